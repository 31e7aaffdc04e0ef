//! The simple pendulum, let go from rest.
//!
//! Source: any textbook; its period is 2 pi sqrt(l/g) / agm(1, cos(amplitude/2)), by Gauss.

use mechanism_macros::mechanism;

mechanism! {
    /// A point mass on a rod without mass, let go from rest at its amplitude.
    pub Pendulum;

    coordinates {
        /// Angle of the rod from the vertical.
        phi [rad];
    }

    parameters {
        /// Length of the rod.
        l [m] = 1;
        /// Mass of the bob.
        m [kg] = 1;
        g [m/s^2] = 9.81;
        /// Where it is let go.
        amplitude [deg] = 90;
    }

    let O = [0, 0];
    let P = l*[sin(phi), -cos(phi)];

    bodies { bob: mass m at P; }
    loads { gravity [0, -g]; }
    initial { phi = amplitude; }

    events {
        /// The bob passes its lowest point.
        bottom: phi = 0;
        /// The bob stands still.
        rest: dot(phi) = 0;
    }

    outputs {
        /// angle of the rod
        angle [deg] = phi;
        /// speed of the bob
        speed [m/s] = l*dot(phi);
        /// force in the rod, positive in tension
        tension [N] = m*(l*dot(phi)^2 + g*cos(phi));
    }

    drawing {
        ground O;
        line O, P;
        circle P radius l/20;
    }
}
