//! Poincaré sections and periods.

use models::{DoublePendulum, Pendulum};
use sim::{Compiled, Crossing, Method, Section, Sectioning, Settings, Start, declared_start, mechanism, poincare};
use std::f64::consts::TAU;
use tests::any_model::{AnyModel, interpreted, without_type};

fn section<M: Compiled>(
    mechanism: M,
    start: &Start<M>,
    event: &str,
    crossing: Option<Crossing>,
    count: usize,
) -> Section<AnyModel> {
    let event = M::DESCRIPTION.events.iter().position(|other| other.name == event).unwrap();
    let settings = Settings::adaptive(Method::Dop853, 200.0, 1e-12);
    let (model, start) = without_type(mechanism, start);
    poincare(model, &start, &Sectioning { event, crossing, count }, &settings).unwrap()
}

/// 2 pi sqrt(l/g) / agm(1, cos(amplitude/2)), by Gauss.
#[test]
fn a_pendulum_has_the_period_of_its_elliptic_integral() {
    let (mut a, mut b) = (1.0f64, std::f64::consts::FRAC_PI_4.cos());
    for _ in 0..6 {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    let expected = 2.0 * std::f64::consts::PI / 9.81f64.sqrt() / a;
    let pendulum = Pendulum::default();
    for (crossing, crossings, states) in [(Some(Crossing::Rising), 1, 20), (None, 2, 40)] {
        let found = section(pendulum, &declared_start(&pendulum), "bottom", crossing, states);
        let period = found.period.unwrap();
        println!("period off by {:.1e}", period.seconds - expected);
        assert_eq!((period.crossings, found.trajectory.samples.len()), (crossings, states));
        // 20 periods at 1e-12 a step.
        assert!((period.seconds - expected).abs() < 1e-10 * expected, "{period:?} {expected}");
    }
}

mechanism! {
    /// A swing, watched where it turns back; and a mass on a spring, watched where it passes its place at rest.
    Swings;
    coordinates { phi [rad]; x [m]; }
    parameters { l [m] = 2.2; g [m/s^2] = 9.81; w [rad/s] = 7; s [m] = 0.1; }
    bodies { seat: mass 30 [kg] at l*[sin(phi), -cos(phi)]; slider: mass 1 [kg] at [x, 0]; }
    loads { gravity [0, -g]; force [-w^2*x*1 [kg], 0] at [x, 0]; }
    initial { phi = 50 [deg]; x = 0; dot(x) = w*s; }
    events { turns: dot(phi) = 0 falling; passes: x = 0 rising; }
}

/// Speeds that are rounding where it turns back, and positions that are where it passes the origin, hide no period; nor does the size.
#[test]
fn sections_through_zero_speeds_and_places_have_periods() {
    let (mut a, mut b) = (1.0f64, (25.0f64).to_radians().cos());
    for _ in 0..6 {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    for size in [1e-3, 1.0, 100.0] {
        let base: Swings = Swings::default();
        let swing = Swings { l: base.l * size, g: base.g * size, s: 0.0, ..base };
        let period = section(swing, &declared_start(&swing), "turns", None, 8).period.unwrap();
        let expected = std::f64::consts::TAU * (base.l / base.g).sqrt() / a;
        // Seven periods at 1e-12 a step; where it turns back the event is as sharp as the speed's slope.
        assert!(period.crossings == 1 && (period.seconds - expected).abs() < 1e-9 * expected, "{period:?} {expected}");
        let hanging = Start { positions: [0.0, 0.0], ..declared_start(&Swings { s: base.s * size, ..swing }) };
        let period = section(Swings { s: base.s * size, ..swing }, &hanging, "passes", None, 8).period.unwrap();
        let expected = std::f64::consts::TAU / base.w;
        // At 1e-12 of the length of the swing, which is 22 times as far as the mass goes.
        assert!(period.crossings == 1 && (period.seconds - expected).abs() < 1e-9 * expected, "{period:?}");
    }
    // Together they repeat nothing.
    let both = Swings::default();
    assert_eq!(section(both, &declared_start(&both), "turns", None, 12).period, None);
}

mechanism! {
    /// The double pendulum, with a section where the upper bar hangs.
    Double;
    coordinates { phi1 [rad]; phi2 [rad]; }
    parameters { l [m] = 0.6; m [kg] = 0.5; g [m/s^2] = 9.81; }
    let elbow = l*[sin(phi1), -cos(phi1)];
    let half = l/2*[sin(phi2), -cos(phi2)];
    bodies {
        upper: mass m at elbow/2, inertia m*l^2/12, angle phi1;
        lower: mass m at elbow + half, inertia m*l^2/12, angle phi2;
    }
    loads { gravity [0, -g]; }
    initial { phi1 = 0.9; phi2 = 0; }
    events { hangs: sin(phi1) = 0; }
    outputs {
        energy [J] = m*l^2*(dot(phi1)^2/6 + dot(phi2)^2/24) + m*norm(dot(elbow + half))^2/2
            + m*g*(elbow.y/2 + elbow.y + half.y);
    }
}

/// Every point of the section is on the surface of the start's energy and on the section; and the motion is no cycle.
#[test]
fn the_return_map_of_a_conservative_mechanism_stays_on_its_energy() {
    let double = Double::default();
    let found = section(double, &declared_start(&double), "hangs", Some(Crossing::Rising), 60);
    assert_eq!((found.trajectory.samples.len(), found.period), (60, None));
    let energy = |q: [f64; 2], qd: [f64; 2]| double.outputs(0.0, &q, &qd, &[0.0; 2], &[]).energy;
    let start = energy([0.9, 0.0], [0.0; 2]);
    for sample in &found.trajectory.samples {
        let state = &sample.state;
        // 60 returns at 1e-12 a step.
        let [q, speeds] = [&state.positions, &state.speeds].map(|pair| [pair[0], pair[1]]);
        assert!((energy(q, speeds) - start).abs() < 1e-9, "{state:?}");
        assert!(state.positions[0].sin().abs() < 1e-10 && state.positions[0].cos() * state.speeds[0] > 0.0);
    }
    // A mechanism without events has no sections, and says so on the command line.
    assert!(DoublePendulum::<f64>::DESCRIPTION.events.is_empty());
}

mechanism! {
    /// Two oscillators without a common period, of which one swings by half a micrometre beside the other's metre; and two in angles
    /// of less than a microradian.
    Apart;
    coordinates { big [m]; small [nm]; a [rad]; b [rad]; }
    bodies {
        first: mass 1 [kg] at [big, 0];
        second: mass 1 [kg] at [0, small];
        third: inertia 1 [kg*m^2], angle a;
        fourth: inertia 1 [kg*m^2], angle b;
    }
    loads {
        spring 1 [N/m], rest 100 [m] on big;
        spring 2.3 [N/m], rest 0 on small;
        spring 1 [N*m], rest 0 on a;
        spring 0.37 [N*m], rest 0 on b;
    }
    initial { big = 101; small = 500; a = 3e-7; b = 3e-7; }
    events { top: dot(big) = 0; angle: dot(a) = 0; }
}

#[test]
fn what_does_not_repeat_in_small_coordinates_has_no_period() {
    let apart = Apart::default();
    for event in ["top", "angle"] {
        let found = section(apart, &declared_start(&apart), event, Some(Crossing::Falling), 20);
        assert!(found.period.is_none(), "{event}: {:?}", found.period);
    }
}

/// 2 pi/agm(fastest, slowest), by Gauss: the time of a turn of a pendulum that goes over the top, from its speeds at the bottom and
/// at the top.
fn time_of_turn(fastest: f64, slowest: f64) -> f64 {
    let (mut a, mut b) = (fastest, slowest);
    for _ in 0..6 {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    std::f64::consts::TAU / a
}

mechanism! {
    /// Bodies that turn by quaternions of every origin, about principal axes: a free body, one on a ball joint, one by hand.
    Tumblers;
    coordinates { e0; e1; e2; e3; }
    parameters { one [rev/s] = 1; two [rev/s] = 2; three [rev/s] = 3; J [kg*m^2] = 1; }
    constraints { unit: e0^2 + e1^2 + e2^2 + e3^2 = 1; }
    bodies {
        a: free, mass 1 [kg], inertia [J, 2*J, 2.5*J];
        b: mass 1 [kg], inertia [J, 2*J, 2.5*J];
        c: inertia [J, 2*J, 2.5*J], attitude quaternion(e0, e1, e2, e3);
    }
    joints { hip: ball ground at [0, 0, 0] to b at [0, 0, 0]; }
    initial {
        dot(a_q3) = one/2; dot(hip_q1) = two/2; dot(e3) = 0.6*three/2;
        e0 = 0.6; e1 = 0; e2 = 0; e3 = 0.8;
    }
    events { turn: (attitude(a)*[1, 0, 0]).y = 0 rising; }
}

/// After a turn of the first, the second has made two turns, and its quaternion has its sign back; those of the first and the third
/// have not.
#[test]
fn a_quaternion_and_its_opposite_are_one_attitude() {
    let period_of =
        |tumblers: Tumblers| section(tumblers, &declared_start(&tumblers), "turn", None, 12).period.unwrap();
    let tumblers = Tumblers::default();
    let period = period_of(tumblers);
    // 12 turns of three quaternions, at 1e-12 a step.
    assert!(period.crossings == 1 && (period.seconds - 1.0).abs() < 1e-9, "{period:?}");
    // Beside a body that makes a turn and a half, it takes two turns of the first.
    let period = period_of(Tumblers { two: 1.5 * tumblers.one, ..tumblers });
    assert!(period.crossings == 2 && (period.seconds - 2.0).abs() < 1e-9, "{period:?}");
}

mechanism! {
    /// A body whose potential energy is that of a pendulum in half of its angle: it takes the two signs for different attitudes.
    Halved;
    parameters { k [J] = 3; J [kg*m^2] = 0.5; w [rad/s] = 6; }
    bodies { b: free, mass 1 [kg], inertia [J, J, J]; }
    loads { potential -k*b_q0; }
    initial { dot(b_q3) = w; }
    events { upright: b_q0 = 0; }
}

/// With b_q0 = cos(f), the energy is 2 J f'^2 - k cos(f). Over the top or through the bottom, half a turn of f takes different times.
#[test]
fn opposite_quaternions_are_two_states_where_a_load_takes_them_for_two() {
    let halved = Halved::default();
    let period = section(halved, &declared_start(&halved), "upright", None, 12).period.unwrap();
    let expected = time_of_turn(halved.w, (halved.w.powi(2) - halved.k / halved.J).sqrt());
    // Five turns at 1e-12 a step.
    assert!(period.crossings == 2 && (period.seconds - expected).abs() < 1e-9 * expected, "{period:?} {expected}");
}

mechanism! {
    /// A body that swings by a microradian about its attitude, beside an oscillator of a thousand kilometres, without a common
    /// period.
    Beside;
    coordinates { far [km]; }
    bodies { distant: mass 1 [kg] at [far, 0, 0]; b: free, mass 1 [kg], inertia [1 [kg*m^2], 1 [kg*m^2], 1 [kg*m^2]]; }
    loads { spring 1 [N/m], rest 0 on far; potential 1.4 [J]*b_q3^2; }
    initial { far = 1000; dot(b_q3) = 1e-6; }
    events { top: dot(far) = 0 falling; }
}

#[test]
fn lengths_beside_a_quaternion_do_not_hide_its_motion() {
    let beside = Beside::default();
    assert_eq!(section(beside, &declared_start(&beside), "top", Some(Crossing::Falling), 20).period, None);
}

mechanism! {
    /// A pendulum on a joint that goes over the top, in units of the user's choice.
    Whirled;
    parameters { g = 9.81; l = 0.3; m = 1; J = 1.5; w = 6.283185307179586; }
    loads { gravity [0, -g, 0]; }
    bodies { b: mass m, inertia [1, 1, J]; }
    joints { j: revolute ground at [0, 0, 0] axis [0, 0, 1] to b at [l, 0, 0] axis [0, 0, 1]; }
    initial { dot(j) = w; }
    events { turn: (attitude(b)*[1, 0, 0]).y = 0 rising; }
}

/// It starts level, with the speed w.
#[test]
fn the_turn_of_a_joint_is_an_angle_without_units_too() {
    let whirled = Whirled::default();
    let period = section(whirled, &declared_start(&whirled), "turn", None, 8).period.unwrap();
    let squared = 2.0 * whirled.m * whirled.g * whirled.l / (whirled.J + whirled.m * whirled.l.powi(2));
    let [fastest, slowest] = [squared, -squared].map(|gained| (whirled.w.powi(2) + gained).sqrt());
    let expected = time_of_turn(fastest, slowest);
    // Seven turns at 1e-12 a step.
    assert!(period.crossings == 1 && (period.seconds - expected).abs() < 1e-10 * expected, "{period:?} {expected}");
}

mechanism! {
    /// Every joint that gives coordinates, and a free body, without units.
    Jointed;
    bodies {
        a: mass 1, inertia [1, 2, 2.5];
        b: mass 1, inertia [1, 2, 2.5];
        c: mass 1, inertia [1, 2, 2.5];
        d: mass 1, inertia [1, 2, 2.5];
        e: mass 1, inertia [1, 2, 2.5];
        f: mass 1, inertia [1, 2, 2.5];
    }
    joints {
        r: revolute ground at [0, 0, 0] axis [0, 0, 1] to a at [1, 0, 0] axis [0, 0, 1];
        p: prismatic ground at [0, 0, 0] axis [0, 0, 1] to b at [1, 0, 0] axis [0, 0, 1];
        c1: cylindrical ground at [0, 0, 0] axis [0, 0, 1] to c at [1, 0, 0] axis [0, 0, 1];
        s: screw ground at [0, 0, 0] axis [0, 0, 1] to d at [1, 0, 0] axis [0, 0, 1] pitch 0.1;
        u: universal ground at [0, 0, 0] axis [1, 0, 0] to e at [1, 0, 0] axis [0, 1, 0];
        l: planar ground at [0, 0, 0] axis [0, 0, 1] to f at [1, 0, 0] axis [0, 0, 1];
    }
}

#[test]
fn turns_of_joints_are_in_radians_and_shifts_in_the_units_of_the_user() {
    let units = Jointed::<f64>::DESCRIPTION.coordinates.iter().map(|c| (c.position.name, c.position.unit));
    let expected = [
        ("r", "rad"),
        ("p", "1"),
        ("c1_turn", "rad"),
        ("c1_shift", "1"),
        ("s", "rad"),
        ("u_1", "rad"),
        ("u_2", "rad"),
        ("l_x", "1"),
        ("l_y", "1"),
        ("l_turn", "rad"),
    ];
    assert_eq!(units.collect::<Vec<_>>(), expected);
}

/// x = 0.8 sin 2t - sin t crosses zero twice falling in its period of 2 pi, at intervals that differ: what the load does with time is
/// no part of the state.
#[test]
fn a_period_takes_the_same_time_each_time() {
    let text = "pub Odd; coordinates { x [m]; } bodies { p: mass 1 [kg] at [x, 0]; }
        loads { force 1 [N]*sin(1 [rad/s]*t) - 3.2 [N]*sin(2 [rad/s]*t) on x; }
        initial { x = 0; dot(x) = 0.6; } events { z: x = 0; }";
    for count in [5, 9, 20] {
        let period = period_of(text, Some(Crossing::Falling), count).unwrap();
        assert_eq!(period.crossings, 2, "{count}");
        assert!((period.seconds - TAU).abs() < 1e-7, "{count}: {}", period.seconds);
    }
}

/// Two oscillators whose frequencies differ by a millionth: each state is nearly the last one, and far from the first.
#[test]
fn what_drifts_has_no_period() {
    let text = |k: f64| {
        format!(
            "pub Two; coordinates {{ x [m]; y [m]; }} parameters {{ k [N/m] = {k:?}; }}
         bodies {{ a: mass 1 [kg] at [x, 0]; b: mass 1 [kg] at [0, y]; }}
         loads {{ force -1 [N/m]*x on x; force -k*y on y; }} initial {{ x = 1; y = 1; }} events {{ e: x = 0; }}"
        )
    };
    for (k, crossings) in [(1.0, Some(1)), (1.000002, None), (1.000001, None), (4.0, Some(1)), (2.25, Some(2))] {
        let found = period_of(&text(k), Some(Crossing::Rising), 150);
        assert_eq!(found.map(|period| period.crossings), crossings, "{k}");
    }
}

fn period_of(text: &str, crossing: Option<Crossing>, count: usize) -> Option<sim::Period> {
    let model = interpreted(text).unwrap();
    let start = declared_start(&model);
    let section = Sectioning { event: 0, crossing, count };
    poincare(model, &start, &section, &Settings::new(1e4)).unwrap().period
}

/// Small swings, which a tolerance of 1e-10 rad knows less and less of: their period is the right one, or none, and no multiple.
#[test]
fn small_swings_have_no_multiple_of_their_period() {
    for amplitude in [1e-2f64, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 1e-7] {
        let text = format!(
            "pub Swing; coordinates {{ p [rad]; }} bodies {{ b: mass 1 [kg] at 1 [m]*[sin(p), -cos(p)]; }}
             loads {{ gravity [0, -9.81 [m/s^2]]; }} initial {{ p = {amplitude:e}; }} events {{ z: p = 0; }}"
        );
        for count in [10, 20, 50] {
            let exact = TAU / 9.81f64.sqrt() * (1.0 + amplitude.powi(2) / 16.0);
            if let Some(period) = period_of(&text, Some(Crossing::Rising), count) {
                assert_eq!(period.crossings, 1, "{amplitude} {count}");
                assert!((period.seconds / exact - 1.0).abs() < 1e-6, "{amplitude} {count}: {}", period.seconds);
            }
        }
        assert!(amplitude < 1e-3 || period_of(&text, Some(Crossing::Rising), 20).is_some(), "{amplitude}");
    }
}

/// Two oscillators of frequencies 2 and 1, of which the slower moves little: states alternate by so much, and repeat after two crossings.
#[test]
fn what_alternates_by_little_repeats_after_two() {
    for amplitude in [1e-2, 1e-3, 1e-4] {
        let text = format!(
            "pub Both; coordinates {{ x [m]; y [m]; }} bodies {{ b: mass 1 [kg] at [x, y]; }}
             loads {{ force [-4 [N/m]*x, -1 [N/m]*(y - 1 [m])] at [x, y]; }}
             initial {{ x = 1; y = 1 + {amplitude:e}; }} events {{ top: x = 0; }}"
        );
        let period = period_of(&text, Some(Crossing::Falling), 30).unwrap();
        assert_eq!(period.crossings, 2, "{amplitude}");
        assert!((period.seconds - TAU).abs() < 1e-8, "{amplitude}: {}", period.seconds);
    }
}
