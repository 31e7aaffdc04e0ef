//! Random places and values.

use crate::Random;
use sim::{At, Dual, Input, Model, Scalar, Values};

/// A place near the start.
pub(super) struct Place<S = f64> {
    pub(super) time: S,
    pub(super) positions: Vec<S>,
    pub(super) speeds: Vec<S>,
    pub(super) accelerations: Vec<S>,
    pub(super) multipliers: Vec<S>,
}

pub(super) type DualPlace = Place<Dual>;

impl<S: Copy> Place<S> {
    pub(super) fn at(&self) -> At<'_, S> {
        let Place { time, positions, speeds, accelerations, multipliers } = self;
        At { time: *time, positions, speeds, accelerations, multipliers }
    }
}

impl Place {
    pub(super) fn random(model: &dyn Model, random: &mut Random) -> Place {
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
}

impl DualPlace {
    pub(super) fn of(place: Place, random: &mut Random) -> DualPlace {
        let mut duals = |values: Vec<f64>| values.into_iter().map(|value| dual(value, random)).collect::<Vec<Dual>>();
        Place {
            time: duals(vec![place.time])[0],
            positions: duals(place.positions),
            speeds: duals(place.speeds),
            accelerations: duals(place.accelerations),
            multipliers: duals(place.multipliers),
        }
    }
}

fn dual(value: f64, random: &mut Random) -> Dual {
    Dual { value, derivative: random.between(-1.0, 1.0) }
}

/// Other parameters, some inputs held, some constraints released.
pub(super) fn random_values(model: &dyn Model, random: &mut Random) -> Values {
    let mut values = model.values();
    values.parameters.iter_mut().for_each(|value| *value *= random.between(0.9, 1.1));
    for input in &mut values.inputs {
        if random.between(0.0, 1.0) < 0.5 {
            *input = Input::Held(random.between(-3.0, 3.0));
        }
    }
    values.activities.iter_mut().for_each(|value| *value = f64::from(u8::from(random.between(0.0, 1.0) < 0.5)));
    values
}

pub(super) fn dual_values(values: &Values, random: &mut Random) -> Values<Dual> {
    let mut values = values.map(Dual::from_f64);
    values.parameters.iter_mut().for_each(|value| *value = dual(value.value, random));
    values
}
