mechanism_macros::mechanism! {
    pub Ball;
    coordinates { y [m]; }
    parameters { m [kg] = 1; h [m] = 1; }
    bodies { ball: mass m at [0, y]; }
    loads { gravity [0, -9.81 [m/s^2]]; }
    constraints { floor: y = 0; }
    initial { y = h; }
    events {
        landing: y = 0 falling { impact floor restitution 0.5 [m]; set m = 2; }
        top: dot(y) = 0 downwards;
    }
}

fn main() {}
