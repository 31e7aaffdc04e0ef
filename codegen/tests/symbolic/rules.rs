//! The engine's rewriting rules as a table: what is written, what it becomes, on which condition.
//!
//! Each row is checked three ways: the left side becomes the right one; both have the same value at random points of the
//! domain that the row names; and where a condition is needed, something that lacks it is left alone.

use crate::reader::read;
use crate::tree::{NAMES, Workspace};
use codegen::notation::infix;

/// One rule by an instance of it.
struct Rule {
    name: &'static str,
    /// What is written.
    left: &'static str,
    /// What it becomes.
    right: &'static str,
    /// When the rule applies, for every real value of the symbols.
    condition: &'static str,
    /// What the condition keeps as it is; empty if there is no condition.
    kept: &'static str,
    /// Where the left side is defined.
    domain: Domain,
}

/// Where x, y, z and w are drawn from.
#[derive(Clone, Copy)]
enum Domain {
    /// All real numbers, negative ones too.
    Real,
    /// Numbers above 0.
    Positive,
}
use Domain::{Positive, Real};

const fn rule(
    name: &'static str,
    [left, right]: [&'static str; 2],
    (condition, kept): (&'static str, &'static str),
    domain: Domain,
) -> Rule {
    Rule { name, left, right, condition, kept, domain }
}

const ALWAYS: (&str, &str) = ("always", "");

/// The table of `codegen/src/symbolic/mod.rs`, row by row.
const RULES: [Rule; 32] = [
    // Sums.
    rule("sums are flat", ["x + (y + z)", "x + y + z"], ALWAYS, Real),
    rule("like terms merge", ["2*x + y + 3*x/2", "7*x/2 + y"], ALWAYS, Real),
    rule("terms cancel", ["x*y + z - y*x", "z"], ALWAYS, Real),
    rule("a number distributes over a sum", ["2*(x + 3*y)", "2*x + 6*y"], ("only a number", "x*(y + z)"), Real),
    rule(
        "squares of sine and cosine fold",
        ["2*y*sin(x)^2 + 5*y*cos(x)^2", "5*y - 3*y*sin(x)^2"],
        ("equal other factors, numbers before them", "y*sin(x)^2 + z*cos(x)^2"),
        Real,
    ),
    // Products.
    rule("products are flat", ["x*(y*z)", "x*y*z"], ALWAYS, Real),
    rule("zero absorbs", ["0*x", "0"], ALWAYS, Real),
    rule("powers of one sign merge", ["x^2*x/(y*y^2)", "x^3/y^3"], ("exponents of one sign", "x^2/x"), Real),
    rule(
        "powers of opposite sign merge",
        ["exp(x)^3/exp(x)", "exp(x)^2"],
        ("the base is never zero and always finite", "(x - y)^2/(x - y)"),
        Real,
    ),
    rule("a sum gives its content away", ["y/(2*x + 4*z)", "y/(2*(x + 2*z))"], ALWAYS, Real),
    rule("equal up to content, sums merge", ["(2*x + 4)*(x + 2)", "2*(x + 2)^2"], ALWAYS, Real),
    // Powers.
    rule("a positive power of a product distributes", ["(x*y^2)^3", "x^3*y^6"], ALWAYS, Real),
    rule(
        "a negative power of a product distributes",
        ["1/(x*y)^2", "1/(x^2*y^2)"],
        ("no factor is below, unless it is never zero", "1/(x/y)"),
        Real,
    ),
    rule("the power 0 is 1", ["x^0", "1"], ALWAYS, Real),
    rule("the power 1 is its base", ["x^1", "x"], ALWAYS, Real),
    rule("fractional powers are powers of roots", ["x^(3/2)*x^(1/2)", "sqrt(x)^4"], ALWAYS, Positive),
    rule("exact roots are numbers", ["(9/4)^(3/2)*x", "27*x/8"], ("a root that is rational", "x*sqrt(2)"), Real),
    rule("powers of e are exp", ["e^(x*y)", "exp(x*y)"], ALWAYS, Real),
    // Functions.
    rule(
        "odd functions give their sign away",
        ["sin(-x) + tan(-y/9) + sinh(-z)", "-sin(x) - tan(y/9) - sinh(z)"],
        ("sin, tan, asin, atan, sinh, tanh, sign", "exp(-x)"),
        Real,
    ),
    rule(
        "even functions drop their sign",
        ["cos(y - x) + cosh(-x) + abs(-z)", "cos(x - y) + cosh(x) + abs(z)"],
        ("cos, cosh, abs", "acos(-x)"),
        Real,
    ),
    rule("sin 0", ["sin(0)*x + y", "y"], ALWAYS, Real),
    rule("cos 0, cosh 0, exp 0", ["cos(0)*x + cosh(0)*y + exp(0)*z", "x + y + z"], ALWAYS, Real),
    rule(
        "tan 0, asin 0, atan 0, sinh 0, tanh 0",
        ["tan(0) + asin(0) + atan(0) + sinh(0) + tanh(0) + x", "x"],
        ALWAYS,
        Real,
    ),
    rule("ln 1", ["ln(1)*x + y", "y"], ALWAYS, Real),
    rule("abs of a number", ["abs(-3/2)*x", "3*x/2"], ("a number", "abs(x)"), Real),
    rule("sign of a number", ["sign(-3)*x + sign(2)*y", "y - x"], ("a number", "sign(x)"), Real),
    // Numbers.
    rule("numbers are exact", ["(1/3 + 1/6)*x + 0.1*y + 0.2*y", "x/2 + 3*y/10"], ALWAYS, Real),
    rule(
        "powers of numbers are numbers",
        ["(2/3)^(-2)*x", "9*x/4"],
        ("of no more than 4,000 bits", "10^1000000*x"),
        Real,
    ),
    rule("a choice between equals is none", ["if x > 0 then y + z else z + y", "y + z"], ALWAYS, Real),
    rule(
        "a choice by a number is made",
        ["(if 2 > 0 then x else y) + (if -1/2 > 0 then y else z) + (if 0 > 0 then x else z)", "x + 2*z"],
        ("a number", "if x > 0 then y else z"),
        Real,
    ),
    rule(
        "the size of a difference does not matter",
        ["if 2*x - 4*y > 0 then x else z", "if x - 2*y > 0 then x else z"],
        ("a positive number", "if -x > 0 then y else z"),
        Real,
    ),
    rule("what is zero everywhere is 0", ["x*(y - y) + sin(z - z)", "0"], ALWAYS, Real),
];

#[test]
fn the_left_side_becomes_the_right_one() {
    for rule in RULES {
        let mut space = Workspace::new();
        let [left, right] = [rule.left, rule.right].map(|text| space.build(&read(text)));
        assert!(left == right, "{}: {} becomes {}", rule.name, rule.left, infix(&space.graph, left));
    }
}

#[test]
fn no_rule_changes_a_value() {
    let mut random = 1u64;
    for rule in RULES {
        let [left, right] = [rule.left, rule.right].map(read);
        for _ in 0..100 {
            let mut space = Workspace::new();
            let point = NAMES.map(|_| rule.domain.draw(&mut random));
            let expr = space.build(&right);
            let value = space.evaluate(expr, &point);
            // The left side as it is written, with the rounding of each of its steps.
            let agrees = space.track(&left, &point).agrees(value);
            assert_ne!(agrees, Some(false), "{} at {point:?}: {} is not {value}", rule.name, rule.left);
            assert!(agrees.is_some() || !value.is_finite(), "{} at {point:?} decides nothing", rule.name);
        }
    }
}

#[test]
fn without_its_condition_a_rule_does_nothing() {
    for rule in RULES.iter().filter(|rule| !rule.kept.is_empty()) {
        let mut space = Workspace::new();
        let kept = space.build(&read(rule.kept));
        assert_eq!(infix(&space.graph, kept), rule.kept, "{}: {}", rule.name, rule.condition);
    }
}

/// The table that a reader finds is this one.
#[test]
fn the_table_in_the_documentation_has_every_rule() {
    let text = include_str!("../../src/symbolic/mod.rs");
    let rows: Vec<&str> = text.lines().filter(|line| line.starts_with("//! | ") && line.contains('`')).collect();
    let names: Vec<&str> = rows.iter().map(|row| row.split('|').nth(1).unwrap().trim()).collect();
    assert_eq!(names, RULES.map(|rule| rule.name));
    for (row, rule) in rows.iter().zip(RULES) {
        let cells: Vec<&str> = row.split('|').skip(2).map(|cell| cell.trim().trim_matches('`')).collect();
        assert_eq!(cells[..3], [rule.left, rule.right, rule.condition], "{}", rule.name);
    }
}

impl Domain {
    fn draw(self, seed: &mut u64) -> f64 {
        // Marsaglia, Xorshift RNGs, 2003.
        *seed ^= *seed << 13;
        *seed ^= *seed >> 7;
        *seed ^= *seed << 17;
        let unit = (*seed >> 11) as f64 / (1u64 << 53) as f64;
        match self {
            Real => 6.0 * unit - 3.0,
            Positive => 3.0 * unit + 0.01,
        }
    }
}
