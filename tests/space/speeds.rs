//! Generalised speeds: their kernels against those in the rates of the coordinates, and motions in them against closed
//! forms.

use codegen::kernel_id::KernelId;
use codegen::program::{Kernel, plan};
use sim::sim_kernel::{GeneralizedSpeeds, Kinematics, SpeedDynamics};
use sim::{Array, Compiled, Dual, FixedArray, Mechanism, mechanism};
use tests::Random;

mechanism! {
    /// A body on which nothing acts.
    FreeBody;
    parameters { m [kg] = 2; A [kg*m^2] = 1; B [kg*m^2] = 2; C [kg*m^2] = 3; }
    bodies { body: free, mass m, inertia [A, B, C]; }
    let w = transpose(attitude(body))*omega(body);
    let H = attitude(body)*[A*w.x, B*w.y, C*w.z];
    speeds {
        /// Angular velocity about the first axis of inertia.
        wx [rad/s] = w.x;
        wy [rad/s] = w.y;
        wz [rad/s] = w.z;
        vx [m/s] = dot(body_x);
        vy [m/s] = dot(body_y);
        vz [m/s] = dot(body_z);
    }
    outputs { Hx [N*m*s] = H.x; Hy [N*m*s] = H.y; Hz [N*m*s] = H.z; }
}

mechanism! {
    /// The same by Euler's angles, which have a singular position.
    Turning;
    coordinates { psi [rad]; theta [rad]; phi [rad]; }
    parameters { A [kg*m^2] = 1; B [kg*m^2] = 2; C [kg*m^2] = 3; }
    bodies { body: inertia [A, B, C], attitude euler(zxz, psi, theta, phi); }
    let w = transpose(attitude(body))*omega(body);
    speeds { wx [rad/s] = w.x; wy [rad/s] = w.y; wz [rad/s] = w.z; }
}

mechanism! {
    /// A body with products of inertia, its velocity in its own frame, pulled, damped and turned, with a rotor on it.
    Towed;
    coordinates { spin [rad]; }
    parameters {
        m [kg] = 2; l [m] = 0.3; J [kg*m^2] = 0.2; D [kg*m^2] = 0.03; k [N/m] = 20; d [N*s/m] = 0.4; g [m/s^2] = 9.81;
    }
    bodies {
        hull: free, mass m, inertia [J, 2*J, 2.5*J, D, -D, D/2];
        rotor: mass m/3 at on(hull, [l, 0, 0]), inertia [J/9, J/8, J/9], attitude attitude(hull)*rotation(y, spin);
    }
    let w = transpose(attitude(hull))*omega(hull);
    let v = transpose(attitude(hull))*dot([hull_x, hull_y, hull_z]);
    speeds {
        w1 [rad/s] = w.x;
        w2 [rad/s] = 3*w.y + 0.2*w.x;
        w3 [rad/s] = w.z;
        v1 [m/s] = v.x;
        v2 [m/s] = v.y;
        v3 [m/s] = v.z - 0.1 [m/s]*cos(2 [rad/s]*t);
        turn [rad/s] = dot(spin) + w2/3;
    }
    loads {
        gravity [0, 0, -g];
        spring k, length l from [0, 0, l] to on(hull, [l, l, 0]);
        force -d*dot(on(hull, [0, l, 0])) at on(hull, [0, l, 0]);
        torque attitude(hull)*[0.1 [N*m*s]*w1, 0, 0.2 [N*m]*sin(t/(1 [s]))] on hull;
        torque -0.1 [N*m*s]*turn*(attitude(hull)*[0, 1, 0]) on rotor;
    }
    outputs { turned [rad/s] = turn; }
}

mechanism! {
    /// A disc that rolls and leans: its contact is in the coordinates, its rolling between speeds.
    Wheel;
    coordinates { x [m]; y [m]; psi [rad]; lean [rad]; phi [rad]; }
    parameters { m [kg] = 0.5; r [m] = 0.2; g [m/s^2] = 9.81; }
    let S = rotation([0, 0, 1], psi)*rotation([1, 0, 0], lean);
    let P = [x, y, r*cos(lean)];
    bodies { disc: mass m at P, inertia [m*r^2/4, m*r^2/2, m*r^2/4], attitude S*rotation([0, 1, 0], phi); }
    loads { gravity [0, 0, -g]; }
    let slip = dot(P) + cross(omega(disc), S*[0, 0, -r]);
    constraints { slip_x: slip.x = 0; slip_y: slip.y = 0; }
    let w = transpose(S)*omega(disc);
    speeds { roll [rad/s] = w.y; nod [rad/s] = w.x; turn [rad/s] = w.z; }
    initial { lean = -0.3; }
}

