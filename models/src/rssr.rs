//! A spatial four-bar: two cranks on skew axes and a coupler with a ball joint at each end (RSSR).
//!
//! Source: Hartenberg and Denavit, Kinematic Synthesis of Linkages, 1964, chapter 12; Norton, Design of Machinery, section 4.9. The
//! coupler's length makes the rocker's angle the root of a cos(psi) + b sin(psi) = c.

use mechanism_macros::mechanism;

mechanism! {
    /// A crank drives a rocker on another axis by a coupler with two ball joints.
    pub Rssr;

    coordinates {
        /// Turn of the crank, about the vertical.
        phi [rad];
        /// Swing of the rocker, about an axis along y.
        psi [rad];
    }

    parameters {
        /// Crank.
        a [m] = 0.15;
        /// Coupler.
        c [m] = 0.7;
        /// Rocker.
        b [m] = 0.4;
        /// Place of the rocker's axis.
        dx [m] = 0.5;
        dz [m] = 0.3;
        m [kg] = 1;
        g [m/s^2] = 9.81;
        /// Speed of the crank at the start.
        speed [rpm] = 120;
    }

    let A = a*[cos(phi), sin(phi), 0];
    let O = [dx, 0, dz];
    let rocker_frame = rotation(y, psi);
    let B = O + rocker_frame*[0, 0, -b];

    bodies {
        crank: inertia [0.01 [kg*m^2], 0.01 [kg*m^2], 0.02 [kg*m^2]], attitude rotation(z, phi);
        coupler: mass m at (A + B)/2;
        rocker: mass m at O + rocker_frame*[0, 0, -b/2], inertia [m*b^2/12, m*b^2/12, 0], attitude rocker_frame;
    }
    loads { gravity [0, 0, -g]; }
    joints { coupling: link A to B, length c; }
    initial { phi = 0; dot(phi) = speed; guess psi = 0.3; }
    events { period: sin(phi/2) = 0; }

    outputs {
        /// swing of the rocker
        swing [deg] = psi;
        /// force in the coupler, positive in tension
        coupler_force [N] = reaction(coupling);
    }

    drawing {
        ground [0, 0, 0], O;
        line [0, 0, 0], A;
        line A, B;
        line B, O;
        circle [0, 0, 0] radius a normal [0, 0, 1];
    }
}
