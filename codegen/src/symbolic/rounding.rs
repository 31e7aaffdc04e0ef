//! Numeric evaluation with a bound of its rounding error.

use super::evaluate::{apply_function, integer_power};
use super::{Expr, Graph, Node, Symbol};
use rustc_hash::FxHashMap;

/// The relative error of an operation; functions of system libraries are more accurate than this.
const UNIT: f64 = 2.0 * f64::EPSILON;

/// An error bound above this fraction of the size says nothing: the value consists of rounding residue.
const KNOWN: f64 = 1e-6;

/// A value, and its possible error.
#[derive(Clone, Copy, Debug)]
pub struct Rounded {
    /// The value, as [`evaluate`](super::evaluate()) has it.
    pub value: f64,
    /// A bound of its rounding error, to first order: running error analysis (Higham, Accuracy and Stability of
    /// Numerical Algorithms, 2002, section 3.3). Infinite or NaN where nothing is known.
    pub error: f64,
    /// The size of its sums and products if nothing in them cancelled.
    size: f64,
}

impl Rounded {
    /// A result whose arguments are exact.
    fn new(value: f64) -> Rounded {
        Rounded { value, error: UNIT * value.abs(), size: value.abs() }
    }

    /// Whether rounding is small relative to the value's terms.
    pub fn is_known(&self) -> bool {
        self.error <= KNOWN * self.size && self.size.is_finite()
    }

    /// A function of a number with a known error.
    fn through(self, f: impl Fn(f64) -> f64) -> Rounded {
        let value = f(self.value);
        let moved = |by: f64| (f(self.value + by) - value).abs();
        Rounded { error: moved(self.error).max(moved(-self.error)) + UNIT * value.abs(), ..Rounded::new(value) }
    }

    /// A function of two.
    fn through_both(self, other: Rounded, f: impl Fn(f64, f64) -> f64) -> Rounded {
        let by_first = self.through(|x| f(x, other.value));
        let by_second = other.through(|y| f(self.value, y));
        Rounded { error: by_first.error + by_second.error, ..by_first }
    }
}

/// The value of an expression where `value` gives each symbol's.
pub fn evaluate_with_rounding(graph: &Graph, root: Expr, value: impl Fn(Symbol) -> f64) -> Rounded {
    let mut done: FxHashMap<Expr, Rounded> = FxHashMap::default();
    for expr in graph.reachable(&[root]) {
        let result = match graph.node(expr) {
            Node::Number(number) => Rounded::new(number.to_f64()),
            Node::Constant(constant) => Rounded::new(constant.to_f64()),
            Node::Symbol(symbol) => Rounded { error: 0.0, ..Rounded::new(value(*symbol)) },
            Node::Sum { constant, terms } => {
                sum(constant.to_f64(), terms.iter().map(|(term, c)| (c.to_f64(), done[term])))
            }
            Node::Product { coefficient, factors } => {
                product(coefficient.to_f64(), factors.iter().map(|(base, e)| (done[base], *e)))
            }
            Node::Power { base, exponent } => done[base].through_both(done[exponent], f64::powf),
            Node::Call(function, argument) => done[argument].through(|x| apply_function(*function, x)),
            Node::Table(table, order, argument) => {
                done[argument].through(|x| graph.table(*table).derivative(*order, x))
            }
            Node::Atan2(y, x) => done[y].through_both(done[x], f64::atan2),
            Node::Choice(difference, above, otherwise) => chosen(done[difference], done[above], done[otherwise]),
        };
        done.insert(expr, result);
    }
    done[&root]
}

fn sum(constant: f64, terms: impl Iterator<Item = (f64, Rounded)>) -> Rounded {
    terms.fold(Rounded::new(constant), |sum, (coefficient, term)| {
        let value = sum.value + coefficient * term.value;
        let rounded = UNIT * ((coefficient * term.value).abs() + value.abs());
        Rounded {
            value,
            error: sum.error + (coefficient * term.error).abs() + rounded,
            size: sum.size + coefficient.abs() * term.size,
        }
    })
}

fn product(coefficient: f64, factors: impl Iterator<Item = (Rounded, i64)>) -> Rounded {
    let (mut value, mut size) = (coefficient, coefficient.abs());
    // The largest that it may be.
    let mut most = coefficient.abs() * (1.0 + UNIT);
    for (base, exponent) in factors {
        let by = if exponent > 0 { base.error } else { -base.error };
        value *= integer_power(base.value, exponent);
        // Divisors count with their value.
        size *= integer_power(if exponent > 0 { base.size } else { base.value.abs() }, exponent);
        let farthest = (base.value.abs() + by).max(0.0);
        most *= integer_power(farthest, exponent) * (1.0 + UNIT * exponent.unsigned_abs() as f64);
    }
    Rounded { value, error: most - value.abs() + UNIT * value.abs(), size }
}

fn chosen(difference: Rounded, above: Rounded, otherwise: Rounded) -> Rounded {
    match difference.value {
        value if !(value.abs() > difference.error) => Rounded::new(f64::NAN),
        value if value > 0.0 => above,
        _ => otherwise,
    }
}
