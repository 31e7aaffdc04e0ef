//! `sim watch` as a reader meets it: what is saved is seen, and what was chosen stays.

use crate::browser::Browser;
use crate::scratch;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A server of a file in a folder of its own.
struct Watched {
    process: Child,
    file: PathBuf,
    address: String,
}

impl Drop for Watched {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

impl Watched {
    /// Of a shipped mechanism, as a file.
    fn start(name: &str, model: &str) -> (Watched, String) {
        let folder = scratch(name);
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        let file = folder.join("own.mech");
        crate::sim(&["new", "--file", file.to_str().unwrap(), "--from", model]);
        let text = fs::read_to_string(&file).unwrap();
        let mut process = Command::new(env!("CARGO_BIN_EXE_sim"))
            .args(["watch", file.to_str().unwrap()])
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut address = String::new();
        BufReader::new(process.stdout.take().unwrap()).read_line(&mut address).unwrap();
        (Watched { process, file, address: address.trim().to_owned() }, text)
    }

    /// Saves as many editors do: another file takes the place of the old one.
    fn save(&self, text: &str) {
        let beside = self.file.with_extension("new");
        fs::write(&beside, text).unwrap();
        fs::rename(&beside, &self.file).unwrap();
    }
}

/// Waits until an expression is true, also while the page is loaded anew.
fn wait(browser: &mut Browser, condition: &str) {
    let clock = Instant::now();
    while browser.try_evaluate(condition) != Some(true.into()) {
        assert!(clock.elapsed() < Duration::from_secs(60), "{condition}: {:?}", browser.complaints);
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// A page with its scripts done.
const READY: &str =
    "!!document.documentElement?.dataset.ready && !!document.documentElement.dataset.page && !!window.report";

/// All that is to stay.
const CHOICES: &str = "(() => {
    const { time, playing, zoom, boxes, speed, repeat, hidden, open, dark } = report.state();
    return JSON.stringify([time, playing, zoom, boxes, speed, repeat, hidden, open, dark]);
})()";

#[test]
#[ignore = "needs Chromium; .ci/run installs it and runs this"]
fn what_is_saved_is_seen_and_choices_stay() {
    let (server, text) = Watched::start("watch-reader", "quick-return");
    let mut browser = Browser::start(&scratch("chromium-watch"));
    browser.window(1400, 1000, 1.0, false);
    browser.call("Page.navigate", serde_json::json!({ "url": server.address }));
    wait(&mut browser, READY);
    assert_eq!(browser.evaluate("location.search"), "");
    // The cookie is not for scripts, and no other script runs.
    assert_eq!(browser.evaluate("document.cookie"), "");
    browser.evaluate(
        "report.player.pause(), report.player.seek(0.4), report.zoomTo({ min: 0.25, max: 1.5 }), \
         document.querySelector('#parts input').click(), document.getElementById('loop').click(), \
         document.querySelector('#traces input').click(), document.getElementById('theme-button').click(), \
         document.querySelector('.legend button').click()",
    );
    browser.settle();
    let chosen = browser.evaluate(CHOICES);
    let before = browser.evaluate("document.documentElement.dataset.page");
    let changed = |of: &str| format!("{READY} && document.documentElement.dataset.page !== {of:?}");
    // The crank is shorter: the page shows it, at the same time, zoom and choices.
    server.save(&text.replace("O2A [m] = 0.2", "O2A [m] = 0.18"));
    assert_ne!(text, fs::read_to_string(&server.file).unwrap());
    wait(&mut browser, &changed(before.as_str().unwrap()));
    assert_eq!(browser.evaluate(CHOICES), chosen);
    wait(&mut browser, "document.querySelector('.reproduce').textContent.includes('0.18')");

    // A mistake stands over the report of before, at its place, as text.
    let before = browser.evaluate("document.documentElement.dataset.page");
    let evil = "<img src=x onerror=alert(1)>";
    server.save(&format!("{text}\noutputs {{ wrong = nothing_{}; }} // {evil}\n", "here"));
    wait(&mut browser, "!!document.getElementById('news')");
    let news = browser.evaluate("document.getElementById('news').textContent");
    let news = news.as_str().unwrap();
    assert!(news.contains("own.mech:") && news.contains(evil), "{news}");
    assert_eq!(browser.evaluate("document.querySelectorAll('#news img').length"), 0);
    assert!(browser.evaluate("document.querySelectorAll('#news mark').length").as_u64().unwrap() > 0);
    assert_eq!(browser.evaluate("document.documentElement.dataset.page"), before);
    browser.screenshot(&crate::pictures().join("watch-mistake.png"));
    server.save(&text);
    wait(&mut browser, &changed(before.as_str().unwrap()));
    wait(&mut browser, "!document.getElementById('news')");
    assert_eq!(browser.evaluate(CHOICES), chosen);
    assert!(browser.complaints.is_empty(), "{:?}", browser.complaints);
}

/// Text of a declaration is text on the page.
#[test]
#[ignore = "needs Chromium; .ci/run installs it and runs this"]
fn text_stays_text() {
    let (server, text) = Watched::start("watch-inert", "pendulum");
    let mut browser = Browser::start(&scratch("chromium-inert"));
    let evil = "</script><script>window.evil = 1</script><img src=x onerror='window.evil = 1'>";
    server.save(&text.replacen("pub ", &format!("/// {evil}\npub "), 1));
    browser.call("Page.navigate", serde_json::json!({ "url": server.address }));
    wait(&mut browser, &format!("{READY} && document.querySelector('header').textContent.includes('window.evil')"));
    browser.settle();
    assert!(
        browser
            .evaluate("window.evil === undefined && document.querySelectorAll('img').length === 0")
            .as_bool()
            .unwrap()
    );
    assert!(browser.complaints.is_empty(), "{:?}", browser.complaints);
}

/// Saves that are timed.
const SAVES: usize = 50;

/// From the write of the file to the page that has the new number in it.
#[test]
#[ignore = "needs Chromium; .ci/run installs it and runs this"]
fn saved_file_to_changed_page() {
    let (server, text) = Watched::start("watch-timed", "quick-return");
    let mut browser = Browser::start(&scratch("chromium-timed"));
    browser.window(1400, 1000, 1.0, false);
    browser.call("Page.navigate", serde_json::json!({ "url": server.address }));
    wait(&mut browser, READY);
    let mut times = Vec::new();
    for save in 0..SAVES {
        let crank = format!("0.{}", 1801 + save);
        let changed = text.replace("O2A [m] = 0.2", &format!("O2A [m] = {crank}"));
        assert_ne!(changed, text);
        let clock = Instant::now();
        server.save(&changed);
        wait(
            &mut browser,
            &format!("{READY} && document.querySelector('.reproduce').textContent.includes('O2A [m] = {crank}')"),
        );
        times.push(1e3 * clock.elapsed().as_secs_f64());
        std::thread::sleep(Duration::from_millis(150));
    }
    times.sort_by(f64::total_cmp);
    println!("saved file to changed page, in ms: {:.1}", times[SAVES / 2]);
}
