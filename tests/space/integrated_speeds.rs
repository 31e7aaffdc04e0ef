//! Motions that are integrated in generalised speeds: of a satellite against Euler's equations, which Jacobi's elliptic
//! functions solve, and of others against the same mechanism without.

use crate::torque_free::{Closed, of_quaternion, product, transposed};
use sim::{Compiled, Method, Rows, Run, Settings, Stabilisation, Table, mechanism};
use tests::any_model::{AnyModel, run_with};

/// A mechanism twice: with generalised speeds, and without.
macro_rules! twice {
    ($with:ident $without:ident { $($before:tt)* } speeds { $($speeds:tt)* } $($after:tt)*) => {
        mechanism! { $with; $($before)* speeds { $($speeds)* } $($after)* }
        mechanism! { $without; $($before)* $($after)* }
    };
}

twice! {
    // A body on which nothing acts.
    Satellite Quaternion {
        parameters { m [kg] = 2; A [kg*m^2] = 1; B [kg*m^2] = 2; C [kg*m^2] = 3; w1 [rad/s] = 1; w3 [rad/s] = 1; }
        bodies { body: free, mass m, inertia [A, B, C]; }
        let w = transpose(attitude(body))*omega(body);
    }
    speeds {
        ux [rad/s] = w.x;
        uy [rad/s] = w.y;
        uz [rad/s] = w.z;
        vx [m/s] = dot(body_x);
        vy [m/s] = dot(body_y);
        vz [m/s] = dot(body_z);
    }
    initial { dot(body_x) = 1; dot(body_q1) = w1/2; dot(body_q3) = w3/2; }
    outputs { wx [rad/s] = w.x; wy [rad/s] = w.y; wz [rad/s] = w.z; }
}

twice! {
    // A disc that rolls and leans: its contact is in the coordinates, its rolling between speeds.
    RollingInSpeeds Rolling {
        coordinates { x [m]; y [m]; psi [rad]; lean [rad]; phi [rad]; }
        parameters { m [kg] = 0.5; r [m] = 0.2; g [m/s^2] = 9.81; }
        let S = rotation([0, 0, 1], psi)*rotation([1, 0, 0], lean);
        bodies { disc: mass m at [x, y, r*cos(lean)], inertia [m*r^2/4, m*r^2/2, m*r^2/4], attitude S*rotation([0, 1, 0], phi); }
        loads { gravity [0, 0, -g]; }
        let slip = dot([x, y, r*cos(lean)]) + cross(omega(disc), S*[0, 0, -r]);
        constraints { slip_x: slip.x = 0; slip_y: slip.y = 0; }
        let w = transpose(S)*omega(disc);
    }
    speeds { roll [rad/s] = w.y; nod [rad/s] = w.x; turn [rad/s] = w.z; }
    initial { lean = -0.3; dot(phi) = 20; dot(psi) = 1; }
    outputs { push [N] = reaction(slip_x); }
}

twice! {
    // A four-bar by the absolute angles of its bars, driven by a moment that depends on a speed.
    LoopInSpeeds Loop {
        coordinates { a [rad]; b [rad]; c [rad]; }
        parameters { m [kg] = 1; l [m] = 0.3; g [m/s^2] = 9.81; }
        let P = l*[cos(a), sin(a)];
        let Q = P + 3*l*[cos(b), sin(b)];
        bodies {
            crank: mass m at P/2, inertia m*l^2/12, angle a;
            coupler: mass m at (P + Q)/2, inertia m*l^2, angle b;
            rocker: mass m at [3*l, 0] + l*[cos(c), sin(c)], inertia m*l^2/3, angle c;
        }
        loads { gravity [0, -g]; torque (20 [rad/s] - dot(a))*(0.3 [N*m*s]) on crank; }
        constraints { pin: Q = [3*l, 0] + 2*l*[cos(c), sin(c)]; }
    }
    speeds { crank_speed [rad/s] = dot(a); bend [rad/s] = dot(a) + dot(b); swing [rad/s] = dot(c) - dot(b)/2; }
    initial { a = 1; dot(a) = 15; guess b = 0.3; guess c = 1.5; }
}

