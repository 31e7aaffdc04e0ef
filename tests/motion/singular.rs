//! Singular positions: motions that go straight on through them, against the same linkage in one coordinate, and motions that
//! cannot.

use sim::{Compiled, Method, Rows, Run, Sample, Settings, Stabilisation, What, mechanism};
use std::f64::consts::PI;
use tests::any_model::{AnyModel, run_with};

mechanism! {
    /// A parallelogram, which can change into a crossed linkage in its flat positions.
    pub(crate) Parallelogram;
    coordinates { crank [rad]; coupler [rad]; rocker [rad]; }
    parameters { a [m] = 0.2; b [m] = 0.6; m [kg] = 2; start [rad] = 1; w [rad/s] = 10; g [m/s^2] = 9.81; ripple [N*m] = 0; nu [rad/s] = 300; }
    let A = a*[cos(crank), sin(crank)];
    bodies {
        one: inertia 0.1 [kg*m^2], angle crank;
        two: mass m at A + b/2*[cos(coupler), sin(coupler)], inertia m*b^2/12, angle coupler;
        three: inertia 0.2 [kg*m^2], angle rocker;
    }
    loads { gravity [0, -g]; torque ripple*cos(nu*t) on one; }
    constraints { closure: A + b*[cos(coupler), sin(coupler)] = [b, 0] + a*[cos(rocker), sin(rocker)]; }
    initial { crank = start; dot(crank) = w; guess coupler = 0; guess rocker = start; }
}

mechanism! {
    /// The same with a third crank in the middle of its coupler, which makes one closure redundant in every position.
    pub(crate) ThreeCranks;
    coordinates { crank [rad]; coupler [rad]; rocker [rad]; middle [rad]; }
    parameters { a [m] = 0.2; b [m] = 0.6; m [kg] = 2; start [rad] = 1; w [rad/s] = 10; g [m/s^2] = 9.81; }
    let A = a*[cos(crank), sin(crank)];
    let u = [cos(coupler), sin(coupler)];
    bodies {
        one: inertia 0.1 [kg*m^2], angle crank;
        two: mass m at A + b/2*u, inertia m*b^2/12, angle coupler;
        three: inertia 0.15 [kg*m^2], angle rocker;
        four: inertia 0.05 [kg*m^2], angle middle;
    }
    loads { gravity [0, -g]; }
    constraints {
        closure: A + b*u = [b, 0] + a*[cos(rocker), sin(rocker)];
        closure_in_the_middle: A + b/2*u = [b/2, 0] + a*[cos(middle), sin(middle)];
    }
    initial { crank = start; dot(crank) = w; guess coupler = 0; guess rocker = start; guess middle = start; }
}

mechanism! {
    /// Its coupler does not turn.
    ParallelogramAlone;
    coordinates { crank [rad]; }
    parameters { a [m] = 0.2; m [kg] = 2; start [rad] = 1; w [rad/s] = 10; g [m/s^2] = 9.81; ripple [N*m] = 0; nu [rad/s] = 300; }
    bodies { two: mass m at a*[cos(crank), sin(crank)]; cranks: inertia 0.3 [kg*m^2], angle crank; }
    loads { gravity [0, -g]; torque ripple*cos(nu*t) on cranks; }
    initial { crank = start; dot(crank) = w; }
}

mechanism! {
    /// A slider-crank with a rod as long as its crank: the slider passes the crank's pivot, where it could stay.
    Isosceles;
    coordinates { crank [rad]; rod [rad]; x [m]; }
    parameters { a [m] = 0.3; g [m/s^2] = 9.81; w [rad/s] = 12; }
    let A = a*[cos(crank), sin(crank)];
    let B = A + a*[cos(rod), -sin(rod)];
    bodies {
        one: mass 1 [kg] at A/2, inertia 0.02 [kg*m^2], angle crank;
        two: mass 0.7 [kg] at (A + B)/2, inertia 0.01 [kg*m^2], angle rod;
        slider: mass 0.4 [kg] at [x, 0];
    }
    loads { gravity [0, -g]; }
    constraints { pin: B = [x, 0]; }
    initial { crank = 0.3; dot(crank) = w; guess rod = 0.3; guess x = 0.55; }
}

