//! Parts with one coordinate in common, whose rows of C_q are factorised part by part.

sim::mechanism! {
    /// Twelve cylinders on one crank.
    pub Engine;
    const n = 12;
    coordinates { a [rad]; repeat i in 1..=n { b_[i] [rad]; x_[i] [m]; } }
    parameters { m [kg] = 1; l [m] = 1; g [m/s^2] = 9.81; v [m/s] = 1; }
    bodies { wheel: inertia m*l^2, angle a; }
    loads { gravity [-g, 0]; }
    repeat i in 1..=n {
        let P_[i] = 0.3*l*[cos(a + 0.7*i), sin(a + 0.7*i)];
        let Q_[i] = P_[i] + l*[cos(b_[i]), sin(b_[i])];
        bodies { rod_[i]: mass m at (P_[i] + Q_[i])/2, inertia m*l^2/12, angle b_[i]; piston_[i]: mass m at [x_[i], 0]; }
        constraints { pin_[i]: Q_[i] = [x_[i], 0]; }
        initial { guess b_[i] = 0; guess x_[i] = l; }
    }
    initial { a = 0.1; dot(a) = v/l; }
}
