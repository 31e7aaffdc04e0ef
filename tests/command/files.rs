//! Mechanisms in files: what a command does with one is what it does with a compiled one, and mistakes show at their place.

use crate::{column, fresh, sim, stderr, stdout};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const BOB: &str = "language 1;

/// A pendulum.
pub Bob;

coordinates { phi [rad]; }
parameters { l [m] = 1; m [kg] = 2; }
let P = l*[sin(phi), -cos(phi)];
bodies { bob: mass m at P; }
loads { gravity [0, -9.81 [m/s^2]]; }
initial { phi = 0.5; }
events { down: phi = 0; }
outputs { height [mm] = P.y; }
run { t_end = 300 [ms]; rtol = 1e-9; rows = 30; }
";

/// A folder with files.
pub(crate) fn folder(name: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = fresh(name);
    fs::create_dir_all(&folder).unwrap();
    files.iter().for_each(|(name, text)| fs::write(folder.join(name), text).unwrap());
    folder
}

/// Runs the binary in a folder.
pub(crate) fn within(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sim")).args(arguments).current_dir(folder).output().unwrap()
}

/// Every shipped mechanism, written to a file and run from there.
#[test]
fn files_give_the_bytes_of_compiled_mechanisms() {
    let names: Value = serde_json::from_str(&stdout(&sim(&["list", "--json"]))).unwrap();
    let folder = folder("from-files", &[]);
    for name in names.as_array().unwrap().iter().map(|each| each["name"].as_str().unwrap()) {
        let file = format!("{name}.mech");
        let made = within(&folder, &["new", "--file", &file, "--from", name]);
        assert!(made.status.success(), "{}", stderr(&made));
        let run = |model: &str, out: &str| {
            let words = ["run", model, "--out", out, "--t-end", "0.2", "--no-figures", "--no-report"];
            let output = within(&folder, &words);
            (output.status.code(), fs::read(folder.join(out).join("trajectory.csv")).unwrap())
        };
        assert!(run(&file, "read") == run(name, "compiled"), "{name}");
    }
}

/// A file of any name is read, where no mechanism of the program has that name.
#[test]
fn files_need_no_certain_name() {
    let folder = folder("any-name", &[("bob.txt", BOB), ("pendulum", BOB)]);
    let named = |file: &str| {
        let told: Value = serde_json::from_str(&stdout(&within(&folder, &["info", file, "--json"]))).unwrap();
        told["name"].clone()
    };
    assert_eq!(["bob.txt", "./pendulum", "pendulum"].map(named), ["bob", "bob", "pendulum"]);
}

/// A run file of a file makes the run again, where that file is.
#[test]
fn a_run_from_a_file_is_made_again() {
    let folder = folder("again", &[("bob.mech", BOB)]);
    let run = |words: &[&str]| {
        let output = within(&folder, words);
        assert!(output.status.success(), "{}", stderr(&output));
    };
    run(&["run", "bob.mech", "--set", "l=2", "--no-figures", "--out", "first"]);
    run(&["run", "first/run.json", "--out", "second"]);
    for file in ["trajectory.csv", "run.json", "summary.json"] {
        assert_eq!(
            fs::read(folder.join("first").join(file)).unwrap(),
            fs::read(folder.join("second").join(file)).unwrap()
        );
    }
    let elsewhere = within(&folder.join("first"), &["run", "run.json"]);
    let said = "error: run.json: model: there is no `bob.mech` here. It is named as it was when the run was made";
    assert!(elsewhere.status.code() == Some(2) && stderr(&elsewhere).starts_with(said), "{}", stderr(&elsewhere));
}

