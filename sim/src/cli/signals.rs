//! The end of a command by Ctrl-C or a signal.
//!
//! Runs check a flag between steps and write what they have. Everything else ends at once: a thread waits for the
//! signal, moves complete files to their place if the tables are among them, and exits.

use crate::cli::files::folder;
#[cfg(unix)]
use signal_hook::{
    consts::{SIGINT, SIGTERM},
    iterator::Signals,
};
use std::sync::atomic::{AtomicBool, Ordering};

/// Set once a run is to end.
pub(super) static INTERRUPTED: AtomicBool = AtomicBool::new(false);
/// Whether a run looks at that.
static IS_LOOKED_AT: AtomicBool = AtomicBool::new(false);

/// Handles SIGINT and SIGTERM from here on. (SIGHUP keeps its meaning: `nohup` works.)
pub(super) fn listen() {
    #[cfg(unix)]
    if let Ok(mut signals) = Signals::new([SIGINT, SIGTERM]) {
        std::thread::spawn(move || signals.forever().for_each(|_| heard()));
    }
    #[cfg(not(unix))]
    let _ = ctrlc::set_handler(heard);
}

/// Does work that checks [`INTERRUPTED`]: the first signal ends it, and its results are written.
pub(super) fn interruptible<T>(work: impl FnOnce() -> T) -> T {
    IS_LOOKED_AT.store(true, Ordering::SeqCst);
    let done = work();
    IS_LOOKED_AT.store(false, Ordering::SeqCst);
    done
}

/// The first signal ends a run, which then writes its results; any other ends the program, keeping complete files.
fn heard() {
    if IS_LOOKED_AT.load(Ordering::SeqCst) && !INTERRUPTED.swap(true, Ordering::SeqCst) {
        return;
    }
    let filled = folder::end();
    match filled.names.is_empty() {
        true => eprintln!("interrupted; nothing was written"),
        false => eprintln!("interrupted; written until then: {}", filled.names.join(", ")),
    }
    std::process::exit(130);
}
