//! What is shown: the last good page, and what is wrong now.

use serde_json::Value;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// A page with the nonce of its scripts.
#[derive(Clone)]
pub(super) struct Page {
    pub(super) number: u64,
    pub(super) nonce: String,
    pub(super) html: Arc<str>,
}

/// What is shown, with a number that grows with each change.
#[derive(Clone)]
pub(super) struct News {
    pub(super) number: u64,
    pub(super) page: Page,
    /// What is wrong: a title, and mistakes.
    pub(super) notice: Option<Value>,
}

/// Where the news are put up, and waited for.
pub(super) struct Board {
    news: Mutex<News>,
    changed: Condvar,
}

impl Board {
    /// With the page that is shown until there is a report.
    pub(super) fn new(page: Page) -> Board {
        Board { news: Mutex::new(News { number: 1, page, notice: None }), changed: Condvar::new() }
    }

    fn lock(&self) -> MutexGuard<'_, News> {
        self.news.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Puts up a new page, or what is wrong over the last one.
    pub(super) fn put(&self, page: Option<Page>, notice: Option<Value>) {
        let mut news = self.lock();
        news.number += 1;
        news.page = page.unwrap_or_else(|| news.page.clone());
        news.notice = notice;
        self.changed.notify_all();
    }

    /// What is shown.
    pub(super) fn now(&self) -> News {
        self.lock().clone()
    }

    /// What is shown once its number is another one than the reader's, or after a time.
    pub(super) fn after(&self, number: u64, patience: Duration) -> News {
        let waited = self.changed.wait_timeout_while(self.lock(), patience, |news| news.number == number);
        waited.unwrap_or_else(PoisonError::into_inner).0.clone()
    }
}
