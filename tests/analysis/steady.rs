//! Small motions about steady ones, by closed forms.

use models::{Pendulum, Top};
use sim::{Compiled, Control, Linearization, assemble, declared_start, linearize, mechanism};
use tests::any_model::interpreted;

mechanism! {
    /// A top that stands upright and spins, in angles of which the last is its spin.
    Sleeping;
    coordinates { a [rad]; b [rad]; phi [rad]; }
    parameters { m [kg] = 1; g [m/s^2] = 9.81; l [m] = 0.5; I1 [kg*m^2] = 0.3; I3 [kg*m^2] = 0.02; w [rad/s] = 100; }
    let A = I1 - m*l^2;
    let R = euler(xyz, a, b, phi);
    bodies { top: mass m at R*[0, 0, l], inertia [A, A, I3], attitude R; }
    loads { gravity [0, 0, -g]; }
    initial { a = 0; b = 0; phi = 0; dot(a) = 0; dot(b) = 0; dot(phi) = w; }
}

mechanism! {
    /// The same on a ball joint, whose quaternion spins.
    SleepingBall;
    parameters { m [kg] = 1; g [m/s^2] = 9.81; l [m] = 0.5; I1 [kg*m^2] = 0.3; I3 [kg*m^2] = 0.02; w [rad/s] = 100; }
    let A = I1 - m*l^2;
    bodies { top: mass m, inertia [A, A, I3]; }
    loads { gravity [0, 0, -g]; }
    joints { foot: ball ground at [0, 0, 0] to top at [0, 0, -l]; }
    initial {
        foot_q0 = 1; foot_q1 = 0; foot_q2 = 0; foot_q3 = 0;
        dot(foot_q0) = 0; dot(foot_q1) = 0; dot(foot_q2) = 0; dot(foot_q3) = w/2;
    }
}

mechanism! {
    /// A thin disc that rolls upright, straight ahead.
    Disc;
    coordinates { x [m]; y [m]; z [m]; yaw [rad]; lean [rad]; spin [rad]; }
    parameters { m [kg] = 2; r [m] = 0.25; g [m/s^2] = 9.81; w [rad/s] = 9; }
    bodies {
        disc: mass m at [x, y, z], inertia [m*r^2/4, m*r^2/2, m*r^2/4], attitude euler(zxy, yaw, lean, spin);
    }
    loads { gravity [0, 0, -g]; }
    joints { floor: roll disc radius r axis [0, 1, 0] on [0, 0, 0] normal [0, 0, 1]; }
    initial {
        x = 0; y = 0; guess z = r; yaw = 0; lean = 0; spin = 0;
        dot(yaw) = 0; dot(lean) = 0; dot(spin) = w;
    }
}

fn about_start<M: Compiled>(mechanism: &M) -> Linearization<M> {
    let state = assemble(mechanism, &declared_start(mechanism)).unwrap();
    let inputs: [Control; 0] = [];
    let found = linearize(mechanism, &state, &inputs).unwrap();
    let entries = found.modes.iter().flat_map(|mode| &mode.shape);
    assert!(entries.clone().all(|entry| entry.re.is_finite() && entry.im.is_finite()), "{:?}", found.modes);
    found
}

