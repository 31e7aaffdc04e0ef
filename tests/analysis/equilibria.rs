//! Where mechanisms rest, and where that cannot be said.

use models::{CartPole, DoublePendulum, Pendulum};
use sim::{Compiled, State, What, assemble, declared_start, equilibrium, linearize, mechanism};
use tests::any_model::interpreted;

mechanism! {
    /// A four-bar of three free bodies.
    FreeFourBar;
    parameters { a [m] = 0.02; m [kg] = 0.1; g [m/s^2] = 9.81; }
    let b = 2.5*a;
    let c = 2*a;
    let d = 2.5*a;
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
    initial {
        crank_phi = 1; dot(crank_phi) = 20;
        guess crank_x = 0.25*a; guess crank_y = 0.4*a; guess coupler_x = 1.7*a; guess coupler_y = 1.3*a; guess coupler_phi = 0.4;
        guess rocker_x = 2.65*a; guess rocker_y = 0.9*a; guess rocker_phi = 1.5;
    }
}

mechanism! {
    /// Two masses in a row on springs without a length, so that nothing but the start has one.
    Row;
    coordinates { a [m]; b [m]; }
    parameters { k [N/m] = 100; }
    bodies { first: mass 1 [kg] at [a, 0]; second: mass 2 [kg] at [b, 0]; }
    loads { spring k, rest 0 [m] on a; spring k, rest 0 [m] between a and b; }
    initial { a = 0.1; b = 0.2; }
}

mechanism! {
    /// Two equal rods, the end of the second on a rail through the pivot of the first.
    Folding;
    coordinates { theta [rad]; phi [rad]; }
    parameters { l [m] = 1; m [kg] = 1; g [m/s^2] = 9.81; }
    let A = l*[cos(theta), sin(theta)];
    let C = A + l*[cos(phi), sin(phi)];
    bodies {
        crank: mass m at A/2, inertia m*l^2/12, angle theta;
        rod: mass m at (A + C)/2, inertia m*l^2/12, angle phi;
    }
    loads { gravity [0, -g]; }
    constraints { rail: C.y = 0; }
    initial { theta = pi/4; dot(theta) = 1; guess phi = -pi/4; }
}

mechanism! {
    /// A pendulum whose circle is written down twice.
    TwiceHeld;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 9.81; k [N/m] = 3; }
    let P = [x, y];
    bodies { bob: mass m at P; }
    loads { gravity [0, -g]; force [-k*x, 0] at P; }
    constraints { circle: x^2 + y^2 = l^2; again: norm(P) = l; }
    initial { x = 0.6*l; guess y = -l; dot(x) = 0; }
    outputs { pull [N] = reaction(circle)*2*l; pull_again [N] = reaction(again); }
}

mechanism! {
    /// A weight that nothing holds.
    Falling;
    coordinates { x [m]; y [m]; }
    bodies { weight: mass 1 [kg] at [x, y]; }
    loads { gravity [0, -9.81 [m/s^2]]; }
    initial { x = 0; y = 0; }
}

mechanism! {
    /// A slider-crank: where the crank is is given, and how fast the rod turns.
    GivenSpeed;
    coordinates { theta [rad]; phi [rad]; }
    parameters { r [m] = 0.1; l [m] = 0.3; m [kg] = 1; }
    let A = r*[cos(theta), sin(theta)];
    bodies { crank: mass m at A; rod: mass m at A + l*[cos(phi), sin(phi)]; }
    constraints { rail: r*sin(theta) + l*sin(phi) = 0; }
    initial { theta = 0.5; guess phi = -0.2; dot(phi) = 3; }
}

/// Newton's method has nothing to go by at 90 degrees: they fall, and hang; and a pole near the upright stands.
#[test]
fn what_starts_horizontal_hangs() {
    let pendulum = Pendulum::default();
    let found = equilibrium(&pendulum, &declared_start(&pendulum)).unwrap();
    assert!(found.state.positions[0].abs() < 1e-12 && (found.eigenvalues[1].im - 9.81f64.sqrt()).abs() < 1e-12);
    let double = DoublePendulum::default();
    let found = equilibrium(&double, &declared_start(&double)).unwrap();
    assert!(found.state.positions.iter().all(|phi| phi.abs() < 1e-12), "{:?}", found.state);
    let cart: CartPole = CartPole::default();
    for phi in [0.2, std::f64::consts::PI - 0.2] {
        let start = sim::Start { positions: [0.0, phi], ..declared_start(&cart) };
        let found = equilibrium(&cart, &start).unwrap().state.positions[1];
        let nearest = if phi < 1.0 { 0.0 } else { std::f64::consts::PI };
        assert!((found - nearest).abs() < 1e-12, "{phi}: {found}");
    }
}

