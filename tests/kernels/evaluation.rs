//! The kernels that the oracle does not know, against evaluation of the expressions that they were made from.

use crate::all::all_mechanisms;
use codegen::dynamics::EquationsOfMotion;
use codegen::model::{Shape, Start};
use codegen::symbolic::{Expr, Symbol, evaluate};
use sim::{Array, Compiled, FixedArray};
use std::collections::HashMap;
use tests::Random;

#[test]
fn kernels_are_their_expressions() {
    macro_rules! check_all {
        ($($model:ty),*) => { $(check::<$model>();)* };
    }
    all_mechanisms!(check_all);
}

fn check<M: Compiled>() {
    let equations = codegen::equations(M::DESCRIPTION.declaration.parse().unwrap()).unwrap();
    let mut random = Random(3);
    for _ in 0..100 {
        let t = random.between(0.0, 2.0);
        let [q, qd, qdd] = [1.2, 3.0, 9.0].map(|size| M::Q::from_fn(|_| random.between(-size, size)));
        let defaults = M::defaults().parameters();
        let mechanism =
            M::defaults().with_parameters(M::Parameters::from_fn(|i| defaults[i] * random.between(0.8, 1.2)));
        let values = values::<M>(&equations, &mechanism, t, [&q, &qd, &qdd]);
        let agree = |kernel: &str, found: &[f64], exprs: &[Expr]| {
            let expected = evaluate(&equations.graph, exprs, |symbol| values[&symbol]);
            assert_eq!(found.len(), expected.len(), "{kernel}");
            // Both round the same few operations; the largest entry stands for the size of what cancels.
            let size = expected.iter().filter(|x| x.is_finite()).fold(1.0f64, |size, x| size.max(x.abs()));
            for (found, expected) in found.iter().zip(&expected) {
                let undefined = !found.is_finite() && !expected.is_finite();
                assert!(undefined || (found - expected).abs() < 1e-12 * size, "{kernel}: {found} {expected}");
            }
        };
        let rates: Vec<Expr> = equations.outputs.rates.iter().flatten().copied().collect();
        agree("output rates", mechanism.output_rates(t, &q, &qd, &qdd).as_ref(), &rates);
        agree("magnitudes", mechanism.constraint_magnitudes(t, &q).as_ref(), &equations.constraints.magnitudes);
        agree("drawing", mechanism.drawing(t, &q).as_ref(), &drawing(&equations));
        let initial = mechanism.initial();
        for (i, c) in equations.model.coordinates.iter().enumerate() {
            if let Start::Given(value) | Start::Guess(value) = c.start {
                agree("start", &[initial.positions[i]], &[value]);
            }
            agree("start speed", &[initial.speeds[i]][..c.start_speed.iter().len()], c.start_speed.as_slice());
        }
    }
}

fn values<M: Compiled>(
    equations: &EquationsOfMotion,
    mechanism: &M,
    t: f64,
    [q, qd, qdd]: [&M::Q; 3],
) -> HashMap<Symbol, f64> {
    let model = &equations.model;
    let parameters = mechanism.parameters();
    let mut values = HashMap::from([(model.time, t)]);
    values.extend(model.parameters.iter().zip(parameters.iter()).map(|(p, value)| (p.symbol, *value)));
    for (i, c) in model.coordinates.iter().enumerate() {
        values.extend([(c.position, q[i]), (c.speed, qd[i]), (c.acceleration, qdd[i])]);
    }
    for input in &model.inputs {
        let course = evaluate(&equations.graph, &[input.course], |symbol| values[&symbol])[0];
        values.insert(input.symbol, course);
    }
    values
}

fn drawing(equations: &EquationsOfMotion) -> Vec<Expr> {
    let shapes = equations.model.drawing.iter();
    shapes
        .flat_map(|shape| match shape {
            Shape::Points(_, points) => points.concat(),
            Shape::Slider(at, along) => [at.as_slice(), along].concat(),
            Shape::Circle(at, radius, normal) => [at.as_slice(), &[*radius], normal].concat(),
        })
        .collect()
}
