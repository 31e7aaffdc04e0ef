//! The derivatives of the motion from dual numbers, where the declaration asks for no program for them: as
//! [`sim_kernel`]'s trait does it, and to the same bits.

use super::kernels::{Kernels, given};
use crate::model::erased::{Found, Values};
use crate::model::{At, constants};
use codegen::kernel_id::KernelId;
use sim_kernel::{Dual, Scalar};

impl Kernels<'_, f64> {
    /// Columns of d(q'', lambda)/dq and d(q'', lambda)/dq' as rows of the four matrices; true if a pivot is refused.
    pub(super) fn jacobian(self, at: At<f64>, found: Found<f64>) -> bool {
        let values = self.values.map(Dual::constant);
        let prepared = Kernels { programs: self.programs, values: &values }.prepare();
        let (n, m) = (self.n(), self.programs.description.constraints.len());
        let [q, qd] = [at.positions, at.speeds].map(|given| all(given, n));
        let [mut by_positions, mut by_speeds] = [0, 1].map(|_| Columns::new(n + m, n));
        let mut refused = false;
        for j in 0..n {
            let varied = varied(&q, j);
            let solved = At::moving(Dual::constant(at.time), &varied, &qd);
            refused |= by_positions.enter(j, self, &values, &prepared, solved);
            let varied = self::varied(&qd, j);
            let solved = At::moving(Dual::constant(at.time), &q, &varied);
            by_speeds.enter(j, self, &values, &prepared, solved);
        }
        let mut row = 0;
        for rows in [0..n, n..n + m] {
            for columns in [&by_positions, &by_speeds] {
                for i in rows.clone() {
                    found(row, columns.row(i));
                    row += 1;
                }
            }
        }
        refused
    }

    /// d(q'', lambda)/d(parameters) by rows.
    pub(super) fn sensitivity(self, at: At<f64>, found: Found<f64>) -> bool {
        let values = self.values.map(Dual::constant);
        let (n, m) = (self.n(), self.programs.description.constraints.len());
        let [q, qd] = [at.positions, at.speeds].map(|given| all(given, n));
        let mut columns = Columns::new(n + m, values.parameters.len());
        let mut refused = false;
        for j in 0..values.parameters.len() {
            let values = Values { parameters: varied(&values.parameters, j), ..values.clone() };
            let prepared = Kernels { programs: self.programs, values: &values }.prepare();
            refused |= columns.enter(j, self, &values, &prepared, At::moving(Dual::constant(at.time), &q, &qd));
        }
        (0..n + m).for_each(|i| found(i, columns.row(i)));
        refused
    }
}

/// Numbers that do not vary; zero where they are omitted.
fn all(given: &[f64], n: usize) -> Vec<Dual> {
    let mut numbers = constants(given);
    numbers.resize(n, Dual::ZERO);
    numbers
}

/// The same numbers, with one as the variable of differentiation.
fn varied(values: &[Dual], j: usize) -> Vec<Dual> {
    let mut values = values.to_vec();
    values[j] = Dual::variable(values[j].value);
    values
}

/// A matrix that is found by columns.
struct Columns {
    width: usize,
    entries: Vec<f64>,
}

impl Columns {
    fn new(rows: usize, width: usize) -> Columns {
        Columns { width, entries: vec![f64::NAN; rows * width] }
    }

    fn row(&self, i: usize) -> &[f64] {
        &self.entries[i * self.width..][..self.width]
    }

    /// Enters the derivatives of a solution as a column.
    fn enter(
        &mut self,
        j: usize,
        kernels: Kernels<f64>,
        values: &Values<Dual>,
        prepared: &[Dual],
        at: At<Dual>,
    ) -> bool {
        let mut i = 0;
        let given = given(kernels.programs, &values.inputs, prepared, at);
        kernels.programs.call(KernelId::Dynamics, &given, &mut |row, numbers| {
            // The third row is the power.
            for number in numbers.iter().filter(|_| row < 2) {
                self.entries[i * self.width + j] = number.derivative;
                i += 1;
            }
        })
    }
}
