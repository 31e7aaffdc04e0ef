//! Running properties with fixed seeds.

use proptest::strategy::Strategy;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestRunner};
use std::cell::Cell;

/// What a random case showed.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Verdict {
    /// It could have failed, and did not.
    Holds,
    /// Rounding leaves open what the right answer is.
    Open,
}

pub(crate) type Outcome = Result<Verdict, TestCaseError>;

/// How many cases: a part in a debug build, as the gate's is, and all in release.
pub(crate) const fn sampled(part: u32, all: u32) -> u32 {
    if cfg!(debug_assertions) { part } else { all }
}

/// Draws the cases, always the same ones, and requires that at least a given percentage is not left open.
pub(crate) fn check<S: Strategy>(cases: u32, least_percent: u32, strategy: S, property: impl Fn(S::Value) -> Outcome) {
    let config = Config {
        cases,
        rng_seed: RngSeed::Fixed(20),
        failure_persistence: None,
        max_local_rejects: u32::MAX,
        ..Config::default()
    };
    let held = Cell::new(0);
    let counted = |case| {
        held.set(held.get() + u32::from(property(case)? == Verdict::Holds));
        Ok(())
    };
    if let Err(failure) = TestRunner::new(config).run(&strategy, counted) {
        panic!("{failure}");
    }
    let percent = 100 * held.get() / cases;
    assert!(percent >= least_percent, "only {percent} % of the cases decide anything");
}
