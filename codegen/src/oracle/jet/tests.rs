//! Jets against dual numbers, through the interpreter: every function, at many points, with all derivatives.

use super::super::error::Result;
use super::super::interpret::Interpreter;
use super::super::measured::Measured;
use super::super::setting::Setting;
use super::super::state::State;
use super::Jet;
use num_dual::{Dual2_64, DualNum, HyperDual64, second_derivative, second_partial_derivative};

type Outcome = std::result::Result<(), Box<dyn std::error::Error>>;

/// Both sides round in at most some 40 operations, half an ulp (1.1e-16) each, and in library functions good to an ulp:
/// 1e-14 of the magnitude is more than that and less than any fault.
const ROUNDING: f64 = 1e-14;

/// The value of `text`, an expression in the coordinates x and y, the time t and the parameter a.
fn evaluate(text: &str, setting: Setting) -> std::result::Result<Result<Jet>, Box<dyn std::error::Error>> {
    let declaration = format!(
        "pub Sample; coordinates {{ x; y; }} parameters {{ a = 1; }} let r = [x, y]; outputs {{ f = {text}; }}"
    );
    let declaration = crate::parse(declaration.parse()?)?;
    let output = declaration.outputs.first().and_then(|group| group.outputs.first()).ok_or("no output")?;
    Ok(Interpreter::new(&declaration, &|_| 1.0, setting).scalar(&output.value))
}

#[track_caller]
fn assert_close(found: Measured, expected: f64, what: &str) {
    let error = (found.value - expected).abs();
    assert!(
        error <= ROUNDING * found.magnitude,
        "{what}: {} is not {expected}, magnitude {}",
        found.value,
        found.magnitude
    );
    assert!(found.magnitude >= found.value.abs(), "{what}: magnitude {} below |{}|", found.magnitude, found.value);
}

/// `count` points of (x, y, t) spread over a cube, by multiples of irrational numbers.
fn points(low: f64, high: f64, count: u32) -> impl Iterator<Item = [f64; 3]> {
    (1..=count).map(move |i| {
        [0.754_877_666, 0.569_840_291, 0.437_016_024].map(|step| low + (high - low) * (f64::from(i) * step).fract())
    })
}

type Function = fn(HyperDual64, HyperDual64, HyperDual64) -> HyperDual64;

#[rustfmt::skip]
const FUNCTIONS: &[(&str, f64, f64, Function)] = &[
    ("x + y - t*x - (-y)", -2.0, 2.0, |x, y, t| x + y - t * x + y),
    ("x*y/t", 0.3, 2.0, |x, y, t| x * y / t),
    ("x^3*y^-2 + t^1", 0.3, 2.0, |x, y, t| x.powi(3) * y.powi(-2) + t),
    ("(-x)^3 + (-y)^2 + (-t)^0", 0.3, 2.0, |x, y, _| -x.powi(3) + y.powi(2) + 1.0),
    ("x^2.5 + y^(1/3)*t^-0.5", 0.3, 2.0, |x, y, t| x.powf(2.5) + y.powf(1.0 / 3.0) * t.powf(-0.5)),
    ("(x*y)^(t + x)", 0.3, 2.0, |x, y, t| (x * y).powd(t + x)),
    ("2^x + e^(y*t) + a^y", -2.0, 2.0, |x, y, t| HyperDual64::from(2.0).powd(x) + (y * t).exp() + HyperDual64::from(1.5).powd(y)),
    ("sin(x*y)*cos(t - x)", -4.0, 4.0, |x, y, t| (x * y).sin() * (t - x).cos()),
    ("tan(x*y + t)", -0.7, 0.7, |x, y, t| (x * y + t).tan()),
    ("asin(x*y) + acos(y*t)", -0.9, 0.9, |x, y, t| (x * y).asin() + (y * t).acos()),
    ("atan(x*y*t)", -3.0, 3.0, |x, y, t| (x * y * t).atan()),
    ("sinh(x)*cosh(y) - tanh(x*t)", -2.0, 2.0, |x, y, t| x.sinh() * y.cosh() - (x * t).tanh()),
    ("exp(x*y - t)*ln(a + x*x)", -2.0, 2.0, |x, y, t| (x * y - t).exp() * (x * x + 1.5).ln()),
    ("sqrt(x + y*t)", 0.3, 2.0, |x, y, t| (x + y * t).sqrt()),
    ("abs(x*y)*t", -2.0, 2.0, |x, y, t| x * y * t * (x * y).re.signum()),
    ("sign(x)*y*t", -2.0, 2.0, |x, y, t| y * t * x.re.signum()),
    ("norm(t*r + [y, a])", -2.0, 2.0, |x, y, t| ((t * x + y).powi(2) + (t * y + 1.5).powi(2)).sqrt()),
    ("inner(r, [t, x]/y)", 0.3, 2.0, |x, y, t| (x * t + y * x) / y),
    ("r.x*[a, t].y - [-t, -r.y].y", -2.0, 2.0, |x, y, t| x * t + y),
    ("sin(cos(x*exp(y)))/(a + atan(t*x))", -1.2, 1.2, |x, y, t| (x * y.exp()).cos().sin() / ((t * x).atan() + 1.5)),
];

