//! The build scripts that find the commit: compiled alone, and run in repositories made for them.

use crate::fresh;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A folder with the sources of a package in it, and the script as a program.
struct Made {
    folder: PathBuf,
    script: PathBuf,
}

fn source(package: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().join(package).join("build.rs")
}

impl Made {
    fn new(name: &str) -> Made {
        // Outside of this repository, which git would find otherwise.
        let folder = std::env::temp_dir().join(format!("linkwright-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        let built = fresh(name);
        fs::create_dir_all(&built).unwrap();
        let script = built.join("script");
        let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let mut compiler = Command::new(rustc);
        compiler.args(["--edition", "2024", "-o"]).arg(&script).arg(source("sim"));
        assert!(compiler.status().unwrap().success());
        Made { folder, script }
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
        let mut script = Command::new(&self.script);
        script.env_remove("LINKWRIGHT_COMMIT").env_remove("CARGO_FEATURE_COMMAND");
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
        self.find(path, "sim", &[]).0
    }
}

impl Drop for Made {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}

#[test]
fn both_packages_have_the_same_script() {
    assert_eq!(fs::read(source("sim")).unwrap(), fs::read(source("codegen")).unwrap());
}

/// The commit of the checkout, with a mark where sources differ; and whatever changes it has the script run again.
#[test]
fn a_checkout_is_named() {
    let made = Made::new("checkout");
    made.git(&["init", "-q"]);
    made.package("sim");
    fs::write(made.folder.join("README.md"), "").unwrap();
    let commit = made.commit(&["."]);
    assert_eq!(made.found("sim"), commit);
    fs::write(made.folder.join("README.md"), "No source.").unwrap();
    fs::write(made.folder.join("sim/src/new.rs"), "// Not tracked.").unwrap();
    assert_eq!(made.found("sim"), commit);
    fs::write(made.folder.join("sim/src/lib.rs"), "// Changed.").unwrap();
    assert_eq!(made.found("sim"), format!("{commit}-dirty"));
    let next = made.commit(&["."]);
    assert!(next != commit && made.found("sim") == next);
    let (_, watched) = made.find("sim", "sim", &[]);
    let branch = made.git(&["symbolic-ref", "HEAD"]);
    for place in [".git/HEAD", ".git/logs/HEAD", &format!(".git/{branch}"), "sim/src"] {
        assert!(
            watched.iter().any(|path| Path::new(path) == made.folder.canonicalize().unwrap().join(place)),
            "{place}: {watched:?}"
        );
    }
    // Whoever makes a macro only is not built again for each commit.
    assert_eq!(made.find("sim", "codegen", &[]), ("unknown".into(), vec!["build.rs".into()]));
}

/// A repository of somebody else's is not asked, whatever is in it.
#[test]
fn other_repositories_are_not_asked() {
    let made = Made::new("others");
    made.git(&["init", "-q"]);
    made.package("vendor/linkwright/sim");
    made.package("sim");
    made.commit(&["vendor"]);
    // Copied into another's tree, tracked or not; and as an archive of a registry.
    assert_eq!(made.found("vendor/linkwright/sim"), "unknown");
    assert_eq!(made.found("sim"), "unknown");
    let text = "{\n  \"git\": {\n    \"sha1\": \"0123456789abcdef0123456789abcdef01234567\"\n  },\n  \"path_in_vcs\": \"sim\"\n}";
    fs::write(made.folder.join("sim/.cargo_vcs_info.json"), text).unwrap();
    assert_eq!(made.found("sim"), "0123456789ab");
    // Nor is one that a hook names.
    let hooked = [("GIT_DIR", made.folder.join(".git").to_str().unwrap().to_owned())];
    let hooked: Vec<(&str, &str)> = hooked.iter().map(|(name, value)| (*name, value.as_str())).collect();
    let elsewhere = Made::new("elsewhere");
    elsewhere.package("sim");
    assert_eq!(elsewhere.find("sim", "sim", &hooked).0, "unknown");
}

/// Without a repository the variable says it, if it says anything sensible.
#[test]
fn a_variable_stands_in() {
    let made = Made::new("variable");
    made.package("sim");
    let said = |text: &str| made.find("sim", "sim", &[("LINKWRIGHT_COMMIT", text)]).0;
    assert_eq!(said("v0.2.0-3-g0123456"), "v0.2.0-3-g0123456");
    for text in ["", "a b", "a\nb", "\u{e4}", "<script>"] {
        assert_eq!(said(text), "unknown", "{text:?}");
    }
    made.git(&["init", "-q"]);
    let commit = made.commit(&["."]);
    assert_eq!(said("other"), commit);
}
