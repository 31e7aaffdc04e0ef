//! Loads along scalars: potentials, dissipation functions, springs, dampers.

use super::effort::Effort;
use super::error::{OracleError, Result};
use super::interpret::Interpreter;
use super::jet::Jet;
use super::measured::Measured;
use super::value::inner;
use crate::dsl::{Expression, Extent, Law};

/// -V_q: a force of -1 along V.
pub(super) fn potential(energy: &Expression, positions: &mut Interpreter) -> Result<Vec<Effort>> {
    Ok(vec![Effort { force: Measured::given(-1.0), place: positions.scalar(energy)? }])
}

/// -dR/dq' along each coordinate and auxiliary displacement; their rates are the last variables of `speeds`.
pub(super) fn dissipation(
    function: &Expression,
    speeds: &mut Interpreter,
    positions: &Interpreter,
) -> Result<Vec<Effort>> {
    let (function, moving) = (speeds.scalar(function)?, positions.moving());
    let slopes = function.gradient().iter().rev().take(moving.len()).rev();
    Ok(slopes.zip(moving).map(|(slope, place)| Effort { force: -*slope, place }).collect())
}

/// An element's force, on both of its ends.
pub(super) fn element(
    law: &Law,
    extent: &Extent,
    positions: &mut Interpreter,
    motion: &mut Interpreter,
) -> Result<Vec<Effort>> {
    match extent {
        Extent::Distance(from, to) => {
            let way = way(from, to, motion)?;
            let places = self::way(from, to, positions)?;
            if let Some(stiffness) = of_no_length(law, motion)? {
                let pulls = way.into_iter().map(|component| (-&(&stiffness * &component)).value());
                return Ok(pulls.zip(places).map(|(force, place)| Effort { force, place }).collect());
            }
            let length = inner(&way, &way)?.call("sqrt").ok_or_else(|| OracleError::new("no length"))?;
            let force = force(law, &length, motion)?;
            // The force on B as a vector: its size along the unit vector from A to B.
            let vector: Vec<Measured> = way.iter().map(|component| (&(&force * component) / &length).value()).collect();
            Ok(vector.into_iter().zip(places).map(|(force, place)| Effort { force, place }).collect())
        }
        Extent::Difference(from, to) => {
            let along = &motion.scalar(to)? - &motion.scalar(from)?;
            let place = &positions.scalar(to)? - &positions.scalar(from)?;
            Ok(vec![Effort { force: force(law, &along, motion)?.value(), place }])
        }
        Extent::Quantity(x) => {
            let along = motion.scalar(x)?;
            Ok(vec![Effort { force: force(law, &along, motion)?.value(), place: positions.scalar(x)? }])
        }
    }
}

/// The stiffness of a linear spring that has no length at rest: its force has a direction wherever its ends are.
fn of_no_length(law: &Law, motion: &mut Interpreter) -> Result<Option<Jet>> {
    let Law::Spring(law, rest) = law else { return Ok(None) };
    let is_linear = !law.mentions("stretch") && !law.mentions("rate");
    let has_no_length = is_linear && motion.scalar(rest)?.value() == Measured::ZERO;
    has_no_length.then(|| motion.scalar(law)).transpose()
}

/// B - A.
fn way(from: &Expression, to: &Expression, interpreter: &mut Interpreter) -> Result<Vec<Jet>> {
    let (a, b) = (interpreter.vector(from)?, interpreter.vector(to)?);
    Ok(a.iter().zip(&b).map(|(a, b)| b - a).collect())
}

/// The force that lets `along` grow.
fn force(law: &Law, along: &Jet, motion: &mut Interpreter) -> Result<Jet> {
    let rate = along.dot().ok_or_else(|| OracleError::new("a rate that is not known here"))?;
    match law {
        Law::Force(force) => motion.scalar(force),
        Law::Spring(law, rest) => {
            let stretch = along - &motion.scalar(rest)?;
            if law.mentions("stretch") || law.mentions("rate") {
                return Ok(-&motion.scalar_with(law, vec![("stretch", stretch), ("rate", rate)])?);
            }
            Ok(-&(&motion.scalar(law)? * &stretch))
        }
        Law::Damper(law) if law.mentions("rate") => Ok(-&motion.scalar_with(law, vec![("rate", rate)])?),
        Law::Friction(size, smooth) => {
            let part = (&rate / &motion.scalar(smooth)?).call("tanh").ok_or_else(|| OracleError::new("no tanh"))?;
            Ok(-&(&motion.scalar(size)? * &part))
        }
        Law::Damper(coefficient) => Ok(-&(&motion.scalar(coefficient)? * &rate)),
    }
}
