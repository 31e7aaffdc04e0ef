//! The equations of motion evaluated numerically: a second, slower way to everything that a kernel computes.
//!
//! The parsed declaration is interpreted with second-order jets, and the equations are assembled and solved densely.
//! Nothing is shared with the symbolic engine, the resolved model or the derivation, so an error in any of them shows
//! as a difference. The parsed declaration is shared, with everything that `dsl` and `joints` write out: fragments and
//! repetitions, joints, free bodies and points on them. Every result carries the magnitude of its terms (see
//! [`Measured`]), as a scale for differences.
//!
//! Positions are jets in (q, t): P, P_q, P_t and all second derivatives, hence velocities and convective terms. Loads,
//! outputs and events are jets in time along q + q' s + q'' s^2/2, which `dot` differentiates.
//!
//! Neither this check nor Lagrange's equations would show an error in what all derivations share. Therefore reactions
//! are also checked body by body (`freed`), and joints against equations written by hand in the tests.

mod comparison;
mod constraint;
mod effort;
mod elements;
mod error;
mod freed;
mod function;
mod interpolation;
mod interpret;
mod jet;
mod measured;
mod mechanics;
mod motion;
mod names;
mod observe;
mod parameters;
mod plain;
mod rotation;
mod setting;
mod sizes;
mod solve;
mod state;
mod value;

pub use comparison::{Comparison, Computed, Observed, residual};
pub use error::{OracleError, Result};
pub use freed::Balance;
pub use measured::Measured;
pub use motion::{Solution, Terms};
pub use state::State;

use crate::dsl::{Activity, Declaration, Unit};
use interpret::Interpreter;
use mechanics::Mechanics;
use names::Names;
use setting::Setting;
use std::sync::Arc;

/// Evaluates one declaration at given states.
pub struct Oracle<'d> {
    declaration: &'d Declaration,
    si_factor: &'d dyn Fn(&Unit) -> f64,
    /// Whether each constraint that events switch holds.
    active: Vec<bool>,
    names: Arc<Names>,
}

impl<'d> Oracle<'d> {
    /// An oracle for `declaration`, in which `si_factor` gives the size of each unit in SI units.
    pub fn new(declaration: &'d Declaration, si_factor: &'d dyn Fn(&Unit) -> f64) -> Oracle<'d> {
        let initially = declaration.constraints.iter().filter_map(|constraint| constraint.initially);
        let active = initially.map(|activity| activity == Activity::Active).collect();
        Oracle { declaration, si_factor, active, names: Arc::new(Names::of(declaration)) }
    }

    /// The same with these activities of the constraints that events switch, instead of those at the start.
    pub fn with_active(self, active: Vec<bool>) -> Oracle<'d> {
        Oracle { active, ..self }
    }

    /// The defaults of the parameters, in SI units.
    ///
    /// A plain number, such as `5` or `-pi/2`, is in the declared unit; a default with a unit or another parameter in
    /// it has its own unit.
    ///
    /// # Errors
    /// If a default is not a scalar made of numbers and earlier parameters.
    pub fn default_parameters(&self) -> Result<Vec<f64>> {
        parameters::defaults(self.declaration, self.si_factor)
    }

    /// The terms of the equations of motion.
    ///
    /// # Errors
    /// If the state does not have the declared lengths, or the declaration has not been checked.
    pub fn terms(&self, at: &State) -> Result<Terms> {
        Ok(Terms::new(&self.mechanics(at)?))
    }

    /// The accelerations and multipliers that solve the equations of motion with these terms.
    ///
    /// # Errors
    /// If the equations are singular: a coordinate without inertia, or constraints that depend on each other.
    pub fn accelerations(&self, terms: &Terms) -> Result<Solution> {
        terms.solve()
    }

    /// Every output in the order of the declaration, group after group, in SI units.
    ///
    /// # Errors
    /// As [`Oracle::terms`].
    pub fn outputs(&self, at: &State, solution: &Solution) -> Result<Vec<Measured>> {
        let setting = self.along(at, solution)?;
        observe::outputs(self.declaration, self.interpreter(setting))
    }

    /// The same of outputs that depend on no reaction, which costs half as much.
    ///
    /// # Errors
    /// As [`Oracle::terms`], and if one depends on a reaction.
    pub fn outputs_of_motion(&self, at: &State, accelerations: &[Measured]) -> Result<Vec<Measured>> {
        at.check(self.declaration)?;
        observe::outputs(self.declaration, self.interpreter(at.accelerated_motion(accelerations)))
    }

    /// The same of outputs in which no rate stands, many times as fast.
    ///
    /// # Errors
    /// As [`Oracle::outputs_of_motion`], and if a rate stands in one.
    pub fn outputs_of_positions(&self, at: &State) -> Result<Vec<Measured>> {
        at.check(self.declaration)?;
        observe::outputs(self.declaration, self.interpreter(at.still()))
    }

    /// left - right of every event, in SI units.
    ///
    /// # Errors
    /// As [`Oracle::terms`].
    pub fn events(&self, at: &State, solution: &Solution) -> Result<Vec<Measured>> {
        let setting = self.along(at, solution)?;
        observe::events(self.declaration, self.interpreter(setting))
    }

    /// The values that the actions of events set, and the coefficients of restitution of impacts, in the order of
    /// declaration.
    ///
    /// # Errors
    /// As [`Oracle::terms`].
    pub fn event_values(&self, at: &State) -> Result<Vec<Measured>> {
        at.check(self.declaration)?;
        observe::event_values(self.declaration, self.si_factor, self.interpreter(at.motion()))
    }

    /// The power of loads, of constraints that time moves and of points that time moves, W.
    ///
    /// It is d(kinetic energy)/dt where the speeds satisfy the constraints.
    ///
    /// # Errors
    /// As [`Oracle::terms`].
    pub fn power(&self, at: &State, solution: &Solution) -> Result<Measured> {
        Ok(observe::power(&self.mechanics(at)?, solution))
    }

    /// The motion with its accelerations and reactions.
    fn along(&self, at: &State, solution: &Solution) -> Result<Setting> {
        let reactions = observe::reactions(&self.mechanics(at)?, solution)?;
        Ok(at.accelerated_motion(&solution.accelerations).with_reactions(reactions))
    }

    fn mechanics(&self, at: &State) -> Result<Mechanics> {
        at.check(self.declaration)?;
        Mechanics::new(self.declaration, self.si_factor, at, &self.active)
    }

    fn interpreter(&self, setting: Setting) -> Interpreter<'d> {
        Interpreter::with_names(self.declaration, self.si_factor, self.names.clone(), setting)
    }
}
