mechanism_macros::mechanism! {
    pub Arm;
    parameters { m [kg] = 1; l [m] = 0.2; A [kg*m^2] = 0.01; g [m/s^2] = 9.81; }
    bodies {
        upper: mass m, inertia [A, A, A/2];
        lower: mass m, inertia [A, A, A/2];
    }
    joints { shoulder: revolute ground at [0, 0, 0] axis [0, 1, 0] to upper at [0, 0, l] axis [0, 1, 0]; }
    loads { gravity [0, 0, -g]; }
    outputs { pin [N] = norm(reaction(shoulder)); }
}

fn main() {}
