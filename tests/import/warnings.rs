//! What a file lacks or contradicts is told at its line, and what is made of it.

use crate::{KINDS, declared, imported};
use sim::import::urdf::{Imported, Mimic, Options, import};
use std::path::Path;

/// Parts of a robot between a base and a tip that moves.
fn robot(parts: &str) -> String {
    format!(
        "<robot name=\"r\">\n<link name=\"base\"/>\n{parts}\n\
         <joint name=\"j\" type=\"continuous\"><parent link=\"base\"/><child link=\"tip\"/><axis xyz=\"0 1 0\"/></joint>\n\
         <link name=\"tip\"><inertial><origin xyz=\"1 0 0\"/><mass value=\"2\"/>\
         <inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n</robot>"
    )
}

fn warned(text: &str, options: &Options) -> (Vec<String>, Imported) {
    let found = import(text, Path::new(""), options).map_err(|mistakes| mistakes[0].message.clone()).unwrap();
    (found.warnings.iter().map(|w| format!("{} {}", w.start.line + 1, w.message)).collect(), found)
}

fn check(parts: &str, expected: &[&str]) -> String {
    let (warnings, found) = warned(&robot(parts), &Options::default());
    assert_eq!(warnings, expected, "\nin: {parts}");
    declared(&found.text);
    found.text
}

/// A link that a joint holds to the base.
fn link(joint: &str, inertial: &str) -> String {
    format!(
        "<joint name=\"k\" type=\"revolute\"><parent link=\"base\"/><child link=\"arm\"/>{joint}</joint>\n\
         <link name=\"arm\">{inertial}</link>"
    )
}

const LIMIT: &str = "<limit lower=\"-1\" upper=\"1\"/>";
const INERTIAL: &str =
    "<inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>";

#[test]
fn a_sound_file_has_none() {
    check(&link(LIMIT, INERTIAL), &[]);
    let (warnings, found) = warned(KINDS, &Options::default());
    let names = ["8 `mast.top` is called `mast_top`", "60 `8` is called `link_8`", "75 `flap` is called `flap_link`"];
    assert_eq!(warnings, names);
    declared(&found.text);
}

#[test]
fn limits_are_told() {
    check(&link("", INERTIAL), &["3 joint `k` has no limit, and moves without one"]);
    check(&link("<limit effort=\"3\"/>", INERTIAL), &["3 joint `k` has no range, and moves without one"]);
    let text = check(
        &link("<limit lower=\"1\" upper=\"-1\"/>", INERTIAL),
        &["3 joint `k` cannot move from 1 to -1; it moves without a range"],
    );
    assert!(!text.contains("k_margin"), "{text}");
}

#[test]
fn a_start_lies_within_the_limits() {
    let text = check(&link("<limit lower=\"0.5\" upper=\"2\"/>", INERTIAL), &[]);
    assert!(text.contains("k = 1.25;"), "{text}");
    assert!(check(&link(LIMIT, INERTIAL), &[]).contains("min(k + 1 [rad], 1 [rad] - k)"));
}

#[test]
fn inertias_that_no_body_has_are_told_and_taken() {
    let inertia = |xx: &str, mass: &str| {
        format!(
            "<inertial><mass value=\"{mass}\"/><inertia ixx=\"{xx}\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>"
        )
    };
    let told = "4 link `arm`: no body has this inertia: a principal moment is at most the sum of the other two: 3 is more than 1 + 1 \
                (is it about the centre of mass, in [kg*m^2]?). It is taken as it is";
    let text = check(&link(LIMIT, &inertia("3", "1")), &[told]);
    assert!(text.contains("inertia [3 [kg*m^2], 1 [kg*m^2], 1 [kg*m^2]], unchecked"), "{text}");
    check(
        &link(LIMIT, &inertia("-1", "1")),
        &["4 link `arm`: about some axis this inertia is negative. It is taken as it is"],
    );
    let point = "<inertial><mass value=\"1\"/></inertial>";
    check(
        &link(LIMIT, point),
        &[
            "4 link `arm`: this mass has no extent, a body has a moment of inertia about every axis. It is taken as it is",
        ],
    );
}

#[test]
fn entries_that_are_missing_are_told() {
    let part = "<inertial><inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/></inertial>";
    check(&link(LIMIT, part), &["4 this lacks a mass, ixy, ixz, iyz, which is taken as 0"]);
}

#[test]
fn links_without_mass_are_told() {
    let nothing = "4 link `arm`, moved by joint `k`, has no mass, nor has anything beyond: the acceleration of `k` is not determined";
    check(&link(LIMIT, ""), &[nothing]);
    let beyond = "<joint name=\"l\" type=\"continuous\"><parent link=\"arm\"/><child link=\"hand\"/></joint><link name=\"hand\">";
    check(&(link(LIMIT, "") + beyond + INERTIAL + "</link>"), &["4 link `arm`, moved by joint `k`, has no mass"]);
}

