//! The cart with a pole: its accelerations solved by hand, its fall from upright, and its swing up by energy.

use models::CartPole;
use sim::{Controller, Input, Method, Sample, Settings, declared_start, run_controlled};
use std::f64::consts::PI;
use tests::Random;
use tests::any_model::run_with;

/// x'' and phi'' of (M + m) x'' + m l (cos phi phi'' - sin phi phi'^2) = F and l phi'' + cos phi x'' = g sin phi.
fn accelerations(c: &CartPole, force: f64, phi: f64, rate: f64) -> [f64; 2] {
    let (s, k) = phi.sin_cos();
    let x = (force + c.m * c.l * s * rate * rate - c.m * c.g * s * k) / (c.M + c.m * s * s);
    [x, (c.g * s - k * x) / c.l]
}

#[test]
fn a_cart_with_a_pole_accelerates_as_by_hand() {
    let mut random = Random(3);
    for _ in 0..200 {
        let push = random.between(-9.0, 9.0);
        let cart = CartPole { push: Input::Held(push), ..CartPole::default() };
        let (phi, rate) = (random.between(-4.0, 4.0), random.between(-9.0, 9.0));
        let found = cart.dynamics(0.0, &[0.3, phi], &[-0.4, rate]).accelerations;
        for (found, expected) in found.iter().zip(accelerations(&cart, push, phi, rate)) {
            // Rounding of terms of up to 200.
            assert!((found - expected).abs() < 1e-12 * 200.0, "{found} {expected}");
        }
    }
}

/// Near upright phi'' = (M + m) g/(M l) phi, so phi = phi0 cosh(w t); cubes of 1e-5 are lost beside it.
#[test]
fn a_pole_falls_as_the_linearised_one() {
    let cart = CartPole { start: 1e-7, push: Input::Held(0.0), ..CartPole::default() };
    let run = run_with(cart, &Settings::equal_steps(Method::Dop853, 0.9, 900)).unwrap();
    let w = ((cart.M + cart.m) * cart.g / (cart.M * cart.l)).sqrt();
    for sample in &run.trajectory.samples {
        let expected = cart.start * (w * sample.state.time).cosh();
        assert!((sample.state.positions[1] / expected - 1.0).abs() < 1e-8, "{}", sample.state.time);
    }
}

/// The drive gives the cart the acceleration k (E - m g l) phi' cos phi, with which the energy E of the pole goes to that
/// of the upright one, whatever its start.
#[test]
fn a_pole_is_swung_up_by_its_energy() {
    let cart: CartPole = CartPole::default();
    let (upright, gain) = (cart.m * cart.g * cart.l, 20.0);
    let energy = |phi: f64, rate: f64| cart.m * cart.l * (cart.l * rate * rate / 2.0 + cart.g * phi.cos());
    let law = |sample: &Sample<CartPole>| {
        let (phi, rate) = (sample.state.positions[1], sample.state.speeds[1]);
        let (s, k) = phi.sin_cos();
        let wanted = gain * (energy(phi, rate) - upright) * rate * k;
        let resisted = cart.m * cart.l * s * rate * rate - cart.m * cart.g * s * k;
        [Input::Held((cart.M + cart.m * s * s) * wanted - resisted)]
    };
    let mut controller = Controller::new(0.002, law).unwrap();
    let settings = Settings::adaptive(Method::Dop853, 12.0, 1e-9);
    let run = run_controlled(cart, &declared_start(&cart), &settings, &mut controller).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let off =
        |sample: &Sample<CartPole>| (energy(sample.state.positions[1], sample.state.speeds[1]) - upright) / upright;
    let (first, last) = (off(&run.trajectory.samples[0]), off(run.trajectory.samples.last().unwrap()));
    println!("energy relative to upright: {first:.3} at the start, {last:.1e} at the end");
    // A hold of 2 ms leaves an error of the order of its length times the speeds, 2e-3*9 of one percent.
    assert!(first < -1.9 && last.abs() < 0.01, "{first} {last}");
    assert!(run.trajectory.samples.iter().any(|s| (s.state.positions[1].rem_euclid(2.0 * PI) - PI).abs() > 3.0));
}
