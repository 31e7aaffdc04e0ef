//! A crate of all generated kernels that prints what they compute.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A mechanism with the states at which it is evaluated.
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) declaration: String,
    /// Components of vectors.
    pub(crate) dimension: usize,
    pub(crate) states: Vec<State>,
}

pub(crate) struct State {
    pub(crate) time: f64,
    pub(crate) parameters: Vec<f64>,
    pub(crate) coordinates: Vec<f64>,
    pub(crate) speeds: Vec<f64>,
    /// Of the motion whose forces are asked for.
    pub(crate) accelerations: Vec<f64>,
}

/// Prints every kernel's values of a state on one line, as bits, under their names.
const DRIVER: &str = r#"
use sim_kernel::{FixedArray, Mechanism, Compiled};

fn print(name: &str, values: impl IntoIterator<Item = f64>) {
    print!("{name}");
    for value in values {
        print!(" {:x}", value.to_bits());
    }
    print!(";");
}

fn rows<R: AsRef<[f64]>>(rows: impl AsRef<[R]>) -> Vec<f64> {
    rows.as_ref().iter().flat_map(|row| row.as_ref().to_vec()).collect()
}

fn evaluate<M: Compiled>(t: f64, p: &[f64], q: &[f64], qd: &[f64], qdd: &[f64]) {
    let mechanism = M::defaults().with_parameters(M::Parameters::from_fn(|i| p[i]));
    let [q, qd, qdd] = &[q, qd, qdd].map(|values| M::Q::from_fn(|i| values[i]));
    let vector = |values: &dyn AsRef<[f64]>| values.as_ref().to_vec();
    print("mass_matrix", rows(mechanism.mass_matrix(t, q)));
    print("convective", vector(&mechanism.convective_forces(t, q, qd)));
    print("forces", vector(&mechanism.generalized_forces(t, q, qd)));
    print("constraints", vector(&mechanism.constraints(t, q)));
    print("jacobian", rows(mechanism.constraint_jacobian(t, q)));
    print("time_derivative", vector(&mechanism.constraint_time_derivative(t, q)));
    print("constraint_convective", vector(&mechanism.constraint_convective(t, q, qd)));
    print("energy", [mechanism.kinetic_energy(t, q, qd)]);
    let solved = mechanism.dynamics(t, q, qd);
    print("refused", [if solved.refused { 1.0 } else { 0.0 }]);
    print("accelerations", vector(&solved.accelerations));
    print("multipliers", vector(&solved.multipliers));
    print("power", [solved.power]);
    print("events", vector(&mechanism.events(t, q, qd, &solved.accelerations, &solved.multipliers)));
    print("outputs", vector(&mechanism.outputs(t, q, qd, &solved.accelerations, &solved.multipliers)));
    print("event_values", vector(&mechanism.event_values(t, q, qd)));
    print("inverse", vector(&mechanism.inverse_dynamics(t, q, qd, qdd)));
    let by_state = mechanism.dynamics_jacobian(t, q, qd);
    let below = |above: Vec<f64>, below: Vec<f64>| [above, below].concat();
    print("by_positions", below(rows(by_state.accelerations_by_positions), rows(by_state.multipliers_by_positions)));
    print("by_speeds", below(rows(by_state.accelerations_by_speeds), rows(by_state.multipliers_by_speeds)));
    let by_parameters = mechanism.dynamics_sensitivity(t, q, qd);
    print("by_parameters", below(rows(by_parameters.accelerations), rows(by_parameters.multipliers)));
        println!();
}
"#;

/// What the kernels of all cases compute: for each case and state, names with values.
pub(crate) fn run(cases: &[Case]) -> Vec<Vec<(String, Vec<f64>)>> {
    let folder = made(cases);
    let mut command = Command::new(env!("CARGO"));
    command.args(["run", "--quiet"]).current_dir(&folder).env("CARGO_NET_OFFLINE", "true");
    command.env("CARGO_TARGET_DIR", folder.join("target"));
    for (setting, value) in [("OPT_LEVEL", "0"), ("DEBUG", "0")] {
        command.env(format!("CARGO_PROFILE_DEV_{setting}"), value);
    }
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap().lines().map(values).collect()
}

fn values(line: &str) -> Vec<(String, Vec<f64>)> {
    let entry = |entry: &str| {
        let mut words = entry.split(' ');
        let name = words.next().unwrap().to_owned();
        (name, words.map(|bits| f64::from_bits(u64::from_str_radix(bits, 16).unwrap())).collect())
    };
    line.split_terminator(';').map(entry).collect()
}

/// Writes the crate.
fn made(cases: &[Case]) -> PathBuf {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fuzz");
    fs::create_dir_all(folder.join("src")).unwrap();
    let manifest = format!(
        "[package]\nname = \"fuzz\"\nedition = \"2024\"\n[dependencies]\n\
         sim-kernel = {{ path = {:?} }}\n[workspace]\n",
        workspace.join("sim/kernel")
    );
    fs::write(folder.join("Cargo.toml"), manifest).unwrap();
    fs::copy(workspace.join("Cargo.lock"), folder.join("Cargo.lock")).unwrap();
    let mut source = String::from(DRIVER);
    let mut calls = String::new();
    for case in cases {
        let module = case.name.to_lowercase();
        let items = codegen::generate_text(&case.declaration, "sim_kernel").unwrap();
        writeln!(source, "#[allow(warnings)] mod {module} {{\n{items}\n}}").unwrap();
        for State { time, parameters, coordinates, speeds, accelerations } in &case.states {
            writeln!(
                calls,
                "evaluate::<{module}::{}>({time:?}, &{parameters:?}, &{coordinates:?}, &{speeds:?}, &{accelerations:?});",
                case.name
            )
            .unwrap();
        }
    }
    writeln!(source, "fn main() {{\n{calls}}}").unwrap();
    fs::write(folder.join("src/main.rs"), source).unwrap();
    folder
}
