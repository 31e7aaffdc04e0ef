//! Two shafts at an angle, joined by a universal joint.
//!
//! Source: Cardan's joint (Hooke 1676); with tan(gamma) = tan(alpha)/cos(beta) its ratio of speeds is
//! cos(beta)/(1 - sin(beta)^2 cos(alpha)^2) (Seherr-Thoss, Schmelz and Aucktor, Universal Joints and Driveshafts, 2006,
//! section 1.2).

use mechanism_macros::mechanism;

mechanism! {
    /// A driven shaft turns another one by a universal joint.
    pub Cardan;

    coordinates {
        /// Turn of the first shaft.
        alpha [rad];
        /// Turn of the second.
        gamma [rad];
    }

    parameters {
        /// Angle between the shafts.
        beta [deg] = 35;
        /// Moment of inertia of a shaft about its axis.
        J [kg*m^2] = 0.02;
        /// Length that is drawn of each shaft.
        l [m] = 0.3;
        /// Arm of the cross.
        a [m] = 0.06;
        /// Speed of the first shaft at the start.
        speed [rpm] = 300;
        /// Braking torque on the second shaft, per speed.
        c [N*m*s] = 0.002;
    }

    let R1 = rotation(x, alpha);
    let R2 = rotation(z, beta)*rotation(x, gamma);

    bodies {
        driving: inertia [J, J, J], attitude R1;
        driven: inertia [J, J, J], attitude R2;
    }
    loads { torque -c*omega(driven) on driven; }

    constraints {
        /// The arms of the cross stand at right angles.
        cross: inner(R1*[0, 1, 0], R2*[0, 0, 1]) = 0;
    }

    initial { alpha = 0; dot(alpha) = speed; guess gamma = 0; }
    events { period: sin(alpha/2) = 0; }

    outputs {
        /// ratio of the speeds of the shafts
        ratio = dot(gamma)/dot(alpha);
        /// torque between the arms of the cross
        torque [N*m] = reaction(cross);
    }

    drawing {
        ground [-l, 0, 0], rotation(z, beta)*[l, 0, 0];
        line [-l, 0, 0], [0, 0, 0];
        line [0, 0, 0], rotation(z, beta)*[l, 0, 0];
        curve R1*[0, -a, 0], R1*[0, a, 0];
        curve R2*[0, 0, -a], R2*[0, 0, a];
        circle R1*[-a, 0, 0] radius a normal [1, 0, 0];
        circle R2*[a, 0, 0] radius a normal R2*[1, 0, 0];
    }
}
