//! `sim watch` attacked: what is not exactly the page's own request gets nothing.

use crate::{fresh, sim, stderr};
use std::fs;
use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const BOB: &str = "pub Bob;
coordinates { phi [rad]; }
parameters { l [m] = 1; m [kg] = 2; }
let P = l*[sin(phi), -cos(phi)];
bodies { bob: mass m at P; }
loads { gravity [0, -9.81 [m/s^2]]; }
initial { phi = 0.5; }
run { t_end = 300 [ms]; rows = 30; }
";

/// A server of a file in a folder of its own.
struct Watched {
    process: Child,
    folder: PathBuf,
    port: String,
    token: String,
}

impl Drop for Watched {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

impl Watched {
    fn start(name: &str) -> Watched {
        let folder = fresh(name);
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("bob.mech"), BOB).unwrap();
        let mut process = Command::new(env!("CARGO_BIN_EXE_sim"))
            .args(["watch", "bob.mech"])
            .current_dir(&folder)
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut address = String::new();
        BufReader::new(process.stdout.take().unwrap()).read_line(&mut address).unwrap();
        let (host, token) = address.trim().split_once("/?token=").unwrap();
        let port = host.strip_prefix("http://127.0.0.1:").unwrap().to_owned();
        Watched { process, folder, port, token: token.to_owned() }
    }

    fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(format!("127.0.0.1:{}", self.port)).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(10))).unwrap();
        stream
    }

    /// The whole answer to some bytes, in which PORT and TOKEN are replaced; empty if the connection is closed.
    fn ask(&self, request: &str) -> String {
        let request = request.replace("PORT", &self.port).replace("TOKEN", &self.token).replace('\n', "\r\n");
        let mut stream = self.connect();
        // Whoever refuses a long request need not read it.
        let _ = stream.write_all(request.as_bytes());
        let mut answer = Vec::new();
        if let Err(why) = stream.read_to_end(&mut answer) {
            assert_eq!(why.kind(), ErrorKind::ConnectionReset, "no answer: {why}");
        }
        String::from_utf8(answer).unwrap()
    }

    fn get(&self, path: &str) -> String {
        self.ask(&format!("GET {path} HTTP/1.1\nHost: 127.0.0.1:PORT\nCookie: linkwright-PORT=TOKEN\n\n"))
    }

    /// The page once it has a report.
    fn report(&self) -> String {
        let clock = Instant::now();
        loop {
            let page = self.get("/");
            if page.contains("<canvas") {
                return page;
            }
            assert!(clock.elapsed() < Duration::from_secs(60), "no report: {page}");
            std::thread::sleep(Duration::from_millis(20));
        }
    }
}

fn status(answer: &str) -> &str {
    answer.split(' ').nth(1).unwrap_or("closed")
}

/// What the page itself asks is answered, with heads that keep the answer where it is.
#[test]
fn the_page_is_served_to_who_knows_the_token() {
    let server = Watched::start("watch-served");
    let entry = server.ask("GET /?token=TOKEN HTTP/1.1\nHost: 127.0.0.1:PORT\n\n");
    assert_eq!(status(&entry), "303", "{entry}");
    let cookie = format!("Set-Cookie: linkwright-{}={}; HttpOnly; SameSite=Strict; Path=/", server.port, server.token);
    assert!(entry.contains("\r\nLocation: /\r\n") && entry.contains(&cookie), "{entry}");
    let page = server.report();
    let head = page.split("\r\n\r\n").next().unwrap();
    for line in [
        "HTTP/1.1 200 OK",
        "Cache-Control: no-store",
        "Referrer-Policy: no-referrer",
        "X-Content-Type-Options: nosniff",
        "Content-Security-Policy: default-src 'none'; script-src 'nonce-",
    ] {
        assert!(head.contains(line), "{line}: {head}");
    }
    assert!(!page.contains(&server.token), "the token is on the page");
    assert!(server.get("/news?after=0").contains("\"notice\":null"));

    // A mistake is told with its place; the last good page stays.
    fs::write(server.folder.join("bob.mech"), BOB.replace("-cos(phi)", "-cos(psi)")).unwrap();
    let clock = Instant::now();
    let mut told = String::new();
    while !told.contains("\"mistakes\":[{") {
        assert!(clock.elapsed() < Duration::from_secs(30), "{told}");
        told = server.get("/news?after=0");
    }
    assert!(told.contains("\"place\":\"bob.mech:4:") && told.contains("\"words\":\"psi\""), "{told}");
    assert!(server.get("/").contains("<canvas"));
    // Nothing is written.
    assert_eq!(fs::read_dir(&server.folder).unwrap().count(), 1);
}