twice! {
    // A pendulum whose generalised speed says nothing of it where it is horizontal.
    PendulumByHeight Pendulum {
        coordinates { a [rad]; }
        parameters { m [kg] = 1; l [m] = 0.5; g [m/s^2] = 9.81; start [rad] = 0.2; rate [rad/s] = 9; }
        bodies { bob: mass m at l*[sin(a), -cos(a)]; }
        loads { gravity [0, -g]; }
    }
    speeds { across [m/s] = l*cos(a)*dot(a); }
    initial { a = start; dot(a) = rate; }
    outputs { energy [J] = m*l^2*dot(a)^2/2 - m*g*l*cos(a); }
}

twice! {
    // A plate with a drum that a clutch lets go, thrown against the ground, from which it bounces.
    ThrownInSpeeds Thrown {
        coordinates { x [m]; y [m]; a [rad]; b [rad]; }
        parameters { m [kg] = 2; r [m] = 0.3; g [m/s^2] = 9.81; }
        bodies { plate: mass m at [x, y], inertia m*r^2, angle a; drum: inertia m*r^2/4, angle b; }
        loads { gravity [0, -g]; force -0.3 [N*s/m]*dot([x, y]) at [x, y]; }
        constraints {
            clutch: dot(a) = 2*dot(b) + sin(t/(1 [s]))/(1 [s]) initially active;
            ground: y = 0 initially released;
        }
    }
    speeds {
        ahead [m/s] = cos(a)*dot(x) + sin(a)*dot(y);
        aside [m/s] = cos(a)*dot(y) - sin(a)*dot(x);
        rim [m/s] = r*dot(a) + cos(a)*dot(x)/2 + sin(a)*dot(y)/2;
        drum_rate [rad/s] = dot(b);
    }
    initial { y = 1; dot(x) = 2; dot(a) = 3; }
    events { slip: t = 0.2937 [s] rising { release clutch; } bounce: y = 0 falling { impact ground restitution 0.8; } }
}

/// A rate of nutation that is neither small nor near the separatrix.
const MOMENTUM: f64 = 4.0;
const NUTATION: f64 = 0.3;
const END: f64 = 60.0;

fn closed() -> Closed {
    Closed::new([1.0, 2.0, 3.0], MOMENTUM, NUTATION)
}

/// The satellite, or the same without generalised speeds, as it turns in the closed form.
fn turning<M: Compiled>(settings: &Settings) -> Run<AnyModel> {
    let mut parameters = M::defaults().parameters();
    let [w1, _, w3] = closed().spin(0.0);
    parameters.as_mut()[4..].copy_from_slice(&[w1, w3]);
    let run = run_with(M::defaults().with_parameters(parameters), settings).unwrap();
    assert_eq!(run.trajectory.failure, None);
    run
}

/// How far angular velocity and attitude are off at most, in any row.
fn off(run: &Run<AnyModel>) -> [f64; 2] {
    let (closed, table) = (closed(), Table::of(&run.mechanism, &run.trajectory));
    let start = transposed(closed.attitude(0.0));
    let value = |name: &str, row: usize| table.column(name).unwrap().values[row];
    let mut off = [0.0f64; 2];
    for (row, t) in table.times().iter().enumerate() {
        let spin = ["wx", "wy", "wz"].map(|name| value(name, row));
        let attitude = of_quaternion([0, 1, 2, 3].map(|i| value(&format!("body_q{i}"), row)));
        let largest = |found: &[f64], expected: &[f64]| {
            found.iter().zip(expected).fold(0.0f64, |off, (found, expected)| off.max((found - expected).abs()))
        };
        off[0] = off[0].max(largest(&spin, &closed.spin(*t)));
        off[1] = off[1].max(largest(&attitude, &product(start, closed.attitude(*t))));
    }
    off
}

