//! Dead points, crossing branches, and what cannot be driven.

use crate::sweeps::{driven, sweep};
use models::{BouncingBall, DoublePendulum, FourBar, SliderCrank, TumblingQuaternion};
use sim::{
    Compiled, Driven, Method, Rows, Settings, Start, Sweep, What, dead_points, declared_start, kinematics, mechanism,
};
use std::f64::consts::PI;
use tests::any_model::run_from;

/// Crank and ground link of 0.5 m and 0.65 m, coupler and rocker of 0.4 m and 0.3 m: no link can turn fully.
fn swinging() -> (FourBar, Start<FourBar>) {
    let linkage = FourBar { a: 0.5, b: 0.4, c: 0.3, d: 0.65, ..FourBar::default() };
    let start = Start { positions: [0.9, 0.2, 1.4], ..declared_start(&linkage) };
    (linkage, start)
}

/// See below.
fn furthest() -> f64 {
    ((0.25 + 0.4225 - 0.49f64) / 0.65).acos()
}

/// The crank goes no further than where coupler and rocker are in line, stretched:
/// cos theta2 = (a^2 + d^2 - (b + c)^2) / (2 a d).
#[test]
fn a_crank_stops_where_the_other_links_are_stretched() {
    let (linkage, start) = swinging();
    let furthest = furthest();
    for (to, sign) in [(3.0, 1.0), (-3.0, -1.0)] {
        let sweep = sweep::<FourBar>("theta2", [sign * 0.9, to], 1.0, 500);
        let start = Start { positions: start.positions.map(|angle| sign * angle), ..start.clone() };
        let found = kinematics(linkage, &start, &sweep).unwrap();
        let limit = found.limit.unwrap();
        println!("limit position off by {:.1e}", limit.value - sign * furthest);
        assert!(
            (limit.value - sign * furthest).abs() < 1e-14
                && (limit.positions[1] - limit.positions[2]).sin().abs() < 1e-12
        );
        let failure = found.trajectory.failure.unwrap();
        assert!(matches!(failure.what, What::LimitPosition { driven: "theta2", .. }), "{failure}");
        assert!(failure.to_string().contains("theta2") && failure.to_string().contains("rad"), "{failure}");
        // All that came before stands, to the last sample before the limit.
        let (last, step) = (*found.values.last().unwrap(), (to - sign * 0.9).abs() / 500.0);
        assert!((limit.value - last).abs() <= step && found.values.len() > 50, "{last}");
        assert!(found.transmission.last().unwrap() < &0.2);
    }
}

