//! Mechanisms of bodies and joints alone: what joints place as coordinates, against the same joints as constraints of free bodies,
//! closed forms, and coordinates written by hand.

use crate::common::{apart, column};
use crate::linkages::rssr_rocker;
use codegen::kernel_id::KernelId;
use models::RobotArm;
use sim::{Compiled, Mechanism, Method, Settings, accelerate, mechanism};
use std::f64::consts::TAU;
use tests::Random;
use tests::any_model::run_with;

/// A chain of three bodies by its joints: `placed` by them, or `free` and held by them. Its outputs are, for each body, position,
/// velocity, acceleration, the columns of the attitude, angular velocity and angular acceleration.
macro_rules! chain {
    ($name:ident, $($joint:tt)*) => {
        pub(crate) mod $name {
            declared!(Placed, (), $($joint)*);
            declared!(Free, (free,), $($joint)*);
        }
    };
}

macro_rules! declared {
    ($type:ident, ($($free:tt)*), $($joint:tt)*) => {
        sim::mechanism! {
            /// A chain of three bodies.
            pub(crate) $type;
            parameters { m [kg] = 1; J [kg*m^2] = 0.02; l [m] = 0.2; k [N/m] = 40; g [m/s^2] = 9.81; }
            bodies {
                c: $($free)* mass m/3, inertia [J/2, J/3, J/3, J/20, 0, -J/30];
                a: $($free)* mass m, inertia [J, 2*J, 2.5*J];
                b: $($free)* mass m/2, inertia [J, J/2, J];
            }
            joints { $($joint)* }
            loads {
                gravity [0, g/2, -g];
                force [0, 1 [N], 0.5 [N]] at on(c, [l, l, 0]);
                torque [0.1 [N*m], 0, -0.2 [N*m]] on b;
                torque attitude(a)*[0, 0.3 [N*m], 0] on a;
                spring k, length l from [0, 0, 2*l] to on(c, [0, l, l]);
            }
            fragment Seen(body) {
                let P = on(body, [0, 0, 0]);
                let w = omega(body);
                let R = attitude(body);
                outputs {
                    x [m] = P.x; y [m] = P.y; z [m] = P.z;
                    vx [m/s] = dot(P).x; vy [m/s] = dot(P).y; vz [m/s] = dot(P).z;
                    ax [m/s^2] = ddot(P).x; ay [m/s^2] = ddot(P).y; az [m/s^2] = ddot(P).z;
                    xx = (R*[1, 0, 0]).x; xy = (R*[1, 0, 0]).y; xz = (R*[1, 0, 0]).z;
                    yx = (R*[0, 1, 0]).x; yy = (R*[0, 1, 0]).y; yz = (R*[0, 1, 0]).z;
                    zx = (R*[0, 0, 1]).x; zy = (R*[0, 0, 1]).y; zz = (R*[0, 0, 1]).z;
                    wx [rad/s] = w.x; wy [rad/s] = w.y; wz [rad/s] = w.z;
                    ex [rad/s^2] = dot(w).x; ey [rad/s^2] = dot(w).y; ez [rad/s^2] = dot(w).z;
                }
            }
            use Seen(a) as of_a;
            use Seen(b) as of_b;
            use Seen(c) as of_c;
        }
    };
}

