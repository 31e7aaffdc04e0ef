//! Static equilibrium, and small motions about it.

use crate::analysis::linearize::{Linearization, Statics, linearize};
use crate::model::{At, Differentiable};
use crate::motion::lengths::measure;
use crate::motion::measured::check_bodies;
use crate::motion::typed::Any;
use crate::numerics::arrays::array;
use crate::start::assemble::{Start, assemble};
use crate::state::failure::{Failure, What};
use crate::state::trajectory::State;
use nalgebra::{Complex, DVector};
use sim_kernel::{Array, Mechanism};

/// A position in which a mechanism at rest stays.
#[derive(Clone, Debug)]
pub struct Equilibrium<M: Mechanism> {
    /// It, at rest at time 0.
    pub state: State<M>,
    /// The reactions there.
    pub multipliers: M::L,
    /// The eigenvalues of small motions about it, 2 for each degree of freedom, by imaginary part; a positive real part
    /// is unstable.
    pub eigenvalues: Vec<Complex<f64>>,
    /// Whether nothing that acts on it, or that small motions depend on, changes with time. Otherwise it holds at time 0 alone.
    pub is_steady: bool,
    /// Whether what acts has a corner or a jump there: small motions differ to either side, and the eigenvalues are those of one.
    pub has_corner: bool,
}

/// The largest rate of a constraint that moves nothing, in its terms per second.
const AT_REST: f64 = 1e-12;
/// Steps of Newton's method.
const MOST_STEPS: usize = 100;
/// The largest number of steps of the descent.
const MOST_DESCENTS: usize = 1000;
/// The longest first step, in the scales of the coordinates: radians, and parts of the mechanism's own length.
const LONGEST: f64 = 0.3;
/// A step is as good as predicted if the residual falls by at least this fraction of the prediction.
const FORETOLD: f64 = 0.1;
/// The number of halvings after which a step is given up. A ground as stiff as 1e15 weights per step ends one only just below it.
const MOST_HALVINGS: i32 = 100;
/// Descent ends where Newton's step is this small, in the same scales.
const NEAR: f64 = 0.1;
/// The margin of stiffness added in the descent, as a fraction of the least stiffness.
const STIFFER: f64 = 1e-3;
/// A step may reverse the force along it, but at most to this fraction of it: then it has led down.
const TURNED: f64 = 0.5;

/// The equilibrium near a start.
///
/// By Newton's method on M q''(q, 0) = 0 over the independent coordinates, in steps that are limited and halved until the
/// residual falls. If that fails, as midway between two equilibria, the result is the position at which the mechanism
/// would come to rest if it moved slowly with damping: descent in steps of (s M - K)^-1 Q, with s so large that the
/// matrix is positive, and Newton's method from near its end. Newton's method also finds unstable
/// equilibria. The mass matrix measures accelerations, and the mechanism's own length and the radian measure steps, so the
/// result does not depend on units; each direction is as soft as it is beside its own coordinates, not beside others.
///
/// # Errors
/// If the start cannot be assembled, [`What::NoEquilibrium`], [`What::Driven`] if time moves a constraint, and [`What::SingularState`] where it is in a singular position.
#[inline(never)]
pub fn equilibrium<M: Mechanism>(mechanism: &M, start: &Start<M>) -> Result<Equilibrium<M>, Failure> {
    let any: &dyn Differentiable = &Any(mechanism);
    let assembled = assemble(mechanism, &at_rest(start))?;
    check_bodies(mechanism, 0.0, &assembled.positions)?;
    let near = assembled.positions.as_ref().to_vec();
    check_undriven(any, &near)?;
    let begin = || Statics::at(any, near.clone(), &measure(any, 0.0, &near).0);
    let found = match newton(any, begin()?)? {
        Ended::AtRest(found) => found,
        Ended::Moving(stuck) => match descend(any, begin()?)? {
            Ended::AtRest(found) => found,
            Ended::Moving(last) => return Err(nowhere(any, &stuck, &last)),
        },
    };
    found.check_inertia(any)?;
    let multipliers = any.accelerate(At::moving(0.0, &found.q, &[]))?;
    let state =
        State { positions: array(mechanism.n(), &found.q), speeds: M::Q::repeat(mechanism.n(), 0.0), ..assembled };
    let multipliers = array(mechanism.m(), &multipliers.as_slice()[mechanism.n()..]);
    let Linearization { eigenvalues, is_steady, has_corner, .. } = linearize(mechanism, &state, &[])?;
    Ok(Equilibrium { state, multipliers, eigenvalues, is_steady, has_corner })
}

/// Refuses constraints that time moves: nothing is at rest on them.
fn check_undriven(mechanism: &dyn Differentiable, q: &[f64]) -> Result<(), Failure> {
    let (rates, terms) = (mechanism.constraint_time_derivative(0.0, q), measure(mechanism, 0.0, q).1);
    let driven = rates.iter().zip(&terms).position(|(rate, terms)| !(rate.abs() <= AT_REST * terms));
    driven.map_or(Ok(()), |row| {
        let constraint = mechanism.description().constraints[row].name;
        Err(mechanism.failure(What::Driven { constraint }, 0.0, q))
    })
}

