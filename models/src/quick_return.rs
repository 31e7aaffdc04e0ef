//! The quick-return mechanism, with the slot as a distance.
//!
//! Source: Multibody Dynamics B, assignment 6, TU Delft, 2019, with its constraint C6 corrected to close the loop.

use mechanism_macros::mechanism;

mechanism! {
    /// Quick-return mechanism: crank 2 drives rocker 4 through slider 3; bar 5 pushes slider 6 along a guide.
    pub QuickReturn;

    coordinates {
        /// Angle of crank 2.
        alpha [rad];
        /// Angle of rocker 4, and of slider 3 on it.
        beta [rad];
        /// Angle of bar 5.
        gamma [rad];
    }

    parameters {
        /// Length of crank 2.
        O2A [m] = 0.2;
        /// Length of rocker 4.
        O4B [m] = 0.7;
        /// Length of bar 5.
        BC [m] = 0.6;
        /// Distance of the fixed pivots.
        O4O2 [m] = 0.3;
        /// Centre of mass of rocker 4.
        O4G4 [m] = 0.4;
        /// Centre of mass of bar 5.
        BG5 [m] = 0.3;
        /// Height of the guide.
        yc [m] = 0.9;
        /// Mass of slider 3.
        m3 [kg] = 0.5;
        /// Mass of rocker 4.
        m4 [kg] = 6;
        /// Mass of bar 5.
        m5 [kg] = 4;
        /// Mass of slider 6.
        m6 [kg] = 2;
        /// Inertia of crank 2 with its flywheel, about O2.
        J2 [kg*m^2] = 100;
        /// Inertia of slider 3.
        J3 [kg*m^2] = 0;
        /// Inertia of rocker 4.
        J4 [kg*m^2] = 10;
        /// Inertia of bar 5.
        J5 [kg*m^2] = 6;
        /// Force on slider 6, along +x.
        F [N] = 1000;
        /// Torque on crank 2.
        T [N*m] = 0;
    }

    let O4 = [0, 0];
    let O2 = [0, O4O2];
    let A = O2 + O2A*[cos(alpha), sin(alpha)];
    let G4 = O4G4*[cos(beta), sin(beta)];
    let B = O4B*[cos(beta), sin(beta)];
    let G5 = B + BG5*[cos(gamma), sin(gamma)];
    let C = B + BC*[cos(gamma), sin(gamma)];

    bodies {
        crank2: inertia J2, angle alpha;
        slider3: mass m3 at A, inertia J3, angle beta;
        rocker4: mass m4 at G4, inertia J4, angle beta;
        bar5: mass m5 at G5, inertia J5, angle gamma;
        slider6: mass m6 at C;
    }

    loads {
        force [F, 0] at C;
        torque T on crank2;
    }

    constraints {
        guide: C.y = yc;
        slot: A.y*cos(beta) = A.x*sin(beta);
    }

    initial {
        alpha = 0;
        dot(alpha) = 75 [rpm];
        guess beta = 1;
        guess gamma = 2.6;
    }

    events {
        period: alpha = 2*pi;
    }

    outputs {
        angular_speeds "Angular speeds" {
            /// crank 2
            crank_speed [rad/s] = dot(alpha);
            /// rocker 4
            rocker_speed [rad/s] = dot(beta);
            /// bar 5
            bar_speed [rad/s] = dot(gamma);
        }
        slider3_speed "Sliding speed of slider 3 on rocker 4" {
            /// sliding speed, d|O4 A|/dt
            sliding_speed [m/s] = dot(norm(A));
            /// the report's |v_A| - |v_G4|
            speed_difference [m/s] = norm(dot(A)) - norm(dot(G4));
        }
        slider6_position "Position of slider 6" {
            /// position
            x6 [m] = C.x;
        }
        slider6_velocity "Velocity of slider 6" {
            /// velocity
            x6_velocity [m/s] = dot(C.x);
        }
        slider6_acceleration "Acceleration of slider 6" {
            /// acceleration
            x6_acceleration [m/s^2] = ddot(C.x);
        }
        normal_forces "Normal forces" {
            /// slider 3 on rocker 4
            normal_force_slider3 [N] = reaction(slot);
            /// slider 6 on the ground
            normal_force_slider6 [N] = reaction(guide);
        }
    }

    drawing {
        ground O2, O4;
        line O2, A;
        line O4, B, C;
        slider A along beta;
        slider C along 0;
        point G4, G5;
    }
}
