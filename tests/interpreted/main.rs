//! Declarations that are read at run time give what compiled ones give, to the last bit.

#![allow(missing_docs, clippy::unwrap_used)]

mod bits;

use sim::{Model, erase, interpret};
use std::sync::Arc;

macro_rules! erased {
    ($($model:ty),*) => { vec![$(erase(<$model as sim::Compiled>::defaults())),*] };
}

/// Every shipped mechanism, compiled and interpreted.
fn both() -> Vec<[Arc<dyn Model>; 2]> {
    let compiled: Vec<Arc<dyn Model>> = models::all_models!(erased);
    compiled.into_iter().map(|model| [model.clone(), again(&*model)]).collect()
}

/// The same mechanism, from the text of its declaration.
fn again(model: &dyn Model) -> Arc<dyn Model> {
    let tokens = model.description().declaration.parse().unwrap();
    interpret(&codegen::derive(tokens).unwrap())
}