mechanism! {
    /// Its rod turns as its crank does.
    IsoscelesAlone;
    coordinates { crank [rad]; }
    parameters { a [m] = 0.3; g [m/s^2] = 9.81; w [rad/s] = 12; }
    let A = a*[cos(crank), sin(crank)];
    let B = [2*a*cos(crank), 0];
    bodies {
        one: mass 1 [kg] at A/2, inertia 0.02 [kg*m^2], angle crank;
        two: mass 0.7 [kg] at (A + B)/2, inertia 0.01 [kg*m^2], angle crank;
        slider: mass 0.4 [kg] at B;
    }
    loads { gravity [0, -g]; }
    initial { crank = 0.3; dot(crank) = w; }
}

mechanism! {
    /// A crank whose pin slides in a link and passes the link's pivot, where the link is free: its row of C_q vanishes.
    Slotted;
    coordinates { crank [rad]; link [rad]; }
    parameters { r [m] = 0.3; g [m/s^2] = 9.81; w [rad/s] = 9; }
    let A = [0, r] + r*[cos(crank), sin(crank)];
    bodies {
        one: mass 1 [kg] at [0, r] + r/2*[cos(crank), sin(crank)], inertia 0.02 [kg*m^2], angle crank;
        two: mass 0.7 [kg] at 0.4 [m]*[cos(link), sin(link)], inertia 0.05 [kg*m^2], angle link;
    }
    loads { gravity [0, -g]; }
    constraints { slot: A.y*cos(link) = A.x*sin(link); }
    initial { crank = 0; dot(crank) = w; guess link = 0.78; }
}

mechanism! {
    /// Its link turns half as fast as its crank.
    SlottedAlone;
    coordinates { crank [rad]; }
    parameters { r [m] = 0.3; g [m/s^2] = 9.81; w [rad/s] = 9; }
    let link = crank/2 + pi/4;
    bodies {
        one: mass 1 [kg] at [0, r] + r/2*[cos(crank), sin(crank)], inertia 0.02 [kg*m^2], angle crank;
        two: mass 0.7 [kg] at 0.4 [m]*[cos(link), sin(link)], inertia 0.05 [kg*m^2], angle link;
    }
    loads { gravity [0, -g]; }
    initial { crank = 0; dot(crank) = w; }
}

mechanism! {
    /// A bead on a rail that ends in a cusp, where it can only turn back.
    Cusp;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; v [m/s] = -1; }
    bodies { bead: mass m at [x, y]; }
    constraints { rail: y^2 = x^3/(1 [m]); }
    initial { x = 0.5; dot(x) = v; guess y = 0.35; }
}

/// The largest difference of the first coordinate and its speed, relative to the largest of each.
fn difference(one: &Run<AnyModel>, other: &Run<AnyModel>) -> f64 {
    assert_eq!((&one.trajectory.failure, &other.trajectory.failure), (&None, &None));
    assert_eq!(one.trajectory.samples.len(), other.trajectory.samples.len());
    let pairs = || one.trajectory.samples.iter().zip(&other.trajectory.samples);
    let largest = |f: &dyn Fn(&Sample<AnyModel>, &Sample<AnyModel>) -> f64| {
        pairs().fold(0.0f64, |largest, (a, b)| largest.max(f(a, b).abs()))
    };
    let positions = largest(&|a, b| a.state.positions.as_ref()[0] - b.state.positions.as_ref()[0])
        / largest(&|a, _| a.state.positions.as_ref()[0]);
    let speeds = largest(&|a, b| a.state.speeds.as_ref()[0] - b.state.speeds.as_ref()[0])
        / largest(&|a, _| a.state.speeds.as_ref()[0]);
    positions.max(speeds)
}