#[test]
fn values_gradients_and_hessians_are_those_of_dual_numbers() -> Outcome {
    for (text, low, high, function) in FUNCTIONS {
        for point in points(*low, *high, 40) {
            assert_derivatives(text, *function, point)?;
        }
    }
    Ok(())
}

/// Dual numbers divide by x, however small it is; the small angle from the direction at the point itself has no such
/// weakness.
#[test]
fn the_angle_of_a_vector_is_right_in_every_direction() -> Outcome {
    let axes = [[0.0, 1.0, 0.5], [-1.0, 0.0, 0.5], [0.0, -2.0, 0.5], [2.0, 0.0, -0.5]];
    for point in points(-2.0, 2.0, 100).chain(axes) {
        assert_derivatives("atan2(y*t, x)", |x, y, t| turned(y * t, x), point)?;
    }
    Ok(())
}

fn turned(y: HyperDual64, x: HyperDual64) -> HyperDual64 {
    let (y0, x0) = (y.re, x.re);
    ((y * x0 - x * y0) / (x * x0 + y * y0)).atan() + y0.atan2(x0)
}

fn assert_derivatives(text: &str, function: Function, point: [f64; 3]) -> Outcome {
    let jet = evaluate(text, Setting::positions(point[2], &[1.5], &point[..2], 0))??;
    for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
        let (value, slope, _, second) = along(function, point, i, j);
        assert_close(jet.value(), value, text);
        assert_close(jet.gradient()[i], slope, &format!("{text} by {i} at {point:?}"));
        assert_close(jet.second(i, j), second, &format!("{text} by {i}, {j} at {point:?}"));
    }
    Ok(())
}

/// Value, derivatives by variables i and j, and the mixed second derivative.
fn along(function: Function, point: [f64; 3], i: usize, j: usize) -> (f64, f64, f64, f64) {
    let shifted = |(a, b): (HyperDual64, HyperDual64)| {
        let mut variables = point.map(HyperDual64::from);
        variables[i] += a;
        variables[j] += b;
        function(variables[0], variables[1], variables[2])
    };
    second_partial_derivative(shifted, (0.0, 0.0))
}

const STATE: State =
    State { time: 0.4, parameters: &[1.5], inputs: &[], coordinates: &[0.7, -1.3], speeds: &[2.1, 0.6] };
const ACCELERATIONS: [f64; 2] = [-0.9, 3.2];

fn accelerated() -> Setting {
    STATE.accelerated_motion(&ACCELERATIONS.map(Measured::given))
}

/// x, y and t as functions of the time s since the state.
fn moving(s: Dual2_64) -> [Dual2_64; 3] {
    let coordinate = |i: usize| s * s * (0.5 * ACCELERATIONS[i]) + s * STATE.speeds[i] + STATE.coordinates[i];
    [coordinate(0), coordinate(1), s + STATE.time]
}

#[test]
fn time_derivatives_are_those_along_the_motion() -> Outcome {
    type Along = fn([Dual2_64; 3]) -> Dual2_64;
    let cases: [(&str, Along); 4] = [
        ("x*sin(y*t)", |[x, y, t]| x * (y * t).sin()),
        ("norm(r*t)", |[x, y, t]| ((x * t).powi(2) + (y * t).powi(2)).sqrt()),
        ("exp(x)/(1 + t*t) - a^y", |[x, y, t]| x.exp() / (t * t + 1.0) - Dual2_64::from(1.5).powd(y)),
        ("3*a", |_| Dual2_64::from(4.5)),
    ];
    for (text, function) in cases {
        let (value, first, second) = second_derivative(|s| function(moving(s)), 0.0);
        let found = |text: String| evaluate(&text, accelerated());
        assert_close(found(text.to_owned())??.value(), value, text);
        assert_close(found(format!("dot({text})"))??.value(), first, text);
        assert_close(found(format!("ddot({text})"))??.value(), second, text);
        assert_close(found(format!("dot(dot({text}))"))??.value(), second, text);
    }
    Ok(())
}

