//! Pendulums, which have closed forms: constraints with and without explicit time, drives, damping.

use sim::mechanism;
use tests::any_model::run;

mechanism! {
    /// A pendulum in polar coordinates.
    Pendulum;
    coordinates { phi [rad]; }
    parameters { l [m] = 0.7; m [kg] = 2; g [m/s^2] = 9.81; amplitude [deg] = 90; }
    let P = l*[sin(phi), -cos(phi)];
    bodies { bob: mass m at P; }
    loads { gravity [0, -g]; }
    initial { phi = amplitude; }
    events { quarter: phi = 0; period: dot(phi) = 0; }
}

mechanism! {
    /// The same pendulum in Cartesian coordinates, its rod a constraint.
    CartesianPendulum;
    coordinates { x [m]; y [m]; }
    parameters { l [m] = 0.7; m [kg] = 2; g [m/s^2] = 9.81; }
    bodies { bob: mass m at [x, y]; }
    loads { gravity [0, -g]; }
    constraints { rod: norm([x, y]) = l; }
    initial { x = 0.7; guess y = 0; }
    events { quarter: x = 0; }
    outputs { tension [N] = reaction(rod); }
}

mechanism! {
    /// A mass on a circle that a constraint drives at constant speed.
    Driven;
    coordinates { x [m]; y [m]; }
    parameters { r [m] = 0.5; w [rad/s] = 3; m [kg] = 2; }
    bodies { bead: mass m at [x, y]; }
    constraints { drive: [x, y] = r*[cos(w*t), sin(w*t)]; }
    initial { guess x = 0.4; guess y = 0.1; }
    outputs { force_x [N] = reaction(drive).x; force_y [N] = reaction(drive).y; }
}

mechanism! {
    /// A pendulum whose support shakes as declared.
    Shaken;
    coordinates { phi [rad]; }
    parameters { l [m] = 0.7; m [kg] = 2; J [kg*m^2] = 0.1; g [m/s^2] = 9.81; a [m] = 0.05; w [rad/s] = 20; c [N*m*s] = 0.3; }
    let support = [a*sin(w*t), 0.5*a*cos(2*w*t)];
    let P = support + l*[sin(phi), -cos(phi)];
    bodies { rod: mass m at P, inertia J, angle phi; }
    loads { gravity [0, -g]; torque -c*dot(phi) on rod; force [0.3 [N/s]*t, -1 [N*s/m]*dot(P.x)] at P; }
    initial { phi = 0.4; dot(phi) = -1; }
}

mechanism! {
    /// A wheel that turns evenly, with conditions that change sign without a root, and one that holds at the start.
    Wheel;
    coordinates { phi [rad]; }
    parameters { J [kg*m^2] = 1; }
    bodies { wheel: inertia J, angle phi; }
    initial { phi = pi; dot(phi) = 10; }
    events {
        jump: atan2(sin(phi + pi/2), cos(phi + pi/2)) = 0;
        pole: tan(phi) = 1;
        edge: sqrt(phi - 4) = 5;
        start: sin(phi) = 0;
    }
}

