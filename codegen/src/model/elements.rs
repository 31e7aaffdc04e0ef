//! Loads along scalars: potentials, dissipation functions, springs, dampers.

use super::interpreter::Interpreter;
use super::level::{self, load_level, position_level, position_scalar};
use super::measured::Measured;
use super::value::Value;
use super::{Dependence, Dimension, Effort};
use crate::dsl::{Element, Expression, Extent, Law, Region};
use crate::symbolic::{Differential, Expr, Function, Number, Symbol};

/// The stretch of a spring from its free length, in the law of its force.
const STRETCH: &str = "stretch";
/// The rate of the extent, in the law of a spring or damper.
const RATE: &str = "rate";

/// -dV/dq: -1 along V.
pub(super) fn potential(energy: &Expression, interpreter: &mut Interpreter) -> Option<Effort> {
    let along = position_scalar(energy, &Dimension::energy(), "a potential energy", interpreter)?;
    if !interpreter.dependences.of(&interpreter.graph, along).meets(Dependence::COORDINATE) {
        return interpreter
            .refuse(energy.region, "this potential energy depends on no coordinate, so it exerts no force");
    }
    let why = "this potential energy jumps where a position does not, so that no force is its slope: let it change within some way";
    interpreter.no_jump(energy.region, &[along], Dependence::COORDINATE, why)?;
    Some(Effort { force: interpreter.graph.integer(-1), along })
}

/// -dR/dq' along each coordinate and auxiliary displacement, given with its rate (Rayleigh's dissipation function;
/// Goldstein, Poole, Safko: Classical Mechanics, 3rd ed., (1.69)).
pub(super) fn dissipation(
    function: &Expression,
    moving: &[(Symbol, Symbol)],
    interpreter: &mut Interpreter,
) -> Vec<Effort> {
    let power = Some(Dimension::energy().over(&Dimension::time()));
    let Some(value) = load_scalar(function, power, "a dissipation function", interpreter) else { return vec![] };
    if !interpreter.dependences.of(&interpreter.graph, value).meets(Dependence::SPEED) {
        let message = "this dissipation function depends on no speed, so it exerts no force; write it with `dot(..)`";
        interpreter.mistakes.add(function.region.error(message));
    }
    let along = moving.iter().map(|(position, rate)| {
        let slope = Differential::partial(&mut interpreter.graph, *rate).of(&mut interpreter.graph, value);
        Effort { force: interpreter.graph.neg(slope), along: interpreter.graph.variable(*position) }
    });
    let along: Vec<Effort> = along.collect();
    along.into_iter().filter(|effort| !interpreter.graph.is_zero(effort.force)).collect()
}

/// An angle that a torque works along.
pub(super) fn turned(expression: &Expression, interpreter: &mut Interpreter) -> Option<Expr> {
    let along = level::angle(expression, "the angle that a torque turns", interpreter)?;
    check_moves(expression.region, along, interpreter)?;
    Some(along)
}

/// The force of an element along its extent.
pub(super) fn element(element: &Element, interpreter: &mut Interpreter) -> Option<Effort> {
    let along = resolve_extent(element.keyword, &element.extent, interpreter);
    match &element.law {
        Law::Force(force) => {
            let (needed, what) = needed("a force", along.as_ref(), Along::force);
            let force = load_scalar(force, needed, &what, interpreter)?;
            along.map(|along| Effort { force, along: along.value })
        }
        Law::Spring(law, rest) => {
            for end in ends(&element.extent) {
                interpreter.refuse_bare_beside(end, rest)?;
            }
            spring(law, rest, along, interpreter)
        }
        Law::Friction(force, smooth) => friction(force, smooth, along, interpreter),
        Law::Damper(law) => damper(law, along, interpreter),
    }
}

/// The expressions whose difference an extent is.
fn ends(extent: &Extent) -> Vec<&Expression> {
    match extent {
        Extent::Distance(from, to) | Extent::Difference(from, to) => vec![from, to],
        Extent::Quantity(x) => vec![x],
    }
}

/// The extent of an element.
struct Along {
    value: Expr,
    /// Its square, where that needs no root.
    square: Option<Expr>,
    dimension: Option<Dimension>,
}

impl Along {
    /// The dimension of a force along it: work per extent.
    fn force(&self) -> Option<Dimension> {
        Some(Dimension::energy().over(self.dimension.as_ref()?))
    }

    fn stiffness(&self) -> Option<Dimension> {
        Some(self.force()?.over(self.dimension.as_ref()?))
    }

