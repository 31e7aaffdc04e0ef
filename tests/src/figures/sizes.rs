//! Sizes known at run time: every shipped model through the loops compiled for it and through those of any model.

use super::Table;
use sim::{Compiled, Erased, InPlace, Mechanism, Model, Run, Settings, declared_start};
use std::sync::Arc;
use std::time::Duration;

/// Runs of each, of which the shortest counts: so many, and more while they take less time than this in all.
const TIMES: usize = 7;
const LEAST_TIME: Duration = Duration::from_millis(50);

/// What two runs of a model have in common.
struct Compared {
    name: &'static str,
    is_same: bool,
    /// The time of the erased model relative to that of the compiled one.
    ratio: f64,
}

pub(super) fn sizes_at_run_time(table: &mut Table) {
    table.heading("Sizes at run time");
    macro_rules! compared {
        ($($model:ty),*) => { [$(compare(<$model>::default())),*] };
    }
    let found: Vec<Option<Compared>> = models::all_models!(compared).into();
    let failed = found.iter().filter(|found| found.is_none()).count();
    let mut found: Vec<Compared> = found.into_iter().flatten().collect();
    found.iter().for_each(|of| println!("  {:<28} {:.2}", of.name, of.ratio));
    table.at_most("models that do not run", failed as f64, 0.0);
    table.at_most("models with other bits", found.iter().filter(|of| !of.is_same).count() as f64, 0.0);
    found.sort_by(|a, b| a.ratio.total_cmp(&b.ratio));
    if let (Some(middle), Some(last)) = (found.get(found.len() / 2), found.last()) {
        let what = format!("time beside the compiled loops; median {:.2}, worst", middle.ratio);
        table.at_most(&what, last.ratio, 1.3);
    }
}

fn compare<M: Compiled>(mechanism: M) -> Option<Compared> {
    let (one, first) = shortest(&mechanism)?;
    let (other, second) = shortest_erased(sim::erase(mechanism))?;
    let ratio = second.as_secs_f64() / first.as_secs_f64();
    Some(Compared { name: M::DESCRIPTION.name, is_same: one == other, ratio })
}

fn shortest_erased(model: Arc<dyn Model>) -> Option<(Vec<u64>, Duration)> {
    match Erased::<InPlace<8>>::new(model.clone()) {
        Some(mechanism) => shortest(&mechanism),
        None => shortest(&Erased::of(model)),
    }
}

/// The bits of every sample, and the shortest time.
fn shortest<M: Mechanism>(mechanism: &M) -> Option<(Vec<u64>, Duration)> {
    let start = declared_start(mechanism);
    let mut best: Option<(Run<M>, Duration)> = None;
    let (mut times, mut taken) = (0, Duration::ZERO);
    while times < TIMES || taken < LEAST_TIME {
        let run = sim::run(mechanism.clone(), &start, &Settings::new(2.0)).ok()?;
        let time = run.integration_time;
        (times, taken) = (times + 1, taken + time);
        if best.as_ref().is_none_or(|(_, shortest)| time < *shortest) {
            best = Some((run, time));
        }
    }
    let (run, time) = best?;
    let of = |sample: &sim::Sample<M>| {
        let parts = [sample.state.positions.as_ref(), sample.state.speeds.as_ref(), sample.accelerations.as_ref()];
        let numbers =
            [parts.concat(), sample.multipliers.as_ref().to_vec(), vec![sample.state.time, sample.state.work]];
        numbers.concat().into_iter().map(f64::to_bits).collect::<Vec<u64>>()
    };
    Some((run.trajectory.samples.iter().flat_map(of).collect(), time))
}
