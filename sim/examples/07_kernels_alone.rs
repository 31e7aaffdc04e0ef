//! 7. Kernels without the runtime: what a controller calls on a real-time target.
//!
//! `controller` uses `core` and generated code only: no allocation, no standard library. In a crate with `#![no_std]`
//! it stands as it is: `sim-kernel` is all that it needs at run time, and `mechanism-macros` declares its mechanism.
//!
//! `cargo run --release --example 07_kernels_alone`

/// Computed torque: the torque that gives the crank a wanted acceleration in the present state.
mod controller {
    use models::FourBar;
    /// The torque on the crank, in N*m; nothing where the equations have no unique solution.
    pub(crate) fn torque(four_bar: &FourBar, q: &[f64; 3], qd: &[f64; 3], wanted: f64) -> Option<f64> {
        // The acceleration is linear in the torque: two evaluations tell the line.
        let with = |torque: f64| {
            let solved = FourBar { T: torque, ..*four_bar }.dynamics(0.0, q, qd);
            (!solved.refused).then_some(solved.accelerations[0])
        };
        let (at_zero, at_one) = (with(0.0)?, with(1.0)?);
        Some((wanted - at_zero) / (at_one - at_zero))
    }
}

use models::FourBar;

fn main() {
    let four_bar = FourBar::default();
    let closed = sim::assemble(&four_bar, &sim::declared_start(&four_bar));
    let Ok(state) = closed else { return println!("the linkage cannot be closed") };
    let (q, qd) = (state.positions, state.speeds);
    for wanted in [0.0, 10.0, -10.0] {
        match controller::torque(&four_bar, &q, &qd, wanted) {
            Some(torque) => {
                let reached = FourBar { T: torque, ..four_bar }.dynamics(0.0, &q, &qd).accelerations[0];
                println!("for {wanted:>5} rad/s^2: {torque:>9.4} N*m, which gives {reached:>9.4} rad/s^2");
            }
            None => println!("a pivot was refused"),
        }
    }
    println!("mass matrix: {:.4?}", four_bar.mass_matrix(0.0, &q));
}
