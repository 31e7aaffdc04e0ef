//! Room for the registers of a call, kept for the next one, so that calls do not allocate.

use sim_kernel::{Dual, Scalar};
use std::cell::Cell;
use std::thread::LocalKey;

thread_local! {
    static NUMBERS: Cell<Vec<f64>> = const { Cell::new(Vec::new()) };
    static DUALS: Cell<Vec<Dual>> = const { Cell::new(Vec::new()) };
}

/// Numbers that programs are executed on.
pub(super) trait Number: Scalar {
    /// Where this thread keeps room for them.
    const ROOM: &'static LocalKey<Cell<Vec<Self>>>;
}

impl Number for f64 {
    const ROOM: &'static LocalKey<Cell<Vec<f64>>> = &NUMBERS;
}

impl Number for Dual {
    const ROOM: &'static LocalKey<Cell<Vec<Dual>>> = &DUALS;
}

/// Works with at least so many registers, whatever they hold.
#[inline]
pub(super) fn with_registers<S: Number, T>(count: usize, work: impl FnOnce(&mut [S]) -> T) -> T {
    // A call inside of another finds none, and makes its own.
    let mut room = S::ROOM.take();
    if room.len() < count {
        room.resize(count, S::ZERO);
    }
    let done = work(&mut room[..count]);
    S::ROOM.set(room);
    done
}
