//! `sim list`.

use crate::arguments::Voice;
use crate::said::counted;
use crate::{Entry, Stop, print};
use serde_json::json;
use sim_kernel::Description;

/// Prints each mechanism with its size and the first line of its documentation.
pub(crate) fn list(mechanisms: &[Entry], voice: Voice) -> Result<(), Stop> {
    let models = mechanisms.iter().map(Entry::model).collect::<Result<Vec<_>, _>>()?;
    let descriptions = models.iter().map(|model| model.description());
    if voice.json {
        let of = |d: &Description| json!({ "name": d.name, "coordinates": d.coordinates.len(), "constraints": d.constraints.len(), "docs": d.docs });
        return print(&format!("{:#}\n", descriptions.map(of).collect::<serde_json::Value>()));
    }
    let mut text = String::new();
    for d in descriptions {
        let (coordinates, constraints) =
            (counted(d.coordinates.len(), "coordinate"), counted(d.constraints.len(), "constraint"));
        text += &format!("{:<20} {coordinates}, {constraints}\n", d.name);
        if let Some(line) = d.docs.lines().next() {
            text += &format!("{:<20} {line}\n", "");
        }
    }
    print(&text)
}
