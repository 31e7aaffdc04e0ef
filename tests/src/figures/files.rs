//! Mechanisms as files: the same bits without a compiler, and what that costs.

use super::{Subject, Table};
use models::QuickReturn;
use sim::{At, DeclarationFile, Erased, InPlace, Kernel, Model, Settings, States, Vectors, declared_start};
use std::hint::black_box;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tests::same_bits::{compiled, differences, interpreted};
use tests::{interleaved, shortest};

pub(super) const SUBJECTS: &[Subject] = &[
    ("bits", same_bits),
    ("process", whole_process),
    ("call", a_call),
    ("blocks", blocks),
    ("run", a_run),
    ("first", first_results),
    ("watch", watch),
];

/// Where every kernel is called.
const STATES: usize = 1000;

fn same_bits(table: &mut Table) {
    table.heading("The same bits");
    let found: Vec<String> = compiled()
        .into_iter()
        .enumerate()
        .flat_map(|(seed, compiled)| match interpreted(&*compiled) {
            Ok(interpreted) => differences(&*compiled, &*interpreted, STATES, seed as u64),
            Err(mistakes) => vec![mistakes.to_string()],
        })
        .collect();
    found.iter().for_each(|difference| println!("  {difference}"));
    table.at_most("kernels of shipped mechanisms with other bits, of 1000 states", found.len() as f64, 0.0);
    table.elsewhere("bits of runs", "cargo test --release -p tests --test results -- --ignored interpreted");
}

/// Runs of the binary, of which the median counts.
const PROCESSES: usize = 21;

fn whole_process(table: &mut Table) {
    table.heading("The whole process: read, derive, integrate, write");
    if let Err(why) = processes(table) {
        table.line("the binary", why, "measured", false);
    }
}

fn processes(table: &mut Table) -> io::Result<()> {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = workspace.join("target/figures-files");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder)?;
    let mut build = Command::new("cargo");
    succeed(build.args(["build", "--release", "--quiet", "-p", "sim"]).current_dir(&workspace))?;
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or(workspace.join("target"), PathBuf::from);
    let sim = target.join("release/sim");
    let command = |words: &[&str]| {
        let mut command = Command::new(&sim);
        command.args(words).current_dir(&folder);
        command
    };
    succeed(&mut command(&["new", "--file", "quick-return.mech", "--from", "quick-return"]))?;
    let without_png = ["run", "quick-return.mech", "--quiet", "--no-png"];
    let plain = ["run", "quick-return.mech", "--quiet", "--no-figures", "--no-report"];
    for (what, words, bound) in [
        ("no figures, no report, in ms", &plain[..], 25.0),
        ("with report and figures as SVG, in ms", &without_png, 150.0),
        ("with report and figures, PNG too, in ms", &plain[..3], 400.0),
    ] {
        let mut times = Vec::new();
        for _ in 0..PROCESSES {
            let clock = Instant::now();
            succeed(&mut command(words))?;
            times.push(milliseconds(clock.elapsed()));
        }
        times.sort_by(f64::total_cmp);
        table.at_most(&format!("sim run quick-return.mech, {what}"), times[PROCESSES / 2], bound);
    }
    Ok(())
}

fn succeed(command: &mut Command) -> io::Result<()> {
    let output = command.output()?;
    match output.status.success() {
        true => Ok(()),
        false => Err(io::Error::other(String::from_utf8_lossy(&output.stderr).into_owned())),
    }
}

fn milliseconds(time: Duration) -> f64 {
    1e3 * time.as_secs_f64()
}

/// Calls that are timed together.
const CALLS: usize = 20_000;

fn a_call(table: &mut Table) {
    table.heading("A call of quick-return's right-hand side");
    let Some([compiled, interpreted]) = quick_return(table) else { return };
    let [q, qd] = compiled.initial();
    let at = At { time: 0.1, positions: &q, speeds: &qd, accelerations: &[], multipliers: &[] };
    let calls = |model: &dyn Model| {
        let prepared = model.prepare();
        move || {
            for _ in 0..CALLS {
                prepared.call(Kernel::Dynamics, black_box(at), &mut |_, row| {
                    black_box(row);
                });
            }
        }
    };
    let (mut first, mut second) = (calls(&*compiled), calls(&*interpreted));
    let times = interleaved(15, &mut [&mut first, &mut second]);
    let [one, other] = [times[0], times[1]].map(|time| 1e9 * time.as_secs_f64() / CALLS as f64);
    table.at_most(&format!("interpreted, in ns; compiled, through the same interface {one:.0}"), other, 250.0);
}

