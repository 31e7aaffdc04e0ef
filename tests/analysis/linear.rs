//! Linearisation, modes and the matrices of a controller.

use models::{CartPole, DoublePendulum, FourBar, Pendulum};
use nalgebra::DMatrix;
use sim::{Compiled, Control, Input, Start, State, What, assemble, declared_start, equilibrium, linearize, mechanism};

mechanism! {
    /// A cart on a spring and a damper, pushed by a force, with a pendulum hung from it.
    Cart;
    coordinates { x [m]; phi [rad]; }
    parameters { M [kg] = 3; m [kg] = 1; l [m] = 0.5; k [N/m] = 40; c [N*s/m] = 2; F [N] = 0; }
    let P = [x + l*sin(phi), -l*cos(phi)];
    bodies { cart: mass M at [x, 0]; bob: mass m at P; }
    loads { gravity [0, -9.81 [m/s^2]]; force [F - k*x - c*dot(x), 0] at [x, 0]; }
    outputs { bob [mm] = P.x; acceleration [m/s^2] = ddot(x); push [N] = F; }
}

/// (M + m) x'' + m l phi'' + c x' + k x = F, x'' + l phi'' + g phi = 0, by hand: A, B, C and D.
#[test]
fn the_matrices_of_a_cart_with_a_pendulum() {
    let cart = Cart::default();
    let state = equilibrium(&cart, &declared_start(&cart)).unwrap().state;
    let force = Cart::<f64>::DESCRIPTION.parameters.iter().position(|p| p.name == "F").unwrap();
    let found = linearize(&cart, &state, &[Control::Parameter(force)]).unwrap();
    let (big, m, l, k, c, g) = (3.0, 1.0, 0.5, 40.0, 2.0, 9.81);
    // x'' = (F - c x' - k x + m g phi) / M.
    let x = [-k / big, m * g / big, -c / big, 0.0];
    let phi = [-x[0] / l, -(g + x[1]) / l, -x[2] / l, 0.0];
    let a = DMatrix::from_row_slice(4, 4, &[[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], x, phi].concat());
    let b = DMatrix::from_row_slice(4, 1, &[0.0, 0.0, 1.0 / big, -1.0 / (big * l)]);
    let c = DMatrix::from_row_slice(3, 4, &[[1.0, l, 0.0, 0.0], x, [0.0; 4]].concat());
    let d = DMatrix::from_row_slice(3, 1, &[0.0, 1.0 / big, 1.0]);
    // Entries below 30, by a few operations each.
    for (found, expected) in [(&found.a, a), (&found.b, b), (&found.c, c), (&found.d, d)] {
        assert!((found - &expected).amax() < 1e-12, "{found}{expected}");
    }
    // What constraints depend on is no input.
    let linkage = FourBar::default();
    let failure =
        linearize(&linkage, &assemble(&linkage, &declared_start(&linkage)).unwrap(), &[Control::Parameter(0)])
            .unwrap_err();
    assert!(matches!(failure.what, What::NotAnInput { parameter: "a" }), "{failure}");
}

/// (M + m) x'' + m l phi'' = u and x'' + l phi'' = g phi of the pole that stands, by hand; of the power u x' at speed v, where u is
/// not zero.
#[test]
fn the_inputs_of_a_cart_with_a_pole() {
    let cart: CartPole = CartPole::default();
    let state: State<CartPole> = State { time: 0.3, positions: [0.2, 0.0], speeds: [1.5, 0.0], work: 0.0 };
    let course = 3.0 * (4.0 * state.time).sin();
    for (cart, push) in [(cart, course), (CartPole { push: Input::Held(-2.0), ..cart }, -2.0)] {
        let found = linearize(&cart, &state, &[Control::Input(0), Control::Parameter(4)]).unwrap();
        let (big, m, l, g) = (1.0, 0.2, 0.5, 9.81);
        let x = [0.0, -m * g / big, 0.0, 0.0];
        let phi = [0.0, (big + m) * g / (big * l), 0.0, 0.0];
        let a = DMatrix::from_row_slice(4, 4, &[[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], x, phi].concat());
        // Free fall acts on a pole that stands by its angle alone.
        let b = DMatrix::from_row_slice(4, 2, &[0.0, 0.0, 0.0, 0.0, 1.0 / big, 0.0, -1.0 / (big * l), 0.0]);
        let c = DMatrix::from_row_slice(3, 4, &[1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, push, 0.0]);
        let d = DMatrix::from_row_slice(3, 2, &[0.0, 0.0, 0.0, 0.0, 1.5, 0.0]);
        for (found, expected) in [(&found.a, a), (&found.b, b), (&found.c, c), (&found.d, d)] {
            assert!((found - &expected).amax() < 1e-12, "{found}{expected}");
        }
    }
}

