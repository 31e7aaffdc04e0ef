//! Springs, dampers, potentials and dissipation functions, against closed forms.

use sim::{Compiled, Method, Rows, Run, Settings, mechanism};
use tests::any_model::{AnyModel, run_with};

mechanism! {
    /// A mass on a rail between a spring and a damper.
    Oscillator;
    coordinates { x [m]; }
    parameters { m [kg] = 2; k [N/m] = 50; c [N*s/m] = 3; l0 [m] = 0.4; }
    bodies { slider: mass m at [x, 0]; }
    loads { spring k, length l0 from [0, 0] to [x, 0]; damper c from [0, 0] to [x, 0]; }
    initial { x = 0.7; dot(x) = -0.5; }
}

mechanism! {
    /// Two discs on a shaft that twists.
    Discs;
    coordinates { a [rad]; b [rad]; }
    parameters { J1 [kg*m^2] = 0.3; J2 [kg*m^2] = 0.7; k [N*m/rad] = 20; twist [rad] = 0.5; }
    bodies { first: inertia J1, angle a; second: inertia J2, angle b; }
    loads { spring k, rest 0 between a and b; }
    initial { a = 0; b = twist; }
}

mechanism! {
    /// A mass in the plane on a spring without free length, which it passes through.
    Central;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 2; k [N/m] = 50; }
    bodies { point: mass m at [x, y]; }
    loads { spring k, length 0 from [0, 0] to [x, y]; }
    initial { x = 0.3; dot(y) = 0; }
}

mechanism! {
    /// A hardening spring by its law.
    Hardening;
    coordinates { x [m]; }
    parameters { m [kg] = 2; k [N/m] = 50; d [N/m^3] = 800; }
    bodies { slider: mass m at [x, 0]; }
    loads { spring k*stretch + d*stretch^3, rest 0 on x; }
    initial { x = 0.4; }
    events { centre: x = 0; }
    outputs { energy [J] = m*dot(x)^2/2 + k*x^2/2 + d*x^4/4; }
}

mechanism! {
    /// The same by its potential.
    Quartic;
    coordinates { x [m]; }
    parameters { m [kg] = 2; k [N/m] = 50; d [N/m^3] = 800; }
    bodies { slider: mass m at [x, 0]; }
    loads { potential k*x^2/2 + d*x^4/4; }
    initial { x = 0.4; }
    events { centre: x = 0; }
    outputs { energy [J] = m*dot(x)^2/2 + k*x^2/2 + d*x^4/4; }
}

mechanism! {
    /// A point that a dissipation function brakes in polar coordinates, where it runs straight on.
    Braked;
    coordinates { r [m]; phi [rad]; }
    parameters { m [kg] = 2; c [N*s/m] = 3; }
    let P = r*[cos(phi), sin(phi)];
    bodies { point: mass m at P; }
    loads { dissipation c/2*inner(dot(P), dot(P)); }
    initial { r = 1; phi = 0; dot(phi) = 2; }
    outputs { x [m] = P.x; y [m] = P.y; }
}

mechanism! {
    /// A block that dry friction stops.
    Sliding;
    coordinates { x [m]; }
    parameters { m [kg] = 2; mu = 0.3; g [m/s^2] = 9.81; v0 [m/s] = 0.01; }
    bodies { block: mass m at [x, 0]; }
    loads { friction mu*m*g, smooth v0 on x; }
    initial { x = 0; dot(x) = 2; }
}

mechanism! {
    /// A ball on a spring that only pushes.
    Bumper;
    coordinates { y [m]; }
    parameters { m [kg] = 2; k [N/m] = 5000; g [m/s^2] = 9.81; h [m] = 0.3; }
    bodies { ball: mass m at [0, y]; }
    loads { gravity [0, -g]; spring min(k*stretch, 0), rest 0 on y; }
    initial { y = h; }
    events { touch: y = 0; turn: dot(y) = 0; }
}

/// 5 s at a relative tolerance of 1e-11, with a row every 5 ms.
fn run<M: Compiled>(mechanism: M, end: f64) -> Run<AnyModel> {
    let settings = Settings { rows: Rows::Even(1000), ..Settings::adaptive(Method::Dop853, end, 1e-11) };
    run_with(mechanism, &settings).unwrap()
}

/// The largest difference of a coordinate from its closed form.
fn error(run: &Run<AnyModel>, i: usize, exact: impl Fn(f64) -> f64) -> f64 {
    assert_eq!(run.trajectory.failure, None);
    let samples = run.trajectory.samples.iter();
    samples.map(|s| (s.state.positions[i] - exact(s.state.time)).abs()).fold(0.0, f64::max)
}

/// Amplitudes are below 1, and some ten periods amplify the tolerance of a step by as much.
const TOLERANCE: f64 = 1e-9;

#[test]
fn a_spring_and_a_damper_are_the_damped_oscillator() {
    let run = run(Oscillator::default(), 5.0);
    let Oscillator { m, k, c, l0 } = Oscillator::<f64>::default();
    let (decay, x0, v0) = (c / (2.0 * m), 0.7 - l0, -0.5);
    let frequency = (k / m - decay * decay).sqrt();
    let exact = |t: f64| {
        let sine = (v0 + decay * x0) / frequency * (frequency * t).sin();
        l0 + (-decay * t).exp() * (x0 * (frequency * t).cos() + sine)
    };
    assert!(error(&run, 0, exact) < TOLERANCE, "{:e}", error(&run, 0, exact));
    assert!(run.energy_balance < TOLERANCE);
}

