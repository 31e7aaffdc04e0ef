//! What the owner of a simulation may do on its way: many short advances, changes at rest, at events and beside singular
//! positions, settings that are none.

use crate::singular::{Parallelogram, ThreeCranks};
use models::{BouncingBall, CartPole};
use sim::{
    Array, Compiled, Controller, Crossing, Input, Mechanism, Method, Rows, Settings, Simulation, Stabilisation, StopAt,
    What, declared_start, mechanism, run, run_controlled,
};

mechanism! {
    /// A mass between a force and a spring, with a condition on its acceleration and one on its place.
    pub(crate) Cart;
    coordinates { x [m]; }
    parameters { m [kg] = 1; k [N/m] = 0; x0 [m] = 0; v0 [m/s] = 0; }
    inputs { F [N] = 0; }
    bodies { cart: mass m at [x, 0]; }
    loads { force [F - k*x, 0] at [x, 0]; }
    events { push: ddot(x) = 0; pass: x = 0 rising; }
    initial { x = x0; dot(x) = v0; }
}

fn simulation<M: Compiled>(mechanism: M, settings: &Settings) -> Simulation<M> {
    Simulation::new(mechanism, &declared_start(&mechanism), settings).unwrap()
}

/// Times at which the owner looks that lie inside steps over singular positions cost nothing of what these are good to.
fn check_advances<M: Compiled>(mechanism: M, settings: &Settings, pieces: u32, bound: f64) {
    let mut whole = simulation(mechanism, settings);
    whole.advance_to(settings.end).unwrap();
    let mut advanced = simulation(mechanism, settings);
    for piece in 1..=pieces {
        advanced.advance_to(settings.end * f64::from(piece) / f64::from(pieces)).unwrap();
        // Saved there and restored it goes on alike.
        if piece % 97 == 0 {
            let mut other = simulation(mechanism, settings);
            other.restore(&advanced.save()).unwrap();
            let (mut one, next) = (advanced.clone(), settings.end * (f64::from(piece) + 0.7) / f64::from(pieces));
            one.advance_to(next).unwrap();
            other.advance_to(next).unwrap();
            assert_eq!(one.save(), other.save());
        }
    }
    let [whole, advanced] =
        [&whole, &advanced].map(|simulation| (simulation.state(), simulation.steps().singularities.len()));
    assert_eq!(whole.1, advanced.1, "{settings:?}");
    let pairs = whole.0.positions.iter().zip(advanced.0.positions.iter());
    let off = pairs
        .chain(whole.0.speeds.iter().zip(advanced.0.speeds.iter()))
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max);
    assert!(off < bound, "{off:e} by {settings:?}");
}

#[test]
fn advances_end_inside_steps_over_singular_positions() {
    // Speeds of 10 rad/s over seven crossings at 1e-10; each amplifies what is before it a few times.
    for stabilisation in [Stabilisation::Projection, Stabilisation::MassProjection, Stabilisation::Partitioning] {
        let settings = Settings { stabilisation, ..Settings::new(2.0) };
        check_advances(Parallelogram::default(), &settings, 1000, 1e-6);
    }
    check_advances(ThreeCranks::default(), &Settings::new(2.0), 1000, 1e-6);
    // Other pieces make other steps: an error of order 4 in steps of 0.5 ms.
    check_advances(Parallelogram::default(), &Settings::equal_steps(Method::Rk4, 2.0, 4000), 5000, 1e-6);
}

/// A mechanism at rest, of which nothing tells how long steps may be, gets on all the same.
#[test]
fn a_change_at_rest_late_is_followed_by_steps() {
    let mut cart = simulation(Cart::default(), &Settings::new(1e6));
    for time in [3600.0, 1e5, 9e5] {
        cart.advance_to(time).unwrap();
        cart.set_inputs([Input::Held(1e-9)]).unwrap();
        cart.set_inputs([Input::Held(0.0)]).unwrap();
        cart.advance_to(time + 1e-4).unwrap();
        assert_eq!(cart.state().time, time + 1e-4);
    }
    // 50,000 short advances after long steps are no sign of a motion that does not get on.
    for piece in 1..=50_000 {
        cart.advance_to(9e5 + 1e-4 + 1e-4 * f64::from(piece)).unwrap();
    }
}

/// An event that lies where the owner changes something that it does not depend on happens once.
#[test]
fn a_change_at_the_time_of_an_event_neither_hides_nor_doubles_it() {
    for milliseconds in 1..1000 {
        let time = f64::from(milliseconds) / 1000.0;
        let cart = Cart { x0: -0.7 * time, v0: 0.7, ..Cart::default() };
        let passes = |change: &dyn Fn(&mut Simulation<Cart>)| {
            let mut cart = simulation(cart, &Settings::new(2.0));
            cart.advance_to(time).unwrap();
            change(&mut cart);
            cart.advance_to(2.0).unwrap();
            cart.events().iter().filter(|event| event.name == "pass").count()
        };
        assert_eq!(passes(&|_| {}), 1);
        assert_eq!(passes(&|cart| cart.set_parameter("k", 0.0).unwrap()), 1, "{time}");
        assert_eq!(passes(&|cart| cart.set_parameter("k", 0.01).unwrap()), 1, "{time}");
        assert_eq!(passes(&|cart| cart.set_input("F", Input::Held(0.01)).unwrap()), 1, "{time}");
    }
}

