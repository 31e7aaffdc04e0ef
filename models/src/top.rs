//! The heavy symmetric top about its steady precession.
//!
//! Source: Goldstein, Poole and Safko, Classical Mechanics, 3rd ed. 2002, section 5.7: with nutation theta held by none, the
//! rate p of precession obeys A cos(theta) p^2 - C w p + m g l = 0, A about the pivot, w the component of the angular
//! velocity along the axis. The slow precession is taken here.

use mechanism_macros::mechanism;

mechanism! {
    /// A heavy symmetric top on a fixed point that precesses and, unless `nod` is 0, nods.
    pub Top;

    coordinates {
        /// Precession about the vertical.
        psi [rad];
        /// Nutation from the vertical.
        theta [rad];
        /// Spin about its own axis.
        phi [rad];
    }

    parameters {
        m [kg] = 0.5;
        /// Distance of the centre of mass from the point it stands on.
        l [m] = 0.04;
        /// Moment of inertia across the axis, about the centre of mass.
        A [kg*m^2] = 3e-4;
        /// And about the axis.
        C [kg*m^2] = 5e-4;
        g [m/s^2] = 9.81;
        /// Nutation.
        theta0 [deg] = 30;
        /// Angular velocity along the axis.
        spin [rad/s] = 150;
        /// Speed of nutation at the start.
        nod [rad/s] = 0.5;
    }

    let R = euler(zxz, psi, theta, phi);
    let inertia_about_pivot = A + m*l^2;
    let discriminant = (C*spin)^2 - 4*inertia_about_pivot*cos(theta0)*m*g*l;
    let steady = (C*spin - sqrt(discriminant))/(2*inertia_about_pivot*cos(theta0));

    bodies { top: mass m at R*[0, 0, l], inertia [A, A, C], attitude R; }
    loads { gravity [0, 0, -g]; }

    initial {
        psi = 0;
        theta = theta0;
        phi = 0;
        dot(psi) = steady;
        dot(theta) = nod;
        dot(phi) = spin - steady*cos(theta0);
    }

    events { period: sin(psi/2) = 0; }

    outputs {
        /// rate of precession
        precession [rad/s] = dot(psi);
        /// nutation
        nutation [deg] = theta;
        /// angular velocity along the axis
        own_spin [rad/s] = (transpose(R)*omega(top)).z;
        /// height of the centre of mass
        height [m] = on(top, [0, 0, 0]).z;
    }

    drawing {
        ground [0, 0, 0];
        line [0, 0, 0], on(top, [0, 0, l]);
        circle on(top, [0, 0, 0]) radius 0.8*l normal R*[0, 0, 1];
        line on(top, [0, 0, 0]), on(top, [0.8*l, 0, 0]);
    }
}
