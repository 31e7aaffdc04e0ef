mechanism_macros::mechanism! {
    pub Valve;
    coordinates { alpha [rad]; y [mm]; }
    parameters { m [kg] = 0.2; r [mm] = 18; J [kg*m^2] = 0.003; }
    tables { lift [mm] over [deg] = cubic, periodic { 0, 0; 90, 6; 60, 3; 360, 0; } }
    bodies { cam: inertia J, angle alpha; valve: mass m at [0, y]; }
    joints { contact: cam [0, y] through [0, 0] along pi/2 on cam radius r by lfit; }
    initial { dot(alpha) = 30; guess y = 18; }
}

fn main() {}
