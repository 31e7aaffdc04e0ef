//! The expressions of a declaration.

use crate::dsl::{Action, Declaration, Element, Expression, Extent, Initial, Law, Load, Shape};

/// Every expression in which a point on a body may stand.
pub(super) fn expressions(declaration: &mut Declaration) -> Vec<&mut Expression> {
    let d = declaration;
    let mut all: Vec<&mut Expression> = d.lets.iter_mut().map(|l| &mut l.value).collect();
    for body in &mut d.bodies {
        all.extend(body.mass.iter_mut().flat_map(|(mass, at)| [mass].into_iter().chain(at)));
        all.extend(body.inertia.iter_mut().chain(&mut body.angle).chain(&mut body.attitude));
    }
    for load in &mut d.loads {
        match load {
            Load::Force { force, point } => all.extend([force, point]),
            Load::Torque { moment, .. } => all.push(moment),
            Load::Gravity { acceleration, .. } => all.push(acceleration),
            Load::Potential(function) | Load::Dissipation(function) => all.push(function),
            Load::Element(element) => all.extend(of_element(element)),
        }
    }
    all.extend(d.constraints.iter_mut().flat_map(|e| [&mut e.left, &mut e.right]));
    for event in &mut d.events {
        all.extend([&mut event.condition.left, &mut event.condition.right]);
        all.extend(event.actions.iter_mut().filter_map(of_action));
    }
    all.extend(d.initial.iter_mut().map(|Initial { value, .. }| value));
    all.extend(d.outputs.iter_mut().flat_map(|group| &mut group.outputs).map(|output| &mut output.value));
    for shape in &mut d.drawing {
        match shape {
            Shape::Points { points, .. } => all.extend(points),
            Shape::Slider { at, along } => all.extend([at, along]),
            Shape::Circle { at, radius, normal } => all.extend([at, radius].into_iter().chain(normal)),
        }
    }
    all
}

fn of_action(action: &mut Action) -> Option<&mut Expression> {
    match action {
        Action::Set { value, .. } => Some(value),
        Action::Impact { restitution, .. } => restitution.as_mut(),
        Action::Record | Action::Stop { .. } | Action::Swap(..) | Action::Switch { .. } => None,
    }
}

fn of_element(element: &mut Element) -> Vec<&mut Expression> {
    let law = match &mut element.law {
        Law::Force(law) | Law::Damper(law) => vec![law],
        Law::Spring(law, other) | Law::Friction(law, other) => vec![law, other],
    };
    let extent = match &mut element.extent {
        Extent::Distance(a, b) | Extent::Difference(a, b) => vec![a, b],
        Extent::Quantity(x) => vec![x],
    };
    law.into_iter().chain(extent).collect()
}
