//! Analyses of a mechanism with its type erased give the numbers of the compiled one.

use models::{CartPole, DoublePendulum, QuickReturn};
use sim::sim_kernel::Mask;
use sim::{
    Array, Control, Driven, Erased, InPlace, Lanes, Mechanism, Scalar, Sweep, declared_start, equilibrium, erase,
    kinematics, linearize,
};

type Short = Erased<InPlace<8>>;

/// Linearised with all inputs and a parameter in their place: kernels on dual numbers, with values that change.
fn bits<M: Mechanism>(mechanism: &M, controls: &[Control]) -> Vec<u64> {
    let state = equilibrium(mechanism, &declared_start(mechanism)).unwrap().state;
    let found = linearize(mechanism, &state, controls).unwrap();
    let matrices = [found.a, found.b, found.c, found.d];
    let numbers = matrices.iter().flat_map(|matrix| matrix.iter()).chain(state.positions.iter());
    numbers.map(|number| number.to_bits()).collect()
}

#[test]
fn matrices_about_equilibria_are_the_same() {
    let (cart, pendulum) = (CartPole::default(), DoublePendulum::default());
    let inputs: Vec<Control> = (0..cart.description().inputs.len()).map(Control::Input).collect();
    let erased = Short::new(erase(cart)).unwrap();
    assert!(!inputs.is_empty());
    assert_eq!(bits(&cart, &inputs), bits(&erased, &inputs));
    let parameter = [Control::Parameter(0)];
    let erased = Short::new(erase(pendulum)).unwrap();
    let found = bits(&pendulum, &parameter);
    assert_eq!(found, bits(&erased, &parameter));
    assert!(found.len() > 20);
}

#[test]
fn sweeps_are_the_same() {
    let compiled = QuickReturn::default();
    let sweep = Sweep { driven: Driven::Coordinate(0), from: 0.0, to: 6.3, speed: 7.0, steps: 36, held: vec![] };
    let found = kinematics(compiled, &declared_start(&compiled), &sweep).unwrap();
    let erased = Short::new(erase(compiled)).unwrap();
    let other = kinematics(erased.clone(), &declared_start(&erased), &sweep).unwrap();
    assert_eq!(found.extremes, other.extremes);
    assert_eq!((found.forces, found.transmission), (other.forces, other.transmission));
}

#[test]
fn values_are_set_as_on_the_compiled_one() {
    let compiled = QuickReturn::default();
    let longer = QuickReturn { O2A: 0.21, ..compiled };
    let erased = Short::new(erase(compiled)).unwrap();
    let q = [0.1, 1.2, 2.3];
    let place = <Short as Mechanism>::Q::with_len(3, |i| q[i]);
    let mut parameters = erased.parameters();
    let crank = erased.description().parameters.iter().position(|p| p.name == "O2A").unwrap();
    parameters[crank] = 0.21;
    let changed = erased.with_parameters(parameters);
    assert_eq!(changed.constraints(0.0, &place).as_ref(), longer.constraints(0.0, &q));
    assert_ne!(erased.constraints(0.0, &place).as_ref(), longer.constraints(0.0, &q));
    assert_eq!(changed.as_declared().constraints(0.0, &place).as_ref(), compiled.constraints(0.0, &q));
}

/// It has kernels for numbers and dual numbers alone, and gives no others.
#[test]
fn other_numbers_are_refused() {
    let lanes = Short::new(erase(QuickReturn::default())).unwrap().on(Lanes::<4>::from_f64);
    let place = <Erased<InPlace<8>, Lanes<4>> as Mechanism<Lanes<4>>>::Q::with_len(3, |_| Lanes::from_f64(1.0));
    let found = lanes.dynamics(Lanes::from_f64(0.0), &place, &place);
    assert!(found.refused.any());
    assert!((0..4).all(|lane| found.power.lane(lane).is_nan() && found.accelerations[0].lane(lane).is_nan()));
}

#[test]
fn too_many_coordinates_are_refused() {
    assert!(Erased::<InPlace<2>>::new(erase(QuickReturn::default())).is_none());
    assert!(Erased::<InPlace<3>>::new(erase(QuickReturn::default())).is_some());
}
