//! Runs random linkages.

#[path = "../stress/mod.rs"]
mod stress;

fn main() -> std::process::ExitCode {
    stress::main()
}
