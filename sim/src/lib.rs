//! What a user depends on: the macro [`mechanism!`] and the runtime, which know nothing of each other, so that both are built
//! side by side.

/// The programs in the documents, compiled and run.
#[cfg(all(doctest, feature = "models", feature = "cli"))]
mod documents {
    #[doc = include_str!("../../TUTORIAL.md")]
    struct Tutorial;
    #[doc = include_str!("../../COMING-FROM.md")]
    struct ComingFrom;
}

#[cfg(feature = "cli")]
pub use sim_command as cli;
pub use sim_output::*;
pub use sim_runtime::*;

#[doc(hidden)]
pub use mechanism_macros::mechanism_at as __mechanism_at;

/// Declares a mechanism: see the language reference, `LANGUAGE.md` at the project's root.
#[macro_export]
macro_rules! mechanism {
    ($($declaration:tt)*) => { $crate::__mechanism_at! { $crate::sim_kernel; $($declaration)* } };
}
