//! The results of a run without the type of its mechanism, so that all code for text, tables and pictures is compiled
//! once.

use sim_kernel::{Array, Description, Mechanism, Quantity};
use sim_runtime::{
    Apart, Crossing, DOUBTFUL_BALANCE, Erased, Failure, Kinematics, Mobility, Occurrence, OnHeap, Run, Sample,
    Settings, Small, Stepping, Steps, SuddenChanges, Unresolved, readable,
};

/// A run without its samples; all in SI units.
pub struct Outcome {
    /// What is told of the mechanism.
    pub description: &'static Description,
    /// Its parameters.
    pub parameters: Vec<f64>,
    /// Their declared defaults.
    pub defaults: Vec<f64>,
    /// How it was integrated.
    pub settings: Settings,
    /// The first sample.
    pub start: Option<Row>,
    /// The time of the last sample.
    pub reached: f64,
    /// The number of samples.
    pub samples: usize,
    /// Why it ended early, if it did.
    pub failure: Option<Failure>,
    /// The events, in order.
    pub events: Vec<Happening>,
    /// The independent coordinates of each dead point, and its time.
    pub dead_points: Vec<(Vec<&'static str>, f64)>,
    /// As [`Run::period`].
    pub period: Option<f64>,
    /// As [`Run::mobility`].
    pub mobility: Mobility,
    /// As [`Run::redundant_later`].
    pub redundant_later: Vec<(f64, Mobility)>,
    /// As [`Run::steps`].
    pub steps: Steps,
    /// As [`Run::evaluations`].
    pub evaluations: u64,
    /// As [`Run::position_residual`].
    pub position_residual: f64,
    /// As [`Run::velocity_residual`].
    pub velocity_residual: f64,
    /// As [`Run::energy_balance`].
    pub energy_balance: f64,
    /// As [`Run::energy_balance_of_changes`].
    pub energy_balance_of_changes: f64,
    /// As [`Run::energy_taken`].
    pub energy_taken: f64,
    /// As [`Run::compared`].
    pub compared: Option<f64>,
    /// As [`Run::apart`].
    pub apart: Option<Apart>,
    /// As [`Run::integration_time`], in seconds.
    pub integration_seconds: f64,
    /// As [`Run::farthest_unmeasured`].
    pub farthest_unmeasured: Option<f64>,
    /// As [`Run::unresolved`].
    pub unresolved: Option<Unresolved>,
}

/// The event that is to end a run.
pub struct Until {
    /// Its name.
    pub event: &'static str,
    /// At which of its occurrences.
    pub asked: usize,
    /// How often it has happened.
    pub happened: usize,
}

impl Outcome {
    /// The event that was to end the run, if one was.
    pub fn until(&self) -> Option<Until> {
        let stop = self.settings.stop?;
        let event = self.description.events.get(stop.event)?.name;
        let happened = self.events.iter().filter(|happening| happening.event == stop.event).count();
        Some(Until { event, asked: stop.occurrence, happened })
    }

    /// Why its numbers may be wrong.
    pub fn warnings(&self) -> Vec<String> {
        let others = [
            self.over_sudden_changes(),
            self.without_a_length(),
            self.within_tolerance(),
            self.off(),
            self.stiff(),
            self.out_of_balance(),
        ];
        others.into_iter().flatten().collect()
    }

    /// Whether energy is lost or won by nothing.
    pub fn is_out_of_balance(&self) -> bool {
        !(self.energy_balance < DOUBTFUL_BALANCE && self.energy_balance_of_changes < DOUBTFUL_BALANCE)
    }

    fn out_of_balance(&self) -> Option<String> {
        let off = match self.energy_balance < DOUBTFUL_BALANCE {
            true => format!(": it is off by {:.1e} of what changes", self.energy_balance_of_changes),
            false => String::new(),
        };
        let advice = "take smaller steps before you trust these numbers";
        self.is_out_of_balance().then(|| format!("energy does not balance{off}; {advice}"))
    }

    /// What is wrong where stability limits adaptive steps.
    fn stiff(&self) -> Option<String> {
        let is_stiff = self.steps.stability.is_stiff() && matches!(self.settings.stepping, Stepping::Adaptive(_));
        is_stiff.then(|| {
            "the mechanism is stiff for this method: stability limits its steps, and accelerations and forces may go to and fro \
             about the right ones; take `--method radau5`"
                .to_owned()
        })
    }

