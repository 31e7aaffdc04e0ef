//! Insertion sort for a few items. The library's sort is long, and would be compiled for each mechanism.

use std::cmp::Ordering;

/// Sorts; equals keep their order.
pub(crate) fn sort_few<T>(items: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    for end in 1..items.len() {
        let mut at = end;
        while at > 0 && compare(&items[at - 1], &items[at]).is_gt() {
            items.swap(at - 1, at);
            at -= 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::sort_few;

    #[test]
    fn as_the_library_sorts() {
        let mut items: Vec<(u32, u32)> = (0..40).map(|i| (i * i % 7, i)).collect();
        let mut expected = items.clone();
        expected.sort_by_key(|item| item.0);
        sort_few(&mut items, |a, b| a.0.cmp(&b.0));
        assert_eq!(items, expected);
    }
}
