//! Kernels on dual numbers give the derivatives that other kernels are.

use crate::all::all_mechanisms;
use sim::{Array, Compiled, Dual, FixedArray, Lanes, Mechanism, Scalar};
use tests::Random;

type OnDual<M> = <M as Mechanism>::On<Dual>;
type DualQ<M> = <OnDual<M> as Mechanism<Dual>>::Q;

/// Both round the same few products; the sum of magnitudes is that of ordinary parameters and states.
const TOLERANCE: f64 = 1e-11;

#[test]
fn derivatives_are_the_kernels_of_derivatives() {
    macro_rules! check_all {
        ($($model:ty),*) => { $(check::<$model>();)* };
    }
    all_mechanisms!(check_all);
}

fn check<M: Compiled>() {
    let mut random = Random(8);
    let mechanism = M::defaults();
    let dual = mechanism.on(Dual::constant);
    let between_speeds = |row: usize| M::DESCRIPTION.speed_constraints.contains(&row);
    for _ in 0..100 {
        let t = random.between(0.0, 2.0);
        let [q, qd, qdd] = [1.2, 3.0, 9.0].map(|size| M::Q::from_fn(|_| random.between(-size, size)));
        let jacobian = mechanism.constraint_jacobian(t, &q);
        for j in 0..M::Q::LEN {
            let along = DualQ::<M>::with_len(M::Q::LEN, |i| Dual { value: q[i], derivative: f64::from(i == j) });
            let column = M::L::from_fn(|i| if between_speeds(i) { 0.0 } else { jacobian[i][j] });
            close::<M>("C_q", dual.constraints(Dual::constant(t), &along).as_ref(), column.as_ref());
        }
        let constant = |values: &M::Q| DualQ::<M>::with_len(M::Q::LEN, |i| Dual::constant(values[i]));
        let by_time = dual.constraints(Dual::variable(t), &constant(&q));
        let drift = mechanism.constraint_time_derivative(t, &q);
        let drift = M::L::from_fn(|i| if between_speeds(i) { 0.0 } else { drift[i] });
        close::<M>("C_t", by_time.as_ref(), drift.as_ref());
        // Along the motion: q changes as q', and q' as q''.
        let moving = |values: &M::Q, rates: &M::Q| {
            DualQ::<M>::with_len(M::Q::LEN, |i| Dual { value: values[i], derivative: rates[i] })
        };
        let (moving_q, moving_qd) = (moving(&q, &qd), moving(&qd, &qdd));
        // C' = C_q q' + C_t, or w, changes as C_q q'' and the convective terms say.
        let along = dual.constraint_jacobian(Dual::variable(t), &moving_q);
        let drifting = dual.constraint_time_derivative(Dual::variable(t), &moving_q);
        let rates: Vec<Dual> = (0..M::L::LEN)
            .map(|i| (0..M::Q::LEN).fold(drifting[i], |sum, j| sum + along[i][j] * moving_qd[j]))
            .collect();
        let convective = mechanism.constraint_convective(t, &q, &qd);
        let accelerated = |i: usize| (0..M::Q::LEN).map(|j| jacobian[i][j] * qdd[j]).sum::<f64>() + convective[i];
        close::<M>("C''", &rates, M::L::from_fn(accelerated).as_ref());
        let lambda = <OnDual<M> as Mechanism<Dual>>::L::repeat(M::L::LEN, Dual::constant(0.0));
        let outputs = dual.outputs(Dual::variable(t), &moving_q, &moving_qd, &constant(&qdd), &lambda);
        let rated: Vec<Dual> = M::DESCRIPTION.rated_outputs.iter().map(|i| outputs[*i]).collect();
        close::<M>("output rates", &rated, mechanism.output_rates(t, &q, &qd, &qdd).as_ref());
    }
}

fn close<M: Compiled>(kernel: &str, found: &[Dual], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    let size = expected.iter().filter(|x| x.is_finite()).fold(1.0f64, |size, x| size.max(x.abs()));
    for (found, expected) in found.iter().zip(expected) {
        let undefined = !found.derivative.is_finite() && !expected.is_finite();
        let name = M::DESCRIPTION.name;
        assert!(
            undefined || (found.derivative - expected).abs() <= TOLERANCE * size,
            "{name}, {kernel}: {} {expected}",
            found.derivative
        );
    }
}

/// d/dx of the dynamics on dual numbers is what central differences approach: values, masks and all.
#[test]
fn dynamics_runs_on_dual_numbers_and_on_dual_lanes() {
    let mechanism = models::QuickReturn::default();
    let (q, qd) = ([0.4, 1.1, 2.5], [3.0, 0.4, -0.2]);
    let dual = mechanism.on(Dual::constant);
    let along = [Dual::variable(q[0]), Dual::constant(q[1]), Dual::constant(q[2])];
    let found = dual.dynamics(Dual::constant(0.0), &along, &qd.map(Dual::constant));
    let at = |alpha: f64| mechanism.dynamics(0.0, &[alpha, q[1], q[2]], &qd).accelerations;
    let (before, after) = (at(q[0] - 1e-5), at(q[0] + 1e-5));
    assert!(!found.refused);
    for i in 0..3 {
        let difference = (after[i] - before[i]) / 2e-5;
        assert_eq!(found.accelerations[i].value.to_bits(), at(q[0])[i].to_bits());
        // The error of the difference is about h^2 times third derivatives.
        assert!((found.accelerations[i].derivative - difference).abs() < 1e-6 * (1.0 + difference.abs()));
    }
    // One dual number in each lane.
    let lanes = mechanism.on(|parameter| Dual::constant(Lanes::<4>::from_f64(parameter)));
    let number = |x: f64, rate: f64| Dual { value: Lanes::<4>::from_f64(x), derivative: Lanes::from_f64(rate) };
    let in_lanes = lanes.dynamics(
        number(0.0, 0.0),
        &[number(q[0], 1.0), number(q[1], 0.0), number(q[2], 0.0)],
        &qd.map(|speed| number(speed, 0.0)),
    );
    for lane in 0..4 {
        assert_eq!(in_lanes.accelerations[1].derivative.lane(lane), found.accelerations[1].derivative);
    }
}

#[test]
fn kinks_have_the_derivatives_that_are_documented() {
    let x = Dual::variable;
    assert_eq!([x(-2.0).abs(), x(0.0).abs(), x(3.0).abs()].map(|x| x.derivative), [-1.0, 0.0, 1.0]);
    assert_eq!([x(-2.0).sign(), x(0.0).sign()], [Dual::constant(-1.0), Dual::constant(0.0)]);
    assert_eq!(x(0.0).sqrt().derivative, f64::INFINITY);
    // A constant exponent leaves the logarithm out; a changing one needs it.
    assert_eq!(x(0.0).powf(Dual::constant(2.0)).derivative, 0.0);
    assert_eq!(x(-3.0).powf(Dual::constant(2.0)).derivative, -6.0);
    assert_eq!(Dual::constant(2.0).powf(x(3.0)).derivative, 8.0 * 2f64.ln());
    assert!(x(-3.0).powf(x(2.0)).derivative.is_nan());
}
