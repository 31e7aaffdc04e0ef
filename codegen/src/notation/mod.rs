//! Equations of motion for readers: as infix text, LaTeX or MathML.
//!
//! Expressions become formulas (`translate`), in the customary order. Shared or wide parts get names (`sharing`), the
//! user's own if there are any. LaTeX and MathML set the same layout.

mod equation_groups;
mod formula;
mod greek;
mod infix;
mod latex;
mod layout;
mod lines;
mod mathml;
mod names;
mod sharing;
mod translate;
mod width;

use crate::dynamics::EquationsOfMotion;
use crate::symbolic::{Expr, Graph};
use equation_groups::Equation;

/// A notation for equations.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Notation {
    /// Text, in the notation of the language; names as in the generated code.
    Infix,
    /// `align*` environments of LaTeX's package `amsmath`.
    Latex,
    /// Presentation MathML: a `math` element, which a web page can hold.
    MathMl,
}

/// Equations that belong together, as text in some notation.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Section {
    /// `system`, `definitions`, or the name of the kernel that computes this: `mass_matrix` and so on.
    pub name: &'static str,
    /// The name in words.
    pub title: &'static str,
    /// The equations. Ends with a new line.
    pub text: String,
}

/// The equations of motion in parts: the system as a whole, mass matrix, convective forces, generalised forces,
/// constraints, constraint Jacobian, constraint convective terms, and the definitions of the names in them. Parts without
/// entries are left out.
pub fn equations(equations: &EquationsOfMotion, notation: Notation) -> Vec<Section> {
    let write = match notation {
        Notation::Infix => lines::text,
        Notation::Latex => |equations: &[Equation]| latex::lines(&lines::set(equations)),
        Notation::MathMl => |equations: &[Equation]| mathml::lines(&lines::set(equations)),
    };
    let groups = equation_groups::equation_groups(equations).into_iter();
    groups.map(|group| Section { name: group.name, title: group.title, text: write(&group.equations) }).collect()
}

/// One expression in infix notation, with the fewest parentheses.
///
/// Shared parts are written out each time, so this is not for large systems.
pub fn infix(graph: &Graph, expr: Expr) -> String {
    let names = names::Names::default();
    infix::text(&translate::Translation { graph, names: &names }.formula(expr))
}
