//! Branches that cross, nearly cross and fold: sweeps stay on theirs.

use crate::sweeps::{driven, output, sweep};
use models::{Bennett, FourBar};
use sim::{Kinematics, Start, declared_start, kinematics, mechanism};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

mechanism! {
    /// Two parallelograms side by side, upright: where they are flat, the rank of their constraints falls by two.
    Parallelograms;
    const N = 2;
    fragment Link(base, phi) {
        let tip = base + l*[sin(phi), cos(phi)];
        bodies { bar: mass m at (base + tip)/2, inertia m*l^2/12, angle -phi; }
    }
    coordinates {
        repeat i in 0..=N { th_[i] [rad]; }
        repeat i in 1..=N { ps_[i] [rad]; }
    }
    parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 9.81; }
    repeat i in 0..=N { use Link([i*l, 0], th_[i]) as crank_[i]; }
    repeat i in 1..=N {
        use Link(crank_[i-1]_tip, ps_[i]) as coupler_[i];
        constraints { loop_[i]: coupler_[i]_tip = crank_[i]_tip; }
    }
    loads { gravity [0, -g]; }
    initial { th_0 = 0; dot(th_0) = 1; repeat i in 1..=N { guess th_[i] = 0; guess ps_[i] = pi/2; } }
    outputs { x [m] = crank_0_tip.x; y [m] = crank_0_tip.y; }
}

/// Virtual work: three cranks and two couplers weigh on the drive, m g l (3/2 + 2) sin th. The same at 1 mm and at 100 m.
#[test]
fn crossings_of_even_order_are_named_and_no_row_is_left_out() {
    for (l, m) in [(1.0, 1.0), (1e-3, 1e-3), (100.0, 1e3)] {
        // Rows on the crossings, one row, and a start a hair before a crossing.
        for (steps, from) in [(36, 0.0), (1, 0.2), (200, -1.57)] {
            let found =
                driven(Parallelograms { l, m, ..Parallelograms::default() }, "th_0", [from, from + TAU], 1.0, steps);
            assert_eq!((&found.trajectory.failure, found.values.len()), (&None, steps + 1), "{l} {steps}");
            let crossings: Vec<f64> = found.branches.iter().map(|branch| branch.value).collect();
            let expected = [FRAC_PI_2, 3.0 * FRAC_PI_2].map(|at| if at < from { at + TAU } else { at });
            assert_eq!(crossings.len(), 2, "{crossings:?}");
            for crossing in &crossings {
                // Where two singular values of rounding are equal.
                assert!(expected.iter().any(|at| (at - crossing).abs() < 1e-9), "{crossings:?}");
            }
            for (sample, force) in found.trajectory.samples.iter().zip(&found.forces[0]) {
                let ([first, second, third, a, b], speeds) = (sample.state.positions, sample.state.speeds);
                let off = [second - first, third - first, a - FRAC_PI_2, b - FRAC_PI_2].map(f64::abs);
                assert!(off.iter().all(|off| *off < 1e-12), "{l} {steps}: {:?}", sample.state);
                assert!((0..3).all(|j| (speeds[j] - 1.0).abs() < 1e-10) && (3..5).all(|j| speeds[j].abs() < 1e-10));
                assert!(sample.accelerations.iter().all(|second| second.abs() < 1e-8), "{:?}", sample.accelerations);
                let torque = -3.5 * m * 9.81 * l * first.sin();
                // Speeds, accelerations and reactions are solved one from the other, and each time rounding is divided by
                // the sine of the angle to the flat position, which is 0.01 where rows are no longer the polynomial's.
                assert!((force - torque).abs() < 5e-9 * m * 9.81 * l, "{l} {steps} {first}: {force} {torque}");
            }
            let x = output::<Parallelograms>("x");
            let range = found.extremes.outputs[x].unwrap();
            assert!((range.greatest.value - l).abs() < 1e-13 * l && (range.least.value + l).abs() < 1e-13 * l);
            assert!((found.extremes.time_ratios[x].unwrap().ratio - 1.0).abs() < 1e-9);
            let torque = found.extremes.forces[0].unwrap();
            assert!((torque.greatest.value / (3.5 * m * 9.81 * l) - 1.0).abs() < 1e-9, "{torque:?}");
            // The followers' own weights have no lever arm there: what the couplers carry along has no bound.
            assert_eq!(found.extremes.multipliers[0], None);
        }
    }
}

