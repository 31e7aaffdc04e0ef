//! The words that blocks start with.

pub(super) const BLOCKS: [&str; 15] = [
    "coordinates",
    "parameters",
    "bodies",
    "loads",
    "constraints",
    "initial",
    "events",
    "outputs",
    "drawing",
    "kernels",
    "auxiliary",
    "inputs",
    "joints",
    "tables",
    "speeds",
];