/// Columns by names and patterns, in their order, with the time; a name that no column has is refused before the run.
#[test]
fn columns_may_be_chosen() {
    let folder = folder("columns", &[("bob.mech", BOB)]);
    let run = |words: &[&str]| within(&folder, &[&["run", "--no-figures", "--no-report"], words].concat());
    let header = |out: &str| {
        let text = fs::read_to_string(folder.join(out).join("trajectory.csv")).unwrap();
        text.lines().next().unwrap().to_owned()
    };
    assert!(run(&["bob.mech", "--columns", "height,phi*t", "--out", "few"]).status.success());
    assert_eq!(header("few"), "t [s],phi_dot [rad/s],phi_ddot [rad/s^2],height [mm]");
    assert!(run(&["few/run.json", "--out", "again"]).status.success());
    assert_eq!(header("again"), header("few"));
    assert!(run(&["bob.mech", "--out", "all"]).status.success());
    assert_eq!(column(&folder.join("few"), "height [mm]"), column(&folder.join("all"), "height [mm]"));
    let refused = run(&["bob.mech", "--columns", "hieght", "--out", "none"]);
    assert!(!folder.join("none").exists() && refused.status.code() == Some(2));
    assert!(stderr(&refused).contains("no column is called `hieght` (did you mean `height`?)"), "{}", stderr(&refused));
}

/// Without PNG, those of an earlier run in the folder are gone too.
#[test]
fn figures_may_be_vectors_alone() {
    let folder = folder("vectors", &[("bob.mech", BOB)]);
    let written = |words: &[&str]| {
        let output = within(&folder, &[&["run", "bob.mech", "--no-report", "--json"], words].concat());
        assert!(output.status.success(), "{}", stderr(&output));
        let told: Value = serde_json::from_str(&stdout(&output)).unwrap();
        let names = fs::read_dir(folder.join("out/bob")).unwrap().map(|entry| entry.unwrap().file_name());
        let names: Vec<String> = names.map(|name| name.into_string().unwrap()).collect();
        let of = |extension: &str| names.iter().filter(|name| name.ends_with(extension)).count();
        (of(".svg"), of(".png"), told["files"].as_array().unwrap().len())
    };
    let (svg, png, told) = written(&[]);
    assert!(svg > 0 && png == svg, "{svg} {png}");
    assert_eq!(written(&["--no-png"]), (svg, 0, told - png));
    assert_eq!(written(&["--no-figures"]), (0, 0, told - png - svg));
}

/// The block `run` is below the command line and above the defaults.
#[test]
fn a_declaration_says_how_it_is_run() {
    let folder = folder("declared-run", &[("bob.mech", BOB)]);
    let last = |words: &[&str]| {
        let words = [&["run", "bob.mech", "--no-figures", "--no-report", "--quiet"], words].concat();
        let output = within(&folder, &words);
        assert!(output.status.success(), "{}", stderr(&output));
        let times = column(&folder.join("out/bob"), "t [s]");
        (times.len(), *times.last().unwrap())
    };
    assert_eq!(last(&[]), (31, 0.3));
    assert_eq!(last(&["--t-end", "0.2"]), (31, 0.2));
    assert_eq!(last(&["--method", "rk4", "--steps", "10"]), (31, 0.3));
    assert_eq!(last(&["--method", "rk4"]), (31, 0.3));
    let file: Value = serde_json::from_str(&fs::read_to_string(folder.join("out/bob/run.json")).unwrap()).unwrap();
    assert_eq!((&file["options"]["steps"], &file["options"]["rtol"]), (&8192.into(), &Value::Null));
    let told: Value = serde_json::from_str(&stdout(&within(&folder, &["info", "bob.mech", "--json"]))).unwrap();
    let of =
        |option: &str| told["run"].as_array().unwrap().iter().find(|each| each["option"] == option).unwrap().clone();
    assert_eq!((&of("t-end")["value"], &of("t-end")["from"]), (&"300 ms".into(), &"declaration".into()));
    assert_eq!((&of("method")["value"], &of("method")["from"]), (&"dop853".into(), &"default".into()));
}

