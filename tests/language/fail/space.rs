mechanism_macros::mechanism! {
    pub Spinner;
    coordinates { psi [rad]; theta [rad]; phi [rad]; }
    parameters { m [kg] = 1; l [m] = 0.2; A [kg*m^2] = 0.01; }
    let R = euler(zxz, psi, theta, phi);
    bodies { top: mass m at R*[0, 0, l], inertia [A, A, 3*A], attitude R; }
    loads { gravity [0, -9.81 [m/s^2]]; }
    initial { theta = 0.5; dot(phi) = 100; }
    outputs {
        height [m] = (R*[0, l]).z;
        spin [rad/s] = (attitude(top)*omega(top)).z;
    }
}

fn main() {}
