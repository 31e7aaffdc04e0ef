//! The `speeds` block: generalised speeds u = W q' + w, linear in the rates of the coordinates (Kane and Levinson,
//! Dynamics: Theory and Applications, 1985, section 2.12).
//!
//! Together with the rows that they satisfy by construction, the norms of quaternions and the constraints between
//! speeds, they must determine q': as many rows as coordinates, of which none follows from the others everywhere.

use super::interpreter::Interpreter;
use super::level::no_input;
use super::quantities::resolve_unit;
use super::rates::first_power;
use super::scope::plain;
use super::smooth::may_jump;
use super::value::Shape;
use super::{Constraint, Coordinate, Dependence, GeneralizedSpeed, Level, Model};
use crate::dsl::{self, Declaration, Region};
use crate::symbolic::{Differential, Expr, Graph, Symbol, evaluate};
use syn::Ident;

const WHAT: &str = "a generalised speed";

impl Model {
    /// The constraint rows, by index, that hold for all values of the generalised speeds.
    pub fn satisfied_rows(&self) -> Vec<usize> {
        satisfied(&self.constraints, &self.norm_constraints)
    }
}

/// Those that keep norms, and those between speeds; not those that events switch.
fn satisfied(constraints: &[Constraint], norm_constraints: &[usize]) -> Vec<usize> {
    let is_satisfied = |row: &usize| {
        constraints[*row].activity.is_none()
            && (constraints[*row].level == Level::Speeds || norm_constraints.contains(row))
    };
    (0..constraints.len()).filter(is_satisfied).collect()
}

pub(super) fn resolve_speeds(
    declaration: &Declaration,
    coordinates: &[Coordinate],
    constraints: &[Constraint],
    norm_constraints: &[usize],
    interpreter: &mut Interpreter,
) -> Vec<GeneralizedSpeed> {
    let speeds: Vec<GeneralizedSpeed> =
        declaration.speeds.iter().filter_map(|speed| resolve_speed(speed, declaration, interpreter)).collect();
    // Another mistake may be the reason why there are too few, or why constraints are missing.
    if interpreter.mistakes.is_empty() && !speeds.is_empty() {
        let names: Vec<&Ident> = declaration.speeds.iter().map(|speed| &speed.name).collect();
        let rows: Vec<&Constraint> =
            satisfied(constraints, norm_constraints).into_iter().map(|row| &constraints[row]).collect();
        let _ = check_count(&names, coordinates, &rows, interpreter).and_then(|()| {
            let rates: Vec<Expr> = rows.iter().map(|row| rate(row, interpreter)).collect();
            check_independent(&names, &speeds, coordinates, &rows, &rates, interpreter)
        });
    }
    speeds
}

fn resolve_speed(
    speed: &dsl::GeneralizedSpeed,
    declaration: &Declaration,
    interpreter: &mut Interpreter,
) -> Option<GeneralizedSpeed> {
    let name = plain(&speed.name);
    let unit = resolve_unit(&speed.unit, interpreter);
    let definition = declaration.lets.iter().find(|definition| definition.name == speed.name)?;
    let place = definition.value.region;
    let value = interpreter.values.get(&name)?.clone();
    let Shape::Scalar(scalar) = value.shape else {
        let message = format!(
            "generalised speed `{name}` is {}; write one line for each component: `{name}_x = (..).x;`",
            value.kind()
        );
        return interpreter.refuse(place, message);
    };
    let unit = unit?;
    interpreter.expect_unit(
        value.measured(&definition.value),
        &format!("generalised speed `{name}` is declared"),
        &name,
        &unit,
    );
    no_input(place, &[scalar], WHAT, interpreter)?;
    let rule = "a generalised speed is made of the rates of coordinates; `ddot()` cannot stand in it";
    interpreter.restrict(place, &[scalar], Dependence::ACCELERATION, rule)?;
    if !interpreter.dependences.of(&interpreter.graph, scalar).meets(Dependence::SPEED) {
        let message = format!("no rate of a coordinate stands in generalised speed `{name}`; write one, with `dot()`");
        return interpreter.refuse(place, message);
    }
    let rule = "a generalised speed is linear in the rates of coordinates, `a*dot(x) + b*dot(y) + c`";
    first_power(place, &[scalar], rule, interpreter)?;
    interpreter.smooth(place, &[scalar], Level::Speeds, WHAT)?;
    if may_jump(interpreter, &[scalar]) {
        let message = format!(
            "generalised speed `{name}` may jump by an `if` or `sign` in it, while no coordinate does: write it without"
        );
        return interpreter.refuse(place, message);
    }
    let symbol = interpreter.graph.symbol(&name);
    Some(GeneralizedSpeed { name, docs: speed.docs.clone(), unit, value: scalar, symbol })
}

