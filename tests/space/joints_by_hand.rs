//! Joints between free bodies against vector equations written by hand: Newton's and Euler's of each body, what the joint passes
//! on, and how it lets them accelerate. Of the declaration only the order of the coordinates and the names of reactions are
//! used, so that nothing that writes out joints is shared; kernels, oracle and Lagrange's equations all have that in common.

use nalgebra::{Matrix3, Quaternion, Rotation3, Unit, UnitQuaternion, Vector3};
use sim::{Compiled, accelerate, mechanism};
use std::f64::consts::TAU;
use tests::Random;

type Vector = Vector3<f64>;

/// Two free bodies that a joint holds; the axis of the first is z, of the second x.
macro_rules! held {
    ($name:ident, $kind:ident $($pitch:tt)*) => {
        mechanism! {
            $name;
            bodies { a: free, mass 2, inertia [0.3, 0.4, 0.5, 0.02, -0.03, 0.05]; b: free, mass 0.7, inertia [0.1, 0.06, 0.08]; }
            joints { j: $kind a at [0.3, -0.1, 0.2] axis [0, 0, 1] to b at [-0.2, 0.1, 0.4] axis [1, 0, 0] $($pitch)*; }
            loads { gravity [0.5, 0, -9.81]; force [3, -4, 5] at on(a, [0.1, 0.2, -0.3]); torque [0.7, -0.2, 0.4] on b; }
            kernels { }
        }
    };
}

held!(Ball, ball);
held!(Revolute, revolute);
held!(Universal, universal);
held!(Cylindrical, cylindrical);
held!(Prismatic, prismatic);
held!(Screw, screw pitch 0.2 [m]);
held!(Planar, planar);
held!(Weld, weld);

/// What a joint lets the second body do beside the first: turn about the axis n of the first and about its own, m, and shift along
/// t1, t2 and n.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Ball,
    Revolute,
    Universal,
    Cylindrical,
    Prismatic,
    Screw,
    Planar,
    Weld,
}

const PITCH: f64 = 0.2;

/// A body as it moves.
#[derive(Clone, Copy)]
struct Body {
    mass: f64,
    inertia: Matrix3<f64>,
    place: Vector,
    turn: UnitQuaternion<f64>,
    velocity: Vector,
    spin: Vector,
    acceleration: Vector,
    spin_rate: Vector,
}

impl Body {
    fn velocity_at(&self, point: Vector) -> Vector {
        self.velocity + self.spin.cross(&(point - self.place))
    }
    fn acceleration_at(&self, point: Vector) -> Vector {
        self.acceleration + self.second(point - self.place)
    }
    /// The second derivative of a vector that is fixed in it.
    fn second(&self, fixed: Vector) -> Vector {
        self.spin_rate.cross(&fixed) + self.spin.cross(&self.spin.cross(&fixed))
    }
    /// J w' + w x J w.
    fn moment(&self) -> Vector {
        let turn = self.turn.to_rotation_matrix();
        let inertia = turn * self.inertia * turn.inverse();
        inertia * self.spin_rate + self.spin.cross(&(inertia * self.spin))
    }
    /// Position and quaternion, then their rates.
    fn coordinates(&self) -> ([f64; 7], [f64; 7]) {
        let (x, v, q) = (self.place, self.velocity, self.turn.quaternion());
        let rate = Quaternion::from_imag(self.spin) * q * 0.5;
        ([x.x, x.y, x.z, q.w, q.i, q.j, q.k], [v.x, v.y, v.z, rate.w, rate.i, rate.j, rate.k])
    }
}

/// The axes of the joint in the world, and the points of both bodies.
struct Joint {
    t1: Vector,
    t2: Vector,
    n: Vector,
    m: Vector,
    first: Vector,
    second: Vector,
}

fn random(random: &mut Random, size: f64) -> Vector {
    Vector::from_fn(|_, _| random.between(-size, size))
}

