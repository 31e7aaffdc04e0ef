//! A chain of n slender rods that hangs from one end.
//!
//! Source: classical; M_ij = m l^2 (n + 1/2 - max(i, j)) cos(phi_i - phi_j) beside the diagonal, M_ii = m l^2 (n + 1/3 - i).

use mechanism_macros::mechanism;

mechanism! {
    /// A chain of five equal slender rods, let go from the side.
    pub HangingChain;

    const n = 5;

    coordinates {
        repeat i in 1..=n {
            /// Angle of rod {i} from the vertical.
            phi_[i] [rad];
        }
    }

    parameters {
        /// Length of each rod.
        l [m] = 0.3;
        /// Mass of each rod.
        m [kg] = 0.2;
        /// Angle of all rods at the start.
        start [deg] = 60;
        g [m/s^2] = 9.81;
    }

    let P_[0] = [0, 0];
    repeat i in 1..=n {
        let u_[i] = [sin(phi_[i]), -cos(phi_[i])];
        let P_[i] = P_[i-1] + l*u_[i];
        bodies { rod_[i]: mass m at P_[i] - l/2*u_[i], inertia m*l^2/12, angle phi_[i]; }
    }

    loads { gravity [0, -g]; }
    initial { repeat i in 1..=n { phi_[i] = start; } }

    outputs {
        angles "Angles of the rods" {
            repeat i in 1..=n {
                /// rod {i}
                angle_[i] [deg] = phi_[i];
            }
        }
        tip "Speed of the tip" {
            /// speed
            tip_speed [m/s] = norm(dot(P_[n]));
        }
        energy "Potential energy" {
            /// zero at the support
            potential [J] = m*g*sum(i in 1..=n, P_[i].y - l/2*u_[i].y);
        }
    }

    drawing {
        ground P_[0];
        repeat i in 1..=n { line P_[i-1], P_[i]; }
        repeat i in 1..n { point P_[i]; }
    }
}
