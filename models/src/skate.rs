//! A skate on sloping ice: the blade goes along itself and never sideways, which cannot be said of positions alone.
//!
//! Sources: with the centre of mass above the blade, the knife edge on an incline (Neimark and Fufaev, Dynamics of
//! Nonholonomic Systems, 1972, chapter III; Bloch, Nonholonomic Mechanics and Control, 2003, section 1.6): turning at
//! omega it does not go down, but along a cycloid across the slope. With the centre of mass ahead of it on level ice,
//! Chaplygin's sleigh (Chaplygin 1911; Bloch, section 1.7), which stops turning and goes straight.

use mechanism_macros::mechanism;

mechanism! {
    /// A skate on sloping ice, let go turning: a cycloid across the slope.
    pub Skate;

    coordinates {
        /// Where the blade touches the ice, down the slope.
        x [m];
        /// And across it.
        y [m];
        /// Direction of the blade, from straight down.
        phi [rad];
    }

    parameters {
        m [kg] = 2;
        /// Moment of inertia about the centre of mass.
        J [kg*m^2] = 0.05;
        /// How far the centre of mass is ahead of the blade.
        a [m] = 0;
        slope [deg] = 5;
        g [m/s^2] = 9.81;
    }

    let P = [x, y];
    let along = [cos(phi), sin(phi)];
    let across = [-sin(phi), cos(phi)];
    let G = P + a*along;

    bodies { skate: mass m at G, inertia J, angle phi; }
    loads { gravity [g*sin(slope), 0]; }

    constraints {
        /// The blade does not slip sideways.
        blade: inner(dot(P), across) = 0;
    }

    initial { x = 0; y = 0; phi = 0; dot(phi) = 3; }

    events {
        /// The skate stands still and turns.
        turn: inner(dot(P), along) = 0;
    }

    outputs {
        /// Speed along the blade
        speed [m/s] = inner(dot(P), along);
        /// Force of the skate on the ice, to its left
        side_force [N] = reaction(blade);
    }

    drawing {
        line P - 0.15 [m]*along, P + 0.15 [m]*along;
        point P, G;
    }
}
