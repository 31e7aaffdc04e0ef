//! What a page has that is served and follows a file: its number, and scripts that ask for news and keep the reader's place.

/// Asks for news, shows mistakes, and loads the page anew.
const NEWS: &str = include_str!("../../../../assets/report/live.js");
/// What the reader chose, kept while the page is loaded anew.
pub(super) const STATE: &str = include_str!("../../../../assets/report/state.js");
const STYLE: &str = include_str!("../../../../assets/report/live.css");
const PAGE_STYLE: &str = include_str!("../../../../assets/report/style.css");

/// A page that is served.
#[derive(Clone, Debug)]
pub(crate) struct Live {
    /// Which page it is.
    pub(crate) number: u64,
    /// What the scripts of this page are known by, in letters and digits.
    pub(crate) nonce: String,
}

impl Live {
    /// For elements with scripts.
    pub(super) fn attribute(&self) -> String {
        format!(" nonce=\"{}\"", self.nonce)
    }

    /// What stands at the end of the page.
    pub(super) fn part(&self) -> String {
        let (number, nonce) = (self.number, self.attribute());
        format!("<style>\n{STYLE}</style>\n<script{nonce} id=\"live\" data-page=\"{number}\">\n{NEWS}</script>\n")
    }
}

/// The page before there is a report.
pub(crate) fn waiting_page(live: &Live) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>sim watch</title>\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<style>\n{PAGE_STYLE}</style>\n</head>\n<body>\n\
         <p class=\"note\">The report is shown here as soon as there is one.</p>\n{}</body>\n</html>\n",
        live.part()
    )
}
