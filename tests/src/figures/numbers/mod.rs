//! No wrong number with exit status 0: each file measures the lines of one subject.

mod bennett;
mod coupling;
mod eigenvalues;
mod extremes;
mod faults;
mod known;
mod programs;
mod speed;
mod stress;
mod verify;

use super::Subject;

pub(super) const SUBJECTS: &[Subject] = &[
    ("known", known::measure),
    ("stress", stress::measure),
    ("bennett", bennett::measure),
    ("extremes", extremes::measure),
    ("eigenvalues", eigenvalues::measure),
    ("verify", verify::measure),
    ("faults", faults::measure),
    ("coupling", coupling::measure),
    ("speed", speed::measure),
];
