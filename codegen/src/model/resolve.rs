//! The whole declaration, block by block.

use super::interpret::Interpreter;
use super::scope::{Names, check_reserved, plain};
use super::start::{in_unit, resolve_initial};
use super::value::{Shape as ValueShape, Value};
use super::*;
use crate::dsl::{self, Declaration, Expression, Region};
use crate::mistakes::Mistakes;
use syn::Ident;

const MOVING: Dependence = Dependence::COORDINATE.or(Dependence::SPEED).or(Dependence::ACCELERATION);
const BEYOND_POSITION: Dependence = Dependence::SPEED.or(Dependence::ACCELERATION).or(Dependence::MULTIPLIER);
const DRAWN: &str = "what is drawn";
const BEYOND_SPEED: Dependence = Dependence::ACCELERATION.or(Dependence::MULTIPLIER);

/// Resolves a declaration.
///
/// # Errors
/// All mistakes of meaning, each at the user's own word, combined into one error.
pub fn resolve(declaration: &Declaration) -> syn::Result<Model> {
    if declaration.coordinates.is_empty() {
        let place = Region::from(&declaration.head.name);
        return Err(place.error("a mechanism needs at least one coordinate: `coordinates { phi [rad]; }`"));
    }
    let mut graph = Graph::new();
    let time = graph.symbol("t");
    let mut dependences = Dependences::default();
    dependences.declare(time, Dependence::TIME);
    let mut interpreter = Interpreter {
        time: graph.variable(time),
        graph,
        dependences,
        values: Names::new("value"),
        reactions: None,
        outputs: declaration
            .outputs
            .iter()
            .flat_map(|group| &group.outputs)
            .map(|output| plain(&output.name))
            .collect(),
        motion: Differential::along([]),
        mistakes: Mistakes::default(),
    };
    let i = &mut interpreter;
    let mut coordinates = resolve_coordinates(declaration, i);
    let parameters = resolve_parameters(declaration, i);
    i.motion = time_derivative(&mut i.graph, time, &coordinates);
    let named = resolve_lets(declaration, i);
    let (bodies, body_names) = resolve_bodies(declaration, i);
    let loads = resolve_loads(declaration, &bodies, &body_names, i);
    let constraints = resolve_constraints(declaration, i);
    resolve_initial(&declaration.initial, &mut coordinates, i);
    let events = resolve_events(declaration, i);
    let (outputs, groups) = resolve_outputs(declaration, &coordinates, &constraints, i);
    let drawing = resolve_drawing(declaration, i);
    check_coordinates_used(declaration, &coordinates, &bodies, &constraints, i);
    let Interpreter { graph, dependences, mistakes, .. } = interpreter;
    mistakes.or(Model {
        name: plain(&declaration.head.name),
        docs: declaration.head.docs.clone(),
        graph,
        dependences,
        time,
        coordinates,
        parameters,
        named,
        bodies: bodies.into_iter().flatten().collect(),
        gravity: loads.gravity,
        forces: loads.forces,
        torques: loads.torques,
        constraints,
        events,
        outputs,
        groups,
        drawing,
    })
}

fn resolve_unit(unit: &Option<dsl::Unit>, i: &mut Interpreter) -> Unit {
    match unit {
        Some(unit) => i.mistakes.note(Unit::resolve(unit)).unwrap_or_else(Unit::none),
        None => Unit::none(),
    }
}

fn define(name: &Ident, value: Option<Value>, i: &mut Interpreter) {
    match check_reserved(name) {
        Ok(()) => i.values.define(name, value, &mut i.mistakes),
        Err(mistake) => i.mistakes.add(mistake),
    }
}

