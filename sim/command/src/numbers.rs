//! Numbers as they are printed for readers.

use sim_kernel::Quantity;

/// Values of quantities in their units, each beside the others of its unit.
pub(super) fn in_units<'a>(
    quantities: impl Iterator<Item = &'a Quantity> + Clone,
    values: &[f64],
    decimals: usize,
) -> Vec<String> {
    let all = quantities.zip(values).map(|(quantity, value)| (quantity.unit, value / quantity.factor));
    // An angle is not small beside 1 rad.
    let least = |unit: &str| if ["rad", "deg"].contains(&unit) { 1.0 } else { 0.0 };
    let largest = |unit: &str| {
        let same = all.clone().filter(|(other, _)| *other == unit);
        same.fold(least(unit), |largest: f64, (_, value)| largest.max(value.abs()))
    };
    all.clone().map(|(unit, value)| beside(value, largest(unit), decimals)).collect()
}

/// A number with so many decimals; with an exponent if these are too few for it, unless it is rounding beside the
/// largest of its kind.
pub(super) fn beside(value: f64, largest: f64, decimals: usize) -> String {
    let is_rounding = value.abs() <= 8.0 * f64::EPSILON * largest;
    if value.abs() >= 1e-3 || is_rounding { fixed(value, decimals) } else { format!("{value:.decimals$e}") }
}

/// A number with so many decimals; one that rounds to zero has no sign.
fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let is_zero = text.bytes().all(|byte| b"-0.".contains(&byte));
    if is_zero { text.trim_start_matches('-').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_numbers_keep_their_digits_and_rounding_is_zero() {
        let of = |unit, factor| Quantity { name: "x", unit, factor, is_length: false, docs: "" };
        let (m, mm, rad) = (of("m", 1.0), of("mm", 1e-3), of("rad", 1.0));
        let rows: [(&[&Quantity], &[f64], &[&str]); 4] = [
            (&[&m, &m], &[0.25, -1e-17], &["0.250000", "0.000000"]),
            (&[&m, &m], &[1.25e-6, -3e-24], &["1.250000e-6", "0.000000"]),
            (&[&m, &mm], &[2.5e-5, 1.5], &["2.500000e-5", "1500.000000"]),
            (&[&rad, &rad], &[-1e-17, 1e-9], &["0.000000", "1.000000e-9"]),
        ];
        for (quantities, values, printed) in rows {
            assert_eq!(in_units(quantities.iter().copied(), values, 6), printed);
        }
    }
}
