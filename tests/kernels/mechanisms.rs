//! Mechanisms that reach every part of the language and of the derivation; with the shipped ones they are what the
//! checks of this folder run over.

use sim::mechanism;

mechanism! {
    /// A bead on a rod that turns: mixed second derivatives.
    pub(crate) Bead;
    coordinates { r [m]; phi [rad]; }
    parameters { m [kg] = 2; J [kg*m^2] = 0.3; g [m/s^2] = 9.81; c [N*s/m] = 0.4; }
    let P = r*[cos(phi), sin(phi)];
    bodies { rod: inertia J, angle phi; bead: mass m at P; }
    loads { gravity [0, -g]; force -c*dot(P) at P; torque 0.1 [N*m]*sin(1 [rad/s]*t) on rod; }
    initial { r = 0.5; phi = 0.1; dot(phi) = 3; }
    outputs { speed [m/s] = norm(dot(P)); radial [m/s^2] = ddot(r) - r*dot(phi)^2; }
    kernels { dynamics_jacobian; dynamics_sensitivity; }
}

mechanism! {
    /// A double pendulum on a cart whose rail and support move as declared, closed by a rod that time drives.
    pub(crate) Cart;
    coordinates { x [m]; a [rad]; b [rad]; }
    parameters { M [kg] = 3; m [kg] = 1; n [kg] = 0.5; l [m] = 0.8; k [m] = 0.6; J [kg*m^2] = 0.05; g [m/s^2] = 9.81; w [1/s] = 2; }
    let O = [x, 0.1 [m]*sin(w*t)];
    let A = O + l*[sin(a), -cos(a)];
    let B = A + k*[sin(b), -cos(b)];
    bodies { cart: mass M at O; first: mass m at A, inertia J, angle a; second: mass n at B, inertia J*k/l, angle b - a/3; }
    loads { gravity [0.1 [m/s^3]*t, -g]; force [-2 [N/m]*x - 1 [kg/m]*dot(x)*abs(dot(x)), 0] at O; torque -0.1 [N*m*s]*dot(b - a) on second; }
    constraints { leash: norm(B - [0.2 [m], 0.3 [m]*cos(w*t)]) = 1.1 [m] + 0.05 [m]*sin(3 [rad/s]*t); }
    initial { x = 0.1; guess a = 0.2; b = 0.3; dot(x) = 0.4; dot(a) = 0.2; }
    events { low: B.y = -1 [m]; }
    outputs { tip [m] = B.x; tip_speed [m/s] = dot(B.x); tip_acceleration [m/s^2] = ddot(B.x); leash_force [N] = reaction(leash); }
    drawing { line O, A, B; ground [0, 0]; slider O along 0; circle B radius 0.05 [m]; point A; }
    kernels { dynamics_jacobian; dynamics_sensitivity; }
}

mechanism! {
    /// Every function of the language, and powers of every kind, in one potential-like load and one position: of numbers
    /// without units.
    pub(crate) Functions;
    coordinates { x; y; }
    parameters { m = 1; p = 1.7; type = 2; }
    let u = sin(x + cos(2*y)/3)*cos(y) + tan(x/4) + asin(x/9) + acos(y/9) + atan(x*y) + atan2(y, x + 5);
    let v = sqrt(x^2 + y^2 + 1) + exp(-x^2) + ln(x^2 + 3) + abs(x - 2*y) + sinh(x/3) + cosh(y/3) + tanh(x);
    let w = (x^2 + 1)^p + (y^2 + 2)^(1/3) + (x^2 + y^2 + 1)^(-3/2) + (y^2 + 1)^-2 + p^(x/5) + pi*e*x^5/type;
    bodies { point: mass m at [x + u/20, y + v/30]; }
    loads { force [w, u*v] at [x, y]; force [y, x]/(1 + x^2) at [v, x]; }
    initial { x = 0.5; y = 0.7; }
    events { even: u = v; }
    outputs { u = u; v = v; w = w; rate = dot(u*v); second = ddot(w); }
    kernels { dynamics_jacobian; dynamics_sensitivity; }
}

