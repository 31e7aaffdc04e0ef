//! A plate cam whose lift is given by a table, with a roller follower on a spring.
//!
//! Source: rise, dwell, return, dwell with cycloidal rise and return; R. L. Norton, Design of Machinery, chapter 8 (cam design), and
//! chapter 15 for the forces: y = L (theta/beta - sin(2 pi theta/beta)/(2 pi)), F = m y'' + k y + F0.

use mechanism_macros::mechanism;

mechanism! {
    /// Plate cam at constant speed that lifts a roller follower against a spring. The lift is a table of the cycloidal law.
    pub CamFollower;

    coordinates {
        /// Angle of the cam.
        alpha [rad];
        /// Height of the roller.
        y [mm];
    }

    parameters {
        /// Speed of the cam.
        w [rpm] = 300;
        /// Radius of the base circle and that of the roller together.
        r [mm] = 40;
        /// Inertia of the cam and its shaft.
        J [kg*m^2] = 0.002;
        /// Mass of the follower.
        m [kg] = 0.6;
        /// Stiffness of the spring.
        k [N/mm] = 2;
        /// Force of the spring where the follower is down.
        F0 [N] = 60;
        /// Radius of the roller, for drawings.
        roller [mm] = 10;
        g [m/s^2] = 9.81;
    }

    const n = 30;

    tables {
        /// Lift over the angle of the cam.
        lift [mm] over [deg] = cubic, periodic {
            repeat i in 0..n { 120*i/n, 12*(i/n - sin(2*pi*i/n)/(2*pi)); }
            repeat i in 0..=10 { 120 + 6*i, 12; }
            repeat i in 1..n { 180 + 120*i/n, 12*(1 - i/n + sin(2*pi*i/n)/(2*pi)); }
            repeat i in 0..=10 { 300 + 6*i, 0; }
        }
    }

    let O = [0, 0];
    let P = [0, y];

    bodies {
        cam: inertia J, angle alpha;
        follower: mass m at P;
    }

    loads {
        gravity [0, -g];
        force -(k*(y - r) + F0) on y;
    }

    constraints { drive: alpha = w*t; }

    joints { contact: cam P through O along pi/2 on cam radius r by lift; }

    initial { guess y = 40; }

    events {
        period: alpha = 2*pi;
        /// The follower loses touch with the cam.
        float: reaction(contact) = 0 falling;
    }

    outputs {
        follower_lift "Lift of the follower" {
            /// lift
            s [mm] = y - r;
        }
        follower_acceleration "Acceleration of the follower" {
            /// acceleration
            a [m/s^2] = ddot(y);
        }
        contact_force "Force of the cam on the follower" {
            /// contact
            N [N] = reaction(contact);
        }
        torque "Torque of the drive" {
            /// drive
            T [N*m] = -reaction(drive);
        }
    }

    let top = [0, 4*r];
    // The path of the roller's centre on the cam.
    repeat i in 0..=36 {
        let path_[i] = (r + lift(10*i*pi/180))*[sin(10*i*pi/180 - alpha), cos(10*i*pi/180 - alpha)];
    }

    drawing {
        ground O, top;
        repeat i in 1..=36 { curve path_[i-1], path_[i]; }
        curve O, path_[0];
        circle P radius roller;
        line P, P + [0, 1.5*r];
        slider P + [0, r] along pi/2;
        spring P + [0, 1.5*r], top;
        point O;
    }
}
