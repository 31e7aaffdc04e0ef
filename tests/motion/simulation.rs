//! Motions that are advanced, changed, saved and restored on their way.

use crate::impacts::{Shaken, Stone};
use crate::singular::{Parallelogram, ThreeCranks};
use models::{Bennett, BouncingBall, CartPole, FourBar, Pendulum, QuickReturn, Skate, TumblingQuaternion};
use sim::{
    Compiled, Controller, Input, Method, NotRestored, Rows, Sample, Settings, Simulation, Stabilisation, State, StopAt,
    What, declared_start, run, run_controlled,
};
use tests::Random;

fn simulation<M: Compiled>(mechanism: M, settings: &Settings) -> Simulation<M> {
    Simulation::new(mechanism, &declared_start(&mechanism), settings).unwrap()
}

/// All bits of a state.
fn bits<M: Compiled>(state: &State<M>) -> Vec<u64> {
    let numbers = [&[state.time, state.work][..], state.positions.as_ref(), state.speeds.as_ref()].concat();
    numbers.into_iter().map(f64::to_bits).collect()
}

fn every_way(end: f64) -> Vec<Settings> {
    let equal = Method::ALL.map(|method| Settings::equal_steps(method, end, 120));
    let adaptive = [Method::Dopri5, Method::Dop853, Method::Radau5].map(|method| Settings::adaptive(method, end, 1e-7));
    let ways = [Stabilisation::MassProjection, Stabilisation::Partitioning, Stabilisation::Baumgarte(5.0)];
    let other = ways.map(|stabilisation| Settings { stabilisation, ..Settings::new(end) });
    equal.into_iter().chain(adaptive).chain(other).collect()
}

/// A run is a loop over a simulation: step by step it comes to the same.
#[test]
fn a_simulation_makes_the_steps_of_a_run() {
    let settings = Settings { rows: Rows::Steps, ..Settings::new(2.0) };
    let ball = BouncingBall::default();
    let found = run(ball, &declared_start(&ball), &settings).unwrap();
    let mut simulation = simulation(ball, &settings);
    while simulation.step().unwrap() {}
    assert!(simulation.has_ended() && found.events.len() > 3);
    assert_eq!(bits(simulation.state()), bits(&found.trajectory.samples.last().unwrap().state));
    assert_eq!((simulation.steps(), simulation.evaluations()), (&found.steps, found.evaluations - rows(&found)));
    let times = |events: &[sim::Occurrence<BouncingBall>]| events.iter().map(|e| e.state.time).collect::<Vec<_>>();
    assert_eq!(times(simulation.events()), times(&found.events));
}

/// Where an event ends the motion, so do its steps.
#[test]
fn a_simulation_ends_at_the_event_that_stops_it() {
    let stop = Some(StopAt { event: 0, occurrence: 2 });
    for settings in
        [Settings { stop, ..Settings::new(1e6) }, Settings { stop, ..Settings::equal_steps(Method::Rk4, 50.0, 9000) }]
    {
        let mut ball = simulation(BouncingBall::default(), &settings);
        ball.advance_to(40.0).unwrap();
        let landing = ball.state().time;
        assert!(ball.has_ended() && ball.events().last().unwrap().state.time == landing && !ball.step().unwrap());
        // Twice from 1 m, by a rebound of 0.9: sqrt(2 h/g) (1 + 2 0.9).
        assert!((landing - (2.0f64 / 9.81).sqrt() * 2.8).abs() < 1e-10, "{landing}");
    }
}

/// Right-hand sides that rows alone ask for: those at events, before and after.
fn rows(found: &sim::Run<BouncingBall>) -> u64 {
    found.events.iter().filter(|event| event.change.is_some()).count() as u64
}