fn resolve_coordinates(declaration: &Declaration, i: &mut Interpreter) -> Vec<Coordinate> {
    let mut coordinates: Vec<Coordinate> = Vec::new();
    for c in &declaration.coordinates {
        let name = plain(&c.name);
        if let Some(base) = rate_of(&name, declaration.coordinates.iter().map(|c| plain(&c.name))) {
            i.mistakes.add(Region::from(&c.name).error(format!(
                "`{name}` is the name of a rate of `{base}` in files and on the command line; choose another name"
            )));
        }
        let unit = resolve_unit(&c.unit, i);
        let position = i.graph.symbol(&name);
        let speed = i.graph.symbol(&format!("{name}_dot"));
        let acceleration = i.graph.symbol(&format!("{name}_ddot"));
        i.dependences.declare(position, Dependence::COORDINATE);
        i.dependences.declare(speed, Dependence::SPEED);
        i.dependences.declare(acceleration, Dependence::ACCELERATION);
        let variable = i.graph.variable(position);
        define(&c.name, Some(Value::scalar(variable, Some(unit.dimension().clone()))), i);
        let (docs, start, start_speed) = (c.docs.clone(), Start::Free, None);
        coordinates.push(Coordinate { name, docs, unit, position, speed, acceleration, start, start_speed });
    }
    coordinates
}

/// The coordinate of which this is the name of a speed or acceleration.
fn rate_of(name: &str, mut coordinates: impl Iterator<Item = String>) -> Option<String> {
    let base = name.strip_suffix("_dot").or_else(|| name.strip_suffix("_ddot"))?;
    coordinates.find(|coordinate| coordinate == base)
}

fn resolve_parameters(declaration: &Declaration, i: &mut Interpreter) -> Vec<Parameter> {
    let mut parameters = Vec::new();
    for p in &declaration.parameters {
        let name = plain(&p.name);
        let unit = resolve_unit(&p.unit, i);
        let symbol = i.graph.symbol(&name);
        i.dependences.declare(symbol, Dependence::PARAMETER);
        let default = parameter_default(&p.value, &unit, i);
        let variable = i.graph.variable(symbol);
        define(&p.name, Some(Value::scalar(variable, Some(unit.dimension().clone()))), i);
        if let Some(default) = default {
            parameters.push(Parameter { name, docs: p.docs.clone(), unit, symbol, default });
        }
    }
    parameters
}

fn parameter_default(expression: &Expression, unit: &Unit, i: &mut Interpreter) -> Option<Expr> {
    let value = in_unit(expression, unit, i)?;
    let any = MOVING.or(Dependence::TIME).or(Dependence::PARAMETER);
    i.restrict(
        expression.region,
        &[value],
        any,
        "the default of a parameter is a number; what follows from other parameters is a `let`",
    )?;
    Some(value)
}

fn resolve_lets(declaration: &Declaration, i: &mut Interpreter) -> Vec<(String, Expr)> {
    let mut named = Vec::new();
    for (at, definition) in declaration.lets.iter().enumerate() {
        let value = match later_use(&definition.value, &declaration.lets[at..]) {
            Some(mistake) => {
                i.mistakes.add(mistake);
                None
            }
            None => i.value(&definition.value),
        };
        let name = plain(&definition.name);
        match value.as_ref().map(|value| value.shape) {
            Some(ValueShape::Scalar(scalar)) => named.push((name, scalar)),
            Some(ValueShape::Vector([x, y])) => named.extend([(format!("{name}_x"), x), (format!("{name}_y"), y)]),
            None => {}
        }
        define(&definition.name, value, i);
    }
    named
}

/// A mistake if an expression uses a `let` that comes later, or itself.
fn later_use(expression: &Expression, later: &[dsl::Let]) -> Option<syn::Error> {
    use dsl::Kind;
    match &expression.kind {
        Kind::Number { .. } => None,
        Kind::Name(name) => {
            let at = later.iter().position(|definition| definition.name == *name)?;
            let message = match at {
                0 => format!("`{name}` is defined by itself"),
                _ => format!("`{name}` is defined only below; move its `let` above this line"),
            };
            Some(Region::from(name).error(message))
        }
        Kind::Vector(parts) | Kind::Call(_, parts) => parts.iter().find_map(|part| later_use(part, later)),
        Kind::Negate(part) | Kind::Component(part, _) => later_use(part, later),
        Kind::Binary(_, left, right) => later_use(left, later).or_else(|| later_use(right, later)),
    }
}

