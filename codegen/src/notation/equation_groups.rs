//! The equations of motion in parts: the system as a whole, and each of its blocks.

use super::formula::Formula;
use super::names::{Name, Names};
use super::sharing::{LINE, names};
use super::translate::Translation;
use super::width::set_width;
use crate::dynamics::EquationsOfMotion;
use crate::kernel_id::KernelId;
use crate::model::Constraint;
use crate::symbolic::Expr;
use std::rc::Rc;

/// The widest system that is also written entry by entry.
const LARGEST_SYSTEM: usize = 8;
/// The width up to which entries stay in their matrix.
const NARROWEST_ENTRY: usize = 12;
/// The widest entry of a vector.
const WIDEST_OF_VECTOR: usize = 30;

/// Equations that belong together.
pub(super) struct EquationGroup {
    pub(super) name: &'static str,
    pub(super) title: &'static str,
    pub(super) equations: Vec<Equation>,
}

/// `left = right`, the left side a product.
pub(super) struct Equation {
    pub(super) left: Vec<Block>,
    pub(super) right: Block,
}

/// A scalar or a matrix.
pub(super) enum Block {
    Formula(Formula),
    Matrix(Vec<Vec<Formula>>),
}

/// A vector or matrix of the equations of motion.
struct Term<'a> {
    kernel: KernelId,
    title: &'static str,
    symbol: Rc<Name>,
    rows: Vec<&'a [Expr]>,
    is_matrix: bool,
}

/// All equation_groups that have entries; the definitions at the end.
pub(super) fn equation_groups(equations: &EquationsOfMotion) -> Vec<EquationGroup> {
    let terms = terms(equations);
    let roots: Vec<Expr> = terms.iter().flat_map(|term| term.rows.concat()).collect();
    let (mut names, defined) = names(equations, &roots);
    let long = name_long_entries(equations, &terms, &mut names);
    let translation = Translation { graph: &equations.graph, names: &names };
    let mut parts = vec![system(equations, &terms, &translation)];
    for (term, long) in terms.iter().zip(long).filter(|(term, _)| !term.rows.is_empty()) {
        let mut equations = vec![Equation {
            left: vec![Block::Formula(Formula::Name(term.symbol.clone()))],
            right: Block::Matrix(term.entries(&translation)),
        }];
        equations.extend(long.into_iter().map(|expr| definition(&translation, expr)));
        parts.push(EquationGroup { name: term.kernel.name(), title: term.title, equations });
    }
    let equations: Vec<Equation> = defined.into_iter().map(|expr| definition(&translation, expr)).collect();
    if !equations.is_empty() {
        parts.push(EquationGroup { name: "definitions", title: "Definitions", equations });
    }
    parts
}

/// Mass matrix, convective forces, generalised forces, constraints, constraint Jacobian and convective terms.
fn terms(equations: &EquationsOfMotion) -> [Term<'_>; 6] {
    let EquationsOfMotion { tmt, constraints, .. } = equations;
    [
        Term::matrix(KernelId::MassMatrix, "Mass matrix", ("M", &[]), &tmt.mass_matrix),
        Term::vector(KernelId::ConvectiveForces, "Convective forces", "h", &tmt.convective_forces),
        Term::vector(KernelId::GeneralizedForces, "Generalised forces", "Q", &tmt.generalized_forces),
        Term::vector(KernelId::Constraints, "Constraints", "C", &constraints.values),
        Term::matrix(KernelId::ConstraintJacobian, "Constraint Jacobian", ("C", &["q"]), &constraints.jacobian),
        Term::vector(KernelId::ConstraintConvective, "Constraint convective terms", "c", &constraints.convective),
    ]
}

impl<'a> Term<'a> {
    fn matrix(
        kernel: KernelId,
        title: &'static str,
        (letter, indices): (&str, &[&str]),
        rows: &'a [Vec<Expr>],
    ) -> Term<'a> {
        let rows = rows.iter().map(Vec::as_slice).collect();
        Term { kernel, title, symbol: Name::bold(kernel.name(), letter, indices).into(), rows, is_matrix: true }
    }

    fn vector(kernel: KernelId, title: &'static str, letter: &str, entries: &'a [Expr]) -> Term<'a> {
        Term {
            kernel,
            title,
            symbol: Name::bold(kernel.name(), letter, &[]).into(),
            rows: entries.chunks(1).collect(),
            is_matrix: false,
        }
    }

    /// The name of an entry.
    fn entry(&self, row: usize, column: usize) -> Name {
        if self.is_matrix { self.symbol.entry(&[row + 1, column + 1]) } else { self.symbol.entry(&[row + 1]) }
    }

    fn entries(&self, translation: &Translation) -> Vec<Vec<Formula>> {
        self.rows.iter().map(|row| row.iter().map(|expr| translation.formula(*expr)).collect()).collect()
    }
}

/// Names entries that are too wide to stand in their matrix; gives them for each term.
fn name_long_entries(equations: &EquationsOfMotion, terms: &[Term], names: &mut Names) -> Vec<Vec<Expr>> {
    let size = equations.model.coordinates.len() + equations.model.constraints.len();
    let mut long_of_all = Vec::new();
    for term in terms {
        let widest = if term.is_matrix { (LINE / size).max(NARROWEST_ENTRY) } else { WIDEST_OF_VECTOR };
        let mut long = Vec::new();
        for (i, row) in term.rows.iter().enumerate() {
            for (j, expr) in row.iter().enumerate() {
                let formula = Translation { graph: &equations.graph, names }.formula(*expr);
                if set_width(&formula) > widest {
                    names.name_entry(*expr, term.entry(i, j));
                    long.push(*expr);
                }
            }
        }
        long_of_all.push(long);
    }
    long_of_all
}

