//! The kernels of a mechanism.

use super::eliminate::{Labels, System, eliminate};
use super::lower::Lowering;
use super::names::Names;
use super::schedule::Schedule;
use super::values::{Input, Value};
use super::{Arguments, Entries, Kernel, Operations, Program, Results};
use crate::dynamics::EquationsOfMotion;
use crate::model::{Model, Shape, Start};
use crate::symbolic::{Expr, Symbol};
use rustc_hash::FxHashMap;

/// Plans every kernel. `equations` is changed only by start values entering its graph.
pub fn plan(equations: &mut EquationsOfMotion) -> Program {
    let zero = equations.model.graph.zero();
    let planner = Planner::new(equations);
    let (e, n) = (&*equations, equations.model.coordinates.len());
    let m = e.model.constraints.len();
    use Arguments::*;
    let vector = |name, arguments, docs: String, values: &[Expr]| {
        planner.kernel(name, arguments, docs, Wanted::Vector(values.to_vec()))
    };
    let matrix =
        |name, docs: String, rows: &[Vec<Expr>]| planner.kernel(name, Positions, docs, Wanted::Matrix(rows.to_vec()));
    let constraints = &e.constraints;
    let (positions, speeds) = start(&e.model, zero);
    let rates: Vec<Expr> = e.outputs.rates.iter().flatten().copied().collect();
    let events: Vec<Expr> = e.model.events.iter().map(|event| event.value).collect();
    let kernels = vec![
        planner.kernel("dynamics", Speeds, dynamics_docs(n, m), Wanted::Dynamics),
        matrix(
            "mass_matrix",
            format!("Mass matrix `T_q' M T_q`, {n} x {n}, symmetric, in SI units."),
            &e.tmt.mass_matrix,
        ),
        vector(
            "convective_forces",
            Speeds,
            format!("Convective forces `T_q' M g`, {n}, with `g = (T_q q' + T_t)_q q' + (..)_t`."),
            &e.tmt.convective_forces,
        ),
        vector(
            "generalized_forces",
            Speeds,
            format!("Generalised forces `T_q' F`, {n}: joules per unit of each coordinate."),
            &e.tmt.generalized_forces,
        ),
        vector(
            "constraints",
            Positions,
            format!("Constraints `C`, {m}; zero throughout the motion."),
            &constraints.values,
        ),
        vector(
            "constraint_magnitudes",
            Positions,
            format!("The sum of the magnitudes of the terms of `C`, {m}: what its rounding is relative to."),
            &constraints.magnitudes,
        ),
        matrix("constraint_jacobian", format!("Constraint Jacobian `C_q`, {m} x {n}."), &constraints.jacobian),
        vector(
            "constraint_time_derivative",
            Positions,
            format!("`C_t`, {m}: the speeds obey `C_q q' + C_t = 0`."),
            &constraints.time_derivative,
        ),
        vector(
            "constraint_convective",
            Speeds,
            format!("`(C_q q' + C_t)_q q' + (..)_t`, {m}: the part of `C''` without accelerations."),
            &constraints.convective,
        ),
        planner.kernel(
            "constraint_linearization",
            Positions,
            format!("`C` ({m}), `C_q` ({m} x {n}) and `C_t` ({m}) together, for projection."),
            Wanted::Linearization,
        ),
        planner.kernel(
            "kinetic_energy",
            Speeds,
            "Kinetic energy `v' M v / 2`, in joules.".into(),
            Wanted::Scalar(e.energy.kinetic),
        ),
        planner.kernel(
            "power",
            Multipliers,
            "Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.".into(),
            Wanted::Scalar(e.energy.power),
        ),
        vector("outputs", Multipliers, "Outputs, in SI units.".into(), &e.outputs.values),
        vector(
            "output_rates",
            Accelerations,
            "Rates of the outputs that depend on neither accelerations nor multipliers, in SI units.".into(),
            &rates,
        ),
        vector("events", Speeds, "`left - right` of each event, zero when it happens.".into(), &events),
        vector(
            "drawing",
            Positions,
            "The numbers of each shape of the drawing, in metres and radians.".into(),
            &drawing(&e.model),
        ),
        planner.kernel(
            "initial",
            Parameters,
            "Declared start: values or guesses of the coordinates, and speeds; 0 where nothing is declared.".into(),
            Wanted::Initial(positions, speeds),
        ),
    ];
    Program { kernels }
}

