//! Values that are results, computed where results stand.

use super::instruction::{Instruction, LookUp, Wave};
use super::parts::{Parts, Place};
use rustc_hash::FxHashMap;

/// The program without the copies of locals to results: each such local is its first result. Values have one place from their
/// computation on, so nothing else changes.
pub(super) fn in_place(parts: Parts) -> Parts {
    let mut results: FxHashMap<Place, Place> = FxHashMap::default();
    let mut instructions = parts.instructions;
    instructions.retain(|instruction| match *instruction {
        Instruction::Copy { to: to @ Place::Result(_), a: a @ Place::Local(_) } if !results.contains_key(&a) => {
            results.insert(a, to);
            false
        }
        _ => true,
    });
    let place = |place: Place| results.get(&place).copied().unwrap_or(place);
    let wave = |Wave { angle, sin, cos }: Wave<Place>| Wave { angle: place(angle), sin: place(sin), cos: place(cos) };
    let look_up = |LookUp { table, to, count }: LookUp<Place>| LookUp { table, to: to.map(place), count };
    Parts {
        instructions: instructions.into_iter().map(|each| each.map(&mut |at, _| place(at))).collect(),
        waves: parts.waves.into_iter().map(|waves| waves.into_iter().map(wave).collect()).collect(),
        look_ups: parts.look_ups.into_iter().map(look_up).collect(),
    }
}
