//! Simulations of mechanisms of any size, for programs in other languages.

use crate::answer::{Refusal, parsed};
use crate::arguments::{Command, RunArguments};
use crate::commands::run::{Asked, asked};
use crate::quantity::parse_quantity;
use crate::sizes::stepping;
use crate::{Stop, unknown};
use sim_kernel::{Input, Mechanism, Quantity};
use sim_output::list;
use sim_runtime::{Erased, Model, Simulation, Storage};
use std::sync::Arc;

/// A [`Simulation`] without the type of its mechanism. All numbers are in SI units.
pub trait Simulated: Send {
    /// Time, positions and speeds.
    fn state(&self) -> Stand;
    /// The same with accelerations and multipliers.
    ///
    /// # Errors
    /// As [`Simulation::sample`].
    fn sample(&mut self) -> Result<Stand, Refusal>;
    /// As [`Simulation::step`].
    ///
    /// # Errors
    /// As it.
    fn step(&mut self) -> Result<bool, Refusal>;
    /// As [`Simulation::advance_while`].
    ///
    /// # Errors
    /// As it.
    fn advance_to(&mut self, time: f64, goes_on: GoesOn) -> Result<(), Refusal>;
    /// Whether the motion has ended.
    fn has_ended(&self) -> bool;
    /// When it ends, if no event ends it before.
    fn end(&self) -> f64;
    /// Holds an input at a value, which is written as on the command line, or gives it back its declared value.
    ///
    /// # Errors
    /// If there is no such input, or the value is none.
    fn set_input(&mut self, name: &str, value: Option<&str>) -> Result<(), Refusal>;
    /// Sets a parameter to a value, which is written as on the command line.
    ///
    /// # Errors
    /// If there is no such parameter, the value is none, or the mechanism no longer closes.
    fn set_parameter(&mut self, name: &str, value: &str) -> Result<(), Refusal>;
    /// The mechanism with its parameters and inputs now, and the constraints that events have switched.
    fn model(&self) -> Arc<dyn Model>;
    /// The names and times of past events.
    fn events(&self) -> Vec<(&'static str, f64)>;
    /// As [`Simulation::save`].
    ///
    /// # Errors
    /// If no thread can be made that has room for a large mechanism.
    fn save(&mut self) -> Result<Vec<u8>, Refusal>;
    /// As [`Simulation::restore`].
    ///
    /// # Errors
    /// If it refuses the bytes.
    fn restore(&mut self, bytes: &[u8]) -> Result<(), Refusal>;
}

/// Whether work goes on.
pub type GoesOn<'a> = &'a mut (dyn FnMut() -> bool + Send);

/// A state of a simulation, in SI units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stand {
    /// t.
    pub time: f64,
    /// q.
    pub positions: Vec<f64>,
    /// q'.
    pub speeds: Vec<f64>,
    /// q'', in a sample.
    pub accelerations: Vec<f64>,
    /// lambda, in a sample.
    pub multipliers: Vec<f64>,
}

/// A simulation as `run` would run it, from the words of its command line without the program's name.
///
/// # Errors
/// [`Refusal`].
pub fn simulated(model: Arc<dyn Model>, words: &[String]) -> Result<Box<dyn Simulated>, Refusal> {
    let begin = || match parsed(words)? {
        Command::Run(arguments) => stepping!(begun, model, &arguments),
        _ => Err(Stop::Usage("a simulation is asked for as a run is".to_owned())),
    };
    begin().map_err(Refusal::from)
}

fn begun<S: Storage>(mechanism: Erased<S>, arguments: &RunArguments) -> Result<Box<dyn Simulated>, Stop>
where
    Simulation<Erased<S>>: Send + 'static,
    Erased<S>: Mechanism,
{
    let Asked { mechanism, start, settings, .. } = asked(&mechanism, arguments)?;
    Ok(Box::new(Simulation::new(mechanism, &start, &settings)?))
}

/// The unit of the quantity of this name.
fn unit_of(kind: &str, name: &str, among: &[Quantity]) -> Result<&'static str, Stop> {
    let found = among.iter().find(|quantity| quantity.name == name);
    let found = found.ok_or_else(|| unknown(kind, name, among.iter().map(|quantity| quantity.name)))?;
    Ok(found.unit)
}

impl<S: Storage> Simulated for Simulation<Erased<S>>
where
    Simulation<Erased<S>>: Send,
    Erased<S>: Mechanism,
{
    fn state(&self) -> Stand {
        let state = Simulation::state(self);
        let (positions, speeds) = (list(&state.positions), list(&state.speeds));
        Stand { time: state.time, positions, speeds, ..Stand::default() }
    }
    fn sample(&mut self) -> Result<Stand, Refusal> {
        let sample = Simulation::sample(self).map_err(Refusal::Failure)?;
        let (accelerations, multipliers) = (list(&sample.accelerations), list(&sample.multipliers));
        Ok(Stand { accelerations, multipliers, ..Simulated::state(self) })
    }
    fn step(&mut self) -> Result<bool, Refusal> {
        Simulation::step(self).map_err(Refusal::Failure)
    }
    fn advance_to(&mut self, time: f64, goes_on: GoesOn) -> Result<(), Refusal> {
        self.advance_while(time, goes_on).map_err(Refusal::Failure)
    }
    fn has_ended(&self) -> bool {
        Simulation::has_ended(self)
    }
    fn end(&self) -> f64 {
        self.settings().end
    }
    fn set_input(&mut self, name: &str, value: Option<&str>) -> Result<(), Refusal> {
        let unit = unit_of("input", name, self.mechanism().description().inputs)?;
        let held = value.map(|text| parse_quantity(name, text, unit)).transpose()?;
        let input = held.map_or(Input::Declared, Input::Held);
        Simulation::set_input(self, name, input).map_err(Refusal::Failure)
    }
    fn set_parameter(&mut self, name: &str, value: &str) -> Result<(), Refusal> {
        let unit = unit_of("parameter", name, self.mechanism().description().parameters)?;
        let value = parse_quantity(name, value, unit)?;
        Simulation::set_parameter(self, name, value).map_err(Refusal::Failure)
    }
    fn model(&self) -> Arc<dyn Model> {
        self.mechanism().model()
    }
    fn events(&self) -> Vec<(&'static str, f64)> {
        Simulation::events(self).iter().map(|found| (found.name, found.state.time)).collect()
    }
    fn save(&mut self) -> Result<Vec<u8>, Refusal> {
        Ok(Simulation::save(self))
    }
    fn restore(&mut self, bytes: &[u8]) -> Result<(), Refusal> {
        Simulation::restore(self, bytes).map_err(|why| Refusal::Usage(why.to_string()))
    }
}
