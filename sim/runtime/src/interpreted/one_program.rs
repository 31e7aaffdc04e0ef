//! The program of a kernel in the two forms that it is executed in.

use super::compact::Compact;
use codegen::emit::bytecode::{Code, Returned};
use sim_kernel::{Mask, Scalar, pivot_is_refused};
use std::ops::Range;

/// The program of a kernel.
#[derive(Debug)]
pub(super) struct OneProgram {
    /// As it is written: for many states at once, and for duals.
    pub(super) code: Code,
    pub(super) places: Places,
    /// Scheduled, on short numbers: for one state. It begins with the same image and arguments.
    pub(super) compact: Compact,
    pub(super) compact_places: Places,
}

impl OneProgram {
    pub(super) fn new(code: Code, scheduled: Code) -> OneProgram {
        let compact = Compact::of(&scheduled);
        let room = compact.room(scheduled.registers);
        OneProgram {
            places: Places::new(&code, code.registers),
            compact_places: Places::new(&scheduled, room),
            code,
            compact,
        }
    }
}

/// How many registers a program has to be given, and where it leaves what.
#[derive(Debug)]
pub(super) struct Places {
    pub(super) room: usize,
    /// The rows of the results, in their order: of a linearisation C, C_t, and then C_q.
    pub(super) rows: Vec<Range<usize>>,
    /// Pivots and the magnitudes of their terms; without them every state is refused.
    pub(super) pivots: Option<Vec<[u32; 2]>>,
}

impl Places {
    fn new(code: &Code, room: usize) -> Places {
        let (last, first): (Vec<&Returned>, Vec<&Returned>) =
            code.results.iter().partition(|result| result.name == "jacobian");
        let rows = first.into_iter().chain(last).flat_map(|result| result.rows.iter().cloned()).collect();
        Places { room, rows, pivots: code.pivots.clone() }
    }

    /// Where a pivot is refused, of what stands in the registers.
    #[inline(always)]
    pub(super) fn refused<S: Scalar>(&self, register: impl Fn(u32) -> S) -> S::Mask {
        let Some(pivots) = &self.pivots else { return S::not(S::Mask::NONE) };
        let mut refused = S::Mask::NONE;
        for [pivot, terms] in pivots {
            refused = refused | pivot_is_refused(register(*pivot), register(*terms));
        }
        refused
    }
}