/// A jump over zero is no event, whatever its size, and what comes after it is.
#[test]
fn a_jump_of_an_input_over_zero_is_no_event() {
    for (before, after) in [(-10.0, 1.0), (-1.0, 10.0), (-3.0, 2.0), (-1.0, 1.0), (1.0, -10.0)] {
        let mut cart = simulation(Cart { k: 1.0, ..Cart::default() }, &Settings::new(6.0));
        cart.set_input("F", Input::Held(before)).unwrap();
        cart.advance_to(1.0).unwrap();
        cart.set_input("F", Input::Held(after)).unwrap();
        cart.advance_to(1.5).unwrap();
        let pushes = |cart: &Simulation<Cart>| cart.events().iter().filter(|event| event.name == "push").count();
        assert_eq!(pushes(&cart), 0, "{before} to {after}: {:?}", cart.events());
        // x - F/k swings with period 2 pi: its acceleration is zero twice in that.
        cart.advance_to(6.0).unwrap();
        assert!(pushes(&cart) >= 1 && cart.events().iter().all(|event| event.crossing != Crossing::Touching));
    }
}

/// What a controller sees beside a singular position is what a run has there.
#[test]
fn a_sample_beside_a_singular_position_is_a_row() {
    let mechanism = Parallelogram::default();
    let whole =
        run(mechanism, &declared_start(&mechanism), &Settings { rows: Rows::Steps, ..Settings::new(2.0) }).unwrap();
    let at = whole.steps.singularities[0].time;
    for beside in [-1e-3, -1e-9, 0.0, 1e-9, 1e-4] {
        let mut simulation = simulation(mechanism, &Settings::new(2.0));
        simulation.advance_to(at + beside).unwrap();
        let [crank, coupler, rocker] = simulation.sample().unwrap().accelerations;
        // The branch on which the cranks are parallel: both accelerate alike, and the coupler does not turn.
        assert!((crank - rocker).abs() < 1e-5 && coupler.abs() < 1e-5, "{beside}: {crank} {coupler} {rocker}");
    }
}

/// What is no number is refused, and the simulation goes on as it was; one that has failed says so whatever is asked of it.
#[test]
fn setters_refuse_what_is_no_number() {
    let mut cart = simulation(Cart::default(), &Settings::new(2.0));
    cart.advance_to(0.5).unwrap();
    let before = cart.save();
    for refused in [cart.set_parameters([2.0, f64::NAN, 0.0, 0.0]), cart.set_inputs([Input::Held(f64::INFINITY)])] {
        assert!(matches!(refused.unwrap_err().what, What::NotFinite { .. }));
    }
    assert_eq!(cart.save(), before);
    let mut failing = simulation(BouncingBall::default(), &Settings::new(1e3));
    let failure = failing.advance_to(1e3).unwrap_err();
    assert!(matches!(failure.what, What::Accumulating { .. }), "{failure}");
    assert_eq!(failing.advance_to(0.0), Err(failure.clone()));
    let parameters = failing.mechanism().parameters();
    assert_eq!(failing.set_parameters(parameters), Err(failure));
}

/// Settings that no motion can be made with are refused by name.
#[test]
fn settings_that_are_none_are_refused() {
    let cart = Cart::default();
    let refused = |settings: &Settings| run(cart, &declared_start(&cart), settings).unwrap_err().to_string();
    assert!(refused(&Settings::equal_steps(Method::Rk4, f64::NAN, 10)).contains("cannot end at NaN s"));
    assert!(refused(&Settings::new(f64::NAN)).contains("cannot end at NaN s"));
    assert!(refused(&Settings::equal_steps(Method::Rk4, 1.0, 0)).contains("0 equal steps: give 1 at least"));
    let stop =
        |event: usize, occurrence: usize| Settings { stop: Some(StopAt { event, occurrence }), ..Settings::new(1.0) };
    assert!(refused(&stop(2, 1)).contains("event 2 is to end the motion, and there are 2"));
    assert!(refused(&stop(0, 0)).contains("counted from 1"));
}

/// A controller is asked at the start and after each period but the last, which ends the run.
#[test]
fn a_controller_is_not_asked_at_the_end() {
    let (cart, mut asked) = (CartPole::default(), Vec::new());
    let mut controller = Controller::new(0.25, |sample: &sim::Sample<CartPole>| {
        asked.push(sample.state.time);
        [Input::Held(0.0)]
    });
    run_controlled(cart, &declared_start(&cart), &Settings::new(1.0), controller.as_mut().unwrap()).unwrap();
    drop(controller);
    assert_eq!(asked, [0.0, 0.25, 0.5, 0.75]);
}
