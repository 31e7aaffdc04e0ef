//! Short loads whose conditions stand behind an input, in a potential, or in the geometry that loads act along.

use sim::{Input, Method, Rows, Settings, Simulation, declared_start};
use tests::any_model::interpreted;
use tests::run_with;

const METHODS: [Method; 3] = [Method::Dop853, Method::Dopri5, Method::Radau5];

/// A rotor that turns at 9 rad/s; loads are shorter than a hundredth of the run.
fn rotor(inputs: &str, load: &str) -> String {
    format!(
        "pub Rotor; coordinates {{ phi [rad]; }}
         parameters {{ J [kg*m^2] = 0.01; T [N*m] = 1; E [J] = 0.5; w [s] = 0.01; b [rad] = 0.02; t0 [s] = 3; }} {inputs}
         bodies {{ rotor: inertia J, angle phi; }} loads {{ {load}; }} initial {{ dot(phi) = 9; }}"
    )
}

/// Position and speed at the end.
fn end(declaration: &str, method: Method, rows: Rows, end: f64) -> [f64; 2] {
    let settings = Settings { rows, ..Settings::adaptive(method, end, 1e-10) };
    let run = run_with(interpreted(declaration).unwrap(), &settings).unwrap();
    assert_eq!(run.trajectory.failure, None, "{declaration}");
    let last = run.trajectory.samples.last().unwrap();
    [last.state.positions[0], last.state.speeds[0]]
}

/// The speed gained is the impulse over the inertia, whether the condition is of time, of a held input or of one with a course.
#[test]
fn inputs_do_not_hide_when_a_load_acts() {
    let (gate, gauss) =
        ("torque (if u < t0 then 0 else if u < t0 + w then T else 0) on rotor", 0.01 * std::f64::consts::PI.sqrt());
    let cases = [
        ("inputs { u [s] = t; }", gate, 0.01),
        ("inputs { u [s] = 3; }", "torque (if t < u then 0 else if t < u + w then T else 0) on rotor", 0.01),
        ("inputs { u [s] = 3; }", "torque T*exp(-((t - u)/w)^2) on rotor", gauss),
        ("inputs { u [s] = t; }", "torque T*exp(-((u - t0)/w)^2) on rotor", gauss),
        ("inputs { u = (t - t0)/w; }", "torque T*exp(-u^2) on rotor", gauss),
        ("inputs { u = 27; }", "torque T*exp(-((phi - u)/b)^2) on rotor", f64::NAN),
    ];
    for (inputs, load, impulse) in cases {
        for method in METHODS {
            for rows in [Rows::Even(1), Rows::Even(1000), Rows::Steps] {
                let [_, speed] = end(&rotor(inputs, load), method, rows, 10.0);
                // By position: the work T b sqrt(pi) over J/2, since the rotor turns at any speed through it.
                let exact = match impulse.is_nan() {
                    true => (81.0 + 2.0 / 0.01 * 0.02 * std::f64::consts::PI.sqrt()).sqrt(),
                    false => 9.0 + impulse / 0.01,
                };
                assert!((speed - exact).abs() < 1e-8, "{inputs} {load} {method:?}: {speed}, not {exact}");
            }
        }
    }
}

/// The owner of a motion moves the gate that is still ahead.
#[test]
fn an_input_that_is_set_moves_the_gate() {
    let text = rotor("inputs { u [s] = 3; }", "torque (if t < u then 0 else if t < u + w then T else 0) on rotor");
    for (set, exact) in [(7.0, 10.0), (0.5, 9.0)] {
        let model = interpreted(&text).unwrap();
        let start = declared_start(&model);
        let mut simulation = Simulation::new(model, &start, &Settings::adaptive(Method::Dop853, 10.0, 1e-10)).unwrap();
        simulation.advance_to(1.0).unwrap();
        simulation.set_input("u", Input::Held(set)).unwrap();
        simulation.advance_to(10.0).unwrap();
        let speed = simulation.state().speeds[0];
        assert!((speed - exact).abs() < 1e-8, "{set}: {speed}");
    }
}

/// The integral of a function from 0 on, by the midpoint rule.
fn integral(to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let parts = 200_000;
    let h = to / f64::from(parts);
    (0..parts).map(|i| f((f64::from(i) + 0.5) * h)).sum::<f64>() * h
}

/// Where a rotor of 9 rad/s is after 1 s that a potential of (phi - 3)/0.02 turns back at this place: the way from 2 rad there and
/// back takes the integral of 1/sqrt(2 (K - V)/J), in which the root of the distance from the place takes out the pole.
fn turned_back(potential: impl Fn(f64) -> f64, turn: f64) -> f64 {
    let (b, inertia, kinetic) = (0.02, 0.01, 0.405);
    let end = (turn + 1.0 / b).sqrt();
    let way = |s: f64| 2.0 * b * s / (2.0 / inertia * (kinetic - potential(turn - s * s))).sqrt();
    2.0 - 9.0 * (1.0 - 2.0 / 9.0 - 2.0 * integral(end, way))
}

