//! What each shipped model gives is what it was, to the last bit: `results.txt` has a line for its default run, for one with equal
//! steps, and for an implicit one that keeps the constraints in another way. A commit that changes one says why. `cargo results`
//! accepts all changes.

use models::CartPole;
use sim::{
    Compiled, Controller, Erased, InPlace, Input, Mechanism, Method, Model, Run, Sample, Settings, Stabilisation,
    Table, declared_start, run_controlled,
};
use std::fs;
use std::path::PathBuf;
use std::sync::Arc;
use tests::digest::Fnv;
use tests::run_with;
use tests::same_bits;

/// What a run gave.
#[derive(Clone, Debug, PartialEq)]
struct Fingerprint {
    /// Its model and settings.
    run: String,
    /// Of every number and name in its table.
    hash: u64,
    rows: usize,
    /// Accepted steps and right-hand sides.
    steps: u64,
    evaluations: u64,
    /// The last row, so that a change of it can be told.
    last: Vec<f64>,
}

impl Fingerprint {
    fn of<M: Mechanism>(run: &str, found: &Run<M>) -> Fingerprint {
        let table = Table::of(&found.mechanism, &found.trajectory);
        let mut hash = Fnv::new();
        for column in &table.columns {
            hash.add(column.header().as_bytes());
            column.values.iter().for_each(|value| hash.add(&value.to_le_bytes()));
        }
        Fingerprint {
            run: format!("{}:{run}", found.mechanism.description().name),
            hash: hash.digest(),
            rows: found.trajectory.samples.len(),
            steps: found.steps.accepted,
            evaluations: found.evaluations,
            last: table.columns.iter().filter_map(|column| column.values.last().copied()).collect(),
        }
    }

    fn line(&self) -> String {
        let last: Vec<String> = self.last.iter().map(|value| format!("{value:e}")).collect();
        let Fingerprint { run, hash, rows, steps, evaluations, .. } = self;
        format!("{run} {hash:016x} rows {rows} steps {steps} evaluations {evaluations} last {}\n", last.join(" "))
    }

    fn parsed(line: &str) -> Fingerprint {
        let words: Vec<&str> = line.split(' ').collect();
        let number = |place: usize| words[place].parse::<u64>().unwrap();
        Fingerprint {
            run: words[0].to_owned(),
            hash: u64::from_str_radix(words[1], 16).unwrap(),
            rows: number(3) as usize,
            steps: number(5),
            evaluations: number(7),
            last: words[9..].iter().map(|word| word.parse().unwrap()).collect(),
        }
    }

    /// How it differs from another, if it does.
    fn difference(&self, before: &Fingerprint) -> Option<String> {
        let relative = |(new, old): (&f64, &f64)| (new - old).abs() / old.abs().max(f64::MIN_POSITIVE);
        let largest = self.last.iter().zip(&before.last).map(relative).fold(0.0, f64::max);
        let counts = |print: &Fingerprint| [print.rows as u64, print.steps, print.evaluations];
        (self != before).then(|| {
            let [new, old] = [self, before].map(counts);
            format!(
                "{}: rows, steps, evaluations {old:?} are {new:?}, the last row changes by {largest:.1e}\n",
                self.run
            )
        })
    }
}

fn of_mechanism<M: Mechanism>(mechanism: &M) -> [Fingerprint; 3] {
    let implicit =
        Settings { stabilisation: Stabilisation::Partitioning, ..Settings::adaptive(Method::Radau5, 0.5, 1e-6) };
    let of = |run: &str, settings: &Settings| Fingerprint::of(run, &run_with(mechanism.clone(), settings).unwrap());
    [
        of("default", &Settings::new(2.0)),
        of("equal-steps", &Settings::equal_steps(Method::Rk4, 2.0, 500)),
        of("implicit", &implicit),
    ]
}

fn of_model<M: Compiled>() -> [Fingerprint; 3] {
    of_mechanism(&M::defaults())
}

