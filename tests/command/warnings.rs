//! What a run says of numbers that may be wrong.

use super::{fresh, sim, stderr};
use serde_json::Value;
use std::fs;

/// The warnings in the summary of a run of a mass on a spring, with a circular frequency of 1 rad/s.
fn said(name: &str, declared: &str, options: &[&str]) -> Vec<String> {
    let folder = fresh(name);
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("mass.mech");
    let text = format!(
        "pub Mass; coordinates {{ x [um]; }} bodies {{ b: mass 1 [kg] at [x, 0]; }}
        loads {{ spring 1 [N/m], rest 0 on x; }} {declared}"
    );
    fs::write(&file, text).unwrap();
    let out = folder.join("out");
    let first = ["run", file.to_str().unwrap(), "--t-end", "10", "--no-figures", "--no-report", "--quiet"];
    let output = sim(&[&first, options, &["--out", out.to_str().unwrap()]].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    let summary: Value = serde_json::from_str(&fs::read_to_string(out.join("summary.json")).unwrap()).unwrap();
    summary["warnings"].as_array().unwrap().iter().map(|warning| warning.as_str().unwrap().to_owned()).collect()
}

/// Beside an absolute tolerance of 1e-10 m four digits of a micrometre are left.
#[test]
fn a_small_motion_without_any_length_is_told() {
    let moving = "parameters { v [um/s] = 1; } initial { x = 0; dot(x) = v; }";
    let [text] = said("no-length", moving, &[]).try_into().unwrap();
    assert!(text.contains("no parameter and no start is a length") && text.contains("`--atol 1e-16`"), "{text}");
    let none: [(&str, String, &[&str]); 5] = [
        ("finer", moving.into(), &["--atol", "1e-16"]),
        ("equal-steps", moving.into(), &["--method", "rk4", "--steps", "1000"]),
        ("start", "initial { x = 1; }".into(), &[]),
        ("parameter", moving.replace("v [", "a [um] = 1; v ["), &[]),
        ("metres", "initial { x = 0; dot(x) = 1e6; }".into(), &[]),
    ];
    for (name, declared, options) in none {
        assert_eq!(said(&format!("length-{name}"), &declared, options), [""; 0], "{name}");
    }
}
