//! Balls that bounce, against their closed forms.

use super::{G, all_settings, times};
use sim::{Erased, Method, Settings, What, declared_start, erase, mechanism, run};
use tests::any_model::run_with;

mechanism! {
    /// A ball that bounces on a floor.
    Ball;
    coordinates { y [m]; }
    parameters { m [kg] = 2; r [m] = 0.1; g [m/s^2] = 9.81; rebound = 0.8; }
    bodies { ball: mass m at [0, y]; }
    loads { gravity [0, -g]; }
    constraints { floor: y = r initially released; }
    initial { y = 1.1; }
    events {
        landing: y = r falling { impact floor restitution rebound; }
        top: dot(y) = 0 falling;
    }
}

/// The model that is shipped: six bounces, each lower.
#[test]
fn the_bouncing_ball_is_the_closed_form() {
    let run = run_with(models::BouncingBall::default(), &Settings::new(3.0)).unwrap();
    let fall = (2.0 / G).sqrt();
    let landings = times(&run, "landing");
    assert!(landings.len() >= 3);
    for (n, found) in landings.iter().enumerate() {
        let exact = fall * (1.0 + 2.0 * (1..=n).map(|k| 0.9f64.powi(k as i32)).sum::<f64>());
        assert!((found - exact).abs() < 1e-10, "{n}: {found} {exact}");
    }
    for (n, top) in run.events.iter().filter(|event| event.name == "top").enumerate() {
        let height = top.state.positions[1] - 0.033;
        assert!((height - 0.81f64.powi(n as i32 + 1)).abs() < 1e-10, "{n}: {height}");
    }
    let last = run.trajectory.samples.last().unwrap().state.clone();
    assert!((last.positions[0] - 0.4 * 3.0).abs() < 1e-10);
}

/// Free fall is a polynomial that every method of order 2 and more has exactly, so times have the tolerance of events, which
/// each impact passes on to the next.
#[test]
fn a_ball_bounces_at_the_times_and_to_the_heights_of_the_closed_form() {
    let fall = (2.0 / G).sqrt();
    for settings in all_settings(3.0) {
        let run = run_with(Ball::default(), &settings).unwrap();
        assert_eq!(run.trajectory.failure, None);
        let (landings, tops) = (times(&run, "landing"), times(&run, "top"));
        let exact = |n: usize| fall * (1.0 + 2.0 * (1..n).map(|k| 0.8f64.powi(k as i32)).sum::<f64>());
        assert_eq!(landings.len(), (1..).take_while(|n| exact(*n) < 3.0).count());
        for (n, found) in landings.iter().enumerate() {
            assert!((found - exact(n + 1)).abs() < 1e-10, "{} {n}: {found}", settings.method.name());
        }
        for (n, top) in tops.iter().enumerate() {
            let event = run.events.iter().filter(|event| event.name == "top").nth(n).unwrap();
            let height = 0.8f64.powi(2 * (n as i32 + 1));
            assert!((event.state.positions[0] - 0.1 - height).abs() < 1e-10, "{n} at {top}");
        }
        let lost = 2.0 * G * (1.0 - 0.64f64.powi(landings.len() as i32));
        assert!((run.energy_taken - lost).abs() < 1e-9 * lost);
        assert!(run.energy_balance < 1e-9, "{:e}", run.energy_balance);
    }
}

/// lambda, and so its impulse, is what the ball exerts on the floor along increasing y.
#[test]
fn an_impact_has_its_impulse_and_its_loss() {
    let run = run_with(Ball::default(), &Settings::new(0.6)).unwrap();
    let change = run.events[0].change.clone().unwrap();
    let speed = (2.0 * G).sqrt();
    assert!((change.impulses[0] + 2.0 * 1.8 * speed).abs() < 1e-10);
    assert!((change.energy_taken - 0.5 * 2.0 * speed * speed * (1.0 - 0.64)).abs() < 1e-10);
    assert!((change.state.speeds[0] - 0.8 * speed).abs() < 1e-11);
    // Two rows at its time, before and after.
    let rows: Vec<f64> = run
        .trajectory
        .samples
        .iter()
        .filter(|sample| sample.state.time == run.events[0].state.time)
        .map(|sample| sample.state.speeds[0])
        .collect();
    assert_eq!(rows.len(), 2);
    assert!((rows[0] + speed).abs() < 1e-11 && (rows[1] - 0.8 * speed).abs() < 1e-11);
}

