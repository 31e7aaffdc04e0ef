//! Loads along scalars: potentials, dissipation functions, springs, dampers.

use super::interpret::Interpreter;
use super::level::{position_level, position_scalar};
use super::loads::load_level;
use super::value::{Value, common_dimension};
use super::{Dependence, Dimension, Effort};
use crate::dsl::{Element, Expression, Extent, Law, Region};
use crate::symbolic::{Differential, Expr, Function, Number, Symbol};

/// How far a spring is from where it has no force, in the law of its force.
const STRETCH: &str = "stretch";
/// How fast its extent grows, in the law of a spring or damper.
const RATE: &str = "rate";

/// -dV/dq: -1 along V.
pub(super) fn potential(energy: &Expression, i: &mut Interpreter) -> Option<Effort> {
    let along = position_scalar(energy, "a potential energy", i)?;
    if !i.dependences.of(&i.graph, along).meets(Dependence::COORDINATE) {
        return i.refuse(energy.region, "no coordinate stands in this potential energy, so no force comes of it");
    }
    Some(Effort { force: i.graph.integer(-1), along })
}

/// -dR/dq' along each coordinate and whatever else moves, given with its rate (Rayleigh's dissipation function; Goldstein,
/// Poole, Safko: Classical Mechanics, 3rd ed., (1.69)).
pub(super) fn dissipation(function: &Expression, moving: &[(Symbol, Symbol)], i: &mut Interpreter) -> Vec<Effort> {
    let value = i.scalar(function).and_then(|value| load_level(function, [value], i));
    let Some([value]) = value else { return vec![] };
    if !i.dependences.of(&i.graph, value).meets(Dependence::SPEED) {
        let message = "no speed stands in this dissipation function, so it brakes nothing; write it with `dot(..)`";
        i.mistakes.add(function.region.error(message));
    }
    let along = moving.iter().map(|(position, rate)| {
        let slope = Differential::partial(&mut i.graph, *rate).of(&mut i.graph, value);
        Effort { force: i.graph.neg(slope), along: i.graph.variable(*position) }
    });
    let along: Vec<Effort> = along.collect();
    along.into_iter().filter(|effort| !i.graph.is_zero(effort.force)).collect()
}

/// A scalar that a force or torque works along.
pub(super) fn quantity(expression: &Expression, i: &mut Interpreter) -> Option<Expr> {
    let along = position_scalar(expression, "what a load works along", i)?;
    check_moves(expression.region, along, i)?;
    Some(along)
}

/// The force of an element along its extent.
pub(super) fn element(element: &Element, i: &mut Interpreter) -> Option<Effort> {
    let along = resolve_extent(element.keyword, &element.extent, i);
    match &element.law {
        Law::Force(force) => {
            let force = load_scalar(force, i)?;
            along.map(|along| Effort { force: force.0, along: along.value })
        }
        Law::Spring(law, rest) => spring(law, rest, along, i),
        Law::Friction(force, smooth) => friction(force, smooth, along, i),
        Law::Damper(law) => damper(law, along, i),
    }
}

/// What an element works along.
struct Along {
    value: Expr,
    /// Its square, where that needs no root.
    square: Option<Expr>,
    dimension: Option<Dimension>,
}

fn resolve_extent(keyword: Region, extent: &Extent, i: &mut Interpreter) -> Option<Along> {
    let along = match extent {
        Extent::Distance(from, to) => distance(from, to, i),
        Extent::Difference(from, to) => {
            let (from, to) = (position(from, i), position(to, i));
            let ((from, unit), (to, other)) = (from?, to?);
            let (value, dimension) = (i.graph.sub(to, from), common_dimension(unit, other));
            Some(Along { value, square: None, dimension })
        }
        Extent::Quantity(x) => position(x, i).map(|(value, dimension)| Along { value, square: None, dimension }),
    }?;
    check_moves(keyword, along.value, i)?;
    Some(along)
}

fn distance(from: &Expression, to: &Expression, i: &mut Interpreter) -> Option<Along> {
    const WHAT: &str = "the end of an element";
    let (a, b) = (i.point_value(from), i.point_value(to));
    let ((a, unit), (b, other)) = (a?, b?);
    let (a, b) = (position_level(from, a, WHAT, i), position_level(to, b, WHAT, i));
    let (a, b) = (a?, b?);
    let way = [i.graph.sub(b[0], a[0]), i.graph.sub(b[1], a[1])];
    let square = i.inner(way, way);
    Some(Along { value: i.graph.sqrt(square), square: Some(square), dimension: common_dimension(unit, other) })
}

fn position(expression: &Expression, i: &mut Interpreter) -> Option<(Expr, Option<Dimension>)> {
    let (value, dimension) = i.scalar_value(expression)?;
    position_level(expression, [value], "what an element works along", i)?;
    Some((value, dimension))
}

