//! Forward sensitivities against closed forms and against differences of whole runs.

use crate::{Rods, Turning};
use models::{Bennett, BouncingBall, FourBar, QuickReturn};
use sim::{
    Array, Compiled, Direction, Dual, Erased, ForwardSensitivity, InPlace, Mechanism, Method, Settings, Simulation,
    Stabilisation, What, declared_start, erase,
};
use tests::engine::Engine;

/// A mechanism without its type: loops for it are compiled once.
pub(crate) fn erased(mechanism: impl Compiled) -> Erased<InPlace<8>> {
    Erased::new(erase(mechanism)).unwrap()
}

sim::mechanism! {
    /// A mass on a spring.
    Oscillator;
    coordinates { x [m]; }
    parameters { m [kg] = 2; k [N/m] = 18; }
    bodies { mass: mass m at [x, 0]; }
    loads { force [-k*x, 0] at [x, 0]; }
    initial { x = 0.4; dot(x) = 0; }
}

/// The direction of one parameter, and of these given values.
pub(crate) fn direction<M: Mechanism>(mechanism: &M, parameter: Option<usize>, speed: Option<usize>) -> Direction<M> {
    let unit = |chosen: Option<usize>, i: usize| f64::from(u8::from(chosen == Some(i)));
    let start = declared_start(mechanism);
    Direction {
        parameters: mechanism.parameters().like(|p| unit(parameter, p)),
        positions: start.positions.like(|_| 0.0),
        speeds: start.speeds.like(|i| unit(speed, i)),
    }
}

/// x = x0 cos(w t) with w = sqrt(k/m): its derivatives by stiffness and by the start.
#[test]
fn an_oscillator_has_the_derivatives_of_its_solution() {
    let oscillator = erased(Oscillator::default());
    let (start, settings) = (declared_start(&oscillator), Settings::new(2.0));
    let derivative = |direction: &Direction<_>| {
        let mut motion = ForwardSensitivity::new(oscillator.clone(), &start, &settings, direction).unwrap();
        motion.advance_to(2.0).unwrap();
        motion.state().positions[0].derivative
    };
    let (w, t, x0) = (3.0f64, 2.0, 0.4);
    // Errors of 1e-10 a step, of which there are some tens.
    let by_stiffness = derivative(&direction(&oscillator, Some(1), None));
    assert!((by_stiffness + x0 * t * (w * t).sin() / (2.0 * w * 2.0)).abs() < 1e-9, "{by_stiffness}");
    let still = direction(&oscillator, None, None);
    let by_position = derivative(&Direction { positions: start.positions.like(|_| 1.0), ..still });
    assert!((by_position - (w * t).cos()).abs() < 1e-9, "{by_position}");
    let by_speed = derivative(&direction(&oscillator, None, Some(0)));
    assert!((by_speed - (w * t).sin() / w).abs() < 1e-9, "{by_speed}");
}

/// Compares the derivative of a state with central differences of runs, whose starts are assembled anew.
pub(crate) fn check<M: Mechanism>(
    mechanism: &M,
    parameter: Option<usize>,
    speed: Option<usize>,
    settings: &Settings,
    bound: f64,
) {
    let direction = direction(mechanism, parameter, speed);
    let start = declared_start(mechanism);
    let mut motion = ForwardSensitivity::new(mechanism.clone(), &start, settings, &direction).unwrap();
    motion.advance_to(0.37 * settings.end).unwrap();
    motion.advance_to(settings.end).unwrap();
    let step = 1e-5;
    let moved = |sign: f64| {
        let parameters = mechanism.parameters();
        let other =
            mechanism.with_parameters(parameters.like(|p| parameters[p] + sign * step * direction.parameters[p]));
        let mut start = start.clone();
        start.speeds = start.speeds.like(|i| start.speeds[i] + sign * step * direction.speeds[i]);
        let mut simulation = Simulation::new(other, &start, settings).unwrap();
        simulation.advance_to(0.37 * settings.end).unwrap();
        simulation.advance_to(settings.end).unwrap();
        simulation.state().clone()
    };
    let [more, less] = [moved(1.0), moved(-1.0)];
    let difference = |more: f64, less: f64| (more - less) / (2.0 * step);
    let found = motion.state();
    for i in 0..mechanism.n() {
        let pairs = [
            (found.positions[i], difference(more.positions[i], less.positions[i])),
            (found.speeds[i], difference(more.speeds[i], less.speeds[i])),
        ];
        for (dual, expected) in pairs {
            let size = 1.0f64.max(expected.abs());
            assert!((dual.derivative - expected).abs() < bound * size, "{i}: {} {expected}", dual.derivative);
        }
    }
    let expected = difference(more.work, less.work);
    assert!((found.work.derivative - expected).abs() < bound * expected.abs().max(1.0), "work");
    // The motion is that of the simulation alone, to its bits.
    let alone = moved(0.0);
    assert_eq!(found.positions.iter().map(|dual| dual.value).collect::<Vec<_>>(), alone.positions.as_ref());
}

