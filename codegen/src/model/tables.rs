//! The `tables` block.

use super::homogeneity::Measured;
use super::interpret::Interpreter;
use super::quantities::resolve_unit;
use super::scope::{check_reserved, plain};
use super::spline::pieces;
use super::start::{is_of_numbers, is_plain};
use super::value::Value;
use super::{Dimension, Level, Unit};
use crate::dsl::{self, Between, Declaration, Expression, Outside, Region};
use crate::symbolic::{Expr, Graph, Table, TableId, evaluate};
use syn::Ident;

/// What a table's name stands for.
#[derive(Clone)]
pub(super) struct Function {
    table: TableId,
    argument: Unit,
    value: Dimension,
}

/// Takes all tables into the graph.
pub(super) fn resolve_tables(declaration: &Declaration, i: &mut Interpreter) {
    for table in &declaration.tables {
        let function = resolve_table(table, i);
        match check_reserved(&table.name) {
            Ok(()) => i.tables.define(&table.name, function, &mut i.mistakes),
            Err(mistake) => i.mistakes.add(mistake),
        }
    }
}

fn resolve_table(written: &dsl::Table, i: &mut Interpreter) -> Option<Function> {
    let name = plain(&written.name);
    let (unit, over) = (resolve_unit(&written.unit, i), resolve_unit(&written.over, i));
    let form = check_form(written, &name, i);
    let (unit, over) = (unit?, over?);
    let rows = written.rows.iter().map(|[x, y]| {
        let arguments = format!("the arguments of table `{name}` are");
        let (x, y) = (entry(x, &arguments, &over, i), entry(y, &format!("the values of table `{name}` are"), &unit, i));
        x.zip(y)
    });
    let rows: Vec<Option<(f64, f64)>> = rows.collect();
    form?;
    let rows = rows.into_iter().collect::<Option<Vec<_>>>()?;
    check_order(written, &rows, i)?;
    check_period(written, &rows, i)?;
    let (knots, values): (Vec<f64>, Vec<f64>) = rows.into_iter().unzip();
    let ends = written.ends.map(|(ends, _)| ends);
    let pieces = pieces(&knots, &values, written.between, ends, written.outside);
    if pieces.iter().flatten().any(|coefficient| !coefficient.is_finite()) {
        let message = format!("the values of table `{name}` change too steeply for the range of numbers");
        return i.refuse((&written.name).into(), message);
    }
    let (degree, smoothness) = match written.between {
        Between::Linear => (1, 0),
        Between::Monotone => (3, 1),
        Between::Cubic => (3, 2),
    };
    let is_periodic = written.outside == Outside::Periodic;
    let table = Table { name, docs: written.docs.clone(), knots, pieces, is_periodic, degree, smoothness };
    Some(Function { table: i.graph.add_table(table), argument: over, value: unit.dimension().clone() })
}

/// What the words before the rows must not say together, and how many rows there are.
fn check_form(written: &dsl::Table, name: &str, i: &mut Interpreter) -> Option<()> {
    let place = Region::from(&written.name);
    if let Some((_, region)) = written.ends {
        if written.between != Between::Cubic {
            return i.refuse(region, "only a `cubic` is `natural` or `clamped` at its ends");
        }
        if written.outside == Outside::Periodic {
            return i.refuse(region, "a periodic table has no ends; leave out `natural` or `clamped`");
        }
    }
    match written.rows.len() {
        0 => i.refuse(place, format!("table `{name}` has no rows; a row is an argument and a value: `90, 10;`")),
        1 => i.refuse(place, format!("table `{name}` has one row; a function is given by two or more")),
        _ => Some(()),
    }
}

