//! Room for the registers of a call, kept for the next one, so that calls do not allocate.

use super::execute::{Given, execute, execute_compact};
use super::one_program::{OneProgram, Places};
use sim_kernel::{Dual, Interval, Scalar};
use std::cell::Cell;
use std::thread::LocalKey;

thread_local! {
    static NUMBERS: Cell<Vec<f64>> = const { Cell::new(Vec::new()) };
    static DUALS: Cell<Vec<Dual>> = const { Cell::new(Vec::new()) };
    static INTERVALS: Cell<Vec<Dual<Interval>>> = const { Cell::new(Vec::new()) };
}

/// Numbers that programs are executed on.
pub(super) trait Number: Scalar {
    /// Where this thread keeps room for them.
    const ROOM: &'static LocalKey<Cell<Vec<Self>>>;

    /// The places of the form that is executed on them.
    fn places(program: &OneProgram) -> &Places;
    /// Executes it, from an image on.
    fn execute(program: &OneProgram, image: &[Self], given: &Given<Self>, registers: &mut [Self]);
}

impl Number for f64 {
    const ROOM: &'static LocalKey<Cell<Vec<f64>>> = &NUMBERS;

    fn places(program: &OneProgram) -> &Places {
        &program.compact_places
    }
    fn execute(program: &OneProgram, image: &[f64], given: &Given<f64>, registers: &mut [f64]) {
        execute_compact(&program.code, &program.compact, image, given, registers);
    }
}

/// Numbers that nothing is laid out for.
macro_rules! plain {
    ($type:ty, $room:ident) => {
        impl Number for $type {
            const ROOM: &'static LocalKey<Cell<Vec<$type>>> = &$room;

            fn places(program: &OneProgram) -> &Places {
                &program.places
            }
            fn execute(program: &OneProgram, image: &[$type], given: &Given<$type>, registers: &mut [$type]) {
                registers[..image.len()].copy_from_slice(image);
                execute::<_, false>(&program.code, given, registers);
            }
        }
    };
}

plain!(Dual, DUALS);
plain!(Dual<Interval>, INTERVALS);

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
