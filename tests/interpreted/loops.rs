//! Loops in space that links turned by quaternions close: their motion against the kernels of the terms, and its derivatives against
//! dual numbers.

use crate::link_derivatives::derivatives_are_those_of_dynamics;
use crate::parts::solves;
use crate::trees::scaled;
use sim::At;
use tests::Random;

/// A knuckle between two arms on ball joints, and a rod with a ball joint at each end from the knuckle to a rack that moves, with
/// loads that know of quaternions. Both quaternions stand in the rows of the rod.
const KNUCKLE: &str = "
    pub Knuckle;
    parameters { L [m] = 1; m [kg] = 1; k [N/m] = 20; c [N*s/m] = 2; }
    bodies {
        lower: mass m, inertia [0.02*m*L^2, 0.05*m*L^2, 0.06*m*L^2];
        upper: mass m, inertia [0.02*m*L^2, 0.04*m*L^2, 0.05*m*L^2];
        knuckle: mass 3*m, inertia [0.3*m*L^2, 0.4*m*L^2, 0.35*m*L^2, 0.01*m*L^2, 0.02*m*L^2, 0.03*m*L^2];
        rod: mass m, inertia [0.1*m*L^2, 0.12*m*L^2, 0.11*m*L^2];
    }
    joints {
        lower_pivot: revolute ground at [0, 0, 0] axis [1, 0, 0] to lower at [0, -0.5*L, 0] axis [1, 0, 0];
        upper_pivot: revolute ground at [-0.1*L, 0.1*L, 0.8*L] axis [1, 0, 0] to upper at [0, -0.4*L, 0] axis [1, 0, 0];
        lower_ball: ball lower at [0, 0.5*L, 0] to knuckle at [0.05*L, -0.1*L, -0.4*L];
        upper_ball: ball upper at [0, 0.4*L, 0] to knuckle at [-0.05*L, -0.2*L, 0.4*L];
        rod_ball: ball knuckle at [0.3*L, 0.1*L, -0.05*L] to rod at [0.02*L, 0.4*L, 0.01*L];
    }
    let wheel = on(knuckle, [0.1*L, 0.2*L, 0]);
    let foot = on(rod, [0, -0.5*L, 0.03*L]);
    constraints { steering: foot = [0.3*L, 0.2*L + 0.1*L*sin(3*t/(1 [s])), -0.3*L]; }
    loads {
        gravity [0, 0, -9.81 [m/s^2]];
        force [0, -k*wheel.y, k*(0.3*L - wheel.z)] at wheel;
        spring k, length 0.3*L from [0, 0, L] to on(knuckle, [0, 0.1*L, 0.2*L]);
        damper c from [0, 0, L] to foot;
        potential m*L^2*(lower_ball_q0^3 + 2*rod_ball_q2)/(1 [s^2]);
    }
    initial { lower_pivot = 0.1; }
    kernels { dynamics_jacobian; }";

#[test]
fn a_knuckle_moves_as_its_terms_say() {
    let random = &mut Random(3);
    for (length, mass) in [(1.0, 1.0), (1e-3, 1e-3), (100.0, 1e3)] {
        let model = scaled(KNUCKLE, length, mass);
        let [start, _] = model.initial();
        for _ in 0..10 {
            let q: Vec<f64> = start.iter().map(|start| start + random.between(-0.7, 0.7)).collect();
            let qd: Vec<f64> = start.iter().map(|_| random.between(-0.7, 0.7)).collect();
            solves(&*model, At { time: 0.4, positions: &q, speeds: &qd, accelerations: &[], multipliers: &[] });
        }
    }
}

#[test]
fn derivatives_of_a_knuckle() {
    derivatives_are_those_of_dynamics(KNUCKLE, &[]);
}
