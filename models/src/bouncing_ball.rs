//! A ball that bounces on a floor.
//!
//! Source: any textbook. Falling from a height h it lands at t = sqrt(2 h/g) (1 + 2 (e + .. + e^(n-1))) for the n-th time, and
//! rises to h e^(2n) after that; its bounces accumulate at sqrt(2 h/g) (1 + e)/(1 - e).

use mechanism_macros::mechanism;

mechanism! {
    /// A ball that falls on a floor and bounces, each time to a lesser height.
    pub BouncingBall;

    coordinates {
        /// How far it has rolled.
        x [m];
        /// Height of its centre above the floor.
        y [m];
    }

    parameters {
        m [kg] = 0.06;
        /// Radius.
        r [m] = 0.033;
        /// Height from which it falls.
        h [m] = 1;
        /// The ratio of its speeds after and before an impact.
        rebound = 0.9;
        /// Its speed along the floor.
        v [m/s] = 0.4;
        g [m/s^2] = 9.81;
    }

    let P = [x, y];

    bodies { ball: mass m at P; }
    loads { gravity [0, -g]; }
    constraints {
        /// It holds for the instant of an impact.
        floor: P.y = r initially released;
    }
    initial { x = 0; y = r + h; dot(x) = v; dot(y) = 0; }

    events {
        /// The ball meets the floor.
        landing: P.y = r falling { impact floor restitution rebound; }
        /// It is at its highest.
        top: dot(P.y) = 0 falling;
    }

    outputs {
        /// Height of the ball above the floor
        height [m] = P.y - r;
        /// Speed upwards
        climb [m/s] = dot(P.y);
        /// Kinetic and potential energy
        energy [J] = m*inner(dot(P), dot(P))/2 + m*g*(P.y - r);
    }

    drawing {
        curve [-0.2 [m], 0], [2 [m], 0];
        circle P radius r;
    }
}
