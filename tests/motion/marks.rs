//! Conditions that are met many times within a step, or at once.

use sim::{Method, Settings, What, mechanism};
use tests::any_model::run_with;

const METHODS: [Method; 3] = [Method::Dopri5, Method::Dop853, Method::Radau5];

mechanism! {
    /// A carriage that is pushed a little at each mark.
    Carriage;
    coordinates { x [m]; }
    parameters { m [kg] = 1; p [m] = 0.5; kick [m/s] = 0.01; n = 0; start [m] = 0.1; v [m/s] = 1; }
    bodies { b: mass m at [x, 0]; }
    initial { x = start; dot(x) = v; }
    events { mark: sin(pi*x/p) = 0 { set dot(x) = dot(x) + kick; set n = n + 1; } }
}

/// From mark to mark at constant speed.
#[test]
fn no_mark_with_an_action_is_passed_over() {
    let cases: [(f64, f64, f64, f64); 4] =
        [(0.5, 1.0, 0.01, 0.1), (2.833, 0.46, 0.0461, 0.1), (0.1, 3.0, 0.0, 0.05), (1.0, 1.0, 0.0, 1000.25)];
    for (p, v, kick, start) in cases {
        let (end, mut x, mut speed, mut time, mut count) = (20.0, start, v, 0.0, 0.0);
        loop {
            let next = p * ((x / p + 1e-9).floor() + 1.0);
            let arrives = time + (next - x) / speed;
            if arrives > end {
                x += speed * (end - time);
                break;
            }
            (x, time, speed, count) = (next, arrives, speed + kick, count + 1.0);
        }
        for method in METHODS {
            let carriage = Carriage { p, v, kick, start, ..Carriage::default() };
            let run = run_with(carriage, &Settings::adaptive(method, end, 1e-10)).unwrap();
            assert_eq!(run.trajectory.failure, None);
            let found = &run.trajectory.samples.last().unwrap().state;
            assert_eq!(run.events.len() as f64, count, "{}, {p}", method.name());
            assert!((found.positions[0] - x).abs() < 1e-9 * x, "{}: {} for {x}", method.name(), found.positions[0]);
        }
    }
}

mechanism! {
    /// A wheel whose teeth are counted.
    Encoder;
    coordinates { phi [rad]; }
    parameters { J [kg*m^2] = 0.01; N = 15; count = 0; w [rpm] = 100; }
    bodies { wheel: inertia J, angle phi; }
    initial { phi = 0; dot(phi) = w; }
    events { tooth: sin(N*phi) = 0 rising { set count = count + 1; } plain: sin(N*phi) = 0 rising; }
}

#[test]
fn every_tooth_is_counted() {
    for n in [7.0, 12.0, 60.0, 211.0] {
        for method in METHODS {
            for end in [1.00123, 5.00123] {
                let encoder = Encoder { N: n, ..Encoder::default() };
                let run = run_with(encoder, &Settings::adaptive(method, end, 1e-10)).unwrap();
                assert_eq!(run.trajectory.failure, None);
                let exact = (n * 100.0 / 60.0 * end).floor();
                // With an action it also happens at the start.
                for (name, first) in [("tooth", 1.0), ("plain", 0.0)] {
                    let count = run.events.iter().filter(|event| event.name == name).count();
                    assert_eq!(count as f64, first + exact, "{name} of {n}, {}", method.name());
                }
            }
        }
    }
}

mechanism! {
    /// A ball on a floor through the origin: when it arrives nothing has a length.
    Bouncing;
    coordinates { y [m]; }
    parameters { m [kg] = 1; bounce = 0.5; g [m/s^2] = 9.81; }
    bodies { ball: mass m at [0, y]; }
    loads { gravity [0, -g]; }
    constraints { floor: y = 0 initially released; }
    initial { y = 1; }
    events { hit: y = 0 falling { impact floor restitution bounce; } }
}

/// Each flight takes e times as long as the one before.
#[test]
fn a_ball_bounces_on_a_floor_through_the_origin() {
    for method in METHODS {
        let run = run_with(Bouncing::default(), &Settings::adaptive(method, 1.3, 1e-10)).unwrap();
        assert_eq!(run.trajectory.failure, None);
        let fall = (2.0f64 / 9.81).sqrt();
        let (mut time, mut flight) = (fall, 2.0 * fall * 0.5);
        assert!(run.events.len() > 4, "{}", run.events.len());
        for event in &run.events {
            assert!((event.state.time - time).abs() < 1e-10, "{}: {} for {time}", method.name(), event.state.time);
            (time, flight) = (time + flight, 0.5 * flight);
        }
        assert!(run.evaluations < 20_000, "{}", run.evaluations);
    }
}