/// The modes of two equal slender rods: (4/3) a'' + b''/2 + (3/2)(g/l) a = 0 and a''/2 + b''/3 + (g/l) b/2 = 0, so that
/// s = w^2 l/g solves 7 s^2/36 - 7 s/6 + 3/4 = 0 and b/a = (3/2 - 4 s/3) / (s/2).
#[test]
fn the_modes_of_a_double_pendulum() {
    let double = DoublePendulum::default();
    let start = Start { positions: [0.1, -0.1], ..declared_start(&double) };
    let found = linearize(&double, &equilibrium(&double, &start).unwrap().state, &[]).unwrap();
    let squares = [-1.0, 1.0].map(|sign: f64| (7.0 / 6.0 + sign * (49.0f64 / 36.0 - 7.0 / 12.0).sqrt()) / (7.0 / 18.0));
    assert_eq!(found.modes.len(), 2);
    for (mode, square) in found.modes.iter().zip(squares) {
        let hertz = (square * 9.81 / 0.6).sqrt() / std::f64::consts::TAU;
        let ratio = (1.5 - 4.0 * square / 3.0) / (square / 2.0);
        let shape = mode.shape[1] / mode.shape[0];
        assert!((mode.frequency() - hertz).abs() < 1e-9 * hertz && mode.damping_ratio().abs() < 1e-9);
        assert!((shape.re - ratio).abs() < 1e-8 && shape.im.abs() < 1e-8, "{shape} {ratio}");
    }
}

#[test]
fn a_pendulum_swings_and_falls() {
    let pendulum = Pendulum::default();
    let at = |phi: f64| State { time: 0.0, positions: [phi], speeds: [0.0], work: 0.0 };
    let down = linearize(&pendulum, &at(0.0), &[]).unwrap();
    assert!((down.modes[0].eigenvalue.im - 9.81f64.sqrt()).abs() < 1e-12 && down.modes.len() == 1);
    let up = linearize(&pendulum, &at(std::f64::consts::PI), &[]).unwrap();
    assert!(up.modes.len() == 2 && up.modes.iter().any(|mode| (mode.eigenvalue.re - 9.81f64.sqrt()).abs() < 1e-12));
}

/// Of the four-bar at rest, by another way: potential and kinetic energy as functions of the crank angle alone, from its
/// geometry; w^2 = V'' / I.
#[test]
fn a_four_bar_about_its_equilibrium_has_the_frequency_of_its_energy() {
    let linkage = FourBar::default();
    let start = Start { positions: [-1.4, 0.9, 1.6], ..declared_start(&linkage) };
    let at = equilibrium(&linkage, &start).unwrap().state;
    let found = linearize(&linkage, &at, &[]).unwrap();
    assert_eq!((found.independent.as_slice(), found.modes.len()), (&[0][..], 1));
    let angles = |crank: f64| {
        let [x, y] = [0.2 * crank.cos() - 0.6, 0.2 * crank.sin()];
        let length = x.hypot(y);
        let corner = ((length * length + 0.25 - 0.36) / (2.0 * length * 0.5)).acos();
        // The rocker on the side on which it was assembled.
        let side = [1.0, -1.0].into_iter().map(|side| y.atan2(x) - side * corner);
        let rocker = side.min_by(|a, b| apart(*a, at.positions[2]).total_cmp(&apart(*b, at.positions[2]))).unwrap();
        let [bx, by] = [0.6 + 0.5 * rocker.cos() - 0.2 * crank.cos(), 0.5 * rocker.sin() - 0.2 * crank.sin()];
        [crank, by.atan2(bx), rocker]
    };
    let potential = |crank: f64| {
        let [a, b, c] = angles(crank);
        9.81 * (2.0 * 0.1 * a.sin() + 4.0 * (0.2 * a.sin() + 0.3 * b.sin()) + 3.0 * 0.25 * c.sin())
    };
    let h = 1e-3;
    let at_crank = at.positions[0];
    let d = |f: &dyn Fn(f64) -> f64| (8.0 * (f(h) - f(-h)) - f(2.0 * h) + f(-2.0 * h)) / (12.0 * h);
    let [b, c] = [1, 2].map(|i| d(&|step| angles(at_crank + step)[i]));
    let (m2, m3, m4) = (2.0 * 0.04 / 3.0, 4.0, 3.0 * 0.25 / 3.0);
    let turned = at.positions[1] - at_crank;
    let inertia = m2 + m3 * (0.04 + 0.09 * b * b + 0.12 * b * turned.cos()) + 0.12 * b * b + m4 * c * c;
    let v = |k: f64| potential(at_crank + k * h);
    let second = (-v(2.0) + 16.0 * v(1.0) - 30.0 * v(0.0) + 16.0 * v(-1.0) - v(-2.0)) / (12.0 * h * h);
    let expected = (second / inertia).sqrt();
    let found = found.modes[0].eigenvalue.im;
    println!("four-bar about its equilibrium: {found} {expected}");
    // Rounding of the second difference: 40 J times 1e-16 over 1e-6.
    assert!((found - expected).abs() < 1e-7 * expected, "{found} {expected}");
}

