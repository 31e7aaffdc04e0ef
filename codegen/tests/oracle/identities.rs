//! Identities of mechanics, on a mechanism that has everything: time in positions, loads and constraints, loads that
//! depend on speeds, a force at a point that time moves, and mixed second derivatives.

use super::{Answer, Mechanism, Outcome, ROUNDING, assert_value};
use codegen::oracle::Measured;

/// A bead slides on a rod whose pivot and whose end time moves; a second rod hangs on the bead, its tip along a curve.
const EVERYTHING: &str = "pub Everything;
    coordinates { r [m]; phi [rad]; psi [rad]; y [m]; }
    parameters { m1 [kg] = 1.2; m2 [kg] = 0.7; J [kg*m^2] = 0.05; J0 [kg*m^2] = 0.4; l [m] = 0.6; a [m] = 0.2; w [rad/s] = 3; c = 0.8; k [N/m] = 30; }
    let O = a*[sin(w*t), cos(2*w*t)];
    let u = [cos(phi), sin(phi)];
    let B = O + r*u;
    let G = B + l/2*[cos(psi + a*t), sin(psi + a*t)];
    let E = B + l*[cos(psi + a*t), sin(psi + a*t)];
    bodies {
        rod: inertia J0, angle phi + a*sin(t)*phi;
        bead: mass m1 at B;
        arm: mass m2 at G, inertia J, angle psi + r*t;
        slide: mass m1/2 at [2*t, y];
    }
    loads {
        gravity [0.3*t, -9.81];
        force -c*dot(E) at E;
        force k*(O - E)*norm(dot(B)) at E + [t^2, sin(t)];
        torque -c*dot(phi)*abs(dot(psi)) + cos(t) on arm;
    }
    constraints { tip: E.y*cos(t) = y^2/4 + 0.3*E.x*t; turn: r*phi = 0.4*sin(w*t)*psi + 0.3; }
    outputs {
        energy_rate = dot(m1/2*inner(dot(B), dot(B)) + m2/2*inner(dot(G), dot(G)) + J/2*dot(psi + r*t)^2 + J0/2*dot(phi + a*sin(t)*phi)^2 + m1/4*(4 + dot(y)^2));
        tip_0 = E.y*cos(t) - (y^2/4 + 0.3*E.x*t); tip_1 = dot(E.y*cos(t) - (y^2/4 + 0.3*E.x*t)); tip_2 = ddot(E.y*cos(t) - (y^2/4 + 0.3*E.x*t));
        turn_0 = r*phi - (0.4*sin(w*t)*psi + 0.3); turn_1 = dot(r*phi - sin(w*t)*psi*0.4); turn_2 = ddot(r*phi - sin(w*t)*psi*0.4);
        power_in = inner(-c*dot(E), dot(E)); drive = reaction(turn);
    }";

const STATES: [(f64, [f64; 4], [f64; 4]); 3] = [
    (0.3, [0.9, 0.5, -1.1, 0.7], [0.4, -1.2, 2.0, 0.6]),
    (1.4, [0.5, -0.8, 0.4, -1.3], [-2.0, 0.7, -0.5, 1.5]),
    (-0.7, [1.6, 2.2, 3.0, 0.9], [0.1, 1.9, 4.0, -2.2]),
];

fn everything() -> Outcome<Vec<(Answer, [f64; 4])>> {
    let mechanism = Mechanism::parse(EVERYTHING)?;
    STATES.iter().map(|(t, q, speeds)| Ok((mechanism.at(*t, q, speeds)?, *speeds))).collect()
}

/// d(kinetic energy)/dt = power - lambda (C_q q' + C_t); the last term is zero where the speeds satisfy the constraints,
/// which these do not. The left side is differentiated along the motion, by other jets than those of the power.
#[test]
fn power_is_the_rate_of_kinetic_energy() -> Outcome {
    for (answer, speeds) in everything()? {
        let drift = constraint_rates(&answer, &speeds);
        let lost: Measured = answer.solution.multipliers.iter().zip(drift).map(|(lambda, rate)| *lambda * rate).sum();
        let rate = answer.outputs[0];
        assert_value(answer.power - lost - rate, 0.0);
        assert!(rate.value.abs() > 1e6 * ROUNDING * rate.magnitude, "a rate below the tolerance would prove nothing");
    }
    Ok(())
}

/// C_q q' + C_t.
fn constraint_rates(answer: &Answer, speeds: &[f64]) -> Vec<Measured> {
    let rows = answer.terms.constraint_jacobian.iter().zip(&answer.terms.constraint_time_derivative);
    rows.map(|(row, time)| {
        row.iter().zip(speeds).map(|(c, speed)| *c * Measured::given(*speed)).sum::<Measured>() + *time
    })
    .collect()
}

