//! Labels and numbers as they are printed.

const THIN_SPACE: char = '\u{2009}';
const MINUS: char = '\u{2212}';

/// A label as it is printed: powers such as `^2` and `^-1` are raised, and `*` in a unit becomes a dot.
///
/// ```
/// assert_eq!(sim::show::typeset("x6_acceleration [m/s^2]"), "x6_acceleration [m/s²]");
/// assert_eq!(sim::show::typeset("inertia [kg*m^2]"), "inertia [kg·m²]");
/// ```
pub fn typeset(label: &str) -> String {
    let mut typeset = String::with_capacity(label.len());
    let mut rest = label;
    let mut in_unit = false;
    while let Some(letter) = rest.chars().next() {
        rest = &rest[letter.len_utf8()..];
        in_unit = letter == '[' || in_unit && letter != ']';
        let power = if letter == '^' { power_length(rest) } else { 0 };
        if power > 0 {
            typeset.extend(rest[..power].chars().map(raised));
            rest = &rest[power..];
        } else {
            typeset.push(if in_unit && letter == '*' { '·' } else { letter });
        }
    }
    typeset
}

/// The length of the whole number that a text begins with; 0 if there is none, or a fraction.
fn power_length(text: &str) -> usize {
    let sign = usize::from(text.starts_with('-'));
    let digits = text[sign..].bytes().take_while(u8::is_ascii_digit).count();
    let end = sign + digits;
    let broken = text[end..].starts_with('.') && text[end + 1..].starts_with(|next: char| next.is_ascii_digit());
    if digits == 0 || broken { 0 } else { end }
}

fn raised(letter: char) -> char {
    match letter {
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        '-' => '⁻',
        other => other,
    }
}

/// A power of ten: `10⁻³`.
pub(super) fn power_of_ten(exponent: i32) -> String {
    typeset(&format!("10^{exponent}"))
}

/// The number digits · 10^exponent, exactly, with its thousands apart where it is long.
pub(super) fn decimal(digits: i64, exponent: i32) -> String {
    let mut whole = digits.unsigned_abs().to_string();
    let mut fraction = String::new();
    if exponent >= 0 {
        if digits != 0 {
            whole.extend(std::iter::repeat_n('0', exponent.unsigned_abs() as usize));
        }
    } else {
        let decimals = exponent.unsigned_abs() as usize;
        let padding = (decimals + 1).saturating_sub(whole.len());
        whole.insert_str(0, &"0".repeat(padding));
        fraction = format!(".{}", whole.split_off(whole.len() - decimals));
    }
    let sign = if digits < 0 { String::from(MINUS) } else { String::new() };
    format!("{sign}{}{fraction}", grouped(&whole))
}

/// Thousands apart in numbers of five digits or more.
fn grouped(digits: &str) -> String {
    let mut grouped = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if digits.len() > 4 && index > 0 && (digits.len() - index).is_multiple_of(3) {
            grouped.push(THIN_SPACE);
        }
        grouped.push(digit);
    }
    grouped
}

/// Times, all with enough decimals to distinguish them, except a bare 0.
pub(super) fn times(times: &[f64]) -> Vec<String> {
    let mut sorted = times.to_vec();
    sorted.sort_by(f64::total_cmp);
    let greatest = times.iter().map(|time| time.abs()).fold(0.0, f64::max);
    let gaps = sorted.windows(2).map(|pair| pair[1] - pair[0]).filter(|gap| *gap > 1e-9 * greatest);
    let tolerance = 0.02 * gaps.fold(greatest, f64::min);
    let close = |decimals: &i32| {
        let unit = 10_f64.powi(-decimals);
        times.iter().all(|time| ((time / unit).round() * unit - time).abs() <= tolerance && time.abs() < 1e15 * unit)
    };
    let decimals = (0..9).find(close);
    times.iter().map(|time| printed_time(*time, decimals)).collect()
}

/// A time with so many decimals, or with a power of ten.
fn printed_time(time: f64, decimals: Option<i32>) -> String {
    let Some(decimals) = decimals else { return format!("{time:e}").replace('-', &String::from(MINUS)) };
    let digits = (time * 10_f64.powi(decimals)).round();
    if digits == 0.0 { "0".to_owned() } else { decimal(digits as i64, -decimals) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_typeset() {
        assert_eq!(typeset("x6_acceleration [m/s^2]"), "x6_acceleration [m/s²]");
        assert_eq!(typeset("work [N*m], a*b"), "work [N·m], a*b");
        assert_eq!(typeset("s^-1 and m^10"), "s⁻¹ and m¹⁰");
        assert_eq!(typeset("[kg*m^2*s^-3]"), "[kg·m²·s⁻³]");
        for plain in ["", "a^b", "a^", "a^-", "φ₁ [rad]", "x^2.5", "2^"] {
            assert_eq!(typeset(plain), plain);
        }
    }

    #[test]
    fn decimals_are_exact() {
        assert_eq!(decimal(3, -1), "0.3");
        assert_eq!(decimal(-5, -2), "\u{2212}0.05");
        assert_eq!(decimal(0, -1), "0.0");
        assert_eq!(decimal(0, 3), "0");
        assert_eq!(decimal(25, 3), "25\u{2009}000");
        assert_eq!(decimal(25, 2), "2500");
        assert_eq!(decimal(-1_234_567, 0), "\u{2212}1\u{2009}234\u{2009}567");
        assert_eq!(decimal(i64::MIN, 0).chars().filter(char::is_ascii_digit).count(), 19);
    }

    #[test]
    fn times_are_short_and_differ() {
        let revolution = 0.659_34;
        let sixths: Vec<f64> = (0..6).map(|sixth| f64::from(sixth) * revolution / 6.0).collect();
        assert_eq!(times(&sixths), ["0", "0.11", "0.22", "0.33", "0.44", "0.55"]);
        assert_eq!(times(&[0.0, 1.0, 2.0]), ["0", "1", "2"]);
        assert_eq!(times(&[0.0, 1e-5, 3e-5]), ["0", "0.00001", "0.00003"]);
        assert_eq!(times(&[0.25, 0.25]), ["0.25", "0.25"]);
        assert_eq!(times(&[3e-12]), ["3e\u{2212}12"]);
        assert_eq!(times(&[0.0]), ["0"]);
        assert_eq!(times(&[1e-17, 0.5, 0.5 + 1e-16, 1.0]), ["0", "0.5", "0.5", "1.0"]);
    }
}
