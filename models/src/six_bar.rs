//! A six-bar linkage of Stephenson's third kind.
//!
//! Source: own dimensions; both loops are solved one after the other by intersecting circles.

use mechanism_macros::mechanism;

mechanism! {
    /// Stephenson's six-bar, third kind: a point of the coupler of a crank-rocker drives a second rocker by a link. The
    /// crank turns evenly.
    pub SixBar;

    coordinates {
        /// Angle of crank 2.
        theta2 [rad];
        /// Angle of coupler 3.
        theta3 [rad];
        /// Angle of rocker 4.
        theta4 [rad];
        /// Angle of link 5.
        theta5 [rad];
        /// Angle of rocker 6.
        theta6 [rad];
    }

    parameters {
        /// Length of crank 2.
        a [m] = 0.1;
        /// Length of coupler 3, from crank to rocker.
        b [m] = 0.3;
        /// Length of rocker 4.
        c [m] = 0.25;
        /// Distance of the pivots of crank 2 and rocker 4.
        d [m] = 0.3;
        /// Distance of the coupler point from the crank's pin.
        p [m] = 0.2;
        /// Angle of the coupler point above the coupler.
        delta [deg] = 30;
        /// Length of link 5.
        f [m] = 0.3;
        /// Length of rocker 6.
        h [m] = 0.25;
        /// Pivot of rocker 6.
        O6x [m] = 0.45;
        /// Pivot of rocker 6.
        O6y [m] = 0.3;
        /// Speed of the crank.
        w [rpm] = 60;
        /// Inertia of the crank about its pivot.
        J2 [kg*m^2] = 0.01;
        /// Mass of the coupler, at its centre of mass.
        m3 [kg] = 1.5;
        /// Inertia of the coupler about its centre of mass.
        J3 [kg*m^2] = 0.015;
        /// Mass of rocker 4, slender.
        m4 [kg] = 1;
        /// Mass of link 5, slender.
        m5 [kg] = 1;
        /// Mass of rocker 6, slender.
        m6 [kg] = 2;
        g [m/s^2] = 9.81;
    }

    let O2 = [0, 0];
    let O4 = [d, 0];
    let O6 = [O6x, O6y];
    let u3 = [cos(theta3), sin(theta3)];
    let u4 = [cos(theta4), sin(theta4)];
    let u5 = [cos(theta5), sin(theta5)];
    let u6 = [cos(theta6), sin(theta6)];
    let A = a*[cos(theta2), sin(theta2)];
    let B = A + b*u3;
    let P = A + p*[cos(theta3 + delta), sin(theta3 + delta)];
    let D = P + f*u5;

    bodies {
        crank2: inertia J2, angle theta2;
        coupler3: mass m3 at (A + B + P)/3, inertia J3, angle theta3;
        rocker4: mass m4 at O4 + c/2*u4, inertia m4*c^2/12, angle theta4;
        link5: mass m5 at P + f/2*u5, inertia m5*f^2/12, angle theta5;
        rocker6: mass m6 at O6 + h/2*u6, inertia m6*h^2/12, angle theta6;
    }

    loads { gravity [0, -g]; }

    constraints {
        drive: theta2 = w*t;
        first_loop: B = O4 + c*u4;
        second_loop: D = O6 + h*u6;
    }

    initial {
        guess theta2 = 0;
        guess theta3 = 0.9;
        guess theta4 = 1.7;
        guess theta5 = 1;
        guess theta6 = 2.4;
    }

    events {
        period: theta2 = 2*pi;
        /// Rocker 6 turns back.
        turn: dot(theta6) = 0;
    }

    outputs {
        rockers "Angles of the rockers" {
            /// rocker 4
            rocker4_angle [deg] = theta4;
            /// rocker 6
            rocker6_angle [deg] = theta6;
        }
        rocker_speeds "Angular speeds of the rockers" {
            /// rocker 4
            rocker4_speed [rad/s] = dot(theta4);
            /// rocker 6
            rocker6_speed [rad/s] = dot(theta6);
        }
        torque "Torque on the crank" {
            /// torque
            T [N*m] = -reaction(drive);
        }
        pin_D "Force of link 5 on rocker 6" {
            /// along x
            Dx [N] = reaction(second_loop).x;
            /// along y
            Dy [N] = reaction(second_loop).y;
        }
    }

    drawing {
        ground O2, O4, O6;
        line O2, A;
        line A, B, P, A;
        line O4, B;
        line P, D, O6;
        point A, B, P, D;
    }
}
