//! Recursions over links, which write `dynamics`, `inverse_dynamics`, `mass_matrix` and the terms of the equations of motion for
//! these mechanisms, against what comes from rows of T: kinetic energy, convective and generalised forces, power. They share the
//! resolved model alone.

use crate::rows;
use codegen::dynamics::EquationsOfMotion;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use sim::{At, DeclarationFile, Kernel, Model};
use std::path::Path;
use std::sync::Arc;
use tests::Random;

/// Branches, a prismatic joint, a coordinate that turns two links, skew axes, fixed turns, and centres of mass beside their
/// frames; parameters for masses, so that regrouping is symbolic.
pub(crate) const BRANCHES: &str = "
    pub Branches;
    coordinates { a [rad]; b [rad]; c [m]; d [rad]; h [rad]; f [rad]; g [rad]; }
    parameters { L [m] = 1; m [kg] = 1; k [N/m] = 20; }
    let A = rotation(z, a);
    let B = A*axes([0, 0, -1], [0, 1, 0], [1, 0, 0])*rotation(y, b);
    let PB = A*[0.2*L, 0.1*L, 0.3*L];
    let PC = PB + B*[0, 0.1*L, 0.4*L + c];
    let D = B*rotation([0.6, 0, 0.8], d)*rotation(x, 0.3 - 2*b);
    let E = A*rotation(x, h);
    let PE = A*[-0.3*L, 0, 0.1*L];
    let F = E*euler(zxz, f, 0.4, g);
    let PF = PE + E*[0.1*L, -0.5*L, 0];
    bodies {
        first: mass 2*m at A*[0.1*L, 0.2*L, -0.1*L], inertia [0.3*m*L^2, 0.2*m*L^2, 0.25*m*L^2, 0.01*m*L^2, 0.02*m*L^2, 0.03*m*L^2], attitude A;
        second: mass m at PB + B*[0.05*L, 0.1*L, 0.2*L], inertia [0.1*m*L^2, 0.09*m*L^2, 0.05*m*L^2], attitude B;
        third: mass 0.5*m at PC + B*[0.02*L, 0, 0], inertia [0.01*m*L^2, 0.012*m*L^2, 0.008*m*L^2], attitude B;
        fourth: mass 0.3*m at PC + D*[0, 0.1*L, 0.05*L], inertia [0.011*m*L^2, 0.012*m*L^2, 0.013*m*L^2, 0.001*m*L^2, 0, 0.002*m*L^2], attitude D;
        fifth: mass m at PE + E*[0, -0.2*L, 0.1*L], inertia [0.1*m*L^2, 0.04*m*L^2, 0.09*m*L^2], attitude E;
        sixth: mass 0.4*m at PF + F*[0.03*L, 0.02*L, 0.2*L], inertia [0.02*m*L^2, 0.03*m*L^2, 0.015*m*L^2], attitude F;
        wheel: inertia [0.001*m*L^2, 0.001*m*L^2, 0.002*m*L^2], attitude F;
    }
    loads { gravity [1 [m/s^2], -2 [m/s^2], -9.81 [m/s^2]]; spring k, length 0.1*L from PC to PF; torque 0.1*m*L^2*t/(1 [s^3]) on h; }
    kernels { inverse_dynamics; }";

/// A base that moves freely, and one limb. The last load acts along its quaternion, which the multiplier of the norm
/// takes up.
pub(crate) const FREE: &str = "
    pub Floating;
    parameters { L [m] = 1; m [kg] = 1; k [N/m] = 20; }
    bodies { base: free, mass 3*m, inertia [0.3*m*L^2, 0.4*m*L^2, 0.35*m*L^2, 0.01*m*L^2, 0.02*m*L^2, 0.03*m*L^2]; }
    coordinates { a [rad]; b [rad]; }
    let A = attitude(base)*rotation(y, a);
    let PA = on(base, [0.1*L, 0.2*L, -0.3*L]);
    let B = A*rotation(y, b);
    let PB = PA + A*[0, 0.1*L, -0.4*L];
    bodies {
        upper: mass m at PA + A*[0.01*L, 0.03*L, -0.2*L], inertia [0.05*m*L^2, 0.06*m*L^2, 0.03*m*L^2], attitude A;
        lower: mass 0.7*m at PB + B*[0.02*L, 0, -0.15*L], inertia [0.02*m*L^2, 0.03*m*L^2, 0.015*m*L^2], attitude B;
    }
    loads {
        gravity [0, 0, -9.81 [m/s^2]];
        spring k, length 0.1*L from PA to PB;
        potential m*L^2*(base_q0^3 + 2*base_q2)/(1 [s^2]);
    }
    kernels { inverse_dynamics; }";

