//! The six-axis arm against the recursive Newton-Euler equations, written here by hand and with numbers, in the world's frame.

use codegen::kernel_id::KernelId;
use models::RobotArm;
use sim::{Compiled, Mechanism, accelerate};
use std::time::Instant;
use tests::Random;

type V = [f64; 3];

fn add(a: V, b: V) -> V {
    std::array::from_fn(|i| a[i] + b[i])
}

fn scaled(k: f64, a: V) -> V {
    a.map(|x| k * x)
}

fn cross(a: V, b: V) -> V {
    std::array::from_fn(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

fn dot(a: V, b: V) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// v turned by an angle about a coordinate axis of its frame.
fn about(axis: usize, angle: f64, v: V) -> V {
    let (s, c) = angle.sin_cos();
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut turned = v;
    turned[j] = c * v[j] - s * v[k];
    turned[k] = s * v[j] + c * v[k];
    turned
}

/// What a link adds: its joint's axis, where its centre and the next joint are, its mass and its moments.
struct Link {
    axis: usize,
    centre: V,
    next: V,
    mass: f64,
    inertia: V,
}

fn links(p: &RobotArm) -> [Link; 6] {
    let link = |axis, centre, next, mass, inertia| Link { axis, centre, next, mass, inertia };
    [
        link(2, [0.4 * p.a1, 0.0, 0.6 * p.h], [p.a1, 0.0, p.h], p.m1, [0.9, 0.8, 0.7]),
        link(1, [0.0, 0.0, 0.45 * p.a2], [0.0, 0.0, p.a2], p.m2, [0.75, 0.8, 0.1]),
        link(1, [0.2 * p.d4, 0.0, 0.03], [p.d4, 0.0, 0.0], p.m3, [0.08, 0.25, 0.24]),
        link(0, [-0.3 * p.d4, 0.0, 0.0], [0.0; 3], p.m4, [0.02, 0.06, 0.06]),
        link(1, [0.2 * p.d6, 0.0, 0.0], [p.d6, 0.0, 0.0], p.m5, [0.005, 0.006, 0.007]),
        link(0, [0.0; 3], [0.0; 3], p.m6, [0.002, 0.0015, 0.0015]),
    ]
}

/// Torques of the drives for a motion, and the sum of the magnitudes that went into each.
fn newton_euler(p: &RobotArm, q: &[f64; 6], qd: &[f64; 6], qdd: &[f64; 6], g: f64) -> [f64; 6] {
    let links = links(p);
    let turned = |i: usize, v: V| (0..=i).rev().fold(v, |v, k| about(links[k].axis, q[k], v));
    let (mut w, mut wd, mut a) = ([0.0; 3], [0.0; 3], [0.0, 0.0, g]);
    let (mut joint, mut joints, mut axes, mut wrenches) = ([0.0; 3], vec![], vec![], vec![]);
    for (i, link) in links.iter().enumerate() {
        let mut unit = [0.0; 3];
        unit[link.axis] = 1.0;
        let axis = turned(i, unit);
        wd = add(add(wd, scaled(qdd[i], axis)), cross(w, scaled(qd[i], axis)));
        w = add(w, scaled(qd[i], axis));
        let moved = |r: V| add(cross(wd, r), cross(w, cross(w, r)));
        let (to_centre, to_next) = (turned(i, link.centre), turned(i, link.next));
        let force = scaled(link.mass, add(a, moved(to_centre)));
        // The moment of inertia in the world, axis by axis of the body.
        let axes_of_body: [V; 3] = std::array::from_fn(|k| {
            let mut e = [0.0; 3];
            e[k] = 1.0;
            turned(i, e)
        });
        let momentum = |x: V| {
            (0..3).fold([0.0; 3], |sum, k| add(sum, scaled(link.inertia[k] * dot(axes_of_body[k], x), axes_of_body[k])))
        };
        let moment = add(momentum(wd), cross(w, momentum(w)));
        wrenches.push((add(joint, to_centre), force, moment));
        axes.push(axis);
        joints.push(joint);
        a = add(a, moved(to_next));
        joint = add(joint, to_next);
    }
    std::array::from_fn(|i| {
        let moment = (i..6).fold([0.0; 3], |sum, k| {
            let (at, force, moment) = wrenches[k];
            add(sum, add(moment, cross(add(at, scaled(-1.0, joints[i])), force)))
        });
        dot(axes[i], moment)
    })
}

/// Without friction and drives.
fn bare(random: &mut Random) -> RobotArm {
    let arm = RobotArm::default();
    let mut parameters = arm.parameters();
    parameters.iter_mut().for_each(|p| *p *= random.between(0.8, 1.2));
    let arm = arm.with_parameters(parameters);
    let arm = arm.with_inputs(arm.inputs().map(|_| sim::Input::Held(0.0)));
    RobotArm { c: 0.0, ..arm }
}

fn state(random: &mut Random) -> [[f64; 6]; 3] {
    [1.5, 3.0, 9.0].map(|size| std::array::from_fn(|_| random.between(-size, size)))
}

fn worst(found: &[f64; 6], expected: &[f64; 6]) -> f64 {
    let size = expected.iter().fold(1.0f64, |size, x| size.max(x.abs()));
    found.iter().zip(expected).map(|(a, b)| (a - b).abs() / size).fold(0.0, f64::max)
}

#[test]
fn kernels_are_those_of_newton_and_euler() {
    let mut random = Random(5);
    let (mut inverse, mut matrix, mut biases, mut forward, mut trip) = (0.0f64, 0.0f64, 0.0f64, 0.0f64, 0.0f64);
    for _ in 0..1000 {
        let arm = bare(&mut random);
        let [q, qd, qdd] = state(&mut random);
        let expected = newton_euler(&arm, &q, &qd, &qdd, arm.g);
        inverse = inverse.max(worst(&arm.inverse_dynamics(0.0, &q, &qd, &qdd), &expected));
        let mass = Mechanism::mass_matrix(&arm, 0.0, &q);
        for j in 0..6 {
            let unit = std::array::from_fn(|k| if k == j { 1.0 } else { 0.0 });
            let column = newton_euler(&arm, &q, &[0.0; 6], &unit, 0.0);
            matrix = matrix.max(worst(&std::array::from_fn(|i| mass[i][j]), &column));
        }
        let (h, loads) = (arm.convective_forces(0.0, &q, &qd), arm.generalized_forces(0.0, &q, &qd));
        let bias = newton_euler(&arm, &q, &qd, &[0.0; 6], arm.g);
        biases = biases.max(worst(&std::array::from_fn(|i| h[i] - loads[i]), &bias));
        // Round trip: the torques of a motion, put in as drives, give that motion.
        let inputs = expected.map(sim::Input::Held);
        let driven = arm.with_inputs(inputs);
        let found = accelerate(&driven, 0.0, &q, &qd).unwrap().accelerations;
        trip = trip.max(worst(&found, &qdd));
        let free = accelerate(&arm, 0.0, &q, &qd).unwrap().accelerations;
        let rest = newton_euler(&arm, &q, &qd, &free, arm.g);
        let size = bias.iter().fold(1.0f64, |size, x| size.max(x.abs()));
        forward = forward.max(rest.iter().fold(0.0f64, |m, x| m.max(x.abs())) / size);
    }
    println!(
        "six-axis arm against recursive Newton-Euler, relative: inverse dynamics {inverse:.1e}, mass matrix {matrix:.1e}, bias \
         {biases:.1e}, forces left by forward dynamics {forward:.1e}, round trip {trip:.1e}"
    );
    assert!(
        inverse < 1e-12 && matrix < 1e-12 && biases < 1e-12 && forward < 1e-12,
        "{inverse:e} {matrix:e} {biases:e}"
    );
    // A solution is as good as the mass matrix is conditioned: some 1e5 here.
    assert!(trip < 1e-10, "{trip:e}");
}

/// Counted as published counts are: additions and multiplications, without the sines and cosines.
#[test]
fn operations_are_no_more_than_published() {
    let tokens = RobotArm::<f64>::DESCRIPTION.declaration.parse().unwrap();
    let clock = Instant::now();
    let model = codegen::model::resolve(&codegen::parse(tokens).unwrap()).unwrap();
    let mut equations = codegen::dynamics::derive_cheapest(model);
    let program = codegen::program::plan(&mut equations);
    println!("derivation and planning, without optimisation: {:.2} s", clock.elapsed().as_secs_f64());
    for (id, most) in [(KernelId::InverseDynamics, 692), (KernelId::MassMatrix, 635), (KernelId::Dynamics, usize::MAX)]
    {
        let kernel = program.kernels.iter().find(|kernel| kernel.id == id).unwrap();
        let counted = kernel.operations;
        println!(
            "{}: {} additions, {} multiplications, {} divisions",
            id.name(),
            counted.additions,
            counted.multiplications,
            counted.divisions
        );
        assert!(counted.additions + counted.multiplications + counted.divisions <= most);
    }
}
