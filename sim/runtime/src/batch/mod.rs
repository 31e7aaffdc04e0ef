//! The equations of motion at many states, and many simulations, several at once.

mod lanes;
mod simulations;
mod solved;

use crate::Failure;
use crate::motion::typed::accelerate;
use crate::state::trajectory::State;
use sim_kernel::{Array, Dynamics, LaneMask, Lanes, Mask, Mechanism, Scalar, Vectors, Work};
pub use simulations::advance_each;
pub use solved::solve_each;

/// The number of states evaluated at once: as many as the widest vector instructions hold.
const LANES: usize = 8;

/// The results at a state.
type Solution<M> = Dynamics<f64, <M as Mechanism>::Q, <M as Mechanism>::L>;
/// A mechanism with a separate trajectory in each lane.
type InLanes<M> = <M as Mechanism>::On<Lanes<LANES>>;
/// The prepared parameters of its equations of motion.
type Prepared<M> = <InLanes<M> as Mechanism<Lanes<LANES>>>::Prepared;
/// Its coordinates.
type Q<M> = <InLanes<M> as Mechanism<Lanes<LANES>>>::Q;
/// The results in all lanes.
type Solutions<M> = Dynamics<Lanes<LANES>, Q<M>, <InLanes<M> as Mechanism<Lanes<LANES>>>::L>;

/// Accelerations, multipliers and power at each of many states: with the same bits as
/// [`accelerate`](crate::accelerate), but eight at once, with the widest vector instructions that the processor has.
///
/// `found` gets an entry for each state, in their order; its memory is used again. A state whose pivots the planned
/// elimination refuses is solved by complete pivoting.
///
/// Returns the failures with the indices of their states; the other results are valid. Failed ones are marked `refused`
/// in `found`.
#[must_use = "these states have no solution"]
pub fn accelerate_each<M: Mechanism>(
    mechanism: &M,
    states: &[State<M>],
    found: &mut Vec<Solution<M>>,
) -> Vec<(usize, Failure)> {
    accelerate_each_with(Vectors::widest(), mechanism, states, found)
}

/// [`accelerate_each`] with chosen vector instructions, for measurements.
#[must_use = "these states have no solution"]
pub fn accelerate_each_with<M: Mechanism>(
    vectors: Vectors,
    mechanism: &M,
    states: &[State<M>],
    found: &mut Vec<Solution<M>>,
) -> Vec<(usize, Failure)> {
    found.resize(states.len(), unsolved(mechanism));
    vectors.run(Batch { mechanism, states, found })
}

fn unsolved<M: Mechanism>(mechanism: &M) -> Solution<M> {
    let (accelerations, multipliers) = (M::Q::repeat(mechanism.n(), 0.0), M::L::repeat(mechanism.m(), 0.0));
    Dynamics { accelerations, multipliers, power: 0.0, refused: true }
}

struct Batch<'a, M: Mechanism> {
    mechanism: &'a M,
    states: &'a [State<M>],
    found: &'a mut [Solution<M>],
}

// The code below uses loops, because closures given to iterators are separate functions, and functions that are not
// inlined are compiled for the baseline.
impl<M: Mechanism> Work for Batch<'_, M> {
    type Output = Vec<(usize, Failure)>;

    #[inline(always)]
    fn run<const AT_ONCE: usize>(self) -> Vec<(usize, Failure)> {
        let mut failures = Vec::new();
        let prepared = self.mechanism.on(Lanes::from_f64).prepare();
        for first in (0..self.states.len()).step_by(LANES) {
            let (states, found) = (&self.states[first..], &mut self.found[first..]);
            let filled;
            let chunk = match states.first_chunk() {
                Some(chunk) => chunk,
                None => {
                    filled = fill(states);
                    &filled
                }
            };
            let solved = dynamics::<M>(&prepared, chunk);
            if (solved.refused | is_not_finite::<M>(&solved)).any() {
                one_by_one(self.mechanism, first, states, found, &mut failures);
            } else if let Some(found) = found.first_chunk_mut() {
                scatter::<M>(&solved, found);
            } else {
                let mut all = std::array::from_fn(|_| unsolved(self.mechanism));
                scatter::<M>(&solved, &mut all);
                let count = found.len();
                found.clone_from_slice(&all[..count]);
            }
        }
        failures
    }
}

/// The last states, fewer than there are lanes: the first of them fills the missing lanes.
#[cold]
#[inline(never)]
fn fill<M: Mechanism>(states: &[State<M>]) -> [State<M>; LANES] {
    std::array::from_fn(|lane| states[if lane < states.len() { lane } else { 0 }].clone())
}

/// The kernel at as many states as there are lanes.
#[inline(always)]
fn dynamics<M: Mechanism>(prepared: &Prepared<M>, states: &[State<M>; LANES]) -> Solutions<M> {
    let n = states[0].positions.len();
    let zero = Q::<M>::repeat(n, Lanes::from_f64(0.0));
    let (mut positions, mut speeds) = (zero.clone(), zero);
    for i in 0..n {
        positions[i] = column(states, |state| state.positions[i]);
        speeds[i] = column(states, |state| state.speeds[i]);
    }
    let time = column(states, |state| state.time);
    InLanes::<M>::prepared_dynamics(prepared, time, &positions, &speeds)
}

#[inline(always)]
fn column<T>([a, b, c, d, e, f, g, h]: &[T; LANES], entry: impl Fn(&T) -> f64) -> Lanes<LANES> {
    Lanes::from([entry(a), entry(b), entry(c), entry(d), entry(e), entry(f), entry(g), entry(h)])
}

/// Whether anything of a solution is infinite or NaN.
#[inline(always)]
fn is_not_finite<M: Mechanism>(solved: &Solutions<M>) -> LaneMask<LANES> {
    // 0 x is 0 unless x is infinite or NaN, and so is the sum of such products.
    let zero = Lanes::from_f64(0.0);
    let mut sum = zero * solved.power;
    for i in 0..solved.accelerations.len() {
        sum = sum + zero * solved.accelerations[i];
    }
    for i in 0..solved.multipliers.len() {
        sum = sum + zero * solved.multipliers[i];
    }
    Lanes::not(Lanes::from_f64(1.0).greater(sum))
}

#[inline(always)]
fn scatter<M: Mechanism>(solved: &Solutions<M>, found: &mut [Solution<M>; LANES]) {
    for lane in 0..LANES {
        for i in 0..solved.accelerations.len() {
            found[lane].accelerations[i] = solved.accelerations[i].lane(lane);
        }
        for i in 0..solved.multipliers.len() {
            found[lane].multipliers[i] = solved.multipliers[i].lane(lane);
        }
        found[lane].power = solved.power.lane(lane);
        found[lane].refused = false;
    }
}

/// The states of one call of the kernel again, when it has refused one or more of them.
#[cold]
#[inline(never)]
fn one_by_one<M: Mechanism>(
    mechanism: &M,
    first: usize,
    states: &[State<M>],
    found: &mut [Solution<M>],
    failures: &mut Vec<(usize, Failure)>,
) {
    for (lane, (state, found)) in states.iter().zip(found).enumerate().take(LANES) {
        match accelerate(mechanism, state.time, &state.positions, &state.speeds) {
            Ok(solution) => *found = solution,
            Err(failure) => {
                *found = unsolved(mechanism);
                failures.push((first + lane, failure));
            }
        }
    }
}
