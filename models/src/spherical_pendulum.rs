//! The spherical pendulum.
//!
//! Source: Landau and Lifshitz, Mechanics, 3rd ed. 1976, section 14, problem 1; Whittaker, Analytical Dynamics, 1937, section 55: its
//! height is z1 + (z2 - z1) sn^2, with the roots z1 < z2 < z3 of 2 g (E - z)(l^2 - z^2) = h^2 in lengths, h the angular
//! momentum about the vertical per mass.

use mechanism_macros::mechanism;

mechanism! {
    /// A bob on a rod that swings in all directions, pushed sideways from its lowest turn.
    pub SphericalPendulum;

    coordinates {
        /// Angle of the rod from straight down.
        theta [rad];
        /// Direction in which it leans.
        phi [rad];
    }

    parameters {
        m [kg] = 1;
        l [m] = 0.8;
        g [m/s^2] = 9.81;
        /// Angle at the start, where the bob is lowest.
        theta0 [deg] = 30;
        /// Rate at which it turns there.
        turning [rad/s] = 6;
    }

    let P = l*[sin(theta)*cos(phi), sin(theta)*sin(phi), -cos(theta)];

    bodies { bob: mass m at P; }
    loads { gravity [0, 0, -g]; }
    initial { theta = theta0; phi = 0; dot(theta) = 0; dot(phi) = turning; }

    outputs {
        /// height of the bob
        height [m] = P.z;
        path "Path seen from above" { x [m] = P.x; y [m] = P.y; }
        /// angular momentum about the vertical
        momentum [N*m*s] = m*(P.x*dot(P).y - P.y*dot(P).x);
    }

    drawing {
        ground [0, 0, 0];
        line [0, 0, 0], P;
        point P;
        trace P;
    }
}
