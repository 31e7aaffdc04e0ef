//! Commands for mechanisms of any size: each is compiled once, and those that make many steps once more for most
//! linkages, whose vectors need no allocation.

use crate::InPlace;

/// For most linkages.
pub(super) type Small = InPlace<8>;

/// Calls a function that makes many steps, in the form that is compiled for the mechanism's size.
macro_rules! stepping {
    ($function:path, $model:expr $(, $argument:expr)*) => {{
        let model: std::sync::Arc<dyn $crate::Model> = $model;
        match $crate::Erased::<$crate::cli::sizes::Small>::new(model.clone()) {
            Some(mechanism) => $function(mechanism $(, $argument)*),
            None => $function($crate::Erased::of(model) $(, $argument)*),
        }
    }};
}
pub(super) use stepping;
