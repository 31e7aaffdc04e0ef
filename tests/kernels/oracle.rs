//! Every kernel of every mechanism against the oracle, which interprets the declaration with jets and shares no
//! code with the engine, at random states and parameters, half of them on the constraints.

use crate::mechanisms::all_mechanisms;
use codegen::dsl::{self, Declaration};
use codegen::model::Unit;
use codegen::oracle::{Measured, Oracle, Solution, State};
use sim::{Array, Input, Measures, Mechanism, accelerate, project_positions, project_velocities};
use tests::Random;

const STATES: usize = 1000;

/// Its redundant constraints leave every elimination without a pivot, and off them its equations without a solution.
pub(crate) const OVERCONSTRAINED: &str = "bennett";
/// Its legs do not reach most random places.
const FAR: &str = "stewart";

/// Rounding of a term relative to the sum of the magnitudes of what goes into it.
const TERM_TOLERANCE: f64 = 1e-13;

#[test]
fn every_kernel_of_every_mechanism_agrees() {
    macro_rules! check_all {
        ($($model:ty),*) => { $(check::<$model>();)* };
    }
    all_mechanisms!(check_all);
}

fn check<M: Mechanism>() {
    let name = M::DESCRIPTION.name;
    let declaration = dsl::parse(M::DESCRIPTION.declaration.parse().unwrap()).unwrap();
    let mut random = Random(11);
    let (mut worst, mut residual, mut on_constraints, mut solved, mut refused) = (0.0f64, 0.0f64, 0, 0, 0);
    for i in 0..STATES {
        let parameters = M::defaults().parameters();
        let mechanism =
            M::defaults().with_parameters(M::Parameters::from_fn(|i| parameters[i] * random.between(0.8, 1.2)));
        let mechanism = match M::Activities::LEN {
            0 => mechanism,
            _ => mechanism.with_activities(M::Activities::from_fn(|_| random.between(0.0, 2.0).floor())),
        };
        // Every third state follows the declared courses of the inputs.
        let held = |random: &mut Random| Input::Held(random.between(-2.0, 2.0));
        let inputs = M::Inputs::from_fn(|_| if i % 3 == 0 { Input::Declared } else { held(&mut random) });
        let mechanism = mechanism.with_inputs(inputs);
        let t = random.between(0.0, 2.0);
        let mut q = M::Q::from_fn(|_| random.between(-1.5, 1.5));
        let mut qd = M::Q::from_fn(|_| random.between(-3.0, 3.0));
        if i % 2 == 0 && put_on_constraints(&mechanism, t, &mut q, &mut qd) {
            on_constraints += 1;
        }
        refused += usize::from(mechanism.dynamics(t, &q, &qd).refused);
        let found = compare(&mechanism, &declaration, t, &q, &qd);
        assert!(found.worst <= TERM_TOLERANCE, "{name}: {} is off by {:e}", found.term, found.worst);
        worst = worst.max(found.worst);
        if let Some(found) = found.residual {
            residual = residual.max(found);
            solved += 1;
        }
    }
    println!(
        "{name:<20} terms {worst:.1e} of their magnitudes, residual {residual:.1} eps n (|K||z| + |r|), {on_constraints} states on the constraints"
    );
    assert!(M::L::LEN == 0 || on_constraints > STATES / 4 || name == FAR, "{name}: {on_constraints}");
    if name == OVERCONSTRAINED {
        return;
    }
    assert!(solved > STATES * 9 / 10, "{name}: {solved}");
    assert!(refused < STATES / 10, "{name}: the planned elimination refuses {refused} states");
    // Elimination in a planned order: 1e-14 n, that is 45 eps n. Complete pivoting would give 1; what the order costs
    // shows where masses are small beside the constraints, as in Andrews' mechanism.
    assert!(residual <= 45.0, "{name}: {residual}");
}

/// Moves a state onto the constraints, from anywhere near enough. Gives whether that could be done.
fn put_on_constraints<M: Mechanism>(mechanism: &M, t: f64, q: &mut M::Q, qd: &mut M::Q) -> bool {
    let mut nearer = *q;
    let measures = Measures::at(mechanism, t, q);
    // Projection gives up after ten corrections; from a random state a few more may be needed.
    let projected = (0..5).find_map(|_| project_positions(mechanism, &measures, t, &mut nearer).ok());
    let Some(linear) = projected else { return false };
    *q = nearer;
    project_velocities(&measures, &linear, t, q, qd).is_ok()
}

/// In space kernels take components in the frames of bodies, where what is zero in the world is a difference of what is not:
/// there rounding of an entry is relative to this part of the largest entry at least.
const PART_IN_SPACE: f64 = 0.01;

struct Found {
    /// Components of vectors.
    dimension: usize,
    /// The largest difference, relative to its magnitude.
    worst: f64,
    /// Where.
    term: &'static str,
    /// The residual of the solved equations in eps n (|K||z| + |r|); none where they have no solution.
    residual: Option<f64>,
}

impl Found {
    fn term(&mut self, term: &'static str, values: &[f64], expected: &[Measured]) {
        assert_eq!(values.len(), expected.len(), "{term}");
        let largest = expected.iter().map(|entry| entry.magnitude).filter(|x| x.is_finite()).fold(0.0, f64::max);
        let least = if self.dimension == 3 { PART_IN_SPACE * largest } else { 0.0 };
        for (value, expected) in values.iter().zip(expected) {
            let both_undefined = !value.is_finite() && !expected.value.is_finite();
            if both_undefined {
                continue;
            }
            let difference = (value - expected.value).abs() / expected.magnitude.max(least).max(f64::MIN_POSITIVE);
            assert!(difference.is_finite(), "{term}: {value} instead of {}", expected.value);
            if difference > self.worst {
                (self.worst, self.term) = (difference, term);
            }
        }
    }
}

