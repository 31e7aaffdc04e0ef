//! Conditions that are small beside what they have been, that touch zero, or that begin where they are infinite.

use sim::{Crossing, Method, Run, Settings};
use tests::any_model::{AnyModel, interpreted};
use tests::run_with;

/// A mass that moves as a force and its start say, with events that do something and an output that counts them.
fn mass(force: &str, initial: &str, events: &str) -> String {
    format!(
        "pub Mass; coordinates {{ x [m]; }}
         parameters {{ m [kg] = 1; n = 0; H [m] = 1000; d [m] = 0.9e-6; g [m/s^2] = 10; r [m] = 0.001; }}
         bodies {{ b: mass m at [x, 0]; }} loads {{ force {force} on x; }}
         constraints {{ wall: x = 1 [m] initially released; ceiling: x = H - d initially released; }}
         initial {{ {initial} }} events {{ {events} }}"
    )
}

fn run_of(declaration: &str, method: Method, equal: Option<usize>, end: f64) -> Run<AnyModel> {
    let settings = match equal {
        Some(steps) => Settings::equal_steps(method, end, steps),
        None => Settings::adaptive(method, end, 1e-10),
    };
    let run = run_with(interpreted(declaration).unwrap(), &settings).unwrap();
    assert_eq!(run.trajectory.failure, None, "{declaration}");
    run
}

fn times(run: &Run<AnyModel>) -> Vec<f64> {
    run.events.iter().map(|event| event.state.time).collect()
}

fn check(declaration: &str, (method, equal, end): (Method, Option<usize>, f64), expected: &[f64], tolerance: f64) {
    let found = times(&run_of(declaration, method, equal, end));
    let is_right = found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= tolerance);
    assert!(is_right, "{declaration}\n{method:?} {equal:?}: {found:?}, not {expected:?}");
}

/// Whether it is gone through for 1e-5 of the time, or by 1e-9 of the way: the ball turns 0.9 um below the top of its flight.
#[test]
fn what_goes_through_zero_by_little_has_crossed_it() {
    let square = mass("0 [N]", "x = -100; dot(x) = 100;", "hit: x^2 = r^2 falling { set n = n + 1; }");
    for (method, equal) in [(Method::Dop853, None), (Method::Radau5, None), (Method::Rk4, Some(1001))] {
        check(&square, (method, equal, 2.0), &[0.999_99], 1e-10);
    }
    let top = mass("-m*g", "x = 0; dot(x) = sqrt(2*g*H);", "hit: x = H - d rising { impact ceiling restitution 1; }");
    let slow = (2.0f64 * 10.0 * 0.9e-6).sqrt();
    check(&top, (Method::Dop853, None, 20.0), &[((2.0f64 * 10.0 * 1000.0).sqrt() - slow) / 10.0], 1e-6);
}

/// What counts as zero is small beside the terms where the motion is, not where it was, nor beside 1 m or 1 J.
#[test]
fn small_conditions_are_no_rounding() {
    let swing = |size: f64| {
        format!(
            "pub Swing; coordinates {{ x [um]; }} parameters {{ w [rad/s] = 6.283185307179586; n = 0; A [um] = {size:e}; }}
             bodies {{ b: mass 1 [mg] at [x, 0]; }} loads {{ force -1 [mg]*w^2*(x - 1 [um]) on x; }}
             initial {{ x = 1 [um] + A; }} events {{ mid: x = 1 [um] falling {{ set n = n + 1; }} }}"
        )
    };
    for size in [1e-2, 1e-3, 1e-4, 1e-5] {
        // 1 um is known to 2e-16 of itself, and the motion to some of them.
        let tolerance = 1e-8 + 1e-13 / size;
        for (method, equal) in [(Method::Dop853, None), (Method::Radau5, None), (Method::Rk4, Some(8192))] {
            check(&swing(size), (method, equal, 2.0), &[0.25, 1.25], tolerance);
        }
    }
    let slowing = mass("-1 [N*s/m]*dot(x)", "x = 0; dot(x) = 1;", "quiet: m*dot(x)^2/2 = 1e-12 [J] falling { stop; }");
    for method in [Method::Dop853, Method::Dopri5, Method::Radau5] {
        // exp(-t) is followed to 1e-10 of 1, and is 1.4e-6 there.
        check(&slowing, (method, None, 20.0), &[(0.5e12f64).ln() / 2.0], 1e-4);
    }
    let cube = mass("0 [N]", "x = -1; dot(x) = 1;", "c: (x/1 [m])^3 = 0 rising { stop; }");
    let steep = mass("0 [N]", "x = 0.1; dot(x) = 1;", "c: (1 [m]/x)^12 = (1 [m]/x)^6 { stop; }");
    for (method, equal) in [(Method::Dop853, None), (Method::Rk4, Some(8192)), (Method::Rk4, Some(20_000))] {
        check(&cube, (method, equal, 2.123), &[1.0], 1e-6);
        check(&steep, (method, equal, 2.123), &[0.9], 1e-9);
    }
}

