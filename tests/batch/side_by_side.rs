//! Simulations side by side have the bits that each has alone: states, steps, events, memory of methods.

use crate::forward::erased;
use crate::{Folding, Rods, Turning};
use models::{Bennett, BouncingBall, CartPole, DoublePendulum, FourBar, QuickReturn, TumblingQuaternion};
use sim::{
    Array, Compiled, Input, Mechanism, Method, Settings, Simulation, Stabilisation, advance_each, declared_start,
};
use tests::engine::Engine;

/// Not a multiple of the number of lanes.
const COUNT: usize = 11;

fn every_way(end: f64) -> Vec<Settings> {
    let equal = Method::ALL.map(|method| Settings::equal_steps(method, end, 150));
    let adaptive = [Method::Dopri5, Method::Dop853, Method::Radau5].map(|method| Settings::adaptive(method, end, 1e-7));
    let partitioned = Settings { stabilisation: Stabilisation::Partitioning, ..Settings::new(end) };
    equal.into_iter().chain(adaptive).chain([partitioned]).collect()
}

/// Simulations whose speeds differ by hundredths, and whose parameters by this fraction of themselves.
fn different<M: Mechanism>(mechanism: &M, settings: &Settings, spread: f64) -> Vec<Simulation<M>> {
    let one = |k: usize| {
        let factor = |p: usize| 1.0 + spread * ((7 * k + 3 * p) % 11) as f64 / 10.0;
        let parameters = mechanism.parameters();
        let other = mechanism.with_parameters(parameters.like(|p| parameters[p] * factor(p)));
        let mut start = declared_start(&other);
        start.speeds = start.speeds.like(|i| start.speeds[i] * (1.0 + 0.02 * k as f64));
        Simulation::new(other, &start, settings).unwrap()
    };
    (0..COUNT).map(one).collect()
}

/// Advances simulations alone and side by side to several times, and compares all that they remember.
fn compare<M: Mechanism>(name: &str, simulations: &[Simulation<M>], times: &[f64]) {
    let (mut alone, mut beside) = (simulations.to_vec(), simulations.to_vec());
    for time in times {
        let failures: Vec<_> = alone
            .iter_mut()
            .enumerate()
            .filter_map(|(i, simulation)| Some((i, simulation.advance_to(*time).err()?)))
            .collect();
        let mut found = advance_each(&mut beside, *time);
        found.sort_by_key(|(i, _)| *i);
        assert_eq!(found, failures, "{name}");
        for (i, (alone, beside)) in alone.iter().zip(&beside).enumerate() {
            assert_eq!(alone.steps(), beside.steps(), "{name} {i} at {time}");
            assert_eq!(alone.evaluations(), beside.evaluations(), "{name} {i} at {time}");
            assert!(alone.save() == beside.save(), "{name} {i} at {time}: other bits");
        }
    }
}

fn in_every_way<M: Compiled>(name: &str, end: f64, spread: f64) {
    for settings in every_way(end) {
        let what = format!("{name} by {:?} {:?}", settings.method, settings.stabilisation);
        compare(&what, &different(&M::defaults(), &settings, spread), &[0.31 * end, 0.8 * end, end]);
    }
}

#[test]
fn loops_and_chains_have_the_same_bits_side_by_side() {
    in_every_way::<QuickReturn>("quick-return", 1.0, 0.01);
    in_every_way::<DoublePendulum>("double pendulum", 1.0, 0.3);
    in_every_way::<FourBar>("four-bar", 1.0, 0.01);
    // With other parameters the body has no possible inertia.
    in_every_way::<TumblingQuaternion>("tumbling", 0.5, 0.0);
}

/// Parts with one crank.
#[test]
fn parts_have_the_same_bits_side_by_side() {
    let settings = [Settings::equal_steps(Method::Rk4, 0.3, 60), Settings::new(0.3)];
    settings.iter().for_each(|settings| {
        compare("engine", &different(&Engine::default(), settings, 0.01), &[0.2, 0.3]);
    });
}

/// Each passes singular positions at its own times, by steps of its own.
#[test]
fn singular_positions_are_passed_side_by_side() {
    let settings = Settings::new(1.0);
    let simulations = different(&Folding::default(), &settings, 0.0);
    compare("folding", &simulations, &[0.3, 0.9]);
    let mut passed = simulations;
    assert!(advance_each(&mut passed, 0.9).is_empty());
    assert!(passed.iter().all(|simulation| simulation.steps().singularities.len() > 1));
}

/// Generalised speeds, many coordinates and redundant constraints, which lanes do not have.
#[test]
fn motions_that_lanes_do_not_have_are_made_one_by_one() {
    in_every_way::<Turning>("turning", 0.5, 0.1);
    compare("rods", &different(&Rods::default(), &Settings::equal_steps(Method::Rk4, 0.3, 60), 0.01), &[0.2, 0.3]);
    // With other parameters its loop does not close.
    compare("bennett", &different(&Bennett::defaults(), &Settings::new(0.5), 0.0), &[0.2, 0.5]);
}

/// Each bounces at its own times, and goes on with another phase.
#[test]
fn events_in_lanes_are_those_of_each_motion() {
    in_every_way::<BouncingBall>("bouncing ball", 3.0, 0.1);
}

/// Inputs that are held in all lanes, in none, and in some.
#[test]
fn inputs_in_lanes_are_those_of_each_motion() {
    let held: [fn(usize) -> bool; 3] = [|_| true, |_| false, |k| k % 3 == 0];
    for is_held in held {
        let mut simulations = different(&CartPole::default(), &Settings::new(1.0), 0.1);
        for (k, simulation) in simulations.iter_mut().enumerate().filter(|(k, _)| is_held(*k)) {
            let inputs = simulation.mechanism().inputs().map(|_| Input::Held(0.1 * k as f64));
            simulation.set_inputs(inputs).unwrap();
        }
        compare("cart-pole", &simulations, &[0.4, 1.0]);
    }
}

/// One in the block fails on its way; the others are not disturbed.
#[test]
fn a_failure_in_a_lane_is_its_own() {
    let settings = Settings::new(1.0);
    let mut simulations = different(&DoublePendulum::default(), &settings, 0.1);
    let mut wild = DoublePendulum::default();
    let first = wild.parameters();
    wild = wild.with_parameters(first.map(|value| value * 1e150));
    let mut start = declared_start(&wild);
    start.speeds = start.speeds.map(|_| 1e150);
    simulations[3] = Simulation::new(wild, &start, &settings).unwrap();
    // Times that are past, or none, change nothing.
    compare("double pendulum", &simulations, &[0.5, 0.2, f64::NAN, f64::NEG_INFINITY, f64::INFINITY]);
    assert!(!advance_each(&mut simulations, 1.0).is_empty());
}

/// Type-erased mechanisms have no kernels in lanes: each makes its own attempts.
#[test]
fn erased_mechanisms_are_advanced_too() {
    compare("erased", &different(&erased(QuickReturn::default()), &Settings::new(1.0), 0.01), &[0.5, 1.0]);
    assert!(advance_each::<QuickReturn>(&mut [], 1.0).is_empty());
}
