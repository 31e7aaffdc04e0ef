//! What grows with coupled pairs: uncoupled free bodies, chains of free bodies.

use crate::figures::Table;

pub(super) fn measure(table: &mut Table) {
    table.heading("Free bodies");
    table.elsewhere("400 free bodies without coupling: memory, code", "not measured yet");
    table.elsewhere("chains of 20 and 100 links as free bodies, beside angles", "not measured yet");
}
