//! Single cases, each with what it is there for.

use crate::reader::read;
use crate::tree::{Point, Workspace};
use codegen::notation::infix;
use codegen::symbolic::{Differential, Number, Recognition};

/// What the engine makes of a text, as text.
fn canonical(text: &str) -> String {
    let mut space = Workspace::new();
    let expr = space.build(&read(text));
    infix(&space.graph, expr)
}

fn value(text: &str, point: &Point) -> f64 {
    let mut space = Workspace::new();
    let expr = space.build(&read(text));
    space.evaluate(expr, point)
}

fn derivative(text: &str) -> String {
    let mut space = Workspace::new();
    let expr = space.build(&read(text));
    let derivative = Differential::partial(&mut space.graph, space.symbols[0]).of(&mut space.graph, expr);
    infix(&space.graph, derivative)
}

/// A text in which another one has been replaced by `z`.
fn recognised(text: &str, known: &str) -> String {
    let mut space = Workspace::new();
    let [expr, known, new] = [text, known, "z"].map(|text| space.build(&read(text)));
    let replaced = Recognition::of([(known, new)]).replace(&mut space.graph, expr);
    infix(&space.graph, replaced)
}

#[test]
fn known_expressions_are_recognised() {
    for (text, known, expected) in [
        ("sin(x + y)", "x + y", "sin(z)"),
        ("3*x + 3*y + x^2", "x + y", "x^2 + 3*z"),
        ("1 - 2*x - 2*y", "x + y + 1", "3 - 2*z"),
        ("3*x + 2*y", "x + y", "3*x + 2*y"),
        ("6*x*y*cos(x)", "2*x*y", "3*z*cos(x)"),
        ("x^2*y^2", "x*y", "z^2"),
        ("y/x^3", "2*y/x", "z/(2*x^2)"),
        ("x^3/y", "x*y", "x^3/y"),
        ("cos(x)*sin(5*x + 5*y)", "x + y", "cos(x)*sin(5*z)"),
    ] {
        assert_eq!(recognised(text, known), expected, "{known} in {text}");
    }
}

fn expect_forms(cases: &[(&str, &str, &str)]) {
    for (intent, text, expected) in cases {
        assert_eq!(canonical(text), *expected, "{intent}: {text}");
    }
}

#[test]
fn powers_merge_where_no_value_changes() {
    expect_forms(&[
        ("exponents of one sign", "x^2*x/(x*x^3)", "x^3/x^4"),
        ("x may be zero", "x^2*x^(-1)", "x^2/x"),
        ("so may x - y", "(x - y)/(x - y)", "(x - y)/(x - y)"),
        ("exp is never zero", "exp(x)^2*exp(x)^(-1)", "exp(x)"),
        ("neither is x^2 + 1", "(x^2 + 1)^2/(x^2 + 1)", "x^2 + 1"),
        ("nor its root", "sqrt(x^2 + 1)/sqrt(x^2 + 1)^2", "1/sqrt(x^2 + 1)"),
        ("nor e^x, which is exp(x)", "e^x/exp(x)", "1"),
        ("1/x^2 + 1 is infinite at 0", "(1/x^2 + 1)/(1/x^2 + 1)", "(1/x^2 + 1)/(1/x^2 + 1)"),
        ("and exp of it as well", "exp(1/x)/exp(1/x)", "exp(1/x)/exp(1/x)"),
        ("sqrt(x) + 1 is undefined below 0", "(sqrt(x) + 1)/(sqrt(x) + 1)", "(sqrt(x) + 1)/(sqrt(x) + 1)"),
        ("(-1)^1 + 1 is zero", "(x^y + 1)/(x^y + 1)", "(x^y + 1)/(x^y + 1)"),
        ("a positive base has positive powers", "(exp(x)^y + 1)/(exp(x)^y + 1)", "1"),
        ("the zeroth power is 1, as in floating point", "(1/x)^0", "1"),
        ("numbers leave sums", "(3*x + 6)/(2*x + 4)", "3*(x + 2)/(2*(x + 2))"),
    ]);
}

#[test]
fn roots_keep_their_domain() {
    expect_forms(&[
        ("a square of a root is undefined below 0", "sqrt(x)^2", "sqrt(x)^2"),
        ("a root of a square is not", "(x^2)^(1/2)", "sqrt(x^2)"),
        ("fractions are powers of roots", "x^(-3/2)", "1/x^(3/2)"),
        ("of any degree", "x^(2/3)", "x^(2/3)"),
        ("exact where they can be", "8^(-1/3)*(4/9)^(1/2)", "1/3"),
        ("atoms where they cannot", "2^(1/2)*2^(1/2)", "sqrt(2)^2"),
        ("odd roots of negative numbers are not real", "(-8)^(1/3)", "(-8)^(1/3)"),
    ]);
}

