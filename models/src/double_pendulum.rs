//! The double pendulum of two slender bars.
//!
//! Source: Multibody Dynamics B, assignment 6 (a study of integrators), TU Delft, 2019. There gravity acts along +x and
//! angles are from +x; here both are from the vertical, which is the same motion.

use mechanism_macros::mechanism;

mechanism! {
    /// Two equal slender bars, let go from the horizontal.
    pub DoublePendulum;

    coordinates {
        /// Angle of the upper bar from the vertical.
        phi1 [rad];
        /// Angle of the lower bar from the vertical.
        phi2 [rad];
    }

    parameters {
        /// Length of each bar.
        l [m] = 0.6;
        /// Density of the bars.
        rho [kg/m^3] = 670;
        /// Width of the bars.
        width [m] = 0.05;
        /// Thickness of the bars.
        thickness [m] = 0.003;
        g [m/s^2] = 9.81;
    }

    let m = rho*l*width*thickness;
    let u = [sin(phi1), -cos(phi1)];
    let v = [sin(phi2), -cos(phi2)];
    let O = [0, 0];
    let elbow = l*u;
    let tip = elbow + l*v;

    bodies {
        upper: mass m at l/2*u, inertia m*l^2/12, angle phi1;
        lower: mass m at elbow + l/2*v, inertia m*l^2/12, angle phi2;
    }

    loads { gravity [0, -g]; }
    initial { phi1 = pi/2; phi2 = pi/2; }

    outputs {
        angles "Angles of the bars" {
            /// upper bar
            upper_angle [rad] = phi1;
            /// lower bar
            lower_angle [rad] = phi2;
        }
        tip_speed "Speed of the tip" {
            /// speed
            speed [m/s] = norm(dot(tip));
        }
        energy "Energy" {
            /// potential energy, zero at the support
            potential [J] = m*g*(l/2*u.y + elbow.y + l/2*v.y);
        }
    }

    drawing {
        ground O;
        line O, elbow, tip;
        point elbow;
    }
}
