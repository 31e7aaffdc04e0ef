//! Presentation MathML, as web pages inline it.

use super::greek;
use super::layout::{Layout, Operator};

const NAMESPACE: &str = "http://www.w3.org/1998/Math/MathML";

/// Lines with their left side, aligned at the sign between them; a continued one has no left side.
pub(super) fn lines(lines: &[(Option<Layout>, Layout)]) -> String {
    let cell = |align: &str, inner: &str| format!("<mtd style=\"text-align: {align}\">{inner}</mtd>");
    let rows: String = lines
        .iter()
        .map(|(left, right)| {
            let (left, equals) = match left {
                Some(left) => (text(left), "<mo>=</mo>"),
                None => (String::new(), ""),
            };
            let cells = [cell("right", &left), cell("center", equals), cell("left", &text(right))].concat();
            format!("<mtr>{cells}</mtr>\n")
        })
        .collect();
    format!(
        "<math xmlns=\"{NAMESPACE}\" display=\"block\"><mtable displaystyle=\"true\" \
         columnalign=\"right center left\">\n{rows}</mtable></math>\n"
    )
}

fn text(layout: &Layout) -> String {
    match layout {
        Layout::Row(parts) => element("mrow", &parts.iter().map(text).collect::<String>()),
        Layout::Number(digits) => element("mn", digits),
        Layout::Word(word, bold) => set_word(word, *bold),
        Layout::Function(name) => element("mi", name),
        Layout::Operator(operator) => element("mo", sign(*operator)),
        Layout::Fraction(above, below) => element("mfrac", &pair(above, below)),
        Layout::Superscript(base, exponent) => element("msup", &pair(base, exponent)),
        Layout::Subscript(base, indices) => {
            let comma = element("mo", ",");
            let indices = element("mrow", &indices.iter().map(text).collect::<Vec<_>>().join(&comma));
            element("msub", &(text(base) + &indices))
        }
        Layout::Root(radicand, None) => element("msqrt", &text(radicand)),
        Layout::Root(radicand, Some(degree)) => element("mroot", &(text(radicand) + &element("mn", degree))),
        Layout::Dots(base, dots) => {
            let accent = if *dots == 1 { "˙" } else { "¨" };
            format!("<mover accent=\"true\">{}{}</mover>", text(base), element("mo", accent))
        }
        Layout::Parentheses(inner) => fenced("(", &text(inner), ")"),
        Layout::Bars(inner) => fenced("|", &text(inner), "|"),
        Layout::Cases(rows) => {
            let cell = |inner: &Layout| format!("<mtd style=\"text-align: left\">{}</mtd>", text(inner));
            let row = |(value, case): &(Layout, Layout)| element("mtr", &[cell(value), cell(case)].concat());
            let rows: String = rows.iter().map(row).collect();
            element("mrow", &format!("<mo fence=\"true\" form=\"prefix\">{{</mo>{}", element("mtable", &rows)))
        }
        Layout::Text(words) => element("mtext", words),
        Layout::Matrix(rows) => fenced("(", &matrix(rows), ")"),
    }
}

fn matrix(rows: &[Vec<Layout>]) -> String {
    let row = |row: &Vec<Layout>| {
        let cells = row.iter().map(|cell| element("mtd", &text(cell))).collect::<String>();
        element("mtr", &cells)
    };
    element("mtable", &rows.iter().map(row).collect::<String>())
}

fn fenced(open: &str, inner: &str, close: &str) -> String {
    let fence = |sign: &str, form: &str| format!("<mo fence=\"true\" form=\"{form}\">{sign}</mo>");
    element("mrow", &[fence(open, "prefix"), inner.to_owned(), fence(close, "postfix")].concat())
}

fn pair(first: &Layout, second: &Layout) -> String {
    text(first) + &text(second)
}

fn element(name: &str, inner: &str) -> String {
    format!("<{name}>{inner}</{name}>")
}

fn sign(operator: Operator) -> &'static str {
    match operator {
        Operator::Plus => "+",
        Operator::Greater => "&gt;",
        Operator::Minus | Operator::Negative => "−",
        Operator::Times => "\u{2062}",
        Operator::Dot => "·",
        Operator::Comma => ",",
        Operator::Apply => "\u{2061}",
        Operator::Transpose => "⊤",
        Operator::Prime => "′",
    }
}

fn set_word(word: &str, bold: bool) -> String {
    let letter = greek::letter(word).map(String::from).unwrap_or_else(|| word.to_owned());
    match bold {
        true => format!("<mi style=\"font-weight: bold\">{letter}</mi>"),
        false => element("mi", &letter),
    }
}
