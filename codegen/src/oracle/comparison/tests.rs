//! The comparison fails for each way in which a kernel can differ.

use super::super::measured::Measured;
use super::Comparison;

/// 1 and 2, of magnitudes 1 and 4.
const EXPECTED: [Measured; 2] = [Measured { value: 1.0, magnitude: 1.0 }, Measured { value: 2.0, magnitude: 4.0 }];

fn worst(values: &[f64]) -> f64 {
    let mut comparison = Comparison::new(0.0);
    comparison.term("first", values, &EXPECTED);
    // What follows does not hide it.
    comparison.term("second", &[1.0, 2.0], &EXPECTED);
    comparison.worst().0
}

#[test]
fn differences_are_relative_to_magnitudes() {
    assert_eq!(worst(&[1.0, 2.0]), 0.0);
    assert_eq!(worst(&[1.0, 3.0]), 0.25);
    assert_eq!(worst(&[1.5, 3.0]), 0.5);
}

#[test]
fn an_entry_that_is_missing_or_has_no_value_is_infinitely_far() {
    for values in [&[1.0][..], &[], &[1.0, 2.0, 3.0], &[f64::NAN, 2.0], &[1.0, f64::INFINITY]] {
        assert_eq!(worst(values), f64::INFINITY, "{values:?}");
    }
}

#[test]
fn what_neither_way_has_a_value_for_is_not_compared() {
    let mut comparison = Comparison::new(0.0);
    comparison.term("first", &[f64::NAN], &[Measured { value: f64::INFINITY, magnitude: f64::INFINITY }]);
    assert_eq!(comparison.worst(), (0.0, ""));
}

#[test]
fn small_entries_are_compared_with_a_part_of_the_largest_of_their_term() {
    let expected = [Measured::given(1e-20), Measured::given(100.0)];
    let mut comparison = Comparison::new(0.01);
    comparison.term("first", &[2e-20, 100.0], &expected);
    comparison.term("second", &[1e-3], &[Measured::given(2e-3)]);
    assert_eq!(comparison.worst(), (0.5, "second"));
    comparison.term("first", &[1e-20, 101.0], &expected);
    comparison.term("first", &[1.0, 100.0], &expected);
    assert_eq!(comparison.worst(), (1.0, "first"));
}
