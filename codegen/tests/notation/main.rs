//! Equations in every notation, read back by readers that share nothing with the writers, against the graph's own
//! values at random points.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod infix;
mod latex;
mod letters;
mod lines;
mod mathml;
mod system;
mod tables;

use codegen::dynamics::EquationsOfMotion;
use codegen::notation::{Notation, Section, equations};
use codegen::symbolic::{Expr, evaluate};
use std::collections::HashMap;

/// Explicit time, products of sums, lets of every kind, a constraint with a root, and names of all shapes.
const CART: &str = "
    Cart;
    coordinates { x [m]; theta_2 [rad]; b [rad]; }
    parameters { M [kg] = 3; m [kg] = 1; n [kg] = 0.5; l1 [m] = 0.8; BC [m] = 0.6; J [kg*m^2] = 0.05; g [m/s^2] = 9.81; w [1/s] = 2; }
    let O = [x, 0.1 [m]*sin(w*t)];
    let A = O + l1*[sin(theta_2), -cos(theta_2)];
    let B = A + BC*[sin(b), -cos(b)];
    bodies { cart: mass M at O; first: mass m at A, inertia J, angle theta_2; second: mass n at B, inertia J*BC/l1, angle b - theta_2/3; }
    loads { gravity [0.1 [m/s^3]*t, -g]; force [-2 [N/m]*x - 1 [kg/m]*dot(x)*abs(dot(x)), 0] at O; torque -0.1 [N*m*s]*dot(b - theta_2) on second; }
    constraints { leash: norm(B - [0.2 [m], 0.3 [m]*cos(w*t)]) = 1.1 [m] + 0.05 [m]*sin(3 [rad/s]*t); }
";

/// Every function of the language, and powers of every kind.
const FUNCTIONS: &str = "
    Functions;
    coordinates { x; y; }
    parameters { m = 1; p = 1.7; }
    let u = sin(x)*cos(y) + tan(x/4) + asin(x/9) + acos(y/9) + atan(x*y) + atan2(y, x + 5);
    let v = sqrt(x^2 + y^2 + 1) + exp(-x^2) + ln(x^2 + 3) + abs(x - 2*y) + sinh(x/3) + cosh(y/3) + tanh(x);
    let w = (x^2 + 1)^p + (y^2 + 2)^(1/3) + (x^2 + y^2 + 1)^(-3/2) + (y^2 + 1)^-2 + p^(x/5) + pi*e*x^5/p + 3*2^x;
    bodies { point: mass m at [x + u/20, y + v/30]; }
    loads { force [w, u*v] at [x, y]; force [y, x]/(1 + x^2) at [v, x]; force [exp(x)^2*y, sin(x + y)^3 + abs(x)^3] at [w/100, x]; }
";

fn derived(declaration: &str) -> EquationsOfMotion {
    codegen::equations(declaration.parse().unwrap()).unwrap()
}

/// A shipped model: the macro's tokens out of its file.
fn model(file: &str) -> EquationsOfMotion {
    let path = format!("{}/../models/src/{file}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let tokens = syn::parse_file(&text).unwrap().items.into_iter().find_map(|item| match item {
        syn::Item::Macro(item) => Some(item.mac.tokens),
        _ => None,
    });
    codegen::equations(tokens.unwrap()).unwrap()
}

/// The equations of a written part: scalars by name, matrices by name, as the text of their entries.
#[derive(Default)]
struct Written {
    scalars: HashMap<String, String>,
    matrices: HashMap<String, Vec<Vec<String>>>,
}

/// The values of names.
type Names<'a> = &'a dyn Fn(&str) -> f64;

/// How a notation is read.
struct Reader {
    notation: Notation,
    /// Adds the equations of a part.
    split: fn(&str, &mut Written),
    /// The value of an expression's text, where names have values.
    value: fn(&str, Names) -> f64,
    /// A symbol of the graph as this notation writes it.
    name: fn(&str) -> String,
    /// The matrices by part.
    matrix: fn(&str) -> &'static str,
}

