//! Every file says where it comes from: program, version, commit, declaration, options, run.

use crate::{fresh, scratch, sim, stderr, stdout, summary};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// The hash of a shipped mechanism's declaration, from its source.
fn hash(model: &str) -> String {
    let file =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/src").join(format!("{}.rs", model.replace('-', "_")));
    let mut declarations = codegen::dsl::declarations(&fs::read_to_string(file).unwrap()).unwrap();
    codegen::dsl::hash(declarations.remove(0))
}

/// What a file of a mechanism says of itself, but for the command and the run.
fn of(model: &str) -> Value {
    let (version, commit) = (env!("CARGO_PKG_VERSION"), sim::COMMIT);
    json!({ "program": "Linkwright", "version": version, "commit": commit, "model": model, "declaration": hash(model) })
}

/// The chunks of a PNG by type.
fn chunks(png: &[u8]) -> Vec<(String, Vec<u8>)> {
    let (mut rest, mut chunks) = (&png[8..], Vec::new());
    while let Some((length, after)) = rest.split_first_chunk::<4>() {
        let (data, after) = after.split_at(4 + u32::from_be_bytes(*length) as usize);
        chunks.push((String::from_utf8(data[..4].to_vec()).unwrap(), data[4..].to_vec()));
        rest = &after[4..];
    }
    chunks
}

/// What a file says of itself; nothing where its format has no place for it.
fn said_by(path: &Path) -> Option<Value> {
    let bytes = fs::read(path).unwrap();
    let text = String::from_utf8_lossy(&bytes);
    let parsed = |text: &str| Some(serde_json::from_str(text).unwrap());
    match path.extension().unwrap().to_str().unwrap() {
        "json" => Some(serde_json::from_str::<Value>(&text).unwrap()["provenance"].take()),
        "svg" => {
            let document = roxmltree::Document::parse(&text).unwrap();
            parsed(document.descendants().find(|node| node.has_tag_name("metadata")).unwrap().text().unwrap())
        }
        "png" => {
            let chunks = chunks(&bytes);
            assert_eq!((chunks[0].0.as_str(), chunks.last().unwrap().0.as_str()), ("IHDR", "IEND"));
            let software = format!("Software\0Linkwright {}, commit {}", env!("CARGO_PKG_VERSION"), sim::COMMIT);
            assert!(chunks.contains(&("tEXt".to_owned(), software.into_bytes())));
            let comment = chunks.iter().find(|(kind, _)| kind == "iTXt").unwrap();
            parsed(std::str::from_utf8(&comment.1).unwrap().strip_prefix("Comment\0\0\0\0\0").unwrap())
        }
        "html" => {
            let meta = text.split_once("<meta name=\"provenance\" content=\"").unwrap().1;
            let footer = text.split_once("<footer>").unwrap().1.split_once("</footer>").unwrap().0;
            let seen = [sim::COMMIT, &hash("quick-return"), env!("CARGO_PKG_VERSION")];
            assert!(seen.iter().all(|words| footer.contains(words)), "{footer}");
            let meta = meta.split_once("\">").unwrap().0.replace("&quot;", "\"").replace("&gt;", ">");
            parsed(&meta)
        }
        "npz" => {
            let archive = zip::ZipArchive::new(fs::File::open(path).unwrap()).unwrap();
            parsed(std::str::from_utf8(archive.comment()).unwrap())
        }
        _ => None,
    }
}

#[test]
fn every_file_of_a_run_says_where_it_comes_from() {
    let directory = fresh("provenance");
    let words = ["run", "quick-return", "--set", "O2A=180mm", "--t-end", "0.1", "--format", "csv,npz,npy,jsonl"];
    let output = sim(&[&words[..], &["--out", directory.to_str().unwrap()]].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    let summary = summary(&directory);
    let mut expected = of("quick-return");
    expected["command"] = summary["provenance"]["command"].clone();
    expected["run"] = summary["run"].clone();
    let command = expected["command"].as_str().unwrap();
    for option in ["sim run quick-return", "--set 'O2A=0.18 m'", "--t-end '0.1 s'", "--method dop853", "--rtol 1e-10"] {
        assert!(command.contains(option), "{option}: {command}");
    }
    assert!(!command.contains("--out"), "{command}");
    let mut said = 0;
    for entry in fs::read_dir(&directory).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        match said_by(&path) {
            Some(found) => {
                assert_eq!(found, expected, "{name}");
                said += 1;
            }
            // The summary does it for them.
            None => assert!(summary["digests"][name].is_string(), "{name}"),
        }
    }
    // Three JSON files, the report, the archive, and seven figures twice.
    assert_eq!(said, 3 + 1 + 1 + 14);
}

