//! Robots from URDF: what is read is what the file says.

#![allow(missing_docs, clippy::unwrap_used)]

mod energies;
mod mangled;
mod reference;
mod refusals;
mod warnings;

use sim::import::urdf::{Imported, Options, import};
use sim::{DeclarationFile, Model};
use std::path::Path;
use std::sync::Arc;

const KINDS: &str = include_str!("../robots/urdf/kinds.urdf");
const ARM: &str = include_str!("../../sim/examples/robots/arm.urdf");
const QUADRUPED: &str = include_str!("../../sim/examples/robots/quadruped.urdf");

fn imported(text: &str, options: &Options) -> Imported {
    import(text, Path::new(""), options).map_err(|mistakes| mistakes[0].shown("robot.urdf", text)).unwrap()
}

/// A declaration's model.
fn declared(text: &str) -> Arc<dyn Model> {
    DeclarationFile::of(Path::new("robot.mech"), text.to_owned())
        .model(None)
        .map_err(|why| format!("{why}\n{text}"))
        .unwrap()
}

/// What a file of robots runs is what its import writes.
#[test]
fn a_robots_file_is_what_its_import_writes() {
    for text in [KINDS, ARM, QUADRUPED] {
        let file = DeclarationFile::of(Path::new("robot.urdf"), text.to_owned()).model(None).unwrap();
        let written = declared(&imported(text, &Options::default()).text);
        assert_eq!(format!("{:?}", file.description()), format!("{:?}", written.description()));
    }
}
