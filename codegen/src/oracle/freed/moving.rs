//! A single body: its motion, and the force and moment not yet accounted for.

use super::vector::{
    Matrix, Vector, ZERO, add, cross, filled, inner, magnitude, of_skew_part, rank, scaled, size, subtract, times,
    times_transposed,
};
use super::{Balance, inertia_entries, known};
use crate::dsl::Body;
use crate::oracle::error::Result;
use crate::oracle::interpret::Interpreter;
use crate::oracle::jet::Jet;
use crate::oracle::measured::Measured;

/// A point moves with a body if its velocities differ from the body's only by rounding.
const RIGID: f64 = 1e-11;

/// A motion without its magnitudes. Along a chain of rotations these are many times the errors visible in the forces;
/// only the magnitudes of loads count, since their terms may cancel.
pub(super) fn as_it_is(x: Measured) -> Measured {
    Measured::given(x.value)
}

/// A point, with its velocity along each coordinate.
pub(super) struct Point {
    at: Vector,
    pub(super) velocities: Vec<Vector>,
}

impl Point {
    pub(super) fn new(place: &[Jet], coordinates: usize) -> Point {
        let along = |j: usize| filled(place.iter().map(|x| as_it_is(x.gradient()[j])));
        Point {
            at: filled(place.iter().map(|x| as_it_is(x.value()))),
            velocities: (0..coordinates).map(along).collect(),
        }
    }
}

/// A body, freed.
pub(super) struct Freed {
    pub(super) name: String,
    pub(super) mass: Measured,
    /// Its centre of mass, if it has one.
    centre: Option<Point>,
    /// Its angular velocity along each coordinate, if it has an angle or an attitude.
    turning: Option<Vec<Vector>>,
    /// About its centre of mass, in the world's frame.
    inertia: Matrix,
    is_spatial: bool,
    /// m a less the forces on it.
    force: Vector,
    /// J w' + w x J w less their moments.
    moment: Vector,
}

impl Freed {
    /// `fixed` knows parameters, `positions` derivatives with respect to coordinates, and `moving` those by time.
    pub(super) fn new(
        body: &Body,
        coordinates: usize,
        fixed: &mut Interpreter,
        positions: &mut Interpreter,
        moving: &mut Interpreter,
    ) -> Result<Freed> {
        let mut freed = Freed {
            name: body.name.to_string(),
            mass: Measured::ZERO,
            centre: None,
            turning: None,
            inertia: [ZERO; 3],
            is_spatial: body.attitude.is_some(),
            force: ZERO,
            moment: ZERO,
        };
        if let Some((mass, Some(place))) = &body.mass {
            freed.mass = fixed.scalar(mass)?.value();
            freed.centre = Some(Point::new(&positions.vector(place)?, coordinates));
            let accelerations = moving.vector(place)?.iter().map(second).collect::<Result<Vec<_>>>()?;
            freed.is_spatial |= accelerations.len() == 3;
            freed.force = scaled(filled(accelerations.into_iter()), freed.mass);
        }
        let inertia = inertia_entries(body, fixed)?;
        if let Some(attitude) = &body.attitude {
            let entries = positions.rotation(attitude)?.entries;
            let now = matrix(&entries, |entry| Ok(entry.value()))?;
            let swept =
                |j: usize| Ok(of_skew_part(&times_transposed(&matrix(&entries, |x| Ok(x.gradient()[j]))?, &now)));
            freed.turning = Some((0..coordinates).map(swept).collect::<Result<_>>()?);
            freed.inertia = times_transposed(&times_transposed(&now, &tensor(&inertia)), &now);
            freed.moment = freed.moment_needed(&moving.rotation(attitude)?.entries)?;
        } else if let Some(angle) = &body.angle {
            let inertia = inertia.first().copied().unwrap_or_default();
            let turning = positions.scalar(angle)?;
            freed.turning = Some((0..coordinates).map(|j| about_z(as_it_is(turning.gradient()[j]))).collect());
            freed.inertia[2][2] = inertia;
            freed.moment = about_z(inertia * second(&moving.scalar(angle)?)?);
        }
        Ok(freed)
    }

    /// J w' + w x J w of a rotation as it changes in time: w is that of the skew part of R' R^T, and w' of R'' R^T.
    fn moment_needed(&self, entries: &[Jet]) -> Result<Vector> {
        let now = matrix(entries, |entry| Ok(entry.value()))?;
        let rates = matrix(entries, |entry| Ok(known(entry.dot(), "a rate")?.value()))?;
        let seconds = matrix(entries, second)?;
        let w = of_skew_part(&times_transposed(&rates, &now));
        let dw = of_skew_part(&times_transposed(&seconds, &now));
        Ok(add(times(&self.inertia, dw), cross(w, times(&self.inertia, w))))
    }