mechanism! {
    /// The same disc with its height as a coordinate, so that the pressure of the ground is left.
    Disc;
    coordinates { x [m]; y [m]; z [m]; psi [rad]; lean [rad]; phi [rad]; }
    parameters { m [kg] = 0.5; r [m] = 0.2; g [m/s^2] = 9.81; }
    let S = rotation([0, 0, 1], psi)*rotation([1, 0, 0], lean);
    bodies { disc: mass m at [x, y, z], inertia [m*r^2/4, m*r^2/2, m*r^2/4], attitude S*rotation([0, 1, 0], phi); }
    loads { gravity [0, 0, -g]; }
    joints { ground: roll disc radius r axis [0, 1, 0] on [0, 0, 0] normal [0, 0, 1]; }
    let w = transpose(S)*omega(disc);
    speeds { roll [rad/s] = w.y; nod [rad/s] = w.x; turn [rad/s] = w.z; rise [m/s] = dot(z); }
}

mechanism! {
    /// Two links in the plane, by the rates of their own angles.
    Links;
    coordinates { a [rad]; u [rad]; }
    parameters { m [kg] = 2; l [m] = 0.7; g [m/s^2] = 9.81; c [N*m*s] = 0.1; }
    let P = l*[sin(a), -cos(a)];
    let Q = P + l*[sin(a + u), -cos(a + u)];
    bodies { first: mass m at P, inertia m*l^2/12, angle a; second: mass m at Q, inertia m*l^2/12, angle a + u; }
    loads { gravity [0, -g]; torque -c*u2 on second; }
    speeds { u1 [rad/s] = dot(a); u2 [rad/s] = dot(a) + dot(u); }
}

mechanism! {
    /// Two links closed into a loop with a slider, whose rates are turned, and a clutch that holds between speeds.
    Clutched;
    coordinates { x [m]; y [m]; a [rad]; b [rad]; }
    parameters { m [kg] = 2; l [m] = 0.7; r [m] = 0.3; g [m/s^2] = 9.81; }
    let P = [x, y];
    let along = [cos(a), sin(a)];
    bodies {
        plate: mass m at P, inertia m*r^2, angle a;
        drum: inertia m*r^2/4, angle b;
        bob: mass m/2 at P + l*[cos(b), sin(b)];
    }
    loads { gravity [0, -g]; force -3 [N*s/m]*dot(P) at P; }
    constraints {
        loop: norm(P + l*[cos(b), sin(b)] - [2*l, 0]) = l;
        clutch: dot(a) = 2*dot(b) + sin(t/(1 [s]))/(1 [s]) initially active;
    }
    speeds {
        ahead [m/s] = inner(dot(P), along);
        aside [m/s] = along.x*dot(y) - along.y*dot(x);
        rim [m/s] = r*dot(a) + ahead/2;
        drum_rate [rad/s] = dot(b);
    }
    events { slip: t = 1 [s] rising { release clutch; } }
}

mechanism! {
    /// A chain so long that its equations in coordinates are written with intermediate quantities.
    Chain;
    const n = 6;
    coordinates { repeat i in 1..=n { phi_[i] [rad]; } }
    parameters { m [kg] = 0.5; l [m] = 0.4; g [m/s^2] = 9.81; }
    let P_[0] = [0, 0];
    repeat i in 1..=n {
        let angle_[i] = sum(j in 1..=i, phi_[j]);
        let P_[i] = P_[i-1] + l*[sin(angle_[i]), -cos(angle_[i])];
        bodies { link_[i]: mass m at P_[i], inertia m*l^2/12, angle angle_[i]; }
        speeds { w_[i] [rad/s] = dot(angle_[i]); }
    }
    loads { gravity [0, -g]; torque -0.1 [N*m*s]*w_[n] on link_[n]; }
}

/// Calls a macro with all of them.
macro_rules! all {
    ($callback:ident) => {
        $callback!(FreeBody, Turning, Towed, Wheel, Disc, Links, Clutched, Chain)
    };
}

