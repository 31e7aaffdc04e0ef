//! The kernels that share nothing with others.

use super::Kernel;
use super::links::LinkTerms;
use super::lower::Lowering;
use super::planner::Planner;
use super::reduced;
use super::results::Results;
use super::speed_mass_matrix::dense;
use super::values::Value;
use super::ways::can_be_by_rows;
use crate::dynamics::EquationsOfMotion;
use crate::kernel_id::{KernelId, Record};
use crate::model::{Model, Shape, Start};
use crate::symbolic::Expr;

/// The results of the kernels of the equations of motion.
type Wanted = fn(&EquationsOfMotion, &mut Lowering) -> Results<Value>;

pub(super) fn separate_kernels(planner: &Planner, zero: Expr) -> Vec<Kernel> {
    let kernels = terms(planner).into_iter().chain(constraints(planner)).chain(energies(planner));
    kernels.chain(observations(planner)).chain([initial(planner, zero)]).collect()
}

fn scalar(planner: &Planner, kernel: KernelId, value: Expr) -> Kernel {
    planner.kernel(kernel, |lowering| Results::Scalar(lowering.lower(value)))
}

fn vector(planner: &Planner, kernel: KernelId, values: &[Expr]) -> Kernel {
    planner.kernel(kernel, |lowering| Results::Vector(lowering.lower_all(values)))
}

fn term(planner: &Planner, kernel: KernelId, wanted: Wanted) -> Kernel {
    planner.kernel(kernel, |lowering| wanted(planner.equations, lowering))
}

/// The terms of the equations of motion.
fn terms(planner: &Planner) -> [Kernel; 3] {
    let EquationsOfMotion { model, graph, .. } = planner.equations;
    let unknowns: Vec<usize> = (0..model.coordinates.len()).collect();
    let by_composite_bodies = |terms: LinkTerms, lowering: &mut Lowering| {
        let entries = terms.mass_matrix(graph, lowering);
        Results::Matrix(unknowns.len(), dense(&mut lowering.values, &unknowns, entries))
    };
    let convective = |terms: LinkTerms, lowering: &mut Lowering| Results::Vector(terms.convective_forces(lowering));
    let given = |terms: LinkTerms, lowering: &mut Lowering| Results::Vector(terms.generalized_forces(lowering));
    [
        along_links(planner, KernelId::MassMatrix, by_composite_bodies, reduced::mass_matrix),
        along_links(planner, KernelId::ConvectiveForces, convective, reduced::convective_forces),
        along_links(planner, KernelId::GeneralizedForces, given, reduced::generalized_forces),
    ]
}

/// By a recursion over links or from rows of T, whichever takes fewer operations.
fn along_links(
    planner: &Planner,
    kernel: KernelId,
    by_links: impl Fn(LinkTerms, &mut Lowering) -> Results<Value>,
    by_rows: Wanted,
) -> Kernel {
    let by_rows = || term(planner, kernel, by_rows);
    let Some(links) = &planner.equations.links else { return by_rows() };
    let by_links = planner.kernel(kernel, |lowering| {
        let terms = LinkTerms::of(lowering, links);
        by_links(terms, lowering)
    });
    if !can_be_by_rows(planner.equations) {
        return by_links;
    }
    let by_rows = by_rows();
    if by_links.operations.total() < by_rows.operations.total() { by_links } else { by_rows }
}

fn constraints(planner: &Planner) -> [Kernel; 6] {
    let constraints = &planner.equations.constraints;
    [
        vector(planner, KernelId::Constraints, &constraints.values),
        vector(planner, KernelId::ConstraintMagnitudes, &constraints.magnitudes),
        term(planner, KernelId::ConstraintJacobian, reduced::constraint_jacobian),
        term(planner, KernelId::ConstraintTimeDerivative, reduced::constraint_time_derivative),
        term(planner, KernelId::ConstraintConvective, reduced::constraint_convective),
        term(planner, KernelId::ConstraintLinearization, constraint_linearization),
    ]
}

/// The constraints with their derivatives, together.
fn constraint_linearization(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Results<Value> {
    Results::record(
        Record::ConstraintLinearization,
        [
            ("values", Results::Vector(lowering.lower_all(&equations.constraints.values))),
            ("jacobian", reduced::constraint_jacobian(equations, lowering)),
            ("time_derivative", reduced::constraint_time_derivative(equations, lowering)),
        ],
    )
}

fn energies(planner: &Planner) -> [Kernel; 2] {
    let energy = &planner.equations.energy;
    [scalar(planner, KernelId::KineticEnergy, energy.kinetic), scalar(planner, KernelId::Power, energy.power)]
}

/// The observed quantities of a motion: outputs, events and the drawing.
fn observations(planner: &Planner) -> [Kernel; 4] {
    let EquationsOfMotion { model, outputs, events, .. } = planner.equations;
    let rates: Vec<Expr> = outputs.rates.iter().flatten().copied().collect();
    [
        vector(planner, KernelId::Outputs, &outputs.values),
        vector(planner, KernelId::OutputRates, &rates),
        vector(planner, KernelId::Events, &events.conditions),
        vector(planner, KernelId::Drawing, &drawing(model)),
    ]
}

fn initial(planner: &Planner, zero: Expr) -> Kernel {
    let (positions, speeds) = start(&planner.equations.model, zero);
    planner.kernel(KernelId::Initial, |lowering| {
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
