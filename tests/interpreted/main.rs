//! Declarations that are read at run time give what compiled ones give, to the last bit.

#![allow(missing_docs, clippy::unwrap_used)]

mod against_oracle;
mod mangled;

use tests::same_bits::{compiled, differences, interpreted};

/// Where kernels are called; `figures -- files bits` takes a thousand places.
const STATES: usize = 25;

#[test]
fn every_kernel_has_the_same_bits() {
    for (seed, compiled) in compiled().into_iter().enumerate() {
        let interpreted = interpreted(&*compiled).unwrap();
        assert_eq!(differences(&*compiled, &*interpreted, STATES, seed as u64), Vec::<String>::new());
    }
}

/// What is told of a mechanism is the same, word by word.
#[test]
fn descriptions_are_the_same() {
    for compiled in compiled() {
        let interpreted = interpreted(&*compiled).unwrap();
        assert_eq!(format!("{:#?}", interpreted.description()), format!("{:#?}", compiled.description()));
    }
}

/// Two mechanisms that differ in one number differ in their kernels.
#[test]
fn a_difference_is_found() {
    let model = compiled().into_iter().find(|model| model.description().name == "quick-return").unwrap();
    let mut values = model.values();
    values.parameters[0] = values.parameters[0].next_up();
    let found = differences(&*model, &*model.with_values(&values), 1, 0);
    assert_eq!(found, ["quick-return: values"]);
    let other = compiled().into_iter().find(|model| model.description().name == "quick-return-ratio").unwrap();
    assert!(differences(&*model, &*other, 1, 0).contains(&"quick-return: dynamics".to_owned()));
}
