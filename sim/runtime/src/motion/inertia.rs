//! Inertia tensors made of parameters: whether a body can have them.
//!
//! The declaration is parsed again and the entries of each tensor are evaluated as outputs. Tensors of numbers alone
//! are checked when the mechanism is built.

use crate::state::failure::Failure;
use sim_kernel::Mechanism;

/// Checks that every spatial body has a possible inertia: positive, and no principal moment above the sum of the
/// others.
///
/// # Errors
/// [`What::ImpossibleInertia`](crate::What::ImpossibleInertia), with the body. None without the feature `analysis`.
#[cfg(not(feature = "analysis"))]
pub fn check_inertias<M: Mechanism>(_: &M, _: f64, _: &M::Q) -> Result<(), Failure> {
    Ok(())
}

#[cfg(feature = "analysis")]
pub use declared::check_inertias;

#[cfg(feature = "analysis")]
mod declared {
    use super::{Failure, Mechanism};
    use crate::model::AnyMechanism;
    use crate::motion::typed::Any;
    use crate::state::failure::What;
    use codegen::dsl::{self, Declaration, Kind, Output, OutputGroup};
    use codegen::model::{Unit, impossible_inertia};
    use codegen::oracle::{Oracle, State};
    use sim_kernel::Input;

    /// Checks that every spatial body has a possible inertia: positive, and no principal moment above the sum of the
    /// others.
    ///
    /// # Errors
    /// [`What::ImpossibleInertia`], with the body.
    pub fn check_inertias<M: Mechanism>(mechanism: &M, time: f64, q: &M::Q) -> Result<(), Failure> {
        check(&Any(mechanism), time, q.as_ref())
    }

    fn check(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> Result<(), Failure> {
        let description = mechanism.description();
        if description.dimension < 3 {
            return Ok(());
        }
        let tokens = description.declaration.parse().ok();
        let Some(declaration) = tokens.and_then(|tokens| codegen::parse(tokens).ok()) else { return Ok(()) };
        for (body, tensor) in tensors(declaration, mechanism, time, q) {
            if let Some(why) = impossible_inertia(tensor) {
                return Err(mechanism.failure(What::ImpossibleInertia { body, why }, time, q));
            }
        }
        Ok(())
    }

    /// The bodies of space with xx, yy, zz, yz, zx, xy.
    fn tensors(
        mut declaration: Declaration,
        mechanism: &dyn AnyMechanism,
        time: f64,
        q: &[f64],
    ) -> Vec<(String, [f64; 6])> {
        let (mut bodies, mut outputs) = (Vec::new(), Vec::new());
        for body in declaration.bodies.iter().filter(|body| !body.unchecked) {
            let Some(Kind::Vector(entries)) = body.inertia.as_ref().map(|inertia| &inertia.kind) else { continue };
            bodies.push((body.name.to_string(), entries.len()));
            outputs.extend(entries.iter().map(|entry| Output {
                docs: String::new(),
                name: body.name.clone(),
                unit: None,
                value: entry.clone(),
            }));
        }
        declaration.outputs = vec![OutputGroup { name: None, title: None, outputs }];
        let si = |unit: &dsl::Unit| Unit::resolve(unit).map_or(f64::NAN, |unit| unit.factor());
        let parameters = mechanism.parameters();
        let inputs: Vec<Option<f64>> = mechanism.inputs().into_iter().map(Input::held).collect();
        let speeds = vec![0.0; q.len()];
        let at = State { time, parameters: &parameters, inputs: &inputs, coordinates: q, speeds: &speeds };
        let Ok(found) = Oracle::new(&declaration, &si).outputs_of_motion(&at, &[]) else { return Vec::new() };
        let mut found = found.into_iter().map(|entry| entry.value);
        let tensor = |(body, entries): (String, usize)| {
            let mut given = [0.0; 6];
            given.iter_mut().zip(found.by_ref().take(entries)).for_each(|(entry, value)| *entry = value);
            let [xx, yy, zz, xy, zx, yz] = given;
            (body, [xx, yy, zz, yz, zx, xy])
        };
        bodies.into_iter().map(tensor).collect()
    }
}
