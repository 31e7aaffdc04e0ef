//! Every method and its dense output show their order of convergence, projection included.

use models::{DoublePendulum, FourBar, QuickReturn};
use sim::{
    Advance, Course, Dop853, ExplicitRungeKutta, Mechanism, Method, Motion, RK4, Rows, Settings, Stabilisation,
    Stepping, Steps, Table, assemble, declared_start, integrate,
};
use std::ops::ControlFlow;
use tests::run_with;

/// Positions and speeds at 17 times, by equal steps.
fn states<M: Mechanism>(mechanism: M, method: Method, end: f64, steps: usize) -> Vec<Vec<f64>> {
    let settings = Settings { rows: Rows::Even(16), ..Settings::equal_steps(method, end, steps) };
    let run = run_with(mechanism, &settings).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let table = Table::of(&run.mechanism, &run.trajectory);
    table.columns[1..=2 * M::DESCRIPTION.coordinates.len()].iter().map(|column| column.values.clone()).collect()
}

/// The largest error of any column at any of the times, relative to the column's largest.
fn error(found: &[Vec<f64>], exact: &[Vec<f64>]) -> f64 {
    let largest = |values: &[f64]| values.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
    let of_column = |(found, exact): (&Vec<f64>, &Vec<f64>)| {
        let differences: Vec<f64> = found.iter().zip(exact).map(|(a, b)| a - b).collect();
        largest(&differences) / largest(exact)
    };
    found.iter().zip(exact).map(of_column).fold(0.0, f64::max)
}

/// The order between the finest pair of step counts, each twice the one before, whose errors are above rounding.
fn observed_order<M: Mechanism>(mechanism: M, method: Method, end: f64, coarsest: usize, floor: f64) -> f64 {
    // Finer than DOP853 needs for its rounding floor.
    let exact = states(mechanism, Method::Dop853, end, 3000);
    let mut steps = coarsest;
    let mut last = error(&states(mechanism, method, end, steps), &exact);
    let mut order = f64::NAN;
    loop {
        steps *= 2;
        let next = error(&states(mechanism, method, end, steps), &exact);
        println!(
            "{:<16} {:<8} {steps:>7} steps, error {next:.1e}, order {:.3}",
            M::DESCRIPTION.name,
            method.name(),
            (last / next).log2()
        );
        if next < floor || steps == 1 << 16 {
            return order;
        }
        (order, last) = ((last / next).log2(), next);
    }
}

/// Every method to one end but DOPRI5, whose leading term is alone only where its errors are about to be rounding: it has
/// an end and a count of steps of its own.
fn check<M: Mechanism>(mechanism: M, end: f64, (dopri5_end, dopri5_steps): (f64, usize)) {
    for method in Method::ALL {
        // Rounding collects over the steps: thousands of them, or hundreds.
        let (end, coarsest, floor) = match method {
            Method::Dopri5 => (dopri5_end, dopri5_steps, 2e-13),
            Method::Radau5 => (end, 32, 1e-12),
            Method::Dop853 => (end, 16, 2e-11),
            _ => (end, 256, 2e-11),
        };
        let order = observed_order(mechanism, method, end, coarsest, floor);
        let expected = method.order() as f64;
        // Errors of DOP853 are rounding before its leading term is alone: until then it shows more than 8. That it has this
        // order and no other is shown by its order conditions.
        let is_shown = if method == Method::Dop853 { order > expected - 0.05 } else { (order - expected).abs() < 0.05 };
        assert!(is_shown, "{} {}: {order}", M::DESCRIPTION.name, method.name());
    }
}

#[test]
fn the_quick_return_mechanism_shows_every_order() {
    check(QuickReturn::default(), 0.8, (0.8, 352));
}

#[test]
fn a_four_bar_shows_every_order() {
    check(FourBar::default(), 0.3, (0.2, 176));
}

#[test]
fn a_double_pendulum_shows_every_order() {
    check(DoublePendulum::default(), 1.0, (1.0, 576));
}

/// The largest error of positions at 0.3 of each step, which is at a new place every time.
fn dense_error<A: Advance<QuickReturn>>(mut method: A, steps: usize) -> f64 {
    let mechanism = QuickReturn::default();
    let motion = Motion::new(&mechanism, Stabilisation::Projection);
    let first = motion.sample(assemble(&mechanism, &declared_start(&mechanism)).unwrap()).unwrap();
    let course = Course { begin: 0.0, end: 1.0, stepping: Stepping::Equal(steps), interrupt: None };
    let mut inside = Vec::new();
    integrate(&motion, &mut method, &course, first, &mut Steps::default(), |step| {
        inside.push(step.at(step.from.state.time + 0.3 * step.length())?);
        Ok(ControlFlow::Continue(()))
    })
    .unwrap();
    let mut worst = 0.0f64;
    // The same times as ends of short steps from the start.
    for state in inside.iter().step_by(steps / 8) {
        let settings = Settings { rows: Rows::Even(1), ..Settings::equal_steps(Method::Dop853, state.time, 2048) };
        let exact = run_with(mechanism, &settings).unwrap();
        let exact = exact.trajectory.samples.last().unwrap().state.positions;
        worst = exact.iter().zip(state.positions).fold(worst, |worst, (a, b)| worst.max((a - b).abs()));
    }
    worst
}

/// The interpolant of DOP853 is of order 7, the quintic of the others of order 5: errors of one step more inside.
#[test]
fn dense_output_shows_its_order() {
    let pairs: [(&str, [f64; 2], f64); 2] = [
        ("dop853", [32, 64].map(|steps| dense_error(Dop853::new(), steps)), 7.0),
        ("rk4", [128, 256].map(|steps| dense_error(ExplicitRungeKutta::new(&RK4), steps)), 4.0),
    ];
    for (name, [coarse, fine], order) in pairs {
        let observed = (coarse / fine).log2();
        println!("{name}: {coarse:.1e}, {fine:.1e}, order {observed:.2}");
        assert!(observed > order - 0.3, "{name}: {observed}");
    }
}
