//! The names of a drawing's points, from the declaration.

use sim_kernel::Description;

/// The names of each shape's points: those of the declaration, or numbers if it cannot be read.
pub(super) fn points(description: &Description) -> Vec<Vec<String>> {
    let numbered = || {
        let mut number = 0;
        let mut next = || {
            number += 1;
            format!("point {number}")
        };
        description.drawing.iter().map(|shape| (0..shape.points()).map(|_| next()).collect()).collect()
    };
    let fits = |names: &Vec<Vec<String>>| {
        names.len() == description.drawing.len()
            && names.iter().zip(description.drawing).all(|(names, shape)| names.len() == shape.points())
    };
    declared(description).filter(fits).unwrap_or_else(numbered)
}

#[cfg(not(feature = "analysis"))]
fn declared(_: &Description) -> Option<Vec<Vec<String>>> {
    None
}

#[cfg(feature = "analysis")]
fn declared(description: &Description) -> Option<Vec<Vec<String>>> {
    use codegen::dsl;
    let declaration = codegen::parse(description.declaration.parse().ok()?).ok()?;
    let names = |points: &[dsl::Expression]| points.iter().map(ToString::to_string).collect();
    let shape = |shape: &dsl::Shape| match shape {
        dsl::Shape::Points { points, .. } => names(points),
        dsl::Shape::Slider { at, .. } | dsl::Shape::Circle { at, .. } => names(std::slice::from_ref(at)),
    };
    Some(declaration.drawing.iter().map(shape).collect())
}
