//! Forces and reactions as arrows on the mechanism.
//!
//! The declaration is read again, and the loads, the points they act at and the constraints' derivatives by their points
//! are evaluated as outputs of it, by the interpreter that also checks the kernels.

/// A force that can be drawn.
pub(super) struct Vector {
    /// What stands at its arrow.
    pub(super) label: String,
    /// What it is.
    pub(super) about: String,
    /// `load` or `reaction`.
    pub(super) kind: &'static str,
}

/// The forces of a run, each with its point and components, x y u v, at each of some samples.
#[cfg(not(feature = "analysis"))]
pub(super) fn vectors<M: sim_kernel::Mechanism>(_: &crate::Run<M>, _: &[usize]) -> Vec<(Vector, Vec<f64>)> {
    Vec::new()
}

#[cfg(feature = "analysis")]
pub(super) use declared::vectors;

#[cfg(feature = "analysis")]
mod declared {
    use super::Vector;
    use crate::{Run, Sample};
    use codegen::dsl::{self, Choice, Declaration, Expression, Kind, Load, Operator, Output, OutputGroup};
    use codegen::oracle::{Measured, Oracle, Solution, State};
    use sim_kernel::{Array, Mechanism};

    /// Half the distance between the two places from which a constraint's derivative is taken, in metres: exact to
    /// rounding for constraints of degree two in a point, which those of linkages are.
    const REACH: f64 = 0.000_976_562_5;

    /// Where an arrow's numbers come from.
    enum Source {
        /// Force and point, as outputs from this index: x, y, u, v.
        Load(usize),
        /// A scalar constraint at a point: x, y, and the differences of C along both.
        Reaction { first: usize, row: usize },
        /// A constraint between vectors, where its left side is: x, y.
        Joint { first: usize, row: usize },
    }

    /// The forces of a run, each with its point and components, x y u v, at each of some samples. None where the
    /// declaration cannot be read again.
    pub(in crate::show) fn vectors<M: Mechanism>(run: &Run<M>, samples: &[usize]) -> Vec<(Vector, Vec<f64>)> {
        let description = const { &M::DESCRIPTION };
        // Arrows have two components, as what they are drawn on.
        let tokens = description.declaration.parse().ok().filter(|_| description.dimension == 2);
        let Some(mut declaration) = tokens.and_then(|tokens| dsl::parse(tokens).ok()) else { return Vec::new() };
        let arrows = arrows(&declaration, description.constraints.len());
        let mut outputs = Vec::new();
        let sources: Vec<(Vector, Source)> =
            arrows.into_iter().map(|(vector, make)| (vector, make(&mut outputs))).collect();
        declaration.outputs = vec![OutputGroup { name: None, title: None, outputs }];
        let si = |unit: &dsl::Unit| codegen::model::Unit::resolve(unit).map_or(f64::NAN, |unit| unit.factor());
        let oracle = Oracle::new(&declaration, &si);
        let mut numbers = vec![Vec::with_capacity(4 * samples.len()); sources.len()];
        for index in samples {
            let mechanism = run.trajectory.phase_of(*index).map_or(&run.mechanism, |phase| &phase.mechanism);
            let parameters: Vec<f64> = mechanism.parameters().iter().copied().collect();
            let values = evaluate(&oracle, &parameters, &run.trajectory.samples[*index]).unwrap_or_default();
            for ((_, source), numbers) in sources.iter().zip(&mut numbers) {
                numbers.extend(arrow(source, &values, &run.trajectory.samples[*index]));
            }
        }
        sources.into_iter().map(|(vector, _)| vector).zip(numbers).collect()
    }

    /// The outputs at a sample.
    fn evaluate<M: Mechanism>(oracle: &Oracle, parameters: &[f64], sample: &Sample<M>) -> Option<Vec<f64>> {
        let list = |values: &M::Q| values.iter().copied().collect::<Vec<f64>>();
        let (coordinates, speeds) = (list(&sample.state.positions), list(&sample.state.speeds));
        let inputs: Vec<Option<f64>> = sample.inputs.iter().map(|input| input.held()).collect();
        let (time, coordinates, speeds) = (sample.state.time, &coordinates, &speeds);
        let state = State { time, parameters, inputs: &inputs, coordinates, speeds };
        let solution = Solution {
            accelerations: sample.accelerations.iter().copied().map(Measured::given).collect(),
            multipliers: sample.multipliers.iter().copied().map(Measured::given).collect(),
        };
        let outputs = oracle.outputs(&state, &solution).ok()?;
        Some(outputs.into_iter().map(|output| output.value).collect())
    }

