//! The whole declaration, block by block.

use super::auxiliary::{Displacements, check_displaced, resolve_auxiliaries};
use super::bodies::{ResolvedBodies, fall, resolve_bodies};
use super::drawing::resolve_drawing;
use super::equations::resolve_constraints;
use super::events::{Known, resolve_events};
use super::interpret::Interpreter;
use super::loads::resolve_loads;
use super::origin::Origins;
use super::outputs::resolve_outputs;
use super::quantities::{
    check_coordinates_used, resolve_coordinates, resolve_inputs, resolve_lets, resolve_parameters,
};
use super::scope::{Names, plain};
use super::space::{Frames, check_norms};
use super::speeds::resolve_speeds;
use super::start::resolve_initial;
use super::tables::resolve_tables;
use super::{Dependence, Dependences, Model, time_derivative};
use crate::dsl::OptionalKernel::{DynamicsJacobian, DynamicsSensitivity, InverseDynamics};
use crate::dsl::{Declaration, Region};
use crate::mistakes::Mistakes;
use crate::symbolic::{Differential, Graph};

/// Resolves a declaration.
///
/// # Errors
/// All mistakes of meaning, each at the user's own word, combined into one error.
pub fn resolve(declaration: &Declaration) -> syn::Result<Model> {
    let mut model = resolve_with(declaration, Displacements::Zero)?;
    if !model.auxiliaries.is_empty() {
        let displaced = resolve_with(declaration, Displacements::Variable)?;
        check_displaced(declaration, &displaced)?;
        model.displaced = Some(Box::new(displaced));
    }
    Ok(model)
}

fn resolve_with(declaration: &Declaration, displacements: Displacements) -> syn::Result<Model> {
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
        tables: Names::new("table"),
        origins: Origins::default(),
        with_units: declaration.has_units(),
        misnamed: vec![],
        local: vec![],
        reactions: None,
        outputs: declaration
            .outputs
            .iter()
            .flat_map(|group| &group.outputs)
            .map(|output| plain(&output.name))
            .collect(),
        motion: Differential::along([]),
        mistakes: Mistakes::default(),
        frames: Frames::default(),
        quaternions: vec![],
        vectors: None,
    };
    let i = &mut interpreter;
    resolve_tables(declaration, i);
    let mut coordinates = resolve_coordinates(declaration, i);
    i.motion = time_derivative(&mut i.graph, time, &coordinates, &[]);
    let parameters = resolve_parameters(declaration, i);
    let inputs = resolve_inputs(declaration, i);
    let auxiliaries = resolve_auxiliaries(declaration, displacements, i);
    let (auxiliaries, forces): (Vec<_>, Vec<_>) = auxiliaries.into_iter().unzip();
    let mut moving: Vec<_> = coordinates.iter().map(|c| (c.position, c.speed)).collect();
    if displacements == Displacements::Variable {
        i.motion = time_derivative(&mut i.graph, time, &coordinates, &auxiliaries);
        moving.extend(auxiliaries.iter().map(|a| (a.displacement, a.rate)));
    }
    let named = resolve_lets(declaration, i);
    let ResolvedBodies { mut bodies, turns, names: body_names, norms } = resolve_bodies(declaration, i);
    let loads = resolve_loads(declaration, &moving, &bodies, &turns, &body_names, i);
    if let Some(gravity) = &loads.falling {
        fall(&mut bodies, &turns, gravity, i);
    }
    let (constraints, conditionals) = resolve_constraints(declaration, &forces, i);
    resolve_initial(declaration, &mut coordinates, i);
    let known = Known { coordinates: &coordinates, parameters: &parameters, conditionals: &conditionals };
    let events = resolve_events(declaration, &known, i);
    let (outputs, groups) = resolve_outputs(declaration, &coordinates, &constraints, i);
    let drawing = resolve_drawing(declaration, i);
    check_coordinates_used(declaration, &coordinates, &bodies, &constraints, i);
    let norm_constraints = check_norms(&i.quaternions, &constraints, &i.graph, &mut i.mistakes);
    let speeds = resolve_speeds(declaration, &coordinates, &constraints, &norm_constraints, i);
    let dimension = if i.is_spatial() { 3 } else { 2 };
    let Interpreter { graph, dependences, mistakes, .. } = interpreter;
    mistakes.or(Model {
        name: plain(&declaration.head.name),
        docs: declaration.head.docs.clone(),
        graph,
        dependences,
        time,
        coordinates,
        parameters,
        inputs,
        named,
        bodies: bodies.into_iter().flatten().collect(),
        gravity: loads.gravity,
        forces: loads.forces,
        efforts: loads.efforts,
        pushes: loads.pushes,
        norms,
        norm_constraints,
        speeds,
        dimension,
        constraints,
        conditionals,
        events,
        outputs,
        groups,
        drawing,
        auxiliaries,
        displaced: None,
        wants_jacobian: declaration.kernels.as_ref().map(|kernels| kernels.contains(&DynamicsJacobian)),
        wants_inverse: declaration.kernels.as_ref().is_some_and(|kernels| kernels.contains(&InverseDynamics)),
        wants_sensitivity: declaration.kernels.as_ref().is_some_and(|kernels| kernels.contains(&DynamicsSensitivity)),
    })
}
