//! A reader of infix text.

use super::{Names, Reader, Written};
use codegen::notation::Notation;

const READER: Reader = Reader { notation: Notation::Infix, split, value, name: str::to_owned, matrix };

#[test]
fn infix_reads_back_as_the_graph() {
    super::every_model().iter().for_each(|equations| super::check(&READER, equations));
}

fn matrix(part: &str) -> &'static str {
    [
        "mass_matrix",
        "convective_forces",
        "generalized_forces",
        "constraints",
        "constraint_jacobian",
        "constraint_convective",
    ]
    .into_iter()
    .find(|name| *name == part)
    .unwrap()
}

/// An equation starts at the margin; a matrix ends with a bracket there.
fn split(text: &str, written: &mut Written) {
    let mut equations: Vec<String> = Vec::new();
    for line in text.lines() {
        match line.starts_with([' ', ']']) {
            true => *equations.last_mut().unwrap() += line.trim_start_matches("   "),
            false => equations.push(line.to_owned()),
        }
    }
    for equation in equations {
        let (left, right) = equation.split_once(" = ").unwrap();
        match right.strip_prefix('[').and_then(|right| right.strip_suffix(']')) {
            Some(rows) => {
                let entries = |row: &str| outside_brackets(row, ',');
                let rows = outside_brackets(rows, ';').iter().map(|row| entries(row)).collect();
                written.matrices.insert(left.to_owned(), rows);
            }
            None => assert!(written.scalars.insert(left.to_owned(), right.to_owned()).is_none(), "{left} twice"),
        }
    }
}

/// The pieces between separators that stand in no bracket.
fn outside_brackets(text: &str, separator: char) -> Vec<String> {
    let mut pieces = vec![String::new()];
    let mut depth = 0;
    for c in text.chars() {
        depth += i32::from("([".contains(c)) - i32::from(")]".contains(c));
        match c == separator && depth == 0 {
            true => pieces.push(String::new()),
            false => pieces.last_mut().unwrap().push(c),
        }
    }
    pieces.iter().map(|piece| piece.trim().to_owned()).collect()
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

impl Parser<'_> {
    fn skip(&mut self, token: &str) -> bool {
        let rest = self.rest.trim_start().strip_prefix(token);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
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

    fn product(&mut self) -> f64 {
        let mut product = self.power();
        loop {
            match (self.skip("*"), self.skip("/")) {
                (true, _) => product *= self.power(),
                (_, true) => product /= self.power(),
                _ => return product,
            }
        }
    }

    fn power(&mut self) -> f64 {
        let base = self.atom();
        if self.skip("^") { base.powf(self.power()) } else { base }
    }

    fn atom(&mut self) -> f64 {
        if self.skip("(") {
            let value = self.sum();
            assert!(self.skip(")"));
            return value;
        }
        let text = self.rest.trim_start();
        let end = text.find(|c: char| !c.is_alphanumeric() && !"._".contains(c)).unwrap_or(text.len());
        let word = &text[..end];
        self.rest = &text[end..];
        if let Ok(number) = word.parse() {
            return number;
        }
        if self.rest.starts_with('[') {
            let end = self.rest.find(']').unwrap() + 1;
            self.rest = &self.rest[end..];
            return (self.names)(&text[..text.len() - self.rest.len()]);
        }
        if self.skip("(") {
            let first = self.sum();
            let value = match word {
                "atan2" => {
                    assert!(self.skip(","));
                    first.atan2(self.sum())
                }
                name => super::letters::function(name, first),
            };
            assert!(self.skip(")"));
            return value;
        }
        match word {
            "pi" => std::f64::consts::PI,
            "e" => std::f64::consts::E,
            name => (self.names)(name),
        }
    }
}
