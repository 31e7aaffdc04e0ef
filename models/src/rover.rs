//! A cart on two driven wheels and a castor without mass: it turns by the difference of its wheels' speeds, and never slips.
//!
//! Source: Neimark and Fufaev, Dynamics of Nonholonomic Systems, 1972, chapter III; Siciliano, Sciavicco, Villani and Oriolo,
//! Robotics, 2009, section 11.2. With wheels of radius r at distance 2 b the cart goes at r (s1 + s2)/2 and turns at
//! r (s2 - s1)/(2 b), s1 and s2 the speeds of the wheels; at constant ones it draws a circle.

use mechanism_macros::mechanism;

mechanism! {
    /// A two-wheeled cart under the torques of its motors, against their friction.
    pub Rover;

    coordinates {
        /// Middle of the axle.
        x [m];
        y [m];
        /// Direction.
        psi [rad];
        /// Turn of the left wheel.
        left [rad];
        /// Turn of the right wheel.
        right [rad];
    }

    parameters {
        /// Mass of the cart without wheels, in the middle of the axle.
        M [kg] = 8;
        /// Its moment of inertia about the vertical.
        J [kg*m^2] = 0.2;
        /// Mass of a wheel.
        m [kg] = 0.5;
        /// Radius of the wheels.
        r [m] = 0.1;
        /// Half of their distance.
        b [m] = 0.2;
        /// Friction of the motors.
        c [N*m*s] = 0.05;
        g [m/s^2] = 9.81;
    }

    inputs { tau_left [N*m] = 0.2; tau_right [N*m] = 0.3; }

    let R = rotation([0, 0, 1], psi);
    let P = [x, y, r];
    let L = P + R*[0, b, 0];
    let Q = P + R*[0, -b, 0];
    let left_frame = R*rotation([0, 1, 0], left);
    let right_frame = R*rotation([0, 1, 0], right);

    bodies {
        cart: mass M at P, inertia [J/2, J/2, J], attitude R;
        left_wheel: mass m at L, inertia [m*r^2/4, m*r^2/2, m*r^2/4], attitude left_frame;
        right_wheel: mass m at Q, inertia [m*r^2/4, m*r^2/2, m*r^2/4], attitude right_frame;
    }
    loads {
        gravity [0, 0, -g];
        torque tau_left - c*dot(left) on left;
        torque tau_right - c*dot(right) on right;
    }
    constraints {
        /// The rim of each wheel stands still where it touches the ground, and neither slips sideways.
        left_rolls: inner(dot(L) + cross(omega(left_wheel), [0, 0, -r]), R*[1, 0, 0]) = 0;
        right_rolls: inner(dot(Q) + cross(omega(right_wheel), [0, 0, -r]), R*[1, 0, 0]) = 0;
        sideways: inner(dot(P), R*[0, 1, 0]) = 0;
    }
    initial { x = 0; y = 0; psi = 0; left = 0; right = 0; dot(left) = 0; dot(right) = 0; }

    outputs {
        /// speed
        speed [m/s] = inner(dot(P), R*[1, 0, 0]);
        /// rate of turning
        turning [rad/s] = dot(psi);
        /// force of the wheels on the ground, sideways
        side_force [N] = reaction(sideways);
    }

    drawing {
        curve [-1 [m], -1 [m], 0], [3 [m], -1 [m], 0], [3 [m], 3 [m], 0], [-1 [m], 3 [m], 0], [-1 [m], -1 [m], 0];
        circle L radius r normal R*[0, 1, 0];
        circle Q radius r normal R*[0, 1, 0];
        line L, on(left_wheel, [r, 0, 0]);
        line Q, on(right_wheel, [r, 0, 0]);
        curve L, P + R*[0.3 [m], 0, 0], Q, L;
    }
}
