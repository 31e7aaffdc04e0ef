//! Linearisation about a state: small motions of the independent coordinates, their modes, and the matrices of a controller.

mod corner;
mod derivatives;
mod differences;
mod modes;
mod reduce;
mod split;
mod statics;
mod steady;

use crate::model::{At, Control, Differentiable};
use crate::motion::lengths::measure;
use crate::motion::measured::check_bodies;
use crate::motion::typed::Any;
use crate::state::failure::{Failure, What};
use crate::state::trajectory::State;
use derivatives::{Derivatives, constraints_depend_on, output_slopes};
use nalgebra::{Complex, DMatrix, DVector};
use reduce::Reduction;
use sim_kernel::Mechanism;

pub use modes::Mode;
pub(crate) use statics::Statics;
pub use steady::quaternions;

/// x' = A x + B u, y = C x + D u about a state, in SI units.
///
/// x are the changes of the independent coordinates and, after them, of the independent speeds; u changes of inputs, or
/// of parameters used as inputs, such as a torque; y changes of the outputs. The matrices are exact at any state of the
/// motion, not in equilibria alone; if the motion is not steady, its eigenvalues hold for one instant.
#[derive(Clone, Debug)]
pub struct Linearization<M: Mechanism> {
    /// Where.
    pub state: State<M>,
    /// The independent coordinates, by index: first those whose speeds the declaration gives at the start, then those
    /// whose values it gives, as far as they determine the others here; pivoting chooses the rest.
    pub independent: Vec<usize>,
    /// The independent speeds, likewise: of the same coordinates, unless constraints hold between speeds alone.
    pub independent_speeds: Vec<usize>,
    /// The coordinates that make A change along the motion; none if the motion is steady. A steady motion moves along
    /// coordinates that nothing depends on, A is constant, and its eigenvalues are those of all small motions about it.
    /// Rest is steady, unless what acts changes with time itself.
    pub unsteady: Vec<usize>,
    /// Whether A is constant along the motion.
    pub is_steady: bool,
    /// Whether what acts has a corner or a jump at the state, where the matrices are those of one side of it, or changes within so small
    /// a way that differences do not find its slope.
    pub has_corner: bool,
    /// The outputs that have a corner or a jump at the state, by index: their rows of C and D hold on one side of it at most.
    /// One by accelerations or multipliers is not seen.
    pub bent_outputs: Vec<usize>,
    /// The quantities that u changes.
    pub inputs: Vec<Control>,
    /// A, h + f square with h independent coordinates and f independent speeds.
    pub a: DMatrix<f64>,
    /// B, h + f x inputs.
    pub b: DMatrix<f64>,
    /// C, outputs x h + f.
    pub c: DMatrix<f64>,
    /// D, outputs x inputs.
    pub d: DMatrix<f64>,
    /// The eigenvalues of A, 2 for each degree of freedom, by imaginary part; a positive real part is unstable.
    pub eigenvalues: Vec<Complex<f64>>,
    /// The modes: one for each pair of conjugate eigenvalues and each real one, slowest first.
    pub modes: Vec<Mode>,
}

/// A speed whose energy, by a change that counts as 1, is this small beside that of another moves nothing.
const LEAST_INERTIA: f64 = 1e-18;

/// Linearises the equations of motion about a state on the constraints.
///
/// With q = (q_i, q_d) the changes of dependent coordinates and speeds are those that keep C = 0 and C_q q' + C_t = 0 to
/// first order, and q_i'' follows from the derivatives of the motion, d(q'')/d(q, q'). (de Jalón and Bayo, Kinematic and
/// Dynamic Simulation of Multibody Systems, 1994, ch. 9; there for equilibria.)
///
/// # Errors
/// [`What::NotAnInput`] for a parameter that constraints depend on, [`What::SingularState`] in a singular position,
/// [`What::NoEigenvalues`]; as the right-hand side.
#[inline(never)]
pub fn linearize<M: Mechanism>(
    mechanism: &M,
    state: &State<M>,
    inputs: &[Control],
) -> Result<Linearization<M>, Failure> {
    check_bodies(mechanism, state.time, &state.positions)?;
    let found = linearize_any(&Any(mechanism), At::state(state), inputs)?;
    let AnyLinearization { a, b, c, d, eigenvalues, modes, reduction, unsteady, has_corner, bent_outputs } = found;
    let is_steady = unsteady.is_none();
    Ok(Linearization {
        state: state.clone(),
        independent: reduction.independent().to_vec(),
        independent_speeds: reduction.independent_speeds().to_vec(),
        unsteady: unsteady.unwrap_or_default(),
        is_steady,
        has_corner,
        bent_outputs,
        inputs: inputs.to_vec(),
        a,
        b,
        c,
        d,
        eigenvalues,
        modes,
    })
}

