//! The ways to solve the equations of motion, and the one that takes fewest operations.

use super::links::Joints;
use super::lower::Lowering;
use super::motion::Motion;
use super::planner::Planner;
use super::values::{Leaves, Value, Values};
use crate::dynamics::{ConstraintForm, ConstraintRows, EquationsOfMotion, Links, Separation};
use crate::threads;

/// With more coordinates only recursions are tried where there are links: rows of T of a tree depend on all coordinates before
/// them, and to count what they would take takes long.
const MOST_BY_ROWS: usize = 32;

/// The motion solved at one state.
pub(super) struct Solution<'a> {
    pub(super) lowering: Lowering<'a>,
    pub(super) motion: Motion<'a>,
    /// The same by a factorisation, where derivatives are wanted and the motion has none.
    pub(super) differentiable: Option<Motion<'a>>,
}

/// A way to solve the equations of motion.
#[derive(Clone, Copy)]
enum Way<'a> {
    /// A factorisation of the system in this form, with its rows written like this, its other terms from rows of T or by recursions
    /// over links, with these coordinates separated.
    Factorised(&'a ConstraintForm, &'a ConstraintRows, Option<&'a Links>, &'a [Separation]),
    /// From the tips of an open tree to the world and back.
    Open(&'a Links, Joints),
}

/// A way that was gone, with the number of operations.
struct Trial<'a> {
    way: Way<'a>,
    cost: usize,
    lowering: Lowering<'a>,
    motion: Motion<'a>,
}

impl<'a> Way<'a> {
    fn factorised(equations: &'a EquationsOfMotion) -> impl Iterator<Item = Way<'a>> {
        let EquationsOfMotion { declared, turned, links, separations, .. } = equations;
        let forms = [declared].into_iter().chain(turned);
        let written =
            |form: &'a ConstraintForm| [&form.rows].into_iter().chain(&form.shortened).map(move |rows| (form, rows));
        let forms = forms.flat_map(written);
        let by_rows = can_be_by_rows(equations).then_some(None);
        let terms = move || by_rows.into_iter().chain(links.iter().map(Some));
        let together = forms
            .clone()
            .flat_map(move |(form, rows)| terms().map(move |links| Way::Factorised(form, rows, links, &[])));
        let is_separated = !separations.is_empty();
        let separated = forms.filter(move |_| is_separated);
        together.chain(separated.map(|(form, rows)| Way::Factorised(form, rows, None, separations)))
    }

    fn open(equations: &'a EquationsOfMotion) -> impl Iterator<Item = Way<'a>> {
        let links = equations.links.iter().filter(|links| links.open.is_some());
        links.flat_map(|links| [Joints::Together, Joints::OneByOne].map(|joints| Way::Open(links, joints)))
    }

    fn solve(self, equations: &'a EquationsOfMotion, lowering: &mut Lowering) -> Option<Motion<'a>> {
        match self {
            Way::Factorised(form, rows, links, separations) => {
                Some(Motion::factorised(equations, form, rows, links, separations, lowering))
            }
            Way::Open(links, joints) => Motion::of_open_tree(equations, links, joints, lowering),
        }
    }

    fn tried(self, planner: &'a Planner<'a>) -> Option<Trial<'a>> {
        let mut lowering = planner.lowering();
        let motion = self.solve(planner.equations, &mut lowering)?;
        let cost = match motion.is_planned() {
            true => operations(&lowering.values, motion.dynamics().entries()),
            false => usize::MAX,
        };
        Some(Trial { way: self, cost, lowering, motion })
    }
}

impl<'a> Solution<'a> {
    pub(super) fn cheapest(planner: &'a Planner<'a>) -> Option<Solution<'a>> {
        let least = |ways: Vec<Way<'a>>| {
            let trials = threads::map(&ways, |way| way.tried(planner)).into_iter().flatten();
            trials.reduce(|best, other| if other.cost < best.cost { other } else { best })
        };
        let is_differentiated = is_differentiated(planner.equations);
        let open = least(Way::open(planner.equations).collect());
        let open = match open {
            Some(Trial { lowering, motion, .. }) if !is_differentiated && !can_be_by_rows(planner.equations) => {
                return Some(Solution { lowering, motion, differentiable: None });
            }
            open => open,
        };
        let factorised = least(Way::factorised(planner.equations).collect())?;
        let open = open.filter(|open| open.cost < factorised.cost);
        let Some(Trial { mut lowering, motion, .. }) = open else {
            let Trial { lowering, motion, .. } = factorised;
            return Some(Solution { lowering, motion, differentiable: None });
        };
        let differentiable = match is_differentiated {
            true => factorised.way.solve(planner.equations, &mut lowering),
            false => None,
        };
        Some(Solution { lowering, motion, differentiable })
    }
}

/// Whether the terms of the equations of motion may come from rows of T.
pub(super) fn can_be_by_rows(equations: &EquationsOfMotion) -> bool {
    equations.links.is_none() || equations.model.coordinates.len() <= MOST_BY_ROWS
}

/// Whether anything is made of the terms from rows of T.
pub(super) fn takes_rows(equations: &EquationsOfMotion) -> bool {
    can_be_by_rows(equations) || is_differentiated(equations) || !equations.separations.is_empty()
}

/// Whether derivatives of the motion are wanted.
fn is_differentiated(EquationsOfMotion { declared, .. }: &EquationsOfMotion) -> bool {
    !declared.by_state.is_empty() || declared.by_parameters.is_some()
}

/// The number of operations that are not on parameters alone.
pub(super) fn operations(values: &Values, roots: Vec<&Value>) -> usize {
    let roots: Vec<Value> = roots.into_iter().copied().collect();
    let needed = values.reachable(&roots, &Leaves::default());
    let moving = needed.into_iter().filter(|value| !values.is_parametric(*value));
    moving.map(|value| values.operands(value).count().saturating_sub(1)).sum()
}
