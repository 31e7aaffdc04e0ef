//! Mechanisms in the plane.

use sim::mechanism;

mechanism! {
    /// LANGUAGE.md, Joints: a slider-crank of bodies and joints. With r = 15 mm, l = 45 mm and equal steps: nonsense.
    pub(crate) Engine;
    parameters { r [m] = 0.15; l [m] = 0.45; m [kg] = 1; g [m/s^2] = 9.81; }
    bodies {
        crank: free, mass m, inertia m*r^2/12;
        rod: free, mass 2*m, inertia m*l^2/6;
        piston: free, mass m, inertia 0.01 [kg*m^2];
    }
    loads { gravity [0, -g]; }
    joints {
        main: pin on(crank, [-r/2, 0]) to [0, 0];
        big_end: pin on(rod, [-l/2, 0]) to on(crank, [r/2, 0]);
        small_end: pin on(piston, [0, 0]) to on(rod, [l/2, 0]);
        cylinder: slide piston through [0, 0] along 0;
    }
    initial { crank_phi = 0.5; dot(crank_phi) = 20; guess crank_x = 0.07; guess rod_x = 0.35; guess piston_x = 0.6; }
    outputs { wall [N] = -reaction(cylinder); bearing [N] = norm(reaction(main)); }
    drawing { ground [0, 0]; line [0, 0], on(crank, [r/2, 0]), on(rod, [l/2, 0]); slider on(piston, [0, 0]) along 0; }
}

mechanism! {
    /// A four-bar of three free bodies, in millimetres: equal steps give nonsense.
    pub(crate) FourBarSmall;
    parameters { a [mm] = 20; b [mm] = 50; c [mm] = 40; d [mm] = 50; m [kg] = 0.1; g [m/s^2] = 9.81; }
    bodies {
        crank: free, mass m, inertia m*a^2/12;
        coupler: free, mass m, inertia m*b^2/12;
        rocker: free, mass m, inertia m*c^2/12;
    }
    loads { gravity [0, -g]; }
    joints {
        A0: pin on(crank, [-a/2, 0]) to [0, 0];
        B0: pin on(rocker, [-c/2, 0]) to [d, 0];
        A: pin on(coupler, [-b/2, 0]) to on(crank, [a/2, 0]);
        B: pin on(coupler, [b/2, 0]) to on(rocker, [c/2, 0]);
    }
    initial {
        crank_phi = 1; dot(crank_phi) = 20;
        guess crank_x = 5; guess crank_y = 8; guess coupler_x = 34; guess coupler_y = 26; guess coupler_phi = 0.4;
        guess rocker_x = 53; guess rocker_y = 18; guess rocker_phi = 1.5;
    }
}

mechanism! {
    /// Starts in a singular position.
    pub(crate) Rhombus;
    coordinates { theta [rad]; phi [rad]; }
    parameters { l [m] = 1; m [kg] = 1; }
    let A = l*[cos(theta), sin(theta)];
    let C = A + l*[cos(phi), sin(phi)];
    bodies { crank: mass m at A/2, inertia m*l^2/12, angle theta; rod: mass m at (A + C)/2, inertia m*l^2/12, angle phi; }
    constraints { rail: C.y = 0; }
    initial { theta = pi/2; dot(theta) = 1; guess phi = -1.5; }
}

mechanism! {
    /// LANGUAGE.md, Events: `sim poincare swing --event period` finds no period.
    pub(crate) Swing;
    coordinates { phi [deg]; }
    parameters { l [m] = 2.2; g [m/s^2] = 9.81; }
    bodies { seat: mass 30 [kg] at l*[sin(phi), -cos(phi)]; }
    loads { gravity [0, -g]; }
    initial { phi = 50; }
    events {
        lowest: phi = 0;
        period: dot(phi) = 0 falling;
    }
}