/// States that a kernel gets at once.
const MANY: usize = 10_000;

fn blocks(table: &mut Table) {
    table.heading("quick-return's right-hand side at many states at once");
    let Some([_, interpreted]) = quick_return(table) else { return };
    let [q, qd] = interpreted.initial();
    let times: Vec<f64> = (0..MANY).map(|state| 1e-4 * state as f64).collect();
    let repeated = |numbers: &[f64]| numbers.repeat(MANY);
    let (positions, speeds) = (repeated(&q), repeated(&qd));
    let states = States { times: &times, positions: &positions, speeds: &speeds, accelerations: &[], multipliers: &[] };
    let time = shortest(25, || {
        black_box(interpreted.call_each(Kernel::Dynamics, black_box(&states)));
    });
    let (nanoseconds, vectors) = (1e9 * time.as_secs_f64() / MANY as f64, Vectors::widest());
    table.at_most(&format!("interpreted, in ns a state, with {vectors}"), nanoseconds, 20.0);
}

/// Compiled and interpreted.
fn quick_return(table: &mut Table) -> Option<[Arc<dyn Model>; 2]> {
    let compiled = sim::erase(QuickReturn::default());
    match interpreted(&*compiled) {
        Ok(interpreted) => Some([compiled, interpreted]),
        Err(mistakes) => {
            table.line("quick-return", mistakes, "read", false);
            None
        }
    }
}

fn a_run(table: &mut Table) {
    table.heading("A whole run of quick-return");
    let Some([_, interpreted]) = quick_return(table) else { return };
    let Some(interpreted) = Erased::<InPlace<8>>::new(interpreted) else { return };
    let compiled = QuickReturn::default();
    let settings = Settings::new(2.0);
    let mut first = || {
        black_box(sim::run(compiled, &declared_start(&compiled), &settings).is_ok());
    };
    let mut second = || {
        black_box(sim::run(interpreted.clone(), &declared_start(&interpreted), &settings).is_ok());
    };
    let times = interleaved(15, &mut [&mut first, &mut second]);
    let ratio = times[1].as_secs_f64() / times[0].as_secs_f64();
    table.at_most("interpreted beside its own compiled loops", ratio, 6.0);
}

fn watch(table: &mut Table) {
    table.heading("sim watch");
    let what = "from a saved file to the changed page in Chromium, median of 50, in ms";
    match saved_to_shown() {
        Ok(milliseconds) => table.at_most(what, milliseconds, 150.0),
        Err(why) => table.line(what, why, "at most 150", false),
    }
    table.elsewhere("sim watch attacked: 403, 404 or closed, nothing read", "cargo test -p sim --test command watch");
}

/// As the browser's test prints it.
fn saved_to_shown() -> io::Result<f64> {
    let mut test = Command::new("cargo");
    test.args(["test", "--release", "--quiet", "-p", "sim", "--test", "report", "saved_file_to_changed_page"]);
    test.args(["--", "--ignored", "--nocapture"]).current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."));
    let output = test.output()?;
    let printed = String::from_utf8_lossy(&output.stdout);
    let figure = printed.lines().find_map(|line| line.split_once("changed page, in ms: ")?.1.trim().parse().ok());
    figure.ok_or_else(|| io::Error::other("no figure: the test needs Chromium"))
}

/// From text to the accelerations at the declared start.
fn first_results(table: &mut Table) {
    table.heading("From text to a first result, in ms");
    let of = |name: &str| tests::shipped().into_iter().find(|description| description.name == name);
    for (name, bound) in [("andrews", 30.0), ("robot-arm", 40.0), ("stewart", 60.0)] {
        if let Some(description) = of(name) {
            first_result(table, name, description.declaration, bound);
        }
    }
    if let Some(description) = of("four-bars") {
        let forty = description.declaration.replace("const N = 3;", "const N = 40;");
        first_result(table, "40 four-bars", &forty, 200.0);
    }
}

fn first_result(table: &mut Table, name: &str, text: &str, bound: f64) {
    let mut coordinates = 0;
    let time = shortest(5, || {
        let file = DeclarationFile::of(Path::new("first.mech"), text.to_owned());
        if let Ok(model) = file.model(None) {
            let [q, qd] = model.initial();
            coordinates = q.len();
            let at = At { time: 0.0, positions: &q, speeds: &qd, accelerations: &[], multipliers: &[] };
            model.prepare().call(Kernel::Dynamics, at, &mut |_, row| {
                black_box(row);
            });
        }
    });
    table.at_most(&format!("{name}, {coordinates} coordinates"), milliseconds(time), bound);
}
