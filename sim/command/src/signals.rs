//! The end of a command by Ctrl-C or a signal.
//!
//! Runs check a flag between steps. Their numbers are written however long that takes, and pictures as far as there is
//! time. Everything else ends at once: a thread waits for the signal, moves complete files to their place if the tables
//! are among them, and exits.

use crate::files::folder;
use crate::tell::tell;
#[cfg(unix)]
use signal_hook::{
    consts::{SIGINT, SIGTERM},
    iterator::Signals,
};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// How long pictures may be drawn after a signal: with what else there is to write, less than a second.
const PATIENCE: Duration = Duration::from_millis(600);

/// Set once a run is to end.
pub(super) static INTERRUPTED: AtomicBool = AtomicBool::new(false);
/// Whether there are numbers to keep: a run, which checks that, or its results.
static HAS_NUMBERS: AtomicBool = AtomicBool::new(false);
/// Whether the user knows that they are being written, and that another signal loses them.
static IS_WARNED: AtomicBool = AtomicBool::new(false);

/// Whether what goes on is to be ended by a signal, and is done then.
static ENDS_WELL: AtomicBool = AtomicBool::new(false);

/// From here on a signal ends the program with status 0: nothing is being written.
pub(super) fn end_well() {
    ENDS_WELL.store(true, Ordering::SeqCst);
}

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
    HAS_NUMBERS.store(true, Ordering::SeqCst);
    work()
}

/// The first signal ends a run, which has a moment to draw its pictures; another ends it as soon as its numbers are
/// written, or, once the user is warned, at once. What is no run ends at once, keeping complete files.
fn heard() {
    if ENDS_WELL.load(Ordering::SeqCst) {
        std::process::exit(0);
    }
    if !HAS_NUMBERS.load(Ordering::SeqCst) || IS_WARNED.load(Ordering::SeqCst) {
        end();
    } else if !INTERRUPTED.swap(true, Ordering::SeqCst) {
        end_after(PATIENCE);
    } else {
        end_after(Duration::ZERO);
    }
}

/// Ends the program after a time, once its numbers are written. Other signals are heard meanwhile.
fn end_after(time: Duration) {
    std::thread::spawn(move || {
        std::thread::sleep(time);
        if folder::is_awaited() && !IS_WARNED.swap(true, Ordering::SeqCst) {
            tell!("interrupted; writing what was computed: another signal ends this at once, and loses it");
        }
        while folder::is_awaited() {
            std::thread::sleep(Duration::from_millis(5));
        }
        end();
    });
}

fn end() {
    let ended = folder::end();
    ended.failures.iter().for_each(|failure| tell!("{failure}"));
    match ended.names.is_empty() {
        true => tell!("interrupted; nothing was written"),
        false => tell!("interrupted; written until then: {}", ended.names.join(", ")),
    }
    std::process::exit(130);
}
