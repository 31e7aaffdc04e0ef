//! A crate whose build script generates the code, without the macro: it depends on sim-kernel alone.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const MANIFEST: &str = r#"
[package]
name = "generated"
edition = "2024"

[dependencies]
sim-kernel = { path = "WORKSPACE/sim/kernel" }

[build-dependencies]
codegen = { path = "WORKSPACE/codegen", default-features = false }

[workspace]
"#;

const BUILD: &str = r#"
use std::{env, fs, path::Path};

fn main() {
    let file = "pendulum.txt";
    println!("cargo::rerun-if-changed={file}");
    let text = fs::read_to_string(file).unwrap();
    match codegen::generate_text(&text, "sim_kernel") {
        Ok(code) => fs::write(Path::new(&env::var("OUT_DIR").unwrap()).join("pendulum.rs"), code).unwrap(),
        Err(mistakes) => {
            codegen::mistakes::located(file, mistakes).lines().for_each(|line| println!("cargo::error={line}"));
        }
    }
}
"#;

const MAIN: &str = r#"
include!(concat!(env!("OUT_DIR"), "/pendulum.rs"));

fn main() {
    let pendulum = Pendulum { l: 2.0, ..Default::default() };
    println!("{}", pendulum.dynamics(0.0, &[0.5], &[1.0]).accelerations[0]);
}
"#;

const PENDULUM: &str = "/// A pendulum.
pub Pendulum;
coordinates { phi [rad]; }
parameters { l [m] = 1; }
bodies { bob: mass 1 [kg] at l*[sin(phi), -cos(phi)]; }
loads { gravity [0, -9.81 [m/s^2]]; }
";

fn cargo_run(folder: &Path) -> Output {
    Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--offline"])
        .current_dir(folder)
        .env("CARGO_TARGET_DIR", folder.join("target"))
        .output()
        .unwrap()
}

#[test]
fn a_build_script_generates_the_code_and_shows_mistakes() {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("generated");
    fs::create_dir_all(folder.join("src")).unwrap();
    let manifest = MANIFEST.replace("WORKSPACE", workspace.to_str().unwrap());
    for (file, text) in [("Cargo.toml", manifest.as_str()), ("build.rs", BUILD), ("src/main.rs", MAIN)] {
        fs::write(folder.join(file), text).unwrap();
    }
    fs::write(folder.join("pendulum.txt"), PENDULUM).unwrap();
    fs::copy(workspace.join("Cargo.lock"), folder.join("Cargo.lock")).unwrap();
    let output = cargo_run(&folder);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let acceleration: f64 = String::from_utf8(output.stdout).unwrap().trim().parse().unwrap();
    // l phi'' = -g sin(phi), and a handful of roundings.
    assert!((acceleration + 9.81 / 2.0 * 0.5f64.sin()).abs() < 1e-14, "{acceleration}");
    fs::write(folder.join("pendulum.txt"), PENDULUM.replace("l*[", "k*[")).unwrap();
    let output = cargo_run(&folder);
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success() && text.contains("pendulum.txt:5:30: no value is called `k`"), "{text}");
}
