//! What a request may ask for. Whatever is not exactly what the page itself sends is refused.

use std::hint::black_box;

/// The address that is bound, and the secret that readers of it know.
pub(super) struct Gate {
    port: u16,
    token: String,
}

/// An answer that a request gets.
#[derive(Debug, PartialEq)]
pub(super) enum Asked {
    /// The address with the token: the token goes into a cookie.
    Entry,
    /// The page.
    Page,
    /// What is new after this number.
    News(u64),
    /// Refused.
    Forbidden,
    /// There is no such thing.
    Nothing,
}

impl Gate {
    pub(super) fn new(port: u16, token: String) -> Gate {
        Gate { port, token }
    }

    /// The bound address, as browsers call it.
    pub(super) fn host(&self) -> String {
        // Browsers leave out the port of HTTP.
        if self.port == 80 { "127.0.0.1".to_owned() } else { format!("127.0.0.1:{}", self.port) }
    }

    /// The address for the user.
    pub(super) fn address(&self) -> String {
        format!("http://{}/?token={}", self.host(), self.token)
    }

    /// The cookie that holds the token; one for each port, as browsers share them between ports.
    pub(super) fn cookie(&self) -> String {
        format!("{}={}; HttpOnly; SameSite=Strict; Path=/", self.cookie_name(), self.token)
    }

    fn cookie_name(&self) -> String {
        format!("linkwright-{}", self.port)
    }

    /// What a request asks for.
    pub(super) fn asked(&self, request: &httparse::Request) -> Asked {
        if request.method != Some("GET") || request.version != Some(1) || !self.is_from_here(request) {
            return Asked::Forbidden;
        }
        let path = request.path.unwrap_or_default();
        if let Some(token) = path.strip_prefix("/?token=") {
            return if self.is_token(token.as_bytes()) { Asked::Entry } else { Asked::Forbidden };
        }
        if !self.has_cookie(request) {
            return Asked::Forbidden;
        }
        match path.strip_prefix("/news?after=") {
            _ if path == "/" => Asked::Page,
            Some(number) => number.parse().map_or(Asked::Nothing, Asked::News),
            None => Asked::Nothing,
        }
    }

    /// Whether the request is addressed to the bound address, comes from its own page or none, and has nothing in it.
    fn is_from_here(&self, request: &httparse::Request) -> bool {
        let host = self.host();
        let origin = format!("http://{host}");
        let hosts: Vec<&[u8]> = values(request, "host").collect();
        hosts == [host.as_bytes()]
            && values(request, "origin").all(|value| value == origin.as_bytes())
            && values(request, "content-length").chain(values(request, "transfer-encoding")).next().is_none()
    }

    fn has_cookie(&self, request: &httparse::Request) -> bool {
        let name = self.cookie_name();
        let pairs = values(request, "cookie").flat_map(|value| value.split(|byte| *byte == b';'));
        let own = pairs.filter_map(|pair| pair.trim_ascii().strip_prefix(name.as_bytes())?.strip_prefix(b"="));
        let found: Vec<bool> = own.map(|token| self.is_token(token)).collect();
        found == [true]
    }

    /// Compares in a time that does not tell how many bytes are right.
    fn is_token(&self, given: &[u8]) -> bool {
        let own = self.token.as_bytes();
        let differs = own.iter().zip(given).fold(0, |all, (one, other)| black_box(all | (one ^ other)));
        given.len() == own.len() && differs == 0
    }
}

/// The values of all headers of a name.
fn values<'r>(request: &'r httparse::Request, name: &'r str) -> impl Iterator<Item = &'r [u8]> {
    let own = request.headers.iter().filter(move |header| header.name.eq_ignore_ascii_case(name));
    own.map(|header| header.value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked(head: &str) -> Asked {
        let gate = Gate::new(4000, "0123abcd".to_owned());
        let mut headers = [httparse::EMPTY_HEADER; 16];
        let mut request = httparse::Request::new(&mut headers);
        let text = format!("{}\r\n\r\n", head.replace('\n', "\r\n"));
        assert!(request.parse(text.as_bytes()).unwrap().is_complete());
        gate.asked(&request)
    }

    #[test]
    fn only_the_page_itself_is_answered() {
        let host = "Host: 127.0.0.1:4000";
        let cookie = "Cookie: other=1; linkwright-4000=0123abcd";
        assert_eq!(asked(&format!("GET /?token=0123abcd HTTP/1.1\n{host}")), Asked::Entry);
        assert_eq!(asked(&format!("GET / HTTP/1.1\n{host}\n{cookie}")), Asked::Page);
        assert_eq!(asked(&format!("GET /news?after=7 HTTP/1.1\nhost: 127.0.0.1:4000\n{cookie}")), Asked::News(7));
        let own = "Origin: http://127.0.0.1:4000";
        assert_eq!(asked(&format!("GET / HTTP/1.1\n{host}\n{cookie}\n{own}")), Asked::Page);
        for nothing in ["/news?after=x", "/news", "//", "/%2e%2e/", "/..", "http://127.0.0.1:4000/", "/index.html"] {
            assert_eq!(asked(&format!("GET {nothing} HTTP/1.1\n{host}\n{cookie}")), Asked::Nothing, "{nothing}");
        }
        for (line, more) in [
            ("GET / HTTP/1.1", ""),
            ("GET / HTTP/1.1", "Cookie: linkwright-4000=0123abce"),
            ("GET / HTTP/1.1", "Cookie: linkwright-4000=0123abcd; linkwright-4000=x"),
            ("GET / HTTP/1.0", cookie),
            ("POST / HTTP/1.1", cookie),
            ("GET /?token=0123abcde HTTP/1.1", ""),
            ("GET /?token=0123abc HTTP/1.1", ""),
            ("GET /?token= HTTP/1.1", ""),
            ("GET / HTTP/1.1", "Cookie: linkwright-4000=0123abcd\nOrigin: null"),
            ("GET / HTTP/1.1", "Cookie: linkwright-4000=0123abcd\nOrigin: http://127.0.0.1:4001"),
            ("GET / HTTP/1.1", "Cookie: linkwright-4000=0123abcd\nHost: 127.0.0.1:4000"),
            ("GET / HTTP/1.1", "Cookie: linkwright-4000=0123abcd\nContent-Length: 1"),
        ] {
            assert_eq!(
                asked(&format!("{line}\n{host}\n{}", if more.is_empty() { "A: b" } else { more })),
                Asked::Forbidden
            );
        }
        for host in ["localhost:4000", "127.0.0.1", "127.0.0.1:4001", "127.0.0.1:4000.evil", "localhost.evil:4000"] {
            assert_eq!(asked(&format!("GET / HTTP/1.1\nHost: {host}\n{cookie}")), Asked::Forbidden, "{host}");
        }
        assert_eq!(asked(&format!("GET / HTTP/1.1\n{cookie}")), Asked::Forbidden);
    }
}
