//! Equilibria of what is stiff beside what is soft, and on grounds that only push.

use sim::{What, declared_start, equilibrium, mechanism};

mechanism! {
    /// A mass on two springs along axes that are turned.
    Turned;
    coordinates { u [m]; v [m]; }
    parameters { m [kg] = 1; k [N/m] = 1e12; c [N/m] = 1; f [N] = 5; turn [rad] = 0; }
    let along = [cos(turn), sin(turn)];
    let across = [-sin(turn), cos(turn)];
    let P = [u, v];
    bodies { mass: mass m at P; }
    loads { spring k, rest 0 [m] on inner(along, P); spring c, rest 0 [m] on inner(across, P); force f*(along + across) at P; }
    initial { u = 0; v = 0; }
}

mechanism! {
    /// Two masses: a stiff spring holds the first at x0; the second is placed relative to it, and a soft one holds both together.
    Coupled;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; k [N/m] = 1e12; c [N/m] = 1; f [N] = 5; x0 [m] = 0; }
    bodies { first: mass m at [x, 0]; second: mass m at [x + y, 0]; }
    loads { spring k, rest x0 on x; spring c, rest 0 [m] on y; force [f, 0] at [x + y, 0]; }
    initial { x = 0; y = 0; }
}

mechanism! {
    /// A mass over a ground at height h that pushes, and on a soft spring to the side.
    Dropped;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; k [N/m] = 1e8; c [N/m] = 1; f [N] = 5; g [m/s^2] = 9.81; h [m] = 0; }
    let P = [x, y];
    bodies { mass: mass m at P; }
    loads { gravity [0, -g]; force [f - c*x, if y < h then k*(h - y) else 0] at P; }
    initial { x = 0; y = 1; }
}

mechanism! {
    /// Two masses that fall on the ground and upon each other.
    Stacked;
    coordinates { a [m]; b [m]; }
    parameters { m [kg] = 1; k [N/m] = 1e8; g [m/s^2] = 9.81; d [m] = 1; }
    let push = if b - a < d then k*(d - b + a) else 0;
    bodies { lower: mass m at [0, a]; upper: mass m at [0, b]; }
    loads { gravity [0, -g]; force [0, (if a < 0 then -k*a else 0) - push] at [0, a]; force [0, push] at [0, b]; }
    initial { a = 0.2; b = 1.5; }
}

mechanism! {
    /// Two masses in a row, the first on a soft spring, the second beyond a stiff one with a length.
    Hanging;
    coordinates { a [m]; b [m]; }
    parameters { k [N/m] = 1e12; c [N/m] = 10; g [m/s^2] = 9.81; d [m] = 1; }
    bodies { upper: mass 1 [kg] at [a, 0]; lower: mass 1 [kg] at [b, 0]; }
    loads { gravity [g, 0]; spring c, rest 0 [m] on a; spring k, rest d between a and b; }
    initial { a = 0; b = 1; }
}

mechanism! {
    /// Two charges of one sign.
    Repelled;
    coordinates { r [m]; }
    bodies { charge: mass 1 [kg] at [r, 0]; }
    loads { force [1 [N*m^2]/r^2, 0] at [r, 0]; }
    initial { r = 1; }
}

fn off(found: f64, expected: f64) -> f64 {
    (found / expected - 1.0).abs()
}

/// u = f/k and v = f/c, however far apart: each is beside itself. Stable or not, light or heavy.
#[test]
fn what_is_soft_moves_beside_what_is_stiff() {
    for k in [1e6, 1e9, 1e12, 1e15, 1e18, -1e12] {
        for c in [1.0, -1.0, 1e-6] {
            for m in [1e-6, 1.0, 1e3] {
                let springs = Turned { k, c, m, f: 5.0 * c, ..Default::default() };
                let found = equilibrium(&springs, &declared_start(&springs)).unwrap().state.positions;
                // Rounding of the load and of positions.
                assert!(off(found[0], 5.0 * c / k) < 1e-12 && off(found[1], 5.0) < 1e-12, "{k:e} {c} {m}: {found:?}");
            }
        }
    }
}

/// The same where masses couple what springs do not, also if positions are known up to 1e-16 alone.
#[test]
fn masses_that_couple_hide_nothing() {
    for k in [1e9, 1e12, 1e15] {
        for x0 in [0.0, 1.0] {
            let masses = Coupled { k, x0, ..Default::default() };
            let found = equilibrium(&masses, &declared_start(&masses)).unwrap().state.positions;
            assert!((found[0] - x0 - 5.0 / k).abs() < 1e-15 && off(found[1], 5.0) < 1e-12, "{k:e} {x0}: {found:?}");
        }
    }
}