/// The times of impacts accumulate at fall (1 + e)/(1 - e).
#[test]
fn a_ball_that_comes_to_rest_chatters_and_says_so() {
    for settings in [Settings::new(6.0), Settings::equal_steps(Method::Rk4, 6.0, 600)] {
        let run = run_with(Ball::default(), &settings).unwrap();
        let failure = run.trajectory.failure.as_ref().unwrap();
        let rest = (2.0 / G).sqrt() * 1.8 / 0.2;
        assert!(matches!(failure.what, What::Accumulating { event: "landing", .. }), "{failure}");
        // Bounces end below the tolerance of constraints, 4e-12 m: one takes 2e-6 s there, and all to come five times that.
        assert!((failure.time - rest).abs() < 1e-5, "{} instead of {rest}", failure.time);
        assert!(failure.to_string().contains("`landing` chatters"));
        assert!(run.trajectory.samples.len() > 300);
    }
    // Without rebound nothing holds the ball.
    let run = run_with(Ball { rebound: 0.0, ..Ball::default() }, &Settings::new(6.0)).unwrap();
    let failure = run.trajectory.failure.unwrap();
    assert!(matches!(failure.what, What::Accumulating { event: "landing", count: 2 }), "{failure}");
    let run = run_with(Ball { rebound: -0.5, ..Ball::default() }, &Settings::new(6.0)).unwrap();
    assert!(matches!(run.trajectory.failure.unwrap().what, What::Restitution { constraint: "floor", .. }));
}

/// Each flight is half as long as the one before: 6, 3, 1.5 and 0.75 ms. An instant is 1e-9 of the time asked for, here 1 ms, so
/// that the fourth landing is the last, and the fifth is said to come at once. A flight lasts for 2 v/g.
#[test]
fn a_ball_chatters_once_a_flight_is_shorter_than_an_instant() {
    let impact = 0.006 * G;
    let ball = Erased::of(erase(Ball { rebound: 0.5, ..Ball::default() }));
    let mut start = declared_start(&ball);
    start.positions[0] = 0.1 + impact * impact / (2.0 * G);
    let run = run(ball, &start, &Settings::new(1e6)).unwrap();
    let landings = times(&run, "landing");
    assert_eq!(landings.len(), 4, "{landings:?}");
    for (n, flight) in landings.windows(2).map(|pair| pair[1] - pair[0]).enumerate() {
        assert!((flight - 0.006 * 0.5f64.powi(n as i32)).abs() < 1e-9, "{n}: {flight}");
    }
    let failure = run.trajectory.failure.unwrap();
    assert!(matches!(failure.what, What::Accumulating { event: "landing", count: 5 }), "{failure}");
}

/// A ball that starts on the floor upwards has not landed; one that starts downwards has.
#[test]
fn what_holds_at_the_start_happens_if_it_goes_on() {
    let start = |speed: f64| {
        let ball = Erased::of(erase(Ball::default()));
        let mut start = declared_start(&ball);
        (start.positions[0], start.speeds[0]) = (0.1, speed);
        start.speed_given = vec![true];
        run(ball, &start, &Settings::new(1.0)).unwrap()
    };
    for (speed, first) in [(2.0, 4.0 / G), (-2.0, 0.0)] {
        let run = start(speed);
        let rebound = if speed > 0.0 { 0.8 * 2.0 } else { 0.8 * 0.8 * 2.0 };
        let landings = times(&run, "landing");
        assert!((landings[0] - first).abs() < 1e-11, "{landings:?}");
        let after = if speed > 0.0 { landings[0] } else { 2.0 * 0.8 * 2.0 / G };
        assert!(landings.iter().any(|time| (time - after).abs() < 1e-11), "{landings:?}");
        let flight = landings[landings.iter().position(|time| (time - after).abs() < 1e-11).unwrap() + 1] - after;
        assert!((flight - 2.0 * rebound / G).abs() < 1e-11, "{flight}");
    }
}

#[test]
fn runs_with_events_are_the_same_bit_for_bit() {
    let bits = || {
        let run = run_with(Ball::default(), &Settings::new(3.9)).unwrap();
        let samples = run.trajectory.samples.iter();
        samples.map(|sample| [sample.state.positions[0], sample.state.speeds[0]].map(f64::to_bits)).collect::<Vec<_>>()
    };
    assert_eq!(bits(), bits());
}
