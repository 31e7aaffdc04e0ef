mechanism_macros::mechanism! {
    pub Pendulum;
    coordinates { phi [rad]; }
    parameters { length [m] = 1; m [kg] = 2; }
    let P = lenght*[sin(phi), -cos(phi)];
    bodies { bob: mass m at P; }
    outputs { height [m] = P.y; }
}

// What uses the mechanism is not a mistake too.
fn main() {
    let _ = Pendulum::<f64>::default();
    let _ = <Pendulum as sim_kernel::Compiled>::DESCRIPTION.name;
}
