//! How a mechanism is run.

use super::check_without_units as check;

/// Replaces `initial {` of line 7 by a block in front of it.
fn run(block: &str, expected: &[&str]) {
    check("initial {", &format!("events {{ down: phi = 0; }} run {{ {block} }} initial {{"), expected);
}

#[test]
fn settings_are_those_of_the_command_line() {
    run("t_end = 30 [ms]; method = radau5; rtol = 1e-11; atol = 1e-9; rows = 600; until = down: 3;", &[]);
    run("t_end = 3; method = rk4; steps = 100; rows = steps; until = down; projection = mass_projection;", &[]);
    run(
        "tend = 30 [ms];",
        &[
            "7:33 `tend` is no setting of a run (did you mean `t_end`?); settings are `t_end`, `method`, `rtol`, `atol`, \
           `steps`, `step`, `projection`, `rows`, `until`",
        ],
    );
    run("rtol = 1e-9; rtol = 1e-8;", &["7:46 `rtol` is set twice"]);
}

#[test]
fn values_are_of_their_kind() {
    run("t_end = 30 [mm];", &["7:44 `mm` is no unit of time; write `[s]` or `[ms]`"]);
    run("t_end = 0;", &["7:41 a time above 0 is needed"]);
    run("t_end = down;", &["7:41 a time is needed: `t_end = 30 [ms];`"]);
    run("rtol = 1e-9 [m];", &["7:40 a number above 0 is needed: `rtol = 1e-11;`"]);
    run("steps = 1.5;", &["7:41 a whole number above 0 is needed: `steps = 8192;`"]);
    run("rows = all;", &["7:40 a whole number above 0, or `steps`, is needed: `rows = 600;`"]);
    run(
        "method = dop835;",
        &[
            "7:42 no method is called `dop835` (did you mean `dop853`?); there are `euler`, `heun`, `rk3`, `rk4`, `dopri5`, \
           `radau5`, `dop853`",
        ],
    );
    run("until = up;", &["7:41 no event is called `up`; there are `down`"]);
    run("until = down: 0;", &["7:47 a whole number above 0 is needed"]);
    run("projection = 3;", &["7:46 a projection is needed: `projection = partitioning;`"]);
}

#[test]
fn steps_are_equal_or_chosen() {
    run(
        "steps = 100; rtol = 1e-9;",
        &["7:46 `rtol` and `steps` exclude each other: steps are equal, or chosen by a tolerance"],
    );
    run("method = rk4; rtol = 1e-9;", &["7:47 rk4 takes equal steps and has no tolerance; give `steps` or `step`"]);
    run("rtol = 1e-9; method = rk4;", &["7:46 rk4 takes equal steps and has no tolerance; give `steps` or `step`"]);
}

/// A declaration in a newer language is refused at its number.
#[test]
fn a_newer_language_is_refused() {
    let mistakes = |text: &str| match codegen::dsl::declarations(text) {
        Ok(all) => all
            .iter()
            .map(|declaration| codegen::dsl::parse_head(declaration.clone()).unwrap().name.to_string())
            .collect(),
        Err(mistakes) => {
            vec![format!("{}:{} {mistakes}", mistakes.span().start().line, mistakes.span().start().column + 1)]
        }
    };
    let body = "pub Bob; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; }";
    assert_eq!(mistakes(&format!("language 1; {body}")), ["Bob"]);
    assert_eq!(mistakes(&format!("mechanism! {{ language 1; {body} }}")), ["Bob"]);
    let newer =
        "this is written in language 2, which this program does not know: it reads language 1. Take a newer Linkwright";
    assert_eq!(mistakes(&format!("language 2; {body}")), [format!("1:10 {newer}")]);
    assert_eq!(mistakes(&format!("mechanism! {{ language 2; {body} }}")), [format!("1:23 {newer}")]);
    let form = "the version of the language is needed, and a semicolon: `language 1;`";
    assert_eq!(mistakes(&format!("language; {body}")), [format!("1:1 {form}")]);
    assert_eq!(mistakes(&format!("language 1.5; {body}")), ["1:10 the version of the language is 1: `language 1;`"]);
}