/// W q' + w of a row that holds between speeds; of one between positions its rate.
fn rate(row: &Constraint, interpreter: &mut Interpreter) -> Expr {
    match row.level {
        Level::Speeds => row.value,
        Level::Positions => interpreter.motion.of(&mut interpreter.graph, row.value),
    }
}

/// Refuses more or fewer speeds than determine the rates.
fn check_count(
    names: &[&Ident],
    coordinates: &[Coordinate],
    rows: &[&Constraint],
    interpreter: &mut Interpreter,
) -> Option<()> {
    let (given, wanted) = (names.len(), coordinates.len().saturating_sub(rows.len()));
    if given == wanted {
        return Some(());
    }
    let listed: Vec<String> = rows.iter().map(|row| format!("`{}`", row.name)).collect();
    let less = match listed.as_slice() {
        [] => String::new(),
        _ => format!(", less the constraints that hold by construction, {}", listed.join(", ")),
    };
    let place = names.get(wanted).or(names.last())?;
    interpreter.refuse(
        Region::from(*place),
        format!("generalised speeds: {given} given, {wanted} needed, as many as coordinates{less}"),
    )
}

/// Refuses speeds that follow from those above them and from the constraints.
fn check_independent(
    names: &[&Ident],
    speeds: &[GeneralizedSpeed],
    coordinates: &[Coordinate],
    rows: &[&Constraint],
    rates: &[Expr],
    interpreter: &mut Interpreter,
) -> Option<()> {
    let mut by_speed: Vec<Differential> =
        coordinates.iter().map(|c| Differential::partial(&mut interpreter.graph, c.speed)).collect();
    let all = rates.iter().copied().chain(speeds.iter().map(|speed| speed.value));
    let matrix: Vec<Vec<Expr>> =
        all.map(|rate| by_speed.iter_mut().map(|by| by.of(&mut interpreter.graph, rate)).collect()).collect();
    let Some(dependent) = dependent(&interpreter.graph, &matrix) else { return Some(()) };
    match dependent.checked_sub(rows.len()) {
        Some(at) => interpreter.refuse(
            Region::from(names[at]),
            format!(
                "generalised speed `{}` follows from those above it and the constraints, so the rates of some coordinates stay \
                 undetermined; choose an independent one",
                speeds[at].name
            ),
        ),
        None => interpreter.refuse(
            Region::from(names[0]),
            format!(
                "constraint `{}` follows from others, so generalised speeds cannot satisfy both by construction; leave \
                 it out",
                rows[dependent].name
            ),
        ),
    }
}

/// The first row that follows from those before it at each of some places.
fn dependent(graph: &Graph, matrix: &[Vec<Expr>]) -> Option<usize> {
    let entries = matrix.concat();
    let symbols = graph.symbols_of(&entries);
    let at = |place: usize| -> Vec<bool> {
        let value = |symbol: Symbol| {
            let k = symbols.binary_search(&symbol).unwrap_or_default();
            ((place * symbols.len() + k + 1) as f64 * 0.618_033_988_75).fract() + 0.2
        };
        let values = evaluate(graph, &entries, value);
        dependences(values.chunks(matrix.first().map_or(1, Vec::len)))
    };
    let places = [0, 1, 2].map(at);
    (0..matrix.len()).find(|row| places.iter().all(|found| found[*row]))
}

/// Whether each row is a combination of those before it, by the Gram-Schmidt process.
fn dependences<'a>(rows: impl Iterator<Item = &'a [f64]>) -> Vec<bool> {
    let inner = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let is_dependent = |row: &[f64]| {
        let size = inner(row, row).sqrt();
        let mut rest = row.to_vec();
        // Twice is enough for the rest to be orthogonal (Giraud, Langou and Rozloznik 2005).
        for unit in basis.iter().chain(&basis) {
            let along = inner(&rest, unit);
            rest.iter_mut().zip(unit).for_each(|(x, u)| *x -= along * u);
        }
        let left = inner(&rest, &rest).sqrt();
        let dependent = left <= 1e-9 * size;
        if !dependent {
            basis.push(rest.into_iter().map(|x| x / left).collect());
        }
        dependent
    };
    rows.map(is_dependent).collect()
}
