//! Bodies that time alone moves, by tables and with corners, beside others: what moves them does work.

use sim::{Method, Rows, Run, Settings, Stepping, Table, What};
use tests::any_model::{AnyModel, interpreted};
use tests::run_with;

/// A carriage that goes along a way, and a mass on a spring beside it, which it does not touch.
fn carried(length: f64, way: &str) -> String {
    format!(
        "pub Carried; coordinates {{ y [m]; }}
         tables {{ measured [m] over [s] = monotone {{ 0, 0; 0.3, {}; 0.5, {}; 0.8, {}; 2, {}; }} }}
         parameters {{ l [m] = {length:e}; k [N/m] = 10; }}
         let s = {way};
         bodies {{ carriage: mass 3 [kg] at [s, 0]; bob: mass 1 [kg] at [0, y]; }}
         loads {{ spring k, rest 0 on y; }} initial {{ y = l/10; }}
         outputs {{ energy [J] = 3 [kg]*dot(s)^2/2 + 1 [kg]*dot(y)^2/2; }}",
        0.1 * length,
        0.5 * length,
        0.6 * length,
        length
    )
}

/// The largest difference of the gain of kinetic energy and the work in any row, beside the largest energy.
fn off(run: &Run<AnyModel>) -> f64 {
    assert_eq!(run.trajectory.failure, None);
    let table = Table::of(&run.mechanism, &run.trajectory);
    let [energy, work] = ["energy", "work"].map(|name| &table.column(name).unwrap().values);
    let largest = energy.iter().copied().fold(0.0, f64::max);
    let begun = energy[0];
    let apart = energy.iter().zip(work).map(|(energy, work)| (energy - begun - work).abs());
    apart.fold(0.0, f64::max) / largest
}

fn every_way() -> impl Iterator<Item = Settings> {
    let methods = [Method::Dop853, Method::Dopri5, Method::Radau5];
    let rows = [Rows::Even(1), Rows::Even(10), Rows::Even(1000), Rows::Steps];
    let tolerances = [1e-7, 1e-10];
    methods.into_iter().flat_map(move |method| {
        rows.into_iter().flat_map(move |rows| {
            tolerances.map(|relative| Settings { rows, ..Settings::adaptive(method, 1.3, relative) })
        })
    })
}

/// Accelerations of the carriage jump at the rows of its table, and so does the power, which nothing else feels.
#[test]
fn what_a_table_moves_takes_the_work_that_it_gains() {
    for length in [1e-3, 1.0, 100.0] {
        for settings in every_way() {
            let Stepping::Adaptive(tolerance) = settings.stepping else { continue };
            let off = off(&run_with(interpreted(&carried(length, "measured(t)")).unwrap(), &settings).unwrap());
            // The power is no part of the estimate of errors; without ends at the rows the work is wrong by a third.
            assert!(off < 100.0 * tolerance.relative, "{length} {:?} {tolerance:?}: {off:e}", settings.method);
        }
    }
}

/// A carriage that starts at full speed takes its kinetic energy at once, and no coordinate feels that.
#[test]
fn what_starts_at_full_speed_takes_its_energy_at_once() {
    for way in ["2*l*max(0, t/(1 [s]) - 0.5)", "if t < 0.5 [s] then 0 else l*(t/(1 [s]) - 0.5)"] {
        for settings in every_way() {
            let run = run_with(interpreted(&carried(1.0, way)).unwrap(), &settings).unwrap();
            assert_eq!(run.steps.corners.map(|corners| corners.steps), Some(1), "{way}");
            assert!(off(&run) < 1e-5, "{way} {:?}: {:e}", settings.method, off(&run));
        }
    }
}

/// A bob on a turning arm that is drawn in or let out at once: its energy grows by m v^2/2, and no coordinate feels that. A body that
/// is pushed along its way feels it, however little, and keeps its momentum: 1 m/s less 1 mm/s.
#[test]
fn what_is_felt_little_or_not_at_all_takes_its_energy() {
    let drawn = "pub Drawn; coordinates { phi [rad]; } let r = 1 [m] + 0.5 [m/s]*max(0 [s], t - 0.5 [s]);
        bodies { bob: mass 1 [kg] at r*[cos(phi), sin(phi)]; } initial { phi = 0; dot(phi) = 1; }
        outputs { energy [J] = 0.5 [kg]*(dot(r)^2 + r^2*dot(phi)^2); }";
    let run = run_with(interpreted(drawn).unwrap(), &Settings::adaptive(Method::Dop853, 2.0, 1e-10)).unwrap();
    assert!(off(&run) < 1e-7, "{:e}", off(&run));
    let pushed = "pub Pushed; coordinates { x [m]; z [m]; } let way = 1e-3 [m/s]*max(0 [s], t - 1e-3 [s]);
        bodies { a: mass 1 [kg] at [x + way, 0]; b: mass 1 [kg] at [0, z]; } loads { spring 1e12 [N/m], rest 0 on z; }
        initial { z = 1e-6; x = 1; dot(x) = 1; }";
    let run = run_with(interpreted(pushed).unwrap(), &Settings::adaptive(Method::Dop853, 2e-3, 1e-10)).unwrap();
    let state = &run.trajectory.samples.last().unwrap().state;
    assert!((state.speeds[0] - 0.999).abs() < 1e-9, "{}", state.speeds[0]);
}

