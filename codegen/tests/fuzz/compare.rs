//! Kernels of random declarations against the oracle.

use crate::build::{Case, State, run};
use crate::random::Random;
use crate::{plane, space};
use codegen::dsl;
use codegen::model::Unit;
use codegen::oracle::{self, Measured, Oracle, Solution};

/// Declarations in the plane and in space, and states of each.
const PLANE: usize = 24;
const SPACE: usize = 12;
const STATES: usize = 4;
/// Rounding of a term, relative to the sum of the magnitudes of what goes into it, as for the shipped mechanisms.
const TOLERANCE: f64 = 1e-13;
/// In space that is this part of the largest term's at least, as for the shipped mechanisms: what is zero in the world is
/// a difference in the frame of a body.
const PART_IN_SPACE: f64 = 0.01;
/// The residual of the solved equations in units of |K||z| + |r|, as for the shipped mechanisms: 450 eps n.
const RESIDUAL: f64 = 450.0 * f64::EPSILON;

#[test]
fn kernels_are_what_random_declarations_say() {
    let first = if crate::scale() > 1 { 1000 } else { 0 };
    let seeds = |count: usize| first..first + count * crate::scale();
    let plane = seeds(PLANE).map(|seed| case(&format!("Fuzz{seed}"), seed, plane::declaration));
    let space = seeds(SPACE).map(|seed| case(&format!("Space{seed}"), seed, space::declaration));
    let cases: Vec<Case> = plane.chain(space).collect();
    let mut found = run(&cases).into_iter();
    let (mut worst, mut solved, mut all) = (0.0f64, 0, 0);
    for case in &cases {
        let parsed = dsl::parse(case.declaration.parse().unwrap()).unwrap();
        for state in &case.states {
            let values = found.next().unwrap();
            let (difference, term, is_solved) = compare(case.dimension, &parsed, state, &values);
            worst = worst.max(difference);
            solved += usize::from(is_solved);
            all += 1;
            let State { time, coordinates, speeds, .. } = state;
            assert!(
                difference < TOLERANCE,
                "{term} is off by {difference:e} at t = {time}, q = {coordinates:?}, q' = {speeds:?} in\n{}",
                case.declaration
            );
        }
    }
    println!("{} declarations, {all} states, {solved} solved: {worst:.1e} of the magnitudes of terms", cases.len());
    assert!(solved * 10 > all * 9, "{solved} of {all} are solved");
}

fn case(name: &str, seed: usize, declaration: impl Fn(&str, usize) -> String) -> Case {
    let declaration = declaration(name, seed);
    let model = codegen::equations(declaration.parse().unwrap())
        .unwrap_or_else(|mistakes| panic!("{}\nin\n{declaration}", codegen::mistakes::located(name, mistakes)))
        .model;
    let mut random = Random::new(seed + 77);
    let parsed = dsl::parse(declaration.parse().unwrap()).unwrap();
    let defaults = Oracle::new(&parsed, &si_factor).default_parameters().unwrap();
    let count = model.coordinates.len();
    let states = (0..STATES)
        .map(|_| State {
            time: random.between(0.0, 2.0),
            parameters: defaults.iter().map(|default| default * random.between(0.8, 1.2)).collect(),
            coordinates: (0..count).map(|_| random.between(-1.5, 1.5)).collect(),
            speeds: (0..count).map(|_| random.between(-2.0, 2.0)).collect(),
        })
        .collect();
    Case { name: name.into(), declaration, dimension: model.dimension, states }
}

fn si_factor(unit: &dsl::Unit) -> f64 {
    Unit::resolve(unit).map_or(f64::NAN, |unit| unit.factor())
}

/// The largest difference relative to its magnitude, where, and whether the equations were solved.
fn compare(
    dimension: usize,
    declaration: &dsl::Declaration,
    state: &State,
    found: &[(String, Vec<f64>)],
) -> (f64, String, bool) {
    let oracle = Oracle::new(declaration, &si_factor);
    let State { time, parameters, coordinates, speeds } = state;
    let at = oracle::State { time: *time, parameters, coordinates, speeds, inputs: &[None] };
    let terms = oracle.terms(&at).unwrap();
    let values = |name: &str| &found.iter().find(|(known, _)| known == name).unwrap().1;
    let mut worst = (0.0f64, String::new());
    let mut term = |name: &str, expected: &[Measured]| {
        let values = values(name);
        assert_eq!(values.len(), expected.len(), "{name}");
        let largest = expected.iter().map(|entry| entry.magnitude).fold(0.0, f64::max);
        let least = if dimension == 3 { PART_IN_SPACE * largest } else { 0.0 };
        for (value, expected) in values.iter().zip(expected) {
            let difference = (value - expected.value).abs() / expected.magnitude.max(least).max(f64::MIN_POSITIVE);
            let difference = if difference.is_finite() { difference } else { f64::INFINITY };
            if difference > worst.0 {
                worst = (difference, name.to_owned());
            }
        }
    };
    term("mass_matrix", &terms.mass_matrix.concat());
    term("convective", &terms.convective);
    term("forces", &terms.applied_forces);
    term("constraints", &terms.constraints);
    term("jacobian", &terms.constraint_jacobian.concat());
    term("time_derivative", &terms.constraint_time_derivative);
    term("constraint_convective", &terms.constraint_convective);
    term("energy", &[terms.kinetic_energy]);
    term("event_values", &oracle.event_values(&at).unwrap());
    if values("refused")[0] != 0.0 {
        return (worst.0, worst.1, false);
    }
    let given = |name: &str| values(name).iter().map(|value| Measured::given(*value)).collect::<Vec<_>>();
    let solution = Solution { accelerations: given("accelerations"), multipliers: given("multipliers") };
    term("events", &oracle.events(&at, &solution).unwrap());
    term("outputs", &oracle.outputs(&at, &solution).unwrap());
    term("power", &[oracle.power(&at, &solution).unwrap()]);
    let residual = residual(&terms, values("accelerations"), values("multipliers"));
    assert!(residual < RESIDUAL, "residual {residual:e}");
    (worst.0, worst.1, true)
}

/// |K z - r| of the oracle's equations at the kernel's solution in n (|K||z| + |r|), in the largest norm.
fn residual(terms: &oracle::Terms, accelerations: &[f64], multipliers: &[f64]) -> f64 {
    let n = accelerations.len();
    let z = [accelerations, multipliers].concat();
    let jacobian = &terms.constraint_jacobian;
    let (mut residual, mut matrix_norm, mut rhs_norm) = (0.0f64, 0.0f64, 0.0f64);
    for i in 0..z.len() {
        let row: Vec<f64> = match i.checked_sub(n) {
            None => terms.mass_matrix[i].iter().chain(jacobian.iter().map(|row| &row[i])).map(|x| x.value).collect(),
            Some(k) => jacobian[k].iter().map(|entry| entry.value).collect(),
        };
        let rhs = i
            .checked_sub(n)
            .map_or_else(|| terms.generalized_forces[i].value, |k| -terms.constraint_convective[k].value);
        residual = residual.max((row.iter().zip(&z).map(|(k, z)| k * z).sum::<f64>() - rhs).abs());
        matrix_norm = matrix_norm.max(row.iter().map(|k| k.abs()).sum());
        rhs_norm = rhs_norm.max(rhs.abs());
    }
    let largest = z.iter().fold(0.0f64, |largest, z| largest.max(z.abs()));
    residual / (z.len() as f64 * (matrix_norm * largest + rhs_norm))
}