mechanism! {
    /// N four-bars with N = 2, in angles of all links: two loops, starts upright, passes the flat positions.
    pub(crate) TwoFourBars;

    const N = 2;

    fragment Link(base, phi) {
        let tip = base + l*[sin(phi), cos(phi)];
        bodies { bar: mass m at (base + tip)/2, inertia m*l^2/12, angle -phi; }
        drawing { line base, tip; }
    }
    coordinates {
        repeat i in 0..=N { th_[i] [rad]; }
        repeat i in 1..=N { ps_[i] [rad]; }
    }
    parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 9.81; v0 [m/s] = 1; }
    repeat i in 0..=N {
        use Link([i*l, 0], th_[i]) as crank_[i];
    }
    repeat i in 1..=N {
        use Link(crank_[i-1]_tip, ps_[i]) as coupler_[i];
        constraints { loop_[i]: coupler_[i]_tip = crank_[i]_tip; }
    }
    loads { gravity [0, -g]; }
    initial {
        th_0 = 0;
        dot(th_0) = v0/l;
        repeat i in 1..=N { guess th_[i] = 0; guess ps_[i] = pi/2; }
    }
    outputs {
        B0_x [m] = crank_0_tip.x; B0_y [m] = crank_0_tip.y;
        B0_vx [m/s] = dot(crank_0_tip.x); B0_vy [m/s] = dot(crank_0_tip.y);
    }
}

mechanism! {
    /// N four-bars with N = 2, of free bodies and pins: fifteen coordinates, fourteen equations.
    pub(crate) TwoFourBarsFree;

    const N = 2;
    parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 9.81; v0 [m/s] = 1; }
    bodies {
        repeat i in 0..=N { crank_[i]: free, mass m, inertia m*l^2/12; }
        repeat i in 1..=N { coupler_[i]: free, mass m, inertia m*l^2/12; }
    }
    loads { gravity [0, -g]; }
    joints {
        repeat i in 0..=N { ground_[i]: pin on(crank_[i], [-l/2, 0]) to [i*l, 0]; }
        repeat i in 1..=N {
            start_[i]: pin on(coupler_[i], [-l/2, 0]) to on(crank_[i-1], [l/2, 0]);
            end_[i]: pin on(coupler_[i], [l/2, 0]) to on(crank_[i], [l/2, 0]);
        }
    }
    initial {
        crank_0_phi = pi/2;
        dot(crank_0_phi) = -v0/l;
        repeat i in 0..=N { guess crank_[i]_x = i*l; guess crank_[i]_y = l/2; }
        repeat i in 1..=N { guess crank_[i]_phi = pi/2; guess coupler_[i]_x = (i - 1/2)*l; guess coupler_[i]_y = l; }
    }
    let B0 = on(crank_0, [l/2, 0]);
    outputs {
        B0_x [m] = B0.x; B0_y [m] = B0.y; B0_vx [m/s] = dot(B0.x); B0_vy [m/s] = dot(B0.y);
    }
    drawing {
        repeat i in 0..=N { ground [i*l, 0]; line [i*l, 0], on(crank_[i], [l/2, 0]); }
        repeat i in 1..=N { line on(coupler_[i], [-l/2, 0]), on(coupler_[i], [l/2, 0]); }
    }
}

mechanism! {
    /// A slider-crank of two equal rods, through its singular position.
    pub(crate) SliderCrankSingular;

    coordinates { theta [rad]; phi [rad]; }
    parameters { l [m] = 1; m [kg] = 1; g [m/s^2] = 9.81; }
    let A = l*[cos(theta), sin(theta)];
    let C = A + l*[cos(phi), sin(phi)];
    bodies {
        crank: mass m at A/2, inertia m*l^2/12, angle theta;
        rod: mass m at (A + C)/2, inertia m*l^2/12, angle phi;
    }
    loads { gravity [0, -g]; }
    constraints { rail: C.y = 0; }
    initial { theta = pi/4; dot(theta) = 4/(2*sin(pi/4)); guess phi = -pi/4; }
    events { singular: theta = pi/2; turn: theta = pi/4 + 2*pi; }
    outputs { x [m] = C.x; x_speed [m/s] = dot(C.x); }
    drawing { ground [0, 0]; line [0, 0], A, C; slider C along 0; }
}

