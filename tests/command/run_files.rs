//! Run files are checked field by field: each mistake names the file and the path of the field.

use super::{fresh, scratch, sim, stderr};
use serde_json::Value;
use std::fs;

/// A whole run file with this in the place of one of its entries.
fn with(entry: &str, value: &str) -> String {
    let entries = [
        ("format", "\"linkwright run 2\""),
        ("model", "\"quick-return\""),
        ("parameters", "{\"O2A\": \"180 mm\"}"),
        ("initial", "{\"alpha_dot\": \"60 rpm\"}"),
        ("options", "{\"t-end\": 0.1, \"no-figures\": true, \"no-report\": true}"),
    ];
    let member = |(name, default): (&str, &str)| {
        let value = if name == entry { value } else { default };
        format!("\"{name}\": {value}")
    };
    format!("{{{}}}", entries.map(member).join(", "))
}

#[test]
fn every_mistake_names_its_field() {
    let place = scratch("run-files");
    let file = place.join("wrong.json");
    let path = file.to_str().unwrap();
    let fine = with("", "");
    let rows: Vec<(String, &[&str])> = vec![
        // What is no JSON.
        (String::new(), &["not JSON", "line 1"]),
        (fine[..fine.len() / 2].to_owned(), &["not JSON", "line 1"]),
        (with("parameters", "{\"O2A\": NaN}"), &["not JSON", "line 1 column"]),
        (with("parameters", "{\"O2A\": 1e999}"), &["not JSON", "out of range"]),
        (with("parameters", "{\"O2A\": 0.1, \"O2A\": 0.2}"), &["`O2A` is given twice", "column"]),
        (fine.replacen("\"format\"", "\"model\"", 1), &["`model` is given twice"]),
        // The file.
        ("[]".into(), &["a run file is an object, not a list"]),
        (fine.replacen("\"initial\"", "\"inital\"", 1), &["did you mean `initial`?"]),
        (with("format", "\"linkwright run 3\""), &["format:", "linkwright run 3", "linkwright run 2"]),
        (with("format", "1"), &["format: it is 1"]),
        ("{\"parameters\": {}}".into(), &["`model` is missing"]),
        (with("model", "3"), &["model:", "not a number"]),
        (with("model", "\"quick-retrun\""), &["no model is called", "did you mean `quick-return`?"]),
        // Parameters and start.
        (with("parameters", "[1]"), &["parameters: an object is needed, not a list"]),
        (with("parameters", "{\"O2AA\": 1}"), &["parameters.O2AA:", "did you mean `O2A`?"]),
        (with("parameters", "{\"O2A\": null}"), &["parameters.O2A:", "not null"]),
        (with("parameters", "{\"O2A\": true}"), &["parameters.O2A:", "not true or false"]),
        (with("parameters", "{\"O2A\": [1]}"), &["parameters.O2A:", "not a list"]),
        (with("parameters", "{\"O2A\": {\"m\": 1}}"), &["parameters.O2A:", "not an object"]),
        (with("parameters", "{\"O2A\": \"nan\"}"), &["parameters.O2A:", "number"]),
        (with("parameters", "{\"O2A\": \"180 kg\"}"), &["parameters.O2A:", "dimension"]),
        (with("parameters", "{\"O2A\": \"\"}"), &["parameters.O2A:", "number"]),
        (with("initial", "\"alpha\""), &["initial: an object is needed, not text"]),
        (with("initial", "{\"alhpa\": 1}"), &["initial.alhpa:", "did you mean `alpha`?"]),
        (with("initial", "{\"alpha_dot\": false}"), &["initial.alpha_dot:", "not true or false"]),
        (with("initial", "{\"alpha_dot\": \"60 m\"}"), &["initial.alpha_dot:", "dimension"]),
        // Where it comes from.
        (
            with("format", "\"linkwright run 2\", \"provenance\": \"me\""),
            &["provenance: an object is needed, not text"],
        ),
        // Options.
        (with("options", "null"), &["options: an object is needed, not null"]),
        (with("options", "{\"tend\": 1}"), &["did you mean `t-end`?"]),
        (with("options", "{\"out\": \"elsewhere\"}"), &["no option of a run file is called `out`"]),
        (with("options", "{\"t-end\": -1}"), &["options.t-end:"]),
        (with("options", "{\"t-end\": \"1 m\"}"), &["options.t-end:", "dimension"]),
        (with("options", "{\"rtol\": true}"), &["options.rtol:", "not true or false"]),
        (with("options", "{\"rtol\": 5}"), &["options.rtol:", "from 1e-14 to 0.1"]),
        (with("options", "{\"atol\": 0}"), &["options.atol:", "above 0"]),
        (with("options", "{\"steps\": 0}"), &["steps"]),
        (with("options", "{\"steps\": 1.5}"), &["options.steps:", "1.5"]),
        (with("options", "{\"rows\": \"many\"}"), &["options.rows:", "whole number"]),
        (with("options", "{\"no-figures\": \"yes\"}"), &["options.no-figures: true or false is needed, not text"]),
        (with("options", "{\"format\": [\"csv\", null]}"), &["options.format:"]),
        (with("options", "{\"format\": [\"xls\"]}"), &["options.format:", "xls"]),
    ];
    for (text, expected) in rows {
        fs::write(&file, &text).unwrap();
        let output = sim(&["run", path, "--out", place.join("never").to_str().unwrap()]);
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{text}: {said}");
        assert!(expected.iter().all(|words| said.contains(words)), "{text}: {said}");
        assert!(said.starts_with("error: ") && said.contains(path) && !said.contains("panicked"), "{text}: {said}");
        assert!(!place.join("never").exists(), "{text}");
    }
    fs::write(&file, fine).unwrap();
    let output = sim(&["run", path, "--out", place.join("fine").to_str().unwrap()]);
    assert!(output.status.success(), "{}", stderr(&output));
}

