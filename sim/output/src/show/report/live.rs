//! What a page has that is served and follows a file: its number, and scripts that ask for news and keep the reader's place.

/// Asks for news, shows mistakes, and loads the page anew.
const NEWS: &str = include_str!("../../../assets/report/live.js");
/// What is added to the script of a report: the reader's choices, kept while the page is loaded anew, and the news.
pub(super) const SCRIPT: [&str; 2] = [include_str!("../../../assets/report/state.js"), NEWS];
/// For what is wrong.
pub(super) const STYLE: &str = include_str!("../../../assets/report/live.css");
const PAGE_STYLE: &str = include_str!("../../../assets/report/style.css");

/// A page that is served.
#[derive(Clone, Debug)]
pub struct Live {
    /// Which page it is.
    pub number: u64,
    /// What the scripts of this page are known by, in letters and digits.
    pub nonce: String,
}

impl Live {
    /// For elements with scripts.
    pub(super) fn attribute(&self) -> String {
        format!(" nonce=\"{}\"", self.nonce)
    }

    /// For the script that asks for news: which page it stands on.
    pub(super) fn number(&self) -> String {
        format!(" id=\"live\" data-page=\"{}\"", self.number)
    }
}

/// The page before there is a report.
pub fn waiting_page(live: &Live) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>sim watch</title>\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<style>\n{PAGE_STYLE}{STYLE}</style>\n</head>\n<body>\n\
         <p class=\"note\">The report is shown here as soon as there is one.</p>\n\
         <script{}{}>\n{NEWS}</script>\n</body>\n</html>\n",
        live.attribute(),
        live.number()
    )
}
