//! What the readers of this folder share: functions by name, and Greek letters.

/// A function at a point, under the names of the language and of mathematics.
pub(crate) fn function(name: &str, x: f64) -> f64 {
    match name {
        "sin" => x.sin(),
        "cos" => x.cos(),
        "tan" => x.tan(),
        "asin" | "arcsin" => x.asin(),
        "acos" | "arccos" => x.acos(),
        "atan" | "arctan" => x.atan(),
        "sinh" => x.sinh(),
        "cosh" => x.cosh(),
        "tanh" => x.tanh(),
        "exp" => x.exp(),
        "ln" => x.ln(),
        "abs" => x.abs(),
        "sqrt" => x.sqrt(),
        "sign" | "sgn" => x.signum(),
        _ => panic!("no function {name}"),
    }
}

/// The names of the test's mechanisms and of the shipped ones, taken apart by hand: base, dots, indices.
pub(crate) fn taken_apart(name: &str) -> (&str, usize, Vec<&str>) {
    let (word, dots) = match (name.strip_suffix("_ddot"), name.strip_suffix("_dot")) {
        (Some(word), _) => (word, 2),
        (_, Some(word)) => (word, 1),
        _ => (name, 0),
    };
    let (base, indices) = match word {
        "theta_2" => ("theta", vec!["2"]),
        "O2A" => ("O", vec!["2A"]),
        "O4B" => ("O", vec!["4B"]),
        "O4O2" => ("O", vec!["4O2"]),
        "O4G4" => ("O", vec!["4G4"]),
        "BG5" => ("BG", vec!["5"]),
        "c0" | "l0" | "l1" => (&word[..1], vec![&word[1..]]),
        _ if word.len() == 2 && word.starts_with(['m', 'J', 'i']) => (&word[..1], vec![&word[1..]]),
        _ => (word, vec![]),
    };
    (base, dots, indices)
}

/// Greek letters of the mechanisms.
pub(crate) const GREEK: [(&str, &str); 9] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ϵ"),
    ("theta", "θ"),
    ("Theta", "Θ"),
    ("Phi", "Φ"),
    ("Omega", "Ω"),
];

#[test]
fn no_two_names_look_the_same() {
    use codegen::notation::Notation;
    let clash = "Clash; coordinates { x [m]; } parameters { m3 [kg] = 1; m_3 [kg] = 2; _m [m] = 1; }
        bodies { a: mass m3 at [x, 0]; b: mass m_3 at [2*x, _m]; }";
    let text = super::part(clash, Notation::Latex, "mass_matrix");
    assert!(text.contains(r"m_{3} + 4 \, \mathrm{m\_3}"), "{text}");
}