/// Bodies in order, a mistaken one as `None`, with their places by name.
fn resolve_bodies(declaration: &Declaration, i: &mut Interpreter) -> (Vec<Option<Body>>, Names<usize>) {
    let mut names = Names::new("body");
    let mut bodies = Vec::new();
    for (at, b) in declaration.bodies.iter().enumerate() {
        names.define(&b.name, Some(at), &mut i.mistakes);
        let body = resolve_body(b, i);
        bodies.push(body);
    }
    if declaration.bodies.is_empty() {
        let place = Region::from(&declaration.head.name);
        i.mistakes.add(
            place.error("a mechanism needs at least one body: `bodies { rod: mass m at G, inertia J, angle phi; }`"),
        );
    }
    (bodies, names)
}

fn resolve_body(b: &dsl::Body, i: &mut Interpreter) -> Option<Body> {
    let name = plain(&b.name);
    let place = Region::from(&b.name);
    // Every part is looked at before the first mistake counts.
    let mass = b.mass.as_ref().map(|(mass, position)| resolve_mass(mass, position.as_ref(), &name, i));
    let angle = b.angle.as_ref().map(|angle| position_scalar(angle, "the angle of a body", i));
    let inertia = b.inertia.as_ref().map(|inertia| {
        let value = i.scalar(inertia)?;
        inertial(inertia, value, i)
    });
    if let (Some(inertia), None) = (&b.inertia, &b.angle) {
        return i.refuse(inertia.region, format!("about which angle does `{name}` turn? Write `inertia J, angle phi`"));
    }
    let zero = i.graph.zero();
    let mass = mass.map_or(Some(None), |mass| mass.map(Some))?;
    let angle = angle.map_or(Some(None), |angle| angle.map(Some))?;
    let inertia = inertia.unwrap_or(Some(zero))?;
    let rotation = angle.map(|angle| (inertia, angle));
    let moved: Vec<Expr> = mass.iter().flat_map(|(_, p)| *p).chain(angle).collect();
    if !moved.iter().any(|x| i.dependences.of(&i.graph, *x).meets(Dependence::COORDINATE.or(Dependence::TIME))) {
        return i.refuse(
            place,
            format!(
                "no coordinate moves body `{name}`; leave it out, or let its position or angle depend on a coordinate"
            ),
        );
    }
    Some(Body { name, mass, rotation })
}

fn resolve_mass(
    mass: &Expression,
    position: Option<&Expression>,
    body: &str,
    i: &mut Interpreter,
) -> Option<(Expr, Point)> {
    let value = i.scalar(mass).and_then(|value| inertial(mass, value, i));
    let Some(position) = position else {
        return i.refuse(
            mass.region,
            format!("where is the mass of `{body}`? Write `mass m at P`, P being its centre of mass"),
        );
    };
    let at = i.point(position).and_then(|at| position_level(position, at, "the position of a mass", i));
    value.zip(at)
}

/// A mass or moment of inertia: made of parameters.
fn inertial(expression: &Expression, value: Expr, i: &mut Interpreter) -> Option<Expr> {
    i.restrict(
        expression.region,
        &[value],
        MOVING.or(Dependence::TIME),
        "a mass or inertia is made of numbers and parameters; it cannot change with the motion",
    )?;
    if i.graph.as_number(value).is_some_and(|number| number.is_negative()) {
        return i.refuse(expression.region, "a mass or inertia cannot be negative");
    }
    Some(value)
}

fn position_level<const N: usize>(
    expression: &Expression,
    values: [Expr; N],
    what: &str,
    i: &mut Interpreter,
) -> Option<[Expr; N]> {
    i.restrict(
        expression.region,
        &values,
        BEYOND_POSITION,
        &format!("{what} is made of coordinates, parameters and time; `dot()` cannot stand in it"),
    )?;
    Some(values)
}

#[derive(Default)]
struct Loads {
    gravity: Option<Point>,
    forces: Vec<Force>,
    torques: Vec<Torque>,
}

