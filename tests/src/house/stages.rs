//! The stages of each crate, in the order of the data flow.

use super::imports::Imports;

/// A crate with its stages.
#[derive(Clone, Copy, Debug)]
pub struct Crate {
    /// Its source, from the root of the workspace.
    pub folder: &'static str,
    /// Its stages in order: none imports a later one.
    pub stages: &'static [&'static str],
    /// Stages that import no others but these.
    pub apart: &'static [(&'static str, &'static [&'static str])],
}

/// The crates of the workspace.
pub const CRATES: &[Crate] = &[
    Crate { folder: "sim/kernel/src", stages: &[], apart: &[] },
    Crate {
        folder: "codegen/src",
        stages: &[
            "threads",
            "nearest",
            "mistakes",
            "kernel_id",
            "symbolic",
            "dsl",
            "joints",
            "model",
            "dynamics",
            "program",
            "description",
            "notation",
            "emit",
            "oracle",
        ],
        apart: &[("symbolic", &[]), ("oracle", &["dsl"])],
    },
    Crate {
        folder: "codegen/command/src",
        stages: &["source", "difference", "header", "document", "graph", "statistics", "command"],
        apart: &[],
    },
    Crate {
        folder: "sim/runtime/src",
        stages: &[
            "numerics",
            "state",
            "model",
            "interpreted",
            "motion",
            "integrate",
            "start",
            "events",
            "record",
            "run",
            "batch",
            "analysis",
            "compiled",
        ],
        apart: &[("numerics", &[])],
    },
    Crate {
        folder: "sim/output/src",
        stages: &["whole", "outcome", "happening", "write", "formats", "show"],
        apart: &[],
    },
    Crate { folder: "sim/import/src", stages: &[], apart: &[] },
    Crate { folder: "sim/command/src", stages: &[], apart: &[] },
];

/// Imports of a later stage, or of one that a stage has to do without, as `from -> to`.
pub fn out_of_order(of: &Crate, imports: &Imports) -> Vec<String> {
    let stage = |module: &str| module.split("::").next().unwrap_or_default().to_owned();
    let place = |module: &str| of.stages.iter().position(|known| *known == stage(module));
    let is_wrong = |from: &str, to: &str| {
        let (before, after) = (stage(from), stage(to));
        let apart = of.apart.iter().find(|(name, _)| *name == before);
        let is_apart = apart.is_some_and(|(_, allowed)| before != after && !allowed.contains(&after.as_str()));
        is_apart || matches!((place(from), place(to)), (Some(from), Some(to)) if to > from)
    };
    let all = imports.iter().flat_map(|(from, others)| others.iter().map(move |to| (from, to)));
    all.filter(|(from, to)| is_wrong(from, to)).map(|(from, to)| format!("{from} -> {to}")).collect()
}
