//! Rows of tables that stand in files: `from "lift.csv"` becomes the rows in braces, before anything else is read.
//!
//! So the declaration text kept in a built mechanism needs no file.

use super::limits;
use proc_macro2::{Delimiter, Group, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use std::io::Read;
use std::path::{Path, PathBuf};
use syn::{Error, Result};

/// The folder in which the tables of a file are sought: that of the crate that a Rust file is in, of others their own.
pub fn folder_of_tables(file: &Path) -> PathBuf {
    let file = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
    let mut folders = file.ancestors().skip(1);
    let own = folders.clone().next().unwrap_or(Path::new("")).to_owned();
    let is_rust = file.extension().is_some_and(|extension| extension == "rs");
    let of_crate = folders.find(|folder| is_rust && folder.join("Cargo.toml").exists());
    of_crate.map_or(own, Path::to_owned)
}

/// Replaces the names of files, which are relative to `folder`, by their rows. Gives the names of the files too.
///
/// A row is a line of two numbers, with a comma, a semicolon, a tab or spaces between them. Empty lines and what follows a
/// `#` are left out. A first line of two words stays with the rows, because it may say units.
///
/// # Errors
/// Files that cannot be read, and lines that are no rows; declarations beyond the limits.
pub fn read_files(tokens: TokenStream, folder: &Path) -> Result<(TokenStream, Vec<String>)> {
    limits::check(tokens.clone())?;
    let mut taken = Taken { files: Vec::new(), rows: 0 };
    Ok((put_in(tokens, folder, &mut taken)?, taken.files))
}

/// The files that were read, and how many rows they have.
struct Taken {
    files: Vec<String>,
    rows: usize,
}

/// The names of the files whose rows a declaration takes, without reading them.
pub fn files_named(tokens: TokenStream) -> Vec<String> {
    let (mut names, mut follows_from) = (Vec::new(), false);
    for token in tokens {
        match &token {
            TokenTree::Literal(literal) if follows_from => names.extend(name(literal)),
            TokenTree::Group(group) => names.extend(files_named(group.stream())),
            _ => {}
        }
        follows_from = matches!(&token, TokenTree::Ident(word) if word == "from");
    }
    names
}

fn put_in(tokens: TokenStream, folder: &Path, taken: &mut Taken) -> Result<TokenStream> {
    let mut out: Vec<TokenTree> = Vec::new();
    for token in tokens {
        let follows_from = matches!(out.last(), Some(TokenTree::Ident(word)) if word == "from");
        match token {
            TokenTree::Literal(literal) if follows_from && name(&literal).is_some() => {
                let (span, name) = (literal.span(), name(&literal).unwrap_or_default());
                out.pop();
                out.push(rows(&name, folder, span, &mut taken.rows).map_err(|message| Error::new(span, message))?);
                taken.files.push(name);
            }
            TokenTree::Group(group) => {
                let before = taken.files.len();
                let mut inner = Group::new(group.delimiter(), put_in(group.stream(), folder, taken)?);
                inner.set_span(group.span());
                // Brackets without a replacement keep their places.
                out.push(TokenTree::Group(if taken.files.len() == before { group } else { inner }));
            }
            other => out.push(other),
        }
    }
    Ok(out.into_iter().collect())
}

/// The text between quotes.
fn name(literal: &Literal) -> Option<String> {
    match syn::Lit::new(literal.clone()) {
        syn::Lit::Str(text) => Some(text.value()),
        _ => None,
    }
}

/// The largest file of a table, in bytes.
const LARGEST: u64 = 16 << 20;

/// The text of a file in a folder or below, wherever links lead.
fn read(name: &str, folder: &Path) -> std::result::Result<String, String> {
    let path = folder.join(name);
    let fail = |e: std::io::Error| format!("cannot read {}: {e}", path.display());
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let (inside, folder) = (path.canonicalize().map_err(fail)?, folder.canonicalize().map_err(fail)?);
    if !inside.starts_with(&folder) {
        return Err(format!("{name} is not in {} or below: tables are read from there alone", folder.display()));
    }
    let mut text = String::new();
    let file = std::fs::File::open(&inside).map_err(fail)?;
    file.take(LARGEST + 1).read_to_string(&mut text).map_err(fail)?;
    match text.len() as u64 > LARGEST {
        true => Err(format!("{name} has more than {} MB: give fewer rows", LARGEST >> 20)),
        false => Ok(text),
    }
}

/// The rows of a file in braces, and one more for each in `count`.
fn rows(name: &str, folder: &Path, span: Span, count: &mut usize) -> std::result::Result<TokenTree, String> {
    if Path::new(name).is_absolute() {
        return Err("the path of a table's file starts at the folder of the declaration's crate or `.mech` file: `from \"data/lift.csv\"`"
            .into());
    }
    let text = read(name, folder)?;
    let mut words: Vec<TokenTree> = Vec::new();
    let mut is_first = true;
    for (at, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default().trim();
        let cells: Vec<&str> = cells(line);
        let is_name = |cell: &&str| cell.parse::<f64>().is_err();
        let is_heading = std::mem::take(&mut is_first)
            && cells.iter().all(is_name)
            && !(cells.len() == 2 && cells.iter().all(|cell| is_spoilt_number(cell)));
        match cells.as_slice() {
            [] => is_first = words.is_empty(),
            cells if is_heading => match headings(cells).as_slice() {
                [argument, value] => words.extend(row(quoted(argument), quoted(value))),
                _ if line.contains(['[', ',', ';']) => {
                    return Err(format!(
                        "{name}, line {}: a heading names the arguments and the values, as in `t [s], F [N]`; a title stands behind `#`",
                        at + 1
                    ));
                }
                _ => {}
            },
            [argument, value] => {
                *count += 1;
                limits::check_rows(*count)?;
                words.extend(row(number(argument, name, at)?, number(value, name, at)?));
            }
            cells => {
                return Err(format!(
                    "{name}, line {}: a row has two numbers, an argument and a value; this one has {}",
                    at + 1,
                    cells.len()
                ));
            }
        }
    }
    words.iter_mut().for_each(|word| word.set_span(span));
    let mut rows = Group::new(Delimiter::Brace, words.into_iter().collect());
    rows.set_span(span);
    Ok(rows.into())
}

/// Whether a cell is meant as a number, though it is none here: with another minus or a currency before it, or a unit behind it.
fn is_spoilt_number(cell: &str) -> bool {
    let digits = cell.trim_start_matches(|c: char| !c.is_alphanumeric() && c != '[');
    digits.starts_with(|c: char| c.is_ascii_digit())
}

/// The cells of a line, without the quotes that a spreadsheet may write around them, and without empty ones at its end.
fn cells(line: &str) -> Vec<&str> {
    fn bare(cell: &str) -> &str {
        cell.trim().trim_matches('"').trim()
    }
    if !line.contains([',', ';']) {
        let between: fn(char) -> bool = if line.contains('\t') { |c| c == '\t' } else { char::is_whitespace };
        return line.split(between).map(bare).filter(|cell| !cell.is_empty()).collect();
    }
    let mut cells: Vec<&str> = line.split([',', ';']).map(bare).collect();
    while cells.last().is_some_and(|cell| cell.is_empty()) {
        cells.pop();
    }
    cells
}

/// `argument, value;`
fn row(argument: Vec<TokenTree>, value: Vec<TokenTree>) -> Vec<TokenTree> {
    let mark = |of| vec![Punct::new(of, Spacing::Alone).into()];
    [argument, mark(','), value, mark(';')].concat()
}

/// The words of a heading, each with the unit that follows it.
fn headings(cells: &[&str]) -> Vec<String> {
    let mut headings: Vec<String> = Vec::new();
    for cell in cells {
        match headings.last_mut() {
            Some(before) if cell.starts_with(['[', '(']) => *before += &format!(" {cell}"),
            _ => headings.push((*cell).to_owned()),
        }
    }
    headings
}

fn quoted(heading: &str) -> Vec<TokenTree> {
    vec![Literal::string(heading).into()]
}

fn number(cell: &str, name: &str, at: usize) -> std::result::Result<Vec<TokenTree>, String> {
    match cell.parse::<f64>() {
        Ok(value) if value.is_finite() => {
            let size = Literal::f64_unsuffixed(value.abs()).into();
            let minus = value.is_sign_negative().then(|| Punct::new('-', Spacing::Alone).into());
            Ok(minus.into_iter().chain([size]).collect())
        }
        _ => Err(format!("{name}, line {}: `{cell}` is not a number", at + 1)),
    }
}
