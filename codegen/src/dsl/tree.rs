//! The parsed declaration: what the user wrote, and where.

use super::{Event, Expression, Region, Unit};
use syn::Ident;

/// A whole `mechanism! { .. }`.
pub struct Declaration {
    /// Documentation, visibility and name.
    pub head: super::Head,
    /// `coordinates { .. }`
    pub coordinates: Vec<Coordinate>,
    /// `parameters { .. }`
    pub parameters: Vec<Parameter>,
    /// `tables { .. }`: functions given by rows.
    pub tables: Vec<Table>,
    /// `inputs { .. }`: each with its declared course.
    pub inputs: Vec<Parameter>,
    /// `speeds { .. }`: generalised speeds; the definition of each is among the `let`s.
    pub speeds: Vec<GeneralizedSpeed>,
    /// `let name = expression;`, in order.
    pub lets: Vec<Let>,
    /// `bodies { .. }`
    pub bodies: Vec<Body>,
    /// `loads { .. }`
    pub loads: Vec<Load>,
    /// `constraints { .. }`: each holds throughout the motion, or while events leave it active.
    pub constraints: Vec<Equation>,
    /// `initial { .. }`
    pub initial: Vec<Initial>,
    /// `events { .. }`: each marks the times at which it comes to hold.
    pub events: Vec<Event>,
    /// `outputs { .. }`; outputs that stand alone form a group of their own.
    pub outputs: Vec<OutputGroup>,
    /// `drawing { .. }`
    pub drawing: Vec<Shape>,
    /// `kernels { .. }`: which of those that not everyone needs are made; `None` leaves that to the program.
    pub kernels: Option<Vec<OptionalKernel>>,
    /// `auxiliary { .. }`: displacements that are zero, whose conjugate forces are wanted.
    pub auxiliary: Vec<Auxiliary>,
    /// `joints { .. }`; none once they are written out as coordinates or constraints.
    pub joints: Vec<super::Joint>,
}

impl Declaration {
    /// Whether anything is declared with a unit. A declaration without any is not checked for them.
    pub fn has_units(&self) -> bool {
        let outputs = self.outputs.iter().flat_map(|group| &group.outputs);
        self.coordinates.iter().any(|c| c.unit.is_some())
            || self.inputs.iter().any(|input| input.unit.is_some())
            || self.tables.iter().any(|table| table.unit.is_some() || table.over.is_some())
            || self.auxiliary.iter().any(|a| a.unit.is_some())
            || self.parameters.iter().any(|p| p.unit.is_some())
            || self.speeds.iter().any(|speed| speed.unit.is_some())
            || outputs.into_iter().any(|output| output.unit.is_some())
    }
}

/// A kernel that not everyone needs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum OptionalKernel {
    /// `dynamics_jacobian;`
    DynamicsJacobian,
    /// `dynamics_sensitivity;`
    DynamicsSensitivity,
    /// `inverse_dynamics;`
    InverseDynamics,
}

/// `alpha [rad];`
pub struct Coordinate {
    /// Documentation, one line each.
    pub docs: String,
    /// Its name.
    pub name: Ident,
    /// Its unit.
    pub unit: Option<Unit>,
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

/// `lift [mm] over [deg] = cubic, periodic { 0, 0; 90, 10; 360, 0; }`
pub struct Table {
    /// Documentation.
    pub docs: String,
    /// Its name.
    pub name: Ident,
    /// The unit of its values.
    pub unit: Option<Unit>,
    /// The unit of its arguments.
    pub over: Option<Unit>,
    /// What is between rows.
    pub between: Between,
    /// What a cubic obeys at the first and the last row, and where that is said.
    pub ends: Option<(Ends, Region)>,
    /// What it is outside of its rows.
    pub outside: Outside,
    /// Arguments and values, row by row.
    pub rows: Vec<[Expression; 2]>,
}

/// What a table is between its rows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Between {
    /// `linear`: straight lines.
    Linear,
    /// `cubic`: cubics with continuous first and second derivatives.
    Cubic,
    /// `monotone`: cubics that rise and fall where the rows do, with continuous first derivatives.
    Monotone,
}

/// What a cubic obeys at its first and last row.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ends {
    /// `natural`: no second derivative.
    Natural,
    /// `clamped`: no first derivative.
    Clamped,
}

/// What a table is outside of its rows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Outside {
    /// `held`: the value of the first or last row.
    Held,
    /// `continued`: the straight line with the value and the slope there.
    Continued,
    /// `periodic`: the rows again and again.
    Periodic,
}

