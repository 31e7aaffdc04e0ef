//! Andrews' squeezing mechanism (Hairer and Wanner, Solving Ordinary Differential Equations II, VI.9): seven bodies,
//! three loops closed by constraints between vectors, a spring and a torque, against 21 digits of accelerations and
//! multipliers at the start and in full motion.

use super::{Mechanism, Outcome, assert_value, samples};
use codegen::oracle::Measured;

const ANGLES: [&str; 7] = ["beta", "Theta", "gamma", "Phi", "delta", "Omega", "epsilon"];

const ANDREWS: &str = "pub Andrews;
    coordinates { beta [rad]; Theta [rad]; gamma [rad]; Phi [rad]; delta [rad]; Omega [rad]; epsilon [rad]; }
    parameters {
        m1 [kg] = 0.04325; m2 [kg] = 0.00365; m3 [kg] = 0.02373; m4 [kg] = 0.00706; m5 [kg] = 0.0705;
        m6 [kg] = 0.00706; m7 [kg] = 0.05498;
        i1 [kg*m^2] = 2.194e-6; i2 [kg*m^2] = 4.41e-7; i3 [kg*m^2] = 5.255e-6; i4 [kg*m^2] = 5.667e-7;
        i5 [kg*m^2] = 1.169e-5; i6 [kg*m^2] = 5.667e-7; i7 [kg*m^2] = 1.912e-5;
        xa [m] = -0.06934; ya [m] = -0.00227; xb [m] = -0.03635; yb [m] = 0.03273; xc [m] = 0.014; yc [m] = 0.072;
        c0 [N/m] = 4530; l0 [m] = 0.07785; mom [N*m] = 0.033;
        d [mm] = 28; da [mm] = 11.5; ee [mm] = 20; ea [mm] = 14.21; rr [mm] = 7; ra [mm] = 0.92; ss [mm] = 35;
        sa [mm] = 18.74; sb [mm] = 10.43; sc [mm] = 18; sd [mm] = 20; ta [mm] = 23.08; tb [mm] = 9.16; u [mm] = 40;
        ua [mm] = 12.28; ub [mm] = 4.49; zf [mm] = 20; zt [mm] = 40; fa [mm] = 14.21;
    }
    let A = [xa, ya];
    let B = [xb, yb];
    let C = [xc, yc];
    let u_beta = [cos(beta), sin(beta)];
    let u_2 = [cos(beta + Theta), sin(beta + Theta)];
    let u_gamma = [cos(gamma), sin(gamma)];
    let n_gamma = [sin(gamma), -cos(gamma)];
    let n_4 = [sin(Phi + delta), -cos(Phi + delta)];
    let u_delta = [cos(delta), sin(delta)];
    let n_delta = [sin(delta), -cos(delta)];
    let u_6 = [cos(Omega + epsilon), sin(Omega + epsilon)];
    let u_epsilon = [cos(epsilon), sin(epsilon)];
    let n_epsilon = [sin(epsilon), -cos(epsilon)];
    let P = rr*u_beta - d*u_2;
    let D = B + sc*n_gamma + sd*u_gamma;
    bodies {
        K1: mass m1 at ra*u_beta, inertia i1, angle beta;
        K2: mass m2 at rr*u_beta - da*u_2, inertia i2, angle beta + Theta;
        K3: mass m3 at B + sa*n_gamma + sb*u_gamma, inertia i3, angle gamma;
        K4: mass m4 at A + zt*u_delta + (ee - ea)*n_4, inertia i4, angle Phi + delta;
        K5: mass m5 at A + ta*u_delta - tb*n_delta, inertia i5, angle delta;
        K6: mass m6 at A + u*n_epsilon + (zf - fa)*u_6, inertia i6, angle Omega + epsilon;
        K7: mass m7 at A + ua*n_epsilon - ub*u_epsilon, inertia i7, angle epsilon;
    }
    loads {
        torque mom on K1;
        force c0*(norm(D - C) - l0)*(C - D)/norm(D - C) at D;
    }
    constraints {
        loop3: P - ss*n_gamma = B;
        loop4: P - ee*n_4 - zt*u_delta = A;
        loop6: P - zf*u_6 - u*n_epsilon = A;
    }";

/// Beside the magnitudes' bound, to 1e-12 of the value itself where that is not zero: at full speed the accelerations of
/// beta and Theta are what is left of terms a thousand times larger, which costs three or four of 16 digits.
#[track_caller]
fn assert_reference(found: Measured, expected: f64) {
    assert_value(found, expected);
    let error = (found.value - expected).abs();
    assert!(expected == 0.0 || error <= 1e-12 * expected.abs(), "{} is not {expected}", found.value);
}

#[test]
fn accelerations_and_multipliers_are_those_of_the_reference() -> Outcome {
    let mechanism = Mechanism::parse(ANDREWS)?;
    for sample in samples(include_str!("andrews.csv"))? {
        let speeds = ANGLES.map(|name| sample.get(&format!("{name}_dot")));
        let answer = mechanism.at(sample.get("t"), &ANGLES.map(|name| sample.get(name)), &speeds)?;
        for (found, name) in answer.solution.accelerations.iter().zip(ANGLES) {
            assert_reference(*found, sample.get(&format!("{name}_ddot")));
        }
        for (found, i) in answer.solution.multipliers.iter().zip(1..=6) {
            assert_reference(*found, sample.get(&format!("lambda{i}")));
        }
    }
    Ok(())
}
