//! A body on which nothing acts, against Jacobi's elliptic functions (Landau and Lifshitz, Mechanics, section 37).

use crate::elliptic::{jacobi, quarter};
use models::{Tumbling, TumblingQuaternion};
use sim::{Compiled, Method, Run, Settings, Table};
use std::f64::consts::{FRAC_PI_2, TAU};
use tests::any_model::{AnyModel, run_with};

/// How many times the angular velocity returns to what it was.
const PERIODS: f64 = 100.0;

/// The closed form for moments of inertia A < B < C, for angular momentum H along z and nutation below the separatrix.
pub(crate) struct Closed {
    inertia: [f64; 3],
    momentum: f64,
    amplitudes: [f64; 3],
    modulus: f64,
    rate: f64,
    /// Precession in a period of the angular velocity.
    advance: f64,
}

impl Closed {
    pub(crate) fn new([a, b, c]: [f64; 3], h: f64, theta: f64) -> Closed {
        let twice_energy = h * h * (theta.sin().powi(2) / a + theta.cos().powi(2) / c);
        let (low, high) = (twice_energy * c - h * h, h * h - twice_energy * a);
        assert!(h * h > twice_energy * b, "beyond the separatrix");
        let amplitudes = [(low / (a * (c - a))).sqrt(), (low / (b * (c - b))).sqrt(), (high / (c * (c - a))).sqrt()];
        let modulus = ((b - a) * low / ((c - b) * high)).sqrt();
        let rate = ((c - b) * high / (a * b * c)).sqrt();
        let mut closed = Closed { inertia: [a, b, c], momentum: h, amplitudes, modulus, rate, advance: 0.0 };
        closed.advance = closed.precession_within(closed.period(), 0.0);
        closed
    }

    fn period(&self) -> f64 {
        4.0 * quarter(self.modulus) / self.rate
    }

    pub(crate) fn spin(&self, t: f64) -> [f64; 3] {
        let [sn, cn, dn] = jacobi(self.rate * t, self.modulus);
        let [a, b, c] = self.amplitudes;
        // The start is at phi = 90 degrees, where w1 is largest; w2 falls from there as A < B < C are right-handed.
        [a * cn, b * sn, c * dn]
    }

    /// The rate of precession, H (A w1^2 + B w2^2)/((A w1)^2 + (B w2)^2).
    fn precession_rate(&self, t: f64) -> f64 {
        let ([a, b, _], [w1, w2, _]) = (self.inertia, self.spin(t));
        self.momentum * (a * w1 * w1 + b * w2 * w2) / ((a * w1).powi(2) + (b * w2).powi(2))
    }