/// The distance between two angles.
fn apart(a: f64, b: f64) -> f64 {
    (0.5 * (a - b)).sin().abs()
}

/// In motion too: rows of A are the derivatives of theta2'' as a function of theta2 and its speed alone, the rest assembled.
#[test]
fn the_matrices_hold_in_motion() {
    let linkage = FourBar::default();
    let start = declared_start(&linkage);
    let acceleration = |change: [f64; 2]| {
        let start =
            Start { positions: [0.3 + change[0], 1.0, 1.7], speeds: [10.0 + change[1], 0.0, 0.0], ..start.clone() };
        let state = assemble(&linkage, &start).unwrap();
        (state.clone(), linkage.dynamics(0.0, &state.positions, &state.speeds).accelerations[0])
    };
    let found = linearize(&linkage, &acceleration([0.0; 2]).0, &[]).unwrap();
    let h = 1e-4;
    for (k, direction) in [[h, 0.0], [0.0, h]].into_iter().enumerate() {
        let at = |factor: f64| acceleration(direction.map(|entry| factor * entry)).1;
        let slope = (8.0 * (at(1.0) - at(-1.0)) - at(2.0) + at(-2.0)) / (12.0 * h);
        println!("{slope} {}", found.a[(1, k)]);
        // Rounding of accelerations of some 100 over 1e-4.
        assert!((slope - found.a[(1, k)]).abs() < 1e-8 * found.a.amax(), "{k}: {slope} {}", found.a);
    }
    assert_eq!((found.a[(0, 0)], found.a[(0, 1)]), (0.0, 1.0));
}

/// A skate: it goes where it points. Its place and heading are three coordinates, its speeds two.
#[test]
fn constraints_between_speeds_leave_more_coordinates_than_speeds() {
    let skate = Skate::default();
    let state = assemble(&skate, &declared_start(&skate)).unwrap();
    let found = linearize(&skate, &state, &[]).unwrap();
    assert_eq!((found.independent.len(), found.independent_speeds.len(), found.a.nrows()), (3, 2, 5));
    // x' = u cos psi, y' = u sin psi at psi = 0, u = 2: a turn by dpsi leads aside, y' = 2 dpsi.
    let heading = found.independent.iter().position(|j| *j == 2).unwrap();
    let aside = found.independent.iter().position(|j| *j == 1).unwrap();
    assert!((found.a[(aside, heading)] - 2.0).abs() < 1e-12, "{}", found.a);
}

mechanism! {
    /// A blade on ice.
    Skate;
    coordinates { x [m]; y [m]; psi [rad]; }
    parameters { m [kg] = 70; J [kg*m^2] = 4; }
    bodies { skater: mass m at [x, y], inertia J, angle psi; }
    constraints { blade: dot(x)*sin(psi) = dot(y)*cos(psi); }
    initial { x = 0; y = 0; psi = 0; dot(x) = 2; }
}

