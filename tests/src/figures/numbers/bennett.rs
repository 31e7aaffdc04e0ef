//! An overconstrained loop: the order of equal steps, and what adaptive ones cost.

use crate::figures::Table;
use models::Bennett;
use sim::{Method, Rows, Settings, Stabilisation, State};

pub(super) fn measure(table: &mut Table) {
    table.heading("Bennett's linkage");
    let adaptive = |tolerance| Settings::adaptive(Method::Dop853, 2.0, tolerance);
    let Some((exact, _)) = end(Stabilisation::Partitioning, adaptive(1e-13)) else {
        table.at_most("runs by partitioning that fail", 1.0, 0.0);
        return;
    };
    let (_, by_partitioning) = end(Stabilisation::Partitioning, adaptive(1e-10)).unwrap_or((exact.clone(), 0));
    for stabilisation in [Stabilisation::Projection, Stabilisation::MassProjection] {
        let error = |steps| {
            let found = end(stabilisation, Settings::equal_steps(Method::Rk4, 2.0, steps));
            found.map_or(f64::NAN, |(state, _)| apart(&state, &exact))
        };
        let errors = [64, 128, 256, 512, 1024].map(error);
        let orders = errors.windows(2).map(|pair| (pair[0] / pair[1]).log2());
        // A run that failed has no order.
        let least = if errors.iter().any(|error| error.is_nan()) { f64::NAN } else { orders.fold(4.0, f64::min) };
        table.at_most(&format!("4 less the least order of RK4, 64 to 1024 steps, {stabilisation}"), 4.0 - least, 0.2);
        let evaluations = end(stabilisation, adaptive(1e-10)).map_or(f64::NAN, |(_, evaluations)| evaluations as f64);
        let ratio = evaluations / by_partitioning as f64;
        table.at_most(&format!("right-hand sides of DOP853 at 1e-10, {stabilisation} over partitioning"), ratio, 1.3);
    }
}

/// Where a run ends, and how many right-hand sides it took; nothing if it failed.
fn end(stabilisation: Stabilisation, settings: Settings) -> Option<(State<Bennett>, u64)> {
    let settings = Settings { stabilisation, rows: Rows::Even(1), ..settings };
    let run = tests::run_with(Bennett::default(), &settings).ok().filter(|run| run.trajectory.failure.is_none())?;
    Some((run.trajectory.samples.last()?.state.clone(), run.evaluations))
}

/// The largest difference of positions and speeds.
fn apart(a: &State<Bennett>, b: &State<Bennett>) -> f64 {
    let positions = (0..3).map(|i| (a.positions[i] - b.positions[i]).abs());
    positions.chain((0..3).map(|i| (a.speeds[i] - b.speeds[i]).abs())).fold(0.0, f64::max)
}
