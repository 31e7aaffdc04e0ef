//! Functions of the runtime's traits that are kernels.

use super::kernel::{argument_names, arguments, record_of, returned_array};
use crate::model::Model;
use crate::program::{Kernel, Receiver};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The trait's function, which calls the inherent one of the same name.
pub(super) fn forward(model: &Model, kernel: &Kernel, path: &TokenStream) -> TokenStream {
    let function = format_ident!("{}", kernel.name);
    let prepared_function = format_ident!("prepared_{}", kernel.name);
    let list = arguments(model, kernel.arguments);
    let names = argument_names(kernel.arguments);
    let returns = returned_array(model, kernel, path);
    let to_array = record_of(model, kernel).map(|_| quote! { .into() });
    match kernel.receiver {
        Receiver::Mechanism if kernel.name == "input_values" => quote! {
            fn held_inputs(&self #(, #list)*) -> Self::Inputs {
                self.#function(#(#names),*).map(#path::Input::Held)
            }
        },
        Receiver::Mechanism => quote! {
            #[inline(always)]
            fn #function(&self #(, #list)*) -> #returns {
                self.#function(#(#names),*) #to_array
            }
        },
        Receiver::Prepared if ["dynamics", "kinematics", "speed_dynamics"].contains(&kernel.name) => quote! {
            #[inline(always)]
            fn #prepared_function(prepared: &Self::Prepared #(, #list)*) -> #returns {
                prepared.#function(#(#names),*)
            }
        },
        Receiver::Prepared => quote! {
            #[inline(always)]
            fn #function(&self #(, #list)*) -> #returns {
                self.prepare().#function(#(#names),*)
            }
        },
    }
}
