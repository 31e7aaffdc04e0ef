//! Every kernel of every shipped mechanism: at random states, with random values, on numbers and on dual numbers.

use crate::both;
use sim::{At, Dual, Input, Kernel, Model, Scalar, Values};
use tests::Random;

/// Where kernels are called; optimised builds take all that the figure asks for.
const STATES: usize = if cfg!(debug_assertions) { 25 } else { 1000 };

/// A place near the start, as numbers.
struct Place {
    time: f64,
    positions: Vec<f64>,
    speeds: Vec<f64>,
    accelerations: Vec<f64>,
    multipliers: Vec<f64>,
}

impl Place {
    fn random(model: &dyn Model, random: &mut Random) -> Place {
        let [start, _] = model.initial();
        let (n, m) = (start.len(), model.description().constraints.len());
        let mut some = |count: usize, size: f64| (0..count).map(|_| random.between(-size, size)).collect::<Vec<f64>>();
        let by = some(n, 0.7);
        Place {
            positions: start.iter().zip(by).map(|(start, by)| start + by).collect(),
            speeds: some(n, 5.0),
            accelerations: some(n, 50.0),
            multipliers: some(m, 200.0),
            time: some(1, 3.0)[0],
        }
    }

    fn at(&self) -> At<'_, f64> {
        let Place { time, positions, speeds, accelerations, multipliers } = self;
        At { time: *time, positions, speeds, accelerations, multipliers }
    }
}

/// The rows of a result, and whether a pivot was refused.
#[derive(Debug, PartialEq)]
struct Answer {
    rows: Vec<(usize, Vec<u64>)>,
    refused: bool,
}

/// Any NaN is equal to any other.
fn bits(value: f64) -> u64 {
    if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() }
}

fn answer(model: &dyn Model, kernel: Kernel, at: At<f64>) -> Answer {
    let mut rows = Vec::new();
    let refused = model.call(kernel, at, &mut |row, numbers| {
        rows.push((row, numbers.iter().map(|number| bits(*number)).collect()));
    });
    Answer { rows, refused }
}

fn answer_on_duals(model: &dyn Model, values: &Values<Dual>, kernel: Kernel, at: At<Dual>) -> Answer {
    let mut rows = Vec::new();
    let refused = model.call_on_duals(values, kernel, at, &mut |row, numbers| {
        let both = numbers.iter().flat_map(|number| [number.value, number.derivative]);
        rows.push((row, both.map(bits).collect()));
    });
    Answer { rows, refused }
}

/// Other parameters, some inputs held, some constraints released.
fn random_values(model: &dyn Model, random: &mut Random) -> Values {
    let Values { parameters, inputs, activities } = model.values();
    let mut is_likely = || random.between(0.0, 1.0) < 0.5;
    let held: Vec<bool> = inputs.iter().map(|_| is_likely()).collect();
    let switched: Vec<bool> = activities.iter().map(|_| is_likely()).collect();
    Values {
        parameters: parameters.into_iter().map(|value| value * random.between(0.9, 1.1)).collect(),
        inputs: held
            .into_iter()
            .map(|held| if held { Input::Held(random.between(-3.0, 3.0)) } else { Input::Declared })
            .collect(),
        activities: switched.into_iter().map(|on| f64::from(u8::from(on))).collect(),
    }
}

fn dual(value: f64, random: &mut Random) -> Dual {
    Dual { value, derivative: random.between(-1.0, 1.0) }
}

#[test]
fn every_kernel_has_the_same_bits() {
    for (at, [compiled, interpreted]) in both().into_iter().enumerate() {
        let random = &mut Random(at as u64);
        assert_eq!(interpreted.values(), compiled.values());
        for _ in 0..STATES {
            let values = random_values(&*compiled, random);
            let (compiled, interpreted) = (compiled.with_values(&values), interpreted.with_values(&values));
            let place = Place::random(&*compiled, random);
            assert_eq!(interpreted.initial(), compiled.initial());
            let held = |model: &dyn Model| model.held_inputs(place.time, &place.positions);
            assert_eq!(held(&*interpreted), held(&*compiled));
            for kernel in Kernel::ALL {
                let of = |model: &dyn Model| answer(model, *kernel, place.at());
                let name = compiled.description().name;
                assert_eq!(of(&*interpreted), of(&*compiled), "{name}: {}", kernel.name());
            }
        }
    }
}

#[test]
fn prepared_kernels_have_the_same_bits() {
    for (at, [compiled, interpreted]) in both().into_iter().enumerate() {
        let random = &mut Random(at as u64);
        for _ in 0..STATES {
            let (values, inputs) = (random_values(&*compiled, random), random_values(&*compiled, random).inputs);
            let place = Place::random(&*compiled, random);
            let of = |model: &dyn Model, kernel: Kernel| {
                let mut prepared = model.with_values(&values).prepare();
                prepared.set_inputs(&inputs);
                let (mut rows, copy) = (Vec::new(), prepared.copied());
                let refused = copy.call(kernel, place.at(), &mut |row, numbers| {
                    rows.push((row, numbers.iter().map(|number| bits(*number)).collect()));
                });
                Answer { rows, refused }
            };
            for kernel in [Kernel::Dynamics, Kernel::Velocities] {
                let name = compiled.description().name;
                assert_eq!(of(&*interpreted, kernel), of(&*compiled, kernel), "{name}: {}", kernel.name());
            }
        }
    }
}

#[test]
fn kernels_on_dual_numbers_have_the_same_bits() {
    // Compiled mechanisms have no others on dual numbers.
    let kernels = [
        Kernel::ConstraintLinearization,
        Kernel::ConstraintMagnitudes,
        Kernel::SparseLinearization,
        Kernel::Dynamics,
        Kernel::Velocities,
        Kernel::VelocityVariables,
        Kernel::Outputs,
        Kernel::OutputRates,
    ];
    for (at, [compiled, interpreted]) in both().into_iter().enumerate() {
        let random = &mut Random(at as u64);
        for _ in 0..STATES {
            let values = random_values(&*compiled, random).map(Dual::from_f64);
            let parameters = values.parameters.iter().map(|value| dual(value.value, random)).collect();
            let values = Values { parameters, ..values };
            let Place { time, positions, speeds, accelerations, multipliers } = Place::random(&*compiled, random);
            let [positions, speeds, accelerations, multipliers] = [positions, speeds, accelerations, multipliers]
                .map(|numbers| numbers.into_iter().map(|value| dual(value, random)).collect::<Vec<Dual>>());
            let at = At {
                time: dual(time, random),
                positions: &positions,
                speeds: &speeds,
                accelerations: &accelerations,
                multipliers: &multipliers,
            };
            for kernel in kernels {
                let of = |model: &dyn Model| answer_on_duals(model, &values, kernel, at);
                let name = compiled.description().name;
                assert_eq!(of(&*interpreted), of(&*compiled), "{name}: {}", kernel.name());
            }
        }
    }
}

/// What is told of a mechanism is the same, word by word.
#[test]
fn descriptions_are_the_same() {
    for [compiled, interpreted] in both() {
        assert_eq!(format!("{:#?}", interpreted.description()), format!("{:#?}", compiled.description()));
    }
}