/// `let A = O2 + O2A*[cos(alpha), sin(alpha)];`
pub struct Let {
    /// The name it gives.
    pub name: Ident,
    /// What it names.
    pub value: Expression,
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
    /// The word `free`: it has a place and an angle of its own.
    pub free: Option<Region>,
}

/// One line of `loads`.
pub enum Load {
    /// `force [F, 0] at C;`
    Force {
        /// The force vector.
        force: Expression,
        /// The point it acts at.
        point: Expression,
    },
    /// `torque T on crank2;`
    Torque {
        /// The moment, positive as the body's angle.
        moment: Expression,
        /// The body's name, or that of an angle.
        body: Ident,
    },
    /// `gravity [0, -9.81];`
    Gravity {
        /// The word `gravity`.
        keyword: Region,
        /// The acceleration of free fall.
        acceleration: Expression,
    },
    /// `potential V;`: the generalised force is -dV/dq.
    Potential(Expression),
    /// `dissipation R;`: the generalised force is -dR/dq'.
    Dissipation(Expression),
    /// `spring k, length l0 from A to B;` and its like.
    Element(Box<Element>),
}

/// A force along a scalar.
pub struct Element {
    /// The word it starts with.
    pub keyword: Region,
    /// What it does.
    pub law: Law,
    /// What it works along.
    pub extent: Extent,
}

/// The force or torque of an element along its extent.
pub enum Law {
    /// `force F ..`, positive where it lets the extent grow.
    Force(Expression),
    /// `spring k, length l0 ..` or `spring k, rest l0 ..`: a stiffness, or the force where `stretch` or `rate` stands in it.
    Spring(Expression, Expression),
    /// `friction F, smooth v0 ..`: dry friction, F tanh(x'/v0).
    Friction(Expression, Expression),
    /// `damper c ..`: a coefficient, or the force where `rate` stands in it.
    Damper(Expression),
}

/// What an element works along.
pub enum Extent {
    /// `from A to B`: the distance of two points.
    Distance(Expression, Expression),
    /// `between alpha and beta`: beta - alpha.
    Difference(Expression, Expression),
    /// `on x`: a scalar.
    Quantity(Expression),
}

/// `slot: left = right;`
pub struct Equation {
    /// Its name.
    pub name: Ident,
    /// What stands left.
    pub left: Expression,
    /// What stands right.
    pub right: Expression,
    /// `initially released`, on a constraint that events switch.
    pub initially: Option<Activity>,
    /// Whether a joint gave it: then none of its rows can be left out by whoever wrote the joint.
    pub is_of_joint: bool,
}

/// Whether a constraint holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Activity {
    /// It holds.
    Active,
    /// It does not, and its reaction is 0.
    Released,
}

/// One line of `initial`.
pub struct Initial {
    /// The coordinate it speaks of.
    pub coordinate: Ident,
    /// What it says of it.
    pub kind: InitialKind,
    /// The value.
    pub value: Expression,
}

/// What a line of `initial` fixes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum InitialKind {
    /// `alpha = 0;` the coordinate itself.
    Position,
    /// `dot(alpha) = 75 [rpm];` its speed.
    Speed,
    /// `guess gamma = 2.6;` where assembly starts to look.
    Guess,
}

/// Outputs that belong in one figure.
pub struct OutputGroup {
    /// The group's name; `None` for an output that stands alone.
    pub name: Option<Ident>,
    /// What to print above the figure.
    pub title: Option<String>,
    /// Its outputs.
    pub outputs: Vec<Output>,
}

/// `x6 [m] = C.x;`
pub struct Output {
    /// Documentation.
    pub docs: String,
    /// Its name.
    pub name: Ident,
    /// The unit it is reported in.
    pub unit: Option<Unit>,
    /// What it is.
    pub value: Expression,
}

/// One line of `drawing`.
pub enum Shape {
    /// `line O4, B, C;` and what else is drawn through or at points alone.
    Points {
        /// What it looks like.
        mark: Mark,
        /// Its points; a spring and a damper have two.
        points: Vec<Expression>,
    },
    /// `slider A along beta;`
    Slider {
        /// Its centre.
        at: Expression,
        /// The angle of its guide, in space its direction.
        along: Expression,
    },
    /// `circle O2 radius r;`
    Circle {
        /// Its centre.
        at: Expression,
        /// Its radius.
        radius: Expression,
        /// `normal n`, in space.
        normal: Option<Expression>,
    },
}

/// What is drawn through or at points.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mark {
    /// `line`: a link with a joint at each point.
    Line,
    /// `curve`: a road, a wall, a guide.
    Curve,
    /// `spring`
    Spring,
    /// `damper`
    Damper,
    /// `ground`: a fixed support at each point.
    Ground,
    /// `point`: a mark at each point.
    Point,
}
