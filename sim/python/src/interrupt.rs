//! Long work with Python's lock released, which Ctrl-C ends.

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// How often signals are asked for.
pub(crate) const BETWEEN: Duration = Duration::from_millis(50);

/// Works in a thread of its own while this one listens to signals. After Ctrl-C the work is told to end, and its result is
/// dropped.
pub(crate) fn interruptible<T: Send>(py: Python<'_>, work: impl FnOnce(&AtomicBool) -> T + Send) -> PyResult<T> {
    let interrupted = AtomicBool::new(false);
    py.detach(|| {
        thread::scope(|scope| {
            let (done, waiting) = channel();
            let interrupted = &interrupted;
            let working = move || {
                // Who waits for it is there until the end.
                let _ = done.send(work(interrupted));
            };
            let worker = thread::Builder::new().spawn_scoped(scope, working)?;
            let mut heard = None;
            loop {
                match waiting.recv_timeout(BETWEEN) {
                    Ok(found) => return heard.map_or(Ok(found), Err),
                    Err(RecvTimeoutError::Disconnected) => {
                        // Joined here, so that its panic goes no further.
                        let _ = worker.join();
                        return Err(PyRuntimeError::new_err("the work has ended without a result"));
                    }
                    Err(RecvTimeoutError::Timeout) => {}
                }
                if let Err(signal) = Python::attach(|py| py.check_signals()) {
                    interrupted.store(true, Ordering::Relaxed);
                    heard = Some(signal);
                }
            }
        })
    })
}
