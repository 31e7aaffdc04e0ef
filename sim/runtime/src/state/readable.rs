//! Numbers in messages.

/// So many decimals; of a small or large number, of what a power of ten multiplies, so that no digits are lost.
pub fn readable(value: f64, decimals: usize) -> String {
    // Zero has no sign here.
    let value = value + 0.0;
    let plain = value == 0.0 || (1e-3..1e6).contains(&value.abs());
    if plain { format!("{value:.decimals$}") } else { format!("{value:.decimals$e}") }
}

#[cfg(test)]
mod tests {
    use super::readable;

    #[test]
    fn small_and_large_numbers_have_exponents() {
        let rows =
            [(0.0, "0.000000"), (-0.0, "0.000000"), (-2.5, "-2.500000"), (2.5e-8, "2.500000e-8"), (3e7, "3.000000e7")];
        for (value, expected) in rows {
            assert_eq!(readable(value, 6), expected);
        }
    }
}
