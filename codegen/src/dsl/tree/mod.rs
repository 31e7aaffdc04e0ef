//! The parsed declaration: what the user wrote, and where.

mod declared_table;
mod equation;
mod event;
mod head;
mod joint;
mod load;
mod output;
mod run_setting;
mod shape;

pub use declared_table::{Between, DeclaredTable, Ends, Outside};
pub use equation::{Activity, Equation};
pub use event::{Action, Direction, Event};
pub use head::Head;
pub use joint::{Guide, Joint, JointKind, Rolling, Side, SpatialJoint, SpatialKind};
pub use load::{Element, Extent, Law, Load};
pub use output::{Output, OutputGroup};
pub use run_setting::{RunSetting, RunValue};
pub use shape::{Mark, Shape};

use super::{Expression, Region, Unit};
use crate::kernel_id::KernelId;
use syn::Ident;

/// A whole `mechanism! { .. }`.
pub struct Declaration {
    /// Documentation, visibility and name.
    pub head: Head,
    /// `coordinates { .. }`
    pub coordinates: Vec<Coordinate>,
    /// `parameters { .. }`
    pub parameters: Vec<Parameter>,
    /// `tables { .. }`: functions given by rows.
    pub tables: Vec<DeclaredTable>,
    /// `inputs { .. }`: each with its declared course.
    pub inputs: Vec<Parameter>,
    /// `speeds { .. }`: generalised speeds; the definition of each is among the `let`s.
    pub speeds: Vec<GeneralizedSpeed>,
    /// `let name = expression;`, in order.
    pub lets: Vec<Let>,
    /// `bodies { .. }`
    pub bodies: Vec<Body>,
    /// `frames { .. }`; the place and the attitude of each are among the `let`s.
    pub frames: Vec<Frame>,
    /// `loads { .. }`
    pub loads: Vec<Load>,
    /// `constraints { .. }`: each holds throughout the motion, or while events leave it active.
    pub constraints: Vec<Equation>,
    /// `initial { .. }`
    pub initial: Vec<Initial>,
    /// `events { .. }`: each marks the times at which its condition becomes true.
    pub events: Vec<Event>,
    /// `outputs { .. }`; outputs that stand alone form a group of their own.
    pub outputs: Vec<OutputGroup>,
    /// `drawing { .. }`
    pub drawing: Vec<Shape>,
    /// `kernels { .. }`: which of the optional kernels are generated; `None` leaves that to the program.
    pub kernels: Option<Vec<KernelId>>,
    /// `auxiliary { .. }`: zero displacements, to find their conjugate forces.
    pub auxiliary: Vec<Auxiliary>,
    /// `run { .. }`: how it is run where nothing else is said.
    pub run: Vec<RunSetting>,
    /// `joints { .. }`; none once they are written out as coordinates or constraints.
    pub joints: Vec<Joint>,
}

impl Declaration {
    /// Whether the user declares anything with a unit. A declaration without any is not checked for them.
    pub fn has_units(&self) -> bool {
        let outputs = self.outputs.iter().flat_map(|group| &group.outputs);
        self.coordinates.iter().any(|c| c.unit.is_some() && !c.is_added)
            || self.inputs.iter().any(|input| input.unit.is_some())
            || self.tables.iter().any(|table| table.unit.is_some() || table.over.is_some())
            || self.auxiliary.iter().any(|a| a.unit.is_some())
            || self.parameters.iter().any(|p| p.unit.is_some())
            || self.speeds.iter().any(|speed| speed.unit.is_some())
            || outputs.into_iter().any(|output| output.unit.is_some())
    }
}

/// `alpha [rad];`
pub struct Coordinate {
    /// Documentation, one line each.
    pub docs: String,
    /// Its name.
    pub name: Ident,
    /// Its unit.
    pub unit: Option<Unit>,
    /// Whether it is of a joint or a free body, and the unit is not the user's.
    pub is_added: bool,
}

/// `bx [m];` in `auxiliary`.
pub struct Auxiliary {
    /// Its name.
    pub name: Ident,
    /// Its unit.
    pub unit: Option<Unit>,
}

/// `v [m/s] = dot(x)*cos(phi) + dot(y)*sin(phi);` in `speeds`.
pub struct GeneralizedSpeed {
    /// Documentation.
    pub docs: String,
    /// Its name, which a `let` defines.
    pub name: Ident,
    /// Its unit.
    pub unit: Option<Unit>,
}

/// `m3 [kg] = 0.5;`: a parameter, or an input.
pub struct Parameter {
    /// Documentation.
    pub docs: String,
    /// Its name.
    pub name: Ident,
    /// Its unit, in which a plain number is read.
    pub unit: Option<Unit>,
    /// Its default, or the declared course of an input.
    pub value: Expression,
}

/// `let A = O2 + O2A*[cos(alpha), sin(alpha)];`
pub struct Let {
    /// The name it gives.
    pub name: Ident,
    /// The named expression.
    pub value: Expression,
    /// Whether it is the place or the attitude of a frame, and the name is not the user's.
    pub is_of_frame: bool,
}

/// `tool: at P, attitude R;`: points that move with something, without mass.
pub struct Frame {
    /// Its name.
    pub name: Ident,
    /// The name of its place.
    pub place: Expression,
    /// The name of its angle, in the plane.
    pub angle: Option<Expression>,
    /// The name of its attitude, in space.
    pub attitude: Option<Expression>,
}

/// `rocker4: mass m4 at G4, inertia J4, angle beta;`
pub struct Body {
    /// Its name.
    pub name: Ident,
    /// `mass m at P`, the position absent only by mistake.
    pub mass: Option<(Expression, Option<Expression>)>,
    /// `inertia J`
    pub inertia: Option<Expression>,
    /// `angle phi`
    pub angle: Option<Expression>,
    /// `attitude R`, a rotation, in space.
    pub attitude: Option<Expression>,
    /// The word `free`: it has its own position and angle.
    pub free: Option<Region>,
    /// `unchecked`: its inertia is taken as it is, even if no body can have it.
    pub unchecked: bool,
}

/// One line of `initial`.
pub struct Initial {
    /// Its coordinate.
    pub coordinate: Ident,
    /// What is fixed.
    pub kind: InitialKind,
    /// The value.
    pub value: Expression,
}

/// The kind of a line of `initial`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum InitialKind {
    /// `alpha = 0;` the coordinate itself.
    Position,
    /// `dot(alpha) = 75 [rpm];` its speed.
    Speed,
    /// `guess gamma = 2.6;` where assembly starts to look.
    Guess,
}
