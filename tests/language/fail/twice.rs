mechanism_macros::mechanism! {
    pub Twice;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 2; x [m] = 1; }
    bodies { point: mass m at [x, y]; }
}

fn main() {}
