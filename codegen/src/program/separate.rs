//! The kernels that share nothing with others.

use super::Arguments::{Accelerations, Multipliers, Parameters, Positions, Speeds};
use super::lower::Lowering;
use super::planner::Planner;
use super::reduced;
use super::results::{Record, Results};
use super::values::Value;
use super::{Arguments, Kernel};
use crate::dynamics::EquationsOfMotion;
use crate::model::{Model, Shape, Start};
use crate::symbolic::Expr;

/// The results of the kernels of the equations of motion.
type Wanted = fn(&EquationsOfMotion, &mut Lowering) -> Results<Value>;

pub(super) fn separate_kernels(planner: &Planner, zero: Expr) -> Vec<Kernel> {
    let kernels = terms(planner).into_iter().chain(constraints(planner)).chain(energies(planner));
    kernels.chain(observations(planner)).chain([initial(planner, zero)]).collect()
}

fn scalar(planner: &Planner, name: &'static str, arguments: Arguments, docs: &str, value: Expr) -> Kernel {
    planner.kernel(name, arguments, docs.into(), |lowering| Results::Scalar(lowering.lower(value)))
}

fn vector(planner: &Planner, name: &'static str, arguments: Arguments, docs: String, values: &[Expr]) -> Kernel {
    planner.kernel(name, arguments, docs, |lowering| Results::Vector(lowering.lower_all(values)))
}

fn term(planner: &Planner, name: &'static str, arguments: Arguments, docs: String, wanted: Wanted) -> Kernel {
    planner.kernel(name, arguments, docs, |lowering| wanted(planner.equations, lowering))
}

/// The terms of the equations of motion.
fn terms(planner: &Planner) -> [Kernel; 3] {
    let n = planner.equations.model.coordinates.len();
    [
        term(
            planner,
            "mass_matrix",
            Positions,
            format!("Mass matrix `T_q' M T_q`, {n} x {n}, symmetric, in SI units."),
            reduced::mass_matrix,
        ),
        term(
            planner,
            "convective_forces",
            Speeds,
            format!(
                "Convective forces `T_q' M g`, {n}, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate."
            ),
            reduced::convective_forces,
        ),
        term(
            planner,
            "generalized_forces",
            Speeds,
            format!("Generalised forces `T_q' F`, {n}: joules per unit of each coordinate."),
            reduced::generalized_forces,
        ),
    ]
}

fn constraints(planner: &Planner) -> [Kernel; 6] {
    let EquationsOfMotion { model, constraints, .. } = planner.equations;
    let (n, m) = (model.coordinates.len(), model.constraints.len());
    [
        vector(
            planner,
            "constraints",
            Positions,
            format!("Constraints `C`, {m}, in SI units; zero throughout the motion."),
            &constraints.values,
        ),
        vector(
            planner,
            "constraint_magnitudes",
            Positions,
            format!(
                "The sum of the magnitudes of the terms of `C`, {m}, in SI units: what its rounding is relative to."
            ),
            &constraints.magnitudes,
        ),
        term(
            planner,
            "constraint_jacobian",
            Positions,
            format!("Constraint Jacobian `C_q`, {m} x {n}: units of each constraint per unit of each coordinate."),
            reduced::constraint_jacobian,
        ),
        term(
            planner,
            "constraint_time_derivative",
            Positions,
            format!("`C_t`, {m}, units of `C` per second: the speeds obey `C_q q' + C_t = 0`."),
            reduced::constraint_time_derivative,
        ),
        term(
            planner,
            "constraint_convective",
            Speeds,
            format!(
                "`(C_q q' + C_t)_q q' + (..)_t`, {m}, units of `C` per second squared: the part of `C''` without accelerations."
            ),
            reduced::constraint_convective,
        ),
        constraint_linearization(planner),
    ]
}

/// The constraints with their derivatives, together.
fn constraint_linearization(planner: &Planner) -> Kernel {
    let e = planner.equations;
    let (n, m) = (e.model.coordinates.len(), e.model.constraints.len());
    planner.kernel(
        "constraint_linearization",
        Positions,
        format!("`C` ({m}), `C_q` ({m} x {n}) and `C_t` ({m}) together, in SI units, for projection."),
        |lowering| {
            Results::record(
                Record::ConstraintLinearization,
                [
                    ("values", Results::Vector(lowering.lower_all(&e.constraints.values))),
                    ("jacobian", reduced::constraint_jacobian(e, lowering)),
                    ("time_derivative", reduced::constraint_time_derivative(e, lowering)),
                ],
            )
        },
    )
}

fn energies(planner: &Planner) -> [Kernel; 2] {
    let energy = &planner.equations.energy;
    [
        scalar(planner, "kinetic_energy", Speeds, "Kinetic energy `v' M v / 2`, in joules.", energy.kinetic),
        scalar(
            planner,
            "power",
            Multipliers,
            "Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.",
            energy.power,
        ),
    ]
}

/// The observed quantities of a motion: outputs, events and the drawing.
fn observations(planner: &Planner) -> [Kernel; 4] {
    let EquationsOfMotion { model, outputs, .. } = planner.equations;
    let rates: Vec<Expr> = outputs.rates.iter().flatten().copied().collect();
    let events: Vec<Expr> = model.events.iter().map(|event| event.value).collect();
    [
        vector(
            planner,
            "outputs",
            Multipliers,
            format!("Outputs, {}, in SI units.", outputs.values.len()),
            &outputs.values,
        ),
        vector(
            planner,
            "output_rates",
            Accelerations,
            format!(
                "Rates of the outputs that depend on neither accelerations nor multipliers, {}, in SI units per second.",
                rates.len()
            ),
            &rates,
        ),
        vector(
            planner,
            "events",
            Multipliers,
            format!("`left - right` of each event, {}, in SI units: zero when it happens.", events.len()),
            &events,
        ),
        vector(
            planner,
            "drawing",
            Positions,
            "The numbers of each shape of the drawing, in metres and radians.".into(),
            &drawing(model),
        ),
    ]
}

fn initial(planner: &Planner, zero: Expr) -> Kernel {
    let model = &planner.equations.model;
    let n = model.coordinates.len();
    let docs = format!(
        "Declared start: values or guesses of the coordinates ({n}), and speeds ({n}), in SI units; 0 where nothing is \
         declared."
    );
    planner.kernel("initial", Parameters, docs, |lowering| {
        let (positions, speeds) = start(model, zero);
        Results::record(
            Record::Initial,
            [
                ("positions", Results::Vector(lowering.lower_all(&positions))),
                ("speeds", Results::Vector(lowering.lower_all(&speeds))),
            ],
        )
    })
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