/// An argument or a value of a row in SI units; plain numbers are in the unit of the column.
fn entry(expression: &Expression, claim: &str, unit: &Unit, i: &mut Interpreter) -> Option<f64> {
    if !is_of_numbers(expression) {
        return i
            .refuse(expression.region, "the rows of a table are numbers, which are known when the mechanism is built");
    }
    let (value, dimension) = i.scalar_value(expression)?;
    let value = if is_plain(expression) {
        let factor = unit.factor_expression(&mut i.graph);
        i.graph.mul(value, factor)
    } else {
        let claim =
            if unit.is_declared() { format!("{claim} in [{}]", unit.text()) } else { format!("{claim} pure numbers") };
        i.expect_dimension(Measured { expression, dimension: &dimension }, unit.dimension(), &claim)?;
        value
    };
    i.check_constants(expression.region, &[value])?;
    Some(evaluate(&i.graph, &[value], |_| f64::NAN)[0])
}

fn check_order(written: &dsl::Table, rows: &[(f64, f64)], i: &mut Interpreter) -> Option<()> {
    let at = rows.windows(2).position(|pair| pair[1].0 <= pair[0].0);
    let Some(at) = at else { return Some(()) };
    let [above, below] = [at, at + 1].map(|row| &written.rows[row][0]);
    let message = match rows[at].0 == rows[at + 1].0 {
        true => {
            format!("the arguments of a table increase from row to row, and {below} stands in the row above as well")
        }
        false => format!("the arguments of a table increase from row to row, and {below} stands below {above}"),
    };
    i.refuse(below.region, message)
}

/// A periodic table ends with the value that it starts with.
fn check_period(written: &dsl::Table, rows: &[(f64, f64)], i: &mut Interpreter) -> Option<()> {
    let (Some((_, first)), Some((_, last))) = (rows.first(), rows.last()) else { return Some(()) };
    if written.outside != Outside::Periodic || first == last {
        return Some(());
    }
    let [first, last] = [written.rows.first()?, written.rows.last()?].map(|row| &row[1]);
    let message = format!(
        "the last row of a periodic table closes the period: its value is that of the first row, {first}, and {last} stands here"
    );
    i.refuse(last.region, message)
}

impl Interpreter {
    /// `lift(phi)`
    pub(super) fn look_up(&mut self, region: Region, name: &Ident, arguments: &[Expression]) -> Option<Value> {
        let text = plain(name);
        let function = self.tables.find(name, &mut self.mistakes);
        let [argument] = arguments else {
            let message =
                format!("table `{text}` is written `{text}(x)`: 1 argument wanted, {} given", arguments.len());
            return self.refuse(region, message);
        };
        let (x, dimension) = self.scalar_value(argument)?;
        let function = function?;
        let claim = match function.argument.is_declared() {
            true => format!("table `{text}` is over [{}]", function.argument.text()),
            false => format!("table `{text}` is over pure numbers (`over [..]` says which unit its arguments have)"),
        };
        self.expect_dimension(
            Measured { expression: argument, dimension: &dimension },
            function.argument.dimension(),
            &claim,
        )?;
        Some(Value::scalar(self.graph.look_up(function.table, 0, x), Some(function.value)))
    }

    /// Refuses tables of which a derivative jumps where speeds would jump with it.
    pub(super) fn smooth(&mut self, place: Region, values: &[Expr], level: Level, what: &str) -> Option<()> {
        match rough(&self.graph, values, level) {
            Some(name) => {
                let message = format!(
                    "the slope of table `{name}` jumps at its rows, and speeds would jump with it: a table in {what} is `cubic`"
                );
                self.refuse(place, message)
            }
            None => Some(()),
        }
    }
}

/// A table of which a derivative jumps that is in the speed of something.
fn rough(graph: &Graph, values: &[Expr], level: Level) -> Option<String> {
    let used = graph.reachable(values);
    let rates = u8::from(level == Level::Positions);
    let rough = graph.look_ups().into_iter().find(|(expr, table, order)| {
        graph.table(*table).smoothness < *order + rates && used.binary_search(expr).is_ok()
    });
    rough.map(|(_, table, _)| graph.table(table).name.clone())
}