#[test]
fn functions_take_out_signs() {
    expect_forms(&[
        ("odd", "sin(-x)", "-sin(x)"),
        ("even", "cos(-x)", "cos(x)"),
        ("odd, of a difference", "tan(-(x - y))", "-tan(x - y)"),
        ("both orders of a difference", "tan(x - y) + tan(y - x)", "0"),
        ("odd, of a quotient", "sign(-x/y)", "-sign(x/y)"),
        ("odd, of a number", "atan(-1/2)", "-atan(1/2)"),
        ("neither", "acos(-x) + exp(-x)", "acos(-x) + exp(-x)"),
    ]);
}

#[test]
fn sums_cancel() {
    expect_forms(&[
        ("a number enters a sum", "x - (x + y)", "-y"),
        ("a sum has one sign", "(x - y)*z + (y - x)*z", "0"),
        ("distribution", "2*(x + y) - 2*x - 2*y", "0"),
        ("no other factor does", "x*(y + z)", "x*(y + z)"),
        ("decimals are exact", "0.2", "0.2"),
        ("and written as they were, but not halves and quarters", "9.81*x + 0.25*y", "9.81*x + y/4"),
        ("and add up", "0.1 + 0.2 - 0.3", "0"),
    ]);
}

#[test]
fn squares_of_sine_and_cosine_fold() {
    expect_forms(&[
        ("alone", "sin(x)^2 + cos(x)^2", "1"),
        ("signs do not matter", "sin(-x)^2 + cos(x)^2", "1"),
        ("one coefficient", "3*sin(x)^2 + 3*cos(x)^2", "3"),
        ("two coefficients", "2*sin(x)^2 + 5*cos(x)^2", "5 - 3*sin(x)^2"),
        ("a difference", "1 - sin(x)^2 - cos(x)^2", "0"),
        ("a common factor", "y/z*sin(x)^2 + cos(x)^2*y/z", "y/z"),
        ("a common sum", "(x + y)*sin(z)^2 + (x + y)*cos(z)^2", "x + y"),
        ("a common square of the cosine", "sin(x)^2*cos(x)^2 + cos(x)^4", "cos(x)^2"),
        ("a common square of another sine", "sin(x)^2*sin(y)^2 + cos(x)^2*sin(y)^2", "sin(y)^2"),
        ("in either order", "sin(x)^2*sin(y)^2 + sin(x)^2*cos(y)^2", "sin(x)^2"),
        ("spherical coordinates", "(sin(x)*cos(y))^2 + (sin(x)*sin(y))^2 + cos(x)^2", "1"),
        ("different angles do not", "sin(x)^2 + cos(y)^2", "sin(x)^2 + cos(y)^2"),
        ("nor different factors", "x*sin(z)^2 + y*cos(z)^2", "x*sin(z)^2 + y*cos(z)^2"),
    ]);
}

#[test]
fn a_sine_takes_one_cosine() {
    let mut space = Workspace::new();
    let terms = ["sin(x)^2*sin(y)^2", "cos(x)^2*sin(y)^2", "sin(x)^2*cos(y)^2"].map(|text| space.build(&read(text)));
    let sum = space.graph.sum(&terms);
    assert_eq!(infix(&space.graph, sum), "sin(y)^2 + sin(x)^2*cos(y)^2");
}

#[test]
fn huge_powers_stay_unevaluated() {
    expect_forms(&[
        ("a number", "10^1000000", "10^1000000"),
        ("its inverse", "10^1000000*10^(-1000000)", "1"),
        ("what is left of it", "3*10^1000000/10^999999 - 30", "0"),
        ("of an inverse", "5*(2*exp(x))^5000*y/(2*exp(x))^4999", "10*y*exp(x)"),
        ("a sum", "(2*x + 2*y)^1000000", "(2*x + 2*y)^1000000"),
        ("units", "(-1)^1000001*1^10000000000*0^0", "-1"),
        ("zero", "0^10000000000", "0"),
        ("the largest exponent", "x^9223372036854775807*x", "x^9223372036854775807*x"),
        ("the smallest exponent", "x^(-9223372036854775807)/x", "1/x^9223372036854775808"),
        ("a root of a huge degree", "2^(1/4000000000)", "2^(1/4000000000)"),
        ("an exponent beyond all of these", "2^(10^30)", "2^1000000000000000000000000000000"),
    ]);
    let power = value("10^1000000", &[0.0; 4]);
    assert_eq!((power, value("10^(-1000000)", &[0.0; 4])), (f64::INFINITY, 0.0));
}

#[test]
fn notation_has_the_parentheses_it_needs_and_no_others() {
    expect_forms(&[
        ("a sign outside of a power", "-x^2", "-x^2"),
        ("a sign inside of a power", "(-x)^y", "(-x)^y"),
        ("powers of powers", "(x^y)^z", "(x^y)^z"),
        ("powers in exponents", "x^(y^z)", "x^(y^z)"),
        ("products in exponents", "x^(-y)*x^(2*y)", "x^(-y)*x^(2*y)"),
        ("fractions in powers", "(1/2)^x*(-2)^y", "(1/2)^x*(-2)^y"),
        ("one factor below", "x*y/z^2", "x*y/z^2"),
        ("two factors below", "x/y/z", "x/(y*z)"),
        ("sums above and below", "(x - y)*z/(z + w)", "z*(x - y)/(z + w)"),
        ("fractions as factors", "2*x/3", "2*x/3"),
        ("differences of sums", "x - (y*z - w)/2", "x - y*z/2 + w/2"),
        ("arguments", "atan2(-x, y + 1)", "atan2(-x, y + 1)"),
        ("irrational constants", "pi*e^2", "pi*e^2"),
    ]);
}

