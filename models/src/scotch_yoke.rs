//! The Scotch yoke, a crank whose pin slides in a straight slot.
//!
//! Source: classical; x = r cos alpha exactly, and the speed follows from the energy.

use mechanism_macros::mechanism;

mechanism! {
    /// Scotch yoke: the pin of a crank with its flywheel drives a yoke along a guide. It turns freely, faster where the
    /// yoke is slow.
    pub ScotchYoke;

    coordinates {
        /// Angle of the crank.
        alpha [rad];
        /// Displacement of the yoke.
        x [m];
    }

    parameters {
        /// Radius of the crank.
        r [m] = 0.1;
        /// Inertia of the crank and its flywheel.
        J [kg*m^2] = 0.02;
        /// Mass of the yoke.
        m [kg] = 3;
        /// Half the length of the slot, for drawings.
        h [m] = 0.13;
        /// Length of the rod on the yoke, for drawings.
        s [m] = 0.25;
    }

    let O = [0, 0];
    let A = r*[cos(alpha), sin(alpha)];
    let yoke = [x, 0];
    let rod = yoke + [s, 0];

    bodies {
        crank: inertia J, angle alpha;
        yoke: mass m at yoke;
    }

    constraints { slot: A.x = x; }

    initial {
        alpha = 0;
        dot(alpha) = 120 [rpm];
    }

    events {
        period: alpha = 2*pi;
        /// The yoke turns back.
        dead_point: dot(x) = 0;
    }

    outputs {
        crank_speed "Speed of the crank" {
            /// speed
            speed [rpm] = dot(alpha);
        }
        yoke_position "Displacement of the yoke" {
            /// displacement
            displacement [mm] = x;
        }
        slot_force "Force of the pin on the slot" {
            /// along x
            force [N] = reaction(slot);
        }
    }

    drawing {
        ground O;
        circle O radius r;
        line O, A;
        line yoke - [0, h], yoke + [0, h];
        line yoke, rod;
        slider rod along 0;
        point A;
    }
}