mechanism! {
    /// A pendulum whose bob touches an elastic wall while it hangs at rest.
    Touching;
    coordinates { phi [rad]; }
    let P = [sin(phi)*1 [m], -cos(phi)*1 [m]];
    bodies { bob: mass 1 [kg] at P; }
    loads {
        gravity [0, -9.81 [m/s^2]];
        force [-5e4 [N]*max(0, P.x/1 [m])^1.5, 0] at P;
    }
}

/// phi'' = -g phi: the wall's force is of higher order.
#[test]
fn a_contact_by_hertz_has_a_derivative_where_it_opens() {
    let touching: Touching = Touching::default();
    let state = equilibrium(&touching, &declared_start(&touching)).unwrap().state;
    let found = linearize(&touching, &state, &[]).unwrap();
    let expected = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -9.81, 0.0]);
    assert!((&found.a - &expected).amax() < 1e-12, "{}", found.a);
}

mechanism! {
    /// A double pendulum in water, with derivatives that are generated: the drag on each bob grows with the square of its speed.
    Dragged;
    coordinates { a [rad]; b [rad]; }
    parameters { m [kg] = 1; l [m] = 0.5; c [N*s^2/m^2] = 3; }
    let P = [l*sin(a), -l*cos(a)];
    let Q = P + [l*sin(b), -l*cos(b)];
    bodies { p: mass m at P; q: mass m at Q; }
    loads {
        gravity [0, -9.81 [m/s^2]];
        force -c*norm(dot(P))*dot(P) at P;
        force -dot(Q)*c*norm(dot(Q)) at Q;
    }
    kernels { dynamics_jacobian; }
}

/// At rest such a drag has the derivative 0: the modes are those of a vacuum, with frequencies g/l (2 -+ sqrt 2).
#[test]
fn a_drag_by_the_square_of_the_speed_does_not_damp_small_motions() {
    let pendulum = Dragged::default();
    let state = equilibrium(&pendulum, &declared_start(&pendulum)).unwrap().state;
    let found = linearize(&pendulum, &state, &[]).unwrap();
    let mut frequencies: Vec<f64> = found.eigenvalues.iter().map(|value| value.im).collect();
    frequencies.sort_by(f64::total_cmp);
    let [slow, fast] = [-1.0, 1.0].map(|sign: f64| (9.81 / 0.5 * (2.0 + sign * 2f64.sqrt())).sqrt());
    for (found, exact) in frequencies.iter().zip([-fast, -slow, slow, fast]) {
        // Eigenvalues below 10, of a few operations.
        assert!((found - exact).abs() < 1e-12, "{frequencies:?}");
    }
    assert!(found.eigenvalues.iter().all(|value| value.re.abs() < 1e-12), "{:?}", found.eigenvalues);
}

mechanism! {
    /// A ball on a spring in space, slowed by the square of its speed, whichever way that is written.
    Slowed;
    parameters { m [kg] = 2; k [N/m] = 50; c [N*s^2/m^2] = 3; }
    coordinates { x [m]; y [m]; z [m]; }
    let P = [x, y, z];
    let v = dot(P);
    bodies { ball: mass m at P; }
    loads {
        force -k*P at P;
        force -c/m*v*norm(v)*1 [kg] at P;
        force [-c*norm(v)*v.x, -c*v.y*norm(v), c*-v.z*norm(v)] at P;
    }
    outputs { slowing [N] = norm(v)*v.x*c; speed [m/s] = norm(v); }
}

/// All modes have the frequency sqrt(k/m); the force has the derivative 0, and the speed has none.
#[test]
fn a_force_that_vanishes_with_a_speed_has_a_derivative_where_the_speed_has_none() {
    let ball = Slowed::default();
    let state = assemble(&ball, &declared_start(&ball)).unwrap();
    let found = linearize(&ball, &state, &[]).unwrap();
    for value in &found.eigenvalues {
        assert!((value.im.abs() - 5.0).abs() < 1e-12 && value.re == 0.0, "{value}");
    }
    assert!(found.c.row(0).iter().all(|entry| *entry == 0.0), "{}", found.c);
    assert!(found.c.row(1).iter().any(|entry| entry.is_nan()), "{}", found.c);
}

