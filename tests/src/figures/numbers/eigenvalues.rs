//! Eigenvalues of matrices whose spectra are known exactly.

use crate::figures::Table;

pub(super) fn measure(table: &mut Table) {
    table.heading("Eigenvalues");
    table.elsewhere("10,000 matrices of exact spectra", "not measured yet");
}
