//! Eigenvalues of matrices whose spectra are known exactly.

use crate::figures::Table;

pub(super) fn measure(table: &mut Table) {
    table.heading("Eigenvalues");
    for (what, value, bound) in tests::spectra::lines(10_000) {
        table.at_most(&what, value, bound);
    }
}