chain!(
    turning,
    hinge: revolute ground at [l, 0, 0] axis [0, 0.6, 0.8] to a at [0, l, 0] axis [1, 0, 0];
    cross: universal a at [0, 0, l] axis [1, 0, 0] to b at [l, 0, 0] axis [0, 0, 1];
    hook: ball b at [0, l, 0] axis [0, 1, 0] to c at [0, 0, l];
);
chain!(
    turning_back,
    hinge: revolute a at [0, l, 0] axis [1, 0, 0] to ground at [l, 0, 0] axis [0, 0.6, 0.8];
    cross: universal b at [l, 0, 0] axis [0, 0, 1] to a at [0, 0, l] axis [1, 0, 0];
    hook: ball c at [0, 0, l] axis [0.48, 0.6, 0.64] to b at [0, l, 0];
);
chain!(
    sliding,
    tube: cylindrical ground at [l, 0, 0] axis [0, -1, 0] to a at [0, l, 0] axis [1, 0, 0];
    guide: prismatic a at [0, 0, l] axis [1, 0, 0] to b at [l, 0, 0] axis [0, 0.8, 0.6];
    glue: weld b at [0, l, 0] axis [0, 1, 0] to c at [0, 0, l];
);
chain!(
    sliding_back,
    tube: cylindrical a at [0, l, 0] axis [1, 0, 0] to ground at [l, 0, 0] axis [0, -1, 0];
    guide: prismatic b at [l, 0, 0] axis [0, 0.8, 0.6] to a at [0, 0, l] axis [1, 0, 0];
    glue: weld c at [0, 0, l] to b at [0, l, 0] axis [0, 1, 0];
);
chain!(
    rolling,
    thread: screw ground at [l, 0, 0] axis [0, 1, 0] to a at [0, l, 0] axis [1, 0, 0] pitch l;
    table: planar a at [0, 0, l] axis [1, 0, 0] to b at [l, 0, 0] axis [0, 0, 1];
    hinge: revolute b at [0, l, 0] axis [0, sin(l/(1 [m])), cos(l/(1 [m]))] to c at [0, 0, l] axis [0, 0, 1];
);
chain!(
    rolling_back,
    thread: screw a at [0, l, 0] axis [1, 0, 0] to ground at [l, 0, 0] axis [0, 1, 0] pitch -l;
    table: planar b at [l, 0, 0] axis [0, 0, 1] to a at [0, 0, l] axis [1, 0, 0];
    hinge: revolute c at [0, 0, l] axis [0, 0, 1] to b at [0, l, 0] axis [0, sin(l/(1 [m])), cos(l/(1 [m]))];
);

/// What is seen of one body.
const SEEN: usize = 24;

/// The state of free bodies by what is seen of those.
fn freed(seen: &[f64]) -> ([f64; 21], [f64; 21]) {
    let (mut q, mut qd) = ([0.0; 21], [0.0; 21]);
    // Free bodies have their coordinates in the order of declaration, in which c is the first.
    for (k, body) in [2, 0, 1].into_iter().enumerate() {
        let of = &seen[SEEN * body..SEEN * (body + 1)];
        let (r, w) = (&of[9..18], &of[18..21]);
        let [s, x, y, z] = quaternion(r);
        let rates = [
            -w[0] * x - w[1] * y - w[2] * z,
            w[0] * s + w[1] * z - w[2] * y,
            w[1] * s + w[2] * x - w[0] * z,
            w[2] * s + w[0] * y - w[1] * x,
        ];
        q[7 * k..7 * k + 3].copy_from_slice(&of[..3]);
        q[7 * k + 3..7 * k + 7].copy_from_slice(&[s, x, y, z]);
        qd[7 * k..7 * k + 3].copy_from_slice(&of[3..6]);
        qd[7 * k + 3..7 * k + 7].copy_from_slice(&rates.map(|rate| rate / 2.0));
    }
    (q, qd)
}

/// Of a matrix by columns, by its largest component: Shepperd's.
fn quaternion(r: &[f64]) -> [f64; 4] {
    let trace = r[0] + r[4] + r[8];
    let squares = [1.0 + trace, 1.0 + 2.0 * r[0] - trace, 1.0 + 2.0 * r[4] - trace, 1.0 + 2.0 * r[8] - trace];
    let (sx, sy, sz) = (r[5] - r[7], r[6] - r[2], r[1] - r[3]);
    let (xy, yz, zx) = (r[1] + r[3], r[5] + r[7], r[2] + r[6]);
    let rows = [[squares[0], sx, sy, sz], [sx, squares[1], xy, zx], [sy, xy, squares[2], yz], [sz, zx, yz, squares[3]]];
    let largest = (0..4).max_by(|i, k| squares[*i].total_cmp(&squares[*k])).unwrap();
    rows[largest].map(|x| x / (2.0 * squares[largest].sqrt()))
}

