//! Andrews' squeezing mechanism: seven bodies, three loops, a spring and a motor.
//!
//! Source: E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, VI.9, and the IVP test set. The source's
//! parameter e is called ee here, because e is Euler's number; n(a) = (sin a, -cos a) is written out.

use mechanism_macros::mechanism;

mechanism! {
    /// Andrews' squeezing mechanism: seven bodies, three loops.
    /// A constant torque turns crank 1 against a spring; the motion grows until nothing holds it.
    pub Andrews;

    coordinates { beta [rad]; Theta [rad]; gamma [rad]; Phi [rad]; delta [rad]; Omega [rad]; epsilon [rad]; }

    parameters {
        m1 [kg] = 0.04325; m2 [kg] = 0.00365; m3 [kg] = 0.02373; m4 [kg] = 0.00706;
        m5 [kg] = 0.0705; m6 [kg] = 0.00706; m7 [kg] = 0.05498;
        i1 [kg*m^2] = 2.194e-6; i2 [kg*m^2] = 4.41e-7; i3 [kg*m^2] = 5.255e-6; i4 [kg*m^2] = 5.667e-7;
        i5 [kg*m^2] = 1.169e-5; i6 [kg*m^2] = 5.667e-7; i7 [kg*m^2] = 1.912e-5;
        xa [m] = -0.06934; ya [m] = -0.00227; xb [m] = -0.03635; yb [m] = 0.03273; xc [m] = 0.014; yc [m] = 0.072;
        /// Stiffness of the spring.
        c0 [N/m] = 4530;
        /// Free length of the spring.
        l0 [m] = 0.07785;
        /// Torque on crank 1.
        mom [N*m] = 0.033;
        d [mm] = 28; da [mm] = 11.5; ee [mm] = 20; ea [mm] = 14.21; rr [mm] = 7; ra [mm] = 0.92; ss [mm] = 35;
        sa [mm] = 18.74; sb [mm] = 10.43; sc [mm] = 18; sd [mm] = 20; ta [mm] = 23.08; tb [mm] = 9.16;
        u [mm] = 40; ua [mm] = 12.28; ub [mm] = 4.49; zf [mm] = 20; zt [mm] = 40; fa [mm] = 14.21;
    }

    let O = [0, 0];
    let A = [xa, ya];
    let B = [xb, yb];
    let C = [xc, yc];
    let u1 = [cos(beta), sin(beta)];
    let u2 = [cos(beta + Theta), sin(beta + Theta)];
    let u3 = [cos(gamma), sin(gamma)];
    let n3 = [sin(gamma), -cos(gamma)];
    let n4 = [sin(Phi + delta), -cos(Phi + delta)];
    let u5 = [cos(delta), sin(delta)];
    let n5 = [sin(delta), -cos(delta)];
    let u6 = [cos(Omega + epsilon), sin(Omega + epsilon)];
    let u7 = [cos(epsilon), sin(epsilon)];
    let n7 = [sin(epsilon), -cos(epsilon)];
    let F = rr*u1;
    let P = F - d*u2;
    let D = B + sc*n3 + sd*u3;
    let E = A + zt*u5;
    let G = A + u*n7;
    let stretch = norm(D - C) - l0;

    bodies {
        crank1: mass m1 at ra*u1, inertia i1, angle beta;
        bar2: mass m2 at F - da*u2, inertia i2, angle beta + Theta;
        plate3: mass m3 at B + sa*n3 + sb*u3, inertia i3, angle gamma;
        bar4: mass m4 at E + (ee - ea)*n4, inertia i4, angle Phi + delta;
        plate5: mass m5 at A + ta*u5 - tb*n5, inertia i5, angle delta;
        bar6: mass m6 at G + (zf - fa)*u6, inertia i6, angle Omega + epsilon;
        plate7: mass m7 at A + ua*n7 - ub*u7, inertia i7, angle epsilon;
    }

    loads {
        torque mom on crank1;
        force c0*stretch*(C - D)/norm(D - C) at D;
    }

    constraints {
        loop3: P = B + ss*n3;
        loop4: P = E + ee*n4;
        loop6: P = G + zf*u6;
    }

    initial {
        Theta = 0;
        guess beta = -0.06;
        guess gamma = 0.46;
        guess Phi = 0.22;
        guess delta = 0.49;
        guess Omega = -0.22;
        guess epsilon = 1.23;
    }

    outputs {
        crank "Crank 1" {
            /// angle of the crank
            crank_angle [rad] = beta;
        }
        swings "Angles of the other bodies" {
            /// plate 3
            plate3_angle [rad] = gamma;
            /// bar 4
            bar4_angle [rad] = Phi + delta;
            /// plate 5
            plate5_angle [rad] = delta;
            /// bar 6
            bar6_angle [rad] = Omega + epsilon;
            /// plate 7
            plate7_angle [rad] = epsilon;
        }
        spring_force "Spring" {
            /// force of the spring
            pull [N] = c0*stretch;
        }
        /// Joint force in P on plate 3
        joint_force [N] = norm(reaction(loop3));
    }

    run { t_end = 30 [ms]; }

    drawing {
        ground O, A, B, C;
        line O, F, P;
        line B, P;
        line B, D;
        spring D, C;
        line A, E, P;
        line A, G, P;
    }
}