/// Plain where nobody asks for more; with comments `plot` reads it all the same.
#[test]
fn a_table_of_text_has_comments_on_request() {
    let [plain, commented] = ["plain-csv", "commented-csv"].map(fresh);
    let run = |directory: &Path, more: &[&str]| {
        let words = ["run", "pendulum", "--t-end", "0.1", "--no-figures", "--no-report", "--out"];
        assert!(sim(&[&words[..], &[directory.to_str().unwrap()], more].concat()).status.success());
        fs::read_to_string(directory.join("trajectory.csv")).unwrap()
    };
    let (bare, text) = (run(&plain, &[]), run(&commented, &["--csv-comments"]));
    let (comments, table): (Vec<&str>, Vec<&str>) = text.lines().partition(|line| line.starts_with("# "));
    assert!(bare.starts_with("t [s],") && table == bare.lines().collect::<Vec<_>>() && text.starts_with("# "));
    let summary = summary(&commented);
    let said = |name: &str| summary["provenance"][name].as_str().unwrap();
    let line = |name: &str| format!("# {name}: {}", said(name));
    let program = format!("# Linkwright {}, commit {}", said("version"), said("commit"));
    assert_eq!(comments, [program, line("model"), line("declaration"), line("command"), line("run")]);
    assert!(said("command").contains(" --csv-comments"));
    let output = sim(&["plot", commented.to_str().unwrap(), "phi"]);
    assert!(output.status.success(), "{}", stderr(&output));
    // And what is wrong with it is told by its own line.
    let file = commented.join("damaged.csv");
    fs::write(&file, "# one\n# two\nt [s],x [m]\n0,1\n1,word\n").unwrap();
    let said = stderr(&sim(&["plot", file.to_str().unwrap(), "x"]));
    assert!(said.contains("line 5: `word` is not a number"), "{said}");
}

/// Figures of other commands, and matrices: the command is the user's own, without where to.
#[test]
fn files_of_other_commands_say_where_they_come_from() {
    let check = |path: &Path, mut expected: Value, command: &str| {
        expected["command"] = format!("sim {command}").into();
        assert_eq!(said_by(path).unwrap(), expected, "{}", path.display());
    };
    let done = |words: &str, directory: &Path| {
        let words: Vec<&str> = words.split(' ').chain(["--out", directory.to_str().unwrap()]).collect();
        let output = sim(&words);
        assert!(output.status.success(), "{}", stderr(&output));
    };
    for (command, figure) in
        [("kinematics four-bar --steps 30", "mechanism"), ("poincare pendulum --event bottom --count 3", "section_phi")]
    {
        let directory = fresh("provenance-of-others");
        done(command, &directory);
        let mut expected = of(command.split(' ').nth(1).unwrap());
        expected["run"] = summary(&directory)["run"].clone();
        for file in ["summary.json".into(), format!("{figure}.svg"), format!("{figure}.png")] {
            check(&directory.join(file), expected.clone(), command);
        }
    }
    let directory = fresh("provenance-linear");
    done("linearize pendulum", &directory);
    for file in ["linear.json", "linear.npz"] {
        check(&directory.join(file), of("pendulum"), "linearize pendulum");
    }
    let [one, other] = ["drawn-one", "drawn-other"].map(fresh);
    done("run pendulum --t-end 0.1 --no-figures --no-report", &one);
    done("run pendulum --t-end 0.2 --no-figures --no-report", &other);
    let runs = [&one, &other].map(|directory| summary(directory)["run"].as_str().unwrap().to_owned());
    let [first, second] = [&one, &other].map(|directory| directory.to_str().unwrap());
    assert!(sim(&["plot", first, "phi", "--quiet"]).status.success());
    let mut expected = of("pendulum");
    expected["run"] = runs[0].clone().into();
    check(&one.join("plot-phi.svg"), expected.clone(), "plot drawn-one phi");
    let compared = fresh("drawn-compared");
    assert!(
        sim(&["compare", first, second, "--quantity", "phi", "--out", compared.to_str().unwrap()]).status.success()
    );
    expected["run"] = runs.join(", ").into();
    check(&compared.join("phi.svg"), expected, "compare drawn-one drawn-other --quantity phi");
}

