//! Whether what a draw gives is right: a reference, a second way to it, and bounds.

use super::draw::{Draw, Parameters, Task};
use super::ranges::Range;
use super::typed::{Form, Found, Refusal};
use sim::{Method, Rows, Settings, Stabilisation, Stepping};
use std::f64::consts::{PI, TAU};

/// What became of a draw.
#[derive(Clone, Debug)]
pub(crate) enum Verdict {
    Right,
    /// Refused by name, though there is an answer.
    Refused(String, String),
    /// Refused by all.
    Unanswered,
    /// The references differ, or there is none.
    Undecided(String),
    Wrong(String),
}

/// A reference with the room that it leaves.
struct Reference {
    form: usize,
    task: Task,
    found: Found,
    /// Of each column its range, and how far it moves with the start, once that is asked for.
    ranges: Vec<f64>,
    moved: Option<Vec<f64>>,
    /// Every how manieth row is compared.
    stride: usize,
}

/// Two references agree to this part of a column's range.
const CONFIRMED: f64 = 1e-9;
/// What the start is changed by, relative.
const NUDGE: f64 = 1e-12;

/// These pass singular positions, where the directions across the constraints change within a step: there equal steps by
/// partitioning lose digits that those by projection keep.
const GO_FLAT: [&str; 2] = ["ParallelCranks", "Parallelograms"];

/// Runs a draw and judges it.
pub(crate) fn judge(draw: &Draw) -> Verdict {
    let result = draw.result(draw.linkage.forms[draw.form], &draw.parameters, &draw.task);
    if let Err(Refusal::Panic(words)) = result {
        return Verdict::Wrong(words);
    }
    let reference = draw.reference();
    match (result, reference) {
        (Ok(found), Ok(mut reference)) => match draw.worst(&found, &mut reference) {
            Ok(None) => draw.beside_projection(&found, &mut reference),
            Ok(Some((share, words))) if draw.is_coarse(share, &mut reference) => {
                Verdict::Wrong(format!("{words}, and another form about as far off"))
            }
            Ok(Some((_, words))) => Verdict::Wrong(words),
            Err(why) => Verdict::Undecided(why),
        },
        (Err(Refusal::Named(name, words)), Ok(_)) => Verdict::Refused(name, words),
        (Err(Refusal::Named(..)), Err(_)) => Verdict::Unanswered,
        (_, Err(why)) => Verdict::Undecided(why),
        (Err(Refusal::Panic(words)), _) => Verdict::Wrong(words),
    }
}

impl Task {
    fn rows(&self) -> usize {
        match self {
            Task::Run(Settings { rows: Rows::Even(rows), .. }) => *rows,
            Task::Run(_) => 1,
            Task::Sweep(_, rows) => *rows,
        }
    }

    /// The same, with more rows, as exactly as can be.
    fn exactly(&self, stride: usize, method: Method, relative: f64, stabilisation: Stabilisation) -> Task {
        let rows = self.rows() * stride;
        match self {
            Task::Run(settings) => {
                let exact = Settings::adaptive(method, settings.end, relative);
                Task::Run(Settings { rows: Rows::Even(rows), stabilisation, ..exact })
            }
            Task::Sweep(span, _) => Task::Sweep(*span, rows),
        }
    }

    /// What may be off, as a part of a column's range.
    fn bound(&self) -> f64 {
        match self {
            Task::Sweep(..) => CONFIRMED,
            Task::Run(Settings { stepping: Stepping::Adaptive(tolerance), .. }) => 1e4 * tolerance.relative,
            // Methods of higher order than RK4 take as many stages or more, and are held to what it is held to.
            Task::Run(Settings { method, .. }) => match method {
                Method::Euler => 0.2,
                Method::Heun => 1e-2,
                Method::Rk3 => 1e-3,
                Method::Rk4 | Method::Dopri5 | Method::Radau5 | Method::Dop853 => 1e-4,
            },
        }
    }
}