/// A random state in which quaternions have length 1 and keep it.
fn state<M: Compiled>(random: &mut Random) -> (M::Q, M::Q)
where
    M::Q: Default + AsMut<[f64]>,
{
    let (mut q, mut qd) = (M::Q::default(), M::Q::default());
    q.as_mut().iter_mut().chain(qd.as_mut()).for_each(|x| *x = random.between(-1.5, 1.5));
    let first = M::DESCRIPTION.coordinates.iter().position(|c| c.position.name.ends_with("_q0"));
    if let Some(at) = first {
        let (q, qd) = (&mut q.as_mut()[at..at + 4], &mut qd.as_mut()[at..at + 4]);
        let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
        q.iter_mut().for_each(|x| *x /= length);
        let along: f64 = q.iter().zip(qd.iter()).map(|(x, v)| x * v).sum();
        q.iter().zip(qd).for_each(|(x, v)| *v -= along * x);
    }
    (q, qd)
}

fn off(found: &[f64], expected: &[f64]) -> f64 {
    let size = expected.iter().fold(1.0f64, |size, x| size.max(x.abs()));
    found.iter().zip(expected).map(|(a, b)| (a - b).abs() / size).fold(0.0, f64::max)
}

/// Positions, speeds and accelerations of every body are those that constraints give free bodies at the same state, and the
/// constraints hold there.
macro_rules! compare {
    ($($name:ident),*) => {
        $({
            let mut random = Random(3);
            let (placed, free) = ($name::Placed::<f64>::default(), $name::Free::<f64>::default());
            let (mut motion, mut broken) = (0.0f64, 0.0f64);
            for _ in 0..100 {
                let (q, qd) = state::<$name::Placed>(&mut random);
                let found = accelerate(&placed, 0.0, &q, &qd).unwrap();
                let seen = Mechanism::outputs(&placed, 0.0, &q, &qd, &found.accelerations, &found.multipliers);
                let (q, qd) = freed(&seen);
                let held = accelerate(&free, 0.0, &q, &qd).unwrap();
                let expected = Mechanism::outputs(&free, 0.0, &q, &qd, &held.accelerations, &held.multipliers);
                motion = motion.max(off(&seen, &expected));
                broken = free.constraints(0.0, &q).iter().fold(broken, |worst, c| worst.max(c.abs()));
            }
            println!("{}: motion of bodies off by {motion:.1e}, constraints by {broken:.1e}", stringify!($name));
            // Multipliers of free bodies are solved for with a condition of some 1e4.
            assert!(motion < 1e-11 && broken < 1e-14, "{motion:e} {broken:e}");
        })*
    };
}

#[test]
fn joints_as_coordinates_move_bodies_as_joints_that_are_constraints() {
    compare!(turning, turning_back, sliding, sliding_back, rolling, rolling_back);
}

