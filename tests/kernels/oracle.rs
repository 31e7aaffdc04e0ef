//! Every kernel of every mechanism against the oracle, which interprets the declaration with jets, at random states and
//! parameters, half of them on the constraints.
//!
//! The oracle shares nothing with the engine, the model, the derivation and the planning of kernels. It shares the parsed
//! declaration, and with that all that `dsl` and `joints` write out: fragments and repetitions, joints as constraints, poses and
//! coordinates, free bodies, points `on()` them; and the sizes of units. Joints are therefore checked apart, against equations
//! written by hand (`tests/space/joints_by_hand.rs`, `tests/motion/joints.rs`).

use crate::all::all_mechanisms;
use codegen::dsl::{self, Declaration};
use codegen::model::Unit;
use codegen::oracle::{Comparison, Measured, Oracle, Solution, State, residual};
use sim::verify::{computed, observed};
use sim::{Array, Compiled, FixedArray, Input, Measures, accelerate, project_positions, project_velocities};
use tests::Random;

const STATES: usize = tests::sampled(80, 1000);

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

fn check<M: Compiled>() {
    let name = M::DESCRIPTION.name;
    let declaration = codegen::parse(M::DESCRIPTION.declaration.parse().unwrap()).unwrap();
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
fn put_on_constraints<M: Compiled>(mechanism: &M, t: f64, q: &mut M::Q, qd: &mut M::Q) -> bool {
    let mut nearer = *q;
    let measures = Measures::at(mechanism, t, q);
    // Projection gives up after ten corrections; from a random state a few more may be needed.
    let projected = (0..5).find_map(|_| project_positions(mechanism, &measures, t, &mut nearer).ok());
    let Some(linear) = projected else { return false };
    *q = nearer;
    project_velocities(mechanism, &measures, &linear, t, q, qd).is_ok()
}

/// In space kernels take components in the frames of bodies, where what is zero in the world is a difference of what is not:
/// there rounding of an entry is relative to this part of the largest entry at least.
const PART_IN_SPACE: f64 = 0.01;

struct Found {
    /// The largest difference, relative to its magnitude.
    worst: f64,
    /// Where.
    term: &'static str,
    /// The residual of the solved equations in eps n (|K||z| + |r|); none where they have no solution.
    residual: Option<f64>,
}

fn compare<M: Compiled>(mechanism: &M, declaration: &Declaration, t: f64, q: &M::Q, qd: &M::Q) -> Found {
    let si_factor = |unit: &dsl::Unit| Unit::resolve(unit).unwrap().factor();
    let active = mechanism.activities().iter().map(|activity| *activity != 0.0).collect();
    let oracle = Oracle::new(declaration, &si_factor).with_active(active);
    let parameters = mechanism.parameters();
    let inputs: Vec<Option<f64>> = mechanism.inputs().iter().map(|input| input.held()).collect();
    let (parameters, coordinates, speeds) = (parameters.as_ref(), q.as_ref(), qd.as_ref());
    let at = State { time: t, parameters, inputs: &inputs, coordinates, speeds };
    let mut comparison = Comparison::new(if M::DESCRIPTION.dimension == 3 { PART_IN_SPACE } else { 0.0 });
    let terms = comparison.enter(&computed(mechanism, t, q, qd), &oracle, &at).unwrap();
    let linear = mechanism.constraint_linearization(t, q);
    let linear_jacobian: Vec<f64> = linear.jacobian.iter().flat_map(|row| row.as_ref().to_vec()).collect();
    comparison.term("linearised C", linear.values.as_ref(), &terms.constraints);
    comparison.term("linearised C_q", &linear_jacobian, &terms.constraint_jacobian.concat());
    comparison.term("linearised C_t", linear.time_derivative.as_ref(), &terms.constraint_time_derivative);
    let residual = accelerate(mechanism, t, q, qd).ok().map(|solved| {
        let (accelerations, multipliers) = (&solved.accelerations, &solved.multipliers);
        let given = |values: &[f64]| values.iter().map(|value| Measured::given(*value)).collect::<Vec<_>>();
        let solution =
            Solution { accelerations: given(accelerations.as_ref()), multipliers: given(multipliers.as_ref()) };
        for (row, lambda) in multipliers.iter().enumerate() {
            assert!(sim::is_active(mechanism, row) || *lambda == 0.0, "a released row has the multiplier {lambda}");
        }
        let observed = observed(mechanism, t, q, qd, accelerations, multipliers);
        comparison.enter_solved(&observed, &oracle, &at, &solution).unwrap();
        comparison.term("power of dynamics", &[solved.power], &[oracle.power(&at, &solution).unwrap()]);
        residual(&terms, accelerations.as_ref(), multipliers.as_ref())
    });
    let (worst, term) = comparison.worst();
    Found { worst, term, residual }
}
