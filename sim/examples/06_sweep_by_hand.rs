//! 6. Parameters swept by hand: a design chart in ten lines. One build serves every design.
//!
//! `cargo run --release --example 06_sweep_by_hand`

use models::QuickReturn;
use sim::show::{Curve, Plot, Size, panels};
use sim::{Failure, Settings, Table, declared_start, run};
use std::path::Path;

fn stroke_and_period(crank: f64) -> Result<(f64, f64), Failure> {
    let machine = QuickReturn { O2A: crank, ..QuickReturn::default() };
    let found = run(machine, &declared_start(&machine), &Settings::new(2.0))?;
    let table = Table::of(&found.mechanism, &found.trajectory);
    let x6 = table.column("x6").map_or(&[][..], |column| &column.values);
    let low = x6.iter().copied().fold(f64::INFINITY, f64::min);
    let high = x6.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Ok((high - low, found.period().unwrap_or(f64::NAN)))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cranks: Vec<f64> = (10..=24).map(|step| 0.01 * f64::from(step)).collect();
    let found: Vec<(f64, f64)> = cranks.iter().map(|crank| stroke_and_period(*crank)).collect::<Result<_, _>>()?;
    println!("crank [m]  stroke [m]  period [s]");
    for (crank, (stroke, period)) in cranks.iter().zip(&found) {
        println!("{crank:>9.2}  {stroke:>10.4}  {period:>10.4}");
    }
    let panel = |label, values: Vec<f64>| Plot {
        title: "Length of the crank",
        x_label: "crank [m]",
        y_label: label,
        x: &cranks,
        curves: vec![Curve { label, values }],
    };
    let strokes = panel("stroke [m]", found.iter().map(|found| found.0).collect());
    let periods = panel("period [s]", found.iter().map(|found| found.1).collect());
    panels(&[strokes, periods], Size::default(), Path::new("out/example-06"), "sweep")?;
    println!("see out/example-06/sweep.svg");
    Ok(())
}