/// I1 (a'' + i b'') - i I3 w (a' + i b') = m g l (a + i b), and a spin that nothing changes. Slow ones fall, fast ones nod.
#[test]
fn a_sleeping_top_wobbles_as_its_equation_says() {
    for size in [1e-3, 1.0, 100.0f64] {
        for w in [0.0, 100.0, 121.3, 150.0, 1e4] {
            let base: Sleeping = Sleeping::default();
            let of_mass = |inertia: f64| inertia * size * size;
            // Lengths and gravity by the same factor: the same motion.
            let top =
                Sleeping { l: base.l * size, g: base.g * size, I1: of_mass(base.I1), I3: of_mass(base.I3), w, ..base };
            let found = about_start(&top);
            assert!(found.unsteady.is_empty(), "{:?}", found.unsteady);
            assert_eq!(found.eigenvalues.iter().filter(|value| value.norm() == 0.0).count(), 2);
            let half = base.I3 * w / (2.0 * base.I1);
            let square = base.m * base.g * base.l / base.I1 - half * half;
            let expected: Vec<[f64; 2]> = match square > 0.0 {
                true => vec![[square.sqrt(), half], [-square.sqrt(), half]],
                false => vec![[0.0, half - (-square).sqrt()], [0.0, half + (-square).sqrt()]],
            };
            for [re, im] in expected {
                let off = |value: &nalgebra::Complex<f64>| (value.re - re).hypot(value.im.abs() - im);
                let nearest =
                    found.eigenvalues.iter().filter(|v| v.norm() > 0.0).map(off).fold(f64::INFINITY, f64::min);
                // Some roundings of the largest, over the distance of the pair.
                let bound = 1e-13 * (half + square.abs().sqrt()).powi(2) / square.abs().sqrt();
                println!("{size} {w}: {nearest:.1e} {bound:.1e}");
                assert!(nearest < bound, "{re} {im}: {:?}", found.eigenvalues);
            }
        }
    }
}

/// The quaternion of a top that spins does not stay, and is named.
#[test]
fn a_quaternion_that_spins_is_not_steady() {
    let found = about_start(&SleepingBall::default());
    let names: Vec<&str> =
        found.unsteady.iter().map(|j| SleepingBall::<f64>::DESCRIPTION.coordinates[*j].position.name).collect();
    assert_eq!(names, ["foot_q0", "foot_q3"]);
    // At rest it hangs over: no motion, nothing that changes.
    assert!(about_start(&SleepingBall { w: 0.0, ..Default::default() }).unsteady.is_empty());
    // On its way a pendulum is not steady, and at rest it is.
    let pendulum = Pendulum::default();
    let at = |phi: f64, speed: f64| sim::State { time: 0.0, positions: [phi], speeds: [speed], work: 0.0 };
    for (phi, speed, expected) in [(0.0, 0.0, vec![]), (0.5, 0.0, vec![0]), (0.5, 1.0, vec![0])] {
        assert_eq!(linearize(&pendulum, &at(phi, speed), &[]).unwrap().unsteady, expected, "{phi} {speed}");
    }
}

/// For a thin disc at the spin w: lean'' = -(12/5 w^2 - 4 g/(5 r)) lean, from (I + m r^2) lean'' + (2 I + m r^2) w yaw' = m g r lean
/// and I yaw'' = 2 I w lean' with I = m r^2/4; everything else stays.
#[test]
fn a_rolling_disc_leans_as_its_equation_says() {
    for size in [1e-3, 1.0, 100.0f64] {
        for w in [9.0, 1.5] {
            let base: Disc = Disc::default();
            let disc = Disc { r: base.r * size, g: base.g * size, w, ..base };
            let found = about_start(&disc);
            assert!(found.unsteady.is_empty(), "{:?}", found.unsteady);
            let square = 2.4 * w * w - 0.8 * base.g / base.r;
            let fastest = found.eigenvalues.iter().fold(0.0, |most: f64, value| most.max(value.norm()));
            println!("{size} {w}: {:e}", fastest / square.abs().sqrt() - 1.0);
            // Five zero modes beside it take no digit.
            assert!((fastest / square.abs().sqrt() - 1.0).abs() < 1e-13, "{:?}", found.eigenvalues);
            let pair = found.eigenvalues.iter().filter(|value| value.norm() > 0.5 * fastest);
            assert!(pair.clone().count() == 2 && pair.clone().all(|value| (value.re == 0.0) == (square > 0.0)));
            // The others are those of defective zeros: the square root of rounding.
            let others = found.eigenvalues.iter().filter(|value| value.norm() <= 0.5 * fastest);
            assert!(others.clone().all(|value| value.norm() < 1e-6 * fastest), "{:?}", found.eigenvalues);
        }
    }
}

