//! The kinematic differential equations q' = N u + n of generalised speeds.
//!
//! The definitions u = W q' + w and the rows that hold whatever u is (norms of quaternions, constraints between speeds)
//! are as many linear equations A q' + b = 0 as there are rates. Where a rate stands with a number as its coefficient
//! it is eliminated in symbols, by pivots that never vanish. The rest, B h + c = 0, is brought into the form B'B h =
//! -B'c. There a number on the diagonal that stands alone gives a rate at once; the rest is solved by elimination at
//! run time, of which every pivot is positive as long as B is regular: where it is not, as at the singular positions of
//! Euler's angles, no speeds determine the rates. B'B of Euler's angles, of quaternions and of directions in a plane is
//! diagonal.
//!
//! The form B'B is used because pivots chosen for B itself when the mechanism is built would vanish at some positions
//! where B is regular. Where B'B is not diagonal, its condition is the square of B's.

use super::block::{Block, Subsystem};
use super::linear::{Equation, Solved, eliminate, expanded};
use crate::model::{GeneralizedSpeed, Level, Model};
use crate::symbolic::{Differential, Expr, Graph, Node, Number, Symbol, substitute};

/// q' = N u + n.
pub struct Kinematics {
    /// q', n, as expressions of u, q, t and the unknowns of the blocks.
    pub rates: Vec<Expr>,
    /// The equations solved at run time.
    pub blocks: Vec<Block>,
}

/// Rates that are 0 for all generalised speeds: those of constraints between speeds, and of q.q/2 for each norm, whose
/// coefficients are orthogonal to those of angular velocities.
pub(super) fn satisfied(graph: &mut Graph, model: &Model, motion: &mut Differential) -> Vec<Expr> {
    let rows = model.satisfied_rows();
    let rate = |row: usize| {
        let (level, value) = (model.constraints[row].level, model.constraints[row].value);
        match level {
            Level::Speeds => value,
            Level::Positions => half_square_rate(graph, motion, value),
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

impl Kinematics {
    pub(super) fn derive(graph: &mut Graph, model: &Model, satisfied: &[Expr]) -> Kinematics {
        let equations = equations(graph, model, satisfied);
        let (solved, equations) = eliminate(graph, equations);
        let n = model.coordinates.len();
        let left: Vec<usize> = (0..n).filter(|j| solved.iter().all(|solved| solved.unknown != *j)).collect();
        let mut rates = vec![graph.zero(); n];
        let mut parts = Vec::new();
        for part in Subsystem::all(graph, &equations, &left) {
            if let Some((j, rate)) = part.known(graph) {
                rates[j] = rate;
                continue;
            }
            let h = part.symbols(graph, model, "dot");
            part.coordinates.iter().zip(&h).for_each(|(j, symbol)| rates[*j] = graph.variable(*symbol));
            parts.push((part, h));
        }
        // Each was solved before those that still stand in it.
        for Solved { unknown, equation } in solved.iter().rev() {
            let left_hand_side = equation.left_hand_side(graph, &rates);
            let opposite = expanded(graph, left_hand_side);
            rates[*unknown] = graph.neg(opposite);
        }
        // The rates of change of the other parts are orthogonal to the columns of this one.
        let mut onwards = motion(graph, model, &rates, vec![]);
        let left_hand_sides = equations.iter().map(|equation| equation.left_hand_side(graph, &rates));
        let left_hand_sides: Vec<Expr> = left_hand_sides.collect();
        let changing: Vec<Expr> = left_hand_sides.iter().map(|side| onwards.of(graph, *side)).collect();
        let rests: Vec<Expr> = equations.iter().map(|equation| equation.rest).collect();
        let blocks = parts.into_iter().map(|(part, h)| part.block(graph, model, h, &rests, &changing)).collect();
        Kinematics { rates, blocks }
    }

    /// The derivative along the motion where u' = 0 of what is written in u, q, t and h.
    pub(super) fn convective(&self, graph: &mut Graph, model: &Model) -> Differential {
        let blocks = self.blocks.iter();
        let along = blocks.flat_map(|block| block.rates.symbols.iter().zip(&block.convective.symbols));
        let along = along.map(|(h, convective)| (*h, graph.variable(*convective))).collect();
        motion(graph, model, &self.rates, along)
    }

    /// The derivatives of what is written in u, q, t and h with respect to each u.
    pub(super) fn by_speeds(&self, graph: &mut Graph, model: &Model) -> Vec<Differential> {
        let mut along: Vec<Vec<(Symbol, Expr)>> =
            model.generalized_speeds.iter().map(|speed| vec![(speed.symbol, graph.one())]).collect();
        for block in &self.blocks {
            for (k, by_speed) in &block.by_speed {
                let derivatives = by_speed.symbols.iter().map(|by| graph.variable(*by));
                along[*k].extend(block.rates.symbols.iter().copied().zip(derivatives));
            }
        }
        along.into_iter().map(Differential::along).collect()
    }
}

/// A q' + b = 0 of the definitions, then of what is satisfied by construction.
fn equations(graph: &mut Graph, model: &Model, satisfied: &[Expr]) -> Vec<Equation> {
    let Model { coordinates, generalized_speeds: speeds, .. } = model;
    let defined: Vec<Expr> = speeds.iter().map(|speed| definition(graph, speed)).collect();
    let zero = graph.zero();
    let at_rest: Vec<(Symbol, Expr)> = coordinates.iter().map(|c| (c.speed, zero)).collect();
    let mut by_rate: Vec<Differential> = coordinates.iter().map(|c| Differential::partial(graph, c.speed)).collect();
    let equation = |expr: Expr| {
        let coefficients = by_rate.iter_mut().map(|by| {
            let coefficient = by.of(graph, expr);
            // Some squares of speeds cancel only when multiplied out.
            substitute(graph, &[coefficient], &at_rest)[0]
        });
        let coefficients = coefficients.collect();
        Equation { coefficients, rest: substitute(graph, &[expr], &at_rest)[0] }
    };
    defined.into_iter().chain(satisfied.iter().copied()).map(equation).collect()
}

/// W q' + w - u, times the denominators of W: those of angular velocities by a quaternion are its norm, and would only
/// be divided out again.
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

/// The derivative along q', with u constant, t at 1 and what else changes.
fn motion(graph: &mut Graph, model: &Model, rates: &[Expr], others: Vec<(Symbol, Expr)>) -> Differential {
    let mut along = vec![(model.time, graph.one())];
    along.extend(model.coordinates.iter().map(|c| c.position).zip(rates.iter().copied()));
    along.extend(others);
    Differential::along(along)
}