/// The same start with all coordinates free and no speeds.
fn at_rest<M: Mechanism>(start: &Start<M>) -> Start<M> {
    let none = vec![false; start.positions.len()];
    Start { speeds: start.speeds.like(|_| 0.0), position_given: none.clone(), speed_given: none, ..start.clone() }
}

/// The end of a search.
enum Ended {
    AtRest(Statics),
    Moving(Statics),
}

impl Ended {
    fn at(mechanism: &dyn Differentiable, at: Statics) -> Ended {
        // Far out, where a force fades, nothing accelerates either, but Newton's method would go on.
        // A structure without freedom rests, however its accelerations are rounded.
        if at.is_rigid() || at.is_at_rest() && at.is_settled(mechanism) { Ended::AtRest(at) } else { Ended::Moving(at) }
    }
}

/// The result of Newton's method from a position on the constraints.
///
/// The force must fall; where it is no more than rounding, the next step with the stiffness here, in which the rounding of
/// what is stiff does not hide what is soft. (Deuflhard, Newton Methods for Nonlinear Problems, 2004, section 3.3.)
fn newton(mechanism: &dyn Differentiable, mut at: Statics) -> Result<Ended, Failure> {
    let mut longest = LONGEST;
    for _ in 0..MOST_STEPS {
        let Some(tangent) = at.tangent() else { break };
        let Some(whole) = tangent.step(&at.force()) else { break };
        let (size, residual) = (at.size(&whole), at.strength(&at.force()));
        let is_rounding = at.is_at_rest();
        let left = |force: &DVector<f64>| match is_rounding {
            true => tangent.step(force).map_or(0.0, |next| at.size(&next) / size),
            false => at.strength(force) / residual,
        };
        let share = (longest / size).min(1.0);
        let falls = |force: &DVector<f64>| left(force) < 1.0;
        // At rounding no step is better.
        let Some((next, force, part)) = halved(mechanism, &at, &(&whole * share), &falls)? else { break };
        let (foretold, fallen) = (share * part, 1.0 - left(&force));
        if part == 1.0 && (fallen - foretold).abs() <= FORETOLD * foretold {
            longest *= 2.0;
        }
        at = next;
    }
    Ok(Ended::at(mechanism, at))
}

/// The position at which the mechanism comes to rest.
fn descend(mechanism: &dyn Differentiable, mut at: Statics) -> Result<Ended, Failure> {
    let mut longest = LONGEST;
    for _ in 0..MOST_DESCENTS {
        let (step, is_down) = at.descent(STIFFER);
        let is_near = is_down && at.newton_step().is_some_and(|step| at.size(&step) <= NEAR);
        if is_near {
            let again = Statics::at(mechanism, at.q.clone(), &at.sizes)?;
            if let Ended::AtRest(found) = newton(mechanism, again)? {
                return Ok(Ended::AtRest(found));
            }
        }
        let share = (longest / at.size(&step)).min(1.0);
        let along = at.force().dot(&step);
        let leads_down = |force: &DVector<f64>| force.dot(&step) >= -TURNED * along;
        let Some((next, force, part)) = halved(mechanism, &at, &(&step * share), &leads_down)? else { break };
        // A weight may have far to fall.
        let is_even = part == 1.0 && force.dot(&step) >= (1.0 - FORETOLD) * along;
        longest = LONGEST.max(longest * if is_even { 2.0 } else { part });
        at = next;
    }
    Ok(Ended::at(mechanism, at))
}

/// The first acceptable of a step, its half and so on; with the force there, and its fraction.
///
/// # Errors
/// [`What::SingularState`] if that is there.
fn halved(
    mechanism: &dyn Differentiable,
    at: &Statics,
    step: &DVector<f64>,
    leads: &dyn Fn(&DVector<f64>) -> bool,
) -> Result<Option<(Statics, DVector<f64>, f64)>, Failure> {
    for part in (0..MOST_HALVINGS).map(|k| 0.5f64.powi(k)) {
        let Ok((q, force)) = at.moved(mechanism, &(step * part)) else { continue };
        if leads(&force) {
            match Statics::at(mechanism, q, &at.sizes) {
                Ok(next) => return Ok(Some((next, force, part))),
                Err(singular) if matches!(singular.what, What::SingularState { .. }) => return Err(singular),
                Err(_) => continue,
            }
        }
    }
    Ok(None)
}

/// The failure if neither search found an equilibrium; it names a singular position beside one of them, if there is
/// one.
fn nowhere(mechanism: &dyn Differentiable, stuck: &Statics, last: &Statics) -> Failure {
    let singular = [last, stuck].into_iter().find_map(|at| at.singular_nearby(mechanism));
    singular.unwrap_or_else(|| {
        let (coordinate, acceleration) = stuck.largest_acceleration();
        let name = |j: usize| mechanism.description().coordinates[j].position.name;
        let what = match stuck.hidden(mechanism) {
            Some(j) => What::SoftBesideRounding { coordinate: name(j) },
            None => What::NoEquilibrium { coordinate: name(coordinate), acceleration },
        };
        mechanism.failure(what, 0.0, &stuck.q)
    })
}