/// About steady precession a top nods at w^2 = V''/I1, with V = (p_psi - p_phi cos theta)^2/(2 I1 sin^2 theta) + m g l cos theta.
#[test]
fn a_precessing_top_nods_as_its_effective_potential_says() {
    let top: Top = Top { nod: 0.0, ..Default::default() };
    let found = about_start(&top);
    assert!(found.unsteady.is_empty(), "{:?}", found.unsteady);
    let [psi, _, _] = found.state.speeds;
    let (inertia, theta) = (top.A + top.m * top.l * top.l, top.theta0);
    let along = top.C * top.spin;
    let about = inertia * theta.sin().powi(2) * psi + along * theta.cos();
    let (s, c) = theta.sin_cos();
    // With u = p_psi - p_phi c: V'' of u^2/(2 I1 s^2) + m g l c, where u' = p_phi s.
    let u = about - along * c;
    let second = (along * along + u * along * c / (s * s) - 4.0 * u * along * c / (s * s)) / inertia
        + u * u * (1.0 / (s * s) + 3.0 * c * c / s.powi(4)) / inertia
        - top.m * 9.81 * top.l * c;
    let expected = (second / inertia).sqrt();
    let nods = found.modes.iter().map(|mode| mode.eigenvalue.im).fold(0.0, f64::max);
    println!("{nods} {expected}");
    // Some roundings of terms ten times as large.
    assert!((nods / expected - 1.0).abs() < 1e-12, "{nods} {expected}");
}

mechanism! {
    /// A pendulum whose pivot shakes up and down.
    Shaken;
    coordinates { phi [rad]; }
    parameters { l [m] = 0.5; A [m] = 0.02; w [rad/s] = 150; }
    let P = [0, A*cos(w*t)] + l*[sin(phi), -cos(phi)];
    bodies { bob: mass 1 [kg] at P; }
    loads { gravity [0, -9.81 [m/s^2]]; }
}

mechanism! {
    /// A bead on a hoop that a drive turns.
    Hoop;
    coordinates { psi [rad]; th [rad]; }
    parameters { R [m] = 0.5; w [rad/s] = 8; J [kg*m^2] = 0.1; }
    let A = rotation(z, psi);
    bodies { h: inertia [J, J, J], attitude A; p: mass 1 [kg] at A*[R*sin(th), 0, -R*cos(th)]; }
    loads { gravity [0, 0, -9.81 [m/s^2]]; }
    constraints { drive: psi = w*t; }
    initial { th = 1; guess psi = 0; }
}

/// At rest A is constant unless time itself changes it: the hanging position of a shaken pendulum holds, its modes do not.
#[test]
fn what_time_changes_is_not_steady() {
    let shaken: Shaken = Shaken::default();
    let found = sim::equilibrium(&shaken, &declared_start(&shaken)).unwrap();
    assert!(!found.is_steady && !linearize(&shaken, &found.state, &[]).unwrap().is_steady);
    let still: Shaken = Shaken { A: 0.0, ..Shaken::default() };
    let found = sim::equilibrium(&still, &declared_start(&still)).unwrap();
    assert!(found.is_steady && linearize(&still, &found.state, &[]).unwrap().is_steady);
}

/// Nothing is at rest on a drive.
#[test]
fn a_driven_mechanism_has_no_equilibrium() {
    let hoop: Hoop = Hoop::default();
    let failure = sim::equilibrium(&hoop, &declared_start(&hoop)).unwrap_err();
    assert_eq!(failure.what, sim::What::Driven { constraint: "drive" });
}

