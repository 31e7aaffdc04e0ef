//! Infix notation, read by a parser of its own.
//!
//! `^` binds tighter than a minus sign, and to the right; there is no sign in an exponent.

use crate::tree::{NAMES, Tree, add, call, div, mul, sub};
use codegen::symbolic::{Constant, Function};

/// The tree of a text, which must be complete and well-formed.
pub(crate) fn read(text: &str) -> Tree {
    let mut reader = Reader { rest: text };
    let tree = reader.sum();
    assert!(reader.rest.is_empty(), "'{}' is left of '{text}'", reader.rest);
    tree
}

struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    fn sum(&mut self) -> Tree {
        let mut sum = self.product();
        loop {
            if self.skip("+") {
                sum = add(sum, self.product());
            } else if self.skip("-") {
                sum = sub(sum, self.product());
            } else {
                return sum;
            }
        }
    }

    fn product(&mut self) -> Tree {
        let mut product = self.signed();
        loop {
            if self.skip("*") {
                product = mul(product, self.signed());
            } else if self.skip("/") {
                product = div(product, self.signed());
            } else {
                return product;
            }
        }
    }

    fn signed(&mut self) -> Tree {
        if !self.skip("-") {
            return self.power();
        }
        match self.signed() {
            Tree::Number(p, q) => Tree::Number(-p, q),
            tree => mul(Tree::Number(-1, 1), tree),
        }
    }

    fn power(&mut self) -> Tree {
        let base = Box::new(self.atom());
        if !self.skip("^") {
            return *base;
        }
        match self.power() {
            Tree::Number(p, q) => Tree::Power(base, p, q),
            Tree::Div(p, q) => match (*p, *q) {
                (Tree::Number(p, 1), Tree::Number(q @ 1.., 1)) => Tree::Power(base, p, q),
                (p, q) => Tree::SymbolicPower(base, div(p, q).into()),
            },
            exponent => Tree::SymbolicPower(base, exponent.into()),
        }
    }

    fn atom(&mut self) -> Tree {
        if self.skip("(") {
            let tree = self.sum();
            self.expect(")");
            return tree;
        }
        let word = self.word();
        match NAMES.iter().position(|name| *name == word) {
            Some(at) => Tree::Symbol(at),
            None if word.starts_with(|c: char| c.is_ascii_digit()) => number(word),
            None if word == "if" => self.choice(),
            None if word == "pi" => Tree::Constant(Constant::Pi),
            None if word == "e" => Tree::Constant(Constant::E),
            None => self.call(word),
        }
    }

    /// `if d > 0 then x else y`, after its first word.
    fn choice(&mut self) -> Tree {
        let difference = self.sum();
        self.expect("> 0 then");
        let above = self.sum();
        self.expect("else");
        Tree::Choice(difference.into(), above.into(), self.sum().into())
    }

    fn call(&mut self, name: &str) -> Tree {
        self.expect("(");
        let first = self.sum();
        let tree = match name {
            "sqrt" => Tree::Power(first.into(), 1, 2),
            "atan2" => {
                self.expect(",");
                Tree::Atan2(first.into(), self.sum().into())
            }
            _ => call(*Function::ALL.iter().find(|function| function.name() == name).expect(name), first),
        };
        self.expect(")");
        tree
    }

    fn word(&mut self) -> &'a str {
        let text = self.rest.trim_start();
        let end = text.find(|c: char| !c.is_ascii_alphanumeric() && c != '.').unwrap_or(text.len());
        assert!(end > 0, "a number or a name is missing before '{text}'");
        self.rest = &text[end..];
        &text[..end]
    }

    fn skip(&mut self, token: &str) -> bool {
        match self.rest.trim_start().strip_prefix(token) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn expect(&mut self, token: &str) {
        assert!(self.skip(token), "'{token}' is missing before '{}'", self.rest);
    }
}

fn number(digits: &str) -> Tree {
    match digits.parse() {
        Ok(integer) => Tree::Number(integer, 1),
        Err(_) => Tree::Decimal(digits.to_owned()),
    }
}

#[test]
fn the_reader_knows_its_precedences() {
    use crate::tree::Workspace;
    let cases = [
        ("-x^2", -9.0),
        ("2^3^2", 512.0),
        ("2 - 1 - 1", 0.0),
        ("x/2/3", 0.5),
        ("x/2*3", 4.5),
        ("-2*-x", 6.0),
        ("2^(-1)", 0.5),
        ("(1 + x)^2*y", -32.0),
        ("sqrt(z)^3 + abs(y) - w/(x*y)", 10.25),
    ];
    for (text, value) in cases {
        let tracked = Workspace::new().track(&read(text), &[3.0, -2.0, 4.0, 1.5]);
        assert_eq!(tracked.agrees(value), Some(true), "{text}");
    }
}