    /// Its integral over a span, by Gauss and Legendre's rule of eight points on short pieces.
    fn precession_within(&self, span: f64, from: f64) -> f64 {
        const NODES: [(f64, f64); 4] = [
            (0.183_434_642_495_649_8, 0.362_683_783_378_362),
            (0.525_532_409_916_329, 0.313_706_645_877_887_3),
            (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
            (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
        ];
        let pieces = (span / self.period() * 60.0).ceil().max(1.0);
        let half = span / pieces / 2.0;
        let piece = |k: usize| {
            let middle = from + (2 * k + 1) as f64 * half;
            let pair = |(x, w): &(f64, f64)| {
                w * (self.precession_rate(middle - x * half) + self.precession_rate(middle + x * half))
            };
            half * NODES.iter().map(pair).sum::<f64>()
        };
        (0..pieces as usize).map(piece).sum()
    }

    /// R, row by row: precession, nutation and spin of the body.
    pub(crate) fn attitude(&self, t: f64) -> [f64; 9] {
        let whole = (t / self.period()).floor();
        let rest = t - whole * self.period();
        let psi = (whole * self.advance).rem_euclid(TAU) + self.precession_within(rest, 0.0);
        let ([a, b, c], [w1, w2, w3]) = (self.inertia, self.spin(rest));
        let phi = (a * w1).atan2(b * w2);
        let theta = (a * w1).hypot(b * w2).atan2(c * w3);
        product(product(about_z(psi), about_x(theta)), about_z(phi))
    }
}

fn about_z(angle: f64) -> [f64; 9] {
    let (s, c) = angle.sin_cos();
    [c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0]
}

fn about_x(angle: f64) -> [f64; 9] {
    let (s, c) = angle.sin_cos();
    [1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c]
}

pub(crate) fn product(a: [f64; 9], b: [f64; 9]) -> [f64; 9] {
    std::array::from_fn(|k| (0..3).map(|i| a[3 * (k / 3) + i] * b[3 * i + k % 3]).sum())
}

pub(crate) fn transposed(a: [f64; 9]) -> [f64; 9] {
    std::array::from_fn(|k| a[3 * (k % 3) + k / 3])
}

pub(crate) fn of_quaternion([a, b, c, d]: [f64; 4]) -> [f64; 9] {
    [
        1.0 - 2.0 * (c * c + d * d),
        2.0 * (b * c - a * d),
        2.0 * (b * d + a * c),
        2.0 * (b * c + a * d),
        1.0 - 2.0 * (b * b + d * d),
        2.0 * (c * d - a * b),
        2.0 * (b * d - a * c),
        2.0 * (c * d + a * b),
        1.0 - 2.0 * (b * b + c * c),
    ]
}

fn columns<const N: usize>(run: &Run<AnyModel>, names: [&str; N]) -> Vec<[f64; N]> {
    assert_eq!(run.trajectory.failure, None);
    let table = Table::of(&run.mechanism, &run.trajectory);
    let columns = names.map(|name| table.column(name).unwrap().values.clone());
    (0..columns[0].len()).map(|k| columns.each_ref().map(|column| column[k])).collect()
}

/// The largest difference of any entry from the first, relative to the largest entry.
fn drift<const N: usize>(rows: &[[f64; N]]) -> f64 {
    let size = rows[0].iter().fold(0.0f64, |size, x| size.max(x.abs()));
    let apart = rows.iter().flat_map(|row| row.iter().zip(&rows[0]).map(|(x, first)| (x - first).abs()));
    apart.fold(0.0, f64::max) / size
}

fn furthest<const N: usize>(found: impl Iterator<Item = ([f64; N], [f64; N])>) -> f64 {
    found.flat_map(|(a, b)| std::array::from_fn::<f64, N, _>(|k| (a[k] - b[k]).abs())).fold(0.0, f64::max)
}

/// Runs a body for a hundred periods and compares: momentum and energy, angular velocity, and attitude.
fn check<M: Compiled>(mechanism: M, closed: &Closed, what: &str, attitude: impl Fn(&Run<AnyModel>) -> Vec<[f64; 9]>) {
    // The error of 1e-14 a step makes what is asked for after some tens of thousands of steps.
    let settings = Settings::adaptive(Method::Dop853, PERIODS * closed.period(), 1e-14);
    let run = run_with(mechanism, &settings).unwrap();
    let times = columns(&run, ["t"]);
    let momentum = drift(&columns(&run, ["Hx", "Hy", "Hz"]).iter().map(|h| [h[0], h[1], h[2]]).collect::<Vec<_>>());
    let energy = drift(&columns(&run, ["energy"]));
    let spins = columns(&run, ["w1", "w2", "w3"]);
    let largest = closed.amplitudes.iter().fold(0.0f64, |size, w| size.max(*w));
    let spin = furthest(spins.into_iter().zip(&times).map(|(w, [t])| (w, closed.spin(*t)))) / largest;
    let turned = furthest(attitude(&run).into_iter().zip(&times).map(|(r, [t])| (r, closed.attitude(*t))));
    println!(
        "{what:<34} {PERIODS} periods, {} steps: angular momentum {momentum:.1e}, energy {energy:.1e}, angular velocity \
         {spin:.1e}, attitude {turned:.1e}",
        run.steps.accepted
    );
    assert!(momentum < 1e-10 && energy < 1e-10, "{what}: {momentum:e} {energy:e}");
    assert!(spin < 1e-8 && turned < 1e-8, "{what}: {spin:e} {turned:e}");
}

fn by_angles(run: &Run<AnyModel>) -> Vec<[f64; 9]> {
    let angles = columns(run, ["psi", "theta", "phi"]);
    angles.into_iter().map(|[psi, theta, phi]| product(product(about_z(psi), about_x(theta)), about_z(phi))).collect()
}

fn by_quaternion(run: &Run<AnyModel>) -> Vec<[f64; 9]> {
    columns(run, ["body_q0", "body_q1", "body_q2", "body_q3"]).into_iter().map(of_quaternion).collect()
}

const INERTIA: [f64; 3] = [1.0, 2.0, 3.0];

#[test]
fn eulers_angles_follow_elliptic_functions() {
    let body = Tumbling::default();
    check(body, &Closed::new(INERTIA, body.H, body.theta0), "by Euler's angles", by_angles);
}

#[test]
fn a_quaternion_follows_elliptic_functions() {
    let body = TumblingQuaternion::default();
    check(body, &Closed::new(INERTIA, body.H, body.theta0), "by a quaternion", by_quaternion);
}

/// Within 1e-3 degrees of the separatrix the body stays for most of its period near the intermediate axis and then turns
/// over: the angular velocity about it changes its sign twice in a period.
#[test]
fn near_the_intermediate_axis_it_turns_over() {
    let theta0 = 29.999f64.to_radians();
    let closed = Closed::new(INERTIA, 6.0, theta0);
    assert!(closed.modulus > 0.999_9);
    // Not to the end of the fourth period, where it turns over once more, before or after by rounding.
    let settings = Settings::adaptive(Method::Dop853, 3.9 * closed.period(), 1e-14);
    let run = run_with(Tumbling { theta0, ..Default::default() }, &settings).unwrap();
    let (times, spins) = (columns(&run, ["t"]), columns(&run, ["w1", "w2", "w3"]));
    let apart = furthest(spins.iter().zip(&times).map(|(w, [t])| (*w, closed.spin(*t))));
    let flips = spins.windows(2).filter(|pair| pair[0][1] * pair[1][1] < 0.0).count();
    println!(
        "near the intermediate axis, k = {:.6}: {flips} turns over in 3.9 periods, off by {apart:.1e}",
        closed.modulus
    );
    assert_eq!(flips, 7);
    // An error grows by the exponential of what the linearised motion near the axis does in a period, some 1e4 here.
    assert!(apart < 1e-7, "{apart:e}");
    assert!((closed.spin(0.0)[0] - 6.0 * theta0.sin()).abs() < 1e-12 && FRAC_PI_2 > theta0);
}
