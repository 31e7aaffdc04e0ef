//! A reader of LaTeX, as far as formulas of mechanics go.

use super::letters::{GREEK, function, taken_apart};
use super::{Names, Reader, Written};
use codegen::notation::Notation;

const READER: Reader = Reader { notation: Notation::Latex, split, value, name, matrix };

#[test]
fn latex_reads_back_as_the_graph() {
    super::every_model().iter().for_each(|equations| super::check(&READER, equations));
}

fn matrix(part: &str) -> &'static str {
    match part {
        "mass_matrix" => r"\mathbf{M}",
        "convective_forces" => r"\mathbf{h}",
        "generalized_forces" => r"\mathbf{Q}",
        "constraints" => r"\mathbf{C}",
        "constraint_jacobian" => r"\mathbf{C}_{q}",
        _ => r"\mathbf{c}",
    }
}

fn name(symbol: &str) -> String {
    let (base, dots, indices) = taken_apart(symbol);
    let letter = match (GREEK.iter().any(|(name, _)| *name == base), base.len()) {
        (true, _) => format!("\\{base}"),
        (false, 1) => base.to_owned(),
        (false, _) => format!("\\mathrm{{{base}}}"),
    };
    let dotted = match dots {
        0 => letter,
        1 => format!("\\dot{{{letter}}}"),
        _ => format!("\\ddot{{{letter}}}"),
    };
    if indices.is_empty() { dotted } else { format!("{dotted}_{{{}}}", indices.join(",")) }
}

fn split(text: &str, written: &mut Written) {
    let inner = text.strip_prefix("\\begin{align*}\n").unwrap().strip_suffix("\n\\end{align*}\n").unwrap();
    let mut equations: Vec<(String, String)> = Vec::new();
    for line in inner.split(" \\\\\n") {
        match line.trim_start().strip_prefix("&\\quad ") {
            Some(more) => equations.last_mut().unwrap().1 += more,
            None => {
                let (left, right) = line.trim_start().split_once(" &= ").unwrap();
                equations.push((left.to_owned(), right.to_owned()));
            }
        }
    }
    for (left, right) in equations {
        let Some(array) = right.strip_prefix("\\left(\\begin{array}{") else {
            assert!(written.scalars.insert(left.clone(), right).is_none(), "{left} twice");
            continue;
        };
        let (columns, rows) = array.strip_suffix("\\end{array}\\right)").unwrap().split_once('}').unwrap();
        let entries = |row: &str| row.split('&').map(|entry| entry.trim().to_owned()).collect::<Vec<_>>();
        let rows: Vec<_> = rows.split("\\\\").map(entries).collect();
        assert!(rows.iter().all(|row| row.len() == columns.len()), "{left}");
        written.matrices.insert(left, rows);
    }
}

fn value(text: &str, names: Names) -> f64 {
    let mut parser = Parser { rest: text, names };
    let value = parser.sum();
    assert!(parser.rest.trim().is_empty(), "'{}' is left of {text}", parser.rest);
    value
}

struct Parser<'a> {
    rest: &'a str,
    names: Names<'a>,
}

impl<'a> Parser<'a> {
    fn skip(&mut self, token: &str) -> bool {
        let rest = self.rest.trim_start().strip_prefix(token);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    /// The text of `{..}`.
    fn group(&mut self) -> &'a str {
        assert!(self.skip("{"), "no group before {}", self.rest);
        let mut depth = 1;
        let end = self.rest.find(|c| {
            depth += i32::from(c == '{') - i32::from(c == '}');
            depth == 0
        });
        let (group, rest) = self.rest.split_at(end.unwrap());
        self.rest = &rest[1..];
        group
    }

    fn within(&self, text: &str) -> f64 {
        value(text, self.names)
    }

    fn sum(&mut self) -> f64 {
        let mut sum = if self.skip("-") { -self.product() } else { self.product() };
        loop {
            match (self.skip("+"), self.skip("-")) {
                (true, _) => sum += self.product(),
                (_, true) => sum -= self.product(),
                _ => return sum,
            }
        }
    }

    /// Every factor after the first has a sign: a thin space or a dot.
    fn product(&mut self) -> f64 {
        let mut product = self.power();
        while self.skip("\\,") || self.skip("\\cdot") {
            product *= self.power();
        }
        product
    }

    fn power(&mut self) -> f64 {
        let base = self.atom();
        match self.skip("^") {
            true => base.powf(self.within_group()),
            false => base,
        }
    }

    fn within_group(&mut self) -> f64 {
        let group = self.group();
        self.within(group)
    }

    fn atom(&mut self) -> f64 {
        if self.skip("\\frac") {
            return self.within_group() / self.within_group();
        }
        if self.skip("\\sqrt") {
            return match self.skip("[") {
                true => {
                    let (degree, rest) = self.rest.split_once(']').unwrap();
                    self.rest = rest;
                    self.within_group().powf(1.0 / degree.parse::<f64>().unwrap())
                }
                false => self.within_group().sqrt(),
            };
        }
        for (open, close) in [("\\left(", "\\right)"), ("\\left|", "\\right|")] {
            if self.skip(open) {
                let value = self.sum();
                assert!(self.skip(close), "{}", self.rest);
                return if open == "\\left|" { value.abs() } else { value };
            }
        }
        if self.skip("\\operatorname{atan2} \\left(") {
            let y = self.sum();
            assert!(self.skip(","));
            let x = self.sum();
            assert!(self.skip("\\right)"));
            return y.atan2(x);
        }
        let functions = ["sinh", "cosh", "tanh", "sin", "cos", "tan", "arcsin", "arccos", "arctan", "ln"];
        for name in functions {
            if self.skip(&format!("\\{name}")) {
                return self.call(name);
            }
        }
        if self.skip("\\operatorname{sgn}") {
            return self.call("sgn");
        }
        self.number_or_name()
    }

    fn call(&mut self, name: &str) -> f64 {
        let exponent = if self.skip("^") { self.within_group() } else { 1.0 };
        function(name, self.atom()).powf(exponent)
    }

    fn number_or_name(&mut self) -> f64 {
        let text = self.rest.trim_start();
        let digits = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
        if digits > 0 {
            self.rest = &text[digits..];
            return text[..digits].parse().unwrap();
        }
        self.rest = text;
        let word = |c: char| !c.is_ascii_alphabetic();
        self.rest = match text.strip_prefix('\\') {
            Some(command) => &command[command.find(word).unwrap_or(command.len())..],
            None => &text[1..],
        };
        if ["\\mathrm", "\\mathbf", "\\dot", "\\ddot"].contains(&&text[..text.len() - self.rest.len()]) {
            self.group();
        }
        if self.skip("_") {
            self.group();
        }
        match &text[..text.len() - self.rest.len()] {
            "\\pi" => std::f64::consts::PI,
            "e" => std::f64::consts::E,
            name => (self.names)(name),
        }
    }
}
