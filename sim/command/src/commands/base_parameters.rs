//! The inertial parameters of a tree of bodies, regrouped by its joints, as `info` shows them: what a joint's motion cannot tell
//! apart is in the link before. A joint on the ground notices fewer of them, as the ground stays at rest.

use crate::said::short;
use codegen::dynamics::{EquationsOfMotion, MassDistribution};
use codegen::symbolic::evaluate;
use serde_json::{Value, json};

/// The axes of moments, in the order in which they are shown.
const AXES: [&str; 3] = ["x", "y", "z"];

/// What is left of the masses of a link, where parameters are as they are by default.
pub(super) struct BaseParameters {
    /// The bodies that are fixed in the link.
    bodies: Vec<String>,
    /// The coordinates that move it in the link before.
    coordinates: Vec<String>,
    /// The name, the value and the unit of each parameter.
    parameters: Vec<(String, f64, &'static str)>,
}

/// Those of each link of a tree in space that has any.
pub(super) fn base_parameters(equations: &EquationsOfMotion, defaults: &[f64]) -> Vec<BaseParameters> {
    let EquationsOfMotion { model, graph, links, .. } = equations;
    let value = |symbol| {
        let parameter = model.parameters.iter().position(|parameter| parameter.symbol == symbol);
        parameter.and_then(|i| defaults.get(i)).copied().unwrap_or(f64::NAN)
    };
    let links = links.iter().flat_map(|links| &links.links).zip(&model.links);
    let of_links = links.map(|(link, declared)| {
        let MassDistribution { mass, first, second } = &link.mass;
        let mut all = vec![("mass".to_owned(), *mass, "kg")];
        all.extend(AXES.iter().zip(first).map(|(axis, entry)| (format!("first_moment_{axis}"), *entry, "kg*m")));
        for (i, first) in AXES.iter().enumerate() {
            let entries = AXES.iter().zip(second[i]).skip(i);
            all.extend(entries.map(|(axis, entry)| (format!("second_moment_{first}{axis}"), entry, "kg*m^2")));
        }
        all.retain(|(_, entry, _)| !graph.is_zero(*entry));
        let values = evaluate(graph, &all.iter().map(|(_, entry, _)| *entry).collect::<Vec<_>>(), value);
        let body = |fixed: &codegen::model::FixedBody| model.bodies[fixed.body].name.clone();
        BaseParameters {
            bodies: declared.bodies.iter().map(body).collect(),
            coordinates: link.columns.iter().map(|(i, _)| model.coordinates[*i].name.clone()).collect(),
            parameters: all.into_iter().zip(values).map(|((name, _, unit), value)| (name, value, unit)).collect(),
        }
    });
    of_links.filter(|of_link| !of_link.parameters.is_empty()).collect()
}

impl BaseParameters {
    /// A line: what moves the link, its bodies, the parameters.
    pub(super) fn line(&self) -> [String; 4] {
        let told = |(name, value, unit): &(String, f64, &str)| {
            let name = name.replace("first_moment_", "h_").replace("second_moment_", "P_");
            format!("{name} = {} {unit}", short(*value))
        };
        let told: Vec<String> = self.parameters.iter().map(told).collect();
        [self.coordinates.join(", "), self.bodies.join(", "), told.join(", "), String::new()]
    }

    pub(super) fn as_json(&self) -> Value {
        let parameter =
            |(name, value, unit): &(String, f64, &str)| json!({ "name": name, "value": value, "unit": unit });
        json!({
            "coordinates": self.coordinates,
            "bodies": self.bodies,
            "parameters": self.parameters.iter().map(parameter).collect::<Vec<_>>(),
        })
    }
}