/// Both bodies as the joint lets them be and move, without accelerations.
fn posed(kind: Kind, numbers: &mut Random) -> (Body, Body, Joint) {
    let turn = UnitQuaternion::from_scaled_axis(random(numbers, 2.0));
    let mut a = Body {
        mass: 2.0,
        inertia: Matrix3::new(0.3, 0.02, -0.03, 0.02, 0.4, 0.05, -0.03, 0.05, 0.5),
        place: random(numbers, 1.0),
        turn,
        velocity: random(numbers, 2.0),
        spin: random(numbers, 3.0),
        acceleration: Vector::zeros(),
        spin_rate: Vector::zeros(),
    };
    let [t1, t2, n] = [Vector::x(), Vector::y(), Vector::z()].map(|axis| turn * axis);
    let first = a.place + turn * Vector::new(0.3, -0.1, 0.2);
    let mut rate = |allowed: bool| if allowed { numbers.between(-2.0, 2.0) } else { 0.0 };
    let turns = !matches!(kind, Kind::Prismatic | Kind::Weld);
    let angle = rate(turns);
    let about = |axis: Vector, angle: f64| Rotation3::from_axis_angle(&Unit::new_normalize(axis), angle);
    // x, y and z of the second body on n, t1 and t2, then turned about n.
    let aligned = about(n, angle) * Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[n, t1, t2]));
    let turned = match kind {
        // x across n, and turned about itself.
        Kind::Universal => {
            let across = about(n, angle) * t1;
            let frame = Matrix3::from_columns(&[across, n, across.cross(&n)]);
            about(across, rate(true)) * Rotation3::from_matrix_unchecked(frame)
        }
        Kind::Ball => Rotation3::from_scaled_axis(Vector::new(rate(true), rate(true), rate(true))),
        _ => aligned,
    };
    let m = turned * Vector::x();
    let (turning, own) = (rate(turns), rate(kind == Kind::Universal));
    let loose = if kind == Kind::Ball { Vector::new(rate(true), rate(true), rate(true)) } else { Vector::zeros() };
    let along = matches!(kind, Kind::Cylindrical | Kind::Prismatic | Kind::Screw);
    let shift = [rate(kind == Kind::Planar), rate(kind == Kind::Planar), rate(along)];
    let mut shifting = [rate(kind == Kind::Planar), rate(kind == Kind::Planar), rate(along)];
    if kind == Kind::Screw {
        shifting[2] = PITCH / TAU * turning;
    }
    let of_frame = |[x, y, z]: [f64; 3]| x * t1 + y * t2 + z * n;
    let second = first + of_frame(shift);
    let spin = a.spin + turning * n + own * m + loose;
    let arm = turned * Vector::new(-0.2, 0.1, 0.4);
    let b = Body {
        mass: 0.7,
        inertia: Matrix3::from_diagonal(&Vector::new(0.1, 0.06, 0.08)),
        place: second - arm,
        turn: UnitQuaternion::from_rotation_matrix(&turned),
        velocity: a.velocity_at(second) + of_frame(shifting) - spin.cross(&arm),
        spin,
        ..a
    };
    a.turn.renormalize();
    (a, b, Joint { t1, t2, n, m, first, second })
}

fn check<M: Compiled>(kind: Kind) {
    let mechanism = M::defaults();
    let mut numbers = Random(23);
    for _ in 0..20 {
        let (mut a, mut b, joint) = posed(kind, &mut numbers);
        let ([qa, ua], [qb, ub]) = {
            let ((qa, ua), (qb, ub)) = (a.coordinates(), b.coordinates());
            ([qa, ua], [qb, ub])
        };
        let mut order = M::DESCRIPTION.coordinates.iter().map(|c| c.position.name);
        assert!(["a_x", "a_y", "a_z", "a_q0", "a_q1", "a_q2", "a_q3", "b_x"].into_iter().eq(order.by_ref().take(8)));
        let (positions, speeds) = ([qa, qb].concat(), [ua, ub].concat());
        let fill = |values: &[f64]| <M::Q as sim::FixedArray<f64>>::from_fn(|i| values[i]);
        let solved = accelerate(&mechanism, 0.0, &fill(&positions), &fill(&speeds)).unwrap();
        let found = solved.accelerations.as_ref();
        for (body, at) in [(&mut a, 0), (&mut b, 7)] {
            body.acceleration = Vector::from_fn(|i, _| found[at + i]);
            // The vector part of 2 q'' q*: that of q' q*' is 0.
            let second = Quaternion::new(found[at + 3], found[at + 4], found[at + 5], found[at + 6]);
            body.spin_rate = 2.0 * (second * body.turn.quaternion().conjugate()).imag();
        }
        let reaction = |suffix: &str| {
            let name = format!("j{suffix}");
            let row = M::DESCRIPTION.constraints.iter().position(|c| c.name == name);
            solved.multipliers[row.unwrap()]
        };
        passes_on(kind, &a, &b, &joint, &reaction);
        lets_accelerate(kind, &a, &b, &joint);
    }
}

/// Forces of some 30 N and accelerations of some 100 rad/s^2, through a solution of a condition of some 1e3.
#[track_caller]
fn vanishes(what: &str, value: f64) {
    assert!(value.abs() < 1e-9, "{what}: {value:e}");
}

