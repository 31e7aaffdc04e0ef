//! Parts that have a crank in common, whose equations of motion are solved with a crank for each: against the kernels of the terms.

use crate::links::called;
use crate::trees::scaled;
use sim::{At, Kernel, Model};
use tests::Random;

/// Pistons on one crank with a wheel, and a load on each of them. Only the first slides along x; lengths are multiples of L and
/// masses of m. With seven pistons and more the crank is separated.
fn engine(cylinders: usize, flywheel: &str) -> String {
    format!(
        "
    pub Engine;
    coordinates {{ a [rad]; }}
    parameters {{ L [m] = 1; m [kg] = 1; p [N] = 3; }}
    fragment Cylinder(phase, tilt) {{
        coordinates {{ b [rad]; x [m]; }}
        let P = 0.3*L*[cos(a + phase), sin(a + phase)];
        let Q = P + L*[cos(b), sin(b)];
        bodies {{
            rod: mass m at P + 0.4*L*[cos(b), sin(b)], inertia 0.1*m*L^2, angle b;
            piston: mass 0.5*m at [x, tilt*x];
        }}
        loads {{ force [-p, 0] at [x, tilt*x]; }}
        constraints {{ pin: Q = [x, tilt*x]; }}
        initial {{ guess b = 0.1; guess x = 1.2*L; }}
    }}
    bodies {{ wheel: {flywheel}, angle a; }}
    loads {{ gravity [0, -9.81 [m/s^2]]; torque 0.1*m*L^2*t/(1 [s^3]) on wheel; }}
    repeat i in 1..={cylinders} {{ use Cylinder(0.7*i, 0.1*(i - 1)) as c_[i]; }}
    initial {{ a = 0.4; dot(a) = 2; }}
    kernels {{ dynamics_jacobian; }}"
    )
}

const WHEEL: &str = "inertia 0.2*m*L^2";

/// A few hundred roundings, divided by the condition of the system.
const ROUNDING: f64 = 1e-10;

/// M q'' + h - Q + C_q' lambda = 0 and C_q q'' + C'' without accelerations = 0, beside the magnitudes of their terms.
pub(crate) fn solves(model: &dyn Model, at: At<f64>) {
    let [accelerations, multipliers, _]: &[Vec<f64>; 3] = &called(model, Kernel::Dynamics, at).try_into().unwrap();
    let vector = |kernel| called(model, kernel, at).concat();
    let (mass, jacobian) = (called(model, Kernel::MassMatrix, at), called(model, Kernel::ConstraintJacobian, at));
    let [convective, given, drift] =
        [Kernel::ConvectiveForces, Kernel::GeneralizedForces, Kernel::ConstraintConvective].map(vector);
    let inner = |row: &[f64], of: &[f64]| row.iter().zip(of).map(|(a, b)| a * b).collect::<Vec<f64>>();
    let rows = mass.iter().enumerate().map(|(i, row)| {
        let reactions: Vec<f64> = jacobian.iter().zip(multipliers).map(|(row, lambda)| row[i] * lambda).collect();
        [inner(row, accelerations), reactions, vec![convective[i], -given[i]]].concat()
    });
    let constraints =
        jacobian.iter().zip(&drift).map(|(row, drift)| [inner(row, accelerations), vec![*drift]].concat());
    for (i, terms) in rows.chain(constraints).enumerate() {
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        let sum: f64 = terms.iter().sum();
        assert!(sum.abs() <= ROUNDING * size, "equation {i}: {sum:e} is left of {size:e}");
    }
}

#[test]
fn pistons_on_one_crank() {
    let random = &mut Random(3);
    for (cylinders, flywheel) in [(2, WHEEL), (3, WHEEL), (7, WHEEL), (12, WHEEL), (7, "inertia 1e-9*m*L^2")] {
        let text = engine(cylinders, flywheel);
        for (length, mass) in [(1.0, 1.0), (1e-3, 1e-3), (100.0, 1e3)] {
            let model = scaled(&text, length, mass);
            let [start, _] = model.initial();
            let size = |i: usize| if i > 0 && i.is_multiple_of(2) { length } else { 1.0 };
            for _ in 0..10 {
                let [off, qd] = [(); 2]
                    .map(|()| -> Vec<f64> { (0..start.len()).map(|i| size(i) * random.between(-0.7, 0.7)).collect() });
                let q: Vec<f64> = start.iter().zip(&off).map(|(start, off)| start + off).collect();
                solves(&*model, At { time: 0.4, positions: &q, speeds: &qd, accelerations: &[], multipliers: &[] });
            }
        }
    }
}

