//! Forward sensitivities: how a motion changes with parameters and start.
//!
//! Each step that a simulation takes is repeated on dual numbers: the same stages and the same projection, between the same
//! times. So the derivative is that of the computed motion, to rounding, with its steps held (internal differentiation;
//! Bock, Numerical treatment of inverse problems in chemical reaction kinetics, 1981). Decisions have no derivative:
//! which steps are taken follows from values alone. Where they end beside a jump of what acts on the mechanism, as adaptive
//! steps do, what the move of the jump adds is known ([`jumps`]). Where a step ends on a change of form itself, be it a jump or a corner,
//! the step is repeated up to just before it, and the next one begins just behind it, since derivatives differ on the two sides.

use super::jumps::{self, MovedJump, Rows};
use crate::integrate::{
    ExplicitRungeKutta, FARTHER, around_end, attempt_plainly, leads_over_change, leads_over_row_that_jumps, tableau,
};
use crate::motion::field::Field;
use crate::motion::plain::Plain;
use crate::run::Simulation;
use crate::start::assemble::Start;
use crate::start::derivative::{Direction, along};
use crate::state::failure::{Failure, What};
use crate::state::settings::{Settings, Stabilisation, Stepping};
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Dual, Mechanism};

/// A mechanism on dual numbers.
type Lifted<M> = <M as Mechanism>::On<Dual>;

/// A simulation with the derivative of its state in a direction.
///
/// ```
/// use sim::{Direction, ForwardSensitivity, Settings, declared_start};
/// # sim::mechanism! {
/// #     Cart;
/// #     coordinates { x [m]; }
/// #     parameters { m [kg] = 2; F [N] = 4; }
/// #     bodies { cart: mass m at [x, 0]; }
/// #     loads { force [F, 0] at [x, 0]; }
/// #     initial { x = 0; dot(x) = 0; }
/// # }
/// let cart = Cart::default();
/// let by_mass = Direction { parameters: [1.0, 0.0], positions: [0.0], speeds: [0.0] };
/// let mut motion = ForwardSensitivity::new(cart, &declared_start(&cart), &Settings::new(1.0), &by_mass)?;
/// motion.advance_to(1.0)?;
/// // x = F t^2 / (2 m).
/// assert!((motion.state().positions[0].derivative + 4.0 / (2.0 * 4.0)).abs() < 1e-12);
/// # Ok::<(), sim::Failure>(())
/// ```
#[derive(Clone, Debug)]
pub struct ForwardSensitivity<M: Mechanism> {
    simulation: Simulation<M>,
    plain: Plain<Lifted<M>, Dual>,
    method: ExplicitRungeKutta<Lifted<M>, Dual>,
    sample: Sample<Lifted<M>, Dual>,
    stepping: Stepping,
    /// The end of the motion, in seconds.
    end: f64,
    /// Changes of form up to this time, in seconds, are behind us; it may be slightly later than the present time.
    passed: f64,
}

impl<M: Mechanism> ForwardSensitivity<M> {
    /// A motion that has not begun yet, with the derivative of its start.
    ///
    /// # Errors
    /// As [`Simulation::new`]; [`What::Unusable`] directions; [`What::NotDifferentiable`] if the method is implicit,
    /// constraints are redundant or not kept by projection, or generalised speeds are declared.
    pub fn new(
        mechanism: M,
        start: &Start<M>,
        settings: &Settings,
        direction: &Direction<M>,
    ) -> Result<ForwardSensitivity<M>, Failure> {
        let simulation = Simulation::new(mechanism, start, settings)?;
        let (state, mechanism) = (simulation.state().clone(), simulation.mechanism());
        let fail = |why| Failure::at(mechanism, What::NotDifferentiable { why }, state.time, &state.positions);
        let tableau = tableau(settings.method).ok_or_else(|| fail("its method is implicit; choose an explicit one"))?;
        if let Some(why) = obstacle(&simulation, settings) {
            return Err(fail(why));
        }
        if !direction.suits(mechanism) {
            let setting = "a direction has a finite number for each parameter, coordinate and speed".to_owned();
            return Err(Failure::at(mechanism, What::Unusable { setting }, state.time, &state.positions));
        }
        let lifted = mechanism.on(Dual::constant);
        let constant = lifted.parameters();
        let rate = |p: usize| Dual { derivative: direction.parameters[p], ..constant[p] };
        let lifted = lifted.with_parameters(constant.like(rate));
        let measures = simulation.motion().measures();
        let measures =
            measures.on(|j| Dual::constant(measures.coordinates()[j]), |i| Dual::constant(measures.constraints()[i]));
        let method = ExplicitRungeKutta::new(&lifted, tableau);
        let begun = along((mechanism, &lifted), start, &state, direction)?;
        let plain = Plain::new(lifted, measures);
        let sample = plain.sample(begun)?;
        let (stepping, end, passed) = (settings.stepping, settings.end, f64::NEG_INFINITY);
        Ok(ForwardSensitivity { simulation, plain, method, sample, stepping, end, passed })
    }

