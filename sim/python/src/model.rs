//! A mechanism whose kernels are called with arrays.

use crate::answer::Answer;
use crate::errors::{argument, load, refusal};
use crate::interrupt::interruptible;
use crate::kernels::{Given, call};
use crate::robots::declared_in;
use crate::shipped::entry;
use crate::simulation::Simulation;
use codegen::model::Unit;
use codegen::notation::Notation;
use numpy::PyArray1;
use pyo3::prelude::*;
use sim_command::{answer, simulated, with_values};
use sim_runtime::sim_kernel::Quantity;
use sim_runtime::{At, DeclarationFile, Found, Input, Kernel, Prepared};
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

/// A mechanism with its values. The package adds commands to it.
#[pyclass(frozen, subclass, module = "linkwright._linkwright")]
pub(crate) struct Model {
    model: Arc<dyn sim_runtime::Model>,
    /// With all that parameters determine computed, once it is needed.
    prepared: OnceLock<Box<dyn Prepared>>,
    /// What the command line calls it: a file, or a name.
    source: String,
}

/// The model of a declaration's text, as if it stood in this file.
#[pyfunction]
pub(crate) fn from_text(py: Python<'_>, text: String, path: PathBuf, name: Option<String>) -> PyResult<Model> {
    let declared_in = declared_in(path.clone(), &text);
    let found = py.detach(|| DeclarationFile::of(&declared_in, text).model(name.as_deref()));
    let source = path.to_string_lossy().into_owned();
    found.map(|model| Model::new(model, source)).map_err(|why| load(py, &why))
}

/// The model of a file, or a shipped one of this name.
#[pyfunction]
pub(crate) fn read(py: Python<'_>, path: Option<PathBuf>, name: Option<String>) -> PyResult<Model> {
    let found = match (&path, &name) {
        (Some(path), _) => py.detach(|| sim_runtime::load(path, name.as_deref())),
        (None, Some(name)) => match entry(name) {
            Some(entry) => py.detach(|| entry.model()),
            None => return Err(argument(py, &unknown(name))),
        },
        (None, None) => return Err(argument(py, "a file or a name is needed")),
    };
    let source = path.map(|path| path.to_string_lossy().into_owned()).or(name).unwrap_or_default();
    found.map(|model| Model::new(model, source)).map_err(|why| load(py, &why))
}

fn unknown(name: &str) -> String {
    let names = crate::shipped::shipped();
    let near = codegen::nearest::suggestion(name, names.iter().copied());
    format!(
        "no shipped model is called `{name}`{near}\nknown: {}; a file ends in .mech, .rs or .urdf",
        names.join(", ")
    )
}

/// A value in SI units in a unit: the number that a declaration would have for it.
#[pyfunction]
pub(crate) fn in_unit(py: Python<'_>, value: f64, unit: &str) -> PyResult<f64> {
    let unit = Unit::parse(unit).map_err(|why| argument(py, &why))?;
    Ok(unit.from_si(value))
}

impl Model {
    pub(crate) fn new(model: Arc<dyn sim_runtime::Model>, source: String) -> Model {
        Model { model, prepared: OnceLock::new(), source }
    }

    /// Another model in place of this one.
    fn with(&self, model: Arc<dyn sim_runtime::Model>) -> Model {
        Model::new(model, self.source.clone())
    }

    /// The same with the constraints that hold at the start, whatever events have switched since.
    fn at_start(&self) -> Arc<dyn sim_runtime::Model> {
        let mut values = self.model.values();
        let declared = self.model.as_declared().values().activities;
        if values.activities == declared {
            return self.model.clone();
        }
        values.activities = declared;
        self.model.with_values(&values)
    }

    /// A kernel at one state.
    fn call_once(&self, kernel: Kernel, at: At<f64>, found: Found<f64>) -> bool {
        match kernel {
            Kernel::Dynamics => self.prepared.get_or_init(|| self.model.prepare()).call(kernel, at, found),
            _ => self.model.call(kernel, at, found),
        }
    }
}

