//! The kinematic differential equations q' = N u + n of generalised speeds.
//!
//! The definitions u = W q' + w and the rows that hold whatever u is (norms of quaternions, constraints between speeds) are as many
//! linear equations A q' + b = 0 as there are rates. Where a rate stands with a number as its coefficient it is eliminated in
//! symbols, by pivots that never vanish. What is left, B h + c = 0, is brought into the form B'B h = -B'c. There a number on the
//! diagonal that stands alone gives a rate at once; the rest is solved by elimination at run time, of which every pivot is positive
//! as long as B is regular: where it is not, as at the singular positions of Euler's angles, no speeds determine the rates.
//! B'B of Euler's angles, of quaternions and of directions in a plane is diagonal.

use super::variables::inner;
use crate::model::{GeneralizedSpeed, Level, Model};
use crate::symbolic::{Differential, Expr, Graph, Node, Number, Symbol, substitute};

/// The largest sum that multiplying out may make.
const LONGEST_EXPANSION: usize = 64;

/// q' = N u + n.
pub struct Kinematics {
    /// q', n, of u, q, t and what the block is solved for.
    pub rates: Vec<Expr>,
    /// What is solved for at run time.
    pub block: Block,
}

/// Linear equations for some of the rates, s of them: h.
pub struct Block {
    /// Which coordinates they are the rates of.
    pub coordinates: Vec<usize>,
    /// h.
    pub rates: Vec<Symbol>,
    /// The derivatives of h by each u.
    pub by_speed: Vec<Vec<Symbol>>,
    /// h' where u' = 0.
    pub convective: Vec<Symbol>,
    /// B'B, s x s, symmetric.
    pub matrix: Vec<Vec<Expr>>,
    /// -B'c, s: the right-hand side for h.
    pub of_rates: Vec<Expr>,
    /// Those for the derivatives of h by each u.
    pub of_speeds: Vec<Vec<Expr>>,
    /// That for h' where u' = 0.
    pub of_convective: Vec<Expr>,
}

/// Rates that are 0 whatever the generalised speeds are: of constraints between speeds, and of q.q/2 for each norm, whose coefficients
/// are orthogonal to those of angular velocities.
pub(super) fn satisfied(model: &mut Model, motion: &mut Differential) -> Vec<Expr> {
    let rows = model.satisfied_rows();
    let rate = |row: usize| {
        let (level, value) = (model.constraints[row].level, model.constraints[row].value);
        match level {
            Level::Speeds => value,
            Level::Positions => half_square_rate(&mut model.graph, motion, value),
        }
    };
    rows.into_iter().map(rate).collect()
}

/// q.q' of the symbols in a norm.
fn half_square_rate(graph: &mut Graph, motion: &mut Differential, norm: Expr) -> Expr {
    let symbols = graph.symbols_of(&[norm]);
    let products: Vec<Expr> = symbols
        .into_iter()
        .map(|symbol| {
            let variable = graph.variable(symbol);
            let rate = motion.of(graph, variable);
            graph.mul(variable, rate)
        })
        .collect();
    graph.sum(&products)
}

/// A linear equation between the rates.
#[derive(Clone)]
struct Equation {
    /// A, one for each rate.
    coefficients: Vec<Expr>,
    /// b.
    rest: Expr,
}

/// An equation solved for one of its rates, whose coefficient is 1.
struct Solved {
    unknown: usize,
    equation: Equation,
}

impl Kinematics {
    pub(super) fn derive(model: &mut Model, satisfied: &[Expr]) -> Kinematics {
        let equations = equations(model, satisfied);
        let (solved, equations) = eliminate(&mut model.graph, equations);
        let n = model.coordinates.len();
        let left: Vec<usize> = (0..n).filter(|j| solved.iter().all(|solved| solved.unknown != *j)).collect();
        let normal = Normal::of(model, &equations, &left);
        let mut rates = vec![model.graph.zero(); n];
        let mut coordinates = Vec::new();
        for (at, j) in left.iter().enumerate() {
            match normal.alone(&model.graph, at) {
                Some(inverse) => rates[*j] = model.graph.scale(&inverse, normal.of_rates[at]),
                None => coordinates.push(at),
            }
        }
        let h = coordinates.iter().map(|at| model.graph.symbol(&format!("{}_dot", model.coordinates[left[*at]].name)));
        let h: Vec<Symbol> = h.collect();
        for (at, symbol) in coordinates.iter().zip(&h) {
            rates[left[*at]] = model.graph.variable(*symbol);
        }
        // Each was solved before those that still stand in it.
        for Solved { unknown, equation } in solved.iter().rev() {
            let known = inner(model, &equation.coefficients, &rates);
            let sum = model.graph.add(known, equation.rest);
            rates[*unknown] = model.graph.neg(sum);
        }
        let block = normal.block(model, &equations, &rates, &left, &coordinates, h);
        Kinematics { rates, block }
    }

