mechanism_macros::mechanism! {
    pub Units;
    coordinates { phi [rad]; x [mm]; }
    parameters { l [m] = 1; m [kg] = 2; g [m/s^2] = 9.81; }
    let P = [x + l*sin(phi), -l*cos(phi)];
    bodies { cart: mass m at [x, 0]; bob: mass m at P, angle phi; }
    loads { gravity [0, -9.81]; torque -m*g*sin(phi) on bob; }
    constraints { stop: x = 10; }
    outputs { pull [N] = reaction(stop)*l; sum [J] = m*g + m; turn = dot(phi); }
}

fn main() {}