/// A barrier of 0.5 J turns a rotor back that has 0.405 J, however it is written. A slope of 0.5 J in 0.02 rad does so within
/// 2 9 0.02 0.01/0.5 s.
#[test]
fn potentials_turn_back_what_has_too_little_energy() {
    let slope = |from: f64| from - 9.0 * (1.0 - from / 9.0 - 7.2e-3);
    let gauss = turned_back(|z| 0.5 * (-z * z).exp(), -(0.5f64 / 0.405).ln().sqrt());
    let tanh = turned_back(|z| 0.25 * (1.0 + z.tanh()), (0.405f64 / 0.25 - 1.0).atanh());
    let potentials = [
        ("E*max(0, 1 - abs((phi - 3)/b))", slope(2.98)),
        ("(if phi < 3 then 0 else if phi < 3 + b then E*(phi - 3)/b else E)", slope(3.0)),
        ("E*exp(-((phi - 3)/b)^2)", gauss),
        ("E*2.718281828459045^(-((phi - 3)/b)^2)", gauss),
        ("E/2*(1 + tanh((phi - 3)/b))", tanh),
    ];
    for (potential, exact) in potentials {
        for method in METHODS {
            for rows in [Rows::Even(1), Rows::Even(1000)] {
                let [phi, speed] = end(&rotor("", &format!("potential {potential}")), method, rows, 1.0);
                assert!(
                    (speed + 9.0).abs() < 1e-8 && (phi - exact).abs() < 1e-8,
                    "{potential} {method:?}: {phi} {speed}"
                );
            }
        }
    }
}

/// A load of 1 N along a bump of 1 m is a barrier of 1 J, and so is a step of 1 m under a mass of 1 kg in 1 m/s^2.
#[test]
fn geometry_of_loads_turns_back_what_has_too_little_energy() {
    let text = |place: &str, load: &str| {
        format!(
            "pub Slider; coordinates {{ x [m]; }} parameters {{ a [m] = 27; w [m] = 0.01; F [N] = 1; }}
             let Q = [x, 1 [m]*max(0, 1 - abs((x - a)/w))];
             let s = (x - a)/w;
             let S = [x, (if x < a then 0 else if x < a + w then 1 [m]*s^2*(3 - 2*s) else 1 [m])];
             bodies {{ b: mass 1 [kg] at {place}; }} loads {{ {load}; }} initial {{ dot(x) = 1; }}"
        )
    };
    for method in METHODS {
        for load in ["force -F on Q.y", "force [0, -F] at Q"] {
            let [x, speed] = end(&text("[x, 0]", load), method, Rows::Even(1), 40.0);
            // At the wall of slope F/w it stops and returns within 2 v/(F/w/m) = 0.02 s, as if it had not moved there.
            assert!((speed + 1.0).abs() < 1e-8 && (x - 14.0).abs() < 1e-7, "{load} {method:?}: {x} {speed}");
        }
        let [_, speed] = end(&text("S", "gravity [0, -1 [m/s^2]]"), method, Rows::Even(1), 40.0);
        assert!((speed + 1.0).abs() < 1e-7, "{method:?}: {speed}");
    }
}

/// Pulses that are zero in their middles, or whose argument only touches zero there.
#[test]
fn pulses_that_are_zero_in_the_middle_are_seen() {
    let gauss = std::f64::consts::PI.sqrt() * 0.01;
    let cases = [
        ("torque T*((t - t0)/w)^2*exp(-((t - t0)/w)^2) on rotor", 9.0 + gauss / 2.0 / 0.01),
        ("torque T*(t - t0)/w*exp(-((t - t0)/w)^2) on rotor", 9.0),
        ("torque T*2^(-((t - t0)/w)^2) on rotor", 9.0 + gauss / 2f64.ln().sqrt() / 0.01),
        ("torque T*(1 - tanh(((t - t0)/w)^2)) on rotor", 9.0 + 2.0 * integral(6.0, |z| 1.0 - (z * z).tanh())),
        ("torque 20*T*((phi - 27)/b)*exp(-((phi - 27)/b)^2) on rotor", 9.0),
    ];
    for (load, exact) in cases {
        for method in METHODS {
            for rows in [Rows::Even(1), Rows::Even(1000)] {
                let [_, speed] = end(&rotor("", load), method, rows, 10.0);
                assert!((speed - exact).abs() < 2e-8, "{load} {method:?}: {speed}, not {exact}");
            }
        }
    }
}

/// Equal steps over what a potential or an input hides are told, as over what a load says itself.
#[test]
fn equal_steps_over_hidden_changes_are_told() {
    let gate = "torque (if t < u then 0 else if t < u + w then T else 0) on rotor";
    for (inputs, load) in [("inputs { u [s] = 3.003; }", gate), ("", "potential E*max(0, 1 - abs((phi - 3)/b))")] {
        let model = interpreted(&rotor(inputs, load)).unwrap();
        let run = run_with(model, &Settings::equal_steps(Method::Rk4, 10.0, 1001)).unwrap();
        assert!(run.steps.sudden_changes.is_some(), "{load}");
    }
}
