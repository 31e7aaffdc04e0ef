//! The server: one request for each connection, answered from memory. A request reads no file.

use super::board::Board;
use super::request::{Asked, Gate};
use serde_json::json;
use std::io::{Error, ErrorKind, Read, Result, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// Connections at one time; further ones are closed.
const CONNECTIONS: usize = 64;
/// The longest head of a request, in bytes.
const HEAD: usize = 8 << 10;
/// The most headers.
const HEADERS: usize = 48;
/// How long a request may take to arrive, and how long a reader may take for what comes next of the answer.
const PATIENCE: Duration = Duration::from_secs(2);
/// How long a page waits for news before it asks again.
const WAIT: Duration = Duration::from_secs(20);

/// What is served, to whom.
pub(super) struct Server {
    pub(super) gate: Gate,
    pub(super) board: Arc<Board>,
    open: AtomicUsize,
}

/// A place among the connections, which is free again when it is dropped.
struct Place {
    server: Arc<Server>,
    /// How many were taken before it.
    number: usize,
}

impl Place {
    fn of(server: &Arc<Server>) -> Place {
        Place { number: server.open.fetch_add(1, Ordering::SeqCst), server: Arc::clone(server) }
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        self.server.open.fetch_sub(1, Ordering::SeqCst);
    }
}

impl Server {
    pub(super) fn new(gate: Gate, board: Arc<Board>) -> Server {
        Server { gate, board, open: AtomicUsize::new(0) }
    }

    /// Answers for ever.
    pub(super) fn serve(self: &Arc<Server>, listener: &TcpListener) -> ! {
        loop {
            let Ok((stream, _)) = listener.accept() else {
                // No more descriptors, perhaps: some will be free.
                std::thread::sleep(Duration::from_millis(20));
                continue;
            };
            let place = Place::of(self);
            if place.number >= CONNECTIONS {
                continue;
            }
            let answer = move || {
                // A reader that goes away is no failure of the server.
                let _ = place.server.answer(stream);
            };
            // A connection that no thread can be made for is closed.
            let _ = std::thread::Builder::new().stack_size(256 << 10).spawn(answer);
        }
    }

    fn answer(&self, mut stream: TcpStream) -> Result<()> {
        stream.set_write_timeout(Some(PATIENCE))?;
        stream.set_nodelay(true)?;
        let asked = self.read(&mut stream)?;
        let (status, more, kind, body) = match asked {
            Asked::Entry => (
                "303 See Other",
                format!("Location: /\r\nSet-Cookie: {}\r\n", self.gate.cookie()),
                "text/plain",
                "".into(),
            ),
            Asked::Page => {
                let page = self.board.now().page;
                ("200 OK", policy(&page.nonce), "text/html", page.html)
            }
            Asked::News(number) => {
                let news = self.board.after(number, WAIT);
                let said = json!({ "number": news.number, "page": news.page.number, "notice": news.notice });
                ("200 OK", String::new(), "application/json", said.to_string().into())
            }
            Asked::Forbidden => (
                "403 Forbidden",
                String::new(),
                "text/plain",
                "403 forbidden: open the address that `sim watch` printed\n".into(),
            ),
            Asked::Nothing => ("404 Not Found", String::new(), "text/plain", "404 not found\n".into()),
        };
        let more = if more.contains(POLICY) { more } else { format!("{more}{POLICY}: default-src 'none'\r\n") };
        let head = format!(
            "HTTP/1.1 {status}\r\nContent-Type: {kind}; charset=utf-8\r\nContent-Length: {}\r\nConnection: close\r\n\
             Cache-Control: no-store\r\nReferrer-Policy: no-referrer\r\nX-Content-Type-Options: nosniff\r\n\
             Cross-Origin-Resource-Policy: same-origin\r\nCross-Origin-Opener-Policy: same-origin\r\n{more}\r\n",
            body.len()
        );
        stream.write_all(&[head.as_bytes(), body.as_bytes()].concat())?;
        stream.shutdown(Shutdown::Write)
    }

    /// Reads the head of a request, within its time and size.
    fn read(&self, stream: &mut TcpStream) -> Result<Asked> {
        let (clock, mut head, mut part) = (Instant::now(), Vec::new(), [0; 1024]);
        loop {
            let left = PATIENCE.checked_sub(clock.elapsed()).filter(|left| !left.is_zero());
            stream.set_read_timeout(Some(left.ok_or(ErrorKind::TimedOut)?))?;
            match stream.read(&mut part)? {
                0 => return Err(ErrorKind::UnexpectedEof.into()),
                length => head.extend_from_slice(&part[..length]),
            }
            let mut headers = [httparse::EMPTY_HEADER; HEADERS];
            let mut request = httparse::Request::new(&mut headers);
            match request.parse(&head) {
                Ok(httparse::Status::Complete(_)) => return Ok(self.gate.asked(&request)),
                Ok(httparse::Status::Partial) if head.len() < HEAD => {}
                Ok(httparse::Status::Partial) | Err(_) => return Ok(Asked::Forbidden),
            }
        }
    }
}

const POLICY: &str = "Content-Security-Policy";

/// What the page may do: run its own scripts, and ask for news.
fn policy(nonce: &str) -> String {
    format!(
        "{POLICY}: default-src 'none'; script-src 'nonce-{nonce}'; style-src 'unsafe-inline'; img-src data:; \
         connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n"
    )
}

/// Letters and digits that nobody can guess, 128 bits of the operating system's.
pub(super) fn secret() -> Result<String> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(Error::other)?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}
