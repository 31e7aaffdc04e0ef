//! Functions given by rows.

use crate::dsl::{Expression, Region, Unit};
use syn::{Ident, LitStr};

/// `lift [mm] over [deg] = cubic, periodic { 0, 0; 90, 10; 360, 0; }`
pub struct DeclaredTable {
    /// Documentation.
    pub docs: String,
    /// Its name.
    pub name: Ident,
    /// The unit of its values.
    pub unit: Option<Unit>,
    /// The unit of its arguments.
    pub over: Option<Unit>,
    /// The interpolation between rows.
    pub between: Between,
    /// The end condition of a cubic at the first and last row, and its place in the text.
    pub ends: Option<(Ends, Region)>,
    /// The extension beyond the rows.
    pub outside: Outside,
    /// What stands over the arguments and over the values, where they have a heading.
    pub headings: Option<[LitStr; 2]>,
    /// Arguments and values, row by row.
    pub rows: Vec<[Expression; 2]>,
}

/// The interpolation of a table between its rows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Between {
    /// `linear`: straight lines.
    Linear,
    /// `cubic`: cubics with continuous first and second derivatives.
    Cubic,
    /// `monotone`: cubics that rise and fall where the rows do, with continuous first derivatives.
    Monotone,
}

/// The end condition of a cubic at its first and last row.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ends {
    /// `natural`: no second derivative.
    Natural,
    /// `clamped`: no first derivative.
    Clamped,
}

/// The extension of a table beyond its rows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Outside {
    /// `held`: the value of the first or last row.
    Held,
    /// `continued`: the straight line with the value and the slope there.
    Continued,
    /// `periodic`: the rows repeat.
    Periodic,
}