/// Methods that call a kernel with as many levels of a state as it reads.
macro_rules! kernels {
    ($($method:ident = $kernel:ident($($level:ident),*);)*) => {
        #[pymethods]
        impl Model {
            $(fn $method<'py>(
                &self,
                py: Python<'py>,
                t: &Bound<'py, PyAny>,
                $($level: &Bound<'py, PyAny>,)*
            ) -> PyResult<Bound<'py, PyAny>> {
                let once = &|at: At<f64>, found: Found<f64>| self.call_once(Kernel::$kernel, at, found);
                call(py, (&self.model, once), Kernel::$kernel, Given { time: t, levels: levels([$($level),*]) })
            })*
        }
    };
}

/// Those that are given, and none of the others.
fn levels<'a, 'py, const L: usize>(given: [&'a Bound<'py, PyAny>; L]) -> [Option<&'a Bound<'py, PyAny>>; 4] {
    let mut all = [None; 4];
    for (place, level) in all.iter_mut().zip(given) {
        *place = Some(level);
    }
    all
}

kernels! {
    switching_functions = SwitchingFunctions();
    mass_matrix = MassMatrix(q);
    speed_mass_matrix = SpeedMassMatrix(q);
    constraints = Constraints(q);
    constraint_magnitudes = ConstraintMagnitudes(q);
    constraint_jacobian = ConstraintJacobian(q);
    constraint_time_derivative = ConstraintTimeDerivative(q);
    constraint_linearization = ConstraintLinearization(q);
    sparse_linearization = SparseLinearization(q);
    drawing = Drawing(q);
    convective_forces = ConvectiveForces(q, qd);
    generalized_forces = GeneralizedForces(q, qd);
    constraint_convective = ConstraintConvective(q, qd);
    kinetic_energy = KineticEnergy(q, qd);
    dynamics = Dynamics(q, qd);
    dynamics_jacobian = DynamicsJacobian(q, qd);
    dynamics_sensitivity = DynamicsSensitivity(q, qd);
    velocity_variables = VelocityVariables(q, qd);
    velocities = Velocities(q, qd);
    event_values = EventValues(q, qd);
    load_conditions = LoadConditions(q, qd);
    inverse_dynamics = InverseDynamics(q, qd, qdd);
    output_rates = OutputRates(q, qd, qdd);
    power = Power(q, qd, qdd, multipliers);
    events = Events(q, qd, qdd, multipliers);
    outputs = Outputs(q, qd, qdd, multipliers);
}

/// Names, units, sizes of units in SI units, and documentation.
type Named = (&'static str, &'static str, f64, &'static str);

fn named<'a>(quantities: impl Iterator<Item = &'a Quantity>) -> Vec<Named> {
    quantities.map(|of| (of.name, of.unit, of.factor, of.docs)).collect()
}

#[pymethods]
impl Model {
    /// Another of the same mechanism: so a class of the package is made of it.
    #[new]
    fn of(other: &Model) -> Model {
        other.with(other.model.clone())
    }

