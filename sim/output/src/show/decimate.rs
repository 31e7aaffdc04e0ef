//! Fewer points, the same picture.

use super::scene::Point;

/// Keeps, of every run of points within a column of this width, the first, the lowest, the highest and the last, in
/// their order: extremes survive, and omitted points would be hidden behind drawn ones.
pub(super) fn decimate(points: &[Point], column: f64) -> Vec<Point> {
    let mut kept = Vec::new();
    let same = |one: &Point, other: &Point| (one.0 / column).floor() == (other.0 / column).floor();
    for run in points.chunk_by(same) {
        let extreme = |higher: fn(f64, f64) -> bool| {
            (1..run.len()).fold(0, |best, index| if higher(run[index].1, run[best].1) { index } else { best })
        };
        let mut indices = [0, extreme(|one, other| one < other), extreme(|one, other| one > other), run.len() - 1];
        indices.sort_unstable();
        let mut last = None;
        for index in indices {
            if last != Some(index) {
                kept.push(run[index]);
            }
            last = Some(index);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_stay_and_numbers_are_bounded() {
        let wave = |index: u32| (f64::from(index) * 0.01, (f64::from(index) * 1.7).sin());
        let mut points: Vec<Point> = (0..100_000).map(wave).collect();
        points[54_321].1 = 40.0;
        points[54_327].1 = -70.0;
        let kept = decimate(&points, 0.5);
        assert!(kept.len() <= 4 * 2000);
        assert!(kept.contains(&points[54_321]) && kept.contains(&points[54_327]));
        assert_eq!((kept.first(), kept.last()), (points.first(), points.last()));
        assert!(kept.windows(2).all(|pair| pair[0].0 <= pair[1].0));
    }

    #[test]
    fn few_points_all_stay() {
        let points = [(0.0, 1.0), (1.0, 2.0), (2.0, 0.0), (1.5, 0.5)];
        assert_eq!(decimate(&points, 0.5), points);
        assert!(decimate(&[], 0.5).is_empty());
    }
}