mechanism! {
    /// The six-axis arm of the shipped models, by its links and joints.
    pub(crate) ArmOfJoints;
    parameters {
        h [m] = 0.4; a1 [m] = 0.15; a2 [m] = 0.6; d4 [m] = 0.55; d6 [m] = 0.1;
        m1 [kg] = 30; m2 [kg] = 18; m3 [kg] = 12; m4 [kg] = 5; m5 [kg] = 2.5; m6 [kg] = 1;
        g [m/s^2] = 9.81; c [N*m*s] = 0.8;
    }
    inputs { tau1 [N*m] = 0; tau2 [N*m] = -60; tau3 [N*m] = -20; tau4 [N*m] = 0; tau5 [N*m] = 0; tau6 [N*m] = 0; }
    bodies {
        waist: mass m1, inertia [0.9 [kg*m^2], 0.8 [kg*m^2], 0.7 [kg*m^2]];
        upper_arm: mass m2, inertia [0.75 [kg*m^2], 0.8 [kg*m^2], 0.1 [kg*m^2]];
        forearm: mass m3, inertia [0.08 [kg*m^2], 0.25 [kg*m^2], 0.24 [kg*m^2]];
        roll: mass m4, inertia [0.02 [kg*m^2], 0.06 [kg*m^2], 0.06 [kg*m^2]];
        bend: mass m5, inertia [0.005 [kg*m^2], 0.006 [kg*m^2], 0.007 [kg*m^2]];
        tool: mass m6, inertia [0.002 [kg*m^2], 0.0015 [kg*m^2], 0.0015 [kg*m^2]];
    }
    joints {
        q1: revolute ground at [0, 0, 0] to waist at [-0.4*a1, 0, -0.6*h];
        q2: revolute waist at [0.6*a1, 0, 0.4*h] axis [0, 1, 0] to upper_arm at [0, 0, -0.45*a2] axis [0, 1, 0];
        q3: revolute upper_arm at [0, 0, 0.55*a2] axis [0, 1, 0] to forearm at [-0.2*d4, 0, -0.03 [m]] axis [0, 1, 0];
        q4: revolute forearm at [0.8*d4, 0, -0.03 [m]] axis [1, 0, 0] to roll at [0.3*d4, 0, 0] axis [1, 0, 0];
        q5: revolute roll at [0.3*d4, 0, 0] axis [0, 1, 0] to bend at [-0.2*d6, 0, 0] axis [0, 1, 0];
        q6: revolute bend at [0.8*d6, 0, 0] axis [1, 0, 0] to tool at [0, 0, 0] axis [1, 0, 0];
    }
    let flange = on(tool, [0, 0, 0]);
    loads {
        gravity [0, 0, -g];
        torque tau1 - c*dot(q1) on q1;
        torque tau2 - c*dot(q2) on q2;
        torque tau3 - c*dot(q3) on q3;
        torque tau4 - c/40*dot(q4) on q4;
        torque tau5 - c/40*dot(q5) on q5;
        torque tau6 - c/40*dot(q6) on q6;
    }
    outputs { x [m] = flange.x; y [m] = flange.y; height [m] = flange.z; flange_speed [m/s] = norm(dot(flange)); }
    kernels { inverse_dynamics; }
}

#[test]
fn an_arm_of_joints_is_the_arm_by_hand() {
    let (mut random, joints, hand) = (Random(11), ArmOfJoints::<f64>::default(), RobotArm::<f64>::default());
    assert_eq!(joints.parameters(), hand.parameters());
    let mut worst = 0.0f64;
    for _ in 0..100 {
        let [q, qd, qdd]: [[f64; 6]; 3] =
            [3.0, 3.0, 9.0].map(|size| std::array::from_fn(|_| random.between(-size, size)));
        let (found, expected) = (Mechanism::mass_matrix(&joints, 0.0, &q), Mechanism::mass_matrix(&hand, 0.0, &q));
        worst = worst.max(off(found.as_flattened(), expected.as_flattened()));
        let (found, expected) = (joints.dynamics(0.0, &q, &qd), hand.dynamics(0.0, &q, &qd));
        worst = worst.max(off(&found.accelerations, &expected.accelerations));
        let pairs = [
            (joints.inverse_dynamics(0.0, &q, &qd, &qdd), hand.inverse_dynamics(0.0, &q, &qd, &qdd)),
            (joints.convective_forces(0.0, &q, &qd), hand.convective_forces(0.0, &q, &qd)),
            (joints.generalized_forces(0.0, &q, &qd), hand.generalized_forces(0.0, &q, &qd)),
        ];
        worst = pairs.iter().fold(worst, |worst, (found, expected)| worst.max(off(found, expected)));
        let seen =
            [Mechanism::outputs(&joints, 0.0, &q, &qd, &qdd, &[]), Mechanism::outputs(&hand, 0.0, &q, &qd, &qdd, &[])];
        worst = worst.max(off(&seen[0], &seen[1]));
    }
    println!("arm of joints against the arm by hand: {worst:.1e}, relative");
    // The mass matrix is conditioned by some 1e5.
    assert!(worst < 1e-11, "{worst:e}");
    let [joints, hand] =
        [ArmOfJoints::<f64>::DESCRIPTION, RobotArm::<f64>::DESCRIPTION].map(|d| operations(d.declaration));
    for (joints, hand) in joints.iter().zip(&hand).filter(|(_, hand)| hand.0 != KernelId::Drawing) {
        assert!(joints.0 == hand.0 && joints.1 <= hand.1, "{joints:?} {hand:?}");
    }
}

