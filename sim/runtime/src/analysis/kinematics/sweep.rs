//! A drive through its range: the sweep.

use super::at_rest::check_at_rest;
use super::driven::Driven;
use super::inverse::AnyPrescribed;
use super::path::Path;
use super::piece::{Piece, Point};
use super::search::{Found, Search};
use super::sizes::Sizes;
use super::system::{Law, System};
use crate::model::Differentiable;
use crate::motion::mobility::Mobility;
use crate::state::failure::{Failure, What};
use sim_kernel::{Description, Quantity};
use std::rc::Rc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The driven quantity has arrived when less than this fraction of the way is missing.
const THERE: f64 = 1e-14;

/// The largest rounding of an angle, in radians: with more, a curve that is followed through many turns seems to turn back.
const ANGLE_ROUNDING: f64 = 1e-10;

/// A special position this close to an end of the sweep, as a fraction of the way, is in it.
const AT_END: f64 = 1e-9;

/// The specification of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// The driven quantity.
    pub driven: Driven,
    /// From where, in SI units.
    pub from: f64,
    /// To where.
    pub to: f64,
    /// The speed; its sign is that of `to - from`, whatever is given. With 0 the mechanism rests in each position, while time
    /// stands still at 0: forces and reactions are static.
    pub speed: f64,
    /// Positions are recorded at the ends of so many equal intervals.
    pub steps: usize,
    /// The holds: one for each further degree of freedom.
    pub held: Vec<(Driven, f64)>,
}

impl Sweep {
    /// The speed in the direction of the sweep.
    pub fn rate(&self) -> f64 {
        self.speed.abs() * (self.to - self.from).signum()
    }

    /// Whether the mechanism rests in each position.
    pub fn is_at_rest(&self) -> bool {
        self.speed == 0.0
    }

    /// Checks that rounding leaves the turns of angles apart.
    ///
    /// # Errors
    /// [`What::Unusable`].
    pub(super) fn check_rounding(&self, description: &'static Description) -> Result<(), What> {
        let ends = [self.from, self.to].map(|end| (self.driven, end));
        let is_lost = |(driven, value): &(Driven, f64)| {
            driven.turn(description).is_some() && value.abs() * f64::EPSILON > ANGLE_ROUNDING
        };
        let Some((driven, value)) = ends.into_iter().chain(self.held.iter().copied()).find(is_lost) else {
            return Ok(());
        };
        let Quantity { name, unit, factor, .. } = driven.quantity(description);
        let [value, largest] = [value, ANGLE_ROUNDING / f64::EPSILON].map(|value| value / factor);
        let setting = format!(
            "`{name}` cannot be followed to {value:.3e} {unit}: its turns are lost in rounding. Stay within {largest:.1e} {unit} of 0"
        );
        Err(What::Unusable { setting })
    }

    /// The way in a unit of the sweep's parameter, which is time unless the mechanism rests.
    fn pace(&self) -> f64 {
        let speed = if self.is_at_rest() { 1.0 } else { self.speed };
        speed.abs() * (self.to - self.from).signum()
    }

    /// The sweep's parameter where the k-th position is reached.
    pub(super) fn parameter(&self, k: usize) -> f64 {
        ((self.to - self.from) / self.pace()).abs() * (k as f64 / self.steps as f64)
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

/// The special positions of the sweep.
pub(super) struct Swept<'m> {
    pub(super) system: System<'m>,
    pub(super) sizes: Sizes,
    pub(super) mobility: Mobility,
    pub(super) motion: Vec<AnyPrescribed>,
    pub(super) branches: Vec<SpecialPosition>,
    pub(super) limit: Option<SpecialPosition>,
    pub(super) failure: Option<Failure>,
    pub(super) found: Found,
}

/// Drives a mechanism from its assembled position to the beginning of the sweep, and through its range, on one branch.
///
/// # Errors
/// [`What::MovedByTime`] at rest, and if the beginning of the sweep cannot be reached.
pub(super) fn sweep<'m>(
    mechanism: &'m dyn Differentiable,
    assembled: Vec<f64>,
    sweep: &Sweep,
    interrupt: &AtomicBool,
) -> Result<Swept<'m>, Failure> {
    let (system, mobility, q) = approach(mechanism, assembled, sweep)?;
    if sweep.is_at_rest() {
        check_at_rest(mechanism, &q)?;
    }
    let held = sweep.held.iter().map(|(driven, value)| Law { driven: *driven, start: *value, rate: 0.0 });
    let laws = [Law { driven: sweep.driven, start: sweep.from, rate: sweep.pace() }].into_iter().chain(held).collect();
    let system = if sweep.is_at_rest() { system.resting(laws) } else { system.running(laws) };
    let path = Path::new(&system, &q, sweep.parameter(sweep.steps));
    let start = path.start(&q)?;
    let mut followed =
        Followed { path: &path, sweep, interrupt, motion: Vec::new(), branches: Vec::new(), limit: None };
    let mut search = Search::new(&path);
    let failure = followed.follow(path.before(start), &mut search).err();
    if let (true, Some(failure)) = (followed.motion.is_empty(), &failure) {
        return Err(failure.clone());
    }
    let found = search.conclude();
    let Followed { motion, branches, limit, .. } = followed;
    let sizes = path.sizes.clone();
    Ok(Swept { motion, branches, limit, failure, found, mobility, sizes, system: system.clone() })
}