mechanism! {
    /// The same, whose end C hits the wall x = 0 at once.
    pub(crate) BarsAtAWall;

    parameters {
        l [m] = 0.6; m [kg] = 0.0603; g [m/s^2] = 9.81; w [rpm] = 60; rebound = 0;
    }
    bodies { b1: free, mass m, inertia m*l^2/12; b2: free, mass m, inertia m*l^2/12; }
    loads { gravity [g, 0]; }
    joints {
        A: pin on(b1, [-l/2, 0]) to [0, 0];
        B: pin on(b2, [-l/2, 0]) to on(b1, [l/2, 0]);
    }
    constraints { wall: on(b2, [l/2, 0]).x = 0 initially released; }
    initial {
        b1_phi = pi/2; b2_phi = pi/2; dot(b1_phi) = w; dot(b2_phi) = w;
        guess b1_x = 0; guess b1_y = l/2; guess b2_x = 0; guess b2_y = 3*l/2;
    }
    events { hit: on(b2, [l/2, 0]).x = 0 falling { impact wall restitution rebound; } }
    outputs {
        energy [J] = m*(inner(dot(on(b1, [0, 0])), dot(on(b1, [0, 0]))) + inner(dot(on(b2, [0, 0])), dot(on(b2, [0, 0]))))/2
            + m*l^2/24*(dot(b1_phi)^2 + dot(b2_phi)^2);
    }
    drawing { line [0, 0], on(b1, [l/2, 0]), on(b2, [l/2, 0]); }
}

mechanism! {
    /// A mass on a circle in absolute coordinates.
    pub(crate) PendulumIndex3;

    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 1; }
    let P = [x, y];
    bodies { bob: mass m at P; }
    loads { gravity [0, -g]; }
    constraints { circle: (x^2 + y^2 - l^2)/2 = 0; }
    initial { x = 1; y = 0; dot(x) = 0; dot(y) = 1; }
    outputs { lambda [N/m] = reaction(circle); }
    drawing { ground [0, 0]; line [0, 0], P; }
}

mechanism! {
    /// Crank shaper: crank on a pivot, rocker through the crank pin.
    pub(crate) CrankShaper;

    coordinates { alpha [deg]; beta [deg]; }
    parameters { r [m] = 0.2; d [m] = 0.3; J [kg*m^2] = 1; }
    let A = [0, d] + r*[cos(alpha), sin(alpha)];
    bodies { crank: inertia J, angle alpha; rocker: inertia J, angle beta; }
    joints { pin_in_slot: slot A through [0, 0] along beta; }
    initial { alpha = 0; guess beta = 57; }
    outputs { swing [deg] = beta; tool [m] = cos(beta)*1 [m]; }
    drawing { ground [0, 0], [0, d]; line [0, d], A; line [0, 0], 2*d*[cos(beta), sin(beta)]; slider A along beta; }
}

