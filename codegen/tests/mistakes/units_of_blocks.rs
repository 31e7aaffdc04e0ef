//! Units: what bodies, loads, starts and drawings take.

use super::check;

/// Loads.
#[test]
fn loads() {
    check(
        "gravity [0, -g]",
        "gravity [0, -9.81]",
        &["6:22 gravity is in [m/s^2], and `[0, -9.81]` is a pure number; write `9.81 [m/s^2]`"],
    );
    check(
        "gravity [0, -g]",
        "gravity [0, -m*g]",
        &["6:17 gravity is in [m/s^2], and `[0, -m*g]` is in [N] (m [kg], g [m/s^2])"],
    );
    check("gravity [0, -g]", "gravity [0, -l]", &["6:17 gravity is in [m/s^2], and `[0, -l]` is in [m] (l [m])"]);
    check(
        "gravity [0, -g]",
        "torque m*g on bob",
        &["6:16 a torque is in [N*m], and `m*g` is in [N] (m [kg], g [m/s^2])"],
    );
    check(
        "gravity [0, -g]",
        "torque 3 on bob",
        &["6:16 a torque is in [N*m], and `3` is a pure number; write `3 [N*m]`"],
    );
    check(
        "gravity [0, -g]",
        "torque -0.1*dot(phi) on bob",
        &[
            "6:17 a torque is in [N*m], and `-0.1*dot(phi)` is in [1/s] (phi [rad]); if a unit is missing, write `0.1 [N*m*s]`",
        ],
    );
    check(
        "gravity [0, -g]",
        "torque [m*g, 0].x*l + m on bob",
        &[
            "6:31 `[m*g, 0].x*l` is in [N*m] (m [kg], g [m/s^2], l [m]) and `m` is in [kg]; only quantities of one dimension can be added",
            "3:25 `m` is declared in [kg] here",
        ],
    );
    check(
        "gravity [0, -g]",
        "force [0, m*g*l] at P",
        &["6:15 a force is in [N], and `[0, m*g*l]` is in [N*m] (m [kg], g [m/s^2], l [m])"],
    );
    check(
        "gravity [0, -g]",
        "force [m*g, 0] at phi*P/l",
        &["6:27 the point of a force is in [m], and `phi*P/l` is a pure number (phi [rad], P [m], l [m])"],
    );
    check(
        "gravity [0, -g]",
        "force [0, -10] at P",
        &["6:20 a force is in [N], and `[0, -10]` is a pure number; write `10 [N]`"],
    );
    check(
        "gravity [0, -g]",
        "force -0.2*dot(P) at P",
        &["6:16 a force is in [N], and `-0.2*dot(P)` is in [m/s] (P [m]); if a unit is missing, write `0.2 [N*s/m]`"],
    );
}

/// Loads along scalars.
#[test]
fn elements() {
    check(
        "gravity [0, -g];",
        "spring 3, length l from [2*l, 0] to P;",
        &["6:16 the stiffness of a spring along a length is in [N/m], and `3` is a pure number; write `3 [N/m]`"],
    );
    check(
        "gravity [0, -g];",
        "spring m*g, length l from [2*l, 0] to P;",
        &["6:16 the stiffness of a spring along a length is in [N/m], and `m*g` is in [N] (m [kg], g [m/s^2])"],
    );
    check(
        "gravity [0, -g];",
        "spring m*g/l, length phi from [2*l, 0] to P;",
        &[
            "6:30 where a spring is at rest along a length is in [m], and `phi` is in [rad]",
            "2:15 `phi` is declared in [rad] here",
        ],
    );
    check("gravity [0, -g];", "spring m*g*l, rest 0.1 on phi;", &[]);
    check(
        "gravity [0, -g];",
        "spring m*g, rest 0.1 on phi;",
        &["6:16 the stiffness of a spring along an angle is in [N*m], and `m*g` is in [N] (m [kg], g [m/s^2])"],
    );
    check(
        "gravity [0, -g];",
        "spring m*stretch, length 0 from [2*l, 0] to P;",
        &["6:16 the force of a spring along a length is in [N], and `m*stretch` is in [kg*m] (m [kg], stretch [m])"],
    );
    check(
        "gravity [0, -g];",
        "damper 0.2 from [2*l, 0] to P;",
        &[
            "6:16 the coefficient of a damper along a length is in [N*s/m], and `0.2` is a pure number; write `0.2 [N*s/m]`",
        ],
    );
    check(
        "gravity [0, -g];",
        "damper 0.2*dot(phi) from [2*l, 0] to P;",
        &[
            "6:16 the coefficient of a damper along a length is in [N*s/m], and `0.2*dot(phi)` is in [1/s] (phi [rad]); if a unit is missing, write `0.2 [kg]`",
        ],
    );
    check(
        "gravity [0, -g];",
        "damper 0.2*abs(rate)*rate from [2*l, 0] to P;",
        &[
            "6:16 the force of a damper along a length is in [N], and `0.2*abs(rate)*rate` is in [m^2/s^2] (rate [m/s]); if a unit is missing, write `0.2 [kg/m]`",
        ],
    );
    check(
        "gravity [0, -g];",
        "damper m*g*l between phi and 2*phi;",
        &[
            "6:16 the coefficient of a damper along an angle is in [N*m*s], and `m*g*l` is in [N*m] (m [kg], g [m/s^2], l [m])",
        ],
    );
    check(
        "gravity [0, -g];",
        "damper m*g between phi and l;",
        &[
            "6:36 `phi` is in [rad] and `l` is in [m]; an element works between quantities of one dimension",
            "2:15 `phi` is declared in [rad] here",
            "3:14 `l` is declared in [m] here",
        ],
    );
    check(
        "gravity [0, -g];",
        "spring m*g/l, length l from [2, 0] to P;",
        &["6:38 the end of an element is in [m], and `[2, 0]` is a pure number; write `2 [m]`"],
    );
    check(
        "gravity [0, -g];",
        "potential m*g*phi;",
        &["6:19 a potential energy is in [N*m], and `m*g*phi` is in [N] (m [kg], g [m/s^2], phi [rad])"],
    );
    check(
        "gravity [0, -g];",
        "potential -9.81*m*P.y;",
        &[
            "6:20 a potential energy is in [N*m], and `-9.81*m*P.y` is in [kg*m] (m [kg], P [m]); if a unit is missing, write `9.81 [m/s^2]`",
        ],
    );
    check(
        "gravity [0, -g];",
        "dissipation m*dot(phi)^2;",
        &["6:21 a dissipation function is in [W], and `m*dot(phi)^2` is in [N/m] (m [kg], phi [rad])"],
    );
    check(
        "gravity [0, -g];",
        "force m*g on phi;",
        &["6:15 a force along an angle is in [N*m], and `m*g` is in [N] (m [kg], g [m/s^2])"],
    );
    check(
        "gravity [0, -g];",
        "torque m*g on l;",
        &[
            "6:16 a torque is in [N*m], and `m*g` is in [N] (m [kg], g [m/s^2])",
            "6:23 the angle that a torque turns is in [rad] or [deg] or a pure number, and `l` is in [m]",
            "3:14 `l` is declared in [m] here",
            "6:23 no coordinate changes this extent, so the load does nothing; leave it out",
        ],
    );
}