fn resolve_loads(
    declaration: &Declaration,
    bodies: &[Option<Body>],
    names: &Names<usize>,
    i: &mut Interpreter,
) -> Loads {
    let mut loads = Loads::default();
    let mut gravity_at: Option<Region> = None;
    for load in &declaration.loads {
        match load {
            dsl::Load::Force { force, point } => {
                let (value, at) = (i.point(force), i.point(point));
                let value = value.and_then(|value| load_level(force, value, i));
                let at = at.and_then(|at| position_level(point, at, "the point of a force", i));
                if let (Some(force), Some(at)) = (value, at) {
                    loads.forces.push(Force { force, at });
                }
            }
            dsl::Load::Torque { moment, body } => {
                let value = i.scalar(moment).and_then(|value| load_level(moment, [value], i));
                let body_at = names.find(body, &mut i.mistakes);
                let (Some([value]), Some(at)) = (value, body_at) else { continue };
                let Some(found) = &bodies[at] else { continue };
                match found.rotation {
                    Some((_, angle)) => loads.torques.push(Torque { moment: value, angle }),
                    None => i.mistakes.add(Region::from(body).error(format!(
                        "a torque turns an angle, and body `{body}` has none; write `angle phi` in its line"
                    ))),
                }
            }
            dsl::Load::Gravity { keyword, acceleration } => {
                if let Some(first) = gravity_at.replace(*keyword) {
                    let mut mistake = keyword.error("gravity is declared twice; keep one");
                    mistake.combine(first.error("it is first declared here"));
                    i.mistakes.add(mistake);
                }
                let value = i.point(acceleration).and_then(|value| load_level(acceleration, value, i));
                loads.gravity = value.or(loads.gravity);
                let massless = declaration.bodies.iter().all(|body| body.mass.is_none());
                if massless && !declaration.bodies.is_empty() {
                    i.mistakes
                        .add(keyword.error(
                            "gravity acts on masses, and no body has one; write `mass m at P` in a body's line",
                        ));
                }
            }
        }
    }
    loads
}

fn load_level<const N: usize>(expression: &Expression, values: [Expr; N], i: &mut Interpreter) -> Option<[Expr; N]> {
    i.restrict(
        expression.region,
        &values,
        BEYOND_SPEED,
        "a load is made of coordinates, speeds, parameters and time; `ddot()` cannot stand in it",
    )?;
    Some(values)
}

fn resolve_constraints(declaration: &Declaration, i: &mut Interpreter) -> Vec<Constraint> {
    let mut rows = Vec::new();
    let mut reactions = Names::new("constraint");
    for equation in &declaration.constraints {
        let first = rows.len();
        let sides = equation_sides(equation, i);
        if let Some(sides) = sides {
            constraint_rows(equation, sides, &mut rows, i);
        }
        let multipliers: Vec<Expr> =
            rows[first..].iter().map(|row: &Constraint| i.graph.variable(row.multiplier)).collect();
        let dimension = rows.get(first).map(|row| row.unit.dimension().clone());
        let reaction = match multipliers.as_slice() {
            [one] => Some(Value::scalar(*one, dimension)),
            [x, y] => Some(Value { shape: ValueShape::Vector([*x, *y]), dimension }),
            _ => None,
        };
        reactions.define(&equation.name, reaction, &mut i.mistakes);
    }
    i.reactions = Some(reactions);
    rows
}

/// left - right, both scalars or both vectors.
fn equation_sides(equation: &dsl::Equation, i: &mut Interpreter) -> Option<Value> {
    let (left, right) = (i.value(&equation.left), i.value(&equation.right));
    let (left, right) = (left?, right?);
    let dimension = super::value::common_dimension(left.dimension.clone(), right.dimension.clone());
    let shape = match (left.shape, right.shape) {
        (ValueShape::Scalar(l), ValueShape::Scalar(r)) => ValueShape::Scalar(i.graph.sub(l, r)),
        (ValueShape::Vector([lx, ly]), ValueShape::Vector([rx, ry])) => {
            ValueShape::Vector([i.graph.sub(lx, rx), i.graph.sub(ly, ry)])
        }
        _ => {
            let message = format!("{} stands left and {} right; both sides are of one kind", left.kind(), right.kind());
            return i.refuse(equation.left.region.to(equation.right.region), message);
        }
    };
    Some(Value { shape, dimension })
}