impl Draw {
    fn result(&self, form: &dyn Form, parameters: &Parameters, task: &Task) -> Result<Found, Refusal> {
        match task {
            Task::Run(settings) => form.run(parameters, settings),
            Task::Sweep(span, rows) => form.sweep(parameters, *span, *rows),
        }
    }

    /// A reference that a second form or method confirms.
    fn reference(&self) -> Result<Reference, String> {
        let stride = 200usize.div_ceil(self.task.rows());
        let forms = self.linkage.forms;
        let projected = Stabilisation::Projection;
        let ways = [
            (0, Method::Dop853, 1e-13, projected),
            (1, Method::Dop853, 1e-13, projected),
            (0, Method::Dop853, 1e-12, Stabilisation::Partitioning),
            (1, Method::Dopri5, 1e-12, Stabilisation::Partitioning),
        ];
        let mut references: Vec<Reference> = Vec::new();
        let mut doubts = Vec::new();
        for (form, method, relative, stabilisation) in ways {
            let task = self.task.exactly(stride, method, relative, stabilisation);
            let another = match self.result(forms[form], &self.parameters, &task) {
                Ok(another) => another,
                Err(refusal) => {
                    doubts.push(format!("{} refused: {refusal:?}", forms[form].name()));
                    continue;
                }
            };
            for i in 0..references.len() {
                match self.beyond(&another, &mut references[i], CONFIRMED, 1.0) {
                    Ok(None) => return Ok(Reference { stride, ..references.swap_remove(i) }),
                    Ok(Some((_, words))) | Err(words) => doubts.push(words),
                }
            }
            let ranges = self.ranges(&another);
            references.push(Reference { form, task, found: another, ranges, moved: None, stride: 1 });
        }
        Err(doubts.join("; "))
    }

    /// How far each column of a reference moves with the start.
    fn moved(&self, reference: &Reference) -> Result<Vec<f64>, String> {
        let Reference { form, task, found, .. } = reference;
        let nudged = self.result(self.linkage.forms[*form], &self.nudged(), &self.nudged_task(task));
        let nudged = nudged.map_err(|refusal| format!("nudged: {refusal:?}"))?;
        let moved = |i: usize| {
            let pairs = found.columns[i].iter().zip(&nudged.columns[i]);
            pairs.map(|(a, b)| found.apart(i, *a, *b)).fold(0.0, f64::max)
        };
        Ok((0..found.columns.len()).map(moved).collect())
    }

    fn nudged(&self) -> Parameters {
        let nudge = |(name, value): &(String, f64)| {
            let is_start = ["th_0", "t_0", "w", "w1", "w2", "w3"].contains(&name.as_str());
            (name.clone(), if is_start { value * (1.0 + NUDGE) } else { *value })
        };
        self.parameters.iter().map(nudge).collect()
    }

    fn nudged_task(&self, task: &Task) -> Task {
        match task {
            Task::Sweep([from, to, speed], rows) => {
                Task::Sweep([from * (1.0 + NUDGE), to * (1.0 + NUDGE), speed * (1.0 + NUDGE)], *rows)
            }
            run => run.clone(),
        }
    }

    /// What the bound of each column is a part of: its range, and at least a hundredth of its natural size, which tolerances
    /// and rounding are a part of even where a column is zero throughout. In sweeps that size itself: beside crossings rounding
    /// is amplified.
    fn ranges(&self, found: &Found) -> Vec<f64> {
        let part = if matches!(self.task, Task::Sweep(..)) { 1.0 } else { 1e-2 };
        let range = |(name, column): (&String, &Vec<f64>)| Range::of(name, self.scales, column).size(part);
        found.names.iter().zip(&found.columns).map(range).collect()
    }

    fn worst(&self, found: &Found, reference: &mut Reference) -> Result<Option<(f64, String)>, String> {
        self.beyond(found, reference, self.task.bound(), 100.0)
    }

