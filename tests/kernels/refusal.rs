//! A pivot that cancellation has taken half of its digits is refused, and the state solved by complete pivoting.

use sim::{Kernel, Results, States, accelerate, erase, mechanism, solve_each};

mechanism! {
    /// Two coordinates along one line: beside `m` at their sum, the pivot of the second is what `small` leaves.
    Shared;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; small [kg] = 1; }
    bodies { sum: mass m at [x + y, 0]; second: mass small at [y, 0]; }
    loads { force m*[1 [m/s^2], 0] at [x + y, 0]; force small*[2 [m/s^2], 0] at [y, 0]; }
    kernels { dynamics_jacobian; dynamics_sensitivity; }
}

#[test]
fn pivots_are_refused_where_half_of_their_digits_are_gone() {
    let (t, q, qd) = (0.0, [0.0; 2], [0.0; 2]);
    for (small, refused) in [(1.0, false), (1e-6, false), (1e-9, true), (1e-20, true), (0.0, true)] {
        let mechanism = Shared { m: 1.0, small };
        assert_eq!(mechanism.dynamics(t, &q, &qd).refused, refused, "{small}");
        assert_eq!(mechanism.dynamics_jacobian(t, &q, &qd).refused, refused, "{small}");
        assert_eq!(mechanism.dynamics_sensitivity(t, &q, &qd).refused, refused, "{small}");
        // With less the masses are those of one coordinate, and there is no solution.
        if small > 1e-15 {
            let solved = accelerate(&mechanism, t, &q, &qd).unwrap();
            // x'' + y'' = 1 and y'' = 2, as far as m + small still knows what small is.
            let tolerance = 4.0 * f64::EPSILON / small;
            assert!((solved.accelerations[1] - 2.0).abs() <= 2.0 * tolerance, "{small}: {:?}", solved.accelerations);
            assert!((solved.accelerations[0] + 1.0).abs() <= 2.0 * tolerance, "{small}: {:?}", solved.accelerations);
        }
    }
}

mechanism! {
    /// A pendulum as a free body of little inertia, its hinge written twice.
    Bob;
    coordinates { x [m]; y [m]; phi [rad]; }
    parameters { m [kg] = 2; I [kg*m^2] = 1e-12; l [m] = 0.5; g [m/s^2] = 9.81; }
    bodies { bob: mass m at [x, y], inertia I, angle phi; }
    loads { gravity [0, -g]; }
    constraints {
        along: x = l*sin(phi);
        down: y = -l*cos(phi);
        again: 2*x = 2*l*sin(phi);
    }
}

/// The kernel refuses redundant constraints at every state, and numbers at states are those of a run: phi'' = -g/l sin(phi)
/// of the pendulum, and of both copies the reactions of least norm. A hinge a little open changes them as little.
#[test]
fn refused_states_are_solved_as_in_a_run() {
    let (m, l, g) = (2.0, 0.5, 9.81);
    let (times, phi, opened) = ([0.0; 3], [0.3f64, 1.2, -2.0], [0.0, 1e-12, -3e-11]);
    let positions: Vec<f64> = (0..3).flat_map(|k| [l * phi[k].sin() + opened[k], -l * phi[k].cos(), phi[k]]).collect();
    let states =
        States { times: &times, positions: &positions, speeds: &[0.0; 9], accelerations: &[], multipliers: &[] };
    let model = erase(Bob::default());
    assert_eq!(model.call_each(Kernel::Dynamics, &states).refused, [0, 1, 2]);
    let Results { numbers, refused, .. } = solve_each(&model, Kernel::Dynamics, &states);
    assert!(refused.is_empty());
    for (k, found) in numbers.chunks(7).enumerate() {
        let angular = -g / l * phi[k].sin();
        // Inertia beside m l^2, rounding, and what the hinge is open.
        let near = |found: f64, right: f64| assert!((found - right).abs() < 1e-9 * g * m, "{k}: {found} {right}");
        near(found[2], angular);
        let pull = m * l * angular * phi[k].cos();
        // along + 2 again = m x'', again = 2 along for the least sum of squares.
        near(found[3].abs(), (pull / 5.0).abs());
        near(found[5].abs(), (2.0 * pull / 5.0).abs());
        near(found[3] + 2.0 * found[5], found[3].signum() * pull.abs());
    }
}

mechanism! {
    /// A point on a circle, whose constraint says nothing in the centre.
    Rod;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 9.81; }
    bodies { bob: mass m at [x, y]; }
    loads { gravity [0, -g]; }
    constraints { length: x^2 + y^2 = l^2; }
}

#[test]
fn states_off_the_constraints_remain_refused() {
    let (times, positions) = ([0.0; 2], [1.0, 0.0, 0.0, 0.0]);
    let states =
        States { times: &times, positions: &positions, speeds: &[0.0; 4], accelerations: &[], multipliers: &[] };
    assert_eq!(solve_each(&erase(Rod::default()), Kernel::Dynamics, &states).refused, [1]);
}
