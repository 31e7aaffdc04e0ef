//! A motion that its owner advances.

use crate::errors::refusal;
use crate::interrupt::BETWEEN;
use crate::model::Model;
use numpy::PyArray1;
use pyo3::prelude::*;
use sim_command::{Refusal, Simulated, Stand};
use std::sync::{Mutex, MutexGuard};
use std::time::Instant;

/// Two vectors.
type Two<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

/// A motion that its owner advances, step by step or to a time.
#[pyclass(frozen, module = "linkwright._linkwright")]
pub(crate) struct Simulation {
    simulated: Mutex<Box<dyn Simulated>>,
    /// What the command line calls its model.
    source: String,
}

impl Simulation {
    pub(crate) fn new(simulated: Box<dyn Simulated>, source: String) -> Simulation {
        Simulation { simulated: Mutex::new(simulated), source }
    }

    fn lock(&self) -> Result<MutexGuard<'_, Box<dyn Simulated>>, Refusal> {
        let broken = |_| Refusal::Other("a failure within this simulation has left it unusable".to_owned());
        self.simulated.lock().map_err(broken)
    }

    /// Work with Python's lock released: another thread may hold the simulation.
    fn work<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut dyn Simulated) -> Result<T, Refusal> + Send,
    ) -> PyResult<T> {
        py.detach(|| work(&mut **self.lock()?)).map_err(|why| refusal(py, &why))
    }
}

/// Where a motion stands after a part of its way.
enum On {
    TheWay,
    Time,
    /// Ended by an event before the time.
    End,
}

/// Advances for some milliseconds at most.
fn advance(simulated: &mut dyn Simulated, time: f64) -> Result<On, Refusal> {
    let (now, end) = (simulated.state().time, simulated.end());
    if !(now..=end).contains(&time) {
        return Err(Refusal::Usage(format!(
            "{time:?} s: a time from {now:?} s, which is now, to {end:?} s, the end, is needed; `t_end` sets the end"
        )));
    }
    let clock = Instant::now();
    simulated.advance_to(time, &mut || clock.elapsed() < BETWEEN)?;
    Ok(match simulated.state().time {
        reached if reached == time => On::Time,
        _ if simulated.has_ended() => On::End,
        _ => On::TheWay,
    })
}

#[pymethods]
impl Simulation {
    #[getter]
    fn time(&self, py: Python<'_>) -> PyResult<f64> {
        self.work(py, |simulated| Ok(simulated.state().time))
    }

    #[getter]
    fn has_ended(&self, py: Python<'_>) -> PyResult<bool> {
        self.work(py, |simulated| Ok(simulated.has_ended()))
    }

    /// q and q'.
    fn state<'py>(&self, py: Python<'py>) -> PyResult<Two<'py>> {
        let Stand { positions, speeds, .. } = self.work(py, |simulated| Ok(simulated.state()))?;
        Ok((PyArray1::from_vec(py, positions), PyArray1::from_vec(py, speeds)))
    }

    /// q'' and lambda.
    fn sample<'py>(&self, py: Python<'py>) -> PyResult<Two<'py>> {
        let Stand { accelerations, multipliers, .. } = self.work(py, |simulated| simulated.sample())?;
        Ok((PyArray1::from_vec(py, accelerations), PyArray1::from_vec(py, multipliers)))
    }

    fn step(&self, py: Python<'_>) -> PyResult<bool> {
        self.work(py, |simulated| simulated.step())
    }

    /// When it ends, if no event ends it before.
    #[getter]
    fn t_end(&self, py: Python<'_>) -> PyResult<f64> {
        self.work(py, |simulated| Ok(simulated.end()))
    }

    /// Whether the time is reached: an event may end the motion before. Nothing is held while handlers of signals run.
    fn advance_to(&self, py: Python<'_>, time: f64) -> PyResult<bool> {
        loop {
            match self.work(py, |simulated| advance(simulated, time))? {
                On::Time => return Ok(true),
                On::End => return Ok(false),
                On::TheWay => py.check_signals()?,
            }
        }
    }

    fn set_parameter(&self, py: Python<'_>, name: &str, value: &str) -> PyResult<()> {
        self.work(py, |simulated| simulated.set_parameter(name, value))
    }

    /// Holds an input, or gives it back its declared value.
    fn set_input(&self, py: Python<'_>, name: &str, value: Option<&str>) -> PyResult<()> {
        self.work(py, |simulated| simulated.set_input(name, value))
    }

    /// The mechanism as it is now.
    fn model(&self, py: Python<'_>) -> PyResult<Model> {
        let model = self.work(py, |simulated| Ok(simulated.model()))?;
        Ok(Model::new(model, self.source.clone()))
    }

    /// The names and times of past events.
    #[getter]
    fn events(&self, py: Python<'_>) -> PyResult<Vec<(&'static str, f64)>> {
        self.work(py, |simulated| Ok(simulated.events()))
    }

    fn save(&self, py: Python<'_>) -> PyResult<Vec<u8>> {
        self.work(py, |simulated| simulated.save())
    }

    fn restore(&self, py: Python<'_>, saved: &[u8]) -> PyResult<()> {
        self.work(py, |simulated| simulated.restore(saved))
    }
}
