//! The cam by a table against the law that its rows were taken from.

use models::CamFollower;
use sim::{Compiled, Method, Run, Settings, Table};
use std::f64::consts::{PI, TAU};
use tests::any_model::{self, AnyModel, interpreted};
use tests::run_with;

const LIFT: f64 = 0.012;

/// Lift with its first two derivatives: cycloidal rise over 120 degrees, dwell over 60, cycloidal return over 120, dwell.
fn cycloidal(angle: f64) -> [f64; 3] {
    let (angle, beta) = (angle.rem_euclid(TAU), TAU / 3.0);
    let rise = |angle: f64| {
        let turn = TAU * angle / beta;
        let slope = LIFT / beta;
        [LIFT * (angle / beta - turn.sin() / TAU), slope * (1.0 - turn.cos()), slope / beta * TAU * turn.sin()]
    };
    match angle {
        _ if angle < beta => rise(angle),
        _ if angle < PI => [LIFT, 0.0, 0.0],
        _ if angle < PI + beta => rise(angle - PI).map(|x| -x).map({
            let mut lifts = [LIFT, 0.0, 0.0].into_iter();
            move |x| x + lifts.next().unwrap_or(0.0)
        }),
        _ => [0.0; 3],
    }
}

fn one_turn(cam: CamFollower) -> Run<AnyModel> {
    let run = any_model::run_with(cam, &Settings::equal_steps(Method::Dop853, TAU / cam.w, 3600)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    run
}

/// The largest difference of a column from the law, relative to the largest of the law.
fn error(run: &Run<AnyModel>, column: &str, law: impl Fn(f64) -> f64) -> f64 {
    let table = Table::of(&run.mechanism, &run.trajectory);
    let (mut error, mut largest) = (0.0f64, 0.0f64);
    for (value, time) in table.column(column).unwrap().values.iter().zip(table.times()) {
        let law = law(CamFollower::<f64>::default().w * time);
        (error, largest) = (error.max((value - law).abs()), largest.max(law.abs()));
    }
    println!("{:<14} {column:<3} {:.1e} of {largest:.3}", CamFollower::<f64>::DESCRIPTION.name, error / largest);
    error / largest
}

/// Lift, acceleration, contact force and torque are those of the law, as far as a spline with a row every 4 degrees is. Its
/// error is h^4/384 of the fourth derivative in the value, h^2/12 in the second derivative (de Boor, A Practical Guide to
/// Splines, ch. V), here 120 degrees being a period: (2 pi/30)^4/384 = 5e-6 and (2 pi/30)^2/12 = 4e-3, and about twice that where
/// rise meets dwell, at the jump of the third derivative.
#[test]
fn a_cycloidal_cam() {
    let cam: CamFollower = CamFollower::default();
    let run = one_turn(cam);
    let w2 = cam.w * cam.w;
    let pressing = |a: f64| {
        let [s, _, curvature] = cycloidal(a);
        cam.m * (cam.g + curvature * w2) + cam.k * s + cam.F0
    };
    assert!(error(&run, "s", |a| 1e3 * cycloidal(a)[0]) < 5e-6);
    assert!(error(&run, "a", |a| cycloidal(a)[2] * w2) < 8e-3);
    assert!(error(&run, "N", pressing) < 1e-3);
    // What the drive gives is what the follower takes.
    assert!(error(&run, "T", |a| pressing(a) * cycloidal(a)[1]) < 1e-3);
}

/// With what the table itself says of the lift, everything is exact: the constraint, its derivatives and the reactions.
#[test]
fn a_cam_by_its_table() {
    let cam: CamFollower = CamFollower::default();
    let run = one_turn(cam);
    let lift = |a: f64| -> [f64; 3] { CamFollower::<f64>::TABLE_lift.at(a) };
    let pressing = |a: f64| {
        let [s, _, curvature] = lift(a);
        cam.m * (cam.g + curvature * cam.w * cam.w) + cam.k * s + cam.F0
    };
    assert!(error(&run, "s", |a| 1e3 * lift(a)[0]) < 1e-12);
    assert!(error(&run, "a", |a| lift(a)[2] * cam.w * cam.w) < 1e-9);
    assert!(error(&run, "N", pressing) < 1e-9);
    assert!(error(&run, "T", |a| pressing(a) * lift(a)[1]) < 1e-9);
    assert!(run.events.iter().all(|event| event.name != "float"));
}

/// Above the speed at which m y'' asks for more than weight and spring the follower leaves the cam where that begins.
#[test]
fn a_cam_that_is_too_fast() {
    let cam = CamFollower { w: 110.0, ..CamFollower::default() };
    let run = one_turn(cam);
    let pressing = |a: f64| {
        let [s, _, curvature] = cycloidal(a);
        cam.m * (cam.g + curvature * cam.w * cam.w) + cam.k * s + cam.F0
    };
    let floats: Vec<f64> = run.events.iter().filter(|e| e.name == "float").map(|e| cam.w * e.state.time).collect();
    // By bisection of the law, in the second half of the rise.
    let (mut before, mut after) = (PI / 3.0, PI / 2.0);
    assert!(pressing(before) > 0.0 && pressing(after) < 0.0);
    for _ in 0..60 {
        let middle = (before + after) / 2.0;
        if pressing(middle) > 0.0 { before = middle } else { after = middle }
    }
    println!("the follower leaves at {:.4} rad, by the law at {before:.4} rad", floats[0]);
    // The error of the second derivative over its slope: 4e-3 of the largest over 3 per radian.
    assert!((floats[0] - before).abs() < 2e-3);
}

/// A follower on a table of time that is smooth at its ends, 3 s^2 - 2 s^3, and stands still then: its acceleration jumps where
/// steps end, and it goes on; a spring carries a mass after it, u'' = w^2 (x - u), which all methods move alike.
#[test]
fn accelerations_may_jump_at_rows_of_a_drive() {
    for [rate, lift] in
        [[0.7, 1.0], [3.7, 1.0], [5.0, 1.0], [10.0, 1.0], [123.4, 1.0], [3.7, 0.1], [3.7, 1e5], [3.7, 1e7]]
    {
        let declaration = format!(
            "pub Follower; coordinates {{ x [m]; u [m]; }} tables {{ f [m] over [s] = cubic, clamped {{ 0, 0; 1, {lift}; }} }}
            bodies {{ follower: mass 2 [kg] at [x, 0]; carried: mass 1 [kg] at [u, 0]; }}
            loads {{ force 40 [N/m]*(x - u) on u; }} constraints {{ d: x = f({rate}*t); }}
            initial {{ guess x = 0; u = 0; dot(u) = 0; }}"
        );
        let mut ends = Vec::new();
        for method in [Method::Dop853, Method::Dopri5, Method::Radau5] {
            let run = run_with(interpreted(&declaration).unwrap(), &Settings::adaptive(method, 2.0, 1e-10)).unwrap();
            assert_eq!(run.trajectory.failure, None, "{rate} {lift} {method:?}");
            for sample in &run.trajectory.samples {
                let s = f64::min(1.0, rate * sample.state.time);
                let x = sample.state.positions[0] / lift;
                assert!((x - s * s * (3.0 - 2.0 * s)).abs() < 1e-11, "{rate} {lift} {method:?}");
            }
            ends.push(run.trajectory.samples.last().unwrap().state.positions[1] / lift);
        }
        // A hundred tolerances.
        assert!(ends.iter().all(|end| (end - ends[0]).abs() < 1e-8), "{rate} {lift}: {ends:?}");
    }
}

/// Where a drive ends with a speed, what it drives stops in no time, and its energy is work.
#[test]
fn a_drive_that_ends_with_a_speed_stops_what_it_drives() {
    let declaration = "pub Driven; coordinates { x [m]; } tables { f [m] over [s] = monotone { 0, 0; 1, 1; 2, 3; } }
        bodies { follower: mass 2 [kg] at [x, 0]; } constraints { d: x = f(1.3*t); }";
    for method in [Method::Dop853, Method::Dopri5, Method::Radau5] {
        let run = run_with(interpreted(declaration).unwrap(), &Settings::adaptive(method, 2.0, 1e-10)).unwrap();
        assert_eq!(run.trajectory.failure, None, "{method:?}");
        let corners = run.steps.corners.unwrap();
        assert!(corners.steps == 1 && (corners.first - 2.0 / 1.3).abs() < 1e-9, "{method:?}: {corners:?}");
        let last = &run.trajectory.samples.last().unwrap().state;
        // The start has the kinetic energy of the slope there, 0.5/s times 1.3.
        let begun = 0.5 * 2.0 * run.trajectory.samples[0].state.speeds[0].powi(2);
        assert!((last.positions[0] - 3.0).abs() < 1e-12 && last.speeds[0].abs() < 1e-12, "{method:?}");
        assert!((last.work + begun).abs() < 1e-9, "{method:?}: {} {begun}", last.work);
    }
}

/// Constant kinetic energy: the time to a place is the integral of sqrt(1 + f'^2) over a path y = f(x), which is straight but for a
/// bump between 7.2 and 7.4.
#[test]
fn a_bump_of_a_constraint_is_not_passed_over() {
    let u = "((x - 7.3 [m])/w)";
    // Heights over widths as they are, slopes in u.
    type Slope = fn(f64) -> f64;
    let quartic: Slope = |u| if u.abs() < 1.0 { -8.0 * u * (1.0 - u * u).powi(3) } else { 0.0 };
    let gaussian: Slope = |u| -2.0 * u * (-u * u).exp();
    let cases = [
        (format!("if abs(x - 7.3 [m]) < w then h*(1 - {u}^2)^4 else 0"), 2.0, 0.05, quartic),
        (format!("h*exp(-{u}^2)"), 2.0, 0.05, gaussian),
        (format!("h*exp(-{u}^2)"), 6.0, 0.05, gaussian),
    ];
    for (law, steep, width, slope) in cases {
        let longer = |u: f64| (1.0 + (steep * slope(u)).powi(2)).sqrt() - 1.0;
        // The trapezoidal rule, exact to rounding for what vanishes smoothly at both ends.
        let lost: f64 = width * (-8000..8000).map(|k| longer(f64::from(k) * 1e-3) * 1e-3).sum::<f64>();
        for placed in [true, false] {
            let (coordinates, y, constraint) = match placed {
                true => ("x [m];", law.as_str(), String::new()),
                false => ("x [m]; y [m];", "y", format!("constraints {{ k: y = {law}; }}")),
            };
            let text = format!(
                "pub Path; coordinates {{ {coordinates} }} parameters {{ h [m] = {}; w [m] = {width}; }}
                 bodies {{ bead: mass 1 [kg] at [x, {y}]; }} {constraint} initial {{ dot(x) = 1; x = 0; }}",
                steep * width
            );
            for method in [Method::Dop853, Method::Dopri5, Method::Radau5] {
                let settings = Settings { rows: sim::Rows::Even(1), ..Settings::adaptive(method, 10.0, 1e-10) };
                let run = run_with(interpreted(&text).unwrap(), &settings).unwrap();
                assert_eq!(run.trajectory.failure, None, "{text} {method:?}");
                let x = run.trajectory.samples.last().unwrap().state.positions[0];
                assert!((x - (10.0 - lost)).abs() < 1e-7, "{text} {method:?}: {x}, not {}", 10.0 - lost);
            }
        }
    }
}

/// The slopes of a `monotone` table are continuous, its second derivatives are not: a cam goes on over its rows. By the integral of
/// energy, J w^2 + m (lift' w)^2 + 2 m g lift = const + 2 T a.
#[test]
fn a_cam_of_a_monotone_table_turns() {
    let text = "pub Cam; coordinates { a [deg]; y [mm]; } parameters { r [mm] = 20; }
        tables { lift [mm] over [deg] = monotone, periodic {
            0,0; 90,0; 100,4; 130,10; 140,10; 180,10; 240,0; 300,0; 360,0; } }
        bodies { w: inertia 0.01 [kg*m^2], angle a; f: mass 0.5 [kg] at [0, y]; }
        joints { c: cam [0, y] through [0, 0] along pi/2 on w radius r by lift; }
        loads { gravity [0, -9.81 [m/s^2]]; torque 0.05 [N*m] on w; }
        initial { a = 0; dot(a) = 300 [rpm]; guess y = 20; }";
    for method in [Method::Dop853, Method::Dopri5] {
        let run = run_with(interpreted(text).unwrap(), &Settings::adaptive(method, 0.5, 1e-10)).unwrap();
        assert_eq!(run.trajectory.failure, None, "{method:?}");
        let last = &run.trajectory.samples.last().unwrap().state;
        let (a, w, y, rise) = (last.positions[0], last.speeds[0], last.positions[1], last.speeds[1]);
        let energy = 0.005 * w * w + 0.25 * rise * rise + 0.5 * 9.81 * (y - 0.02) - 0.05 * a;
        let begun = 0.005 * (10.0 * PI).powi(2);
        // A thousand tolerances.
        assert!((energy - begun).abs() < 1e-7 * begun, "{method:?}: {energy}, not {begun}");
        // By SciPy, with its own monotone table and the integral of energy: 933.0715 deg.
        assert!((a.to_degrees() - 933.0715).abs() < 1e-4, "{method:?}: {}", a.to_degrees());
    }
}

/// A kink is found where it is, however steep it is, and not far before.
#[test]
fn a_kink_ends_the_run_where_it_is() {
    for slope in ["1", "2", "3", "5"] {
        let text = format!(
            "pub Kinked; coordinates {{ x [m]; y [m]; }} bodies {{ a: mass 1 [kg] at [x, 0]; b: mass 1 [kg] at [0, y]; }}
             constraints {{ k: y = if x < 0.5 [m] then 0 else {slope}*(x - 0.5 [m]); }} initial {{ dot(x) = 1; guess y = 0; }}"
        );
        let run = run_with(interpreted(&text).unwrap(), &Settings::new(1.5)).unwrap();
        let failure = run.trajectory.failure.unwrap();
        assert!(failure.what.code() == "E-KINK" && (failure.time - 0.5).abs() < 1e-6, "{slope}: {failure}");
    }
}
