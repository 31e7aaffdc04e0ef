//! What interpreted kernels cost: a call, many states at once, a whole run.

use crate::figures::Table;
use models::QuickReturn;
use sim::{At, Erased, InPlace, Kernel, Model, Settings, States, Vectors, declared_start};
use std::hint::black_box;
use std::sync::Arc;
use tests::interleaved;
use tests::same_bits::interpreted;

/// Calls that are timed together.
const CALLS: usize = 20_000;

/// Rounds of them, of which the fastest counts: a processor takes half a second to come to its clock.
const ROUNDS: usize = 400;

pub(super) fn a_call(table: &mut Table) {
    table.heading("A call of quick-return's right-hand side");
    let Some([compiled, interpreted]) = quick_return(table) else { return };
    let (mut first, mut second) = (calls(&*compiled), calls(&*interpreted));
    let times = interleaved(ROUNDS, &mut [&mut first, &mut second, &mut direct_calls()]);
    let [one, other, direct] = [0, 1, 2].map(|work| 1e9 * times[work].as_secs_f64() / CALLS as f64);
    let what = format!("interpreted, in ns; compiled, through the same interface {one:.0}, directly {direct:.0}");
    table.at_most(&what, other, 250.0);
}

/// The compiled kernel at the start, as a user's own loop calls it.
fn direct_calls() -> impl FnMut() {
    let mechanism = QuickReturn::default();
    let start = declared_start(&mechanism);
    let prepared = mechanism.prepare();
    move || {
        for _ in 0..CALLS {
            let (q, qd) = black_box((&start.positions, &start.speeds));
            black_box(prepared.dynamics(0.1, q, qd));
        }
    }
}

/// Right-hand sides at the start, one by one.
fn calls(model: &dyn Model) -> impl FnMut() + use<> {
    let ([q, qd], prepared) = (model.initial(), model.prepare());
    move || {
        let at = At { time: 0.1, positions: &q, speeds: &qd, accelerations: &[], multipliers: &[] };
        for _ in 0..CALLS {
            prepared.call(Kernel::Dynamics, black_box(at), &mut |_, row| {
                black_box(row);
            });
        }
    }
}

/// States that a kernel gets at once.
const MANY: usize = 10_000;

pub(super) fn blocks(table: &mut Table) {
    table.heading("quick-return's right-hand side at many states at once");
    let Some([_, interpreted]) = quick_return(table) else { return };
    let [q, qd] = interpreted.initial();
    let times: Vec<f64> = (0..MANY).map(|state| 1e-4 * state as f64).collect();
    let repeated = |numbers: &[f64]| numbers.repeat(MANY);
    let (positions, speeds) = (repeated(&q), repeated(&qd));
    let states = States { times: &times, positions: &positions, speeds: &speeds, accelerations: &[], multipliers: &[] };
    for vectors in [Vectors::avx2(), Vectors::avx512()].into_iter().flatten() {
        let mut of_many = || {
            black_box(interpreted.call_each_with(vectors, Kernel::Dynamics, black_box(&states)));
        };
        let times = interleaved(ROUNDS, &mut [&mut direct_calls(), &mut of_many]);
        let nanoseconds = |work: usize, states: usize| 1e9 * times[work].as_secs_f64() / states as f64;
        let (one, many) = (nanoseconds(0, CALLS), nanoseconds(1, MANY));
        table.at_most(
            &format!("interpreted, in ns a state, with {vectors}; compiled, one state directly {one:.0}"),
            many,
            20.0,
        );
    }
}

/// Compiled and interpreted.
fn quick_return(table: &mut Table) -> Option<[Arc<dyn Model>; 2]> {
    let compiled = sim::erase(QuickReturn::default());
    match interpreted(&*compiled) {
        Ok(interpreted) => Some([compiled, interpreted]),
        Err(mistakes) => {
            table.line("quick-return", mistakes, "read", false);
            None
        }
    }
}

pub(super) fn a_run(table: &mut Table) {
    table.heading("A whole run of quick-return");
    let Some([_, interpreted]) = quick_return(table) else { return };
    let Some(interpreted) = Erased::<InPlace<8>>::new(interpreted) else { return };
    let compiled = QuickReturn::default();
    let settings = Settings::new(2.0);
    let mut first = || {
        black_box(sim::run(compiled, &declared_start(&compiled), &settings).is_ok());
    };
    let mut second = || {
        black_box(sim::run(interpreted.clone(), &declared_start(&interpreted), &settings).is_ok());
    };
    let times = interleaved(15, &mut [&mut first, &mut second]);
    let ratio = times[1].as_secs_f64() / times[0].as_secs_f64();
    table.at_most("interpreted beside its own compiled loops", ratio, 6.0);
}
