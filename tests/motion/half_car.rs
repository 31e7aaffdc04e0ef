//! The half car by its modes: each answers the bump by Duhamel's integral.

use models::HalfCar;
use sim::{Method, Settings};
use tests::any_model::run_with;

/// One mode of M X'' + C X' + K X = f with C = 0 beside the damping of the mode itself.
struct Mode {
    /// Bounce and pitch, with X' M X = 1.
    shape: [f64; 2],
    /// omega^2
    stiffness: f64,
}

/// The modes of M = diag(m, J) and K.
fn modes(car: &HalfCar) -> [Mode; 2] {
    let a = (car.kf + car.kr) / car.m;
    let b = (car.kf * car.lf - car.kr * car.lr) / (car.m * car.J).sqrt();
    let d = (car.kf * car.lf * car.lf + car.kr * car.lr * car.lr) / car.J;
    [1.0, -1.0].map(|sign| {
        let stiffness = (a + d) / 2.0 + sign * ((a - d).powi(2) / 4.0 + b * b).sqrt();
        let (x, y) = (b, stiffness - a);
        let length = x.hypot(y);
        Mode { shape: [x / length / car.m.sqrt(), y / length / car.J.sqrt()], stiffness }
    })
}

/// Height of the road at a place, and its slope.
fn road(car: &HalfCar, s: f64) -> (f64, f64) {
    let x = (s - car.s0) / car.w;
    let height = car.H * (-x * x).exp();
    (height, -2.0 * x / car.w * height)
}

/// Bounce and pitch at a time, for damping in proportion to stiffness: eta'' + tau k eta' + k eta = shape'f.
fn motion(car: &HalfCar, tau: f64, t: f64) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for mode in modes(car) {
        let decay = tau * mode.stiffness / 2.0;
        let frequency = (mode.stiffness - decay * decay).sqrt();
        let integrand = |s: f64| {
            let force: f64 = [(car.lf, car.kf), (-car.lr, car.kr)]
                .into_iter()
                .map(|(arm, k)| {
                    let (height, slope) = road(car, car.v * s + arm);
                    k * (height + tau * car.v * slope) * (mode.shape[0] + arm * mode.shape[1])
                })
                .sum();
            (-decay * (t - s)).exp() * (frequency * (t - s)).sin() / frequency * force
        };
        // Simpson's rule; 4e-4 s against the 0.05 s in which the bump is passed leave 1e-10.
        let panels = 2 * (t / 4e-4).ceil() as usize;
        let h = t / panels as f64;
        let weight = |i: usize| if i == 0 || i == panels { 1.0 } else { 2.0 + 2.0 * (i % 2) as f64 };
        let eta = h / 3.0 * (0..=panels).map(|i| weight(i) * integrand(i as f64 * h)).sum::<f64>();
        sum = [sum[0] + mode.shape[0] * eta, sum[1] + mode.shape[1] * eta];
    }
    sum
}

#[test]
fn a_half_car_over_a_bump_by_modes() {
    let tau = 0.07;
    let car: HalfCar = HalfCar::default();
    let car = HalfCar { cf: tau * car.kf, cr: tau * car.kr, ..car };
    let run = run_with(car, &Settings::equal_steps(Method::Dop853, 2.0, 2000)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let mut worst = 0.0f64;
    for sample in run.trajectory.samples.iter().step_by(100).skip(1) {
        let expected = motion(&car, tau, sample.state.time);
        for (found, expected) in sample.state.positions.as_ref().iter().zip(expected) {
            worst = worst.max((found - expected).abs());
        }
    }
    let largest = run.trajectory.samples.iter().map(|sample| sample.state.positions[0].abs()).fold(0.0, f64::max);
    println!("largest bounce {largest}, worst difference {worst:.1e}");
    assert!(largest > 0.01 && worst < 1e-10, "{worst:e}");
}
