//! Bodies that joints place.

use super::mistakes;

const SOUND: &str = "pub Arm;
parameters { l [m] = 1; m [kg] = 2; A [kg*m^2] = 0.1; g [m/s^2] = 9.81; T [N*m] = 1; }
bodies { lower: mass m, inertia [A, A, A]; upper: mass m, inertia [A, A, A]; }
joints {
    shoulder: revolute ground at [0, 0, l] axis [0, 1, 0] to upper at [0, 0, l/2] axis [0, 1, 0];
    elbow: universal lower at [0, 0, l/2] axis [0, 1, 0] to upper at [0, 0, -l/2] axis [1, 0, 0];
}
loads { gravity [0, 0, -g]; torque T - 0.1*T*sign(dot(shoulder)) on shoulder; torque [0, 0, T] on lower; }
initial { shoulder = 30 [deg]; dot(elbow_2) = 1; }
events { lowest: shoulder = 0; }
outputs { tip [m] = on(lower, [0, 0, -l/2]).z; spin [rad/s] = norm(omega(lower)); }
drawing { line [0, 0, l], on(upper, [0, 0, -l/2]), on(lower, [0, 0, -l/2]); }
";

fn check(replace: &str, by: &str, expected: &[&str]) {
    assert!(SOUND.contains(replace), "{replace}");
    assert_eq!(mistakes(&SOUND.replacen(replace, by, 1)), expected, "\nin: {by}");
}

fn body(line: &str, expected: &[&str]) {
    check("bodies {", &format!("bodies {{ {line}"), expected);
}

fn joint(line: &str, expected: &[&str]) {
    check("\nloads", &format!("joints {{ {line} }}\nloads"), expected);
}

#[test]
fn the_sound_declaration_has_none() {
    check("pub", "pub", &[]);
}

/// On bodies above, placed by joints or not; on the names of Rust's words; and in loops.
#[test]
fn what_joints_place_is_a_body_as_any() {
    check(
        "; }\njoints",
        "; rim: mass m at on(upper, [l, 0, 0]), inertia [A, A, A], attitude attitude(lower); }\njoints",
        &[],
    );
    check("bodies {", "coordinates { s [m]; } bodies { sledge: mass m at [s, 0, 0]; ", &[]);
    joint("stay: ball ground at [l, 0, 0] to lower at [0, 0, 0] initially released;", &[]);
    let stay = "joints { stay: revolute ground at [0, 0, 0] to lower at [0, 0, 0]; } loads";
    let words = [("loads", stay), ("lower", "r#type"), ("shoulder", "r#fn"), ("elbow", "r#while"), ("stay", "r#loop")];
    let renamed = words.iter().fold(SOUND.to_owned(), |text, (name, by)| text.replace(name, by));
    assert_eq!(mistakes(&renamed), [""; 0]);
}

#[test]
fn bodies_that_nothing_places() {
    let lost = |place: &str, name: &str, roll: &str| {
        format!(
            "{place} no joint places `{name}`: none leads to it from the ground or from a placed body{roll}. Join \
             it, write `mass m at P` and `attitude R`, or make it `free`"
        )
    };
    body("hand: mass m, inertia [A, A, A];", &[&lost("3:10", "hand", "")]);
    body("hand: inertia [A, A, A];", &[&lost("3:10", "hand", "")]);
    joint("grip: ball hand at [0, 0, 0] to lower at [0, 0, 0];", &["7:22 no body above is called `hand`"]);
    check("ground at", "base at", &["5:24 no body above is called `base`"]);
    check(
        "elbow: universal lower at [0, 0, l/2] axis [0, 1, 0] to upper at [0, 0, -l/2] axis [1, 0, 0];",
        "elbow: roll lower radius l axis [0, 0, 1] on [0, 0, 0] normal [0, 0, 1];",
        &[&lost("3:10", "lower", "; `roll` is a constraint and places nothing")],
    );
    body(
        "hand: inertia [A, A, A]; } joints { grip: weld hand at [0, 0, 0] to lower at [0, 0, 0]; } bodies {",
        &["3:10 the mass of `hand` is missing: a joint places it, `hand: mass m, inertia [A, B, C];`"],
    );
    // In the plane, and without moments of inertia, joints hold bodies and place none.
    check(
        "lower: mass m, inertia [A, A, A];",
        "lower: mass m, inertia A;",
        &[
            "6:22 body `lower` has no position; write `mass m at P` in its line, or make it `free`",
            "11:24 body `lower` has no position; write `mass m at P` in its line, or make it `free`",
            "12:55 body `lower` has no position; write `mass m at P` in its line, or make it `free`",
        ],
    );
}

