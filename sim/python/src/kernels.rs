//! Kernels on arrays: of one state, or of many, one a row.

use crate::errors::{argument, kernel as refused_by};
use crate::shapes::{Shape, parts};
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyInt, PySlice, PyTuple};
use sim_runtime::{At, Found, Kernel, Model, Results, States, solve_each};
use std::sync::Arc;

/// Below so many states Python's lock is kept.
const FEW: usize = 32;

/// The arguments of a kernel: t, and of each level an array or none.
pub(crate) struct Given<'a, 'py> {
    pub(crate) time: &'a Bound<'py, PyAny>,
    /// q, q', q'', lambda.
    pub(crate) levels: [Option<&'a Bound<'py, PyAny>>; 4],
}

/// The names of the levels.
const NAMES: [&str; 4] = ["q", "qd", "qdd", "multipliers"];

/// Numbers that lie one after the other.
enum Numbers<'py> {
    /// Along one axis. Those of a state are few, and copying them is cheaper than having them lent.
    Row(Vec<f64>),
    Array(PyReadonlyArrayDyn<'py, f64>),
    None,
}

impl<'py> Numbers<'py> {
    /// An array of numbers, or what NumPy makes one of.
    fn of(value: Option<&Bound<'py, PyAny>>) -> PyResult<Numbers<'py>> {
        let Some(value) = value else { return Ok(Numbers::None) };
        if let Ok(array) = value.cast_exact::<PyArrayDyn<f64>>()
            && array.is_c_contiguous()
            && (array.data() as usize).is_multiple_of(align_of::<f64>())
        {
            return Numbers::in_array(array);
        }
        Numbers::in_array(plain(value)?.cast::<PyArrayDyn<f64>>()?)
    }

    fn in_array(array: &Bound<'py, PyArrayDyn<f64>>) -> PyResult<Numbers<'py>> {
        match array.ndim() {
            1 => Ok(Numbers::Row(array.to_vec()?)),
            _ => {
                let lent = array.try_readonly();
                let lent = lent.map_err(|_| argument(array.py(), "an array is being written to by another program"))?;
                Ok(Numbers::Array(lent))
            }
        }
    }

    /// Of one state, or of many in rows of a width.
    fn count(&self, width: usize) -> Result<Option<usize>, String> {
        match self {
            Numbers::None => Ok(None),
            Numbers::Row(numbers) if numbers.len() == width => Ok(None),
            Numbers::Row(numbers) => Err(format!("{},", numbers.len())),
            Numbers::Array(array) => match array.shape() {
                [states, length] if *length == width => Ok(Some(*states)),
                shape => Err(shape.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")),
            },
        }
    }

    fn slice(&self) -> PyResult<&[f64]> {
        match self {
            Numbers::Row(numbers) => Ok(numbers),
            Numbers::Array(array) => Ok(array.as_slice()?),
            Numbers::None => Ok(&[]),
        }
    }
}

/// A kernel at one state; whether it is refused.
type Once<'a> = dyn Fn(At<f64>, Found<f64>) -> bool + 'a;

/// A kernel's results at one state, or at many: arrays in a tuple if there are several.
pub(crate) fn call<'py>(
    py: Python<'py>,
    (model, once): (&Arc<dyn Model>, &Once),
    kernel: Kernel,
    given: Given<'_, 'py>,
) -> PyResult<Bound<'py, PyAny>> {
    let description = model.description();
    if let Some(why) = kernel.missing_in(description) {
        return Err(argument(py, &why));
    }
    let n = description.coordinates.len();
    let widths = [n, n, n, description.constraints.len()];
    let levels = [
        Numbers::of(given.levels[0])?,
        Numbers::of(given.levels[1])?,
        Numbers::of(given.levels[2])?,
        Numbers::of(given.levels[3])?,
    ];
    let mut count = None;
    for ((level, width), name) in levels.iter().zip(widths).zip(NAMES) {
        if !matches!(level, Numbers::None) {
            agree(py, &mut count, level.count(width), width, name)?;
        }
    }
    let slices = [levels[0].slice()?, levels[1].slice()?, levels[2].slice()?, levels[3].slice()?];
    for ((numbers, width), name) in slices.iter().zip(widths).zip(NAMES) {
        if has_undefined(numbers) {
            let at = numbers.iter().position(|number| !number.is_finite()).unwrap_or(0) / width.max(1);
            return Err(argument(py, &format!("{name}: a number of state {at} (counted from 0) is not finite")));
        }
    }
    let [positions, speeds, accelerations, multipliers] = slices;
    match count.flatten() {
        None => {
            let time = one_time(given.time)?.ok_or_else(|| argument(py, "t: one number is needed for one state"))?;
            if !time.is_finite() {
                return Err(argument(py, "t: the number is not finite"));
            }
            of_one(py, (model, once), kernel, At { time, positions, speeds, accelerations, multipliers })
        }
        Some(states) => {
            let times = times(py, given.time, states)?;
            of_many(py, model, kernel, States { times: &times, positions, speeds, accelerations, multipliers })
        }
    }
}

/// All arrays are of one state, or of the same number of states.
fn agree(
    py: Python<'_>,
    count: &mut Option<Option<usize>>,
    found: Result<Option<usize>, String>,
    width: usize,
    name: &str,
) -> PyResult<()> {
    let states = found.map_err(|shape| {
        argument(py, &format!("{name}: an array of shape ({width},) or (states, {width}) is needed, not ({shape})"))
    })?;
    match *count {
        Some(before) if before != states => {
            let told =
                |states: Option<usize>| states.map_or("one state".to_owned(), |states| format!("{states} states"));
            Err(argument(
                py,
                &format!("{name}: numbers of {}, where those before are of {}", told(states), told(before)),
            ))
        }
        _ => {
            *count = Some(states);
            Ok(())
        }
    }
}

/// Real numbers as an array of f64, one after the other. What NumPy would turn into such without a word is refused: complex
/// numbers, texts, truth values, and arrays of a class of their own, which may have masks or units.
fn plain<'py>(value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let py = value.py();
    let numpy = py.import("numpy")?;
    let array = numpy.getattr("ndarray")?;
    let class = value.get_type();
    if value.is_instance(&array)? && !class.is(&array) && !class.is(&numpy.getattr("memmap")?) {
        let name = class.name()?;
        return Err(argument(
            py,
            &format!("a plain array is needed, not a {name}: NumPy would drop what it means besides"),
        ));
    }
    let found = numpy.call_method1("asarray", (value,))?;
    let kind: String = found.getattr("dtype")?.getattr("kind")?.extract()?;
    if !["f", "i", "u"].contains(&kind.as_str()) && found.getattr("size")?.extract::<usize>()? > 0 {
        let of = found.getattr("dtype")?.str()?;
        return Err(argument(py, &format!("real numbers are needed, not {of}")));
    }
    numpy.call_method1("require", (found, numpy.getattr("float64")?, ("C", "ALIGNED")))
}

