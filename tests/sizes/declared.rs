//! Mechanisms for which commands are compiled in different sizes.

sim::mechanism! {
    /// A chain of point masses on rigid rods: 70 coordinates, 35 constraints.
    pub Chain;
    const n = 35;
    coordinates { repeat i in 1..=n { x_[i] [m]; y_[i] [m]; } }
    parameters { m [kg] = 1; l [m] = 0.1; }
    let X_[0] = 0 [m];
    let Y_[0] = 0 [m];
    repeat i in 1..=n {
        let X_[i] = x_[i];
        let Y_[i] = y_[i];
        bodies { mass_[i]: mass m at [x_[i], y_[i]]; }
        constraints { rod_[i]: (X_[i] - X_[i-1])^2 + (Y_[i] - Y_[i-1])^2 = l^2; }
        initial { guess x_[i] = i*l*sin(0.5); guess y_[i] = -i*l*cos(0.5); }
    }
    loads { gravity [0, -9.81 [m/s^2]]; }
    outputs { tip [m] = y_[35]; }
}

sim::mechanism! {
    /// Twelve masses in a row on springs.
    pub Row;
    const n = 12;
    coordinates { repeat i in 1..=n { x_[i] [m]; } }
    parameters { m [kg] = 1; k [N/m] = 100; }
    let e_[0] = 0 [m];
    repeat i in 1..=n {
        let e_[i] = x_[i];
        bodies { mass_[i]: mass m at [x_[i], 0]; }
        loads { force [k*(e_[i-1] - e_[i]), 0] at [x_[i], 0]; }
    }
    initial { x_1 = 0.1; }
}
