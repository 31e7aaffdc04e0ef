//! The state of interpreting a declaration's expressions, and checks of what they must not be.

use super::function::Function;
use super::origin::Origins;
use super::scope::{Names, Values, plain};
use super::space::{Frames, Quaternion};
use super::value::Value;
use super::{Dependence, Dependences};
use crate::dsl::{Declaration, Region};
use crate::mistakes::Mistakes;
use crate::symbolic::{Differential, Expr, Graph, Symbol, evaluate};
use rustc_hash::FxHashMap;

/// Turns expressions into values. `None` means a mistake that has been recorded.
pub(super) struct Interpreter {
    pub(super) graph: Graph,
    pub(super) dependences: Dependences,
    pub(super) values: Values,
    pub(super) tables: Names<Function>,
    pub(super) origins: Origins,
    /// Whether dimensions are checked: they are unless no unit is declared anywhere.
    pub(super) with_units: bool,
    /// Reserved names that are defined nevertheless; their uses are not reported again.
    pub(super) misnamed: Vec<String>,
    /// Words that have a meaning in one expression alone.
    pub(super) local: Vec<(&'static str, Value)>,
    /// The multipliers of each constraint; absent until constraints are resolved.
    pub(super) reactions: Option<Names<Value>>,
    /// The lengths of vectors that have been asked for, with their components.
    pub(super) lengths: FxHashMap<Expr, Vec<Expr>>,
    /// Names of the outputs, which are not values.
    pub(super) outputs: Vec<String>,
    pub(super) time: Expr,
    pub(super) motion: Differential,
    pub(super) mistakes: Mistakes,
    /// All rotations.
    pub(super) frames: Frames,
    /// The quaternions whose components are coordinates.
    pub(super) quaternions: Vec<Quaternion>,
    /// The number of components of the first vector, and its place: all others must have as many.
    pub(super) vectors: Option<(usize, Region)>,
}

impl Interpreter {
    /// Before anything is resolved. `time` is a symbol of the graph.
    pub(super) fn new(declaration: &Declaration, mut graph: Graph, time: Symbol) -> Interpreter {
        let mut dependences = Dependences::default();
        dependences.declare(time, Dependence::TIME);
        let outputs = declaration.outputs.iter().flat_map(|group| &group.outputs);
        Interpreter {
            time: graph.variable(time),
            graph,
            dependences,
            values: Names::new("value"),
            tables: Names::new("table"),
            origins: Origins::default(),
            with_units: declaration.has_units(),
            misnamed: vec![],
            local: vec![],
            reactions: None,
            lengths: FxHashMap::default(),
            outputs: outputs.map(|output| plain(&output.name)).collect(),
            motion: Differential::along([]),
            mistakes: Mistakes::default(),
            frames: Frames::default(),
            quaternions: vec![],
            vectors: None,
        }
    }

    /// A mistake at a place.
    pub(super) fn refuse<T>(&mut self, region: Region, message: impl std::fmt::Display) -> Option<T> {
        self.mistakes.add(region.error(message));
        None
    }

    /// Whether vectors have three components.
    pub(super) fn is_spatial(&self) -> bool {
        self.vectors.is_some_and(|(components, _)| components == 3)
    }

    /// Refuses an expression with a dependence that is not allowed here; `rule` says why.
    pub(super) fn restrict(&mut self, place: Region, values: &[Expr], forbidden: Dependence, rule: &str) -> Option<()> {
        for value in values {
            if self.dependences.of(&self.graph, *value).meets(forbidden) {
                return self.refuse(place, rule);
            }
        }
        Some(())
    }

    /// Refuses constants that are not real numbers, such as `sqrt(-1)`, and coefficients beyond the range of `f64`.
    pub(super) fn check_constants(&mut self, region: Region, values: &[Expr]) -> Option<()> {
        for value in values {
            let constant = self.dependences.of(&self.graph, *value) == Dependence::NONE;
            if constant && !evaluate(&self.graph, &[*value], |_| f64::NAN)[0].is_finite() {
                return self.refuse(region, "this is not a finite real number");
            }
            if !self.graph.numbers_in_range(*value) {
                return self
                    .refuse(region, "a coefficient here is outside the range of numbers (about 1e-308 to 1e308)");
            }
        }
        Some(())
    }
}
