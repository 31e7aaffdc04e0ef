//! A mechanism from a file against the oracle, which interprets its declaration with jets: at random states every term, the
//! solved equations, and the derivatives of their solution against difference quotients along a random direction.

use codegen::dsl;
use codegen::model::Unit;
use codegen::oracle::{Comparison, Measured, Oracle, Solution, State, Terms, residual};
use sim::verify::{computed, observed};
use sim::{Array, At, Erased, Kernel, List, Model};
use std::sync::Arc;
use tests::Random;

fn vector(values: &[f64]) -> List<f64> {
    List::with_len(values.len(), |i| values[i])
}

/// Rounding of a term relative to the magnitudes of what goes into it.
const TERM: f64 = 1e-12;
/// In space kernels take components in the frames of bodies, where what is zero in the world is a difference of what is not:
/// there rounding of an entry is relative to this part of the largest entry at least.
const PART_IN_SPACE: f64 = 0.01;
/// The elimination refuses a pivot that has lost half of the digits, so that the rest of them are right: K z - r relative to
/// |K||z| + |r|.
const RESIDUAL: f64 = 1e-6;

/// The steps of the difference quotients, which are of fourth order. Two that differ by more than this part of the derivative
/// are undecided, and a derivative is off where it differs by a hundred times that.
const STEPS: [f64; 2] = [2e-3, 1e-3];
const DECIDED: f64 = 1e-7;
const APART: f64 = 1e-5;
/// What rounding of the terms may do to a solution, as a part of its size: divided by a step it is a tenth of what is allowed.
const KNOWN: f64 = 1e-9;

/// How many derivatives have been compared, and of how many the quotients differ.
#[derive(Debug, Default)]
pub(crate) struct Derivatives {
    pub(crate) compared: usize,
    pub(crate) undecided: usize,
    pub(crate) worst: f64,
}

/// Compares a mechanism at so many random states.
pub(crate) fn compare(
    model: &Arc<dyn Model>,
    states: usize,
    random: &mut Random,
    derivatives: &mut Derivatives,
) -> Result<(), String> {
    let fail = |why: &dyn std::fmt::Display| why.to_string();
    let declaration =
        codegen::parse(model.description().declaration.parse().map_err(|e| fail(&e))?).map_err(|e| fail(&e))?;
    let si_factor = |unit: &dsl::Unit| Unit::resolve(unit).map_or(f64::NAN, |unit| unit.factor());
    let oracle = Oracle::new(&declaration, &si_factor);
    let parameters = model.values().parameters;
    let mut defaults = Comparison::new(0.0);
    let declared: Vec<Measured> =
        oracle.default_parameters().map_err(|e| fail(&e))?.into_iter().map(Measured::given).collect();
    defaults.term("parameters", &parameters, &declared);
    within("of the defaults", defaults.worst(), TERM)?;
    let n = model.description().coordinates.len();
    let mut some = |count: usize| (0..count).map(|_| random.between(-1.0, 1.0)).collect::<Vec<f64>>();
    for _ in 0..states {
        let inputs = vec![None; model.description().inputs.len()];
        let place = Place { time: 0.3, parameters: parameters.clone(), inputs, positions: some(n), speeds: some(n) };
        let solution = terms_agree(model, &oracle, &place)?;
        if let Some(solution) = solution {
            let (by_parameters, positions, speeds) = (some(parameters.len()), some(n), some(n));
            let along = Place { time: 0.0, parameters: by_parameters, inputs: Vec::new(), positions, speeds };
            derivatives_agree(&**model, &oracle, (&place, &along), &solution, derivatives)?;
        }
    }
    Ok(())
}

fn within(what: &str, (worst, term): (f64, &str), bound: f64) -> Result<(), String> {
    if worst <= bound { Ok(()) } else { Err(format!("{term} {what} is off by {worst:e}")) }
}

/// A state with parameters, or a direction from it: along parameters relative to their values.
struct Place {
    time: f64,
    parameters: Vec<f64>,
    /// Each follows its declared course.
    inputs: Vec<Option<f64>>,
    positions: Vec<f64>,
    speeds: Vec<f64>,
}

impl Place {
    fn state(&self) -> State<'_> {
        let Place { time, parameters, inputs, positions, speeds } = self;
        State { time: *time, parameters, inputs, coordinates: positions, speeds }
    }

    fn moved(&self, along: &Place, by: f64) -> Place {
        let added = |values: &[f64], along: &[f64]| values.iter().zip(along).map(|(x, v)| x + by * v).collect();
        Place {
            time: self.time,
            inputs: self.inputs.clone(),
            parameters: self.parameters.iter().zip(&along.parameters).map(|(p, v)| p * (1.0 + by * v)).collect(),
            positions: added(&self.positions, &along.positions),
            speeds: added(&self.speeds, &along.speeds),
        }
    }
}

