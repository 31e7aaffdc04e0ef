//! `sim evaluate`.

mod columns;
mod table;

use crate::arguments::{EvaluateArguments, Voice};
use crate::events::only_in_runs;
use crate::tell::tell;
use crate::{Stop, print, unknown, with_values};
use columns::{Column, columns};
use sim_runtime::{Kernel, Model, Results, solve_each};
use table::Table;

/// Prints a kernel's results, a line for each state.
pub(crate) fn evaluate(model: &dyn Model, arguments: &EvaluateArguments, voice: Voice) -> Result<(), Stop> {
    let model = with_values(model, &arguments.set, &arguments.input)?;
    let name = arguments.kernel.as_str();
    let names = || Kernel::ALL.iter().map(|kernel| kernel.name());
    let kernel = Kernel::ALL.iter().copied().find(|kernel| kernel.name() == name);
    let kernel = kernel.ok_or_else(|| unknown("kernel", name, names()))?;
    if let Some(why) = kernel.missing_in(model.description()) {
        return Err(Stop::Usage(why));
    }
    let table = Table::read(model.description(), kernel, arguments)?;
    if !(voice.quiet || table.has_times) {
        tell!("there is no column `t`: t = 0 at all states");
    }
    if let Some(line) = only_in_runs(model.description()).filter(|_| !voice.quiet) {
        tell!("{line}");
    }
    let states = table.states();
    let results = solve_each(&model, kernel, &states);
    let columns = columns(model.description(), kernel, &results.rows);
    let found = Evaluated { times: states.times, columns: &columns, results: &results };
    print(&if voice.json { found.json() } else { found.csv() })?;
    found.outside().map_or(Ok(()), |row| {
        Err(Stop::Failed(anyhow::anyhow!(
            "`{name}` is not finite in row {}: an expression leaves its domain there (division by zero, root or logarithm of a \
             negative number)",
            row + 1
        )))
    })
}

/// A kernel's results at states.
struct Evaluated<'a> {
    times: &'a [f64],
    columns: &'a [Column],
    results: &'a Results,
}

impl Evaluated<'_> {
    /// The numbers of each state in the columns' units, where it is not refused.
    fn rows(&self) -> impl Iterator<Item = Option<Vec<f64>>> {
        let mut refused = self.results.refused.iter().peekable();
        (0..self.times.len()).map(move |row| {
            let numbers = &self.results.numbers[row * self.columns.len()..][..self.columns.len()];
            let in_units = || self.columns.iter().zip(numbers).map(|(column, number)| number / column.factor).collect();
            refused.next_if_eq(&&row).is_none().then(in_units)
        })
    }

    /// The first state at which a number is not finite, though the kernel does not refuse it.
    fn outside(&self) -> Option<usize> {
        self.rows().position(|row| row.is_some_and(|numbers| numbers.iter().any(|number| !number.is_finite())))
    }

    /// A line for each state, below a heading.
    fn csv(&self) -> String {
        let mut text = line("t [s]", self.columns.iter().map(|column| column.heading.clone()), "refused");
        for (time, row) in self.times.iter().zip(self.rows()) {
            let refused = if row.is_some() { "0" } else { "1" };
            let cell = |i: usize| row.as_ref().map_or_else(String::new, |numbers| format!("{:?}", numbers[i]));
            text += &line(&format!("{time:?}"), (0..self.columns.len()).map(cell), refused);
        }
        text
    }

    /// The same columns by their headings. Numbers that are not finite are null, as those that are refused.
    fn json(&self) -> String {
        let rows: Vec<Option<Vec<f64>>> = self.rows().collect();
        let of = |i: usize| rows.iter().map(|row| row.as_ref().map(|numbers| numbers[i])).collect();
        let found = self.columns.iter().enumerate().map(|(i, column)| (column.heading.clone(), of(i)));
        let times = [("t [s]".to_owned(), self.times.into())];
        let refused = [("refused".to_owned(), rows.iter().map(Option::is_none).collect())];
        let all: serde_json::Map<String, serde_json::Value> = times.into_iter().chain(found).chain(refused).collect();
        format!("{:#}\n", serde_json::Value::Object(all))
    }
}

/// A line of the table.
fn line(time: &str, cells: impl Iterator<Item = String>, refused: &str) -> String {
    let cells: Vec<String> = [time.to_owned()].into_iter().chain(cells).chain([refused.to_owned()]).collect();
    cells.join(",") + "\n"
}
