//! What is known of a mechanism when the program is compiled.

use crate::{Description, FixedArray, Input, Mechanism, Scalar};

/// A mechanism that `mechanism!` generates: its sizes are those of its types, and its description is a constant.
///
/// Code that is generic over [`Mechanism`] alone also runs mechanisms whose sizes are known only at run time.
pub trait Compiled<S: Scalar = f64>:
    Mechanism<
        S,
        Q: FixedArray<S>,
        L: FixedArray<S>,
        Z: FixedArray<S>,
        QQ: FixedArray<Self::Q>,
        V: FixedArray<S>,
        VV: FixedArray<Self::V>,
        LQ: FixedArray<Self::Q>,
        LL: FixedArray<Self::L>,
        ZZ: FixedArray<Self::Z>,
        Entries: FixedArray<S>,
        Envelope: FixedArray<S>,
        Parameters: FixedArray<S>,
        Inputs: FixedArray<Input<S>>,
        Outputs: FixedArray<S>,
        OutputRates: FixedArray<S>,
        Events: FixedArray<S>,
        EventValues: FixedArray<S>,
        SwitchingFunctions: FixedArray<S>,
        LoadConditions: FixedArray<S>,
        Activities: FixedArray<S>,
        Drawing: FixedArray<S>,
        QP: FixedArray<Self::Parameters>,
        LP: FixedArray<Self::Parameters>,
        Prepared: Copy + Send + Sync,
    > + Copy
    + Send
    + Sync
    + 'static
{
    /// Names, units, documentation.
    const DESCRIPTION: Description;

    /// The mechanism with its declared defaults.
    fn defaults() -> Self;
}
