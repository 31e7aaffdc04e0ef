//! Bodies as frames: points fixed on them, and joints between them, written out as ordinary expressions and equations. Later
//! stages know neither.
//!
//! A body with a position P and an angle phi is a frame: the point `on(body, [u, v])` is P + R(phi) [u, v].

use super::given::with_suffix;
use super::joint::{Joint, JointKind};
use super::made::{
    across, attitude, binary, call, called, component, difference, direction, inner, product, vector, zero,
};
use super::spatial_joint::{Placed, equations, named, rolls, screw};
use super::{
    Action, Activity, Body, Declaration, Element, Equation, Expression, Extent, Initial, Kind, Law, Load, Operator,
    Region, Shape, Side, SpatialJoint,
};
use crate::mistakes::Mistakes;
use crate::nearest;
use syn::{Ident, Result};

/// Writes out all joints and all points on bodies.
///
/// # Errors
/// Bodies that are not there, or have no position or no angle.
pub(super) fn write_out(mut declaration: Declaration) -> Result<Declaration> {
    let frames = Frames::of(&declaration)?;
    let mut mistakes = Mistakes::default();
    for joint in std::mem::take(&mut declaration.joints) {
        if let Some(equations) = mistakes.note(frames.equations(joint)) {
            declaration.constraints.extend(equations);
        }
    }
    for expression in expressions(&mut declaration) {
        mistakes.note(frames.write_out(expression));
    }
    mistakes.or(declaration)
}

/// Where bodies are and how they are turned.
struct Frames {
    bodies: Vec<Frame>,
    /// The names of tables.
    tables: Vec<String>,
}

struct Frame {
    name: Ident,
    position: Option<Expression>,
    angle: Option<Expression>,
    attitude: Option<Expression>,
}

impl Frames {
    /// Those of the bodies, each written out by those before it.
    fn of(declaration: &Declaration) -> Result<Frames> {
        let tables = declaration.tables.iter().map(|table| table.name.to_string()).collect();
        let mut frames = Frames { bodies: Vec::new(), tables };
        for Body { name, mass, angle, attitude, .. } in &declaration.bodies {
            let position = mass.as_ref().and_then(|(_, position)| position.as_ref()).cloned();
            let mut frame = Frame { name: name.clone(), position, angle: angle.clone(), attitude: attitude.clone() };
            for expression in frame.position.iter_mut().chain(&mut frame.angle).chain(&mut frame.attitude) {
                frames.write_out(expression)?;
            }
            frames.bodies.push(frame);
        }
        Ok(frames)
    }

    fn find(&self, name: &Ident) -> Result<&Frame> {
        let unknown = || unknown_body(name, &self.bodies.iter().map(|body| &body.name).collect::<Vec<_>>());
        self.bodies.iter().find(|body| body.name == *name).ok_or_else(unknown)
    }

    /// A table at the angle of a body.
    fn lift(&self, table: &Ident, wheel: &Ident) -> Result<Expression> {
        let text = table.to_string();
        if !self.tables.contains(&text) {
            let near = nearest::suggestion(&text, self.tables.iter().map(String::as_str));
            let message = format!("no table is called `{text}`{near}: `tables {{ {text} [mm] over [deg] = .. }}`");
            return Err(Region::from(table).error(message));
        }
        Ok(called(table, self.angle(wheel)?))
    }

    fn position(&self, body: &Ident) -> Result<Expression> {
        let missing = || {
            Region::from(body)
                .error(format!("body `{body}` has no place; write `mass m at P` in its line, or let it be `free`"))
        };
        self.find(body)?.position.clone().ok_or_else(missing)
    }

    fn angle(&self, body: &Ident) -> Result<Expression> {
        let missing = || {
            Region::from(body)
                .error(format!("body `{body}` has no angle; write `angle phi` in its line, or let it be `free`"))
        };
        self.find(body)?.angle.clone().ok_or_else(missing)
    }

