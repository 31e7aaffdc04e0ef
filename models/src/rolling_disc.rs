//! A disc that rolls on a plane without slip, leaning, in a circle.
//!
//! Source: Neimark and Fufaev, Dynamics of Nonholonomic Systems, 1972, chapter II; Routh, Advanced Rigid Dynamics, 1905, section
//! 244. With lean L from the upright, rate W of turning and component w of the angular velocity along the axis steady
//! motion needs (C + m r^2) W w cos(L) = A W^2 sin(L) cos(L) - m g r sin(L).

use mechanism_macros::mechanism;

mechanism! {
    /// A disc rolls in a circle, leaning inwards and, unless `nod` is 0, nodding.
    pub RollingDisc;

    coordinates {
        /// Place of the centre.
        x [m];
        y [m];
        z [m];
        /// Direction of rolling.
        psi [rad];
        /// Lean from the upright.
        lean [rad];
        /// Turn about its own axis.
        phi [rad];
    }

    parameters {
        m [kg] = 0.5;
        r [m] = 0.2;
        g [m/s^2] = 9.81;
        /// Lean at the start.
        lean0 [deg] = -20;
        /// Rate of turning at the start.
        turning [rad/s] = 1.5;
        /// Speed of leaning at the start.
        nod [rad/s] = 0.2;
    }

    let A = m*r^2/4;
    let C = m*r^2/2;
    let axial = (A*turning^2*sin(lean0)*cos(lean0) - m*g*r*sin(lean0))/((C + m*r^2)*turning*cos(lean0));
    let R = rotation([0, 0, 1], psi)*rotation([1, 0, 0], lean)*rotation([0, 1, 0], phi);
    let P = [x, y, z];

    bodies { disc: mass m at P, inertia [A, C, A], attitude R; }
    loads { gravity [0, 0, -g]; }
    joints { ground: roll disc radius r axis [0, 1, 0] on [0, 0, 0] normal [0, 0, 1]; }

    initial {
        x = 0;
        y = 0;
        guess z = r;
        psi = 0;
        lean = lean0;
        phi = 0;
        dot(psi) = turning;
        dot(lean) = nod;
        dot(phi) = axial - turning*sin(lean0);
    }
    events { period: sin(psi/2) = 0; }

    outputs {
        /// lean
        leaning [deg] = lean;
        /// speed of the centre
        speed [m/s] = norm(dot(P));
        /// force on the ground
        normal_force [N] = -reaction(ground);
    }

    drawing {
        curve [-1.5 [m], -0.5 [m], 0], [1.5 [m], -0.5 [m], 0], [1.5 [m], 2.5 [m], 0], [-1.5 [m], 2.5 [m], 0], [-1.5 [m], -0.5 [m], 0];
        circle P radius r normal R*[0, 1, 0];
        line P, on(disc, [r, 0, 0]);
    }
}
