//! What grows with the size of a mechanism: operations, and the time of the derivation.

use super::accuracy::accuracy;
use super::counts::{derived, operations};
use super::growth::growth;
use super::walker::walker_runs;
use super::{Subject, Table};

pub(super) const SUBJECTS: &[Subject] = &[
    ("robots", robots),
    ("derivatives", derivatives),
    ("walker", walker),
    ("runs", walker_runs),
    ("growth", growth),
    ("accuracy", accuracy),
];

/// A kernel, and the operations of the recursion that is specialised to the robot (articulated bodies, Newton-Euler and
/// composite bodies in the bodies' own frames, inertial parameters regrouped), sines aside.
pub(super) type Recursion = (&'static str, usize);

/// What a free base may take besides.
const FREE: usize = 200;

/// What the mass matrix in q' may take besides, with so many joints on a free base.
const fn in_coordinates(joints: usize) -> usize {
    40 * joints + 250
}

pub(super) const LEG: &str = include_str!("../../robots/declared/leg.rs");
pub(super) const WISHBONE: &str = include_str!("../../robots/declared/wishbone.rs");

pub(super) const ROBOTS: [(&str, &str, &[Recursion]); 5] = [
    (
        "UR5",
        include_str!("../../robots/declared/ur5.rs"),
        &[("dynamics", 736), ("inverse_dynamics", 370), ("mass_matrix", 162)],
    ),
    (
        "Talos' arm",
        include_str!("../../robots/declared/talosarm.rs"),
        &[("dynamics", 1635), ("inverse_dynamics", 833), ("mass_matrix", 392)],
    ),
    (
        "Panda",
        include_str!("../../robots/declared/panda.rs"),
        &[("dynamics", 1865), ("inverse_dynamics", 1031), ("mass_matrix", 548)],
    ),
    (
        "ANYmal",
        include_str!("../../robots/declared/anymal.rs"),
        &[
            ("dynamics", 4039 + FREE),
            ("inverse_dynamics", 2044 + FREE),
            ("speed_mass_matrix", 756 + FREE),
            ("mass_matrix", 756 + FREE + in_coordinates(12)),
        ],
    ),
    (
        "Talos",
        include_str!("../../robots/declared/talos.rs"),
        &[
            ("dynamics", 10_002 + FREE),
            ("inverse_dynamics", 4982 + FREE),
            ("speed_mass_matrix", 3301 + FREE),
            ("mass_matrix", 3301 + FREE + in_coordinates(32)),
        ],
    ),
];

fn robots(table: &mut Table) {
    table.heading("Operations of declared robots, sines aside");
    for (name, text, recursions) in ROBOTS {
        let Some(derived) = derived(table, name, text) else { continue };
        for (kernel, most) in recursions {
            let what = format!("{name}: {kernel}");
            match operations(&derived, kernel) {
                Some(count) => table.at_most(&what, count as f64, *most as f64),
                None => table.line(&what, "no such kernel", format!("at most {most}"), false),
            }
        }
    }
}

/// Declarations with the operations that their derivatives may take: those before they came along the tree, and for the wishbone
/// half of them.
const DIFFERENTIATED: [(&str, &str, usize); 3] = [
    ("Talos' arm", include_str!("../../robots/declared/talosarm.rs"), 19_369),
    ("ANYmal", include_str!("../../robots/declared/anymal.rs"), 165_982),
    ("double wishbone", WISHBONE, 8000),
];

fn derivatives(table: &mut Table) {
    table.heading("Operations of dynamics_jacobian; times of the robots are printed by tests/robots/race/race.sh");
    for (name, text, most) in DIFFERENTIATED {
        let text = text.replace("inverse_dynamics;", "dynamics_jacobian;");
        let Some(derived) = derived(table, name, &text) else { continue };
        match operations(&derived, "dynamics_jacobian") {
            Some(count) => table.at_most(name, count as f64, most as f64),
            None => table.line(name, "no such kernel", format!("at most {most}"), false),
        }
    }
}

/// Operations of `dynamics` for one pair of legs.
const ONE: f64 = 1174.0;

fn walker(table: &mut Table) {
    table.heading("Jansen's walker with 2 n legs");
    let text = include_str!("../../robots/declared/beest.rs");
    for n in [1, 3, 6, 12] {
        let name = format!("n = {n}");
        let Some(derived) = derived(table, &name, &text.replace("const n = 6;", &format!("const n = {n};"))) else {
            continue;
        };
        let count = operations(&derived, "dynamics").unwrap_or(usize::MAX);
        table.at_most(&format!("{name}: dynamics"), count as f64, 1.1 * ONE * f64::from(n));
    }
}
