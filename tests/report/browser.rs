//! Chromium without a window, spoken with by its DevTools protocol.

use base64::Engine;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use tungstenite::stream::MaybeTlsStream;
use tungstenite::{Message, WebSocket};

/// What Chromium may be called; `CHROMIUM` names another.
const NAMES: [&str; 4] = ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"];

/// A browser with one page.
pub(crate) struct Browser {
    process: Child,
    socket: WebSocket<MaybeTlsStream<TcpStream>>,
    session: Option<String>,
    last: u64,
    /// What the console, the page's errors and the network said since the page was opened.
    pub(crate) complaints: Vec<String>,
    /// Addresses asked for.
    pub(crate) requests: Vec<String>,
}

impl Drop for Browser {
    fn drop(&mut self) {
        // The process may be a script that has started the browser: this ends the browser itself.
        let close = json!({ "id": self.last + 1, "method": "Browser.close" });
        let _ = self.socket.send(Message::text(close.to_string()));
        while self.socket.read().is_ok() {}
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

impl Browser {
    /// Starts Chromium.
    pub(crate) fn start(profile: &Path) -> Browser {
        let named = std::env::var("CHROMIUM").ok();
        let names = named.iter().map(String::as_str).chain(NAMES);
        let start = |name: &str| {
            Command::new(name)
                .args(["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--remote-debugging-port=0"])
                .arg(format!("--user-data-dir={}", profile.display()))
                .stdout(Stdio::null())
                .stderr(Stdio::piped())
                .spawn()
                .ok()
        };
        let mut process = names.into_iter().find_map(start).expect("Chromium: apt-get install chromium-headless-shell");
        let mut lines = BufReader::new(process.stderr.take().unwrap()).lines();
        let address = lines.find_map(|line| Some(line.ok()?.split_once("listening on ")?.1.to_owned())).unwrap();
        // Whatever it says later must not fill the pipe.
        std::thread::spawn(move || lines.for_each(drop));
        let (socket, _) = tungstenite::connect(address.trim()).unwrap();
        let mut browser =
            Browser { process, socket, session: None, last: 0, complaints: Vec::new(), requests: Vec::new() };
        let target = browser.call("Target.createTarget", json!({ "url": "about:blank" }));
        let attached =
            browser.call("Target.attachToTarget", json!({ "targetId": target["targetId"], "flatten": true }));
        browser.session = Some(attached["sessionId"].as_str().unwrap().to_owned());
        for domain in ["Page", "Runtime", "Log", "Network"] {
            browser.call(&format!("{domain}.enable"), json!({}));
        }
        browser
    }

    /// Sends a command and waits for its answer; events on the way are kept.
    pub(crate) fn call(&mut self, method: &str, parameters: Value) -> Value {
        let answer = self.ask(method, parameters);
        assert!(answer["error"].is_null(), "{method}: {answer}");
        answer["result"].clone()
    }

    fn ask(&mut self, method: &str, parameters: Value) -> Value {
        self.last += 1;
        let mut message = json!({ "id": self.last, "method": method, "params": parameters });
        if let Some(session) = &self.session {
            message["sessionId"] = session.as_str().into();
        }
        self.socket.send(Message::text(message.to_string())).unwrap();
        loop {
            let Message::Text(text) = self.socket.read().unwrap() else { continue };
            let answer: Value = serde_json::from_str(&text).unwrap();
            if answer["id"] == self.last {
                return answer;
            }
            self.note(&answer);
        }
    }

    fn note(&mut self, event: &Value) {
        let parameters = &event["params"];
        match event["method"].as_str().unwrap_or_default() {
            "Runtime.consoleAPICalled" => self.complaints.push(format!("console: {}", parameters["args"])),
            "Runtime.exceptionThrown" => self.complaints.push(format!("exception: {}", parameters["exceptionDetails"])),
            "Log.entryAdded" => self.complaints.push(format!("log: {}", parameters["entry"]["text"])),
            "Network.requestWillBeSent" => {
                self.requests.push(parameters["request"]["url"].as_str().unwrap_or_default().to_owned());
            }
            _ => {}
        }
    }

    /// The value of an expression in the page; promises are waited for.
    pub(crate) fn evaluate(&mut self, expression: &str) -> Value {
        let answer = self
            .call("Runtime.evaluate", json!({ "expression": expression, "awaitPromise": true, "returnByValue": true }));
        assert!(answer["exceptionDetails"].is_null(), "{expression}: {answer}");
        answer["result"]["value"].clone()
    }

    /// The same where the page may just be loaded anew: `None` then.
    pub(crate) fn try_evaluate(&mut self, expression: &str) -> Option<Value> {
        let answer = self.ask("Runtime.evaluate", json!({ "expression": expression, "returnByValue": true }));
        let result = answer["result"].as_object().filter(|result| result.get("exceptionDetails").is_none());
        result.map(|result| result["result"]["value"].clone())
    }

    /// Sets the size of the window and the reader's theme.
    pub(crate) fn window(&mut self, width: u32, height: u32, scale: f64, dark: bool) {
        let phone = width < 600;
        let metrics = json!({ "width": width, "height": height, "deviceScaleFactor": scale, "mobile": phone });
        self.call("Emulation.setDeviceMetricsOverride", metrics);
        let theme = if dark { "dark" } else { "light" };
        let features = json!([{ "name": "prefers-color-scheme", "value": theme }]);
        self.call("Emulation.setEmulatedMedia", json!({ "features": features }));
    }

    /// Opens a report at a place such as `#t=0.5`, and waits until it is ready.
    pub(crate) fn open(&mut self, report: &Path, place: &str) {
        self.call("Page.navigate", json!({ "url": "about:blank" }));
        (self.complaints, self.requests) = (Vec::new(), Vec::new());
        self.call("Page.navigate", json!({ "url": format!("file://{}{place}", report.display()) }));
        let patience = Instant::now();
        while self.evaluate("(document.documentElement && document.documentElement.dataset.ready) || null").is_null() {
            assert!(patience.elapsed() < Duration::from_secs(60), "not ready: {:?}", self.complaints);
            std::thread::sleep(Duration::from_millis(20));
        }
        self.settle();
    }

    /// Waits until what was asked for is drawn.
    pub(crate) fn settle(&mut self) {
        self.evaluate(
            "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 60))))",
        );
    }

    /// Presses and releases the mouse, at the same place or at another.
    pub(crate) fn drag(&mut self, from: (f64, f64), to: (f64, f64)) {
        let mut mouse = |kind: &str, (x, y): (f64, f64), buttons: u32| {
            let event = json!({ "type": kind, "x": x, "y": y, "button": "left", "buttons": buttons, "clickCount": 1 });
            self.call("Input.dispatchMouseEvent", event);
        };
        mouse("mouseMoved", from, 0);
        mouse("mousePressed", from, 1);
        for step in 1..=4 {
            let share = f64::from(step) / 4.0;
            mouse("mouseMoved", (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1)), 1);
        }
        mouse("mouseReleased", to, 0);
        self.settle();
    }

    /// Moves two fingers from two places to two others.
    pub(crate) fn pinch(&mut self, from: [(f64, f64); 2], to: [(f64, f64); 2]) {
        let mut touch = |kind: &str, points: &[(f64, f64)]| {
            let points: Vec<Value> =
                points.iter().enumerate().map(|(id, (x, y))| json!({ "x": x, "y": y, "id": id })).collect();
            self.call("Input.dispatchTouchEvent", json!({ "type": kind, "touchPoints": points }));
        };
        touch("touchStart", &from);
        for step in 1..=4 {
            let share = f64::from(step) / 4.0;
            let between =
                |i: usize| (from[i].0 + share * (to[i].0 - from[i].0), from[i].1 + share * (to[i].1 - from[i].1));
            touch("touchMove", &[between(0), between(1)]);
        }
        touch("touchEnd", &[]);
        self.settle();
    }

    /// Presses a key.
    pub(crate) fn key(&mut self, key: &str) {
        let text = if key.chars().count() == 1 { key } else { "" };
        self.call("Input.dispatchKeyEvent", json!({ "type": "keyDown", "key": key, "text": text }));
        self.call("Input.dispatchKeyEvent", json!({ "type": "keyUp", "key": key }));
        self.settle();
    }

    /// The middle of an element, at a share of its width.
    pub(crate) fn place(&mut self, selector: &str, share: f64) -> (f64, f64) {
        let expression = format!(
            "(() => {{ const e = document.querySelector({selector:?}); e.scrollIntoView({{ block: 'center' }}); \
             const b = e.getBoundingClientRect(); return [b.left + {share} * b.width, b.top + b.height / 2]; }})()"
        );
        let place = self.evaluate(&expression);
        (place[0].as_f64().unwrap(), place[1].as_f64().unwrap())
    }

    /// Keeps a picture of the window.
    pub(crate) fn screenshot(&mut self, path: &Path) {
        let shot = self.call("Page.captureScreenshot", json!({ "format": "png" }));
        let bytes = base64::engine::general_purpose::STANDARD.decode(shot["data"].as_str().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }

    /// The bytes of the page as a printer would have it.
    pub(crate) fn printed(&mut self) -> usize {
        let pdf = self.call("Page.printToPDF", json!({ "printBackground": true, "preferCSSPageSize": true }));
        pdf["data"].as_str().unwrap().len() * 3 / 4
    }
}
