//! A rigid body on which nothing acts, by Euler's angles.
//!
//! Source: Landau and Lifshitz, Mechanics, 3rd ed. 1976, sections 35 and 37, where the axes are ordered A < B < C. The angular
//! momentum stands along z, and the body starts with no angular velocity about its intermediate axis; the components of
//! its angular velocity then are Jacobi's elliptic functions of time. From below the angle arcsin(sqrt((1/B - 1/C)/(1/A - 1/C))),
//! 30 degrees here, it turns about its third axis; close to it, it stays for long near the intermediate axis, and turns over
//! again and again.

use mechanism_macros::mechanism;

mechanism! {
    /// A free rigid body that tumbles, by Euler's angles.
    pub Tumbling;

    coordinates {
        /// Precession about the angular momentum.
        psi [rad];
        /// Nutation: angle between the third axis of the body and the angular momentum.
        theta [rad];
        /// Spin about the third axis.
        phi [rad];
    }

    parameters {
        /// Principal moments of inertia.
        A [kg*m^2] = 1;
        B [kg*m^2] = 2;
        C [kg*m^2] = 3;
        /// Angular momentum.
        H [N*m*s] = 6;
        /// Nutation at the start.
        theta0 [deg] = 28;
    }

    let R = euler(zxz, psi, theta, phi);
    let w = transpose(R)*omega(body);

    bodies { body: inertia [A, B, C], attitude R; }

    initial {
        psi = 0;
        theta = theta0;
        phi = 90 [deg];
        dot(psi) = H/A;
        dot(theta) = 0;
        dot(phi) = H*cos(theta0)*(1/C - 1/A);
    }

    outputs {
        angular_velocity "Angular velocity in the frame of the body" {
            /// about the axis of least inertia
            w1 [rad/s] = w.x;
            /// about the intermediate axis
            w2 [rad/s] = w.y;
            /// about the axis of most inertia
            w3 [rad/s] = w.z;
        }
        angular_momentum "Angular momentum in the world" {
            Hx [N*m*s] = (R*[A*w.x, B*w.y, C*w.z]).x;
            Hy [N*m*s] = (R*[A*w.x, B*w.y, C*w.z]).y;
            Hz [N*m*s] = (R*[A*w.x, B*w.y, C*w.z]).z;
        }
        /// kinetic energy
        energy [J] = (A*w.x^2 + B*w.y^2 + C*w.z^2)/2;
    }

    drawing {
        line R*[1 [m], 0, 0], R*[0, 0.7 [m], 0], R*[-1 [m], 0, 0], R*[0, -0.7 [m], 0], R*[1 [m], 0, 0];
        line R*[0, 0, -0.3 [m]], R*[0, 0, 0.5 [m]];
        curve [0, 0, 0], [0, 0, 1.2 [m]];
        point [0, 0, 0];
    }
}
