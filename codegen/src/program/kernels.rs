//! The kernels of a mechanism.

use super::lower::Lowering;
use super::planner::Planner;
use super::prepared::prepared_kernels;
use super::reduced;
use super::results::{Record, Results};
use super::sparsity::Sparsity;
use super::values::Value;
use super::{Arguments, Kernel, Program};
use crate::dynamics::EquationsOfMotion;
use crate::model::{EventStep, Model, Shape, Start};
use crate::symbolic::Expr;
use rustc_hash::FxHashMap;

/// What a kernel returns, of the equations of motion.
type Wanted = fn(&EquationsOfMotion, &mut Lowering) -> Results<Value>;

/// The largest sum that multiplying out may make.
const LONGEST_EXPANSION: usize = 64;

/// Plans every kernel. `equations` is changed only by start values and other forms of expressions entering its graph.
pub fn plan(equations: &mut EquationsOfMotion) -> Program {
    let zero = equations.model.graph.zero();
    let alternatives = expansions(equations);
    let planner = Planner::new(equations, &alternatives);
    let mut kernels = prepared_kernels(&planner);
    kernels.extend(separate_kernels(&planner, zero));
    let columns = reduced::columns_of_constraints(planner.equations, &mut planner.lowering());
    let sparsity = Sparsity::of(columns, planner.equations.model.coordinates.len());
    kernels.extend(sparsity.as_ref().map(|sparsity| sparse_linearization_kernel(&planner, sparsity)));
    kernels.extend(generalized_speeds_kernel(&planner));
    kernels.extend(event_values_kernel(&planner));
    kernels.extend(input_values_kernel(&planner));
    Program { kernels, sparsity }
}

/// Expressions with products of sums multiplied out, where that lets terms cancel; the power by forces along coordinates.
fn expansions(equations: &mut EquationsOfMotion) -> FxHashMap<Expr, Expr> {
    let EquationsOfMotion { model, tmt, constraints, speeds, energy, .. } = equations;
    let matrices = tmt.mass_matrix.iter().chain(&constraints.jacobian).flatten();
    let in_speeds = speeds.iter().flat_map(|speeds| {
        let matrices = speeds.tmt.mass_matrix.iter().chain(&speeds.jacobian);
        matrices.chain([&speeds.tmt.right_hand_side, &speeds.convective]).flatten()
    });
    let vectors = [
        &tmt.right_hand_side,
        &tmt.convective_forces,
        &tmt.generalized_forces,
        &constraints.convective,
        &constraints.time_derivative,
    ];
    let zero = model.graph.zero();
    let exprs = matrices.chain(vectors.into_iter().flatten()).chain(in_speeds).copied();
    let exprs: Vec<Expr> = exprs.filter(|expr| *expr != zero).collect();
    let expanded = exprs.into_iter().filter_map(|expr| Some((expr, model.graph.expand(expr, LONGEST_EXPANSION)?)));
    expanded.chain(energy.power_along_variables.map(|other| (energy.power, other))).collect()
}

/// The constraints linearised, with C_q by its entries.
fn sparse_linearization_kernel(planner: &Planner, sparsity: &Sparsity) -> Kernel {
    let e = planner.equations;
    let (m, entries) = (e.model.constraints.len(), sparsity.rows.iter().map(|row| row.columns.len()).sum::<usize>());
    let docs = format!(
        "`C` ({m}), the {entries} entries of `C_q` that need not be 0, row after row in the order of elimination, and `C_t` \
         ({m}) together, in SI units, for projection."
    );
    planner.kernel("sparse_linearization", Arguments::Positions, docs, |lowering| {
        Results::record(
            Record::ConstraintLinearization,
            [
                ("values", Results::Vector(lowering.lower_all(&e.constraints.values))),
                ("jacobian", reduced::entries_of_constraints(e, lowering, sparsity)),
                ("time_derivative", reduced::constraint_time_derivative(e, lowering)),
            ],
        )
    })
}

/// The generalised speeds at a state, if there are any.
fn generalized_speeds_kernel(planner: &Planner) -> Option<Kernel> {
    let speeds: Vec<Expr> = planner.equations.model.speeds.iter().map(|speed| speed.value).collect();
    let docs =
        format!("The generalised speeds `u = W q' + w`, {}, in SI units, in the order of declaration.", speeds.len());
    let kernel = |lowering: &mut Lowering| Results::Vector(lowering.lower_all(&speeds));
    (!speeds.is_empty()).then(|| planner.kernel("generalized_speeds", Arguments::Speeds, docs, kernel))
}

/// What events set, if any does.
fn event_values_kernel(planner: &Planner) -> Option<Kernel> {
    let values = event_values(&planner.equations.model);
    let docs = format!(
        "What the actions of events set, and the coefficients of restitution of impacts, {}, in SI units, in the order of \
         declaration.",
        values.len()
    );
    let kernel = |lowering: &mut Lowering| Results::Vector(lowering.lower_all(&values));
    (!values.is_empty()).then(|| planner.kernel("event_values", Arguments::Speeds, docs, kernel))
}

/// What inputs are, if there are any.
fn input_values_kernel(planner: &Planner) -> Option<Kernel> {
    let model = &planner.equations.model;
    let inputs: Vec<Expr> = model.inputs.iter().filter_map(|input| model.graph.existing(input.symbol)).collect();
    let docs = format!("The inputs, {}, in SI units: what each is held at, or its declared course.", inputs.len());
    let kernel = |lowering: &mut Lowering| Results::Vector(lowering.lower_all(&inputs));
    (!inputs.is_empty()).then(|| planner.kernel("input_values", Arguments::Positions, docs, kernel))
}