mechanism! {
    /// Two parallelograms on one shaft, the second ahead by a small angle: it is flat a little before the first.
    OneAheadOfTheOther;
    coordinates { crank [rad]; coupler_a [rad]; rocker_a [rad]; coupler_b [rad]; rocker_b [rad]; }
    parameters { a [m] = 0.2; b [m] = 0.6; ahead [rad] = 0.01; J [kg*m^2] = 0.1; }
    let A = a*[cos(crank), sin(crank)];
    let B = a*[cos(crank + ahead), sin(crank + ahead)];
    bodies { shaft: inertia J, angle crank; one: inertia J, angle rocker_a; two: inertia J, angle rocker_b; }
    constraints {
        loop_a: A + b*[cos(coupler_a), sin(coupler_a)] = [b, 0] + a*[cos(rocker_a), sin(rocker_a)];
        loop_b: B + b*[cos(coupler_b), sin(coupler_b)] = [b, 0] + a*[cos(rocker_b), sin(rocker_b)];
    }
    initial { crank = 0.5; dot(crank) = 1; guess coupler_a = 0; guess rocker_a = 0.5; guess coupler_b = 0; guess rocker_b = 0.5; }
}

/// Rows between two crossings and beside them are as good as others, however near the two are.
#[test]
fn crossings_near_each_other_are_told_apart() {
    let sizes = [(0.2, 0.6), (2e-4, 3e-4), (100.0, 150.0)];
    for ((a, b), ahead) in sizes.into_iter().cycle().zip([1e-6, 1e-4, 0.01, 0.3]) {
        let linkage = OneAheadOfTheOther { a, b, ahead, ..OneAheadOfTheOther::default() };
        let found = driven(linkage, "crank", [2.5, 3.5], 1.0, 200);
        assert_eq!((&found.trajectory.failure, found.values.len()), (&None, 201), "{ahead}");
        let crossings = found.branches.iter().map(|branch| branch.value);
        let expected = [PI - ahead, PI];
        assert!(crossings.zip(expected).all(|(at, expected)| (at - expected).abs() < 1e-9), "{ahead}");
        assert_eq!(found.branches.len(), 2, "{ahead}");
        let mut worst = [0.0f64; 3];
        let mut off = |k: usize, off: f64| worst[k] = worst[k].max(off.abs());
        for sample in &found.trajectory.samples {
            let [crank, coupler_a, rocker_a, coupler_b, rocker_b] = sample.state.positions;
            let angles = [coupler_a, rocker_a - crank, coupler_b, rocker_b - crank - ahead];
            angles.into_iter().for_each(|angle| off(0, angle));
            sample.state.speeds.iter().zip([1.0, 0.0, 1.0, 0.0, 1.0]).for_each(|(u, expected)| off(1, u - expected));
            sample.accelerations.iter().for_each(|acceleration| off(2, *acceleration));
        }
        println!("{ahead:.0e} rad: {worst:?}");
        // Positions to rounding; speeds and accelerations are each solved from what is before them.
        assert!(worst[0] < 1e-13 && worst[1] < 1e-12 && worst[2] < 1e-11, "{ahead}: {worst:?}");
    }
}

