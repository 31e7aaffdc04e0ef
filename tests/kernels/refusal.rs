//! A pivot that cancellation has taken half of its digits is refused, and the state solved by complete pivoting.

use sim::{accelerate, mechanism};

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
