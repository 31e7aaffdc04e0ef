//! `sim evaluate`.

mod columns;
mod table;

use crate::cli::arguments::EvaluateArguments;
use crate::cli::{Stop, print, unknown, with_values};
use crate::{Kernel, Model};
use columns::{Column, columns};
use table::Table;

/// Prints a kernel's results, a line for each state.
pub(in crate::cli) fn evaluate(model: &dyn Model, arguments: &EvaluateArguments) -> Result<(), Stop> {
    let model = with_values(model, &arguments.set, &arguments.input)?;
    let name = arguments.kernel.as_str();
    let names = || Kernel::ALL.iter().map(|kernel| kernel.name());
    let kernel = Kernel::ALL.iter().copied().find(|kernel| kernel.name() == name);
    let kernel = kernel.ok_or_else(|| unknown("kernel", name, names()))?;
    if let Some(why) = kernel.missing_in(model.description()) {
        return Err(Stop::Usage(why));
    }
    let table = Table::read(model.description(), kernel, arguments)?;
    let states = table.states();
    let results = model.call_each(kernel, &states);
    let columns = columns(model.description(), kernel, &results.rows);
    let mut text = line("t [s]", columns.iter().map(|column| column.heading.clone()), "refused");
    let (mut refused, mut outside) = (results.refused.iter().peekable(), None);
    for (row, time) in states.times.iter().enumerate() {
        let is_refused = refused.next_if_eq(&&row).is_some();
        let numbers = &results.numbers[row * columns.len()..][..columns.len()];
        if !is_refused && numbers.iter().any(|number| !number.is_finite()) {
            outside = outside.or(Some(row + 1));
        }
        let cell = |(column, number): (&Column, &f64)| {
            if is_refused { String::new() } else { format!("{:?}", number / column.factor) }
        };
        text += &line(&format!("{time:?}"), columns.iter().zip(numbers).map(cell), if is_refused { "1" } else { "0" });
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
