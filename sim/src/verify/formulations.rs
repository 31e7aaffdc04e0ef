//! Kernels against other formulations of the same declaration: Lagrange's equations, the oracle, and the balance of
//! the bodies.

use super::{Check, VerifyError};
use crate::any::{Any, AnyMechanism, At};
use crate::trajectory::Sample;
use codegen::dsl::{self, Declaration};
use codegen::dynamics::{Lagrange, lagrange};
use codegen::model::{self, Model, Unit};
use codegen::oracle::{Measured, Oracle, Solution, State, Terms};
use codegen::symbolic::{Expr, evaluate};
use nalgebra::{DMatrix, DVector};
use sim_kernel::{Description, Input, Mechanism};

/// A declaration, read again, with Lagrange's equations of it.
pub struct Declared {
    declaration: Declaration,
    model: Model,
    lagrange: Lagrange,
}

impl Declared {
    /// That of a mechanism.
    ///
    /// # Errors
    /// If it cannot be read, which would be a mistake of the mechanism's description.
    pub fn of<M: Mechanism>() -> Result<Declared, VerifyError> {
        Declared::read(const { &M::DESCRIPTION })
    }

    fn read(description: &Description) -> Result<Declared, VerifyError> {
        let fail = |e: &dyn std::fmt::Display| VerifyError::Declaration(e.to_string());
        let tokens = description.declaration.parse().map_err(|_| fail(&"its text is no list of tokens"))?;
        let declaration = dsl::parse(tokens).map_err(|e| fail(&e))?;
        let mut model = model::resolve(&declaration).map_err(|e| fail(&e))?;
        let lagrange = lagrange(&mut model);
        Ok(Declared { declaration, model, lagrange })
    }

    /// The oracle, with the constraints that the mechanism holds.
    fn oracle(&self, mechanism: &dyn AnyMechanism) -> Oracle<'_> {
        let active = mechanism.activities().iter().map(|activity| *activity != 0.0).collect();
        Oracle::new(&self.declaration, &si_factor).with_active(active)
    }
}

fn si_factor(unit: &dsl::Unit) -> f64 {
    Unit::resolve(unit).map_or(f64::NAN, |unit| unit.factor())
}

/// Rounding amplified by the equations themselves; see `tests/kernels/lagrange.rs`.
const CONDITIONED: f64 = 1000.0;

/// q'' of the generated kernels, by TMT, against q'' of Lagrange's equations, in units of eps cond(K) |q''|.
pub fn lagrange_against_kernels<M: Mechanism>(mechanism: &M, declared: &Declared, samples: &[Sample<M>]) -> Check {
    compare_with_lagrange(&Any(mechanism), declared, &places(samples))
}

/// Samples of a mechanism of any type.
pub(super) fn places<M: Mechanism>(samples: &[Sample<M>]) -> Vec<At<'_, f64>> {
    samples.iter().map(At::sample).collect()
}

pub(super) fn compare_with_lagrange(mechanism: &dyn AnyMechanism, declared: &Declared, samples: &[At<f64>]) -> Check {
    let mut found = Vec::new();
    for sample in samples {
        let Ok(solved) = mechanism.accelerate(*sample) else {
            continue;
        };
        let (apart, size) = lagrange_difference(mechanism, declared, sample, solved.as_slice());
        found.push((apart, size, sample.time));
    }
    // Where accelerations pass through zero their rounding is that of where they do not.
    let largest = found.iter().map(|(_, size, _)| *size).fold(f64::MIN_POSITIVE, f64::max);
    let mut worst = (0.0, 0.0);
    for (apart, _, time) in found {
        let relative = apart / largest;
        if !(relative <= worst.0) {
            worst = (relative, time);
        }
    }
    let meaning = format!("largest difference of q'' in eps cond |q''|, at t = {:.4} s", worst.1);
    Check { name: "TMT against Lagrange", figure: worst.0, bound: CONDITIONED, meaning }
}