fn dynamics_docs(n: usize, m: usize) -> String {
    format!(
        "Accelerations ({n}), multipliers ({m}) and power, from\n\n```text\n\
         [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]\n\
         [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]\n```\n\n\
         by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and \
         nothing else holds: solve that state from the other kernels."
    )
}

fn start(model: &Model, zero: Expr) -> (Vec<Expr>, Vec<Expr>) {
    let position = |start: Start| match start {
        Start::Given(value) | Start::Guess(value) => value,
        Start::Free => zero,
    };
    let coordinates = model.coordinates.iter();
    coordinates.map(|c| (position(c.start), c.start_speed.unwrap_or(zero))).unzip()
}

fn drawing(model: &Model) -> Vec<Expr> {
    let numbers = model.drawing.iter().flat_map(|shape| match shape {
        Shape::Line(points) | Shape::Ground(points) | Shape::Points(points) => points.concat(),
        Shape::Slider([x, y], number) | Shape::Circle([x, y], number) => vec![*x, *y, *number],
    });
    numbers.collect()
}

/// What a kernel is to return.
enum Wanted {
    Scalar(Expr),
    Vector(Vec<Expr>),
    Matrix(Vec<Vec<Expr>>),
    Initial(Vec<Expr>, Vec<Expr>),
    Linearization,
    Dynamics,
}

struct Planner<'a> {
    equations: &'a EquationsOfMotion,
    inputs: FxHashMap<Symbol, Input>,
    /// Names wished for values of the model.
    labels: Vec<(Expr, String)>,
}