    /// Whether a point moves as a rigid part of the body, along every coordinate. A fixed point belongs to no body.
    pub(super) fn carries(&self, point: &Point) -> bool {
        let Some(centre) = &self.centre else { return false };
        let arm = subtract(point.at, centre.at);
        let turning = self.turning.as_deref().unwrap_or(&[]);
        let rigid = |j: usize| {
            let turned = turning.get(j).map_or(ZERO, |w| cross(*w, arm));
            let apart = subtract(point.velocities[j], add(centre.velocities[j], turned));
            size(apart) <= RIGID * magnitude(apart)
        };
        let moves = point.velocities.iter().any(|velocity| size(*velocity) > 0.0);
        moves && (0..point.velocities.len()).all(rigid)
    }

    /// Subtracts a force at a point, or at the centre of mass, from the remainder.
    pub(super) fn take_force(&mut self, force: Vector, point: Option<&Point>) {
        self.force = subtract(self.force, force);
        if let (Some(point), Some(centre), Some(_)) = (point, &self.centre, &self.turning) {
            let moment = cross(subtract(point.at, centre.at), force);
            self.take_moment(moment);
        }
    }

    pub(super) fn take_moment(&mut self, moment: Vector) {
        self.moment = subtract(self.moment, moment);
    }

    fn velocity(&self, j: usize) -> Vector {
        self.centre.as_ref().map_or(ZERO, |centre| centre.velocities[j])
    }

    fn angular_velocity(&self, j: usize) -> Vector {
        self.turning.as_ref().map_or(ZERO, |turning| turning[j])
    }

    /// The power of the remainder along a coordinate.
    pub(super) fn power_needed(&self, j: usize) -> Measured {
        inner(self.force, self.velocity(j)) + inner(self.moment, self.angular_velocity(j))
    }

    /// m v.v + w.Jw along a coordinate.
    pub(super) fn inertia_along(&self, j: usize) -> f64 {
        let (v, w) = (self.velocity(j), self.angular_velocity(j));
        (self.mass * inner(v, v) + inner(w, times(&self.inertia, w))).value
    }

    pub(super) fn moves_along(&self, j: usize) -> bool {
        magnitude(self.velocity(j)) > 0.0 || magnitude(self.angular_velocity(j)) > 0.0
    }

    /// The components of forces and moments along which the body can move.
    fn ways(&self) -> (usize, &'static [usize]) {
        let forces = match (&self.centre, self.is_spatial) {
            (None, _) => 0,
            (_, true) => 3,
            (_, false) => 2,
        };
        match (&self.turning, self.is_spatial) {
            (None, _) => (forces, &[]),
            (_, true) => (forces, &[0, 1, 2]),
            (_, false) => (forces, &[2]),
        }
    }

    /// Whether these coordinates move it in every way.
    pub(super) fn is_free_along(&self, coordinates: &[usize]) -> bool {
        let (forces, moments) = self.ways();
        let twist = |j: &usize| -> Vec<f64> {
            let (v, w) = (self.velocity(*j), self.angular_velocity(*j));
            v[..forces].iter().map(|x| x.value).chain(moments.iter().map(|i| w[*i].value)).collect()
        };
        forces > 0 && rank(coordinates.iter().map(twist).collect()) == forces + moments.len()
    }

    /// Each component of the remainder, which must vanish.
    pub(super) fn own_balances(&self) -> Vec<Balance> {
        let (forces, moments) = self.ways();
        let mean = (0..3).map(|i| self.inertia[i][i].value).sum::<f64>() / if self.is_spatial { 3.0 } else { 1.0 };
        let balance = |missing: &Measured, inertia: f64| Balance {
            name: self.name.clone(),
            missing: missing.value,
            size: missing.magnitude,
            inertia,
        };
        let forces = self.force[..forces].iter().map(|missing| balance(missing, self.mass.value));
        forces.chain(moments.iter().map(|i| balance(&self.moment[*i], mean))).collect()
    }
}

/// The second derivative by time.
fn second(x: &Jet) -> Result<Measured> {
    let rate = known(x.dot(), "a rate")?;
    Ok(as_it_is(known(rate.dot(), "an acceleration")?.value()))
}

fn about_z(x: Measured) -> Vector {
    [Measured::ZERO, Measured::ZERO, x]
}

fn matrix(entries: &[Jet], of: impl Fn(&Jet) -> Result<Measured>) -> Result<Matrix> {
    let mut rows = [ZERO; 3];
    for (at, entry) in entries.iter().enumerate() {
        rows[at / 3][at % 3] = as_it_is(of(entry)?);
    }
    Ok(rows)
}

/// The symmetric matrix of xx, yy, zz, xy, xz, yz, as far as they are given.
fn tensor(entries: &[Measured]) -> Matrix {
    let entry = |k: usize| entries.get(k).copied().unwrap_or_default();
    let [xx, yy, zz, xy, xz, yz] = [0, 1, 2, 3, 4, 5].map(entry);
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}
