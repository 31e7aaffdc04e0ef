//! What is refused, at its place.

use sim::import::urdf::{Base, Options, import};
use std::path::Path;

/// A sound robot of two links.
const ROBOT: &str = r#"<robot name="two">
  <link name="a"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="j" type="revolute">
    <parent link="a"/> <child link="b"/>
    <origin xyz="0 0 1"/> <axis xyz="0 0 1"/> <limit lower="-1" upper="1"/>
  </joint>
  <link name="b"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
</robot>"#;

/// The mistakes of a robot in which one part is replaced, as `line:column message`.
fn mistakes(replace: &str, by: &str) -> Vec<String> {
    assert!(ROBOT.contains(replace), "{replace}");
    let text = ROBOT.replacen(replace, by, 1);
    match import(&text, Path::new(""), &Options::default()) {
        Ok(_) => Vec::new(),
        Err(all) => all.iter().map(|m| format!("{}:{} {}", m.start.line + 1, m.start.column + 1, m.message)).collect(),
    }
}

fn check(replace: &str, by: &str, expected: &[&str]) {
    assert_eq!(mistakes(replace, by), expected, "\nin: {by}");
}

#[test]
fn a_sound_robot_is_accepted() {
    check("two", "two", &[]);
}

#[test]
fn what_is_no_robot_is_refused() {
    check("<robot name=\"two\">", "<sdf>", &["8:1 this is no XML: expected 'sdf' tag, not 'robot' at 8:1"]);
    let empty = import("<robot name=\"x\"/>", Path::new(""), &Options::default()).unwrap_err();
    assert_eq!(empty[0].message, "there is no robot here: a robot has a `<link name=\"..\">` at least");
    let other = import("<sdf/>", Path::new(""), &Options::default()).unwrap_err();
    assert_eq!(other[0].message, "this is `<sdf>`, and the root of a URDF is `<robot name=\"..\">`");
    let type_of_document = "<!DOCTYPE robot [<!ENTITY a \"b\">]><robot name=\"two\">";
    let found = mistakes("<robot name=\"two\">", type_of_document);
    assert!(found[0].starts_with("1:1 a document type is not read"), "{found:?}");
}

#[test]
fn macros_name_the_command_that_expands_them() {
    const SAID: &str =
        "this is a macro, and the file is to be expanded first: `xacro robot.urdf.xacro > robot.urdf`, of ROS";
    check("0 0 1\"/> <axis", "0 0 ${height}\"/> <axis", &[&format!("5:5 {SAID}")]);
    let space = "<robot name=\"two\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><xacro:include filename=\"a\"/>";
    check("<robot name=\"two\">", space, &[&format!("1:63 {SAID}")]);
}

#[test]
fn numbers_words_and_names_are_checked() {
    check("0 0 1\"/> <axis", "0 0 a\"/> <axis", &["5:18 `0 0 a` is not three numbers, as in `0 0 0.1`"]);
    check("0 0 1\"/> <axis", "0 0\"/> <axis", &["5:18 `0 0` is not three numbers, as in `0 0 0.1`"]);
    check("<mass value=\"1\"/>", "<mass value=\"1e999\"/>", &["2:41 `1e999` is not a number"]);
    check("<mass value=\"1\"/>", "<mass value=\"-1\"/>", &["2:28 a mass cannot be negative"]);
    check("axis xyz=\"0 0 1\"", "axis xyz=\"0 0 0\"", &["5:38 an axis has a direction, and this one is 0"]);
    let kinds = "known are revolute, continuous, prismatic, fixed, floating, planar";
    check(
        "revolute",
        "revolut",
        &[&format!("3:25 no joint is of the type `revolut` (did you mean `revolute`?); {kinds}")],
    );
    check("parent link=\"a\"", "parent link=\"base\"", &["4:19 no link is called `base`"]);
    check("<parent link=\"a\"/>", "", &["3:3 joint `j` has no `<parent link=\"..\"/>`"]);
    check("<joint name=\"j\"", "<joint", &["3:3 `<joint>` needs the attribute `name`"]);
    check("<link name=\"b\">", "<link name=\"a\"/><link name=\"b\">", &["7:3 two links are called `a`"]);
}

#[test]
fn a_robot_is_one_tree() {
    let lone = "<link name=\"c\"/><link name=\"b\">";
    check("<link name=\"b\">", lone, &["7:3 two links are held by no joint, `a` and `c`; a robot has one root"]);
    let twice = "<joint name=\"k\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint><link name=\"b\">";
    let found = mistakes("<link name=\"b\">", twice);
    assert!(
        found[0].starts_with("7:3 link `b` is held by two joints, `j` and this one: URDF describes trees."),
        "{found:?}"
    );
    let closed = "<joint name=\"k\" type=\"fixed\"><parent link=\"b\"/><child link=\"a\"/></joint><link name=\"b\">";
    check("<link name=\"b\">", closed, &["2:3 every link is held by another: the joints form a loop"]);
    let apart = "<link name=\"c\"/><link name=\"d\"/>\
        <joint name=\"k\" type=\"fixed\"><parent link=\"c\"/><child link=\"d\"/></joint>\
        <joint name=\"l\" type=\"fixed\"><parent link=\"d\"/><child link=\"c\"/></joint><link name=\"b\">";
    check("<link name=\"b\">", apart, &["7:3 link `c` is held by links that it holds itself: the joints form a loop"]);
}

#[test]
fn what_does_not_move_is_refused_on_a_fixed_base_alone() {
    check(
        "revolute",
        "fixed",
        &["2:3 nothing moves: no joint of this robot does. A free root does, `sim import FILE --base free`"],
    );
    let free = Options { base: Base::Free, ..Options::default() };
    assert!(import(&ROBOT.replace("revolute", "fixed"), Path::new(""), &free).is_ok());
}
