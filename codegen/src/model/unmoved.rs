//! Rows that contain coordinates but that no coordinate moves, as where a point lies on the axis that its body turns
//! about. Such terms do not always cancel symbolically.
//!
//! A row is evaluated at fixed random points. An analytic expression that does not vary with the coordinates at any of
//! them, to rounding, is almost surely constant (Schwartz, Journal of the ACM 27, 1980).

use super::{Dependence, Dependences};
use crate::symbolic::{Expr, Graph, Rounded, Symbol, evaluate, evaluate_with_rounding, substitute};

/// Values of all parameters, each with this many positions.
const PLACES: usize = 4;
const POSITIONS: usize = 4;

/// The row without coordinates, if none moves it.
pub(super) fn without_coordinates(graph: &mut Graph, dependences: &mut Dependences, row: Expr) -> Option<Expr> {
    let symbols = graph.symbols_of(&[row]);
    let mut coordinates = Vec::new();
    for symbol in &symbols {
        let variable = graph.variable(*symbol);
        if dependences.of(graph, variable).meets(Dependence::COORDINATE) {
            coordinates.push(*symbol);
        }
    }
    let drawn = |symbol: Symbol, place: usize, position: usize| {
        let position = if coordinates.contains(&symbol) { position } else { 0 };
        drawn(symbols.binary_search(&symbol).unwrap_or_default(), place * POSITIONS + position)
    };
    let mut is_zero = true;
    for place in 0..PLACES {
        let mut first = None;
        for position in 0..POSITIONS {
            let found = evaluate_with_rounding(graph, row, |symbol| drawn(symbol, place, position));
            let start: Rounded = *first.get_or_insert(found);
            if !found.is_known() || !((found.value - start.value).abs() <= found.error + start.error) {
                return None;
            }
            is_zero &= found.value.abs() <= found.error;
        }
    }
    let zero = graph.zero();
    if is_zero {
        return Some(zero);
    }
    // A row without a value at 0, such as one with a quaternion, stays as it is.
    let at_zero: Vec<_> = coordinates.iter().map(|symbol| (*symbol, zero)).collect();
    let rest = substitute(graph, &[row], &at_zero)[0];
    let value = evaluate(graph, &[rest], |symbol| drawn(symbol, 0, 0))[0];
    value.is_finite().then_some(rest)
}

/// A pseudo-random number between 1/2 and 3/2 for each symbol and point.
fn drawn(symbol: usize, place: usize) -> f64 {
    const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
    let mut bits = (symbol as u64 + 1).wrapping_mul(GOLDEN) ^ (place as u64 + 1);
    for shift in [30, 27, 31] {
        bits = (bits ^ (bits >> shift)).wrapping_mul(GOLDEN);
    }
    0.5 + (bits >> 11) as f64 / (1u64 << 53) as f64
}
