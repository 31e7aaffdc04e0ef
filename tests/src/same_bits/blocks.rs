//! Kernels at many states, one after the other and at once.

use super::draws::{Place, random_values};
use super::{Answer, bits, plain};
use crate::Random;
use sim::{Kernel, Model, Results, States, Vectors};

/// Two blocks of an interpreted program, and a part of one.
const SOME_BLOCKS: usize = 150;

/// The kernels of which many states at once differ from the compiled kernel at each: no state, one, a part of a block, and as
/// many as are asked for, at least some blocks.
pub(super) fn differences(
    compiled: &dyn Model,
    interpreted: &dyn Model,
    states: usize,
    random: &mut Random,
) -> Vec<String> {
    let mut found = Vec::new();
    for count in [0, 1, 7, states.max(SOME_BLOCKS)] {
        let values = random_values(compiled, random);
        let [compiled, interpreted] = [compiled, interpreted].map(|model| model.with_values(&values));
        let places: Vec<Place> = (0..count).map(|_| Place::random(&*compiled, random)).collect();
        let states = Numbers::of(&places);
        for kernel in Kernel::ALL {
            let alone: Vec<Answer> = places.iter().map(|place| plain(&*compiled, *kernel, place.at())).collect();
            let mut compare = |what: &str, results: &Results| {
                if answers(results, count) != alone {
                    found.push(format!("{}: {} at {count} states, {what}", compiled.description().name, kernel.name()));
                }
            };
            compare("compiled", &compiled.call_each(*kernel, &states.given()));
            for vectors in [Some(Vectors::BASELINE), Vectors::avx2(), Vectors::avx512()].into_iter().flatten() {
                let results = interpreted.call_each_with(vectors, *kernel, &states.given());
                compare(&format!("interpreted with {vectors}"), &results);
            }
        }
    }
    found
}

/// The numbers of many places.
struct Numbers {
    times: Vec<f64>,
    levels: [Vec<f64>; 4],
}

impl Numbers {
    fn of(places: &[Place]) -> Numbers {
        let level = |of: fn(&Place) -> &Vec<f64>| places.iter().flat_map(|place| of(place).clone()).collect();
        Numbers {
            times: places.iter().map(|place| place.time).collect(),
            levels: [
                level(|place| &place.positions),
                level(|place| &place.speeds),
                level(|place| &place.accelerations),
                level(|place| &place.multipliers),
            ],
        }
    }

    fn given(&self) -> States<'_> {
        let [positions, speeds, accelerations, multipliers] = &self.levels;
        States { times: &self.times, positions, speeds, accelerations, multipliers }
    }
}

/// The results at each state.
fn answers(results: &Results, count: usize) -> Vec<Answer> {
    let width: usize = results.rows.iter().sum();
    let answer = |state: usize| {
        let mut numbers = results.numbers[state * width..][..width].iter().map(|number| bits(*number));
        let row = |(row, length): (usize, &usize)| (row, numbers.by_ref().take(*length).collect());
        Answer { rows: results.rows.iter().enumerate().map(row).collect(), refused: results.refused.contains(&state) }
    };
    (0..count).map(answer).collect()
}