/// The operations of each kernel.
fn operations(declaration: &str) -> Vec<(KernelId, usize)> {
    let model = codegen::model::resolve(&codegen::parse(declaration.parse().unwrap()).unwrap()).unwrap();
    let program = codegen::program::plan(&mut codegen::dynamics::derive_cheapest(model));
    program.kernels.iter().map(|kernel| (kernel.id, kernel.operations.total())).collect()
}

mechanism! {
    /// Cardan's joint of two shafts: their joint and the first bearing are coordinates, the second bearing is the cut.
    pub(crate) CardanOfJoints;
    parameters { m [kg] = 1; J [kg*m^2] = 0.02; l [m] = 0.2; w [rad/s] = 30; }
    let beta = 35 [deg];
    bodies {
        driven: mass m, inertia [J, 2*J, 2*J];
        driving: mass m, inertia [J, 2*J, 2*J];
    }
    joints {
        bearing: revolute ground at [-l, 0, 0] axis [1, 0, 0] to driving at [0, 0, 0] axis [1, 0, 0];
        cross: universal driving at [l, 0, 0] axis [0, 1, 0] to driven at [-l, 0, 0] axis [0, 0, 1];
        guide: cylindrical driven at [0, 0, 0] axis [1, 0, 0] to ground at [0, 0, 0] axis [cos(beta), sin(beta), 0];
    }
    initial { bearing = 0; dot(bearing) = w; guess cross_2 = beta; }
    outputs { ratio = inner(omega(driven), [cos(beta), sin(beta), 0])/dot(bearing); force [N] = reaction(guide_f1); }
}

#[test]
fn cardans_joint_of_joints_has_its_ratio_of_speeds() {
    let run = run_with(CardanOfJoints::default(), &Settings::adaptive(Method::Dop853, 0.5, 1e-12)).unwrap();
    let beta = 35f64.to_radians();
    let ratio = |turn: f64| beta.cos() / (1.0 - (beta.sin() * turn.cos()).powi(2));
    let worst = apart(&run, "ratio", "bearing", ratio);
    let turns = column(&run, "bearing").last().unwrap() / TAU;
    println!(
        "Cardan's joint of joints: {} coordinates, dependent {:?}, ratio off by {worst:.1e} in {turns:.1} turns, energy {:.1e}",
        CardanOfJoints::<f64>::DESCRIPTION.coordinates.len(),
        run.mobility.dependent,
        run.energy_balance
    );
    assert_eq!((CardanOfJoints::<f64>::DESCRIPTION.coordinates.len(), run.mobility.degrees_of_freedom), (3, 1));
    assert!(worst < 1e-12 && turns > 2.0 && run.energy_balance < 1e-9, "{worst:e}");
}