mechanism! {
    /// A rod that falls flat on two stops. Once one has thrown it back, the other end rises.
    Sled;
    coordinates { y [m]; f [rad]; }
    parameters { m [kg] = 2; J [kg*m^2] = 2; a [m] = 0.3; g [m/s^2] = 9.81; bounce = 0.9; tilt [rad] = 0; }
    let G = [0, y];
    let A = G - a*[cos(f), sin(f)];
    let B = G + a*[cos(f), sin(f)];
    bodies { rod: mass m at G, inertia J, angle f; }
    loads { gravity [0, -g]; }
    constraints { at_a: A.y = 0 initially released; at_b: B.y = 0 initially released; }
    initial { y = 1; f = tilt; }
    events {
        hits_a: A.y = 0 falling { impact at_a restitution bounce; }
        hits_b: B.y = 0 falling { activate at_b; }
        lifts_b: reaction(at_b) = 0 rising { release at_b; }
    }
}

/// The blow at A alone, by the mass that acts there: it takes (1 - e^2)/2 v^2/(1/m + a^2/J).
#[test]
fn what_an_event_turns_back_does_not_happen() {
    for tilt in [0.0, 1e-9] {
        let run = run_with(Sled { tilt, ..Sled::default() }, &Settings::adaptive(Method::Dop853, 0.6, 1e-10)).unwrap();
        assert_eq!(run.trajectory.failure, None);
        let names: Vec<&str> = run.events.iter().map(|event| event.name).collect();
        assert_eq!(names, ["hits_a"], "{tilt}");
        let taken = 0.19 / 2.0 * 2.0 * 9.81 / (0.5 + 0.09 / 2.0);
        assert!((run.energy_taken - taken).abs() < 1e-7, "{} for {taken}", run.energy_taken);
    }
}

mechanism! {
    /// Five balls in a row.
    Cradle;
    parameters { m [kg] = 1; d [m] = 0.1; v_1 [m/s] = 1; v_2 [m/s] = 1; v_4 [m/s] = 0; v_5 [m/s] = 0; }
    coordinates { repeat i in 1..=5 { x_[i] [m]; } }
    bodies { repeat i in 1..=5 { b_[i]: mass m at [x_[i], 0]; } }
    constraints { repeat i in 1..=4 { c_[i]: x_[i + 1] - x_[i] = d initially released; } }
    initial {
        x_1 = -1.1; x_2 = -1; x_3 = 0.1; x_4 = 0.2; x_5 = 0.3;
        dot(x_1) = v_1; dot(x_2) = v_2; dot(x_4) = v_4; dot(x_5) = v_5;
    }
    events { repeat i in 1..=4 { hit_[i]: x_[i + 1] - x_[i] = d falling { impact c_[i] restitution 1; } } }
}