    /// By how much a coordinate is off.
    fn off(&self) -> Option<String> {
        let Apart { tolerance, coordinate, by, extent, time, since } = self.apart?;
        let Quantity { name, unit, factor, .. } = &self.description.coordinates[coordinate].position;
        let [by, extent] = [by, extent].map(|value| value / factor);
        let unit = if *unit == "1" { String::new() } else { format!(" {unit}") };
        let off =
            format!("`{name}` is off by {by:.1e}{unit} at {} s, on a way of {extent:.1e}{unit}", readable(time, 6));
        let beside = format!("{off}, beside a run with a tolerance of {tolerance:.0e}");
        Some(match self.settings.stepping {
            Stepping::Equal(_) => format!("{beside}: take more steps, or a tolerance (`--rtol`)"),
            Stepping::Adaptive(_) => format!(
                "{beside}: rows from {} s on are off by more than a thousandth of the way; take a smaller tolerance (`--rtol`), or \
                 fewer seconds where small errors grow",
                readable(since, 6)
            ),
        })
    }

    /// Where speeds have jumped, since what time drives has a corner.
    pub fn corners(&self) -> Option<String> {
        let SuddenChanges { steps, first, .. } = self.steps.corners?;
        let times = if steps == 1 { String::new() } else { format!(", the first of {steps} times") };
        let at = format!("speeds jump at {} s{times}, where what time drives has a corner", readable(first, 9));
        Some(format!("{at}: by an impulse, which reactions do not show"))
    }

    /// What tolerances mean where no length is declared, if the motion is small.
    fn without_a_length(&self) -> Option<String> {
        let (Some(farthest), Stepping::Adaptive(tolerance)) = (self.farthest_unmeasured, self.settings.stepping) else {
            return None;
        };
        let is_small = farthest > 0.0 && tolerance.absolute > SMALL * tolerance.relative * farthest;
        let finer = tolerance.relative * farthest;
        is_small.then(|| {
            format!(
                "no parameter and no start is a length, so lengths are measured by 1 m: they stay within {farthest:.1e} m, and a step \
                 may be wrong by {:.1e} m; give a parameter or the start a length, or take `--atol {finer:.0e}`",
                tolerance.absolute
            )
        })
    }

    /// What tolerances mean for a coordinate that starts and stays within them.
    fn within_tolerance(&self) -> Option<String> {
        let (Some(Unresolved { coordinate, begins, farthest, scale }), Stepping::Adaptive(tolerance)) =
            (self.unresolved, self.settings.stepping)
        else {
            return None;
        };
        let Quantity { name, unit, factor, .. } = &self.description.coordinates[coordinate].position;
        let unit = if *unit == "1" { String::new() } else { format!(" {unit}") };
        let ([stays, wrong], finer) =
            ([farthest, tolerance.absolute * scale].map(|value| value / factor), tolerance.relative * begins / scale);
        Some(format!(
            "`{name}` stays within {stays:.1e}{unit}, and a step may be wrong by {wrong:.1e}{unit}: take `--atol {finer:.0e}`"
        ))
    }

