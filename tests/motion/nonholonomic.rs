//! Constraints between speeds: a skate against closed forms, rolling against the constraint between positions that it can be
//! integrated to, and a floor that moves.

use models::Skate;
use sim::{Compiled, Mechanism, Method, Run, Settings, Stabilisation, Table, mechanism, mobility};
use tests::any_model::run_with;

const OMEGA: f64 = 3.0;

fn column<M: Mechanism>(run: &Run<M>, name: &str) -> Vec<f64> {
    assert_eq!(run.trajectory.failure, None);
    Table::of(&run.mechanism, &run.trajectory).column(name).unwrap().values.clone()
}

/// A column is `expected` of time, to `tolerance` of its largest value.
fn check<M: Mechanism>(run: &Run<M>, name: &str, tolerance: f64, expected: impl Fn(f64) -> f64) {
    let (times, values) = (column(run, "t"), column(run, name));
    let largest = values.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
    let apart = times.iter().zip(&values).map(|(t, value)| (value - expected(*t)).abs());
    let worst = apart.fold(0.0f64, f64::max) / largest;
    println!("{:<12} {name:<12} {worst:.1e}", run.mechanism.description().name);
    assert!(worst < tolerance, "{name}: {worst:e}");
}

fn ways() -> [Stabilisation; 3] {
    [Stabilisation::Projection, Stabilisation::MassProjection, Stabilisation::Partitioning]
}

/// With phi = omega t the speed u along the blade obeys u' = g sin(slope) cos(phi), so u = k sin(phi)/omega; x and y are the
/// integrals of u cos(phi) and u sin(phi), and the ice gives m u phi' across. Tolerance: a thousand times that of a step.
#[test]
fn a_knife_edge_on_an_incline_draws_a_cycloid() {
    for stabilisation in ways() {
        let settings = Settings { stabilisation, ..Settings::adaptive(Method::Dop853, 4.0, 1e-12) };
        let run = run_with(Skate::default(), &settings).unwrap();
        let k = 9.81 * 5f64.to_radians().sin();
        let phi = |t: f64| OMEGA * t;
        check(&run, "phi", 1e-9, phi);
        check(&run, "x", 1e-9, |t| k / (2.0 * OMEGA * OMEGA) * phi(t).sin().powi(2));
        check(&run, "y", 1e-9, |t| k / (2.0 * OMEGA * OMEGA) * (phi(t) - 0.5 * (2.0 * phi(t)).sin()));
        check(&run, "speed", 1e-9, |t| k / OMEGA * phi(t).sin());
        // The blade is pushed to its left by m u omega and gravity across it, and pushes back.
        check(&run, "side_force", 1e-9, |t| -2.0 * 2.0 * k * phi(t).sin());
        assert!(run.energy_balance < 1e-10 && run.velocity_residual < 1e-12, "{}", run.energy_balance);
    }
}

/// Chaplygin's sleigh: u' = a omega^2 and omega' = -(a/k^2) u omega with k^2 = (J + m a^2)/m, so u = c tanh(s) and
/// omega = (c/k) / cosh(s) with s = a c t / k^2; the angle is (k/a) gd(s).
#[test]
fn chaplygins_sleigh_stops_turning() {
    let (a, omega) = (0.2, OMEGA);
    let skate = Skate { a, slope: 0.0, ..Default::default() };
    let k = f64::sqrt(skate.J / skate.m + a * a);
    let c = k * omega;
    let s = |t: f64| a * c * t / (k * k);
    for stabilisation in ways() {
        let settings = Settings { stabilisation, ..Settings::adaptive(Method::Dop853, 6.0, 1e-12) };
        let run = run_with(skate, &settings).unwrap();
        check(&run, "speed", 1e-9, |t| c * s(t).tanh());
        check(&run, "phi_dot", 1e-9, |t| c / k / s(t).cosh());
        check(&run, "phi", 1e-9, |t| k / a * 2.0 * (s(t) / 2.0).tanh().atan());
        assert!(run.energy_balance < 1e-10, "{}", run.energy_balance);
    }
}

#[test]
fn a_skate_has_fewer_speeds_than_positions() {
    let found = mobility(&Skate::default(), 0.0, &[0.0; 3]);
    assert_eq!((found.degrees_of_freedom, found.configuration_freedom), (2, 3));
    assert_eq!(Skate::<f64>::DESCRIPTION.speed_constraints, [0]);
}