/// About turned axes rounding of 1e-16 of the stiff spring hides the soft one: the answer is right, or there is none.
#[test]
fn about_turned_axes_the_soft_place_is_right_or_refused() {
    let mut refused = 0;
    for turn in [0.5, std::f64::consts::FRAC_PI_4, 1.1] {
        for k in [1e6, 1e9, 1e12, 1e13, 1e14, 1e15, 1e16, 1e18] {
            let springs = Turned { k, turn, ..Default::default() };
            match equilibrium(&springs, &declared_start(&springs)).map(|found| found.state.positions) {
                // The longest step that a search may end with, in units of 1 m.
                Ok([u, v]) => {
                    let expected = [-5.0 * turn.sin(), 5.0 * turn.cos()];
                    assert!(
                        (u - expected[0]).abs().max((v - expected[1]).abs()) < 1e-4 + 10.0 / k,
                        "{turn} {k:e}: {u} {v}"
                    );
                }
                Err(failure) => {
                    let is_named = matches!(failure.what, What::SoftBesideRounding { coordinate: "u" | "v" });
                    assert!(is_named && k > 1e12, "{turn} {k:e}: {failure}");
                    refused += 1;
                }
            }
        }
    }
    assert!(refused > 0);
}

/// It sinks in by m g / k from wherever it falls, and beside that goes as far as the soft spring lets it.
#[test]
fn a_mass_rests_on_a_stiff_ground() {
    for k in [1e2, 1e6, 1e8, 1e10, 1e12, 1e14] {
        for m in [1e-6, 1.0, 1e3] {
            // Where the ground is at 1 m, a depth below the rounding of that is none.
            let heights = if m < k * 1e-15 { 0.0 } else { 1.0 };
            for (h, y) in
                [(0.0, 1.0), (0.0, 0.0), (0.0, 1e-6), (0.0, -0.1), (0.0, 17.3), (heights, 2.0), (-heights, 2.0)]
            {
                let ball = Dropped { k, m, h, ..Default::default() };
                let start = sim::Start { positions: [0.0, y], ..declared_start(&ball) };
                let found = equilibrium(&ball, &start).map(|found| found.state.positions);
                let found = found.unwrap_or_else(|failure| panic!("{k:e} {m} {h} {y}: {failure}"));
                let depth = m * 9.81 / k;
                // Rounding of the height.
                let is_there = (found[1] - (h - depth)).abs() < 1e-12 * depth + 1e-15 * h.abs() + 1e-18;
                assert!(is_there && off(found[0], 5.0) < 1e-12, "{k:e} {m} {h} {y}: {found:?}");
            }
        }
    }
}

/// The lower one carries both.
#[test]
fn masses_rest_upon_each_other() {
    for k in [1e4, 1e8, 1e12] {
        let masses = Stacked { k, ..Default::default() };
        let [a, b] = equilibrium(&masses, &declared_start(&masses)).unwrap().state.positions;
        let weight = 9.81 / k;
        assert!((a + 2.0 * weight).abs() < 1e-15 && (b - (1.0 - 3.0 * weight)).abs() < 1e-15, "{k:e}: {a} {b}");
    }
}

/// In coordinates from the origin the stiff spring's rounding moves the soft one: the place is right to 1e-4 m or refused.
#[test]
fn a_soft_spring_behind_a_stiff_one_is_right_or_refused() {
    for k in [1e6, 1e9, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e18] {
        let masses = Hanging { k, ..Default::default() };
        match equilibrium(&masses, &declared_start(&masses)).map(|found| found.state.positions) {
            Ok([a, _]) => assert!((a - 1.962).abs() < 1e-4, "{k:e}: {a}"),
            Err(failure) => {
                assert!(matches!(failure.what, What::SoftBesideRounding { .. }) && k > 1e12, "{k:e}: {failure}")
            }
        }
    }
}

/// Where a force fades nothing rests.
#[test]
fn far_out_nothing_rests() {
    let charge = Repelled::default();
    let failure = equilibrium(&charge, &declared_start(&charge)).map(|found| found.state).unwrap_err();
    assert!(matches!(failure.what, What::NoEquilibrium { coordinate: "r", .. }), "{failure}");
}