/// How far apart both are, in units of eps cond(K), and the size of the solution.
fn lagrange_difference(
    mechanism: &dyn AnyMechanism,
    declared: &Declared,
    state: &At<f64>,
    accelerations: &[f64],
) -> (f64, f64) {
    let (n, m) = (state.positions.len(), state.multipliers.len());
    let parameters = mechanism.parameters();
    let model = &declared.model;
    let inputs = mechanism.inputs();
    let given = |symbol| {
        let of_parameter = || model.parameters.iter().position(|p| p.symbol == symbol).map(|i| parameters[i]);
        let of_time = || (symbol == model.time).then_some(state.time);
        of_parameter().or_else(of_time).unwrap_or(f64::NAN)
    };
    let course = |i: usize| evaluate(&model.graph, &[model.inputs[i].course], given)[0];
    let values = |exprs: &[Expr]| {
        evaluate(&model.graph, exprs, |symbol| {
            let of_coordinate = model.coordinates.iter().enumerate().find_map(|(i, c)| match symbol {
                _ if symbol == c.position => Some(state.positions[i]),
                _ if symbol == c.speed => Some(state.speeds[i]),
                _ => None,
            });
            let of_input =
                || model.inputs.iter().position(|input| input.symbol == symbol).map(|i| inputs[i].or(course(i)));
            of_coordinate.or_else(of_input).unwrap_or_else(|| given(symbol))
        })
    };
    let (mass, force) = (values(&declared.lagrange.mass_matrix.concat()), values(&declared.lagrange.right_hand_side));
    let jacobian = mechanism.constraint_jacobian(state.time, state.positions);
    let convective = mechanism.constraint_convective(state.time, state.positions, state.speeds);
    let mut matrix = DMatrix::from_fn(n + m, n + m, |i, j| match (i < n, j < n) {
        (true, true) => mass[i * n + j],
        (true, false) => jacobian[(j - n, i)],
        (false, true) => jacobian[(i - n, j)],
        (false, false) => 0.0,
    });
    let mut rhs = DVector::from_fn(n + m, |i, _| if i < n { force[i] } else { -convective[i - n] });
    if matrix.iter().chain(rhs.iter()).any(|entry| !entry.is_finite()) {
        return (f64::NAN, f64::NAN);
    }
    // Units apart, the condition says what the equations themselves amplify.
    let scale: Vec<f64> = matrix.row_iter().map(|row| row.amax().max(f64::MIN_POSITIVE).sqrt().recip()).collect();
    for i in 0..n + m {
        matrix.row_mut(i).scale_mut(scale[i]);
        matrix.column_mut(i).scale_mut(scale[i]);
        rhs[i] *= scale[i];
    }
    let svd = matrix.clone().svd(true, true);
    // Of the reactions of redundant constraints the smallest are taken; accelerations are the same for all.
    let least = 1e-12 * svd.singular_values.max();
    let regular = svd.singular_values.iter().copied().filter(|value| *value > least).fold(f64::INFINITY, f64::min);
    let Ok(solution) = svd.solve(&rhs, least) else { return (f64::NAN, f64::NAN) };
    // Once more for what is left: a decomposition by iteration keeps fewer digits.
    let Ok(correction) = svd.solve(&(&rhs - &matrix * &solution), least) else { return (f64::NAN, f64::NAN) };
    let solution = solution + correction;
    let apart = (0..n).map(|i| (solution[i] - accelerations[i] / scale[i]).powi(2)).sum::<f64>().sqrt();
    (apart / (f64::EPSILON * svd.singular_values.max() / regular), solution.norm())
}

/// What a term may differ by, relative to the magnitudes of what goes into it.
const TERM: f64 = 1e-12;

/// Mass matrix, forces, constraints with their derivatives, kinetic energy, events, power and outputs, against
/// the oracle.
///
/// # Errors
/// If the oracle cannot interpret the declaration.
pub fn kernels_against_oracle<M: Mechanism>(
    mechanism: &M,
    declared: &Declared,
    samples: &[Sample<M>],
) -> Result<Check, VerifyError> {
    compare_with_oracle(&Any(mechanism), declared, &places(samples))
}

