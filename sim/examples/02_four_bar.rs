//! 2. A four-bar linkage: a loop, closed by a constraint; an own start; the report.
//!
//! `cargo run --release --example 02_four_bar`

use models::FourBar;
use sim::{Settings, Table, declared_start, run, show, summary};
use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let four_bar = FourBar { T: 3.0, ..FourBar::default() };
    // Where the crank starts is given; assembly finds the other angles near their guesses.
    let mut start = declared_start(&four_bar);
    start.positions[0] = 0.5;
    start.speeds[0] = 5.0;
    let found = run(four_bar, &start, &Settings::new(1.5))?;
    println!("constraints open by at most {:.1e}", found.position_residual);
    println!("energy off by at most {:.1e}, relative", found.energy_balance);

    // The reaction in the pin B is the multiplier of its constraint, in newtons because that is between lengths.
    let table = Table::of(&found.mechanism, &found.trajectory);
    if let Some(force) = table.column("Bx") {
        let largest = force.values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        println!("the pin B carries up to {largest:.1} {} along x", force.unit);
    }
    let directory = Path::new("out/example-02");
    std::fs::create_dir_all(directory)?;
    let about = show::About { summary: &summary(&found, &table), command: "02_four_bar", run_file: None };
    show::report(&found, &table, &about, &directory.join("report.html"))?;
    println!("see {}", directory.join("report.html").display());
    Ok(())
}
