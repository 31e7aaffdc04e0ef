//! The equations of motion in 71 digits, as they are derived for readers: mass matrix and constraint Jacobian are formed, and the
//! system is solved by Gauss's elimination. Nothing of the kernels' forms occurs in it.

use ::f256::{consts, f256};
use codegen::dynamics::EquationsOfMotion;
use codegen::symbolic::{Constant, Expr, Function, Node, Number, Symbol};
use std::collections::HashMap;

/// One expression, of those before it.
enum Step {
    Known(f256),
    Input(usize),
    Sum(f256, Vec<(usize, f256)>),
    Product(f256, Vec<(usize, i64)>),
    Power(usize, usize),
    Call(Function, usize),
    Atan2(usize, usize),
    Choice([usize; 3]),
}

/// The entries of the system, to be evaluated at many states.
pub(super) struct Exact {
    steps: Vec<Step>,
    /// M and C_q row after row, then Q - h and C'' without accelerations.
    entries: Vec<usize>,
    /// n and m.
    sizes: [usize; 2],
}

impl Exact {
    /// None where tables or constraints that events switch occur.
    pub(super) fn of(equations: &EquationsOfMotion) -> Option<Exact> {
        let EquationsOfMotion { model, graph, tmt, constraints, .. } = equations;
        if !model.conditionals.is_empty() {
            return None;
        }
        let rows = tmt.mass_matrix.iter().chain(&constraints.jacobian).flatten();
        let roots: Vec<Expr> = rows.chain(&tmt.right_hand_side).chain(&constraints.convective).copied().collect();
        let symbols = model.parameters.iter().map(|parameter| parameter.symbol);
        let symbols = symbols.chain(model.coordinates.iter().flat_map(|c| [c.position, c.speed])).chain([model.time]);
        let courses: Vec<Expr> = model.inputs.iter().map(|input| input.course).collect();
        let courses_of: HashMap<Symbol, Expr> = model.inputs.iter().map(|input| (input.symbol, input.course)).collect();
        let inputs: HashMap<Symbol, usize> = symbols.enumerate().map(|(at, symbol)| (symbol, at)).collect();
        let mut places: HashMap<Expr, usize> = HashMap::new();
        let mut steps = Vec::new();
        // Courses do not depend on inputs, and what stands in both is written twice.
        for expr in graph.reachable(&courses).into_iter().chain(graph.reachable(&roots)) {
            let place = |expr: &Expr| places[expr];
            steps.push(match graph.node(expr) {
                Node::Number(number) => Step::Known(exact(number)),
                Node::Constant(Constant::Pi) => Step::Known(consts::PI),
                Node::Constant(Constant::E) => Step::Known(f256::from(1.0).exp()),
                Node::Symbol(symbol) => match courses_of.get(symbol) {
                    Some(course) => Step::Sum(f256::from(0.0), vec![(place(course), f256::from(1.0))]),
                    None => Step::Input(*inputs.get(symbol)?),
                },
                Node::Sum { constant, terms } => Step::Sum(
                    exact(constant),
                    terms.iter().map(|(term, factor)| (place(term), exact(factor))).collect(),
                ),
                Node::Product { coefficient, factors } => {
                    Step::Product(exact(coefficient), factors.iter().map(|(base, e)| (place(base), *e)).collect())
                }
                Node::Power { base, exponent } => Step::Power(place(base), place(exponent)),
                Node::Call(function, argument) => Step::Call(*function, place(argument)),
                Node::Atan2(y, x) => Step::Atan2(place(y), place(x)),
                Node::Choice(difference, above, otherwise) => Step::Choice([difference, above, otherwise].map(place)),
                Node::Table(..) => return None,
            });
            places.insert(expr, steps.len() - 1);
        }
        let entries = roots.iter().map(|root| places[root]).collect();
        Some(Exact { steps, entries, sizes: [model.coordinates.len(), model.constraints.len()] })
    }