    fn rate(&self) -> Option<Dimension> {
        Some(self.dimension.as_ref()?.over(&Dimension::time()))
    }

    fn damping(&self) -> Option<Dimension> {
        Some(self.stiffness()?.times(&Dimension::time()))
    }
}

/// The required dimension of a part of an element, and the part in words: "a force along a length".
fn needed(
    part: &str,
    along: Option<&Along>,
    dimension: fn(&Along) -> Option<Dimension>,
) -> (Option<Dimension>, String) {
    let extent = match along.and_then(|along| along.dimension.as_ref()) {
        Some(extent) if extent.is_none() => "an angle".to_owned(),
        Some(extent) if *extent == Dimension::length() => "a length".to_owned(),
        Some(extent) => format!("[{}]", extent.si_unit()),
        None => return (None, part.to_owned()),
    };
    (along.and_then(dimension), format!("{part} along {extent}"))
}

fn resolve_extent(keyword: Region, extent: &Extent, interpreter: &mut Interpreter) -> Option<Along> {
    let along = match extent {
        Extent::Distance(from, to) => distance(from, to, interpreter),
        Extent::Difference(from, to) => {
            let (a, b) = (position(from, interpreter), position(to, interpreter));
            let ((a, of_a), (b, of_b)) = (a?, b?);
            let from = Measured { expression: from, dimension: &of_a };
            let to = Measured { expression: to, dimension: &of_b };
            let dimension =
                interpreter.common_dimension(from, to, "an element works between quantities of one dimension")?;
            Some(Along { value: interpreter.graph.sub(b, a), square: None, dimension })
        }
        Extent::Quantity(x) => {
            position(x, interpreter).map(|(value, dimension)| Along { value, square: None, dimension })
        }
    }?;
    check_moves(keyword, along.value, interpreter)?;
    Some(along)
}

fn distance(from: &Expression, to: &Expression, interpreter: &mut Interpreter) -> Option<Along> {
    const WHAT: &str = "the end of an element";
    let (a, b) = (level::position(from, WHAT, interpreter), level::position(to, WHAT, interpreter));
    let (a, b) = (a?, b?);
    let way: Vec<Expr> = a.into_iter().zip(b).map(|(a, b)| interpreter.graph.sub(b, a)).collect();
    let squares: Vec<Expr> = way.into_iter().map(|x| interpreter.graph.mul(x, x)).collect();
    let square = interpreter.graph.sum(&squares);
    let dimension = Some(Dimension::length()).filter(|_| interpreter.with_units);
    Some(Along { value: interpreter.graph.sqrt(square), square: Some(square), dimension })
}

fn position(expression: &Expression, interpreter: &mut Interpreter) -> Option<(Expr, Option<Dimension>)> {
    let (value, dimension) = interpreter.scalar_value(expression)?;
    position_level(expression, &[value], "the extent of an element", interpreter)?;
    Some((value, dimension))
}

fn check_moves(place: Region, along: Expr, interpreter: &mut Interpreter) -> Option<()> {
    match interpreter.dependences.of(&interpreter.graph, along).meets(Dependence::COORDINATE) {
        true => Some(()),
        false => interpreter.refuse(place, "no coordinate changes this extent, so the load does nothing; leave it out"),
    }
}

fn load_scalar(
    expression: &Expression,
    needed: Option<Dimension>,
    what: &str,
    interpreter: &mut Interpreter,
) -> Option<Expr> {
    let (value, dimension) = interpreter.scalar_value(expression)?;
    load_level(expression, vec![value], interpreter)?;
    if let Some(needed) = needed {
        interpreter.expect_in_place(Measured { expression, dimension: &dimension }, &needed, what);
    }
    Some(value)
}

/// -k (x - x0), or minus the force that is given for a stretch of x - x0.
fn spring(law: &Expression, rest: &Expression, along: Option<Along>, interpreter: &mut Interpreter) -> Option<Effort> {
    let (needed_rest, what) = needed("where a spring is at rest", along.as_ref(), |along| along.dimension.clone());
    let rest = load_scalar(rest, needed_rest, &what, interpreter);
    if !law.mentions(STRETCH) && !law.mentions(RATE) {
        let (needed, what) = needed("the stiffness of a spring", along.as_ref(), Along::stiffness);
        let stiffness = load_scalar(law, needed, &what, interpreter);
        let (stiffness, rest, along) = (stiffness?, rest?, along?);
        return Some(linear_spring(stiffness, rest, &along, interpreter));
    }
    let (rest, along) = (rest?, along?);
    let stretch = Value::scalar(interpreter.graph.sub(along.value, rest), along.dimension.clone());
    let words = vec![(STRETCH, stretch), rate_word(&along, interpreter)];
    let force = law_of_force(law, words, needed("the force of a spring", Some(&along), Along::force), interpreter)?;
    Some(Effort { force: interpreter.graph.neg(force), along: along.value })
}