/// Saved after any step and restored into a simulation that has not begun, or is elsewhere, a motion goes on as if nothing had
/// been.
fn check_saved<M: Compiled>(mechanism: M, end: f64, random: &mut Random) {
    for settings in every_way(end) {
        let mut whole = simulation(mechanism, &settings);
        let (mut saved, mut states) = (vec![whole.save()], vec![bits(whole.state())]);
        // Radau's equations may have no solution beside a flat position; both ways end there then.
        while whole.step().unwrap_or(false) {
            saved.push(whole.save());
            states.push(bits(whole.state()));
        }
        let mut other = simulation(mechanism, &settings);
        for _ in 0..tests::sampled(10, 50) {
            let at = random.between(0.0, saved.len() as f64) as usize;
            other.restore(&saved[at]).unwrap();
            for expected in states[at..].iter().take(12) {
                assert_eq!(bits(other.state()), *expected, "{} by {:?} after step {at}", M::DESCRIPTION.name, settings);
                let _ = other.step();
            }
        }
        // Where the motion fails it stays, and so it does in what was restored.
        if let Err(failure) = whole.step() {
            assert_eq!(whole.step(), Err(failure));
            assert_eq!(other.restore(&whole.save()), Err(NotRestored::Failed));
        }
        // To the end from somewhere, and as much happened.
        other.restore(&saved[saved.len() / 3]).unwrap();
        while other.step().unwrap_or(false) {}
        assert_eq!((bits(other.state()), other.steps()), (bits(whole.state()), whole.steps()));
        assert_eq!((other.events().len(), other.evaluations()), (whole.events().len(), whole.evaluations()));
        assert_eq!(other.save(), whole.save());
    }
}

#[test]
fn a_simulation_goes_on_from_where_it_was_saved() {
    let mut random = Random(7);
    check_saved(QuickReturn::default(), 0.3, &mut random);
    check_saved(Shaken::default(), 0.9, &mut random);
    check_saved(Stone::default(), 2.0, &mut random);
    check_saved(Parallelogram::default(), 4.0, &mut random);
    check_saved(ThreeCranks::default(), 4.0, &mut random);
    check_saved(BouncingBall::default(), 1.5, &mut random);
    check_saved(TumblingQuaternion::default(), 0.4, &mut random);
    check_saved(Bennett::default(), 0.3, &mut random);
    check_saved(Skate::default(), 0.5, &mut random);
}

/// Of bytes that are cut, lengthened or altered none is restored; nor does anything panic where the digest is right.
#[test]
fn altered_bytes_are_refused() {
    let settings = Settings::adaptive(Method::Radau5, 1.5, 1e-6);
    let mut ball = simulation(BouncingBall::default(), &settings);
    ball.advance_to(1.0).unwrap();
    let (saved, mut random) = (ball.save(), Random(3));
    for round in 0..10_000 {
        let (mut bytes, at) = (saved.clone(), random.between(0.0, saved.len() as f64) as usize);
        match round % 4 {
            0 => bytes.truncate(at),
            1 => bytes[at] ^= 1 << (round / 4 % 8),
            2 => bytes.insert(at, round as u8),
            _ => {
                let other = random.between(0.0, saved.len() as f64) as usize;
                bytes.swap(at, other);
                bytes[at] = bytes[at].wrapping_add(1);
            }
        }
        if bytes != saved {
            let refused = ball.restore(&bytes);
            assert!(matches!(refused, Err(NotRestored::Damaged | NotRestored::NotSaved)), "{round}: {refused:?}");
        }
        // Whoever alters bytes and knows the digest gets an error or a simulation, and no panic.
        let length = bytes.len().saturating_sub(8);
        bytes.truncate(length);
        let sum = tests::digest::fnv(&bytes);
        bytes.extend(sum.to_le_bytes());
        let mut other = ball.clone();
        if other.restore(&bytes).is_ok() {
            let _ = other.step();
        }
    }
    assert_eq!(ball.save(), saved);
}

/// What is not the same is named.
#[test]
fn a_simulation_of_something_else_is_refused_by_name() {
    let settings = Settings::new(1.0);
    let saved = simulation(FourBar::default(), &settings).save();
    let other = |settings: Settings| simulation(FourBar::default(), &settings).restore(&saved).unwrap_err().to_string();
    assert!(other(Settings::adaptive(Method::Radau5, 1.0, 1e-10)).contains("another method: `dop853` there, `radau5`"));
    assert!(other(Settings::new(2.0)).contains("another end: `1 s` there, `2 s` here"));
    assert!(other(Settings::adaptive(Method::Dop853, 1.0, 1e-9)).contains("another length of steps: `rtol 1e-10"));
    let pendulum = simulation(Pendulum::default(), &settings).restore(&saved).unwrap_err().to_string();
    assert!(pendulum.contains("another mechanism: `four-bar` there, `pendulum` here"), "{pendulum}");
    assert_eq!(simulation(FourBar::default(), &settings).restore(b"not this"), Err(NotRestored::NotSaved));
    // Another start and other parameters are what is saved.
    let longer = FourBar { a: 0.21, ..FourBar::default() };
    let mut restored = simulation(longer, &settings);
    restored.restore(&saved).unwrap();
    assert_eq!(restored.mechanism().a, 0.2);
}

