//! The gyroscope in Cardan's suspension against closed forms.
//!
//! With a the turn of the outer gimbal, b the rise of the rotor's axis, w the rotor's angular velocity along it and
//! H = C w, T = (J a'^2 + E b'^2 + C w^2)/2 with J = D + B sin(b)^2 + N cos(b)^2, and V = m g l sin(b). w is constant, as
//! is K = J a' + H sin(b), and E b'' = -(N - B) sin(b) cos(b) a'^2 + H cos(b) a' - m g l cos(b).

use crate::common::{apart, column};
use models::Gyroscope;
use sim::{Method, Run, Settings};
use tests::any_model::{AnyModel, run_with};

/// Moments of inertia.
struct Moments {
    /// The rotor's, across its axis.
    a: f64,
    /// Of the outer gimbal about the vertical.
    d: f64,
    /// Of the inner gimbal about the axis of the rotor.
    b: f64,
    /// Of inner gimbal, rotor and weight about the axis of the inner gimbal.
    e: f64,
    /// The same across both axes.
    n: f64,
    /// The rotor's angular momentum along its axis.
    h: f64,
}

impl Moments {
    fn of(gyroscope: &Gyroscope) -> Moments {
        let Gyroscope { M, r, inner_mass, inner_radius, outer_mass, outer_radius, m, l, own_spin, .. } = *gyroscope;
        let inner = inner_mass * inner_radius * inner_radius;
        let a = M * r * r / 4.0;
        Moments {
            a,
            d: outer_mass * outer_radius * outer_radius / 2.0,
            b: inner / 2.0,
            e: inner / 2.0 + a + m * l * l,
            n: inner + a + m * l * l,
            h: 2.0 * a * own_spin,
        }
    }

    /// J at this rise.
    fn about_vertical(&self, rise: f64) -> f64 {
        self.d + self.b * rise.sin().powi(2) + self.n * rise.cos().powi(2)
    }
}

/// Where b'' = 0: (N - B) sin(b) p^2 - H p + m g l = 0, whatever the outer gimbal. The moment on the rotor then is p times
/// the horizontal part of its angular momentum, H along the axis and A p cos(b) across it.
#[test]
fn a_weight_lets_it_precess_steadily() {
    for rise in [-40.0f64, 0.0, 25.0, 60.0] {
        let rise0 = rise.to_radians();
        let gyroscope = Gyroscope { blow: 0.0, rise0, ..Gyroscope::default() };
        let Moments { a, b, n, h, .. } = Moments::of(&gyroscope);
        let (p2, weight) = ((n - b) * rise0.sin(), gyroscope.m * gyroscope.g * gyroscope.l);
        let rate = 2.0 * weight / (h + (h * h - 4.0 * p2 * weight).sqrt());
        let moment = rate * (h * rise0.cos() - a * rate * rise0.cos() * rise0.sin());
        let run = run_with(gyroscope, &Settings::adaptive(Method::Dop853, 5.0, 1e-13)).unwrap();
        let off = [
            apart(&run, "turn", "t", |t| rate * t),
            apart(&run, "elevation", "t", |_| rise),
            apart(&run, "moment", "t", |_| moment) / moment,
        ];
        println!("gyroscope at {rise} deg: {rate:.9} rad/s; turn, rise in deg and moment off by {off:?}");
        assert!(off.iter().all(|off| *off < 1e-9), "{off:?}");
    }
}

/// The rotor's angular velocity along its axis, and the moment of momentum about the vertical.
#[test]
fn its_integrals_are_constant_while_it_nods() {
    let gyroscope = Gyroscope::default();
    let moments = Moments::of(&gyroscope);
    let run = run_with(gyroscope, &Settings::adaptive(Method::Dop853, 5.0, 1e-12)).unwrap();
    let spin = apart(&run, "along_axis", "t", |_| gyroscope.own_spin) / gyroscope.own_spin;
    let (rises, rates) = (column(&run, "rise"), column(&run, "precession"));
    let about_vertical = |(rise, rate): (&f64, &f64)| moments.about_vertical(*rise) * rate + moments.h * rise.sin();
    let integrals: Vec<f64> = rises.iter().zip(&rates).map(about_vertical).collect();
    let drift = integrals.iter().map(|k| (k / integrals[0] - 1.0).abs()).fold(0.0, f64::max);
    let nods = rises.iter().fold(0.0f64, |most, rise| most.max((rise - gyroscope.rise0).abs()));
    println!("gyroscope nods by {nods:.3} rad: its spin is constant to {spin:.1e}, K to {drift:.1e}");
    assert!(nods > 0.05 && spin < 1e-10 && drift < 1e-10, "{spin:e} {drift:e}");
}

/// Magnus' drift: without a weight a blow b' = v on the inner gimbal lets the outer one turn on, while the axis nods.
///
/// From K = H sin(b0) follow a' = H (sin(b0) - sin(b))/J and, with x = b - b0, s and c the sine and cosine of b0 and
/// j = J'(b0)/J = -2 (N - B) s c/J, to the second order E x'' = -(H^2/J) (c^2 x - 3/2 (s c + c^2 j) x^2) and
/// a' = -(H/J) (c x - (s/2 + c j) x^2). The mean of x'' over a nutation is 0, so that of x is 3/2 (s/c + j) <x^2>, and
/// <a'> = -(H/J) (s + c j/2) <x^2> = -H s (D + B) <x^2>/J^2. As <x^2> = v^2 E J/(2 H^2 c^2), the drift is
/// -E (D + B) s v^2/(2 J H c^2). A blow of -v gives the same motion from its return to b0 on, so the next term is of
/// order v^4: the error in parts of the drift is of order v^2, and falls to a quarter with half of v.
#[test]
fn after_a_blow_it_drifts() {
    let mut errors = vec![];
    for blow in [1.6, 0.8, 0.4, 0.2] {
        let gyroscope = Gyroscope { m: 0.0, blow, ..Gyroscope::default() };
        let moments = Moments::of(&gyroscope);
        let Moments { d, b, e, h, .. } = moments;
        let (sine, cosine) = gyroscope.rise0.sin_cos();
        let j = moments.about_vertical(gyroscope.rise0);
        let drift = -e * (d + b) * sine * blow * blow / (2.0 * j * h * cosine * cosine);
        let run = run_with(gyroscope, &Settings::adaptive(Method::Dop853, 5.0, 1e-13)).unwrap();
        let found = mean_rate(&run, gyroscope.rise0);
        println!("a blow of {blow} rad/s: drift {found:.6e} rad/s, to its leading term {:.2e}", found / drift - 1.0);
        errors.push((found / drift - 1.0).abs());
    }
    let falls: Vec<f64> = errors.windows(2).map(|pair| pair[0] / pair[1]).collect();
    // The order beyond leaves a few parts of (nutation in rad)^2 of the fall, 0.05^2 at most.
    assert!(falls.iter().all(|fall| (fall - 4.0).abs() < 0.05) && errors[3] < 1e-3, "{errors:?} fall by {falls:?}");
}

/// The mean rate of the outer gimbal over whole nutations, which end where the axis is as high as it comes.
fn mean_rate(run: &Run<AnyModel>, rise0: f64) -> f64 {
    let is_highest = |state: &&sim::State<AnyModel>| state.positions[1] > rise0;
    let nutations = run.events.iter().filter(|event| event.name == "nutation").map(|event| &event.state);
    let highest: Vec<_> = nutations.filter(is_highest).collect();
    let (first, last) = (highest[0], highest[highest.len() - 1]);
    (last.positions[0] - first.positions[0]) / (last.time - first.time)
}