fn constraint_rows(
    equation: &dsl::Equation,
    value: Value,
    rows: &mut Vec<Constraint>,
    i: &mut Interpreter,
) -> Option<()> {
    let place = equation.left.region.to(equation.right.region);
    let name = plain(&equation.name);
    let components = value.components();
    i.restrict(
        place,
        &components,
        BEYOND_POSITION,
        "a constraint holds between positions; `dot()` cannot stand in it",
    )?;
    let unit = match &value.dimension {
        Some(dimension) => Unit::coherent(Dimension::energy().over(dimension)),
        None => Unit::none(),
    };
    let suffixes: &[&str] = if components.len() == 1 { &[""] } else { &["_x", "_y"] };
    for (value, suffix) in components.into_iter().zip(suffixes) {
        if !i.dependences.of(&i.graph, value).meets(Dependence::COORDINATE) {
            return i.refuse(Region::from(&equation.name), format!("no coordinate moves constraint `{name}{suffix}`: it holds always or never; leave it out, or let it depend on a coordinate"));
        }
        let multiplier = i.graph.symbol(&format!("lambda_{name}{suffix}"));
        i.dependences.declare(multiplier, Dependence::MULTIPLIER);
        rows.push(Constraint { name: format!("{name}{suffix}"), value, multiplier, unit: unit.clone() });
    }
    Some(())
}

fn resolve_events(declaration: &Declaration, i: &mut Interpreter) -> Vec<Event> {
    let mut names = Names::new("event");
    let mut events = Vec::new();
    for equation in &declaration.events {
        names.define(&equation.name, Some(()), &mut i.mistakes);
        let Some(value) = equation_sides(equation, i) else { continue };
        let place = equation.left.region.to(equation.right.region);
        let ValueShape::Scalar(value) = value.shape else {
            i.mistakes.add(place.error("an event is an equation between scalars; take a component (`.x`, `.y`)"));
            continue;
        };
        let rule = "an event is a condition on coordinates, speeds and time";
        if i.restrict(place, &[value], BEYOND_SPEED, rule).is_none() {
            continue;
        }
        if !i.dependences.of(&i.graph, value).meets(MOVING.or(Dependence::TIME)) {
            i.mistakes.add(Region::from(&equation.name).error(format!(
                "event `{}` never changes; let it depend on a coordinate, a speed or `t`",
                equation.name
            )));
            continue;
        }
        events.push(Event { name: plain(&equation.name), value });
    }
    events
}

fn resolve_outputs(
    declaration: &Declaration,
    coordinates: &[Coordinate],
    constraints: &[Constraint],
    i: &mut Interpreter,
) -> (Vec<Output>, Vec<OutputGroup>) {
    let mut columns: Vec<String> = vec!["t".into()];
    columns.extend(
        coordinates.iter().flat_map(|c| [c.name.clone(), format!("{}_dot", c.name), format!("{}_ddot", c.name)]),
    );
    columns.extend(constraints.iter().map(|c| format!("lambda_{}", c.name)));
    let mut names = Names::new("output");
    let mut figures = Vec::new();
    let (mut outputs, mut groups) = (Vec::new(), Vec::new());
    for group in &declaration.outputs {
        if let Some(name) = group.name.as_ref().or(group.outputs.first().map(|output| &output.name)) {
            let defined_twice = group.name.is_none() && names.get_region(&plain(name)).is_some();
            if !defined_twice {
                define_figure(name, &mut figures, i);
            }
        }
        let first = outputs.len();
        for output in &group.outputs {
            let name = plain(&output.name);
            names.define(&output.name, Some(()), &mut i.mistakes);
            if columns.contains(&name) {
                i.mistakes.add(
                    Region::from(&output.name)
                        .error(format!("`{name}` is recorded already, under this name; choose another")),
                );
            }
            let unit = resolve_unit(&output.unit, i);
            if let Some(value) = output_value(output, &name, i) {
                outputs.push(Output { name, docs: output.docs.clone(), unit, value });
            }
        }
        if let Some(output) = group.outputs.first() {
            let name = plain(group.name.as_ref().unwrap_or(&output.name));
            let title = group.title.clone().unwrap_or_else(|| default_title(group, output));
            groups.push(OutputGroup { name, title, len: outputs.len() - first });
        }
    }
    (outputs, groups)
}

