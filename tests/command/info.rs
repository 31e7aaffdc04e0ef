//! What `info` tells of a mechanism.

use crate::{sim, stdout};
use serde_json::Value;

#[test]
fn info_tells_units_of_multipliers_and_degrees_of_freedom() {
    let text = stdout(&sim(&["info", "quick-return"]));
    for expected in ["1 degree of freedom", "C.y = yc", "lambda_guide", "Length of crank 2.", "x6_velocity"] {
        assert!(text.contains(expected), "{expected}: {text}");
    }
}

/// The tree of a robot is that of its joints, whose turned origins (`shoulder`, `wrist_roll`) are no links.
#[test]
fn info_tells_the_tree_of_a_robot() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/robots/arm.urdf");
    let info: Value = serde_json::from_str(&stdout(&sim(&["info", file, "--json"]))).unwrap();
    let first = |link: &Value, of: &str| link[of][0].as_str().unwrap_or("ground").to_owned();
    let found = info["tree"].as_array().unwrap().iter().map(|link| {
        assert!(link["coordinates"].as_array().unwrap().len() == 1, "{link}");
        (first(link, "bodies"), first(link, "on"), first(link, "coordinates"), link["mass"].as_f64().unwrap())
    });
    let expected = [
        ("turret_body", "ground", "waist", 1.9),
        ("upper_arm_body", "turret_body", "shoulder", 2.2),
        ("forearm_body", "upper_arm_body", "elbow", 1.4),
        ("wrist_body", "forearm_body", "wrist_roll", 0.5),
        ("hand_body", "wrist_body", "wrist_pitch", 0.35),
    ];
    let expected = expected.map(|(body, on, by, mass)| (body.to_owned(), on.to_owned(), by.to_owned(), mass));
    assert_eq!(found.take(expected.len()).collect::<Vec<_>>(), expected);
    let text = stdout(&sim(&["info", file]));
    // What starts where nothing moves it away, and what limits do.
    assert!(text.contains("starts at 0 rad") && !text.contains("start found"), "{text}");
    assert!(text.contains("(noted, not kept)") && text.contains("falling, noted; the motion goes on"), "{text}");
}
