//! Functions that compute kernels. Long ones are work of its own, which is done with the vector instructions that the processor has.

use super::concrete::{Concrete, vector};
use super::names::argument_names;
use crate::kernel_id::{Arguments, KernelId};
use crate::program::Kernel;
use proc_macro2::{Group, Ident, TokenStream};
use quote::{format_ident, quote};

/// Whether a kernel has parts, or is called again and again and so long that a call costs nothing beside what is won. What is
/// returned is copied, so a kernel with many results has to be longer.
pub(super) fn is_apart(kernel: &Kernel) -> bool {
    use KernelId as Id;
    let (results, operations) = (kernel.results.entries().len(), kernel.operations.total());
    let is_long = match kernel.id {
        // Shorter ones have few equal steps side by side, and lose more by shuffling numbers than vectors save.
        Id::Dynamics => operations >= 500,
        Id::SpeedDynamics | Id::InverseDynamics => operations >= 150,
        Id::MassMatrix | Id::SpeedMassMatrix => operations >= 150 && results <= 36,
        Id::DynamicsJacobian | Id::DynamicsSensitivity => operations >= 1000,
        _ => false,
    };
    is_long || !kernel.pieces.is_empty()
}

/// A function that computes a kernel, or a part of it.
pub(super) struct Function<'a> {
    pub(super) name: Ident,
    /// What it is a method of, without its scalar.
    pub(super) of: Ident,
    /// The arguments of the kernel.
    pub(super) arguments: Arguments,
    /// Whether it is one of several parts, which are never inlined.
    pub(super) is_part: bool,
    /// How many results of the parts before it is given.
    pub(super) found: Option<usize>,
    pub(super) returns: TokenStream,
    pub(super) body: &'a Group,
}

impl Function<'_> {
    /// The function, which hands its arguments on as work, and the one that does the work.
    pub(super) fn apart(self, visibility: &TokenStream, concrete: &Concrete, path: &TokenStream) -> TokenStream {
        let Function { name, of, returns, body, .. } = &self;
        let way = format_ident!("{}", if self.is_part { "compute_part" } else { "compute" });
        let (work, compute) = (format_ident!("{of}At"), format_ident!("compute_{name}"));
        let arguments = self.arguments(concrete, &quote! { & });
        let fields = self.arguments(concrete, &quote! { &'a });
        let found = self.found.map(|_| format_ident!("found"));
        let names: Vec<Ident> = argument_names(self.arguments).into_iter().chain(found).collect();
        quote! {
            #visibility fn #name(&self #(, #arguments)*) -> #returns {
                struct #work<'a, S> { of: &'a #of<S> #(, #fields)* }
                impl<S: #path::Scalar> #path::Work for #work<'_, S> {
                    type Output = #returns;
                    #[inline(always)]
                    fn run<const AT_ONCE: ::core::primitive::usize>(self) -> #returns {
                        self.of.#compute(#(self.#names),*)
                    }
                }
                S::#way(#work { of: self #(, #names)* })
            }

            #[inline(always)]
            fn #compute(&self #(, #arguments)*) -> #returns #body
        }
    }

    /// The function as it is.
    pub(super) fn plain(self, visibility: &TokenStream, concrete: &Concrete) -> TokenStream {
        let Function { name, returns, body, .. } = &self;
        let arguments = self.arguments(concrete, &quote! { & });
        quote! { #visibility fn #name(&self #(, #arguments)*) -> #returns #body }
    }

    /// `t: S, q: &[S; n], ..`
    fn arguments(&self, concrete: &Concrete, reference: &TokenStream) -> Vec<TokenStream> {
        let found = self.found.map(|len| {
            let found = vector(len);
            quote! { found: #reference #found }
        });
        concrete.arguments_by(self.arguments, reference).into_iter().chain(found).collect()
    }
}
