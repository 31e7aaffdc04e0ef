//! Vectors in the wrong frame.

use super::mistakes;

const SOUND: &str = "pub Two;
coordinates { a [rad]; b [rad]; }
parameters { l [m] = 1; m [kg] = 2; J [kg*m^2] = 0.1; g [m/s^2] = 9.81; F [N] = 1; }
let R = rotation(z, a);
bodies {
    one: mass m at R*[l, 0, 0], inertia [J, J, J], attitude R;
    two: mass m at on(one, [l, 0, 0]), inertia [J, J, J], attitude attitude(one)*rotation(x, b);
}
loads { gravity [0, 0, -g]; force [F, 0, 0] at on(two, [0, l, 0]); torque [F*l, 0, 0] on one; }
constraints { hold: on(two, [0, 0, l]) = [l, 0, 0]; }
outputs { x = (R*[1, 0, 0]).x; }
drawing { line [0, 0, 0], on(one, [0, 0, 0]); }
";

/// Replaces a part; the mistake is where `#` stands.
fn check(replace: &str, by: &str, message: &str) {
    assert!(SOUND.contains(replace), "{replace}");
    let marked = SOUND.replacen(replace, by, 1);
    let before = marked.split('#').next().unwrap();
    let (line, column) =
        (before.matches('\n').count() + 1, before.len() - before.rfind('\n').map_or(0, |at| at + 1) + 1);
    assert_eq!(mistakes(&marked.replacen('#', "", 1)), [format!("{line}:{column} {message}")], "\nin: {by}");
}

fn sound(replace: &str, by: &str) {
    assert!(SOUND.contains(replace), "{replace}");
    assert_eq!(mistakes(&SOUND.replacen(replace, by, 1)), [""; 0], "\nin: {by}");
}

const OUTPUT: &str = "x = (R*[1, 0, 0]).x";

fn output(value: &str, message: &str) {
    check(OUTPUT, &format!("x [1/s] = ({value}).x"), message);
}

const WORLD_NOT_ONE: &str =
    "this vector v is in the world's frame, but one in the frame of `one` is needed: `transpose(attitude(one))*v`";
const WORLD_NOT_TWO: &str =
    "this vector v is in the world's frame, but one in the frame of `two` is needed: `transpose(attitude(two))*v`";
const ONE_NOT_WORLD: &str =
    "this vector v is in the frame of `one`, but one in the world's frame is needed: `attitude(one)*v`";
const ONE_NOT_TWO: &str = "this vector v is in the frame of `one`, but one in the frame of `two` is needed: \
                           `transpose(attitude(two))*(attitude(one)*v)`";

#[test]
fn vectors_in_their_own_frames_are_none() {
    sound("pub", "pub");
    for value in [
        "omega(one) + omega(two)",
        "transpose(attitude(one))*omega(two) + [1 [1/s], 0, 0]",
        "attitude(two)*(transpose(attitude(two))*omega(one)) - omega(one)",
        "cross(attitude(one)*[1, 0, 0], omega(one))",
        "inner(omega(one), attitude(two)*[0, 0, 1])*[1, 0, 0]",
        "dot(attitude(one)*[1, 0, 0]) + omega(one)",
        "if a > 0 then omega(one) else [0, 0, 0]",
        "-2*omega(one)/3 + omega(two)",
        "transpose(attitude(two))*attitude(one)*(transpose(attitude(one))*omega(one)) + transpose(attitude(two))*omega(two)",
        "angular_velocity(attitude(one)*rotation(y, a)) + omega(one)",
        // Rotations that no body's `attitude(..)` stands in say nothing of frames.
        "R*omega(one) + transpose(R)*omega(one)",
        "R*(transpose(attitude(two))*omega(one)) + omega(one)",
        "attitude(one)*transpose(attitude(two))*omega(one)",
        "attitude(one)*[omega(one).x, omega(one).y, 0]",
    ] {
        sound(OUTPUT, &format!("x [1/s] = ({value}).x"));
    }
}

#[test]
fn what_a_body_takes_is_in_its_own_frame() {
    check("on(two, [0, l, 0])", "on(two, #on(one, [0, l, 0]))", WORLD_NOT_TWO);
    output("attitude(one)*#omega(one)", WORLD_NOT_ONE);
    output("transpose(attitude(one))*#(transpose(attitude(one))*omega(two))", ONE_NOT_WORLD);
    output("attitude(two)*#(transpose(attitude(one))*omega(one))", ONE_NOT_TWO);
    check(
        "constraints {",
        "joints { pivot: ball one at [0, 0, 0] to two at #on(one, [0, 0, 0]); } constraints {",
        WORLD_NOT_TWO,
    );
    check(
        "}\nloads",
        "three: mass m, inertia [J, J, J]; } joints { pin: revolute two at [0, 0, 0] to three at #on(one, [0, 0, 0]); }\nloads",
        "this vector v is in the world's frame, but one in the frame of `three` is needed: `transpose(attitude(three))*v`",
    );
}

#[test]
fn vectors_together_are_in_one_frame() {
    let own = "transpose(attitude(one))*omega(one)";
    output(&format!("omega(one) + #{own}"), ONE_NOT_WORLD);
    output(&format!("#{own} - omega(one)"), ONE_NOT_WORLD);
    output(
        &format!("{own} - #transpose(attitude(two))*omega(one)"),
        "this vector v is in the frame of `two`, but one in the frame of `one` is needed: \
         `transpose(attitude(one))*(attitude(two)*v)`",
    );
    output(&format!("cross(omega(one), #{own})"), ONE_NOT_WORLD);
    output(&format!("inner(omega(one), #{own})*[1 [s], 0, 0]"), ONE_NOT_WORLD);
    output(&format!("if a > 0 then omega(one) else #{own}"), ONE_NOT_WORLD);
    sound("= [l, 0, 0];", "= transpose(R)*[l, 0, 0];");
    check("= [l, 0, 0];", "= #transpose(attitude(one))*on(one, [l, 0, 0]);", ONE_NOT_WORLD);
}

#[test]
fn forces_and_places_are_in_the_worlds_frame() {
    let own = "transpose(attitude(one))*[0, 0, 1]";
    check("[0, 0, -g]", &format!("#-g*({own})"), ONE_NOT_WORLD);
    check("force [F, 0, 0]", &format!("force #F*({own})"), ONE_NOT_WORLD);
    check("at on(two, [0, l, 0])", &format!("at #l*({own})"), ONE_NOT_WORLD);
    check("torque [F*l, 0, 0]", &format!("torque #F*l*({own})"), ONE_NOT_WORLD);
    check("at on(one, [l, 0, 0])", &format!("at #l*({own})"), ONE_NOT_WORLD);
    sound("attitude attitude(one)*rotation(x, b)", "attitude rotation(x, b)*transpose(attitude(one))");
    check(
        "attitude attitude(one)*",
        "attitude #transpose(attitude(one))*",
        "this rotation R turns vectors into the frame of `one`, but an attitude turns them into the world's frame: `attitude(one)*R`",
    );
    check("line [0, 0, 0]", &format!("line #l*({own})"), ONE_NOT_WORLD);
}