/// Arithmetic-geometric mean.
fn agm(mut a: f64, mut b: f64) -> f64 {
    while (a - b).abs() > 1e-15 * a {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    a
}

/// T = 2 pi sqrt(l/g) / agm(1, cos(amplitude/2)).
fn exact_period(l: f64, g: f64, amplitude: f64) -> f64 {
    2.0 * std::f64::consts::PI * (l / g).sqrt() / agm(1.0, (amplitude / 2.0).cos())
}

/// Steps of a thousandth of the period: the method of order 4 leaves about 1e-11, the events add 1e-12.
const PERIOD_TOLERANCE: f64 = 1e-9;

#[test]
fn a_pendulum_keeps_its_period() {
    for degrees in [10.0f64, 90.0, 170.0] {
        let amplitude = degrees.to_radians();
        let pendulum = Pendulum { amplitude, ..Default::default() };
        let period = exact_period(0.7, 9.81, amplitude);
        let run = run(pendulum, 1.1 * period, 4000).unwrap();
        let times = |name: &str| -> Vec<f64> {
            run.events.iter().filter(|event| event.name == name).map(|event| event.state.time).collect()
        };
        let expected = [period / 4.0, period * 0.75];
        assert_eq!((times("quarter").len(), times("period").len()), (2, 2));
        for (found, expected) in times("quarter").iter().zip(expected) {
            assert!((found - expected).abs() < PERIOD_TOLERANCE, "{degrees}: {found} {expected}");
        }
        // The bob stands still at the start, which does not count, after half a period and after a whole one.
        let still = times("period");
        assert!((still[0] - period / 2.0).abs() < PERIOD_TOLERANCE && (still[1] - period).abs() < PERIOD_TOLERANCE);
        // Against energy of order m g l = 14 J.
        assert!(run.energy_balance < 1e-9, "{}", run.energy_balance);
    }
}

#[test]
fn a_constrained_pendulum_keeps_its_period_and_carries_its_bob() {
    let period = exact_period(0.7, 9.81, std::f64::consts::FRAC_PI_2);
    let run = run(CartesianPendulum::default(), 1.1 * period, 4000).unwrap();
    assert!((run.events[0].state.time - period / 4.0).abs() < PERIOD_TOLERANCE);
    assert!(run.position_residual < 1e-12 && run.velocity_residual < 1e-12);
    for sample in &run.trajectory.samples {
        // From rest at the height of the pivot, v^2 = -2 g y: the rod pulls with m (v^2 - g y)/l = -3 m g y/l.
        let expected = -3.0 * 2.0 * 9.81 * sample.state.positions[1] / 0.7;
        // Of the largest tension, 3 m g = 59 N.
        assert!((sample.multipliers[0] - expected).abs() < 59.0 * PERIOD_TOLERANCE);
    }
}

#[test]
fn a_drive_holds_its_path_and_reacts_with_the_centripetal_force() {
    let run = run(Driven::default(), 3.0, 3000).unwrap();
    let (r, w, m) = (0.5, 3.0, 2.0);
    assert!(run.position_residual < 1e-12 && run.velocity_residual < 1e-12);
    // A drive that holds a constant speed does no work.
    assert!(run.energy_balance < 1e-12, "{}", run.energy_balance);
    for sample in &run.trajectory.samples {
        let (sin, cos) = (w * sample.state.time).sin_cos();
        // The system pushes its guide outwards.
        let expected = [m * r * w * w * cos, m * r * w * w * sin];
        for (found, expected) in sample.multipliers.as_ref().iter().zip(expected) {
            assert!((found - expected).abs() < 1e-11, "{found} {expected}");
        }
    }
}

/// The equation of motion derived by hand: (J + m l^2) phi'' = -m l (sx'' cos phi + (g + sy'') sin phi) - c phi'
/// + l (Fx cos phi + Fy sin phi), integrated independently.
#[test]
fn a_shaken_pendulum_follows_the_equation_derived_by_hand() {
    let (l, m, j, g, a, w, c) = (0.7, 2.0, 0.1, 9.81, 0.05, 20.0, 0.3);
    let acceleration = |t: f64, phi: f64, rate: f64| {
        let (sx, sy) = (-a * w * w * (w * t).sin(), -2.0 * a * w * w * (2.0 * w * t).cos());
        let vx = a * w * (w * t).cos() + l * phi.cos() * rate;
        let force = [0.3 * t, -vx];
        let moment = l * (force[0] * phi.cos() + force[1] * phi.sin()) - c * rate;
        (moment - m * l * (sx * phi.cos() + (g + sy) * phi.sin())) / (j + m * l * l)
    };
    let steps = 20_000;
    let run = run(Shaken::default(), 2.0, steps).unwrap();
    let h = 2.0 / steps as f64;
    let (mut phi, mut rate) = (0.4, -1.0);
    for (i, sample) in run.trajectory.samples.iter().enumerate() {
        let t = i as f64 * h;
        // Both follow the same exact solution with errors of (20 h)^4 = 2e-11 at most.
        assert!((sample.state.positions[0] - phi).abs() < 1e-9, "{t}");
        assert!((sample.accelerations[0] - acceleration(t, phi, rate)).abs() < 1e-7, "{t}");
        let f = |t: f64, y: [f64; 2]| [y[1], acceleration(t, y[0], y[1])];
        let step = |y: [f64; 2], k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
        let y = [phi, rate];
        let k1 = f(t, y);
        let k2 = f(t + h / 2.0, step(y, k1, h / 2.0));
        let k3 = f(t + h / 2.0, step(y, k2, h / 2.0));
        let k4 = f(t + h, step(y, k3, h));
        phi += h / 6.0 * (k1[0] + 2.0 * k2[0] + 2.0 * k3[0] + k4[0]);
        rate += h / 6.0 * (k1[1] + 2.0 * k2[1] + 2.0 * k3[1] + k4[1]);
    }
    // The drive of the support does work; the balance counts it.
    assert!(run.energy_balance < 1e-9, "{}", run.energy_balance);
}

#[test]
fn only_roots_are_events() {
    // From pi to pi + 7.2 rad.
    let run = run(Wheel::default(), 0.72, 100).unwrap();
    let pi = std::f64::consts::PI;
    let angles = |name: &str| -> Vec<f64> {
        run.events.iter().filter(|event| event.name == name).map(|event| event.state.positions[0]).collect()
    };
    let near = |found: Vec<f64>, expected: &[f64]| {
        assert_eq!(found.len(), expected.len(), "{found:?}");
        // 10 rad/s times the tolerance of times, and the method's own rounding.
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-10), "{found:?}");
    };
    near(angles("jump"), &[1.5 * pi]);
    near(angles("pole"), &[1.25 * pi, 2.25 * pi, 3.25 * pi]);
    near(angles("edge"), &[]);
    near(angles("start"), &[2.0 * pi, 3.0 * pi]);
}
