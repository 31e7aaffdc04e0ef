//! Functions of the runtime's traits that are kernels.

use super::concrete::Concrete;
use super::ident;
use super::kernel::record_of;
use super::names::argument_names;
use crate::kernel_id::{Associated, KernelId, Receiver, Trait, Type};
use crate::model::Model;
use crate::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

/// The functions of a trait, each of which calls the inherent one.
pub(super) fn forwards(
    of: Trait,
    model: &Model,
    program: &Program,
    concrete: &Concrete,
    path: &TokenStream,
) -> TokenStream {
    let kernels = program.kernels.iter().map(|kernel| kernel.id);
    let own = kernels.filter(|kernel| kernel.signature().method.of == of);
    own.map(|kernel| forward(model, kernel, concrete, path)).collect()
}

fn forward(model: &Model, kernel: KernelId, concrete: &Concrete, path: &TokenStream) -> TokenStream {
    let signature = kernel.signature();
    let (function, method) = (ident(signature.name), ident(signature.method.name));
    let list = concrete.arguments(signature.arguments);
    let names = argument_names(signature.arguments);
    if let Type::Associated(Associated::Inputs) = signature.result {
        return quote! {
            fn #method(&self #(, #list)*) -> Self::Inputs {
                self.#function(#(#names),*).map(#path::Input::Held)
            }
        };
    }
    let returns = concrete.of_type(&signature.result);
    let to_array = record_of(model, kernel).map(|_| quote! { .into() });
    let (receiver, called) = match (signature.method.receiver, signature.receiver) {
        (Receiver::Mechanism, Receiver::Mechanism) => (quote! { &self }, quote! { self }),
        (Receiver::Mechanism, Receiver::Prepared) => (quote! { &self }, quote! { self.prepare() }),
        (Receiver::Prepared, _) => (quote! { prepared: &Self::Prepared }, quote! { prepared }),
    };
    quote! {
        #[inline(always)]
        fn #method(#receiver #(, #list)*) -> #returns {
            #called.#function(#(#names),*) #to_array
        }
    }
}
