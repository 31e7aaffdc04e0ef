//! The text that declares mechanisms, and where it comes from.

use anyhow::{Context, Result, anyhow};
use codegen::dsl::{folder_of_tables, read_files};
use codegen::dynamics::EquationsOfMotion;
use codegen::mistakes::located;
use proc_macro2::TokenStream;
use std::io::Read;
use std::path::{Path, PathBuf};

pub(crate) struct Source {
    /// For messages.
    name: String,
    pub(crate) text: String,
    /// The folder of the files of tables: that of the crate that a Rust file is in, the file's own, or the current one.
    pub(crate) folder: PathBuf,
}

impl Source {
    /// A file, or standard input.
    pub(crate) fn read(file: Option<&Path>) -> Result<Source> {
        match file.filter(|file| *file != Path::new("-")) {
            Some(file) => {
                let name = file.display().to_string();
                let text = std::fs::read_to_string(file).with_context(|| format!("cannot read {name}"))?;
                Ok(Source { name, text, folder: folder_of_tables(file) })
            }
            None => {
                let mut text = String::new();
                std::io::stdin().read_to_string(&mut text).context("cannot read standard input")?;
                Ok(Source { name: "<stdin>".into(), text, folder: PathBuf::new() })
            }
        }
    }

    pub(crate) fn declarations(&self) -> syn::Result<Vec<TokenStream>> {
        let declarations = codegen::dsl::declarations(&self.text)?.into_iter();
        declarations.map(|declaration| Ok(read_files(declaration, &self.folder)?.0)).collect()
    }

    /// The equations of motion of all mechanisms.
    pub(crate) fn equations(&self) -> syn::Result<Vec<EquationsOfMotion>> {
        self.declarations()?.into_iter().map(codegen::equations).collect()
    }

    /// One view of each mechanism, with an empty line between two.
    pub(crate) fn each(&self, view: &dyn Fn(TokenStream) -> syn::Result<String>) -> syn::Result<String> {
        let views: syn::Result<Vec<String>> = self.declarations()?.into_iter().map(view).collect();
        Ok(views?.join("\n"))
    }

    /// The result, or its mistakes by line and column.
    pub(crate) fn located<T>(&self, result: syn::Result<T>) -> Result<T> {
        result.map_err(|mistakes| anyhow!(located(&self.name, mistakes)))
    }
}