/// y of the centres of gravity in units of the crank, as a function of its angle, from the triangle of coupler and rocker.
fn height(crank: f64, side: f64) -> f64 {
    let [x, y] = [crank.cos() - 2.5, crank.sin()];
    let length = x.hypot(y);
    let corner = ((length * length + 4.0 - 6.25) / (4.0 * length)).acos();
    let rocker = y.atan2(x) - side * corner;
    let tip = 2.0 * rocker.sin();
    (crank.sin() + (crank.sin() + tip) + tip) / 2.0
}

/// The same position and the same frequencies beside sqrt(g/a) at every size, on a maximum or minimum of the height.
#[test]
fn a_linkage_rests_alike_at_every_size() {
    let mut first: Option<(f64, nalgebra::Complex<f64>)> = None;
    for a in [1e-3, 0.02, 1.0, 100.0f64] {
        for m in [1e-3, 1.0, 1e3] {
            let linkage = FreeFourBar { a, m, ..Default::default() };
            let found = equilibrium(&linkage, &declared_start(&linkage)).unwrap();
            let (crank, rocker) = (found.state.positions[2], found.state.positions[8]);
            let side = [1.0, -1.0].into_iter().find(|side| {
                let [x, y] = [crank.cos() - 2.5, crank.sin()];
                let corner = ((x * x + y * y + 4.0 - 6.25) / (4.0 * x.hypot(y))).acos();
                (0.5 * (y.atan2(x) - side * corner - rocker)).sin().abs() < 1e-8
            });
            let slope =
                |step: f64| (height(crank + step, side.unwrap()) - height(crank - step, side.unwrap())) / (2.0 * step);
            // The error of the difference is 1e-10 of a third derivative of some units.
            assert!(slope(1e-5).abs() < 1e-8, "{a} {m}: {crank} {}", slope(1e-5));
            let value = found.eigenvalues[1] / (9.81 / a).sqrt();
            println!("{a} {m}: {crank} {value}");
            let (place, same) = first.get_or_insert((crank, value));
            assert!(
                (crank - *place).abs() < 1e-11 && (value - *same).norm() < 1e-9 * same.norm(),
                "{a} {m}: {crank} {value}"
            );
        }
    }
}

/// Where the rods stand upon each other, or hang, two motions cross: that is said, and where.
#[test]
fn an_equilibrium_in_a_singular_position_is_named() {
    for l in [1e-3, 1.0, 100.0] {
        for (theta, guess) in [(0.25, -0.25), (-0.25, 0.25), (0.5, -0.5)]
            .map(|(a, b)| (a * std::f64::consts::PI, b * std::f64::consts::PI))
        {
            let rods = Folding { l, ..Default::default() };
            let start = sim::Start { positions: [theta, guess], ..declared_start(&rods) };
            let failure = equilibrium(&rods, &start).map(|found| found.state).unwrap_err();
            assert!(matches!(failure.what, What::SingularState { constraint: "rail" }), "{l} {theta}: {failure}");
            let upright = theta.signum() * std::f64::consts::FRAC_PI_2;
            // Half of the digits.
            assert!((failure.state[0].1 - upright).abs() < 1e-7, "{failure:?}");
        }
        // Small motions are refused there as well, and are those of the branch beside it: w^2 = -(3/8) g/l.
        let rods = Folding { l, ..Default::default() };
        let at = |theta: f64| State { time: 0.0, positions: [theta, -theta], speeds: [0.0; 2], work: 0.0 };
        let upright = std::f64::consts::FRAC_PI_2;
        for beside in [0.0, 1e-9] {
            let failure = linearize(&rods, &at(upright + beside), &[]).map(|found| found.a).unwrap_err();
            assert!(matches!(failure.what, What::SingularState { constraint: "rail" }), "{beside}: {failure}");
        }
        let beside = linearize(&rods, &at(upright + 1e-3), &[]).unwrap().eigenvalues;
        let expected = (9.81 * 3.0 / 8.0 / l).sqrt();
        // Of the second order of 1e-3.
        assert!(beside.iter().all(|value| (value.re.abs() / expected - 1.0).abs() < 1e-5), "{beside:?} {expected}");
    }
}

