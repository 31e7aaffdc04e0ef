//! The `frames` block: each frame is checked where it is declared, used or not. Points on it are written out before.

use super::bodies::ResolvedBodies;
use super::interpreter::Interpreter;
use super::level;
use super::scope::Names;
use super::value::Shape;
use super::{Dimension, Level};
use crate::dsl::{Declaration, Frame};

/// Refuses what cannot be the place or the attitude of a frame, and names that two frames, or a frame and a body, share.
pub(super) fn check_frames(declaration: &Declaration, bodies: &ResolvedBodies, interpreter: &mut Interpreter) {
    let mut names = Names::new("frame");
    for frame in &declaration.frames {
        let is_free = bodies.names.check_free(&frame.name);
        match is_free {
            Ok(()) => names.define(&frame.name, Some(()), &mut interpreter.mistakes),
            Err(mistake) => interpreter.mistakes.add(mistake),
        }
        check(frame, interpreter);
    }
}

fn check(frame: &Frame, interpreter: &mut Interpreter) -> Option<()> {
    const PLACE: &str = "the place of a frame";
    const ANGLE: &str = "the angle of a frame";
    if let Some(attitude) = &frame.attitude {
        interpreter.attitude_of(attitude)?;
    }
    if let Some(angle) = &frame.angle {
        let value = level::angle(angle, ANGLE, interpreter)?;
        interpreter.smooth(angle.region, &[value], Level::Positions, ANGLE)?;
    }
    let value = interpreter.vector_value(&frame.place)?;
    interpreter.expect_world(frame.place.region, &value.bases)?;
    let at = match &value.shape {
        // Multiplied out, as nothing needs it, it would be long at the end of a chain.
        Shape::Spatial(vector) => vector.written(),
        _ => interpreter.components(&value),
    };
    level::position_level(&frame.place, &at, PLACE, interpreter)?;
    interpreter.expect_in_place(value.measured(&frame.place), &Dimension::length(), PLACE);
    interpreter.smooth(frame.place.region, &at, Level::Positions, PLACE)
}
