//! Mechanisms driven through a range, against their geometry.

use models::{FourBar, QuickReturn, SliderCrank};
use sim::{Compiled, Driven, Kinematics, Mechanism, Sweep, declared_start, kinematics, mechanism};
use std::f64::consts::{PI, TAU};
use tests::any_model::interpreted;

/// Drives a coordinate or output from the declared start.
pub(crate) fn driven<M: Compiled>(
    mechanism: M,
    name: &str,
    [from, to]: [f64; 2],
    speed: f64,
    steps: usize,
) -> Kinematics<M> {
    kinematics(mechanism, &declared_start(&mechanism), &sweep::<M>(name, [from, to], speed, steps)).unwrap()
}

pub(crate) fn sweep<M: Compiled>(name: &str, [from, to]: [f64; 2], speed: f64, steps: usize) -> Sweep {
    Sweep { driven: Driven::find(&M::DESCRIPTION, name).unwrap(), from, to, speed, steps, held: Vec::new() }
}

/// The place of an output.
pub(crate) fn output<M: Compiled>(name: &str) -> usize {
    M::DESCRIPTION.outputs.iter().position(|output| output.name == name).unwrap()
}

/// |sin(theta3 - theta4)| is the sine of the transmission angle between coupler and rocker.
#[test]
fn the_transmission_index_of_a_four_bar_is_the_sine_of_its_transmission_angle() {
    let found = driven(FourBar::default(), "theta2", [0.0, TAU], 10.0, 360);
    for (sample, index) in found.trajectory.samples.iter().zip(&found.transmission) {
        let [_, coupler, rocker] = sample.state.positions;
        assert!((index - (coupler - rocker).sin().abs()).abs() < 1e-12);
    }
    // Worst where crank and ground link are aligned: cos mu = (b^2 + c^2 - (d - a)^2) / (2 b c), which is 3/4.
    let least = found.extremes.transmission.unwrap().least;
    assert!((least.value - (7f64 / 16.0).sqrt()).abs() < 1e-12 && least.at.sin().abs() < 1e-7, "{least:?}");
}

/// Virtual work: the torque that holds the crank balances the force on the slider by their ratio, and gravity by the slope of
/// its potential; so does the limit of ever slower sweeps.
#[test]
fn a_mechanism_at_rest_is_held_by_static_forces() {
    let quick = QuickReturn::default();
    let found = driven(quick, "alpha", [0.0, TAU], 0.0, 72);
    let (x6, force) = (output::<QuickReturn>("x6"), quick.F);
    let rated = quick.description().rated_outputs.iter().position(|rated| *rated == x6).unwrap();
    let moving = driven(quick, "alpha", [0.0, TAU], 3.0, 72);
    for (k, sample) in found.trajectory.samples.iter().enumerate() {
        assert!(sample.state.time == 0.0 && sample.state.speeds == [0.0; 3] && sample.accelerations == [0.0; 3]);
        assert_eq!(found.values[k], sample.state.positions[0]);
        let (torque, ratio) = (found.forces[0][k], found.ratios[k][rated]);
        // Rounding of torques of some hundred newton metres.
        assert!((torque + force * ratio).abs() < 1e-10, "{k}: {torque} {ratio}");
        assert!((ratio - moving.ratios[k][rated]).abs() < 1e-13);
        assert!((sample.state.positions[1] - moving.trajectory.samples[k].state.positions[1]).abs() < 1e-14);
    }
    let four_bar = FourBar::default();
    let speed = [2.0, 1.0, 0.0].map(|speed| driven(four_bar, "theta2", [0.0, TAU], speed, 36).forces[0].clone());
    for ((fast, slow), rest) in speed[0].iter().zip(&speed[1]).zip(&speed[2]) {
        // Forces of inertia grow with the square of the speed.
        assert!((rest - (4.0 * slow - fast) / 3.0).abs() < 1e-11, "{rest} {slow} {fast}");
    }
    assert!(speed[2].iter().any(|torque| torque.abs() > 0.1));
}

mechanism! {
    /// An arm on a moving support, tied to a slide that another support moves.
    pub Carried;
    coordinates { phi [rad]; x [m]; }
    parameters { m [kg] = 2; l [m] = 0.5; a [m] = 0.1; k [N/m] = 30; c [N*s/m] = 0; }
    let pivot = [a*cos(7 [rad/s]*t + 0.4), 0];
    let tip = pivot + l*[cos(phi), sin(phi)];
    bodies { bob: mass m at tip; slide: mass m at [x, -1 [m]]; }
    loads { gravity [0, -9.81 [m/s^2]]; spring k, length 0 from [x, -1 [m]] to tip; damper c from [x, -1 [m]] to tip; }
    constraints { led: x = a*sin(5 [rad/s]*t + 0.3); }
    outputs { along [m] = tip.x; }
    initial { phi = 0; }
}

