//! The `tables` block.
//!
//! Rows become cubics when the mechanism is resolved, and constants of its type. A table is one node of the graph with
//! the order of its derivative, and a kernel looks a piece up once for each argument, lane by lane. So dual numbers and
//! lanes need nothing but the look-up. The oracle makes its splines another way: from second derivatives, by
//! relaxation.

use super::Unit;
use super::function::Function;
use super::interpreter::Interpreter;
use super::measured::Measured;
use super::plain::{is_of_numbers, is_plain};
use super::quantities::resolve_unit;
use super::scope::{check_reserved, plain};
use super::spline::pieces;
use crate::dsl::{self, Between, Declaration, Expression, Outside, Region};
use crate::symbolic::{Table, evaluate};

/// Takes all tables into the graph.
pub(super) fn resolve_tables(declaration: &Declaration, interpreter: &mut Interpreter) {
    for table in &declaration.tables {
        let function = resolve_table(table, interpreter);
        match check_reserved(&table.name) {
            Ok(()) => interpreter.tables.define(&table.name, function, &mut interpreter.mistakes),
            Err(mistake) => interpreter.mistakes.add(mistake),
        }
    }
}

fn resolve_table(written: &dsl::DeclaredTable, interpreter: &mut Interpreter) -> Option<Function> {
    let name = plain(&written.name);
    let (unit, over) = (resolve_unit(&written.unit, interpreter), resolve_unit(&written.over, interpreter));
    let form = check_form(written, &name, interpreter);
    let (unit, over) = (unit?, over?);
    check_headings(written, &name, [&over, &unit], interpreter)?;
    let rows = written.rows.iter().map(|[x, y]| {
        let arguments = format!("the arguments of table `{name}` are");
        let (x, y) = (
            entry(x, &arguments, &over, interpreter),
            entry(y, &format!("the values of table `{name}` are"), &unit, interpreter),
        );
        x.zip(y)
    });
    let rows: Vec<Option<(f64, f64)>> = rows.collect();
    form?;
    let rows = rows.into_iter().collect::<Option<Vec<_>>>()?;
    check_order(written, &rows, interpreter)?;
    let (knots, mut values): (Vec<f64>, Vec<f64>) = rows.into_iter().unzip();
    if written.outside == Outside::Periodic {
        close_period(written, &mut values, &unit, interpreter)?;
    }
    let ends = written.ends.map(|(ends, _)| ends);
    let pieces = pieces(&knots, &values, written.between, ends, written.outside);
    if pieces.iter().flatten().any(|coefficient| !coefficient.is_finite()) {
        let message = format!("the values of table `{name}` change too steeply for the range of numbers");
        return interpreter.refuse((&written.name).into(), message);
    }
    let (degree, smoothness) = match written.between {
        Between::Linear => (1, 0),
        Between::Monotone => (3, 1),
        Between::Cubic => (3, 2),
    };
    let is_periodic = written.outside == Outside::Periodic;
    let table = Table { name, docs: written.docs.clone(), knots, pieces, is_periodic, degree, smoothness };
    Some(Function { table: interpreter.graph.add_table(table), argument: over, value: unit.dimension().clone() })
}

/// Checks the combination of words before the rows, and the number of rows.
fn check_form(written: &dsl::DeclaredTable, name: &str, interpreter: &mut Interpreter) -> Option<()> {
    let place = Region::from(&written.name);
    if let Some((_, region)) = written.ends {
        if written.between != Between::Cubic {
            return interpreter.refuse(region, "only a `cubic` table can be `natural` or `clamped`");
        }
        if written.outside == Outside::Periodic {
            return interpreter.refuse(region, "a periodic table has no ends; leave out `natural` or `clamped`");
        }
    }
    match written.rows.len() {
        0 => interpreter
            .refuse(place, format!("table `{name}` has no rows; a row is an argument and a value: `90, 10;`")),
        1 => interpreter.refuse(place, format!("table `{name}` has one row; a function is given by two or more")),
        _ => Some(()),
    }
}

/// A heading that says another unit than the declaration belongs to rows in that unit.
fn check_headings(
    written: &dsl::DeclaredTable,
    name: &str,
    declared: [&Unit; 2],
    interpreter: &mut Interpreter,
) -> Option<()> {
    let Some(headings) = &written.headings else { return Some(()) };
    for ((heading, declared), column) in headings.iter().zip(declared).zip(["arguments", "values"]) {
        let text = heading.value();
        let Some(said) = said_unit(&text).or_else(|| last_word(&text, declared).map(Ok)) else { continue };
        let message = match said {
            Ok(said) if said.is_same_as(declared) => continue,
            Ok(said) => {
                let (said, declared) = (said.text(), declared.text());
                format!(
                    "the heading says that the {column} of table `{name}` are in [{said}]; they are declared in [{declared}]"
                )
            }
            Err(text) => {
                format!("the heading says [{text}], which is no unit; write one such as `[deg]` or `[1]`, or none")
            }
        };
        return interpreter.refuse(heading.span().into(), message);
    }
    Some(())
}