mechanism! {
    /// One leg of Theo Jansen's walker, its crank driven at constant speed.
    pub(crate) JansenLeg;

    coordinates {
        /// Angle of the crank.
        alpha [deg];
        tj [deg]; tb [deg]; tk [deg]; tc [deg]; tf [deg]; tg [deg];
    }
    parameters {
        /// Crank.
        m [mm] = 15;
        a [mm] = 38; b [mm] = 41.5; c [mm] = 39.3; d [mm] = 40.1; e1 [mm] = 55.8; f [mm] = 39.4;
        g1 [mm] = 36.7; h [mm] = 65.7; i [mm] = 49; j [mm] = 50; k [mm] = 61.9; l [mm] = 7.8;
        /// Mass per length of all bars.
        rho [kg/m] = 0.5;
        /// Speed of the crank.
        n [rpm] = 60;
        g [m/s^2] = 9.81;
    }
    fragment Bar(P, Q, th, len) {
        let mass_ = rho*len;
        bodies { bar: mass mass_ at (P + Q)/2, inertia mass_*len^2/12, angle th; }
        drawing { line P, Q; }
    }

    let O = [0, 0];
    let B = [-a, -l];
    let C = m*[cos(alpha), sin(alpha)];
    let D = B + b*[cos(tb), sin(tb)];
    let gamma = acos((b^2 + d^2 - e1^2)/(2*b*d));
    let F = B + d*[cos(tb + gamma), sin(tb + gamma)];
    let E = B + c*[cos(tc), sin(tc)];
    let G = E + g1*[cos(tg), sin(tg)];
    let delta = acos((g1^2 + i^2 - h^2)/(2*g1*i));
    let P = E + i*[cos(tg + delta), sin(tg + delta)];

    use Bar(O, C, alpha, m) as crank;
    use Bar(C, D, tj, j) as rod_j;
    use Bar(B, D, tb, b) as rod_b;
    use Bar(B, F, tb, d) as rod_d;
    use Bar(D, F, tb, e1) as rod_e;
    use Bar(C, E, tk, k) as rod_k;
    use Bar(B, E, tc, c) as rod_c;
    use Bar(F, G, tf, f) as rod_f;
    use Bar(E, G, tg, g1) as rod_g;
    use Bar(G, P, tg, h) as rod_h;
    use Bar(E, P, tg, i) as rod_i;

    loads { gravity [0, -g]; }
    constraints {
        upper: C + j*[cos(tj), sin(tj)] = D;
        lower: C + k*[cos(tk), sin(tk)] = E;
        foot: F + f*[cos(tf), sin(tf)] = G;
        drive: alpha = n*t;
    }
    initial {
        guess tj = 140; guess tb = 100; guess tk = 200; guess tc = -100; guess tf = -90; guess tg = 180;
    }
    events { period: alpha = 2*pi; }
    outputs {
        foot_path "Foot" {
            /// horizontal
            foot_x [mm] = P.x;
            /// vertical
            foot_y [mm] = P.y;
        }
        torque "Driving torque" {
            /// on the crank
            T_drive [N*m] = -reaction(drive);
        }
    }
    drawing { ground O, B; }
}

mechanism! {
    /// A slider-crank of free bodies, of 3 and 9 mm: reactions between adaptive steps.
    pub(crate) SliderCrankTiny;
    parameters { r [m] = 0.003; l [m] = 0.009; e0 [m] = 0.0006; m1 [kg] = 1; m2 [kg] = 2; m3 [kg] = 1.5; g [m/s^2] = 0; T [N*m] = 0; k [N/m] = 0; kd [N*s/m] = 0;
        th [rad] = 0; ph [rad] = 0.0667; w [rad/s] = 20; }
    bodies { crank: free, mass m1, inertia m1*r^2/12; rod: free, mass m2, inertia m2*l^2/12; piston: free, mass m3, inertia m3*r^2/100; }
    joints {
        main: pin on(crank, [-r/2, 0]) to [0, 0];
        big_end: pin on(rod, [-l/2, 0]) to on(crank, [r/2, 0]);
        small_end: pin on(piston, [0, 0]) to on(rod, [l/2, 0]);
        cylinder: slide piston through [0, e0] along 0;
    }
    let C = on(piston, [0, 0]);
    initial { crank_phi = th; dot(crank_phi) = w; guess crank_x = r/2*cos(th); guess crank_y = r/2*sin(th); guess rod_phi = ph; guess rod_x = r*cos(th) + l/2*cos(ph); guess rod_y = r*sin(th) + l/2*sin(ph); guess piston_x = r*cos(th) + l*cos(ph); guess piston_y = e0; }
    events { period: crank_phi = th + 2*pi; dead: dot(C.x) = 0; }
    kernels { }
    loads { gravity [0, -g]; torque T on crank; force [-k*(C.x - l) - kd*dot(C.x), 0] at C; }
    outputs {
        o_x [m] = C.x; o_v [m/s] = dot(C.x); o_a [m/s^2] = ddot(C.x); o_th [rad] = crank_phi; o_w [rad/s] = dot(crank_phi); o_e [rad/s^2] = ddot(crank_phi); o_ph [rad] = rod_phi; o_wp [rad/s] = dot(rod_phi); o_N [N] = -reaction(cylinder);
    }
}

