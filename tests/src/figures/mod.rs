//! Tables of figures: each line says what is measured, its value, its bound, and whether it is met.
//!
//! An area has subjects, each a function that measures its lines one after the other; a line is printed as soon as its
//! value is known.

mod accuracy;
mod binary;
mod builds;
mod counts;
mod files;
mod growth;
mod kernels;
mod numbers;
mod printed;
mod robots;
mod rooms;
mod size;
mod sizes;
mod walker;

use std::fmt::Display;

/// What can be asked for.
pub(crate) struct Area {
    pub(crate) name: &'static str,
    pub(crate) about: &'static str,
    /// By name, what measures the lines of each.
    pub(crate) subjects: &'static [Subject],
}

/// A name, and what measures its lines.
pub(crate) type Subject = (&'static str, fn(&mut Table));

/// The areas, in order.
pub(crate) const AREAS: &[Area] = &[
    measured("numbers", "no wrong number with exit status 0", numbers::SUBJECTS),
    measured("rooms", "a runtime for every use, and a house with rooms", rooms::SUBJECTS),
    measured("files", "mechanisms as files: run in milliseconds", files::SUBJECTS),
    measured("size", "robots, walkers, parallel machines", size::SUBJECTS),
    measured("robots", "robots as they come: URDF", robots::SUBJECTS),
    open("sweeps"),
    open("design"),
    open("languages"),
    open("friction"),
    open("taylor"),
    measured("kernels", "what kernels cost", kernels::SUBJECTS),
];

const fn measured(name: &'static str, about: &'static str, subjects: &'static [Subject]) -> Area {
    Area { name, about, subjects }
}

const fn open(name: &'static str) -> Area {
    Area { name, about: "no figure of this area is measured yet", subjects: &[] }
}

/// What has been printed of a table.
#[derive(Default)]
pub(crate) struct Table {
    missed: usize,
    elsewhere: usize,
}

#[allow(dead_code)]
impl Table {
    /// A heading over the lines that follow.
    pub(crate) fn heading(&mut self, text: &str) {
        println!("\n{text}\n{}", "-".repeat(text.chars().count()));
    }

    /// A line whose value is words, or met by a condition of its own.
    pub(crate) fn line(&mut self, what: &str, value: impl Display, bound: impl Display, is_met: bool) {
        let verdict = if is_met { "met" } else { "MISSED" };
        self.missed += usize::from(!is_met);
        println!("{what:<68} {:>14}   {:<22} {verdict}", value.to_string(), bound.to_string());
    }

    /// A value that must not be greater than its bound.
    pub(crate) fn at_most(&mut self, what: &str, value: f64, bound: f64) {
        self.line(what, short(value), format!("at most {}", short(bound)), value <= bound);
    }

    /// A value that must not be less than its bound.
    pub(crate) fn at_least(&mut self, what: &str, value: f64, bound: f64) {
        self.line(what, short(value), format!("at least {}", short(bound)), value >= bound);
    }

    /// A line that is not measured here: the command that measures it, or why there is none.
    pub(crate) fn elsewhere(&mut self, what: &str, how: &str) {
        self.elsewhere += 1;
        println!("{what:<68} {:>14}   {how}", "-");
    }

    /// Prints how many lines were missed and how many are not measured; whether none was missed.
    pub(crate) fn conclude(&self) -> bool {
        println!("\n{} missed, {} not measured here", self.missed, self.elsewhere);
        self.missed == 0
    }
}

/// A number in four digits, or as it is if it is whole.
fn short(value: f64) -> String {
    match value.abs() {
        size if value == value.trunc() && size < 1e9 => format!("{value}"),
        size if (1e-3..1e6).contains(&size) => format!("{value:.4}"),
        _ => format!("{value:.3e}"),
    }
}