fn definition(translation: &Translation, expr: Expr) -> Equation {
    let name = translation.names.of(expr).map(|name| Block::Formula(Formula::Name(name.clone())));
    Equation { left: name.into_iter().collect(), right: Block::Formula(translation.definition(expr)) }
}

/// The system by blocks and, if it is small, by entries.
fn system(equations: &EquationsOfMotion, terms: &[Term; 6], translation: &Translation) -> EquationGroup {
    let model = &equations.model;
    let (n, m) = (model.coordinates.len(), model.constraints.len());
    let symbols = |symbols: Vec<_>| -> Vec<Vec<Formula>> {
        symbols
            .into_iter()
            .map(|symbol| vec![Formula::Name(translation.names.symbol(&equations.graph, symbol))])
            .collect()
    };
    let coordinates = symbols(model.coordinates.iter().map(|c| c.position).collect());
    let accelerations = symbols(model.coordinates.iter().map(|c| c.acceleration).collect());
    let multipliers = symbols(model.constraints.iter().map(|c| c.multiplier).collect());
    let mut lines = vec![by_blocks(terms, m), named("coordinates", "q", coordinates)];
    if m > 0 {
        lines.push(named("multipliers", "lambda", multipliers.clone()));
        let constraints = Block::Formula(Formula::Name(terms[3].symbol.clone()));
        lines.push(Equation { left: vec![constraints], right: Block::Formula(Formula::number(0)) });
    }
    if n + m <= LARGEST_SYSTEM {
        let diagonal = model.constraints.iter().map(|constraint| released(constraint, translation)).collect();
        lines.push(by_entries(terms, translation, [accelerations, multipliers].concat(), diagonal));
    }
    EquationGroup { name: "system", title: "Equations of motion", equations: lines }
}

fn named(text: &str, letter: &str, entries: Vec<Vec<Formula>>) -> Equation {
    Equation {
        left: vec![Block::Formula(Formula::Name(Name::bold(text, letter, &[]).into()))],
        right: Block::Matrix(entries),
    }
}

/// `[M C_q'; C_q 0] [q''; lambda] = [Q - h; -c]`
fn by_blocks(terms: &[Term; 6], constraints: usize) -> Equation {
    let [mass, convective, loads, _, jacobian, rates] = terms.each_ref().map(|term| term.symbol.clone());
    let accelerations = Formula::Name(Name::bold("accelerations", "q", &[]).dotted(2).into());
    let forces = Formula::Sum(vec![(false, Formula::Name(loads)), (true, Formula::Name(convective))]);
    let mass = Formula::Name(mass);
    if constraints == 0 {
        return Equation {
            left: vec![Block::Formula(mass), Block::Formula(accelerations)],
            right: Block::Formula(forces),
        };
    }
    let matrix =
        vec![vec![mass, Formula::Transpose(jacobian.clone())], vec![Formula::Name(jacobian), Formula::number(0)]];
    let multipliers = Formula::Name(Name::bold("multipliers", "lambda", &[]).into());
    Equation {
        left: vec![Block::Matrix(matrix), Block::Matrix(vec![vec![accelerations], vec![multipliers]])],
        right: Block::Matrix(vec![vec![forces], vec![Formula::Name(rates).signed(true)]]),
    }
}

/// The diagonal entry of a multiplier: activity - 1 if events switch its constraint.
fn released(constraint: &Constraint, translation: &Translation) -> Formula {
    let activity = |activity| vec![(false, translation.formula(activity)), (true, Formula::number(1))];
    constraint.activity.map_or(Formula::number(0), |expr| Formula::Sum(activity(expr)))
}

/// The same with all entries.
fn by_entries(
    terms: &[Term; 6],
    translation: &Translation,
    unknowns: Vec<Vec<Formula>>,
    diagonal: Vec<Formula>,
) -> Equation {
    let [mass, convective, loads, _, jacobian, rates] = terms.each_ref().map(|term| term.entries(translation));
    let mut matrix = mass;
    for (i, row) in matrix.iter_mut().enumerate() {
        row.extend(jacobian.iter().map(|constraint| constraint[i].clone()));
    }
    for (i, row) in jacobian.iter().enumerate() {
        let mut of_multipliers = vec![Formula::number(0); jacobian.len()];
        of_multipliers[i] = diagonal[i].clone();
        matrix.push([row.clone(), of_multipliers].concat());
    }
    let mut right: Vec<Vec<Formula>> =
        loads.iter().zip(&convective).map(|(q, h)| vec![difference(&q[0], &h[0])]).collect();
    right.extend(rates.iter().map(|row| vec![difference(&Formula::number(0), &row[0])]));
    Equation { left: vec![Block::Matrix(matrix), Block::Matrix(unknowns)], right: Block::Matrix(right) }
}

/// `a - b`, as one sum.
fn difference(a: &Formula, b: &Formula) -> Formula {
    let terms = |formula: &Formula, subtracted: bool| match formula {
        zero if zero.is_zero() => vec![],
        Formula::Sum(terms) => terms.iter().map(|(sign, term)| (*sign != subtracted, term.clone())).collect(),
        other => vec![(subtracted, other.clone())],
    };
    Formula::sum([terms(a, false), terms(b, true)].concat())
}
