//! The mechanics of a declaration at one state: body rows, loads and constraints as jets in (q, t).
//!
//! Nothing here uses an angular velocity, except for freed bodies: rotational energy is tr(R' S R'^T)/2 over the nine
//! entries of R, and a torque M is half of M x r on each column r. So the derivation is independent of the one it
//! checks.

use super::constraint::{self, Constraint, constraints};
use super::effort::Effort;
use super::elements::{dissipation, element, potential};
use super::error::{OracleError, Result};
use super::interpret::Interpreter;
use super::jet::Jet;
use super::measured::Measured;
use super::rotation::Rotation;
use super::setting::Setting;
use super::state::State;
use super::value::{cross, inner};
use crate::dsl::{Body, Declaration, Expression, Kind, Load, Unit};
use syn::Ident;

/// One row of x = T(q, t): a coordinate of a mass point, or the angle of a body; in space an entry of its rotation.
pub(super) struct InertialRow {
    /// Its mass or moment of inertia.
    pub(super) inertia: Measured,
    /// Its value.
    pub(super) place: Jet,
    /// The quantity whose acceleration multiplies its inertia: the same, except for products of inertia.
    pub(super) partner: Jet,
}

impl InertialRow {
    fn new(inertia: Measured, place: Jet) -> InertialRow {
        InertialRow { inertia, partner: place.clone(), place }
    }
}

/// All parts of a declaration that enter the equations of motion, at one state.
pub(super) struct Mechanics {
    /// The rows of x = T(q, t) that have inertia.
    pub(super) rows: Vec<InertialRow>,
    /// All loads.
    pub(super) efforts: Vec<Effort>,
    /// All constraints.
    pub(super) constraints: Vec<Constraint>,
    /// (q', 1, 0, ..): how the variables (q, t, s) of a position change in time.
    pub(super) rates: Vec<Measured>,
    /// The number of coordinates.
    pub(super) coordinates: usize,
    /// The number of auxiliary displacements.
    pub(super) auxiliaries: usize,
}

impl Mechanics {
    pub(super) fn new(
        declaration: &Declaration,
        si_factor: &dyn Fn(&Unit) -> f64,
        at: &State,
        active: &[bool],
    ) -> Result<Mechanics> {
        let auxiliaries = declaration.auxiliary.len();
        let interpreter = |setting| Interpreter::new(declaration, si_factor, setting);
        let mut builder = Builder {
            fixed: interpreter(Setting::fixed(at.parameters)),
            positions: interpreter(Setting::positions(at.time, at.parameters, at.coordinates, auxiliaries)),
            motion: interpreter(at.motion()),
            speeds: interpreter(Setting::speeds(at, auxiliaries).with_inputs(at.inputs)),
        };
        let bodies = declaration.bodies.iter().map(|body| builder.body(body)).collect::<Result<Vec<_>>>()?;
        let mut efforts = Vec::new();
        for load in &declaration.loads {
            efforts.extend(builder.load(load, &declaration.bodies, &bodies)?);
        }
        let norms = builder.norms(&declaration.bodies)?;
        Ok(Mechanics {
            rows: bodies.into_iter().flatten().chain(norms).collect(),
            efforts,
            constraints: constraints(declaration, si_factor, at, active)?,
            rates: at.rates(auxiliaries),
            coordinates: at.coordinates.len(),
            auxiliaries,
        })
    }

    /// All rows of the constraints: a vector has two, x and y.
    pub(super) fn constraint_rows(&self) -> Vec<constraint::ConstraintRow> {
        self.constraints.iter().flat_map(|constraint| constraint.rows.clone()).collect()
    }
}

struct Builder<'d> {
    fixed: Interpreter<'d>,
    positions: Interpreter<'d>,
    motion: Interpreter<'d>,
    speeds: Interpreter<'d>,
}