/// A base with loads on it, and a limb of so many joints that each is eliminated at its link: about axes of a frame and askew,
/// one that slides, one with a rotor that turns with it, two on one link. And a second base, of which the first knows nothing.
pub(crate) const LIMB: &str = "
    pub Limb;
    parameters { L [m] = 1; m [kg] = 1; k [N/m] = 20; }
    bodies {
        base: free, mass 3*m, inertia [0.3*m*L^2, 0.4*m*L^2, 0.35*m*L^2, 0.01*m*L^2, 0.02*m*L^2, 0.03*m*L^2];
        other: free, mass 2*m, inertia [0.2*m*L^2, 0.1*m*L^2, 0.25*m*L^2];
    }
    coordinates { a [rad]; b [rad]; c [rad]; d [m]; s [rad]; f [rad]; g [rad]; h [rad]; i [rad]; o [rad]; u [rad]; }
    let A = attitude(base)*rotation(y, a);
    let PA = on(base, [0.1*L, 0.2*L, -0.3*L]);
    let B = A*rotation(x, b);
    let PB = PA + A*[0, 0.1*L, -0.4*L];
    let C = B*rotation([0.6, 0, 0.8], c);
    let PC = PB + B*[0.1*L, 0.1*L, -0.3*L];
    let PD = PC + C*[0, 0.1*L, d];
    let E = C*rotation(z, s);
    let PE = PD + C*[0.1*L, 0, 0.2*L];
    let F = E*axes([0, 1, 0], [0, 0, 1], [1, 0, 0])*rotation(y, f);
    let PF = PE + E*[0, -0.3*L, 0.1*L];
    let G = F*rotation(y, g);
    let PG = PF + F*[0.2*L, 0.1*L, 0];
    let H = G*rotation(x, h);
    let PH = PG + G*[0.2*L, 0, 0.3*L];
    let I = H*rotation(z, i + 2*u);
    let PI = PH + H*[0, 0.3*L, 0.1*L];
    let O = attitude(other)*rotation(z, o);
    bodies {
        one: mass m at PA + A*[0.01*L, 0.03*L, -0.2*L], inertia [0.05*m*L^2, 0.06*m*L^2, 0.03*m*L^2], attitude A;
        two: mass 0.7*m at PB + B*[0.02*L, 0, -0.15*L], inertia [0.02*m*L^2, 0.03*m*L^2, 0.015*m*L^2], attitude B;
        three: mass 0.6*m at PC + C*[0.02*L, 0, -0.1*L], inertia [0.02*m*L^2, 0.03*m*L^2, 0.025*m*L^2, 0.001*m*L^2, 0.002*m*L^2, 0], attitude C;
        four: mass 0.5*m at PD + C*[0.1*L, 0.02*L, 0], inertia [0.01*m*L^2, 0.012*m*L^2, 0.008*m*L^2], attitude C;
        five: mass 0.5*m at PE + E*[0.1*L, 0.02*L, 0], inertia [0.01*m*L^2, 0.012*m*L^2, 0.009*m*L^2], attitude E;
        six: mass 0.4*m at PF + F*[0.05*L, 0.1*L, 0.1*L], inertia [0.01*m*L^2, 0.011*m*L^2, 0.008*m*L^2], attitude F;
        seven: mass 0.4*m at PG + G*[0.05*L, 0, 0.1*L], inertia [0.01*m*L^2, 0.012*m*L^2, 0.007*m*L^2], attitude G;
        eight: mass 0.3*m at PH + H*[0, 0.1*L, 0.1*L], inertia [0.01*m*L^2, 0.012*m*L^2, 0.008*m*L^2], attitude H;
        nine: mass 0.3*m at PI + I*[0.05*L, 0.1*L, 0.1*L], inertia [0.009*m*L^2, 0.012*m*L^2, 0.008*m*L^2], attitude I;
        ten: mass m at on(other, [0.1*L, 0, 0.2*L]) + O*[0.1*L, 0.1*L, 0], inertia [0.1*m*L^2, 0.12*m*L^2, 0.08*m*L^2], attitude O;
        rotor: inertia 0.02*m*L^2, angle b;
        gear: inertia 0.03*m*L^2, angle u + 0.2*sin(u);
    }
    loads {
        gravity [1 [m/s^2], 0, -9.81 [m/s^2]];
        spring k, length 0.1*L from PA to PF;
        spring k, length 0.2*L from [0, 0, L] to on(base, [0, 0.1*L, 0.2*L]);
        torque [0.1*m*L^2/(1 [s^2]), 0, 0.2*m*L^2/(1 [s^2])] on base;
        torque 0.1*m*L^2/(1 [s^2]) on g;
    }
    kernels { inverse_dynamics; speed_mass_matrix; }";

