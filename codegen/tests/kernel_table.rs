//! The table of kernels says of them what the runtime's traits do, and whoever goes by it leaves none out.

#![allow(missing_docs, clippy::unwrap_used)]

use codegen::kernel_id::{Argument, KernelId, Receiver, Signature, Trait, Type};
use codegen::{dsl, dynamics, emit, model, program};
use quote::{ToTokens, quote};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use syn::{ImplItem, Item, TraitItem, TraitItemFn};

/// Functions of the traits that are no kernels: of parameters and the like, and those that other functions of the trait give.
const NO_KERNELS: [&str; 15] = [
    "activities",
    "as_declared",
    "description",
    "inputs",
    "m",
    "n",
    "on",
    "parameters",
    "prepared_velocities",
    "rows_left",
    "set_inputs",
    "velocity_variables",
    "with_activities",
    "with_inputs",
    "with_parameters",
];

/// Every kernel but the one of sparse rows.
const SMALL: &str = "pub Small;
    coordinates { x [m]; }
    parameters { m [kg] = 1; }
    inputs { F [N] = 0; }
    speeds { v [m/s] = dot(x); }
    bodies { block: mass m at [x, 0]; }
    loads { force [if t > 1 [s] then F else 0, 0] at [x, 0]; force max(0 [N], -m*x*1 [1/s^2]) on x; }
    events { far: x = 1 [m] { set x = 0; } }
    kernels { dynamics_jacobian; dynamics_sensitivity; inverse_dynamics; speed_mass_matrix; }";

/// Many rows, each of few coordinates.
const SPARSE: &str = "pub Sparse;
    parameters { m [kg] = 2; J [kg*m^2] = 0.3; l [m] = 0.7; }
    bodies { repeat i in 1..=16 { b_[i]: free, mass m, inertia J; } }
    joints { repeat i in 1..=8 { p_[i]: pin on(b_[2*i - 1], [l, 0]) to on(b_[2*i], [0, l]); } }";

/// The source of the runtime's half of generated code, in which its traits are.
fn kernel_source() -> String {
    fn read(folder: &Path, out: &mut String) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                read(&path, out);
            } else {
                let file = syn::parse_file(&fs::read_to_string(&path).unwrap()).unwrap();
                let traits = file.items.into_iter().filter(|item| matches!(item, Item::Trait(_)));
                *out += &traits.map(|item| item.to_token_stream().to_string()).collect::<String>();
            }
        }
    }
    let mut out = String::new();
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../sim/kernel/src"), &mut out);
    out
}

fn name(of: Trait) -> &'static str {
    match of {
        Trait::Mechanism => "Mechanism",
        Trait::GeneralizedSpeeds => "GeneralizedSpeeds",
    }
}

/// The items of a trait in a source.
fn items(of: Trait, source: &str) -> Vec<TraitItem> {
    let found = syn::parse_file(source).unwrap().items.into_iter().find_map(|item| match item {
        Item::Trait(found) if found.ident == name(of) => Some(found.items),
        _ => None,
    });
    found.unwrap()
}

fn methods(of: Trait, source: &str) -> BTreeMap<String, TraitItemFn> {
    let methods = items(of, source).into_iter().filter_map(|item| match item {
        TraitItem::Fn(method) => Some((method.sig.ident.to_string(), method)),
        _ => None,
    });
    methods.collect()
}

/// A type as the traits write it.
fn written(of: &Type) -> String {
    match of {
        Type::Scalar => "S".into(),
        Type::Associated(associated) => format!("Self::{associated:?}"),
        Type::Record(record, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(written).collect();
            format!("{record:?}<{}>", arguments.join(", "))
        }
    }
}

/// The head of a function that a trait has for a kernel.
fn expected(kernel: &Signature, name: &str, receiver: Receiver) -> String {
    let receiver = match receiver {
        Receiver::Mechanism => "&self",
        Receiver::Prepared => "prepared: &Self::Prepared",
    };
    let argument = |argument: &Argument| match argument.vector() {
        None => format!(", {}: S", argument.name()),
        Some(vector) => format!(", {}: &Self::{vector:?}", argument.name()),
    };
    let arguments: String = kernel.arguments.list().iter().map(argument).collect();
    format!("fn {name}({receiver}{arguments}) -> {}", written(&kernel.result))
}

