//! What kernels cost. Times are taken by benchmarks, which print them beside what they are compared with.

use super::{Subject, Table};

pub(super) const SUBJECTS: &[Subject] = &[("benchmarks", measure)];

fn measure(table: &mut Table) {
    let bench = |name: &str| format!("cargo bench -p tests --bench {name}");
    let scale = |name: &str| format!("cargo bench -p tests --features scale --bench {name}");
    table.elsewhere("right-hand side of quick-return beside one derived by hand", &bench("dynamics"));
    table.elsewhere("eight trajectories in vector lanes beside one", &bench("lanes"));
    table.elsewhere("kernels of a six-axis arm beside published generators", &bench("arm"));
    table.elsewhere("derivatives of the motion beside the right-hand side", &scale("derivatives"));
    table.elsewhere("chains and rows of four-bars beside recursions by hand", &scale("scale"));
    table.elsewhere("derivation, by stage", &bench("derivation"));
}
