//! Vectors by their components.

use super::interpreter::Interpreter;
use super::measured::Measured;
use super::space::Spatial;
use super::value::{Shape, Value};
use crate::dsl::{Expression, Region};

impl Interpreter {
    /// `[x, y]` or `[x, y, z]`: all of a declaration have the same number of components.
    pub(super) fn vector(&mut self, region: Region, components: &[Expression]) -> Option<Value> {
        let values: Vec<_> = components.iter().map(|c| self.scalar_value(c)).collect();
        if ![2, 3].contains(&values.len()) {
            let message = match values.len() {
                6 => "six numbers in brackets are an inertia; a vector has two components in the plane, `[x, y]`, and \
                      three in space, `[x, y, z]`"
                    .to_owned(),
                given => format!(
                    "a vector of the plane has two components, `[x, y]`, and one of space three, `[x, y, z]`; this has {given}"
                ),
            };
            return self.refuse(region, message);
        }
        self.check_length(region, values.len())?;
        let mut entries = Vec::new();
        let (first, mut dimension) = (&components[0], None);
        for (component, value) in components.iter().zip(values) {
            let (value, own) = value?;
            let (a, b) = (
                Measured { expression: first, dimension: &dimension },
                Measured { expression: component, dimension: &own },
            );
            let rule = match components.len() {
                2 => "both components of a vector are of one dimension",
                _ => "all components of a vector are of one dimension",
            };
            dimension = self.one_dimension(a, b, rule)?;
            entries.push(value);
        }
        let shape = match entries.as_slice() {
            [x, y] => Shape::Vector([*x, *y]),
            [x, y, z] => Shape::Spatial(Spatial::world([*x, *y, *z])),
            _ => return None,
        };
        Some(Value::new(shape, dimension))
    }

    /// Refuses a vector with more or fewer components than those before it.
    fn check_length(&mut self, region: Region, components: usize) -> Option<()> {
        let (known, first) = *self.vectors.get_or_insert((components, region));
        if components == 3 {
            self.frames.begin(&mut self.graph);
        }
        if known == components {
            return Some(());
        }
        let message = match known {
            2 => {
                "this vector has three components, but the first vector makes the mechanism planar; write `[x, y]`, \
                  or three components everywhere"
            }
            _ => {
                "this vector has two components, but the first vector makes the mechanism spatial; write `[x, y, 0]`, \
                  or two components everywhere"
            }
        };
        let mut mistake = region.error(message);
        mistake.combine(first.error("the first vector stands here"));
        self.mistakes.add(mistake);
        None
    }
}