/// About the lowest point w^2 = g/l + k/m; what the two share of the weight is their own matter, its derivative is not: with x the pull
/// changes in the second order alone.
#[test]
fn redundant_constraints_change_no_small_motion() {
    for l in [1e-3, 1.0, 100.0] {
        let held = TwiceHeld { l, ..Default::default() };
        let found = equilibrium(&held, &declared_start(&held)).unwrap();
        assert!(found.state.positions[0].abs() < 1e-11 * l && (found.state.positions[1] + l).abs() < 1e-12 * l);
        let expected = (9.81 / l + 3.0f64).sqrt();
        println!("{l}: {:e}", found.eigenvalues[1].im / expected - 1.0);
        // By differences, which are good to some 1e-11.
        assert!((found.eigenvalues[1].im / expected - 1.0).abs() < 1e-10, "{:?} {expected}", found.eigenvalues);
        let small = linearize(&held, &found.state, &[]).unwrap();
        assert_eq!((small.independent.as_slice(), small.a.nrows()), (&[0][..], 2));
        assert!(small.c.iter().all(|slope| (slope * l).abs() < 1e-7), "{}", small.c);
    }
}

#[test]
fn what_nothing_holds_has_no_equilibrium() {
    let falling = Falling::default();
    let failure = equilibrium(&falling, &declared_start(&falling)).map(|found| found.state).unwrap_err();
    assert!(
        matches!(failure.what, What::NoEquilibrium { coordinate: "y", acceleration } if (acceleration - 9.81).abs() < 1e-12),
        "{failure}"
    );
}

/// The coordinate whose speed is given is independent, before the one whose value is.
#[test]
fn given_speeds_say_what_is_independent() {
    let linkage = GivenSpeed::default();
    let state = assemble(&linkage, &declared_start(&linkage)).unwrap();
    let found = linearize(&linkage, &state, &[]).unwrap();
    assert_eq!((found.independent.as_slice(), found.independent_speeds.as_slice()), (&[1][..], &[1][..]));
    // Both say the same: the rate of theta' with phi by r cos(theta) theta' + l cos(phi) phi' = 0 has the same eigenvalues.
    let names = GivenSpeed::<f64>::DESCRIPTION.coordinates;
    assert!(names[1].speed_given && !names[0].speed_given);
}

/// The equilibrium is where the mechanism has no size, whatever the start's is. Frequencies of small motions by hand.
#[test]
fn a_mechanism_without_lengths_rests_where_it_has_none() {
    let row = Row::default();
    let declared = declared_start(&row);
    for scale in [1e-6, 1.0, 1e3] {
        let mut start = declared.clone();
        start.positions.iter_mut().for_each(|value| *value *= scale);
        let found = equilibrium(&row, &start).unwrap();
        assert!(found.state.positions.iter().all(|value| value.abs() < 1e-15 * scale), "{:?}", found.state.positions);
        // m1 = 1, m2 = 2, both springs 100: w^4 - 250 w^2 + 5000 = 0.
        let mut frequencies: Vec<f64> = found.eigenvalues.iter().map(|value| value.im).collect();
        frequencies.sort_by(f64::total_cmp);
        let expected = [125.0 - 10625f64.sqrt(), 125.0 + 10625f64.sqrt()].map(f64::sqrt);
        for (found, expected) in frequencies[2..].iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 1e-12, "{frequencies:?}");
        }
    }
}

/// What nothing holds is at rest under no force, however far from the origin it is, how heavy, and how weak the force.
#[test]
fn what_nothing_holds_rests_under_no_force() {
    let heavy = |force: f64| {
        format!(
            "pub Heavy; coordinates {{ x [m]; }} parameters {{ R [km] = 6371; }} bodies {{ a: mass 1e3 [kg] at [R + x, 0]; }} loads {{ force {force:e} [N] on x; }}"
        )
    };
    let cart = |length: f64, force: f64| {
        format!(
            "pub Cart; coordinates {{ x [m]; phi [rad]; }} parameters {{ l [m] = {length}; g [m/s^2] = 9.81; }}
             bodies {{ c: mass 1 [kg] at [x, 0]; b: mass 0.2 [kg] at [x, 0] + l*[sin(phi), -cos(phi)]; }}
             loads {{ gravity [0, -g]; force {force:e} [N] on x; }} initial {{ phi = 0.1; }}"
        )
    };
    for force in [50.0, 1e-3, 1e-7, 0.0] {
        // 1e-13 of the radius of the earth per s^2 is rounding.
        let found = [heavy(1e5 * force), cart(0.5, force), cart(10.0, force), cart(1000.0, force)].map(|text| {
            let model = interpreted(&text).unwrap();
            equilibrium(&model, &declared_start(&model)).map(|found| found.state.positions[0])
        });
        assert!(found.iter().all(|found| found.is_ok() == (force == 0.0)), "{force}: {found:?}");
    }
}