/// With equal steps differences are those of the same discrete motion: their errors are of second order in 1e-5, times
/// third derivatives of up to 1e3, and rounding of 1e-13 over 1e-5.
#[test]
fn loops_have_the_derivatives_that_differences_have() {
    for method in [Method::Euler, Method::Heun, Method::Rk3, Method::Rk4, Method::Dopri5, Method::Dop853] {
        let settings = Settings::equal_steps(method, 0.5, 200);
        // The length of the crank, and its speed.
        check(&QuickReturn::default(), Some(0), None, &settings, 1e-6);
        check(&QuickReturn::default(), None, Some(0), &settings, 1e-6);
    }
    check(&FourBar::default(), Some(1), None, &Settings::equal_steps(Method::Rk4, 0.5, 200), 1e-6);
}

#[test]
fn sparse_rows_have_derivatives_too() {
    let rods = Rods::default();
    assert!(!rods.description().sparsity.is_empty());
    check(&rods, Some(1), None, &Settings::equal_steps(Method::Rk4, 0.3, 100), 1e-6);
    let engine = Engine::default();
    assert_eq!(engine.description().common_column, Some(0));
    check(&engine, Some(1), None, &Settings::equal_steps(Method::Rk4, 0.3, 100), 1e-6);
}

/// Steps of other lengths make differences of the order of the tolerance over 1e-5.
#[test]
fn adaptive_steps_have_derivatives_too() {
    check(&QuickReturn::default(), Some(0), None, &Settings::adaptive(Method::Dop853, 0.5, 1e-12), 1e-5);
    check(&QuickReturn::default(), Some(0), None, &Settings::adaptive(Method::Dopri5, 0.5, 1e-11), 1e-4);
}

#[test]
fn erased_mechanisms_have_the_same_derivatives() {
    check(&erased(QuickReturn::default()), Some(0), None, &Settings::equal_steps(Method::Rk4, 0.5, 200), 1e-6);
}

/// Why a motion has no derivative step by step.
pub(crate) fn refusal<M: Mechanism>(mechanism: M, settings: &Settings) -> &'static str {
    let start = declared_start(&mechanism);
    let direction = Direction {
        parameters: mechanism.parameters().like(|_| 1.0),
        positions: start.positions.like(|_| 0.0),
        speeds: start.speeds.like(|_| 0.0),
    };
    let made = ForwardSensitivity::new(mechanism, &start, settings, &direction);
    let failure = made.and_then(|mut motion| motion.advance_to(settings.end)).unwrap_err();
    match failure.what {
        What::NotDifferentiable { why } => why,
        other => panic!("{other}"),
    }
}

#[test]
fn what_has_no_derivative_is_refused_by_name() {
    let settings = Settings::new(1.0);
    assert!(refusal(QuickReturn::default(), &Settings::adaptive(Method::Radau5, 1.0, 1e-8)).contains("implicit"));
    let partitioned = Settings { stabilisation: Stabilisation::Partitioning, ..settings };
    assert!(refusal(QuickReturn::default(), &partitioned).contains("projection"));
    assert!(refusal(Bennett::default(), &settings).contains("redundant"));
    assert!(refusal(Turning::default(), &settings).contains("generalised speeds"));
    assert!(refusal(BouncingBall::default(), &settings).contains("event"));
}

#[test]
fn a_direction_without_numbers_is_refused() {
    let mechanism = QuickReturn::default();
    let direction = Direction { speeds: [f64::NAN, 0.0, 0.0], ..direction(&mechanism, None, None) };
    let made = ForwardSensitivity::new(mechanism, &declared_start(&mechanism), &Settings::new(1.0), &direction);
    assert!(matches!(made.unwrap_err().what, What::Unusable { .. }));
}

/// Dual numbers of the state are consistent: positions stay on the constraints with their derivatives.
#[test]
fn derivatives_stay_on_the_constraints() {
    let mechanism = QuickReturn::default();
    let direction = direction(&mechanism, Some(0), None);
    let settings = Settings::new(1.0);
    let mut motion = ForwardSensitivity::new(mechanism, &declared_start(&mechanism), &settings, &direction).unwrap();
    motion.advance_to(1.0).unwrap();
    let lifted = mechanism.on(Dual::constant);
    let mut parameters = lifted.parameters();
    parameters[0].derivative = 1.0;
    let state = motion.state();
    let residual = lifted.with_parameters(parameters).constraints(state.time, &state.positions);
    // The projection leaves second-order residuals of corrections of about 1e-10.
    assert!(residual.iter().all(|value| value.derivative.abs() < 1e-12), "{residual:?}");
}
