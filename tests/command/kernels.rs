//! What commands tell of a mechanism's kernels: counts, parameters, values at states.

use crate::files::{folder, within};
use crate::{column, stderr, stdout};
use serde_json::{Value, json};
use std::fs;

/// Of two links, about z and y, by hand: the second one's mass, and its second moment along y, go to the first.
#[test]
fn base_parameters_are_regrouped() {
    let arm = "pub Arm; coordinates { a [rad]; b [rad]; } parameters { l [m] = 2; m [kg] = 3; }
        let A = rotation(z, a);
        let B = A*rotation(y, b);
        bodies {
            one: mass 5 [kg] at A*[1 [m], 0, 0], inertia [4 [kg*m^2], 6 [kg*m^2], 8 [kg*m^2]], attitude A;
            two: mass m at A*[l, 0, 0] + B*[0.5 [m], 0, 0], inertia [1 [kg*m^2], 2 [kg*m^2], 2.5 [kg*m^2]], attitude B;
        }
        loads { gravity [0, 0, -9.81 [m/s^2]]; }";
    let folder = folder("arm", &[("arm.mech", arm)]);
    let told: Value = serde_json::from_str(&stdout(&within(&folder, &["info", "arm.mech", "--json"]))).unwrap();
    let of = |name: &str, value: f64, unit: &str| json!({ "name": name, "value": value, "unit": unit });
    let expected = json!([
        { "coordinates": ["a"], "bodies": ["one"], "parameters": [
            of("first_moment_x", 5.0 + 3.0 * 2.0, "kg*m"),
            of("second_moment_xx", 5.0 + 5.0 + 3.0 * 4.0, "kg*m^2"),
            of("second_moment_yy", 3.0 + 0.75, "kg*m^2"),
        ] },
        { "coordinates": ["b"], "bodies": ["two"], "parameters": [
            of("first_moment_x", 3.0 * 0.5, "kg*m"),
            of("second_moment_xx", 1.75 + 3.0 * 0.25, "kg*m^2"),
            of("second_moment_zz", 0.25, "kg*m^2"),
        ] },
    ]);
    assert_eq!(told["base_parameters"], expected);
    // The kernels are those that run.
    let dynamics = told["kernels"].as_array().unwrap().iter().find(|kernel| kernel["name"] == "dynamics").unwrap();
    let counted = codegen::derive(arm.parse().unwrap()).unwrap().program;
    let counted = counted.kernels.iter().find(|kernel| kernel.id.name() == "dynamics").unwrap();
    assert_eq!(dynamics["operations"], counted.operations.total());
    assert!(
        stdout(&within(&folder, &["info", "arm.mech"]))
            .contains("h_x = 1.5 kg*m, P_xx = 2.5 kg*m^2, P_zz = 0.25 kg*m^2")
    );
}

/// A free body turned by 120 degrees, so that its axes are the world's in another order.
const BODY: &str = "body_x,body_y,body_z,body_q0,body_q1,body_q2,body_q3\n1,2,3,0.5,0.5,0.5,0.5\n";

