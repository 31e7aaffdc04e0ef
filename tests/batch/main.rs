//! Motions on other numbers: side by side in lanes, and with derivatives.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod forward;
mod jumps;
mod side_by_side;

sim::mechanism! {
    /// A body on which nothing acts, by Euler's angles and its angular velocity in its own frame.
    Turning;
    coordinates { psi [rad]; theta [rad]; phi [rad]; }
    parameters { A [kg*m^2] = 1; B [kg*m^2] = 2; C [kg*m^2] = 2.5; }
    bodies { body: inertia [A, B, C], attitude euler(zxz, psi, theta, phi); }
    let w = transpose(attitude(body))*omega(body);
    speeds { wx [rad/s] = w.x; wy [rad/s] = w.y; wz [rad/s] = w.z; }
    initial { psi = 0; theta = 1; phi = 0; dot(psi) = 2; dot(theta) = 0.5; dot(phi) = 1; }
}

sim::mechanism! {
    /// A parallelogram that folds: a singular position twice in each turn.
    Folding;
    coordinates { a [rad]; b [rad]; c [rad]; }
    parameters { l [m] = 0.1; d [m] = 0.3; m [kg] = 1; }
    let A = l*[cos(a), sin(a)];
    let B = A + d*[cos(b), sin(b)];
    bodies { crank: inertia m*l^2/3, angle a; coupler: mass m at (A + B)/2, inertia m*d^2/12, angle b; rocker: inertia m*l^2/3, angle c; }
    constraints { close: B = [d, 0] + l*[cos(c), sin(c)]; }
    initial { a = 1; dot(a) = 10; guess b = 0; guess c = 1; }
}

sim::mechanism! {
    /// Rods that hang from each other, each a free body.
    Rods;
    const n = 6;
    parameters { m [kg] = 1; l [m] = 1; }
    let P_[0] = [0, 0];
    repeat i in 1..=n {
        bodies { rod_[i]: free, mass m, inertia m*l^2/12; }
        let P_[i] = on(rod_[i], [l/2, 0]);
        joints { pin_[i]: pin P_[i-1] to on(rod_[i], [-l/2, 0]); }
    }
    loads { gravity [0, -9.81 [m/s^2]]; }
    initial { repeat i in 1..=n { guess rod_[i]_x = (i - 0.5) * 1 [m]; } }
}
