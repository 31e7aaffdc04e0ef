mechanism_macros::mechanism! {
    pub Engine;
    parameters { r [m] = 0.15; l [m] = 0.45; m [kg] = 1; }
    bodies {
        crank: free, mass m, inertia m*r^2/12;
        rod: free, mass 2*m, inertia m*l^2/6;
    }
    joints {
        main: pin on(crank, [-r/2, 0]) to [0, 0];
        big_end: pin on(rod, [-l/2, 0]) to on(crnak, [r/2, 0]);
        end: hinge on(rod, [l/2, 0]) to [0, 0];
    }
    initial { crank_phi = 0.5; }
}

fn main() {}
