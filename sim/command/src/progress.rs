//! The progress bar of a long run, and its end by Ctrl-C.

use crate::Stop;
use crate::arguments::Voice;
use crate::signals;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use sim_runtime::Failure;
use std::io::IsTerminal;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::{self, JoinHandle};
use std::time::Duration;

static REACHED: AtomicU64 = AtomicU64::new(0);

/// No bar before this time: most runs are over by then.
const PATIENCE: Duration = Duration::from_secs(1);
const BETWEEN: Duration = Duration::from_millis(100);

/// Runs to a time with a progress bar on a terminal, after the first second. Ctrl-C ends the run and keeps its results.
pub(super) fn watched<T>(
    end: f64,
    voice: Voice,
    run: impl FnOnce(&mut dyn FnMut(f64) -> bool) -> Result<T, Failure>,
) -> Result<T, Stop> {
    let watch = begin(end, voice);
    let mut goes_on = |time: f64| {
        REACHED.store(time.to_bits(), Ordering::Relaxed);
        !signals::INTERRUPTED.load(Ordering::Relaxed)
    };
    let found = signals::interruptible(|| run(&mut goes_on));
    watch.end();
    Ok(found?)
}

/// Who shows a run while it lasts.
struct Watch {
    done: Sender<()>,
    bar: Option<JoinHandle<()>>,
}

impl Watch {
    fn end(self) {
        drop(self.done);
        if let Some(bar) = self.bar {
            let _ = bar.join();
        }
    }
}

fn begin(end: f64, voice: Voice) -> Watch {
    REACHED.store(0, Ordering::Relaxed);
    let shown = !voice.quiet && !voice.json && std::io::stderr().is_terminal();
    let (done, waiting) = channel::<()>();
    let bar = shown.then(|| {
        thread::spawn(move || {
            if waiting.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                let bar = bar();
                while waiting.recv_timeout(BETWEEN) == Err(RecvTimeoutError::Timeout) {
                    show(&bar, f64::from_bits(REACHED.load(Ordering::Relaxed)), end);
                }
                bar.finish_and_clear();
            }
        })
    });
    Watch { done, bar }
}

fn bar() -> ProgressBar {
    let style = ProgressStyle::with_template(
        "{prefix}{bar:30} {percent:>3} %  {msg}  {eta} left  (Ctrl-C keeps what there is)",
    );
    let bar = ProgressBar::with_draw_target(Some(1_000_000), ProgressDrawTarget::stderr());
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

fn show(bar: &ProgressBar, reached: f64, end: f64) {
    let position = (1e6 * (reached / end).clamp(0.0, 1.0)) as u64;
    if position < bar.position() {
        bar.set_prefix("comparing ");
        bar.reset_elapsed();
    }
    bar.set_position(position);
    let rate = reached / bar.elapsed().as_secs_f64().max(1e-3);
    bar.set_message(format!("t = {reached:.4} of {end} s, {rate:.3} s per second"));
}