#[test]
fn what_is_not_read_is_listed_once() {
    let parts = "<transmission name=\"a\"/><gazebo/>\n<transmission name=\"b\"/>";
    check(parts, &["3 `transmission` is ignored, here and 1 times more", "3 `gazebo` is ignored"]);
    let dynamics = |attributes: &str| link(&format!("{LIMIT}<dynamics {attributes}/>"), INERTIAL);
    check(&dynamics("dampng=\"1\""), &["3 `dampng` of `dynamics` (did you mean `damping`?) is ignored"]);
    check(&dynamics("damping=\"1\" armature=\"2\""), &["3 `armature` of `dynamics` is ignored"]);
}

/// A joint that slides in a plane has no damping by itself.
#[test]
fn damping_of_joints_with_several_coordinates_is_told() {
    let planar = format!(
        "<joint name=\"k\" type=\"planar\"><parent link=\"base\"/><child link=\"arm\"/>\
         <dynamics damping=\"2\" friction=\"0\"/></joint>\n<link name=\"arm\">{INERTIAL}</link>"
    );
    check(&planar, &["3 damping is known of joints with one coordinate; here it is left out"]);
}

#[test]
fn joints_that_mimic_what_is_not_there_move_by_themselves() {
    let mimic = |joint: &str| format!("{LIMIT}<mimic joint=\"{joint}\"/>");
    check(
        &link(&mimic("other"), INERTIAL),
        &["3 joint `k` mimics `other`, and no joint is called so: it moves by itself"],
    );
    check(&link(&mimic("k"), INERTIAL), &["3 joint `k` mimics `k`, which mimics it: it moves by itself"]);
    let follows = robot(&link(&format!("{LIMIT}<mimic joint=\"j\" multiplier=\"-2\" offset=\"0.5\"/>"), INERTIAL));
    let of = |mimic: Mimic| warned(&follows, &Options { mimic, ..Options::default() }).1.text;
    assert!(of(Mimic::Substitute).contains("rotation(x, (-2*j + 0.5 [rad]))"));
    assert!(of(Mimic::Couple).contains("k_mimic: k = (-2*j + 0.5 [rad]);"));
    assert!(!of(Mimic::Free).contains("-2*j"));
}

#[test]
fn damping_and_friction_are_parameters_that_can_be_left_out() {
    let parts = link(&format!("{LIMIT}<dynamics damping=\"0.7\" friction=\"-1\"/>"), INERTIAL);
    let text = check(&parts, &["3 negative friction would drive the joint; it is left out"]);
    assert!(text.contains("k_damping [N*m*s] = 0.7;") && text.contains("damper k_damping on k;"), "{text}");
    let (_, plain) = warned(&robot(&parts), &Options { damping: false, ..Options::default() });
    assert!(!plain.text.contains("damp"));
}

#[test]
fn rotations_are_set_straight_within_a_bound_and_told_beyond_it() {
    let parts = link(&format!("{LIMIT}<origin rpy=\"1.57079632679 0 0\"/>"), INERTIAL);
    assert!(check(&parts, &[]).contains("axes([1, 0, 0], [0, 0, 1], [0, -1, 0])"));
    let parts = robot(&link(&format!("{LIMIT}<origin rpy=\"1.5708 0 0\"/>"), INERTIAL));
    assert!(!imported(&parts, &Options::default()).text.contains("axes([1, 0, 0], [0, 0, 1], [0, -1, 0])"));
    let (warnings, found) = warned(&parts, &Options { straighten: 1e-5, ..Options::default() });
    assert_eq!(warnings, ["3 this rotation is set straight"]);
    assert!(found.text.contains("axes([1, 0, 0], [0, 0, 1], [0, -1, 0])"));
}

#[test]
fn texts_stay_inert() {
    let hostile = "&lt;/script&gt;&#10;}}; let a = 1;";
    let text = robot("")
        .replace("\"r\"", &format!("\"{hostile}\""))
        .replace("tip", hostile)
        .replace("\"j\"", &format!("\"{hostile}\""));
    let (_, found) = warned(&text, &Options::default());
    let is_documentation = |line: &&str| line.trim_start().starts_with("///");
    assert!(
        found.text.lines().filter(|line| !is_documentation(line)).all(|line| !line.contains("let a")),
        "{}",
        found.text
    );
    declared(&found.text);
}

/// Words of the language, of Rust and of what is generated, as names of joints and links at once.
const WORDS: &[&str] = &[
    "margins",
    "parameters",
    "frames",
    "outputs",
    "rotation",
    "min",
    "t",
    "e",
    "pi",
    "g",
    "x",
    "y",
    "z",
    "S",
    "sim",
    "mass",
    "angle",
    "at",
    "on",
    "attitude",
    "free",
    "inertia",
    "force",
    "torque",
    "damper",
    "friction",
    "smooth",
    "falling",
    "record",
    "repeat",
    "fragment",
    "use",
    "unchecked",
    "initially",
    "released",
    "omega",
    "work",
    "stretch",
    "rate",
    "self",
    "Self",
    "crate",
    "type",
    "fn",
    "match",
    "true",
    "async",
    "pub",
    "sin",
    "atan2",
    "cross",
    "axes",
    "t_end",
    "core",
    "_",
    "__",
    "-a",
    "1a",
    "S_",
    "ground",
    "tau_x",
    "x_dot",
    "\u{e9}",
    "\u{65e5}\u{672c}",
];

