//! Mistakes of a stage, collected so that all of them show at once, and shown outside of rustc.

mod shown;

pub use shown::{Mistake, Position, Related};

use std::collections::HashSet;

/// Every mistake as `file:line:column: message`, a line each; later lines of a message are indented.
pub fn located(file: &str, mistakes: syn::Error) -> String {
    let line = |mistake: syn::Error| {
        let start = mistake.span().start();
        let message = mistake.to_string().replace('\n', "\n    ");
        format!("{file}:{}:{}: {message}", start.line, start.column + 1)
    };
    mistakes.into_iter().map(line).collect::<Vec<_>>().join("\n")
}

/// Errors met so far, in order.
#[derive(Default)]
pub struct Mistakes {
    all: Option<syn::Error>,
    /// Where each is, and what it says.
    known: HashSet<(String, String)>,
}

impl Mistakes {
    /// Adds one. A mistake that is written out at several places is added once.
    pub fn add(&mut self, mistake: syn::Error) {
        let words = |e: &syn::Error| (format!("{:?}", e.span()), e.to_string());
        if self.known.contains(&words(&mistake)) {
            return;
        }
        self.known.extend(mistake.clone().into_iter().map(|one| words(&one)));
        match &mut self.all {
            Some(all) => all.combine(mistake),
            None => self.all = Some(mistake),
        }
    }

    /// Whether there was none.
    pub fn is_empty(&self) -> bool {
        self.all.is_none()
    }

    /// The value, or `None` with its mistakes recorded.
    pub fn note<T>(&mut self, result: syn::Result<T>) -> Option<T> {
        result.map_err(|mistake| self.add(mistake)).ok()
    }

    /// The value of the stage if there was no mistake.
    ///
    /// # Errors
    /// All mistakes, combined.
    pub fn or<T>(self, value: T) -> syn::Result<T> {
        self.all.map_or(Ok(value), Err)
    }
}