mechanism! {
    /// A pendulum in Cartesian coordinates, of whose start the height is given: at the lowest point it tells nothing.
    ByHeight;
    coordinates { x [m]; y [m]; }
    parameters { l [m] = 1; m [kg] = 1; g [m/s^2] = 9.81; }
    bodies { bob: mass m at [x, y]; }
    loads { gravity [0, -g]; }
    constraints { rod: x^2 + y^2 = l^2; }
    initial { y = -0.8; guess x = 0.6; }
}

mechanism! {
    /// A mass in a bowl z = (x^2 + y^2)/(2 b), of whose start the height is given.
    Bowl;
    coordinates { x [m]; y [m]; z [m]; }
    parameters { b [m] = 0.8; m [kg] = 1; g [m/s^2] = 9.81; }
    bodies { ball: mass m at [x, y, z]; }
    loads { gravity [0, 0, -g]; }
    constraints { bowl: z = (x^2 + y^2)/(2*b); }
    initial { z = 0.3; guess x = 0.5; guess y = 0.2; }
}

mechanism! {
    /// A free body held by springs that turn it back with a moment k sin(angle) about each axis.
    TurnedBack;
    parameters { k [N*m] = 40; C [kg*m^2] = 4e-3; c [N/m] = 1000; m [kg] = 1; }
    bodies { body: free, mass m, inertia [C, C, C]; }
    let u = attitude(body)*[1, 0, 0];
    let v = attitude(body)*[0, 1, 0];
    let w = attitude(body)*[0, 0, 1];
    loads { potential k*(3 - u.x - v.y - w.z)/2 + c/2*(body_x^2 + body_y^2 + body_z^2); }
    initial { body_q1 = 0.1; body_q2 = -0.05; body_q3 = 0.2; }
}

/// A coordinate that turns back at the equilibrium does not tell where the others are: what follows from it as if it did has
/// frequencies that are too large by the root of 2. The frequencies sqrt(g/l), sqrt(g/b) twice, and sqrt(k/C) three times.
#[test]
fn what_turns_back_is_not_independent() {
    fn check<M: Compiled>(expected: &[f64], bound: f64) {
        let mechanism = M::defaults();
        let found = equilibrium(&mechanism, &declared_start(&mechanism)).unwrap();
        assert!(found.is_steady);
        let mut rates: Vec<f64> = found.eigenvalues.iter().map(|value| value.im).filter(|rate| *rate > 0.0).collect();
        rates.sort_by(f64::total_cmp);
        assert_eq!(rates.len(), expected.len(), "{rates:?}");
        for (rate, expected) in rates.iter().zip(expected) {
            assert!((rate / expected - 1.0).abs() < bound, "{rates:?} for {expected}");
        }
    }
    // Newton's method ends within 1e-8 of the equilibrium, where frequencies differ in second order.
    check::<ByHeight>(&[9.81f64.sqrt()], 1e-12);
    check::<Bowl>(&[(9.81f64 / 0.8).sqrt(); 2], 1e-12);
    let (slide, turn) = (1000f64.sqrt(), 1e4f64.sqrt());
    check::<TurnedBack>(&[slide, slide, slide, turn, turn, turn], 1e-9);
}

mechanism! {
    /// A mass on a spring under a force that comes and goes: at rest at t = 0 alone.
    Forced;
    coordinates { x [m]; }
    parameters { m [kg] = 1; k [N/m] = 100; F [N] = 2; w [rad/s] = 3; }
    bodies { b: mass m at [x, 0]; }
    loads { spring k, rest 0 on x; force F*cos(w*t) on x; }
}

#[test]
fn what_rests_for_an_instant_is_not_steady() {
    let forced = Forced::default();
    let state = equilibrium(&forced, &declared_start(&forced)).unwrap().state;
    assert!((state.positions[0] - 0.02).abs() < 1e-12);
    assert!(!linearize(&forced, &state, &[]).unwrap().is_steady);
    let free = Forced { F: 0.0, ..forced };
    let state = equilibrium(&free, &declared_start(&free)).unwrap().state;
    assert!(linearize(&free, &state, &[]).unwrap().is_steady);
}
