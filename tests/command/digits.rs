//! Small numbers keep their digits where they are printed.

use super::{fresh, sim, stderr, stdout};
use std::fs;

/// What a command prints of a declaration.
fn printed(name: &str, declaration: &str, command: &str, options: &[&str]) -> String {
    let folder = fresh(name);
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("small.mech");
    fs::write(&file, declaration).unwrap();
    let out = folder.join("out");
    let first = [command, file.to_str().unwrap(), "--out", out.to_str().unwrap()];
    let output = sim(&[&first, options].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    stdout(&output)
}

/// 2 nN s down, and as much up: its multiplier is negative where the floor pushes.
#[test]
fn an_impulse_of_a_nanogram() {
    let ball = "pub Ball; coordinates { y [m]; } parameters { m [kg] = 1e-9; v [m/s] = 2; }
        bodies { ball: mass m at [0, y]; }
        constraints { floor: y = 0 initially released; }
        initial { y = 1; dot(y) = -v; }
        events { lands: y = 0 falling { impact floor restitution 1; } }";
    let text = printed("impulse", ball, "run", &["--t-end", "1", "--no-figures", "--no-report"]);
    assert!(text.contains("lands at 0.500000000000 s; impulse of floor -4.000000e-9 N*s"), "{text}");
}

/// sqrt(4e-12 N/m / 1 kg) = 2e-6 1/s, which is 3.183098862e-7 Hz.
#[test]
fn a_slow_mode() {
    let mass = "pub Slow; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; }
        loads { spring 4e-12 [N/m], rest 0 on x; } initial { x = 0; }";
    let text = printed("slow-mode", mass, "linearize", &[]);
    assert!(text.contains("(0.000000000 +2.000000000 i) e-6 1/s, 3.183098862e-7 Hz"), "{text}");
}
