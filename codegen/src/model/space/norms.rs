//! Quaternions of coordinates, and the constraints that keep their norms.

use crate::dsl::Region;
use crate::mistakes::Mistakes;
use crate::model::{Constraint, Level};
use crate::symbolic::{Expr, Graph, Symbol, evaluate};

/// A quaternion of coordinates, which need their norm constraint.
pub(in crate::model) struct Quaternion {
    pub(in crate::model) components: [Expr; 4],
    pub(super) symbols: [Symbol; 4],
    pub(super) names: [String; 4],
    pub(super) place: Region,
}

/// The rows that keep the norms of quaternions of coordinates; refuses quaternions without one.
pub(in crate::model) fn check_norms(
    quaternions: &[Quaternion],
    constraints: &[Constraint],
    graph: &Graph,
    mistakes: &mut Mistakes,
) -> Vec<usize> {
    let mut rows = Vec::new();
    for quaternion in quaternions {
        if let Some(row) = constraints.iter().position(|constraint| quaternion.is_kept_by(constraint, graph)) {
            rows.push(row);
        } else {
            let [a, b, c, d] = &quaternion.names;
            mistakes.add(quaternion.place.error(format!(
                "no constraint keeps the norm of this quaternion at 1; add \
                 `constraints {{ {a}_norm: {a}^2 + {b}^2 + {c}^2 + {d}^2 = 1; }}`"
            )));
        }
    }
    rows.sort_unstable();
    rows.dedup();
    rows
}

impl Quaternion {
    /// Whether a constraint holds where the norm is 1 and not where it is 2, tested at some points.
    fn is_kept_by(&self, constraint: &Constraint, graph: &Graph) -> bool {
        let occurring = graph.symbols_of(&[constraint.value]);
        let same = occurring.len() == 4 && self.symbols.iter().all(|symbol| occurring.contains(symbol));
        let at = |k: usize, norm: f64| {
            let direction: [f64; 4] =
                std::array::from_fn(|i| ((4 * k + i + 1) as f64 * 0.618_033_988_75).fract() - 0.4);
            let size = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
            let value = |symbol: Symbol| {
                self.symbols.iter().position(|own| *own == symbol).map_or(f64::NAN, |i| norm * direction[i] / size)
            };
            evaluate(graph, &[constraint.value], value)[0]
        };
        let keeps = |k: usize| at(k, 1.0).abs() < 1e-12 && at(k, 2.0).abs() > 0.1;
        constraint.level == Level::Positions && same && (0..3).all(keeps)
    }
}
