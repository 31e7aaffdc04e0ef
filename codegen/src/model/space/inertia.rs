//! Inertia tensors, about the centre of mass and in the frame of the body.

use crate::dsl::{Expression, Kind};
use crate::model::inertial::inertial;
use crate::model::interpreter::Interpreter;
use crate::model::{Dependence, Dimension, Tensor};
use crate::symbolic::{Expr, evaluate};

const FORM: &str = "the inertia of a body in space is `inertia [A, B, C]`, its principal moments, or \
                    `inertia [Jxx, Jyy, Jzz, Jxy, Jxz, Jyz]`, in its own frame about its centre of mass";

/// A tensor by its principal moments, or by the entries of its matrix.
///
/// `unchecked` takes tensors that no body can have, as files of robots hold them.
pub(in crate::model) fn resolve_inertia(
    expression: &Expression,
    unchecked: bool,
    interpreter: &mut Interpreter,
) -> Option<Tensor> {
    let Kind::Vector(written) = &expression.kind else { return interpreter.refuse(expression.region, FORM) };
    if ![3, 6].contains(&written.len()) {
        return interpreter.refuse(expression.region, format!("{} numbers are given; {FORM}", written.len()));
    }
    let mut entries = Vec::new();
    for (at, entry) in written.iter().enumerate() {
        let value = interpreter.scalar_of(entry, &Dimension::inertia(), "an inertia");
        // Products of inertia have either sign.
        entries.push(value.and_then(|value| {
            if at < 3 && !unchecked { inertial(entry, value, interpreter) } else { fixed(entry, value, interpreter) }
        }));
    }
    let entries: Vec<Expr> = entries.into_iter().collect::<Option<_>>()?;
    let zero = interpreter.graph.zero();
    let entry = |k: usize| entries.get(k).copied().unwrap_or(zero);
    let tensor = Tensor { moments: [entry(0), entry(1), entry(2)], products: [entry(5), entry(4), entry(3)] };
    if !unchecked {
        check(expression, &tensor, interpreter)?;
    }
    Some(tensor)
}

fn fixed(expression: &Expression, value: Expr, interpreter: &mut Interpreter) -> Option<Expr> {
    let moving = crate::model::level::MOVING.or(Dependence::TIME).or(Dependence::INPUT);
    let rule = "an inertia is made of numbers and parameters; it cannot change with the motion";
    interpreter.restrict(expression.region, &[value], moving, rule)?;
    Some(value)
}

/// Refuses numeric tensors that no body can have.
fn check(expression: &Expression, tensor: &Tensor, interpreter: &mut Interpreter) -> Option<()> {
    let entries = tensor.entries();
    if entries.iter().any(|entry| interpreter.dependences.of(&interpreter.graph, *entry) != Dependence::NONE) {
        return Some(());
    }
    let values = evaluate(&interpreter.graph, &entries, |_| f64::NAN);
    let values = [values[0], values[1], values[2], values[3], values[4], values[5]];
    match impossible_inertia(values) {
        Some(why) => interpreter.refuse(expression.region, why),
        None => Some(()),
    }
}

/// The reason why no body can have the inertia xx, yy, zz, yz, zx, xy, if none can.
///
/// The second moments of the mass distribution, the eigenvalues of tr(J)/2 - J, are not negative; nor are those of J,
/// which are their sums. A moment of 0 belongs to a body without extent across its axis.
pub fn impossible_inertia(tensor: [f64; 6]) -> Option<String> {
    let [xx, yy, zz, ..] = tensor;
    let size = xx.abs().max(yy.abs()).max(zz.abs());
    let tolerance = 1e-12 * size;
    if !is_semidefinite(tensor, tolerance) {
        return Some("about some axis this inertia is negative".into());
    }
    let half = (xx + yy + zz) / 2.0;
    let [.., yz, zx, xy] = tensor;
    let masses = [half - xx, half - yy, half - zz, -yz, -zx, -xy];
    (!is_semidefinite(masses, tolerance)).then(|| {
        let largest = if tensor[3..].iter().all(|product| *product == 0.0) {
            let [small, middle, large] = sorted([xx, yy, zz]);
            format!(": {large} is more than {small} + {middle}")
        } else {
            String::new()
        };
        format!(
            "no body has this inertia: a principal moment is at most the sum of the other two{largest} (is it about the \
             centre of mass, in [kg*m^2]?)"
        )
    })
}

fn sorted(mut values: [f64; 3]) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    values
}

/// Whether all principal minors of a symmetric matrix xx, yy, zz, yz, zx, xy are positive or zero.
fn is_semidefinite([xx, yy, zz, yz, zx, xy]: [f64; 6], tolerance: f64) -> bool {
    let size = xx.abs().max(yy.abs()).max(zz.abs());
    let ones = [xx, yy, zz].iter().all(|x| *x >= -tolerance);
    let twos = [xx * yy - xy * xy, yy * zz - yz * yz, zz * xx - zx * zx].iter().all(|x| *x >= -tolerance * size);
    let three = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * zx) + zx * (xy * yz - yy * zx);
    ones && twos && three >= -tolerance * size * size
}
