//! The outline of a cloud of points: what is seen of it along each axis.

use nalgebra::Vector3;

/// So many corners of a hull are looked at.
const MANY: usize = 500;

/// Convex outlines of points as seen along x, y and z, each in the middle of the third direction, with at most so many corners.
/// Closed: the last corner is the first.
pub(super) fn outlines(points: &[Vector3<f64>], most: usize) -> Vec<Vec<Vector3<f64>>> {
    let bound = |k: usize, better: fn(f64, f64) -> f64| points.iter().map(|at| at[k]).fold(points[0][k], better);
    let middle: [f64; 3] = std::array::from_fn(|k| (bound(k, f64::min) + bound(k, f64::max)) / 2.0);
    let along = |k: usize| {
        let [u, v] = [(k + 1) % 3, (k + 2) % 3];
        let corners = simplified(hull(points.iter().map(|at| [at[u], at[v]]).collect()), most);
        let mut outline: Vec<Vector3<f64>> = corners
            .into_iter()
            .map(|[a, b]| {
                let mut corner = Vector3::zeros();
                (corner[u], corner[v], corner[k]) = (a, b, middle[k]);
                corner
            })
            .collect();
        outline.extend(outline.first().copied());
        outline
    };
    (0..3).map(along).filter(|outline| outline.len() > 2).collect()
}

/// Twice the area of a triangle, positive if its corners turn left.
fn area([a, b, c]: [[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// The convex hull, anticlockwise (Andrew's monotone chain).
fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let chain = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for point in points {
            while let [.., a, b] = chain.as_slice()
                && area([*a, *b, point]) <= 0.0
            {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut lower = chain(&mut points.iter().copied());
    lower.extend(chain(&mut points.iter().rev().copied()));
    lower
}

/// Leaves out the corners that change the outline least.
fn simplified(mut corners: Vec<[f64; 2]>, most: usize) -> Vec<[f64; 2]> {
    // Of very many, those between are left out first.
    let stride = corners.len().div_ceil(MANY);
    corners = corners.into_iter().step_by(stride.max(1)).collect();
    while corners.len() > most {
        let n = corners.len();
        let cut = |k: usize| area([corners[(k + n - 1) % n], corners[k], corners[(k + 1) % n]]);
        let Some(least) = (0..n).min_by(|a, b| cut(*a).total_cmp(&cut(*b))) else { break };
        corners.remove(least);
    }
    corners
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_outline_of_a_box_is_three_rectangles() {
        let corner = |k: usize| Vector3::new((k & 1) as f64, (k >> 1 & 1) as f64 * 2.0, (k >> 2) as f64 * 3.0);
        let mut points: Vec<_> = (0..8).map(corner).collect();
        points.push(Vector3::new(0.5, 1.0, 1.5));
        let outlines = outlines(&points, 12);
        assert_eq!(outlines.len(), 3);
        for (k, outline) in outlines.iter().enumerate() {
            assert_eq!(outline.len(), 5);
            assert!(outline.iter().all(|corner| corner[k] == [0.5, 1.0, 1.5][k]));
            let sides: f64 = outline.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
            assert_eq!(sides, [10.0, 8.0, 6.0][k]);
        }
    }

    #[test]
    fn a_circles_outline_keeps_its_form() {
        let on_circle = |k: usize| {
            let (sine, cosine) = (k as f64 * 0.01).sin_cos();
            [cosine, sine]
        };
        let corners = simplified(hull((0..629).map(on_circle).collect()), 12);
        assert_eq!(corners.len(), 12);
        let n = corners.len();
        let twice: f64 = (1..n - 1).map(|k| area([corners[0], corners[k], corners[k + 1]])).sum();
        // The regular polygon of 12 corners has an area of 3.
        assert!((twice / 2.0 - 3.0).abs() < 0.05, "{twice}");
    }
}
