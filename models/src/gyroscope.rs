//! A gyroscope in Cardan's suspension: a rotor in two gimbals whose inertia takes part.
//!
//! Source: Magnus, Kreisel, 1971, on the gyroscope in gimbals and its drift; Plymale and Goodstein, Nutation of a Free
//! Gyro Subjected to an Impulse, Journal of Applied Mechanics 22, 1955. With the rotor's axis raised by b over the
//! horizontal and H the rotor's angular momentum along it, the rate p of steady precession under a weight obeys
//! (N - B) sin(b) p^2 - H p + m g l = 0, N the moment of inertia of gimbal, rotor and weight across the axes of both, B
//! that of the gimbal about the rotor's. The slow precession is taken here.

use mechanism_macros::mechanism;

mechanism! {
    /// A rotor in two gimbals that precesses under a weight on the inner one and, unless `blow` is 0, nods.
    pub Gyroscope;

    parameters {
        /// Mass of the rotor, a disc.
        M [kg] = 0.3;
        /// Its radius.
        r [m] = 0.05;
        /// Mass of the inner gimbal, a ring.
        inner_mass [kg] = 0.08;
        /// Its radius.
        inner_radius [m] = 0.07;
        /// Mass of the outer gimbal, a ring.
        outer_mass [kg] = 0.12;
        /// Its radius.
        outer_radius [m] = 0.09;
        /// Mass of the weight on the inner gimbal.
        m [kg] = 0.05;
        /// Its distance from the centre, on the rotor's axis.
        l [m] = 0.08;
        g [m/s^2] = 9.81;
        /// Rise of the rotor's axis at the start.
        rise0 [deg] = 25;
        /// Angular velocity of the rotor along its axis.
        own_spin [rad/s] = 60;
        /// Speed of the inner gimbal at the start, after a blow.
        blow [rad/s] = 2;
    }

    let R = attitude(rotor);
    let w = transpose(R)*omega(rotor);
    let A = M*r^2/4;
    let C = M*r^2/2;
    let inner_ring = inner_mass*inner_radius^2;
    let outer_ring = outer_mass*outer_radius^2;
    let H = C*own_spin;
    let N_less_B = A + inner_ring/2 + m*l^2;
    let discriminant = H^2 - 4*N_less_B*sin(rise0)*m*g*l;
    let steady = 2*m*g*l/(H + sqrt(discriminant));

    bodies {
        outer_gimbal: mass outer_mass, inertia [outer_ring/2, outer_ring, outer_ring/2];
        inner_gimbal: mass inner_mass, inertia [inner_ring/2, inner_ring/2, inner_ring];
        rotor: mass M, inertia [A, C, A];
        weight: mass m at on(inner_gimbal, [0, l, 0]);
    }
    joints {
        /// Turn of the outer gimbal about the vertical.
        turn: revolute ground at [0, 0, 0] axis [0, 0, 1] to outer_gimbal at [0, 0, 0] axis [0, 0, 1];
        /// Rise of the rotor's axis over the horizontal.
        rise: revolute outer_gimbal at [0, 0, 0] axis [1, 0, 0] to inner_gimbal at [0, 0, 0] axis [1, 0, 0];
        /// Turn of the rotor in the inner gimbal.
        spin: revolute inner_gimbal at [0, 0, 0] axis [0, 1, 0] to rotor at [0, 0, 0] axis [0, 1, 0];
    }
    loads { gravity [0, 0, -g]; }

    initial {
        turn = 0;
        rise = rise0;
        spin = 0;
        dot(turn) = steady;
        dot(rise) = blow;
        dot(spin) = own_spin - steady*sin(rise0);
    }

    events {
        period: sin(turn/2) = 0;
        nutation: dot(rise) = 0;
    }

    outputs {
        /// rate of precession
        precession [rad/s] = dot(turn);
        /// rise of the rotor's axis
        elevation [deg] = rise;
        spins "Angular velocity of the rotor" {
            /// along its axis, in the world
            along_axis [rad/s] = w.y;
            /// in the inner gimbal
            in_gimbal [rad/s] = dot(spin);
        }
        /// moment of the gimbals on the rotor
        moment [N*m] = norm(dot(R*[A*w.x, C*w.y, A*w.z]));
    }

    drawing {
        ground [0, 0, -1.15*outer_radius];
        curve [0, 0, -1.15*outer_radius], [0, 0, -outer_radius];
        circle [0, 0, 0] radius outer_radius normal attitude(outer_gimbal)*[0, 1, 0];
        curve on(outer_gimbal, [-outer_radius, 0, 0]), on(inner_gimbal, [-inner_radius, 0, 0]);
        curve on(inner_gimbal, [inner_radius, 0, 0]), on(outer_gimbal, [outer_radius, 0, 0]);
        circle [0, 0, 0] radius inner_radius normal attitude(inner_gimbal)*[0, 0, 1];
        curve on(inner_gimbal, [0, -inner_radius, 0]), on(inner_gimbal, [0, l, 0]);
        circle [0, 0, 0] radius r normal R*[0, 1, 0];
        curve on(rotor, [-r, 0, 0]), on(rotor, [r, 0, 0]);
        point on(inner_gimbal, [0, l, 0]);
    }
}