impl Builder<'_> {
    /// x and y with the mass, the angle with the moment of inertia, whichever the body has.
    fn body(&mut self, body: &Body) -> Result<Vec<InertialRow>> {
        let mut rows = Vec::new();
        if let Some((mass, position)) = &body.mass {
            let inertia = self.fixed.scalar(mass)?.value();
            let place = self.positions.vector(needed(position.as_ref(), &body.name, "at")?)?;
            rows.extend(place.into_iter().map(|place| InertialRow::new(inertia, place)));
        }
        if let Some(attitude) = &body.attitude {
            let rotation = self.positions.rotation(attitude)?;
            rows.extend(self.turning(needed(body.inertia.as_ref(), &body.name, "inertia")?, &rotation)?);
            return Ok(rows);
        }
        if let Some(inertia) = &body.inertia {
            let inertia = self.fixed.scalar(inertia)?.value();
            rows.push(InertialRow::new(
                inertia,
                self.positions.scalar(needed(body.angle.as_ref(), &body.name, "angle")?)?,
            ));
        }
        Ok(rows)
    }

    /// The entries of R, of which each row has the inertia S = tr(J)/2 - J: the rotational energy is tr(R' S R'^T)/2.
    fn turning(&mut self, inertia: &Expression, rotation: &Rotation) -> Result<Vec<InertialRow>> {
        let Kind::Vector(written) = &inertia.kind else { return Err(OracleError::new("an inertia is in brackets")) };
        let given = written.iter().map(|x| Ok(self.fixed.scalar(x)?.value())).collect::<Result<Vec<_>>>()?;
        let entry = |k: usize| given.get(k).copied().unwrap_or_default();
        let half = Measured::given(0.5);
        let [xx, yy, zz] = [entry(0), entry(1), entry(2)];
        let mass = |i: usize, k: usize| match (i.min(k), i.max(k)) {
            (0, 0) => half * (yy + zz - xx),
            (1, 1) => half * (zz + xx - yy),
            (2, 2) => half * (xx + yy - zz),
            (0, 1) => -entry(3),
            (0, 2) => -entry(4),
            _ => -entry(5),
        };
        let mut rows = Vec::new();
        for row in rotation.entries.chunks(3) {
            for (i, place) in row.iter().enumerate() {
                let partners = row.iter().enumerate().filter(|(k, _)| *k == i || given.len() > 3);
                rows.extend(partners.map(|(k, partner)| InertialRow {
                    inertia: mass(i, k),
                    place: place.clone(),
                    partner: partner.clone(),
                }));
            }
        }
        Ok(rows)
    }

    /// A quaternion of coordinates has, along its norm, the mean moment of the first body that it turns.
    fn norms(&mut self, bodies: &[Body]) -> Result<Vec<InertialRow>> {
        let (mut rows, mut known): (Vec<InertialRow>, Vec<Vec<f64>>) = (Vec::new(), Vec::new());
        for body in bodies {
            let (Some(attitude), Some(inertia)) = (&body.attitude, &body.inertia) else { continue };
            for quaternion in self.positions.rotation(attitude)?.quaternions {
                // Equal values at this state with other gradients are other coordinates.
                let mark: Vec<f64> = quaternion.iter().flat_map(|x| x.gradient()).map(|slope| slope.value).collect();
                let Kind::Vector(written) = &inertia.kind else { continue };
                if known.contains(&mark) {
                    continue;
                }
                known.push(mark);
                let moments = written.iter().take(3).map(|x| Ok(self.fixed.scalar(x)?.value()));
                let sum: Measured = moments.collect::<Result<Vec<_>>>()?.into_iter().sum();
                rows.push(InertialRow::new(sum * Measured::given(1.0 / 3.0), inner(&quaternion, &quaternion)?));
            }
        }
        Ok(rows)
    }

    /// M on a body with rotation R: half of M x r on each column r, since the body turns by half the sum of r x dr.
    fn spatial_torque(&mut self, moment: &Expression, attitude: &Expression) -> Result<Vec<Effort>> {
        let moment = self.motion.vector(moment)?;
        let (now, places) = (self.motion.rotation(attitude)?, self.positions.rotation(attitude)?);
        let mut efforts = Vec::new();
        for column in 0..3 {
            let of = |entries: &[Jet]| -> Vec<Jet> { (0..3).map(|row| entries[3 * row + column].clone()).collect() };
            let force = cross(&moment, &of(&now.entries))?;
            let halves = force.iter().map(|x| x.value() * Measured::given(0.5));
            efforts.extend(halves.zip(of(&places.entries)).map(|(force, place)| Effort { force, place }));
        }
        Ok(efforts)
    }

    fn load(&mut self, load: &Load, bodies: &[Body], rows: &[Vec<InertialRow>]) -> Result<Vec<Effort>> {
        match load {
            Load::Force { force, point } => {
                let (force, place) = (self.motion.vector(force)?, self.positions.vector(point)?);
                Ok(force.iter().zip(place).map(|(force, place)| Effort { force: force.value(), place }).collect())
            }
            Load::Torque { moment, body } => {
                let turned = bodies.iter().find(|b| b.name == *body).and_then(|b| b.attitude.as_ref());
                if let Some(attitude) = turned {
                    return self.spatial_torque(moment, attitude);
                }
                let force = self.motion.scalar(moment)?.value();
                let place = match bodies.iter().find(|b| b.name == *body) {
                    Some(body) => self.positions.scalar(needed(body.angle.as_ref(), &body.name, "angle")?)?,
                    None => self.positions.named(body)?.scalar()?,
                };
                Ok(vec![Effort { force, place }])
            }
            Load::Potential(energy) => potential(energy, &mut self.positions),
            Load::Dissipation(function) => dissipation(function, &mut self.speeds, &self.positions),
            Load::Element(load) => element(&load.law, &load.extent, &mut self.positions, &mut self.motion),
            Load::Gravity { acceleration, .. } => {
                let acceleration: Vec<Measured> = self.motion.vector(acceleration)?.iter().map(Jet::value).collect();
                let massive = bodies.iter().zip(rows).filter(|(body, _)| body.mass.is_some());
                Ok(massive.flat_map(|(_, rows)| weight(rows, &acceleration)).collect())
            }
        }
    }
}

/// m g, of a body whose first rows are those of its mass.
fn weight(rows: &[InertialRow], acceleration: &[Measured]) -> Vec<Effort> {
    let components = rows.iter().zip(acceleration);
    components.map(|(row, g)| Effort { force: row.inertia * *g, place: row.place.clone() }).collect()
}

fn needed<'e>(expression: Option<&'e Expression>, body: &Ident, word: &str) -> Result<&'e Expression> {
    expression.ok_or_else(|| OracleError::new(format!("body `{body}` has no `{word}`")))
}
