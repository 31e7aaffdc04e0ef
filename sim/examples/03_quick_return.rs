//! 3. The quick-return mechanism: what is asked of a machine, from events and outputs.
//!
//! `cargo run --release --example 03_quick_return`

use models::QuickReturn;
use sim::{Settings, Table, declared_start, run};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let machine = QuickReturn::default();
    let found = run(machine, &declared_start(&machine), &Settings::new(2.0))?;
    let period = found.period().ok_or("no full turn within the run")?;
    println!("a turn takes {period:.12} s");

    // The slider works while it goes one way and returns quickly: the ratio of the two times names the mechanism.
    let table = Table::of(&found.mechanism, &found.trajectory);
    let speed = table.column("x6_velocity").ok_or("no such output")?;
    let within = table.times().iter().filter(|time| **time <= period).count();
    let forward = speed.values[..within].iter().filter(|speed| **speed < 0.0).count();
    println!("the slider goes left {:.1} % of that time", 100.0 * forward as f64 / within as f64);

    // The law of energy is checked in every run; here is the work that the force on the slider did.
    if let Some(last) = found.trajectory.samples.last() {
        println!("work of the loads until t = {} s: {:.3} J", last.state.time, last.state.work);
    }
    Ok(())
}
