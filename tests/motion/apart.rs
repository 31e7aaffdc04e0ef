//! Runs that are off are told, by comparison with a run of a smaller tolerance.

use sim::{Method, Run, Settings, State, Stepping, Tolerance, declared_start, run, run_compared};
use tests::any_model::{AnyModel, interpreted};

/// A mass on a spring that pushes it away, with x'' = x - 2 cos t: cos t from x = 1 at rest, and errors grow as e^t.
const AWAY: &str = "pub Away; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; }
    loads { force 1 [N/m]*x on x; force -2 [N]*cos(1 [rad/s]*t) on x; } initial { x = 1; }";

fn settings(method: Method, end: f64, tolerance: f64) -> Settings {
    Settings { method, stepping: Stepping::Adaptive(Tolerance::new(tolerance)), ..Settings::new(end) }
}

fn compared(mechanism: &AnyModel, settings: &Settings) -> Run<AnyModel> {
    let run = run_compared(mechanism.clone(), &declared_start(mechanism), settings, &mut |_| true).unwrap();
    assert_eq!(run.trajectory.failure, None);
    run
}

/// Errors are known here: those told are those that are there, and they are told from where a thousandth of the way is passed.
#[test]
fn what_has_grown_is_told_as_it_is() {
    let away = interpreted(AWAY).unwrap();
    for (method, tolerance) in
        [(Method::Dop853, 1e-11), (Method::Dopri5, 1e-9), (Method::Radau5, 1e-9), (Method::Dop853, 1e-6)]
    {
        let run = compared(&away, &settings(method, 40.0, tolerance));
        let apart = run.apart.unwrap_or_else(|| panic!("{method:?} {tolerance:e}: nothing is told"));
        let off = |time: f64| {
            let sample = run.trajectory.samples.iter().find(|sample| sample.state.time >= time).unwrap();
            (sample.state.positions[0] - sample.state.time.cos()).abs()
        };
        // The other run has a hundredth of the error, and a row takes 0.04 s.
        assert!((off(apart.time) / apart.by - 1.0).abs() < 0.05, "{method:?} {tolerance:e}: {apart:?}");
        let first = off(apart.since) / (1e-3 * apart.extent);
        assert!((0.95..1.1).contains(&first), "{method:?} {tolerance:e}: {first} {apart:?}");
    }
}

/// Comparing changes nothing of the run, and a motion that is right is not doubted.
#[test]
fn right_motions_are_not_doubted() {
    let swing = interpreted(&AWAY.replace("1 [N/m]*x", "-1 [N/m]*x")).unwrap();
    for (method, tolerance) in
        [(Method::Dop853, 1e-11), (Method::Dop853, 1e-6), (Method::Dopri5, 1e-9), (Method::Radau5, 1e-8)]
    {
        let settings = settings(method, 100.0, tolerance);
        let found = compared(&swing, &settings);
        assert_eq!(found.apart, None, "{method:?} {tolerance:e}");
        assert!(found.compared.is_some_and(|other| other < tolerance), "{method:?} {tolerance:e}");
        let alone = run(swing.clone(), &declared_start(&swing), &settings).unwrap();
        assert_eq!(alone.compared, None);
        assert_eq!(
            (alone.trajectory.samples.last().unwrap().state.positions[0].to_bits(), alone.evaluations),
            (found.trajectory.samples.last().unwrap().state.positions[0].to_bits(), found.evaluations)
        );
    }
}

/// A double pendulum is off by as much as it moves after 20 s, with any tolerance: it is told with each.
#[test]
fn chaos_is_told_with_every_tolerance() {
    let chaos = interpreted(
        "pub Chaos; coordinates { a [rad]; b [rad]; } let P = 1 [m]*[sin(a), -cos(a)]; let Q = P + 1 [m]*[sin(b), -cos(b)];
         bodies { p: mass 1 [kg] at P; q: mass 1 [kg] at Q; } loads { gravity [0, -9.81 [m/s^2]]; } initial { a = 2; b = 2; }",
    )
    .unwrap();
    let all = [1e-6, 1e-10, 1e-12, 1e-13, 1e-14].map(|tolerance| (Method::Dop853, tolerance));
    for (method, tolerance) in all.into_iter().chain([(Method::Dopri5, 1e-10), (Method::Radau5, 1e-8)]) {
        assert!(compared(&chaos, &settings(method, 40.0, tolerance)).apart.is_some(), "{method:?} {tolerance:e}");
    }
}

/// Equal steps, whose rows are their ends where no others are asked for: 1 - e^-5t by Heun's method with h = 0.05.
#[test]
fn equal_steps_are_compared_at_their_ends() {
    let drag = interpreted(
        "pub Drag; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; } loads { force -5 [N*s/m]*dot(x) on x; }
         initial { x = 0; dot(x) = 5; }",
    )
    .unwrap();
    let run = compared(&drag, &Settings::equal_steps(Method::Heun, 10.0, 200));
    let apart = run.apart.unwrap();
    let off = |state: &State<AnyModel>| (state.positions[0] - 1.0 + (-5.0 * state.time).exp()).abs();
    let states = || run.trajectory.samples.iter().map(|sample| &sample.state);
    let worst = states().map(off).fold(0.0, f64::max);
    assert!((apart.by / worst - 1.0).abs() < 1e-6, "{apart:?} {worst}");
    assert!((off(states().find(|state| state.time == apart.time).unwrap()) / worst - 1.0).abs() < 1e-6, "{apart:?}");
}
