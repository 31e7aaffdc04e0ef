//! Recursions over links, which write `dynamics`, `inverse_dynamics`, `mass_matrix` and the terms of the equations of motion for
//! these mechanisms, against what comes from rows of T: kinetic energy, convective and generalised forces, power. They share the
//! resolved model alone.

use crate::rows;
use crate::trees::{ARM, BRANCHES, DRIVEN, FREE, GIMBALS, LIMB, TWINS, scaled};
use codegen::dynamics::EquationsOfMotion;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use sim::{At, Kernel, Model};
use tests::Random;

pub(crate) fn called(model: &dyn Model, kernel: Kernel, at: At<f64>) -> Vec<Vec<f64>> {
    let mut found = Vec::new();
    assert!(!model.call(kernel, at, &mut |_, row| found.push(row.to_vec())), "{kernel:?} is refused");
    found
}

pub(crate) fn vector(model: &dyn Model, kernel: Kernel, at: At<f64>) -> Vec<f64> {
    called(model, kernel, at).concat()
}

/// Of mass matrices: 100 bodies of one size would be worse.
pub(crate) const CONDITION: f64 = 1e3;

/// Rows of T are components in the world: what adds up to a force along a coordinate may be some times as large as that.
const IN_THE_WORLD: f64 = 10.0;

/// The magnitudes that meet add up to `size`. Some hundred roundings, of what is at most a few times as large.
pub(crate) fn assert_close(what: &str, found: f64, expected: f64, size: f64) {
    assert!((found - expected).abs() <= 1e-13 * size, "{what}: {found:e} is not {expected:e} beside {size:e}");
}

/// At random states of the mechanism in several sizes. The coordinates in `lengths` are lengths.
fn agrees(text: &str, lengths: &[usize]) {
    let (random, equations) = (&mut Random(7), &rows::equations(text));
    for (length, mass) in [(1.0, 1.0), (1e-3, 1e-3), (100.0, 1e3)] {
        let model = scaled(text, length, mass);
        let [start, _] = model.initial();
        let multipliers = vec![0.0; model.description().constraints.len()];
        for _ in 0..20 {
            let size = |i: usize| if lengths.contains(&i) { length } else { 1.0 };
            let [off, qd, a] = [(); 3]
                .map(|()| -> Vec<f64> { (0..start.len()).map(|i| size(i) * random.between(-0.7, 0.7)).collect() });
            // Quaternions off their norm, but not near 0, where they turn without bound.
            let q: Vec<f64> = start.iter().zip(&off).map(|(start, off)| start + off).collect();
            let at = At { time: 0.4, positions: &q, speeds: &qd, accelerations: &a, multipliers: &multipliers };
            mass_matrix_is_that_of_the_kinetic_energy(&*model, at, &size);
            inverse_dynamics_are_those_terms(&*model, equations, at, lengths);
            dynamics_solve_them(&*model, equations, at, lengths);
        }
    }
}

/// Second differences of a quadratic function are exact.
fn mass_matrix_is_that_of_the_kinetic_energy(model: &dyn Model, at: At<f64>, size: &impl Fn(usize) -> f64) {
    let n = at.positions.len();
    let energy = |moved: &[usize]| {
        let mut speeds = vec![0.0; n];
        moved.iter().for_each(|i| speeds[*i] += size(*i));
        vector(model, Kernel::KineticEnergy, At { speeds: &speeds, ..at })[0]
    };
    for (i, row) in called(model, Kernel::MassMatrix, at).into_iter().enumerate() {
        for (j, entry) in row.into_iter().enumerate() {
            let energies = [energy(&[i, j]), -energy(&[i]), -energy(&[j]), energy(&[])];
            let sum = energies.iter().map(|energy| energy.abs()).sum();
            assert_close(&format!("mass {i} {j}"), size(i) * size(j) * entry, energies.iter().sum(), sum);
        }
    }
}