#[test]
fn a_condition_may_be_infinite_at_the_start() {
    for condition in ["1 [m]/x = 2", "ln(x/1 [m]) = ln(0.5)", "tan(x/1 [m] + pi/2) = -1/tan(0.5)"] {
        let declaration = mass("0 [N]", "x = 0; dot(x) = 1;", &format!("c: {condition} {{ stop; }}"));
        check(&declaration, (Method::Dop853, None, 2.0), &[0.5], 1e-9);
        check(&declaration, (Method::Rk4, Some(100), 2.0), &[0.5], 1e-9);
    }
}

/// An event that only counts, or ends the run, happens though another has just turned the motion back; one that would turn it
/// again does not.
#[test]
fn simultaneous_events_happen_unless_they_turn_the_motion_again() {
    let first = "hit: x = 1 [m] rising { impact wall restitution 0.5; }";
    let names = |others: &str| {
        let declaration = mass("0 [N]", "x = 0; dot(x) = 1;", &format!("{first} {others}"));
        let run = run_of(&declaration, Method::Dop853, None, 1.7);
        (
            run.events.iter().map(|event| event.name).collect::<Vec<_>>(),
            run.trajectory.samples.last().unwrap().state.time,
        )
    };
    let counts = "count: x = 1 [m] rising { set n = n + 1; }";
    assert_eq!(names(&format!("{counts} end: x = 1 [m] rising {{ stop; }}")).0, ["hit", "count", "end"]);
    assert_eq!(names("turn: x = 1 [m] rising { set dot(x) = -dot(x); }"), (vec!["hit"], 1.7));
}

/// A touch is one event, however close to the end of a step it is, and leaves the condition on its side.
#[test]
fn a_touch_happens_once() {
    for condition in ["(x/1 [m] - 3)^2", "abs(x - 3 [m])", "(x/1 [m] - 3)^4", "abs(t - 3 [s])", "(t/1 [s] - 3)^2"] {
        for action in [";", "{ set n = n + 1; }"] {
            let declaration = mass("0 [N]", "x = 0; dot(x) = 1;", &format!("c: {condition} = 0 {action}"));
            for (method, equal) in [(Method::Dop853, None), (Method::Rk4, Some(10)), (Method::Rk4, Some(1001))] {
                check(&declaration, (method, equal, 10.0), &[3.0], 1e-4);
                let run = run_of(&declaration, method, equal, 10.0);
                assert_eq!(run.events[0].crossing, Crossing::Touching, "{condition} {action} {method:?} {equal:?}");
            }
        }
    }
}

/// Many touches within one step are as many events.
#[test]
fn a_step_may_hold_many_touches() {
    for condition in ["sin(100*x/1 [m])^2", "abs(sin(100*x/1 [m]))", "1 - cos(100*x/1 [m])"] {
        let count = if condition.contains("cos") { 159 } else { 318 };
        for action in [";", "{ set n = n + 1; }"] {
            let declaration = mass("0 [N]", "x = 0; dot(x) = 1;", &format!("c: {condition} = 0 {action}"));
            for (method, equal) in [(Method::Dop853, None), (Method::Rk4, Some(20))] {
                let found = run_of(&declaration, method, equal, 10.0);
                assert_eq!(found.events.len(), count, "{condition} {action} {method:?} {equal:?}");
            }
        }
    }
}