/// What is steady does not depend on what moves fast beside it, nor on when loads change.
#[test]
fn a_fast_mode_hides_no_change() {
    let beside = |k: f64, start: &str| {
        format!(
            "pub Beside; coordinates {{ x [m]; phi [rad]; }} parameters {{ l [m] = 1; k [N/m] = {k:e}; }}
         bodies {{ mass: mass 1 [kg] at [x, 0]; bob: mass 1 [kg] at l*[sin(phi), -cos(phi)]; }}
         loads {{ gravity [0, -9.81 [m/s^2]]; force -k*x on x; }} initial {{ {start} }}"
        )
    };
    for k in [1.0, 1e4, 1e6, 1e8, 1e10] {
        for (start, is_steady) in [("phi = 0.5; dot(phi) = 4;", false), ("phi = 1;", false), ("phi = 0;", true)] {
            let found = about_interpreted(&beside(k, start));
            assert_eq!(found.is_steady, is_steady, "{k:e} {start}");
        }
    }
    let later = |stiffness: &str, start: &str| {
        format!(
            "pub Later; coordinates {{ x [m]; }} parameters {{ k [N/m] = 10; }}
         tables {{ f over [s] = linear {{ 0, 1; 1, 1; 2, 3; }} }}
         bodies {{ mass: mass 1 [kg] at [x, 0]; }} loads {{ force -{stiffness}*x on x; }} initial {{ {start} }}"
        )
    };
    for start in ["x = 0;", "x = 0; dot(x) = 1;"] {
        for (stiffness, is_steady) in [("k", true), ("k*(if t > 1 [s] then 10 else 1)", false), ("k*f(t)", false)] {
            let found = about_interpreted(&later(stiffness, start));
            assert_eq!(found.is_steady, is_steady, "{stiffness} {start}");
        }
    }
}

/// At a corner small motions have the stiffness of either side, and the matrices that of one.
#[test]
fn corners_are_told() {
    let cases = [
        ("force -k*x - (if x < 0 then 9*k*x else 0) on x;", true),
        ("force -k*f(x) on x;", true),
        ("force -k*x - 1 [N*s/m]*(if dot(x) > 0 then dot(x) else 2*dot(x)) on x;", true),
        ("force -k*x - 1 [N]*sign(dot(x)) on x;", true),
        ("force -k*x - (if x < 0.1 [m] then 0 else 9*k*(x - 0.1 [m])) on x;", false),
        ("force -k*x - k*max(x, 0)^2/(1 [m]) on x;", false),
        ("force -k*x - 2 [kg/m]*dot(x)*abs(dot(x)) on x;", false),
        ("force -k*x - 100*k*(1 [m])*max(0, x/(1 [m]))^1.5 on x;", false),
        ("force -k*x - k/2*abs(x) - 1e3*k*(1 [m])*max(0, x/(1 [m]))^1.5 on x;", true),
        ("force -k/2*abs(x) - 2e5*k/(1 [m])*x^2 on x;", true),
        ("spring k, rest 0 on x; dissipation 0.1 [kg/m]*norm(dot([x, 0]))^3;", false),
        ("force -k*x on x;", false),
    ];
    for (load, has_corner) in cases {
        let text = format!(
            "pub Corner; coordinates {{ x [m]; }} parameters {{ k [N/m] = 100; }}
             tables {{ f [m] over [m] = linear, continued {{ -1, -1; 0, 0; 1, 4; }} }}
             bodies {{ mass: mass 1 [kg] at [x, 0]; }} loads {{ {load} }} initial {{ x = 0; }}"
        );
        assert_eq!(about_interpreted(&text).has_corner, has_corner, "{load}");
        let model = interpreted(&text).unwrap();
        let start = declared_start(&model);
        assert_eq!(sim::equilibrium(&model, &start).unwrap().has_corner, has_corner, "{load}");
    }
}

/// At a corner or a jump of an output its rows hold on one side at most; what is smooth, or bends elsewhere, is not told. In the plane
/// of a mass on a spring, and of one on a rail by a constraint; small and large.
#[test]
fn corners_of_outputs_are_told() {
    let cases = [
        ("abs(x/l)", true),
        ("abs(dot(x)/(1 [m/s]))", true),
        ("max(x/l, 0)", true),
        ("if x > 0 then 1 else 2", true),
        ("f(x)/l", true),
        ("(x/l)^2", false),
        ("x*abs(x)/l^2", false),
        ("abs(x - l)/l", false),
        ("cos(x/l)", false),
        ("sin(x/l)^2 + cos(x/l)^2", false),
        ("1/cosh(x/l)", false),
        ("dot(x)/(1 [m/s])", false),
    ];
    for size in [1e-3, 1.0, 100.0] {
        for rail in ["", "constraints { rail: y = 0.3*x; }"] {
            for (output, is_bent) in cases {
                let place = if rail.is_empty() { "[x, 0]" } else { "[x, y]" };
                let y = if rail.is_empty() { "" } else { "y [m];" };
                let text = format!(
                    "pub Bent; coordinates {{ x [m]; {y} }} parameters {{ k [N/m] = 100; l [m] = {size}; }}
                     tables {{ f [m] over [m] = linear, continued {{ -1, -1; 0, 0; 1, 4; }} }} {rail}
                     bodies {{ mass: mass 1 [kg] at {place}; }} loads {{ force -k*x on x; }} initial {{ x = 0; }}
                     outputs {{ other = x/l; seen = {output}; }}"
                );
                let bent = about_interpreted(&text).bent_outputs;
                assert_eq!(bent, if is_bent { vec![1] } else { vec![] }, "{output}, {size}, {rail}");
            }
        }
    }
}