/// The motion is that of the linkage alone, and every singular position on the way is reported, with its constraint.
fn check<M: Compiled, N: Compiled>(mechanism: M, alone: N, constraint: &str, angles: impl Fn(usize) -> f64) {
    let end = 3.0;
    let even = |settings: Settings| Settings { rows: Rows::Even(300), ..settings };
    let exact = run_with(alone, &even(Settings::adaptive(Method::Dop853, end, 1e-13))).unwrap();
    let adaptive = |method, rtol, bound| (even(Settings::adaptive(method, end, rtol)), bound);
    let mut all = vec![
        adaptive(Method::Dop853, 1e-12, 1e-9),
        adaptive(Method::Dop853, 1e-10, 1e-8),
        adaptive(Method::Dop853, 1e-6, 1e-3),
        adaptive(Method::Dopri5, 1e-8, 1e-5),
        adaptive(Method::Radau5, 1e-8, 1e-6),
    ];
    // What RK4 itself loses in 8192 steps of the slider is 1.1e-9.
    for steps in [10_000, 40_000] {
        all.push((even(Settings::equal_steps(Method::Rk4, end, steps)), 1e-9));
    }
    for stabilisation in [Stabilisation::MassProjection, Stabilisation::Partitioning] {
        all.push((Settings { stabilisation, ..even(Settings::adaptive(Method::Dop853, end, 1e-12)) }, 1e-9));
    }
    for (settings, bound) in all {
        let run = run_with(mechanism, &settings).unwrap();
        let found = difference(&run, &exact);
        let passed = &run.steps.singularities;
        let name = M::DESCRIPTION.name;
        println!(
            "{name:<14} {:<7} {:?} {}: {found:.1e}, {} singular positions",
            settings.method.name(),
            settings.stepping,
            settings.stabilisation,
            passed.len()
        );
        assert!(found < bound, "{found:e}");
        // Those that the crank's angle has passed.
        let last = exact.trajectory.samples.last().unwrap().state.positions.as_ref()[0];
        assert_eq!(passed.len(), (0..).take_while(|i| angles(*i) < last).count());
        for (i, singularity) in passed.iter().enumerate() {
            assert!(singularity.constraint.starts_with(constraint) && singularity.sine < 1e-6, "{singularity:?}");
            // The time is as exact as the motion.
            let near = exact.trajectory.samples.iter().min_by(|a, b| {
                let far = |s: &Sample<AnyModel>| (s.state.time - singularity.time).abs();
                far(a).total_cmp(&far(b))
            });
            let near = near.unwrap();
            let h = singularity.time - near.state.time;
            let (q, v, a) =
                (near.state.positions.as_ref()[0], near.state.speeds.as_ref()[0], near.accelerations.as_ref()[0]);
            // Within 5 ms of a sample; what Taylor's polynomial leaves out is 1e-8 times a rate of acceleration.
            assert!((q + h * (v + h / 2.0 * a) - angles(i)).abs() < 1e-4, "{singularity:?}");
        }
    }
}

#[test]
fn a_parallelogram_passes_its_flat_positions() {
    check(Parallelogram::default(), ParallelogramAlone::default(), "closure", |i| PI * (i + 1) as f64);
}

/// With a redundant closure a position counts as singular beside the most regular one, as sines of combinations have no size.
#[test]
fn three_cranks_pass_their_flat_positions() {
    let even = |method, rtol| Settings { rows: Rows::Even(300), ..Settings::adaptive(method, 3.0, rtol) };
    let exact = run_with(ParallelogramAlone::default(), &even(Method::Dop853, 1e-13)).unwrap();
    let turns = exact.trajectory.samples.last().unwrap().state.positions[0] / PI;
    for (method, rtol, bound) in [(Method::Dop853, 1e-10, 1e-8), (Method::Radau5, 1e-8, 1e-6)] {
        let run = run_with(ThreeCranks::default(), &even(method, rtol)).unwrap();
        let (found, passed) = (difference(&run, &exact), run.steps.singularities.len());
        println!("{:<7} {found:.1e}, {passed} singular positions", method.name());
        assert!(found < bound && passed == turns.floor() as usize, "{found:e} {passed}");
    }
}