/// Rows between steps are as good as steps. The rates of the quaternion lose ten times as much.
#[test]
fn a_satellite_turns_by_eulers_equations() {
    let all: &[_] = &[(Method::Dop853, 1e-11), (Method::Radau5, 1e-10), (Method::Dopri5, 1e-12)];
    for &(method, rtol) in tests::sampled(&all[..2], all) {
        for rows in [1, 1000] {
            let settings = Settings { rows: Rows::Even(rows), ..Settings::adaptive(method, END, rtol) };
            let (run, other) = (turning::<Satellite>(&settings), turning::<Quaternion>(&settings));
            let ([spin, attitude], [without, _]) = (off(&run), off(&other));
            println!(
                "{method:?} {rtol:e}, {rows} rows: spin off by {spin:.1e} ({without:.1e} without speeds), attitude by \
                 {attitude:.1e}, {} steps ({})",
                run.steps.accepted, other.steps.accepted
            );
            // Some hundred steps, each good to the tolerance; entries of the attitude change by twice a quaternion's.
            assert!(spin < 1e-9 && attitude < 4e-9, "{method:?}: {spin:e} {attitude:e}");
            assert!(run.energy_balance < 1e-9, "{:e}", run.energy_balance);
        }
    }
    let settings = Settings::adaptive(Method::Dop853, END, 1e-11);
    let [with, without] = [off(&turning::<Satellite>(&settings))[0], off(&turning::<Quaternion>(&settings))[0]];
    assert!(5.0 * with < without, "{with:e} {without:e}");
}

/// All ways on the constraints keep generalised speeds.
#[test]
fn a_satellite_is_kept_in_every_way() {
    use Stabilisation::{Baumgarte, MassProjection, None, Partitioning};
    for stabilisation in [MassProjection, Partitioning, Baumgarte(10.0), None] {
        let settings = Settings { stabilisation, ..Settings::adaptive(Method::Dop853, END, 1e-11) };
        let [spin, attitude] = off(&turning::<Satellite>(&settings));
        println!("{stabilisation:?}: spin off by {spin:.1e}, attitude by {attitude:.1e}");
        assert!(spin < 1e-9 && attitude < 4e-9, "{stabilisation:?}: {spin:e} {attitude:e}");
    }
    let run = turning::<Satellite>(&Settings::equal_steps(Method::Dop853, END, 1500));
    let [spin, attitude] = off(&run);
    // Rounding of 1e-16 in each of some thousand steps; nothing of it adds up.
    assert!(spin < 1e-11 && attitude < 1e-11, "{spin:e} {attitude:e}");
    assert_eq!(run.evaluations, 12 * 1500 + 1);
}

#[test]
fn equal_steps_keep_their_order() {
    let orders = [(Method::Euler, 1, 40_000), (Method::Heun, 2, 8000), (Method::Rk3, 3, 4000), (Method::Rk4, 4, 2000)];
    for (method, order, steps) in orders {
        let errors = [steps, 2 * steps].map(|steps| {
            let settings = Settings { rows: Rows::Even(8), ..Settings::equal_steps(method, 5.0, steps / 10) };
            off(&turning::<Satellite>(&settings)).into_iter().fold(0.0, f64::max)
        });
        let found = (errors[0] / errors[1]).log2();
        println!("{method:?}: {:.1e} and {:.1e}, order {found:.2}", errors[0], errors[1]);
        assert!((found - f64::from(order)).abs() < 0.25, "{method:?}: {found}");
    }
}

/// The largest difference of all columns of two runs but the time, beside the largest number in each.
fn apart(a: &Run<AnyModel>, b: &Run<AnyModel>) -> f64 {
    assert_eq!((&a.trajectory.failure, &b.trajectory.failure), (&None, &None));
    let [a, b] = [Table::of(&a.mechanism, &a.trajectory), Table::of(&b.mechanism, &b.trajectory)];
    assert_eq!((a.columns.len(), a.times().len()), (b.columns.len(), b.times().len()));
    let differences = a.columns.iter().zip(&b.columns).map(|(a, b)| {
        assert_eq!(a.name, b.name);
        let size = a.values.iter().fold(1.0f64, |size, value| size.max(value.abs()));
        let pairs = a.values.iter().zip(&b.values);
        pairs.fold(0.0f64, |apart, (a, b)| if a == b { apart } else { apart.max((a - b).abs()) }) / size
    });
    differences.fold(0.0, f64::max)
}

