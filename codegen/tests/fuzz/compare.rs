//! Kernels of random declarations against the oracle.

use crate::build::{Case, State, run};
use crate::derivatives::{self, Derivatives};
use crate::random::Random;
use crate::{plane, space};
use codegen::dsl;
use codegen::model::Unit;
use codegen::oracle::{self, Comparison, Computed, Measured, Observed, Oracle, Solution, residual};

/// Declarations in the plane and in space, of which a debug build takes a part, and states of each.
const PLANE: usize = if cfg!(debug_assertions) { 4 } else { 12 };
const SPACE: usize = if cfg!(debug_assertions) { 2 } else { 6 };
const STATES: usize = 4;
/// Declarations that are compiled as one crate: more of them take the compiler more memory than a machine may have.
const TOGETHER: usize = 144;
/// Rounding of a term, relative to the sum of the magnitudes of what goes into it, as for the shipped mechanisms.
const TOLERANCE: f64 = 1e-13;
/// In space that is this part of the largest term's at least, as for the shipped mechanisms: what is zero in the world is
/// a difference in the frame of a body.
const PART_IN_SPACE: f64 = 0.01;
/// The residual of the solved equations in eps n (|K||z| + |r|): ten times what the shipped mechanisms may have.
const RESIDUAL: f64 = 450.0;

#[test]
fn kernels_are_what_random_declarations_say() {
    let first = if crate::scale() > 1 { 1000 } else { 0 };
    let seeds = |count: usize| first..first + count * crate::scale();
    let plane = seeds(PLANE).map(|seed| case(&format!("Fuzz{seed}"), seed, plane::declaration));
    let space = seeds(SPACE).map(|seed| case(&format!("Space{seed}"), seed, space::declaration));
    let cases: Vec<Case> = plane.chain(space).flatten().collect();
    let drawn = (PLANE + SPACE) * crate::scale();
    assert!(cases.len() * 50 >= drawn * 49, "{} of {drawn} random declarations say nothing idle", cases.len());
    let mut found = cases.chunks(TOGETHER).flat_map(run);
    let (mut worst, mut solved, mut all) = (0.0f64, 0, 0);
    let mut derived = Derivatives::default();
    for case in &cases {
        let parsed = codegen::parse(case.declaration.parse().unwrap()).unwrap();
        for state in &case.states {
            let values = found.next().unwrap();
            let (difference, term, is_solved) = compare(case.dimension, &parsed, state, &values);
            worst = worst.max(difference);
            solved += usize::from(is_solved);
            all += 1;
            if is_solved {
                let oracle = Oracle::new(&parsed, &si_factor);
                derivatives::compare(&oracle, state, &values, &case.declaration, &mut derived);
            }
            let State { time, coordinates, speeds, .. } = state;
            assert!(
                difference < TOLERANCE,
                "{term} is off by {difference:e} at t = {time}, q = {coordinates:?}, q' = {speeds:?} in\n{}",
                case.declaration
            );
        }
    }
    println!("{} declarations, {all} states, {solved} solved: {worst:.1e} of the magnitudes of terms", cases.len());
    println!("{derived:?}");
    assert!(solved * 10 > all * 9, "{solved} of {all} are solved");
    // Where a difference quotient spans a kink, or the equations are nearly singular, two of them differ.
    assert!(derived.compared > 5 * derived.undecided, "{derived:?}");
}

/// What refuses a load or an event that random expressions have made one of nothing.
const IDLE: [&str; 2] = ["so the load does nothing; leave it out", "never changes; make it depend on"];

/// None where something in the declaration happens to have no effect, which is a mistake.
fn case(name: &str, seed: usize, declaration: impl Fn(&str, usize) -> String) -> Option<Case> {
    let declaration = declaration(name, seed);
    let model = match codegen::equations(declaration.parse().unwrap()) {
        Ok(equations) => equations.model,
        Err(mistakes) => {
            let mistakes = codegen::mistakes::located(name, mistakes);
            let is_idle = mistakes.lines().all(|line| IDLE.iter().any(|idle| line.contains(idle)));
            assert!(is_idle, "{mistakes}\nin\n{declaration}");
            return None;
        }
    };
    let mut random = Random::new(seed + 77);
    let parsed = codegen::parse(declaration.parse().unwrap()).unwrap();
    let defaults = Oracle::new(&parsed, &si_factor).default_parameters().unwrap();
    let count = model.coordinates.len();
    let states = (0..STATES)
        .map(|_| State {
            time: random.between(0.0, 2.0),
            parameters: defaults.iter().map(|default| default * random.between(0.8, 1.2)).collect(),
            coordinates: (0..count).map(|_| random.between(-1.5, 1.5)).collect(),
            speeds: (0..count).map(|_| random.between(-2.0, 2.0)).collect(),
            accelerations: (0..count).map(|_| random.between(-9.0, 9.0)).collect(),
        })
        .collect();
    Some(Case { name: name.into(), declaration, dimension: model.dimension, states })
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
) -> (f64, &'static str, bool) {
    let oracle = Oracle::new(declaration, &si_factor);
    let State { time, parameters, coordinates, speeds, accelerations } = state;
    let at = oracle::State { time: *time, parameters, coordinates, speeds, inputs: &[None] };
    let values = |name: &str| found.iter().find(|(known, _)| known == name).unwrap().1.clone();
    let mut comparison = Comparison::new(if dimension == 3 { PART_IN_SPACE } else { 0.0 });
    let computed = Computed {
        mass_matrix: values("mass_matrix"),
        convective_forces: values("convective"),
        generalized_forces: values("forces"),
        constraints: values("constraints"),
        constraint_jacobian: values("jacobian"),
        constraint_time_derivative: values("time_derivative"),
        constraint_convective: values("constraint_convective"),
        kinetic_energy: values("energy")[0],
        event_values: values("event_values"),
    };
    let terms = comparison.enter(&computed, &oracle, &at).unwrap();
    comparison.term("inverse dynamics", &values("inverse"), &inverse(&terms, accelerations));
    if values("refused")[0] != 0.0 {
        let (worst, term) = comparison.worst();
        return (worst, term, false);
    }
    let given = |name: &str| values(name).iter().map(|value| Measured::given(*value)).collect::<Vec<_>>();
    let solution = Solution { accelerations: given("accelerations"), multipliers: given("multipliers") };
    let observed = Observed { events: values("events"), outputs: values("outputs"), power: values("power")[0] };
    comparison.enter_solved(&observed, &oracle, &at, &solution).unwrap();
    let residual = residual(&terms, &values("accelerations"), &values("multipliers"));
    assert!(residual < RESIDUAL, "residual {residual:e}");
    let (worst, term) = comparison.worst();
    (worst, term, true)
}

/// M q'' + h - Q.
fn inverse(terms: &oracle::Terms, accelerations: &[f64]) -> Vec<Measured> {
    let inertial =
        |row: &Vec<Measured>| row.iter().zip(accelerations).map(|(m, a)| *m * Measured::given(*a)).sum::<Measured>();
    let rows = terms.mass_matrix.iter().zip(&terms.generalized_forces);
    rows.map(|(row, force)| inertial(row) - *force).collect::<Vec<Measured>>()
}