/// The contents of [`Linearization`] for a mechanism of any type.
struct AnyLinearization {
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    c: DMatrix<f64>,
    d: DMatrix<f64>,
    eigenvalues: Vec<Complex<f64>>,
    modes: Vec<Mode>,
    reduction: Reduction,
    /// Nothing where A is constant.
    unsteady: Option<Vec<usize>>,
    has_corner: bool,
    bent_outputs: Vec<usize>,
}

fn linearize_any(mechanism: &dyn Differentiable, at: At<f64>, inputs: &[Control]) -> Result<AnyLinearization, Failure> {
    let description = mechanism.description();
    if let Some(input) = inputs.iter().find(|input| constraints_depend_on(mechanism, at, **input)) {
        let what = What::NotAnInput { parameter: input.name_in(description) };
        return Err(mechanism.failure(what, at.time, at.positions));
    }
    let derivatives = Derivatives::at(mechanism, at, inputs)?;
    let reduction = Reduction::at(mechanism, at)?;
    let sizes = measure(mechanism, at.time, at.positions).0;
    check_inertia(mechanism, at, &reduction, &sizes)?;
    let columns = columns(&derivatives, &reduction)?;
    let forced = (0..inputs.len()).map(|k| derivatives.forced(k)).collect::<Result<Vec<Change>, Failure>>()?;
    let slopes = |change: &Change, input: Option<Control>| output_slopes(&derivatives, change, input);
    let by_state: Vec<Vec<f64>> = columns.iter().map(|change| slopes(change, None)).collect();
    let by_input: Vec<Vec<f64>> =
        forced.iter().zip(inputs).map(|(change, input)| slopes(change, Some(*input))).collect();
    let outputs = description.outputs.len();
    let a = matrix(&reduction, &columns);
    let (eigenvalues, modes) = modes::modes(&a, |x| reduction.positions(x))
        .map_err(|why| mechanism.failure(What::NoEigenvalues { why }, at.time, at.positions))?;
    Ok(AnyLinearization {
        has_corner: derivatives.are_unsettled() || corner::has_corner(mechanism, at, &sizes),
        bent_outputs: corner::bent_outputs(&derivatives, &columns, &sizes),
        unsteady: steady::unsteady(&derivatives, &reduction, &a, &eigenvalues)?,
        b: matrix(&reduction, &forced),
        c: DMatrix::from_fn(outputs, a.ncols(), |i, k| by_state[k][i]),
        d: DMatrix::from_fn(outputs, inputs.len(), |i, k| by_input[k][i]),
        modes,
        a,
        eigenvalues,
        reduction,
    })
}

/// Refuses a position where a speed moves next to nothing, such as the angle about a pole: how accelerations change is rounding
/// there.
fn check_inertia(
    mechanism: &dyn Differentiable,
    at: At<f64>,
    reduction: &Reduction,
    sizes: &[f64],
) -> Result<(), Failure> {
    let by_speeds = reduction.by_speeds();
    let mass = by_speeds.transpose() * mechanism.mass_matrix(at.time, at.positions) * by_speeds;
    let independent = reduction.independent_speeds();
    let inertias = || independent.iter().enumerate().map(|(k, j)| mass[(k, k)] * sizes[*j] * sizes[*j]);
    let most = inertias().fold(0.0, f64::max);
    let least = inertias().position(|inertia| inertia < LEAST_INERTIA * most);
    least.map_or(Ok(()), |k| {
        let unknown =
            format!("the acceleration of `{}`", mechanism.description().coordinates[independent[k]].position.name);
        Err(mechanism.failure(What::Singular { unknown }, at.time, at.positions))
    })
}

/// The change of the state, with accelerations and multipliers, with each entry of x.
fn columns(derivatives: &Derivatives, reduction: &Reduction) -> Result<Vec<Change>, Failure> {
    let size = reduction.independent().len() + reduction.independent_speeds().len();
    (0..size).map(|k| derivatives.along(reduction, k)).collect()
}

/// A of the changes with the entries of x, B of those with inputs.
fn matrix(reduction: &Reduction, changes: &[Change]) -> DMatrix<f64> {
    let (positions, speeds) = (reduction.independent(), reduction.independent_speeds());
    let h = positions.len();
    DMatrix::from_fn(h + speeds.len(), changes.len(), |i, k| match i < h {
        true => changes[k].speeds[positions[i]],
        false => changes[k].accelerations[speeds[i - h]],
    })
}

/// A small change of all quantities at a state.
#[derive(Clone, Debug)]
pub(crate) struct Change {
    positions: DVector<f64>,
    speeds: DVector<f64>,
    /// Of the accelerations.
    pub(crate) accelerations: DVector<f64>,
    multipliers: DVector<f64>,
}