/// Laws that have a slope at rest but no second derivative, of a mass whose place is a coordinate twice: elimination refuses the pivot of
/// the second, and derivatives are differences.
#[test]
fn laws_that_are_smooth_once_have_their_slopes_beside_constraints() {
    // The stiffness of the monotone cubic through three rows with slopes 2 and 6 N/mm is their harmonic mean.
    let cases = [
        ("force -F(x) on x;", 3000.0, 0.0),
        ("spring 100 [N/m], rest 0 on x; force -1e4 [N/m^2]*x*abs(x) on x;", 100.0, 0.0),
        ("spring 4 [N/m], rest 0 on x; damper 1 [N*s/m] on x; damper 300 [kg/m]*rate*abs(rate) on x;", 4.0, 1.0),
        ("spring 25 [N/m], rest 0 on x; potential 1e3 [N/m^2]*max(0, x)^3;", 25.0, 0.0),
        // Smooth, but steep beside its slope: the quotient of fourth order is exact for it.
        ("spring 1e-3 [N/m], rest 0 on x; force -1e3 [N/m^3]*x^3 on x;", 1e-3, 0.0),
    ];
    for (loads, stiffness, damping) in cases {
        let text = format!(
            "pub Twice; coordinates {{ x [mm]; r [mm]; }}
             tables {{ F [N] over [mm] = monotone {{ -10, -20; 0, 0; 10, 60; }} }}
             bodies {{ b: mass 1 [kg] at [x, 0]; }} loads {{ {loads} }} constraints {{ k: r = x; }}"
        );
        let model = interpreted(&text).unwrap();
        let found = sim::equilibrium(&model, &declared_start(&model)).unwrap();
        let [sum, product] = [found.eigenvalues[0] + found.eigenvalues[1], found.eigenvalues[0] * found.eigenvalues[1]];
        // Differences are accurate to 1e-8 of a law whose second derivative jumps.
        assert!((product.re - stiffness).abs() < 1e-6 * stiffness, "{loads}: {product}");
        assert!((sum.re + damping).abs() < 1e-6, "{loads}: {sum}");
    }
}

/// A pendulum by position whose rod is written twice: no kernel has the derivatives, and those by differences keep a damping and an input
/// that are small beside the weight. A = -(c/m)(1 - x^2/l^2) for the speed of x, and B = (1 - x^2/l^2)/m.
#[test]
fn small_damping_and_inputs_are_kept_beside_redundant_constraints() {
    for (m, k, c, l) in
        [(5.0, 50.0, 0.01, 1.0), (5.0, 50.0, 1e-5, 1.0), (200.0, 4000.0, 1.0, 0.5), (200.0, 6000.0, 1.0, 0.5)]
    {
        let text = format!(
            "pub Rod; coordinates {{ x [m]; y [m]; }} inputs {{ F [N] = 0; }}
             bodies {{ b: mass {m} [kg] at [x, y]; }}
             loads {{ gravity [0, -9.81 [m/s^2]]; spring {k} [N/m], rest 0.1 [m] on x; damper {c} [N*s/m] on x; force F on x; }}
             constraints {{ rod: norm([x, y]) = {l} [m]; dup: x^2 + y^2 = ({l} [m])^2; }}
             initial {{ guess x = 0.1; guess y = -{l}; }}"
        );
        let model = interpreted(&text).unwrap();
        let state = sim::equilibrium(&model, &declared_start(&model)).unwrap().state;
        let found = linearize(&model, &state, &[Control::Input(0)]).unwrap();
        let part = 1.0 - (state.positions[0] / l).powi(2);
        // Both by differences: 1e-11 of the weight.
        assert!((found.a[(1, 1)] + c / m * part).abs() < 1e-8, "{m} {k} {c}: {}", found.a);
        assert!((found.b[(1, 0)] - part / m).abs() < 1e-8, "{m} {k} {c}: {}", found.b);
    }
}