/// The unit of a heading: `F [kN]`, `F in kN`, `F/kN` or `F (kN)`, with other words around it; of several in brackets the last. Words
/// without square brackets need not be one.
fn said_unit(heading: &str) -> Option<Result<Unit, String>> {
    let heading = heading.trim();
    let within = |open: char, close: char| {
        let parts = heading.split(open).skip(1);
        parts.filter_map(move |part| part.split_once(close)).map(|(text, _)| text.trim())
    };
    if let Some(text) = within('[', ']').last() {
        let is_pure = matches!(text, "" | "-");
        return Some(if is_pure { Ok(Unit::none()) } else { Unit::parse(text).map_err(|_| text.to_owned()) });
    }
    let bare: String = heading.split('(').map(|part| part.split_once(')').map_or(part, |(_, after)| after)).collect();
    let last = bare.trim().rsplit_once(' ').filter(|(_, text)| text.contains('/'));
    let after = || bare.rsplit_once(" in ").or_else(|| bare.split_once('/'));
    let named = last.into_iter().chain(after()).find_map(|(_, text)| Unit::parse(text.trim()).ok());
    named.or_else(|| within('(', ')').filter_map(|text| Unit::parse(text).ok()).last()).map(Ok)
}

/// The last of several words of a heading, as of `F kN` or `F {kN}`, if it is a unit of the same kind as this.
fn last_word(heading: &str, declared: &Unit) -> Option<Unit> {
    let is_between = |c: char| c.is_whitespace() || "(){},;".contains(c);
    let mut words = heading.split(is_between).filter(|word| !word.is_empty());
    let last = words.next_back().filter(|last| words.next().is_some() && last.contains(char::is_alphabetic))?;
    Unit::parse(last).ok().filter(|unit| unit.dimension() == declared.dimension())
}

/// An argument or a value of a row in SI units; plain numbers are in the unit of the column.
fn entry(expression: &Expression, claim: &str, unit: &Unit, interpreter: &mut Interpreter) -> Option<f64> {
    if !is_of_numbers(expression) {
        return interpreter
            .refuse(expression.region, "the rows of a table are numbers, which are known when the mechanism is built");
    }
    let (value, dimension) = interpreter.scalar_value(expression)?;
    let value = if is_plain(expression) {
        let factor = unit.factor_expression(&mut interpreter.graph);
        interpreter.graph.mul(value, factor)
    } else {
        let claim =
            if unit.is_declared() { format!("{claim} in [{}]", unit.text()) } else { format!("{claim} pure numbers") };
        interpreter.expect_in_unit(Measured { expression, dimension: &dimension }, unit, &claim)?;
        value
    };
    interpreter.check_constants(expression.region, &[value])?;
    Some(evaluate(&interpreter.graph, &[value], |_| f64::NAN)[0])
}

fn check_order(written: &dsl::DeclaredTable, rows: &[(f64, f64)], interpreter: &mut Interpreter) -> Option<()> {
    let at = rows.windows(2).position(|pair| pair[1].0 <= pair[0].0);
    let Some(at) = at else { return Some(()) };
    let [above, below] = [at, at + 1].map(|row| &written.rows[row][0]);
    let message = match rows[at].0 == rows[at + 1].0 {
        true => {
            format!("the arguments of a table must increase from row to row; {below} is in the row above too")
        }
        false => format!("the arguments of a table must increase from row to row; {below} follows {above}"),
    };
    interpreter.refuse(below.region, message)
}

/// A periodic table ends with the value that it starts with. One that was computed may differ by its rounding.
fn close_period(
    written: &dsl::DeclaredTable,
    values: &mut [f64],
    unit: &Unit,
    interpreter: &mut Interpreter,
) -> Option<()> {
    const ROUNDING: f64 = 1e-12;
    let largest = values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let [first, .., last] = values else { return Some(()) };
    if (*last - *first).abs() <= ROUNDING * largest {
        *last = *first;
        return Some(());
    }
    let [first, last] = [*first, *last].map(|value| shown(value, unit));
    let message =
        format!("the last row of a periodic table must repeat the value of the first, {first}; this is {last}");
    interpreter.refuse(written.rows.last()?[1].region, message)
}

/// A value in its unit, without the last digit, which the conversion rounds.
fn shown(value: f64, unit: &Unit) -> String {
    let rounded = format!("{:.14e}", value / unit.factor());
    rounded.parse().map_or(rounded, |value: f64| value.to_string())
}
