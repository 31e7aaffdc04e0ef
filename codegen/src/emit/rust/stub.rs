//! A stub for a mechanism whose declaration has mistakes, so that uses of it through the trait cause no further errors.

use super::concrete::Concrete;
use super::ident;
use super::names::other_scalar;
use crate::description::Description;
use crate::dsl::Head;
use crate::kernel_id::{KernelId, Receiver, Signature, Trait};
use proc_macro2::TokenStream;
use quote::quote;

/// The type and the trait's impl, of size zero; the code never runs.
pub fn stub(head: &Head, path: &TokenStream) -> TokenStream {
    let Head { visibility, name, .. } = head;
    let concrete = Concrete::empty(path);
    let (types, other) = (concrete.definitions(Trait::Mechanism), other_scalar(&name.to_string()));
    let functions = functions(head, path);
    let kernels = kernels(Trait::Mechanism, &concrete);
    let speeds = speeds(head, &concrete, path);
    let description = super::description::description(&Description::default(), path);
    quote! {
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
        #visibility struct #name<S = ::core::primitive::f64>(::core::marker::PhantomData<S>);

        impl<S: #path::Scalar> ::core::default::Default for #name<S> {
            fn default() -> Self {
                Self(::core::marker::PhantomData)
            }
        }

        #[allow(unused_variables, clippy::all)]
        impl<S: #path::Scalar> #path::Mechanism<S> for #name<S> {
            #types
            type On<#other: #path::Scalar> = #name<#other>;

            fn description(&self) -> &'static #path::Description {
                const { &<Self as #path::Compiled<S>>::DESCRIPTION }
            }

            fn as_declared(&self) -> Self {
                *self
            }

            #functions

            #kernels
        }

        impl<S: #path::Scalar> #path::Compiled<S> for #name<S> {
            const DESCRIPTION: #path::Description = #description;

            fn defaults() -> Self {
                Self(::core::marker::PhantomData)
            }
        }

        #speeds
    }
}

/// The trait's functions that are no kernels.
fn functions(head: &Head, path: &TokenStream) -> TokenStream {
    let (name, other) = (&head.name, other_scalar(&head.name.to_string()));
    quote! {
        fn parameters(&self) -> [S; 0] {
            []
        }
        fn with_parameters(&self, parameters: [S; 0]) -> Self {
            Self(::core::marker::PhantomData)
        }
        fn on<#other: #path::Scalar>(&self, convert: impl ::core::ops::Fn(S) -> #other) -> #name<#other> {
            #name(::core::marker::PhantomData)
        }
        fn inputs(&self) -> Self::Inputs {
            []
        }
        fn with_inputs(&self, inputs: Self::Inputs) -> Self {
            *self
        }
        fn set_inputs(prepared: &mut (), inputs: Self::Inputs) {}
    }
}

/// The kernels that a trait has no body for.
fn kernels(of: Trait, concrete: &Concrete) -> TokenStream {
    let needed = KernelId::ALL.iter().map(|kernel| kernel.signature());
    let needed = needed.filter(|kernel| kernel.method.of == of && !kernel.method.is_provided);
    let kernel = |kernel: &Signature| {
        let (name, returns) = (ident(kernel.method.name), concrete.of_type(&kernel.result));
        let receiver = match kernel.method.receiver {
            Receiver::Mechanism => quote! { &self },
            Receiver::Prepared => quote! { prepared: &Self::Prepared },
        };
        let arguments = concrete.arguments(kernel.arguments);
        quote! { fn #name(#receiver #(, #arguments)*) -> #returns { loop {} } }
    };
    needed.map(kernel).collect()
}

/// The impl of the trait of generalised speeds.
fn speeds(head: &Head, concrete: &Concrete, path: &TokenStream) -> TokenStream {
    let name = &head.name;
    let types = concrete.definitions(Trait::GeneralizedSpeeds);
    let kernels = kernels(Trait::GeneralizedSpeeds, concrete);
    quote! {
        #[allow(unused_variables, clippy::all)]
        impl<S: #path::Scalar> #path::GeneralizedSpeeds<S> for #name<S> {
            #types

            const SPEEDS: &'static [#path::Quantity] = &[];
            const ROWS: &'static [::core::primitive::usize] = &[];

            #kernels
        }
    }
}