/// Equal steps lead over such rows, and are counted.
#[test]
fn equal_steps_over_rows_that_jump_are_counted() {
    let counted = |way: &str, steps| {
        let run = run_with(interpreted(&carried(1.0, way)).unwrap(), &Settings::equal_steps(Method::Rk4, 1.0, steps));
        run.unwrap().steps.sudden_changes.map_or(0, |changes| changes.steps)
    };
    // Rows at 0.3, 0.5 and 0.8 s, within steps and at their ends.
    assert_eq!([counted("measured(t)", 64), counted("measured(t)", 100)], [3, 3]);
    assert_eq!(counted("l*sin(t/(1 [s]))", 64), 0);
}

/// A cart that a table drives and that stops at its last row throws what hangs from it: adaptive steps see that, and equal ones are
/// refused.
#[test]
fn equal_steps_over_the_end_of_a_course_are_refused() {
    let text = "pub Stopped; coordinates { x [m]; phi [rad]; }
        tables { way [m] over [s] = cubic { 0, 0; 0.2, 0.3; 0.4, 0.5; 0.5, 0.7; } }
        bodies { cart: mass 2 [kg] at [x, 0]; bob: mass 1 [kg] at [x + 0.4 [m]*sin(phi), -0.4 [m]*cos(phi)]; }
        loads { gravity [0, -9.81 [m/s^2]]; } constraints { drive: x = way(t); } initial { phi = 0.2; guess x = 0; }";
    let run = |settings: &Settings| run_with(interpreted(text).unwrap(), settings).unwrap();
    let adaptive = run(&Settings::adaptive(Method::Dop853, 1.0, 1e-10));
    assert_eq!(adaptive.steps.corners.map(|corners| corners.steps), Some(1));
    for steps in [100, 333] {
        let failure = run(&Settings::equal_steps(Method::Rk4, 1.0, steps)).trajectory.failure.unwrap();
        assert!(matches!(failure.what, What::CornerInEqualStep { time } if (time - 0.5).abs() < 1e-9), "{failure}");
        assert_eq!(run(&Settings::equal_steps(Method::Rk4, 0.495, steps)).trajectory.failure, None);
    }
}

/// Where a table dwells, what it moves begins from rest, and the speeds of nothing jump; nor at the turn of a cosine, where an
/// unrelated load begins.
#[test]
fn what_begins_from_rest_has_no_corner() {
    let dwells = "pub Dwells; coordinates { y [m]; }
        tables { way [m] over [s] = monotone { 0, 0; 0.3, 0; 0.5, 0.5; 0.8, 0.6; 1.2, 0.6; 1.5, 0; } }
        bodies { carriage: mass 3 [kg] at [way(t), 0]; bob: mass 1 [kg] at [0, y]; }
        loads { spring 10 [N/m], rest 0 on y; } initial { y = 0; }";
    let turns = "pub Turns; coordinates { y [m]; }
        bodies { carriage: mass 3 [kg] at [0.1 [m]*cos(3.141592653589793 [rad/s]*t), 0]; bob: mass 1 [kg] at [0, y]; }
        loads { force if t < 1 [s] then 1 [N] else 0 on y; } initial { y = 0; }";
    for text in [dwells, turns] {
        let run = run_with(interpreted(text).unwrap(), &Settings::adaptive(Method::Dop853, 1.4, 1e-10)).unwrap();
        assert_eq!((run.trajectory.failure, run.steps.corners), (None, None), "{text}");
    }
}

/// A drive at constant speed by a table: its second derivatives are rounding, and no row is a jump.
#[test]
fn rows_on_a_line_are_no_jumps() {
    for drive in
        ["cart: mass 2 [kg] at [x, 0]; } constraints { drive: x = way(t); ", "cart: mass 2 [kg] at [way(t), x]; "]
    {
        let text = format!(
            "pub Even; coordinates {{ x [m]; }}
             tables {{ way [m] over [s] = cubic, continued {{ 0, 0.1; 0.13, 0.139; 0.4, 0.22; 0.7, 0.31; 1.1, 0.43; 1.7, 0.61; }} }}
             bodies {{ {drive} }} initial {{ guess x = 0.1; }}"
        );
        let run = run_with(interpreted(&text).unwrap(), &Settings::equal_steps(Method::Rk4, 1.6, 53)).unwrap();
        assert_eq!((run.trajectory.failure, run.steps.sudden_changes), (None, None), "{text}");
    }
}
