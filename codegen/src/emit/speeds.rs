//! The items of generalised speeds: their struct, and the impl of their trait.

use super::description::quantity;
use super::documentation::documented;
use super::forward::forward;
use super::record::record;
use super::{ident, size};
use crate::dsl::Head;
use crate::dynamics::EquationsOfMotion;
use crate::program::{Kernel, Program};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Whether a kernel is one of the trait of generalised speeds.
pub(super) fn is_of_speeds(kernel: &Kernel) -> bool {
    ["generalized_speeds", "kinematics", "speed_dynamics"].contains(&kernel.name)
}

/// Their items in the runtime's trait; empty if there are none.
pub(super) fn velocity_variables(equations: &EquationsOfMotion, path: &TokenStream) -> Option<TokenStream> {
    let n = size(equations.model.coordinates.len());
    equations.speeds.as_ref().map(|_| {
        quote! {
            const ROWS_LEFT: ::core::option::Option<&'static [::core::primitive::usize]> =
                ::core::option::Option::Some(<Self as #path::GeneralizedSpeeds<S>>::ROWS);

            #[inline(always)]
            fn velocity_variables(&self, t: S, q: &[S; #n], qd: &[S; #n]) -> [S; #n] {
                #path::speeds::velocity_variables(self, t, q, qd)
            }

            #[inline(always)]
            fn prepared_velocities(
                prepared: &Self::Prepared,
                t: S,
                q: &[S; #n],
                v: &[S; #n],
            ) -> #path::Kinematics<S, [S; #n]> {
                #path::speeds::prepared_velocities::<S, Self>(prepared, t, q, v)
            }
        }
    })
}

/// Nothing where there are none.
pub(super) fn speeds(
    head: &Head,
    equations: &EquationsOfMotion,
    program: &Program,
    path: &TokenStream,
) -> Option<TokenStream> {
    let (model, speeds) = (&equations.model, equations.speeds.as_ref()?);
    let fields: Vec<_> =
        model.speeds.iter().map(|speed| (speed.name.clone(), documented(&speed.docs, &speed.unit))).collect();
    let docs = format!(" Generalised speeds of [`{}`] by name, in SI units; also for their rates.", model.name);
    let record = record(&head.visibility, &format_ident!("{}Speeds", model.name), &docs, &fields, path);
    let quantities = model.speeds.iter().map(|speed| quantity(&speed.name, &speed.unit, &speed.docs, path));
    let (name, k, r) = (ident(&model.name), size(model.speeds.len()), size(speeds.rows.len()));
    let rows = speeds.rows.iter().copied().map(size);
    let kernels = program.kernels.iter().filter(|kernel| is_of_speeds(kernel));
    let forwards = kernels.map(|kernel| forward(model, kernel, path));
    Some(quote! {
        #record

        #[allow(non_snake_case, clippy::all, clippy::pedantic)]
        impl<S: #path::Scalar> #path::GeneralizedSpeeds<S> for #name<S> {
            type U = [S; #k];
            type R = [S; #r];

            const SPEEDS: &'static [#path::Quantity] = &[#(#quantities),*];
            const ROWS: &'static [::core::primitive::usize] = &[#(#rows),*];

            #(#forwards)*
        }
    })
}
