//! Mechanisms with sparse rows, for tests.

mechanism_macros::mechanism! {
    /// Eight rods that hang from each other, each a free body.
    pub(crate) Chain;
    const n = 8;
    parameters { m [kg] = 1; l [m] = 1; }
    let P_[0] = [0, 0];
    repeat i in 1..=n {
        bodies { rod_[i]: free, mass m, inertia m*l^2/12; }
        let P_[i] = on(rod_[i], [l/2, 0]);
        joints { pin_[i]: pin P_[i-1] to on(rod_[i], [-l/2, 0]); }
    }
}

mechanism_macros::mechanism! {
    /// Ten cylinders on one crank, each with an eccentric of its own, so that rows of other parts do not look alike.
    pub(crate) Engine;
    const n = 10;
    coordinates { a [rad]; repeat i in 1..=n { b_[i] [rad]; x_[i] [m]; } }
    parameters { m [kg] = 1; l [m] = 1; }
    bodies { wheel: inertia m*l^2, angle a; }
    repeat i in 1..=n {
        let P_[i] = 0.3*l*[cos(a + 0.7*i), sin(a + 0.7*i)] + 0.02*i*l*[sin(a), 0];
        let Q_[i] = P_[i] + l*[cos(b_[i]), sin(b_[i])];
        bodies { rod_[i]: mass m at (P_[i] + Q_[i])/2, inertia m*l^2/12, angle b_[i]; piston_[i]: mass m at [x_[i], 0]; }
        constraints { pin_[i]: Q_[i] = [x_[i], 0]; }
    }
}

mechanism_macros::mechanism! {
    /// The same, its crank driven twice: the first part takes the whole column, but for rounding.
    pub(crate) Driven;
    const n = 10;
    coordinates { a [rad]; y [rad]; repeat i in 1..=n { b_[i] [rad]; x_[i] [m]; } }
    parameters { m [kg] = 1; l [m] = 1; }
    bodies { wheel: inertia m*l^2, angle a; other: inertia m*l^2, angle y; }
    constraints { gear: 0.9*y = 0.37*a; drive: 1.1*y + 0.73*a = 0.3 [rad/s]*t; }
    repeat i in 1..=n {
        let P_[i] = 0.3*l*[cos(a + 0.7*i), sin(a + 0.7*i)];
        let Q_[i] = P_[i] + l*[cos(b_[i]), sin(b_[i])];
        bodies { rod_[i]: mass m at (P_[i] + Q_[i])/2, inertia m*l^2/12, angle b_[i]; piston_[i]: mass m at [x_[i], 0]; }
        constraints { pin_[i]: Q_[i] = [x_[i], 0]; }
    }
    constraints { again: 0.7*a = 0.1 [rad/s]*t; }
}
