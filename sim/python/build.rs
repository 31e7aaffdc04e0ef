//! Lists the shipped mechanisms with their texts, in the order in which the command line has them.

use std::fmt::Write;
use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models/src");
    let models = models.canonicalize()?;
    println!("cargo::rerun-if-changed={}", models.display());
    let library = fs::read_to_string(models.join("lib.rs"))?;
    let mut list = String::new();
    for name in library.lines().filter_map(|line| line.trim().strip_prefix("$crate::")) {
        let words = words(name.trim_end_matches(','));
        let file = models.join(words.join("_")).with_extension("rs");
        if !file.is_file() {
            return Err(io::Error::other(format!("{} declares no model", file.display())));
        }
        writeln!(list, "    text_entry({:?}, include_str!({file:?})),", words.join("-")).map_err(io::Error::other)?;
    }
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    fs::write(Path::new(&out).join("shipped.rs"), format!("&[\n{list}]\n"))
}

/// `FourBar` in two, without capitals.
fn words(name: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for letter in name.chars() {
        if letter.is_uppercase() {
            words.push(String::new());
        }
        if let Some(word) = words.last_mut() {
            word.extend(letter.to_lowercase());
        }
    }
    words
}
