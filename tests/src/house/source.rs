//! The modules of a crate and their tokens.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// A module that is a file.
#[derive(Clone, Debug)]
pub struct Module {
    /// Where it is.
    pub file: PathBuf,
    /// How many lines it has.
    pub lines: usize,
    /// Its tokens, without modules of tests.
    pub tokens: Vec<TokenTree>,
}

/// The modules of a crate by their paths, `state::settings`; that of the root is empty.
#[derive(Clone, Debug, Default)]
pub struct Source {
    /// By path.
    pub modules: BTreeMap<String, Module>,
}

impl Source {
    /// All modules below a folder, in which the root is `lib.rs`.
    ///
    /// # Errors
    /// Those of the file system; `InvalidData` for what is no Rust.
    pub fn read(folder: &Path) -> io::Result<Source> {
        let mut source = Source::default();
        source.add(folder, folder)?;
        Ok(source)
    }

    /// A crate that is given as text, for tests.
    ///
    /// # Errors
    /// `InvalidData` for what is no Rust.
    pub fn of(texts: &[(&str, &str)]) -> io::Result<Source> {
        let mut source = Source::default();
        for (path, text) in texts {
            source.modules.insert((*path).to_owned(), module(PathBuf::from(*path), text)?);
        }
        Ok(source)
    }

    fn add(&mut self, root: &Path, folder: &Path) -> io::Result<()> {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            if path.is_dir() {
                self.add(root, &path)?;
            } else if path.extension().is_some_and(|extension| extension == "rs") && !path.ends_with("main.rs") {
                let text = fs::read_to_string(&path)?;
                self.modules.insert(name(root, &path), module(path, &text)?);
            }
        }
        Ok(())
    }
}

/// The path of the module in a file.
fn name(root: &Path, file: &Path) -> String {
    let inside = file.strip_prefix(root).unwrap_or(file).with_extension("");
    let mut parts: Vec<String> = inside.iter().map(|part| part.to_string_lossy().into_owned()).collect();
    if parts.last().is_some_and(|last| last == "mod" || last == "lib") {
        parts.pop();
    }
    parts.join("::")
}

fn module(file: PathBuf, text: &str) -> io::Result<Module> {
    let tokens: TokenStream = text
        .parse()
        .map_err(|error| io::Error::new(io::ErrorKind::InvalidData, format!("{}: {error}", file.display())))?;
    Ok(Module { lines: text.lines().count(), tokens: without_tests(tokens), file })
}

/// The tokens but for `#[cfg(test)] mod name { .. }`.
fn without_tests(tokens: TokenStream) -> Vec<TokenTree> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let (mut kept, mut i) = (Vec::new(), 0);
    while i < tokens.len() {
        let is_of_tests = tokens[i].to_string() == "#"
            && tokens.get(i + 1).is_some_and(|attribute| attribute.to_string().replace(' ', "") == "[cfg(test)]")
            && tokens.get(i + 2).is_some_and(|word| word.to_string() == "mod");
        if is_of_tests
            && matches!(&tokens.get(i + 4), Some(TokenTree::Group(body)) if body.delimiter() == Delimiter::Brace)
        {
            i += 5;
        } else {
            kept.push(tokens[i].clone());
            i += 1;
        }
    }
    kept
}