    /// What equal steps over sudden changes may have missed.
    fn over_sudden_changes(&self) -> Option<String> {
        let SuddenChanges { steps, first, .. } = self.steps.sudden_changes?;
        let led = if steps == 1 { "one equal step leads".to_owned() } else { format!("{steps} equal steps lead") };
        Some(format!(
            "{led} over a sudden change or a short pulse of what acts on the mechanism, the first at {} s: such a step is less accurate, and does not see what begins and ends within it; steps with a tolerance (`--rtol`) end where such changes are",
            readable(first, 9)
        ))
    }
}

/// An event as it happened.
pub struct Happening {
    /// Which event, by index.
    pub event: usize,
    pub name: &'static str,
    pub crossing: Crossing,
    pub time: f64,
    /// Its impulses and losses, if it has actions.
    pub change: Option<Done>,
}

/// The effects of an event.
pub struct Done {
    /// The lost kinetic energy, in joules.
    pub energy_taken: f64,
    /// The impulse of each constraint row.
    pub impulses: Vec<f64>,
}

/// A sample with its mechanism.
pub struct Row {
    pub time: f64,
    pub positions: Vec<f64>,
    pub speeds: Vec<f64>,
    pub accelerations: Vec<f64>,
    pub multipliers: Vec<f64>,
    pub work: f64,
    /// The inputs that are held.
    pub inputs: Vec<Option<f64>>,
    pub parameters: Vec<f64>,
    pub kinetic_energy: f64,
    /// The energy that events have taken until then.
    pub energy_taken: f64,
    /// The numbers of the drawing.
    pub drawing: Vec<f64>,
}

/// The samples of a motion, of a mechanism without a type.
pub trait Rows {
    /// A sample.
    fn row(&self, index: usize) -> Row;
}

/// A run whose mechanism has no type.
pub trait Recorded: Rows {
    /// All but the samples.
    fn outcome(&self) -> Outcome;
}

impl<M: Mechanism> Recorded for Run<M> {
    fn outcome(&self) -> Outcome {
        let samples = &self.trajectory.samples;
        Outcome {
            description: self.mechanism.description(),
            parameters: list(&self.mechanism.parameters()),
            defaults: list(&self.mechanism.as_declared().parameters()),
            settings: self.settings,
            start: (!samples.is_empty()).then(|| self.row(0)),
            reached: samples.last().map_or(0.0, |sample| sample.state.time),
            samples: samples.len(),
            failure: self.trajectory.failure.clone(),
            events: self.events.iter().map(happening).collect(),
            dead_points: self.dead_points.iter().map(|point| (point.of.clone(), point.state.time)).collect(),
            period: self.period(),
            mobility: self.mobility.clone(),
            redundant_later: self.redundant_later.clone(),
            steps: self.steps.clone(),
            evaluations: self.evaluations,
            position_residual: self.position_residual,
            velocity_residual: self.velocity_residual,
            energy_balance: self.energy_balance,
            energy_balance_of_changes: self.energy_balance_of_changes,
            energy_taken: self.energy_taken,
            compared: self.compared,
            apart: self.apart,
            integration_seconds: self.integration_time.as_secs_f64(),
            farthest_unmeasured: self.farthest_unmeasured(),
            unresolved: self.unresolved(),
        }
    }
}

/// The absolute tolerance is large beside this many times what is allowed relative to the largest length.
const SMALL: f64 = 1e3;

impl<M: Mechanism> Rows for Run<M> {
    fn row(&self, index: usize) -> Row {
        let phase = self.trajectory.phase_of(index);
        let mechanism = phase.map_or(&self.mechanism, |phase| &phase.mechanism);
        Row::new(mechanism, &self.trajectory.samples[index], phase.map_or(0.0, |phase| phase.energy_taken))
    }
}

impl<M: Mechanism> Rows for Kinematics<M> {
    fn row(&self, index: usize) -> Row {
        Row::new(&self.mechanism, &self.trajectory.samples[index], 0.0)
    }
}

impl Row {
    /// A sample of a mechanism.
    #[inline(never)]
    pub fn new<M: Mechanism>(mechanism: &M, sample: &Sample<M>, energy_taken: f64) -> Row {
        let (t, q, qd) = (sample.state.time, &sample.state.positions, &sample.state.speeds);
        Row {
            time: t,
            positions: list(q),
            speeds: list(qd),
            accelerations: list(&sample.accelerations),
            multipliers: list(&sample.multipliers),
            work: sample.state.work,
            inputs: sample.inputs.iter().map(|input| input.held()).collect(),
            parameters: list(&mechanism.parameters()),
            kinetic_energy: mechanism.with_inputs(sample.inputs.clone()).kinetic_energy(t, q, qd),
            energy_taken,
            drawing: list(&mechanism.drawing(t, q)),
        }
    }
}

/// Rows of mechanisms whose sizes are known at run time are compiled here, not with a command line that is less optimised, as the
/// runtime's loops are.
#[used]
static COMPILED: [fn(); 2] = [rows_of::<Erased<Small>>, rows_of::<Erased<OnHeap>>];

fn rows_of<M: Mechanism>() {
    std::hint::black_box(Row::new::<M> as *const ());
}

fn happening<M: Mechanism>(event: &Occurrence<M>) -> Happening {
    let Occurrence { event: index, name, crossing, state, change } = event;
    let done =
        |change: &sim_runtime::Change<M>| Done { energy_taken: change.energy_taken, impulses: list(&change.impulses) };
    Happening { event: *index, name, crossing: *crossing, time: state.time, change: change.as_ref().map(done) }
}

/// The numbers of an array.
pub fn list(numbers: &impl Array<f64>) -> Vec<f64> {
    numbers.iter().copied().collect()
}
