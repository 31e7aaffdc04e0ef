//! The whole declaration, block by block.

use super::auxiliary::{Displacements, check_displaced, resolve_auxiliaries};
use super::bodies::{ResolvedBodies, fall, resolve_bodies};
use super::drawing::resolve_drawing;
use super::equations::resolve_constraints;
use super::events::{Known, resolve_events};
use super::interpreter::Interpreter;
use super::loads::resolve_loads;
use super::outputs::resolve_outputs;
use super::placed_frames::check_frames;
use super::quantities::{
    check_coordinates_used, resolve_coordinates, resolve_inputs, resolve_lets, resolve_parameters,
};
use super::run::resolve_run;
use super::scope::plain;
use super::space::{check_norms, links};
use super::speeds::resolve_speeds;
use super::start::resolve_initial;
use super::tables::resolve_tables;
use super::value::Value;
use super::{Auxiliary, Coordinate, Displaced, Input, Model, Parameter, Resolved, time_derivative};
use crate::dsl::{Declaration, Region};
use crate::symbolic::{Graph, Symbol};

/// Resolves a declaration.
///
/// # Errors
/// All mistakes of meaning, each at the user's own word, combined into one error.
pub fn resolve(declaration: &Declaration) -> syn::Result<Resolved> {
    if declaration.coordinates.is_empty() {
        let place = Region::from(&declaration.head.name);
        return Err(place.error("a mechanism needs at least one coordinate: `coordinates { phi [rad]; }`"));
    }
    let (model, graph) = resolve_with(declaration, Displacements::Zero)?;
    let mut displaced = None;
    if !model.auxiliaries.is_empty() {
        let (model, graph) = resolve_with(declaration, Displacements::Variable)?;
        check_displaced(declaration, &model, &graph)?;
        displaced = Some(Displaced { model, graph });
    }
    Ok(Resolved { model, graph, displaced })
}

fn resolve_with(declaration: &Declaration, displacements: Displacements) -> syn::Result<(Model, Graph)> {
    let mut graph = Graph::new();
    let time = graph.symbol("t");
    let mut interpreter = Interpreter::new(declaration, graph, time);
    resolve_tables(declaration, &mut interpreter);
    let Symbols { mut coordinates, parameters, inputs, auxiliaries, forces, moving } =
        resolve_symbols(declaration, time, displacements, &mut interpreter);
    let named = resolve_lets(declaration, &mut interpreter);
    let resolved = resolve_bodies(declaration, &mut interpreter);
    check_frames(declaration, &resolved, &mut interpreter);
    let ResolvedBodies { mut bodies, turns, names: body_names, norms } = resolved;
    let loads = resolve_loads(declaration, &moving, &bodies, &turns, &body_names, &mut interpreter);
    fall(&mut bodies, &turns, loads.falling.as_ref(), &mut interpreter);
    let links = links(&bodies, &turns, &mut interpreter);
    let (constraints, conditionals) = resolve_constraints(declaration, &forces, &mut interpreter);
    resolve_initial(declaration, &mut coordinates, &mut interpreter);
    let known = Known { coordinates: &coordinates, parameters: &parameters, conditionals: &conditionals };
    let events = resolve_events(declaration, &known, &mut interpreter);
    let (outputs, groups) = resolve_outputs(declaration, &coordinates, &constraints, &mut interpreter);
    let drawing = resolve_drawing(declaration, &mut interpreter);
    check_coordinates_used(declaration, &coordinates, &bodies, &constraints, &mut interpreter);
    let norm_constraints =
        check_norms(&interpreter.quaternions, &constraints, &interpreter.graph, &mut interpreter.mistakes);
    let generalized_speeds =
        resolve_speeds(declaration, &coordinates, &constraints, &norm_constraints, &mut interpreter);
    let run = resolve_run(declaration, &mut interpreter);
    let dimension = if interpreter.is_spatial() { 3 } else { 2 };
    let Interpreter { graph, dependences, mistakes, .. } = interpreter;
    let model = Model {
        name: plain(&declaration.head.name),
        docs: declaration.head.docs.clone(),
        dependences,
        time,
        coordinates,
        parameters,
        inputs,
        named,
        bodies: bodies.into_iter().flatten().collect(),
        links,
        gravity: loads.gravity,
        forces: loads.forces,
        efforts: loads.efforts,
        pushes: loads.pushes,
        norms,
        norm_constraints,
        generalized_speeds,
        dimension,
        constraints,
        conditionals,
        events,
        outputs,
        groups,
        drawing,
        auxiliaries,
        run,
        kernels: declaration.kernels.clone(),
    };
    mistakes.or((model, graph))
}

/// Items declared as symbols.
struct Symbols {
    coordinates: Vec<Coordinate>,
    parameters: Vec<Parameter>,
    inputs: Vec<Input>,
    auxiliaries: Vec<Auxiliary>,
    /// The forces conjugate to auxiliary displacements.
    forces: Vec<Value>,
    /// Everything that moves, with its rate.
    moving: Vec<(Symbol, Symbol)>,
}

fn resolve_symbols(
    declaration: &Declaration,
    time: Symbol,
    displacements: Displacements,
    interpreter: &mut Interpreter,
) -> Symbols {
    let coordinates = resolve_coordinates(declaration, interpreter);
    interpreter.motion = time_derivative(&mut interpreter.graph, time, &coordinates, &[]);
    let parameters = resolve_parameters(declaration, interpreter);
    let inputs = resolve_inputs(declaration, interpreter);
    let auxiliaries = resolve_auxiliaries(declaration, displacements, interpreter);
    let (auxiliaries, forces): (Vec<_>, Vec<_>) = auxiliaries.into_iter().unzip();
    let mut moving: Vec<_> = coordinates.iter().map(|c| (c.position, c.speed)).collect();
    if displacements == Displacements::Variable {
        interpreter.motion = time_derivative(&mut interpreter.graph, time, &coordinates, &auxiliaries);
        moving.extend(auxiliaries.iter().map(|a| (a.displacement, a.rate)));
    }
    Symbols { coordinates, parameters, inputs, auxiliaries, forces, moving }
}
