//! Verification passes for every shipped mechanism, and fails in the right row for each fault that is planted.

use crate::faulty::{Fault, Faulty};
use models::{HangingChain, QuickReturn, RobotArm, Stewart};
use sim::verify::{Check, constraint_residuals, order_of_convergence, runs_agree, verify};
use sim::{
    Compiled, Course, DOPRI5, Erased, ErrorEstimate, ExplicitRungeKutta, Measures, Mechanism, Method, Motion, RK4, Run,
    Settings, Stabilisation, Stepping, Steps, Tableau, Weight, assemble, declared_start, erase, integrate, mechanism,
    project_positions,
};
use std::ops::ControlFlow;
use tests::any_model::{AnyModel, interpreted};
use tests::run_with;

mechanism! {
    /// A bead on a rod that turns about a support that shakes: mixed second derivatives, and points that time moves.
    Shaken;
    coordinates { r [m]; phi [rad]; }
    parameters { m [kg] = 2; J [kg*m^2] = 0.3; g [m/s^2] = 9.81; w [rad/s] = 7; a [m] = 0.1; k [N/m] = 40; }
    let O = [a*sin(w*t), 0];
    let P = O + r*[cos(phi), sin(phi)];
    bodies { rod: inertia J, angle phi; bead: mass m at P; }
    loads { gravity [0, -g]; force k*(O - P) at P; }
    initial { r = 0.5; phi = 0.1; dot(phi) = 3; }
    outputs { x [m] = P.x; y [m] = P.y; }
}

/// Every row.
fn checks(mechanism: impl Mechanism, end: f64) -> Vec<Check> {
    let checks = verify(mechanism.clone(), &declared_start(&mechanism), end).unwrap();
    for check in &checks {
        let Check { name, figure, bound, meaning } = check;
        let figure = figure.map_or("-".into(), |figure| format!("{figure:.1e}"));
        println!("{:<16} {name:<34} {figure:>9} {bound:>9.1e} {meaning}", mechanism.description().name);
    }
    assert!(checks.len() >= 7);
    checks
}

fn any(mechanism: impl Compiled) -> AnyModel {
    Erased::of(erase(mechanism))
}

/// The rows that fail.
fn failing(mechanism: impl Mechanism, end: f64) -> Vec<&'static str> {
    checks(mechanism, end).iter().filter(|check| !check.passes()).map(|check| check.name).collect()
}

const LAGRANGE: &str = "TMT against Lagrange";
const ORACLE: &str = "kernels against the oracle";
const DUALS: &str = "Jacobians against dual numbers";
const REACTIONS: &str = "reactions against Newton-Euler";
const CONSTRAINTS: &str = "constraints along the run";
const ENERGY: &str = "energy and work";
const METHODS: &str = "DOP853 against DOPRI5";
const ORDER: &str = "order of convergence";
const PARTITIONING: &str = "projection against partitioning";

/// Every shipped one, or every fourth in a debug build.
#[test]
fn shipped_mechanisms_pass() {
    for (name, model) in models::erased().step_by(tests::sampled(4, 1)) {
        assert_eq!(failing(AnyModel::of(model()), 2.0), [""; 0], "{name}");
    }
    assert_eq!(failing(any(Shaken::default()), 1.0), [""; 0]);
}

/// An event at the time of a row makes a row more in one run than in another, and friction that is too sharp for equal steps shows no
/// order: neither is a fault of the mechanism.
#[test]
fn events_at_rows_and_sharp_friction_are_no_faults() {
    let oscillator =
        "pub Half; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; } loads { spring 50 [N/m], rest 0 on x; }
        initial { x = 0.3; } events { half: t = 0.5 [s] { set dot(x) = 1 [m/s]; } }";
    let sliding = "pub Sliding; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; }
        loads { spring 100 [N/m], rest 0 on x; friction 20 [N], smooth 1e-3 [m/s] on x; } initial { x = 1; }";
    for text in [oscillator, sliding] {
        assert_eq!(failing(interpreted(text).unwrap(), 2.0), [""; 0], "{text}");
    }
}

/// The trait has these derivatives from dual numbers, with which they would be compared.
#[test]
fn where_there_is_no_kernel_of_derivatives_none_is_compared() {
    let row = |checks: Vec<Check>| checks.into_iter().find(|check| check.name == DUALS).unwrap();
    let absent = [row(checks(any(RobotArm::default()), 0.1)), row(checks(any(HangingChain::default()), 0.1))];
    for Check { figure, meaning, .. } in absent {
        assert!(figure.is_none() && meaning.starts_with("no kernel"), "{figure:?} {meaning}");
    }
    // It has constraints, whose derivatives are kernels.
    let Check { figure, meaning, .. } = row(checks(any(Stewart::default()), 0.1));
    assert!(figure.is_some() && meaning.ends_with("no kernel of d(q'', lambda)/d(q, q') to compare"), "{meaning}");
}