/// Laws that change within a millionth of the scale of differences, or grow with a power below 2: what is not known is told.
#[test]
fn differences_that_do_not_settle_are_told() {
    for load in ["friction 1 [N], smooth 1e-6 [m/s] on x;", "force -1e9 [N]*max(0, x/(1 [m]))^1.5 on x;"] {
        let text = format!(
            "pub Sharp; coordinates {{ x [m]; r [m]; }} bodies {{ b: mass 1 [kg] at [x, 0]; }}
             loads {{ spring 100 [N/m], rest 0 on x; {load} }} constraints {{ k: r = x; }}"
        );
        assert!(about_interpreted(&text).has_corner, "{load}");
    }
}

/// A spring that stiffens with the cube of its way has no stiffness at rest, and nothing changes with time.
#[test]
fn what_rests_on_a_cubic_spring_is_steady() {
    let text = "pub Cubic; coordinates { x [m]; } bodies { b: mass 2 [kg] at [x, 0]; }
        loads { force -30 [N/m^3]*x^3 on x; } initial { x = 1; }";
    let model = interpreted(text).unwrap();
    assert!(sim::equilibrium(&model, &declared_start(&model)).unwrap().is_steady);
}

fn about_interpreted(text: &str) -> Linearization<tests::any_model::AnyModel> {
    let model = interpreted(text).unwrap();
    let start = assemble(&model, &declared_start(&model)).unwrap();
    linearize(&model, &start, &[]).unwrap()
}

/// Straight rolling at a steady speed, started by the speed of the frame: rows of A that are rounding do not change. Of the eigenvalues
/// one is that of the steering, which swings back as a caster does; the others are 0 and neither grow nor decay.
#[test]
fn straight_rolling_is_steady_however_it_starts() {
    let tricycle = |speed: f64| {
        format!(
            "pub Tricycle; coordinates {{ x [m]; y [m]; psi [rad]; delta [rad]; turn [rad]; }}
            parameters {{ l [m] = 0.7; c [m] = 0.07; r [m] = 0.35; }}
            let F = [x, y] + l*[cos(psi), sin(psi)];
            let d = [cos(psi + delta), sin(psi + delta)];
            let C = F - c*d;
            bodies {{
                frame: mass 10 [kg] at [x, y] + 0.3*l*[cos(psi), sin(psi)], inertia 1 [kg*m^2], angle psi;
                fork: inertia 0.02 [kg*m^2], angle psi + delta;
                wheel: inertia 0.1 [kg*m^2], angle turn;
            }}
            loads {{ spring 2 [N*m], rest 0 on delta; }}
            constraints {{
                rear: inner(dot([x, y]), [-sin(psi), cos(psi)]) = 0;
                front: inner(dot(C), [-sin(psi + delta), cos(psi + delta)]) = 0;
                rolls: inner(dot(C), d) = r*dot(turn);
            }}
            initial {{ x = 0; y = 0; psi = 0; delta = 0; dot(x) = {speed}; dot(delta) = 0; turn = 0; }}"
        )
    };
    for speed in [0.5, 1.0, 3.0, 5.0, 10.0] {
        let found = about_interpreted(&tricycle(speed));
        assert!(found.unsteady.is_empty() && found.is_steady, "{speed}: {:?}", found.unsteady);
        let fastest = found.eigenvalues.iter().fold(0.0, |most: f64, value| most.max(value.norm()));
        let rounding = found.modes.iter().filter(|mode| mode.eigenvalue.norm() < 1e-9 * fastest);
        assert!(
            rounding.clone().count() >= 4 && rounding.clone().all(|mode| mode.is_neutral),
            "{speed}: {:?}",
            found.modes
        );
    }
}
