//! The equations of motion in a mechanism's documentation.

use crate::dynamics::EquationsOfMotion;
use crate::notation::{self, Notation};

/// Larger systems fill a page and are better read from the command's output.
const LARGEST_SYSTEM: usize = 16;

/// Lines of documentation: the equations as text, under the names of the kernels that compute them. If they are many,
/// or not in the coordinates alone, a pointer to the command.
pub(super) fn equations(equations: &EquationsOfMotion) -> Vec<String> {
    let size = equations.model.coordinates.len() + equations.model.constraints.len();
    if size > LARGEST_SYSTEM || !equations.intermediates.is_empty() {
        return vec![String::new(), " Its equations of motion are printed by `codegen FILE --equations infix`.".into()];
    }
    let mut lines = vec![String::new(), " # Equations of motion".into(), String::new(), " ```text".into()];
    for (at, part) in notation::equations(equations, Notation::Infix).iter().enumerate() {
        if at > 0 {
            lines.push(String::new());
        }
        lines.extend(part.text.lines().map(|line| format!(" {line}")));
    }
    lines.push(" ```".into());
    lines
}