/// The energy of its base at a velocity is a quadratic form of it. These rates are those of the coordinates.
fn speed_mass_matrix_is_that_of_the_kinetic_energy(
    model: &dyn Model,
    at: At<f64>,
    bases: &[usize],
    size: &impl Fn(usize) -> f64,
) {
    let n = at.positions.len();
    let mut rates: Vec<(f64, Vec<f64>)> = Vec::new();
    for j in 0..n {
        let mut rate = vec![0.0; n];
        let Some(first) = bases.iter().copied().find(|first| (*first..*first + 7).contains(&j)) else {
            rate[j] = size(j);
            rates.push((size(j), rate));
            continue;
        };
        let q = &at.positions[first + 3..first + 7];
        let quaternion = Quaternion::new(q[0], q[1], q[2], q[3]);
        let axis = |i: usize| Vector3::ith(i, 1.0);
        match j - first {
            i @ 0..3 => {
                let velocity = UnitQuaternion::from_quaternion(quaternion) * axis(i) * size(j);
                rate[first..first + 3].copy_from_slice(velocity.as_slice());
                rates.push((size(j), rate));
            }
            // Seven coordinates have six speeds.
            3 => {}
            i => {
                let Quaternion { coords: half } = quaternion * Quaternion::from_imag(axis(i - 4)) * 0.5;
                rate[first + 3..first + 7].copy_from_slice(&[half.w, half.x, half.y, half.z]);
                rates.push((1.0, rate));
            }
        }
    }
    let energy = |moved: &[usize]| {
        let speeds: Vec<f64> = (0..n).map(|i| moved.iter().map(|of| rates[*of].1[i]).sum()).collect();
        vector(model, Kernel::KineticEnergy, At { speeds: &speeds, ..at })[0]
    };
    let rows = called(model, Kernel::SpeedMassMatrix, at);
    assert_eq!(rows.len(), n - bases.len());
    for (i, row) in rows.into_iter().enumerate() {
        assert_eq!(row.len(), n - bases.len());
        for (j, entry) in row.into_iter().enumerate() {
            let energies = [energy(&[i, j]), -energy(&[i]), -energy(&[j])];
            let sum = energies.iter().map(|energy| energy.abs()).sum();
            assert_close(&format!("mass {i} {j}"), rates[i].0 * rates[j].0 * entry, energies.iter().sum(), sum);
        }
    }
}

/// M q'' + h - Q, and the kernels h and Q, by their terms.
fn inverse_dynamics_are_those_terms(model: &dyn Model, equations: &EquationsOfMotion, at: At<f64>, lengths: &[usize]) {
    let mass = called(model, Kernel::MassMatrix, at);
    let needed = vector(model, Kernel::InverseDynamics, at);
    let (terms, rows) = (rows::forces(equations, model, at), terms(model, equations, at, &mass, at.accelerations));
    let own = [Kernel::ConvectiveForces, Kernel::GeneralizedForces].map(|kernel| vector(model, kernel, at));
    for (i, force) in needed.into_iter().enumerate() {
        let size = IN_THE_WORLD * magnitude(&rows, i, lengths);
        assert_close(&format!("force {i}"), force, rows[i].iter().sum(), size);
        (0..2).for_each(|k| assert_close(&format!("term {k} of force {i}"), own[k][i], terms[k][i], size));
    }
}

/// M q'' + h - Q + C_q' lambda = 0 for the accelerations and multipliers found, and their power.
fn dynamics_solve_them(model: &dyn Model, equations: &EquationsOfMotion, at: At<f64>, lengths: &[usize]) {
    let [accelerations, multipliers, power]: &[Vec<f64>; 3] = &called(model, Kernel::Dynamics, at).try_into().unwrap();
    let (mass, jacobian) = (called(model, Kernel::MassMatrix, at), called(model, Kernel::ConstraintJacobian, at));
    let mut rows = terms(model, equations, at, &mass, accelerations);
    for (i, terms) in rows.iter_mut().enumerate() {
        terms.extend(jacobian.iter().zip(multipliers).map(|(row, multiplier)| row[i] * multiplier));
    }
    for (i, terms) in rows.iter().enumerate() {
        let size = CONDITION * magnitude(&rows, i, lengths);
        assert_close(&format!("equation {i}"), terms.iter().sum(), 0.0, size);
    }
    let found = At { accelerations, multipliers, ..at };
    let [_, given] = rows::forces(equations, model, at);
    let powers: Vec<f64> = given.iter().zip(at.speeds).map(|(force, speed)| force * speed).collect();
    let expected = vector(model, Kernel::Power, found)[0];
    let size = IN_THE_WORLD * (powers.iter().map(|power| power.abs()).sum::<f64>() + expected.abs());
    assert_close("power", power[0], expected, size);
}