/// The same by the loops of a mechanism whose sizes are known at run time.
fn of_erased(model: Arc<dyn Model>) -> [Fingerprint; 3] {
    let short = Erased::<InPlace<8>>::new(model.clone()).map(|mechanism| of_mechanism(&mechanism));
    short.unwrap_or_else(|| of_mechanism(&Erased::of(model)))
}

/// A cart and pole whose controller is asked every 0.03 s.
fn controlled(run: &str, settings: &Settings) -> Fingerprint {
    let model = CartPole::default();
    let law = |sample: &Sample<CartPole>| [Input::Held(-2.0 * sample.state.positions[0] - sample.state.speeds[0])];
    let mut controller = Controller::new(0.03, law).unwrap();
    Fingerprint::of(run, &run_controlled(model, &declared_start(&model), settings, &mut controller).unwrap())
}

macro_rules! of_models {
    ($($model:ty),*) => { [$(of_model::<$model>()),*].concat() };
}

/// By the loops that are compiled for a mechanism: of all with the feature `loops`, of a sample without it, for each costs the compiler
/// two seconds.
#[cfg(feature = "loops")]
fn compiled() -> Vec<Fingerprint> {
    models::all_models!(of_models)
}
#[cfg(not(feature = "loops"))]
fn compiled() -> Vec<Fingerprint> {
    use models::{BouncingBall, CamFollower, FourBar, QuickReturn, Skate, Stewart, TumblingQuaternion};
    of_models!(BouncingBall, CamFollower, FourBar, QuickReturn, Skate, Stewart, TumblingQuaternion)
}

/// By the loops for any model.
fn fingerprints() -> Vec<Fingerprint> {
    let mut found: Vec<Fingerprint> = models::erased().flat_map(|(_, model)| of_erased(model())).collect();
    found.push(controlled("controlled", &Settings::new(2.0)));
    found.push(controlled("controlled-in-equal-steps", &Settings::equal_steps(Method::Rk4, 2.0, 500)));
    found
}

fn file() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/results/results.txt"))
}

fn accepted() -> Vec<Fingerprint> {
    fs::read_to_string(file()).unwrap().lines().map(Fingerprint::parsed).collect()
}

#[test]
fn shipped_models_give_the_same_bits() {
    let (before, now) = (accepted(), fingerprints());
    let names = |prints: &[Fingerprint]| prints.iter().map(|print| print.run.clone()).collect::<Vec<_>>();
    assert_eq!(names(&now), names(&before));
    let differences: String = now.iter().zip(&before).filter_map(|(now, before)| now.difference(before)).collect();
    assert!(differences.is_empty(), "{differences}`cargo results` accepts the changes");
}

#[test]
fn loops_compiled_for_a_mechanism_give_the_same_bits() {
    let (before, now) = (accepted(), compiled());
    let same = |now: &Fingerprint| before.iter().find(|before| before.run == now.run).unwrap();
    let differences: String = now.iter().filter_map(|now| now.difference(same(now))).collect();
    assert_eq!(differences, "");
}

/// How the results of one in so many models differ where these are interpreted.
fn differences_of_interpreted(every: usize) -> String {
    let (before, models) = (accepted(), models::erased().map(|(_, model)| model()));
    let differences = |(model, before): (Arc<dyn Model>, &[Fingerprint])| {
        let now = of_erased(same_bits::interpreted(&*model).unwrap());
        now.iter().zip(before).filter_map(|(now, before)| now.difference(before)).collect::<String>()
    };
    models.zip(before.chunks(3)).step_by(every).map(differences).collect()
}

#[test]
fn every_seventh_model_has_the_same_bits_interpreted() {
    assert_eq!(differences_of_interpreted(7), "");
}

#[test]
#[ignore = "takes long in a debug build; `.ci/full` runs it"]
fn every_model_has_the_same_bits_interpreted() {
    assert_eq!(differences_of_interpreted(1), "");
}

/// Takes what is computed now as right.
#[test]
#[ignore = "writes what the other test compares with"]
fn accept() {
    let now: Vec<Fingerprint> = fingerprints();
    fs::write(file(), now.iter().map(Fingerprint::line).collect::<String>()).unwrap();
}
