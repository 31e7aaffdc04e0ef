//! Numbers of several motions side by side, one lane each.

use super::LANES;
use crate::motion::measures::Measures;
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Input, Lanes, Mechanism, Scalar};

/// Numbers in all lanes.
pub(super) type Numbers = Lanes<LANES>;
/// A mechanism with a separate motion in each lane.
pub(super) type InLanes<M> = <M as Mechanism>::On<Numbers>;

/// Arrays side by side.
pub(super) fn gather<'a, A: Array<f64>, B: Array<Numbers>>(of: impl Fn(usize) -> &'a A) -> B {
    B::with_len(of(0).len(), |i| Lanes::from_fn(|lane| of(lane)[i]))
}

/// One lane of an array.
#[inline(always)]
pub(super) fn lane_of<A: Array<f64>, B: Array<Numbers>>(array: &B, lane: usize) -> A {
    A::with_len(array.len(), |i| array[i].lane(lane))
}

/// Mechanisms of one type side by side, with a separate value of each parameter; `None` where an input follows its
/// declared course in one and is held in another.
pub(super) fn mechanism<M: Mechanism>(mechanisms: [&M; LANES]) -> Option<InLanes<M>> {
    let mut inputs = mechanisms[0].on(Numbers::from_f64).inputs();
    for (i, input) in inputs.as_mut().iter_mut().enumerate() {
        let each: [Input; LANES] = std::array::from_fn(|lane| mechanisms[lane].inputs()[i]);
        *input = match each.map(Input::held) {
            held if held.iter().all(Option::is_none) => Input::Declared,
            held if held.iter().all(Option::is_some) => {
                Input::Held(Lanes::from_fn(|lane| held[lane].unwrap_or(f64::NAN)))
            }
            _ => return None,
        };
    }
    let (parameters, activities) = (mechanisms.map(M::parameters), mechanisms.map(M::activities));
    let lanes = mechanisms[0].on(Numbers::from_f64).with_parameters(gather(|lane| &parameters[lane]));
    Some(lanes.with_inputs(inputs).with_activities(gather(|lane| &activities[lane])))
}

/// Scales side by side; `None` unless constraints are independent in all.
pub(super) fn measures<M: Mechanism>(each: [&Measures<M>; LANES]) -> Option<Measures<InLanes<M>, Numbers>> {
    let is_plain = |one: &&Measures<M>| !one.is_redundant() && one.rank() == each[0].rank();
    let coordinate = |j: usize| Lanes::from_fn(|lane| each[lane].coordinates()[j]);
    let constraint = |i: usize| Lanes::from_fn(|lane| each[lane].constraints()[i]);
    each.iter().all(is_plain).then(|| each[0].on(coordinate, constraint))
}

/// Samples side by side, with the inputs of the mechanism in lanes.
pub(super) fn sample<M: Mechanism>(mechanism: &InLanes<M>, samples: &[Sample<M>]) -> Sample<InLanes<M>, Numbers> {
    let number = |entry: &dyn Fn(&Sample<M>) -> f64| Lanes::from_fn(|lane| entry(&samples[lane]));
    Sample {
        state: State {
            time: number(&|sample| sample.state.time),
            positions: gather(|lane| &samples[lane].state.positions),
            speeds: gather(|lane| &samples[lane].state.speeds),
            work: number(&|sample| sample.state.work),
        },
        accelerations: gather(|lane| &samples[lane].accelerations),
        multipliers: gather(|lane| &samples[lane].multipliers),
        power: number(&|sample| sample.power),
        inputs: mechanism.inputs(),
    }
}

/// One lane of a sample, with these inputs.
pub(super) fn sample_of<M: Mechanism>(
    sample: &Sample<InLanes<M>, Numbers>,
    lane: usize,
    inputs: M::Inputs,
) -> Sample<M> {
    Sample {
        state: State {
            time: sample.state.time.lane(lane),
            positions: lane_of(&sample.state.positions, lane),
            speeds: lane_of(&sample.state.speeds, lane),
            work: sample.state.work.lane(lane),
        },
        accelerations: lane_of(&sample.accelerations, lane),
        multipliers: lane_of(&sample.multipliers, lane),
        power: sample.power.lane(lane),
        inputs,
    }
}
