//! The checker of units against what it is for: an expression that passes has, in every system of base units, the value
//! that its dimension says. Random expressions are read in two systems and their values compared.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod expression;
mod random;

use codegen::model::Resolved;
use codegen::symbolic::{Symbol, evaluate};
use expression::{Dimension, Expression, expression, mutate, unit};
use random::Random;
use std::collections::HashMap;

const EXPRESSIONS: usize = 1000;

/// Names with their dimensions in m, kg and s; the coordinates first.
const NAMES: [(&str, Dimension); 9] = [
    ("x", Dimension([1, 0, 0])),
    ("phi", Dimension([0, 0, 0])),
    ("l", Dimension([1, 0, 0])),
    ("m", Dimension([0, 1, 0])),
    ("T", Dimension([0, 0, 1])),
    ("w", Dimension([0, 0, -1])),
    ("F", Dimension([1, 1, -2])),
    ("k", Dimension([0, 1, -2])),
    ("p", Dimension([0, 0, 0])),
];

/// How large the base units m, kg and s of a system are, as exponents of 2: then rounding scales too.
type System = [i32; 3];

const SI: System = [0, 0, 0];

/// A declaration in which one output is the expression, its numbers as they are in the system.
fn declaration(expression: &Expression, of: Dimension, system: &System, with_units: bool) -> String {
    let unit = |dimension| if with_units { unit(dimension) } else { String::new() };
    let declare = |(name, dimension): &(&str, Dimension), rest: &str| format!("{name}{}{rest}; ", unit(*dimension));
    let coordinates: String = NAMES[..2].iter().map(|name| declare(name, "")).collect();
    let parameters: String = NAMES[2..].iter().map(|name| declare(name, " = 1")).collect();
    format!(
        "Random; coordinates {{ {coordinates} }} parameters {{ {parameters} }}
        bodies {{ body: mass m at [x, 0], inertia m*l^2, angle phi; }}
        outputs {{ out{} = {}; }}",
        unit(of),
        expression.text(system, with_units)
    )
}

fn resolve(text: &str) -> Result<Resolved, Vec<String>> {
    let tokens = text.parse().unwrap();
    let resolved = codegen::parse(tokens).and_then(|declaration| codegen::model::resolve(&declaration));
    resolved.map_err(|mistakes| mistakes.into_iter().map(|mistake| mistake.to_string()).collect())
}

/// The value of the output at a state that is the same in every system.
fn value(Resolved { model, graph, .. }: &Resolved, state: u64, system: &System) -> f64 {
    let mut random = Random(state);
    let mut draw = |dimension: Dimension| random.between(0.3, 2.0) * dimension.size(system);
    let time = Dimension([0, 0, 1]);
    let mut values: HashMap<Symbol, f64> = HashMap::from([(model.time, draw(time))]);
    for (coordinate, (_, dimension)) in model.coordinates.iter().zip(&NAMES) {
        values.insert(coordinate.position, draw(*dimension));
        values.insert(coordinate.speed, draw(dimension.over(time)));
        values.insert(coordinate.acceleration, draw(dimension.over(time).over(time)));
    }
    for (parameter, (_, dimension)) in model.parameters.iter().zip(&NAMES[2..]) {
        values.insert(parameter.symbol, draw(*dimension));
    }
    evaluate(graph, &[model.outputs[0].value], |symbol| values[&symbol])[0]
}

/// Whether the output scales as its dimension says; `None` where it has no value to compare.
fn scales(expression: &Expression, of: Dimension, with_units: bool, seed: u64) -> Option<bool> {
    let mut random = Random(seed);
    // Even powers, so that square roots are exact too.
    let system: System = std::array::from_fn(|_| *random.pick(&[-6, -4, -2, 2, 4, 6]));
    let [here, there] = [SI, system].map(|system| resolve(&declaration(expression, of, &system, with_units)).ok());
    let [here, there] = [value(&here?, seed, &SI), value(&there?, seed, &system)];
    let expected = here * of.size(&system);
    // What is smaller may be the rounding of terms that cancel, and nothing scales whatever its dimension.
    if !expected.is_finite() || !there.is_finite() || here.abs() < 1e-12 {
        return None;
    }
    // Powers of two scale rounding too, but sums may be taken in another order, and differences lose digits.
    Some((there - expected).abs() <= 1e-8 * expected.abs())
}

/// What may be wrong with an expression whose units are not.
fn is_of_numbers(mistake: &str) -> bool {
    ["division by zero", "not a finite real number", "outside the range", "third derivative"]
        .iter()
        .any(|known| mistake.contains(known))
}

#[test]
fn homogeneous_expressions_pass_and_scale() {
    let (mut compared, mut numbers) = (0, 0);
    for seed in 0..EXPRESSIONS as u64 {
        let mut random = Random(seed);
        let of = random.dimension();
        let expression = expression(&mut random, of, 4);
        let text = declaration(&expression, of, &SI, true);
        match resolve(&text) {
            Ok(_) => {
                let scales = scales(&expression, of, true, seed);
                assert_ne!(scales, Some(false), "{text}");
                compared += usize::from(scales.is_some());
            }
            Err(mistakes) => {
                assert!(mistakes.iter().all(|mistake| is_of_numbers(mistake)), "{text}\n{mistakes:?}");
                numbers += 1;
            }
        }
    }
    println!("{compared} of {EXPRESSIONS} compared, {numbers} refused for their numbers");
    assert!(compared > EXPRESSIONS * 8 / 10);
}

/// With one part of another dimension put in, an expression is refused, or it is homogeneous all the same.
#[test]
fn what_is_not_homogeneous_is_refused() {
    let (mut refused, mut for_nothing) = (0, 0);
    for seed in 0..EXPRESSIONS as u64 {
        let mut random = Random(seed);
        let of = random.dimension();
        let original = expression(&mut random, of, 4);
        let expression = mutate(&mut random, original);
        let text = declaration(&expression, of, &SI, true);
        match resolve(&text) {
            Ok(_) => assert_ne!(scales(&expression, of, true, seed), Some(false), "{text}"),
            Err(mistakes) if mistakes.iter().any(|mistake| is_of_numbers(mistake)) => {}
            // Without units nothing is refused, and the values can be compared.
            Err(_) => match scales(&expression, of, false, seed) {
                Some(true) => for_nothing += 1,
                Some(false) => refused += 1,
                None => {}
            },
        }
    }
    println!("{refused} refused, {for_nothing} refused though they scale");
    assert!(refused > EXPRESSIONS / 2 && for_nothing < refused / 20);
}
