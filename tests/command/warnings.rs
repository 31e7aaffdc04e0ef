//! What a run says of numbers that may be wrong.

use super::{fresh, sim, stderr};
use serde_json::Value;
use std::fs;

/// A declaration's warnings with these options.
fn warnings(name: &str, text: &str, options: &[&str]) -> Vec<String> {
    let folder = fresh(name);
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("declared.mech");
    fs::write(&file, text).unwrap();
    let out = folder.join("out");
    let first = ["run", file.to_str().unwrap(), "--no-figures", "--no-report", "--quiet"];
    let output = sim(&[&first, options, &["--out", out.to_str().unwrap()]].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    let summary: Value = serde_json::from_str(&fs::read_to_string(out.join("summary.json")).unwrap()).unwrap();
    summary["warnings"].as_array().unwrap().iter().map(|warning| warning.as_str().unwrap().to_owned()).collect()
}

/// Those of a mass on a spring, with a circular frequency of 1 rad/s.
fn said(name: &str, declared: &str, options: &[&str]) -> Vec<String> {
    let text = format!(
        "pub Mass; coordinates {{ x [um]; }} bodies {{ b: mass 1 [kg] at [x, 0]; }}
        loads {{ spring 1 [N/m], rest 0 on x; }} {declared}"
    );
    warnings(name, &text, &[&["--t-end", "10"], options].concat())
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

/// A bob whirls on a car in place of swinging, and the energy of the car hides it; a load comes to the same at each step; a free body
/// turns over at other times than it should.
#[test]
fn equal_steps_that_are_off_are_told() {
    let car = "pub Car; coordinates { X [m]; p [rad]; } bodies { car: mass 1500 [kg] at [X, 0];
        bob: mass 1 [kg] at [X, 0] + 0.01 [m]*[sin(p), -cos(p)]; } loads { gravity [0, -9.81 [m/s^2]]; }
        initial { p = 1; dot(X) = 30; }";
    let alias = "pub Alias; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; }
        loads { force 1 [N]*sin(2*pi*100 [1/s]*t) on x; }";
    let swing =
        "pub Swing; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; } loads { force -1 [N/m]*x on x; }
        initial { x = 1; }";
    let cases: [(&str, &str, &[&str], &[&str]); 6] = [
        ("heun", car, &["--t-end", "60", "--method", "heun"], &["`p` is off", "of what changes"]),
        ("rk4", car, &["--t-end", "60", "--method", "rk4"], &["`p` is off"]),
        ("fine", car, &["--t-end", "1", "--method", "rk4"], &[]),
        ("alias", alias, &["--t-end", "10", "--method", "rk4", "--steps", "1000"], &["`x` is off by 1.6e-2 m"]),
        ("phase", swing, &["--t-end", "210", "--method", "heun"], &["`x` is off"]),
        ("right", swing, &["--t-end", "210", "--method", "rk4"], &[]),
    ];
    for (name, text, options, expected) in cases {
        let found = warnings(&format!("off-{name}"), text, options);
        assert_eq!(found.len(), expected.len(), "{name}: {found:?}");
        assert!(found.iter().zip(expected).all(|(found, expected)| found.contains(expected)), "{name}: {found:?}");
    }
}

/// The force of a stiff contact goes to and fro where stability limits the steps.
#[test]
fn stiff_mechanisms_are_told() {
    let text = "pub Drop; coordinates { y [m]; } parameters { k [N/m] = 1e6; c [N*s/m] = 1e4; } bodies { b: mass 1 [kg] at [0, y]; }
        loads { gravity [0, -9.81 [m/s^2]]; force [0, max(0, -k*y - c*dot(y))*(if y < 0 then 1 else 0)] at [0, y]; }
        initial { y = 1; }";
    for (name, options, is_stiff) in [
        ("loose", ["--rtol", "1e-4"], true),
        ("default", ["--rtol", "1e-10"], true),
        ("dopri5", ["--method", "dopri5"], true),
        ("radau5", ["--method", "radau5"], false),
        ("soft", ["--set", "k=100"], false),
    ] {
        let options = [&options[..], &["--t-end", "2", "--set", if name == "soft" { "c=1" } else { "c=1e4" }]].concat();
        let found = warnings(&format!("stiff-{name}"), text, &options);
        assert_eq!(
            found.iter().any(|warning| warning.contains("the mechanism is stiff")),
            is_stiff,
            "{name}: {found:?}"
        );
    }
}

/// A small oscillation beside a large way, and one within the tolerance of angles.
#[test]
fn motions_that_tolerances_hide_are_told() {
    let beside =
        "pub Beside; coordinates { s [km]; u [mm]; } bodies { car: mass 1 [kg] at [s, 0]; bob: mass 1 [kg] at [s, u]; }
        loads { spring 100 [N/m], rest 0 on u; } initial { s = 7000; u = 1; }";
    let within = "pub Within; coordinates { p [rad]; } bodies { b: inertia 1 [kg*m^2], angle p; }
        loads { spring 100 [N*m], rest 0 on p; } initial { p = 1e-11; }";
    let locked = "pub Locked; coordinates { a [rad]; b [rad]; } parameters { off [rad] = 4e-11; }
        bodies { t: inertia 1 [kg*m^2], angle a; w: inertia 1 [kg*m^2], angle b; } constraints { held: a = off; }
        loads { spring 1 [N*m], rest 0 on b; } initial { guess a = 0; b = 1; }";
    // Errors carry it to 1.2e-10, beyond the tolerance.
    let carried = within.replace("100", "9.81");
    let cases: [(&str, &str, &[&str], &[&str]); 8] = [
        ("locked", locked, &[], &[]),
        ("far", beside, &[], &["`u` is off by"]),
        ("finer", beside, &["--atol", "1e-17"], &[]),
        ("near", beside, &["--initial", "s=0.001"], &[]),
        ("equal", beside, &["--method", "rk4", "--steps", "20000"], &[]),
        ("within", within, &[], &["`p` stays within"]),
        ("carried", &carried, &[], &["`p` stays within"]),
        ("equally", within, &["--method", "rk4", "--steps", "20000"], &[]),
    ];
    for (name, text, options, expected) in cases {
        let found = warnings(&format!("hidden-{name}"), text, &[&["--t-end", "10", "--rows", "50"], options].concat());
        assert_eq!(found.len(), expected.len(), "{name}: {found:?}");
        assert!(found.iter().zip(expected).all(|(found, expected)| found.contains(expected)), "{name}: {found:?}");
    }
}

/// A double pendulum is off by as much as it moves, after a while; without the comparison nothing is known of it.
#[test]
fn chaos_is_told() {
    let text = "pub Chaos; coordinates { a [rad]; b [rad]; } let P = 1 [m]*[sin(a), -cos(a)]; let Q = P + 1 [m]*[sin(b), -cos(b)];
        bodies { p: mass 1 [kg] at P; q: mass 1 [kg] at Q; } loads { gravity [0, -9.81 [m/s^2]]; } initial { a = 2; b = 2; }";
    for (name, options, count) in [
        ("short", &["--t-end", "2"][..], 0),
        ("long", &["--t-end", "60"], 1),
        ("not", &["--t-end", "60", "--no-comparison"], 0),
    ] {
        let found = warnings(&format!("chaos-{name}"), text, options);
        assert_eq!(found.iter().filter(|warning| warning.contains("is off by")).count(), count, "{name}: {found:?}");
    }
}