#[test]
fn a_slider_passes_the_pivot_of_its_crank() {
    check(Isosceles::default(), IsoscelesAlone::default(), "pin", |i| PI * (i as f64 + 0.5));
}

#[test]
fn a_pin_passes_the_pivot_of_its_link() {
    check(Slotted::default(), SlottedAlone::default(), "slot", |i| PI * (2.0 * i as f64 + 1.5));
}

/// Without loads a parallelogram turns evenly, and steps would end in its flat position.
#[test]
fn steps_do_not_end_where_the_motion_is_not_determined() {
    let flat = (PI - 1.0) / 10.0;
    for method in Method::ALL {
        let settings = Settings { rows: Rows::Even(20), ..Settings::equal_steps(method, 2.0 * flat, 64) };
        let run = run_with(Parallelogram { g: 0.0, ..Default::default() }, &settings).unwrap();
        assert_eq!((&run.trajectory.failure, run.steps.singularities.len()), (&None, 1));
        assert!((run.steps.singularities[0].time - flat).abs() < 1e-9);
        let (mut worst, mut acceleration) = (0.0f64, 0.0f64);
        for sample in &run.trajectory.samples {
            let crank = 1.0 + 10.0 * sample.state.time;
            let pairs = sample.state.positions.as_ref().iter().zip([crank, 0.0, crank]);
            worst = pairs.fold(worst, |worst, (a, b)| worst.max((a - b).abs()));
            acceleration = sample.accelerations.as_ref().iter().fold(acceleration, |worst, a| worst.max(a.abs()));
        }
        println!("{:<7} {worst:.1e}, accelerations {acceleration:.1e}", method.name());
        // In the flat position accelerations follow from those around it.
        assert!(worst < 1e-9 && acceleration < 1e-6, "{}: {worst:e} {acceleration:e}", method.name());
    }
}

/// The largest difference of a parallelogram's accelerations from those of its crank alone, relative to the largest of these.
fn accelerations_off(settings: &Settings, start: f64, ripple: f64) -> f64 {
    let run = run_with(Parallelogram { start, ripple, ..Default::default() }, settings).unwrap();
    let exact = Settings { rows: settings.rows, ..Settings::adaptive(Method::Dop853, settings.end, 1e-13) };
    let alone = run_with(ParallelogramAlone { start, ripple, ..Default::default() }, &exact).unwrap();
    assert_eq!((&run.trajectory.failure, run.trajectory.samples.len()), (&None, alone.trajectory.samples.len()));
    let (mut worst, mut largest) = (0.0f64, 0.0f64);
    for (sample, alone) in run.trajectory.samples.iter().zip(&alone.trajectory.samples) {
        let expected = [alone.accelerations[0], 0.0, alone.accelerations[0]];
        worst =
            sample.accelerations.as_ref().iter().zip(expected).fold(worst, |worst, (a, b)| worst.max((a - b).abs()));
        largest = largest.max(alone.accelerations[0].abs());
    }
    worst / largest
}

