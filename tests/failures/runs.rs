//! Motions that cannot go on.

use crate::{complete, failing, fresh, rows, stderr};

/// A run that fails with exit status 1, a message of these parts, and whole files to a time in this range.
fn check(name: &str, words: &[&str], parts: &[&str], reached: std::ops::RangeInclusive<f64>) {
    let directory = fresh(name);
    let words = [&["run"], words, &["--no-figures", "--out", directory.to_str().unwrap()]].concat();
    let output = failing(&words);
    let said = stderr(&output);
    println!("{name}: {said}");
    assert_eq!(output.status.code(), Some(1), "{said}");
    // What, and when; where, by the name of a coordinate.
    assert!(said.starts_with("error: at t = ") && said.contains(" = "), "{said}");
    for part in parts {
        assert!(said.contains(part), "`{part}` is missing: {said}");
    }
    let last = complete(&directory, &said);
    assert!(reached.contains(&last), "{last}");
    // A report of what there is.
    assert_eq!(directory.join("report.html").exists(), !rows(&directory).is_empty());
}

/// x = t + t^2/2 sqrt(1/2) at first: x = 1/2 after 0.4 s and more.
#[test]
fn a_load_that_is_no_number() {
    let parts =
        ["the equation of the acceleration of `x` is not finite", "leaves its domain", "root of a negative number"];
    check("root-rk4", &["root", "--method", "rk4", "--steps", "1000"], &parts, 0.35..=0.5);
    check("root-dop853", &["root"], &parts, 0.35..=0.5);
}

/// x'' = 100 x^3 from rest at 1: infinite after K(1/2)/10 = 0.1854 s, by the elliptic integral.
#[test]
fn a_load_that_is_infinite() {
    let parts = ["is not finite", "or the step is too large"];
    check("infinite", &["blow-up", "--method", "rk4", "--steps", "2000"], &parts, 0.17..=0.22);
}

/// The same by a method that chooses its steps, which shrink without end before that time.
#[test]
fn a_step_that_shrinks_to_nothing() {
    for method in ["dop853", "dopri5"] {
        let parts = ["the tolerance cannot be met", "the step has shrunk to", "Allow a larger tolerance"];
        check(&format!("underflow-{method}"), &["blow-up", "--method", method], &parts, 0.18..=0.186);
    }
}

/// Dry friction stops the block after pi/10 s, and its sign jumps at every step from there on.
#[test]
fn a_load_that_holds_the_motion_at_its_jump() {
    let parts = ["drives it back to the jump from both sides", "Smooth it, as `friction F, smooth v0 on x` does"];
    check("stiction", &["stiction", "--set", "friction=200", "--initial", "x=3"], &parts, 0.31..=0.32);
}

#[test]
fn a_tolerance_below_rounding() {
    let output = failing(&["run", "root", "--rtol", "1e-17"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("--rtol from 1e-14 to 0.1"), "{}", stderr(&output));
}

#[test]
fn events_that_chatter() {
    let parts = ["event `rattle` chatters", "Its condition changes faster than the motion", "make it smooth"];
    check("rattle", &["rattle", "--method", "rk4", "--steps", "100"], &parts, 0.48..=0.5);
    // The bounces of a ball accumulate at sqrt(2 h/g) (1 + e)/(1 - e) = 1.355 s.
    let parts = ["event `landing` chatters", "accumulate here", "Stop the run (`stop`)"];
    check("bounces", &["bouncing-ball", "--set", "rebound=0.5"], &parts, 1.35..=1.36);
}

#[test]
fn no_convergence() {
    let parts = ["Newton's method does not converge", "Take smaller steps"];
    check("newton", &["quick-return", "--method", "radau5", "--steps", "3"], &parts, 0.0..=1.4);
    let parts = ["the constraints could not be met: `", "Take smaller steps"];
    check("projection", &["quick-return", "--method", "rk4", "--steps", "12"], &parts, 0.1..=1.9);
}

#[test]
fn a_singular_system() {
    let parts =
        ["the equations of motion are singular: the acceleration of `y` is not determined", "needs a mass or inertia"];
    check("weightless", &["weightless"], &parts, 0.0..=0.0);
}

/// What is wrong with the start ends a run before it begins, and leaves no files.
#[test]
fn a_start_that_makes_no_sense() {
    let rows: [(&[&str], &[&str]); 4] = [
        (&["root", "--set", "m=-2"], &["the mass matrix is not positive", "moving `x`", "; `m` is -2 kg"]),
        (&["flat"], &["cannot start in a singular position", "`closure_x`", "Start beside it"]),
        (&["quick-return", "--set", "O4B=10mm"], &["cannot be assembled", "stays open by", "check the lengths"]),
        (&["quick-return", "--initial", "beta_dot=5"], &["the given speeds contradict", "Give fewer speeds"]),
    ];
    for (words, parts) in rows {
        let directory = fresh("senseless");
        let output = failing(&[&["run"], words, &["--out", directory.to_str().unwrap()]].concat());
        let said = stderr(&output);
        println!("{said}");
        assert_eq!(output.status.code(), Some(1), "{words:?}: {said}");
        assert!(parts.iter().all(|part| said.contains(part)), "{said}");
        assert!(!directory.join("trajectory.csv").exists());
    }
    // What is verified starts as what is run.
    let said = stderr(&failing(&["verify", "flat"]));
    assert!(said.contains("cannot start in a singular position"), "{said}");
    for value in ["nan", "inf", "1e999"] {
        let output = failing(&["run", "root", "--set", &format!("m={value}")]);
        assert_eq!(output.status.code(), Some(2), "{value}");
        assert!(stderr(&output).contains("m: "), "{}", stderr(&output));
    }
}
