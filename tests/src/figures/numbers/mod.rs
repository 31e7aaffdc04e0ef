//! No wrong number with exit status 0: each file measures the lines of one subject.

mod bennett;
mod coupling;
mod eigenvalues;
mod extremes;
mod faults;
mod known;
mod speed;
mod stress;
mod verify;

use super::Table;

pub(super) fn measure(table: &mut Table) {
    known::measure(table);
    stress::measure(table);
    bennett::measure(table);
    extremes::measure(table);
    eigenvalues::measure(table);
    verify::measure(table);
    faults::measure(table);
    coupling::measure(table);
    speed::measure(table);
}
