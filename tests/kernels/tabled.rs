//! Tables of every kind.

use sim::mechanism;

mechanism! {
    /// A cam with a knife-edge and a rocker, a bead on a track, springs, dry friction and a drive: tables of every kind, in
    /// positions, constraints, loads and inputs, beyond their rows too.
    pub(crate) Tabled;
    coordinates { alpha [rad]; s [mm]; b [deg]; x [m]; y [m]; }
    parameters { m [kg] = 0.4; J [kg*m^2] = 0.01; r [mm] = 20; v0 [m/s] = 0.1; h [m] = 0.3; g [m/s^2] = 9.81; }
    tables {
        lift [mm] over [deg] = cubic, periodic { 0, 0; 40, 2; 90, 10; 180, 20; 280, 10; 315, 2; 360, 0; }
        rocking [deg] over [deg] = cubic, natural, continued { -60, 4; -10, 0; 10, 7; 25, 9; 70, -3; }
        track [m] over [m] = cubic, clamped { -0.8, 0.1; -0.1, 0; 0.5, 0.2; 0.9, 0.15; }
        bumps [m] over [m] = cubic, continued { -0.8, 0.1; -0.1, 0; 0.5, 0.2; 0.9, 0.15; }
        force [N] over [mm] = linear, continued { -300, -40; 0, 0; 500, 100; 800, 400; }
        friction_of [N] over [m/s] = monotone, continued { -2, -3; -0.1, -4; 0.1, 4; 2, 3; }
        gain = linear { -1, 0.3; 0, 1; 2, 0.1; }
        push [N*m] over [s] = monotone, periodic { 0, 0; 0.3, 5; 0.7, 1; 0.9, -2; 1.1, 0; }
        saw [N] over [rad] = linear, periodic { 0, 0; 3, 2; pi, 0; }
        three [N] over [m] = cubic { 0, 1; 0.4, 2; 0.7, 1 [N]; }
        two [m] over [m] = monotone from "kernels/rows.csv";
    }
    inputs { T [N*m] = 2*push(t); }
    let P = [0, s];
    let track_point = [x, track(x) + bumps(x*cos(0.5 [rad/s]*t))/3];
    bodies {
        cam: inertia J, angle alpha;
        follower: mass m at P;
        arm: inertia J/2, angle b;
        bead: mass m/3 at track_point + [0, h*rocking(y/h)];
        weight: mass m at [x/5, y];
    }
    joints {
        edge: cam P through [0, 0] along pi/2 on cam radius r by lift;
        rocker: cam arm on cam by rocking;
    }
    loads {
        gravity [0, -g];
        force -force(s - r) on s;
        force -friction_of(dot(x))*gain(y/h) on x;
        force [0, -friction_of(dot(y) + 0.2*dot(x))] at [0, y];
        torque T on cam;
        spring saw(stretch/h), rest 0.1 [m] on y - x;
        potential 1 [N]*two(y) + three(y)*h;
    }
    initial { alpha = 0.3; guess s = 0.02; x = 0.2; y = 0.1; }
    outputs { a [m/s^2] = ddot(s); N [N] = reaction(edge); moment [N*m] = reaction(rocker); rate [m/s] = dot(bumps(x) + lift(b)); }
    kernels { dynamics_jacobian; dynamics_sensitivity; }
}