#[test]
fn values_at_the_edges() {
    let cases = [
        ("division by the number 0", "0^(-1)", 0.0, f64::INFINITY),
        ("in a product", "y/(x - x)", 0.0, f64::INFINITY),
        ("0*x is 0", "0*(1/x)", 0.0, 0.0),
        ("x - x is 0", "1/x - 1/x", 0.0, 0.0),
        ("x/x is undefined at 0", "x/x", 0.0, f64::NAN),
        ("x^2/x as well", "x^2/x", 0.0, f64::NAN),
        ("a root of a square is an absolute value", "(x^2)^(1/2)", -3.0, 3.0),
        ("a square of a root has its domain", "sqrt(x)^2", -3.0, f64::NAN),
        ("odd roots have none below 0", "x^(1/3)", -8.0, f64::NAN),
        ("integers as symbolic exponents", "x^w", -2.0, -8.0),
        ("outside of a domain", "asin(x)", 2.0, f64::NAN),
        ("at the edge of one", "ln(x)", 0.0, -f64::INFINITY),
        ("poles become zeros", "1/(1/x)", 0.0, 0.0),
        ("the sign of 0", "sign(x)", 0.0, 0.0),
    ];
    for (intent, text, x, expected) in cases {
        let result = value(text, &[x, 1.0, 2.0, 3.0]);
        // The same operations in the same order: nothing to round.
        assert!(result == expected || result.is_nan() && expected.is_nan(), "{intent}: {text} = {result}");
    }
}

#[test]
fn derivatives_in_closed_form() {
    let cases = [
        ("x^3", "3*x^2"),
        ("x^3/x", "3*x^2/x - x^3/x^2"),
        ("x^1000000", "1000000*x^999999"),
        ("x^(-9223372036854775807)/x", "-9223372036854775808/(x^9223372036854775808*x)"),
        ("x^y", "y*x^(y - 1)"),
        ("y^x", "y^x*ln(y)"),
        ("sqrt(x)", "sqrt(x)/(2*x)"),
        ("ln(x)", "1/x"),
        ("exp(2*x)", "2*exp(2*x)"),
        ("abs(x)", "sign(x)"),
        ("sign(x)", "0"),
        ("tan(x)", "tan(x)^2 + 1"),
        ("acos(x)", "-1/sqrt(1 - x^2)"),
        ("atan2(y, x)", "-y/(x^2 + y^2)"),
        ("sin(y)*exp(z)", "0"),
    ];
    for (text, expected) in cases {
        assert_eq!(derivative(text), expected, "{text}");
    }
}

#[test]
fn decimals_become_fractions() {
    assert_eq!(Number::parse_decimal("0.2"), Number::fraction(1, 5));
    assert_eq!(Number::parse_decimal("12.5e-1"), Number::fraction(5, 4));
}

/// What multiplying out makes of a text, if anything.
fn expanded(text: &str, limit: usize) -> Option<String> {
    let mut space = Workspace::new();
    let expr = space.build(&read(text));
    space.graph.expand(expr, limit).map(|expr| infix(&space.graph, expr))
}

#[test]
fn products_are_multiplied_out_where_terms_cancel() {
    let cases = [
        ("constants and weights count", "(2*x + 1)*(3*y + 2) - 6*x*y", "4*x + 3*y + 2"),
        ("so does what stands before the sum", "5*x*(y - 2) - 5*x*y", "-10*x"),
        ("all may go", "(x + y)*z - x*z - y*z", "0"),
        ("a divisor stays", "(x + y)*z/w - x*z/w", "y*z/w"),
        (
            "a sum that is left over counts by its terms",
            "(x + 1)*(y + z + w + sin(x)) - x*y",
            "y + z + w + sin(x) + x*z + x*w + x*sin(x)",
        ),
    ];
    for (intent, text, expected) in cases {
        assert_eq!(expanded(text, 16).as_deref(), Some(expected), "{intent}: {text}");
    }
}

#[test]
fn products_stay_where_nothing_is_gained() {
    let cases = [
        ("no terms cancel", "(x + 1)*(y + 2) - z"),
        ("a square keeps its digits", "(x - y)^2 - x^2 - x"),
        ("there is no sum", "(x + 1)*y"),
    ];
    for (intent, text) in cases {
        assert_eq!(expanded(text, 16), None, "{intent}: {text}");
    }
    let five = "(x + 1)*(y + 2) - x*y";
    assert!(expanded(five, 5).is_some());
    assert_eq!(expanded(five, 4), None);
}
