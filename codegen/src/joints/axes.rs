//! Axes of joints by name: `let s = [0.6, 0, 0.8]; .. axis s` means `axis [0.6, 0, 0.8]`. Later stages see only the
//! latter.

use super::made::negated;
use crate::dsl::{Declaration, Expression, JointKind, Kind, Let};

/// Replaces names by their definitions in the axes of joints and the normals of planes.
pub(super) fn write_out(declaration: &mut Declaration) {
    let Declaration { joints, lets, .. } = declaration;
    for joint in joints {
        let axes = match &mut joint.kind {
            JointKind::Spatial(joint) => [&mut joint.first.axis, &mut joint.second.axis].map(Option::as_mut),
            JointKind::Rolling(rolling) => [Some(&mut rolling.axis), Some(&mut rolling.normal)],
            _ => continue,
        };
        for axis in axes.into_iter().flatten() {
            *axis = written(axis, lets);
        }
    }
}

/// An axis with named vectors and numbers written out. Expressions that depend on parameters keep their names.
fn written(axis: &Expression, lets: &[Let]) -> Expression {
    let kind = match &axis.kind {
        Kind::Name(name) => lets.iter().rposition(|definition| definition.name == *name).and_then(|at| {
            let value = written(&lets[at].value, &lets[..at]);
            (matches!(value.kind, Kind::Vector(_)) || is_numeric(&value)).then_some(value.kind)
        }),
        Kind::Negate(operand) => match written(operand, lets) {
            Expression { kind: Kind::Vector(components), .. } => {
                Some(Kind::Vector(components.into_iter().map(negated).collect()))
            }
            operand => Some(Kind::Negate(Box::new(operand))),
        },
        Kind::Vector(parts) => Some(Kind::Vector(parts.iter().map(|part| written(part, lets)).collect())),
        Kind::Call(function, parts) => {
            Some(Kind::Call(function.clone(), parts.iter().map(|part| written(part, lets)).collect()))
        }
        Kind::Binary(operator, left, right) => {
            Some(Kind::Binary(*operator, Box::new(written(left, lets)), Box::new(written(right, lets))))
        }
        _ => None,
    };
    Expression { region: axis.region, kind: kind.unwrap_or_else(|| axis.kind.clone()) }
}

/// Whether an expression is of numbers alone, without a unit.
fn is_numeric(expression: &Expression) -> bool {
    match &expression.kind {
        Kind::Number { unit, .. } => unit.is_none(),
        Kind::Negate(_) | Kind::Binary(..) | Kind::Call(..) => expression.parts().into_iter().all(is_numeric),
        _ => false,
    }
}
