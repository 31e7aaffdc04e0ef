//! Operations of chains, trees and parallel loops of ten bodies to a hundred.

use super::Table;
use super::counts::{derived, operations};
use std::fmt::Write;

/// At most so many times what the line through the counts of ten and twenty has: the ends of a chain take less than its middle.
const MOST: f64 = 1.1;

/// The declaration of a mechanism of so many bodies.
type Declared = fn(usize) -> String;

pub(super) fn growth(table: &mut Table) {
    table.heading("Operations as mechanisms grow, beside the line through those of 10 and 20 bodies, times 1.1");
    let kinds: [(&str, Declared); 4] = [
        ("planar chain", planar_chain),
        ("spatial chain", spatial_chain),
        ("spatial tree", spatial_tree),
        ("engine", engine),
    ];
    for (name, text) in kinds {
        let counts = |table: &mut Table, n: usize| -> Option<[f64; 2]> {
            let derived = derived(table, &format!("{name} of {n}"), &text(n))?;
            let [Some(forward), Some(inverse)] =
                ["dynamics", "inverse_dynamics"].map(|kernel| operations(&derived, kernel))
            else {
                table.line(name, "no such kernel", "dynamics and inverse_dynamics", false);
                return None;
            };
            Some([forward as f64, inverse as f64])
        };
        let (Some(ten), Some(twenty)) = (counts(table, 10), counts(table, 20)) else { continue };
        for n in [40, 100] {
            let Some(found) = counts(table, n) else { continue };
            for (i, kernel) in ["dynamics", "inverse_dynamics"].iter().enumerate() {
                let line = ten[i] + (twenty[i] - ten[i]) / 10.0 * (n - 10) as f64;
                table.at_most(&format!("{name} of {n}: {kernel}"), found[i], MOST * line);
            }
        }
    }
}

/// A declaration of n coordinates, from what each body is.
fn declared(n: usize, gravity: &str, body: impl Fn(usize) -> String) -> String {
    let coordinates: String = (0..n).map(|i| format!("q{i} [rad]; ")).collect();
    let bodies = (0..n).fold(String::new(), |mut text, i| {
        let _ = writeln!(text, "{}", body(i));
        text
    });
    format!(
        "mechanism! {{ pub Growing; parameters {{ m [kg] = 1; L [m] = 1; J [kg*m^2] = 0.1; }} coordinates {{ {coordinates} }}
        {bodies} loads {{ gravity {gravity}; }} kernels {{ inverse_dynamics; }} }}"
    )
}

fn planar_chain(n: usize) -> String {
    declared(n, "[0, -9.81 [m/s^2]]", |i| {
        let before = if i == 0 { "[0, 0]".to_owned() } else { format!("P{}", i - 1) };
        format!(
            "let P{i} = {before} + L*[cos(q{i}), sin(q{i})];
            bodies {{ b{i}: mass m at {before} + 0.5*L*[cos(q{i}), sin(q{i})], inertia J, angle q{i}; }}"
        )
    })
}

fn spatial_chain(n: usize) -> String {
    spatial(n, |i| i - 1)
}

/// Each body carries two.
fn spatial_tree(n: usize) -> String {
    spatial(n, |i| (i - 1) / 2)
}

fn spatial(n: usize, before: impl Fn(usize) -> usize) -> String {
    declared(n, "[0, 0, -9.81 [m/s^2]]", |i| {
        let axis = ["x", "y", "z"][i % 3];
        let (turn, place) = match i {
            0 => (String::new(), String::new()),
            _ => (format!("R{}*", before(i)), format!("P{} + ", before(i))),
        };
        format!(
            "let R{i} = {turn}rotation({axis}, q{i}); let P{i} = {place}R{i}*[0, 0, L];
            bodies {{ b{i}: mass m at {place}R{i}*[0.1*L, 0, 0.5*L], inertia [J, 1.1*J, 0.9*J], attitude R{i}; }}"
        )
    })
}

/// So many pistons on one crank.
fn engine(n: usize) -> String {
    format!(
        "mechanism! {{ pub Engine; parameters {{ m [kg] = 1; L [m] = 1; J [kg*m^2] = 0.1; }} coordinates {{ a [rad]; }}
        fragment Cylinder(phase) {{
            coordinates {{ b [rad]; x [m]; }}
            let P = 0.3*L*[cos(a + phase), sin(a + phase)];
            bodies {{ rod: mass m at P + 0.4*L*[cos(b), sin(b)], inertia J, angle b; piston: mass 0.5*m at [x, 0]; }}
            constraints {{ pin: P + L*[cos(b), sin(b)] = [x, 0]; }}
            initial {{ guess b = 0.1; guess x = 1.2*L; }}
        }}
        bodies {{ wheel: inertia J, angle a; }} repeat i in 1..={n} {{ use Cylinder(0.7*i) as c_[i]; }}
        kernels {{ inverse_dynamics; }} }}"
    )
}
