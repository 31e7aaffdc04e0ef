//! Every method and its dense output show their order of convergence, projection included.

use models::{DoublePendulum, FourBar, QuickReturn};
use sim::{
    Advance, Compiled, Course, DOPRI5, Dop853, ExplicitRungeKutta, HEUN, Measures, Method, Motion, RK4, Radau5, Rows,
    Settings, Stabilisation, Stepping, Steps, Table, assemble, declared_start, integrate,
};
use std::ops::ControlFlow;
use tests::run_with;

/// Positions and speeds at 17 times, by equal steps.
fn states<M: Compiled>(mechanism: M, method: Method, end: f64, steps: usize) -> Vec<Vec<f64>> {
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
fn observed_order<M: Compiled>(mechanism: M, method: Method, end: f64, coarsest: usize, floor: f64) -> f64 {
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

/// An end, and the first count of steps.
type Span = (f64, usize);

/// Every method to one end but DOPRI5 and DOP853, whose leading terms are alone only where their errors are about to be
/// rounding: each has an end and a count of steps of its own.
fn check<M: Compiled>(mechanism: M, end: f64, dopri5: Span, dop853: Span) {
    for method in Method::ALL {
        // Rounding collects over the steps: thousands of them, or hundreds.
        let ((end, coarsest), floor, tolerance) = match method {
            Method::Dopri5 => (dopri5, 2e-13, 0.05),
            // Rounding of 2e-14 in an error of little more than the floor is a tenth of an order.
            Method::Dop853 => (dop853, 1e-13, 0.1),
            Method::Radau5 => ((end, 32), 1e-12, 0.05),
            _ => ((end, 256), 2e-11, 0.05),
        };
        let order = observed_order(mechanism, method, end, coarsest, floor);
        let expected = method.order() as f64;
        assert!((order - expected).abs() < tolerance, "{} {}: {order}", M::DESCRIPTION.name, method.name());
    }
}

#[test]
fn the_quick_return_mechanism_shows_every_order() {
    check(QuickReturn::default(), 0.8, (0.8, 352), (1.18, 80));
}

#[test]
fn a_four_bar_shows_every_order() {
    check(FourBar::default(), 0.3, (0.2, 176), (0.71, 96));
}

#[test]
fn a_double_pendulum_shows_every_order() {
    check(DoublePendulum::default(), 1.0, (1.0, 576), (1.61, 128));
}

/// Of positions and of speeds.
type Pair = [f64; 2];

/// The largest error at places inside one step of this length.
fn error_inside<A: Advance<QuickReturn>>(mut method: A, h: f64) -> Pair {
    let mechanism = QuickReturn::default();
    let start = assemble(&mechanism, &declared_start(&mechanism)).unwrap();
    let measures = Measures::at(&mechanism, start.time, &start.positions);
    let motion = Motion::new(mechanism, Stabilisation::Projection, measures);
    let first = motion.sample(start).unwrap();
    let course = Course { begin: 0.0, end: h, stepping: Stepping::Equal(1) };
    let mut inside = Vec::new();
    integrate(&motion, &mut method, &course, first, &mut Steps::default(), |step| {
        for fraction in [0.15, 0.3, 0.45, 0.6, 0.75, 0.9] {
            inside.push(step.at(fraction * h)?);
        }
        Ok(ControlFlow::Continue(()))
    })
    .unwrap();
    let mut worst = [0.0f64; 2];
    // The same times as ends of short steps from the start.
    for state in &inside {
        let settings = Settings { rows: Rows::Even(1), ..Settings::equal_steps(Method::Dop853, state.time, 64) };
        let exact = run_with(mechanism, &settings).unwrap().trajectory.samples.last().unwrap().state.clone();
        let far = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).fold(0.0f64, |worst, (a, b)| worst.max((a - b).abs()));
        worst[0] = worst[0].max(far(exact.positions, state.positions));
        worst[1] = worst[1].max(far(exact.speeds, state.speeds));
    }
    worst
}

/// Inside one step an interpolant of order p is wrong by O(h^(p + 1)): DOP853's own of order 7, Radau's collocation
/// polynomial of order 3, and the quintic of both ends of the method's order up to 5, with speeds, its derivative, of one order
/// less.
#[test]
fn dense_output_shows_its_order() {
    let mechanism = &QuickReturn::defaults();
    let dop853 = |h| error_inside(Dop853::new(mechanism), h);
    let radau = |h| error_inside(Radau5::new(mechanism), h);
    let explicit = |tableau, h| error_inside(ExplicitRungeKutta::new(mechanism, tableau), h);
    let rows: [(&str, [Pair; 2], Pair); 5] = [
        ("dop853", [0.025, 0.0125].map(dop853), [7.0, 7.0]),
        ("radau5", [0.004, 0.002].map(radau), [3.0, 3.0]),
        ("dopri5", [0.008, 0.004].map(|h| explicit(&DOPRI5, h)), [5.0, 4.0]),
        ("rk4", [0.004, 0.002].map(|h| explicit(&RK4, h)), [4.0, 3.0]),
        ("heun", [0.002, 0.001].map(|h| explicit(&HEUN, h)), [2.0, 1.0]),
    ];
    for (name, [coarse, fine], order) in rows {
        let observed = [0, 1].map(|k| (coarse[k] / fine[k]).log2() - 1.0);
        println!("{name}: {:.1e} and {:.1e}, order {observed:.2?} of {order:?}", fine[0], fine[1]);
    }
    for (name, [coarse, fine], order) in rows {
        for k in 0..2 {
            let observed = (coarse[k] / fine[k]).log2() - 1.0;
            assert!((observed - order[k]).abs() < 0.3, "{name}: {observed} is not {}", order[k]);
        }
    }
}