/// What stays at zero happens where it comes there, and not where it leaves.
#[test]
fn what_stays_at_zero_happens_once() {
    let spring = mass("-1 [N/m]*x", "x = 1;", "off: max(0 [m], x) = 0 { set n = n + 1; }");
    let free = mass("0 [N]", "x = 0; dot(x) = 1;", "a: min(x - 3 [m], 0*x) = 0 { set n = n + 1; }");
    for (method, equal) in [(Method::Dop853, None), (Method::Radau5, None), (Method::Rk4, Some(1000))] {
        let half = std::f64::consts::FRAC_PI_2;
        check(&spring, (method, equal, 10.0), &[half, 5.0 * half], 1e-6);
        check(&free, (method, equal, 10.0), &[3.0], 1e-9);
    }
}

/// A load that jumps past what a latch bears opens it, also where its event has no direction.
#[test]
fn a_latch_opens_where_its_load_jumps() {
    for direction in ["", "rising"] {
        let declaration = format!(
            "pub Latch; coordinates {{ x [m]; }} parameters {{ F [N] = 1; }} bodies {{ a: mass 1 [kg] at [x, 0]; }}
             loads {{ force F on x; }} constraints {{ latch: x = 0 initially active; }}
             events {{ open: reaction(latch) = 3 [N] {direction} {{ release latch; }} jump: t = 1 [s] rising {{ set F = 5; }} }}"
        );
        let run = run_of(&declaration, Method::Dop853, None, 2.0);
        let end = run.trajectory.samples.last().unwrap().state.positions[0];
        assert!((end - 2.5).abs() < 1e-9, "{direction}: {end}");
    }
}

/// A blow at a place that only says when it comes is given once, whatever it leaves of the speed.
#[test]
fn a_blow_may_leave_the_rate_of_its_condition() {
    for restitution in [0.0, 0.5, 1.0] {
        let declaration = format!(
            "pub Blow; coordinates {{ x1 [m]; x2 [m]; }} bodies {{ a: mass 3 [kg] at [x1, 0]; b: mass 1 [kg] at [x2, 0]; }}
             constraints {{ c: x1 = x2 initially released; }} initial {{ x2 = 1; dot(x1) = 1; dot(x2) = 0; }}
             events {{ hit: x1 = 1 [m] rising {{ impact c restitution {restitution:?}; }} }}"
        );
        let run = run_of(&declaration, Method::Dop853, None, 2.0);
        let speeds = &run.trajectory.samples.last().unwrap().state.speeds;
        // The impulse on both is 3/4 (1 + e) kg m/s.
        let impulse = 0.75 * (1.0 + restitution);
        assert!((speeds[0] - (1.0 - impulse / 3.0)).abs() < 1e-12 && (speeds[1] - impulse).abs() < 1e-12, "{speeds:?}");
        assert_eq!(run.events.len(), 1);
    }
}

/// Waves that decay are searched as finely as at first: each passage of x = k pi/1000, or of t, up to exp(-10).
#[test]
fn decaying_waves_are_searched_as_finely_as_at_first() {
    for (condition, count) in [("sin(1000*x/1 [m])*exp(-x/1 [m])", 3183), ("sin(1000*t/1 [s])*exp(-t/1 [s])", 3183)] {
        let declaration = mass("0 [N]", "x = 0; dot(x) = 1;", &format!("c: {condition} = 0;"));
        for (method, equal) in [(Method::Dop853, None), (Method::Dopri5, None), (Method::Rk4, Some(20))] {
            assert_eq!(
                run_of(&declaration, method, equal, 10.0).events.len(),
                count,
                "{condition} {method:?} {equal:?}"
            );
        }
    }
}
