//! What runs are looked at with.

use sim::{Mechanism, Run, Table};

/// A column of a run that did not fail.
pub(crate) fn column<M: Mechanism>(run: &Run<M>, name: &str) -> Vec<f64> {
    assert_eq!(run.trajectory.failure, None);
    Table::of(&run.mechanism, &run.trajectory).column(name).unwrap().values.clone()
}

/// The largest difference of a column from what it should be, given the values of another one.
pub(crate) fn apart<M: Mechanism>(run: &Run<M>, name: &str, of: &str, expected: impl Fn(f64) -> f64) -> f64 {
    let pairs = column(run, of).into_iter().zip(column(run, name));
    pairs.map(|(x, found)| (found - expected(x)).abs()).fold(0.0, f64::max)
}