    /// The equations of a joint.
    fn equations(&self, joint: Joint) -> Result<Vec<Equation>> {
        let Joint { name, kind, initially, .. } = joint;
        let at = Region::from(&name);
        let equation = |left, right| Equation { name: name.clone(), left, right, initially, is_of_joint: true };
        Ok(match kind {
            JointKind::Pin(first, second) => vec![equation(first, second)],
            JointKind::Link(first, second, length) => {
                vec![equation(call(at, "norm", vec![difference(first, second)]), length)]
            }
            JointKind::Slot(point, guide) => vec![equation(across(at, point, &guide), zero(at))],
            JointKind::Slide(body, guide) => {
                let turned = Equation {
                    name: with_suffix(&name, "turn"),
                    left: self.angle(&body)?,
                    right: guide.along.clone(),
                    initially,
                    is_of_joint: true,
                };
                vec![equation(across(at, self.position(&body)?, &guide), zero(at)), turned]
            }
            JointKind::Gear([(first, r), (second, s)]) => {
                let turned = [product(r, self.angle(&first)?), product(s, self.angle(&second)?)];
                let [left, right] = turned;
                vec![equation(binary(Operator::Add, left, right), zero(at))]
            }
            JointKind::Rack(point, guide, wheel, radius) => {
                let way = inner(at, difference(point, guide.through), direction(at, &guide.along));
                vec![equation(way, product(radius, self.angle(&wheel)?))]
            }
            JointKind::Cam(point, guide, wheel, radius, lift) => {
                let way = inner(at, difference(point, guide.through), direction(at, &guide.along));
                vec![equation(binary(Operator::Add, radius, self.lift(&lift, &wheel)?), way)]
            }
            JointKind::Rocker(arm, wheel, lift) => {
                vec![equation(self.lift(&lift, &wheel)?, self.angle(&arm)?)]
            }
            JointKind::Spatial(joint) => self.spatial(&name, *joint, initially)?,
            JointKind::Rolling(rolling) => {
                let (centre, attitude) = (self.position(&rolling.disc)?, self.attitude(&rolling.disc)?);
                let spin = call(at, "angular_velocity", vec![attitude.clone()]);
                let rows = rolls(at, &rolling, centre, product(attitude, rolling.axis.clone()), spin)?;
                rows.into_iter().map(|(suffix, left, right)| named(&name, suffix, left, right)).collect()
            }
            JointKind::Roll(wheel, radius, along) => {
                let speed = inner(at, call(at, "dot", vec![self.position(&wheel)?]), direction(at, &along));
                let turning = product(radius, call(at, "dot", vec![self.angle(&wheel)?]));
                vec![equation(binary(Operator::Add, speed, turning), zero(at))]
            }
        })
    }

    fn attitude(&self, body: &Ident) -> Result<Expression> {
        let missing = || {
            let message = format!("body `{body}` has no attitude; write `attitude R` in its line, or let it be `free`");
            Region::from(body).error(message)
        };
        let rotation = self.find(body)?.attitude.clone().ok_or_else(missing)?;
        Ok(attitude(rotation.region, body, rotation))
    }

    /// The equations of a joint of bodies in space.
    fn spatial(&self, name: &Ident, joint: SpatialJoint, initially: Option<Activity>) -> Result<Vec<Equation>> {
        let at = Region::from(name);
        let (first, second) = (self.placed(&joint.first)?, self.placed(&joint.second)?);
        let mut rows = equations(at, joint.kind, &first, &second);
        if let Some(pitch) = joint.pitch {
            let spins = [self.spin(at, &joint.first.body)?, self.spin(at, &joint.second.body)?];
            let (left, right) = screw(at, pitch, &first, &second, spins);
            rows.push(("_screw", left, right));
        }
        let equation = |(suffix, left, right)| Equation { initially, ..named(name, suffix, left, right) };
        Ok(rows.into_iter().map(equation).collect())
    }

    /// Whether a joint holds to the ground. A body may have that name.
    fn is_ground(&self, body: &Ident) -> bool {
        body == "ground" && self.bodies.iter().all(|frame| frame.name != "ground")
    }

