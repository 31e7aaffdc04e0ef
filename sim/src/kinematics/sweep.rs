//! A drive through its range: the sweep.

use super::driven::Driven;
use super::inverse::{AnyPrescribed, prescribed};
use super::path::{Path, Point, Span, Special};
use super::system::{Law, System};
use crate::any::AnyMechanism;
use crate::failure::{Failure, What, largest};
use crate::interpolate::quintic;
use crate::mobility::Mobility;

/// How a mechanism is driven.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// What is driven.
    pub driven: Driven,
    /// From where, in SI units.
    pub from: f64,
    /// To where.
    pub to: f64,
    /// How fast; its sign is that of `to - from`, whatever is given.
    pub speed: f64,
    /// Positions are recorded at the ends of so many equal intervals.
    pub steps: usize,
    /// What is held where: a drive for each further degree of freedom.
    pub held: Vec<(Driven, f64)>,
}

impl Sweep {
    /// The speed in the direction of the sweep.
    pub fn rate(&self) -> f64 {
        self.speed.abs() * (self.to - self.from).signum()
    }

    /// When the k-th position is reached.
    fn parameter(&self, k: usize) -> f64 {
        ((self.to - self.from) / self.speed).abs() * (k as f64 / self.steps as f64)
    }
}

/// A position in which the drive cannot go further, or another branch of the motion crosses.
#[derive(Clone, Debug, PartialEq)]
pub struct SpecialPosition {
    /// The value of what is driven, in SI units.
    pub value: f64,
    /// The coordinates there.
    pub positions: Vec<f64>,
}

/// What the sweep met.
pub(super) struct Swept<'m> {
    pub(super) system: System<'m>,
    pub(super) mobility: Mobility,
    pub(super) motion: Vec<AnyPrescribed>,
    pub(super) branches: Vec<SpecialPosition>,
    pub(super) limit: Option<SpecialPosition>,
    pub(super) failure: Option<Failure>,
}

impl Swept<'_> {
    /// The motion between two of its positions, next to them.
    pub(super) fn between(&self, at: usize, p: f64) -> Result<AnyPrescribed, Failure> {
        let path = Path::new(&self.system, 1.0);
        let (Some(a), Some(b)) = (self.motion.get(at), self.motion.get(at + 1)) else {
            let there = &self.motion[at.min(self.motion.len() - 1)];
            return prescribed(&self.system, &there.positions, there.time, &[]);
        };
        let h = b.time - a.time;
        let ends = |j: usize| {
            [[a, b].map(|m| m.positions[j]), [a, b].map(|m| m.speeds[j]), [a, b].map(|m| m.accelerations[j])]
        };
        let position = |j: usize| {
            let [values, rates, seconds] = ends(j);
            quintic(values, rates, seconds, h, (p - a.time) / h)
        };
        let guess: Vec<f64> = (0..a.positions.len()).map(position).collect();
        let q = path.at_parameter(&guess, p, f64::INFINITY).unwrap_or(guess);
        prescribed(&self.system, &q, p, &[])
    }
}

/// Drives a mechanism from its assembled position to where the sweep begins, and through its range, on one branch.
///
/// # Errors
/// [`What::NotHolonomic`], and if where the sweep begins cannot be reached.
pub(super) fn sweep<'m>(
    mechanism: &'m dyn AnyMechanism,
    assembled: Vec<f64>,
    sweep: &Sweep,
) -> Result<Swept<'m>, Failure> {
    let (system, mobility, q) = approach(mechanism, assembled, sweep)?;
    let held = sweep.held.iter().map(|(driven, value)| Law { driven: *driven, start: *value, rate: 0.0 });
    let laws = [Law { driven: sweep.driven, start: sweep.from, rate: sweep.rate() }].into_iter().chain(held).collect();
    let system = system.running(laws);
    let along = system.clone();
    let path = Path::new(&along, sweep.parameter(sweep.steps));
    let from = path.start(&q)?;
    let q = path.at_parameter(&q, 0.0, f64::INFINITY).unwrap_or(q);
    let motion = vec![checked(&system, &q, 0.0)?];
    let mut swept = Swept { system, mobility, motion, branches: Vec::new(), limit: None, failure: None };
    swept.failure = advance(&mut swept, &path, from, sweep).err();
    Ok(swept)
}

