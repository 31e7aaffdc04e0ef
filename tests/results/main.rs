//! The results of shipped models: bit for bit as they were, and over long times.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod bits;
mod long;
