//! The offset slider-crank.
//!
//! Source: own problem; x = r cos theta + sqrt(l^2 - (r sin theta - offset)^2) is classical.

use mechanism_macros::mechanism;

mechanism! {
    /// Offset slider-crank: crank, connecting rod and piston under gravity, let go with the crank along the guide
    /// at 20 rad/s.
    pub SliderCrank;

    coordinates {
        /// Angle of the crank.
        theta [rad];
        /// Angle of the rod.
        phi [rad];
    }

    parameters {
        /// Length of the crank.
        r [m] = 0.15;
        /// Length of the rod.
        l [m] = 0.45;
        /// Height of the guide.
        offset [m] = 0.03;
        /// Mass of the crank, a slender rod.
        m1 [kg] = 1;
        /// Mass of the rod, slender.
        m2 [kg] = 2;
        /// Mass of the piston.
        m3 [kg] = 1.5;
        g [m/s^2] = 9.81;
        /// Torque on the crank.
        T [N*m] = 0;
    }

    let O = [0, 0];
    let A = r*[cos(theta), sin(theta)];
    let rod = [cos(phi), sin(phi)];
    let C = A + l*rod;

    bodies {
        crank: mass m1 at A/2, inertia m1*r^2/12, angle theta;
        connecting_rod: mass m2 at A + l/2*rod, inertia m2*l^2/12, angle phi;
        piston: mass m3 at C;
    }

    loads {
        gravity [0, -g];
        torque T on crank;
    }

    constraints { guide: C.y = offset; }

    initial {
        theta = 0;
        dot(theta) = 20;
        guess phi = 0.07;
    }

    events {
        period: theta = 2*pi;
        /// The piston turns back.
        dead_point: dot(C.x) = 0;
    }

    outputs {
        angular_speeds "Angular speeds" {
            /// crank
            crank_speed [rad/s] = dot(theta);
            /// rod
            rod_speed [rad/s] = dot(phi);
        }
        piston_position "Position of the piston" {
            /// position
            x [m] = C.x;
        }
        piston_velocity "Velocity of the piston" {
            /// velocity
            x_velocity [m/s] = dot(C.x);
        }
        piston_acceleration "Acceleration of the piston" {
            /// acceleration
            x_acceleration [m/s^2] = ddot(C.x);
        }
        wall "Force of the wall on the piston" {
            /// along +y
            wall_force [N] = -reaction(guide);
        }
    }

    drawing {
        ground O;
        line O, A, C;
        slider C along 0;
    }
}
