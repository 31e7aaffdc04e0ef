//! Stage 3: names are resolved, errors of meaning reported, and the declaration becomes symbolic. The user's tokens end
//! here.

mod arithmetic;
mod auxiliary;
mod bare_degrees;
mod blame;
mod bodies;
mod calls;
mod choice;
mod cycles;
mod dependence;
mod dimension;
mod drawing;
mod elements;
mod equations;
mod events;
mod expressions;
mod function;
mod homogeneity;
mod inertial;
mod interpreter;
mod level;
mod loads;
mod look_up;
mod measured;
mod origin;
mod outputs;
mod parts;
mod placed_frames;
mod plain;
mod quantities;
mod rates;
mod resolve;
mod run;
mod scope;
mod smooth;
mod space;
mod speeds;
mod spline;
mod start;
mod tables;
mod units;
mod unmoved;
mod value;
mod vectors;

pub use crate::dsl::Direction;
pub use dependence::{Dependence, Dependences};
pub use dimension::Dimension;
pub use parts::{
    Auxiliary, Body, Conditional, Constraint, Coordinate, Effort, Event, EventStep, Force, GeneralizedSpeed, Input,
    Level, Output, OutputGroup, Parameter, Shape, Start, Target,
};
pub use resolve::resolve;
pub use run::{METHODS, RunDefault};
pub use scope::is_name;
pub(crate) use space::triple;
pub use space::{Attitude, Fall, FixedBody, Link, Norm, Push, Pushed, Rates, Tensor, impossible_inertia};
pub use units::Unit;

use crate::kernel_id::KernelId;
use crate::symbolic::{Differential, Expr, Graph, Symbol};

/// What a declaration means: a model, and the graph that its expressions live in.
pub struct Resolved {
    /// The mechanism.
    pub model: Model,
    /// Where its expressions live.
    pub graph: Graph,
    /// The same with auxiliary displacements as variables; none where there are none.
    pub displaced: Option<Displaced>,
}

/// A model with auxiliary displacements as variables, in a graph of its own.
pub struct Displaced {
    /// The mechanism.
    pub model: Model,
    /// Where its expressions live.
    pub graph: Graph,
}

/// A mechanism in symbols. All expressions are in SI units and live in a graph beside it.
pub struct Model {
    /// The type's name.
    pub name: String,
    /// Documentation, one line each.
    pub docs: String,
    /// What each expression depends on.
    pub dependences: Dependences,
    /// Time.
    pub time: Symbol,
    /// Generalised coordinates, in the order of declaration.
    pub coordinates: Vec<Coordinate>,
    /// Parameters, in the order of declaration.
    pub parameters: Vec<Parameter>,
    /// Inputs, in the order of declaration.
    pub inputs: Vec<Input>,
    /// Scalars that the declaration names with `let`; components as `A_x`.
    pub named: Vec<(String, Expr)>,
    /// Bodies.
    pub bodies: Vec<Body>,
    /// The frames that bodies of space are fixed in.
    pub links: Vec<Link>,
    /// Acceleration of free fall of every mass.
    pub gravity: Option<Point>,
    /// Forces at points.
    pub forces: Vec<Force>,
    /// Efforts along scalars: torques about angles, springs, dampers, potentials.
    pub efforts: Vec<Effort>,
    /// Forces and torques in space.
    pub pushes: Vec<Push>,
    /// Quaternions of coordinates.
    pub norms: Vec<Norm>,
    /// The constraint rows that keep their norms.
    pub norm_constraints: Vec<usize>,
    /// Generalised generalized_speeds, in the order of declaration; none, or enough to determine all rates.
    pub generalized_speeds: Vec<GeneralizedSpeed>,
    /// 2 in the plane, 3 in space.
    pub dimension: usize,
    /// Constraints, one row each, in the order of declaration.
    pub constraints: Vec<Constraint>,
    /// Constraints that events switch, in the order of declaration.
    pub conditionals: Vec<Conditional>,
    /// Conditions whose crossings are located.
    pub events: Vec<Event>,
    /// Outputs, in the order of declaration.
    pub outputs: Vec<Output>,
    /// Which outputs belong in one figure.
    pub groups: Vec<OutputGroup>,
    /// The drawing.
    pub drawing: Vec<Shape>,
    /// Which of the optional kernels are requested; `None` leaves that to the program.
    pub kernels: Option<Vec<KernelId>>,
    /// How it is run where nothing else is said.
    pub run: Vec<RunDefault>,
    /// Auxiliary displacements, which are zero here.
    pub auxiliaries: Vec<Auxiliary>,
}

/// A scalar for each axis: two in the plane, three in space.
pub type Point = Vec<Expr>;

impl Model {
    /// Whether a kernel is requested by name.
    pub fn wants(&self, kernel: KernelId) -> bool {
        self.kernels.as_ref().is_some_and(|kernels| kernels.contains(&kernel))
    }

    /// The total time derivative of an expression without accelerations.
    pub fn time_derivative(&self, graph: &mut Graph) -> Differential {
        time_derivative(graph, self.time, &self.coordinates, &[])
    }

    /// The accelerations as expressions.
    pub fn accelerations(&self, graph: &mut Graph) -> Vec<Expr> {
        self.coordinates.iter().map(|c| graph.variable(c.acceleration)).collect()
    }

    /// The multipliers as expressions.
    pub fn multipliers(&self, graph: &mut Graph) -> Vec<Expr> {
        self.constraints.iter().map(|c| graph.variable(c.multiplier)).collect()
    }
}

fn time_derivative(
    graph: &mut Graph,
    time: Symbol,
    coordinates: &[Coordinate],
    auxiliaries: &[Auxiliary],
) -> Differential {
    let mut rates = vec![(time, graph.one())];
    for c in coordinates {
        rates.push((c.position, graph.variable(c.speed)));
        rates.push((c.speed, graph.variable(c.acceleration)));
    }
    for a in auxiliaries {
        rates.push((a.displacement, graph.variable(a.rate)));
    }
    Differential::along(rates)
}