/// The time, if it is one number.
fn one_time(given: &Bound<'_, PyAny>) -> PyResult<Option<f64>> {
    if let Ok(time) = given.cast::<PyFloat>() {
        return Ok(Some(time.value()));
    }
    if let Ok(time) = given.cast_exact::<PyInt>() {
        return time.extract().map(Some);
    }
    let found = plain(given)?;
    match found.getattr("ndim")?.extract::<usize>()? {
        0 => Ok(Some(found.extract()?)),
        _ => Ok(None),
    }
}

/// The time of each state: one for all, or one each.
fn times(py: Python<'_>, given: &Bound<'_, PyAny>, states: usize) -> PyResult<Vec<f64>> {
    let times = match one_time(given)? {
        Some(time) => vec![time; states],
        None => match Numbers::of(Some(given))? {
            Numbers::Row(times) if times.len() == states => times,
            _ => return Err(argument(py, &format!("t: a number, or {states} of them, is needed"))),
        },
    };
    match has_undefined(&times) {
        true => Err(argument(py, "t: a number is not finite")),
        false => Ok(times),
    }
}

fn of_one<'py>(
    py: Python<'py>,
    (model, once): (&Arc<dyn Model>, &Once),
    kernel: Kernel,
    at: At<f64>,
) -> PyResult<Bound<'py, PyAny>> {
    let description = model.description();
    let (mut numbers, mut rows) = (Vec::with_capacity(64), Vec::with_capacity(8));
    let is_refused = once(at, &mut |_, row| {
        numbers.extend_from_slice(row);
        rows.push(row.len());
    });
    let mut refused = Vec::new();
    if is_refused {
        let At { time, positions, speeds, accelerations, multipliers } = at;
        let states = States { times: &[time], positions, speeds, accelerations, multipliers };
        Results { numbers, refused, .. } = solve_each(model, kernel, &states);
    }
    check(py, kernel, &numbers, numbers.len(), &refused)?;
    let arrays = parts(kernel, description, &rows).into_iter().map(|part| {
        let numbers = &numbers[part.numbers];
        Ok(match part.shape {
            Shape::Number => numbers.first().copied().unwrap_or(0.0).into_pyobject(py)?.into_any(),
            Shape::Vector => PyArray1::from_slice(py, numbers).into_any(),
            Shape::Matrix(rows, columns) => PyArray1::from_slice(py, numbers).reshape([rows, columns])?.into_any(),
        })
    });
    together(py, arrays.collect::<PyResult<_>>()?)
}

