//! Mechanisms in space.

use sim::mechanism;

mechanism! {
    /// By joints alone: five hinges are coordinates, the sixth closes the loop.
    pub(crate) BricardJoints;
    parameters { m [kg] = 1; l [m] = 1; h [m] = 0.1; g [m/s^2] = 9.81; }
    let a = m*(l^2 + h^2)/12;
    let c = m*h^2/6;
    bodies {
        rod1: mass m, inertia [c, a, a];
        rod2: mass m, inertia [a, c, a];
        rod3: mass m, inertia [a, a, c];
        rod4: mass m, inertia [c, a, a];
        rod5: mass m, inertia [a, c, a];
    }
    joints {
        t1: revolute ground at [0, 0, 0] axis [0, 1, 0] to rod1 at [-l/2, 0, 0] axis [0, 1, 0];
        t2: revolute rod1 at [l/2, 0, 0] axis [0, 0, 1] to rod2 at [0, l/2, 0] axis [0, 0, 1];
        t3: revolute rod2 at [0, -l/2, 0] axis [1, 0, 0] to rod3 at [0, 0, -l/2] axis [1, 0, 0];
        t4: revolute rod3 at [0, 0, l/2] axis [0, 1, 0] to rod4 at [l/2, 0, 0] axis [0, 1, 0];
        t5: revolute rod4 at [-l/2, 0, 0] axis [0, 0, 1] to rod5 at [0, -l/2, 0] axis [0, 0, 1];
        t6: revolute rod5 at [0, l/2, 0] axis [1, 0, 0] to ground at [0, 0, l] axis [1, 0, 0];
    }
    loads { gravity [0, -g, 0]; }
    initial { t1 = 0; dot(t1) = 0; guess t2 = 0; guess t3 = 0; guess t4 = 0; guess t5 = 0; }
    let P3 = on(rod2, [0, -l/2, 0]);
    events { rest: dot(t1) = 0; quarter: t1 = pi/2 rising; }
    outputs {
        px [m] = P3.x; py [m] = P3.y; pz [m] = P3.z; th1 [rad] = t1; th3 [rad] = t3; th5 [rad] = t5; th2 [rad] = t2; th4 [rad] = t4; rate [rad/s] = dot(t1);
        potential_energy [J] = m*g*(on(rod1, [0, 0, 0]).y + on(rod2, [0, 0, 0]).y + on(rod3, [0, 0, 0]).y + on(rod4, [0, 0, 0]).y + on(rod5, [0, 0, 0]).y);
    }
}

mechanism! {
    /// By joints alone: spin, slider, two arms.
    pub(crate) FlyballJoints;
    parameters { K [N/m] = 800000; C [N*s/m] = 40000; g [m/s^2] = 9.81; w0 [rad/s] = 6.283185307179586; }
    let mr = 0.3 [kg];
    let ms = 3 [kg];
    let mb = 5 [kg];
    let Jt = mr*(1 [m^2] + 1e-4 [m^2])/12;
    let Ja = mr*2e-4 [m^2]/12;
    bodies {
        shaft: mass mr, inertia [Jt, Jt, Ja];
        slider: mass ms, inertia [ms*0.02 [m^2]/12, ms*0.02 [m^2]/12, ms*0.02 [m^2]/12];
        arm1: mass mr, inertia [Ja, Jt, Jt];
        arm2: mass mr, inertia [Ja, Jt, Jt];
        ball1: mass mb at on(arm1, [0.5 [m], 0, 0]);
        ball2: mass mb at on(arm2, [0.5 [m], 0, 0]);
    }
    joints {
        spin: revolute ground at [0, 0, 0] axis [0, 0, 1] to shaft at [0, 0, -0.5 [m]] axis [0, 0, 1];
        s: prismatic shaft at [0, 0, -0.5 [m]] axis [0, 0, 1] to slider at [0, 0, 0] axis [0, 0, 1];
        a1: revolute shaft at [0.05 [m], 0, 0.5 [m]] axis [0, 1, 0] to arm1 at [-0.5 [m], 0, 0] axis [0, 1, 0];
        a2: revolute shaft at [-0.05 [m], 0, 0.5 [m]] axis [0, -1, 0] to arm2 at [-0.5 [m], 0, 0] axis [0, 1, 0];
    }
    loads {
        gravity [0, 0, -g];
        spring K, length 0.5 [m] from on(slider, [0.05 [m], 0, 0]) to on(arm1, [0, 0, 0]);
        spring K, length 0.5 [m] from on(slider, [-0.05 [m], 0, 0]) to on(arm2, [0, 0, 0]);
        damper C from on(slider, [0.05 [m], 0, 0]) to on(arm1, [0, 0, 0]);
        damper C from on(slider, [-0.05 [m], 0, 0]) to on(arm2, [0, 0, 0]);
    }
    initial { spin = 0; s = 0.5; a1 = pi/6; a2 = pi/6; dot(spin) = w0; dot(s) = 0; dot(a1) = 0; dot(a2) = 0; }
    let tip2 = on(arm2, [0.5 [m], 0, 0]);
    outputs { height [m] = s; alpha [rad] = a1; sv [m/s] = dot(s); av [rad/s] = dot(a1); w [rad/s] = dot(spin); alpha2 [rad] = a2; tip2x [m] = tip2.x; tip2z [m] = tip2.z; }
}

