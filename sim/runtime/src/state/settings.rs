//! How to run a motion.

use std::fmt;

/// Which method advances the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Euler's explicit method, order 1.
    Euler,
    /// Heun's method, order 2.
    Heun,
    /// Kutta's method of order 3.
    Rk3,
    /// The classical method of Runge and Kutta, order 4.
    Rk4,
    /// Dormand and Prince, order 5 with an error estimate of order 4.
    Dopri5,
    /// Dormand and Prince, order 8 with error estimates of order 5 and 3.
    Dop853,
    /// Radau IIA of order 5, implicit: for stiff springs and dampers.
    Radau5,
}

impl Method {
    /// All methods, by order.
    pub const ALL: [Method; 7] =
        [Method::Euler, Method::Heun, Method::Rk3, Method::Rk4, Method::Dopri5, Method::Radau5, Method::Dop853];

    /// Its name on the command line and in files.
    pub const fn name(self) -> &'static str {
        match self {
            Method::Euler => "euler",
            Method::Heun => "heun",
            Method::Rk3 => "rk3",
            Method::Rk4 => "rk4",
            Method::Dopri5 => "dopri5",
            Method::Dop853 => "dop853",
            Method::Radau5 => "radau5",
        }
    }

    /// Its order of convergence.
    pub const fn order(self) -> usize {
        match self {
            Method::Euler => 1,
            Method::Heun => 2,
            Method::Rk3 => 3,
            Method::Rk4 => 4,
            Method::Dopri5 | Method::Radau5 => 5,
            Method::Dop853 => 8,
        }
    }

    /// Whether it estimates its error, and so can choose its steps.
    pub const fn is_adaptive(self) -> bool {
        matches!(self, Method::Dopri5 | Method::Dop853 | Method::Radau5)
    }
}

/// The length of the steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stepping {
    /// This many steps of equal length.
    Equal(usize),
    /// As long as the tolerance allows.
    Adaptive(Tolerance),
}

/// The allowed error of one step in a coordinate or speed x: `relative` times |x| plus `absolute` times the scale of x,
/// which is the mechanism's own length for lengths and 1 rad for angles ([`Measures`](crate::Measures)), whatever the
/// declared unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Relative.
    pub relative: f64,
    /// Absolute, as a fraction of the scale of a coordinate.
    pub absolute: f64,
}

impl Tolerance {
    /// The same number for both.
    pub const fn new(relative: f64) -> Tolerance {
        Tolerance { relative, absolute: relative }
    }
}

/// How the motion is kept on its constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stabilisation {
    /// Every step is projected, by the smallest change of coordinates.
    Projection,
    /// Every step is projected, by the smallest change in the metric of the mass matrix.
    MassProjection,
    /// Only the parts of the coordinates along the constraints are integrated; those across follow from the constraints at every
    /// evaluation.
    Partitioning,
    /// Baumgarte's method: C'' + 2 a C' + a^2 C = 0, with this a in 1/s. Constraints drift; for comparison.
    Baumgarte(f64),
    /// None: constraints drift; for comparison.
    None,
}

impl fmt::Display for Stabilisation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Stabilisation::Projection => f.write_str("projection"),
            Stabilisation::MassProjection => f.write_str("mass-projection"),
            Stabilisation::Partitioning => f.write_str("partitioning"),
            Stabilisation::Baumgarte(rate) => write!(f, "baumgarte={rate}"),
            Stabilisation::None => f.write_str("none"),
        }
    }
}

/// The times at which the motion is recorded. They do not change the steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rows {
    /// After each step.
    Steps,
    /// At the ends of this many intervals of equal length. A run that ends early has up to twice as many, shorter by a
    /// power of two, and its last state.
    Even(usize),
}

/// An event that ends the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StopAt {
    /// Which event, by index.
    pub event: usize,
    /// The occurrence, counted from 1.
    pub occurrence: usize,
}

/// How to run a motion from time 0.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// The end, in seconds.
    pub end: f64,
    /// The method.
    pub method: Method,
    /// Its steps.
    pub stepping: Stepping,
    /// The stabilisation of the constraints.
    pub stabilisation: Stabilisation,
    /// The record.
    pub rows: Rows,
    /// The event that ends the run early.
    pub stop: Option<StopAt>,
}

impl Settings {
    /// DOP853 at a relative tolerance of 1e-10, projected, recorded at 1025 times.
    pub const fn new(end: f64) -> Settings {
        Settings {
            end,
            method: Method::Dop853,
            stepping: Stepping::Adaptive(Tolerance::new(1e-10)),
            stabilisation: Stabilisation::Projection,
            rows: Rows::Even(1024),
            stop: None,
        }
    }

    /// A method with equal steps, recorded after each.
    pub const fn equal_steps(method: Method, end: f64, steps: usize) -> Settings {
        let stepping = Stepping::Equal(steps);
        Settings { method, stepping, rows: Rows::Steps, ..Settings::new(end) }
    }

    /// A method that chooses its steps.
    pub const fn adaptive(method: Method, end: f64, relative: f64) -> Settings {
        Settings { method, stepping: Stepping::Adaptive(Tolerance::new(relative)), ..Settings::new(end) }
    }

    /// Checks that they suit a mechanism with this many events; the error says what is wrong and how to correct it.
    pub(crate) fn check(&self, events: usize) -> Result<(), String> {
        let is_equal = matches!(self.stepping, Stepping::Equal(_));
        if self.end.is_nan() || (is_equal && self.end.is_infinite()) {
            return Err(format!("a motion cannot end at {} s: give a time", self.end));
        }
        match (self.stepping, self.stop) {
            (Stepping::Equal(0), _) => Err("no motion is made of 0 equal steps: give 1 at least".to_owned()),
            (_, Some(StopAt { event, .. })) if event >= events => {
                Err(format!("event {event} is to end the motion, and there are {events}: they are counted from 0"))
            }
            (_, Some(StopAt { occurrence: 0, .. })) => {
                Err("the occurrence 0 of an event is to end the motion: they are counted from 1".to_owned())
            }
            _ => Ok(()),
        }
    }
}