fn compare<M: Mechanism>(mechanism: &M, declaration: &Declaration, t: f64, q: &M::Q, qd: &M::Q) -> Found {
    let si_factor = |unit: &dsl::Unit| Unit::resolve(unit).unwrap().factor();
    let active = mechanism.activities().iter().map(|activity| *activity != 0.0).collect();
    let oracle = Oracle::new(declaration, &si_factor).with_active(active);
    let parameters = mechanism.parameters();
    let inputs: Vec<Option<f64>> = mechanism.inputs().iter().map(|input| input.held()).collect();
    let (parameters, coordinates, speeds) = (parameters.as_ref(), q.as_ref(), qd.as_ref());
    let at = State { time: t, parameters, inputs: &inputs, coordinates, speeds };
    let terms = oracle.terms(&at).unwrap();
    let mut found = Found { dimension: M::DESCRIPTION.dimension, worst: 0.0, term: "", residual: None };
    let matrix = |rows: Vec<Vec<f64>>| rows.concat();
    let mass = matrix(mechanism.mass_matrix(t, q).iter().map(|row| row.as_ref().to_vec()).collect());
    let jacobian = matrix(mechanism.constraint_jacobian(t, q).iter().map(|row| row.as_ref().to_vec()).collect());
    found.term("mass matrix", &mass, &terms.mass_matrix.concat());
    found.term("convective forces", mechanism.convective_forces(t, q, qd).as_ref(), &terms.convective);
    found.term("generalised forces", mechanism.generalized_forces(t, q, qd).as_ref(), &terms.applied_forces);
    found.term("constraints", mechanism.constraints(t, q).as_ref(), &terms.constraints);
    found.term("constraint Jacobian", &jacobian, &terms.constraint_jacobian.concat());
    found.term("C_t", mechanism.constraint_time_derivative(t, q).as_ref(), &terms.constraint_time_derivative);
    found.term(
        "constraint convective",
        mechanism.constraint_convective(t, q, qd).as_ref(),
        &terms.constraint_convective,
    );
    found.term("kinetic energy", &[mechanism.kinetic_energy(t, q, qd)], &[terms.kinetic_energy]);
    let linear = mechanism.constraint_linearization(t, q);
    let linear_jacobian = matrix(linear.jacobian.iter().map(|row| row.as_ref().to_vec()).collect());
    found.term("linearised C", linear.values.as_ref(), &terms.constraints);
    found.term("linearised C_q", &linear_jacobian, &terms.constraint_jacobian.concat());
    found.term("linearised C_t", linear.time_derivative.as_ref(), &terms.constraint_time_derivative);
    let Ok(solved) = accelerate(mechanism, t, q, qd) else { return found };
    let given = |values: &[f64]| values.iter().map(|value| Measured::given(*value)).collect::<Vec<_>>();
    let solution = Solution {
        accelerations: given(solved.accelerations.as_ref()),
        multipliers: given(solved.multipliers.as_ref()),
    };
    let events = mechanism.events(t, q, qd, &solved.accelerations, &solved.multipliers);
    found.term("events", events.as_ref(), &oracle.events(&at, &solution).unwrap());
    found.term("what events set", mechanism.event_values(t, q, qd).as_ref(), &oracle.event_values(&at).unwrap());
    for (row, lambda) in solved.multipliers.iter().enumerate() {
        assert!(sim::is_active(mechanism, row) || *lambda == 0.0, "a released row has the multiplier {lambda}");
    }
    let outputs = mechanism.outputs(t, q, qd, &solved.accelerations, &solved.multipliers);
    found.term("outputs", outputs.as_ref(), &oracle.outputs(&at, &solution).unwrap());
    found.term("power", &[solved.power], &[oracle.power(&at, &solution).unwrap()]);
    found.residual = Some(residual(&terms, solved.accelerations.as_ref(), solved.multipliers.as_ref()));
    let power = mechanism.power(t, q, qd, &solved.accelerations, &solved.multipliers);
    found.term("power alone", &[power], &[oracle.power(&at, &solution).unwrap()]);
    found
}

/// |K z - r| of the oracle's equations at the kernel's solution in eps n (|K||z| + |r|), in the largest norm; |r| is the sum
/// of the magnitudes of its terms, as both sides compute it with their own rounding.
fn residual(terms: &codegen::oracle::Terms, accelerations: &[f64], multipliers: &[f64]) -> f64 {
    let n = accelerations.len();
    let z = [accelerations, multipliers].concat();
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0f64, |largest, x| largest.max(x.abs()));
    let (mut residual, mut matrix_norm, mut rhs_norm) = (0.0f64, 0.0f64, 0.0f64);
    for i in 0..z.len() {
        let row: Vec<f64> = match i < n {
            true => {
                let mass = terms.mass_matrix[i].iter().map(|entry| entry.value);
                mass.chain(terms.constraint_jacobian.iter().map(|row| row[i].value)).collect()
            }
            false => terms.constraint_jacobian[i - n].iter().map(|entry| entry.value).collect(),
        };
        let (sign, rhs) =
            if i < n { (1.0, terms.generalized_forces[i]) } else { (-1.0, terms.constraint_convective[i - n]) };
        let sum: f64 = row.iter().zip(&z).map(|(k, z)| k * z).sum();
        residual = residual.max((sum - sign * rhs.value).abs());
        matrix_norm = matrix_norm.max(row.iter().map(|k| k.abs()).sum());
        rhs_norm = rhs_norm.max(rhs.magnitude);
    }
    let size = matrix_norm * largest(&mut z.iter().copied()) + rhs_norm;
    residual / (f64::EPSILON * z.len() as f64 * size)
}
