//! Stage 4: equations to straight-line programs, one for each kernel: what is shared, how the equations are
//! solved, in which order things are computed and under which names.

mod diagram;
mod eliminate;
mod kernels;
mod lower;
mod names;
mod operations;
mod schedule;
mod values;

pub use diagram::{Diagram, Vertex};
pub use kernels::plan;
pub use operations::Operations;
pub use values::Input;

/// All kernels of a mechanism.
pub struct Program {
    /// The kernels, in the order in which they are printed.
    pub kernels: Vec<Kernel>,
}

/// A straight-line program.
pub struct Kernel {
    /// Its name.
    pub name: &'static str,
    /// What it computes: formula, shape, units.
    pub docs: String,
    /// Its arguments.
    pub arguments: Arguments,
    /// The local names of the entries of its arguments; `None` for those it does not need.
    pub entries: Entries,
    /// What is computed, in order.
    pub statements: Vec<Statement>,
    /// What is returned.
    pub results: Results,
    /// What it costs.
    pub operations: Operations,
}

/// The arguments of a kernel: each kind includes those before.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Arguments {
    /// Only the parameters.
    Parameters,
    /// And t, q.
    Positions,
    /// And q'.
    Speeds,
    /// And q''.
    Accelerations,
    /// And lambda.
    Multipliers,
}

/// Local names of the entries of each argument.
#[derive(Default)]
pub struct Entries {
    /// Of q.
    pub positions: Vec<Option<String>>,
    /// Of q'.
    pub speeds: Vec<Option<String>>,
    /// Of q''.
    pub accelerations: Vec<Option<String>>,
    /// Of lambda.
    pub multipliers: Vec<Option<String>>,
}

/// One step of a kernel.
pub enum Statement {
    /// A name for a value.
    Let {
        /// The name.
        name: String,
        /// The value.
        value: Tree,
    },
    /// Sines and cosines of independent angles together.
    SinCos(Vec<Wave>),
}

/// The sine and cosine of one angle, as far as they are needed.
pub struct Wave {
    /// The name of the sine.
    pub sin: Option<String>,
    /// The name of the cosine.
    pub cos: Option<String>,
    /// The angle.
    pub argument: Tree,
}

/// An expression over names.
pub enum Tree {
    /// A number that is not negative.
    Constant(f64),
    /// A local name.
    Name(String),
    /// A parameter of the mechanism.
    Parameter(String),
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

/// What a kernel returns.
pub enum Results {
    /// One number.
    Scalar(Tree),
    /// A vector, or a struct with a field for each entry.
    Vector(Vec<Tree>),
    /// A matrix by rows.
    Matrix(Vec<Vec<Tree>>),
    /// C, C_q and C_t.
    Linearization(Vec<Tree>, Vec<Vec<Tree>>, Vec<Tree>),
    /// Start positions and speeds.
    Initial(Vec<Tree>, Vec<Tree>),
    /// The solved equations of motion.
    Dynamics {
        /// q''.
        accelerations: Vec<Tree>,
        /// lambda.
        multipliers: Vec<Tree>,
        /// Power.
        power: Tree,
        /// Each pivot with the magnitude of its terms; none if no elimination could be planned, and every state
        /// is refused.
        pivots: Option<Vec<(Tree, Tree)>>,
    },
}

impl Results {
    /// Calls `f` for every expression.
    fn visit<'a>(&'a self, f: &mut dyn FnMut(&'a Tree)) {
        match self {
            Results::Scalar(tree) => f(tree),
            Results::Vector(trees) => trees.iter().for_each(f),
            Results::Matrix(rows) => rows.iter().flatten().for_each(f),
            Results::Linearization(values, rows, rates) => {
                values.iter().chain(rows.iter().flatten()).chain(rates).for_each(f);
            }
            Results::Initial(positions, speeds) => positions.iter().chain(speeds).for_each(f),
            Results::Dynamics { accelerations, multipliers, power, pivots } => {
                accelerations.iter().chain(multipliers).chain([power]).for_each(&mut *f);
                pivots.iter().flatten().flat_map(|(pivot, terms)| [pivot, terms]).for_each(f);
            }
        }
    }
}