#[test]
fn names_of_coordinates() {
    let clash = |name: &str, place: &str, other: &str| {
        [
            format!("{place} `{name}` is the name of a coordinate that this adds; rename this, or the other `{name}`"),
            format!("{other} the other `{name}` is here"),
        ]
    };
    let name =
        |replace: &str, by: &str, expected: [String; 2]| check(replace, by, &expected.each_ref().map(String::as_str));
    name("T [N*m]", "elbow_1 = 2; T [N*m]", clash("elbow_1", "6:5", "2:73"));
    name("T [N*m]", "shoulder = 2; T [N*m]", clash("shoulder", "5:5", "2:73"));
    name("bodies {", "let rim_x = l; bodies { rim: free, mass m, inertia [A, A, A];", clash("rim_x", "3:25", "3:5"));
}

#[test]
fn what_only_constraints_have() {
    check(
        "axis [1, 0, 0];",
        "axis [1, 0, 0] initially released;",
        &[
            "6:5 joint `elbow` places a body, so events cannot switch it; make the body `free`, and the joint becomes a constraint",
        ],
    );
    for (reaction, joint) in [("norm(reaction(shoulder))", "shoulder"), ("[reaction(elbow_m), 0, 0].x", "elbow")] {
        let column = 28 + reaction.find(joint).unwrap();
        check(
            "outputs {",
            &format!("outputs {{ f [N] = norm([0, {reaction}, 0]);"),
            &[&format!(
                "11:{column} joint `{joint}` places a body, so it has no reaction of its own; make the body `free`, and the joint becomes a \
                 constraint, or put an `auxiliary` displacement into its point and take the reaction of that"
            )],
        );
    }
    // What the message says.
    let with_auxiliary = SOUND
        .replacen("ground at [0, 0, l]", "ground at [0, 0, l + s]", 1)
        .replacen("loads", "auxiliary { s [m]; } loads", 1)
        .replacen("outputs {", "outputs { f [N] = reaction(s);", 1);
    assert_eq!(mistakes(&with_auxiliary), [""; 0]);
    for action in ["release", "impact"] {
        let message = "joint `shoulder` places a body, so events cannot switch it; make the body `free`, and the joint becomes a \
                       constraint";
        let column = 31 + action.len();
        check(
            "events {",
            &format!("events {{ off: shoulder = 1 {{ {action} shoulder; }}"),
            &[&format!("10:{column} {message}")],
        );
    }
}

#[test]
fn rotations_by_their_axes() {
    let output = |value: &str, expected: &[&str]| {
        check("= norm(omega(lower))", &format!("= ({value}*omega(lower)).x"), expected)
    };
    output("axes([0, 1, 0], [0, 0, 1], [1, 0, 0])", &[]);
    output("axes([0, cos(shoulder), sin(shoulder)], [0, -sin(shoulder), cos(shoulder)], [1, 0, 0])", &[]);
    output("axes(y, z, x)", &[]);
    let message =
        "`axes(u, v, w)` takes three axes at right angles, the third of them u x v: write `axes(u, v, cross(u, v))`";
    output("axes([0, 1, 0], [1, 0, 0], [0, 0, 1])", &[&format!("11:64 {message}")]);
    output("axes([0, 1, 0], [0, 0.6, 0.8], [1, 0, 0])", &[&format!("11:64 {message}")]);
    output(
        "axes([0, 1, 1], y, z)",
        &["11:69 an axis is a vector of length 1, and this one has 1.4142135623730951; write `u/norm(u)`"],
    );
}