#[test]
fn mistakes_are_shown_under_their_line() {
    let folder = folder("mistaken", &[("bob.mech", &BOB.replace("mass m at", "mass mm at"))]);
    for words in [["check", "bob.mech"], ["run", "bob.mech"], ["verify", "bob.mech"]] {
        let output = within(&folder, &words);
        assert_eq!(output.status.code(), Some(1));
        let said = stderr(&output);
        assert!(
            said.contains("\n --> bob.mech:9:20\n  |\n9 | bodies { bob: mass mm at P; }\n  |                    ^^"),
            "{said}"
        );
    }
    let output = within(&folder, &["check", "bob.mech", "--json"]);
    assert_eq!(output.status.code(), Some(1));
    let told: Value = serde_json::from_str(&stdout(&output)).unwrap();
    let mistake = &told["mistakes"][0];
    assert_eq!(mistake["code"], "E-MEANING");
    assert_eq!(mistake["range"]["start"], serde_json::json!({ "line": 8, "character": 19 }));
    assert_eq!(
        &BOB.replace("mass m at", "mass mm at")[mistake["bytes"]["start"].as_u64().unwrap() as usize..][..2],
        "mm"
    );
    fs::write(folder.join("twice.mech"), BOB.replace("l [m] = 1;", "l [m] = 1; l [m] = 2;")).unwrap();
    let said = stderr(&within(&folder, &["check", "twice.mech"]));
    assert!(said.contains("\nnote: the first definition of `l` is here\n --> twice.mech:7:14\n"), "{said}");
    let told: Value = serde_json::from_str(&stdout(&within(&folder, &["check", "twice.mech", "--json"]))).unwrap();
    let related = &told["mistakes"][0]["related"][0];
    assert_eq!(related["message"], "the first definition of `l` is here");
    assert_eq!(related["range"]["start"], serde_json::json!({ "line": 6, "character": 13 }));
    fs::write(folder.join("open.mech"), "pub Bob; coordinates { x [m];").unwrap();
    let said = stderr(&within(&folder, &["check", "open.mech"]));
    assert!(
        said.contains("a bracket, a quote or a comment is not closed") && said.contains("open.mech:1:22"),
        "{said}"
    );
    let right = within(&folder, &["new", "--file", "other.mech"]);
    assert!(right.status.success());
    let told: Value = serde_json::from_str(&stdout(&within(&folder, &["check", "other.mech", "--json"]))).unwrap();
    assert_eq!((&told["mechanisms"][0], told["mistakes"].as_array().unwrap().len()), (&"other".into(), 0));
}

#[test]
fn one_of_several_is_chosen() {
    let both = format!("mechanism! {{ {} }}\nmechanism! {{ {} }}", &BOB[12..], BOB[12..].replace("Bob", "LongBob"));
    let folder = folder("several", &[("bobs.rs", &both)]);
    let run = |model: &str| within(&folder, &["assemble", model]);
    assert!(run("bobs.rs:LongBob").status.success() && run("bobs.rs:long-bob").status.success());
    assert!(stderr(&run("bobs.rs")).contains("bobs.rs declares Bob, LongBob: choose one, as in `bobs.rs:Bob`"));
    assert!(stderr(&run("bobs.rs:Bobby")).contains("bobs.rs declares no `Bobby`, but Bob, LongBob"));
    assert!(stderr(&run("none.mech")).contains("cannot read none.mech"));
    assert_eq!(run("none.mech").status.code(), Some(1));
}

/// Tables are read from the folder of the file, and from nowhere else.
#[test]
fn tables_stand_beside_the_file() {
    let tabled = |file: &str| {
        let tables = format!("tables {{ f over [m] = linear from \"{file}\"; }}\nlet P");
        BOB.replacen("let P", &tables, 1)
    };
    let folder = folder("tabled", &[]);
    fs::create_dir_all(folder.join("inside/rows")).unwrap();
    fs::write(folder.join("inside/rows/f.csv"), "0, 0\n1, 2\n").unwrap();
    fs::write(folder.join("outside.csv"), "0, 0\n1, 2\n").unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink(folder.join("outside.csv"), folder.join("inside/link.csv")).unwrap();
    let check = |file: &str| {
        fs::write(folder.join("inside/bob.mech"), tabled(file)).unwrap();
        within(&folder, &["check", "inside/bob.mech"])
    };
    let said = check("rows/f.csv");
    assert!(said.status.success(), "{}", stderr(&said));
    for outside in ["../outside.csv", "link.csv"] {
        let said = check(outside);
        assert_eq!(said.status.code(), Some(1));
        assert!(stderr(&said).contains("or below: tables are read from there alone"), "{}", stderr(&said));
    }
}