fn apart(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len());
    assert!(found.iter().chain(expected).all(|x| x.is_finite()), "{found:?} {expected:?}");
    let size = expected.iter().fold(1.0f64, |size, x| size.max(x.abs()));
    found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size
}

/// u of a state that moves with q' and q''.
fn rates_of_speeds<M>(mechanism: &M, t: f64, q: &M::Q, qd: &M::Q, qdd: &M::Q) -> Vec<f64>
where
    M: Compiled,
    M::On<Dual>: GeneralizedSpeeds<Dual>,
{
    let dual = mechanism.on(Dual::constant);
    let moving = |values: &M::Q, rates: &M::Q| {
        <M::On<Dual> as Mechanism<Dual>>::Q::from_fn(|i| Dual { value: values[i], derivative: rates[i] })
    };
    let speeds = dual.generalized_speeds(Dual::variable(t), &moving(q, qd), &moving(qd, qdd));
    speeds.iter().map(|u| u.derivative).collect()
}

/// A random place. Quaternions are longer than 1/2: of shorter ones rows of angular velocities and of norms differ in
/// size.
fn place<M: Compiled>(mechanism: &M, random: &mut Random) -> M::Q {
    loop {
        let q = M::Q::from_fn(|_| random.between(-1.2, 1.2));
        let norms = mechanism.constraints(0.0, &q);
        if M::DESCRIPTION.norm_constraints.iter().all(|row| norms[*row] > -0.75) {
            return q;
        }
    }
}

/// At random states, with quaternions of many lengths: `kinematics` inverts `generalized_speeds` and moves on what
/// holds by construction, and u' and lambda are those of the motion in q.
fn check<M>()
where
    M: GeneralizedSpeeds,
    M::On<Dual>: GeneralizedSpeeds<Dual>,
{
    let (mut random, mechanism) = (Random(17), M::defaults());
    let [mut inverted, mut kept, mut moved, mut held] = [0.0f64; 4];
    let mut left_out = 0;
    for _ in 0..1000 {
        let t = random.between(0.0, 2.0);
        let q = place(&mechanism, &mut random);
        let u = M::U::from_fn(|_| random.between(-3.0, 3.0));
        let Kinematics { rates: qd, refused } = mechanism.kinematics(t, &q, &u);
        let dynamics = mechanism.dynamics(t, &q, &qd);
        let SpeedDynamics { rates, multipliers, refused: unsolved } = mechanism.speed_dynamics(t, &q, &u);
        assert!(!refused && !unsolved);
        // Near singular positions of angles and of constraints rates and accelerations are large, and cancel in u'.
        let size = qd.iter().chain(dynamics.accelerations.iter()).fold(1.0f64, |size, x| size.max(x.abs()));
        if dynamics.refused || size > 1e4 {
            left_out += 1;
            continue;
        }
        inverted = inverted.max(apart(mechanism.generalized_speeds(t, &q, &qd).as_ref(), u.as_ref()));
        let (jacobian, drift) = (mechanism.constraint_jacobian(t, &q), mechanism.constraint_time_derivative(t, &q));
        for i in (0..M::L::LEN).filter(|i| !M::ROWS.contains(i)) {
            let rate = (0..M::Q::LEN).fold(drift[i], |sum, j| sum + jacobian[i][j] * qd[j]);
            kept = kept.max(rate.abs() / size);
        }
        let expected = rates_of_speeds(&mechanism, t, &q, &qd, &dynamics.accelerations);
        moved = moved.max(apart(rates.as_ref(), &expected) / size);
        let expected: Vec<f64> = M::ROWS.iter().map(|row| dynamics.multipliers[*row]).collect();
        held = held.max(apart(multipliers.as_ref(), &expected) / size);
    }
    let name = M::DESCRIPTION.type_name;
    println!(
        "{name:<10} u(q'(u)) {inverted:.1e}, rows kept {kept:.1e}, u' {moved:.1e}, lambda {held:.1e}; {left_out} left out"
    );
    assert!(left_out < 100, "{name}");
    // Some tens of roundings of 1e-16, enlarged by the condition of the mass matrix, up to 1e2.
    assert!(inverted < 1e-12 && kept < 1e-12, "{name}: {inverted:e} {kept:e}");
    assert!(moved < 1e-12 && held < 1e-12, "{name}: {moved:e} {held:e}");
}

