//! The symbolic engine: expressions over exact rationals, shared and kept in canonical form.
//!
//! Every expression lives in one [`Graph`] and is named by an [`Expr`]; structurally equal expressions are the same
//! `Expr`. Only the constructors on `Graph` add nodes, so canonical form is an invariant and not a pass. The engine
//! knows no mechanics: symbols are names, and their meaning is up to the caller.
//!
//! No rewriting changes a value at any real point, infinities and NaN included. The one exception is the customary one:
//! `0*x` and `x - x` are 0 for every x, and a choice between equal expressions is that expression, whatever the
//! condition. `if d > 0 then x else y` is NaN where d is NaN.
//!
//! # The rules
//!
//! The expression on the left becomes the one on the right on construction, with any expressions in place of the
//! letters. A condition must hold for every real value of the symbols; if that is not known, it does not hold.
//!
//! | rule | written | becomes | condition |
//! |---|---|---|---|
//! | sums are flat | `x + (y + z)` | `x + y + z` | always |
//! | like terms merge | `2*x + y + 3*x/2` | `7*x/2 + y` | always |
//! | terms cancel | `x*y + z - y*x` | `z` | always |
//! | a number distributes over a sum | `2*(x + 3*y)` | `2*x + 6*y` | only a number |
//! | squares of sine and cosine fold | `2*y*sin(x)^2 + 5*y*cos(x)^2` | `5*y - 3*y*sin(x)^2` | equal other factors, numbers before them |
//! | products are flat | `x*(y*z)` | `x*y*z` | always |
//! | zero absorbs | `0*x` | `0` | always |
//! | powers of one sign merge | `x^2*x/(y*y^2)` | `x^3/y^3` | exponents of one sign |
//! | powers of opposite sign merge | `exp(x)^3/exp(x)` | `exp(x)^2` | the base is never zero and always finite |
//! | a sum gives its content away | `y/(2*x + 4*z)` | `y/(2*(x + 2*z))` | always |
//! | equal up to content, sums merge | `(2*x + 4)*(x + 2)` | `2*(x + 2)^2` | always |
//! | a positive power of a product distributes | `(x*y^2)^3` | `x^3*y^6` | always |
//! | a negative power of a product distributes | `1/(x*y)^2` | `1/(x^2*y^2)` | no factor is below, unless it is never zero |
//! | the power 0 is 1 | `x^0` | `1` | always |
//! | the power 1 is its base | `x^1` | `x` | always |
//! | fractional powers are powers of roots | `x^(3/2)*x^(1/2)` | `sqrt(x)^4` | always |
//! | exact roots are numbers | `(9/4)^(3/2)*x` | `27*x/8` | a root that is rational |
//! | powers of e are exp | `e^(x*y)` | `exp(x*y)` | always |
//! | odd functions give their sign away | `sin(-x) + tan(-y/9) + sinh(-z)` | `-sin(x) - tan(y/9) - sinh(z)` | sin, tan, asin, atan, sinh, tanh, sign |
//! | even functions drop their sign | `cos(y - x) + cosh(-x) + abs(-z)` | `cos(x - y) + cosh(x) + abs(z)` | cos, cosh, abs |
//! | sin 0 | `sin(0)*x + y` | `y` | always |
//! | cos 0, cosh 0, exp 0 | `cos(0)*x + cosh(0)*y + exp(0)*z` | `x + y + z` | always |
//! | tan 0, asin 0, atan 0, sinh 0, tanh 0 | `tan(0) + asin(0) + atan(0) + sinh(0) + tanh(0) + x` | `x` | always |
//! | ln 1 | `ln(1)*x + y` | `y` | always |
//! | abs of a number | `abs(-3/2)*x` | `3*x/2` | a number |
//! | sign of a number | `sign(-3)*x + sign(2)*y` | `y - x` | a number |
//! | numbers are exact | `(1/3 + 1/6)*x + 0.1*y + 0.2*y` | `x/2 + 3*y/10` | always |
//! | powers of numbers are numbers | `(2/3)^(-2)*x` | `9*x/4` | of no more than 4,000 bits |
//! | a choice between equals is none | `if x > 0 then y + z else z + y` | `y + z` | always |
//! | a choice by a number is made | `(if 2 > 0 then x else y) + (if -1/2 > 0 then y else z) + (if 0 > 0 then x else z)` | `x + 2*z` | a number |
//! | the size of a difference does not matter | `if 2*x - 4*y > 0 then x else z` | `if x - 2*y > 0 then x else z` | a positive number |
//! | what is zero everywhere is 0 | `x*(y - y) + sin(z - z)` | `0` | always |
//!
//! Each row is tested, at random points too, by `codegen/tests/symbolic/rules.rs`. [`Graph::expand`] is not among them;
//! it must be called explicitly.

mod call;
mod choice;
mod derivative;
mod evaluate;
mod expand;
mod facts;
mod function;
mod graph;
mod look_up;
mod node;
mod number;
mod operands;
mod power;
mod product;
mod pythagoras;
mod recognise;
mod rest;
mod rounding;
mod substitute;
mod sum;
mod symbols;
mod table;

pub use derivative::Differential;
pub use evaluate::{apply_function, evaluate};
pub use function::Function;
pub use graph::Graph;
pub use node::{Constant, Expr, Node, Symbol};
pub use number::Number;
pub use operands::Operands;
pub use recognise::Recognition;
pub use rounding::{Rounded, evaluate_with_rounding};
pub use substitute::{substitute, transplant, with_operands};
pub use table::{Table, TableId};