/// Virtual work about a support that stands where it is at time 0: m g l cos(phi) + k l (sin phi (x - x_p) + cos phi), as
/// the spring's two ends are (x_p + l cos phi - x, 1 + l sin phi) apart.
#[test]
fn nothing_moves_with_time_in_a_sweep_at_rest() {
    let arm = Carried::default();
    let found = driven(arm, "phi", [0.0, TAU], 0.0, 36);
    let (pivot, slide) = (arm.a * 0.4f64.cos(), arm.a * 0.3f64.sin());
    for (k, sample) in found.trajectory.samples.iter().enumerate() {
        let (sine, cosine) = found.values[k].sin_cos();
        let torque = arm.m * 9.81 * arm.l * cosine + arm.k * arm.l * (sine * (slide - pivot) + cosine);
        let stretch = pivot + arm.l * cosine - slide;
        // Rounding of 25 N*m.
        assert!((found.forces[0][k] - torque).abs() < 1e-13, "{k}: {} {torque}", found.forces[0][k]);
        // The constraint does the virtual work -lambda dx.
        assert!((sample.multipliers[0] - arm.k * stretch).abs() < 1e-13, "{k}: {}", sample.multipliers[0]);
        assert!((found.ratios[k][0] + arm.l * sine).abs() < 1e-15, "{k}: {}", found.ratios[k][0]);
        assert!(sample.state.speeds == [0.0; 2] && sample.state.work == 0.0 && sample.power == 0.0);
    }
}

mechanism! {
    /// The same arm with an output that has the speed of its support.
    pub Watched;
    coordinates { phi [rad]; }
    parameters { m [kg] = 2; l [m] = 0.5; }
    let tip = [sin(3 [rad/s]*t)*l + l*cos(phi), l*sin(phi)];
    bodies { bob: mass m at tip; }
    outputs { speed [m/s] = dot(tip.x); }
    initial { phi = 0; }
}

/// A damper to a moving support pulls while the rest of the mechanism rests; the kernels do not tell its force from a load that is
/// written in t. So does a speed in an output.
#[test]
fn what_may_feel_a_motion_by_time_does_not_rest() {
    let damped = Carried { c: 0.1, ..Carried::default() };
    let at = |mechanism: &Carried, speed: f64| {
        kinematics(*mechanism, &declared_start(mechanism), &sweep::<Carried>("phi", [0.0, 1.0], speed, 4))
    };
    let named = |failure: sim::Failure| match failure.what {
        sim::What::MovedByTime { what } => what,
        what => panic!("{what}"),
    };
    assert_eq!(named(at(&damped, 0.0).unwrap_err()), "the load along `phi`");
    assert!(at(&damped, 1.0).is_ok());
    let watched = Watched::default();
    let swept = kinematics(watched, &declared_start(&watched), &sweep::<Watched>("phi", [0.0, 1.0], 0.0, 4));
    assert_eq!(named(swept.unwrap_err()), "output `speed`");
}