/// What is known of the motion beside a crossing is known from both sides of it, where the sweep begins or ends there too. These
/// are of such lengths that the last step would be a short one.
#[test]
fn sweeps_begin_and_end_beside_crossings() {
    let gap = 0.01;
    for far in (0..10).map(|k| 0.15 + 0.002 * f64::from(k)) {
        for range in [[FRAC_PI_2 - gap - far, FRAC_PI_2 - gap], [FRAC_PI_2 + gap, FRAC_PI_2 + gap + far]] {
            let linkage = Parallelograms { l: 0.01, ..Parallelograms::default() };
            let found = driven(linkage, "th_0", range, 1.0, 3);
            assert_eq!((&found.trajectory.failure, found.values.len()), (&None, 4), "{range:?}");
            let seconds = found.trajectory.samples.iter().flat_map(|sample| sample.accelerations);
            let off = seconds.fold(0.0f64, |most, second| most.max(second.abs()));
            println!("{range:?}: {off:e}");
            // The equations alone give 4e-11: rounding is amplified by the inverse cube of the sine, which is about the gap.
            assert!(off < 1e-11, "{off:e}");
        }
    }
}

/// The angle of the rocker on the branch to one side of the line from the crank pin to its pivot, and its distance to that line.
fn rocker([a, b, c, d]: [f64; 4], crank: f64, side: f64) -> (f64, f64) {
    let (x, y) = (a * crank.cos() - d, a * crank.sin());
    let square = x * x + y * y;
    let cosine = (c * c + square - b * b) / (2.0 * c * square.sqrt());
    (y.atan2(x) + side * cosine.acos(), 1.0 - cosine.abs())
}

/// A parallelogram whose crank is a little too short cannot fold: it bends over to the antiparallel branch where it is flat, the
/// sharper the less is missing, and back. On its branch the rocker stays to one side.
#[test]
fn what_nearly_crosses_is_not_crossed() {
    for missing in [1e-2, 1e-6, 1e-9] {
        let lengths = [0.2 * (1.0 - missing), 0.6, 0.2, 0.6];
        let [a, b, c, d] = lengths;
        let linkage = FourBar { a, b, c, d, ..FourBar::default() };
        let start = Start { positions: [0.5, 0.0, 0.5], ..declared_start(&linkage) };
        let found = kinematics(linkage, &start, &sweep::<FourBar>("theta2", [0.5, 9.0], 10.0, 100)).unwrap();
        assert_eq!((&found.trajectory.failure, found.branches.len()), (&None, 0), "{missing}");
        for sample in &found.trajectory.samples {
            let [crank, _, follower] = sample.state.positions;
            let (expected, flat) = rocker(lengths, crank, -1.0);
            let turns = (follower - expected) / TAU;
            // An arc cosine loses half of the digits where the linkage is flat.
            let bound = 1e-14 / flat.sqrt().max(1e-8);
            assert!((turns - turns.round()).abs() < bound, "{missing}: {:?} for {expected}", sample.state);
        }
    }
}

/// The same sweep of a four-bar from 1 mm to 100 m: angles, and torques by their scale.
#[test]
fn sizes_do_not_matter() {
    let of_size = |length: f64, mass: f64| {
        let [a, b, c, d] = [0.2, 0.5, 0.4, 0.5].map(|link| link * length);
        let linkage = Bars { a, b, c, d, m: mass, g: 9.81 * length };
        let angles = |x: f64, y: f64, phi: f64| [x * length, y * length, phi];
        let positions = [angles(0.05, 0.08, 1.0), angles(0.34, 0.26, 0.4), angles(0.53, 0.18, 1.5)].concat();
        let start = Start { positions: positions.try_into().unwrap(), ..declared_start(&linkage) };
        kinematics(linkage, &start, &sweep::<Bars>("crank_phi", [1.0, 1.0 + TAU], 20.0, 30)).unwrap()
    };
    let one = of_size(1.0, 1.0);
    assert_eq!((&one.trajectory.failure, one.values.len()), (&None, 31));
    for (length, mass) in [(1e-3, 1e-3), (1e-3, 1e3), (100.0, 1.0), (100.0, 1e3)] {
        let other = of_size(length, mass);
        assert_eq!((&other.trajectory.failure, other.values.len()), (&None, 31));
        let torque = mass * length * length;
        let greatest = |found: &Kinematics<Bars>| found.extremes.forces[0].unwrap().greatest;
        assert!((greatest(&other).value / torque / greatest(&one).value - 1.0).abs() < 1e-11);
        assert!((greatest(&other).at - greatest(&one).at).abs() < 1e-10);
        for (k, (a, b)) in one.trajectory.samples.iter().zip(&other.trajectory.samples).enumerate() {
            for angle in [2, 5, 8] {
                assert!((a.state.positions[angle] - b.state.positions[angle]).abs() < 1e-13);
                assert!((a.accelerations[angle] - b.accelerations[angle]).abs() < 1e-9);
            }
            assert!((other.forces[0][k] / torque - one.forces[0][k]).abs() < 1e-11 * greatest(&one).value);
        }
    }
}