#[test]
fn discs_on_a_shaft_swing_against_each_other() {
    let run = run(Discs::default(), 5.0);
    let Discs { J1, J2, k, twist } = Discs::<f64>::default();
    let frequency = (k * (1.0 / J1 + 1.0 / J2)).sqrt();
    let share = |own: f64, other: f64| other / (own + other) * twist;
    // The centre of both stays where it is.
    let centre = J2 * twist / (J1 + J2);
    assert!(error(&run, 0, |t| centre - share(J1, J2) * (frequency * t).cos()) < TOLERANCE);
    assert!(error(&run, 1, |t| centre + share(J2, J1) * (frequency * t).cos()) < TOLERANCE);
}

#[test]
fn a_spring_without_length_has_no_singular_position() {
    let run = run(Central::default(), 5.0);
    let Central { m, k, .. } = Central::<f64>::default();
    let frequency = (k / m).sqrt();
    assert!(error(&run, 0, |t| 0.3 * (frequency * t).cos()) < TOLERANCE);
    assert!(error(&run, 1, |_| 0.0) < TOLERANCE);
}

/// A quarter of the period of Duffing's oscillator m x'' + k x + d x^3 = 0 at amplitude a: K(n)/w with
/// w^2 = (k + d a^2)/m and n^2 = d a^2/(2 (k + d a^2)), K by the arithmetic-geometric mean.
#[test]
fn a_law_and_its_potential_are_duffings_oscillator() {
    let (m, k, d, a) = (2.0f64, 50.0, 800.0, 0.4);
    let (frequency, modulus_squared) = (((k + d * a * a) / m).sqrt(), d * a * a / (2.0 * (k + d * a * a)));
    let (mut mean, mut geometric) = (1.0f64, (1.0 - modulus_squared).sqrt());
    for _ in 0..8 {
        (mean, geometric) = ((mean + geometric) / 2.0, (mean * geometric).sqrt());
    }
    let quarter = std::f64::consts::FRAC_PI_2 / mean / frequency;
    let by_law = run(Hardening::default(), 5.0);
    let by_potential = run(Quartic::default(), 5.0);
    assert!((by_law.events[0].state.time - quarter).abs() < TOLERANCE);
    assert!((by_potential.events[0].state.time - quarter).abs() < TOLERANCE);
    assert!(
        error(&by_law, 0, |t| by_potential.trajectory.samples[(t * 200.0).round() as usize].state.positions[0]) < 1e-8
    );
    for run in [by_potential.energy_balance, by_law.energy_balance] {
        assert!(run < TOLERANCE, "{run:e}");
    }
}

#[test]
fn a_dissipation_function_brakes_exponentially_and_its_power_is_in_the_balance() {
    let run = run(Braked::default(), 5.0);
    let Braked { m, c } = Braked::<f64>::default();
    let way = |t: f64| 2.0 * m / c * (1.0 - (-c / m * t).exp());
    for sample in &run.trajectory.samples {
        let [r, phi] = [0, 1].map(|i| sample.state.positions[i]);
        let t = sample.state.time;
        assert!((r * phi.cos() - 1.0).abs() < TOLERANCE && (r * phi.sin() - way(t)).abs() < TOLERANCE);
        // R is c v^2/2, and the power -2 R.
        let speed = 2.0 * (-c / m * t).exp();
        assert!((sample.power + c * speed * speed).abs() < 10.0 * TOLERANCE);
    }
    assert!(run.energy_balance < TOLERANCE);
}

/// m v' = -F tanh(v/v0): sinh(v/v0) decays as exp(-F t/(m v0)), and the way to rest is the integral of
/// v dv/(a tanh(v/v0)), that is v^2/(2 a) + pi^2 v0^2/(12 a) for a start of many v0; a = mu g, and Coulomb's is v^2/(2 a).
#[test]
fn dry_friction_stops_where_coulomb_says_but_for_the_smoothing() {
    let run = run(Sliding::default(), 2.0);
    let Sliding { mu, g, v0, .. } = Sliding::<f64>::default();
    let (a, start) = (mu * g, 2.0f64);
    let coulomb = start * start / (2.0 * a);
    let smoothed = coulomb + std::f64::consts::PI.powi(2) * v0 * v0 / (12.0 * a);
    let last = run.trajectory.samples.last().unwrap().state.clone();
    assert!((last.positions[0] - smoothed).abs() < TOLERANCE, "{} {smoothed}", last.positions[0]);
    assert!(last.speeds[0].abs() < TOLERANCE && (last.positions[0] / coulomb - 1.0).abs() < 5e-5);
    assert!(run.energy_balance < TOLERANCE);
}

/// Falling h, pushing through half a period about the sag m g/k, and back: the closed form of each piece.
#[test]
fn a_spring_that_only_pushes_is_left_and_met_again() {
    let run = run(Bumper::default(), 1.2);
    let Bumper { m, k, g, h } = Bumper::<f64>::default();
    let (falling, w, sag) = ((2.0 * h / g).sqrt(), (k / m).sqrt(), m * g / k);
    // y = -sag + sag cos(w s) - v/w sin(w s) is 0 again after 2 (pi - atan(v/(w sag)))/w.
    let pushed = 2.0 * (std::f64::consts::PI - (g * falling / (w * sag)).atan()) / w;
    let times = [falling, falling + pushed, 3.0 * falling + pushed];
    let touches: Vec<f64> = run.events.iter().filter(|e| e.name == "touch").map(|e| e.state.time).collect();
    assert!(touches.len() >= 3);
    for (found, exact) in touches.iter().zip(times) {
        // The force has a kink there, at which a step that crosses it is refused until it is short.
        assert!((found - exact).abs() < 1e-8, "{found} {exact}");
    }
    assert!(run.energy_balance < 1e-8);
}
