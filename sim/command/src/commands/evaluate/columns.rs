//! The columns of a kernel's results.

use sim_kernel::{Description, Quantity};
use sim_runtime::Kernel;

/// A number of a result.
pub(super) struct Column {
    /// Its name and unit.
    pub(super) heading: String,
    /// The unit in SI units.
    pub(super) factor: f64,
}

/// The numbers of rows of such lengths, under the names that they have in a trajectory, or by row and column.
pub(super) fn columns(description: &Description, kernel: Kernel, rows: &[usize]) -> Vec<Column> {
    let in_rows = rows.iter().enumerate().flat_map(|(row, length)| (0..*length).map(move |i| (row, i)));
    in_rows.map(|(row, i)| column(description, kernel, row, i)).collect()
}

fn column(description: &Description, kernel: Kernel, row: usize, i: usize) -> Column {
    let quantity =
        |prefix: &str, q: &Quantity| Column { heading: format!("{prefix}{} [{}]", q.name, q.unit), factor: q.factor };
    let plain = |heading: String| Column { heading, factor: 1.0 };
    match (kernel, row) {
        (Kernel::Dynamics, 0) => quantity("", &description.coordinates[i].acceleration),
        (Kernel::Dynamics, 1) => quantity("lambda_", &description.constraints[i]),
        (Kernel::Dynamics, _) => plain("power [W]".to_owned()),
        (Kernel::Outputs, _) => quantity("", &description.outputs[i]),
        _ if is_matrix(kernel) => plain(format!("{}_{}_{}", kernel.name(), row + 1, i + 1)),
        _ => plain(format!("{}_{}", kernel.name(), i + 1)),
    }
}

/// A matrix of one row is one too.
fn is_matrix(kernel: Kernel) -> bool {
    matches!(
        kernel,
        Kernel::MassMatrix
            | Kernel::SpeedMassMatrix
            | Kernel::ConstraintJacobian
            | Kernel::ConstraintLinearization
            | Kernel::SparseLinearization
            | Kernel::DynamicsJacobian
            | Kernel::DynamicsSensitivity
    )
}