mechanism! {
    /// A four-bar of free bodies and pins.
    Bars;
    parameters { a [m] = 0.2; b [m] = 0.5; c [m] = 0.4; d [m] = 0.5; m [kg] = 1; g [m/s^2] = 9.81; }
    bodies {
        crank: free, mass m, inertia m*a^2/12;
        coupler: free, mass m, inertia m*b^2/12;
        rocker: free, mass m, inertia m*c^2/12;
    }
    loads { gravity [0, -g]; }
    joints {
        A0: pin on(crank, [-a/2, 0]) to [0, 0];
        B0: pin on(rocker, [-c/2, 0]) to [d, 0];
        A: pin on(coupler, [-b/2, 0]) to on(crank, [a/2, 0]);
        B: pin on(coupler, [b/2, 0]) to on(rocker, [c/2, 0]);
    }
    initial { crank_phi = 1; dot(crank_phi) = 20; }
}

/// Through a flat linkage of free bodies too, from a start just before its crossing and to an end just before the next.
#[test]
fn rows_beside_crossings_have_all_their_digits() {
    let [a, b] = [0.2, 0.6];
    let linkage = Bars { a, b, c: a, d: b, ..Bars::default() };
    for (from, to) in [(PI - 1e-6, TAU - 1e-6), (0.5, 2.0 * PI)] {
        let at = |phi: f64| [a / 2.0 * phi.cos(), a / 2.0 * phi.sin(), phi];
        let coupler = |phi: f64| [b / 2.0 + a * phi.cos(), a * phi.sin(), 0.0];
        let rocker = |phi: f64| [b + a / 2.0 * phi.cos(), a / 2.0 * phi.sin(), phi];
        let all = |phi: f64| [at(phi), coupler(phi), rocker(phi)].concat();
        let start = Start { positions: all(0.5).try_into().unwrap(), ..declared_start(&linkage) };
        let found = kinematics(linkage, &start, &sweep::<Bars>("crank_phi", [from, to], 20.0, 64)).unwrap();
        assert_eq!((&found.trajectory.failure, found.values.len()), (&None, 65), "{from}");
        // Two rods of m g a/2 and one of m g a.
        let torque = |phi: f64| 2.0 * 9.81 * a * phi.cos();
        for (sample, force) in found.trajectory.samples.iter().zip(&found.forces[0]) {
            let (q, phi) = (sample.state.positions, sample.state.positions[2]);
            for (q, expected) in q.iter().zip(all(phi)) {
                assert!((q - expected).abs() < 1e-12, "{phi}: {q} {expected}");
            }
            assert!((force - torque(phi)).abs() < 1e-8, "{phi}: {force} {}", torque(phi));
        }
    }
}