/// What is known from one side of a flat position alone, at the end of a run or at its start, would be known badly.
#[test]
fn runs_end_and_begin_beside_singular_positions() {
    let long = Settings::adaptive(Method::Dop853, 0.5, 1e-12);
    let flat = run_with(Parallelogram::default(), &long).unwrap().steps.singularities[0].time;
    let mut worst = [0.0f64; 2];
    for method in [Method::Dop853, Method::Dopri5] {
        for stabilisation in [Stabilisation::Projection, Stabilisation::MassProjection, Stabilisation::Partitioning] {
            for aside in [-1e-1, -1e-2, -1e-3, 1e-2, 1e-1] {
                let rows = Rows::Even(50);
                let until = |end: f64| Settings { stabilisation, rows, ..Settings::adaptive(method, end, 1e-11) };
                worst[0] = worst[0].max(accelerations_off(&until(flat + aside / 100.0), 1.0, 0.0));
                worst[1] = worst[1].max(accelerations_off(&until(0.1), PI + aside, 0.0));
            }
        }
    }
    println!("at the end {:.1e}, at the start {:.1e}", worst[0], worst[1]);
    // A hundred times the tolerance.
    assert!(worst[0] < 1e-9 && worst[1] < 1e-9, "{worst:?}");
}

/// A load that changes fast is not smooth around a singular position: what lies there tells nothing of the accelerations at it.
#[test]
fn accelerations_beside_singular_positions_follow_a_load_that_changes_fast() {
    for aside in [-0.08, -0.02, 0.02, 0.08] {
        let settings = Settings { rows: Rows::Even(500), ..Settings::adaptive(Method::Dop853, 0.5, 1e-11) };
        let off = accelerations_off(&settings, PI + aside, 30.0);
        println!("{aside} rad beside a flat position at the start: {off:.1e}");
        // Rounding of 1e-16 over the cube of a sine of 5e-4.
        assert!(off < 1e-6, "{off:e}");
    }
}

/// A bead cannot go on beyond a cusp: the run ends there, says why, and keeps what it has.
#[test]
fn a_cusp_ends_the_run_with_an_explanation() {
    for settings in [Settings::new(2.0), Settings::equal_steps(Method::Rk4, 2.0, 1000)] {
        let run = run_with(Cusp::default(), &settings).unwrap();
        let failure = run.trajectory.failure.unwrap();
        println!("{failure}");
        assert_eq!(failure.what, What::SingularPosition { constraint: "rail" });
        let last = run.trajectory.samples.last().unwrap().state.clone();
        assert!(run.trajectory.samples.len() > 150 && last.positions[0] < 0.05 && run.steps.singularities.is_empty());
    }
}

/// In each row the pins give the coupler its acceleration, also where they have a pole: in the flat positions of a parallelogram the
/// forces along it grow as the weight over the angle.
#[test]
fn reactions_at_flat_positions_belong_to_the_accelerations_of_their_row() {
    let text = "pub Parallelogram; coordinates { x [m]; y [m]; th [rad]; a [rad]; b [rad]; }
        parameters { r [m] = 0.1; l [m] = 0.3; m [kg] = 1; J [kg*m^2] = 0.01; }
        bodies { co: mass m at [x, y], inertia J, angle th; ca: inertia J, angle a; cb: inertia J, angle b; }
        loads { gravity [0, -9.81 [m/s^2]]; }
        constraints { A: r*[cos(a), sin(a)] + [-l, 0] = on(co, [-l, 0]); B: r*[cos(b), sin(b)] = on(co, [0, 0]); }
        initial { a = 1; guess b = 1; guess x = 0; guess y = 0.1; }";
    let settings = Settings { rows: Rows::Even(20_000), ..Settings::adaptive(Method::Dop853, 20.0, 1e-10) };
    let run = tests::run_with(tests::any_model::interpreted(text).unwrap(), &settings).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let mut largest = 0.0f64;
    for sample in &run.trajectory.samples {
        let [ax, ay, bx, by] = [0, 1, 2, 3].map(|row| sample.multipliers[row]);
        let off = (sample.accelerations[0] - ax - bx).abs() + (sample.accelerations[1] + 9.81 - ay - by).abs();
        largest = largest.max(ax.abs());
        // Rounding of the largest of them.
        assert!(off < 1e-7, "{}: {off:e}", sample.state.time);
    }
    assert!(largest > 1e3, "{largest}");
}
