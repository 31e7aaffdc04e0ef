//! Stage 5: equations to straight-line programs, one for each kernel: sharing, the solution of the equations, the order
//! of computation, and names.

mod collect;
mod columns;
mod diagram;
mod eliminate;
mod entries;
mod kernels;
mod latency;
mod lifetimes;
mod links;
mod lower;
mod motion;
mod names;
mod needs;
mod notes;
mod numbers;
mod operation;
mod operations;
mod pieces;
mod planner;
mod prepared;
mod reduced;
mod responses;
mod results;
mod right_hand_sides;
mod schedule;
mod separate;
mod separated;
mod shared_products;
mod sparsity;
mod speed_mass_matrix;
mod speeds;
mod turns;
mod values;
mod ways;

pub use columns::{BLOCK, ColumnsShape, ColumnsStep};
pub use diagram::{Diagram, Vertex};
pub use kernels::plan;
pub use operations::Operations;
pub use pieces::Piece;
pub use results::Results;
pub use sparsity::{SparseRow, Sparsity};

use crate::kernel_id::KernelId;
use crate::symbolic::TableId;
use std::sync::Arc;

/// All kernels of a mechanism.
pub struct Program {
    /// The kernels, in the order in which they are printed.
    pub kernels: Vec<Kernel>,
    /// The sparsity of C_q, if using it pays off.
    pub sparsity: Option<Sparsity>,
}

/// A straight-line program.
pub struct Kernel {
    /// Which it is: its name, receiver, arguments.
    pub id: KernelId,
    /// Its documentation: formula, shape, units.
    pub docs: String,
    /// The local names of the entries of its arguments; `None` for those it does not need.
    pub entries: Entries,
    /// The parts computed before in functions of their own, if the kernel is long.
    pub pieces: Vec<Piece>,
    /// The statements, in order.
    pub statements: Vec<Statement>,
    /// The results.
    pub results: Results<Tree>,
    /// Its operations.
    pub operations: Operations,
}

/// Local names of the entries of each argument.
#[derive(Default)]
pub struct Entries {
    /// Of q.
    pub positions: Vec<Option<Name>>,
    /// Of q'.
    pub speeds: Vec<Option<Name>>,
    /// Of q''.
    pub accelerations: Vec<Option<Name>>,
    /// Of lambda.
    pub multipliers: Vec<Option<Name>>,
    /// Of u.
    pub generalized_speeds: Vec<Option<Name>>,
}

/// One step of a kernel.
pub enum Statement {
    /// A name for a value.
    Let {
        /// The name.
        name: Name,
        /// The value.
        value: Tree,
    },
    /// Sines and cosines of independent angles together.
    SinCos(Vec<Wave>),
    /// A table looked up once.
    Table(LookUp),
    /// A system solved for many right-hand sides.
    Columns(Columns),
}

/// A system with many right-hand sides, and its solutions.
pub struct Columns {
    /// The structure of the system.
    pub shape: Arc<ColumnsShape>,
    /// The reciprocals of pivots, by steps.
    pub inverses: Vec<Tree>,
    /// The entries of L, by steps.
    pub entries: Vec<Tree>,
    /// The right-hand sides, by rows.
    pub right_hand_sides: Vec<Vec<Tree>>,
    /// The names of the solutions, as far as they are needed.
    pub names: Vec<Vec<Option<Name>>>,
}

/// The value of a table and its derivatives, as far as they are needed.
pub struct LookUp {
    /// Which table of the model's graph.
    pub table: TableId,
    /// The names of the derivatives by order, from the value itself on.
    pub names: Vec<Option<Name>>,
    /// The argument.
    pub argument: Tree,
}

/// The sine and cosine of one angle, as far as they are needed.
pub struct Wave {
    /// The name of the sine.
    pub sin: Option<Name>,
    /// The name of the cosine.
    pub cos: Option<Name>,
    /// The angle.
    pub argument: Tree,
}

/// A name, shared by all of its uses.
pub type Name = Arc<str>;

/// An expression over names.
#[derive(Clone)]
pub enum Tree {
    /// A number that is not negative.
    Constant(f64),
    /// A local name.
    Name(Name),
    /// A field of the receiver: a parameter, or a value prepared from parameters.
    Field(Name),
    /// Terms, each with whether it is subtracted; the first is added.
    Sum(Vec<(bool, Tree)>),
    /// Factors.
    Product(Vec<Tree>),
    /// A quotient.
    Quotient(Box<Tree>, Box<Tree>),
    /// The opposite.
    Negate(Box<Tree>),
    /// A method of the scalar: receiver first.
    Method(&'static str, Vec<Tree>),
}