/// The kernels that share nothing with others.
fn separate_kernels(planner: &Planner, zero: Expr) -> Vec<Kernel> {
    use Arguments::*;
    let e = planner.equations;
    let (n, m) = (e.model.coordinates.len(), e.model.constraints.len());
    let scalar = |name, arguments, docs: &str, value: Expr| {
        planner.kernel(name, arguments, docs.into(), |lowering| Results::Scalar(lowering.lower(value)))
    };
    let vector = |name, arguments, docs: String, values: &[Expr]| {
        planner.kernel(name, arguments, docs, |lowering| Results::Vector(lowering.lower_all(values)))
    };
    let term = |name, arguments, docs: String, wanted: Wanted| {
        planner.kernel(name, arguments, docs, |lowering| wanted(e, lowering))
    };
    let constraints = &e.constraints;
    let rates: Vec<Expr> = e.outputs.rates.iter().flatten().copied().collect();
    let events: Vec<Expr> = e.model.events.iter().map(|event| event.value).collect();
    vec![
        term(
            "mass_matrix",
            Positions,
            format!("Mass matrix `T_q' M T_q`, {n} x {n}, symmetric, in SI units."),
            reduced::mass_matrix,
        ),
        term(
            "convective_forces",
            Speeds,
            format!("Convective forces `T_q' M g`, {n}, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate."),
            reduced::convective_forces,
        ),
        term(
            "generalized_forces",
            Speeds,
            format!("Generalised forces `T_q' F`, {n}: joules per unit of each coordinate."),
            reduced::generalized_forces,
        ),
        vector(
            "constraints",
            Positions,
            format!("Constraints `C`, {m}, in SI units; zero throughout the motion."),
            &constraints.values,
        ),
        vector(
            "constraint_magnitudes",
            Positions,
            format!("The sum of the magnitudes of the terms of `C`, {m}, in SI units: what its rounding is relative to."),
            &constraints.magnitudes,
        ),
        term(
            "constraint_jacobian",
            Positions,
            format!("Constraint Jacobian `C_q`, {m} x {n}: units of each constraint per unit of each coordinate."),
            reduced::constraint_jacobian,
        ),
        term(
            "constraint_time_derivative",
            Positions,
            format!("`C_t`, {m}, units of `C` per second: the speeds obey `C_q q' + C_t = 0`."),
            reduced::constraint_time_derivative,
        ),
        term(
            "constraint_convective",
            Speeds,
            format!("`(C_q q' + C_t)_q q' + (..)_t`, {m}, units of `C` per second squared: the part of `C''` without accelerations."),
            reduced::constraint_convective,
        ),
        planner.kernel(
            "constraint_linearization",
            Positions,
            format!("`C` ({m}), `C_q` ({m} x {n}) and `C_t` ({m}) together, in SI units, for projection."),
            |lowering| {
                Results::record(
                    Record::ConstraintLinearization,
                    [
                        ("values", Results::Vector(lowering.lower_all(&constraints.values))),
                        ("jacobian", reduced::constraint_jacobian(e, lowering)),
                        ("time_derivative", reduced::constraint_time_derivative(e, lowering)),
                    ],
                )
            },
        ),
        scalar("kinetic_energy", Speeds, "Kinetic energy `v' M v / 2`, in joules.", e.energy.kinetic),
        scalar(
            "power",
            Multipliers,
            "Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.",
            e.energy.power,
        ),
        vector("outputs", Multipliers, format!("Outputs, {}, in SI units.", e.outputs.values.len()), &e.outputs.values),
        vector(
            "output_rates",
            Accelerations,
            format!(
                "Rates of the outputs that depend on neither accelerations nor multipliers, {}, in SI units per second.",
                rates.len()
            ),
            &rates,
        ),
        vector(
            "events",
            Multipliers,
            format!("`left - right` of each event, {}, in SI units: zero when it happens.", events.len()),
            &events,
        ),
        vector(
            "drawing",
            Positions,
            "The numbers of each shape of the drawing, in metres and radians.".into(),
            &drawing(&e.model),
        ),
        planner.kernel(
            "initial",
            Parameters,
            format!("Declared start: values or guesses of the coordinates ({n}), and speeds ({n}), in SI units; 0 where nothing is declared."),
            |lowering| {
                let (positions, speeds) = start(&e.model, zero);
                Results::record(
                    Record::Initial,
                    [
                        ("positions", Results::Vector(lowering.lower_all(&positions))),
                        ("speeds", Results::Vector(lowering.lower_all(&speeds))),
                    ],
                )
            },
        ),
    ]
}

/// What the actions of events set, and the coefficients of restitution of impacts, in order.
fn event_values(model: &Model) -> Vec<Expr> {
    let steps = model.events.iter().flat_map(|event| &event.steps);
    let values = steps.flat_map(|step| match step {
        EventStep::Set(sets) => sets.iter().map(|(_, value)| *value).collect(),
        EventStep::Impact(hits) => hits.iter().map(|(_, coefficient)| *coefficient).collect(),
        EventStep::Stop(_) | EventStep::Switch(_) => vec![],
    });
    values.collect()
}

fn start(model: &Model, zero: Expr) -> (Vec<Expr>, Vec<Expr>) {
    let position = |start: Start| match start {
        Start::Given(value) | Start::Guess(value) => value,
        Start::Free => zero,
    };
    let coordinates = model.coordinates.iter();
    coordinates.map(|c| (position(c.start), c.start_speed.unwrap_or(zero))).unzip()
}

fn drawing(model: &Model) -> Vec<Expr> {
    let numbers = model.drawing.iter().flat_map(|shape| match shape {
        Shape::Points(_, points) => points.concat(),
        Shape::Slider(at, along) => [at.as_slice(), along].concat(),
        Shape::Circle(at, radius, normal) => [at.as_slice(), &[*radius], normal].concat(),
    });
    numbers.collect()
}
