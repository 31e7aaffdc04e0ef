//! Whitworth's quick return, in which the slotted link turns all the way round.
//!
//! Source: classical; tan beta = r sin alpha/(d + r cos alpha), and the times of stroke and return are as the angles of
//! the crank between the dead points.

use mechanism_macros::mechanism;

mechanism! {
    /// Whitworth's quick return: a crank that turns evenly drives a slotted link about a pivot inside the crank's circle,
    /// and that drives a ram.
    pub Whitworth;

    coordinates {
        /// Angle of the crank.
        alpha [rad];
        /// Angle of the slotted link.
        beta [rad];
        /// Angle of the connecting rod.
        gamma [rad];
    }

    parameters {
        /// Radius of the crank.
        r [m] = 0.2;
        /// Distance of the fixed pivots, less than the radius.
        d [m] = 0.09;
        /// Radius at which the slotted link drives the rod.
        c [m] = 0.12;
        /// Length of the connecting rod.
        l [m] = 0.5;
        /// Speed of the crank.
        w [rpm] = 60;
        /// Inertia of the crank and its wheel.
        J2 [kg*m^2] = 0.2;
        /// Inertia of the slotted link.
        J4 [kg*m^2] = 0.15;
        /// Mass of the connecting rod, slender.
        m5 [kg] = 2;
        /// Mass of the ram.
        m6 [kg] = 8;
        /// Length of the slotted link beyond its pivot, for drawings.
        s [m] = 0.3;
    }

    let O4 = [0, 0];
    let O2 = [0, d];
    let A = O2 + r*[-sin(alpha), cos(alpha)];
    let link = [-sin(beta), cos(beta)];
    let B = -c*link;
    let rod = [cos(gamma), sin(gamma)];
    let C = B + l*rod;

    bodies {
        crank: inertia J2, angle alpha;
        slotted_link: inertia J4, angle beta;
        connecting_rod: mass m5 at B + l/2*rod, inertia m5*l^2/12, angle gamma;
        ram: mass m6 at C;
    }

    constraints {
        drive: alpha = w*t;
        slot: A.x*link.y = A.y*link.x;
        guide: C.y = 0;
    }

    initial {
        guess alpha = 0;
        guess beta = 0;
        guess gamma = 0.2;
    }

    events {
        period: alpha = 2*pi;
        /// The ram turns back.
        dead_point: dot(C.x) = 0;
    }

    outputs {
        ram "Position of the ram" {
            /// position
            x [mm] = C.x;
        }
        ram_velocity "Velocity of the ram" {
            /// velocity
            v [m/s] = dot(C.x);
        }
        speeds "Angular speeds" {
            /// crank
            crank_speed [rpm] = dot(alpha);
            /// slotted link
            link_speed [rpm] = dot(beta);
        }
        torque "Torque on the crank" {
            /// torque
            T [N*m] = -reaction(drive);
        }
    }

    drawing {
        ground O2, O4;
        line O2, A;
        line B, s*link;
        line B, C;
        slider A along beta + pi/2;
        slider C along 0;
        point B;
    }
}