    /// The motion itself.
    pub fn simulation(&self) -> &Simulation<M> {
        &self.simulation
    }

    /// The present state with its derivative.
    pub fn state(&self) -> &State<Lifted<M>, Dual> {
        &self.sample.state
    }

    /// The same with accelerations and multipliers.
    pub fn sample(&self) -> &Sample<Lifted<M>, Dual> {
        &self.sample
    }

    /// Advances to a time, at which a step ends, or to the end of the motion if that is earlier. At a jump the derivative is that behind
    /// it; at the start, that of a motion that begins behind it.
    ///
    /// # Errors
    /// As [`Simulation::advance_to`]; [`What::NotFinite`] where the state has no derivative; [`What::NotDifferentiable`] where
    /// the motion passes a singular position, or an event or the corner of a drive changes it, and where an equal step leads over a jump
    /// or a corner whose time moves.
    pub fn advance_to(&mut self, time: f64) -> Result<(), Failure> {
        while let Some(target) = self.simulation.aim(time)? {
            self.check_followed()?;
            let row_jumps = self.row_jumps(target.time)?;
            let before = self.simulation.state().time;
            self.simulation.attempt()?;
            let now = self.simulation.state().time;
            if now > before {
                self.follow(now, row_jumps)?;
                self.check_followed()?;
            }
        }
        self.check_followed()
    }

    /// Whether an equal step to this time leads over a row of a table at which accelerations jump. Adaptive steps end beside them.
    fn row_jumps(&self, time: f64) -> Result<bool, Failure> {
        let is_equal = matches!(self.stepping, Stepping::Equal(_));
        Ok(is_equal && leads_over_row_that_jumps(self.simulation.motion(), &self.simulation.sample()?, time))
    }

    /// Repeats a step to this time on dual numbers; an equal one may lead over a row that is a jump.
    fn follow(&mut self, time: f64, row_jumps: bool) -> Result<(), Failure> {
        let from = self.sample.state.time.value;
        if self.passed == f64::NEG_INFINITY {
            self.passed = from;
            if let Some([_, after]) = self.change_at(from, [from, time]) {
                self.pass(self.sample.state.clone(), after)?;
            }
        }
        match self.change_at(time, [from, time]) {
            Some(around) => self.step_onto_change(time, around, row_jumps)?,
            None => self.step_until(time, row_jumps)?,
        }
        // The same to rounding.
        let state = self.simulation.state();
        set_values(&mut self.sample.state.positions, &state.positions);
        set_values(&mut self.sample.state.speeds, &state.speeds);
        self.sample.state.work.value = state.work;
        let found = &self.sample.state;
        let derivatives = found.positions.iter().chain(found.speeds.iter()).chain([&found.work]);
        match derivatives.map(|number| number.derivative).all(f64::is_finite) {
            true => Ok(()),
            false => {
                let what = What::NotFinite { quantity: "a derivative of the state".to_owned() };
                Err(Failure::at(self.simulation.mechanism(), what, state.time, &state.positions))
            }
        }
    }

    /// Repeats a step to this time, with what a jump within it adds.
    fn step_until(&mut self, time: f64, row_jumps: bool) -> Result<(), Failure> {
        let ahead = attempt_plainly(&self.plain, &mut self.method, &self.sample, Dual::constant(time), None)?.to;
        let moved = self.moved_jump(time, self.rows_until(time, row_jumps))?;
        self.step_over(ahead, moved)
    }

    /// Goes from the present sample to one behind it, with what jumps between them add.
    fn step_over(&mut self, to: Sample<Lifted<M>, Dual>, moved: f64) -> Result<(), Failure> {
        self.sample = match (moved == 0.0, self.moved_jump_of_loads(&to)?) {
            (true, None) => to,
            (true, Some(jump)) => self.plain.sample(jumps::behind_jump(&to.state, &jump))?,
            (false, None) => self.plain.sample(jumps::behind(&self.sample, &to, moved))?,
            (false, Some(_)) => return Err(self.not_differentiable(jumps::TOGETHER)),
        };
        Ok(())
    }

    /// The times just before and behind an end of a step, if something changes its form between them.
    fn change_at(&self, time: f64, step: [f64; 2]) -> Option<[f64; 2]> {
        let around = around_end(step);
        let times = [time - around, time + around];
        jumps::changes_between(self.plain.mechanism(), times).then_some(times)
    }

    /// Repeats a step that ends on a change of form: until right before it, and over it. One of equal steps onto a jump that does not move
    /// is repeated as it is.
    fn step_onto_change(&mut self, time: f64, [before, after]: [f64; 2], row_jumps: bool) -> Result<(), Failure> {
        let begun = self.sample.clone();
        if before > begun.state.time.value {
            self.step_until(before, row_jumps)?;
        }
        let at = |time: f64| self.plain.sample(State { time: Dual::constant(time), ..self.sample.state.clone() });
        let far = [at(time + FARTHER * (before - time))?, at(time + FARTHER * (after - time))?];
        let near = [self.sample.clone(), at(after)?];
        let is_jump = jumps::rates_jump(&near, &far, self.plain.measures().coordinates());
        let is_equal = matches!(self.stepping, Stepping::Equal(_));
        let rows = if is_jump { Rows::All } else { Rows::None };
        // What is continuous adds nothing.
        let moved = if is_jump || !is_equal { self.moved_jump(after, rows)? } else { 0.0 };
        if is_jump && is_equal {
            self.sample = begun;
            return self.step_until(time, row_jumps);
        }
        let [_, behind] = near;
        self.step_over(behind, moved)?;
        let state = self.sample.state.clone();
        self.pass(State { time: Dual::constant(time), ..state }, after)
    }

