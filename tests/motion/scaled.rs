//! The same mechanism small and large, light and heavy: the same steps, and the same numbers scaled back.

use models::Bennett;
use sim::{Measures, Method, Rows, Run, Settings, Stabilisation, State, Table, assemble, declared_start, mechanism};
use tests::any_model::{AnyModel, run_with};

mechanism! {
    /// A slider-crank of free bodies, whose piston is pushed.
    FreeEngine;
    parameters { r [m] = 0.15; l [m] = 0.45; m [kg] = 1; J [kg*m^2] = 0.01; F [N] = 40; }
    bodies {
        crank: free, mass m, inertia m*r^2/12;
        rod: free, mass 2*m, inertia m*l^2/6;
        piston: free, mass m, inertia J;
    }
    loads { force [-F, 0] at on(piston, [0, 0]); force [0, -3*F] at on(rod, [0, 0]); }
    joints {
        main: pin on(crank, [-r/2, 0]) to [0, 0];
        big_end: pin on(rod, [-l/2, 0]) to on(crank, [r/2, 0]);
        small_end: pin on(piston, [0, 0]) to on(rod, [l/2, 0]);
        cylinder: slide piston through [0, 0] along 0;
    }
    initial { crank_phi = 0.5; dot(crank_phi) = 20; guess crank_x = r/2; guess rod_x = l; guess piston_x = r + l; }
    outputs { bearing [N] = norm(reaction(main)); piston_acceleration [m/s^2] = ddot(piston_x); }
}

impl FreeEngine {
    /// The same with its lengths, masses and forces times these; forces are such that the motion is similar.
    fn scaled(length: f64, mass: f64) -> FreeEngine {
        let FreeEngine { r, l, m, J, F } = <FreeEngine>::default();
        let (force, inertia) = (mass * length, mass * length * length);
        FreeEngine { r: r * length, l: l * length, m: m * mass, J: J * inertia, F: F * force }
    }
}

/// By what a column in this unit is larger where lengths and masses are.
fn factor(unit: &str, length: f64, mass: f64) -> f64 {
    match unit {
        "m" | "m/s" | "m/s^2" => length,
        "N" => mass * length,
        "N*m" | "J" | "W" => mass * length * length,
        _ => 1.0,
    }
}

fn assert_similar(of_one: &Run<AnyModel>, other: &Run<AnyModel>, [length, mass]: [f64; 2]) {
    let what = format!(
        "{} {:?} {} {length} m {mass} kg",
        of_one.settings.method.name(),
        of_one.settings.stepping,
        of_one.settings.stabilisation
    );
    assert_eq!((&of_one.trajectory.failure, &other.trajectory.failure), (&None, &None), "{what}");
    assert_eq!((&of_one.steps.accepted, of_one.evaluations), (&other.steps.accepted, other.evaluations), "{what}");
    let tables = [of_one, other].map(|run| Table::of(&run.mechanism, &run.trajectory));
    // A column may be zero throughout but for rounding, which is that of others in its unit.
    let largest = |unit: &str| {
        let columns = tables[0].columns.iter().filter(|column| column.unit == unit);
        columns.flat_map(|column| &column.values).fold(0.0f64, |range, value| range.max(value.abs()))
    };
    for (a, b) in tables[0].columns.iter().zip(&tables[1].columns) {
        let factor = factor(&a.unit, length, mass);
        let range = largest(&a.unit);
        let apart = a.values.iter().zip(&b.values).fold(0.0f64, |apart, (a, b)| apart.max((a - b / factor).abs()));
        // A thousand steps of rounding, amplified by the condition of the loop.
        assert!(apart <= 1e-9 * range, "{what}: {} {apart:e} of {range:e}", a.name);
    }
}

#[test]
fn a_mechanism_of_any_size_takes_the_same_steps_to_the_same_numbers() {
    let mut all = Vec::new();
    for stabilisation in [Stabilisation::Projection, Stabilisation::MassProjection, Stabilisation::Partitioning] {
        for method in Method::ALL {
            all.push(Settings { stabilisation, rows: Rows::Even(37), ..Settings::equal_steps(method, 0.3, 200) });
        }
        for method in [Method::Dopri5, Method::Dop853, Method::Radau5] {
            all.push(Settings { stabilisation, rows: Rows::Even(37), ..Settings::adaptive(method, 0.3, 1e-8) });
        }
    }
    for settings in all {
        let of_one = run_with(FreeEngine::default(), &settings).unwrap();
        for [length, mass] in [[1e-3, 1e3], [100.0, 1e-3]] {
            let other = run_with(FreeEngine::scaled(length, mass), &settings).unwrap();
            assert_similar(&of_one, &other, [length, mass]);
        }
    }
}

