//! What a run says of its inputs.

use super::{fresh, sim, stderr, stdout};
use std::fs;

/// Runs a mechanism with these options, and gives what it says of its inputs.
fn said(model: &str, name: &str, options: &[&str]) -> Option<String> {
    let directory = fresh(name);
    let first = ["run", model, "--t-end", "0.1", "--no-png", "--out", directory.to_str().unwrap()];
    let output = sim(&[&first, options].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    let line = stdout(&output).lines().find_map(|line| line.strip_prefix("inputs ").map(str::trim).map(String::from));
    fs::remove_dir_all(&directory).unwrap();
    line
}

#[test]
fn a_run_tells_how_its_inputs_are_driven() {
    let one = |options: &[&str]| said("cart-pole", "inputs-one", options);
    assert_eq!(one(&[]).unwrap(), "push as declared; `--input push=VALUE` holds it at a value");
    assert_eq!(one(&["--input", "push=2N"]).unwrap(), "push = 2 N held");
    assert_eq!(said("pendulum", "inputs-none", &[]), None);

    let file = fresh("inputs-file.mech");
    let text = "pub Pushed; coordinates { x [m]; y [m]; } parameters { m [kg] = 1; } bodies { b: mass m at [x, y]; }
        inputs { right [N] = 0; up [N] = 0; } loads { force [right, up] at [x, y]; } initial { x = 0; y = 0; }";
    fs::write(&file, text).unwrap();
    let two = |options: &[&str]| said(file.to_str().unwrap(), "inputs-two", options);
    assert_eq!(two(&[]).unwrap(), "right and 1 other as declared; `--input right=VALUE` holds one at a value");
    assert_eq!(two(&["--input", "up=3N"]).unwrap(), "up = 3 N held, others as declared");
    // What is given twice is held at the last value.
    assert_eq!(two(&["--input", "up=3N", "--input", "up=4kN"]).unwrap(), "up = 4000 N held, others as declared");
    assert_eq!(two(&["--input", "up=3N", "--input", "right=1N"]).unwrap(), "right = 1 N, up = 3 N held");
    fs::remove_file(&file).unwrap();
}
