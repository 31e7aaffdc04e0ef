//! Stewart's platform: a body on six legs of prescribed lengths.
//!
//! Source: Stewart, A Platform with Six Degrees of Freedom, Proceedings of the Institution of Mechanical Engineers 180 (1965);
//! Merlet, Parallel Robots, 2006. The feet stand in pairs on a circle of radius R, the heads in pairs on one of radius r turned
//! by 60 degrees. Legs of one length L hold the platform level, at the height sqrt(L^2 - d^2), d being how far a head is
//! from its foot as seen from above.

use mechanism_macros::mechanism;

mechanism! {
    /// A platform on six legs that lengthen and shorten together, and swing apart.
    pub Stewart;

    parameters {
        m [kg] = 40;
        /// Principal moments of inertia of the platform.
        A [kg*m^2] = 3;
        C [kg*m^2] = 5;
        /// Radius of the circle of the feet.
        R [m] = 0.9;
        /// Radius of the circle of the heads.
        r [m] = 0.5;
        /// Half of the angle between the feet of a pair.
        foot [deg] = 10;
        /// Half of the angle between the heads of a pair.
        head [deg] = 12;
        /// Length of the legs at rest.
        L [m] = 1;
        /// How far all legs move together.
        heave [m] = 0.1;
        /// How far neighbours move against each other.
        sway [m] = 0;
        w [rad/s] = 4;
        g [m/s^2] = 9.81;
    }

    bodies { platform: free, mass m, inertia [A, A, C]; }
    loads { gravity [0, 0, -g]; }

    fragment Leg(i, side) {
        let foot_angle = i*120 [deg] + side*foot;
        let head_angle = i*120 [deg] + side*(60 [deg] - head);
        let on_ground = R*[cos(foot_angle), sin(foot_angle), 0];
        let on_platform = on(platform, r*[cos(head_angle), sin(head_angle), 0]);
        joints { leg: link on_platform to on_ground, length L + heave*sin(w*t) + side*sway*sin(w*t + i*120 [deg]); }
        drawing { line on_ground, on_platform; }
    }
    use Leg(0, 1) as a1;
    use Leg(1, -1) as a2;
    use Leg(1, 1) as b1;
    use Leg(2, -1) as b2;
    use Leg(2, 1) as c1;
    use Leg(3, -1) as c2;

    // Its derivatives are long, and seldom wanted.
    kernels { }

    initial { guess platform_z = 0.7; }
    events { period: sin(w*t/2) = 0; }

    outputs {
        /// height of the platform
        height [m] = platform_z;
        /// lean of the platform
        lean = (attitude(platform)*[0, 0, 1]).z;
        leg_forces "Forces in the legs, positive in tension" {
            force1 [N] = reaction(a1_leg);
            force2 [N] = reaction(a2_leg);
        }
    }

    drawing {
        ground a1_on_ground, a2_on_ground, b1_on_ground, b2_on_ground, c1_on_ground, c2_on_ground;
        curve a1_on_platform, a2_on_platform, b1_on_platform, b2_on_platform, c1_on_platform, c2_on_platform, a1_on_platform;
    }
}