/// Every term, and the solved equations. Gives the solution where there is one.
fn terms_agree(model: &Arc<dyn Model>, oracle: &Oracle, place: &Place) -> Result<Option<Vec<f64>>, String> {
    let description = model.description();
    let at = place.state();
    let mechanism = Erased::of(model.clone());
    let (q, qd) = (vector(&place.positions), vector(&place.speeds));
    let mut comparison = Comparison::new(if description.dimension == 3 { PART_IN_SPACE } else { 0.0 });
    let refused = |why: codegen::oracle::OracleError| why.to_string();
    if !is_in_domain(&oracle.terms(&at).map_err(refused)?) {
        return Ok(None);
    }
    let terms = comparison.enter(&computed(&mechanism, place.time, &q, &qd), oracle, &at).map_err(refused)?;
    let solved = solve(&**model, place).filter(|solved| solved.iter().all(|number| number.is_finite()));
    if let Some(solved) = &solved {
        let (accelerations, multipliers) = solved.split_at(q.len());
        let given = |values: &[f64]| values.iter().map(|value| Measured::given(*value)).collect::<Vec<_>>();
        let solution = Solution { accelerations: given(accelerations), multipliers: given(multipliers) };
        let (qdd, lambda) = (vector(accelerations), vector(multipliers));
        let observed = observed(&mechanism, place.time, &q, &qd, &qdd, &lambda);
        comparison.enter_solved(&observed, oracle, &at, &solution).map_err(refused)?;
        let missing = residual(&terms, accelerations, multipliers) * f64::EPSILON * solved.len() as f64;
        within("of the equations of motion", (missing, "the residual"), RESIDUAL)?;
    }
    within("", comparison.worst(), TERM)?;
    Ok(solved)
}

/// Whether all that the declaration says has a value: not asin(5), say, of which a kernel may need the sine alone.
fn is_in_domain(terms: &Terms) -> bool {
    let matrices = terms.mass_matrix.iter().chain(&terms.constraint_jacobian).flatten();
    let rows = [&terms.applied_forces, &terms.convective, &terms.constraints, &terms.constraint_time_derivative];
    let all = matrices.chain(rows.into_iter().flatten()).chain(&terms.constraint_convective);
    all.chain([&terms.kinetic_energy]).all(|term| term.value.is_finite())
}

/// Accelerations and multipliers, unless a pivot is refused.
fn solve(model: &dyn Model, place: &Place) -> Option<Vec<f64>> {
    let (rows, refused) = rows(model, Kernel::Dynamics, place);
    (!refused).then(|| rows[..2].concat())
}

fn rows(model: &dyn Model, kernel: Kernel, place: &Place) -> (Vec<Vec<f64>>, bool) {
    let Place { time, positions, speeds, .. } = place;
    let at = At { time: *time, positions, speeds, accelerations: &[], multipliers: &[] };
    let mut rows = Vec::new();
    let refused = model.call(kernel, at, &mut |_, row| rows.push(row.to_vec()));
    (rows, refused)
}

/// d(q'', lambda) along a direction: by the kernels, and by quotients of what the oracle solves.
fn derivatives_agree(
    model: &dyn Model,
    oracle: &Oracle,
    (place, along): (&Place, &Place),
    solution: &[f64],
    derivatives: &mut Derivatives,
) -> Result<(), String> {
    let (jacobian, refused) = rows(model, Kernel::DynamicsJacobian, place);
    let (sensitivity, refused_too) = rows(model, Kernel::DynamicsSensitivity, place);
    if refused || refused_too {
        return Err("derivatives are refused where accelerations are not".to_owned());
    }
    let quotients = STEPS.map(|h| quotient(h, &|by| solved_by(oracle, &place.moved(along, by))));
    let [Some(far), Some(near)] = quotients else {
        derivatives.undecided += solution.len();
        return Ok(());
    };
    let n = place.positions.len();
    let m = solution.len() - n;
    let inner = |row: &[f64], along: &[f64]| row.iter().zip(along).map(|(a, b)| a * b).sum::<f64>();
    let by_parameters: Vec<f64> = place.parameters.iter().zip(&along.parameters).map(|(p, v)| p * v).collect();
    let size = near.iter().chain(solution).fold(1.0f64, |size, x| size.max(x.abs()));
    for (i, (far, near)) in far.iter().zip(&near).enumerate() {
        // Rows of accelerations by positions, by speeds; then those of multipliers.
        let [by_positions, by_speeds] = if i < n { [i, n + i] } else { [n + i, n + m + i] };
        let found = inner(&jacobian[by_positions], &along.positions)
            + inner(&jacobian[by_speeds], &along.speeds)
            + inner(&sensitivity[i], &by_parameters);
        let apart = (found - near).abs() / size;
        if !((far - near).abs() <= DECIDED * size) {
            derivatives.undecided += 1;
        } else if apart <= APART {
            derivatives.compared += 1;
            derivatives.worst = derivatives.worst.max(apart);
        } else {
            return Err(format!("derivative {i} of (q'', lambda) is {found}, not {near}"));
        }
    }
    Ok(())
}

/// The oracle's solution, where rounding leaves it enough digits.
fn solved_by(oracle: &Oracle, place: &Place) -> Option<Vec<f64>> {
    let solution = oracle.accelerations(&oracle.terms(&place.state()).ok()?).ok()?;
    let unknowns = || solution.accelerations.iter().chain(&solution.multipliers);
    let size = unknowns().fold(1.0f64, |size, x| size.max(x.value.abs()));
    let is_known = unknowns().all(|x| f64::EPSILON * x.magnitude <= KNOWN * size);
    is_known.then(|| unknowns().map(|x| x.value).collect())
}

/// (8 (f(h) - f(-h)) - (f(2 h) - f(-2 h)))/(12 h).
fn quotient(h: f64, f: &dyn Fn(f64) -> Option<Vec<f64>>) -> Option<Vec<f64>> {
    let [a, b, c, d] = [f(-2.0 * h)?, f(-h)?, f(h)?, f(2.0 * h)?];
    Some((0..a.len()).map(|i| (8.0 * (c[i] - b[i]) - (d[i] - a[i])) / (12.0 * h)).collect())
}