/// In a run the same positions are passed: the crank swings to and fro, and each time coupler and rocker bend the other way.
#[test]
fn a_run_says_which_dead_points_it_passed() {
    let (linkage, start) = swinging();
    let run = run_from(linkage, &Start { speeds: [20.0, 0.0, 0.0], ..start }, &Settings::new(1.0)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let passed = dead_points(&run);
    let furthest = furthest();
    for point in &passed {
        let (crank, speed) = (point.state.positions[0], point.state.speeds[0]);
        println!("{:?} at {:.6} s: {crank:.6}, {speed:.1e}", point.of, point.state.time);
        let off = (crank.abs() - furthest).abs();
        assert!(point.of == ["theta2"] && off < 1e-9 && speed.abs() < 1e-5, "{point:?}");
    }
    // Between two of them the crank turns back once: its speed changes its sign as often.
    let speeds = run.trajectory.samples.windows(2).map(|pair| pair[0].state.speeds[0] * pair[1].state.speeds[0]);
    assert!(passed.len() > 3 && speeds.filter(|product| *product < 0.0).count() >= passed.len());
    assert!(
        dead_points(&run_from(FourBar::default(), &declared_start(&FourBar::default()), &Settings::new(2.0)).unwrap())
            .is_empty()
    );
}

mechanism! {
    /// A crank about the vertical and a rocker about an axis across it, joined by a link; of the start the rocker is given.
    Rocked;
    coordinates { psi [rad]; phi [rad]; }
    parameters { a [m] = 0.15; b [m] = 0.4; m [kg] = 1; }
    let A = a*[cos(phi), sin(phi), 0];
    let B = [0.5 [m], 0, 0.3 [m]] + rotation(y, psi)*[0, 0, -b];
    bodies { crank: mass m at A; rocker: mass m at B; }
    joints { coupling: link A to B, length 0.7 [m]; }
    initial { psi = -0.6; dot(phi) = 12; guess phi = 0.5; }
}

/// In space, the rocker turns back where it is farthest: there its speed is 0, and it does not say where the crank goes.
#[test]
fn a_run_in_space_says_which_dead_points_it_passed() {
    let linkage = Rocked::default();
    let run = run_from(linkage, &declared_start(&linkage), &Settings::new(2.0)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let passed = dead_points(&run);
    for point in &passed {
        assert!(point.of == ["psi"] && point.state.speeds[0].abs() < 1e-5 * 12.0, "{point:?}");
    }
    let speeds = run.trajectory.samples.windows(2).map(|pair| pair[0].state.speeds[0] * pair[1].state.speeds[0]);
    let turns = speeds.filter(|product| *product < 0.0).count();
    assert!(turns > 3 && passed.len() == turns, "{turns} {passed:?}");
}

mechanism! {
    /// A bob on a circle, in absolute coordinates, from the height of the pivot.
    Bob;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; l [m] = 1; }
    let P = [x, y];
    bodies { bob: mass m at P; }
    loads { gravity [0, -1 [m/s^2]]; }
    constraints { circle: x^2 + y^2 = l^2; }
    initial { x = 1; y = 0; dot(x) = 0; dot(y) = 1; }
}

/// Thrown upwards with v^2 = g l the bob turns back at sin theta = 1/2. With 1 - 2 sin theta = u^2 it is back at the height of the
/// pivot, where x tells nothing, after 2 int_0^1 du/cos theta each way. What is recorded has no part in that.
#[test]
fn dead_points_do_not_depend_on_rows() {
    let cosine = |u: f64| (1.0 - (1.0 - u * u).powi(2) / 4.0).sqrt();
    let n = 1000;
    let simpson = |k: u32| if k == 0 || k == n { 1.0 } else { 2.0 + 2.0 * f64::from(k % 2) };
    let sum: f64 = (0..=n).map(|k| simpson(k) / cosine(f64::from(k) / f64::from(n))).sum();
    let expected = 2.0 * sum / (3.0 * f64::from(n));
    let times = |rows| {
        let settings = Settings { rows, ..Settings::adaptive(Method::Dop853, 10.0, 1e-12) };
        let run = run_from(Bob::default(), &declared_start(&Bob::default()), &settings).unwrap();
        dead_points(&run).iter().map(|point| point.state.time).collect::<Vec<f64>>()
    };
    let found = times(Rows::Even(1));
    println!("{found:?}, {expected:.12}");
    // The tolerance of a step, times the steps.
    assert!((found[0] - expected).abs() < 1e-10, "{found:?} {expected}");
    for rows in [Rows::Even(11), Rows::Even(1000), Rows::Steps] {
        assert_eq!(times(rows), found);
    }
}

mechanism! {
    /// A crank and a rod of equal length: where both stand upright the piston may stay and both turn about it.
    EqualRods;
    coordinates { theta [rad]; phi [rad]; }
    parameters { l [m] = 1; m [kg] = 1; }
    let A = l*[cos(theta), sin(theta)];
    let C = A + l*[cos(phi), sin(phi)];
    bodies {
        crank: mass m at A/2, inertia m*l^2/12, angle theta;
        rod: mass m at (A + C)/2, inertia m*l^2/12, angle phi;
    }
    constraints { rail: C.y = 0; }
    initial { theta = pi/4; dot(theta) = 4; guess phi = -pi/4; }
}

/// dC/dphi changes its sign in the singular position too, but the motion passes it straight on: phi = -theta before and after.
#[test]
fn a_singular_position_is_no_dead_point() {
    let rods = EqualRods::default();
    for end in [0.5, 0.77] {
        let run = run_from(rods, &declared_start(&rods), &Settings::new(end)).unwrap();
        let last = &run.trajectory.samples.last().unwrap().state.positions;
        let [theta, phi] = [last[0], last[1]];
        assert!(theta > 1.7 && (theta + phi).abs() < 1e-6, "{theta} {phi}");
        assert!(dead_points(&run).is_empty(), "{:?}", dead_points(&run));
    }
}

/// Components of a quaternion change their signs, and nothing is dead there.
#[test]
fn a_tumbling_body_has_no_dead_points() {
    let body = TumblingQuaternion::default();
    let run = run_from(body, &declared_start(&body), &Settings::new(2.0)).unwrap();
    let last = |j: usize| run.trajectory.samples.iter().map(|sample| sample.state.positions[j]).fold(0.0, f64::min);
    assert!((3..7).any(|j| last(j) < -0.1) && dead_points(&run).is_empty());
}

/// Both ways round, the piston cannot be pushed beyond where crank and rod are in line.
#[test]
fn an_output_is_driven_to_its_dead_points() {
    let (near, far) = ((0.3f64.powi(2) - 0.0009).sqrt(), (0.6f64.powi(2) - 0.0009).sqrt());
    for (to, limit) in [(0.2, near), (0.7, far)] {
        let found = driven(SliderCrank::default(), "x", [0.5, to], 0.1, 300);
        assert!((found.limit.unwrap().value - limit).abs() < 1e-14);
        let x = |sample: &sim::Sample<SliderCrank>| {
            0.15 * sample.state.positions[0].cos() + 0.45 * sample.state.positions[1].cos()
        };
        for (sample, value) in found.trajectory.samples.iter().zip(&found.values) {
            assert!((x(sample) - value).abs() < 1e-15);
        }
    }
    // Where the sweep should begin beyond a dead point, the way there ends in it.
    let crank = SliderCrank::default();
    let failure =
        kinematics(crank, &declared_start(&crank), &sweep::<SliderCrank>("x", [0.7, 0.5], 0.1, 10)).unwrap_err();
    assert!(matches!(failure.what, What::LimitPosition { driven: "x", .. }), "{failure}");
}

/// A sweep that ends exactly in a special position names it, and what grows without bound towards it has no greatest value.
#[test]
fn a_special_position_at_the_end_is_named() {
    let linkage = FourBar { a: 0.2, b: 0.6, c: 0.2, d: 0.6, ..FourBar::default() };
    let start = Start { positions: [0.5, 0.0, 0.5], ..declared_start(&linkage) };
    for to in [0.0, PI, 0.5 - 2.0 * PI, -PI] {
        let found = kinematics(linkage, &start, &sweep::<FourBar>("theta2", [0.5, to], 10.0, 100)).unwrap();
        let last = found.branches.last().unwrap().value;
        let is_flat = to.sin().abs() < 1e-9;
        assert_eq!((last - to).abs() < 1e-9, is_flat, "{to}: {last}");
        assert!(found.extremes.multipliers.iter().any(Option::is_none), "{to}");
        assert_eq!(found.trajectory.samples.len(), 101);
    }
    for to in [(0.3f64.powi(2) - 0.0009).sqrt(), (0.6f64.powi(2) - 0.0009).sqrt()] {
        let found = driven(SliderCrank::default(), "x", [0.5, to], 0.1, 300);
        assert!((found.limit.unwrap().value - to).abs() < 1e-14, "{to}");
        // The speed of the crank.
        assert_eq!(found.extremes.outputs[0], None, "{to}");
    }
}

/// A parallelogram linkage can fold where it is flat: there another branch crosses. It goes straight on.
#[test]
fn a_parallelogram_goes_straight_through_its_change_points() {
    let linkage = FourBar { a: 0.2, b: 0.6, c: 0.2, d: 0.6, ..FourBar::default() };
    let start = Start { positions: [0.5, 0.0, 0.5], ..declared_start(&linkage) };
    // 350 steps of 1 degree and a little: no sample is on a change point, and then one is on each, and is not left out.
    for (from, to, samples) in [(0.5, 6.9, 351), (PI / 2.0, PI / 2.0 + 2.0 * PI, 361)] {
        let steps = samples - 1;
        let found = kinematics(linkage, &start, &sweep::<FourBar>("theta2", [from, to], 10.0, steps)).unwrap();
        assert_eq!((found.trajectory.failure, found.trajectory.samples.len()), (None, samples));
        let crossings: Vec<f64> = found.branches.iter().map(|branch| branch.value).collect();
        println!("branches off by {:?}", [crossings[0] - PI, crossings[1] - 2.0 * PI]);
        assert!(crossings.len() == 2 && (crossings[0] - PI).abs() < 1e-6 && (crossings[1] - 2.0 * PI).abs() < 1e-6);
        for sample in &found.trajectory.samples {
            let ([crank, coupler, rocker], speeds) = (sample.state.positions, sample.state.speeds);
            // Next to a change point the last bits of the constraints are divided by sin theta2.
            let rounding = 1e-14 / crank.sin().abs();
            assert!(coupler.abs() < rounding && (rocker - crank).abs() < rounding, "{:?}", sample.state);
            assert!((speeds[2] - 10.0).abs() < 1e3 * rounding);
        }
    }
}

#[test]
fn what_cannot_be_driven_says_why() {
    let double = DoublePendulum::default();
    let one = sweep::<DoublePendulum>("phi1", [0.0, 1.0], 1.0, 10);
    let failure = kinematics(double, &declared_start(&double), &one).unwrap_err();
    assert!(matches!(failure.what, What::NotDriven { freedoms: 2, driven: 1 }), "{failure}");
    let held = sim::Sweep { held: vec![(Driven::Coordinate(1), 0.3)], ..one };
    let found = kinematics(double, &declared_start(&double), &held).unwrap();
    // The lower bar is held at its angle, and the upper one turns: its weight and that of the lower one at the elbow.
    let (m, l, g) = (670.0 * 0.6 * 0.05 * 0.003, 0.6, 9.81);
    for (sample, forces) in found.trajectory.samples.iter().zip(&found.forces[1]) {
        let ([upper, lower], turning) = (sample.state.positions, m * l * l / 2.0);
        assert!((lower - 0.3).abs() < 1e-15);
        let held = m * g * l / 2.0 * lower.sin() - turning * (upper - lower).sin();
        assert!((forces - held).abs() < 1e-14, "{forces} {held}");
    }
    let slider = SliderCrank::default();
    let speed = sweep::<SliderCrank>("x_velocity", [0.0, 1.0], 1.0, 10);
    let failure = kinematics(slider, &declared_start(&slider), &speed).unwrap_err();
    assert!(matches!(failure.what, What::NotOfPositions { output: "x_velocity" }), "{failure}");
    // In a dead point the piston does not determine the crank.
    let flat = SliderCrank { offset: 0.0, ..slider };
    let piston = sweep::<SliderCrank>("x", [0.6, 0.5], 0.1, 10);
    let failure = kinematics(flat, &declared_start(&flat), &piston).unwrap_err();
    assert!(matches!(failure.what, What::DriveSingular { driven: "x" }), "{failure}");
}

mechanism! {
    /// An arm of two links.
    pub Arm;
    coordinates { a [rad]; b [rad]; }
    let elbow = 0.4 [m]*[cos(a), sin(a)];
    let hand = elbow + 0.3 [m]*[cos(a + b), sin(a + b)];
    bodies { upper: mass 1 [kg] at elbow; lower: mass 1 [kg] at hand; }
    initial { a = 0.5; b = 1; }
    outputs { reach [m] = norm(hand); }
}

/// The hand is 0.7 m away at most: what stops short is the hold, whether the drive moves to its start or is there.
#[test]
fn a_hold_out_of_reach_is_named() {
    let arm = Arm::default();
    for from in [0.5, 0.9] {
        let held = vec![(Driven::find(&<Arm as Compiled>::DESCRIPTION, "reach").unwrap(), 0.9)];
        let sweep = Sweep { held, ..sweep::<Arm>("a", [from, 2.0], 1.0, 10) };
        let failure = kinematics(arm, &declared_start(&arm), &sweep).unwrap_err();
        let What::LimitPosition { driven: "reach", value } = &failure.what else { panic!("{failure}") };
        assert_eq!(value, "0.700000000 m");
    }
}

/// Angles whose rounding is no small part of what turns are followed to.
#[test]
fn a_range_lost_in_rounding_is_refused() {
    let linkage = FourBar::default();
    for (from, to) in [(1e300, 2e300), (0.0, -1e10)] {
        let sweep = sweep::<FourBar>("theta2", [from, to], 1.0, 100);
        let failure = kinematics(linkage, &declared_start(&linkage), &sweep).unwrap_err();
        assert!(matches!(&failure.what, What::Unusable { setting } if setting.contains("`theta2`")), "{failure}");
    }
}

mechanism! {
    /// A crank and its slider, whose guide is declared twice.
    Doubled;
    coordinates { theta [rad]; phi [rad]; }
    parameters { r [m] = 0.1; l [m] = 0.3; m [kg] = 1; }
    let C = r*[cos(theta), sin(theta)] + l*[cos(phi), sin(phi)];
    bodies { piston: mass m at C; }
    constraints { guide: C.y = 0; again: 2*C.y = 0; }
    initial { theta = 0.4; dot(theta) = 3; guess phi = 0; }
    outputs { x [m] = C.x; }
}

#[test]
fn redundant_constraints_are_named_and_do_no_harm() {
    let found = driven(Doubled::default(), "theta", [0.4, 6.0], 3.0, 50);
    assert_eq!(found.mobility.dependent, ["again"]);
    for sample in &found.trajectory.samples {
        let [theta, phi] = sample.state.positions;
        assert!((0.1 * theta.sin() + 0.3 * phi.sin()).abs() < 1e-15);
        // The same constraint twice, once at double size: the shortest share is 1 to 2.
        assert!((sample.multipliers[1] - 2.0 * sample.multipliers[0]).abs() < 1e-12);
    }
}

/// A ball over a floor that holds for the instant of an impact: no dead point, and a sweep that the released floor does not
/// hinder, and that has no reaction of it.
#[test]
fn released_constraints_are_no_part_of_positions() {
    let ball = BouncingBall::default();
    let run = run_from(ball, &declared_start(&ball), &Settings::new(1.0)).unwrap();
    assert!(run.trajectory.failure.is_none() && !run.events.is_empty());
    assert!(dead_points(&run).is_empty());
    let held = vec![(Driven::find(&<BouncingBall as Compiled>::DESCRIPTION, "y").unwrap(), 0.5)];
    let sweep = Sweep { held, ..sweep::<BouncingBall>("x", [0.0, 1.0], 2.0, 10) };
    let found = kinematics(ball, &declared_start(&ball), &sweep).unwrap();
    assert_eq!((&found.trajectory.failure, found.values.len()), (&None, 11));
    for sample in &found.trajectory.samples {
        assert!(sample.multipliers == [0.0] && (sample.state.positions[1] - 0.5).abs() < 1e-15, "{sample:?}");
    }
}
