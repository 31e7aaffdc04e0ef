//! What numeric evaluation says of its own rounding.

use codegen::symbolic::{Expr, Function, Graph, Symbol, evaluate_with_rounding};

/// sin(2 x) - 2 sin(x) cos(x), which is zero everywhere, though the engine does not know that.
fn nothing(graph: &mut Graph, x: Symbol) -> Expr {
    let (x, two) = (graph.variable(x), graph.integer(2));
    let twice = graph.mul(two, x);
    let (sine, cosine) = (graph.call(Function::Sin, x), graph.call(Function::Cos, x));
    let (whole, half) = (graph.call(Function::Sin, twice), graph.mul(sine, cosine));
    let halves = graph.mul(two, half);
    graph.sub(whole, halves)
}

fn at_places(mut seen: impl FnMut(f64)) {
    (1..=1000).for_each(|k| seen(f64::from(k) * 0.01317));
}

#[test]
fn the_bound_holds_where_all_that_is_left_is_rounding() {
    let mut graph = Graph::new();
    let x = graph.symbol("x");
    let nothing = nothing(&mut graph, x);
    let variable = graph.variable(x);
    let large = graph.integer(1_000_000_000);
    let scaled = graph.mul(large, nothing);
    let squared = graph.integer_power(variable, 2);
    let times = graph.mul(nothing, squared);
    let mut rounded = 0;
    at_places(|at| {
        // What cancels is of this size; an angle `at` has a rounding of its own.
        for (expr, size) in [(nothing, 1.0), (scaled, 1e9), (times, at * at)] {
            let found = evaluate_with_rounding(&graph, expr, |_| at);
            assert!(found.value.abs() <= found.error, "{found:?} at {at}");
            assert!(found.error <= 16.0 * f64::EPSILON * size * (1.0 + at), "{found:?} at {at}");
            assert!(found.is_known(), "{found:?} at {at}");
            rounded += usize::from(found.value != 0.0);
        }
    });
    assert!(rounded > 500, "{rounded} values have any rounding");
}

#[test]
fn what_is_made_of_rounding_is_not_known() {
    let mut graph = Graph::new();
    let (x, y) = (graph.symbol("x"), graph.symbol("y"));
    let (of_x, of_y) = (nothing(&mut graph, x), nothing(&mut graph, y));
    let one = graph.integer(1);
    let made = [
        graph.div(one, of_x),
        graph.div(of_y, of_x),
        graph.atan2(of_y, of_x),
        graph.sqrt(of_x),
        graph.choice(of_x, one, of_y),
    ];
    at_places(|at| {
        for expr in made {
            let found = evaluate_with_rounding(&graph, expr, |symbol| if symbol == x { at } else { 1.7 * at });
            assert!(!found.is_known(), "{found:?} at {at}");
        }
    });
}