    /// The derivative along the motion where u' = 0 of what is written in u, q, t and h.
    pub(super) fn convective(&self, model: &mut Model) -> Differential {
        let along = self.block.rates.iter().zip(&self.block.convective);
        let along: Vec<_> = along.map(|(h, convective)| (*h, model.graph.variable(*convective))).collect();
        motion(model, &self.rates, along)
    }

    /// The derivatives of what is written in u, q, t and h with respect to each u.
    pub(super) fn by_speeds(&self, model: &mut Model) -> Vec<Differential> {
        let Model { speeds, graph, .. } = model;
        let along = |(speed, by_speed): (&GeneralizedSpeed, &Vec<Symbol>)| {
            let mut along = vec![(speed.symbol, graph.one())];
            along.extend(self.block.rates.iter().zip(by_speed).map(|(h, by)| (*h, graph.variable(*by))));
            Differential::along(along)
        };
        speeds.iter().zip(&self.block.by_speed).map(along).collect()
    }
}

/// A q' + b = 0 of the definitions, then of what is satisfied by construction.
fn equations(model: &mut Model, satisfied: &[Expr]) -> Vec<Equation> {
    let Model { graph, coordinates, speeds, .. } = model;
    let defined: Vec<Expr> = speeds.iter().map(|speed| definition(graph, speed)).collect();
    let zero = graph.zero();
    let at_rest: Vec<(Symbol, Expr)> = coordinates.iter().map(|c| (c.speed, zero)).collect();
    let mut by_rate: Vec<Differential> = coordinates.iter().map(|c| Differential::partial(graph, c.speed)).collect();
    let equation = |expr: Expr| {
        let coefficients = by_rate.iter_mut().map(|by| {
            let coefficient = by.of(graph, expr);
            // Squares of speeds may cancel only when they are multiplied out.
            substitute(graph, &[coefficient], &at_rest)[0]
        });
        let coefficients = coefficients.collect();
        Equation { coefficients, rest: substitute(graph, &[expr], &at_rest)[0] }
    };
    defined.into_iter().chain(satisfied.iter().copied()).map(equation).collect()
}

/// W q' + w - u, times the denominators of W: those of angular velocities by a quaternion are its norm, and would only be divided
/// out again.
fn definition(graph: &mut Graph, speed: &GeneralizedSpeed) -> Expr {
    let (mut value, mut scaled) = (speed.value, graph.variable(speed.symbol));
    if let Node::Product { coefficient, factors } = graph.node(speed.value).clone() {
        let (above, below): (Vec<_>, Vec<_>) = factors.iter().partition(|(_, exponent)| *exponent > 0);
        let powers: Vec<Expr> = above.into_iter().map(|(base, exponent)| graph.integer_power(base, exponent)).collect();
        let inverse = coefficient.recip().unwrap_or(Number::ONE);
        value = graph.product(&powers);
        scaled = graph.scale(&inverse, scaled);
        for (base, exponent) in below {
            let power = graph.integer_power(base, -exponent);
            scaled = graph.mul(scaled, power);
        }
    }
    graph.sub(value, scaled)
}

/// Solves as many equations as have a number for a coefficient, each for a rate that stands in few others; gives them in
/// order, and what is left.
fn eliminate(graph: &mut Graph, mut equations: Vec<Equation>) -> (Vec<Solved>, Vec<Equation>) {
    let mut solved = Vec::new();
    while let Some((row, unknown)) = pivot(graph, &equations) {
        let mut equation = equations.remove(row);
        if let Some(inverse) = graph.as_number(equation.coefficients[unknown]).and_then(Number::recip) {
            equation.scale(graph, &inverse);
        }
        for other in &mut equations {
            other.take(graph, unknown, &equation);
        }
        let zero = graph.zero();
        equation.coefficients[unknown] = zero;
        solved.push(Solved { unknown, equation });
    }
    (solved, equations)
}

/// Where a number is a coefficient, by Markowitz's count of the entries that its elimination may make.
fn pivot(graph: &Graph, equations: &[Equation]) -> Option<(usize, usize)> {
    let occupied = |equation: &Equation, j: usize| !graph.is_zero(equation.coefficients[j]);
    let mut best = None;
    for (i, equation) in equations.iter().enumerate() {
        let entries = (0..equation.coefficients.len()).filter(|j| occupied(equation, *j)).count();
        for (j, coefficient) in equation.coefficients.iter().enumerate() {
            if graph.as_number(*coefficient).is_none_or(Number::is_zero) {
                continue;
            }
            let column = equations.iter().filter(|equation| occupied(equation, j)).count();
            let cost = (entries - 1) * (column - 1);
            if best.is_none_or(|(least, _)| cost < least) {
                best = Some((cost, (i, j)));
            }
        }
    }
    best.map(|(_, place)| place)
}

impl Equation {
    fn scale(&mut self, graph: &mut Graph, factor: &Number) {
        for entry in self.coefficients.iter_mut().chain([&mut self.rest]) {
            *entry = graph.scale(factor, *entry);
        }
    }

