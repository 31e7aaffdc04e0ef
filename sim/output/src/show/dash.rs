//! Dashed lines.

use super::scene::Point;

/// The strokes of a dashed line along a polyline: `on` drawn, then `off` skipped, with the first stroke starting this
/// far before the polyline.
pub(super) fn dashes(points: &[Point], on: f64, off: f64, before: f64) -> Vec<Vec<Point>> {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return Vec::new() };
    let mut total = 0.0;
    let mut lengths = vec![total];
    for pair in points.windows(2) {
        total += (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1);
        lengths.push(total);
    }
    let at = |length: f64| match lengths.partition_point(|passed| *passed <= length) {
        0 => *first,
        next if next < points.len() => {
            let share = (length - lengths[next - 1]) / (lengths[next] - lengths[next - 1]);
            let (from, to) = (points[next - 1], points[next]);
            (from.0 + (to.0 - from.0) * share, from.1 + (to.1 - from.1) * share)
        }
        _ => *last,
    };
    let stroke = |number: u32| {
        let start = f64::from(number) * (on + off) - before.rem_euclid(on + off);
        (start.max(0.0), (start + on).min(total))
    };
    let strokes = (0..).map(stroke).take_while(|(start, _)| *start < total).filter(|(start, end)| start < end);
    let between = |start: f64, end: f64| {
        let (from, to) =
            (lengths.partition_point(|passed| *passed <= start), lengths.partition_point(|passed| *passed < end));
        points[from..to.max(from)].iter().copied()
    };
    strokes.map(|(start, end)| [at(start)].into_iter().chain(between(start, end)).chain([at(end)]).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strokes_have_their_length_also_round_corners() {
        let strokes = dashes(&[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0)], 4.0, 2.0, 0.0);
        assert_eq!(strokes.len(), 4);
        assert_eq!(strokes[0], [(0.0, 0.0), (4.0, 0.0)]);
        assert_eq!(strokes[1], [(6.0, 0.0), (10.0, 0.0)]);
        assert_eq!(strokes[2], [(10.0, 2.0), (10.0, 6.0)]);
        assert_eq!(strokes[3], [(10.0, 8.0), (10.0, 10.0)]);
        assert_eq!(dashes(&[(0.0, 0.0), (3.0, 0.0)], 2.0, 2.0, 3.0), [[(1.0, 0.0), (3.0, 0.0)]]);
        assert!(dashes(&[(1.0, 1.0)], 2.0, 2.0, 0.0).is_empty());
    }
}