/// x = r cos theta + sqrt(l^2 - (r sin theta - e)^2): its stroke is sqrt((l + r)^2 - e^2) - sqrt((l - r)^2 - e^2), with crank
/// and rod in line at both ends.
#[test]
fn the_stroke_and_time_ratio_of_a_slider_crank() {
    let (r, l, e) = (0.15f64, 0.45f64, 0.03f64);
    let found = driven(SliderCrank::default(), "theta", [0.3, 0.3 + TAU], 20.0, 100);
    assert!(found.is_cycle());
    for sample in &found.trajectory.samples {
        let ([theta, phi], [_, phi_dot]) = (sample.state.positions, sample.state.speeds);
        let sine = (e - r * theta.sin()) / l;
        let rate = -r * theta.cos() * 20.0 / (l * phi.cos());
        let second = (r * theta.sin() * 400.0 + l * phi.sin() * rate * rate) / (l * phi.cos());
        assert!((phi - sine.asin()).abs() < 1e-14 && (phi_dot - rate).abs() < 1e-13 && sample.accelerations[0] == 0.0);
        assert!((sample.accelerations[1] - second).abs() < 1e-11);
    }
    let x = output::<SliderCrank>("x");
    let range = found.extremes.outputs[x].unwrap();
    let (out, back) = (((l + r).powi(2) - e * e).sqrt(), ((l - r).powi(2) - e * e).sqrt());
    assert!((range.greatest.value - out).abs() < 1e-15 && (range.least.value - back).abs() < 1e-15, "{range:?}");
    let (outer, inner) = ((e / (l + r)).asin(), PI + (e / (l - r)).asin());
    // Places are those of roots of the velocity, to a few roundings of 2 pi.
    assert!((range.greatest.at - (outer + TAU)).abs().min((range.greatest.at - outer).abs()) < 1e-14);
    assert!((range.least.at - inner).abs() < 1e-14, "{range:?}");
    let ratio = found.extremes.time_ratios[x].unwrap();
    assert!(
        (ratio.ratio - (TAU - (inner - outer)).max(inner - outer) / (TAU - (inner - outer)).min(inner - outer)).abs()
            < 1e-13
    );
    // The mechanical advantage d theta/dx is least where the piston is fastest.
    let fastest = found.extremes.ratios[x].unwrap().peak();
    let speed = |theta: f64| {
        let sine = r * theta.sin() - e;
        -r * theta.sin() - sine * r * theta.cos() / (l * l - sine * sine).sqrt()
    };
    let slower = [-1e-3, 1e-3].map(|step| speed(fastest.at + step).abs());
    assert!((speed(fastest.at) - fastest.value).abs() < 1e-14 && slower.iter().all(|slow| *slow < fastest.value.abs()));
}

mechanism! {
    /// A wheel that turns another one half as fast, with a pen on each, and a pen that is always on the line between the hubs.
    Geared;
    coordinates { a [rad]; b [rad]; }
    parameters { r [m] = 0.1; J [kg*m^2] = 1; }
    bodies { fast: inertia J, angle a; slow: inertia J, angle b; }
    joints { teeth: gear fast radius r to slow radius 2*r; }
    outputs { on_fast [m] = r*sin(a); on_slow [m] = 2*r*sin(b); still = a + 2*b; }
}

/// After one turn of the fast wheel the slow one is half a turn further: its pen has no time ratio, and neither has what moves by
/// rounding alone.
#[test]
fn a_time_ratio_needs_a_motion_that_returns() {
    let found = driven(Geared::default(), "a", [0.1, 0.1 + TAU], 1.0, 100);
    let ratios = &found.extremes.time_ratios;
    assert!((ratios[0].unwrap().ratio - 1.0).abs() < 1e-9);
    assert_eq!(ratios[1..], [None, None]);
    let twice = driven(Geared::default(), "b", [0.1, 0.1 + TAU], 1.0, 100);
    assert!((twice.extremes.time_ratios[1].unwrap().ratio - 1.0).abs() < 1e-9);
}

/// The rocker turns back where the crank is at a right angle to it: the smaller part of the turn is 2 acos(O2A / O4O2).
#[test]
fn the_time_ratio_of_quick_return() {
    let found = driven(QuickReturn::default(), "alpha", [0.0, TAU], 2.5 * PI, 720);
    let x6 = output::<QuickReturn>("x6");
    let ratio = found.extremes.time_ratios[x6].unwrap();
    let returning = 2.0 * (2.0f64 / 3.0).acos();
    assert!((ratio.ratio - (TAU - returning) / returning).abs() < 1e-12, "{ratio:?}");
    assert!((ratio.returning - returning).abs() < 1e-13);
    // The rocker swings by the same angle each way about the vertical; its tip and bar 5 give the stroke.
    let swing = (2.0f64 / 3.0).asin();
    let slider = |beta: f64| 0.7 * beta.cos() - (0.36 - (0.9 - 0.7 * beta.sin()).powi(2)).sqrt();
    let stroke = slider(PI / 2.0 - swing) - slider(PI / 2.0 + swing);
    let range = found.extremes.outputs[x6].unwrap();
    assert!((range.stroke() - stroke).abs() < 1e-14, "{range:?} {stroke}");
    // Through two turns the same positions come again.
    let twice = driven(QuickReturn::default(), "alpha", [0.0, 2.0 * TAU], 2.5 * PI, 1440);
    for (first, second) in twice.trajectory.samples.iter().zip(&twice.trajectory.samples[720..]) {
        let apart = |j: usize| second.state.positions[j] - first.state.positions[j];
        assert!((apart(0) - TAU).abs() < 1e-14 && apart(1).abs() < 1e-13 && apart(2).abs() < 1e-13);
    }
}

