//! An integrator of one's own in thirty lines: the explicit midpoint rule, projected, with events, like every other.

use sim::{
    Advance, Attempt, Course, Failure, Measures, Mechanism, Motion, Sample, Stabilisation, Stepping, Steps, Tolerance,
    assemble, declared_start, integrate,
};
use std::ops::ControlFlow;

struct Midpoint;

impl<M: Mechanism> Advance<M> for Midpoint {
    fn step(
        &mut self,
        motion: &Motion<M>,
        from: &Sample<M>,
        time: f64,
        _: Option<&Tolerance>,
    ) -> Result<Attempt<M>, Failure> {
        let h = time - from.state.time;
        let middle = from.state.changed(from.state.time + h / 2.0, h / 2.0, &from.rates());
        let end = from.state.changed(time, h, &motion.sample(middle)?.rates());
        Ok(Attempt { end, error: 0.0 })
    }
}

fn main() -> Result<(), Failure> {
    let mechanism = models::QuickReturn::default();
    let start = assemble(&mechanism, &declared_start(&mechanism))?;
    let measures = Measures::at(&mechanism, start.time, &start.positions);
    let motion = Motion::new(mechanism, Stabilisation::Projection, measures);
    let start = motion.sample(start)?;
    let course = Course { begin: 0.0, end: 2.0, stepping: Stepping::Equal(20_000) };
    let (mut steps, mut last) = (Steps::default(), start.clone());
    integrate(&motion, &mut Midpoint, &course, start, &mut steps, |step| {
        last = step.to.clone();
        Ok(ControlFlow::Continue(()))
    })?;
    println!("alpha(2 s) = {} rad after {} steps", last.state.positions[0], steps.accepted);
    Ok(())
}