fn compare<A: Compiled, B: Compiled>(end: f64, bound: f64) {
    let settings = |method, rtol| Settings { rows: Rows::Even(100), ..Settings::adaptive(method, end, rtol) };
    let expected = run_with(B::defaults(), &settings(Method::Dop853, 1e-13)).unwrap();
    let projections =
        [Stabilisation::Projection, Stabilisation::MassProjection, Stabilisation::Partitioning, Stabilisation::None];
    let mut found = vec![];
    for stabilisation in projections {
        let of = |settings| Settings { stabilisation, ..settings };
        found.push(run_with(A::defaults(), &of(settings(Method::Dop853, 1e-12))).unwrap());
    }
    found.push(run_with(A::defaults(), &settings(Method::Dopri5, 1e-12)).unwrap());
    found.push(run_with(A::defaults(), &settings(Method::Radau5, 1e-11)).unwrap());
    let equal = Settings { rows: Rows::Even(100), ..Settings::equal_steps(Method::Dop853, end, 2000) };
    found.push(run_with(A::defaults(), &equal).unwrap());
    for (k, run) in found.iter().enumerate() {
        let apart = apart(run, &expected);
        println!("{} {k}: {apart:.1e}, energy {:.1e}", A::DESCRIPTION.type_name, run.energy_balance);
        assert!(apart < bound && run.energy_balance < bound, "{k}: {apart:e} {:e}", run.energy_balance);
    }
}

/// Work, reactions and accelerations too.
#[test]
fn generalised_speeds_do_not_change_the_motion() {
    // Tolerances of 1e-12 and 1e-11, enlarged by what the motion does with a disturbance.
    compare::<RollingInSpeeds, Rolling>(2.0, 1e-8);
    compare::<LoopInSpeeds, Loop>(2.0, 1e-8);
    compare::<ThrownInSpeeds, Thrown>(1.5, 1e-8);
}

/// Where they do not determine the speeds, steps are made without them, as large or small as they are.
#[test]
fn what_generalised_speeds_do_not_determine_is_passed() {
    // All but at rest at its top, the motion enlarges errors so that DOPRI5 is off by 1e-8 in rates too.
    compare::<PendulumByHeight, Pendulum>(3.0, 3e-8);
    for start in [[0.2, 9.0], [1.5, 2.0]] {
        for steps in [97, 100, 400, 1000] {
            let settings = Settings::equal_steps(Method::Rk4, 1.0, steps);
            let [with, without] = [
                apart(&thrown::<PendulumByHeight>(start, &settings), &exact(start, steps)),
                apart(&thrown::<Pendulum>(start, &settings), &exact(start, steps)),
            ];
            println!("{start:?}, {steps} steps: {with:.1e} with generalised speeds, {without:.1e} without");
            // Where it hangs, its rate changes less than this generalised speed, whose steps are worse by ten, and rows between
            // them by twenty. Made in it everywhere, steps are worse by two hundred.
            assert!(with < 30.0 * without, "{start:?}, {steps}: {with:e} {without:e}");
        }
    }
}

/// A pendulum from an angle and its rate.
fn thrown<M: Compiled>(start: [f64; 2], settings: &Settings) -> Run<AnyModel> {
    let mut parameters = M::defaults().parameters();
    parameters.as_mut()[3..].copy_from_slice(&start);
    run_with(M::defaults().with_parameters(parameters), settings).unwrap()
}

fn exact(start: [f64; 2], steps: usize) -> Run<AnyModel> {
    thrown::<Pendulum>(start, &Settings::equal_steps(Method::Dop853, 1.0, steps))
}