/// Which parameter is called so.
fn parameter<M: Compiled>(name: &str) -> usize {
    M::DESCRIPTION.parameters.iter().position(|p| p.name == name).unwrap()
}

#[test]
fn a_wrapper_without_a_fault_passes() {
    assert_eq!(failing(Faulty { true_one: Shaken::default(), fault: Fault::None }, 1.0), [""; 0]);
}

/// Which rows see a fault, at a hundred times their bound at least.
fn seeing(found: &[Check]) -> Vec<&'static str> {
    let sees = |check: &&Check| check.figure.is_some_and(|figure| figure >= 100.0 * check.bound);
    let seeing = found.iter().filter(sees).map(|check| check.name).collect();
    let doubtful: Vec<&Check> = found.iter().filter(|check| !check.passes() && !sees(check)).collect();
    assert!(doubtful.is_empty(), "{doubtful:?}");
    seeing
}

#[test]
fn spoiled_kernels_fail_in_their_rows() {
    let quick_return = |fault| seeing(&checks(Faulty { true_one: QuickReturn::default(), fault }, 0.5));
    let shaken = |fault| seeing(&checks(Faulty { true_one: Shaken::default(), fault }, 1.0));
    assert_eq!(quick_return(Fault::MultiplierSign), [LAGRANGE, REACTIONS]);
    assert_eq!(quick_return(Fault::SwappedOutputs), [ORACLE]);
    assert_eq!(quick_return(Fault::LostDerivative), [DUALS]);
    assert_eq!(quick_return(Fault::HalfPower), [ENERGY]);
    let all = |rows: &[&str], seen: Vec<&str>| assert!(rows.iter().all(|row| seen.contains(row)), "{seen:?}");
    let lost = Fault::LostLoad(parameter::<QuickReturn>("F"));
    all(&[LAGRANGE, ORACLE, REACTIONS, ENERGY], quick_return(lost));
    all(&[LAGRANGE, ORACLE], quick_return(Fault::UnitFactor(parameter::<QuickReturn>("BC"), 1.01)));
    all(&[LAGRANGE, ORACLE, ENERGY], shaken(Fault::MixedDerivative));
    all(&[LAGRANGE, ORACLE], shaken(Fault::Frozen(parameter::<Shaken>("w"))));
}

/// The start of the quick-return.
fn start() -> sim::State<QuickReturn> {
    let mechanism = QuickReturn::default();
    assemble(&mechanism, &declared_start(&mechanism)).unwrap()
}

/// A run of it with equal steps, all of which are rows.
fn run_by(method: Method, stabilisation: Stabilisation) -> Run<QuickReturn> {
    run_with(QuickReturn::default(), &Settings { stabilisation, ..Settings::equal_steps(method, 0.5, 1024) }).unwrap()
}

fn sees(check: Check, name: &str) {
    println!("{check:?}");
    assert_eq!(check.name, name);
    assert_eq!(seeing(&[check]), [name]);
}

/// Positions projected and velocities not.
#[test]
fn a_velocity_projection_that_is_skipped_fails_the_constraints() {
    let mut run = run_by(Method::Heun, Stabilisation::None);
    let first = start();
    let measures = Measures::at(&run.mechanism, first.time, &first.positions);
    for sample in &mut run.trajectory.samples {
        project_positions(&run.mechanism, &measures, sample.state.time, &mut sample.state.positions).unwrap();
    }
    sees(constraint_residuals(&run), CONSTRAINTS);
    assert!(constraint_residuals(&run_by(Method::Heun, Stabilisation::Projection)).passes());
    // A speed without a value is no smaller than any.
    let mut run = run_by(Method::Heun, Stabilisation::Projection);
    run.trajectory.samples[7].state.speeds[1] = f64::NAN;
    sees(constraint_residuals(&run), CONSTRAINTS);
}

