//! Mechanisms that reach every part of the language of space.

use sim::mechanism;

mechanism! {
    /// A gimballed rotor on an arm that time shakes, with a full tensor of inertia, and every kind of load.
    pub(crate) Gimbal;
    coordinates { a [rad]; b [rad]; c [rad]; x [m]; }
    parameters { m [kg] = 2; l [m] = 0.3; k [N/m] = 20; d [N*s/m] = 0.4; g [m/s^2] = 9.81; J [kg*m^2] = 0.2; D [kg*m^2] = 0.02; w [rad/s] = 2; }
    let axis = [3/5, 0, 4/5];
    let S = rotation([0, 0, 1], a)*rotation(axis, b + 0.1*sin(w*t));
    let P = [x, 0, 0.1 [m]*cos(w*t)];
    let Q = P + S*[l, 0, 0.1 [m]];
    let R = S*axes([cos(c), 0, -sin(c)], y, [sin(c), 0, cos(c)]);
    bodies {
        frame: mass m at P + S*[l/2, 0, 0], inertia [J, 2*J, 2.5*J, D, -D, D/2], attitude S;
        rotor: mass m/2 at Q, inertia [J, 3/2*J, J], attitude R;
        bob: mass 0.1 [kg] at on(rotor, [0, l, x]);
    }
    loads {
        gravity [0.1 [m/s^3]*t, 0, -g];
        torque S*[0, 0, 0.3 [N*m]*sin(w*t)] on rotor;
        torque -0.2 [N*m*s]*omega(rotor) on rotor;
        force R*[0, 1 [N], 0] at on(rotor, [l, 0, 0]);
        force -d*dot(Q) at Q;
        spring k, length l from [0, 0, 1 [m]] to on(frame, [0, l, 0]);
        damper d from [0, 1 [m], 0] to Q;
    }
    initial { a = 0.1; b = 0.2; dot(c) = 3; x = 0; }
    outputs {
        height [m] = on(rotor, [0, l, 0]).z;
        spin [rad/s] = (transpose(R)*omega(rotor)).y;
        turning [rad/s] = norm(omega(rotor));
        speed [m/s] = norm(dot(on(rotor, [0, l, 0])));
        climbing [m/s^2] = ddot(Q.z);
        lever [m^2] = cross(Q - P, [l, 0, 0]).z;
        facing = inner(R*[0, 0, 1], S*[1, 0, 0]);
    }
}

mechanism! {
    /// A body by Euler's angles of another sequence on an axis that moves, tied to the ground by a leash.
    pub(crate) Leashed;
    coordinates { psi [rad]; theta [rad]; phi [rad]; u [m]; }
    parameters { m [kg] = 1; l [m] = 0.4; J [kg*m^2] = 0.05; g [m/s^2] = 9.81; }
    let lean = [sin(u/(1 [m])), 0, cos(u/(1 [m]))];
    let R = euler(xyz, psi, theta/2, phi);
    let S = transpose(R)*rotation(lean, phi);
    let P = [u, u^2/(2 [m]), 0];
    bodies {
        body: mass m at P + R*[0, 0, l], inertia [J, 2*J, 2*J], attitude R;
        flag: mass m/4 at on(body, [l, 0, 0]) + S*[0, l/3, 0], inertia [J, J, J/2, J/8, 0, 0], attitude S;
    }
    loads { gravity [0, 0, -g]; }
    constraints {
        leash: norm(on(body, [0, 0, 2*l]) - [1 [m], 0, 1 [m]]) = 1 [m];
        roll: omega(body).x = 0.3 [rad/s];
    }
    initial { theta = 0.3; u = 0.1; }
    outputs { tension [N] = reaction(leash); turn [rad/s^2] = dot(omega(flag)).y; }
}

mechanism! {
    /// Two bodies by quaternions, one free and one on the other by a ball joint, pulled by springs and pushed in both frames.
    pub(crate) Thrown;
    coordinates { p0; p1; p2; p3; }
    parameters { m [kg] = 1.5; l [m] = 0.3; J [kg*m^2] = 0.08; k [N/m] = 30; g [m/s^2] = 9.81; }
    let S = quaternion(p0, p1, p2, p3);
    bodies {
        first: free, mass m, inertia [J, 2*J, 2.5*J, J/10, -J/20, J/8];
        second: mass m/2 at on(first, [l, 0, 0]) + S*[0, l, 0], inertia [J, J, J/2], attitude S;
        marker: mass m/9 at on(second, [0, l/2, l]), inertia [J/9, J/9, J/9], attitude attitude(second)*rotation(x, 0.3);
    }
    loads {
        gravity [0, 0, -g];
        spring k, length l from [0, 0, 0] to on(first, [0, l, 0]);
        force S*[0, 0, 1 [N]] at on(second, [0, l, 0]);
        torque [0.1 [N*m], 0, 0] on first;
        torque attitude(second)*[0, 0.2 [N*m], 0] on second;
    }
    constraints { second_norm: p0^2 + p1^2 + p2^2 + p3^2 = 1; }
    initial { guess p0 = 0.8; guess p1 = 0.3; first_y = 0.2; dot(first_z) = 1; }
    outputs { height [m] = on(second, [0, l, 0]).z; spin [rad/s] = norm(omega(second) - omega(first)); norm_force [J] = reaction(first_norm); }
}