/// Bodies.
#[test]
fn bodies() {
    check(
        "mass m at P, angle phi",
        "mass l at P",
        &["5:20 a mass is in [kg], and `l` is in [m]", "3:14 `l` is declared in [m] here"],
    );
    check(
        "mass m at P, angle phi",
        "mass 2 at P",
        &["5:20 a mass is in [kg], and `2` is a pure number; write `2 [kg]`"],
    );
    check(
        "mass m at P, angle phi",
        "mass m at [sin(phi), -cos(phi)]",
        &["5:25 the position of a mass is in [m], and `[sin(phi), -cos(phi)]` is a pure number (phi [rad])"],
    );
    check(
        "mass m at P, angle phi",
        "mass m at P, inertia m*l, angle phi",
        &["5:36 an inertia is in [kg*m^2], and `m*l` is in [kg*m] (m [kg], l [m])"],
    );
    check(
        "mass m at P, angle phi",
        "mass m at P, inertia m*l^2, angle P.x",
        &[
            "5:49 the angle of a body is in [rad] or [deg] or a pure number, and `P.x` is in [m]",
            "4:5 `P` is defined here (l [m], phi [rad])",
        ],
    );
}

/// Start values and defaults.
#[test]
fn starts() {
    check("phi = 0.5", "phi = 2 [m]", &["7:17 `phi` is declared in [rad], and `2 [m]` is in [m]"]);
    check(
        "phi = 0.5",
        "phi = l",
        &["7:17 `phi` is declared in [rad], and `l` is in [m]", "3:14 `l` is declared in [m] here"],
    );
    check("phi = 0.5", "dot(phi) = 75 [rad]", &["7:22 `dot(phi)` is in [rad/s], and `75 [rad]` is in [rad]"]);
    check(
        "phi = 0.5",
        "dot(phi) = sqrt(g*l)",
        &["7:22 `dot(phi)` is in [rad/s], and `sqrt(g*l)` is in [m/s] (g [m/s^2], l [m])"],
    );
    check("phi = 0.5", "dot(phi) = sqrt(g/l)", &[]);
    check("l [m] = 1;", "l [m] = 1 [kg];", &["3:22 `l` is declared in [m], and `1 [kg]` is in [kg]"]);
    check(
        "l [m] = 1;",
        "l [m] = 3*40 [mm]; k = 3 [N/m];",
        &["3:37 `k` is declared without a unit (write `k [N/m]`), and `3 [N/m]` is in [N/m]"],
    );
}

/// Drawing.
#[test]
fn drawing() {
    check(
        "line [0, 0], P",
        "line [0, 1], P",
        &["9:20 a drawn point is in [m], and `[0, 1]` is a pure number; write `1 [m]`"],
    );
    check(
        "line [0, 0], P",
        "trace [0, 1]",
        &["9:21 a drawn point is in [m], and `[0, 1]` is a pure number; write `1 [m]`"],
    );
    check(
        "line [0, 0], P",
        "slider P along P.x",
        &[
            "9:26 the angle of a slider is in [rad] or [deg] or a pure number, and `P.x` is in [m]",
            "4:5 `P` is defined here (l [m], phi [rad])",
        ],
    );
    check(
        "line [0, 0], P",
        "circle P radius 0.1",
        &["9:27 a radius is in [m], and `0.1` is a pure number; write `0.1 [m]`"],
    );
}
