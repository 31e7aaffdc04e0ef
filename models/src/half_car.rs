//! Half a car on two springs and dampers that drives over a bump.
//!
//! Source: classical, for small pitch (Wong, Theory of Ground Vehicles, chapter 7); a linear system, whose motion is
//! Duhamel's integral of its modes.

use mechanism_macros::mechanism;

mechanism! {
    /// Half a car, seen from the side, drives over a bump: bounce and pitch from equilibrium.
    pub HalfCar;

    const n = 32;

    coordinates {
        /// Bounce of the centre of mass.
        y [m];
        /// Pitch, the front upwards.
        phi [rad];
    }

    parameters {
        /// Mass of the body.
        m [kg] = 700;
        /// Inertia of the body.
        J [kg*m^2] = 1000;
        /// From the centre of mass to the front axle.
        lf [m] = 1.2;
        /// From the centre of mass to the rear axle.
        lr [m] = 1.5;
        /// Stiffness of the front spring.
        kf [kN/m] = 18;
        /// Stiffness of the rear spring.
        kr [kN/m] = 20;
        /// Damping in front.
        cf [N*s/m] = 1200;
        /// Damping behind.
        cr [N*s/m] = 1400;
        /// Speed.
        v [m/s] = 10;
        /// Height of the bump.
        H [mm] = 80;
        /// Half of its width, where it has fallen to a third.
        w [m] = 0.5;
        /// Where its top is.
        s0 [m] = 6;
        /// Radius of the wheels, for drawings.
        R [m] = 0.3;
    }

    let front_road = H*exp(-((v*t + lf - s0)/w)^2);
    let rear_road = H*exp(-((v*t - lr - s0)/w)^2);
    let front = y + lf*phi;
    let rear = y - lr*phi;

    bodies { car: mass m at [0, y], inertia J, angle phi; }

    loads {
        spring kf, rest 0 between front_road and front;
        spring kr, rest 0 between rear_road and rear;
        damper cf between front_road and front;
        damper cr between rear_road and rear;
    }

    initial { y = 0; phi = 0; dot(y) = 0; dot(phi) = 0; }

    events {
        /// The body is highest or lowest.
        turn: dot(y) = 0;
    }

    outputs {
        bounce "Bounce" {
            /// body
            body [mm] = y;
            /// road at the front axle
            road [mm] = front_road;
        }
        pitch "Pitch" {
            /// pitch
            pitch_angle [deg] = phi;
        }
        comfort "Acceleration of the body" {
            /// acceleration
            acceleration [m/s^2] = ddot(y);
        }
        suspension "Forces of the suspension, beyond the weight" {
            /// front
            front_force [N] = -kf*(front - front_road) - cf*dot(front - front_road);
            /// rear
            rear_force [N] = -kr*(rear - rear_road) - cr*dot(rear - rear_road);
        }
    }

    // The road under the car, and the car as it stands on it.
    repeat i in 0..=n {
        let x_[i] = (i - n/2)*0.125*(lf + lr)/1.5;
        let road_[i] = [x_[i], H*exp(-((v*t + x_[i] - s0)/w)^2)];
    }
    let front_end = [lf, 2.5*R + front];
    let rear_end = [-lr, 2.5*R + rear];
    let front_wheel = [lf, R + front_road];
    let rear_wheel = [-lr, R + rear_road];

    let side = [R/4, 0];

    drawing {
        repeat i in 1..=n { curve road_[i-1], road_[i]; }
        circle front_wheel radius R;
        circle rear_wheel radius R;
        line rear_end, front_end;
        spring rear_wheel - side, rear_end - side;
        damper rear_wheel + side, rear_end + side;
        spring front_wheel - side, front_end - side;
        damper front_wheel + side, front_end + side;
        point [0, 2.5*R + y];
    }
}
