//! Commands for mechanisms of any size: each is compiled once, and those that make many steps once more for most
//! linkages, whose vectors need no allocation.

/// Calls a function that makes many steps, in the form that is compiled for the mechanism's size.
macro_rules! stepping {
    ($function:path, $model:expr $(, $argument:expr)*) => {{
        let model: std::sync::Arc<dyn sim_runtime::Model> = $model;
        match sim_runtime::Erased::<sim_runtime::Small>::new(model.clone()) {
            Some(mechanism) => $function(mechanism $(, $argument)*),
            None => $function(sim_runtime::Erased::of(model) $(, $argument)*),
        }
    }};
}
pub(super) use stepping;