/// Away from singular positions a run with N steps evaluates stages x N right-hand sides, and one at its start.
#[test]
fn equal_steps_are_equal_steps_at_any_size() {
    let stages = [(Method::Euler, 1), (Method::Heun, 2), (Method::Rk3, 3), (Method::Rk4, 4)];
    for (method, stages) in stages {
        for steps in [400, 2000, 8192] {
            for length in [1e-3, 0.1, 1.0, 100.0] {
                let run =
                    run_with(FreeEngine::scaled(length, 1.0), &Settings::equal_steps(method, 0.3, steps)).unwrap();
                let counted = (run.steps.accepted, run.evaluations);
                assert_eq!(counted, (steps as u64, (stages * steps) as u64 + 1), "{method:?} {length} m");
            }
        }
    }
}

/// The mechanism's own length is in proportion to it, whatever else is.
#[test]
fn the_own_length_is_in_proportion_to_the_mechanism() {
    let length = |mechanism: FreeEngine| {
        let start = assemble(&mechanism, &declared_start(&mechanism)).unwrap();
        Measures::at(&mechanism, 0.0, &start.positions).coordinates()[0]
    };
    let of_one = length(FreeEngine::default());
    // Of the size of its levers, of 0.075 m and 0.225 m.
    assert!((0.05..=0.3).contains(&of_one), "{of_one}");
    for factor in [1e-3, 100.0] {
        let apart = length(FreeEngine::scaled(factor, 7.0)) / factor / of_one - 1.0;
        assert!(apart.abs() < 1e-12, "{apart:e}");
    }
}

/// Bennett's loop has three rows too many. Stages of Runge-Kutta lie beside the constraints, where these rows contradict the
/// others; met in least squares they cost neither the order of a method nor a step.
#[test]
fn an_overconstrained_loop_keeps_the_order_and_the_steps_of_a_method() {
    let state = |settings: &Settings| {
        let run = run_with(Bennett::default(), settings).unwrap();
        assert_eq!(run.trajectory.failure, None, "{}", settings.stabilisation);
        (run.trajectory.samples.last().unwrap().state.clone(), run.evaluations)
    };
    let with = |stabilisation, settings: Settings| state(&Settings { stabilisation, rows: Rows::Even(1), ..settings });
    let adaptive = |tolerance| Settings::adaptive(Method::Dop853, 2.0, tolerance);
    let (exact, _) = with(Stabilisation::Partitioning, adaptive(1e-13));
    let distance = |found: State<AnyModel>| {
        let apart = |a: &[f64], b: &[f64]| (0..3).fold(0.0f64, |most, i| most.max((a[i] - b[i]).abs()));
        apart(found.positions.as_ref(), exact.positions.as_ref())
            .max(apart(found.speeds.as_ref(), exact.speeds.as_ref()))
    };
    let (_, evaluations) = with(Stabilisation::Partitioning, adaptive(1e-10));
    for stabilisation in [Stabilisation::Projection, Stabilisation::MassProjection] {
        let error = |steps| distance(with(stabilisation, Settings::equal_steps(Method::Rk4, 2.0, steps)).0);
        let errors = [64, 128, 256, 512, 1024].map(error);
        let orders: Vec<f64> = errors.windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect();
        let (found, taken) = with(stabilisation, adaptive(1e-10));
        let found = distance(found);
        println!(
            "{stabilisation}: {errors:?}, orders {orders:.2?}; {found:.1e} by {taken}, partitioning {evaluations}"
        );
        // Higher terms of the error are a tenth of the leading one at 64 steps.
        assert!(orders.iter().all(|order| (3.8..4.4).contains(order)));
        assert!(found < 1e-8 && taken as f64 <= 1.3 * evaluations as f64);
    }
}
