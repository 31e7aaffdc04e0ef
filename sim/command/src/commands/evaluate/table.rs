//! States in a table.

use crate::Stop;
use crate::arguments::EvaluateArguments;
use crate::files::stored::{StoredColumn, columns as columns_of};
use codegen::model::Unit;
use sim_kernel::{Description, Quantity};
use sim_runtime::{Kernel, States};

/// What a kernel reads, in SI units, state by state.
pub(super) struct Table {
    /// Whether the table has times; they are zero otherwise.
    pub(super) has_times: bool,
    times: Vec<f64>,
    /// Positions, speeds, accelerations and multipliers.
    levels: [Vec<f64>; 4],
}

impl Table {
    /// Takes the columns of the table that the arguments name.
    pub(super) fn read(
        description: &'static Description,
        kernel: Kernel,
        arguments: &EvaluateArguments,
    ) -> Result<Table, Stop> {
        let table = columns_of(&arguments.at)?;
        let rows = table.first().map_or(0, |column| column.values.len());
        if rows == 0 {
            let path = arguments.at.display();
            return Err(Stop::Usage(format!("{path}: no states; a line for each is needed below the heading")));
        }
        refuse_values(description, &table)?;
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
            each.collect::<Result<Vec<_>, Stop>>().map(|columns| by_state(&columns, rows))
        };
        let coordinates = description.coordinates;
        let named = |q: &'static Quantity| (q.name.to_owned(), q);
        let multipliers = description.constraints.iter().map(|c| (format!("lambda_{}", c.name), c));
        Ok(Table {
            has_times: table.iter().any(|column| column.name == "t"),
            times: of("t".into(), "s", 1.0, false)?,
            levels: [
                all(coordinates.iter().map(|c| named(&c.position)).collect(), 0)?,
                all(coordinates.iter().map(|c| named(&c.speed)).collect(), 1)?,
                all(coordinates.iter().map(|c| named(&c.acceleration)).collect(), 2)?,
                all(multipliers.collect(), 3)?,
            ],
        })
    }

    /// The states.
    pub(super) fn states(&self) -> States<'_> {
        let [positions, speeds, accelerations, multipliers] = &self.levels;
        States { times: &self.times, positions, speeds, accelerations, multipliers }
    }
}

/// Parameters and inputs are the same in all states: a column of them would be passed over.
fn refuse_values(description: &Description, table: &[StoredColumn]) -> Result<(), Stop> {
    let kinds = [(description.parameters, "a parameter", "--set"), (description.inputs, "an input", "--input")];
    for (quantities, kind, option) in kinds {
        if let Some(column) = table.iter().find(|column| quantities.iter().any(|q| q.name == column.name)) {
            let name = &column.name;
            return Err(Stop::Usage(format!(
                "`{name}` is {kind}, which is the same in all states: leave its column out, and give `{option} {name}=VALUE`"
            )));
        }
    }
    Ok(())
}

/// The numbers of columns, row by row.
fn by_state(columns: &[Vec<f64>], rows: usize) -> Vec<f64> {
    (0..rows).flat_map(|row| columns.iter().map(move |column| column[row])).collect()
}

/// How much a kernel needs of a state: 0 the time alone, 1 positions, 2 speeds too, 3 accelerations too, 4 multipliers too.
fn needs(kernel: Kernel) -> usize {
    match kernel {
        Kernel::SwitchingFunctions => 0,
        Kernel::MassMatrix
        | Kernel::SpeedMassMatrix
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
        | Kernel::EventValues
        | Kernel::LoadConditions => 2,
        Kernel::InverseDynamics | Kernel::OutputRates => 3,
        Kernel::Power | Kernel::Outputs | Kernel::Events => 4,
    }
}

/// The values of a column in SI units, from the unit of its heading or else the declared one.
fn in_si(column: &StoredColumn, declared: &str, factor: f64) -> Result<Vec<f64>, Stop> {
    let heading = if column.has_unit { column.header() } else { column.name.clone() };
    let fail = |why: String| Stop::Usage(format!("`{heading}`: {why}"));
    let unit = column.unit.as_str();
    let factor = if column.has_unit && unit != declared {
        let (given, declared) = (Unit::parse(unit).map_err(fail)?, Unit::parse(declared).map_err(fail)?);
        if given.dimension() != declared.dimension() {
            return Err(fail(format!("`{unit}` is no unit of this quantity, which is in `{}`", declared.text())));
        }
        if let Some(why) = given.mistaken_for(&declared) {
            return Err(fail(why));
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