impl<'a> Planner<'a> {
    fn new(equations: &'a EquationsOfMotion) -> Planner<'a> {
        let model = &equations.model;
        let mut inputs = FxHashMap::default();
        inputs.insert(model.time, Input::Time);
        inputs.extend(model.parameters.iter().enumerate().map(|(i, p)| (p.symbol, Input::Parameter(i))));
        for (i, c) in model.coordinates.iter().enumerate() {
            let levels = [
                (c.position, Input::Position(i)),
                (c.speed, Input::Speed(i)),
                (c.acceleration, Input::Acceleration(i)),
            ];
            inputs.extend(levels);
        }
        inputs.extend(model.constraints.iter().enumerate().map(|(i, c)| (c.multiplier, Input::Multiplier(i))));
        Planner { equations, inputs, labels: labels(equations) }
    }

    fn kernel(&self, name: &'static str, arguments: Arguments, docs: String, wanted: Wanted) -> Kernel {
        let mut lowering = Lowering::new(&self.equations.model.graph, &self.inputs);
        let mut labels = Labels::new();
        let plan = self.lower(&wanted, &mut lowering, &mut labels);
        let roots = plan.roots();
        let wished = self.labels.iter().filter_map(|(expr, name)| Some((lowering.lowered(*expr)?, name.clone())));
        // The first wish for a value wins: what the user named, then what the method names.
        let mut by_value: FxHashMap<Value, String> = FxHashMap::default();
        for (value, name) in wished.chain(labels) {
            if let Some(opposite) = lowering.values.opposite(value) {
                by_value.entry(opposite).or_insert_with(|| format!("minus_{name}"));
            }
            by_value.entry(value).or_insert(name);
        }
        let mut names = Names::new();
        let (entries, input_names) = self.name_inputs(&lowering, &roots, &mut names);
        let schedule = Schedule::new(&lowering.values, &roots, &by_value, &input_names, &mut names);
        let results = plan.results(&schedule);
        let statements = schedule.statements;
        let operations = Operations::of(&statements, &results);
        Kernel { name, docs, arguments, entries, statements, results, operations }
    }

    fn lower(&self, wanted: &Wanted, lowering: &mut Lowering, labels: &mut Labels) -> Plan {
        let constraints = &self.equations.constraints;
        let rows =
            |lowering: &mut Lowering, rows: &[Vec<Expr>]| rows.iter().map(|row| lowering.lower_all(row)).collect();
        match wanted {
            Wanted::Scalar(expr) => Plan::Scalar(lowering.lower(*expr)),
            Wanted::Vector(exprs) => Plan::Vector(lowering.lower_all(exprs)),
            Wanted::Matrix(matrix) => Plan::Matrix(rows(lowering, matrix)),
            Wanted::Initial(positions, speeds) => {
                Plan::Initial(lowering.lower_all(positions), lowering.lower_all(speeds))
            }
            Wanted::Linearization => Plan::Linearization(
                lowering.lower_all(&constraints.values),
                rows(lowering, &constraints.jacobian),
                lowering.lower_all(&constraints.time_derivative),
            ),
            Wanted::Dynamics => self.lower_dynamics(lowering, labels),
        }
    }

    fn lower_dynamics(&self, lowering: &mut Lowering, labels: &mut Labels) -> Plan {
        let EquationsOfMotion { model, tmt, constraints, energy, .. } = self.equations;
        let (n, m) = (model.coordinates.len(), model.constraints.len());
        let mut entry = |expr: Expr| (!model.graph.is_zero(expr)).then(|| lowering.lower(expr));
        let mut matrix: Vec<Vec<_>> = (0..n).map(|i| (0..=i).map(|j| entry(tmt.mass_matrix[i][j])).collect()).collect();
        for (i, row) in constraints.jacobian.iter().enumerate() {
            matrix.push(row.iter().map(|expr| entry(*expr)).chain(vec![None; i + 1]).collect());
        }
        let mut rhs = lowering.lower_all(&tmt.right_hand_side);
        for expr in &constraints.convective {
            let value = lowering.lower(*expr);
            rhs.push(lowering.values.negate(value));
        }
        let names: Vec<String> = model
            .coordinates
            .iter()
            .map(|c| c.name.clone())
            .chain(model.constraints.iter().map(|c| format!("lambda_{}", c.name)))
            .collect();
        let system = System { matrix, rhs, coordinates: n };
        let mut solved = Labels::new();
        let solution = eliminate(&mut lowering.values, &system, &names, &mut solved);
        let zero = lowering.values.constant(0.0);
        let (unknowns, pivots) = match solution {
            Some(solution) => (solution.unknowns, Some(solution.pivots)),
            None => (vec![zero; n + m], None),
        };
        let solved_inputs =
            (0..n).map(Input::Acceleration).chain((0..m).map(Input::Multiplier)).zip(unknowns.iter().copied());
        lowering.replace_inputs(solved_inputs.collect());
        let power = lowering.lower(energy.power);
        labels.extend(solved.into_iter().map(|(value, name)| match unknowns.iter().position(|u| *u == value) {
            Some(i) if i < n => (value, format!("{name}_ddot")),
            _ => (value, name),
        }));
        let (accelerations, multipliers) = (unknowns[..n].to_vec(), unknowns[n..].to_vec());
        Plan::Dynamics { accelerations, multipliers, power, pivots }
    }

    /// Local names for the inputs that are needed, under the user's names where these are free.
    fn name_inputs(
        &self,
        lowering: &Lowering,
        roots: &[Value],
        names: &mut Names,
    ) -> (Entries, FxHashMap<Input, String>) {
        let model = &self.equations.model;
        let needed = lowering.inputs_of(roots);
        let mut by_input = FxHashMap::default();
        by_input.insert(Input::Time, "t".to_owned());
        for (i, parameter) in model.parameters.iter().enumerate() {
            by_input.insert(Input::Parameter(i), parameter.name.clone());
        }
        let mut name = |input: Input, wished: String| {
            let name = needed.contains(&input).then(|| names.unique(&wished))?;
            by_input.insert(input, name.clone());
            Some(name)
        };
        let coordinates = || model.coordinates.iter().enumerate();
        let entries = Entries {
            positions: coordinates().map(|(i, c)| name(Input::Position(i), c.name.clone())).collect(),
            speeds: coordinates().map(|(i, c)| name(Input::Speed(i), format!("{}_dot", c.name))).collect(),
            accelerations: coordinates()
                .map(|(i, c)| name(Input::Acceleration(i), format!("{}_ddot", c.name)))
                .collect(),
            multipliers: model
                .constraints
                .iter()
                .enumerate()
                .map(|(i, c)| name(Input::Multiplier(i), format!("lambda_{}", c.name)))
                .collect(),
        };
        (entries, by_input)
    }
}

/// Names for values of the model: those of the user's `let`s, and those of the method.
fn labels(equations: &EquationsOfMotion) -> Vec<(Expr, String)> {
    let model = &equations.model;
    let mut labels: Vec<(Expr, String)> = model.named.iter().map(|(name, expr)| (*expr, name.clone())).collect();
    let coordinate = |i: usize| &model.coordinates[i].name;
    for (i, row) in equations.tmt.mass_matrix.iter().enumerate() {
        labels.extend(
            row[..=i].iter().enumerate().map(|(j, expr)| (*expr, format!("mass_{}_{}", coordinate(i), coordinate(j)))),
        );
    }
    for (row, constraint) in equations.constraints.jacobian.iter().zip(&model.constraints) {
        labels.extend(
            row.iter().enumerate().map(|(j, expr)| (*expr, format!("{}_by_{}", constraint.name, coordinate(j)))),
        );
    }
    labels
}

/// What a kernel returns, as values.
enum Plan {
    Scalar(Value),
    Vector(Vec<Value>),
    Matrix(Vec<Vec<Value>>),
    Linearization(Vec<Value>, Vec<Vec<Value>>, Vec<Value>),
    Initial(Vec<Value>, Vec<Value>),
    Dynamics { accelerations: Vec<Value>, multipliers: Vec<Value>, power: Value, pivots: Option<Vec<(Value, Value)>> },
}

impl Plan {
    fn roots(&self) -> Vec<Value> {
        match self {
            Plan::Scalar(value) => vec![*value],
            Plan::Vector(values) => values.clone(),
            Plan::Matrix(rows) => rows.concat(),
            Plan::Linearization(values, rows, rates) => [values.clone(), rows.concat(), rates.clone()].concat(),
            Plan::Initial(positions, speeds) => [positions.clone(), speeds.clone()].concat(),
            Plan::Dynamics { accelerations, multipliers, power, pivots } => {
                let checks = pivots.iter().flatten().flat_map(|(pivot, terms)| [*pivot, *terms]);
                accelerations.iter().chain(multipliers).chain([power]).copied().chain(checks).collect()
            }
        }
    }

    fn results(&self, schedule: &Schedule) -> Results {
        let trees = |values: &[Value]| values.iter().map(|value| schedule.tree(*value)).collect();
        let rows = |rows: &[Vec<Value>]| rows.iter().map(|row| trees(row)).collect();
        match self {
            Plan::Scalar(value) => Results::Scalar(schedule.tree(*value)),
            Plan::Vector(values) => Results::Vector(trees(values)),
            Plan::Matrix(matrix) => Results::Matrix(rows(matrix)),
            Plan::Linearization(values, matrix, rates) => {
                Results::Linearization(trees(values), rows(matrix), trees(rates))
            }
            Plan::Initial(positions, speeds) => Results::Initial(trees(positions), trees(speeds)),
            Plan::Dynamics { accelerations, multipliers, power, pivots } => Results::Dynamics {
                accelerations: trees(accelerations),
                multipliers: trees(multipliers),
                power: schedule.tree(*power),
                pivots: pivots.as_ref().map(|pivots| {
                    pivots.iter().map(|(pivot, terms)| (schedule.tree(*pivot), schedule.tree(*terms))).collect()
                }),
            },
        }
    }
}