/// The last row just before the linkage is flat: the torque is smooth there, as rows further away foretell.
#[test]
fn the_last_row_before_a_flat_position_is_there() {
    let end = 179.9999f64.to_radians();
    let found = driven(Bennett::default(), "theta1", [170f64.to_radians(), end], 1.0, 2);
    assert_eq!((&found.trajectory.failure, found.values.len()), (&None, 3));
    // Lagrange's polynomial through 8 rows to both sides, half a degree apart.
    let step = 0.5f64.to_radians();
    let around = driven(Bennett::default(), "theta1", [end - 4.0 * step, end + 4.0 * step], 1.0, 8);
    let places = [-4.0, -3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 4.0];
    let rows: Vec<f64> = (0..9).filter(|k| *k != 4).map(|k| around.forces[0][k]).collect();
    let weight = |j: usize| (0..8).filter(|i| *i != j).map(|i| places[i] / (places[i] - places[j])).product::<f64>();
    let foretold: f64 = (0..8).map(|j| weight(j) * rows[j]).sum();
    let last = found.forces[0][2];
    println!("torque {last}, foretold {foretold}");
    assert!((last / foretold - 1.0).abs() < 1e-5, "{last} {foretold}");
    // The last row of one sweep is the middle one of another, both beside the flat position.
    assert!((last / around.forces[0][4] - 1.0).abs() < 1e-10, "{last} {}", around.forces[0][4]);
}

mechanism! {
    /// A crank that slides in a slotted rocker.
    Shaper;
    coordinates { alpha [deg]; beta [deg]; }
    parameters { r [m] = 0.2; d [m] = 0.3; J [kg*m^2] = 1; }
    let A = [0, d] + r*[cos(alpha), sin(alpha)];
    bodies { crank: inertia J, angle alpha; rocker: inertia J, angle beta; }
    constraints { slot: A.x*sin(beta) = A.y*cos(beta); }
    initial { alpha = 270; beta = 90; }
}

/// Where the sweep begins may be off the start by rounding, and so may its end be off its beginning.
#[test]
fn ways_as_short_as_rounding_are_gone() {
    let right = FRAC_PI_2;
    for (from, to) in [(right, 2.1), (right.next_up(), 2.1), (right, right + 1e-15), (right + 1e-9, right + 1.1e-9)] {
        let found = driven(Shaper::default(), "beta", [from, to], 1.0, 10);
        assert_eq!((&found.trajectory.failure, found.values.len()), (&None, 11), "{from} {to}");
        for sample in &found.trajectory.samples {
            let [alpha, beta] = sample.state.positions;
            let (x, y) = (0.2 * alpha.cos(), 0.3 + 0.2 * alpha.sin());
            assert!((x * beta.sin() - y * beta.cos()).abs() < 1e-15);
        }
    }
}

mechanism! {
    /// A pin that is pushed along a roof.
    Roof;
    coordinates { x [mm]; y [mm]; }
    parameters { slope = 0.1; m [kg] = 1; g [m/s^2] = 9.81; }
    bodies { pin: mass m at [x, y]; }
    loads { gravity [0, -g]; }
    constraints { roof: y = -slope*abs(x); }
    initial { x = -20; dot(x) = 1; guess y = -2; }
}

/// Curves may have corners, as tables and moduli have; the push changes its sign there.
#[test]
fn a_corner_is_passed() {
    let found = driven(Roof::default(), "x", [-0.02, 0.03], 0.1, 50);
    assert_eq!((&found.trajectory.failure, found.values.len(), found.branches.len()), (&None, 51, 0));
    for (sample, force) in found.trajectory.samples.iter().zip(&found.forces[0]) {
        let [x, y] = sample.state.positions;
        assert!((y + 0.1 * x.abs()).abs() < 1e-16, "{x} {y}");
        // In the corner itself either slope will do.
        assert!(x.abs() < 1e-12 || (force + 0.1 * 9.81 * x.signum()).abs() < 1e-12, "{x}: {force}");
    }
    let push = found.extremes.forces[0].unwrap();
    assert!((push.greatest.value - 0.981).abs() < 1e-12 && (push.least.value + 0.981).abs() < 1e-12, "{push:?}");
}