    /// Takes away that multiple of an equation, whose coefficient there is 1, which makes a coefficient 0.
    fn take(&mut self, graph: &mut Graph, unknown: usize, equation: &Equation) {
        let factor = self.coefficients[unknown];
        if graph.is_zero(factor) {
            return;
        }
        let less = equation.coefficients.iter().chain([&equation.rest]);
        for (entry, less) in self.coefficients.iter_mut().chain([&mut self.rest]).zip(less) {
            let product = graph.mul(factor, *less);
            let difference = graph.sub(*entry, product);
            *entry = expanded(graph, difference);
        }
    }
}

/// The derivative along q', with u constant, t at 1 and what else changes.
fn motion(model: &mut Model, rates: &[Expr], others: Vec<(Symbol, Expr)>) -> Differential {
    let mut along = vec![(model.time, model.graph.one())];
    along.extend(model.coordinates.iter().map(|c| c.position).zip(rates.iter().copied()));
    along.extend(others);
    Differential::along(along)
}

/// B'B h = -B'c.
struct Normal {
    /// B by columns.
    columns: Vec<Vec<Expr>>,
    /// B'B.
    matrix: Vec<Vec<Expr>>,
    /// -B'c.
    of_rates: Vec<Expr>,
}

impl Normal {
    fn of(model: &mut Model, equations: &[Equation], unknowns: &[usize]) -> Normal {
        let column = |j: &usize| equations.iter().map(|equation| equation.coefficients[*j]).collect();
        let columns: Vec<Vec<Expr>> = unknowns.iter().map(column).collect();
        let rests: Vec<Expr> = equations.iter().map(|equation| equation.rest).collect();
        let mut entry = |a: &[Expr], b: &[Expr]| {
            let entry = inner(model, a, b);
            expanded(&mut model.graph, entry)
        };
        let matrix = columns.iter().map(|a| columns.iter().map(|b| entry(a, b)).collect()).collect();
        let of_rates = reduced(model, &columns, &rests);
        Normal { columns, matrix, of_rates }
    }

    /// The reciprocal of a number on the diagonal, if it is the only entry of its row.
    fn alone(&self, graph: &Graph, at: usize) -> Option<Number> {
        let others = self.matrix[at].iter().enumerate().filter(|(other, _)| *other != at);
        let is_alone = others.into_iter().all(|(_, entry)| graph.is_zero(*entry));
        graph.as_number(self.matrix[at][at]).filter(|_| is_alone).and_then(Number::recip)
    }

    /// What of it is left to be solved for `h`, the unknowns `at`, given all rates.
    fn block(
        self,
        model: &mut Model,
        equations: &[Equation],
        rates: &[Expr],
        unknowns: &[usize],
        at: &[usize],
        h: Vec<Symbol>,
    ) -> Block {
        let columns: Vec<Vec<Expr>> = at.iter().map(|at| self.columns[*at].clone()).collect();
        let matrix = at.iter().map(|i| at.iter().map(|j| self.matrix[*i][*j]).collect()).collect();
        let of_rates = at.iter().map(|at| self.of_rates[*at]).collect();
        let speeds: Vec<Symbol> = model.speeds.iter().map(|speed| speed.symbol).collect();
        let derivatives = |model: &mut Model, mut by: Differential, exprs: &[Expr]| {
            let derivatives: Vec<Expr> = exprs.iter().map(|expr| by.of(&mut model.graph, *expr)).collect();
            reduced(model, &columns, &derivatives)
        };
        let rests: Vec<Expr> = equations.iter().map(|equation| equation.rest).collect();
        let of_speeds = speeds.iter().map(|speed| {
            let by = Differential::partial(&mut model.graph, *speed);
            derivatives(model, by, &rests)
        });
        let of_speeds = of_speeds.collect();
        let left: Vec<Expr> = equations
            .iter()
            .map(|equation| {
                let moving = inner(model, &equation.coefficients, rates);
                model.graph.add(moving, equation.rest)
            })
            .collect();
        // Other rates change too, but B' takes that away: their columns are orthogonal to these.
        let by = motion(model, rates, vec![]);
        let of_convective = derivatives(model, by, &left);
        let coordinates: Vec<usize> = at.iter().map(|at| unknowns[*at]).collect();
        let mut named = |suffix: &str| -> Vec<Symbol> {
            coordinates
                .iter()
                .map(|j| model.graph.symbol(&format!("{}_{suffix}", model.coordinates[*j].name)))
                .collect()
        };
        let by_speed = model.speeds.iter().map(|speed| named(&format!("by_{}", speed.name))).collect();
        let convective = named("convective");
        Block { coordinates, rates: h, by_speed, convective, matrix, of_rates, of_speeds, of_convective }
    }
}

/// -B' times a vector.
fn reduced(model: &mut Model, columns: &[Vec<Expr>], vector: &[Expr]) -> Vec<Expr> {
    let entry = |column: &Vec<Expr>| {
        let sum = inner(model, column, vector);
        model.graph.neg(sum)
    };
    columns.iter().map(entry).collect()
}

/// Multiplied out where terms cancel then.
fn expanded(graph: &mut Graph, expr: Expr) -> Expr {
    graph.expand(expr, LONGEST_EXPANSION).unwrap_or(expr)
}