#[test]
fn derivatives_may_stand_within_derivatives() -> Outcome {
    let [x, y] = [0, 1].map(|i| [STATE.coordinates[i], STATE.speeds[i], ACCELERATIONS[i]]);
    let cases = [
        ("dot(dot(x)*y)", x[2] * y[0] + x[1] * y[1]),
        ("dot(x*dot(y*t))", x[1] * (y[1] * 0.4 + y[0]) + x[0] * (y[2] * 0.4 + 2.0 * y[1])),
        ("inner(dot(r), ddot(r))", x[1] * x[2] + y[1] * y[2]),
        ("sin(dot(x))*ddot(y)", x[1].sin() * y[2]),
        ("dot(sin(dot(r).x))", x[1].cos() * x[2]),
    ];
    for (text, expected) in cases {
        assert_close(evaluate(text, accelerated())??.value(), expected, text);
    }
    Ok(())
}

#[test]
fn a_derivative_that_is_not_known_is_refused() -> Outcome {
    let known = |text| evaluate(text, accelerated()).map(|result| result.is_ok());
    let without_accelerations = |text| evaluate(text, STATE.motion()).map(|result| result.is_ok());
    let in_position =
        |text| evaluate(text, Setting::positions(0.4, &[1.5], &[0.7, -1.3], 0)).map(|result| result.is_ok());
    assert!(known("ddot(x*y)")? && known("ddot(dot(a))")? && known("dot(x*dot(y))")?);
    assert!(!known("dot(ddot(x))")? && !known("dot(dot(x)*ddot(y))")? && !known("ddot(dot(r)).y")?);
    assert!(without_accelerations("dot(x*y)")? && without_accelerations("ddot(t^2)")?);
    assert!(!without_accelerations("ddot(x)")? && !without_accelerations("dot(t*dot(x))")?);
    assert!(in_position("x*t")? && !in_position("dot(x)")? && !in_position("dot(a)")?);
    assert!(!known("reaction(x)")? && !known("z")? && !known("cosine(x)")? && !known("r")? && !known("r*r")?);
    assert!(!known("x + r")? && !known("x/r")? && !known("x.x")? && !known("r.z")? && !known("[x, y, t, x].x")?);
    Ok(())
}

/// The base of a power with an exponent that is no integer must not be negative; integer powers take any base.
#[test]
fn outside_its_domain_a_function_is_not_a_number() -> Outcome {
    for text in ["(-a)^0.5", "(-a)^x", "sqrt(-a)", "ln(-a)", "asin(a)", "acos(a)", "(x - a)^(1/3)"] {
        assert!(evaluate(text, accelerated())??.value().value.is_nan(), "{text}");
    }
    for (text, value) in [("(-a)^2", 2.25), ("(-a)^-1", -1.0 / 1.5), ("(a - a)^0", 1.0), ("sqrt(0*a)", 0.0)] {
        assert_close(evaluate(text, accelerated())??.value(), value, text);
    }
    Ok(())
}

/// The root has no derivative at zero, but what does not vary needs none.
#[test]
fn a_constant_at_the_edge_of_a_domain_has_no_derivatives() -> Outcome {
    let jet = evaluate("x*sqrt(0*a)", Setting::positions(0.4, &[1.5], &[0.7, -1.3], 0))??;
    assert!(entries(&jet).all(|entry| entry == Measured::ZERO), "{jet:?}");
    Ok(())
}

/// If every given number is off by a relative 1e-7, no result is off by more than 1e-7 times its magnitude times the
/// number of given numbers in one term of its longest product: at most 8 in these expressions, derivatives included.
/// (Second-order effects, 1e-14 of larger magnitudes, are below that.)
#[test]
fn magnitudes_bound_what_errors_can_do() -> Outcome {
    const ERROR: f64 = 1e-7;
    for (text, low, high, _) in FUNCTIONS {
        for (n, [x, y, t]) in points(*low, *high, 16).enumerate() {
            let off = |value: f64, bit: usize| value * if n >> bit & 1 == 1 { 1.0 + ERROR } else { 1.0 - ERROR };
            let exact = evaluate(text, Setting::positions(t, &[1.5], &[x, y], 0))??;
            let wrong = evaluate(text, Setting::positions(off(t, 0), &[off(1.5, 1)], &[off(x, 2), off(y, 3)], 0))??;
            for (a, b) in entries(&exact).zip(entries(&wrong)) {
                let error = (a.value - b.value).abs();
                assert!(error <= 8.0 * ERROR * a.magnitude, "{text} at {x}, {y}, {t}: {error} of {}", a.magnitude);
            }
        }
    }
    Ok(())
}

