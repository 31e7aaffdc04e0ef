//! Calls that give rotations.

use super::Interpreter;
use crate::dsl::{Expression, Kind};
use crate::oracle::error::{OracleError, Result, refuse};
use crate::oracle::jet::Jet;
use crate::oracle::rotation::{Rotation, letter};
use crate::oracle::value::Value;

impl Interpreter<'_> {
    pub(super) fn about(&mut self, axis: &Expression, angle: &Expression) -> Result<Value> {
        let rotation = Rotation::about(&self.axis(axis)?, &self.scalar(angle)?);
        rotation.map(Value::Rotation).ok_or_else(|| OracleError::new("no rotation"))
    }

    /// A vector, or the letter of an axis unless that is a name.
    fn axis(&mut self, axis: &Expression) -> Result<Vec<Jet>> {
        match (letter(axis), self.value(axis)) {
            (_, Ok(axis)) => axis.vector(),
            (Some(letter), Err(_)) => self.unit(letter),
            (None, Err(error)) => Err(error),
        }
    }

    /// Axes as columns.
    pub(super) fn axes(&mut self, columns: [&Expression; 3]) -> Result<Value> {
        let [u, v, w] = columns.map(|column| self.axis(column));
        let rows = Rotation { entries: [u?, v?, w?].concat(), quaternions: vec![] };
        Ok(Value::Rotation(rows.transposed()))
    }

    fn unit(&self, letter: usize) -> Result<Vec<Jet>> {
        (0..3).map(|k| self.constant(if k == letter { 1.0 } else { 0.0 }).scalar()).collect()
    }

    pub(super) fn euler(&mut self, sequence: &Expression, angles: &[Expression]) -> Result<Value> {
        let Kind::Name(letters) = &sequence.kind else { return refuse("a sequence of axes is a name") };
        let mut whole: Option<Rotation> = None;
        for (letter, angle) in letters.to_string().chars().zip(angles) {
            let axis = "xyz".find(letter).ok_or_else(|| OracleError::new("an axis is x, y or z"))?;
            let turn = Rotation::about(&self.unit(axis)?, &self.scalar(angle)?);
            let turn = turn.ok_or_else(|| OracleError::new("no rotation"))?;
            whole = Some(whole.map_or(turn.clone(), |before| before.then(&turn)));
        }
        whole.map(Value::Rotation).ok_or_else(|| OracleError::new("a sequence of no axes"))
    }

    pub(super) fn quaternion(&mut self, components: [&Expression; 4]) -> Result<Value> {
        let is_coordinate = |x: &&Expression| match &x.kind {
            Kind::Name(name) => self.declaration.coordinates.iter().any(|c| c.name == *name),
            _ => false,
        };
        let of_coordinates = components.iter().all(is_coordinate);
        let q = components.into_iter().map(|x| self.scalar(x)).collect::<Result<Vec<Jet>>>()?;
        let q = <[Jet; 4]>::try_from(q).map_err(|_| OracleError::new("a quaternion has four components"))?;
        let rotation = Rotation::of_quaternion(q, of_coordinates);
        rotation.map(Value::Rotation).ok_or_else(|| OracleError::new("no rotation"))
    }
}
