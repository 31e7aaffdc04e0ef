//! Bodies as frames: their positions and attitudes.

use super::made::{attitude, call, called, vector, zero};
use crate::dsl::{Expression, Region};
use crate::nearest;
use syn::{Ident, Result};

/// The positions and attitudes of declared frames and of bodies.
pub(super) struct Frames {
    pub(super) bodies: Vec<Frame>,
    /// The names of tables.
    pub(super) tables: Vec<String>,
}

pub(super) struct Frame {
    pub(super) name: Ident,
    pub(super) position: Option<Expression>,
    pub(super) angle: Option<Expression>,
    pub(super) attitude: Option<Expression>,
    /// Whether these are the names of what the frame's line defines.
    pub(super) is_named: bool,
}

impl Frame {
    /// One of its parts, as it stands where the frame's own name is used.
    fn used(&self, part: &Option<Expression>, name: &Ident) -> Option<Expression> {
        let part = part.clone()?;
        Some(if self.is_named { Expression { region: Region::from(name), ..part } } else { part })
    }
}

impl Frames {
    pub(super) fn find(&self, name: &Ident) -> Result<&Frame> {
        let unknown = || unknown_body(name, &self.bodies.iter().map(|body| &body.name).collect::<Vec<_>>());
        self.bodies.iter().find(|body| body.name == *name).ok_or_else(unknown)
    }

    /// A table at the angle of a body.
    pub(super) fn lift(&self, table: &Ident, wheel: &Ident) -> Result<Expression> {
        let text = table.to_string();
        if !self.tables.contains(&text) {
            let near = nearest::suggestion(&text, self.tables.iter().map(String::as_str));
            let message = format!("no table is called `{text}`{near}: `tables {{ {text} [mm] over [deg] = .. }}`");
            return Err(Region::from(table).error(message));
        }
        Ok(called(table, self.angle(wheel)?))
    }

    pub(super) fn position(&self, body: &Ident) -> Result<Expression> {
        let missing = || {
            Region::from(body)
                .error(format!("body `{body}` has no position; write `mass m at P` in its line, or make it `free`"))
        };
        let frame = self.find(body)?;
        frame.used(&frame.position, body).ok_or_else(missing)
    }

    pub(super) fn angle(&self, body: &Ident) -> Result<Expression> {
        let missing = || {
            Region::from(body)
                .error(format!("body `{body}` has no angle; write `angle phi` in its line, or make it `free`"))
        };
        let frame = self.find(body)?;
        frame.used(&frame.angle, body).ok_or_else(missing)
    }

    pub(super) fn attitude(&self, body: &Ident) -> Result<Expression> {
        let missing = || {
            let message = format!("body `{body}` has no attitude; write `attitude R` in its line, or make it `free`");
            Region::from(body).error(message)
        };
        let frame = self.find(body)?;
        let rotation = frame.used(&frame.attitude, body).ok_or_else(missing)?;
        Ok(attitude(rotation.region, body, rotation))
    }

    /// Whether a joint holds to the ground. A body may have that name.
    pub(super) fn is_ground(&self, body: &Ident) -> bool {
        body == "ground" && self.bodies.iter().all(|frame| frame.name != "ground")
    }

    /// The angular velocity of a body.
    pub(super) fn spin(&self, at: Region, body: &Ident) -> Result<Expression> {
        match self.is_ground(body) {
            true => Ok(vector(at, vec![zero(at); 3])),
            false => Ok(call(at, "angular_velocity", vec![self.attitude(body)?])),
        }
    }
}

pub(super) fn unknown_body(name: &Ident, bodies: &[&Ident]) -> syn::Error {
    let text = name.to_string();
    let names: Vec<String> = bodies.iter().map(|body| body.to_string()).collect();
    let near = nearest::suggestion(&text, names.iter().map(String::as_str));
    Region::from(name).error(format!("no body above is called `{text}`{near}"))
}
