//! The cam by a table against the law that its rows were taken from.

use models::CamFollower;
use sim::{Compiled, Method, Run, Settings, Table};
use std::f64::consts::{PI, TAU};
use tests::any_model::interpreted;
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

fn one_turn(cam: CamFollower) -> Run<CamFollower> {
    let run = run_with(cam, &Settings::equal_steps(Method::Dop853, TAU / cam.w, 3600)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    run
}

/// The largest difference of a column from the law, relative to the largest of the law.
fn error(run: &Run<CamFollower>, column: &str, law: impl Fn(f64) -> f64) -> f64 {
    let table = Table::of(&run.mechanism, &run.trajectory);
    let (mut error, mut largest) = (0.0f64, 0.0f64);
    for (value, time) in table.column(column).unwrap().values.iter().zip(table.times()) {
        let law = law(run.mechanism.w * time);
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
