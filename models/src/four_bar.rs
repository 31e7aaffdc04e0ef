//! The four-bar linkage, a crank-rocker under gravity.
//!
//! Source: own problem, solved in closed form (Freudenstein's equation) and by quadrature of the energy integral.

use mechanism_macros::mechanism;

mechanism! {
    /// Four-bar linkage: crank 2 turns, coupler 3 swings rocker 4. Three uniform slender rods under gravity, let go
    /// with the crank along the ground link at 10 rad/s.
    pub FourBar;

    coordinates {
        /// Angle of crank 2.
        theta2 [rad];
        /// Angle of coupler 3.
        theta3 [rad];
        /// Angle of rocker 4.
        theta4 [rad];
    }

    parameters {
        /// Length of crank 2.
        a [m] = 0.2;
        /// Length of coupler 3.
        b [m] = 0.6;
        /// Length of rocker 4.
        c [m] = 0.5;
        /// Distance of the fixed pivots.
        d [m] = 0.6;
        /// Mass of crank 2.
        m2 [kg] = 2;
        /// Mass of coupler 3.
        m3 [kg] = 4;
        /// Mass of rocker 4.
        m4 [kg] = 3;
        g [m/s^2] = 9.81;
        /// Torque on crank 2.
        T [N*m] = 0;
    }

    let O2 = [0, 0];
    let O4 = [d, 0];
    let u2 = [cos(theta2), sin(theta2)];
    let u3 = [cos(theta3), sin(theta3)];
    let u4 = [cos(theta4), sin(theta4)];
    let A = a*u2;
    let B = O4 + c*u4;
    let G2 = a/2*u2;
    let G3 = A + b/2*u3;
    let G4 = O4 + c/2*u4;
    let weight = [0, g];

    bodies {
        crank2: mass m2 at G2, inertia m2*a^2/12, angle theta2;
        coupler3: mass m3 at G3, inertia m3*b^2/12, angle theta3;
        rocker4: mass m4 at G4, inertia m4*c^2/12, angle theta4;
    }

    loads {
        gravity [0, -g];
        torque T on crank2;
    }

    constraints { closure: A + b*u3 = B; }

    initial {
        theta2 = 0;
        dot(theta2) = 10;
        guess theta3 = 1;
        guess theta4 = 1.7;
    }

    events { period: theta2 = 2*pi; }

    let effort3 = m3*(ddot(G3) + weight);
    let effort2 = m2*(ddot(G2) + weight);
    let effort4 = m4*(ddot(G4) + weight);

    outputs {
        angular_speeds "Angular speeds" {
            /// crank 2
            crank_speed [rad/s] = dot(theta2);
            /// coupler 3
            coupler_speed [rad/s] = dot(theta3);
            /// rocker 4
            rocker_speed [rad/s] = dot(theta4);
        }
        rocker_angle "Angle of rocker 4" {
            /// angle
            rocker [deg] = theta4;
        }
        forces_in_B "Force of coupler 3 on rocker 4, in B" {
            /// along x
            Bx [N] = reaction(closure).x;
            /// along y
            By [N] = reaction(closure).y;
        }
        forces_in_A "Force of crank 2 on coupler 3, in A" {
            /// along x
            Ax [N] = effort3.x + reaction(closure).x;
            /// along y
            Ay [N] = effort3.y + reaction(closure).y;
        }
        forces_in_O2 "Force of the ground on crank 2, in O2" {
            /// along x
            O2x [N] = effort2.x + effort3.x + reaction(closure).x;
            /// along y
            O2y [N] = effort2.y + effort3.y + reaction(closure).y;
        }
        forces_in_O4 "Force of the ground on rocker 4, in O4" {
            /// along x
            O4x [N] = effort4.x - reaction(closure).x;
            /// along y
            O4y [N] = effort4.y - reaction(closure).y;
        }
    }

    drawing {
        ground O2, O4;
        line O2, A, B, O4;
        point G2, G3, G4;
        trace G3;
    }
}