mechanism! {
    /// The spatial four-bar of the shipped models, by its bars and joints: the second ball is the cut.
    pub(crate) RssrOfJoints;
    parameters {
        a [m] = 0.15; b [m] = 0.4; c [m] = 0.7; dx [m] = 0.5; dz [m] = 0.3; m [kg] = 1; J [kg*m^2] = 0.02; g [m/s^2] = 9.81;
    }
    bodies {
        crank: mass m, inertia [J, J, J];
        coupler: mass m, inertia [J/100, J, J];
        rocker: mass m, inertia [J, J, J/100];
    }
    joints {
        phi: revolute ground at [0, 0, 0] to crank at [-a/2, 0, 0];
        psi: revolute ground at [dx, 0, dz] axis [0, 1, 0] to rocker at [0, 0, b/2] axis [0, 1, 0];
        hook: ball crank at [a/2, 0, 0] to coupler at [-c/2, 0, 0];
        cut: ball coupler at [c/2, 0, 0] to rocker at [0, 0, -b/2];
    }
    loads { gravity [0, 0, -g]; }
    initial { phi = 0; dot(phi) = 120 [rpm]; guess psi = -1; guess hook_q0 = 1; guess hook_q2 = -0.07; }
    outputs { force [N] = norm(reaction(cut)); }
}

#[test]
fn a_spatial_four_bar_of_joints_closes() {
    let linkage: RssrOfJoints = RssrOfJoints::default();
    let RssrOfJoints { a, b, c, dx, dz, .. } = linkage;
    let run = run_with(linkage, &Settings::adaptive(Method::Dop853, 2.0, 1e-11)).unwrap();
    let off = apart(&run, "psi", "phi", |phi| rssr_rocker([a, b, c, dx, dz], phi)[0]);
    let turns = column(&run, "phi").last().unwrap() / TAU;
    println!(
        "spatial four-bar of joints: rocker off by {off:.1e} in {turns:.1} turns, energy {:.1e}",
        run.energy_balance
    );
    // The coupler turns about its own axis too.
    assert_eq!(run.mobility.degrees_of_freedom, 2);
    assert!(off < 1e-11 && turns > 1.0 && run.energy_balance < 1e-9, "{off:e}");
}

mechanism! {
    /// Two links, and the force of the joint that holds both, by auxiliary displacements of its point.
    pub(crate) Held;
    parameters { m [kg] = 1; J [kg*m^2] = 0.02; l [m] = 0.2; g [m/s^2] = 9.81; }
    auxiliary { ax [m]; ay [m]; az [m]; }
    bodies {
        upper: mass m, inertia [J, J, J/4];
        lower: mass m/2, inertia [J, J/4, J];
    }
    joints {
        hip: universal ground at [ax, ay, l + az] axis [1, 0, 0] to upper at [0, 0, l] axis [0, 1, 0];
        knee: revolute lower at [0, l, 0] axis [1, 0, 0] to upper at [0, 0, -l] axis [1, 0, 0];
    }
    loads { gravity [0, 0, -g]; }
    initial { hip_1 = 0.5; hip_2 = 0.3; dot(hip_2) = 2; dot(knee) = 3; }
    let momentum = m*dot(on(upper, [0, 0, 0])) + m/2*dot(on(lower, [0, 0, 0]));
    outputs {
        x [N] = reaction(ax) - dot(momentum).x;
        y [N] = reaction(ay) - dot(momentum).y;
        z [N] = reaction(az) - dot(momentum).z - 1.5*m*g;
        size [N] = norm([reaction(ax), reaction(ay), reaction(az)]);
    }
}

#[test]
fn auxiliary_displacements_of_a_joints_point_give_its_force() {
    let run = run_with(Held::default(), &Settings::adaptive(Method::Dop853, 1.0, 1e-10)).unwrap();
    let largest = |name: &str| column(&run, name).iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
    let off = ["x", "y", "z"].map(largest).into_iter().fold(0.0, f64::max) / largest("size");
    println!("force of a joint against Newton's law for both links: {off:.1e}, relative");
    assert!(off < 1e-13 && largest("size") > 10.0, "{off:e}");
}
