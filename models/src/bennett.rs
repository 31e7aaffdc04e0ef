//! Bennett's linkage: a spatial loop of four bars with four hinges, which moves although counting says that it cannot.
//!
//! Source: Bennett, A New Mechanism, Engineering 76 (1903); Hunt, Kinematic Geometry of Mechanisms, 1978, section 10.3. Opposite
//! bars are equal, and the sines of their twists are as their lengths. With turns theta1 and theta2 at neighbouring hinges
//! tan(theta1/2) tan(theta2/2) = sin((beta + alpha)/2)/sin((beta - alpha)/2). A loop of four hinges takes away
//! 6*4 - 5*4 = 4 freedoms of 3, by Gruebler's count: two of its closing equations too many, and one that follows.

use mechanism_macros::mechanism;

mechanism! {
    /// Bennett's overconstrained linkage, hanging along y from two hinges, its loop cut at the fourth.
    pub Bennett;

    coordinates {
        /// Turn at the first hinge.
        theta1 [rad];
        /// At the second.
        theta2 [rad];
        /// At the third.
        theta3 [rad];
    }

    parameters {
        /// Length of the first and the third bar.
        a [m] = 0.5;
        /// Of the second bar and the ground.
        b [m] = 0.4;
        /// Twist of the first and the third bar.
        alpha [deg] = 40;
        m [kg] = 0.5;
        /// Moment of inertia of a bar across its axis.
        J [kg*m^2] = 0.004;
        g [m/s^2] = 9.81;
        /// Speed at the first hinge at the start.
        speed [rad/s] = 0.5;
    }

    let beta = asin(b*sin(alpha)/a);
    let R1 = rotation(z, theta1);
    let R2 = R1*rotation(x, alpha)*rotation(z, theta2);
    let R3 = R2*rotation(x, beta)*rotation(z, theta3);
    let P2 = R1*[a, 0, 0];
    let P3 = P2 + R2*[b, 0, 0];

    bodies {
        bar1: mass m at P2/2, inertia [J/50, J, J], attitude R1;
        bar2: mass m at (P2 + P3)/2, inertia [J/50, J, J], attitude R2;
        bar3: mass m at P3 + R3*[a/2, 0, 0], inertia [J/50, J, J], attitude R3;
    }
    loads { gravity [0, g, 0]; }

    joints {
        closure: revolute bar3 at [a/2, 0, 0] axis [0, -sin(alpha), cos(alpha)] to ground at [-b, 0, 0] axis [0, sin(beta), cos(beta)];
    }

    kernels { }

    initial { theta1 = 60 [deg]; guess theta2 = -160 [deg]; guess theta3 = -60 [deg]; dot(theta1) = speed; }

    outputs {
        /// tan(theta1/2) tan(theta2/2)
        product = tan(theta1/2)*tan(theta2/2);
        /// force of the third bar on the ground
        force [N] = norm(reaction(closure));
    }

    drawing {
        ground [0, 0, 0], [-b, 0, 0];
        line [0, 0, 0], P2;
        line P2, P3;
        line P3, on(bar3, [a/2, 0, 0]);
        curve P2 - 0.05 [m]*(R2*[0, 0, 1]), P2 + 0.05 [m]*(R2*[0, 0, 1]);
        curve P3 - 0.05 [m]*(R3*[0, 0, 1]), P3 + 0.05 [m]*(R3*[0, 0, 1]);
    }
}