pub(super) fn compare_with_oracle(
    mechanism: &dyn AnyMechanism,
    declared: &Declared,
    samples: &[At<f64>],
) -> Result<Check, VerifyError> {
    let mut found = Found { entries: Vec::new() };
    for sample in samples {
        compare_terms(mechanism, declared, sample, &mut found)?;
    }
    let (worst, term) = found.worst();
    let meaning = match term {
        "" => "largest difference relative to the magnitudes of terms".into(),
        term => format!("largest difference relative to the magnitudes of terms: {term}"),
    };
    Ok(Check { name: "kernels against the oracle", figure: worst, bound: TERM, meaning })
}

/// A term this small beside the largest of its name, as a power where nothing moves, may be rounding of what it cancels from.
const VANISHING: f64 = 1e-2;

/// Differences of terms: name, how far apart, and the magnitude that this is relative to.
struct Found {
    entries: Vec<(&'static str, f64, f64)>,
}

impl Found {
    fn compare(&mut self, term: &'static str, values: &[f64], expected: &[Measured]) {
        for (value, expected) in values.iter().zip(expected) {
            if !value.is_finite() && !expected.value.is_finite() {
                continue;
            }
            self.entries.push((term, (value - expected.value).abs(), expected.magnitude));
        }
    }

    /// The largest relative difference, and of which term.
    fn worst(&self) -> (f64, &'static str) {
        let largest = |name: &str| {
            let magnitudes = self.entries.iter().filter(|(term, ..)| *term == name).map(|(_, _, magnitude)| *magnitude);
            magnitudes.fold(f64::MIN_POSITIVE, f64::max)
        };
        let mut sizes: Vec<(&str, f64)> = Vec::new();
        let (mut worst, mut of) = (0.0, "");
        for (term, apart, magnitude) in &self.entries {
            if !sizes.iter().any(|(known, _)| known == term) {
                sizes.push((term, largest(term)));
            }
            let size = sizes.iter().find(|(known, _)| known == term).map_or(0.0, |(_, size)| *size);
            let relative = apart / magnitude.max(VANISHING * size);
            if !(relative <= worst) {
                (worst, of) = (relative, term);
            }
        }
        (worst, of)
    }
}

fn compare_terms(
    mechanism: &dyn AnyMechanism,
    declared: &Declared,
    sample: &At<f64>,
    found: &mut Found,
) -> Result<(), VerifyError> {
    let (t, q, qd) = (sample.time, sample.positions, sample.speeds);
    let (oracle, parameters, inputs) = (declared.oracle(mechanism), mechanism.parameters(), held(mechanism));
    let at = State { time: t, parameters: &parameters, inputs: &inputs, coordinates: q, speeds: qd };
    let terms = oracle.terms(&at).map_err(uninterpreted)?;
    // Entries of matrices here are by columns.
    let by_rows = |matrix: DMatrix<f64>| matrix.transpose().as_slice().to_vec();
    found.compare("mass matrix", &by_rows(mechanism.mass_matrix(t, q)), &terms.mass_matrix.concat());
    found.compare("convective forces", mechanism.convective_forces(t, q, qd).as_slice(), &terms.convective);
    found.compare("generalised forces", mechanism.generalized_forces(t, q, qd).as_slice(), &terms.applied_forces);
    found.compare("constraints", mechanism.constraints(t, q).as_slice(), &terms.constraints);
    let jacobian = mechanism.constraint_jacobian(t, q);
    found.compare("constraint Jacobian", &by_rows(jacobian), &terms.constraint_jacobian.concat());
    found.compare("C_t", mechanism.constraint_time_derivative(t, q).as_slice(), &terms.constraint_time_derivative);
    found.compare(
        "convective terms of constraints",
        mechanism.constraint_convective(t, q, qd).as_slice(),
        &terms.constraint_convective,
    );
    found.compare("kinetic energy", &[mechanism.kinetic_energy(t, q, qd)], &[terms.kinetic_energy]);
    let solution = solution_of(sample);
    let events = oracle.events(&at, &solution).map_err(uninterpreted)?;
    found.compare("events", &mechanism.events(*sample), &events);
    let event_values = oracle.event_values(&at).map_err(uninterpreted)?;
    found.compare("what events set", &mechanism.event_values(*sample), &event_values);
    let outputs = oracle.outputs(&at, &solution).map_err(uninterpreted)?;
    found.compare("outputs", &mechanism.outputs(*sample), &outputs);
    let power = oracle.power(&at, &solution).map_err(uninterpreted)?;
    found.compare("power", &[mechanism.power(*sample)], &[power]);
    Ok(())
}

/// What each input of a mechanism is set to.
fn held(mechanism: &dyn AnyMechanism) -> Vec<Option<f64>> {
    mechanism.inputs().into_iter().map(Input::held).collect()
}

fn uninterpreted(error: codegen::oracle::OracleError) -> VerifyError {
    VerifyError::Declaration(error.to_string())
}

/// A sample's accelerations and multipliers for the oracle.
fn solution_of(sample: &At<f64>) -> Solution {
    let given = |values: &[f64]| values.iter().map(|value| Measured::given(*value)).collect();
    Solution { accelerations: given(sample.accelerations), multipliers: given(sample.multipliers) }
}

/// What the balance of a body may miss, relative to the magnitudes of what acts on it: the elimination works
/// in a planned order, which amplifies rounding where masses are small beside reactions.
const BALANCE: f64 = 1e-9;

/// Newton and Euler: the masses of all bodies times their accelerations, the loads and the reactions lambda of the run, along
/// each coordinate, from the oracle's positions of bodies, loads and constraints.
///
/// # Errors
/// If the oracle cannot interpret the declaration.
pub fn reactions_against_balance<M: Mechanism>(
    mechanism: &M,
    declared: &Declared,
    samples: &[Sample<M>],
) -> Result<Check, VerifyError> {
    check_balance(&Any(mechanism), declared, &places(samples))
}

pub(super) fn check_balance(
    mechanism: &dyn AnyMechanism,
    declared: &Declared,
    samples: &[At<f64>],
) -> Result<Check, VerifyError> {
    let (parameters, inputs) = (mechanism.parameters(), held(mechanism));
    let oracle = declared.oracle(mechanism);
    let mut worst = (0.0, "");
    for sample in samples {
        let (coordinates, speeds) = (sample.positions, sample.speeds);
        let at = State { time: sample.time, parameters: &parameters, inputs: &inputs, coordinates, speeds };
        let solved = mechanism.accelerate(*sample)?;
        let (accelerations, multipliers) = solved.as_slice().split_at(coordinates.len());
        let terms = oracle.terms(&at).map_err(uninterpreted)?;
        for j in 0..coordinates.len() {
            let (missing, size) = balance(&terms, accelerations, multipliers, j);
            let apart = missing.abs() / size.max(f64::MIN_POSITIVE);
            if !(apart <= worst.0) {
                worst = (apart, mechanism.description().coordinates[j].position.name);
            }
        }
    }
    let meaning = format!("what bodies, loads and reactions miss, relative to them, along `{}`", worst.1);
    Ok(Check { name: "reactions against Newton-Euler", figure: worst.0, bound: BALANCE, meaning })
}

/// M q'' + g - Q + C_q' lambda along coordinate j, and the magnitudes in it.
fn balance(terms: &Terms, accelerations: &[f64], multipliers: &[f64], j: usize) -> (f64, f64) {
    let inertia =
        terms.mass_matrix[j].iter().zip(accelerations).map(|(entry, a)| (entry.value * a, entry.magnitude * a.abs()));
    let reactions = terms
        .constraint_jacobian
        .iter()
        .zip(multipliers)
        .map(|(row, l)| (row[j].value * l, row[j].magnitude * l.abs()));
    let force = &terms.generalized_forces[j];
    inertia
        .chain(reactions)
        .chain([(-force.value, force.magnitude)])
        .fold((0.0, 0.0), |(sum, size), (value, magnitude)| (sum + value, size + magnitude))
}
