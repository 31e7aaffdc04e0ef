//! Which samples a report shows, and numbers as base64.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use sim_runtime::Column;

/// The size limit of packed samples in bytes, so that the page stays under 2 MB.
const BUDGET: usize = 1_450_000;

/// The samples shown, each `width` floats: all if they fit; otherwise some at equal distances, the last, and those at
/// which a column is largest or smallest.
pub(super) fn chosen(columns: &[&Column], samples: usize, width: usize) -> Vec<usize> {
    // Four bytes a float, eight for the time, four letters to three bytes.
    let room = BUDGET * 3 / 4 / (8 + 4 * width.max(1));
    let extremes = 2 * columns.len() + 1;
    if samples <= room {
        return (0..samples).collect();
    }
    let stride = samples.div_ceil(room.saturating_sub(extremes).max(100));
    let mut rows: Vec<usize> = (0..samples).step_by(stride).chain([samples - 1]).collect();
    for column in columns {
        rows.extend(extreme(&column.values, |a, b| a > b));
        rows.extend(extreme(&column.values, |a, b| a < b));
    }
    rows.sort_unstable();
    rows.dedup();
    rows
}

/// The index of the finite value that beats all others.
fn extreme(values: &[f64], beats: fn(f64, f64) -> bool) -> Option<usize> {
    let mut best: Option<usize> = None;
    for (row, value) in values.iter().enumerate() {
        if value.is_finite() && best.is_none_or(|best| beats(*value, values[best])) {
            best = Some(row);
        }
    }
    best
}

/// Numbers as 32-bit floats, low byte first.
pub(super) fn floats(values: impl IntoIterator<Item = f64>) -> String {
    let bytes: Vec<u8> = values.into_iter().flat_map(|value| (value as f32).to_le_bytes()).collect();
    STANDARD.encode(bytes)
}

/// Numbers as 64-bit floats, low byte first.
pub(super) fn doubles(values: impl IntoIterator<Item = f64>) -> String {
    let bytes: Vec<u8> = values.into_iter().flat_map(f64::to_le_bytes).collect();
    STANDARD.encode(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wave(samples: usize) -> Column {
        let mut values: Vec<f64> = (0..samples).map(|i| (i as f64 * 1e-3).sin()).collect();
        values[samples / 3] = 9.0;
        values[samples / 2] = f64::NAN;
        Column { name: "wave".into(), unit: "m".into(), values }
    }

    #[test]
    fn short_runs_are_whole_and_long_ones_keep_their_extremes() {
        let short = wave(100);
        assert_eq!(chosen(&[&short], 100, 20), (0..100).collect::<Vec<_>>());
        let long = wave(3_000_000);
        let rows = chosen(&[&long], 3_000_000, 40);
        assert!(rows.contains(&0) && rows.contains(&2_999_999) && rows.contains(&1_000_000));
        assert!(rows.len() * (8 + 4 * 40) * 4 / 3 <= BUDGET && rows.len() > 5000, "{}", rows.len());
        assert!(rows.windows(2).all(|pair| pair[0] < pair[1]));
    }

    #[test]
    fn floats_are_little_endian() {
        assert_eq!(floats([1.0]), "AACAPw==");
        assert_eq!(doubles([1.0]), "AAAAAAAA8D8=");
    }
}