    /// q'' and then lambda at t = 0; none where the system is singular.
    pub(super) fn motion(&self, parameters: &[f64], [q, qd]: [&[f64]; 2]) -> Option<Vec<f256>> {
        let states = q.iter().zip(qd).flat_map(|(position, speed)| [*position, *speed]);
        let inputs: Vec<f256> = parameters.iter().copied().chain(states).chain([0.0]).map(f256::from).collect();
        let values = self.values(&inputs);
        let [n, m] = self.sizes;
        let entry = |at: usize| values[self.entries[at]];
        let (jacobian, forces, convective) = (n * n, (n + m) * n, (n + m) * n + n);
        let row = |i: usize| -> Vec<f256> {
            let column = |j: usize| match (i < n, j < n) {
                (true, false) => entry(jacobian + (j - n) * n + i),
                (false, false) => f256::from(0.0),
                _ => entry(i * n + j),
            };
            let side = if i < n { entry(forces + i) } else { -entry(convective + i - n) };
            (0..n + m).map(column).chain([side]).collect()
        };
        solve((0..n + m).map(row).collect())
    }

    fn values(&self, inputs: &[f256]) -> Vec<f256> {
        let mut values: Vec<f256> = Vec::with_capacity(self.steps.len());
        for step in &self.steps {
            let value = |at: &usize| values[*at];
            values.push(match step {
                Step::Known(number) => *number,
                Step::Input(at) => inputs[*at],
                Step::Sum(constant, terms) => terms.iter().fold(*constant, |sum, (term, c)| sum + *c * value(term)),
                Step::Product(c, factors) => {
                    factors.iter().fold(*c, |product, (base, e)| product * power(value(base), *e))
                }
                Step::Power(base, exponent) => value(base).powf(&value(exponent)),
                Step::Call(function, argument) => call(*function, value(argument)),
                Step::Atan2(y, x) => value(y).atan2(&value(x)),
                Step::Choice([difference, above, _]) if value(difference) > f256::from(0.0) => value(above),
                Step::Choice([_, _, otherwise]) => value(otherwise),
            });
        }
        values
    }
}

/// A rational number, which is shown as one.
fn exact(number: &Number) -> f256 {
    let shown = number.to_string();
    let (numerator, denominator) = shown.split_once('/').unwrap_or((&shown, "1"));
    let [numerator, denominator] = [numerator, denominator].map(|part| part.parse().unwrap_or(f256::NAN));
    numerator / denominator
}

fn power(base: f256, exponent: i64) -> f256 {
    let power = (0..exponent.unsigned_abs()).fold(f256::from(1.0), |power, _| power * base);
    if exponent < 0 { power.recip() } else { power }
}

fn call(function: Function, x: f256) -> f256 {
    let half_of_exponentials = |sign: f64| (x.exp() + f256::from(sign) * (-x).exp()).div2();
    match function {
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.tan(),
        Function::Asin => x.asin(),
        Function::Acos => x.acos(),
        Function::Atan => x.atan(),
        Function::Sinh => half_of_exponentials(-1.0),
        Function::Cosh => half_of_exponentials(1.0),
        Function::Tanh => half_of_exponentials(-1.0) / half_of_exponentials(1.0),
        Function::Exp => x.exp(),
        Function::Ln => x.ln(),
        Function::Abs => x.abs(),
        Function::Sign if x.eq_zero() => x,
        Function::Sign => x.signum(),
    }
}

/// Gauss's elimination with partial pivoting; the right-hand side stands last in each row.
fn solve(mut rows: Vec<Vec<f256>>) -> Option<Vec<f256>> {
    let count = rows.len();
    for k in 0..count {
        let pivot = (k..count).max_by(|i, j| rows[*i][k].abs().total_cmp(&rows[*j][k].abs()))?;
        rows.swap(k, pivot);
        let (solved, below) = rows.split_at_mut(k + 1);
        let pivot = &solved[k];
        if pivot[k].eq_zero() || !pivot[k].is_finite() {
            return None;
        }
        for row in below {
            let factor = row[k] / pivot[k];
            if !factor.eq_zero() {
                (k..=count).for_each(|j| row[j] -= factor * pivot[j]);
            }
        }
    }
    for k in (0..count).rev() {
        let known = (k + 1..count).fold(rows[k][count], |rest, j| rest - rows[k][j] * rows[j][count]);
        rows[k][count] = known / rows[k][k];
    }
    Some(rows.into_iter().map(|row| row[count]).collect())
}
