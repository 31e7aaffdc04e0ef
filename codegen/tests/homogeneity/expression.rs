//! Random expressions of a given dimension.

use crate::random::Random;
use crate::{NAMES, System};

/// Exponents of m, kg and s.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Dimension(pub(crate) [i32; 3]);

impl Dimension {
    const NONE: Dimension = Dimension([0; 3]);

    pub(crate) fn times(self, other: Dimension) -> Dimension {
        Dimension(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }

    pub(crate) fn to_the(self, exponent: i32) -> Dimension {
        Dimension(self.0.map(|e| e * exponent))
    }

    pub(crate) fn over(self, other: Dimension) -> Dimension {
        self.times(other.to_the(-1))
    }

    /// How many times larger a number of this dimension is in the system.
    pub(crate) fn size(self, system: &System) -> f64 {
        2f64.powi(self.0.iter().zip(system).map(|(e, s)| e * s).sum())
    }
}

/// ` [m^1*kg^1*s^-2]`, nothing for a pure number.
pub(crate) fn unit(of: Dimension) -> String {
    let factors: Vec<_> = ["m", "kg", "s"].iter().zip(of.0).filter(|(_, e)| *e != 0).collect();
    let factors: Vec<_> = factors.into_iter().map(|(base, e)| format!("{base}^{e}")).collect();
    if factors.is_empty() { String::new() } else { format!(" [{}]", factors.join("*")) }
}

/// An expression with its dimension. What stands around its parts is text.
#[derive(Clone)]
pub(crate) struct Expression {
    of: Dimension,
    node: Node,
}

#[derive(Clone)]
enum Node {
    Number(f64),
    Name(&'static str),
    /// Texts between, before and after the parts.
    Compound(Vec<&'static str>, Vec<Expression>),
}

impl Expression {
    /// The text, its numbers as they are in the system.
    pub(crate) fn text(&self, system: &System, with_units: bool) -> String {
        match &self.node {
            Node::Number(number) => {
                let unit = if with_units { unit(self.of) } else { String::new() };
                format!("{}{unit}", number * self.of.size(system))
            }
            Node::Name(name) => (*name).to_owned(),
            Node::Compound(texts, parts) => {
                let mut text = texts[0].to_owned();
                for (part, after) in parts.iter().zip(&texts[1..]) {
                    text += &part.text(system, with_units);
                    text += after;
                }
                text
            }
        }
    }

    fn size(&self) -> usize {
        match &self.node {
            Node::Compound(_, parts) => 1 + parts.iter().map(Expression::size).sum::<usize>(),
            _ => 1,
        }
    }
}

/// An expression of the dimension.
pub(crate) fn expression(random: &mut Random, of: Dimension, depth: u32) -> Expression {
    if depth == 0 {
        return leaf(random, of);
    }
    // What stands around the parts, and their dimensions for that of the whole and any other.
    type Form = (&'static [&'static str], fn(Dimension, Dimension) -> Vec<Dimension>);
    const EVERY: [Form; 14] = [
        (&["(", " + ", ")"], |d, _| vec![d, d]),
        (&["(", " - ", ")"], |d, _| vec![d, d]),
        (&["(", "*", ")"], |d, other| vec![other, d.over(other)]),
        (&["(", "/", ")"], |d, other| vec![d.times(other), other]),
        (&["(-", ")"], |d, _| vec![d]),
        (&["abs(", ")"], |d, _| vec![d]),
        (&["sqrt(abs(", "))"], |d, _| vec![d.to_the(2)]),
        (&["(", "^2/", ")"], |d, other| vec![other, other.to_the(2).over(d)]),
        (&["(sqrt(abs(", "))*abs(", ")^(1/2))"], |d, other| vec![other, d.to_the(2).over(other)]),
        (&["(", "^-1)"], |d, _| vec![d.to_the(-1)]),
        (&["norm([", ", ", "])"], |d, _| vec![d, d]),
        (&["inner([", ", ", "], [", ", ", "])"], |d, other| vec![other, other, d.over(other), d.over(other)]),
        (&["dot(", ")"], |d, _| vec![d.times(Dimension([0, 0, 1]))]),
        (&["inner([1, 2], ", "*[", ", ", "])"], |d, other| vec![other, d.over(other), d.over(other)]),
    ];
    const PURE: [Form; 5] = [
        (&["sin(", ")"], |d, _| vec![d]),
        (&["exp(sin(", "))"], |d, _| vec![d]),
        (&["atan(", ")"], |d, _| vec![d]),
        (&["atan2(", ", ", ")"], |_, other| vec![other, other]),
        (&["p^tanh(", ")"], |d, _| vec![d]),
    ];
    let (texts, parts) =
        if of == Dimension::NONE && random.integer(0, 2) == 0 { *random.pick(&PURE) } else { *random.pick(&EVERY) };
    let other = random.dimension();
    let parts = parts(of, other).into_iter().map(|of| expression(random, of, depth - 1)).collect();
    Expression { of, node: Node::Compound(texts.to_vec(), parts) }
}

/// A name, a number with a unit, or a product of powers.
fn leaf(random: &mut Random, of: Dimension) -> Expression {
    let names: Vec<_> = NAMES.iter().filter(|(_, dimension)| *dimension == of).collect();
    let node = match random.integer(0, 3) {
        0 => Node::Number(*random.pick(&[0.5, 0.75, 1.25, 2.0, 3.0])),
        1 | 2 if !names.is_empty() => Node::Name(random.pick(&names).0),
        _ => powers(random, of),
    };
    Expression { of, node }
}

/// `(2*x*x/m)`
fn powers(random: &mut Random, of: Dimension) -> Node {
    let number = Node::Number(random.between(0.5, 2.0));
    let (mut texts, mut parts) = (vec!["("], vec![Expression { of: Dimension::NONE, node: number }]);
    const BASES: [[&str; 2]; 3] = [["x", "l"], ["m", "m"], ["T", "t"]];
    for (at, base) in BASES.iter().enumerate() {
        let mut exponents = [0; 3];
        exponents[at] = 1;
        for _ in 0..of.0[at].abs() {
            texts.push(if of.0[at] > 0 { "*" } else { "/" });
            parts.push(Expression { of: Dimension(exponents), node: Node::Name(random.pick::<&str>(base)) });
        }
    }
    texts.push(")");
    Node::Compound(texts, parts)
}

/// The expression with one of its parts replaced by one of another dimension.
pub(crate) fn mutate(random: &mut Random, mut expression: Expression) -> Expression {
    let at = random.integer(0, expression.size() as i32 - 1) as usize;
    replace(random, &mut expression, &mut { at });
    expression
}

fn replace(random: &mut Random, part: &mut Expression, left: &mut usize) -> bool {
    if *left == 0 {
        let mut step = [0; 3];
        step[random.integer(0, 2) as usize] = *random.pick(&[-2, -1, 1, 2]);
        *part = expression(random, part.of.times(Dimension(step)), 1);
        return true;
    }
    *left -= 1;
    match &mut part.node {
        Node::Compound(_, parts) => parts.iter_mut().any(|part| replace(random, part, left)),
        _ => false,
    }
}
