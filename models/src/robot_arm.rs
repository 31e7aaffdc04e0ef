//! A six-axis industrial arm with a spherical wrist.
//!
//! Source: the usual layout (Siciliano, Sciavicco, Villani and Oriolo, Robotics, 2009, section 2.9: an anthropomorphic arm with a
//! spherical wrist), with dimensions of a small industrial arm. Its kernels are compared with the recursive Newton-Euler
//! equations (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 5.3).

use mechanism_macros::mechanism;

mechanism! {
    /// A six-axis arm with a spherical wrist, let swing from rest under the torques of its drives.
    pub RobotArm;

    coordinates {
        /// Waist, about the vertical.
        q1 [rad];
        /// Shoulder.
        q2 [rad];
        /// Elbow.
        q3 [rad];
        /// Roll of the forearm.
        q4 [rad];
        /// Bend of the wrist.
        q5 [rad];
        /// Turn of the flange.
        q6 [rad];
    }

    parameters {
        /// Height of the shoulder over the base.
        h [m] = 0.4;
        /// Shoulder ahead of the waist's axis.
        a1 [m] = 0.15;
        /// Length of the upper arm.
        a2 [m] = 0.6;
        /// Elbow to wrist.
        d4 [m] = 0.55;
        /// Wrist to flange.
        d6 [m] = 0.1;
        m1 [kg] = 30;
        m2 [kg] = 18;
        m3 [kg] = 12;
        m4 [kg] = 5;
        m5 [kg] = 2.5;
        m6 [kg] = 1;
        g [m/s^2] = 9.81;
        /// Viscous friction of the first three drives; those of the wrist have a fortieth of it.
        c [N*m*s] = 0.8;
    }

    inputs { tau1 [N*m] = 0; tau2 [N*m] = -60; tau3 [N*m] = -20; tau4 [N*m] = 0; tau5 [N*m] = 0; tau6 [N*m] = 0; }

    let R1 = rotation(z, q1);
    let R2 = R1*rotation(y, q2);
    let R3 = R2*rotation(y, q3);
    let R4 = R3*rotation(x, q4);
    let R5 = R4*rotation(y, q5);
    let R6 = R5*rotation(x, q6);
    let shoulder = R1*[a1, 0, h];
    let elbow = shoulder + R2*[0, 0, a2];
    let wrist = elbow + R3*[d4, 0, 0];
    let flange = wrist + R5*[d6, 0, 0];

    bodies {
        waist: mass m1 at R1*[0.4*a1, 0, 0.6*h], inertia [0.9 [kg*m^2], 0.8 [kg*m^2], 0.7 [kg*m^2]], attitude R1;
        upper_arm: mass m2 at shoulder + R2*[0, 0, 0.45*a2], inertia [0.75 [kg*m^2], 0.8 [kg*m^2], 0.1 [kg*m^2]], attitude R2;
        forearm: mass m3 at elbow + R3*[0.2*d4, 0, 0.03 [m]], inertia [0.08 [kg*m^2], 0.25 [kg*m^2], 0.24 [kg*m^2]], attitude R3;
        roll: mass m4 at wrist + R4*[-0.3*d4, 0, 0], inertia [0.02 [kg*m^2], 0.06 [kg*m^2], 0.06 [kg*m^2]], attitude R4;
        bend: mass m5 at wrist + R5*[0.2*d6, 0, 0], inertia [0.005 [kg*m^2], 0.006 [kg*m^2], 0.007 [kg*m^2]], attitude R5;
        tool: mass m6 at flange, inertia [0.002 [kg*m^2], 0.0015 [kg*m^2], 0.0015 [kg*m^2]], attitude R6;
    }

    loads {
        gravity [0, 0, -g];
        torque tau1 - c*dot(q1) on q1;
        torque tau2 - c*dot(q2) on q2;
        torque tau3 - c*dot(q3) on q3;
        torque tau4 - c/40*dot(q4) on q4;
        torque tau5 - c/40*dot(q5) on q5;
        torque tau6 - c/40*dot(q6) on q6;
    }

    initial { q1 = 0; q2 = 20 [deg]; q3 = -30 [deg]; q4 = 10 [deg]; q5 = 40 [deg]; q6 = 0; dot(q1) = 0.5; }

    outputs {
        flange_position "Position of the flange" {
            x [m] = flange.x;
            y [m] = flange.y;
            height [m] = flange.z;
        }
        /// speed of the flange
        flange_speed [m/s] = norm(dot(flange));
    }

    drawing {
        ground [0, 0, 0];
        line [0, 0, 0], R1*[0, 0, h], shoulder;
        line shoulder, elbow;
        line elbow, wrist;
        line wrist, flange;
        curve flange, flange + R6*[0, 0.05 [m], 0];
    }

    kernels { inverse_dynamics; }
}
