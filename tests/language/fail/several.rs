mechanism_macros::mechanism! {
    pub Several;
    coordinates { x [m]; y [mtr]; }
    parameters { m [kg] = 2; }
    let P = [x, y];
    bodies { point: mass m at P.x; bar: mass m; }
    loads { torque 3 on point; }
    constraints { line: P = 1; }
    outputs { pull [N] = reaction(lime); }
}

fn main() {}
