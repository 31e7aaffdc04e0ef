//! The build scripts that find the commit: compiled alone, and run in repositories made for them.

use crate::scratch;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// A folder with packages in it.
struct Made {
    folder: PathBuf,
}

fn source(package: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().join(package).join("build.rs")
}

/// The script as a program.
fn script() -> &'static Path {
    static BUILT: OnceLock<PathBuf> = OnceLock::new();
    BUILT.get_or_init(|| {
        let script = scratch("commit").join(format!("script-{}", std::process::id()));
        let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let mut compiler = Command::new(rustc);
        compiler.args(["--edition", "2024", "-o"]).arg(&script).arg(source("sim/runtime"));
        assert!(compiler.status().unwrap().success());
        script
    })
}

impl Made {
    fn new(name: &str) -> Made {
        // Outside of this repository, which git would find otherwise.
        let folder = std::env::temp_dir().join(format!("linkwright-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        Made { folder }
    }

    /// A package where this path leads.
    fn package(&self, path: &str) {
        let folder = self.folder.join(path);
        fs::create_dir_all(folder.join("src")).unwrap();
        for (file, text) in [("Cargo.toml", ""), ("build.rs", ""), ("src/lib.rs", "")] {
            fs::write(folder.join(file), text).unwrap();
        }
    }

    fn git(&self, words: &[&str]) -> String {
        let user = ["-c", "user.name=A", "-c", "user.email=a@b.c", "-c", "commit.gpgsign=false"];
        let output = Command::new("git").args(user).args(words).current_dir(&self.folder).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap().trim().to_owned()
    }

    fn commit(&self, words: &[&str]) -> String {
        self.git(&[&["add"], words].concat());
        self.git(&["commit", "-q", "-m", "A"]);
        self.git(&["rev-parse", "HEAD"])[..12].to_owned()
    }

    /// The commit that the script of a package finds, and what has it run again.
    fn find(&self, path: &str, name: &str, variables: &[(&str, &str)]) -> (String, Vec<String>) {
        let mut script = Command::new(script());
        script.env_remove("LINKWRIGHT_COMMIT");
        script.env("CARGO_MANIFEST_DIR", self.folder.join(path)).env("CARGO_PKG_NAME", name).envs(variables.to_vec());
        let output = script.output().unwrap();
        assert!(output.status.success());
        let text = String::from_utf8(output.stdout).unwrap();
        let lines =
            |prefix: &str| text.lines().filter_map(|line| line.strip_prefix(prefix)).map(String::from).collect();
        let commits: Vec<String> = lines("cargo::rustc-env=LINKWRIGHT_COMMIT=");
        assert_eq!(commits.len(), 1, "{text}");
        (commits[0].clone(), lines("cargo::rerun-if-changed="))
    }

    fn found(&self, path: &str) -> String {
        self.find(path, "sim-runtime", &[]).0
    }
}

impl Drop for Made {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}

#[test]
fn both_packages_have_the_same_script() {
    assert_eq!(fs::read(source("sim/runtime")).unwrap(), fs::read(source("codegen/command")).unwrap());
}

/// The commit of the checkout, with a mark where sources differ; and whatever changes it has the script run again.
#[test]
fn a_checkout_is_named() {
    let made = Made::new("checkout");
    made.git(&["init", "-q"]);
    made.package("sim/runtime");
    fs::write(made.folder.join("README.md"), "").unwrap();
    let commit = made.commit(&["."]);
    assert_eq!(made.found("sim/runtime"), commit);
    fs::write(made.folder.join("README.md"), "No source.").unwrap();
    fs::write(made.folder.join("sim/runtime/src/new.rs"), "// Not tracked.").unwrap();
    assert_eq!(made.found("sim/runtime"), commit);
    fs::write(made.folder.join("sim/runtime/src/lib.rs"), "// Changed.").unwrap();
    assert_eq!(made.found("sim/runtime"), format!("{commit}-dirty"));
    let next = made.commit(&["."]);
    assert!(next != commit && made.found("sim/runtime") == next);
    let (_, watched) = made.find("sim/runtime", "sim-runtime", &[]);
    let branch = made.git(&["symbolic-ref", "HEAD"]);
    for place in [".git/HEAD", ".git/logs/HEAD", &format!(".git/{branch}"), "sim/runtime/src"] {
        assert!(
            watched.iter().any(|path| Path::new(path) == made.folder.canonicalize().unwrap().join(place)),
            "{place}: {watched:?}"
        );
    }
    // What is not there would have the script run each time.
    let is_there = |path: &String| path == "build.rs" || Path::new(path).exists();
    assert!(watched.iter().all(is_there), "{watched:?}");
}

/// What macros are made with is not built again for each commit; the command is.
#[test]
fn a_library_that_writes_no_files_is_not_named() {
    assert!(!source("codegen").exists());
    let made = Made::new("library");
    made.git(&["init", "-q"]);
    made.package("codegen");
    made.package("codegen/command");
    let commit = made.commit(&["."]);
    let find = || made.find("codegen/command", "codegen-command", &[]).0;
    assert_eq!(find(), commit);
    fs::write(made.folder.join("codegen/src/lib.rs"), "// Changed.").unwrap();
    assert_eq!(find(), format!("{commit}-dirty"));
}

/// A repository of somebody else's is not asked, whatever is in it.
#[test]
fn other_repositories_are_not_asked() {
    let made = Made::new("others");
    made.git(&["init", "-q"]);
    made.package("vendor/linkwright/sim/runtime");
    made.package("sim/runtime");
    made.commit(&["vendor"]);
    // Copied into another's tree, tracked or not; and as an archive of a registry.
    assert_eq!(made.found("vendor/linkwright/sim/runtime"), "unknown");
    assert_eq!(made.found("sim/runtime"), "unknown");
    let text = "{\n  \"git\": {\n    \"sha1\": \"0123456789abcdef0123456789abcdef01234567\"\n  },\n  \"path_in_vcs\": \"sim/runtime\"\n}";
    fs::write(made.folder.join("sim/runtime/.cargo_vcs_info.json"), text).unwrap();
    assert_eq!(made.found("sim/runtime"), "0123456789ab");
    // Nor is one that a hook names, as if what lies here were of it.
    made.commit(&["sim/runtime/Cargo.toml", "sim/runtime/build.rs"]);
    let elsewhere = Made::new("elsewhere");
    elsewhere.package("sim/runtime");
    let [repository, tree] =
        [made.folder.join(".git"), elsewhere.folder.clone()].map(|path| path.display().to_string());
    let hooked = [("GIT_DIR", repository.as_str()), ("GIT_WORK_TREE", tree.as_str())];
    assert_eq!(elsewhere.find("sim/runtime", "sim-runtime", &hooked).0, "unknown");
}

/// Without a repository the variable says it, if it says anything sensible.
#[test]
fn a_variable_stands_in() {
    let made = Made::new("variable");
    made.package("sim/runtime");
    let said = |text: &str| made.find("sim/runtime", "sim-runtime", &[("LINKWRIGHT_COMMIT", text)]).0;
    assert_eq!(said("v0.2.0-3-g0123456"), "v0.2.0-3-g0123456");
    for text in ["", "a b", "a\nb", "\u{e4}", "<script>"] {
        assert_eq!(said(text), "unknown", "{text:?}");
    }
    made.git(&["init", "-q"]);
    let commit = made.commit(&["."]);
    assert_eq!(said("other"), commit);
}