fn entries(jet: &Jet) -> impl Iterator<Item = Measured> + '_ {
    std::iter::once(jet.value).chain(jet.gradient.iter().copied()).chain(jet.hessian.iter().copied())
}

/// Cancellation leaves a value of rounding, and the magnitude of what cancelled.
#[test]
fn magnitudes_survive_cancellation() -> Outcome {
    let jet = evaluate("(x + 1000) - (x + 1000)", Setting::positions(0.4, &[1.5], &[0.7, -1.3], 0))??;
    assert_eq!(jet.value(), Measured { value: 0.0, magnitude: 2001.4 });
    let jet = evaluate("sin(x + 1000*pi) - sin(x)", Setting::positions(0.4, &[1.5], &[0.7, -1.3], 0))??;
    assert!(jet.value().value != 0.0, "rounding of 1000 pi is expected to show");
    assert_close(jet.value(), 0.0, "sin(x + 1000 pi) - sin(x)");
    Ok(())
}

/// A component of a vector that so many rotations turn, these in turn.
fn turned_by(rotations: &[&str], count: usize) -> String {
    let chain: Vec<&str> = rotations.iter().copied().cycle().take(count).collect();
    format!("inner([0.3, 0.4, 0.5], {}*[0.1, -0.2, 0.3])", chain.join("*"))
}

/// Along a chain of rotations errors of the angles add up, so magnitudes may grow no faster than the number of joints;
/// with each derivative, which is a sum over all of them, by that number once more. They still bound what errors do:
/// all of it shows where the axes are the same.
#[test]
fn magnitudes_of_a_chain_of_rotations_grow_with_its_joints() -> Outcome {
    const ERROR: f64 = 1e-7;
    for rotations in [
        &["rotation([1, 0, 0], x)", "rotation([0.6, 0, 0.8], y)", "rotation([0, 1, 0], t)"][..],
        &["rotation([0.6, 0, 0.8], x)"],
    ] {
        let at = |joints: usize, error: f64| {
            let of = |x: f64| x * (1.0 + error);
            evaluate(&turned_by(rotations, joints), Setting::positions(of(0.9), &[1.5], &[of(0.7), of(-1.3)], 0))
        };
        let (short, long) = (at(12, 0.0)??, at(48, 0.0)??);
        for (k, (a, b)) in entries(&short).zip(entries(&long)).enumerate() {
            let derivative = [0, 1, 1, 1].get(k).copied().unwrap_or(2);
            assert!(b.magnitude <= 1.5 * 4f64.powi(derivative + 1) * a.magnitude, "entry {k}: {a:?}, {b:?}");
        }
        for (k, (a, b)) in entries(&long).zip(entries(&at(48, ERROR)??)).enumerate() {
            let error = (a.value - b.value).abs();
            assert!(error <= 2.0 * ERROR * a.magnitude, "entry {k}: {error} of {}", a.magnitude);
        }
    }
    Ok(())
}

/// Where both factors cancel, a product that is multiplied out differs by rounding of their terms: within 1e-12 of the
/// magnitude, which is what the comparison with kernels allows.
#[test]
fn magnitudes_of_products_cover_those_multiplied_out() -> Outcome {
    const ZERO: &str = "(x/3 + y/7 - (7*x + 3*y)/21)";
    const OUT: &str = "(x/3)^2 + (y/7)^2 + ((7*x + 3*y)/21)^2 + 2*x*y/21 - 2*(x/3 + y/7)*(7*x + 3*y)/21";
    let mut shown = 0;
    for [x, y, t] in points(0.5, 2.0, 32) {
        let at = || Setting::positions(t, &[1.5], &[x, y], 0);
        let product = evaluate(&format!("{ZERO}*{ZERO}"), at())??.value();
        let apart = (product.value - evaluate(OUT, at())??.value().value).abs();
        assert!(apart <= 1e-12 * product.magnitude, "{apart} of {}", product.magnitude);
        shown += usize::from(apart > f64::EPSILON * product.value.abs());
    }
    assert!(shown > 8, "rounding is expected to show");
    Ok(())
}