/// The force and moment of the first body on the second, from Newton's and Euler's equations of both.
fn passes_on(kind: Kind, a: &Body, b: &Body, joint: &Joint, reaction: &dyn Fn(&str) -> f64) {
    let Joint { t1, t2, n, m, second: at, .. } = *joint;
    let g = Vector::new(0.5, 0.0, -9.81);
    let force = b.mass * (b.acceleration - g);
    let moment = b.moment() - Vector::new(0.7, -0.2, 0.4) - (at - b.place).cross(&force);
    let load = Vector::new(3.0, -4.0, 5.0);
    let on_first = a.mass * (a.acceleration - g) - load;
    let arm = a.turn * Vector::new(0.1, 0.2, -0.3);
    let moment_on_first = a.moment() - arm.cross(&load) - (at - a.place).cross(&on_first);
    vanishes("action and reaction", (force + on_first).norm());
    vanishes("their moments", (moment + moment_on_first).norm());
    match kind {
        Kind::Ball | Kind::Revolute | Kind::Universal | Kind::Weld => {
            vanishes("force", (force - Vector::new(reaction("_x"), reaction("_y"), reaction("_z"))).norm());
        }
        Kind::Cylindrical | Kind::Prismatic | Kind::Screw => {
            vanishes("f1", force.dot(&t1) - reaction("_f1"));
            vanishes("f2", force.dot(&t2) - reaction("_f2"));
        }
        Kind::Planar => {
            vanishes("f", force.dot(&n) - reaction("_f"));
            vanishes("in the plane", force.dot(&t1).hypot(force.dot(&t2)));
        }
    }
    match kind {
        Kind::Ball => vanishes("moment", moment.norm()),
        Kind::Universal => {
            vanishes("about both axes", moment.dot(&n).hypot(moment.dot(&m)));
            vanishes("m", moment.dot(&n.cross(&m)) - reaction("_m"));
        }
        _ => {
            vanishes("m1", moment.dot(&t1) - reaction("_m1"));
            vanishes("m2", moment.dot(&t2) - reaction("_m2"));
        }
    }
    match kind {
        Kind::Prismatic | Kind::Weld => vanishes("m3", moment.dot(&n) - reaction("_m3")),
        Kind::Screw => vanishes("power of the screw", force.dot(&n) * PITCH / TAU + moment.dot(&n)),
        _ => vanishes("about the axis", if kind == Kind::Universal { 0.0 } else { moment.dot(&n) }),
    }
    if matches!(kind, Kind::Cylindrical | Kind::Prismatic) {
        vanishes("along the axis", force.dot(&n));
    }
}

/// The second derivatives of what the joint keeps.
fn lets_accelerate(kind: Kind, a: &Body, b: &Body, joint: &Joint) {
    let Joint { t1, t2, n, m, first, second } = *joint;
    // From the point of the first body to that of the second.
    let apart = second - first;
    let rate = b.velocity_at(second) - a.velocity_at(first);
    let second_rate = b.acceleration_at(second) - a.acceleration_at(first);
    // Of axis.apart, the axis fixed in the first body.
    let along =
        |axis: Vector| a.second(axis).dot(&apart) + 2.0 * a.spin.cross(&axis).dot(&rate) + axis.dot(&second_rate);
    // Of u.v, u fixed in the first body and v in the second.
    let product = |u: Vector, v: Vector| {
        a.second(u).dot(&v) + 2.0 * a.spin.cross(&u).dot(&b.spin.cross(&v)) + u.dot(&b.second(v))
    };
    match kind {
        Kind::Ball | Kind::Revolute | Kind::Universal | Kind::Weld => vanishes("points", second_rate.norm()),
        Kind::Cylindrical | Kind::Prismatic | Kind::Screw => vanishes("axis", along(t1).hypot(along(t2))),
        Kind::Planar => vanishes("plane", along(n)),
    }
    match kind {
        Kind::Ball => {}
        Kind::Universal => vanishes("right angle", product(n, m)),
        _ => vanishes("parallel axes", product(t1, m).hypot(product(t2, m))),
    }
    if matches!(kind, Kind::Prismatic | Kind::Weld) {
        vanishes("turning", (b.spin_rate - a.spin_rate).norm());
    }
    if kind == Kind::Screw {
        let advance = a.spin.cross(&n).dot(&rate) + n.dot(&second_rate);
        let turning = a.spin.cross(&n).dot(&(b.spin - a.spin)) + n.dot(&(b.spin_rate - a.spin_rate));
        vanishes("screw", advance - PITCH / TAU * turning);
    }
}

#[test]
fn joints_are_what_newton_euler_and_geometry_say() {
    check::<Ball>(Kind::Ball);
    check::<Revolute>(Kind::Revolute);
    check::<Universal>(Kind::Universal);
    check::<Cylindrical>(Kind::Cylindrical);
    check::<Prismatic>(Kind::Prismatic);
    check::<Screw>(Kind::Screw);
    check::<Planar>(Kind::Planar);
    check::<Weld>(Kind::Weld);
}
