//! Chains of free bodies, whose rows of C_q are stored by the entries that need not be 0.

use sim::{
    Array, Compiled, FixedArray, Measures, Method, Rows, Settings, project, project_positions, project_velocities,
};
use tests::engine::Engine;
use tests::{Random, any_model, run_with};

sim::mechanism! {
    /// Twelve rods that hang from the ground, each a free body.
    pub Free;
    const n = 12;
    parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 9.81; }
    let P_[0] = [0, 0];
    repeat i in 1..=n {
        bodies { rod_[i]: free, mass m, inertia m*l^2/12; }
        let P_[i] = on(rod_[i], [l/2, 0]);
        joints { pin_[i]: pin P_[i-1] to on(rod_[i], [-l/2, 0]); }
        initial { rod_[i]_phi = 0.1*i; guess rod_[i]_x = i*l; }
    }
    loads { gravity [0, -g]; }
}

sim::mechanism! {
    /// The same, its pins declared in another order.
    pub Shuffled;
    const n = 12;
    parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 9.81; }
    let P_[0] = [0, 0];
    repeat i in 1..=n {
        bodies { rod_[i]: free, mass m, inertia m*l^2/12; }
        let P_[i] = on(rod_[i], [l/2, 0]);
        initial { rod_[i]_phi = 0.1*i; guess rod_[i]_x = i*l; }
    }
    repeat i in 1..=6 { joints { odd_[i]: pin P_[2*i-2] to on(rod_[2*i-1], [-l/2, 0]); } }
    repeat i in 1..=6 { joints { even_[i]: pin P_[13-2*i] to on(rod_[14-2*i], [-l/2, 0]); } }
    loads { gravity [0, -g]; }
}

sim::mechanism! {
    /// The same, the first pin declared twice.
    pub Redundant;
    const n = 12;
    parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 9.81; }
    let P_[0] = [0, 0];
    repeat i in 1..=n {
        bodies { rod_[i]: free, mass m, inertia m*l^2/12; }
        let P_[i] = on(rod_[i], [l/2, 0]);
        joints { pin_[i]: pin P_[i-1] to on(rod_[i], [-l/2, 0]); }
        initial { rod_[i]_phi = 0.1*i; guess rod_[i]_x = i*l; }
    }
    joints { again: pin P_[0] to on(rod_[1], [-l/2, 0]); }
    loads { gravity [0, -g]; }
}

sim::mechanism! {
    /// The same in angles.
    pub Angles;
    const n = 12;
    coordinates { repeat i in 1..=n { phi_[i] [rad]; } }
    parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 9.81; }
    let P_[0] = [0, 0];
    repeat i in 1..=n {
        let u_[i] = [cos(phi_[i]), sin(phi_[i])];
        let P_[i] = P_[i-1] + l*u_[i];
        bodies { rod_[i]: mass m at P_[i-1] + l/2*u_[i], inertia m*l^2/12, angle phi_[i]; }
        initial { phi_[i] = 0.1*i; }
    }
    loads { gravity [0, -g]; }
}

sim::mechanism! {
    /// Three parallelograms side by side, each rod a free body.
    pub Parallelograms;
    const N = 3;
    parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 9.81; v [m/s] = 1; }
    bodies {
        repeat i in 0..=N { crank_[i]: free, mass m, inertia m*l^2/12; }
        repeat i in 1..=N { coupler_[i]: free, mass m, inertia m*l^2/12; }
    }
    loads { gravity [0, -g]; }
    joints {
        repeat i in 0..=N { ground_[i]: pin on(crank_[i], [-l/2, 0]) to [i*l, 0]; }
        repeat i in 1..=N {
            start_[i]: pin on(coupler_[i], [-l/2, 0]) to on(crank_[i-1], [l/2, 0]);
            end_[i]: pin on(coupler_[i], [l/2, 0]) to on(crank_[i], [l/2, 0]);
        }
    }
    initial {
        crank_0_phi = pi/2;
        dot(crank_0_phi) = -v/l;
        repeat i in 0..=N { guess crank_[i]_x = i*l; guess crank_[i]_y = l/2; }
        repeat i in 1..=N { guess crank_[i]_phi = pi/2; guess coupler_[i]_x = (i - 1/2)*l; guess coupler_[i]_y = l; }
    }
}

sim::mechanism! {
    /// Their couplers do not turn.
    pub ParallelogramsAlone;
    const N = 3;
    coordinates { crank [rad]; }
    parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 9.81; v [m/s] = 1; }
    let u = l*[cos(crank), sin(crank)];
    bodies {
        repeat i in 0..=N { crank_[i]: mass m at u/2, inertia m*l^2/12, angle crank; }
        repeat i in 1..=N { coupler_[i]: mass m at u; }
    }
    loads { gravity [0, -g]; }
    initial { crank = pi/2; dot(crank) = -v/l; }
}

/// Every entry of C_q that the sparse rows leave out is 0, and they have all others.
fn sparse_entries_are_those_of_c_q<M: Compiled>(mechanism: M) {
    let (rows, mut random) = (M::DESCRIPTION.sparsity, Random(3));
    assert_eq!(rows.len(), M::L::LEN);
    // Two rows for each pin, and each has to do with the next one, or with a crank that all turn with.
    assert!(rows.iter().enumerate().all(|(k, row)| k - row.first <= 3));
    for _ in 0..20 {
        let q = M::Q::from_fn(|_| random.between(-3.0, 3.0));
        let (sparse, mut dense) =
            (mechanism.sparse_linearization(0.0, &q), mechanism.constraint_linearization(0.0, &q));
        assert_eq!(sparse.values.as_ref(), dense.values.as_ref());
        for row in rows {
            for (k, j) in row.columns.iter().enumerate() {
                assert_eq!(sparse.jacobian[row.entries + k], dense.jacobian[row.constraint][*j]);
                dense.jacobian[row.constraint][*j] = 0.0;
            }
        }
        assert!(dense.jacobian.iter().all(|row| row.iter().all(|entry| *entry == 0.0)));
    }
}