/// Figures are files, and some file systems do not tell letter case apart.
fn define_figure(name: &Ident, figures: &mut Vec<(String, Region)>, i: &mut Interpreter) {
    let file = plain(name).to_lowercase();
    if file == "mechanism" {
        i.mistakes
            .add(Region::from(name).error("`mechanism` is the figure of the mechanism itself; choose another name"));
    }
    if let Some((_, first)) = figures.iter().find(|(other, _)| *other == file) {
        let mut mistake = Region::from(name)
            .error(format!("two figures would be called `{file}`; choose another name for one of them"));
        mistake.combine(first.error("the other one is here"));
        i.mistakes.add(mistake);
    }
    figures.push((file, name.into()));
}

fn output_value(output: &dsl::Output, name: &str, i: &mut Interpreter) -> Option<Expr> {
    let value = i.value(&output.value)?;
    match value.shape {
        ValueShape::Scalar(value) => Some(value),
        ValueShape::Vector(_) => i.refuse(
            output.value.region,
            format!("output `{name}` is a vector; write one output for each component: `{name}_x = (..).x;`"),
        ),
    }
}

/// The first line of an output's documentation, or its name.
fn default_title(group: &dsl::OutputGroup, output: &dsl::Output) -> String {
    match (&group.name, output.docs.lines().next()) {
        (None, Some(line)) if !line.is_empty() => line.trim_end_matches('.').to_owned(),
        (Some(name), _) => plain(name).replace('_', " "),
        (None, _) => plain(&output.name).replace('_', " "),
    }
}

fn resolve_drawing(declaration: &Declaration, i: &mut Interpreter) -> Vec<Shape> {
    declaration.drawing.iter().filter_map(|shape| resolve_shape(shape, i)).collect()
}

fn resolve_shape(shape: &dsl::Shape, i: &mut Interpreter) -> Option<Shape> {
    match shape {
        dsl::Shape::Line(points) => drawn_points(points, i).map(Shape::Line),
        dsl::Shape::Ground(points) => drawn_points(points, i).map(Shape::Ground),
        dsl::Shape::Points(points) => drawn_points(points, i).map(Shape::Points),
        dsl::Shape::Slider { at, along } => {
            let (point, angle) = (drawn_point(at, i), position_scalar(along, DRAWN, i));
            Some(Shape::Slider(point?, angle?))
        }
        dsl::Shape::Circle { at, radius } => {
            let (point, radius) = (drawn_point(at, i), position_scalar(radius, DRAWN, i));
            Some(Shape::Circle(point?, radius?))
        }
    }
}

fn drawn_points(points: &[Expression], i: &mut Interpreter) -> Option<Vec<Point>> {
    let points: Vec<_> = points.iter().map(|point| drawn_point(point, i)).collect();
    points.into_iter().collect()
}

fn drawn_point(expression: &Expression, i: &mut Interpreter) -> Option<Point> {
    let point = i.point(expression)?;
    position_level(expression, point, DRAWN, i)
}

fn position_scalar(expression: &Expression, what: &str, i: &mut Interpreter) -> Option<Expr> {
    let value = i.scalar(expression)?;
    position_level(expression, [value], what, i).map(|[value]| value)
}

/// A coordinate that neither moves a body nor stands in a constraint has no equation of motion.
fn check_coordinates_used(
    declaration: &Declaration,
    coordinates: &[Coordinate],
    bodies: &[Option<Body>],
    constraints: &[Constraint],
    i: &mut Interpreter,
) {
    // Another mistake may be why it is not used.
    if !i.mistakes.is_empty() {
        return;
    }
    let mut roots: Vec<Expr> = constraints.iter().map(|c| c.value).collect();
    for body in bodies.iter().flatten() {
        roots.extend(body.mass.iter().flat_map(|(_, at)| *at));
        roots.extend(body.rotation.map(|(_, angle)| angle));
    }
    let used = i.graph.symbols_of(&roots);
    for (c, written) in coordinates.iter().zip(&declaration.coordinates) {
        if !used.contains(&c.position) {
            i.mistakes.add(Region::from(&written.name).error(format!(
                "coordinate `{}` moves no body and stands in no constraint; use it or leave it out",
                c.name
            )));
        }
    }
}
