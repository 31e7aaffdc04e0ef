//! The tree of bodies in space, as `info` shows it: what each link is on, what moves it there, and its mass.

use crate::said::short;
use codegen::dynamics::EquationsOfMotion;
use codegen::symbolic::evaluate;
use serde_json::{Value, json};

/// A link: bodies that move together.
pub(super) struct Link {
    bodies: Vec<String>,
    /// The bodies of the link before, or none on the ground.
    on: Vec<String>,
    /// The coordinates that move it in the link before.
    coordinates: Vec<String>,
    /// In kg, where parameters are as they are by default.
    mass: f64,
}

/// The links of a tree in space, each after the one before it. Frames without bodies, such as the origins of joints, are
/// on the way to a link: the coordinates that turn them move it too.
pub(super) fn tree(equations: &EquationsOfMotion, defaults: &[f64]) -> Vec<Link> {
    let EquationsOfMotion { model, graph, links, .. } = equations;
    let value = |symbol| {
        let parameter = model.parameters.iter().position(|parameter| parameter.symbol == symbol);
        parameter.and_then(|i| defaults.get(i)).copied().unwrap_or(f64::NAN)
    };
    let bodies = |link: usize| {
        let fixed = model.links.get(link).into_iter().flat_map(|link| &link.bodies);
        fixed.map(|fixed| &model.bodies[fixed.body]).collect::<Vec<_>>()
    };
    let names = |link: usize| bodies(link).into_iter().map(|body| body.name.clone()).collect::<Vec<_>>();
    let links = links.as_ref().map_or(&[][..], |links| &links.links);
    let told = (0..links.len()).filter(|at| !bodies(*at).is_empty()).map(|at| {
        let (mut on, mut columns) = (links[at].before, vec![&links[at].columns]);
        while let Some(frame) = on.filter(|frame| bodies(*frame).is_empty()) {
            on = links[frame].before;
            columns.push(&links[frame].columns);
        }
        let masses: Vec<_> =
            bodies(at).into_iter().filter_map(|body| body.mass.as_ref().map(|(mass, _)| *mass)).collect();
        let coordinates = columns.into_iter().rev().flatten();
        Link {
            bodies: names(at),
            on: on.map(names).unwrap_or_default(),
            coordinates: coordinates.map(|(i, _)| model.coordinates[*i].name.clone()).collect(),
            mass: evaluate(graph, &masses, value).into_iter().fold(0.0, |sum, mass| sum + mass),
        }
    });
    told.collect()
}

impl Link {
    /// A line: the bodies, their mass, what they are on and what moves them there.
    pub(super) fn line(&self) -> [String; 4] {
        let on = if self.on.is_empty() { "on the ground".to_owned() } else { format!("on {}", self.on.join(", ")) };
        let moved = format!("{on} by {}", self.coordinates.join(", "));
        [self.bodies.join(", "), format!("{} kg", short(self.mass)), moved, String::new()]
    }

    pub(super) fn as_json(&self) -> Value {
        json!({ "bodies": self.bodies, "on": self.on, "coordinates": self.coordinates, "mass": self.mass })
    }
}