#[test]
fn any_word_can_name_a_joint_and_a_link() {
    let mut text = "<robot name=\"self\">\n<link name=\"base\"/>\n".to_owned();
    for (k, word) in WORDS.iter().enumerate() {
        let kind = ["revolute", "prismatic", "continuous"][k % 3];
        text += &format!(
            "<joint name=\"{word}\" type=\"{kind}\"><parent link=\"base\"/><child link=\"{word}\"/>{LIMIT}\
             <dynamics damping=\"1\" friction=\"1\"/></joint>\n<link name=\"{word}\">{INERTIAL}</link>\n"
        );
    }
    text += "</robot>";
    for options in [Options::default(), Options { stops: true, ..Options::default() }] {
        let model = declared(&imported(&text, &options).text);
        assert_eq!(model.description().coordinates.len(), WORDS.len());
    }
}

/// What was found wrong by a review, each with what is told of it.
#[test]
fn what_counts_is_the_first_of_two() {
    let heavy = INERTIAL.replace("mass value=\"1\"", "mass value=\"7\"");
    let text =
        check(&link(LIMIT, &(INERTIAL.to_owned() + &heavy)), &["4 a second `inertial` is left out: the first counts"]);
    assert!(text.contains("arm_body: mass 1 [kg]"), "{text}");
    let axes = "<axis xyz=\"0 0 1\"/><axis xyz=\"0 1 0\"/>";
    let text = check(&link(&format!("{LIMIT}{axes}"), INERTIAL), &["3 a second `axis` is left out: the first counts"]);
    assert!(text.contains("rotation(z, k)"), "{text}");
}

#[test]
fn followers_start_where_their_leader_has_them() {
    let mimic = format!("{LIMIT}<mimic joint=\"j\" multiplier=\"2\" offset=\"1.5\"/>");
    let told = "3 joint `k` follows another, and starts at 1.5, outside of these limits";
    check(&link(&mimic, INERTIAL), &[told]);
    let follows = robot(&link(&mimic.replace("1.5", "0.5"), INERTIAL));
    let (_, found) = warned(&follows, &Options { mimic: Mimic::Couple, ..Options::default() });
    assert!(found.text.contains("    j = 0;"), "{}", found.text);
    let still = mimic.replace("multiplier=\"2\"", "multiplier=\"0\"");
    check(&link(&still, INERTIAL), &["3 joint `k` mimics `j` by 0 times its value: it moves by itself"]);
}

/// The limits of a follower that its leader would pass stop both; those that come after the leader's need no stop.
#[test]
fn followers_stop_their_leaders() {
    let slide = "<limit lower=\"-0.1\" upper=\"0.5\"/><axis xyz=\"0 0 1\"/><mimic joint=\"j\" multiplier=\"-2\" offset=\"0.3\"/>";
    let text = robot(&link(slide, INERTIAL).replace("revolute", "prismatic"));
    let text = imported(&text, &Options { stops: true, ..Options::default() }).text;
    for side in ["lower", "upper"] {
        assert!(text.contains(&format!("k_{side}_hit: (-2 [m]*j + 0.3 [m]) = ")), "{text}");
    }
    let after = slide.replace("-0.1", "-10").replace("0.5", "10");
    let text = robot(&link(&after, INERTIAL).replace("revolute", "prismatic"));
    let text = text.replace("type=\"continuous\">", &format!("type=\"revolute\">{LIMIT}"));
    let text = imported(&text, &Options { stops: true, ..Options::default() }).text;
    assert!(!text.contains("_hit: (-2") && text.contains("k_limit: "), "{text}");
}

/// On a slide that starts amid its range, with a link that floats from there.
#[test]
fn floating_links_start_on_the_links_before_them() {
    let slide =
        link("<limit lower=\"1\" upper=\"3\"/><axis xyz=\"0 0 1\"/>", INERTIAL).replace("revolute", "prismatic");
    let afloat =
        "<joint name=\"f\" type=\"floating\"><parent link=\"arm\"/><child link=\"c\"/></joint><link name=\"c\">";
    let text = check(&format!("{slide}{afloat}{INERTIAL}</link>"), &[]);
    assert!(text.contains("c_body_z = 2;") && text.contains("k = 2;"), "{text}");
}

#[test]
fn a_limit_is_passed_where_a_joint_starts_on_it() {
    let slide =
        link("<limit lower=\"0\" upper=\"1\"/><axis xyz=\"0 0 1\"/>", INERTIAL).replace("revolute", "prismatic");
    let text = check(&slide, &[]);
    assert!(text.contains("= -1e-9 [m] falling;"), "{text}");
}

#[test]
fn what_cannot_be_drawn_is_no_mistake() {
    let visual = |form: &str| format!("{INERTIAL}<visual><geometry>{form}</geometry></visual>");
    let box_told = "4 `1` is not three numbers, as in `0 0 0.1`; this is not drawn";
    check(&link(LIMIT, &visual("<box size=\"1\"/>")), &[box_told]);
    check(&link(LIMIT, &visual("<box size=\"1e305 1 1\"/>")), &[]);
}