/// Every entry of every part, read back, is the value of the graph.
fn check(reader: &Reader, equations_of_motion: &EquationsOfMotion) {
    let parts = equations(equations_of_motion, reader.notation);
    let mut written = Written::default();
    parts.iter().filter(|part| part.name != "system").for_each(|part| (reader.split)(&part.text, &mut written));
    let graph = &equations_of_motion.graph;
    let mut seed = 1;
    for _ in 0..5 {
        let roots: Vec<Expr> = matrices(equations_of_motion).into_iter().flat_map(|(_, rows)| rows.concat()).collect();
        let symbols = graph.symbols_of(&roots);
        let values: Vec<f64> = symbols.iter().map(|_| random(&mut seed)).collect();
        let value_of = |symbol| values[symbols.iter().position(|s| *s == symbol).unwrap()];
        let by_name: HashMap<String, f64> =
            symbols.iter().map(|s| ((reader.name)(graph.symbol_name(*s)), value_of(*s))).collect();
        for (part, rows) in matrices(equations_of_motion) {
            if rows.is_empty() {
                assert!(parts.iter().all(|other| other.name != part), "{part}");
                continue;
            }
            let read = written.matrices.get((reader.matrix)(part)).unwrap_or_else(|| panic!("no {part}"));
            assert_eq!((read.len(), read[0].len()), (rows.len(), rows[0].len()), "{part}");
            for (text, expr) in read.iter().flatten().zip(rows.concat()) {
                let read = value(reader, &written, &by_name, text);
                let expected = evaluate(graph, &[expr], value_of)[0];
                // At most a few dozen terms of size 10, in another order; a wrong sign or letter costs 1e-3 at least.
                assert!((read - expected).abs() <= 1e-11 * (1.0 + expected.abs()), "{part}: {text}: {read} {expected}");
            }
        }
    }
}

fn value(reader: &Reader, written: &Written, by_name: &HashMap<String, f64>, text: &str) -> f64 {
    (reader.value)(text, &|name| match (by_name.get(name), written.scalars.get(name)) {
        (Some(value), None) => *value,
        (None, Some(definition)) => value(reader, written, by_name, definition),
        (Some(_), Some(_)) => panic!("{name} has two meanings"),
        (None, None) => panic!("{name} is unknown in {text}"),
    })
}

fn matrices(equations: &EquationsOfMotion) -> Vec<(&'static str, Vec<Vec<Expr>>)> {
    let EquationsOfMotion { tmt, constraints, .. } = equations;
    let column = |entries: &[Expr]| entries.chunks(1).map(<[Expr]>::to_vec).collect();
    vec![
        ("mass_matrix", tmt.mass_matrix.clone()),
        ("convective_forces", column(&tmt.convective_forces)),
        ("generalized_forces", column(&tmt.generalized_forces)),
        ("constraints", column(&constraints.values)),
        ("constraint_jacobian", constraints.jacobian.clone()),
        ("constraint_convective", column(&constraints.convective)),
    ]
}

/// Between 0.3 and 1.3 (Marsaglia, Xorshift RNGs, 2003).
fn random(seed: &mut u64) -> f64 {
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    0.3 + (*seed >> 11) as f64 / (1u64 << 53) as f64
}

/// One part of a declaration in one notation.
fn part(declaration: &str, notation: Notation, name: &str) -> String {
    let parts = codegen::equations_as(notation, declaration).unwrap();
    parts.into_iter().find(|part: &Section| part.name == name).unwrap().text
}

fn every_model() -> Vec<EquationsOfMotion> {
    let mut all: Vec<_> = ["quick_return.rs", "quick_return_ratio.rs", "andrews.rs"].map(model).into();
    all.extend([CART, FUNCTIONS].map(derived));
    all
}
