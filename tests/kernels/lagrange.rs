//! TMT against Lagrange's equations: two derivations from one declaration. Each has its own mass matrix, forces, C_q and
//! convective terms; they share the resolved model, with the velocities that constraints between speeds are written in, and
//! the engine.

use crate::all;
use crate::oracle::OVERCONSTRAINED;
use codegen::dynamics::{EquationsOfMotion, lagrange};
use codegen::symbolic::{Expr, Symbol, evaluate};
use nalgebra::{DMatrix, DVector};
use sim::Description;
use std::collections::HashMap;
use tests::Random;

const STATES: usize = 100;

#[test]
fn both_give_the_same_accelerations() {
    // The redundant constraints of an overconstrained loop make these equations singular.
    for description in all::descriptions().into_iter().filter(|description| description.name != OVERCONSTRAINED) {
        let worst = compare(description);
        println!("{:<20} {worst:.2} eps cond(K) |a|", description.name);
        // Each side accumulates a few roundings in its terms; the solution amplifies them by the condition number.
        assert!(worst < 100.0, "{}: {worst}", description.name);
    }
}

/// The largest difference of the accelerations, relative to eps cond(K) |a|.
fn compare(description: &Description) -> f64 {
    let mut equations = codegen::equations(description.declaration.parse().unwrap()).unwrap();
    let other = lagrange(&mut equations.graph, &equations.model);
    let n = equations.model.coordinates.len();
    let mut random = Random(7);
    let mut worst = 0.0f64;
    for _ in 0..STATES {
        let state = random_state(&equations, &mut random);
        let value = |exprs: &[Expr]| evaluate(&equations.graph, exprs, |symbol| state[&symbol]);
        let active: Vec<bool> = equations
            .model
            .constraints
            .iter()
            .map(|constraint| constraint.activity.is_none_or(|activity| value(&[activity])[0] != 0.0))
            .collect();
        let solve = |mass: Vec<f64>, force: Vec<f64>, jacobian: Vec<f64>, convective: Vec<f64>| {
            let m = active.len();
            let of = |row: usize, x: f64| if active[row] { x } else { 0.0 };
            let mut matrix = DMatrix::from_fn(n + m, n + m, |i, j| match (i < n, j < n) {
                (true, true) => mass[i * n + j],
                (true, false) => of(j - n, jacobian[(j - n) * n + i]),
                (false, true) => of(i - n, jacobian[(i - n) * n + j]),
                (false, false) => 0.0,
            });
            // The multiplier of a released constraint is 0.
            (0..m).filter(|i| !active[*i]).for_each(|i| matrix[(n + i, n + i)] = -1.0);
            let mut rhs = DVector::from_fn(n + m, |i, _| if i < n { force[i] } else { of(i - n, -convective[i - n]) });
            // Units apart, the condition says what the equations themselves amplify.
            let scale: Vec<f64> = matrix.row_iter().map(|row| row.amax().sqrt().recip()).collect();
            for i in 0..n + m {
                matrix.row_mut(i).scale_mut(scale[i]);
                matrix.column_mut(i).scale_mut(scale[i]);
                rhs[i] *= scale[i];
            }
            let singular = matrix.singular_values();
            (matrix.lu().solve(&rhs).unwrap(), singular.max() / singular.min())
        };
        let constraints = &equations.constraints;
        let (tmt, condition) = solve(
            value(&equations.tmt.mass_matrix.concat()),
            value(&equations.tmt.right_hand_side),
            value(&constraints.jacobian.concat()),
            value(&constraints.convective),
        );
        let (lagrange, _) = solve(
            value(&other.mass_matrix.concat()),
            value(&other.right_hand_side),
            value(&other.constraint_jacobian.concat()),
            value(&other.constraint_convective),
        );
        let difference = (&tmt - &lagrange).norm() / (f64::EPSILON * condition * tmt.norm());
        assert!(difference.is_finite(), "{}", description.name);
        worst = worst.max(difference);
    }
    worst
}

/// Random time, coordinates and speeds, and parameters within 20 % of their defaults.
fn random_state(equations: &EquationsOfMotion, random: &mut Random) -> HashMap<Symbol, f64> {
    let model = &equations.model;
    let mut state = HashMap::from([(model.time, random.between(0.0, 2.0))]);
    for c in &model.coordinates {
        state.insert(c.position, random.between(-1.5, 1.5));
        state.insert(c.speed, random.between(-3.0, 3.0));
    }
    for p in &model.parameters {
        let default = evaluate(&equations.graph, &[p.default], |_| f64::NAN)[0];
        state.insert(p.symbol, default * random.between(0.8, 1.2));
    }
    state.extend(model.inputs.iter().map(|input| (input.symbol, random.between(-2.0, 2.0))));
    for conditional in &model.conditionals {
        state.insert(conditional.symbol, random.between(0.0, 2.0).floor());
    }
    state
}