/// Without free length the force is proportional to the vector between the ends, without a division by its length: -k/2
/// along x^2.
fn linear_spring(stiffness: Expr, rest: Expr, along: &Along, interpreter: &mut Interpreter) -> Effort {
    match along.square {
        Some(square) if interpreter.graph.is_zero(rest) => {
            Effort { force: interpreter.graph.scale(&-&Number::HALF, stiffness), along: square }
        }
        _ => {
            let stretch = interpreter.graph.sub(along.value, rest);
            let pull = interpreter.graph.mul(stiffness, stretch);
            Effort { force: interpreter.graph.neg(pull), along: along.value }
        }
    }
}

/// -c x', or minus the force that is given for a rate of x'.
fn damper(law: &Expression, along: Option<Along>, interpreter: &mut Interpreter) -> Option<Effort> {
    if law.mentions(STRETCH) && interpreter.values.get_region(STRETCH).is_none() {
        return interpreter.refuse(law.region, "`stretch` belongs to springs; the force of a damper depends on `rate`");
    }
    if !law.mentions(RATE) {
        let (needed, what) = needed("the coefficient of a damper", along.as_ref(), Along::damping);
        let coefficient = load_scalar(law, needed, &what, interpreter);
        let (coefficient, along) = (coefficient?, along?);
        let rate = rate_of(&along, interpreter);
        let force = interpreter.graph.mul(coefficient, rate);
        return Some(Effort { force: interpreter.graph.neg(force), along: along.value });
    }
    let along = along?;
    let words = vec![rate_word(&along, interpreter)];
    let force = law_of_force(law, words, needed("the force of a damper", Some(&along), Along::force), interpreter)?;
    Some(Effort { force: interpreter.graph.neg(force), along: along.value })
}

/// -F tanh(x'/v0): Coulomb friction, smoothed at speeds of a few v0 (Andersson, Soederberg, Bjoerklund: Friction models
/// for sliding dry, boundary and mixed lubricated contacts, Tribology International 40, 2007).
fn friction(
    force: &Expression,
    smooth: &Expression,
    along: Option<Along>,
    interpreter: &mut Interpreter,
) -> Option<Effort> {
    let (needed_force, of_force) = needed("the size of friction", along.as_ref(), Along::force);
    let (needed_speed, of_speed) = needed("the speed over which friction is smoothed", along.as_ref(), Along::rate);
    let size = load_scalar(force, needed_force, &of_force, interpreter);
    let speed = load_scalar(smooth, needed_speed, &of_speed, interpreter);
    let (size, speed, along) = (size?, speed?, along?);
    if interpreter.graph.is_zero(speed) {
        let message =
            "the speed over which friction is smoothed must be above 0: a force that jumps cannot be integrated";
        return interpreter.refuse(smooth.region, message);
    }
    let rate = rate_of(&along, interpreter);
    let ratio = interpreter.graph.div(rate, speed);
    let part = interpreter.graph.call(Function::Tanh, ratio);
    let force = interpreter.graph.mul(size, part);
    Some(Effort { force: interpreter.graph.neg(force), along: along.value })
}

fn rate_of(along: &Along, interpreter: &mut Interpreter) -> Expr {
    let Interpreter { graph, motion, .. } = interpreter;
    motion.of(graph, along.value)
}

fn rate_word(along: &Along, interpreter: &mut Interpreter) -> (&'static str, Value) {
    (RATE, Value::scalar(rate_of(along, interpreter), along.rate()))
}

/// A law with words that have a meaning only there.
fn law_of_force(
    law: &Expression,
    words: Vec<(&'static str, Value)>,
    (needed, what): (Option<Dimension>, String),
    interpreter: &mut Interpreter,
) -> Option<Expr> {
    for (word, _) in &words {
        if law.mentions(word)
            && let Some(own) = interpreter.values.get_region(word)
        {
            let mut mistake = law.region.error(format!("in the law of an element `{word}` has its own meaning"));
            mistake.combine(own.error(format!("choose another name for this `{word}`")));
            interpreter.mistakes.add(mistake);
            return None;
        }
    }
    interpreter.local = words;
    let force = load_scalar(law, needed, &what, interpreter);
    interpreter.local.clear();
    force
}
