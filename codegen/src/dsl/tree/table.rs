//! Functions given by rows.

use crate::dsl::{Expression, Region, Unit};
use syn::Ident;

/// `lift [mm] over [deg] = cubic, periodic { 0, 0; 90, 10; 360, 0; }`
pub struct Table {
    /// Documentation.
    pub docs: String,
    /// Its name.
    pub name: Ident,
    /// The unit of its values.
    pub unit: Option<Unit>,
    /// The unit of its arguments.
    pub over: Option<Unit>,
    /// What is between rows.
    pub between: Between,
    /// What a cubic obeys at the first and the last row, and where that is said.
    pub ends: Option<(Ends, Region)>,
    /// What it is outside of its rows.
    pub outside: Outside,
    /// Arguments and values, row by row.
    pub rows: Vec<[Expression; 2]>,
}

/// What a table is between its rows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Between {
    /// `linear`: straight lines.
    Linear,
    /// `cubic`: cubics with continuous first and second derivatives.
    Cubic,
    /// `monotone`: cubics that rise and fall where the rows do, with continuous first derivatives.
    Monotone,
}

/// What a cubic obeys at its first and last row.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ends {
    /// `natural`: no second derivative.
    Natural,
    /// `clamped`: no first derivative.
    Clamped,
}

/// What a table is outside of its rows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Outside {
    /// `held`: the value of the first or last row.
    Held,
    /// `continued`: the straight line with the value and the slope there.
    Continued,
    /// `periodic`: the rows again and again.
    Periodic,
}