/// The head of a function without line breaks and what they bring.
fn head(signature: &syn::Signature) -> String {
    let (name, inputs, output) = (&signature.ident, signature.inputs.iter(), &signature.output);
    quote!(fn #name(#(#inputs),*) #output).to_string()
}

/// What the traits say otherwise than the table, or do not say.
fn differences(source: &str) -> Vec<String> {
    let mut differences = Vec::new();
    for kernel in KernelId::ALL.iter().map(|kernel| kernel.signature()) {
        let methods = methods(kernel.method.of, source);
        let mut compare = |name: &str, receiver: Receiver, is_provided: bool| {
            let expected: syn::Signature = syn::parse_str(&expected(kernel, name, receiver)).unwrap();
            let found = methods.get(name).map(|method| (head(&method.sig), method.default.is_some()));
            if found != Some((head(&expected), is_provided)) {
                differences.push(kernel.name.to_owned());
            }
        };
        compare(kernel.method.name, kernel.method.receiver, kernel.method.is_provided);
        // For one call.
        if kernel.method.receiver == Receiver::Prepared {
            compare(kernel.name, Receiver::Mechanism, true);
        }
    }
    differences
}

#[test]
fn the_traits_have_the_functions_of_the_table() {
    assert_eq!(differences(&kernel_source()), Vec::<String>::new());
}

#[test]
fn a_trait_that_differs_is_found() {
    let source = kernel_source();
    let head = |kernel: KernelId| {
        let text = expected(kernel.signature(), kernel.signature().method.name, kernel.signature().method.receiver);
        head(&syn::parse_str(&text).unwrap())
    };
    for (kernel, from, to) in [
        (KernelId::MassMatrix, "q : & Self :: Q", "q : & Self :: L"),
        (KernelId::Power, "qd : &", "speeds : &"),
        (KernelId::Events, ", lambda : & Self :: L", ""),
        (KernelId::Constraints, "-> Self :: L", "-> Self :: Q"),
        (KernelId::KineticEnergy, "& self", "prepared : & Self :: Prepared"),
        (KernelId::Kinematics, "u : & Self :: U", "u : & Self :: Q"),
        (KernelId::Drawing, "fn drawing", "fn picture"),
    ] {
        let head = head(kernel);
        let planted = source.replace(&head, &head.replacen(from, to, 1));
        assert_ne!(planted, source, "{head}");
        assert_eq!(differences(&planted), [kernel.name()]);
    }
}

#[test]
fn every_function_of_the_traits_is_in_the_table_or_no_kernel() {
    let source = kernel_source();
    let functions: BTreeSet<String> = [Trait::Mechanism, Trait::GeneralizedSpeeds]
        .into_iter()
        .flat_map(|of| methods(of, &source).into_keys())
        .collect();
    let kernels = KernelId::ALL.iter().map(|kernel| kernel.signature());
    let for_one_call = |kernel: &Signature| (kernel.method.receiver == Receiver::Prepared).then_some(kernel.name);
    let known = kernels.flat_map(|kernel| [Some(kernel.method.name), for_one_call(kernel)]).flatten().chain(NO_KERNELS);
    assert_eq!(functions, known.map(str::to_owned).collect());
}

/// What an impl says of a trait in generated items: functions and types.
fn implemented(of: Trait, items: &str) -> BTreeSet<String> {
    let impls = syn::parse_file(items).unwrap().items.into_iter().filter_map(|item| match item {
        Item::Impl(found) => Some(found),
        _ => None,
    });
    let is_of = |found: &syn::ItemImpl| {
        found.trait_.as_ref().is_some_and(|(path, _)| path.segments.last().unwrap().ident == name(of))
    };
    let said = impls.filter(is_of).flat_map(|found| found.items).filter_map(|item| match item {
        ImplItem::Fn(function) => Some(function.sig.ident.to_string()),
        ImplItem::Type(defined) => Some(defined.ident.to_string()),
        _ => None,
    });
    said.collect()
}

/// Functions and types that a trait leaves to each impl.
fn needed(of: Trait, source: &str) -> BTreeSet<String> {
    let items = items(of, source).into_iter().filter_map(|item| match item {
        TraitItem::Fn(function) if function.default.is_none() => Some(function.sig.ident.to_string()),
        TraitItem::Type(defined) => Some(defined.ident.to_string()),
        _ => None,
    });
    items.collect()
}

#[test]
fn mechanisms_and_their_stand_ins_leave_nothing_out() {
    let source = kernel_source();
    let head = dsl::parse_head(SMALL.parse().unwrap()).unwrap();
    let stub = emit::stub(&head, &quote!(sim_kernel)).to_string();
    let small = codegen::generate_text(SMALL, "sim_kernel").unwrap();
    for of in [Trait::Mechanism, Trait::GeneralizedSpeeds] {
        let needed = needed(of, &source);
        assert_eq!(implemented(of, &stub), needed);
        assert!(implemented(of, &small).is_superset(&needed));
        let methods: BTreeSet<String> = methods(of, &source).into_keys().chain(needed).collect();
        assert!(implemented(of, &small).is_subset(&methods));
    }
}

/// The kernels of a declaration.
fn planned(declaration: &str) -> Vec<KernelId> {
    let tokens = dsl::declarations(declaration).unwrap().remove(0);
    let mut equations = dynamics::derive_cheapest(model::resolve(&codegen::parse(tokens).unwrap()).unwrap());
    program::plan(&mut equations).kernels.iter().map(|kernel| kernel.id).collect()
}

#[test]
fn every_kernel_is_made() {
    let made: Vec<Vec<KernelId>> = [SMALL, SPARSE].map(planned).into();
    for kernels in &made {
        let distinct: BTreeSet<&KernelId> = kernels.iter().collect();
        assert_eq!(distinct.len(), kernels.len(), "{kernels:?}");
    }
    let all: BTreeSet<KernelId> = KernelId::ALL.iter().copied().collect();
    assert_eq!(made.into_iter().flatten().collect::<BTreeSet<_>>(), all);
}

#[test]
fn names_are_names_of_one_kernel() {
    let names: BTreeSet<&str> = KernelId::ALL.iter().map(|kernel| kernel.name()).collect();
    assert_eq!(names.len(), KernelId::ALL.len());
}

/// A word in braces that nothing is said for would be printed.
#[test]
fn documentation_is_filled_in() {
    for declaration in [SMALL, SPARSE] {
        let tokens = dsl::declarations(declaration).unwrap().remove(0);
        let mut equations = dynamics::derive_cheapest(model::resolve(&codegen::parse(tokens).unwrap()).unwrap());
        for kernel in program::plan(&mut equations).kernels {
            assert!(!kernel.docs.is_empty() && !kernel.docs.contains(['{', '}']), "{}", kernel.docs);
        }
    }
}
