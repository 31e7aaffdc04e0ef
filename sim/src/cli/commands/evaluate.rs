//! `sim evaluate`.

use crate::cli::arguments::EvaluateArguments;
use crate::cli::files::stored::{StoredColumn, columns as columns_of};
use crate::cli::given::{hold, set};
use crate::cli::{Stop, print, unknown};
use crate::{At, Kernel, Model};
use codegen::model::Unit;
use sim_kernel::{Description, Quantity};
use std::sync::Arc;

/// Prints a kernel's results, a line for each state.
pub(in crate::cli) fn evaluate(model: &dyn Model, arguments: &EvaluateArguments) -> Result<(), Stop> {
    let model = as_given(model, arguments)?;
    let name = arguments.kernel.as_str();
    let names = || Kernel::ALL.iter().map(|kernel| kernel.name());
    let kernel = Kernel::ALL.iter().copied().find(|kernel| kernel.name() == name);
    let kernel = kernel.ok_or_else(|| unknown("kernel", name, names()))?;
    let states = States::read(model.description(), kernel, arguments)?;
    let (mut text, mut outside) = (String::new(), None);
    for row in 0..states.rows {
        let place = states.place(row);
        let mut found = Vec::new();
        let refused = model.call(kernel, place.at(), &mut |row, numbers| found.push((row, numbers.to_vec())));
        let columns = columns(model.description(), kernel, found);
        if row == 0 {
            text = line("t [s]", columns.iter().map(|column| column.heading.clone()), "refused");
        }
        if !refused && columns.iter().any(|column| !column.value.is_finite()) {
            outside = outside.or(Some(row + 1));
        }
        let cells = columns.iter().map(|column| if refused { String::new() } else { format!("{:?}", column.value) });
        text += &line(&format!("{:?}", place.time), cells, if refused { "1" } else { "0" });
    }
    print(&text)?;
    outside.map_or(Ok(()), |row| {
        Err(Stop::Failed(anyhow::anyhow!(
            "`{name}` is not finite in row {row}: an expression leaves its domain there (division by zero, root or logarithm of a \
             negative number)"
        )))
    })
}

/// A line of the table.
fn line(time: &str, cells: impl Iterator<Item = String>, refused: &str) -> String {
    let cells: Vec<String> = [time.to_owned()].into_iter().chain(cells).chain([refused.to_owned()]).collect();
    cells.join(",") + "\n"
}

/// With the user's parameters and inputs.
fn as_given(model: &dyn Model, arguments: &EvaluateArguments) -> Result<Arc<dyn Model>, Stop> {
    let mut values = model.values();
    set(&mut values.parameters, model.description(), &arguments.set)?;
    hold(&mut values.inputs, model.description(), &arguments.input)?;
    Ok(model.with_values(&values))
}

/// A number of a result.
struct Column {
    heading: String,
    value: f64,
}

/// The numbers of a result under the names that they have in a trajectory, or by row and column.
fn columns(description: &Description, kernel: Kernel, found: Vec<(usize, Vec<f64>)>) -> Vec<Column> {
    let quantity = |prefix: &str, q: &Quantity, value: f64| Column {
        heading: format!("{prefix}{} [{}]", q.name, q.unit),
        value: value / q.factor,
    };
    // A matrix of one row is one too.
    let is_matrix = matches!(
        kernel,
        Kernel::MassMatrix
            | Kernel::ConstraintJacobian
            | Kernel::ConstraintLinearization
            | Kernel::SparseLinearization
            | Kernel::DynamicsJacobian
            | Kernel::DynamicsSensitivity
    );
    let of_row = |(row, values): (usize, Vec<f64>)| -> Vec<Column> {
        let numbered = values.iter().copied().enumerate();
        match (kernel, row) {
            (Kernel::Dynamics, 0) => {
                numbered.map(|(i, value)| quantity("", &description.coordinates[i].acceleration, value)).collect()
            }
            (Kernel::Dynamics, 1) => {
                numbered.map(|(i, value)| quantity("lambda_", &description.constraints[i], value)).collect()
            }
            (Kernel::Dynamics, _) => {
                values.into_iter().map(|value| Column { heading: "power [W]".into(), value }).collect()
            }
            (Kernel::Outputs, _) => numbered.map(|(i, value)| quantity("", &description.outputs[i], value)).collect(),
            _ => numbered
                .map(|(i, value)| {
                    let place = if is_matrix { format!("{}_{}", row + 1, i + 1) } else { format!("{}", i + 1) };
                    Column { heading: format!("{}_{place}", kernel.name()), value }
                })
                .collect(),
        }
    };
    found.into_iter().flat_map(of_row).collect()
}