mechanism! {
    pub(crate) TopXyz;
    coordinates { a [rad]; b [rad]; phi [rad]; }
    parameters { m [kg] = 1; g [m/s^2] = 9.81; l [m] = 0.5; I1 [kg*m^2] = 0.3; I3 [kg*m^2] = 0.02; w3 [rad/s] = 150; th0 [deg] = 30; }
    let A = I1 - m*l^2;
    let R = euler(xyz, a, b, phi);
    bodies { top: mass m at R*[0, 0, l], inertia [A, A, I3], attitude R; }
    loads { gravity [0, 0, -g]; }
    initial { a = th0; b = 0; phi = 0; dot(a) = 0; dot(b) = 0; dot(phi) = w3; }
    let n = R*[0, 0, 1];
    outputs { ex = n.x; ey = n.y; ez = n.z; }
}

mechanism! {
    /// Placed by a ball joint, whose quaternion is its coordinates.
    pub(crate) TopBall;
    parameters { m [kg] = 1; g [m/s^2] = 9.81; l [m] = 0.5; I1 [kg*m^2] = 0.3; I3 [kg*m^2] = 0.02; w3 [rad/s] = 150; th0 [deg] = 30; }
    let A = I1 - m*l^2;
    let s = sin(th0/2);
    let c = cos(th0/2);
    bodies { top: mass m, inertia [A, A, I3]; }
    loads { gravity [0, 0, -g]; }
    joints { foot: ball ground at [0, 0, 0] to top at [0, 0, -l]; }
    initial {
        foot_q0 = c; foot_q1 = s; foot_q2 = 0; foot_q3 = 0;
        dot(foot_q0) = 0; dot(foot_q1) = 0; dot(foot_q2) = -s*w3/2; dot(foot_q3) = c*w3/2;
    }
    let n = attitude(top)*[0, 0, 1];
    outputs { ex = n.x; ey = n.y; ez = n.z; own [rad/s] = (transpose(attitude(top))*omega(top)).z; }
}

mechanism! {
    /// A free body with a quaternion, and the joint `roll`.
    pub(crate) DiscFree;
    parameters { m [kg] = 2; r [m] = 0.25; g [m/s^2] = 9.81; yaw0 [rad] = 0.3; lean0 [rad] = 0.2; u10 [rad/s] = 0.4; u20 [rad/s] = 9; u30 [rad/s] = -1.1; }
    bodies { disc: free, mass m, inertia [m*r^2/4, m*r^2/2, m*r^2/4]; }
    loads { gravity [0, 0, -g]; }
    joints { floor: roll disc radius r axis [0, 1, 0] on [0, 0, 0] normal [0, 0, 1]; }
    let a = cos(yaw0/2); let b = sin(yaw0/2); let c = cos(lean0/2); let d = sin(lean0/2);
    let e0 = a*c; let e1 = a*d; let e2 = b*d; let e3 = b*c;
    initial {
        disc_x = r*sin(lean0)*sin(yaw0); disc_y = -r*sin(lean0)*cos(yaw0); guess disc_z = 0.24;
        disc_q0 = e0; disc_q1 = e1; disc_q2 = e2; disc_q3 = e3;
        dot(disc_q0) = -(e1*u10 + e2*u20 + e3*u30)/2;
        dot(disc_q1) = (e0*u10 + e2*u30 - e3*u20)/2;
        dot(disc_q2) = (e0*u20 + e3*u10 - e1*u30)/2;
        dot(disc_q3) = (e0*u30 + e1*u20 - e2*u10)/2;
    }
    let n = attitude(disc)*[0, 1, 0];
    let w = omega(disc);
    outputs {
        nx = n.x; ny = n.y; nz = n.z;
        wx [rad/s] = w.x; wy [rad/s] = w.y; wz [rad/s] = w.z;
        cx [m] = disc_x; cy [m] = disc_y; cz [m] = disc_z;
        fx [N] = -reaction(floor_f1); fy [N] = -reaction(floor_f2); fz [N] = -reaction(floor);
    }
}

mechanism! {
    /// A free brick without gravity: partitioning of its quaternion.
    pub(crate) SpinningBrick;
    parameters { m [kg] = 2; A [kg*m^2] = 0.01; B [kg*m^2] = 0.02; C [kg*m^2] = 0.025; L [m] = 0.3; g [m/s^2] = 0; vx [m/s] = 1; vz [m/s] = 5; w1 [rad/s] = 1; w2 [rad/s] = 0.5; w3 [rad/s] = -0.7; }
    bodies { brick: free, mass m, inertia [A, B, C]; }
    let tip = on(brick, [L, 0, L/2]);
    let wb = transpose(attitude(brick))*omega(brick);
    outputs { o_tx [m] = tip.x; o_ty [m] = tip.y; o_tz [m] = tip.z; o_tvx [m/s] = dot(tip.x); o_tax [m/s^2] = ddot(tip.x); o_w1 [rad/s] = wb.x; o_w2 [rad/s] = wb.y; o_w3 [rad/s] = wb.z; }
    loads { gravity [0, 0, -g]; }
    initial { dot(brick_x) = vx; dot(brick_y) = 0; dot(brick_z) = vz; brick_x = 0; brick_y = 0; brick_z = 0; brick_q0 = 1; brick_q1 = 0; brick_q2 = 0; brick_q3 = 0; dot(brick_q0) = 0; dot(brick_q1) = w1/2; dot(brick_q2) = w2/2; dot(brick_q3) = w3/2; }
}

