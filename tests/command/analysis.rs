//! Commands that analyse a mechanism without running it.

use crate::{fresh, sim, stderr, stdout, summary};
use serde_json::Value;
use std::fs;
use std::path::Path;

#[test]
fn kinematics_writes_table_summary_and_figures_against_the_crank_angle() {
    let directory = fresh("kinematics");
    let out = directory.to_str().unwrap();
    let range = ["--drive", "alpha", "--from", "0", "--to", "360deg", "--speed", "75rpm", "--steps", "90"];
    let output = sim(&[&["kinematics", "quick-return", "--out", out], &range[..]].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(stdout(&output).contains("time ratio   x6: 2.735239183"), "{}", stdout(&output));
    for name in ["drive", "transmission", "ratios", "mechanism", "slider6_position"] {
        assert!(directory.join(format!("{name}.svg")).is_file() && directory.join(format!("{name}.png")).is_file());
    }
    let figure = fs::read_to_string(directory.join("slider6_position.svg")).unwrap();
    assert!(figure.contains("Angle of crank 2"));
    assert_eq!(crate::column(&directory, "drive_alpha [N*m]").len(), 91);
    assert_eq!(crate::column(&directory, "ratio_x6 [m/rad]").len(), 91);
    let summary = summary(&directory);
    assert_eq!((&summary["cycle"], &summary["limit_position"]), (&Value::Bool(true), &Value::Null));
    // Coordinates and outputs have one name on the command line: `plot` reads what was written.
    assert!(sim(&["plot", out, "drive_alpha", "--against", "alpha"]).status.success());
}

#[test]
fn a_limit_position_is_named_and_what_came_before_is_kept() {
    let directory = fresh("limit");
    let out = directory.to_str().unwrap();
    let range = ["--drive", "x", "--from", "550mm", "--to", "0.2", "--speed", "0.1", "--no-figures", "--json"];
    let output = sim(&[&["kinematics", "slider-crank", "--out", out], &range[..]].concat());
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("`x` cannot go beyond 0.298496231 m"), "{}", stderr(&output));
    let said: Value = serde_json::from_str(&stdout(&output)).unwrap();
    assert_eq!(said["drive"]["reached"], said["limit_position"]["at"]);
    assert!((said["limit_position"]["at"].as_f64().unwrap() - (0.09f64 - 0.0009).sqrt()).abs() < 1e-14);
    assert!(crate::column(&directory, "x [m]").len() > 500);
}

/// Without a speed the mechanism rests in each position.
#[test]
fn a_sweep_without_a_speed_is_static() {
    let directory = fresh("static");
    let out = directory.to_str().unwrap();
    let range = ["--drive", "x", "--from", "0.5", "--to", "0.4", "--no-figures"];
    let output = sim(&[&["kinematics", "slider-crank", "--out", out], &range[..]].concat());
    assert!(output.status.success() && stdout(&output).contains("at rest in each"), "{}", stdout(&output));
    assert!(crate::column(&directory, "theta_dot [rad/s]").iter().all(|speed| *speed == 0.0));
}

#[test]
fn what_is_wrong_with_a_sweep_is_said() {
    let rows: [(&[&str], &str); 6] = [
        (&["quick-return", "--drive", "alph"], "did you mean `alpha`"),
        (&["slider-crank", "--drive", "x"], "--from is needed for `x`"),
        (&["quick-return", "--from", "1", "--to", "1"], "nothing to drive"),
        (&["quick-return", "--speed", "3mm"], "dimension"),
        (&["quick-return", "--from", "0", "--to", "1", "--speed", "-3"], "`alpha` grows from --from to --to"),
        (&["double-pendulum", "--speed", "1"], "there are 2 of them here, and 1"),
    ];
    for (words, message) in rows {
        let output = sim(&[&["kinematics"], words].concat());
        assert!(!output.status.success() && stderr(&output).contains(message), "{words:?}: {}", stderr(&output));
    }
}

/// A negative speed alone turns the crank back, from where it is, if it is asked for and if it is that of the start.
#[test]
fn a_negative_speed_turns_back() {
    for (name, speed) in [("asked", ["--speed", "-3"]), ("begun", ["--initial", "alpha_dot=-3"])] {
        let directory = fresh(&format!("kinematics-back-{name}"));
        let out = directory.to_str().unwrap();
        let words = ["kinematics", "quick-return", "--steps", "4", "--no-report", "--no-figures", "--out", out];
        let output = sim(&[&words[..], &speed].concat());
        assert!(output.status.success(), "{}", stderr(&output));
        let angles = crate::column(&directory, "alpha [rad]");
        // A turn back, in quarters.
        let is_quarter = |pair: &[f64]| (pair[0] - pair[1] - std::f64::consts::FRAC_PI_2).abs() < 1e-12;
        assert!(angles.windows(2).all(is_quarter), "{angles:?}");
        let speeds = crate::column(&directory, "alpha_dot [rad/s]");
        assert!(speeds.iter().all(|speed| *speed == -3.0), "{speeds:?}");
    }
}

#[test]
fn branches_are_listed() {
    let output = sim(&["assemble", "four-bar", "--branches"]);
    let text = stdout(&output);
    assert!(output.status.success() && text.contains("closure_x, closure_y closes theta3, theta4: RRR dyad"), "{text}");
    assert!(text.contains("branch 1") && text.contains("branch 2") && !text.contains("branch 3"), "{text}");
    let said: Value = serde_json::from_str(&stdout(&sim(&["assemble", "four-bar", "--branches", "--json"]))).unwrap();
    assert_eq!(said["branches"].as_array().unwrap().len(), 2);
    let apart = sim(&["assemble", "four-bar", "--branches", "--set", "d=2"]);
    assert!(stdout(&apart).contains("do not reach"), "{}", stdout(&apart));
}