/// An arm on the ground: turns about axes of a frame and askew, one that slides askew, and two motors of one turn.
pub(crate) const ARM: &str = "
    pub Arm;
    parameters { L [m] = 1; m [kg] = 1; k [N/m] = 20; }
    coordinates { a [rad]; b [rad]; s [m]; c [rad]; d [rad]; h [rad]; f [rad]; }
    let A = rotation(x, 0.3)*rotation(z, a);
    let B = A*rotation([0.6, 0, 0.8], b);
    let PB = A*[0.1*L, 0.2*L, 0.3*L];
    let PS = PB + B*[0.3*L, 0.6*s, 0.8*s];
    let C = B*rotation(y, c + 3*d);
    let PC = PS + B*[0, 0.1*L, 0.2*L];
    let E = C*rotation(x, h);
    let PE = PC + C*[0.2*L, 0, 0.1*L];
    let F = E*rotation(y, f);
    let PF = PE + E*[0, 0.3*L, 0];
    bodies {
        one: mass m at A*[0.01*L, 0.03*L, 0.2*L], inertia [0.05*m*L^2, 0.06*m*L^2, 0.03*m*L^2, 0.001*m*L^2, 0, 0.002*m*L^2], attitude A;
        two: mass 0.7*m at PB + B*[0.02*L, 0, 0.15*L], inertia [0.02*m*L^2, 0.03*m*L^2, 0.015*m*L^2], attitude B;
        three: mass 0.6*m at PS + B*[0.02*L, 0.1*L, 0], inertia [0.02*m*L^2, 0.03*m*L^2, 0.025*m*L^2], attitude B;
        four: mass 0.5*m at PC + C*[0.1*L, 0.02*L, 0], inertia [0.01*m*L^2, 0.012*m*L^2, 0.008*m*L^2, 0, 0.001*m*L^2, 0], attitude C;
        five: mass 0.4*m at PE + E*[0, 0.1*L, 0.03*L], inertia [0.01*m*L^2, 0.008*m*L^2, 0.009*m*L^2], attitude E;
        six: mass 0.3*m at PF + F*[0.1*L, 0, 0.1*L], inertia [0.004*m*L^2, 0.006*m*L^2, 0.005*m*L^2], attitude F;
        motor: inertia 0.02*m*L^2, angle d;
    }
    loads {
        gravity [1 [m/s^2], 0, -9.81 [m/s^2]];
        spring k, length 0.1*L from PB to PF;
        torque -0.1*m*L^2*dot(h)/(1 [s]) on h;
    }
    kernels { inverse_dynamics; }";

/// A table that time turns and lifts carries an arm: the power is that of loads and drives.
pub(crate) const DRIVEN: &str = "
    pub Driven;
    coordinates { a [rad]; b [rad]; }
    parameters { L [m] = 1; m [kg] = 1; w [1/s] = 2; }
    let R = rotation(z, 0.3*sin(w*t));
    let A = R*rotation(x, a);
    let PA = [0, 0, 0.2*L*sin(w*t)] + R*[0.3*L, 0, 0.1*L];
    let B = A*rotation(y, b);
    let PB = PA + A*[0, 0.5*L, 0];
    bodies {
        arm: mass m at PA + A*[0.05*L, 0.25*L, 0], inertia [0.075*m*L^2, 0.01*m*L^2, 0.07*m*L^2, 0.002*m*L^2, 0, 0], attitude A;
        hand: mass 0.5*m at PB + B*[0.1*L, 0.05*L, 0.02*L], inertia [0.01*m*L^2, 0.02*m*L^2, 0.015*m*L^2], attitude B;
    }
    loads { gravity [0, 0, -9.81 [m/s^2]]; }
    kernels { inverse_dynamics; }";

pub(crate) fn called(model: &dyn Model, kernel: Kernel, at: At<f64>) -> Vec<Vec<f64>> {
    let mut found = Vec::new();
    assert!(!model.call(kernel, at, &mut |_, row| found.push(row.to_vec())), "{kernel:?} is refused");
    found
}

pub(crate) fn vector(model: &dyn Model, kernel: Kernel, at: At<f64>) -> Vec<f64> {
    called(model, kernel, at).concat()
}

/// Lengths are multiples of L and masses of m: of a mechanism of a millimetre as of one of 100 m.
pub(crate) fn scaled(text: &str, length: f64, mass: f64) -> Arc<dyn Model> {
    let model = DeclarationFile::of(Path::new("links.mech"), text.to_owned()).model(None).unwrap();
    let mut values = model.values();
    values.parameters[0] = length;
    values.parameters[1] = mass;
    model.with_values(&values)
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
