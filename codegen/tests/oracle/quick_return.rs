//! The quick-return mechanism against a solution to 20 digits, made with energy and Newton-Euler in 40-digit arithmetic.

use super::{Answer, Mechanism, Outcome, Sample, assert_value, samples};
use codegen::oracle::Measured;

const REFERENCE: &str = include_str!("quick_return.csv");

const BLOCKS: &str = "
    coordinates { alpha [rad]; beta [rad]; gamma [rad]; }
    parameters {
        O2A [m] = 0.2; O4B [m] = 0.7; BC [m] = 0.6; O4O2 [m] = 0.3; O4G4 [m] = 0.4; BG5 [m] = 0.3; yc [m] = 0.9;
        m3 [kg] = 0.5; m4 [kg] = 6; m5 [kg] = 4; m6 [kg] = 2;
        J2 [kg*m^2] = 100; J3 [kg*m^2] = 0; J4 [kg*m^2] = 10; J5 [kg*m^2] = 6; F [N] = 1000; T [N*m] = 0;
    }
    let O4 = [0, 0];
    let O2 = [0, O4O2];
    let A = O2 + O2A*[cos(alpha), sin(alpha)];
    let G4 = O4G4*[cos(beta), sin(beta)];
    let B = O4B*[cos(beta), sin(beta)];
    let G5 = B + BG5*[cos(gamma), sin(gamma)];
    let C = B + BC*[cos(gamma), sin(gamma)];
    outputs {
        sliding_speed [m/s] = dot(norm(A)); x6 [m] = C.x; v6 [m/s] = dot(C.x); a6 [m/s^2] = ddot(C.x);
        slot_force [N] = reaction(slot); guide_force [N] = reaction(guide);
    }";

const SLOT: &str = "A.y*cos(beta) = A.x*sin(beta)";

/// The mechanism with slider 6 at this position, the slot in these words and these loads beside force and torque.
fn quick_return(slider6: &str, slot: &str, loads: &str) -> Outcome<Mechanism> {
    Mechanism::parse(&format!(
        "pub QuickReturn; {BLOCKS}
        bodies {{
            crank2: inertia J2, angle alpha;
            slider3: mass m3 at A, inertia J3, angle beta;
            rocker4: mass m4 at G4, inertia J4, angle beta;
            bar5: mass m5 at G5, inertia J5, angle gamma;
            slider6: mass m6 at {slider6};
        }}
        loads {{ force [F, 0] at C; torque T on crank2; {loads} }}
        constraints {{ guide: C.y = yc; slot: {slot}; }}"
    ))
}

/// Relative to the value itself 1e-12, because the solution of three equations with entries of order 0.1 to 100 loses at
/// most four digits, beside the magnitudes' bound.
#[track_caller]
fn assert_reference(found: Measured, expected: f64) {
    assert_value(found, expected);
    let error = (found.value - expected).abs();
    assert!(error <= 1e-12 * expected.abs(), "{} is not {expected}", found.value);
}

#[test]
fn accelerations_forces_and_outputs_are_those_of_the_reference() -> Outcome {
    let mechanism = quick_return("C", SLOT, "")?;
    let samples = samples(REFERENCE)?;
    assert_eq!(samples.len(), 17);
    for sample in samples {
        let answer = at(&mechanism, &sample)?;
        for (found, name) in answer.solution.accelerations.iter().zip(["alpha_ddot", "beta_ddot", "gamma_ddot"]) {
            assert_reference(*found, sample.get(name));
        }
        let outputs = ["sliding_velocity", "x6", "x6_dot", "x6_ddot"];
        let forces = ["normal_force_slider3_on_rocker4", "normal_force_slider6_on_ground"];
        for (found, name) in answer.outputs.iter().zip(outputs.iter().chain(&forces)) {
            assert_reference(*found, sample.get(name));
        }
        assert_reference(answer.terms.kinetic_energy, sample.get("kinetic_energy"));
        // The force on slider 6 is the only load.
        assert_reference(answer.power, 1000.0 * sample.get("x6_dot"));
    }
    Ok(())
}

fn at(mechanism: &Mechanism, sample: &Sample) -> Outcome<Answer> {
    const NAMES: [&str; 3] = ["alpha", "beta", "gamma"];
    mechanism.at(sample.get("t"), &NAMES.map(|q| sample.get(q)), &NAMES.map(|q| sample.get(&format!("{q}_dot"))))
}

/// The slot as an equation of ratios: the same motion, and a multiplier in joules, whose ratio to the normal force is
/// that of the two constraints' gradients, C2 = -C1/(y_A sin beta).
#[test]
fn the_slot_in_another_form_gives_the_same_motion() -> Outcome {
    let lengths = quick_return("C", SLOT, "")?;
    let ratios = quick_return("C", "A.x/A.y = cos(beta)/sin(beta)", "")?;
    for sample in samples(REFERENCE)? {
        let (a, b) = (at(&lengths, &sample)?, at(&ratios, &sample)?);
        for (a, b) in a.solution.accelerations.iter().zip(&b.solution.accelerations) {
            assert_value(*a - *b, 0.0);
        }
        let (alpha, beta) = (sample.get("alpha"), sample.get("beta"));
        let factor = -(0.3 + 0.2 * alpha.sin()) * beta.sin();
        assert_value(a.outputs[4] * Measured::given(factor) - b.outputs[4], 0.0);
    }
    let start = samples(REFERENCE)?.into_iter().next().ok_or("no sample")?;
    // The published figure is rounded to 0.01.
    assert!((at(&ratios, &start)?.outputs[4].value + 664.28).abs() <= 0.005);
    Ok(())
}

/// The guide keeps slider 6 at constant height, so the y row of its position adds m6 y'' = 0 to what the guide bears;
/// and that row is what makes the guide bear the weight of the slider.
#[test]
fn the_height_of_slider_6_matters_to_its_weight_only() -> Outcome {
    let gravity = "gravity [0, -9.81];";
    for sample in samples(REFERENCE)? {
        for (loads, weight) in [("", 0.0), (gravity, 2.0 * 9.81)] {
            let in_plane = at(&quick_return("C", SLOT, loads)?, &sample)?;
            let along_guide = at(&quick_return("[C.x, 0]", SLOT, loads)?, &sample)?;
            for (a, b) in in_plane.solution.accelerations.iter().zip(&along_guide.solution.accelerations) {
                assert_value(*a - *b, 0.0);
            }
            assert_value(in_plane.outputs[4] - along_guide.outputs[4], 0.0);
            assert_value(in_plane.outputs[5] - along_guide.outputs[5], -weight);
        }
    }
    Ok(())
}
