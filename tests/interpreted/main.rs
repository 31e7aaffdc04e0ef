//! Declarations that are read at run time give what compiled ones give, to the last bit.

#![allow(missing_docs, clippy::unwrap_used)]

mod against_oracle;
mod columns;
mod frames;
mod link_derivatives;
mod links;
mod loops;
mod mangled;
mod many_rows;
mod parts;
mod robots;
mod rows;
mod trees;

use sim::{At, DeclarationFile, Kernel};
use std::path::Path;
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

/// A spring between a mass and what time moves 1e30 times as fast: the power is its force times the speed of the mass.
#[test]
fn power_beside_what_moves_much_faster() {
    let text = "
        pub Shaken;
        coordinates { y [m]; }
        parameters { m [kg] = 1; k [N/m] = 2; H [m] = 1e30; w [1/s] = 3; }
        let road = H*sin(w*t);
        bodies { mass: mass m at [0, y]; }
        loads { spring k, rest 0 between road and y; }
    ";
    let model = DeclarationFile::of(Path::new("shaken.mech"), text.to_owned()).model(None).unwrap();
    let at = At { time: 0.3, positions: &[0.1], speeds: &[0.7], accelerations: &[0.2], multipliers: &[] };
    let mut power = 0.0;
    model.call(Kernel::Power, at, &mut |_, row| power = row[0]);
    let expected = 2.0 * (1e30 * (0.3f64 * 3.0).sin() - 0.1) * 0.7;
    // A few roundings.
    assert!((power - expected).abs() <= 1e-14 * expected, "{power:e} is not {expected:e}");
}