fn check_moves(place: Region, along: Expr, i: &mut Interpreter) -> Option<()> {
    match i.dependences.of(&i.graph, along).meets(Dependence::COORDINATE) {
        true => Some(()),
        false => i.refuse(place, "no coordinate changes what this works along, so it moves nothing; leave it out"),
    }
}

fn load_scalar(expression: &Expression, i: &mut Interpreter) -> Option<(Expr, Option<Dimension>)> {
    let (value, dimension) = i.scalar_value(expression)?;
    load_level(expression, [value], i)?;
    Some((value, dimension))
}

/// -k (x - x0), or minus the force that is given for a stretch of x - x0.
fn spring(law: &Expression, rest: &Expression, along: Option<Along>, i: &mut Interpreter) -> Option<Effort> {
    let rest = load_scalar(rest, i);
    if !law.mentions(STRETCH) && !law.mentions(RATE) {
        let stiffness = load_scalar(law, i);
        let ((stiffness, _), (rest, _), along) = (stiffness?, rest?, along?);
        return Some(linear_spring(stiffness, rest, &along, i));
    }
    let ((rest, _), along) = (rest?, along?);
    let stretch = Value::scalar(i.graph.sub(along.value, rest), along.dimension.clone());
    let words = vec![(STRETCH, stretch), rate_word(&along, i)];
    let force = law_of_force(law, words, i)?;
    Some(Effort { force: i.graph.neg(force), along: along.value })
}

/// Without free length it pulls by the way between its ends, which has no direction to be divided by: -k/2 along x^2.
fn linear_spring(stiffness: Expr, rest: Expr, along: &Along, i: &mut Interpreter) -> Effort {
    match along.square {
        Some(square) if i.graph.is_zero(rest) => {
            Effort { force: i.graph.scale(&-&Number::HALF, stiffness), along: square }
        }
        _ => {
            let stretch = i.graph.sub(along.value, rest);
            let pull = i.graph.mul(stiffness, stretch);
            Effort { force: i.graph.neg(pull), along: along.value }
        }
    }
}

/// -c x', or minus the force that is given for a rate of x'.
fn damper(law: &Expression, along: Option<Along>, i: &mut Interpreter) -> Option<Effort> {
    if law.mentions(STRETCH) && i.values.get_region(STRETCH).is_none() {
        return i.refuse(law.region, "a damper has no free length to be stretched from; its force depends on `rate`");
    }
    if !law.mentions(RATE) {
        let coefficient = load_scalar(law, i);
        let ((coefficient, _), along) = (coefficient?, along?);
        let rate = rate_of(&along, i);
        let force = i.graph.mul(coefficient, rate);
        return Some(Effort { force: i.graph.neg(force), along: along.value });
    }
    let along = along?;
    let words = vec![rate_word(&along, i)];
    let force = law_of_force(law, words, i)?;
    Some(Effort { force: i.graph.neg(force), along: along.value })
}

/// -F tanh(x'/v0): Coulomb's friction, but for speeds of a few v0 (Andersson, Soederberg, Bjoerklund: Friction models for
/// sliding dry, boundary and mixed lubricated contacts, Tribology International 40, 2007).
fn friction(force: &Expression, smooth: &Expression, along: Option<Along>, i: &mut Interpreter) -> Option<Effort> {
    let (size, speed) = (load_scalar(force, i), load_scalar(smooth, i));
    let ((size, _), (speed, _), along) = (size?, speed?, along?);
    if i.graph.is_zero(speed) {
        let message = "the speed within which friction is smoothed is above 0: a force that jumps cannot be integrated";
        return i.refuse(smooth.region, message);
    }
    let rate = rate_of(&along, i);
    let ratio = i.graph.div(rate, speed);
    let part = i.graph.call(Function::Tanh, ratio);
    let force = i.graph.mul(size, part);
    Some(Effort { force: i.graph.neg(force), along: along.value })
}

fn rate_of(along: &Along, i: &mut Interpreter) -> Expr {
    let Interpreter { graph, motion, .. } = i;
    motion.of(graph, along.value)
}

fn rate_word(along: &Along, i: &mut Interpreter) -> (&'static str, Value) {
    let dimension = along.dimension.as_ref().map(|d| d.over(&Dimension::time()));
    (RATE, Value::scalar(rate_of(along, i), dimension))
}

/// A law with the words that stand in it alone.
fn law_of_force(law: &Expression, words: Vec<(&'static str, Value)>, i: &mut Interpreter) -> Option<Expr> {
    for (word, _) in &words {
        if law.mentions(word)
            && let Some(own) = i.values.get_region(word)
        {
            let mut mistake = law.region.error(format!("in the law of an element `{word}` is its own {word}"));
            mistake.combine(own.error(format!("choose another name than `{word}` for this")));
            i.mistakes.add(mistake);
            return None;
        }
    }
    i.local = words;
    let force = load_scalar(law, i);
    i.local.clear();
    force.map(|(force, _)| force)
}
