//! The house: no ring of imports, no stage that imports a later one, no function or file that is too long.

#![allow(missing_docs, clippy::unwrap_used)]

use std::path::Path;
use tests::house::{CRATES, Crate, Source, imports, long_files, long_functions, out_of_order, rings};

fn source(of: &Crate) -> Source {
    Source::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(of.folder)).unwrap()
}

#[test]
fn imports_go_in_no_ring() {
    for of in CRATES {
        assert_eq!(rings(&imports(&source(of))), Vec::<Vec<String>>::new(), "{}", of.folder);
    }
}

#[test]
fn no_stage_imports_a_later_one() {
    for of in CRATES {
        assert_eq!(out_of_order(of, &imports(&source(of))), Vec::<String>::new(), "{}", of.folder);
    }
}

/// A stage that is not in the list would not be looked at.
#[test]
fn every_folder_is_a_stage() {
    for of in CRATES.iter().filter(|of| !of.stages.is_empty()) {
        let modules = source(of).modules;
        let unknown = modules.keys().filter(|path| !path.is_empty());
        let unknown: Vec<&String> =
            unknown.filter(|path| !of.stages.contains(&path.split("::").next().unwrap())).collect();
        assert!(unknown.is_empty(), "{}: {unknown:?}", of.folder);
    }
}

#[test]
fn functions_and_files_are_short() {
    for of in CRATES {
        let source = source(of);
        assert_eq!(long_functions(&source, 60), vec![], "{}", of.folder);
        assert_eq!(long_files(&source, 400), vec![], "{}", of.folder);
    }
}

/// Rings and wrong ways that were put there are seen, by way of names that are passed on too.
#[test]
fn planted_faults_are_found() {
    let ring = Source::of(&[
        ("", "mod a; mod b; pub use a::Name;"),
        ("a", "use crate::b::thing; pub struct Name;"),
        ("b", "pub mod inner; fn thing() { let _ = crate::Name; }"),
        ("b::inner", "use super::thing;"),
    ]);
    assert_eq!(rings(&imports(&ring.unwrap())), [["a", "b"]]);
    let none = Source::of(&[
        ("", "mod a; mod b;"),
        ("a", "#[cfg(test)] mod tests { use crate::b::thing; }"),
        ("b", "use crate::{a::{Name, Other}, Third}; fn long() {\n\n\n}"),
    ]);
    let none = none.unwrap();
    assert_eq!(rings(&imports(&none)), Vec::<Vec<String>>::new());
    let backward = Crate { folder: "", stages: &["b", "a"], apart: &[] };
    assert_eq!(out_of_order(&backward, &imports(&none)), ["b -> a"]);
    let apart = Crate { folder: "", stages: &["a", "b"], apart: &[("b", &[])] };
    assert_eq!(out_of_order(&apart, &imports(&none)), ["b -> a"]);
    assert_eq!(long_functions(&none, 3)[0].lines, 4);
}
