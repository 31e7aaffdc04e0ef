//! A motion that its owner advances.

use crate::errors::{argument, refusal};
use crate::interrupt::BETWEEN;
use numpy::PyArray1;
use pyo3::prelude::*;
use sim::cli::{Refusal, Simulated, Stand};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// A motion that its owner advances, step by step or to a time.
#[pyclass(frozen, module = "linkwright._linkwright")]
pub(crate) struct Simulation {
    simulated: Mutex<Box<dyn Simulated>>,
}

impl Simulation {
    pub(crate) fn new(simulated: Box<dyn Simulated>) -> Simulation {
        Simulation { simulated: Mutex::new(simulated) }
    }

    fn lock(&self) -> MutexGuard<'_, Box<dyn Simulated>> {
        self.simulated.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Work with Python's lock released: another thread may hold the simulation.
    fn work<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut dyn Simulated) -> Result<T, Refusal> + Send,
    ) -> PyResult<T> {
        py.detach(|| work(&mut **self.lock())).map_err(|why| refusal(py, &why))
    }
}

/// What has been heard while a motion was advanced.
fn listening(heard: &mut Option<PyErr>) -> impl FnMut() -> bool {
    let mut last = Instant::now();
    move || {
        if last.elapsed() > BETWEEN {
            last = Instant::now();
            *heard = Python::attach(|py| py.check_signals()).err();
        }
        heard.is_none()
    }
}

#[pymethods]
impl Simulation {
    #[getter]
    fn time(&self, py: Python<'_>) -> f64 {
        py.detach(|| self.lock().state().time)
    }

    #[getter]
    fn has_ended(&self, py: Python<'_>) -> bool {
        py.detach(|| self.lock().has_ended())
    }

    /// q and q'.
    fn state<'py>(&self, py: Python<'py>) -> [Bound<'py, PyArray1<f64>>; 2] {
        let Stand { positions, speeds, .. } = py.detach(|| self.lock().state());
        [PyArray1::from_vec(py, positions), PyArray1::from_vec(py, speeds)]
    }

    /// q'' and lambda.
    fn sample<'py>(&self, py: Python<'py>) -> PyResult<[Bound<'py, PyArray1<f64>>; 2]> {
        let Stand { accelerations, multipliers, .. } = self.work(py, |simulated| simulated.sample())?;
        Ok([PyArray1::from_vec(py, accelerations), PyArray1::from_vec(py, multipliers)])
    }

    fn step(&self, py: Python<'_>) -> PyResult<bool> {
        self.work(py, |simulated| simulated.step())
    }

    /// When it ends, if no event ends it before.
    #[getter]
    fn t_end(&self, py: Python<'_>) -> f64 {
        py.detach(|| self.lock().end())
    }

    /// Whether the time is reached: an event may end the motion before.
    fn advance_to(&self, py: Python<'_>, time: f64) -> PyResult<bool> {
        let (now, end) = py.detach(|| {
            let simulated = self.lock();
            (simulated.state().time, simulated.end())
        });
        if !(now..=end).contains(&time) {
            let why = format!(
                "{time:?} s: a time from {now:?} s, which is now, to {end:?} s, the end, is needed; `t_end` sets the end"
            );
            return Err(argument(py, &why));
        }
        let mut heard = None;
        self.work(py, |simulated| simulated.advance_to(time, &mut listening(&mut heard)))?;
        match heard {
            Some(signal) => Err(signal),
            None => Ok(self.time(py) == time),
        }
    }

    fn set_parameter(&self, py: Python<'_>, name: &str, value: &str) -> PyResult<()> {
        self.work(py, |simulated| simulated.set_parameter(name, value))
    }

    /// Holds an input, or gives it back its declared value.
    fn set_input(&self, py: Python<'_>, name: &str, value: Option<&str>) -> PyResult<()> {
        self.work(py, |simulated| simulated.set_input(name, value))
    }

    /// The names and times of past events.
    #[getter]
    fn events(&self, py: Python<'_>) -> Vec<(&'static str, f64)> {
        py.detach(|| self.lock().events())
    }

    fn save(&self, py: Python<'_>) -> Vec<u8> {
        py.detach(|| self.lock().save())
    }

    fn restore(&self, py: Python<'_>, saved: &[u8]) -> PyResult<()> {
        self.work(py, |simulated| simulated.restore(saved))
    }
}