/// The constraints, their rates and (with the accelerations that solve the equations) their second derivatives are
/// those of their expressions along the motion.
#[test]
fn constraints_are_differentiated_along_the_motion() -> Outcome {
    for (answer, speeds) in everything()? {
        let rates = constraint_rates(&answer, &speeds);
        for (i, expected) in [&answer.outputs[1..4], &answer.outputs[4..7]].into_iter().enumerate() {
            assert_value(answer.terms.constraints[i] - expected[0], 0.0);
            assert_value(rates[i] - expected[1], 0.0);
            assert_value(expected[2], 0.0);
            assert!(answer.terms.constraint_convective[i].value.abs() > 0.01);
        }
    }
    Ok(())
}

/// 2 T = v.v m is q' M q' plus what time alone moves: T(q') + T(-q') - 2 T(0) = q' M q'.
#[test]
fn kinetic_energy_is_the_form_of_the_mass_matrix() -> Outcome {
    let mechanism = Mechanism::parse(EVERYTHING)?;
    for (t, q, speeds) in STATES {
        let answer = mechanism.at(t, &q, &speeds)?;
        let energy = |factor: f64| Ok(mechanism.at(t, &q, &speeds.map(|s| factor * s))?.terms.kinetic_energy);
        let speed = |i: usize| Measured::given(speeds[i]);
        let pairs = (0..4).flat_map(|i| (0..4).map(move |j| (i, j)));
        let form: Measured = pairs.map(|(i, j)| speed(i) * answer.terms.mass_matrix[i][j] * speed(j)).sum();
        let still: Outcome<Measured> = energy(0.0);
        let energies = answer.terms.kinetic_energy + energy(-1.0)? - Measured::given(2.0) * still?;
        assert_value(energies - form, 0.0);
        for (i, row) in answer.terms.mass_matrix.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                assert_value(*entry - answer.terms.mass_matrix[j][i], 0.0);
            }
        }
    }
    Ok(())
}

/// M q'' + C_q' lambda = generalized_forces and C_q q'' = -constraint_convective.
#[test]
fn the_solution_solves_the_equations() -> Outcome {
    for (answer, _) in everything()? {
        let (terms, Answer { solution, .. }) = (&answer.terms, &answer);
        for i in 0..4 {
            let inertia: Measured =
                terms.mass_matrix[i].iter().zip(&solution.accelerations).map(|(m, a)| *m * *a).sum();
            let reaction: Measured =
                terms.constraint_jacobian.iter().zip(&solution.multipliers).map(|(c, l)| c[i] * *l).sum();
            assert_value(inertia + reaction - terms.generalized_forces[i], 0.0);
            let total = terms.applied_forces[i] - terms.convective[i];
            assert_eq!(terms.generalized_forces[i], total);
        }
        for (row, convective) in terms.constraint_jacobian.iter().zip(&terms.constraint_convective) {
            let second: Measured = row.iter().zip(&solution.accelerations).map(|(c, a)| *c * *a).sum();
            assert_value(second + *convective, 0.0);
        }
    }
    Ok(())
}

/// What perturbed terms do to accelerations, multipliers and outputs stays within their magnitudes: every parameter off
/// by a relative 1e-8, up or down, and at most some 20 of them in one product.
#[test]
fn magnitudes_bound_what_errors_can_do() -> Outcome {
    const ERROR: f64 = 1e-8;
    let mechanism = Mechanism::parse(EVERYTHING)?;
    let oracle = mechanism.oracle();
    let parameters = oracle.default_parameters()?;
    for (t, q, speeds) in STATES {
        let answer = mechanism.at(t, &q, &speeds)?;
        for pattern in 0..32u32 {
            let off = |(i, p): (usize, &f64)| p * if pattern >> (i % 5) & 1 == 1 { 1.0 + ERROR } else { 1.0 - ERROR };
            let parameters: Vec<f64> = parameters.iter().enumerate().map(off).collect();
            let state = codegen::oracle::State {
                time: t,
                parameters: &parameters,
                inputs: &[],
                coordinates: &q,
                speeds: &speeds,
            };
            let solution = oracle.accelerations(&oracle.terms(&state)?)?;
            let outputs = oracle.outputs(&state, &solution)?;
            let wrong = solution.accelerations.iter().chain(&solution.multipliers).chain(&outputs);
            let right = answer.solution.accelerations.iter().chain(&answer.solution.multipliers).chain(&answer.outputs);
            for (a, b) in right.zip(wrong) {
                assert!((a.value - b.value).abs() <= 20.0 * ERROR * a.magnitude, "{a:?}, {b:?}");
            }
        }
    }
    Ok(())
}
