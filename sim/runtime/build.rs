//! Finds the commit that is built, which stands in every file that the program writes. The packages `sim-runtime` and
//! `codegen-command` have the same script, each its own, as it is published with them.
//!
//! It is that of the checkout in which this package is a member, with `-dirty` if its sources differ from it; else the one that
//! the package was published from; else what the variable LINKWRIGHT_COMMIT says; else `unknown`. A repository of somebody
//! else's, in which this package lies or of which it is a dependency, is not asked.

use std::path::{Path, PathBuf};
use std::process::Command;

/// What is to be known of the package: its folder in the checkout, and the sources that it is made of.
fn package(name: &str) -> (&'static str, &'static [&'static str]) {
    match name {
        "codegen-command" => ("codegen/command/", &["codegen/command/src", "codegen/src"]),
        _ => (
            "sim/runtime/",
            &[
                "sim/src",
                "sim/command/src",
                "sim/command/assets",
                "sim/output/src",
                "sim/output/assets",
                "sim/runtime/src",
                "sim/import/src",
                "sim/kernel/src",
                "mechanism-macros/src",
                "codegen/src",
                "models/src",
            ],
        ),
    }
}

fn main() {
    let variable = |name: &str| std::env::var(name).unwrap_or_default();
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=LINKWRIGHT_COMMIT");
    let (folder, name) = (PathBuf::from(variable("CARGO_MANIFEST_DIR")), variable("CARGO_PKG_NAME"));
    let commit = of_checkout(&folder, &name).or_else(|| of_archive(&folder));
    let is_plain =
        |text: &String| !text.is_empty() && text.chars().all(|c| c.is_ascii_alphanumeric() || "-_.+".contains(c));
    let said = || Some(variable("LINKWRIGHT_COMMIT")).filter(is_plain);
    println!("cargo::rustc-env=LINKWRIGHT_COMMIT={}", commit.or_else(said).unwrap_or_else(|| "unknown".into()));
}

/// What git prints in a folder, whatever repository a hook that runs it may have named.
fn git(folder: &Path, words: &[&str]) -> Option<String> {
    let mut command = Command::new("git");
    for name in ["GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_COMMON_DIR", "GIT_PREFIX"] {
        command.env_remove(name);
    }
    let output = command.arg("--no-optional-locks").args(words).current_dir(folder).output().ok()?;
    let text = String::from_utf8(output.stdout).ok().filter(|_| output.status.success())?;
    Some(text.trim_end().to_owned())
}

/// The commit of the checkout, if this package is tracked there as a member of its workspace.
fn of_checkout(folder: &Path, name: &str) -> Option<String> {
    let (member, sources) = package(name);
    git(folder, &["rev-parse", "--show-prefix"]).filter(|prefix| prefix == member)?;
    git(folder, &["ls-files", "--error-unmatch", "Cargo.toml", "build.rs"])?;
    let root = PathBuf::from(git(folder, &["rev-parse", "--show-toplevel"])?);
    let commit = git(&root, &["rev-parse", "--short=12", "HEAD"])?;
    watch(&root, sources);
    let changes = git(&root, &[&["status", "--porcelain", "--untracked-files=no", "--"], sources].concat())?;
    Some(if changes.is_empty() { commit } else { commit + "-dirty" })
}

/// Has the script run again when another commit is checked out, or when a source changes.
fn watch(root: &Path, sources: &[&str]) {
    let branch = git(root, &["symbolic-ref", "-q", "HEAD"]);
    // The log changes with each commit, where a branch is packed among others.
    let names = ["HEAD", "logs/HEAD"].into_iter().chain(branch.as_deref());
    let places = names.filter_map(|name| git(root, &["rev-parse", "--git-path", name])).map(|path| root.join(path));
    // What is not there would have the script run each time.
    for path in places.chain(sources.iter().map(|source| root.join(source))).filter(|path| path.exists()) {
        println!("cargo::rerun-if-changed={}", path.display());
    }
}

/// The commit that cargo has put into the archive of a published package.
fn of_archive(folder: &Path) -> Option<String> {
    let text = std::fs::read_to_string(folder.join(".cargo_vcs_info.json")).ok()?;
    let (_, rest) = text.split_once("\"sha1\"")?;
    let commit: String = rest.chars().skip_while(|c| !c.is_ascii_hexdigit()).take(12).collect();
    (commit.len() == 12 && commit.chars().all(|c| c.is_ascii_hexdigit())).then_some(commit)
}