mechanism! {
    /// A rod in absolute coordinates with its pin as a constraint between vectors, and names that are Rust's.
    pub(crate) Rod;
    coordinates { x [mm]; q [mm]; phi [deg]; }
    parameters { l [mm] = 600; m [g] = 500; J [kg*m^2] = 0.015; r#fn [N] = 3; t0 = 2; }
    let G = [x, q];
    bodies { rod: mass m at G, inertia J, angle phi; }
    loads { gravity [0, -9.81 [m/s^2]]; force [r#fn, 0] at G + l/2*[cos(phi), sin(phi)]; }
    constraints { pin: G - l/2*[cos(phi), sin(phi)] = [0, 0]; }
    initial { phi = 30; guess x = 300; guess q = 100; dot(phi) = 60 [rpm]; }
    outputs { pin_x [kN] = reaction(pin).x; pin_y [N] = reaction(pin).y; }
    kernels { dynamics_jacobian; dynamics_sensitivity; }
}

mechanism! {
    /// A chain of eight rods in absolute angles from a support that shakes, its end on a moving line: long sums.
    pub(crate) Chain;
    coordinates { a1 [rad]; a2 [rad]; a3 [rad]; a4 [rad]; a5 [rad]; a6 [rad]; a7 [rad]; a8 [rad]; }
    parameters { m [kg] = 0.3; l [m] = 0.4; J [kg*m^2] = 0.01; k [N*s/m] = 0.2; w [1/s] = 3; }
    let P0 = 0.1 [m]*[sin(w*t), cos(2*w*t)];
    let G1 = P0 + 0.5*l*[sin(a1), -cos(a1)];
    let P1 = P0 + l*[sin(a1), -cos(a1)];
    let G2 = P1 + 0.5*l*[sin(a2), -cos(a2)];
    let P2 = P1 + l*[sin(a2), -cos(a2)];
    let G3 = P2 + 0.45*l*[sin(a3), -cos(a3)];
    let P3 = P2 + l*[sin(a3), -cos(a3)];
    let G4 = P3 + 0.5*l*[sin(a4), -cos(a4)];
    let P4 = P3 + l*[sin(a4), -cos(a4)];
    let G5 = P4 + 0.5*l*[sin(a5), -cos(a5)];
    let P5 = P4 + l*[sin(a5), -cos(a5)];
    let G6 = P5 + 0.5*l*[sin(a6), -cos(a6)];
    let P6 = P5 + l*[sin(a6), -cos(a6)];
    let G7 = P6 + 0.5*l*[sin(a7), -cos(a7)];
    let P7 = P6 + l*[sin(a7), -cos(a7)];
    let G8 = P7 + 0.5*l*[sin(a8), -cos(a8)];
    let P8 = P7 + l*[sin(a8), -cos(a8)];
    bodies {
        rod1: mass m at G1, inertia J, angle a1;
        rod2: mass m at G2, inertia J, angle a2;
        rod3: mass m at G3, inertia J, angle a3;
        rod4: mass 2*m at G4, inertia J, angle a4;
        rod5: mass m at G5, inertia J, angle a5;
        rod6: mass m at G6, inertia J, angle a6;
        rod7: mass m at G7, inertia J, angle a7;
        rod8: mass m at G8, inertia J, angle a8;
    }
    loads { gravity [0, -9.81 [m/s^2]]; force -k*dot(P5) at P5; force 1 [N]*[sin(1 [rad/s]*t), 2] at P8; torque 0.1 [N*m]*a2 on rod3; }
    constraints { line: P8.x + 0.2*P8.y = 0.3 [m]*sin(1 [rad/s]*t); }
    initial { guess a1 = -0.15; guess a2 = 0.0; guess a3 = 0.15; guess a4 = 0.3; guess a5 = 0.45; guess a6 = 0.6; guess a7 = 0.75; guess a8 = 0.9; }
    outputs { height [m] = P8.y; climb [m/s] = dot(P8.y); pull [N] = reaction(line); lift [m/s^2] = ddot(P6.x); }
    drawing { line P0, P1, P2, P3, P4, P5, P6, P7, P8; }
}

mechanism! {
    /// Seven links in relative angles on a slide, with a spring to a point and the last link held by a guide: angles that are sums.
    pub(crate) Arm;
    coordinates { x [m]; q1 [rad]; q2 [rad]; q3 [rad]; q4 [rad]; q5 [rad]; q6 [rad]; q7 [rad]; }
    parameters { m [kg] = 0.5; l [m] = 0.3; J [kg*m^2] = 0.02; c [N*m*s] = 0.05; s [N/m] = 20; }
    let P0 = [x, 0.05 [m/s^2]*t^2];
    let b1 = q1;
    let P1 = P0 + l*[cos(b1), sin(b1)];
    let b2 = b1 + q2;
    let P2 = P1 + l*[cos(b2), sin(b2)];
    let b3 = b2 + q3;
    let P3 = P2 + l*[cos(b3), sin(b3)];
    let b4 = b3 + q4;
    let P4 = P3 + l*[cos(b4), sin(b4)];
    let b5 = b4 + q5;
    let P5 = P4 + l*[cos(b5), sin(b5)];
    let b6 = b5 + q6;
    let P6 = P5 + l*[cos(b6), sin(b6)];
    let b7 = b6 + q7;
    let P7 = P6 + l*[cos(b7), sin(b7)];
    bodies {
        slide: mass 3*m at P0;
        link1: mass m at P0 + l/3*[cos(b1), sin(b1)], inertia J, angle b1;
        link2: mass m at P1 + l/3*[cos(b2), sin(b2)], inertia J, angle b2;
        link3: mass m at P2 + l/3*[cos(b3), sin(b3)], inertia J, angle b3;
        link4: mass m at P3 + l/3*[cos(b4), sin(b4)], inertia J, angle b4;
        link5: mass m at P4 + l/3*[cos(b5), sin(b5)], inertia J, angle b5;
        link6: mass m at P5 + l/3*[cos(b6), sin(b6)], inertia J, angle b6;
        link7: mass m at P6 + l/3*[cos(b7), sin(b7)], inertia J, angle b7;
    }
    loads { gravity [0, -9.81 [m/s^2]]; torque -c*dot(q3) on link3; torque c*dot(q3) on link2; force -s*(P4 - [0.5, 0.2]*1 [m]) at P4; force -0.05 [kg]*dot(P5)*abs(dot(b5)) at P5; }
    constraints { level: b7 = 0.2*sin(1 [rad/s]*t); rest: P7 = [0.9 [m] + 0.1 [m]*sin(1 [rad/s]*t), 0.3 [m]]; }
    initial { guess x = 0.1; guess q1 = 1.2; guess q2 = -0.7; guess q3 = -0.6; guess q4 = 0.3; guess q5 = -0.9; guess q6 = 0.4; guess q7 = 0.3; }
    outputs { angle [rad] = b6; push_x [N] = reaction(rest).x; turn [rad/s] = dot(b5); }
}

mechanism! {
    /// A cart with a pendulum and a wheel, and every load along a scalar: ends that move in time, laws of stretch and rate.
    pub(crate) Sprung;
    coordinates { x [m]; a [rad]; b [rad]; }
    parameters {
        M [kg] = 2; m [kg] = 0.7; l [m] = 0.6; J [kg*m^2] = 0.05; k [N/m] = 40; k3 [N/m^3] = 300; l0 [m] = 0.5; c [N*s/m] = 1.5;
        kt [N*m/rad] = 3; ct [N*m*s] = 0.2; b0 [deg] = 20; w [1/s] = 4;
    }
    let O = [x, 0.1 [m]*sin(w*t)];
    let P = O + l*[sin(a), -cos(a)];
    let anchor = [1.2 [m] + 0.1 [m]*cos(w*t), 0.9 [m]];
    bodies { cart: mass M at O; bob: mass m at P, inertia J, angle a; wheel: inertia J, angle b; }
    loads {
        gravity [0, -9.81 [m/s^2]];
        potential k*x^2/2 + 0.3 [J]*cos(b - 2*a)*exp(-(x/1 [m])^2) + 0.1 [N]*x*sin(w*t);
        dissipation c/2*inner(dot(P), dot(P)) + ct/2*dot(a - b)^2 + 0.02 [N*m*s^2]*abs(dot(b))^3;
        spring k, length l0 from anchor to P;
        spring k, length 0 from [0.3 [m], -2 [m]] to P;
        spring k*stretch + k3*stretch^3 + 0.2 [N*s/m]*rate, length l0 + 0.05 [m]*sin(1 [rad/s]*t) from O to [2 [m], 1.5 [m]];
        spring kt, rest b0 between a and b;
        spring kt*sin(stretch), rest b0 on b;
        damper c from anchor to P;
        damper c*rate + 0.1 [N*s^2/m^2]*rate*abs(rate) from O to [0, 1 [m]];
        damper ct between a and b;
        damper ct*1 [rad/s]*tanh(rate/1 [rad/s]) on a + b;
        force 3 [N]*sin(w*t) on x - l*a;
        force 2 [N] - 1 [N*s/m]*dot(x) from O to anchor;
        torque 0.4 [N*m] between a and b;
        torque 0.2 [N*m]*cos(1 [rad/s]*t) on b;
        torque ct*1 [rad/s] on wheel;
    }
    initial { x = 0.2; a = 0.4; b = -0.3; dot(x) = 0.5; }
    outputs { height [m] = P.y; }
    kernels { dynamics_jacobian; dynamics_sensitivity; }
}

mechanism! {
    /// A cart with two pendulums and a motor between them, pulled by an actuator, with every kind of input.
    pub(crate) Actuated;
    coordinates { x [m]; a [rad]; b [rad]; }
    parameters { M [kg] = 2; m [kg] = 0.7; l [m] = 0.6; k [N/m] = 30; size [N] = 4; }
    inputs {
        /// Torque of the motor.
        tau [N*m] = 0;
        pull [N] = size*sin(3 [rad/s]*t)^2;
        shift [mm] = 20;
        gain [N*s/m] = 1 [N*s/m] + 1 [N/m]*t;
    }
    let O = [x, 0];
    let P = O + l*[sin(a), -cos(a)];
    let Q = P + l*[sin(b), -cos(b)];
    let drag = gain*dot(P);
    bodies { cart: mass M at O; bob: mass m at P; tip: mass m at Q, angle b; }
    loads {
        gravity [0, -9.81 [m/s^2]];
        torque tau between a and b;
        force pull from [2 [m], 1 [m]] to Q;
        spring k, length 0.5 [m] + shift from [-1 [m], 0] to O;
        force -drag at P;
        torque tau^2/10 [N*m]*cos(b) on tip;
        dissipation gain*dot(x)^2;
    }
    initial { x = 0.1; a = 0.3; b = -0.2; }
    events { turn: dot(a) = 0; }
    outputs { power [W] = tau*dot(b - a); stretched [m] = x + shift; acceleration [m/s^2] = ddot(x) + gain*1 [m/(kg*s)]; height [m] = Q.y; }
    kernels { dynamics_jacobian; dynamics_sensitivity; }
}

mechanism! {
    /// A sled with a pole on a blade, on ice that drifts, its tip on a line: constraints between positions and between speeds.
    pub(crate) Sled;
    coordinates { x [m]; y [mm]; phi [rad]; psi [rad]; }
    parameters { m [kg] = 3; J [kg*m^2] = 0.2; a [m] = 0.3; l [m] = 0.7; n [kg] = 0.4; v [m/s] = 0.2; c [N*s/m] = 0.5; }
    let P = [x, y];
    let across = [-sin(phi), cos(phi)];
    auxiliary { bx [m]; by [m]; foot [mm]; turn [rad]; }
    let slip = inner(dot(P + [bx, by]) - v*[sin(2 [rad/s]*t), 0.3], across);
    let G = P + a*[cos(phi), sin(phi)];
    let tip = G + [foot, 0] + l*[cos(psi + turn), sin(psi + turn)];
    bodies { sled: mass m at G, inertia J, angle phi; pole: mass n at tip, inertia J/9, angle psi + turn; }
    loads {
        force [1 [N], 0.2 [N/s]*t] at G; force -c*dot(tip) at tip; torque 1 [N*m]*sin(1 [rad/s]*t) on pole;
        dissipation c*inner(dot(tip), dot(tip)); spring 20 [N/m], length l from [0, 1 [m]] to tip;
    }
    constraints { blade: slip = 0; rail: tip.y + 0.1*tip.x = 0.4 [m] + 0.05 [m]*sin(1 [rad/s]*t); }
    initial { phi = 0.3; dot(phi) = 1; guess y = 100; guess psi = 0.2; }
    outputs { side [N] = reaction(blade); rail [N] = reaction(rail); sideways [m/s] = slip;
        blade_x [N] = reaction(bx); blade_y [N] = reaction(by); foot [N] = reaction(foot); moment [N*m] = reaction(turn)*cos(psi); }
    drawing { line P, G, tip; ground [0, 0]; }
    kernels { dynamics_jacobian; dynamics_sensitivity; }
}

mechanism! {
    /// Seven rods in a chain from a support that shakes, the last on two blades: long sums, and speeds of a point in them.
    pub(crate) Snake;
    coordinates { a1 [rad]; a2 [rad]; a3 [rad]; a4 [rad]; a5 [rad]; a6 [rad]; a7 [rad]; }
    parameters { m [kg] = 0.3; l [m] = 0.4; J [kg*m^2] = 0.01; w [1/s] = 3; }
    let P0 = 0.1 [m]*[sin(w*t), cos(2*w*t)];
    let P1 = P0 + l*[sin(a1), -cos(a1)];
    let P2 = P1 + l*[sin(a2), -cos(a2)];
    let P3 = P2 + l*[sin(a3), -cos(a3)];
    let P4 = P3 + l*[sin(a4), -cos(a4)];
    let P5 = P4 + l*[sin(a5), -cos(a5)];
    let P6 = P5 + l*[sin(a6), -cos(a6)];
    let P7 = P6 + l*[sin(a7), -cos(a7)];
    bodies {
        rod1: mass m at P1, inertia J, angle a1;
        rod2: mass m at P2, inertia J, angle a2;
        rod3: mass m at P3, inertia J, angle a3;
        rod4: mass 2*m at P4, inertia J, angle a4;
        rod5: mass m at P5, inertia J, angle a5;
        rod6: mass m at P6, inertia J, angle a6;
        rod7: mass m at P7, inertia J, angle a7;
    }
    loads { gravity [0, -9.81 [m/s^2]]; force 1 [N]*[sin(1 [rad/s]*t), 2] at P7; }
    constraints { blade: inner(dot(P7), [cos(a7), sin(a7)]) = 0.1 [m/s]*sin(1 [rad/s]*t); other: dot(P4.x) = 0; }
    initial { guess a1 = -0.15; guess a2 = 0.0; guess a3 = 0.15; guess a4 = 0.3; guess a5 = 0.45; guess a6 = 0.6; guess a7 = 0.75; }
    outputs { height [m] = P7.y; pull [N] = reaction(blade); }
}

mechanism! {
    /// A motor that lifts a bar by a gear and a rack, the bar in a slot and on a link: bodies and joints.
    pub(crate) Hoist;
    coordinates { turn [rad]; }
    parameters { m [kg] = 2; J [kg*m^2] = 0.1; r [m] = 0.1; s [m] = 0.25; l [m] = 0.9; T [N*m] = 3; g [m/s^2] = 9.81; }
    auxiliary { cut [m]; }
    bodies {
        motor: inertia J, angle turn;
        wheel: free, mass 2*m, inertia 3*J;
        bar: free, mass m, inertia J/3;
        weight: mass m/3 at on(bar, [0.5 [m] + cut, 0.1 [m]]);
    }
    loads { gravity [0, -g]; torque T*cos(1 [rad/s]*t) on motor; force [0.1 [N/s]*t, 1 [N]] at on(wheel, [r, s]); }
    joints {
        axle: pin on(wheel, [0, 0]) to [0.3 [m], 0.1 [m]*sin(1 [rad/s]*t)];
        mesh: gear motor radius r to wheel radius s;
        lift: rack on(bar, [0, -0.2 [m]]) through on(wheel, [0, 0]) along 1.2 on wheel radius r;
        rest: slot on(bar, [0.3 [m], 0]) through [0.5 [m], 0] along 0.1 [rad/s]*t;
    }
    initial { turn = 0.2; guess wheel_phi = -0.1; guess bar_x = 0.4; }
    outputs { pull [N] = reaction(lift); cut [N] = reaction(cut); tip [m] = on(bar, [0.5 [m], 0]).y; }
    drawing { line on(bar, [-0.5 [m], 0]), on(bar, [0.5 [m], 0]); circle on(wheel, [0, 0]) radius r; }
}

mechanism! {
    /// A cart with a pendulum; a rod that time drives, a pin and a stop come and go.
    pub(crate) Switched;
    coordinates { x [m]; a [rad]; b [deg]; }
    parameters { M [kg] = 3; m [kg] = 1; l [m] = 0.8; k [m] = 0.6; J [kg*m^2] = 0.05; g [m/s^2] = 9.81; e1 = 0.4; }
    let O = [x, 0.1 [m]*sin(2 [rad/s]*t)];
    let A = O + l*[sin(a), -cos(a)];
    let B = A + k*[sin(b), -cos(b)];
    bodies { cart: mass M at O; first: mass m at A, inertia J, angle a; second: mass m at B, inertia J, angle b; }
    loads { gravity [0, -g]; force [-2 [N/m]*x - 1 [N*s/m]*dot(x), 0] at O; torque -0.1 [N*m*s]*dot(b - a) on second; }
    constraints {
        rod: norm(B - [0.2 [m], 0.3 [m]*cos(1 [rad/s]*t)]) = 1.1 [m] + 0.05 [m]*sin(3 [rad/s]*t) initially released;
        rail: x + 0.1 [m]*a = 0.2 [m]*sin(1 [rad/s]*t);
        lock: b = a + 0.1 [rad] initially active;
    }
    initial { x = 0; guess a = 0.2; b = 10; }
    events {
        apart: reaction(lock) + 0.1 [m]*reaction(rod) = 0.3 [N*m] falling { release lock; activate rod; }
        knock: b - a = 0.1 [rad] rising { impact lock restitution e1*abs(dot(a))/1 [rad/s]; impact rod; swap a, b; set m = 1.1*m; }
        hurried: ddot(x) = 1 [m/s^2] { set b = 3; set dot(b) = 30; set dot(a) = -dot(a) + 1 [rad/s^2]*t; stop after 3; }
    }
    outputs { pull [N] = reaction(rod); hold [N*m] = reaction(lock); slide [N] = reaction(rail); }
    kernels { dynamics_jacobian; dynamics_sensitivity; }
}

mechanism! {
    /// A cart with a pendulum and stops, a one-sided spring, dry friction and a wheel of two radii: choices in loads, in a position
    /// and in a constraint, with branches that have no value where they are not taken: of numbers without units.
    pub(crate) Chosen;
    coordinates { x; a; s; }
    parameters { M = 2; m = 0.7; l = 0.6; k = 400; F = 3; v0 = 0.05; c = 2; }
    let O = [x, if s > 0.2 then 0.1*(s - 0.2)^2 else 0];
    let P = O + l*[sin(a), -cos(a)];
    let hill = if x >= 0 then [x, sqrt(x)^3/9] else [x, -x^2/3];
    bodies { cart: mass M at O; bob: mass m at P, angle a; follower: mass m/2 at [s, max(0.2*s, -s, s^2 - 1)]; bead: mass 0.1 at hill; }
    loads {
        gravity [0, -9.81];
        spring max(k*stretch, 0), length 0.4 from [1.5, 0] to O;
        spring if stretch < 0 then k*stretch + c*min(rate, 0) else 0, rest 0.1 on s;
        friction F, smooth v0 on x;
        friction F/3, smooth v0/l between 0 and a;
        friction F/2, smooth v0 from [0, 1] to P;
        force -sign(x)*0.3 on x;
        force if dot(s) <= 0 then -c*dot(s) else -c*dot(s)^2 on s;
        damper if (abs(rate) < 1) then c*rate else c*sqrt(rate^2 - 1)*sign(rate) + c*rate on s - a;
    }
    constraints { lift: s = if x < 0 then 0.4*x^3 else 0.2*x^2; }
    initial { x = 0.3; a = 0.4; dot(x) = 0.2; guess s = 0; }
    outputs { height = min(O.y, P.y, 0.1); rate = dot(max(P.x, s)); }
    kernels { dynamics_jacobian; dynamics_sensitivity; }
}

mechanism! {
    /// A four-bar with its coupler tilted by a parameter: its rows are turned by that angle.
    pub(crate) Tilted;
    coordinates { coupler [rad]; crank [rad]; rocker [rad]; }
    parameters {
        m [kg] = 1.3; r [m] = 0.4; l [m] = 1.1; k [m] = 0.9; d [m] = 1; tilt [rad] = 0.3;
        g [m/s^2] = 9.81;
    }
    let phi = coupler + tilt;
    let A = r*[cos(crank), sin(crank)];
    let along = [cos(phi), sin(phi)];
    let B = A + l*along;
    bodies {
        crank_rod: mass m at A/2, inertia m*r^2/12, angle crank;
        coupler_rod: mass m at A + l/2*along, inertia m*l^2/12, angle phi;
        rocker_rod: mass 2*m at [d, 0], inertia m*k^2/3, angle rocker;
    }
    loads { gravity [0, -g]; torque -0.2 [N*m*s]*dot(crank) on crank_rod; }
    constraints { closed: B = [d, 0] + k*[cos(rocker), sin(rocker)]; }
    initial { guess coupler = 0.2; guess crank = 1; guess rocker = 1.4; }
    outputs { pin [N] = norm(reaction(closed)); }
    kernels { dynamics_jacobian; dynamics_sensitivity; }
}
