//! The state of a simulation as bytes, and back.
//!
//! Each part describes its contents once, for writing and for reading, so the two cannot get out of order.

use crate::state::failure::constraint_name;
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Input, Mechanism};

/// The bytes end early, or were never saved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Damaged;

/// Bytes that are being written, or read.
pub(crate) enum Bytes<'b> {
    /// The bytes written so far.
    Written(Vec<u8>),
    /// The bytes left to read.
    Read(&'b [u8]),
}

impl Bytes<'_> {
    /// A whole number.
    pub(crate) fn word(&mut self, word: &mut u64) -> Result<(), Damaged> {
        match self {
            Bytes::Written(bytes) => bytes.extend(word.to_le_bytes()),
            Bytes::Read(bytes) => {
                let (first, rest) = bytes.split_first_chunk().ok_or(Damaged)?;
                (*word, *bytes) = (u64::from_le_bytes(*first), rest);
            }
        }
        Ok(())
    }

    pub(crate) fn number(&mut self, number: &mut f64) -> Result<(), Damaged> {
        let mut bits = number.to_bits();
        self.word(&mut bits)?;
        *number = f64::from_bits(bits);
        Ok(())
    }

    pub(crate) fn numbers(&mut self, numbers: &mut [f64]) -> Result<(), Damaged> {
        numbers.iter_mut().try_for_each(|number| self.number(number))
    }

    /// A number below a limit, such as an index.
    pub(crate) fn index(&mut self, index: &mut usize, limit: usize) -> Result<(), Damaged> {
        let mut word = *index as u64;
        self.word(&mut word)?;
        *index = usize::try_from(word).ok().filter(|index| *index < limit).ok_or(Damaged)?;
        Ok(())
    }

    /// A count, far enough below the limits of its type to grow.
    pub(crate) fn count(&mut self, count: &mut usize) -> Result<(), Damaged> {
        self.index(count, 1 << 48)
    }

    /// The same for larger counts.
    pub(crate) fn tally(&mut self, count: &mut u64) -> Result<(), Damaged> {
        self.word(count)?;
        if *count < 1 << 48 { Ok(()) } else { Err(Damaged) }
    }

    /// A duration, in seconds.
    pub(crate) fn duration(&mut self, duration: &mut f64) -> Result<(), Damaged> {
        self.number(duration)?;
        if *duration >= 0.0 && duration.is_finite() { Ok(()) } else { Err(Damaged) }
    }

    pub(crate) fn flag(&mut self, flag: &mut bool) -> Result<(), Damaged> {
        let mut word = usize::from(*flag);
        self.index(&mut word, 2)?;
        *flag = word == 1;
        Ok(())
    }

    /// An optional value; `blank` is filled if it is present.
    pub(crate) fn option<T>(
        &mut self,
        value: &mut Option<T>,
        blank: impl FnOnce() -> T,
        transfer: impl FnOnce(&mut Self, &mut T) -> Result<(), Damaged>,
    ) -> Result<(), Damaged> {
        let mut is_some = value.is_some();
        self.flag(&mut is_some)?;
        if let Bytes::Read(_) = self {
            *value = None;
        }
        match is_some {
            true => transfer(self, value.get_or_insert_with(blank)),
            false => {
                *value = None;
                Ok(())
            }
        }
    }

    /// A list; each entry is a `blank` that is filled.
    pub(crate) fn list<T>(
        &mut self,
        list: &mut Vec<T>,
        blank: impl Fn() -> T,
        mut transfer: impl FnMut(&mut Self, &mut T) -> Result<(), Damaged>,
    ) -> Result<(), Damaged> {
        let mut count = list.len();
        self.count(&mut count)?;
        if let Bytes::Read(_) = self {
            list.clear();
        }
        for k in 0..count {
            if k == list.len() {
                list.push(blank());
            }
            transfer(self, &mut list[k])?;
        }
        Ok(())
    }

    pub(crate) fn text(&mut self, text: &mut String) -> Result<(), Damaged> {
        let mut letters = std::mem::take(text).into_bytes();
        self.list(
            &mut letters,
            || 0,
            |bytes, letter| {
                let mut code = usize::from(*letter);
                bytes.index(&mut code, 256)?;
                *letter = code as u8;
                Ok(())
            },
        )?;
        *text = String::from_utf8(letters).map_err(|_| Damaged)?;
        Ok(())
    }

    /// The name of a constraint.
    pub(crate) fn constraint<M: Mechanism>(&mut self, mechanism: &M, name: &mut &'static str) -> Result<(), Damaged> {
        let mut row = (0..mechanism.m()).find(|row| constraint_name(mechanism, *row) == *name).unwrap_or(0);
        self.index(&mut row, mechanism.m())?;
        *name = constraint_name(mechanism, row);
        Ok(())
    }

    pub(crate) fn state<M: Mechanism>(&mut self, state: &mut State<M>) -> Result<(), Damaged> {
        self.number(&mut state.time)?;
        self.numbers(state.positions.as_mut())?;
        self.numbers(state.speeds.as_mut())?;
        self.number(&mut state.work)
    }

    pub(crate) fn sample<M: Mechanism>(&mut self, sample: &mut Sample<M>) -> Result<(), Damaged> {
        self.state(&mut sample.state)?;
        self.numbers(sample.accelerations.as_mut())?;
        self.numbers(sample.multipliers.as_mut())?;
        self.number(&mut sample.power)?;
        self.inputs(sample.inputs.as_mut())
    }

    fn inputs(&mut self, inputs: &mut [Input]) -> Result<(), Damaged> {
        for input in inputs {
            let mut held = input.held();
            self.option(&mut held, || 0.0, Bytes::number)?;
            *input = held.map_or(Input::Declared, Input::Held);
        }
        Ok(())
    }

    /// A mechanism by its parameters, inputs and activities.
    pub(crate) fn mechanism<M: Mechanism>(&mut self, mechanism: &mut M) -> Result<(), Damaged> {
        let (mut parameters, mut inputs) = (mechanism.parameters(), mechanism.inputs());
        let mut activities = mechanism.activities();
        self.numbers(parameters.as_mut())?;
        self.inputs(inputs.as_mut())?;
        self.numbers(activities.as_mut())?;
        *mechanism = mechanism.with_parameters(parameters).with_inputs(inputs).with_activities(activities);
        Ok(())
    }
}

/// A sample to be filled.
pub(crate) fn blank_sample<M: Mechanism>(mechanism: &M, state: &State<M>) -> Sample<M> {
    Sample {
        state: state.clone(),
        accelerations: M::Q::repeat(mechanism.n(), 0.0),
        multipliers: M::L::repeat(mechanism.m(), 0.0),
        power: 0.0,
        inputs: mechanism.inputs().like(|_| Input::Declared),
    }
}
