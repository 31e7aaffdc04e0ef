mechanism_macros::mechanism! {
    pub Bare;
    coordinates { x [m]; }
    parameters { g = 9.81 m/s^2; m kg = 2; }
    bodies { point: mass m at [x**2, 0]; }
}

fn main() {}