/// RK4 with one entry of its tableau wrong.
#[test]
fn a_wrong_tableau_fails_the_order() {
    const WRONG: Tableau =
        Tableau { a: &[&[], &[(0, 0.5)], &[(1, 0.51)], &[(2, 1.0)]], error: ErrorEstimate::None, ..RK4 };
    let mechanism = QuickReturn::default();
    let order = |tableau| {
        order_of_convergence(&mechanism, start(), 0.5, || ExplicitRungeKutta::new(&mechanism, tableau), 4.0).unwrap()
    };
    assert!(order(&RK4).passes());
    sees(order(&WRONG), ORDER);
}

/// DOPRI5 with one weight wrong by a hundredth.
#[test]
fn a_wrong_method_fails_beside_another() {
    let good = run_by(Method::Dop853, Stabilisation::Projection);
    assert!(runs_agree(METHODS, &good, &run_by(Method::Dopri5, Stabilisation::Projection)).passes());
    let weights: Vec<Weight> = DOPRI5.b.iter().map(|(stage, weight)| (*stage, 1.01 * weight)).collect();
    let wrong = Tableau { b: weights.leak(), ..DOPRI5 };
    let mechanism = QuickReturn::default();
    let measures = Measures::at(&mechanism, 0.0, &start().positions);
    let motion = Motion::new(mechanism, Stabilisation::Projection, measures);
    let course = Course { begin: 0.0, end: 0.5, stepping: Stepping::Equal(1024) };
    let (mut spoiled, first) = (good.clone(), motion.sample(start()).unwrap());
    spoiled.trajectory.samples = vec![first.clone()];
    let mut method = ExplicitRungeKutta::new(&mechanism, Box::leak(Box::new(wrong)));
    integrate(&motion, &mut method, &course, first, &mut Steps::default(), |step| {
        spoiled.trajectory.samples.push(step.to.clone());
        Ok(ControlFlow::Continue(()))
    })
    .unwrap();
    sees(runs_agree(METHODS, &good, &spoiled), METHODS);
}

/// Accelerations that leave the constraints: projection brings the motion back across them, partitioning along them.
#[test]
fn lost_convective_terms_fail_between_projection_and_partitioning() {
    let faulty = Faulty { true_one: QuickReturn::default(), fault: Fault::LostConvective };
    let run = |stabilisation| {
        run_with(faulty, &Settings { stabilisation, ..Settings::equal_steps(Method::Rk4, 0.5, 1024) }).unwrap()
    };
    let [one, other] = [Stabilisation::Projection, Stabilisation::Partitioning].map(run);
    sees(runs_agree(PARTITIONING, &one, &other), PARTITIONING);
    let [one, other] = [Stabilisation::Projection, Stabilisation::Partitioning].map(|kept| run_by(Method::Rk4, kept));
    assert!(runs_agree(PARTITIONING, &one, &other).passes());
}

/// A spring without length, at its own end, and a motor by the straight lines of a table, whose corners no method passes with its order.
#[test]
fn springs_of_no_length_and_straight_tables_pass() {
    let spring = "pub Spring; coordinates { x [m]; } bodies { b: mass 2 [kg] at [x, 0]; }
        loads { spring 30 [N/m], length 0 from [0, 0] to [x, 0]; } initial { x = 0; dot(x) = 1; }";
    let motor = "pub Motor; coordinates { w [rad]; } parameters { J [kg*m^2] = 2; }
        tables { mo [N*m] over [rad/s] = linear { 0, 10; 5, 4; 20, 0; } }
        bodies { r: inertia J, angle w; } loads { torque mo(dot(w)) on w; } initial { w = 0; dot(w) = 0.1; }";
    for text in [spring, motor] {
        assert_eq!(failing(interpreted(text).unwrap(), 4.0), Vec::<&str>::new(), "{text}");
    }
}

/// What starts at a zero of a condition has its form from there on, and shows its order.
#[test]
fn a_start_at_a_zero_of_a_condition_is_checked() {
    let text = "pub Drag; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; }
        loads { force 2 [N] - 0.3 [kg/m]*dot(x)*abs(dot(x)) on x; } initial { x = 0; dot(x) = 0; }";
    let order = checks(interpreted(text).unwrap(), 3.0).into_iter().find(|check| check.name == ORDER).unwrap();
    assert!(order.passes() && !order.meaning.contains("not checked"), "{order:?}");
}

#[test]
fn a_row_has_been_seen_to_fail_for_each_that_is_printed() {
    let rows: Vec<&str> = checks(any(QuickReturn::default()), 0.5).iter().map(|check| check.name).collect();
    assert_eq!(rows, [LAGRANGE, ORACLE, DUALS, REACTIONS, CONSTRAINTS, ENERGY, METHODS, ORDER, PARTITIONING]);
}