/// A loop that is closed by the owner of a simulation is the same as by a controller that a run asks.
#[test]
fn a_loop_is_closed_by_inputs() {
    let law = |sample: &Sample<CartPole>| Input::Held(-2.0 * sample.state.positions[0] - sample.state.speeds[0]);
    for settings in [Settings::new(1.0), Settings::equal_steps(Method::Rk4, 1.0, 300)] {
        let cart = CartPole::default();
        let mut controller = Controller::new(0.1, |sample: &Sample<CartPole>| [law(sample)]).unwrap();
        let found = run_controlled(cart, &declared_start(&cart), &settings, &mut controller).unwrap();
        let mut simulation = simulation(cart, &settings);
        let input = <CartPole as Compiled>::DESCRIPTION.inputs[0].name;
        for period in 0..10 {
            simulation.set_input(input, law(&simulation.sample().unwrap())).unwrap();
            simulation.advance_to(f64::from(period + 1) * 0.1).unwrap();
        }
        assert_eq!(bits(simulation.state()), bits(&found.trajectory.samples.last().unwrap().state));
        let unknown = simulation.set_input("nothing", Input::Declared).unwrap_err();
        assert!(unknown.to_string().contains(&format!("there is no input `nothing`; there are: {input}")), "{unknown}");
    }
}

/// A pendulum that becomes longer while it hangs moves on with the same angle and speed.
#[test]
fn a_parameter_that_no_constraint_has_moves_nothing() {
    let mut pendulum = simulation(Pendulum::default(), &Settings::new(4.0));
    pendulum.advance_to(1.0).unwrap();
    let before = bits(pendulum.state());
    pendulum.set_parameter("l", 2.0 * pendulum.mechanism().l).unwrap();
    assert_eq!(bits(pendulum.state()), before);
    pendulum.advance_to(4.0).unwrap();
    // As one that starts there.
    let state = pendulum.state();
    let energy = |state: &State<Pendulum>| {
        let mechanism = pendulum.mechanism();
        mechanism.kinetic_energy(state.time, &state.positions, &state.speeds) - state.work
    };
    assert!(energy(state).is_finite());
    let refused = pendulum.clone().set_parameter("l", f64::NAN).unwrap_err();
    assert!(matches!(refused.what, What::NotFinite { .. }), "{refused}");
    let refused = pendulum.clone().set_parameter("m", -1.0).unwrap_err();
    assert!(matches!(refused.what, What::NegativeMass { .. }), "{refused}");
}

/// A four-bar whose coupler grows keeps its loop closed on its branch; one that would be too long is refused and left as it was.
#[test]
fn a_length_that_is_changed_moves_the_linkage_along_its_branch() {
    let mut linkage = simulation(FourBar::default(), &Settings::new(1.0));
    linkage.advance_to(0.3).unwrap();
    let [_, coupler, rocker] = linkage.state().positions;
    let side = (rocker - coupler).sin().signum();
    let b: f64 = FourBar::default().b;
    for factor in [1.02, 1.1, 0.95] {
        linkage.set_parameter("b", factor * b).unwrap();
        let (state, mechanism) = (linkage.state(), linkage.mechanism());
        let open = mechanism.constraints(state.time, &state.positions);
        assert!(open.iter().all(|value| value.abs() < 1e-12), "{open:?}");
        let [_, coupler, rocker] = state.positions;
        assert_eq!((rocker - coupler).sin().signum(), side);
        let time = state.time + 0.05;
        linkage.advance_to(time).unwrap();
        assert_eq!(linkage.state().time, time);
    }
    let before = linkage.save();
    let refused = linkage.set_parameter("b", 20.0 * b).unwrap_err();
    assert!(matches!(refused.what, What::ParametersOpen { .. }), "{refused}");
    assert_eq!(linkage.save(), before);
    let refused = linkage.advance_to(f64::NAN).unwrap_err();
    assert!(refused.to_string().contains("the time to advance to is not a number"), "{refused}");
}
