//! A rigid body on which nothing acts, by a unit quaternion: the motion of [`Tumbling`](crate::Tumbling), without angles and so
//! without positions in which they fail.
//!
//! Source: Landau and Lifshitz, Mechanics, 3rd ed. 1976, section 37; quaternions as in Goldstein, Poole and Safko, Classical
//! Mechanics, 3rd ed. 2002, section 4.5.

use mechanism_macros::mechanism;

mechanism! {
    /// A free rigid body that tumbles, by a quaternion.
    pub TumblingQuaternion;

    parameters {
        /// Principal moments of inertia.
        A [kg*m^2] = 1;
        B [kg*m^2] = 2;
        C [kg*m^2] = 3;
        m [kg] = 1;
        /// Angular momentum.
        H [N*m*s] = 6;
        /// Angle between the third axis and the angular momentum at the start.
        theta0 [deg] = 28;
    }

    let c = cos(theta0/2)*cos(45 [deg]);
    let s = sin(theta0/2)*cos(45 [deg]);
    let W1 = H*sin(theta0)/A;
    let W3 = H*cos(theta0)/C;
    let w = transpose(attitude(body))*omega(body);

    bodies { body: free, mass m, inertia [A, B, C]; }

    initial {
        body_x = 0; body_y = 0; body_z = 0;
        body_q0 = c; body_q1 = s; body_q2 = -s; body_q3 = c;
        dot(body_q0) = -(s*W1 + c*W3)/2;
        dot(body_q1) = (c*W1 - s*W3)/2;
        dot(body_q2) = (c*W1 - s*W3)/2;
        dot(body_q3) = (c*W3 + s*W1)/2;
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
            Hx [N*m*s] = (attitude(body)*[A*w.x, B*w.y, C*w.z]).x;
            Hy [N*m*s] = (attitude(body)*[A*w.x, B*w.y, C*w.z]).y;
            Hz [N*m*s] = (attitude(body)*[A*w.x, B*w.y, C*w.z]).z;
        }
        /// kinetic energy
        energy [J] = (A*w.x^2 + B*w.y^2 + C*w.z^2)/2;
        /// what keeps the norm: nothing
        norm_force [J] = reaction(body_norm);
    }

    drawing {
        line on(body, [1 [m], 0, 0]), on(body, [0, 0.7 [m], 0]), on(body, [-1 [m], 0, 0]), on(body, [0, -0.7 [m], 0]), on(body, [1 [m], 0, 0]);
        line on(body, [0, 0, -0.3 [m]]), on(body, [0, 0, 0.5 [m]]);
        curve [0, 0, 0], [0, 0, 1.2 [m]];
        point on(body, [0, 0, 0]);
    }
}
