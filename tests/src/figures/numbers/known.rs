//! Problems with known solutions, by the commands that a user gives.

use super::programs::{program, programs_are_built};
use crate::figures::Table;
use serde_json::Value;
use std::process::Command;

/// What a command is looked at for.
enum Look {
    /// The last value of a column of its table.
    Last(&'static str, f64),
    /// A row of a column, from 0.
    Row(usize, &'static str, f64),
    /// A number of its summary, by JSON pointer.
    Summary(&'static str, f64),
    /// The last value of a column, as another command has it.
    As(&'static str, &'static str),
    /// That it ends with exit status 0.
    Succeeds,
    /// That it ends with exit status 1 and says this.
    Says(&'static str),
}

/// A command, what is looked at, and how far it may be off, as a part of what is right.
type Known = (&'static str, Look, f64);

/// 1e-4 for RK4 with 400 steps a turn and more, as random linkages are held to; 1e-8 at tolerances of 1e-10 and less.
const KNOWN: &[Known] = &[
    (
        "found run engine --set r=15mm --set l=45mm --method rk4 --t-end 0.5",
        Look::As("crank_phi [rad]", "found run engine --set r=15mm --set l=45mm --rtol 1e-12 --t-end 0.5"),
        1e-4,
    ),
    ("found run four-bar-small --method rk4 --t-end 0.05", Look::Last("crank_phi [rad]", 1.73448), 1e-5),
    (
        "found run two-four-bars-free --set l=0.05 --method rk4 --t-end 0.05",
        Look::As("crank_0_phi [rad]", "found run two-four-bars-free --set l=0.05 --rtol 1e-12 --t-end 0.05"),
        1e-4,
    ),
    ("found run two-four-bars --method rk4", Look::Last("th_0 [rad]", 6.341), 1e-4),
    ("found run two-four-bars --method rk4 --steps 1500", Look::Last("th_0 [rad]", 6.341), 1e-4),
    ("found run two-four-bars --rtol 1e-14", Look::Last("th_0 [rad]", 6.341), 1e-4),
    (
        "sim run bennett --t-end 2 --method rk4 --steps 1024",
        Look::As("theta1 [rad]", "sim run bennett --t-end 2 --rtol 1e-12 --projection partitioning"),
        1e-6,
    ),
    (
        "found run bricard-joints --t-end 1 --method rk4 --steps 1024 --projection mass-projection",
        Look::As("t1 [rad]", "found run bricard-joints --t-end 1 --rtol 1e-12 --projection partitioning"),
        1e-6,
    ),
    ("sim run bennett --set speed=1", Look::Succeeds, 0.0),
    ("sim kinematics quick-return --steps 1", Look::Summary("/drives/alpha/greatest/value", 3979.0), 1e-3),
    ("sim kinematics quick-return --steps 8", Look::Summary("/drives/alpha/greatest/value", 3979.0), 1e-3),
    ("found linearize slider-crank-singular", Look::Says("singular"), 0.0),
    ("found linearize top-xyz --at initial --set th0=0 --set w3=100", Look::Succeeds, 0.0),
    (
        "found kinematics two-four-bars --drive th_0 --speed 1rad/s --steps 36",
        Look::Summary("/outputs/B0_x/greatest/value", 1.0),
        1e-9,
    ),
    // 4 sqrt(l/g) K(sin(25 deg)) for 2.2 m.
    ("found poincare swing --event period --count 10", Look::Summary("/period/seconds", 3.123_605_827_5), 1e-9),
    (
        "found run pendulum-index3 --t-end 10 --rows 11 --rtol 1e-12",
        Look::Summary("/dead_points/0/time", 2.156_515_647_5),
        1e-9,
    ),
    ("found run rhombus", Look::Says("singular"), 0.0),
    ("found run slider-crank-singular --initial theta=90deg", Look::Says("singular"), 0.0),
    (
        "found kinematics crank-shaper --drive beta --to 125deg --initial alpha=270deg --initial beta=90deg --speed 1rpm",
        Look::Succeeds,
        0.0,
    ),
    ("found run slider-crank-tiny --t-end 0.31 --rows 40", Look::Row(1, "o_N [N]", -0.18826), 1e-4),
    (
        "found run slider-crank-tiny --set r=32 --set l=50 --set e0=0 --set ph=0 --set w=1 --t-end 20 --rows 20 --method rk4 --steps 200 --projection partitioning",
        Look::Last("o_th [rad]", 13.0910),
        1e-3,
    ),
    (
        "found run spinning-brick --t-end 16 --rows 1 --method rk4 --steps 50 --projection partitioning",
        Look::Last("brick_q0", 0.4808),
        1e-3,
    ),
    (
        "found run four-bar-in-space --t-end 0.4665692828855223 --method rk4 --steps 500",
        Look::Last("o_w2 [rad/s]", -4.665),
        1e-3,
    ),
    (
        "found run four-bar-tiny --set a=0.449mm --set b=1.0388mm --set c=1.19mm --set d=0.682mm --set th2=-1.1167298032430077 --set th3=2.2189194510857866 --set th4=2.7769219586308038 --t-end 0.1",
        Look::Succeeds,
        0.0,
    ),
    ("sim kinematics bennett --from 170deg --to 179.9999deg --speed 1 --steps 2", Look::Succeeds, 0.0),
    // It leaves the wall, comes back at 0.0105 s, and is pressed against it from there on.
    ("found run bars-at-a-wall", Look::Says("at t = 0.0104"), 0.0),
];

pub(super) fn measure(table: &mut Table) {
    table.heading("Known solutions");
    if !programs_are_built() {
        return table.line("the programs to be run", "not built", "", false);
    }
    for (command, look, within) in KNOWN {
        let (said, is_met) = judged(command, look, *within);
        println!("{command}");
        table.line("", said, wanted(look), is_met);
    }
}

/// What a look should find.
fn wanted(look: &Look) -> String {
    match look {
        Look::Last(column, right) | Look::Row(_, column, right) => format!("{column} = {right}"),
        Look::Summary(pointer, right) => format!("{pointer} = {right}"),
        Look::As(column, _) => format!("{column} as a sound run has it"),
        Look::Succeeds => "exit status 0".to_owned(),
        Look::Says(words) => format!("exit status 1, saying `{words}`"),
    }
}

/// What a command gives, and whether that is what it should.
fn judged(command: &str, look: &Look, within: f64) -> (String, bool) {
    let done = match Done::of(command) {
        Ok(done) => done,
        Err(why) => return (why, false),
    };
    let near = |found: Option<f64>, right: f64| match found {
        Some(found) if done.is_success => (format!("{found:.9}"), (found - right).abs() <= within * right.abs()),
        _ => (done.first_words(), false),
    };
    match look {
        Look::Last(column, right) => near(done.column(column).and_then(|values| values.last().copied()), *right),
        Look::Row(row, column, right) => near(done.column(column).and_then(|values| values.get(*row).copied()), *right),
        Look::Summary(pointer, right) => near(done.summary.pointer(pointer).and_then(Value::as_f64), *right),
        Look::As(column, other) => match Done::of(other).map(|other| other.column(column)) {
            Ok(Some(values)) => near(
                done.column(column).and_then(|own| own.last().copied()),
                values.last().copied().unwrap_or(f64::NAN),
            ),
            _ => (format!("`{other}` gives nothing"), false),
        },
        Look::Succeeds => (done.first_words(), done.is_success),
        Look::Says(words) => (done.first_words(), !done.is_success && done.errors.contains(words)),
    }
}

/// A command that has been run.
struct Done {
    is_success: bool,
    summary: Value,
    errors: String,
    table: Vec<Vec<String>>,
}

impl Done {
    fn of(command: &str) -> Result<Done, String> {
        let mut words = command.split(' ');
        let program = program(words.next().unwrap_or_default()).map_err(|e| e.to_string())?;
        let out = std::env::temp_dir().join(format!("linkwright-figures-{}", std::process::id()));
        let mut run = Command::new("timeout");
        run.arg("60").arg(program).args(words).arg("--json").arg("--out").arg(&out);
        if !command.contains("linearize") {
            run.arg("--no-figures");
        }
        let output = run.output().map_err(|e| e.to_string())?;
        let text = std::fs::read_to_string(out.join("trajectory.csv")).unwrap_or_default();
        let row = |line: &str| line.split(',').map(str::to_owned).collect();
        let done = Done {
            is_success: output.status.success(),
            summary: serde_json::from_slice(&output.stdout).unwrap_or(Value::Null),
            errors: String::from_utf8_lossy(&output.stderr).into_owned(),
            table: text.lines().map(row).collect(),
        };
        // What is not there is not left over either.
        let _ = std::fs::remove_dir_all(&out);
        Ok(done)
    }

    fn column(&self, name: &str) -> Option<Vec<f64>> {
        let (names, rows) = self.table.split_first()?;
        let found = |cell: &String| cell == name || cell.split(" [").next() == Some(name);
        let at = names.iter().position(found)?;
        rows.iter().map(|row| row.get(at)?.parse().ok()).collect()
    }

    fn first_words(&self) -> String {
        let errors = self.errors.trim_start_matches("error: ");
        let short: String = errors.chars().take(60).collect();
        match self.is_success {
            true => "done".to_owned(),
            false => format!("refused: {}", short.trim()),
        }
    }
}