/// The terms of M q'' + h - Q in each row.
fn terms(
    model: &dyn Model,
    equations: &EquationsOfMotion,
    at: At<f64>,
    mass: &[Vec<f64>],
    accelerations: &[f64],
) -> Vec<Vec<f64>> {
    let [convective, given] = rows::forces(equations, model, at);
    let row = |i: usize| {
        let inertial = mass[i].iter().zip(accelerations).map(|(entry, acceleration)| entry * acceleration);
        inertial.chain([convective[i], -given[i]]).collect()
    };
    (0..mass.len()).map(row).collect()
}

/// The largest sum of magnitudes in rows of the same unit as this one: components of one force in another frame.
fn magnitude(rows: &[Vec<f64>], of: usize, lengths: &[usize]) -> f64 {
    let same = |i: &usize| lengths.contains(i) == lengths.contains(&of);
    let sums = (0..rows.len()).filter(same).map(|i| rows[i].iter().map(|term| term.abs()).sum());
    sums.fold(0.0, f64::max)
}

#[test]
fn branches_with_a_prismatic_joint() {
    agrees(BRANCHES, &[2]);
}

#[test]
fn a_free_base() {
    agrees(FREE, &[2, 3, 4]);
}

/// A quaternion of zero has no direction.
#[test]
fn a_quaternion_of_zero_is_refused() {
    let model = scaled(FREE, 1.0, 1.0);
    let [mut q, qd] = model.initial();
    let is_refused = |q: &[f64]| {
        let at = At { time: 0.0, positions: q, speeds: &qd, accelerations: &[], multipliers: &[] };
        model.call(Kernel::Dynamics, at, &mut |_, _| ())
    };
    assert!(!is_refused(&q));
    q[5..9].fill(0.0);
    assert!(is_refused(&q));
}

#[test]
fn an_arm_on_the_ground() {
    agrees(ARM, &[2]);
}

#[test]
fn limbs_that_stand_in_one_place() {
    agrees(TWINS, &[2]);
}

/// Where two axes are one, rounding is all that is left of a pivot, wherever the arm stands and however large it is. A wire that
/// rolls about itself has a small pivot of its own, with all its digits.
#[test]
fn gimbal_lock_below_an_arm_is_refused() {
    let random = &mut Random(3);
    for (length, mass) in [(1.0, 1.0), (1e-3, 1e-3), (100.0, 1e3)] {
        let model = scaled(GIMBALS, length, mass);
        for _ in 0..50 {
            let mut q: Vec<f64> = (0..9).map(|_| random.between(-2.0, 2.0)).collect();
            let qd: Vec<f64> = (0..9).map(|_| random.between(-2.0, 2.0)).collect();
            for (b, refused) in [(0.0, true), (1e-9, true), (0.1, false), (-1.5, false)] {
                q[1] = b;
                let at = At { time: 0.0, positions: &q, speeds: &qd, accelerations: &[], multipliers: &[] };
                assert_eq!(model.call(Kernel::Dynamics, at, &mut |_, _| ()), refused, "{b} {q:?}");
            }
        }
    }
}

#[test]
fn a_limb_of_many_joints() {
    agrees(LIMB, &[3, 11, 12, 13, 18, 19, 20]);
    agrees_in_speeds(LIMB, &[3, 11, 12, 13, 18, 19, 20], &[11, 18]);
}

/// As `agrees`; free bodies begin at these coordinates.
fn agrees_in_speeds(text: &str, lengths: &[usize], bases: &[usize]) {
    let random = &mut Random(11);
    for (length, mass) in [(1.0, 1.0), (1e-3, 1e-3), (100.0, 1e3)] {
        let model = scaled(text, length, mass);
        let [start, _] = model.initial();
        for _ in 0..5 {
            let size = |i: usize| if lengths.contains(&i) { length } else { 1.0 };
            let off = |(i, start): (usize, &f64)| start + size(i) * random.between(-0.7, 0.7);
            let q: Vec<f64> = start.iter().enumerate().map(off).collect();
            let at = At { time: 0.0, positions: &q, speeds: &[], accelerations: &[], multipliers: &[] };
            speed_mass_matrix_is_that_of_the_kinetic_energy(&*model, at, bases, &size);
        }
    }
}

#[test]
fn a_driven_base() {
    agrees(DRIVEN, &[]);
}
