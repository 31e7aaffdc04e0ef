//! Rows of tables, at which loads change their form.

use sim_kernel::{Switching, Table};

/// A difference of slopes or of second derivatives that is rounding, as a part of what they are over the distance of rows.
const ROUNDING: f64 = 1e-9;

/// Whether slope and second derivative of a table are the same on both sides of a row.
pub(super) fn is_gentle(table: &Table, row: f64) -> bool {
    let [[_, slope, bend], [_, after, bent]] = [row.next_down(), row].map(|x| table.at::<f64, 3>(x));
    let apart = (table.next_row(row) - row).min(row - table.last_row(row)).max(f64::MIN_POSITIVE);
    let size = slope.abs() + after.abs() + apart * (bend.abs() + bent.abs());
    (after - slope).abs() <= ROUNDING * size && apart * (bent - bend).abs() <= ROUNDING * size
}

/// The values of a condition, on the way from one to another, at which its load changes its form: of a table the row behind, and
/// as many ahead as matter.
pub(super) fn levels(condition: &Switching, [from, to]: [f64; 2]) -> impl Iterator<Item = f64> {
    let rows = condition.table.map(|table| {
        let (ahead, behind) = if from <= to {
            (table.next_row(from), table.last_row(from))
        } else {
            (table.last_row(from), table.next_row(from))
        };
        let further = move |row: &f64| Some(if from <= to { table.next_row(*row) } else { table.last_row(*row) });
        std::iter::successors(Some(ahead), further).take(3).chain([behind])
    });
    let zero = rows.is_none().then_some(0.0);
    rows.into_iter().flatten().chain(zero).filter(|level| level.is_finite())
}
