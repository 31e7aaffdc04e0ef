//! The `auxiliary` block: zero displacements, to find their conjugate forces.
//!
//! A declaration with such displacements is resolved twice: once with the number 0 in their places, which gives exactly
//! the model without them, and once with variables, from which the conjugate forces are derived.

use super::interpreter::Interpreter;
use super::origin::Origin;
use super::quantities::{define, refuse_rate, resolve_unit};
use super::scope::plain;
use super::value::Value;
use super::{Auxiliary, Dependence, Dimension, Model};
use crate::dsl::{Declaration, Region};
use crate::mistakes::Mistakes;
use crate::symbolic::{Expr, Graph};

/// Whether auxiliary displacements are the number 0, or variables.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Displacements {
    Zero,
    Variable,
}

/// The auxiliary displacements, each with its conjugate force as a value.
pub(super) fn resolve_auxiliaries(
    declaration: &Declaration,
    displacements: Displacements,
    interpreter: &mut Interpreter,
) -> Vec<(Auxiliary, Value)> {
    let mut auxiliaries = Vec::new();
    for a in &declaration.auxiliary {
        let name = plain(&a.name);
        refuse_rate(&a.name, declaration, interpreter);
        let unit = resolve_unit(&a.unit, interpreter);
        let auxiliary = Auxiliary {
            displacement: interpreter.graph.symbol(&name),
            rate: interpreter.graph.symbol(&format!("{name}_dot")),
            reaction: interpreter.graph.symbol(&format!("reaction_{name}")),
            name,
        };
        interpreter.dependences.declare(auxiliary.displacement, Dependence::COORDINATE);
        interpreter.dependences.declare(auxiliary.rate, Dependence::SPEED);
        interpreter.dependences.declare(auxiliary.reaction, Dependence::ACCELERATION.or(Dependence::MULTIPLIER));
        let value = match displacements {
            Displacements::Zero => interpreter.graph.zero(),
            Displacements::Variable => interpreter.graph.variable(auxiliary.displacement),
        };
        let dimension = unit.map(|unit| unit.dimension().clone());
        interpreter.origins.add(plain(&a.name), Origin::Declared(a.unit.as_ref().map(|unit| unit.text.clone())));
        define(&a.name, Some(Value::scalar(value, dimension.clone())), interpreter);
        let reaction = interpreter.graph.variable(auxiliary.reaction);
        let force = Value::scalar(reaction, dimension.map(|dimension| Dimension::energy().over(&dimension)));
        auxiliaries.push((auxiliary, force));
    }
    auxiliaries
}

/// Refuses displacements that displace nothing: their conjugate forces would always be 0.
pub(super) fn check_displaced(declaration: &Declaration, displaced: &Model, graph: &Graph) -> syn::Result<()> {
    let mut mistakes = Mistakes::default();
    let moved = graph.symbols_of(&positions(displaced));
    for (written, auxiliary) in declaration.auxiliary.iter().zip(&displaced.auxiliaries) {
        if !moved.contains(&auxiliary.displacement) && !moved.contains(&auxiliary.rate) {
            mistakes.add(Region::from(&written.name).error(format!(
                "`{0}` displaces nothing; add it to the position of a body or of a load's point, or to a point in a \
                 constraint: `let B = A + [{0}, 0];`",
                auxiliary.name
            )));
        }
    }
    mistakes.or(())
}

/// Everything that a displacement may move.
fn positions(model: &Model) -> Vec<Expr> {
    let bodies = model.bodies.iter().flat_map(|body| {
        let mass = body.mass.iter().flat_map(|(_, at)| at.clone());
        let attitude = body.attitude.iter().flat_map(|attitude| attitude.matrix.concat());
        mass.chain(body.rotation.map(|(_, angle)| angle)).chain(attitude).collect::<Vec<_>>()
    });
    let pushed = model.pushes.iter().flat_map(|push| push.along.velocity);
    let forces = model.forces.iter().flat_map(|force| force.at.clone());
    let loads = forces.chain(model.efforts.iter().map(|effort| effort.along)).chain(pushed);
    bodies.chain(loads).chain(model.constraints.iter().map(|c| c.value)).collect()
}