    fn arrow<M: Mechanism>(source: &Source, values: &[f64], sample: &Sample<M>) -> [f64; 4] {
        let at = |index: usize| values.get(index).copied().unwrap_or(f64::NAN);
        match source {
            Source::Load(first) => [at(*first), at(first + 1), at(first + 2), at(first + 3)],
            Source::Reaction { first, row } => {
                let force = -sample.multipliers[*row] / (2.0 * REACH);
                [at(*first), at(first + 1), force * at(first + 2), force * at(first + 3)]
            }
            Source::Joint { first, row } => {
                [at(*first), at(first + 1), -sample.multipliers[*row], -sample.multipliers[row + 1]]
            }
        }
    }

    /// Adds what an arrow needs to the outputs.
    type Make<'d> = Box<dyn FnOnce(&mut Vec<Output>) -> Source + 'd>;

    /// Every force that is a load, and every weight; every constraint between vectors where its left side is; every other at the points
    /// named in it that are drawn, where its virtual work is that of a force.
    fn arrows(declaration: &Declaration, rows: usize) -> Vec<(Vector, Make<'static>)> {
        let mut arrows: Vec<(Vector, Make<'static>)> = Vec::new();
        for load in &declaration.loads {
            match load {
                Load::Force { force, point } => {
                    let [force_text, place] = [force, point].map(crate::show::names::printed);
                    arrows.push(load_arrow(format!("force {force_text} at {place}"), copy(force), point));
                }
                Load::Gravity { acceleration, .. } => {
                    let masses = declaration.bodies.iter().filter_map(|body| Some((&body.name, body.mass.as_ref()?)));
                    for (body, (mass, point)) in masses {
                        let Some(point) = point else { continue };
                        let weight = binary(Operator::Multiply, copy(mass), copy(acceleration));
                        arrows.push(load_arrow(format!("weight of {body}"), weight, point));
                    }
                }
                // Their forces follow from an energy, or act along two points or an angle.
                Load::Torque { .. } | Load::Potential(_) | Load::Dissipation(_) | Load::Element(_) => {}
            }
        }
        let mut row = 0;
        let (vectors, drawn) = (vectors_named(declaration), drawn(declaration));
        for constraint in &declaration.constraints {
            let (name_of, own) = (constraint.name.to_string(), row);
            let difference = binary(Operator::Subtract, copy(&constraint.left), copy(&constraint.right));
            if is_vector(&difference, &vectors) {
                row += 2;
                if declaration.has_rates(constraint) {
                    continue;
                }
                let left = copy(&constraint.left);
                let make = move |outputs: &mut Vec<Output>| {
                    let first = outputs.len();
                    outputs.extend(components(&left).map(output));
                    Source::Joint { first, row: own }
                };
                let about = format!("reaction of {name_of}, on {}", crate::show::names::printed(&constraint.left));
                arrows.push((Vector { label: name_of, about, kind: "reaction" }, Box::new(make)));
                continue;
            }
            row += 1;
            let between_speeds = declaration.has_rates(constraint);
            for point in named(&difference).into_iter().filter(|name| vectors.contains(name) && drawn.contains(name)) {
                let (about, difference) = (format!("reaction of {name_of} at {point}"), copy(&difference));
                let make = move |outputs: &mut Vec<Output>| {
                    let first = outputs.len();
                    let moved = if between_speeds { rate(&point) } else { name(&point) };
                    let changes = [[REACH, 0.0], [0.0, REACH]].map(|step| change(&difference, &moved, step));
                    outputs.extend(components(&name(&point)).into_iter().chain(changes).map(output));
                    Source::Reaction { first, row: own }
                };
                arrows.push((Vector { label: name_of.clone(), about, kind: "reaction" }, Box::new(make)));
            }
        }
        // What cannot be counted here is better not drawn.
        if row == rows { arrows } else { Vec::new() }
    }

    fn load_arrow(about: String, force: Expression, point: &Expression) -> (Vector, Make<'static>) {
        let point = copy(point);
        let make = move |outputs: &mut Vec<Output>| {
            let first = outputs.len();
            outputs.extend(components(&point).into_iter().chain(components(&force)).map(output));
            Source::Load(first)
        };
        (Vector { label: String::new(), about, kind: "load" }, Box::new(make))
    }

    /// C with the point, or its velocity, moved forwards, minus C with it moved back.
    fn change(constraint: &Expression, point: &Expression, [x, y]: [f64; 2]) -> Expression {
        let moved =
            |sign: Operator| substitute(constraint, point, &binary(sign, copy(point), vector(number(x), number(y))));
        binary(Operator::Subtract, moved(Operator::Add), moved(Operator::Subtract))
    }

    /// The names of what is drawn.
    fn drawn(declaration: &Declaration) -> Vec<String> {
        let points = declaration.drawing.iter().flat_map(|shape| match shape {
            dsl::Shape::Points { points, .. } => points.as_slice(),
            dsl::Shape::Slider { at, .. } | dsl::Shape::Circle { at, .. } => std::slice::from_ref(at),
        });
        points.map(crate::show::names::printed).collect()
    }

    /// The `let`s that name vectors.
    fn vectors_named(declaration: &Declaration) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for named in &declaration.lets {
            if is_vector(&named.value, &names) {
                names.push(named.name.to_string());
            }
        }
        names
    }

