//! The six-axis arm: operations and times of its kernels, beside published counts of other generators.

use codegen::kernel_id::KernelId;
use models::RobotArm;
use sim::{Compiled, Mechanism, accelerate};
use std::hint::black_box;
use tests::{Random, shortest};

/// Published: arm, kernel, additions and multiplications, and time where one is given.
const PUBLISHED: [(&str, &str, &str); 6] = [
    ("HybrDyn, six axes, spherical wrist", "inverse dynamics", "304 + 388"),
    ("HybrDyn, six axes, spherical wrist", "mass matrix", "261 + 374"),
    ("SymPyBotics, Puma 560", "inverse dynamics", "402 + 494, 198 ns"),
    ("SymPyBotics, Puma 560", "mass matrix", "325 + 400, 180 ns"),
    ("Pinocchio, iiwa, seven axes", "inverse dynamics", "0.3 us"),
    ("Pinocchio, iiwa, seven axes", "forward dynamics", "0.9 us"),
];

const STATES: usize = 1000;

fn main() {
    let Ok(tokens) = RobotArm::<f64>::DESCRIPTION.declaration.parse() else { return };
    let Ok(model) = codegen::parse(tokens).and_then(|declaration| codegen::model::resolve(&declaration)) else {
        return;
    };
    let mut equations = codegen::dynamics::derive_cheapest(model);
    let program = codegen::program::plan(&mut equations);
    let arm = RobotArm::default();
    let mut random = Random(3);
    let states: Vec<[[f64; 6]; 3]> =
        (0..STATES).map(|_| [1.5, 3.0, 9.0].map(|size| std::array::from_fn(|_| random.between(-size, size)))).collect();
    let prepared = arm.prepare();
    let time = |f: &mut dyn FnMut(&[[f64; 6]; 3])| {
        shortest(200, || states.iter().for_each(&mut *f)).as_secs_f64() / STATES as f64 * 1e9
    };
    let times = [
        (
            KernelId::InverseDynamics,
            time(&mut |[q, qd, qdd]| _ = black_box(prepared.inverse_dynamics(0.0, q, qd, qdd))),
        ),
        (KernelId::MassMatrix, time(&mut |[q, ..]| _ = black_box(Mechanism::mass_matrix(&arm, 0.0, q)))),
        (
            KernelId::Dynamics,
            time(&mut |[q, qd, _]| {
                _ = black_box(<RobotArm as Mechanism>::prepared_dynamics(&prepared, 0.0, q, qd));
            }),
        ),
    ];
    let [q, qd, _] = &states[0];
    if accelerate(&arm, 0.0, q, qd).is_err() {
        println!("the arm has no accelerations");
    }
    println!("{:<36} {:<18} additions + multiplications, time", "generator", "kernel");
    for (id, time) in times {
        let Some(kernel) = program.kernels.iter().find(|kernel| kernel.id == id) else { continue };
        let counted = kernel.operations;
        println!(
            "{:<36} {:<18} {} + {} (and {} divisions, {} sine-cosine pairs), {time:.0} ns",
            "Linkwright, six axes, spherical wrist",
            id.name(),
            counted.additions,
            counted.multiplications,
            counted.divisions,
            counted.sine_cosines
        );
    }
    for (generator, kernel, cost) in PUBLISHED {
        println!("{generator:<36} {kernel:<18} {cost}");
    }
}
