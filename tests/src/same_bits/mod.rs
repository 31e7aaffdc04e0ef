//! A mechanism compiled and the same one interpreted: every kernel at random states, with random values, on numbers, on dual numbers
//! and on many states at once, to the last bit.

mod blocks;
mod draws;

use crate::Random;
use draws::{DualPlace, Place, dual_values, random_values};
use sim::{At, DeclarationFile, Dual, Input, Kernel, LoadError, Model, Values};
use std::path::Path;
use std::sync::Arc;

/// Every shipped mechanism, compiled.
pub fn compiled() -> Vec<Arc<dyn Model>> {
    models::erased().map(|(_, model)| model()).collect()
}

/// The same mechanism, from the text of its declaration.
///
/// # Errors
/// If the text has a mistake.
pub fn interpreted(model: &dyn Model) -> Result<Arc<dyn Model>, LoadError> {
    DeclarationFile::of(Path::new("shipped.mech"), model.description().declaration.to_owned()).model(None)
}

/// The kernels in which both differ at so many states: `quick-return: dynamics`.
pub fn differences(compiled: &dyn Model, interpreted: &dyn Model, states: usize, seed: u64) -> Vec<String> {
    let (random, mut found) = (&mut Random(seed), Vec::new());
    let name = compiled.description().name;
    if interpreted.values() != compiled.values() {
        found.push(format!("{name}: values"));
    }
    for _ in 0..states {
        let values = random_values(compiled, random);
        let both = [compiled.with_values(&values), interpreted.with_values(&values)];
        let place = Place::random(compiled, random);
        let mut compare = |what: &str, of: &dyn Fn(&dyn Model) -> Answer| {
            let [compiled, interpreted] = both.each_ref().map(|model| of(&**model));
            if compiled != interpreted {
                found.push(format!("{name}: {what}"));
            }
        };
        compare("initial", &|model| Answer::of(model.initial().concat().into_iter()));
        compare("held inputs", &|model| {
            Answer::of(model.held_inputs(place.time, &place.positions).into_iter().map(|input| input.or(f64::INFINITY)))
        });
        Kernel::ALL.iter().for_each(|kernel| compare(kernel.name(), &|model| plain(model, *kernel, place.at())));
        let inputs = random_values(compiled, random).inputs;
        for kernel in [Kernel::Dynamics, Kernel::Velocities] {
            compare(kernel.name(), &|model| prepared(model, &inputs, kernel, place.at()));
        }
        let values = dual_values(&values, random);
        let place = DualPlace::of(place, random);
        for kernel in ON_DUALS {
            compare(&format!("{} on dual numbers", kernel.name()), &|model| {
                on_duals(model, &values, kernel, place.at())
            });
        }
    }
    found.extend(blocks::differences(compiled, interpreted, states, random));
    found.sort();
    found.dedup();
    found
}

/// The kernels that compiled mechanisms have on dual numbers.
const ON_DUALS: [Kernel; 8] = [
    Kernel::ConstraintLinearization,
    Kernel::ConstraintMagnitudes,
    Kernel::SparseLinearization,
    Kernel::Dynamics,
    Kernel::Velocities,
    Kernel::VelocityVariables,
    Kernel::Outputs,
    Kernel::OutputRates,
];

/// The rows of a result, and whether a pivot was refused.
#[derive(PartialEq)]
struct Answer {
    rows: Vec<(usize, Vec<u64>)>,
    refused: bool,
}

impl Answer {
    fn of(numbers: impl Iterator<Item = f64>) -> Answer {
        Answer { rows: vec![(0, numbers.map(bits).collect())], refused: false }
    }
}

/// Any NaN is equal to any other.
fn bits(value: f64) -> u64 {
    if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() }
}

fn plain(model: &dyn Model, kernel: Kernel, at: At<f64>) -> Answer {
    let mut rows = Vec::new();
    let refused = model.call(kernel, at, &mut |row, numbers| {
        rows.push((row, numbers.iter().map(|number| bits(*number)).collect()));
    });
    Answer { rows, refused }
}

fn prepared(model: &dyn Model, inputs: &[Input], kernel: Kernel, at: At<f64>) -> Answer {
    let mut prepared = model.prepare();
    prepared.set_inputs(inputs);
    let (mut rows, copy) = (Vec::new(), prepared.copied());
    let refused = copy.call(kernel, at, &mut |row, numbers| {
        rows.push((row, numbers.iter().map(|number| bits(*number)).collect()));
    });
    Answer { rows, refused }
}

fn on_duals(model: &dyn Model, values: &Values<Dual>, kernel: Kernel, at: At<Dual>) -> Answer {
    let mut rows = Vec::new();
    let refused = model.call_on_duals(values, kernel, at, &mut |row, numbers| {
        let both = numbers.iter().flat_map(|number| [number.value, number.derivative]);
        rows.push((row, both.map(bits).collect()));
    });
    Answer { rows, refused }
}