mechanism! {
    /// A disc with its weight off its centre, which rolls down a slope: between speeds.
    RollingDisc;
    coordinates { x [m]; y [m]; phi [rad]; }
    parameters { r [m] = 0.3; d [m] = 0.1; m [kg] = 2; J [kg*m^2] = 0.05; slope [rad] = 0.1; g [m/s^2] = 9.81; }
    bodies { disc: mass m at [x, y] + d*[sin(phi), cos(phi)], inertia J, angle phi; }
    loads { gravity g*[sin(slope), -cos(slope)]; torque -0.01 [N*m*s]*dot(phi) on disc; }
    constraints { roll: dot(x) = r*dot(phi); floor: y = r; }
    initial { x = 0; phi = 0; dot(phi) = 1; guess y = r; }
    outputs { friction [N] = reaction(roll); load [N] = reaction(floor); }
}

mechanism! {
    /// The same between positions.
    GearedDisc;
    coordinates { x [m]; y [m]; phi [rad]; }
    parameters { r [m] = 0.3; d [m] = 0.1; m [kg] = 2; J [kg*m^2] = 0.05; slope [rad] = 0.1; g [m/s^2] = 9.81; }
    bodies { disc: mass m at [x, y] + d*[sin(phi), cos(phi)], inertia J, angle phi; }
    loads { gravity g*[sin(slope), -cos(slope)]; torque -0.01 [N*m*s]*dot(phi) on disc; }
    constraints { roll: x = r*phi; floor: y = r; }
    initial { x = 0; phi = 0; dot(phi) = 1; guess y = r; }
    outputs { friction [N] = reaction(roll); load [N] = reaction(floor); }
}

/// Rolling on a line can be integrated: then it is the same motion with the same reactions. Tolerance: that of two integrations.
#[test]
fn rolling_is_what_it_can_be_integrated_to() {
    let settings = Settings::adaptive(Method::Dop853, 3.0, 1e-12);
    let geared = run_with(GearedDisc::default(), &settings).unwrap();
    for stabilisation in ways() {
        let rolling = run_with(RollingDisc::default(), &Settings { stabilisation, ..settings }).unwrap();
        for name in ["x", "phi", "x_dot", "phi_dot", "friction", "load"] {
            let (a, b) = (column(&rolling, name), column(&geared, name));
            let largest = a.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
            let worst = a.iter().zip(&b).fold(0.0f64, |worst, (a, b)| worst.max((a - b).abs())) / largest;
            println!("{stabilisation:<16} {name:<8} {worst:.1e}");
            assert!(worst < 1e-9, "{name}: {worst:e}");
        }
    }
}

mechanism! {
    /// A ball on a belt that is driven to and fro: the belt's work is in the balance.
    Belt;
    coordinates { x [m]; phi [rad]; }
    parameters { r [m] = 0.3; m [kg] = 2; J [kg*m^2] = 0.07; v [m/s] = 0.8; w [1/s] = 3; }
    bodies { ball: mass m at [x, r], inertia J, angle phi; }
    constraints { roll: dot(x) + r*dot(phi) = v*sin(w*t); }
    initial { x = 0; phi = 0; dot(phi) = 1; }
    outputs { friction [N] = reaction(roll); }
}

/// m x'' = -lambda and J phi'' = -lambda r give x'' (m r^2 / J + 1) = v w cos(w t), and the belt does the work of the force on
/// it, lambda, along its speed.
#[test]
fn a_belt_drives_a_ball() {
    let run = run_with(Belt::default(), &Settings::adaptive(Method::Dop853, 5.0, 1e-12)).unwrap();
    let (r, m, j, v, w) = (0.3, 2.0, 0.07, 0.8, 3.0);
    let share = 1.0 / (m * r * r / j + 1.0);
    let start = -r * 1.0;
    check(&run, "x_dot", 1e-9, |t| start + share * v * (w * t).sin());
    check(&run, "friction", 1e-9, |t| -m * share * v * w * (w * t).cos());
    assert!(run.energy_balance < 1e-10, "{}", run.energy_balance);
}