/// Backwards, and beginning elsewhere than the declared start, the same branch is followed.
#[test]
fn directions_and_beginnings_do_not_change_the_branch() {
    let ahead = driven(FourBar::default(), "theta2", [1.0, 3.0], 10.0, 64);
    let back = driven(FourBar::default(), "theta2", [3.0, 1.0], 10.0, 64);
    for (a, b) in ahead.trajectory.samples.iter().zip(back.trajectory.samples.iter().rev()) {
        for j in 0..3 {
            assert!((a.state.positions[j] - b.state.positions[j]).abs() < 1e-14);
            assert!((a.state.speeds[j] + b.state.speeds[j]).abs() < 1e-12);
            assert!((a.accelerations[j] - b.accelerations[j]).abs() < 1e-10);
        }
    }
}

mechanism! {
    /// A slider on a rail that shakes, on a spring.
    Shaker;
    coordinates { x [mm]; }
    parameters { m [kg] = 2; k [N/m] = 500; c [N*s/m] = 1; stroke [mm] = 5; }
    let P = [x + stroke*sin(30 [rad/s]*t), 0];
    bodies { slider: mass m at P; }
    loads { force [-k*x - c*dot(x), 0] at P; }
    outputs { place [mm] = P.x; speed [m/s] = dot(x); }
}

/// While x moves uniformly the rail's acceleration is felt; while the place in space does, it is not.
#[test]
fn time_runs_during_the_sweep() {
    let found = driven(Shaker::default(), "x", [0.01, 0.03], 0.1, 20);
    for (sample, force) in found.trajectory.samples.iter().zip(&found.forces[0]) {
        let (t, x) = (sample.state.time, sample.state.positions[0]);
        let expected = -2.0 * 0.005 * 900.0 * (30.0 * t).sin() + 500.0 * x + 0.1;
        assert!((force - expected).abs() < 1e-12 && (x - 0.01 - 0.1 * t).abs() < 1e-16);
    }
    let found = driven(Shaker::default(), "place", [0.01, 0.03], 0.1, 20);
    for (sample, force) in found.trajectory.samples.iter().zip(&found.forces[0]) {
        let t = sample.state.time;
        let (x, rate) = (0.01 + 0.1 * t - 0.005 * (30.0 * t).sin(), 0.1 - 0.15 * (30.0 * t).cos());
        assert!((sample.state.positions[0] - x).abs() < 1e-16 && (force - 500.0 * x - rate).abs() < 1e-12, "{t}");
    }
}

/// A sweep of a length that begins at the origin, or close to it, where the mechanism has no length of its own: the spring pulls.
#[test]
fn a_length_is_driven_from_the_origin_on() {
    let all: &[f64] = &[0.0, 1e-9, 1e-4, -1e-9, 0.1];
    let forms = [
        ("", all),
        ("constraints { c1: y = 0; c2: y = 0; }", tests::sampled(&[0.1][..], all)),
        ("constraints { c1: y = 0.1*x; c2: 2*y = 0.2*x; }", tests::sampled(&[1e-4][..], all)),
    ];
    for (constraints, starts) in forms {
        let coordinates = if constraints.is_empty() { "x [m];" } else { "x [m]; y [m];" };
        let place = if constraints.is_empty() { "[x, 0]" } else { "[x, y]" };
        for &from in starts {
            let text = format!(
                "pub Short; coordinates {{ {coordinates} }} bodies {{ a: mass 1 [kg] at {place}; }}
                 loads {{ spring 100 [N/m], rest 0 on x; }} {constraints} initial {{ x = {from:e}; }}"
            );
            let model = interpreted(&text).unwrap();
            let driven = Driven::find(model.description(), "x").unwrap();
            let sweep = Sweep { driven, from, to: 1.0, speed: 0.0, steps: 10, held: Vec::new() };
            let found = kinematics(model.clone(), &declared_start(&model), &sweep).unwrap();
            assert!(found.trajectory.failure.is_none() && found.values.len() == 11, "{text}");
            for (x, force) in found.values.iter().zip(&found.forces[0]) {
                assert!((force - 100.0 * x).abs() < 1e-10, "{text}: {force} N at {x} m");
            }
        }
    }
}
