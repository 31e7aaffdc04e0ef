//! N four-bars side by side, a benchmark for redundant and singular systems.
//!
//! Source: problem A02 of the IFToMM library of computational benchmark problems (Gonzalez et al., Multibody System Dynamics
//! 16, 2006), which starts upright with 1 m/s at the first pin and passes through singular positions. Here the linkage
//! swings about the lowest position and stays clear of them: it moves as one pendulum.

use mechanism_macros::mechanism;

mechanism! {
    /// Parallel cranks side by side, joined by couplers: three four-bars in a row, which swing as one pendulum.
    pub FourBars;

    const N = 3;

    /// A slender bar from a point, turned by an angle.
    fragment Bar(base, phi) {
        let tip = base + l*[cos(phi), sin(phi)];
        bodies { bar: mass m at (base + tip)/2, inertia m*l^2/12, angle phi; }
        drawing { line base, tip; }
    }

    coordinates {
        repeat i in 0..=N {
            /// Angle of crank {i}.
            crank_angle_[i] [rad];
        }
        repeat i in 1..=N {
            /// Angle of coupler {i}.
            coupler_angle_[i] [rad];
        }
    }

    parameters {
        /// Length of each bar.
        l [m] = 1;
        /// Mass of each bar.
        m [kg] = 1;
        /// Angle of the cranks at the start.
        start [deg] = -40;
        g [m/s^2] = 9.81;
    }

    repeat i in 0..=N {
        use Bar([i*l, 0], crank_angle_[i]) as crank_[i];
        drawing { ground [i*l, 0]; }
    }
    repeat i in 1..=N {
        use Bar(crank_[i-1]_tip, coupler_angle_[i]) as coupler_[i];
        constraints { loop_[i]: coupler_[i]_tip = crank_[i]_tip; }
        drawing { point crank_[i]_tip; }
    }

    loads { gravity [0, -g]; }

    initial {
        crank_angle_0 = start;
        repeat i in 1..=N {
            guess crank_angle_[i] = start;
            guess coupler_angle_[i] = 0;
        }
    }

    events { period: dot(crank_angle_0) = 0; }

    outputs {
        cranks "Angles of the cranks" {
            /// first
            first [deg] = crank_angle_0;
            /// last
            last [deg] = crank_angle_[N];
        }
        pins "Force on the last crank" {
            /// along x
            Fx [N] = reaction(loop_[N]).x;
            /// along y
            Fy [N] = reaction(loop_[N]).y;
        }
    }
}