/// What a kernel reads, by columns in SI units.
struct States {
    rows: usize,
    time: Vec<f64>,
    /// Positions, speeds, accelerations and multipliers.
    levels: [Vec<Vec<f64>>; 4],
}

/// One of them.
struct Place {
    time: f64,
    levels: [Vec<f64>; 4],
}

impl Place {
    fn at(&self) -> At<'_, f64> {
        let [positions, speeds, accelerations, multipliers] = &self.levels;
        At { time: self.time, positions, speeds, accelerations, multipliers }
    }
}

impl States {
    fn read(description: &'static Description, kernel: Kernel, arguments: &EvaluateArguments) -> Result<States, Stop> {
        let table = columns_of(&arguments.at)?;
        let rows = table.first().map_or(0, |column| column.values.len());
        if rows == 0 {
            let path = arguments.at.display();
            return Err(Stop::Usage(format!("{path}: no states; a line for each is needed below the heading")));
        }
        let of = |name: String, unit: &str, factor: f64, is_needed: bool| match table
            .iter()
            .find(|column| column.name == name)
        {
            Some(column) => in_si(column, unit, factor),
            None if !is_needed => Ok(vec![0.0; rows]),
            None => Err(Stop::Usage(format!(
                "{}: `{}` needs the column `{name}`; there are {}",
                arguments.at.display(),
                kernel.name(),
                table.iter().map(|column| column.name.as_str()).collect::<Vec<_>>().join(", ")
            ))),
        };
        let level = needs(kernel);
        let all = |quantities: Vec<(String, &'static Quantity)>, place: usize| {
            let each = quantities.into_iter().map(|(name, q)| of(name, q.unit, q.factor, place < level));
            each.collect::<Result<Vec<_>, Stop>>()
        };
        let coordinates = description.coordinates;
        let named = |q: &'static Quantity| (q.name.to_owned(), q);
        let multipliers = description.constraints.iter().map(|c| (format!("lambda_{}", c.name), c));
        Ok(States {
            rows,
            time: of("t".into(), "s", 1.0, false)?,
            levels: [
                all(coordinates.iter().map(|c| named(&c.position)).collect(), 0)?,
                all(coordinates.iter().map(|c| named(&c.speed)).collect(), 1)?,
                all(coordinates.iter().map(|c| named(&c.acceleration)).collect(), 2)?,
                all(multipliers.collect(), 3)?,
            ],
        })
    }

    fn place(&self, row: usize) -> Place {
        let of = |columns: &Vec<Vec<f64>>| columns.iter().map(|column| column[row]).collect();
        Place { time: self.time[row], levels: self.levels.each_ref().map(of) }
    }
}

/// How much a kernel needs of a state: 1 positions, 2 speeds too, 3 accelerations too, 4 multipliers too.
fn needs(kernel: Kernel) -> usize {
    match kernel {
        Kernel::MassMatrix
        | Kernel::Constraints
        | Kernel::ConstraintMagnitudes
        | Kernel::ConstraintJacobian
        | Kernel::ConstraintTimeDerivative
        | Kernel::ConstraintLinearization
        | Kernel::SparseLinearization
        | Kernel::Drawing => 1,
        Kernel::ConvectiveForces
        | Kernel::GeneralizedForces
        | Kernel::ConstraintConvective
        | Kernel::KineticEnergy
        | Kernel::Dynamics
        | Kernel::DynamicsJacobian
        | Kernel::DynamicsSensitivity
        | Kernel::VelocityVariables
        | Kernel::Velocities
        | Kernel::EventValues => 2,
        Kernel::InverseDynamics | Kernel::OutputRates => 3,
        Kernel::Power | Kernel::Outputs | Kernel::Events => 4,
    }
}

/// The values of a column in SI units, from the unit of its heading or else the declared one.
fn in_si(column: &StoredColumn, declared: &str, factor: f64) -> Result<Vec<f64>, Stop> {
    let fail = |why: String| Stop::Usage(format!("`{}`: {why}", column.header()));
    let unit = column.unit.as_str();
    let factor = if column.has_unit && unit != declared {
        let (given, declared) = (Unit::parse(unit).map_err(fail)?, Unit::parse(declared).map_err(fail)?);
        if given.dimension() != declared.dimension() {
            return Err(fail(format!("`{unit}` is no unit of this quantity, which is in `{}`", declared.text())));
        }
        given.factor()
    } else {
        factor
    };
    if let Some(row) = column.values.iter().position(|value| !value.is_finite()) {
        return Err(fail(format!("row {} is not finite", row + 1)));
    }
    Ok(column.values.iter().map(|value| value * factor).collect())
}
