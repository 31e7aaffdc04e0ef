//! Commands for mechanisms of any size: each command is compiled for a few storages, whatever the mechanisms.

use crate::cli::Stop;
use crate::{InPlace, OnHeap};
use sim_kernel::Description;

/// For most linkages.
pub(super) type Small = InPlace<8>;
/// For robots and machines.
pub(super) type Medium = OnHeap<64>;
/// For long chains and grids.
pub(super) type Large = OnHeap<4096>;

/// The stack for large vectors, which lie there by the dozen; it takes memory only as far as it is used.
const DEEP: usize = 1 << 30;

/// Calls a function that makes many steps, in the form that is compiled for the mechanism's size.
macro_rules! stepping {
    ($function:path, $model:expr $(, $argument:expr)*) => {{
        let model: std::sync::Arc<dyn $crate::Model> = $model;
        match $crate::Erased::<$crate::cli::sizes::Small>::new(model.clone()) {
            Some(mechanism) => $function(mechanism $(, $argument)*),
            None => $crate::cli::sizes::by_size!($function, model $(, $argument)*),
        }
    }};
}
pub(super) use stepping;

/// Calls a function that needs less time than it would take to compile it for small mechanisms too.
macro_rules! by_size {
    ($function:path, $model:expr $(, $argument:expr)*) => {{
        let model: std::sync::Arc<dyn $crate::Model> = $model;
        if let Some(mechanism) = $crate::Erased::<$crate::cli::sizes::Medium>::new(model.clone()) {
            $function(mechanism $(, $argument)*)
        } else if let Some(mechanism) = $crate::Erased::<$crate::cli::sizes::Large>::new(model.clone()) {
            $crate::cli::sizes::deep(|| $function(mechanism $(, $argument)*))
        } else {
            Err($crate::cli::sizes::too_large(model.description()))
        }
    }};
}
pub(super) use by_size;

/// Works on a stack that has room for large vectors.
pub(super) fn deep<T: Send>(work: impl FnOnce() -> Result<T, Stop> + Send) -> Result<T, Stop> {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(DEEP).spawn_scoped(scope, work)?;
        thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}

/// The refusal of a mechanism that no command is compiled for.
pub(super) fn too_large(description: &Description) -> Stop {
    let most = <Large as crate::Storage>::MOST;
    Stop::Failed(anyhow::anyhow!(
        "{} has {} coordinates and {} constraint rows; commands work on at most {most} of each. `sim::run` and the other \
         functions of the library have no limit",
        description.name,
        description.coordinates.len(),
        description.constraints.len()
    ))
}