/// F = k x^3, and a mass between two springs across their length, F = k y^3/l^2 for small y: no stiffness where the search begins.
#[test]
fn an_equilibrium_is_found_from_where_nothing_is_stiff() {
    for force in [1.0, 1e-6, 1e-9, 1e-12] {
        for mass in [1.0, 1e6] {
            let text = format!(
                "pub Soft; coordinates {{ x [m]; }} bodies {{ a: mass {mass:e} [kg] at [x, 0]; }} loads {{ force {force:e}*{mass:e} [N] - {mass:e} [N/m^3]*x^3 on x; }}"
            );
            let model = interpreted(&text).unwrap();
            let found = equilibrium(&model, &declared_start(&model)).unwrap().state.positions[0];
            assert!((found / f64::cbrt(force) - 1.0).abs() < 1e-6, "{force:e} {mass}: {found:e}");
        }
    }
    let text = "pub Strings; coordinates { y [m]; } parameters { k [N/m] = 1e4; l [m] = 1; F [N] = 1e-5; }
        bodies { a: mass 1000 [kg] at [0, y]; }
        loads { force F on y; spring k, length l from [-l, 0] to [0, y]; spring k, length l from [l, 0] to [0, y]; }";
    let model = interpreted(text).unwrap();
    let found = equilibrium(&model, &declared_start(&model)).unwrap().state.positions[0];
    // k y^3/l^2 (1 - 3/4 (y/l)^2 ..) = F.
    assert!((found - 1e-3 * (1.0 + 0.25e-6)).abs() < 1e-11, "{found:e}");
}

/// A three-hinged arch, whose reactions follow from moments about its hinges, with parts so light that the rounding of its forces would
/// accelerate them.
#[test]
fn a_structure_rests_however_light_its_parts_are() {
    for mass in [1.0, 1e-3, 1e-6, 1e-9] {
        let text = format!(
            "pub Arch; bodies {{ L: free, mass {mass:e} [kg], inertia {mass:e} [kg*m^2]; R: free, mass {mass:e} [kg], inertia {mass:e} [kg*m^2]; }}
             joints {{ a: pin on(L, [0, 0]) to [0, 0]; b: pin on(R, [0, 0]) to [12 [m], 0];
                 c: pin on(L, [6 [m], 4 [m]]) to on(R, [-6 [m], 4 [m]]); }}
             loads {{ force [0, -9000 [N]] at on(L, [2 [m], 3 [m]]); }}
             initial {{ guess R_x = 12 [m]; }}"
        );
        let arch = interpreted(&text).unwrap();
        let found = equilibrium(&arch, &declared_start(&arch)).unwrap();
        assert!(found.eigenvalues.is_empty());
        // About A: 12 B_y = 2 * 9000; the right part is a strut along (-6, 4): B_x = -6/4 B_y.
        let expected = [2250.0, 7500.0, -2250.0, 1500.0];
        for (multiplier, expected) in found.multipliers.as_ref().iter().zip(expected) {
            assert!((multiplier.abs() - f64::abs(expected)).abs() < 1e-6, "{mass}: {multiplier} for {expected}");
        }
    }
}

/// Inertias that no body has are refused by every analysis.
#[test]
fn analyses_refuse_impossible_inertias() {
    let text = "pub Disc; coordinates { a [rad]; } parameters { A [kg*m^2] = 1; C [kg*m^2] = 3; }
        bodies { b: mass 1 [kg] at [0, 0, 0], inertia [A, A, C], attitude rotation([0, 0, 1], a); }
        loads { spring 5 [N*m], rest 0 on a; } initial { a = 0.1; }";
    let disc = interpreted(text).unwrap();
    let start = declared_start(&disc);
    let state = assemble(&disc, &start).unwrap();
    let codes = [
        equilibrium(&disc, &start).err().map(|failure| failure.what.code()),
        linearize(&disc, &state, &[]).err().map(|failure| failure.what.code()),
    ];
    assert_eq!(codes, [Some("E-IMPOSSIBLE-INERTIA"); 2]);
}