/// Where a rod and the crank lie in line with a cylinder, this piston alone would stop the crank.
#[test]
fn a_dead_centre() {
    let model = scaled(&engine(7, WHEEL), 1.0, 1.0);
    let a = -0.7_f64;
    let mut q = vec![a];
    for i in 1..=7 {
        let phase = 0.7 * f64::from(i);
        let b: f64 = -(0.3 * (a + phase).sin()).asin();
        q.extend([b, 0.3 * (a + phase).cos() + b.cos()]);
    }
    let qd = vec![0.0; q.len()];
    let at = At { time: 0.4, positions: &q, speeds: &qd, accelerations: &[], multipliers: &[] };
    assert!((q[1], q[2]) == (0.0, 1.3));
    solves(&*model, at);
}

/// Derivatives come from the same factorisation: as dual numbers through it.
#[test]
fn derivatives() {
    let text = engine(7, WHEEL);
    let [kernel, duals] =
        [text.clone(), text.replace("kernels { dynamics_jacobian; }", "kernels { inverse_dynamics; }")]
            .map(|text| scaled(&text, 1.0, 1.0));
    let [q, _] = kernel.initial();
    let qd: Vec<f64> = (0..q.len()).map(|i| 0.3 * i as f64 - 1.0).collect();
    let at = At { time: 0.0, positions: &q, speeds: &qd, accelerations: &[], multipliers: &[] };
    let [found, expected] = [&kernel, &duals].map(|model| called(&**model, Kernel::DynamicsJacobian, at));
    let size = expected.iter().flatten().fold(0.0, |size: f64, x| size.max(x.abs()));
    for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() <= ROUNDING * size, "{found} is not {expected}");
    }
}

/// A chain in the plane is written with the positions of its joints in between, and its inverse dynamics goes along them.
#[test]
fn inverse_dynamics_of_a_chain() {
    let n = 12;
    let mut text = String::from("pub Chain; parameters { L [m] = 1; m [kg] = 1; }\ncoordinates {");
    (0..n).for_each(|i| text += &format!(" q{i} [rad];"));
    text += " }\nlet P0 = [0, 0];\n";
    for i in 0..n {
        text += &format!("let E{i} = [cos(q{i}), sin(q{i})]; let P{} = P{i} + L*E{i};\n", i + 1);
        text += &format!("bodies {{ b{i}: mass m at P{i} + 0.4*L*E{i}, inertia 0.1*m*L^2, angle q{i}; }}\n");
    }
    text += &format!("loads {{ gravity [0, -9.81 [m/s^2]]; spring 30 [N/m], length L from [0, L] to P{n}; }}\n");
    text += "kernels { inverse_dynamics; }";
    let random = &mut Random(9);
    for (length, mass) in [(1.0, 1.0), (1e-3, 1e-3), (100.0, 1e3)] {
        let model = scaled(&text, length, mass);
        assert_eq!(model.description().optional_kernels, ["inverse_dynamics"]);
        for _ in 0..10 {
            let [q, qd, a] = [(); 3].map(|()| -> Vec<f64> { (0..n).map(|_| random.between(-2.0, 2.0)).collect() });
            let at = At { time: 0.0, positions: &q, speeds: &qd, accelerations: &a, multipliers: &[] };
            let vector = |kernel| called(&*model, kernel, at).concat();
            let (needed, convective) = (vector(Kernel::InverseDynamics), vector(Kernel::ConvectiveForces));
            let given = vector(Kernel::GeneralizedForces);
            for (i, row) in called(&*model, Kernel::MassMatrix, at).iter().enumerate() {
                let inertial = row.iter().zip(&a).map(|(entry, acceleration)| entry * acceleration);
                let terms: Vec<f64> = inertial.chain([convective[i], -given[i]]).collect();
                let (sum, size) = (terms.iter().sum::<f64>(), terms.iter().map(|term| term.abs()).sum::<f64>());
                assert!((needed[i] - sum).abs() <= ROUNDING * size, "force {i}: {} is not {sum}", needed[i]);
            }
        }
    }
}
