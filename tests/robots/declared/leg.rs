mechanism! {
    /// A leg of four bars on a base that moves freely: a crank at the hip, a shank that stands on it, and a rod beside the crank.
    pub Leg;
    parameters {
        crank [m] = 0.3; shank [m] = 0.35; rod [m] = 0.32; apart [m] = 0.08; heel [m] = 0.07;
        kp [N*m/rad] = 300;
    }
    inputs { hip_torque [N*m] = 0; }
    bodies { base: free, mass 12 [kg], inertia [0.2 [kg*m^2], 0.35 [kg*m^2], 0.4 [kg*m^2]]; }
    coordinates { hip [rad]; knee [rad]; side [rad]; }
    let at_hip = on(base, [0.2 [m], 0.1 [m], 0]);
    let R_crank = attitude(base)*rotation(y, hip);
    let at_knee = at_hip + R_crank*[0, 0, -crank];
    let R_shank = R_crank*rotation(y, knee);
    let R_rod = attitude(base)*rotation(y, side);
    bodies {
        thigh: mass 1.2 [kg] at at_hip + R_crank*[0.01 [m], 0, -0.4*crank], inertia [0.01 [kg*m^2], 0.011 [kg*m^2], 0.002 [kg*m^2]], attitude R_crank;
        calf: mass 0.5 [kg] at at_knee + R_shank*[0, 0, -0.5*shank], inertia [0.005 [kg*m^2], 0.006 [kg*m^2], 0.001 [kg*m^2]], attitude R_shank;
        bar: mass 0.2 [kg] at on(base, [0.2 [m] + apart, 0.1 [m], 0]) + R_rod*[0, 0, -0.5*rod], inertia [0.002 [kg*m^2], 0.002 [kg*m^2], 0.0001 [kg*m^2]], attitude R_rod;
    }
    loads { gravity [0, 0, -9.81 [m/s^2]]; torque hip_torque - kp*(hip - 0.4) on hip; }
    constraints {
        pin_x: -crank*sin(hip) + heel*cos(hip + knee) = apart - rod*sin(side);
        pin_z: -crank*cos(hip) - heel*sin(hip + knee) = -rod*cos(side);
    }
    initial { hip = 0.4; guess knee = -0.1; guess side = 0.4; }
    kernels { inverse_dynamics; dynamics_jacobian; }
}
