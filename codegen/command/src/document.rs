//! Equations of motion as a standalone document.

use crate::source::Source;
use clap::ValueEnum;
use codegen::dynamics::EquationsOfMotion;
use codegen::notation::{self, Section, equations};

/// How equations are written.
#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Notation {
    Infix,
    Latex,
    Mathml,
}

/// The equations of all mechanisms of a text.
pub(crate) fn document(source: &Source, notation: Notation) -> syn::Result<String> {
    let mechanisms = source.equations()?;
    let sections =
        |write: fn(&EquationsOfMotion) -> String| mechanisms.iter().map(write).collect::<Vec<_>>().join("\n");
    Ok(match notation {
        Notation::Infix => sections(infix),
        Notation::Latex => latex(&sections(latex_section)),
        Notation::Mathml => page(&sections(page_section)),
    })
}

/// Sections with headings, and the documentation of the mechanism on top.
fn section(
    mechanism: &EquationsOfMotion,
    notation: notation::Notation,
    head: impl Fn(&str, &str) -> String,
    part: impl Fn(&Section) -> String,
) -> String {
    let model = &mechanism.model;
    let parts = equations(mechanism, notation);
    head(&model.name, &model.docs) + &parts.iter().map(part).collect::<Vec<_>>().join("\n")
}

fn infix(mechanism: &EquationsOfMotion) -> String {
    let head = |name: &str, docs: &str| {
        let docs: String = docs.lines().map(|line| format!("{line}\n")).collect();
        format!("{name}\n{}\n{docs}\n", "=".repeat(name.chars().count()))
    };
    section(mechanism, notation::Notation::Infix, head, |part| format!("# {}\n\n{}", part.title, part.text))
}

fn latex(sections: &str) -> String {
    format!(
        "\\documentclass[a4paper,10pt]{{article}}\n\
         \\usepackage[margin=15mm]{{geometry}}\n\
         \\usepackage[utf8]{{inputenc}}\n\
         \\usepackage{{amsmath}}\n\
         \\allowdisplaybreaks\n\
         \\begin{{document}}\n\n\
         {sections}\n\
         \\end{{document}}\n"
    )
}

fn latex_section(mechanism: &EquationsOfMotion) -> String {
    let head = |name: &str, docs: &str| format!("\\section*{{{}}}\n\n{}\n\n", latex_text(name), latex_text(docs));
    section(mechanism, notation::Notation::Latex, head, |part| {
        format!("\\subsection*{{{}}}\n{}", part.title, part.text)
    })
}

/// Text with LaTeX's special characters escaped.
fn latex_text(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '\\' => out += "\\textbackslash{}",
            '~' => out += "\\textasciitilde{}",
            '^' => out += "\\textasciicircum{}",
            '#' | '$' | '%' | '&' | '_' | '{' | '}' => out.extend(['\\', c]),
            _ => out.push(c),
        }
    }
    out
}

fn page(sections: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"/><title>Equations of motion</title></head>\n\
         <body>\n{sections}</body>\n</html>\n"
    )
}

fn page_section(mechanism: &EquationsOfMotion) -> String {
    let head = |name: &str, docs: &str| format!("<h1>{}</h1>\n<p>{}</p>\n", page_text(name), page_text(docs));
    section(mechanism, notation::Notation::MathMl, head, |part| format!("<h2>{}</h2>\n{}", part.title, part.text))
}

fn page_text(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
