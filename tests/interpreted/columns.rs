//! Derivatives of a tree of so many joints that they are solved in a loop over their columns.

use crate::link_derivatives::derivatives_are_those_of_dynamics;
use sim::{erase, mechanism};
use tests::same_bits::{differences, interpreted};

mechanism! {
    /// Three limbs of seven joints on a body that moves freely. All angles are zero at first.
    pub Spider;
    parameters { L [m] = 1; m [kg] = 1; c [N*m*s] = 0.1; }
    bodies { base: free, mass 5*m, inertia [0.3*m*L^2, 0.4*m*L^2, 0.35*m*L^2]; }
    fragment Limb(turn) {
        coordinates { j_1 [rad]; j_2 [rad]; j_3 [rad]; j_4 [rad]; j_5 [rad]; j_6 [rad]; j_7 [rad]; }
        let A = attitude(base)*rotation(z, turn)*rotation(y, j_1);
        let B = A*rotation(x, j_2);
        let C = B*rotation(x, j_3);
        let D = C*rotation(y, j_4);
        let E = D*rotation(x, j_5);
        let F = E*rotation(x, j_6);
        let G = F*rotation(z, j_7);
        let PA = on(base, [0, 0, -0.1*L]) + attitude(base)*rotation(z, turn)*[0.3*L, 0, 0];
        let PB = PA + A*[0, 0.1*L, 0];
        let PC = PB + B*[0, 0, -0.3*L];
        let PD = PC + C*[0, 0, -0.3*L];
        let PE = PD + D*[0, 0, -0.1*L];
        let PF = PE + E*[0, 0, -0.2*L];
        let PG = PF + F*[0, 0, -0.1*L];
        bodies {
            one: mass 0.2*m at PA + A*[0, 0.05*L, 0], inertia [0.002*m*L^2, 0.001*m*L^2, 0.002*m*L^2], attitude A;
            two: mass 0.6*m at PB + B*[0, 0, -0.15*L], inertia [0.006*m*L^2, 0.005*m*L^2, 0.002*m*L^2], attitude B;
            three: mass 0.4*m at PC + C*[0.01*L, 0, -0.15*L], inertia [0.004*m*L^2, 0.005*m*L^2, 0.002*m*L^2], attitude C;
            four: mass 0.1*m at PD + D*[0, 0, -0.05*L], inertia [0.001*m*L^2, 0.002*m*L^2, 0.001*m*L^2], attitude D;
            five: mass 0.2*m at PE + E*[0, 0.02*L, -0.1*L], inertia [0.002*m*L^2, 0.003*m*L^2, 0.002*m*L^2], attitude E;
            six: mass 0.2*m at PF + F*[0, 0, -0.05*L], inertia [0.002*m*L^2, 0.001*m*L^2, 0.001*m*L^2], attitude F;
            seven: mass 0.1*m at PG + G*[0.05*L, 0, -0.05*L], inertia [0.001*m*L^2, 0.0015*m*L^2, 0.001*m*L^2], attitude G;
        }
        loads { torque -c*dot(j_3) on j_3; }
    }
    use Limb(0) as left;
    use Limb(2 [rad]) as right;
    use Limb(4 [rad]) as hind;
    loads { gravity [0, 0, -9.81 [m/s^2]]; }
    kernels { dynamics_jacobian; }
}

#[test]
fn columns_have_the_same_bits() {
    let compiled = erase(Spider::default());
    let interpreted = interpreted(&*compiled).unwrap();
    assert_eq!(differences(&*compiled, &*interpreted, 3, 2), Vec::<String>::new());
}

#[test]
fn derivatives_by_columns() {
    let text = &erase(Spider::default()).description().declaration;
    derivatives_are_those_of_dynamics(text, &[0, 1, 2]);
    // In straight lines, where a limb follows the base that another one moves.
    let two_limbs = text.replace("use Limb(4 [rad]) as hind;", "");
    assert_ne!(&two_limbs, text);
    derivatives_are_those_of_dynamics(&two_limbs, &[0, 1, 2]);
}

/// A base that loads tell where it is.
#[test]
fn derivatives_with_loads_on_everything() {
    let text = &erase(Spider::default()).description().declaration;
    let gravity = "loads { gravity [0, 0, -9.81 [m/s^2]]; }";
    assert!(text.contains(gravity));
    let loads = "loads {
        gravity [0.3 [m/s^2]*sin(t/(1 [s])), 0, -9.81 [m/s^2]];
        force [0, 1 [N*s]*sin(left_j_1)*dot(hind_j_2), 2 [N]*hind_j_3] at on(base, [0.1*L, 0, 0]);
        torque [0.1 [N*m]*left_j_4, 0, 0.2 [N*m]*right_j_2] on left_four;
    }";
    derivatives_are_those_of_dynamics(&text.replace(gravity, loads), &[0, 1, 2]);
}
