//! What intervals bound: values and rates at all numbers that are in them, and not much more.

use sim::{Dual, Interval, Scalar};
use tests::Random;

/// A function of one number, on numbers of any kind.
trait Of {
    fn of<S: Scalar>(&self, x: S) -> S;
}

/// Functions, with the numbers on which they have a value and are smooth.
macro_rules! functions {
    ($($name:ident: |$x:ident| $value:expr, from $from:literal to $to:literal;)*) => {
        $(
            struct $name;
            impl Of for $name {
                fn of<S: Scalar>(&self, $x: S) -> S {
                    $value
                }
            }
        )*
        #[test]
        fn functions_are_bounded() {
            $(check(&$name, stringify!($name), [$from, $to]);)*
        }
    };
}

fn number<S: Scalar>(value: f64) -> S {
    S::from_f64(value)
}

functions! {
    Sine: |x| x.sin(), from -20.0 to 20.0;
    Cosine: |x| x.cos(), from -20.0 to 20.0;
    Tangent: |x| x.tan(), from -1.5 to 1.5;
    FarTangent: |x| x.tan(), from 8.0 to 10.9;
    Arcsine: |x| x.asin(), from -0.999 to 0.999;
    Arccosine: |x| x.acos(), from -0.999 to 0.999;
    Arctangent: |x| x.atan(), from -30.0 to 30.0;
    HyperbolicSine: |x| x.sinh(), from -4.0 to 4.0;
    HyperbolicCosine: |x| x.cosh(), from -4.0 to 4.0;
    HyperbolicTangent: |x| x.tanh(), from -4.0 to 4.0;
    Exponential: |x| x.exp(), from -9.0 to 9.0;
    Logarithm: |x| x.ln(), from 0.01 to 9.0;
    Root: |x| x.sqrt(), from 0.01 to 9.0;
    Magnitude: |x| x.abs(), from -3.0 to 3.0;
    Square: |x| x.powf(number(2.0)), from -3.0 to 3.0;
    Cube: |x| x.powf(number(3.0)), from -3.0 to 3.0;
    Inverse: |x| x.powf(number(-1.0)), from -3.0 to -0.1;
    Fraction: |x| x.powf(number(0.3)), from 0.1 to 3.0;
    Power: |x| number::<S>(2.5).powf(x), from -3.0 to 3.0;
    Angle: |x| x.atan2(number::<S>(1.0) + x), from 0.1 to 3.0;
    Polynomial: |x| x * x * x - number::<S>(0.1) * x + number(0.7), from -3.0 to 3.0;
    Quotient: |x| (x - number(0.3)) / (x * x + number(1.0)), from -3.0 to 3.0;
    Larger: |x| (x - number(1.0)).choose(x, number::<S>(2.0) - x), from -3.0 to 3.0;
}

fn check(function: &impl Of, name: &str, [least, greatest]: [f64; 2]) {
    let mut random = Random(5);
    for width in [0.0, 1e-12, 1e-6, 0.01, 1.0, 100.0] {
        for _ in 0..200 {
            let from = random.between(least, greatest);
            let to = (from + width).min(greatest);
            let bounds = function.of(Dual::variable(Interval::between(from, to)));
            let mut steepest = 0.0_f64;
            for _ in 0..40 {
                let x = random.between(from, to).clamp(from, to);
                let Dual { value, derivative } = function.of(Dual::variable(x));
                assert!(bounds.value.holds(value), "{name} of {x} in {from} to {to}: {value}, {bounds:?}");
                assert!(
                    bounds.derivative.holds(derivative),
                    "{name} of {x} in {from} to {to}: {derivative}, {bounds:?}"
                );
                steepest = steepest.max(derivative.abs());
            }
            if width <= 1e-6 && !bounds.value.jumps() {
                // Each operation widens by the terms' own widths and by a rounding of numbers below 1e4.
                let most = 4.0 * (1.0 + 3.0 * steepest) * (to - from) + 1e-11;
                let found = bounds.value.greatest() - bounds.value.least();
                assert!(found <= most, "{name} in {from} to {to}: {found} for {most}");
            }
        }
    }
}

/// What has no value everywhere, or jumps.
#[test]
fn what_has_no_bounds_has_none() {
    let around_zero = Interval::between(-1.0, 4.0);
    assert_eq!(Interval::exactly(1.0) / around_zero, Interval::ALL);
    assert!(around_zero.sqrt().holds(0.0) && around_zero.sqrt().holds(2.0) && !around_zero.sqrt().holds(2.001));
    assert!(around_zero.sign().jumps() && around_zero.sign().holds(-1.0) && around_zero.sign().holds(1.0));
    assert!(around_zero.choose(Interval::exactly(5.0), Interval::exactly(7.0)).jumps());
    assert!(!(around_zero + Interval::exactly(2.0)).sign().jumps());
    assert_eq!(Interval::exactly(f64::NAN), Interval::ALL);
    assert_eq!(Interval::between(1.0, 2.0).tan().greatest(), f64::INFINITY);
    assert!(Interval::between(-1.0, 1.0).atan2(Interval::between(-2.0, -1.0)).jumps());
    // A product with what has no bounds, and a difference of the same.
    assert_eq!((Interval::ALL * Interval::exactly(0.0)).greatest(), 0.0);
    assert!((Interval::ALL - Interval::ALL).holds(1e300));
}