/// Accelerations and multipliers of a run are those of the kernel at its states.
#[test]
fn kernels_are_evaluated_at_states() {
    let folder = folder("evaluated", &[]);
    let ran =
        within(&folder, &["run", "quick-return", "--t-end", "0.1", "--rows", "20", "--no-figures", "--no-report"]);
    assert!(ran.status.success());
    let states = "out/quick-return/trajectory.csv";
    let evaluate = |words: &[&str]| within(&folder, &[&["evaluate", "quick-return"], words].concat());
    let output = evaluate(&["--kernel", "dynamics", "--at", states]);
    assert!(output.status.success(), "{}", stderr(&output));
    fs::create_dir_all(folder.join("found")).unwrap();
    fs::write(folder.join("found/trajectory.csv"), &output.stdout).unwrap();
    for header in ["t [s]", "alpha_ddot [rad/s^2]", "gamma_ddot [rad/s^2]", "lambda_slot [N]"] {
        assert_eq!(column(&folder.join("found"), header), column(&folder.join("out/quick-return"), header), "{header}");
    }
    let said = |words: &[&str]| stderr(&evaluate(words));
    assert!(said(&["--kernel", "dynamic", "--at", states]).contains("did you mean `dynamics`?"));
    fs::write(folder.join("few.csv"), "alpha [deg],beta,gamma\n90,1.2,2.7\n").unwrap();
    assert!(said(&["--kernel", "dynamics", "--at", "few.csv"]).contains("`dynamics` needs the column `alpha_dot`"));
    fs::write(folder.join("twice.csv"), "alpha,beta,alpha [deg],gamma\n1,1.2,90,2.7\n").unwrap();
    assert!(said(&["--kernel", "mass_matrix", "--at", "twice.csv"]).contains("the heading has `alpha` twice"));
    fs::write(folder.join("values.csv"), "alpha,beta,gamma,O2A [m]\n1,1.2,2.7,0.2\n").unwrap();
    let given = said(&["--kernel", "mass_matrix", "--at", "values.csv"]);
    assert!(given.contains("leave its column out, and give `--set O2A=VALUE`"), "{given}");
    let without_times = "there is no column `t`: t = 0 at all states";
    assert!(said(&["--kernel", "mass_matrix", "--at", "few.csv"]).contains(without_times));
    assert!(!said(&["--kernel", "dynamics", "--at", states]).contains(without_times));
    // 90 degrees are pi/2, and the entries of a matrix have numbers.
    fs::write(
        folder.join("same.csv"),
        format!("alpha,beta,gamma\n{:?},1.2,2.7\n", 90.0 * (std::f64::consts::PI / 180.0)),
    )
    .unwrap();
    let of = |file: &str| stdout(&evaluate(&["--kernel", "mass_matrix", "--at", file]));
    assert_eq!(of("few.csv"), of("same.csv"));
    assert!(of("few.csv").starts_with("t [s],mass_matrix_1_1,mass_matrix_1_2,"));
    // So have those of a matrix of one row; what has no entries has no columns.
    let line = |model: &str, kernel: &str, states: &str| {
        fs::write(folder.join("few.csv"), states).unwrap();
        let output = within(&folder, &["evaluate", model, "--kernel", kernel, "--at", "few.csv"]);
        (stdout(&output), stderr(&output))
    };
    assert_eq!(line("pendulum", "mass_matrix", "phi\n0.5\n").0, "t [s],mass_matrix_1_1,refused\n0.0,1.0,0\n");
    assert_eq!(line("pendulum", "constraint_jacobian", "phi\n0.5\n").0, "t [s],refused\n0.0,0\n");
    let (nothing, why) = line("pendulum", "speed_mass_matrix", "phi\n0.5\n");
    assert!(nothing.is_empty() && why.contains("write `kernels { speed_mass_matrix; }` in its declaration"), "{why}");
    let (nothing, why) = line("pendulum", "sparse_linearization", "phi\n0.5\n");
    assert!(nothing.is_empty() && why.contains("ask for `constraint_jacobian`"), "{why}");
    let columns = "{\n  \"t [s]\": [\n    0.0\n  ],\n  \"mass_matrix_1_1\": [\n    1.0\n  ],\n  \"refused\": [\n    false\n  ]\n}\n";
    fs::write(folder.join("few.csv"), "t,phi\n0,0.5\n").unwrap();
    let json = ["evaluate", "pendulum", "--kernel", "mass_matrix", "--at", "few.csv", "--json"];
    assert_eq!(stdout(&within(&folder, &json)), columns);
    let body = "pub Body; bodies { body: free, mass 2, inertia [1, 2, 3]; } kernels { speed_mass_matrix; }";
    fs::write(folder.join("body.mech"), body).unwrap();
    let (found, why) = line("body.mech", "speed_mass_matrix", BODY);
    let numbers: Vec<&str> = found.lines().nth(1).map_or(vec![], |line| line.split(',').collect());
    assert_eq!(numbers.len(), 1 + 36 + 1, "{found}{why}");
    assert_eq!([1, 8, 15, 22, 29, 36].map(|i| numbers[i]), ["2.0", "2.0", "2.0", "1.0", "2.0", "3.0"]);
    let (nothing, why) = line("pendulum", "mass_matrix", "phi\n");
    assert!(nothing.is_empty() && why.contains("few.csv: no states"), "{nothing}{why}");
    fs::write(folder.join("nan.csv"), "alpha,beta,gamma\nNaN,1.2,2.7\n").unwrap();
    assert!(said(&["--kernel", "mass_matrix", "--at", "nan.csv"]).contains("`alpha`: row 1 is not finite"));
}

/// What events have set is what is linearised after them, and a time after the end of a motion is refused.
#[test]
fn events_before_the_state_count_in_its_linearisation() {
    let text = "pub Stiffened; coordinates { x [m]; } parameters { k [N/m] = 10; } bodies { p: mass 1 [kg] at [x, 0]; }
        loads { force [-k*x, 0] at [x, 0]; } initial { x = 0.3; }
        events { flip: t = 0.5 [s] rising { set k = 40; } last: t = 3 [s] rising { stop; } }";
    let folder = folder("stiffened", &[("stiffened.mech", text)]);
    let mode = |at: &str| {
        let output = within(&folder, &["linearize", "stiffened.mech", "--at", at, "--json"]);
        let said: serde_json::Value = serde_json::from_str(&stdout(&output)).unwrap_or_default();
        (said["eigenvalues"][1][1].as_f64().unwrap_or(f64::NAN), stderr(&output))
    };
    for (at, k) in [("0.4", 10.0f64), ("1", 40.0)] {
        assert!((mode(at).0.abs() - k.sqrt()).abs() < 1e-9, "{at}: {}{}", mode(at).0, mode(at).1);
    }
    assert!(mode("4").1.contains("the motion ends at t = 3"), "{}", mode("4").1);
}
