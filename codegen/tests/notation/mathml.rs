//! A reader of XML and of the MathML in it.

use super::letters::{GREEK, function, taken_apart};
use super::{Names, Reader, Written};
use codegen::notation::{Notation, equations};

const READER: Reader = Reader { notation: Notation::MathMl, split, value, name, matrix };

#[test]
fn mathml_reads_back_as_the_graph() {
    super::every_model().iter().for_each(|equations| super::check(&READER, equations));
}

#[test]
fn every_part_is_one_well_formed_element() {
    for model in super::every_model() {
        for part in equations(&model, Notation::MathMl) {
            let element = parse(part.text.trim());
            assert_eq!(element.name, "math", "{}", part.name);
        }
    }
}

fn matrix(part: &str) -> &'static str {
    match part {
        "mass_matrix" => "M",
        "convective_forces" => "h",
        "generalized_forces" => "Q",
        "constraints" => "C",
        "constraint_jacobian" => "C_q",
        _ => "c",
    }
}

/// Names as the reader spells them: the letters, a dot for each dot, and what is below after an underscore.
fn name(symbol: &str) -> String {
    let (base, dots, indices) = taken_apart(symbol);
    let letter = GREEK.iter().find(|(name, _)| *name == base).map_or(base, |(_, letter)| letter);
    let dots = ["", "˙", "¨"][dots];
    if indices.is_empty() { format!("{letter}{dots}") } else { format!("{letter}{dots}_{}", indices.join(",")) }
}

struct Element {
    name: String,
    bold: bool,
    children: Vec<Element>,
    text: String,
}

/// One element, the whole text.
fn parse(text: &str) -> Element {
    let mut rest = text;
    let element = element(&mut rest);
    assert!(rest.is_empty(), "'{rest}' is left");
    element
}

fn element(rest: &mut &str) -> Element {
    let (tag, after) = rest.strip_prefix('<').and_then(|rest| rest.split_once('>')).expect(rest);
    let name = tag.split(' ').next().unwrap().to_owned();
    assert!(tag[name.len()..].matches('"').count().is_multiple_of(2), "{tag}");
    *rest = after.trim_start_matches('\n');
    let bold = tag.contains("bold");
    let mut element = Element { name, bold, children: vec![], text: String::new() };
    loop {
        if let Some(after) = rest.strip_prefix("</") {
            *rest = after.strip_prefix(&element.name).and_then(|rest| rest.strip_prefix('>')).expect(&element.name);
            *rest = rest.trim_start_matches('\n');
            return element;
        }
        match rest.starts_with('<') {
            true => element.children.push(self::element(rest)),
            false => {
                let (text, _) = rest.split_once('<').unwrap();
                assert!(!text.contains(['>', '&']), "{text}");
                element.text += text;
                *rest = &rest[text.len()..];
            }
        }
    }
}

/// Expressions are kept as XML, to be parsed again.
fn split(text: &str, written: &mut Written) {
    let mut equations: Vec<(Element, String)> = Vec::new();
    for row in text.lines().filter(|line| line.starts_with("<mtr>")) {
        let cell = |at: usize| row.split("<mtd style=\"text-align: ").nth(at).unwrap().split_once("\">").unwrap().1;
        let right = cell(3).strip_suffix("</mtd></mtr>").unwrap();
        let left = parse(&format!("<x>{}</x>", cell(1).strip_suffix("</mtd>").unwrap()));
        match left.children.is_empty() {
            true => {
                let more = right.strip_prefix("<mrow>").unwrap();
                let so_far = &mut equations.last_mut().unwrap().1;
                *so_far = so_far.strip_suffix("</mrow>").unwrap().to_owned() + more;
            }
            false => equations.push((left, right.to_owned())),
        }
    }
    for (left, right) in equations {
        let left = &left.children[0].children[0];
        let tree = parse(&right);
        match tree.children.get(1).filter(|table| table.name == "mtable") {
            Some(_) => {
                let table = right.split_once("<mtable>").unwrap().1.split_once("</mtable>").unwrap().0;
                let entries = |row: &str| {
                    row.split("<mtd>").skip(1).map(|e| e.split("</mtd>").next().unwrap().to_owned()).collect()
                };
                let rows = table.split("<mtr>").skip(1).map(entries).collect();
                written.matrices.insert(spelled(left).replace('*', ""), rows);
            }
            None => assert!(written.scalars.insert(spelled(left), right).is_none()),
        }
    }
}

/// The name that an element is, if it is one; bold ones with a star.
fn spelled(element: &Element) -> String {
    let children: Vec<String> = element.children.iter().map(spelled).collect();
    match element.name.as_str() {
        "msub" => children.join("_"),
        _ if element.bold => format!("*{}", element.text),
        _ => element.text.clone() + &children.concat(),
    }
}

fn value(text: &str, names: Names) -> f64 {
    evaluate(&parse(text), names)
}

fn evaluate(element: &Element, names: Names) -> f64 {
    let child = |at: usize| evaluate(&element.children[at], names);
    match element.name.as_str() {
        "mn" => element.text.parse().unwrap(),
        "mfrac" => child(0) / child(1),
        "msqrt" => child(0).sqrt(),
        "mroot" => child(0).powf(1.0 / child(1)),
        "msup" => child(0).powf(child(1)),
        "mi" | "msub" | "mover" => match spelled(element).as_str() {
            "π" => std::f64::consts::PI,
            "e" => std::f64::consts::E,
            name => names(name),
        },
        "mrow" => match element.children[0].text.as_str() {
            "(" => child(1),
            "|" => child(1).abs(),
            _ => sum(&element.children, names),
        },
        other => panic!("no value of {other}"),
    }
}

fn sum(children: &[Element], names: Names) -> f64 {
    let is_sign = |element: &Element| element.name == "mo" && ["+", "−"].contains(&element.text.as_str());
    let mut value = 0.0;
    let mut sign = 1.0;
    let mut rest = children;
    while !rest.is_empty() {
        if is_sign(&rest[0]) {
            sign = if rest[0].text == "+" { 1.0 } else { -1.0 };
            rest = &rest[1..];
        }
        let end = rest.iter().position(is_sign).unwrap_or(rest.len());
        value += sign * product(&rest[..end], names);
        rest = &rest[end..];
    }
    value
}

fn product(children: &[Element], names: Names) -> f64 {
    let is_times = |element: &Element| element.name == "mo" && ["\u{2062}", "·"].contains(&element.text.as_str());
    children.split(is_times).map(|factor| call(factor, names)).product()
}

fn call(factor: &[Element], names: Names) -> f64 {
    match factor {
        [one] => evaluate(one, names),
        [name, _, pair] if name.text == "atan2" => {
            let [y, _, x] = pair.children[1].children.as_slice() else { panic!("atan2 takes two") };
            evaluate(y, names).atan2(evaluate(x, names))
        }
        [name, apply, argument] if apply.text == "\u{2061}" => {
            let x = evaluate(argument, names);
            match name.name.as_str() {
                "msup" => function(&name.children[0].text, x).powf(evaluate(&name.children[1], names)),
                _ => function(&name.text, x),
            }
        }
        _ => panic!("no product sign between {}", factor.iter().map(spelled).collect::<String>()),
    }
}