    /// Goes on from a state with the rates right behind a change.
    fn pass(&mut self, state: State<Lifted<M>, Dual>, after: f64) -> Result<(), Failure> {
        let time = state.time;
        self.sample = self.plain.sample(State { time: Dual::constant(after), ..state })?;
        (self.sample.state.time, self.passed) = (time, after);
        Ok(())
    }

    /// The rows of tables that count in a step to this time: those at which accelerations jump, and in an equal step corners.
    fn rows_until(&self, time: f64, row_jumps: bool) -> Rows {
        match self.stepping {
            _ if row_jumps || leads_over_change([self.sample.state.time.value, time], self.end) => Rows::All,
            Stepping::Equal(_) => Rows::Corners,
            Stepping::Adaptive(_) => Rows::None,
        }
    }

    /// How far a jump at a known time moves, in seconds, that lies before this time and is not behind us yet.
    fn moved_jump(&self, time: f64, rows: Rows) -> Result<f64, Failure> {
        let times = [self.sample.state.time.value.max(self.passed), time];
        if times[0] >= time {
            return Ok(0.0);
        }
        let moved = jumps::moved(self.plain.mechanism(), times, rows);
        let moved = moved.map_err(|why| self.not_differentiable(why))?;
        self.check_move(moved)?;
        Ok(moved)
    }

    /// The jump of loads at a position or speed within a step to this end, if there is one.
    fn moved_jump_of_loads(&mut self, to: &Sample<Lifted<M>, Dual>) -> Result<Option<MovedJump<M>>, Failure> {
        let mut found = None;
        let conditions = jumps::changed(self.plain.mechanism(), [&self.sample, to]);
        if conditions.is_empty() {
            return Ok(None);
        }
        let moves = jumps::moved_by_state(self.plain.mechanism(), &self.sample, &conditions);
        for (condition, moved) in conditions.into_iter().zip(moves) {
            let Some(samples) = self.simulation.jump_by(condition)? else { continue };
            self.check_move(moved)?;
            let first = found.get_or_insert(MovedJump { samples, moved });
            if !jumps::are_same(first.moved, moved) {
                return Err(self.not_differentiable(jumps::TOGETHER));
            }
        }
        Ok(found)
    }

    /// Equal steps do not tell when in a step a jump comes.
    fn check_move(&self, moved: f64) -> Result<(), Failure> {
        let why = "an equal step leads over a sudden change whose time moves; choose a tolerance instead";
        match self.stepping {
            Stepping::Equal(_) if moved != 0.0 => Err(self.not_differentiable(why)),
            _ => Ok(()),
        }
    }

    fn not_differentiable(&self, why: &'static str) -> Failure {
        let state = self.simulation.state();
        Failure::at(self.simulation.mechanism(), What::NotDifferentiable { why }, state.time, &state.positions)
    }

    /// Checks that the simulation has made no steps of other kinds.
    fn check_followed(&self) -> Result<(), Failure> {
        let (state, here) = (self.simulation.state(), &self.sample.state);
        let are_equal = |duals: &[Dual], values: &[f64]| duals.iter().map(|dual| dual.value).eq(values.iter().copied());
        let is_here = are_equal(here.positions.as_ref(), state.positions.as_ref())
            && are_equal(here.speeds.as_ref(), state.speeds.as_ref());
        let steps = self.simulation.steps();
        if is_here && self.simulation.changes() == 0 && steps.singularities.is_empty() && steps.corners.is_none() {
            return Ok(());
        }
        Err(self.not_differentiable("it passes a singular position, or an event or the corner of a drive changes it"))
    }
}

/// Why a simulation cannot be repeated on dual numbers.
fn obstacle<M: Mechanism>(simulation: &Simulation<M>, settings: &Settings) -> Option<&'static str> {
    if simulation.motion().measures().is_redundant() {
        return Some("some of its constraints are redundant; leave them out");
    }
    if simulation.mechanism().rows_left().is_some() {
        return Some("generalised speeds are declared; leave them out");
    }
    let is_kept = settings.stabilisation == Stabilisation::Projection || simulation.mechanism().m() == 0;
    (!is_kept).then_some("its constraints are not kept by projection; choose that stabilisation")
}

/// Sets values, not derivatives.
fn set_values(of: &mut impl Array<Dual>, values: &impl Array<f64>) {
    of.as_mut().iter_mut().zip(values.iter()).for_each(|(number, value)| number.value = *value);
}
