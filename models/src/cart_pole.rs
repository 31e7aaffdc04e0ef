//! A cart with a pole, pushed by a drive: the standard problem of control.
//!
//! Source: classical (Barto, Sutton, Anderson 1983); swung up by its energy (Astrom, Furuta, Automatica 36, 2000).

use mechanism_macros::mechanism;

mechanism! {
    /// A cart on a rail with a pole that stands on it, pushed by a drive.
    pub CartPole;

    coordinates {
        /// Position of the cart.
        x [m];
        /// Angle of the pole from upright, to the right.
        phi [rad];
    }

    parameters {
        /// Mass of the cart.
        M [kg] = 1;
        /// Mass at the end of the pole.
        m [kg] = 0.2;
        /// Length of the pole.
        l [m] = 0.5;
        /// Angle of the pole at the start.
        start [deg] = 170;
        g [m/s^2] = 9.81;
    }

    inputs {
        /// Force of the drive, to the right.
        push [N] = 3 [N]*sin(4 [rad/s]*t);
    }

    let O = [x, 0];
    let P = O + l*[sin(phi), cos(phi)];

    bodies {
        cart: mass M at O;
        pole: mass m at P;
    }

    loads {
        gravity [0, -g];
        force push on x;
    }

    initial { x = 0; phi = start; }

    outputs {
        cart "Position of the cart" {
            /// position
            position [m] = x;
        }
        pole "Angle of the pole" {
            /// from upright
            angle [deg] = phi;
        }
        drive "Power of the drive" {
            /// power
            power [W] = push*dot(x);
        }
    }

    drawing {
        line O, P;
        point P;
        slider O along 0;
    }
}
