//! Names of mechanisms on the command line.

/// The name of a mechanism on the command line: `QuickReturn` is `quick-return`.
pub fn kebab_case(name: &str) -> String {
    let mut out = String::new();
    let letters: Vec<char> = name.chars().collect();
    for (i, letter) in letters.iter().enumerate() {
        let after_small = i > 0 && (letters[i - 1].is_lowercase() || letters[i - 1].is_ascii_digit());
        let before_small =
            i > 0 && letters[i - 1].is_uppercase() && letters.get(i + 1).is_some_and(|c| c.is_lowercase());
        if letter.is_uppercase() && (after_small || before_small) {
            out.push('-');
        }
        out.extend(if *letter == '_' { vec!['-'] } else { letter.to_lowercase().collect() });
    }
    out
}