    fn placed(&self, side: &Side) -> Result<Placed> {
        if self.is_ground(&side.body) {
            return Placed::new(side, side.at.clone(), |v| v);
        }
        let (position, attitude) = (self.position(&side.body)?, self.attitude(&side.body)?);
        let point = binary(Operator::Add, position, product(attitude.clone(), side.at.clone()));
        Placed::new(side, point, |v| product(attitude.clone(), v))
    }

    /// The angular velocity of a body.
    fn spin(&self, at: Region, body: &Ident) -> Result<Expression> {
        match self.is_ground(body) {
            true => Ok(vector(at, vec![zero(at); 3])),
            false => Ok(call(at, "angular_velocity", vec![self.attitude(body)?])),
        }
    }

    /// Writes out the points on bodies in an expression.
    fn write_out(&self, expression: &mut Expression) -> Result<()> {
        match &mut expression.kind {
            Kind::Number { .. } | Kind::Name(_) => Ok(()),
            Kind::Negate(part) | Kind::Component(part, _) => self.write_out(part),
            Kind::Binary(_, left, right) => self.write_out(left).and_then(|()| self.write_out(right)),
            Kind::Vector(parts) => parts.iter_mut().try_for_each(|part| self.write_out(part)),
            Kind::Call(function, parts) if function == "on" => {
                let parts = std::mem::take(parts);
                *expression = self.point(expression.region, parts)?;
                Ok(())
            }
            Kind::Call(function, parts) if function == "attitude" || function == "omega" => {
                if let [Expression { kind: Kind::Name(body), .. }] = parts.as_slice()
                    && let Ok(turned) = self.attitude(body)
                {
                    let mut turned = Expression { region: expression.region, ..turned };
                    if function == "omega" {
                        turned = call(expression.region, "angular_velocity", vec![turned]);
                    }
                    *expression = turned;
                    return Ok(());
                }
                parts.iter_mut().try_for_each(|part| self.write_out(part))
            }
            Kind::Attitude(_, rotation) => self.write_out(rotation),
            Kind::Call(_, parts) => parts.iter_mut().try_for_each(|part| self.write_out(part)),
            Kind::If(choice) => {
                let parts = [&mut choice.left, &mut choice.right, &mut choice.yes, &mut choice.no];
                parts.into_iter().try_for_each(|part| self.write_out(part))
            }
        }
    }

    /// P + [u cos(phi) - v sin(phi), u sin(phi) + v cos(phi)].
    fn point(&self, region: Region, parts: Vec<Expression>) -> Result<Expression> {
        let form = || region.error("a point on a body is written `on(body, [u, v])`, in space `on(body, [u, v, w])`");
        let [body, mut place] = <[Expression; 2]>::try_from(parts).map_err(|_| form())?;
        self.write_out(&mut place)?;
        let Kind::Name(body) = body.kind else { return Err(form()) };
        if self.find(&body)?.attitude.is_some() {
            let turned = product(self.attitude(&body)?, place);
            let mut point = binary(Operator::Add, self.position(&body)?, turned);
            point.region = region;
            return Ok(point);
        }
        let (position, angle) = (self.position(&body)?, self.angle(&body)?);
        let of_angle = |function| call(region, function, vec![angle.clone()]);
        let [u, v] = ["x", "y"].map(|axis| component(&place, axis));
        let x = binary(Operator::Subtract, product(u.clone(), of_angle("cos")), product(v.clone(), of_angle("sin")));
        let y = binary(Operator::Add, product(u, of_angle("sin")), product(v, of_angle("cos")));
        let arm = Expression { region, kind: Kind::Vector(vec![x, y]) };
        let mut point = binary(Operator::Add, position, arm);
        point.region = region;
        Ok(point)
    }
}

pub(super) fn unknown_body(name: &Ident, bodies: &[&Ident]) -> syn::Error {
    let text = name.to_string();
    let names: Vec<String> = bodies.iter().map(|body| body.to_string()).collect();
    let near = nearest::suggestion(&text, names.iter().map(String::as_str));
    Region::from(name).error(format!("no body above is called `{text}`{near}"))
}

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
