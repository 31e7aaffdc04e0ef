//! Elements and attributes of a robot's file, and their places.

use super::robot::Place;
use super::warnings::CODE;
use codegen::mistakes::Mistake;
use roxmltree::Node;

/// The attributes of elements that say how a robot moves, those of limits that no motion depends on among them.
pub(super) const ATTRIBUTES: [(&str, &[&str]); 12] = [
    ("link", &["name", "type"]),
    ("joint", &["name", "type"]),
    ("inertial", &[]),
    ("origin", &["xyz", "rpy"]),
    ("mass", &["value"]),
    ("inertia", &["ixx", "iyy", "izz", "ixy", "ixz", "iyz"]),
    ("parent", &["link"]),
    ("child", &["link"]),
    ("axis", &["xyz"]),
    ("limit", &["lower", "upper", "effort", "velocity", "acceleration", "deceleration", "jerk"]),
    ("dynamics", &["damping", "friction"]),
    ("mimic", &["joint", "multiplier", "offset"]),
];

/// A file has at most so many elements, attributes aside.
pub(super) const MOST_NODES: u32 = 500_000;

/// What is said of files that xacro has yet to expand.
pub(super) const MACRO: &str =
    "this is a macro, and the file is to be expanded first: `xacro robot.urdf.xacro > robot.urdf`, of ROS";

/// What is no XML, or XML that may do more than say what it holds.
pub(super) fn malformed(text: &str, error: &roxmltree::Error) -> Mistake {
    let at = error.pos();
    let before: usize = text.split_inclusive('\n').take(at.row.max(1) as usize - 1).map(str::len).sum();
    let line = text.get(before..).and_then(|rest| rest.lines().next()).unwrap_or_default();
    let column: usize = line.chars().take(at.col.max(1) as usize - 1).map(char::len_utf8).sum();
    let message = match error {
        roxmltree::Error::DtdDetected => {
            "a document type is not read: entities can hide what a file holds. Leave `<!DOCTYPE ..>` out".into()
        }
        roxmltree::Error::NodesLimitReached => format!("this has more than {MOST_NODES} elements; robots have fewer"),
        roxmltree::Error::UnknownNamespace(prefix, _) if prefix == "xacro" => MACRO.into(),
        _ => format!("this is no XML: {error}"),
    };
    let start = before + column;
    let end = start + text.get(start..).and_then(|rest| rest.chars().next()).map_or(0, char::len_utf8);
    Mistake::at(text, CODE, start..end, message)
}

/// The first child of a name.
pub(super) fn child<'a, 'input>(node: Node<'a, 'input>, name: &str) -> Option<Node<'a, 'input>> {
    node.children().find(|child| child.is_element() && child.tag_name().name() == name)
}

/// Whether an element has this name, and no other vocabulary's.
pub(super) fn is_plain(node: Node, name: &str) -> bool {
    node.is_element() && node.tag_name().name() == name && node.tag_name().namespace().is_none()
}

/// Whether xacro has yet to write something here.
pub(super) fn is_of_xacro(node: Node) -> bool {
    let is_macro = |space: &str| space.contains("xacro");
    node.tag_name().namespace().is_some_and(is_macro)
        || node.attributes().any(|attribute| attribute.value().contains("${") || attribute.value().contains("$("))
}

/// The start tag of an element.
pub(super) fn tag(node: Node) -> Place {
    let range = node.range();
    let text = &node.document().input_text()[range.clone()];
    let end = text.find(['>', '\n']).map_or(text.len(), |at| if text[at..].starts_with('>') { at + 1 } else { at });
    range.start..range.start + end
}

/// The value of an attribute that is there.
pub(super) fn value(node: Node, name: &str) -> Place {
    node.attribute_node(name).map_or_else(|| tag(node), |attribute| attribute.range_value())
}

/// The beginning of a text, for messages.
pub(super) fn short(text: &str) -> String {
    const LONGEST: usize = 60;
    let kept: String = text.chars().take(LONGEST).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if text.chars().nth(LONGEST).is_some() { kept + ".." } else { kept }
}
