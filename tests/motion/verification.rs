//! Verification passes for every shipped mechanism, and fails in the right row for each fault that is planted.

use crate::faulty::{Fault, Faulty};
use models::QuickReturn;
use sim::verify::{constraint_residuals, order_of_convergence, verify};
use sim::{
    ErrorEstimate, ExplicitRungeKutta, Measures, Mechanism, Method, RK4, Settings, Tableau, assemble, declared_start,
    mechanism, project_positions,
};
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

/// The rows that fail.
fn failing<M: Mechanism>(mechanism: M, end: f64) -> Vec<&'static str> {
    let checks = verify(mechanism, &declared_start(&mechanism), end).unwrap();
    for check in &checks {
        println!(
            "{:<16} {:<34} {:>9.1e} {:>9.0e} {}",
            M::DESCRIPTION.name,
            check.name,
            check.figure,
            check.bound,
            check.meaning
        );
    }
    assert!(checks.len() >= 7);
    checks.iter().filter(|check| !check.passes()).map(|check| check.name).collect()
}

const ORACLE: &str = "kernels against the oracle";
const LAGRANGE: &str = "TMT against Lagrange";
const REACTIONS: &str = "reactions against Newton-Euler";
const ENERGY: &str = "energy and work";

#[test]
fn every_shipped_mechanism_passes() {
    macro_rules! all {
        ($($model:ty),*) => { $(assert_eq!(failing(<$model>::default(), 2.0), [""; 0]);)* };
    }
    models::all_models!(all);
    assert_eq!(failing(Shaken::default(), 1.0), [""; 0]);
}

/// Which parameter is called so.
fn parameter<M: Mechanism>(name: &str) -> usize {
    M::DESCRIPTION.parameters.iter().position(|p| p.name == name).unwrap()
}

#[test]
fn a_wrapper_without_a_fault_passes() {
    assert_eq!(failing(Faulty { true_one: Shaken::default(), fault: Fault::None }, 1.0), [""; 0]);
}

#[test]
fn spoiled_kernels_fail_in_their_rows() {
    let quick_return = |fault| failing(Faulty { true_one: QuickReturn::default(), fault }, 0.5);
    let shaken = |fault| failing(Faulty { true_one: Shaken::default(), fault }, 1.0);
    assert_eq!(quick_return(Fault::MultiplierSign), [REACTIONS]);
    assert_eq!(quick_return(Fault::SwappedOutputs), [ORACLE]);
    let lost = quick_return(Fault::LostLoad(parameter::<QuickReturn>("F")));
    assert!([LAGRANGE, ORACLE, REACTIONS, ENERGY].iter().all(|row| lost.contains(row)), "{lost:?}");
    let unit = quick_return(Fault::UnitFactor(parameter::<QuickReturn>("BC"), 1.01));
    assert!([LAGRANGE, ORACLE].iter().all(|row| unit.contains(row)), "{unit:?}");
    let mixed = shaken(Fault::MixedDerivative);
    assert!([LAGRANGE, ORACLE, ENERGY].iter().all(|row| mixed.contains(row)), "{mixed:?}");
    let frozen = shaken(Fault::Frozen(parameter::<Shaken>("w")));
    assert!([LAGRANGE, ORACLE].iter().all(|row| frozen.contains(row)), "{frozen:?}");
}

/// Positions projected and velocities not.
#[test]
fn a_velocity_projection_that_is_skipped_fails_the_constraints() {
    let settings = Settings { stabilisation: sim::Stabilisation::None, ..Settings::equal_steps(Method::Rk4, 2.0, 256) };
    let mut run = run_with(QuickReturn::default(), &settings).unwrap();
    let start = run.trajectory.samples[0].state;
    let measures = Measures::at(&run.mechanism, start.time, &start.positions);
    for sample in &mut run.trajectory.samples {
        project_positions(&run.mechanism, &measures, sample.state.time, &mut sample.state.positions).unwrap();
    }
    let check = constraint_residuals(&run);
    println!("{check:?}");
    assert!(!check.passes());
    assert!(constraint_residuals(&run_with(QuickReturn::default(), &Settings::new(2.0)).unwrap()).passes());
}

/// RK4 with one entry of its tableau wrong.
#[test]
fn a_wrong_tableau_fails_the_order() {
    const WRONG: Tableau =
        Tableau { a: &[&[], &[(0, 0.5)], &[(1, 0.51)], &[(2, 1.0)]], error: ErrorEstimate::None, ..RK4 };
    let mechanism = QuickReturn::default();
    let start = assemble(&mechanism, &declared_start(&mechanism)).unwrap();
    let order =
        |tableau| order_of_convergence(&mechanism, start, 0.5, || ExplicitRungeKutta::new(tableau), 4.0).unwrap();
    println!("{:?}\n{:?}", order(&RK4), order(&WRONG));
    assert!(order(&RK4).passes() && !order(&WRONG).passes());
}