fn of_many<'py>(
    py: Python<'py>,
    model: &Arc<dyn Model>,
    kernel: Kernel,
    states: States,
) -> PyResult<Bound<'py, PyAny>> {
    let description = model.description();
    let count = states.times.len();
    let Results { rows, numbers, refused } =
        if count < FEW { solve_each(model, kernel, &states) } else { py.detach(|| solve_each(model, kernel, &states)) };
    let rows = if count == 0 { rows_of(&**model, kernel) } else { rows };
    let width: usize = rows.iter().sum();
    check(py, kernel, &numbers, width, &refused)?;
    let all = PyArray1::from_vec(py, numbers).reshape([count, width])?;
    let arrays = parts(kernel, description, &rows).into_iter().map(|part| {
        let of_part = |columns: Bound<'py, PyAny>| all.get_item((PySlice::full(py), columns));
        let slice = || PySlice::new(py, part.numbers.start as isize, part.numbers.end as isize, 1).into_any();
        match part.shape {
            Shape::Number => of_part(0_i32.into_pyobject(py)?.into_any()),
            Shape::Vector => of_part(slice()),
            Shape::Matrix(rows, columns) => of_part(slice())?.call_method1("reshape", (count, rows, columns)),
        }
    });
    together(py, arrays.collect::<PyResult<_>>()?)
}

/// The lengths of the rows of a result, whatever the state.
fn rows_of(model: &dyn Model, kernel: Kernel) -> Vec<usize> {
    let mut rows = Vec::new();
    let [q, qd] = model.initial();
    let lambda = vec![0.0; model.description().constraints.len()];
    let at = At { time: 0.0, positions: &q, speeds: &qd, accelerations: &qd, multipliers: &lambda };
    model.call(kernel, at, &mut |_, row| rows.push(row.len()));
    rows
}

fn together<'py>(py: Python<'py>, mut arrays: Vec<Bound<'py, PyAny>>) -> PyResult<Bound<'py, PyAny>> {
    match arrays.len() {
        1 => Ok(arrays.swap_remove(0)),
        _ => Ok(PyTuple::new(py, arrays)?.into_any()),
    }
}

/// Whether one of them is not finite. Without a branch, so that it is made for many numbers at once.
fn has_undefined(numbers: &[f64]) -> bool {
    numbers.iter().fold(false, |any, number| any | !number.is_finite())
}

/// Every number is one.
fn check(py: Python<'_>, kernel: Kernel, numbers: &[f64], width: usize, refused: &[usize]) -> PyResult<()> {
    let name = kernel.name();
    if let Some(first) = refused.first() {
        let count = refused.len();
        let message = format!(
            "`{name}` meets a singular matrix in {count} of the states, first in state {first} (counted from 0): a position is \
             singular, constraints are redundant, or masses are 0 there"
        );
        return Err(refused_by(py, "E-SINGULAR", &message, refused));
    }
    if !has_undefined(numbers) {
        return Ok(());
    }
    let at = numbers.chunks(width.max(1)).position(|of_state| of_state.iter().any(|number| !number.is_finite()));
    let first = at.unwrap_or(0);
    let message = format!(
        "`{name}` is not finite in state {first} (counted from 0): an expression leaves its domain there (division by zero, root or logarithm of a negative number)"
    );
    Err(refused_by(py, "E-NOT-FINITE", &message, &[first]))
}
