//! The derivatives of the motion from dual numbers, for mechanisms without kernels for them: `dynamics` once for each
//! variable.

use crate::{Array, Dual, Dynamics, DynamicsJacobian, DynamicsSensitivity, Mask, Mechanism, Scalar};

type InDuals<S, M> = <M as Mechanism<S>>::On<Dual<S>>;
type Q<S, M> = <InDuals<S, M> as Mechanism<Dual<S>>>::Q;
type L<S, M> = <InDuals<S, M> as Mechanism<Dual<S>>>::L;
type Solution<S, M> = Dynamics<Dual<S>, Q<S, M>, L<S, M>>;

/// d(q'', lambda)/d(q, q').
pub(crate) fn jacobian<S: Scalar, M: Mechanism<S>>(
    mechanism: &M,
    t: S,
    q: &M::Q,
    qd: &M::Q,
) -> DynamicsJacobian<S, M::QQ, M::LQ> {
    let prepared = mechanism.on(Dual::constant).prepare();
    let [q, qd] = [q, qd].map(|values| Q::<S, M>::with_len(values.len(), |i| Dual::constant(values[i])));
    let solve = |q: &Q<S, M>, qd: &Q<S, M>| InDuals::<S, M>::prepared_dynamics(&prepared, Dual::constant(t), q, qd);
    let (n, m) = (mechanism.n(), mechanism.m());
    let zero = M::Q::repeat(n, S::from_f64(0.0));
    let mut found = DynamicsJacobian {
        accelerations_by_positions: M::QQ::repeat(n, zero.clone()),
        accelerations_by_speeds: M::QQ::repeat(n, zero.clone()),
        multipliers_by_positions: M::LQ::repeat(m, zero.clone()),
        multipliers_by_speeds: M::LQ::repeat(m, zero),
        refused: S::Mask::NONE,
    };
    for j in 0..n {
        let by_position = solve(&varied(&q, j), &qd);
        enter::<S, M, M::Q, _, _>(
            &by_position,
            j,
            &mut found.accelerations_by_positions,
            &mut found.multipliers_by_positions,
        );
        let by_speed = solve(&q, &varied(&qd, j));
        enter::<S, M, M::Q, _, _>(&by_speed, j, &mut found.accelerations_by_speeds, &mut found.multipliers_by_speeds);
        found.refused = found.refused | by_position.refused;
    }
    found
}

/// d(q'', lambda)/d(parameters).
pub(crate) fn sensitivity<S: Scalar, M: Mechanism<S>>(
    mechanism: &M,
    t: S,
    q: &M::Q,
    qd: &M::Q,
) -> DynamicsSensitivity<S, M::QP, M::LP> {
    let [q, qd] = [q, qd].map(|values| Q::<S, M>::with_len(values.len(), |i| Dual::constant(values[i])));
    let constant = mechanism.on(Dual::constant);
    let parameters = constant.parameters();
    let zero = M::Parameters::repeat(parameters.len(), S::from_f64(0.0));
    let mut found = DynamicsSensitivity {
        accelerations: M::QP::repeat(mechanism.n(), zero.clone()),
        multipliers: M::LP::repeat(mechanism.m(), zero),
        refused: S::Mask::NONE,
    };
    for j in 0..parameters.len() {
        let solved = constant.with_parameters(varied(&parameters, j));
        let solved = solved.dynamics(Dual::constant(t), &q, &qd);
        enter::<S, M, M::Parameters, _, _>(&solved, j, &mut found.accelerations, &mut found.multipliers);
        found.refused = found.refused | solved.refused;
    }
    found
}

/// The same numbers, with one as the variable of differentiation.
fn varied<S: Scalar, A: Array<Dual<S>>>(values: &A, j: usize) -> A {
    let mut values = values.clone();
    values[j] = Dual::variable(values[j].value);
    values
}

/// Enters the derivatives of a solution as a column.
fn enter<S: Scalar, M: Mechanism<S>, Row: Array<S>, A: Array<Row>, B: Array<Row>>(
    solved: &Solution<S, M>,
    j: usize,
    accelerations: &mut A,
    multipliers: &mut B,
) {
    for i in 0..accelerations.len() {
        accelerations[i][j] = solved.accelerations[i].derivative;
    }
    for i in 0..multipliers.len() {
        multipliers[i][j] = solved.multipliers[i].derivative;
    }
}