    fn is_vector(expression: &Expression, vectors: &[String]) -> bool {
        match &expression.kind {
            Kind::Vector(_) => true,
            Kind::Name(name) => vectors.contains(&name.to_string()),
            Kind::Negate(operand) => is_vector(operand, vectors),
            Kind::Binary(_, left, right) => is_vector(left, vectors) || is_vector(right, vectors),
            Kind::Call(function, operands) => {
                (function == "dot" || function == "ddot") && operands.iter().all(|x| is_vector(x, vectors))
            }
            Kind::If(choice) => is_vector(&choice.yes, vectors),
            Kind::Number { .. } | Kind::Component(..) => false,
        }
    }

    /// The names in an expression, each once.
    fn named(expression: &Expression) -> Vec<String> {
        let mut names: Vec<String> = match &expression.kind {
            Kind::Name(name) => vec![name.to_string()],
            _ => expression.parts().into_iter().flat_map(named).collect(),
        };
        names.sort();
        names.dedup();
        names
    }

    fn copy(expression: &Expression) -> Expression {
        rebuilt(expression, &|_| None)
    }

    /// What a name, or the rate of one, stands for instead.
    fn substitute(expression: &Expression, point: &Expression, by: &Expression) -> Expression {
        rebuilt(expression, &|part| is_same(part, point).then(|| copy(by)))
    }

    fn is_same(a: &Expression, b: &Expression) -> bool {
        match (&a.kind, &b.kind) {
            (Kind::Name(a), Kind::Name(b)) => a == b,
            (Kind::Call(f, a), Kind::Call(g, b)) => {
                f == g && a.len() == b.len() && a.iter().zip(b).all(|(a, b)| is_same(a, b))
            }
            _ => false,
        }
    }

    /// The expression with some parts replaced.
    fn rebuilt(expression: &Expression, replaced: &dyn Fn(&Expression) -> Option<Expression>) -> Expression {
        if let Some(other) = replaced(expression) {
            return other;
        }
        let again = |expression: &Expression| rebuilt(expression, replaced);
        let boxed = |expression: &Expression| Box::new(again(expression));
        let kind = match &expression.kind {
            Kind::Name(name) => Kind::Name(name.clone()),
            Kind::Number { literal, unit } => Kind::Number { literal: literal.clone(), unit: unit.clone() },
            Kind::Vector(items) => Kind::Vector(items.iter().map(again).collect()),
            Kind::Negate(operand) => Kind::Negate(boxed(operand)),
            Kind::Binary(operator, left, right) => Kind::Binary(*operator, boxed(left), boxed(right)),
            Kind::Call(function, items) => Kind::Call(function.clone(), items.iter().map(again).collect()),
            Kind::Component(vector, axis) => Kind::Component(boxed(vector), axis.clone()),
            Kind::If(choice) => Kind::If(Box::new(Choice {
                left: again(&choice.left),
                comparison: choice.comparison,
                right: again(&choice.right),
                yes: again(&choice.yes),
                no: again(&choice.no),
            })),
        };
        Expression { region: expression.region, kind }
    }

    fn made(kind: Kind) -> Expression {
        Expression { region: span().into(), kind }
    }

    fn span() -> proc_macro2::Span {
        proc_macro2::Span::call_site()
    }

    fn name(name: &str) -> Expression {
        made(Kind::Name(proc_macro2::Ident::new(name, span())))
    }

    fn rate(of: &str) -> Expression {
        made(Kind::Call(proc_macro2::Ident::new("dot", span()), vec![name(of)]))
    }

    fn number(value: f64) -> Expression {
        made(Kind::Number { literal: format!("{value:?}"), unit: None })
    }

    fn vector(x: Expression, y: Expression) -> Expression {
        made(Kind::Vector(vec![x, y]))
    }

    fn binary(operator: Operator, left: Expression, right: Expression) -> Expression {
        made(Kind::Binary(operator, Box::new(left), Box::new(right)))
    }

    fn components(vector: &Expression) -> [Expression; 2] {
        ["x", "y"].map(|axis| made(Kind::Component(Box::new(copy(vector)), proc_macro2::Ident::new(axis, span()))))
    }

    fn output(value: Expression) -> Output {
        Output { docs: String::new(), name: proc_macro2::Ident::new("arrow", span()), unit: None, value }
    }
}