    /// Equal steps by partitioning within their bound may still be far worse than they need be: their error is held to a
    /// hundred times that of the same steps by projection, or of what references are confirmed to.
    fn beside_projection(&self, found: &Found, reference: &mut Reference) -> Verdict {
        let Task::Run(settings @ Settings { stepping: Stepping::Equal(_), .. }) = &self.task else {
            return Verdict::Right;
        };
        if settings.stabilisation != Stabilisation::Partitioning || GO_FLAT.contains(&self.linkage.name) {
            return Verdict::Right;
        }
        let another = Task::Run(Settings { stabilisation: Stabilisation::Projection, ..*settings });
        let Ok(projected) = self.result(self.linkage.forms[self.form], &self.parameters, &another) else {
            return Verdict::Right;
        };
        let error = CONFIRMED * self.off(&projected, reference, CONFIRMED, 0.0).map_or(1.0, |(share, _)| share);
        match self.beyond(found, reference, 100.0 * error, 100.0) {
            Ok(None) => Verdict::Right,
            Ok(Some((_, words))) => {
                Verdict::Wrong(format!("{words}, which is a hundred times the error of projection"))
            }
            Err(why) => Verdict::Undecided(why),
        }
    }

    /// Whether the same method with the same steps or tolerance is about as far off in another form, kept on the constraints
    /// in another way: no verdict, but a hint that the method is at fault and not the form, as Euler's near a dead point.
    fn is_coarse(&self, share: f64, reference: &mut Reference) -> bool {
        let Task::Run(settings) = &self.task else { return false };
        let stabilisation = match settings.stabilisation {
            Stabilisation::Projection => Stabilisation::Partitioning,
            _ => Stabilisation::Projection,
        };
        let another = Task::Run(Settings { stabilisation, ..*settings });
        let form = self.linkage.forms[usize::from(self.form == 0)];
        let found = self.result(form, &self.parameters, &another);
        let worst = found.ok().and_then(|found| self.worst(&found, reference).ok().flatten());
        worst.is_some_and(|(other, _)| other > share / 3.0)
    }

    /// How many times beyond its bound the number is that is furthest beyond, if one is, and which it is. How far the
    /// reference moves is found where the bound alone is not kept.
    fn beyond(
        &self,
        found: &Found,
        reference: &mut Reference,
        bound: f64,
        moves: f64,
    ) -> Result<Option<(f64, String)>, String> {
        let off = self.off(found, reference, bound, moves);
        if off.is_none() || reference.moved.is_some() {
            return Ok(off);
        }
        reference.moved = Some(self.moved(reference)?);
        Ok(self.off(found, reference, bound, moves))
    }

    /// The same with what is known of the reference.
    fn off(&self, found: &Found, reference: &Reference, bound: f64, moves: f64) -> Option<(f64, String)> {
        let mut worst = (1.0, String::new());
        for (i, name) in found.names.iter().enumerate() {
            let Some(k) = reference.found.names.iter().position(|known| known == name) else { continue };
            let room = bound * reference.ranges[k] + moves * reference.moved.as_ref().map_or(0.0, |moved| moved[k]);
            let (values, exact) = (&found.columns[i], &reference.found.columns[k]);
            let stride = if name.starts_with("extreme") { 1 } else { reference.stride };
            for (row, value) in values.iter().enumerate() {
                let Some(right) = exact.get(row * stride) else {
                    return Some((f64::INFINITY, format!("{} rows of {}", values.len(), exact.len() / stride)));
                };
                let share = reference.found.apart(k, *value, *right) / room;
                if !(share <= worst.0) {
                    worst = (share, format!("{name}[{row}] = {value:e} for {right:e}, {share:.1e} times the bound"));
                }
            }
        }
        (!worst.1.is_empty()).then_some(worst)
    }
}

impl Found {
    /// How far two values of a column are apart; angles up to whole turns.
    fn apart(&self, column: usize, a: f64, b: f64) -> f64 {
        match self.names[column].starts_with("angle") {
            true => ((a - b + PI).rem_euclid(TAU) - PI).abs(),
            false => (a - b).abs(),
        }
    }
}
