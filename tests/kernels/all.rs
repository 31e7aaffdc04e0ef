//! The mechanisms that the checks of this folder run over.

use sim::Description;

/// Calls a macro with the types of this folder's mechanisms.
macro_rules! own_mechanisms {
    ($callback:ident) => {
        $callback!(
            crate::mechanisms::Bead,
            crate::mechanisms::Cart,
            crate::mechanisms::Functions,
            crate::mechanisms::Rod,
            crate::mechanisms::Chain,
            crate::mechanisms::Arm,
            crate::mechanisms::Sled,
            crate::mechanisms::Snake,
            crate::mechanisms::Hoist,
            crate::mechanisms::Sprung,
            crate::mechanisms::Switched,
            crate::mechanisms::Actuated,
            crate::mechanisms::Chosen,
            crate::mechanisms::Tilted,
            crate::tabled::Tabled
        )
    };
}
pub(crate) use own_mechanisms;

/// Calls a macro with the types of the shipped mechanisms, then with those of this folder.
macro_rules! all_mechanisms {
    ($callback:ident) => {{
        models::all_models!($callback);
        crate::all::own_mechanisms!($callback);
    }};
}
pub(crate) use all_mechanisms;

/// The shipped mechanisms and those of this folder.
pub(crate) fn descriptions() -> Vec<&'static Description> {
    macro_rules! descriptions {
        ($($model:ty),*) => { [$(const { &<$model as sim::Compiled>::DESCRIPTION }),*] };
    }
    [tests::shipped(), own_mechanisms!(descriptions).to_vec()].concat()
}