    #[getter]
    fn name(&self) -> &'static str {
        self.model.description().name
    }

    #[getter]
    fn docs(&self) -> &'static str {
        self.model.description().docs
    }

    #[getter]
    fn declaration(&self) -> &'static str {
        self.model.description().declaration
    }

    #[getter]
    fn declaration_hash(&self) -> &'static str {
        self.model.description().declaration_hash
    }

    #[pyo3(name = "_quantities")]
    fn quantities(&self, kind: &str) -> Vec<Named> {
        let of = self.model.description();
        match kind {
            "coordinates" => named(of.coordinates.iter().map(|c| &c.position)),
            "speeds" => named(of.coordinates.iter().map(|c| &c.speed)),
            "parameters" => named(of.parameters.iter()),
            "inputs" => named(of.inputs.iter()),
            "constraints" => named(of.constraints.iter()),
            "outputs" => named(of.outputs.iter()),
            _ => Vec::new(),
        }
    }

    #[getter]
    fn event_names(&self) -> Vec<&'static str> {
        self.model.description().events.iter().map(|event| event.name).collect()
    }

    /// Parameters in SI units.
    #[pyo3(name = "_parameter_values")]
    fn parameter_values(&self) -> Vec<f64> {
        self.model.values().parameters
    }

    /// The values at which inputs are held, in SI units.
    #[pyo3(name = "_input_values")]
    fn input_values(&self) -> Vec<Option<f64>> {
        self.model.values().inputs.iter().map(|input| input.held()).collect()
    }

    /// For each constraint that events switch, 1 where it holds and 0 where it is released.
    #[pyo3(name = "_activities")]
    fn activities(&self) -> Vec<f64> {
        self.model.values().activities
    }

    /// The declared start, in SI units.
    #[pyo3(name = "_initial")]
    fn initial<'py>(&self, py: Python<'py>) -> (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>) {
        let [positions, speeds] = self.model.initial();
        (PyArray1::from_vec(py, positions), PyArray1::from_vec(py, speeds))
    }

    /// The same with these parameters and inputs as they are declared.
    #[pyo3(name = "_as_declared")]
    fn as_declared(&self, py: Python<'_>, parameters: Vec<String>, inputs: Vec<String>) -> PyResult<Model> {
        // Names that are none are refused as they are with a value.
        let [set, held] =
            [&parameters, &inputs].map(|names| names.iter().map(|name| format!("{name}=0")).collect::<Vec<_>>());
        with_values(&*self.model, &set, &held).map_err(|why| refusal(py, &why))?;
        let (description, mut values) = (self.model.description(), self.model.values());
        let declared = self.model.as_declared().values();
        let places = |names: &[String], among: &[Quantity]| -> Vec<usize> {
            (0..among.len()).filter(|place| names.iter().any(|name| name == among[*place].name)).collect()
        };
        for place in places(&parameters, description.parameters) {
            values.parameters[place] = declared.parameters[place];
        }
        for place in places(&inputs, description.inputs) {
            values.inputs[place] = declared.inputs[place];
        }
        Ok(self.with(self.model.with_values(&values)))
    }

    /// The same with other values.
    #[pyo3(name = "_set")]
    fn set(&self, py: Python<'_>, parameters: Vec<String>, inputs: Vec<String>) -> PyResult<Model> {
        let model = with_values(&*self.model, &parameters, &inputs).map_err(|why| refusal(py, &why))?;
        Ok(self.with(model))
    }

    /// The same with values in SI units, as many as there are.
    #[pyo3(name = "_restored")]
    fn restored(
        &self,
        py: Python<'_>,
        parameters: Vec<f64>,
        inputs: Vec<Option<f64>>,
        activities: Vec<f64>,
    ) -> PyResult<Model> {
        let mut values = self.model.values();
        let sizes = [values.parameters.len(), values.inputs.len(), values.activities.len()];
        if [parameters.len(), inputs.len(), activities.len()] != sizes {
            return Err(argument(py, "these are values of another mechanism"));
        }
        (values.parameters, values.activities) = (parameters, activities);
        values.inputs = inputs.into_iter().map(|held| held.map_or(Input::Declared, Input::Held)).collect();
        Ok(self.with(self.model.with_values(&values)))
    }

    #[getter]
    fn source(&self) -> &str {
        &self.source
    }

    /// Executes a command line on this mechanism.
    #[pyo3(name = "_answer")]
    fn answer(&self, py: Python<'_>, words: Vec<String>) -> PyResult<Answer> {
        let found = interruptible(py, |interrupted| answer(self.at_start(), &words, interrupted))?;
        found.map(Answer::new).map_err(|why| refusal(py, &why))
    }

    #[pyo3(name = "_simulated")]
    fn simulated(&self, py: Python<'_>, words: Vec<String>) -> PyResult<Simulation> {
        let found = py.detach(|| simulated(self.at_start(), &words));
        found.map(|found| Simulation::new(found, self.source.clone())).map_err(|why| refusal(py, &why))
    }

    /// The equations of motion: headings and texts.
    #[pyo3(name = "_equation_groups")]
    fn equation_groups(&self, py: Python<'_>, notation: &str) -> PyResult<Vec<(&'static str, String)>> {
        let notation = match notation {
            "text" => Notation::Infix,
            "latex" => Notation::Latex,
            "mathml" => Notation::MathMl,
            other => return Err(argument(py, &format!("no notation is called `{other}`; known: text, latex, mathml"))),
        };
        let groups = py.detach(|| codegen::equations_as(notation, self.declaration()).map_err(|why| why.to_string()));
        let groups = groups.map_err(|why| argument(py, &why))?;
        Ok(groups.into_iter().map(|group| (group.title, group.text)).collect())
    }

    /// The kernels in Rust.
    fn generate_rust(&self, py: Python<'_>) -> PyResult<String> {
        let text =
            py.detach(|| codegen::generate_text(self.declaration(), "sim_kernel").map_err(|why| why.to_string()));
        text.map_err(|why| argument(py, &why))
    }
}