#[test]
fn linearize_prints_modes_and_writes_matrices() {
    let directory = fresh("linear");
    let out = directory.to_str().unwrap();
    let output = sim(&["linearize", "four-bar", "--input", "T", "--initial", "theta2=-80deg", "--out", out, "--json"]);
    assert!(output.status.success(), "{}", stderr(&output));
    let said: Value = serde_json::from_str(&stdout(&output)).unwrap();
    assert_eq!(
        (said["A"].as_array().unwrap().len(), &said["states"][0], &said["inputs"][0]),
        (2, &"theta2".into(), &"T".into())
    );
    assert!(said["modes"][0]["frequency_hz"].as_f64().unwrap() > 0.1);
    // An archive as `numpy.savez` makes them, of stored files: the header of A says its shape.
    let archive = fs::read(directory.join("linear.npz")).unwrap();
    let text = String::from_utf8_lossy(&archive);
    assert!(archive.starts_with(b"PK") && text.contains("A.npy") && text.contains("'shape': (2,2,)"));
    assert_eq!(said["outputs_without_derivative"].as_array().unwrap().len(), 0);
    let wrong = sim(&["linearize", "four-bar", "--input", "a", "--at", "initial"]);
    assert!(!wrong.status.success() && stderr(&wrong).contains("constraints depend on `a`"), "{}", stderr(&wrong));
}

/// The speed of a point has no derivative at rest: its row of C is not a number, and that is said.
#[test]
fn linearize_names_outputs_without_a_derivative() {
    let directory = fresh("linear-at-rest");
    let linearize = |more: &[&str]| {
        stdout(&sim(&[&["linearize", "double-pendulum", "--out", directory.to_str().unwrap()], more].concat()))
    };
    let text = linearize(&[]);
    assert!(text.contains("warning      speed: no derivative here"), "{text}");
    let said: Value = serde_json::from_str(&linearize(&["--json"])).unwrap();
    assert_eq!(said["outputs_without_derivative"], serde_json::json!(["speed"]));
    assert!(said["C"][2][0].is_null() && said["C"][0][0] == 1.0);
    // In motion it has one.
    assert!(!linearize(&["--at", "0.3"]).contains("warning"));
}

#[test]
fn poincare_finds_the_period_and_draws_the_section() {
    let directory = fresh("poincare");
    let out = directory.to_str().unwrap();
    let section = ["poincare", "pendulum", "--event", "bottom", "--direction", "rising", "--count", "10", "--out", out];
    let output = sim(&section);
    assert!(output.status.success(), "{}", stderr(&output));
    // 2 pi sqrt(l/g) / agm(1, cos 45 deg).
    assert!(stdout(&output).contains("period       2.36784194"), "{}", stdout(&output));
    assert!(directory.join("section_phi.png").is_file());
    assert_eq!(crate::column(&directory, "t [s]").len(), 10);
    let never = sim(&["poincare", "pendulum", "--event", "bottom", "--initial", "phi=0", "--t-end", "1", "--out", out]);
    assert!(!never.status.success() && stderr(&never).contains("has not happened"), "{}", stderr(&never));
    assert!(stderr(&sim(&["poincare", "pendulum", "--event", "botom"])).contains("did you mean `bottom`"));
}

/// A sweep begins, and holds a further degree of freedom, where the mechanism is, and not where its guesses would have it: a crank
/// of 60 mm and a rod of 150 mm carry the point at 60 sin 100 deg + 150 sin of the angle at which the rods meet.
#[test]
fn a_sweep_begins_where_the_mechanism_is() {
    let folder = fresh("begins");
    fs::create_dir_all(&folder).unwrap();
    let (file, out) = (folder.join("five.mech"), folder.join("out"));
    let five = "pub Five; coordinates { a [deg]; b [deg]; c [deg]; d [deg]; } parameters { r [mm] = 60; l [mm] = 150; f [mm] = 120; }
        let P = r*[cos(a), sin(a)] + l*[cos(c), sin(c)];
        bodies { ca: inertia 1 [kg*m^2], angle a; cb: inertia 1 [kg*m^2], angle b; pen: mass 1 [kg] at P; rod: inertia 1 [kg*m^2], angle d; }
        joints { tip: pin P to [f, 0] + r*[cos(b), sin(b)] + l*[cos(d), sin(d)]; }
        initial { a = 100; b = 80; guess c = 50; guess d = 130; }
        outputs { px [mm] = P.x; py [mm] = P.y; }";
    fs::write(&file, five).unwrap();
    let [file, out] = [&file, &out].map(|path| path.to_str().unwrap());
    let output =
        sim(&["kinematics", file, "--drive", "px", "--from", "60", "--to", "70", "--hold", "py", "--out", out]);
    assert!(output.status.success(), "{}", stderr(&output));
    // Both cranks are symmetric about x = 60 mm: the rod spans what lies between its crank and that line.
    let crank = 100f64.to_radians();
    let height = 60.0 * crank.sin() + (150f64.powi(2) - (60.0 - 60.0 * crank.cos()).powi(2)).sqrt();
    let text = fs::read_to_string(Path::new(out).join("trajectory.csv")).unwrap();
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let column = lines.next().unwrap().split(',').position(|name| name == "py [mm]").unwrap();
    for line in lines {
        let held: f64 = line.split(',').nth(column).unwrap().parse().unwrap();
        assert!((held - height).abs() < 1e-9, "{held} {height}");
    }
}
