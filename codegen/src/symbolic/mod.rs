//! The symbolic engine: expressions over exact rationals, shared and kept in canonical form.
//!
//! Every expression lives in one [`Graph`] and is named by an [`Expr`]; structurally equal expressions
//! are the same `Expr`. Only the constructors on `Graph` add nodes, so canonical form is an invariant
//! and not a pass. The engine knows no mechanics: symbols are names, and what they mean is its user's
//! business.
//!
//! A rewriting that could change a value, at any real point, infinities and NaN included, is not done.
//! The one exception is the customary one: `0*x` is 0 and `x - x` is 0 whatever x is.

mod derivative;
mod evaluate;
mod expand;
mod facts;
mod function;
mod graph;
mod number;
mod power;
mod product;
mod pythagoras;
mod substitute;
mod sum;

pub use derivative::Differential;
pub use evaluate::{apply_function, evaluate};
pub use function::Function;
pub use graph::{Constant, Expr, Graph, Node, Symbol};
pub use number::Number;
pub use substitute::{substitute, with_operands};
