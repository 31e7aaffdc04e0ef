//! A crank with a prescribed motion that drives a follower by a spring and a damper.
//!
//! Source: classical; a linear oscillator with a moving support, solved in closed form.

use mechanism_macros::mechanism;

mechanism! {
    /// A crank pin that turns evenly lifts a follower through a spring and a damper: motion prescribed by time alone.
    pub SpringFollower;

    coordinates {
        /// Height of the follower.
        y [m];
    }

    parameters {
        /// Radius of the crank.
        r [mm] = 40;
        /// Speed of the crank.
        w [rpm] = 240;
        /// Mass of the crank pin and its yoke.
        m_pin [kg] = 0.4;
        /// Mass of the follower.
        m [kg] = 0.8;
        /// Stiffness of the spring.
        k [N/m] = 1200;
        /// Damping.
        c [N*s/m] = 6;
        /// Length of the spring without load.
        l0 [mm] = 150;
        g [m/s^2] = 9.81;
    }

    let O = [0, 0];
    let A = r*[cos(w*t), sin(w*t)];
    let yoke = [0, A.y];
    let P = [0, y];

    bodies {
        pin: mass m_pin at A;
        follower: mass m at P;
    }

    loads {
        gravity [0, -g];
        spring k, rest l0 between A.y and y;
        damper c between A.y and y;
    }

    initial {
        y = 150 [mm];
        dot(y) = 0;
    }

    events {
        period: sin(w*t) = 0;
        /// The follower turns back.
        turn: dot(y) = 0;
    }

    outputs {
        heights "Heights" {
            /// pin
            pin_height [mm] = A.y;
            /// follower
            follower_height [mm] = y;
        }
        forces "Forces on the follower" {
            /// spring
            spring_force [N] = k*(l0 - (y - A.y));
            /// damper
            damper_force [N] = -c*dot(y - A.y);
        }
    }

    let side = [8 [mm], 0];

    drawing {
        ground O;
        circle O radius r;
        line O, A;
        line A, yoke;
        spring yoke - side, P - side;
        damper yoke + side, P + side;
        point A;
        slider P along pi/2;
    }
}
