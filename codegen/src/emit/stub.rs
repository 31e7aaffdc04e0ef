//! A stub for a mechanism whose declaration has mistakes, so that uses of it through the trait cause no further errors.

use super::ident;
use super::names::other_scalar;
use crate::dsl::Head;
use proc_macro2::TokenStream;
use quote::quote;

/// The type and the trait's impl, of size zero; the code never runs.
pub fn stub(head: &Head, path: &TokenStream) -> TokenStream {
    let Head { visibility, name, .. } = head;
    let types = types(head, path);
    let functions = functions(head, path);
    let kernels = kernels(path);
    let speeds = speeds(head, path);
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

            const DESCRIPTION: #path::Description = #path::Description {
                name: "", type_name: "", docs: "", declaration: "", declaration_hash: "", coordinates: &[], parameters: &[], inputs: &[], constraints: &[],
                speed_constraints: &[], norm_constraints: &[], sparsity: &[],
                conditionals: &[], events: &[], outputs: &[], rated_outputs: &[], figures: &[], optional_kernels: &[], dimension: 2, drawing: &[],
            };

            #functions

            #(#kernels)*
        }

        #speeds
    }
}

/// The trait's vectors and matrices: empty.
fn types(head: &Head, path: &TokenStream) -> TokenStream {
    let (name, other) = (&head.name, other_scalar(&head.name.to_string()));
    quote! {
        type Q = [S; 0];
        type L = [S; 0];
        type Z = [S; 0];
        type QQ = [[S; 0]; 0];
        type LQ = [[S; 0]; 0];
        type LL = [[S; 0]; 0];
        type ZZ = [[S; 0]; 0];
        type Entries = [S; 0];
        type Envelope = [S; 0];
        type Parameters = [S; 0];
        type Outputs = [S; 0];
        type OutputRates = [S; 0];
        type Events = [S; 0];
        type EventValues = [S; 0];
        type Activities = [S; 0];
        type Drawing = [S; 0];
        type QP = [[S; 0]; 0];
        type LP = [[S; 0]; 0];
        type Inputs = [#path::Input<S>; 0];
        type Prepared = ();
        type On<#other: #path::Scalar> = #name<#other>;
    }
}

/// The trait's functions that are not kernels of a time.
fn functions(head: &Head, path: &TokenStream) -> TokenStream {
    let (name, other) = (&head.name, other_scalar(&head.name.to_string()));
    quote! {
        fn defaults() -> Self {
            Self(::core::marker::PhantomData)
        }
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
        fn initial(&self) -> #path::Initial<[S; 0]> {
            loop {}
        }
        fn prepare(&self) {}
        fn prepared_dynamics(
            prepared: &(),
            t: S,
            q: &[S; 0],
            qd: &[S; 0],
        ) -> #path::Dynamics<S, [S; 0], [S; 0]> {
            loop {}
        }
    }
}

/// The kernels of the mechanism's own type.
fn kernels(path: &TokenStream) -> [TokenStream; 15] {
    let kernel = |name: &str, arguments: &[&str], returns: TokenStream| {
        let name = ident(name);
        let arguments = arguments.iter().map(|argument| {
            let argument = ident(argument);
            quote! { #argument: &[S; 0] }
        });
        quote! { fn #name(&self, t: S #(, #arguments)*) -> #returns { loop {} } }
    };
    let (vector, matrix) = (quote! { [S; 0] }, quote! { [[S; 0]; 0] });
    [
        kernel("mass_matrix", &["q"], matrix.clone()),
        kernel("convective_forces", &["q", "qd"], vector.clone()),
        kernel("generalized_forces", &["q", "qd"], vector.clone()),
        kernel("constraints", &["q"], vector.clone()),
        kernel("constraint_magnitudes", &["q"], vector.clone()),
        kernel("constraint_jacobian", &["q"], matrix),
        kernel("constraint_time_derivative", &["q"], vector.clone()),
        kernel("constraint_convective", &["q", "qd"], vector.clone()),
        kernel("constraint_linearization", &["q"], quote! { #path::ConstraintLinearization<[S; 0], [[S; 0]; 0]> }),
        kernel("kinetic_energy", &["q", "qd"], quote! { S }),
        kernel("power", &["q", "qd", "qdd", "lambda"], quote! { S }),
        kernel("outputs", &["q", "qd", "qdd", "lambda"], vector.clone()),
        kernel("output_rates", &["q", "qd", "qdd"], vector.clone()),
        kernel("events", &["q", "qd", "qdd", "lambda"], vector.clone()),
        kernel("drawing", &["q"], vector),
    ]
}

/// The impl of the trait of generalised speeds.
fn speeds(head: &Head, path: &TokenStream) -> TokenStream {
    let name = &head.name;
    quote! {
        #[allow(unused_variables, clippy::all)]
        impl<S: #path::Scalar> #path::GeneralizedSpeeds<S> for #name<S> {
            type U = [S; 0];
            type R = [S; 0];

            const SPEEDS: &'static [#path::Quantity] = &[];
            const ROWS: &'static [::core::primitive::usize] = &[];

            fn generalized_speeds(&self, t: S, q: &[S; 0], qd: &[S; 0]) -> [S; 0] {
                []
            }
            fn prepared_kinematics(prepared: &(), t: S, q: &[S; 0], u: &[S; 0]) -> #path::Kinematics<S, [S; 0]> {
                loop {}
            }
            fn prepared_speed_dynamics(
                prepared: &(),
                t: S,
                q: &[S; 0],
                u: &[S; 0],
            ) -> #path::SpeedDynamics<S, [S; 0], [S; 0]> {
                loop {}
            }
        }
    }
}
