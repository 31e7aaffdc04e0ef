//! The shapes of a kernel's results.

use sim_runtime::{Description, Kernel};
use std::ops::Range;

/// The shape of a result at one state.
#[derive(Clone, Copy)]
pub(crate) enum Shape {
    Number,
    Vector,
    Matrix(usize, usize),
}

/// A result among those of a kernel.
pub(crate) struct Part {
    pub(crate) shape: Shape,
    /// Its places among the numbers of a state.
    pub(crate) numbers: Range<usize>,
}

/// The results of a kernel that gives rows of these lengths.
pub(crate) fn parts(kernel: Kernel, description: &Description, rows: &[usize]) -> Vec<Part> {
    let shapes = shapes(kernel, description, rows.len());
    let (mut from, mut rows) = (0, rows.iter());
    let part = |shape: Shape| {
        let length = match shape {
            Shape::Number | Shape::Vector => rows.next().copied().unwrap_or(0),
            Shape::Matrix(height, _) => rows.by_ref().take(height).sum(),
        };
        let numbers = from..from + length;
        from = numbers.end;
        Part { shape, numbers }
    };
    shapes.into_iter().map(part).collect()
}

fn shapes(kernel: Kernel, description: &Description, rows: usize) -> Vec<Shape> {
    use Shape::{Matrix, Number, Vector};
    let [n, m, p] = [description.coordinates.len(), description.constraints.len(), description.parameters.len()];
    match kernel {
        Kernel::KineticEnergy | Kernel::Power => vec![Number],
        Kernel::MassMatrix => vec![Matrix(n, n)],
        Kernel::SpeedMassMatrix => vec![Matrix(rows, rows)],
        Kernel::ConstraintJacobian => vec![Matrix(m, n)],
        Kernel::ConstraintLinearization => vec![Vector, Vector, Matrix(m, n)],
        Kernel::SparseLinearization => vec![Vector, Vector, Vector],
        Kernel::Dynamics => vec![Vector, Vector],
        Kernel::DynamicsJacobian => vec![Matrix(n, n), Matrix(n, n), Matrix(m, n), Matrix(m, n)],
        Kernel::DynamicsSensitivity => vec![Matrix(n, p), Matrix(m, p)],
        _ => vec![Vector],
    }
}