#[test]
fn motion_in_speeds_is_that_in_coordinates() {
    macro_rules! check_all {
        ($($model:ty),*) => { $(check::<$model>();)* };
    }
    all!(check_all);
}

/// A released clutch has no multiplier, and does not hold.
#[test]
fn switched_constraints_are_left_to_their_multipliers() {
    let released = Clutched { clutch_activity: 0.0, ..Default::default() };
    let (q, u) = ([0.3, 0.2, 0.5, 0.9], [0.4, -0.2, 0.7, 1.1]);
    let qd = released.kinematics(0.3, &q, &u).rates;
    let (found, expected) = (released.speed_dynamics(0.3, &q, &u), released.dynamics(0.3, &q, &qd));
    assert_eq!(Clutched::<f64>::ROWS, [0, 1]);
    assert_eq!(found.multipliers[1], 0.0);
    let rates = rates_of_speeds(&released, 0.3, &q, &qd, &expected.accelerations);
    assert!(apart(&found.rates, &rates) < 1e-12 && apart(&found.multipliers, &expected.multipliers) < 1e-12);
    let held = Clutched::default().speed_dynamics(0.3, &q, &u);
    assert!(apart(&found.rates, &held.rates) > 1e-3);
}

/// Euler's equations A w1' = (B - C) w2 w3, of w alone; bit for bit no more than that can be asked.
#[test]
fn a_free_body_has_eulers_equations() {
    let mut random = Random(4);
    let [a, b, c] = [1.0, 2.0, 3.0];
    for _ in 0..100 {
        let q = std::array::from_fn(|_| random.between(-1.0, 1.0));
        let u: [f64; 6] = std::array::from_fn(|_| random.between(-5.0, 5.0));
        let [w1, w2, w3, ..] = u;
        let expected = [(b - c) * w2 * w3 / a, (c - a) * w3 * w1 / b, (a - b) * w1 * w2 / c, 0.0, 0.0, 0.0];
        let found = FreeBody::default().speed_dynamics(0.0, &q, &u).rates;
        // Three roundings.
        assert!(apart(&found, &expected) < 1e-15);
        // Where Euler's angles are singular too.
        let found = Turning::default().speed_dynamics(0.0, &[0.3, 0.0, 0.2], &[w1, w2, w3]);
        assert!(!found.refused && apart(&found.rates, &expected[..3]) < 1e-15);
    }
    let turning: Turning = Turning::default();
    assert!(turning.kinematics(0.0, &[0.3, 0.0, 0.2], &[1.0, 2.0, 3.0]).refused);
    assert!(!turning.kinematics(0.0, &[0.3, 1e-7, 0.2], &[1.0, 2.0, 3.0]).refused);
}

/// No coordinate stands in them, no sine and no division, and they take a twentieth of the operations.
#[test]
fn eulers_equations_are_as_short_as_on_paper() {
    let kernels = |declaration: &str| {
        let declaration = codegen::parse(declaration.parse().unwrap()).unwrap();
        let model = codegen::model::resolve(&declaration).unwrap();
        plan(&mut codegen::dynamics::derive_cheapest(model)).kernels
    };
    let find = |kernels: &[Kernel], id: KernelId| {
        let kernel = kernels.iter().find(|kernel| kernel.id == id).unwrap();
        let operations = &kernel.operations;
        (
            operations.total(),
            operations.divisions + operations.sine_cosines,
            kernel.entries.positions.iter().flatten().count(),
        )
    };
    for declaration in [FreeBody::<f64>::DESCRIPTION.declaration, Turning::<f64>::DESCRIPTION.declaration] {
        let kernels = kernels(declaration);
        let [(speeds, slow, positions), (kinematics, ..), (coordinates, ..)] =
            [KernelId::SpeedDynamics, KernelId::Kinematics, KernelId::Dynamics].map(|id| find(&kernels, id));
        println!("speed_dynamics {speeds}, kinematics {kinematics}, dynamics {coordinates} operations");
        assert!(speeds <= 10 && slow == 0 && positions == 0);
        assert!(speeds + kinematics < coordinates / 2);
    }
}

