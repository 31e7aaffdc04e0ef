//! The items of generalised speeds: their struct, and the impl of their trait.

use super::concrete::Concrete;
use super::description::quantity;
use super::documentation::documented;
use super::forward::forwards;
use super::record::record;
use super::{ident, size};
use crate::description::Quantity;
use crate::dsl::Head;
use crate::dynamics::EquationsOfMotion;
use crate::kernel_id::Trait;
use crate::program::Program;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Their items in the runtime's trait; empty if there are none.
pub(super) fn velocity_variables(equations: &EquationsOfMotion, path: &TokenStream) -> Option<TokenStream> {
    let n = size(equations.model.coordinates.len());
    equations.speeds.as_ref().map(|_| {
        quote! {
            #[inline(always)]
            fn rows_left(&self) -> ::core::option::Option<&'static [::core::primitive::usize]> {
                ::core::option::Option::Some(<Self as #path::GeneralizedSpeeds<S>>::ROWS)
            }

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
    concrete: &Concrete,
    path: &TokenStream,
) -> Option<TokenStream> {
    let (model, speeds) = (&equations.model, equations.speeds.as_ref()?);
    let fields: Vec<_> = model
        .generalized_speeds
        .iter()
        .map(|speed| (speed.name.clone(), documented(&speed.docs, &speed.unit)))
        .collect();
    let docs = format!(" Generalised speeds of [`{}`] by name, in SI units; also for their rates.", model.name);
    let record = record(&head.visibility, &format_ident!("{}Speeds", model.name), &docs, &fields, path);
    let quantities = model
        .generalized_speeds
        .iter()
        .map(|speed| quantity(&Quantity::of(&speed.name, &speed.unit, &speed.docs), path));
    let (name, types) = (ident(&model.name), concrete.definitions(Trait::GeneralizedSpeeds));
    let rows = speeds.rows.iter().copied().map(size);
    let forwards = forwards(Trait::GeneralizedSpeeds, model, program, concrete, path);
    Some(quote! {
        #record

        #[allow(non_snake_case, clippy::all, clippy::pedantic)]
        impl<S: #path::Scalar> #path::GeneralizedSpeeds<S> for #name<S> {
            #types

            const SPEEDS: &'static [#path::Quantity] = &[#(#quantities),*];
            const ROWS: &'static [::core::primitive::usize] = &[#(#rows),*];

            #forwards
        }
    })
}