/// A run file that another declaration has written is run, and the difference told.
#[test]
fn a_run_file_of_another_declaration_is_told() {
    let directory = fresh("declared");
    let words =
        ["run", "pendulum", "--t-end", "0.1", "--no-figures", "--no-report", "--out", directory.to_str().unwrap()];
    assert!(sim(&words).status.success());
    let mut file: Value = serde_json::from_str(&fs::read_to_string(directory.join("run.json")).unwrap()).unwrap();
    let again = scratch("declared-again");
    let (path, out) = (again.join("again.json"), again.join("out"));
    let mut run = |declaration: &str, more: &[&str]| {
        file["provenance"]["declaration"] = declaration.into();
        fs::write(&path, file.to_string()).unwrap();
        let output = sim(&[&["run", path.to_str().unwrap(), "--out", out.to_str().unwrap()], more].concat());
        assert!(output.status.success(), "{}", stderr(&output));
        stderr(&output)
    };
    assert_eq!(run(&hash("pendulum"), &[]), "");
    let other = "0".repeat(32);
    let said = run(&other, &[]);
    let words =
        ["warning: ", "again.json", "another declaration of `pendulum`", &other, &hash("pendulum"), sim::COMMIT];
    assert!(words.iter().all(|words| said.contains(words)) && said.lines().count() == 1, "{said}");
    assert_eq!(run(&other, &["--quiet"]), "");
    // What wrote it now says so.
    let written: Value = serde_json::from_str(&fs::read_to_string(out.join("run.json")).unwrap()).unwrap();
    assert_eq!(written["provenance"]["declaration"], hash("pendulum"));
    // Files from before there was any are read.
    fs::write(&path, "{\"format\": \"linkwright run 1\", \"model\": \"pendulum\", \"options\": {\"t-end\": 0.1}}")
        .unwrap();
    let output = sim(&["run", path.to_str().unwrap(), "--no-figures", "--no-report", "--out", out.to_str().unwrap()]);
    assert!(output.status.success() && stderr(&output).is_empty(), "{}", stderr(&output));
}

#[test]
fn the_program_says_what_it_is() {
    let program = format!("{} (commit {})", env!("CARGO_PKG_VERSION"), sim::COMMIT);
    assert_eq!(stdout(&sim(&["--version"])), format!("sim {program}\n"));
    assert!(stdout(&sim(&["info", "quick-return"])).contains(&format!("\ndeclaration {}\n", hash("quick-return"))));
    let info: Value = serde_json::from_str(&stdout(&sim(&["info", "quick-return", "--json"]))).unwrap();
    assert_eq!(info["declaration_hash"], hash("quick-return"));
    let made = fresh("made");
    assert!(sim(&["new", made.to_str().unwrap()]).status.success());
    let manifest = fs::read_to_string(made.join("Cargo.toml")).unwrap();
    let line =
        format!("# Made by `new` of Linkwright {}, commit {}.\n[package]\n", env!("CARGO_PKG_VERSION"), sim::COMMIT);
    assert!(manifest.starts_with(&line), "{manifest}");
}

/// A saved simulation names the commit too; one that another commit has saved goes on.
#[test]
fn a_saved_simulation_names_its_commit() {
    use sim::Compiled;
    let pendulum = models::Pendulum::defaults();
    let start = sim::declared_start(&pendulum);
    let mut simulation = sim::Simulation::new(pendulum, &start, &sim::Settings::new(1.0)).unwrap();
    let saved = simulation.save();
    // A letter is a number of eight bytes.
    let word = |text: &str| text.bytes().flat_map(|letter| u64::from(letter).to_le_bytes()).collect::<Vec<u8>>();
    let at = |text: &str| saved.windows(8 * text.len()).position(|part| part == word(text)).unwrap();
    assert!(at(env!("CARGO_PKG_VERSION")) < at(&hash("pendulum")));
    let place = at(sim::COMMIT);
    let mut other = saved.clone();
    other[place] = if other[place] == b'a' { b'b' } else { b'a' };
    let content = other.len() - 8;
    let fnv = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
    let sum = other[..content].iter().fold(0xcbf2_9ce4_8422_2325, fnv);
    other[content..].copy_from_slice(&sum.to_le_bytes());
    simulation.restore(&other).unwrap();
    assert!(simulation.save() == saved && other != saved);
}