/// q and u after equal steps of the classical method of Runge and Kutta.
fn integrate<M: GeneralizedSpeeds>(mechanism: &M, mut q: M::Q, mut u: M::U, end: f64, steps: usize) -> (M::Q, M::U) {
    let (h, prepared) = (end / steps as f64, mechanism.prepare());
    for step in 0..steps {
        let t = step as f64 * h;
        let rates = |t: f64, q: &M::Q, u: &M::U| {
            let (kinematics, dynamics) =
                (M::prepared_kinematics(&prepared, t, q, u), M::prepared_speed_dynamics(&prepared, t, q, u));
            assert!(!kinematics.refused && !dynamics.refused);
            (kinematics.rates, dynamics.rates)
        };
        let ahead = |h: f64, (qd, ud): &(M::Q, M::U)| {
            (M::Q::from_fn(|i| q[i] + h * qd[i]), M::U::from_fn(|i| u[i] + h * ud[i]))
        };
        let first = rates(t, &q, &u);
        let middle = ahead(h / 2.0, &first);
        let second = rates(t + h / 2.0, &middle.0, &middle.1);
        let middle = ahead(h / 2.0, &second);
        let third = rates(t + h / 2.0, &middle.0, &middle.1);
        let last = ahead(h, &third);
        let fourth = rates(t + h, &last.0, &last.1);
        q = M::Q::from_fn(|i| q[i] + h / 6.0 * (first.0[i] + 2.0 * (second.0[i] + third.0[i]) + fourth.0[i]));
        u = M::U::from_fn(|i| u[i] + h / 6.0 * (first.1[i] + 2.0 * (second.1[i] + third.1[i]) + fourth.1[i]));
    }
    (q, u)
}

#[test]
fn a_free_body_keeps_energy_and_momentum() {
    let body: FreeBody = FreeBody::default();
    let (q, u) = ([0.0, 0.0, 0.0, 0.5, -0.5, 0.5, 0.5], [0.3, 1.0, 0.2, 0.1, 0.2, 0.3]);
    let kept = |q: &[f64; 7], u: &[f64; 6]| {
        let qd = body.kinematics(0.0, q, u).rates;
        let outputs: [f64; 3] = body.outputs(0.0, q, &qd, &[0.0; 7], &[0.0]).into();
        [body.kinetic_energy(0.0, q, &qd), outputs[0], outputs[1], outputs[2]]
    };
    let errors = [2000, 4000].map(|steps| {
        let (end, speeds) = integrate(&body, q, u, 50.0, steps);
        apart(&kept(&end, &speeds), &kept(&q, &u))
    });
    println!("energy and angular momentum after 50 s: {:.1e}, {:.1e} with half of the steps", errors[1], errors[0]);
    // Of order 4: half of the step leaves a sixteenth, and the fifth order a little less.
    assert!(errors[1] < 1e-7 && errors[0] / errors[1] > 12.0, "{errors:?}");
}

/// Steady rolling (Neimark and Fufaev 1972, chapter II): lean, turn and spin are constant, and the centre goes round a
/// circle.
#[test]
fn a_disc_rolls_steadily_in_a_circle() {
    let wheel: Wheel = Wheel::default();
    let (lean, turning): (f64, f64) = (-0.3, 1.5);
    let (m, r, g) = (wheel.m, wheel.r, wheel.g);
    let (a, c) = (m * r * r / 4.0, m * r * r / 2.0);
    let (s, cos) = lean.sin_cos();
    let axial = (a * turning * turning * s * cos - m * g * r * s) / ((c + m * r * r) * turning * cos);
    let (q, u) = ([0.0, 0.0, 0.0, lean, 0.0], [axial, 0.0, turning * cos]);
    let found = wheel.speed_dynamics(0.0, &q, &u);
    assert!(apart(&found.rates, &[0.0; 3]) < 1e-12, "{found:?}");
    let (end, speeds) = integrate(&wheel, q, u, std::f64::consts::TAU / turning, 2000);
    println!("after one turn: place {:.1e} {:.1e}, lean {:.1e}", end[0], end[1], end[3] - lean);
    // The steady motion is stable, and the method's error h^4 with h of 1/2000 of a turn.
    assert!(end[0].abs() < 1e-9 && end[1].abs() < 1e-9 && (end[3] - lean).abs() < 1e-9);
    assert!(apart(&speeds, &u) < 1e-9);
}
