//! Inputs: declared courses, values that are held, and controllers, against closed forms.

use sim::{
    Controller, Input, Mechanism, Method, Rows, Run, Sample, Settings, Stepping, declared_start, mechanism,
    run_controlled,
};
use tests::any_model::{AnyModel, run_with};

mechanism! {
    /// A disc that a motor turns.
    Motor;
    coordinates { phi [rad]; }
    parameters { J [kg*m^2] = 0.5; w [1/s] = 3; size [N*m] = 2; }
    inputs { tau [N*m] = size*cos(w*t); }
    bodies { disc: inertia J, angle phi; }
    loads { torque tau on disc; }
    initial { dot(phi) = 1; }
    outputs { torque [N*m] = tau; speed [rad/s] = dot(phi); }
}

/// Runs are at a relative tolerance of 1e-11, and values below 10.
const TOLERANCE: f64 = 1e-9;

fn settings(end: f64) -> Settings {
    Settings { rows: Rows::Even(100), ..Settings::adaptive(Method::Dop853, end, 1e-11) }
}

/// The largest difference of the angle from its closed form.
fn error(run: &Run<AnyModel>, exact: impl Fn(f64) -> f64) -> f64 {
    assert_eq!(run.trajectory.failure, None);
    let samples = run.trajectory.samples.iter();
    samples.map(|s| (s.state.positions[0] - exact(s.state.time)).abs()).fold(0.0, f64::max)
}

#[test]
fn an_input_follows_its_course_until_it_is_held() {
    let followed = run_with(Motor::default(), &settings(4.0)).unwrap();
    let Motor { J, w, size, .. } = Motor::<f64>::default();
    assert!(error(&followed, |t| t + size / (J * w * w) * (1.0 - (w * t).cos())) < TOLERANCE);
    let held = run_with(Motor { tau: Input::Held(0.3), ..Motor::default() }, &settings(4.0)).unwrap();
    assert!(error(&held, |t| t + 0.3 / J * t * t / 2.0) < TOLERANCE);
    for run in [&followed, &held] {
        assert!(run.energy_balance < TOLERANCE);
    }
}

/// Setting an input needs no preparation: the kernels of what is prepared give the bits of a mechanism with it.
#[test]
fn an_input_is_set_without_preparing_again() {
    let mut prepared = Motor::<f64>::default().prepare();
    for tau in [0.7, -0.2] {
        Motor::set_inputs(&mut prepared, [tau.into()]);
        let found = prepared.dynamics(0.4, &[0.1], &[2.0]).accelerations[0];
        let whole = Motor { tau: tau.into(), ..Motor::default() }.dynamics(0.4, &[0.1], &[2.0]).accelerations[0];
        assert_eq!(found.to_bits(), whole.to_bits());
        assert!((found - tau / 0.5).abs() < 1e-15);
    }
}

/// A sampled controller brakes: tau = -k phi' at the samples makes of each period a step by 1 - k T/J of the speed.
#[test]
fn a_controller_is_a_zero_order_hold() {
    let (k, period) = (2.0, 0.1);
    let law = |sample: &Sample<Motor>| [Input::Held(-k * sample.state.speeds[0])];
    for settings in [settings(3.0), Settings { rows: Rows::Even(100), ..Settings::equal_steps(Method::Rk4, 3.0, 90) }] {
        let mut controller = Controller::new(period, law).unwrap();
        let mechanism = Motor::default();
        let start = declared_start(&mechanism);
        let run = run_controlled(mechanism, &start, &settings, &mut controller).unwrap();
        assert_eq!(run.trajectory.failure, None);
        assert_eq!(run.trajectory.samples.len(), 101);
        let factor: f64 = 1.0 - k * period / 0.5;
        for sample in &run.trajectory.samples {
            let t = sample.state.time;
            let whole = (t / period + 1e-9).floor();
            let (before, inside) = (factor.powf(whole), t - whole * period);
            let exact = before * (1.0 - k / 0.5 * inside);
            assert!((sample.state.speeds[0] - exact).abs() < TOLERANCE, "{t}: {} {exact}", sample.state.speeds[0]);
        }
        // A row has the input that led to it: the hold of the period that ends there.
        let last = run.trajectory.samples.last().unwrap();
        assert!((last.inputs[0].held().unwrap() + k * factor.powf(29.0)).abs() < TOLERANCE);
        assert!(run.energy_balance < TOLERANCE);
        // Three in each period: as many as without a controller.
        if let Stepping::Equal(count) = settings.stepping {
            assert_eq!(run.steps.accepted, count as u64);
        }
    }
    assert!(Controller::<Motor>::new(0.0, law).is_none() && Controller::<Motor>::new(f64::NAN, law).is_none());
}

/// A linear feedback that is sampled often enough approaches the continuous one, in the first order of the period.
#[test]
fn sampling_is_of_first_order() {
    let error = |period: f64| {
        let mut controller = Controller::new(period, |s: &Sample<Motor>| [Input::Held(-s.state.speeds[0])]).unwrap();
        let mechanism = Motor::default();
        let start = declared_start(&mechanism);
        let run = run_controlled(mechanism, &start, &settings(1.0), &mut controller).unwrap();
        run.trajectory.samples.last().unwrap().state.speeds[0] - (-2.0f64).exp()
    };
    let ratio = error(0.02) / error(0.01);
    assert!((ratio - 2.0).abs() < 0.05, "{ratio}");
}