/// Brings what is driven and held from where it was assembled to where the sweep begins, while time stands still.
fn approach<'m>(
    mechanism: &'m dyn AnyMechanism,
    q: Vec<f64>,
    sweep: &Sweep,
) -> Result<(System<'m>, Mobility, Vec<f64>), Failure> {
    let targets = [(sweep.driven, sweep.from)].into_iter().chain(sweep.held.iter().copied());
    let law = |(driven, target): (Driven, f64)| {
        let start = driven.value_of(mechanism, 0.0, &q);
        Law { driven, start, rate: target - start }
    };
    let (system, mobility) = System::new(mechanism, targets.map(law).collect(), &q)?;
    if system.laws.iter().all(|law| law.rate == 0.0) {
        return Ok((system, mobility, q));
    }
    let path = Path::new(&system, 1.0);
    let (mut from, mut length) = (path.start(&q)?, path.first_length());
    loop {
        let (to, taken) = path.next(&from, &mut length)?;
        let span = Span::new(&from, &to, taken);
        let special = path.special(&span);
        if let Some((Special::Limit, q, p)) = &special
            && *p < 1.0
        {
            return Err(limit(&system, q, *p).1);
        }
        if path.place(&to).1 >= 1.0 || matches!(special, Some((Special::Limit, ..))) {
            let q = path.at(&span, 1.0).ok_or_else(|| system.singular(&path.place(&to).0, 1.0))?;
            return Ok((system, mobility, q));
        }
        from = to;
    }
}

/// The recorded positions after the first, one after the other, until the end or what ends the sweep.
fn advance(swept: &mut Swept, path: &Path, mut from: Point, sweep: &Sweep) -> Result<(), Failure> {
    let system = swept.system.clone();
    let (mut next, mut length) = (1, path.first_length());
    while next <= sweep.steps {
        let (to, taken) = path.next(&from, &mut length)?;
        let span = Span::new(&from, &to, taken);
        let special = path.special(&span);
        let reached = match &special {
            Some((Special::Limit, _, p)) => *p,
            _ => path.place(&to).1,
        };
        while next <= sweep.steps && sweep.parameter(next) <= reached {
            match sample(&system, path, &span, sweep.parameter(next))? {
                Some(motion) => swept.motion.push(motion),
                // Where branches cross the drive leaves the speeds open; a limit position is reported below.
                None if matches!(special, Some((Special::Limit, ..))) => break,
                None => {}
            }
            next += 1;
        }
        match special {
            Some((Special::Limit, q, p)) if next <= sweep.steps => {
                let (position, failure) = limit(&system, &q, p);
                swept.limit = Some(position);
                return Err(failure);
            }
            Some((Special::Branch, positions, p)) if p <= sweep.parameter(sweep.steps) => {
                swept.branches.push(SpecialPosition { value: system.laws[0].at(p), positions });
            }
            _ => {}
        }
        from = to;
    }
    Ok(())
}

/// The motion in a span at a given p; `None` where the drive does not determine it.
fn sample(system: &System, path: &Path, span: &Span, p: f64) -> Result<Option<AnyPrescribed>, Failure> {
    let Some(q) = path.at(span, p) else { return Ok(None) };
    match checked(system, &q, p) {
        Err(Failure { what: What::DriveSingular { .. }, .. }) => Ok(None),
        found => found.map(Some),
    }
}

/// The motion at a position, where all constraints hold.
fn checked(system: &System, q: &[f64], p: f64) -> Result<AnyPrescribed, Failure> {
    let (mechanism, time) = (system.mechanism, system.time(p));
    // Those that depend on others too.
    if !mechanism.is_met(time, q) {
        let (row, residual) = largest(mechanism.constraints(time, q).iter()).unwrap_or((0, f64::NAN));
        let constraint = mechanism.constraint_name(row);
        return Err(mechanism.failure(What::NotProjected { constraint, residual, iterations: 1 }, time, q));
    }
    prescribed(system, q, p, &[])
}

/// A limit position, and the failure to pass it.
fn limit(system: &System, positions: &[f64], p: f64) -> (SpecialPosition, Failure) {
    let (mechanism, value) = (system.mechanism, system.laws[0].at(p));
    let driven = system.laws[0].driven.quantity(mechanism.description());
    let shown = format!("{:.9} {}", value / driven.factor, driven.unit);
    let what = What::LimitPosition { driven: driven.name, value: shown };
    let failure = mechanism.failure(what, system.time(p), positions);
    (SpecialPosition { value, positions: positions.to_vec() }, failure)
}