mechanism! {
    /// The same in angles: right.
    pub(crate) SliderCrankTinyAngles;
    coordinates { theta [deg]; phi [rad]; }
    parameters { r [m] = 0.003; l [m] = 0.009; e0 [m] = 0.0006; m1 [kg] = 1; m2 [kg] = 2; m3 [kg] = 1.5; g [m/s^2] = 0; T [N*m] = 0; k [N/m] = 0; kd [N*s/m] = 0;
        th [rad] = 0; ph [rad] = 0.0667; w [rad/s] = 20; }
    let A = r*[cos(theta), sin(theta)];
    let C = A + l*[cos(phi), sin(phi)];
    bodies { crank: mass m1 at A/2, inertia m1*r^2/12, angle theta; rod: mass m2 at (A + C)/2, inertia m2*l^2/12, angle phi; piston: mass m3 at C; }
    constraints { guide: C.y = e0; }
    initial { theta = th; dot(theta) = w; guess phi = ph; }
    events { period: theta = th + 2*pi; dead: dot(C.x) = 0; }
    loads { gravity [0, -g]; torque T on crank; force [-k*(C.x - l) - kd*dot(C.x), 0] at C; }
    outputs {
        o_x [m] = C.x; o_v [m/s] = dot(C.x); o_a [m/s^2] = ddot(C.x); o_th [rad] = theta; o_w [rad/s] = dot(theta); o_e [rad/s^2] = ddot(theta); o_ph [rad] = phi; o_wp [rad/s] = dot(phi); o_N [N] = -reaction(guide);
    }
}

mechanism! {
    /// A four-bar of free bodies of half a millimetre, whose start is refused.
    pub(crate) FourBarTiny;
    parameters { a [m] = 0.000449; b [m] = 0.0010388; c [m] = 0.00119; d [m] = 0.000682; m2 [kg] = 2; m3 [kg] = 4; m4 [kg] = 3; g [m/s^2] = 0;
        T [N*m] = 0; k [N/m] = 0; l0 [m] = 0.1; kd [N*m*s] = 0; th2 [rad] = -1.116729803243; th3 [rad] = 2.218919451085; th4 [rad] = 2.776921958630; w [rad/s] = -10; }
    let S = [0, -2*(a + b)];
    bodies { crank: free, mass m2, inertia m2*a^2/12; coupler: free, mass m3, inertia m3*b^2/12; rocker: free, mass m4, inertia m4*c^2/12; }
    loads { gravity [0, -g]; torque T on crank; spring k, length l0 from S to on(coupler, [(0.317 - 0.5)*b, 0]); torque -kd*dot(rocker_phi) on rocker; }
    joints {
        pA0: pin on(crank, [-a/2, 0]) to [0, 0];
        pB0: pin on(rocker, [-c/2, 0]) to [d, 0];
        pA: pin on(coupler, [-b/2, 0]) to on(crank, [a/2, 0]);
        pB: pin on(coupler, [b/2, 0]) to on(rocker, [c/2, 0]);
    }
    let B = on(rocker, [c/2, 0]);
    initial { crank_phi = th2; dot(crank_phi) = w; guess crank_x = a/2*cos(th2); guess crank_y = a/2*sin(th2); guess coupler_phi = th3; guess rocker_phi = th4;
        guess coupler_x = a*cos(th2) + b/2*cos(th3); guess coupler_y = a*sin(th2) + b/2*sin(th3); guess rocker_x = d + c/2*cos(th4); guess rocker_y = c/2*sin(th4); }
    events { period: crank_phi = th2 + 2*pi; }
    kernels { }
    outputs {
        o_Bx [m] = B.x; o_By [m] = B.y; o_Bvx [m/s] = dot(B.x); o_Bvy [m/s] = dot(B.y); o_Bax [m/s^2] = ddot(B.x); o_Bay [m/s^2] = ddot(B.y);
        o_th2 [rad] = crank_phi; o_th3 [rad] = coupler_phi; o_th4 [rad] = rocker_phi; o_w2 [rad/s] = dot(crank_phi); o_w3 [rad/s] = dot(coupler_phi); o_w4 [rad/s] = dot(rocker_phi);
        o_e2 [rad/s^2] = ddot(crank_phi); o_e4 [rad/s^2] = ddot(rocker_phi); o_FBx [N] = reaction(pB).x; o_FBy [N] = reaction(pB).y; o_FAx [N] = reaction(pA).x; o_FAy [N] = reaction(pA).y; o_F2x [N] = reaction(pA0).x; o_F2y [N] = reaction(pA0).y;
    }
}