/// Equal balls exchange their speeds.
#[test]
fn blows_go_to_and_fro_in_a_row_of_balls() {
    let run = run_with(Cradle::default(), &Settings::adaptive(Method::Dop853, 3.0, 1e-10)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let last = &run.trajectory.samples.last().unwrap().state;
    assert_eq!(last.speeds.as_ref(), [0.0, 0.0, 0.0, 1.0, 1.0]);
}

mechanism! {
    /// Three balls, the outer ones thrown at the middle one at once.
    Both;
    parameters { m [kg] = 1; d [m] = 0.1; }
    coordinates { x1 [m]; x2 [m]; x3 [m]; }
    bodies { a: mass m at [x1, 0]; b: mass m at [x2, 0]; c: mass m at [x3, 0]; }
    constraints { ab: x2 - x1 = d initially released; bc: x3 - x2 = d initially released; }
    initial { x1 = -1; dot(x1) = 1; x2 = 0; x3 = 1; dot(x3) = -1; }
    events {
        hits_ab: x2 - x1 = d falling { impact ab restitution 1; }
        hits_bc: x3 - x2 = d falling { impact bc restitution 1; }
    }
}

#[test]
fn blows_from_both_sides_are_no_chatter() {
    let run = run_with(Both::default(), &Settings::adaptive(Method::Dop853, 3.0, 1e-10)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let last = &run.trajectory.samples.last().unwrap().state;
    for (found, exact) in last.speeds.as_ref().iter().zip([-1.0, 0.0, 1.0]) {
        assert!((found - exact).abs() < 1e-12, "{:?}", last.speeds);
    }
}

mechanism! {
    /// Two oscillators of 0.01 m and 0.007 m, one of them far from the origin.
    Far;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; k [N/m] = 100; h [N/m] = 200; far [m] = 0; }
    bodies { a: mass m at [far + x, 0]; b: mass m at [far, y]; }
    loads { force -k*x on x; force -h*y on y; }
    initial { x = 0.01; y = 0.007; }
}

mechanism! {
    /// A light part beside a heavy rotor.
    Beside;
    coordinates { a [rad]; x [mm]; }
    parameters { J [kg*m^2] = 1; m [kg] = 1e-3; w [rad/s] = 50; }
    bodies { rotor: inertia J, angle a; part: mass m at [x, 0]; }
    loads { force -m*w^2*x on x; }
    initial { a = 0; dot(a) = 0.1; x = 1; }
}

/// Neither a length that is declared nor a rotor says how accurate other motions have to be.
#[test]
fn great_lengths_elsewhere_do_not_spoil_small_motions() {
    for far in [0.0, 1.0, 6.371e6, 1e9] {
        let run = run_with(Far { far, ..Far::default() }, &Settings::adaptive(Method::Dop853, 2.0, 1e-10)).unwrap();
        for sample in &run.trajectory.samples {
            let t = sample.state.time;
            let exact = [0.01 * (10.0 * t).cos(), 0.007 * (200f64.sqrt() * t).cos()];
            for (found, exact) in sample.state.positions.as_ref().iter().zip(exact) {
                assert!((found - exact).abs() < 1e-9, "{far} m: {found} for {exact}");
            }
        }
    }
    // A start that is rounding is no length.
    for (start, length) in [(0.0, 1.0), (1e-17, 1.0), (0.01, 0.01), (3.0, 1.0)] {
        let far = Far { far: 1.0, ..Far::default() };
        assert_eq!(sim::Measures::at(&far, 0.0, &[start, 0.0]).coordinates()[0], length);
    }
    for inertia in [1e-3, 1.0, 1e3, 1e6] {
        let run = run_with(Beside { J: inertia, ..Beside::default() }, &Settings::adaptive(Method::Dop853, 5.0, 1e-10))
            .unwrap();
        let last = &run.trajectory.samples.last().unwrap().state;
        assert!((last.positions[1] - 1e-3 * (250f64).cos()).abs() < 1e-9, "{inertia}: {}", last.positions[1]);
    }
}

mechanism! {
    /// A beam on three supports in a row that runs against a wall, which is not upright.
    Beam;
    parameters { m [kg] = 12; L [m] = 2; mu = 0.5; g [m/s^2] = 9.81; }
    bodies { b: free, mass m, inertia m*L^2/12; }
    loads { gravity [0, -g]; }
    constraints {
        left: on(b, [-L/2, 0]).y = 0;
        middle: on(b, [0, 0]).y = 0;
        right: on(b, [L/2, 0]).y = 0;
        wall: b_x + mu*on(b, [L/4, 0]).y = 1 [m] initially released;
    }
    initial { b_x = 0; dot(b_x) = 2; }
    events { hit: b_x = 1 [m] rising { impact wall restitution 0; } }
}

/// The wall takes 24 N*s and lifts the beam with half of that a quarter of its length from the middle: sum -12 N*s, moment -6 N*m*s
/// about the middle, spread over the supports so that the sum of squares is least, as a - d, a, a + d.
#[test]
fn impulses_of_redundant_supports_are_those_of_least_norm() {
    let run = run_with(Beam::default(), &Settings::adaptive(Method::Dop853, 1.0, 1e-10)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let impulses = &run.events[0].change.as_ref().unwrap().impulses;
    let exact = [-1.0, -4.0, -7.0].map(|support: f64| support * impulses[3].signum());
    for (found, exact) in impulses.as_ref().iter().zip(exact) {
        assert!((found.abs() - exact.abs()).abs() < 1e-9, "{impulses:?}");
    }
}

mechanism! {
    /// A mass pulled against dry friction, whose direction turns with the motion, as one may write it.
    Chattering;
    coordinates { x [m]; }
    parameters { m [kg] = 1; F [N] = 1; R [N] = 3; d = 1; }
    bodies { b: mass m at [x, 0]; }
    loads { force F + d*R on x; }
    initial { x = 0; dot(x) = -2; }
    events { up: dot(x) = 0 rising { set d = -1; } down: dot(x) = 0 falling { set d = 1; } }
}

/// At rest each direction of the friction starts a motion against which the other stands: no motion follows, and none is told.
#[test]
fn events_that_turn_each_other_back_for_ever_are_refused() {
    let failure = run_with(Chattering::default(), &Settings::new(3.0)).unwrap().trajectory.failure.unwrap();
    assert!(matches!(failure.what, What::Accumulating { .. }), "{failure}");
    // -2 + (1 + 3) t = 0.
    assert!((failure.time - 0.5).abs() < 1e-9, "{failure}");
}