/// Moves driven and held quantities from the assembled position to the beginning of the sweep, while time stands still.
fn approach<'m>(
    mechanism: &'m dyn Differentiable,
    q: Vec<f64>,
    sweep: &Sweep,
) -> Result<(System<'m>, Mobility, Vec<f64>), Failure> {
    let targets = [(sweep.driven, sweep.from)].into_iter().chain(sweep.held.iter().copied());
    let law = |(driven, target): (Driven, f64)| {
        let start = driven.value_of(mechanism, 0.0, &q);
        // Quantities that are there within rounding need not be moved.
        let is_there = (target - start).abs() <= THERE * target.abs().max(start.abs());
        Law { driven, start: if is_there { target } else { start }, rate: if is_there { 0.0 } else { target - start } }
    };
    let (system, mobility) = System::new(mechanism, targets.map(law).collect(), &q)?;
    if system.laws.iter().all(|law| law.rate == 0.0) {
        return Ok((system, mobility, q));
    }
    let path = Path::new(&system, &q, 1.0);
    let (mut from, mut length) = (path.start(&q)?, f64::INFINITY);
    loop {
        let piece = path.next(&from, &mut length)?;
        let x = path.locate(&piece, 1.0);
        if let Some(end) = piece.limit
            && path.at(&piece, end).1 < 1.0
        {
            let (q, p) = path.at(&piece, end);
            return Err(limit(&system, path.stopped(&piece, end), &q, p).1);
        }
        if path.reached(&piece) >= 1.0 || piece.limit.is_some() {
            let q = path.solve(&piece, x, 1.0).ok_or_else(|| system.singular(&path.at(&piece, x).0, 1.0))?;
            return Ok((system, mobility, q));
        }
        from = piece.to;
    }
}

/// A curve as far as it has been followed.
struct Followed<'s> {
    path: &'s Path<'s>,
    sweep: &'s Sweep,
    interrupt: &'s AtomicBool,
    motion: Vec<AnyPrescribed>,
    branches: Vec<SpecialPosition>,
    limit: Option<SpecialPosition>,
}

impl<'s> Followed<'s> {
    /// Follows the curve until its end or the end of the sweep, recording rows and searching extremes on the way.
    fn follow(&mut self, mut from: Point, search: &mut Search<'s>) -> Result<(), Failure> {
        let (path, end, mut length) = (self.path, self.sweep.parameter(self.sweep.steps), f64::INFINITY);
        loop {
            self.check_interrupt(|| path.place(&from.z))?;
            let piece = Rc::new(path.next(&from, &mut length)?);
            // The curve may begin before the sweep does.
            let is_within = path.reached(&piece) > 0.0 || piece.limit.is_some();
            let part = [0.0, end].map(|p| path.locate(&piece, p));
            let looked = if is_within { search.look(&piece, part) } else { Ok(()) };
            // These may be millions, and the record may be interrupted.
            self.record(&piece, part, search)?;
            // A limit position is told of itself.
            let is_limit =
                |failure: &Failure| matches!(failure.what, What::DriveSingular { .. }) && piece.limit.is_some();
            looked.or_else(|failure| if is_limit(&failure) { Ok(()) } else { Err(failure) })?;
            let crossings = piece.crossings.iter().map(|x| path.at(&piece, *x));
            let branch = |(positions, p)| SpecialPosition { value: path.system.laws[0].at(p), positions };
            let within = -AT_END * end..=(1.0 + AT_END) * end;
            self.branches.extend(crossings.filter(|(_, p)| within.contains(p)).map(branch));
            if let Some((q, p)) = piece.limit.map(|x| path.at(&piece, x)) {
                let (position, failure) = limit(path.system, 0, &q, p);
                let is_passed = self.motion.len() > self.sweep.steps;
                self.limit = (!is_passed || within.contains(&p)).then_some(position);
                if !is_passed {
                    return Err(failure);
                }
            }
            if path.reached(&piece) >= end || self.motion.len() > self.sweep.steps {
                return Ok(());
            }
            from = piece.to.clone();
        }
    }

    /// Ends the sweep where it is interrupted.
    fn check_interrupt(&self, place: impl Fn() -> (Vec<f64>, f64)) -> Result<(), Failure> {
        if !self.interrupt.load(Ordering::Relaxed) {
            return Ok(());
        }
        let ((q, p), system) = (place(), self.path.system);
        Err(system.mechanism.failure(What::Interrupted, system.time(p), &q))
    }

    /// The rows in a step.
    fn record(&mut self, piece: &Rc<Piece>, part: [f64; 2], search: &mut Search<'s>) -> Result<(), Failure> {
        let reached = piece.limit.map_or_else(|| self.path.reached(piece), |x| self.path.at(piece, x).1);
        while self.motion.len() <= self.sweep.steps && self.sweep.parameter(self.motion.len()) <= reached {
            let p = self.sweep.parameter(self.motion.len());
            let x = self.path.locate(piece, p);
            self.check_interrupt(|| (self.path.at(piece, x).0, p))?;
            match self.path.motion(piece, x, p) {
                Ok(motion) => {
                    search.witness(piece, part, x, &motion);
                    self.motion.push(motion);
                }
                // In a limit position itself, which is reported.
                Err(Failure { what: What::DriveSingular { .. }, .. }) if piece.limit.is_some() => break,
                Err(failure) => return Err(failure),
            }
        }
        Ok(())
    }
}

/// A limit position of what a law moves, and the failure to pass it.
fn limit(system: &System, law: usize, positions: &[f64], p: f64) -> (SpecialPosition, Failure) {
    let (mechanism, law) = (system.mechanism, system.laws[law]);
    let (driven, value) = (law.driven.quantity(mechanism.description()), law.at(p));
    let shown = format!("{:.9} {}", value / driven.factor, driven.unit);
    let what = What::LimitPosition { driven: driven.name, value: shown };
    let failure = mechanism.failure(what, system.time(p), positions);
    (SpecialPosition { value, positions: positions.to_vec() }, failure)
}