/// A run repeated from its own run file gives the same bytes in every file but that of the wall times.
#[test]
fn a_run_file_makes_its_run_again_to_the_byte() {
    let (first, second) = (fresh("asked"), fresh("from-file"));
    let settings = ["--set", "O2A=180mm", "--initial", "alpha=30deg", "--initial", "alpha_dot=70rpm"];
    let options = ["--t-end", "1.1", "--method", "dopri5", "--rtol", "1e-7", "--rows", "300", "--size", "640x400"];
    let formats = ["--format", "csv,jsonl,npy,npz", "--out", first.to_str().unwrap()];
    let output = sim(&[&["run", "quick-return"], &settings[..], &options[..], &formats[..]].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    let run_file = first.join("run.json");
    let output = sim(&["run", run_file.to_str().unwrap(), "--out", second.to_str().unwrap()]);
    assert!(output.status.success(), "{}", stderr(&output));
    let mut compared = 0;
    for entry in fs::read_dir(&first).unwrap() {
        let name = entry.unwrap().file_name();
        if name != "timing.json" {
            assert!(fs::read(first.join(&name)).unwrap() == fs::read(second.join(&name)).unwrap(), "{name:?}");
            compared += 1;
        }
    }
    // Seven figures twice, four tables, run file, summary, report.
    assert_eq!(compared, 14 + 4 + 3);

    // Words of the command line override the file's.
    let third = fresh("overridden");
    let words = ["--steps", "200", "--method", "rk4", "--no-figures", "--out", third.to_str().unwrap()];
    let output = sim(&[&["run", run_file.to_str().unwrap()], &words[..]].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    let file: Value = serde_json::from_str(&fs::read_to_string(third.join("run.json")).unwrap()).unwrap();
    assert_eq!(file["options"]["method"], "rk4");
    assert_eq!(file["options"]["steps"], 200);
    assert_eq!(file["parameters"]["O2A"], "0.18 m");
    assert!(file["options"].get("rtol").is_none());
}

#[test]
fn a_run_file_that_is_wrong_says_where() {
    let place = scratch("wrong");
    let rows = [
        ("{", "not JSON"),
        ("{\"model\": \"quick-retrun\"}", "did you mean `quick-return`?"),
        ("{\"model\": \"quick-return\", \"parameters\": {\"O2AA\": 1}}", "did you mean `O2A`?"),
        ("{\"model\": \"quick-return\", \"options\": {\"tend\": 1}}", "did you mean `t-end`?"),
    ];
    for (text, expected) in rows {
        let file = place.join("wrong.json");
        fs::write(&file, text).unwrap();
        let output = sim(&["run", file.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(stderr(&output).contains(expected), "{text}: {}", stderr(&output));
    }
    let output = sim(&["run", "nowhere.json"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("cannot read the run file nowhere.json"));
}
