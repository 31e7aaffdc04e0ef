//! 5. A load of one's own, that no expression says: a controller with memory, sampled at 1 kHz.
//!
//! The declaration leaves the torque as a parameter; the program sets it between steps.
//!
//! `cargo run --release --example 05_own_load`

use models::FourBar;
use sim::{Failure, Method, Settings, Start, declared_start, run};

/// Keeps the crank's speed, by proportion and integral.
struct Controller {
    wanted: f64,
    sum: f64,
}

impl Controller {
    fn torque(&mut self, speed: f64, h: f64) -> f64 {
        let error = self.wanted - speed;
        self.sum += error * h;
        // A motor has its limits.
        (30.0 * error + 300.0 * self.sum).clamp(-40.0, 40.0)
    }
}

fn main() -> Result<(), Failure> {
    let (mut controller, h) = (Controller { wanted: 12.0, sum: 0.0 }, 1e-3);
    let mut four_bar = FourBar::default();
    let mut start = declared_start(&four_bar);
    for sample in 0..3000 {
        four_bar.T = controller.torque(start.speeds[0], h);
        let found = run(four_bar, &start, &Settings::equal_steps(Method::Rk4, h, 2))?;
        let Some(last) = found.trajectory.samples.last() else { break };
        // The next millisecond starts where this one ended.
        start = Start { positions: last.state.positions, speeds: last.state.speeds, ..start };
        if (sample + 1) % 500 == 0 {
            let (time, speed) = (f64::from(sample + 1) * h, start.speeds[0]);
            println!("t = {time:.1} s: crank at {speed:>7.3} rad/s, torque {:>7.2} N*m", four_bar.T);
        }
    }
    Ok(())
}