mechanism! {
    /// A four-bar of free bodies in space, in metres, that passes near a change point.
    pub(crate) FourBarInSpace;
    parameters { a [m] = 0.387176255004; b [m] = 1.057251057735; c [m] = 0.745228708078; d [m] = 0.698073273583; m2 [kg] = 1.208847964404; m3 [kg] = 0.064626892749; m4 [kg] = 0.125626696152; g [m/s^2] = 1;
        T [N*m] = 0.163175440968; k [N/m] = 0; l0 [m] = 1; kd [N*m*s] = 0; th2 [rad] = -0.823774536939; th3 [rad] = 1.289601924016; th4 [rad] = 1.761985333800; w [rad/s] = 4.040033626938; tilt [rad] = 0.3; }
    let n_ = [0, -cos(tilt), sin(tilt)];
    let up = [0, sin(tilt), cos(tilt)];
    let S = -2*(a + b)*up;
    bodies { crank: free, mass m2, inertia [m2*a^2/600, m2*a^2/12, m2*a^2/12]; coupler: free, mass m3, inertia [m3*b^2/600, m3*b^2/12, m3*b^2/12]; rocker: free, mass m4, inertia [m4*c^2/600, m4*c^2/12, m4*c^2/12]; }
    joints {
        t2: revolute ground at [0, 0, 0] axis [0, -cos(tilt), sin(tilt)] to crank at [-a/2, 0, 0] axis [0, -cos(tilt), sin(tilt)];
        t3: revolute crank at [a/2, 0, 0] axis [0, -cos(tilt), sin(tilt)] to coupler at [-b/2, 0, 0] axis [0, -cos(tilt), sin(tilt)];
        t4: revolute ground at [d, 0, 0] axis [0, -cos(tilt), sin(tilt)] to rocker at [-c/2, 0, 0] axis [0, -cos(tilt), sin(tilt)];
        tB: revolute coupler at [b/2, 0, 0] axis [0, -cos(tilt), sin(tilt)] to rocker at [c/2, 0, 0] axis [0, -cos(tilt), sin(tilt)];
    }
    let B = on(rocker, [c/2, 0, 0]);
    let By_ = inner(B, up);
    loads { gravity -g*up; torque T*n_ on crank; spring k, length l0 from S to on(coupler, [(0.317 - 0.5)*b, 0, 0]); torque -kd*inner(omega(rocker), n_)*n_ on rocker; }
    initial {
        crank_q0 = cos(th2/2); crank_q1 = 0; crank_q2 = -sin(th2/2)*cos(tilt); crank_q3 = sin(th2/2)*sin(tilt); dot(crank_q0) = -sin(th2/2)*w/2; dot(crank_q1) = 0; dot(crank_q2) = -cos(th2/2)*w/2*cos(tilt); dot(crank_q3) = cos(th2/2)*w/2*sin(tilt);
        guess crank_x = a/2*cos(th2); guess crank_y = a/2*sin(th2)*sin(tilt); guess crank_z = a/2*sin(th2)*cos(tilt);
        guess coupler_x = a*cos(th2) + b/2*cos(th3); guess coupler_y = (a*sin(th2) + b/2*sin(th3))*sin(tilt); guess coupler_z = (a*sin(th2) + b/2*sin(th3))*cos(tilt); guess coupler_q0 = cos(th3/2); guess coupler_q2 = -sin(th3/2)*cos(tilt); guess coupler_q3 = sin(th3/2)*sin(tilt);
        guess rocker_x = d + c/2*cos(th4); guess rocker_y = c/2*sin(th4)*sin(tilt); guess rocker_z = c/2*sin(th4)*cos(tilt); guess rocker_q0 = cos(th4/2); guess rocker_q2 = -sin(th4/2)*cos(tilt); guess rocker_q3 = sin(th4/2)*sin(tilt);
    }
    outputs {
        o_Bx [m] = B.x; o_By [m] = By_; o_Bvx [m/s] = dot(B.x); o_Bvy [m/s] = dot(By_); o_Bax [m/s^2] = ddot(B.x); o_Bay [m/s^2] = ddot(By_);
        o_w2 [rad/s] = inner(omega(crank), n_); o_w3 [rad/s] = inner(omega(coupler), n_); o_w4 [rad/s] = inner(omega(rocker), n_); o_FBx [N] = reaction(tB).x; o_FBy [N] = inner(reaction(tB), up);
    }
    kernels { }
}
