//! Mistakes in `frames`.

use crate::mistakes;

/// A sound arm with a frame, in which one part is replaced.
const ARM: &str = "pub Arm;
coordinates { a [rad]; b [rad]; }
frames { upper: at [0, 0, 0], attitude rotation(y, a); lower: at on(upper, [1 [m], 0, 0]), attitude attitude(upper)*rotation(y, b); }
bodies { link: mass 1 [kg] at on(lower, [1 [m], 0, 0]), inertia [0.1 [kg*m^2], 0.1 [kg*m^2], 0.1 [kg*m^2]], attitude attitude(lower); }
";

fn check(replace: &str, by: &str, expected: &[&str]) {
    assert!(ARM.contains(replace), "{replace}");
    assert_eq!(mistakes(&ARM.replacen(replace, by, 1)), expected, "\nin: {by}");
}

#[test]
fn a_frame_has_a_place_and_an_attitude() {
    assert_eq!(mistakes(ARM), Vec::<String>::new());
    const FORM: &str = "a frame is written `name: at P, attitude R;`, in the plane `name: at P, angle phi;`";
    let form = |place: &str| format!("{place} expected `at`: `{FORM}`");
    check("upper: at [0, 0, 0]", "upper: [0, 0, 0]", &[&form("3:17")]);
    check(", attitude rotation(y, a)", "", &[&format!("3:29 {FORM}")]);
    check(
        "attitude rotation(y, a)",
        "rotation(y, a)",
        &["3:31 `rotation` is not known here; expected one of `angle`, `attitude`"],
    );
}

#[test]
fn a_frame_stands_on_what_is_above_it() {
    const BELOW: &str = "this frame is declared here or below; a frame stands on others above it";
    check("at [0, 0, 0]", "at on(lower, [0, 0, 0])", &[&format!("3:23 {BELOW}")]);
    check("at on(upper,", "at on(lower,", &[&format!("3:69 {BELOW}")]);
    check("at on(upper,", "at on(uper,", &["3:69 no body above is called `uper` (did you mean `upper`?)"]);
}

#[test]
fn frames_are_checked_whether_used_or_not() {
    let place = "at [0, 0, 0], attitude rotation(y, a); tool: at [0, 0, a], attitude rotation(y, a)";
    check(
        "at [0, 0, 0], attitude rotation(y, a)",
        place,
        &[
            "3:65 the place of a frame is in [m], and `place_of_tool` is a pure number",
            "3:56 `place_of_tool` is defined here (a [rad])",
        ],
    );
    let moving = "at [0, 0, 0], attitude rotation(y, dot(a))";
    let rule = "the angle of a rotation is made of coordinates, parameters and time; `dot()` cannot stand in it";
    check("at [0, 0, 0], attitude rotation(y, a)", moving, &[&format!("3:52 {rule}")]);
}

#[test]
fn frames_and_bodies_have_names_of_their_own() {
    let twice = [
        "3:10 `link` is defined twice; choose another name for one of them",
        "4:10 the first definition of `link` is here",
    ];
    check("frames { upper", "frames { link: at [0, 0, 0], attitude rotation(y, a); upper", &twice);
}

#[test]
fn an_impossible_inertia_is_taken_unchecked_alone() {
    let replace = "inertia [0.1 [kg*m^2], 0.1 [kg*m^2], 0.1 [kg*m^2]]";
    let impossible = "inertia [0.1 [kg*m^2], 0.1 [kg*m^2], 0.3 [kg*m^2]]";
    let why = "no body has this inertia: a principal moment is at most the sum of the other two: 0.3 is more than 0.1 + 0.1 \
               (is it about the centre of mass, in [kg*m^2]?)";
    check(replace, impossible, &[&format!("4:65 {why}")]);
    check(replace, &format!("{impossible}, unchecked"), &[]);
}