#[test]
fn sparse_entries_are_all_of_c_q() {
    sparse_entries_are_those_of_c_q(Free::default());
    sparse_entries_are_those_of_c_q(Shuffled::default());
    sparse_entries_are_those_of_c_q(Engine::default());
}

/// Projection with sparse rows, beside the two projections with dense ones, from states off the constraints.
fn sparse_projection_is_the_dense_one<M: Compiled>(mechanism: M) {
    let start = run_with(mechanism, &Settings { rows: Rows::Even(1), ..Settings::adaptive(Method::Dop853, 0.1, 1e-9) });
    let state = start.unwrap().trajectory.samples[0].state.clone();
    let (measures, mut random) = (Measures::at(&mechanism, 0.0, &state.positions), Random(4));
    for away in [1e-3, 1e-6, 1e-9] {
        let mut sparse = state.clone();
        for j in 0..M::Q::LEN {
            sparse.positions[j] += random.between(-away, away);
            sparse.speeds[j] += random.between(-away, away);
        }
        let mut dense = sparse.clone();
        project(&mechanism, &measures, &mut sparse).unwrap();
        let linear = project_positions(&mechanism, &measures, 0.0, &mut dense.positions).unwrap();
        project_velocities(&mechanism, &measures, &linear, 0.0, &dense.positions, &mut dense.speeds).unwrap();
        let lengths = measures.coordinates();
        for j in 0..M::Q::LEN {
            // Positions meet 1e-12 of the constraints' terms, and the rows' products have a condition of some 1e3. One
            // factorisation may serve both projections here, which leaves 1e-8 of rates up to 1e-5.
            assert!((sparse.positions[j] - dense.positions[j]).abs() < 1e-11 * lengths[j]);
            assert!((sparse.speeds[j] - dense.speeds[j]).abs() < 1e-10 * lengths[j], "{away} {j}");
        }
    }
}

#[test]
fn sparse_projection_is_that_of_dense_rows() {
    sparse_projection_is_the_dense_one(Free::default());
    sparse_projection_is_the_dense_one(Shuffled::default());
    sparse_projection_is_the_dense_one(Free { l: 1e-3, ..Free::default() });
    sparse_projection_is_the_dense_one(Free { l: 100.0, ..Free::default() });
    assert_eq!(Engine::<f64>::DESCRIPTION.common_column, Some(0));
    for l in [1e-3, 1.0, 100.0] {
        sparse_projection_is_the_dense_one(Engine { l, v: f64::sqrt(l), ..Engine::default() });
    }
}

/// The angles at the end of a swing, at a tolerance of 1e-12.
fn swung<M: Compiled>(mechanism: M, end: f64) -> Vec<f64> {
    let settings = Settings::adaptive(Method::Dop853, end, 1e-12);
    let run = any_model::run_with(mechanism, &Settings { rows: Rows::Even(1), ..settings }).unwrap();
    let end = run.trajectory.samples[1].state.clone();
    let angles = (0..M::Q::LEN).filter(|j| M::DESCRIPTION.coordinates[*j].start == sim::sim_kernel::Start::Given);
    angles.map(|j| end.positions[j]).collect()
}

/// 1e-9: a tolerance of 1e-12 in each of some hundred steps, which the motion of twelve rods amplifies.
fn assert_same(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
}

#[test]
fn a_chain_of_free_bodies_swings_as_in_angles() {
    for l in [1e-3, 1.0, 100.0] {
        let end = 0.5 * f64::sqrt(l);
        let expected = swung(Angles { l, ..Angles::default() }, end);
        assert_same(&swung(Free { l, ..Free::default() }, end), &expected);
        assert_same(&swung(Shuffled { l, ..Shuffled::default() }, end), &expected);
    }
}

#[test]
fn a_pin_that_is_there_twice_changes_nothing() {
    assert_same(&swung(Redundant::default(), 0.05), &swung(Angles::default(), 0.05));
}

/// In the flat position the parallelograms could change into crossed linkages. They go straight on, and the run says where
/// that was: a tolerance of 1e-10, and rounding that is multiplied by a thousand beside such a position.
#[test]
fn parallelograms_of_free_bodies_pass_their_flat_position() {
    assert!(!Parallelograms::<f64>::DESCRIPTION.sparsity.is_empty());
    let until = |end: f64| Settings { rows: Rows::Even(1), ..Settings::adaptive(Method::Dop853, end, 1e-10) };
    let angle = |end: f64| {
        let run = any_model::run_with(ParallelogramsAlone::default(), &until(end)).unwrap();
        run.trajectory.samples[1].state.positions[0]
    };
    let run = any_model::run_with(Parallelograms::default(), &until(1.2)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let found = run.trajectory.samples[1].state.positions[2];
    assert!((found - angle(1.2)).abs() < 1e-7, "{found} {}", angle(1.2));
    let passed: Vec<f64> = run.steps.singularities.iter().map(|singularity| singularity.time).collect();
    assert_eq!(passed.len(), 1, "{passed:?}");
    assert!(angle(passed[0]).abs() < 1e-6, "{}", angle(passed[0]));
}