/// A parameter that the declaration starts with acts on a run file too, except where the start was given by hand.
#[test]
fn parameters_of_a_run_file_move_its_start() {
    let text = "pub Hung; coordinates { phi [rad]; } parameters { a [deg] = 30; l [m] = 1; eta [percent] = 80; } bodies { b: mass eta
        * 1 [kg] at l*[sin(phi), -cos(phi)]; } loads { gravity [0, -9.81 [m/s^2]]; } initial { phi = a; }";
    let folder = folder("hung", &[("hung.mech", text)]);
    let first = |name: &str, words: &[&str]| {
        let more = ["--t-end", "0.1", "--rows", "1", "--no-figures", "--no-report", "--out", name];
        let output = within(&folder, &[&["run"], words, &more[..]].concat());
        assert!(output.status.success(), "{}", stderr(&output));
        column(&folder.join(name), "phi [rad]")[0]
    };
    assert!((first("a", &["hung.mech"]) - 30f64.to_radians()).abs() < 1e-15);
    assert!((first("b", &["a/run.json", "--set", "a=60deg"]) - 60f64.to_radians()).abs() < 1e-15);
    let file: Value = serde_json::from_str(&fs::read_to_string(folder.join("b/run.json")).unwrap()).unwrap();
    // Parts of a hundred are numbers, and degrees angles.
    assert_eq!(
        (&file["parameters"]["eta"], &file["parameters"]["a"]),
        (&"0.8 [1]".into(), &"1.0471975511965976 rad".into())
    );
    assert_eq!(first("e", &["b/run.json"]), first("f", &["b/run.json", "--set", "eta=80"]));
    assert_eq!(first("c", &["hung.mech", "--initial", "phi=0.25"]), 0.25);
    assert_eq!(first("d", &["c/run.json", "--set", "a=60deg"]), 0.25);
}

/// Text of a declaration stays text wherever it is shown: no file has it as markup.
#[test]
fn text_is_inert() {
    let evil = "</script><!--<script><img src=x onerror=alert(1)></text><b>";
    let text = BOB
        .replace("/// A pendulum.", &format!("/// {evil}"))
        .replace("height [mm]", &format!("/// {evil}\n group \"{evil}\" {{ /// {evil}\n height [mm]"))
        .replace("= P.y;", "= P.y; }")
        .replace("l [m] = 1", &format!("/// {evil}\n l [m] = 1"))
        .replace("{ phi [rad]; }", &format!("{{ /// {evil}\n phi [rad]; }}"));
    let folder = folder("inert", &[("bob.mech", &text)]);
    for words in [
        &["run", "bob.mech", "--out", "run"][..],
        &["kinematics", "bob.mech", "--drive", "phi", "--from", "0", "--to", "1", "--speed", "1", "--out", "swept"],
    ] {
        let output = within(&folder, words);
        assert!(output.status.success(), "{}", stderr(&output));
        for file in fs::read_dir(folder.join(words.last().unwrap())).unwrap().map(|entry| entry.unwrap().path()) {
            let extension = file.extension().unwrap();
            if extension == "html" || extension == "svg" {
                let shown = fs::read_to_string(&file).unwrap();
                let markup = ["<img", "<b>", "<!--", "</script><script", "<script><"];
                markup.iter().for_each(|markup| assert!(!shown.contains(markup), "{}: {markup}", file.display()));
            }
        }
    }
}