/// The attacks, and whether the head has the cookie of a reader.
#[test]
fn what_is_not_the_pages_own_is_refused() {
    let server = Watched::start("watch-attacked");
    server.report();
    let cookie = "Cookie: linkwright-PORT=TOKEN";
    let host = "Host: 127.0.0.1:PORT";
    let own = |line: &str, more: &str| format!("{line}\n{host}\n{cookie}\n{more}\n");
    let of_host = |hosts: &str| format!("GET / HTTP/1.1\n{hosts}{cookie}\n\n");
    let mut attacks: Vec<String> = Vec::new();
    for name in ["localhost.evil:PORT", "localhost:PORT", "evil", "127.0.0.1", "127.0.0.1:1", "127.0.0.1:PORT.evil", ""]
    {
        attacks.push(of_host(&format!("Host: {name}\n")));
    }
    attacks.push(of_host(""));
    attacks.push(of_host(&format!("{host}\n{host}\n")));
    attacks.push(of_host(&format!("{host}\nHost: evil\n")));
    attacks.push(of_host(&format!(" Host: evil\n{host}\n")));
    for origin in ["http://evil", "null", "http://127.0.0.1:1", "http://localhost:PORT", "https://127.0.0.1:PORT", ""] {
        attacks.push(own("GET / HTTP/1.1", &format!("Origin: {origin}\n")));
    }
    let short = &server.token[1..];
    for token in ["", short, "TOKENx", "TOKEN&", "TOKEN%20", "0123456789abcdef0123456789abcdef"] {
        attacks.push(format!("GET /?token={token} HTTP/1.1\n{host}\n\n"));
        attacks.push(format!("GET / HTTP/1.1\n{host}\nCookie: linkwright-PORT={token}\n\n"));
    }
    attacks.push(format!("GET / HTTP/1.1\n{host}\n\n"));
    attacks.push(format!("GET /news?after=0 HTTP/1.1\n{host}\n\n"));
    attacks.push(format!("GET / HTTP/1.1\n{host}\nCookie: linkwright-PORT=\"TOKEN\"\n\n"));
    attacks.push(format!("GET / HTTP/1.1\n{host}\nCookie: linkwright-1=TOKEN\n\n"));
    for method in ["POST", "PUT", "HEAD", "OPTIONS", "CONNECT", "DELETE", "PATCH", "TRACE", "get"] {
        attacks.push(own(&format!("{method} / HTTP/1.1"), ""));
        attacks.push(format!("{method} /?token=TOKEN HTTP/1.1\n{host}\n\n"));
    }
    for path in [
        "/%2e%2e/",
        "/%2e%2e/bob.mech",
        "//",
        "/../bob.mech",
        "/..%2fbob.mech",
        "/bob.mech",
        "/./",
        "/%2f",
        "/?",
        "/?x",
        "*",
        "/news?after=-1",
        "/news?after=",
        "http://127.0.0.1:PORT/",
        "http://evil/",
        "//evil/",
        "/\\..\\bob.mech",
        "/favicon.ico",
        "/?token=TOKEN/../bob.mech",
        "file:///etc/passwd",
        "/etc/passwd",
    ] {
        attacks.push(own(&format!("GET {path} HTTP/1.1"), ""));
    }
    attacks.push(own("GET / HTTP/1.0", ""));
    attacks.push(own("GET / HTTP/2.0", ""));
    attacks.push(format!("GET /\n{host}\n{cookie}\n\n"));
    attacks.push(own("GET / HTTP/1.1", "Content-Length: 3\n\nabc"));
    attacks.push(own("GET / HTTP/1.1", "Transfer-Encoding: chunked\n\n0\n"));
    attacks.push(own("GET / HTTP/1.1", &format!("A: {}\n", "a".repeat(20_000))));
    attacks.push(own("GET / HTTP/1.1", &"A: a\n".repeat(1000)));
    attacks.push("\u{0}\u{1}\u{2}\n\n".to_owned());
    for attack in &attacks {
        let answer = server.ask(attack);
        assert!(["403", "404", "closed"].contains(&status(&answer)), "{attack}\n{answer}");
        let told = ["<canvas", "Bob", "coordinates", "root:", &server.token, "Set-Cookie", "number"];
        told.iter().for_each(|secret| assert!(!answer.contains(*secret), "{attack}\n{answer}"));
    }
    println!("{} attacks", attacks.len());
    assert_eq!(status(&server.get("/")), "200");
}

/// Who sends slowly is closed, and many of them neither hang the server nor stay.
#[test]
fn slow_senders_are_closed() {
    let server = Watched::start("watch-slow");
    server.report();
    let clock = Instant::now();
    let mut slow = server.connect();
    let mut many: Vec<TcpStream> = (0..200).map(|_| server.connect()).collect();
    let mut is_open = true;
    while is_open && clock.elapsed() < Duration::from_secs(8) {
        is_open = slow.write_all(b"G").is_ok();
        std::thread::sleep(Duration::from_millis(100));
    }
    assert!(!is_open, "a sender of ten bytes a second is still heard");
    for stream in &mut many {
        let mut nothing = Vec::new();
        let _ = stream.read_to_end(&mut nothing);
        assert!(nothing.is_empty());
    }
    assert_eq!(status(&server.get("/")), "200");
    assert!(clock.elapsed() < Duration::from_secs(20));
}

#[test]
fn it_says_what_to_do() {
    let named = sim(&["watch", "quick-return"]);
    assert_eq!(named.status.code(), Some(2));
    assert!(stderr(&named).contains("new --file quick-return.mech --from quick-return"), "{}", stderr(&named));
    let missing = sim(&["watch", "no-such.mech"]);
    assert_eq!(missing.status.code(), Some(1));
    assert!(stderr(&missing).contains("new --file no-such.mech"), "{}", stderr(&missing));
    let server = Watched::start("watch-taken");
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    let file = server.folder.join("bob.mech");
    let refused = sim(&["watch", file.to_str().unwrap(), "--port", &port]);
    assert_eq!(refused.status.code(), Some(1));
    let said = stderr(&refused);
    assert!(said.contains(&format!("port {port} of 127.0.0.1 is taken")) && said.contains("--port"), "{said}");
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_it_well() {
    let mut server = Watched::start("watch-ended");
    server.report();
    let killed = Command::new("kill").args(["-INT", &server.process.id().to_string()]).status().unwrap();
    assert!(killed.success());
    assert_eq!(server.process.wait().unwrap().code(), Some(0));
}
