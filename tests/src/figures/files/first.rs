//! From text to a first result.

use super::milliseconds;
use crate::figures::Table;
use sim::{At, DeclarationFile, Kernel};
use std::hint::black_box;
use std::path::Path;
use tests::shortest;

/// From text to the accelerations at the declared start.
pub(super) fn first_results(table: &mut Table) {
    table.heading("From text to a first result, in ms");
    let of = |name: &str| tests::shipped().into_iter().find(|description| description.name == name);
    for (name, bound) in [("andrews", 30.0), ("robot-arm", 40.0), ("stewart", 60.0)] {
        if let Some(description) = of(name) {
            first_result(table, name, description.declaration, bound);
        }
    }
    if let Some(description) = of("four-bars") {
        let forty = description.declaration.replace("const N = 3;", "const N = 40;");
        first_result(table, "40 four-bars", &forty, 200.0);
    }
}

fn first_result(table: &mut Table, name: &str, text: &str, bound: f64) {
    let mut coordinates = 0;
    let time = shortest(5, || {
        let file = DeclarationFile::of(Path::new("first.mech"), text.to_owned());
        if let Ok(model) = file.model(None) {
            let [q, qd] = model.initial();
            coordinates = q.len();
            let at = At { time: 0.0, positions: &q, speeds: &qd, accelerations: &[], multipliers: &[] };
            model.prepare().call(Kernel::Dynamics, at, &mut |_, row| {
                black_box(row);
            });
        }
    });
    table.at_most(&format!("{name}, {coordinates} coordinates"), milliseconds(time), bound);
}
