//! Tables, and joints by them.

use super::{SOUND, mistakes, without_units};

/// The sound declaration with a table `lift` of these words and rows, and a use of it.
fn table(written: &str, expected: &[&str]) {
    let text = SOUND.replacen("let P", &format!("tables {{ {written} }} let P"), 1);
    assert_eq!(mistakes(&text), expected, "\nin: {written}");
}

/// The sound declaration with a table over degrees, and another output.
fn used(output: &str, expected: &[&str]) {
    let tables = "tables { lift [mm] over [deg] = cubic { 0, 0; 90, 10; } gain = linear { 0, 1; 1, 2; } } let P";
    let text = SOUND.replacen("let P", tables, 1).replacen("outputs {", &format!("outputs {{ {output}"), 1);
    assert_eq!(mistakes(&text), expected, "\nin: {output}");
}

#[test]
fn forms() {
    table("lift [mm] over [deg] = cubic, clamped, held { 0, 0; 90, 10; 2 [rad], 0.1 [m]; }", &[]);
    table("lift [mm] over [deg] = cubic, periodic { repeat i in 0..9 { 40*i, i*(9 - i); } 360, 0; };", &[]);
    table("", &[]);
    const FORM: &str = "a table is written `lift [mm] over [deg] = cubic, periodic { 0, 0; 90, 10; 360, 0; }`";
    table("lift { 0, 0; 1, 1; }", &[&format!("4:15 {FORM}")]);
    table("lift [mm] deg = linear { 0, 0; 1, 1; }", &["4:20 expected `over`: `lift [mm] over [deg] = ..`"]);
    table(
        "lift [mm] over = linear { 0, 0; 1, 1; }",
        &["4:25 `over` is followed by the unit of the arguments: `over [deg]`"],
    );
    table(
        "lift = spline { 0, 0; 1, 1; }",
        &[
            "4:17 `spline` is not known here; expected one of `linear`, `cubic`, `monotone`, `natural`, `clamped`, `held`, \
           `continued`, `periodic`",
        ],
    );
    table(
        "lift = periodic { 0, 0; 1, 0; }",
        &[&format!("4:10 table `lift` is `linear`, `cubic` or `monotone`; {FORM}")],
    );
    table(
        "lift = linear, cubic { 0, 0; 1, 1; }",
        &["4:25 `cubic` repeats or contradicts an earlier word; give one word of each kind"],
    );
    table(
        "lift = linear cubic { 0, 0; 1, 1; }",
        &[&format!("4:24 expected `,`, the rows in braces or `from` a file; {FORM}")],
    );
    table("lift = linear [0, 0; 1, 1];", &[&format!("4:24 expected `,`, the rows in braces or `from` a file; {FORM}")]);
    table("lift = linear { 0, 0; 1; 2, 3; }", &["4:33 a row is an argument and a value: `90, 10;`"]);
    table("lift = linear { 0, 0; 1, 2, 3; }", &["4:36 a row is an argument and a value: `90, 10;`, and no more"]);
    table("lift = linear { 0, 0; 1, 2 }", &["4:37 expected `;` at the end of this line"]);
    table("lift = linear { (0, 0), (1, 2) }", &["4:28 a vector is written in square brackets: `[x, y]`"]);
}

#[test]
fn rows() {
    table("lift = linear { }", &["4:10 table `lift` has no rows; a row is an argument and a value: `90, 10;`"]);
    table("lift = linear { 0, 1; }", &["4:10 table `lift` has one row; a function is given by two or more"]);
    table(
        "lift = linear { 0, 1; 2, 1; 1, 5; }",
        &["4:38 the arguments of a table must increase from row to row; 1 follows 2"],
    );
    table(
        "lift = linear { 0, 1; 2, 1; 2, 5; }",
        &["4:38 the arguments of a table must increase from row to row; 2 is in the row above too"],
    );
    table(
        "lift = linear { 0, 1; 2, l; }",
        &["4:35 the rows of a table are numbers, which are known when the mechanism is built"],
    );
    table(
        "lift = cubic, periodic { 0, 1; 2, 3; 4, 5; }",
        &["4:50 the last row of a periodic table must repeat the value of the first, 1; this is 5"],
    );
    table(
        "lift [mm] = cubic, periodic { 0, 1; 2, 3; 4, 1*(1 + 1e-11); }",
        &["4:55 the last row of a periodic table must repeat the value of the first, 1; this is 1.00000000001"],
    );
    table("lift = cubic, periodic { 0, 1000*sin(0); 2, 1000; 4, 1000*sin(2*pi); }", &[]);
    table(
        "lift = cubic, natural, periodic { 0, 1; 2, 3; 4, 1; }",
        &["4:24 a periodic table has no ends; leave out `natural` or `clamped`"],
    );
    table("lift = linear, clamped { 0, 1; 2, 3; }", &["4:25 only a `cubic` table can be `natural` or `clamped`"]);
    table("lift = linear { 0, 1; 2, sqrt(-1); }", &["4:35 this is not a finite real number"]);
    table(
        "lift = cubic { 0, 1; 1e-200, 3; 2e-200, 1; }",
        &["4:10 the values of table `lift` change too steeply for the range of numbers"],
    );
}

#[test]
fn units() {
    table(
        "lift [mm] over [deg] = linear { 0, 0; 90, 10 [deg]; }",
        &["4:52 the values of table `lift` are in [mm], and `10 [deg]` is in [deg]"],
    );
    table(
        "lift [mm] over [deg] = linear { 0, 0; 90 [mm], 10; }",
        &["4:48 the arguments of table `lift` are in [deg], and `90 [mm]` is in [mm]"],
    );
    table(
        "lift over [deg] = linear { 0, 0; 90, 10 [mm]; }",
        &["4:47 the values of table `lift` are pure numbers, and `10 [mm]` is in [mm]"],
    );
    table("lift [mn] over [dag] = linear { 0, 0; 90, 10; }", &["4:16 `mn` is not a known unit (did you mean `mN`?)"]);
    used(
        "v [m] = lift(l);",
        &["8:24 table `lift` is over [deg], and `l` is in [m]", "3:14 `l` is declared in [m] here"],
    );
    used(
        "v = lift(phi);",
        &["8:15 output `v` is declared without a unit (write `v [m]`), and `lift(phi)` is in [m] (phi [rad])"],
    );
    used(
        "v [m] = gain(l);",
        &[
            "8:24 table `gain` is over pure numbers (`over [..]` says which unit its arguments have), and `l` is in [m]",
            "3:14 `l` is declared in [m] here",
        ],
    );
    used("v [m] = gain(phi);", &["8:19 output `v` is declared in [m], and `gain(phi)` is a pure number (phi [rad])"]);
}

#[test]
fn headings() {
    let headed = |headings: &str, expected: &[&str]| {
        table(&format!("lift [mm] over [deg] = linear {{ {headings}; 0, 0; 90, 10; }}"), expected);
    };
    for sound in
        ["angle [deg]\", \"lift [mm]", "angle\", \"lift", "phi (deg)\", \"lift (of the valve)", "a/b\", \"lift / mm"]
    {
        headed(&format!("\"{sound}\""), &[]);
    }
    table(r#"x = linear { "a [-]", "b []"; 0, 0; 90, 10; }"#, &[]);
    table(r#"x [m/s] over [rad/s] = linear { "omega rad/s", "v m/s"; 0, 0; 90, 10; }"#, &[]);
    table(r#"x [J] over [1] = linear { "a [rad]", "b [N*m]"; 0, 0; 90, 10; }"#, &[]);
    let declared = |column, said, declared| {
        format!("the heading says that the {column} of table `lift` are in [{said}]; they are declared in [{declared}]")
    };
    headed(r#""angle [deg]", "lift [m]""#, &[&format!("4:57 {}", declared("values", "m", "mm"))]);
    headed(r#""angle (rad)", "lift""#, &[&format!("4:42 {}", declared("arguments", "rad", "deg"))]);
    headed(r#""angle/rad", "lift/mm""#, &[&format!("4:42 {}", declared("arguments", "rad", "deg"))]);
    headed(r#""angle in deg", "lift in m""#, &[&format!("4:58 {}", declared("values", "m", "mm"))]);
    headed(r#""angle [rad] since the start", "lift""#, &[&format!("4:42 {}", declared("arguments", "rad", "deg"))]);
    headed(r#""angle", "lift (m) (smoothed)*""#, &[&format!("4:51 {}", declared("values", "m", "mm"))]);
    headed(r#""angle", "lift in m (raw)""#, &[&format!("4:51 {}", declared("values", "m", "mm"))]);
    headed(r#""angle", "lift (mm) in m""#, &[&format!("4:51 {}", declared("values", "m", "mm"))]);
    headed(r#""angle (A) (deg)", "channel (A) lift (mm)""#, &[]);
    for said in ["lift m", "lift {m}", "lift (in m)", "lift, m"] {
        headed(&format!(r#""angle", "{said}""#), &[&format!("4:51 {}", declared("values", "m", "mm"))]);
    }
    for sound in ["lift mm", "m", "lift s", "lift_m", "lift m [mm]", "lift of valve"] {
        headed(&format!(r#""angle 1", "{sound}""#), &[]);
    }
    headed(r#""angle [-]", "lift""#, &[&format!("4:42 {}", declared("arguments", "1", "deg"))]);
    headed(
        r#""angle [°]", "lift""#,
        &["4:42 the heading says [°], which is no unit; write one such as `[deg]` or `[1]`, or none"],
    );
    headed(
        r#""angle [deg]""#,
        &["4:55 a heading has two texts, for the arguments and for the values: `\"t [s]\", \"F [N]\";`"],
    );
}

#[test]
fn uses() {
    used("v [m] = lift;", &["8:19 `lift` is a table; it takes an argument: `lift(x)`"]);
    used("v [m] = lift(phi, 2);", &["8:19 table `lift` is written `lift(x)`: 1 argument wanted, 2 given"]);
    used(
        "v [m] = lift([1, 2]);",
        &["8:24 a vector stands where a scalar belongs; take a component (`.x`, `.y`) or `norm(..)`"],
    );
    used("v [m] = lyft(phi);", &["8:19 no function is called `lyft` (did you mean `lift`?)"]);
    let again = |written: &str, expected: &[&str]| {
        let tables = format!("tables {{ lift = linear {{ 0, 0; 1, 1; }} }} {written} let P");
        assert_eq!(mistakes(&without_units(SOUND).replacen("let P", &tables, 1)), expected, "\nin: {written}");
    };
    let first = "4:10 the first definition of `lift` is here";
    again("let lift = 2;", &["4:46 `lift` is defined twice; choose another name for one of them", first]);
    again("parameters { lift = 2; }", &["4:55 `lift` is defined twice; choose another name for one of them", first]);
    again(
        "tables { lift = linear { 0, 0; 1, 1; } }",
        &["4:51 `lift` is defined twice; choose another name for one of them", first],
    );
    again(
        "tables { sin = linear { 0, 0; 1, 1; } }",
        &["4:51 `sin` is a function in the language; choose another name"],
    );
    again(
        "bodies { other: mass 1 at [lift(phi), 0]; }",
        &[
            "4:68 the slope of table `lift` jumps at its rows, and speeds would jump with it: a table in the position of a mass is `cubic`",
        ],
    );
    again(
        "constraints { held: phi = 0.1 + lift(phi); }",
        &[
            "4:62 the slope of table `lift` jumps at its rows, and speeds would jump with it: a table in a constraint is `cubic`",
        ],
    );
}

#[test]
fn cams() {
    let cam = |written: &str, expected: &[&str]| {
        let joints = format!("tables {{ lift = cubic {{ 0, 0; 1, 1; 2, 3; }} }} joints {{ {written} }} let P");
        assert_eq!(mistakes(&without_units(SOUND).replacen("let P", &joints, 1)), expected, "\nin: {written}");
    };
    cam("c: cam P through [0, 1] along phi on bob radius 1 by lift;", &[]);
    cam("c: cam bob on bob by lift;", &[]);
    cam("c: cam P on bob by lift;", &["4:63 no body above is called `P`"]);
    cam(
        "c: cam [0, 1] on bob by lift;",
        &["4:70 expected `through`: `cam P through O along beta on wheel radius r by lift;`"],
    );
    cam(
        "c: cam P through [0, 1] along phi on bob radius 1;",
        &["4:105 expected `by`: `cam P through O along beta on wheel radius r by lift;`"],
    );
    cam(
        "c: cam P through [0, 1] along phi on bob by lift;",
        &["4:97 expected `radius`: `cam P through O along beta on wheel radius r by lift;`"],
    );
    cam(
        "c: cam bob on bob by left;",
        &["4:77 no table is called `left` (did you mean `lift`?): `tables { left [mm] over [deg] = .. }`"],
    );
    cam("c: cam bob on bob by 2;", &["4:77 expected a table, by its name"]);
}

/// The mistakes of a table whose rows are in a file with this text.
fn in_file(text: &str) -> Result<usize, String> {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    // Tests of one name run one after the other.
    std::fs::write(folder.join("rows_of_a_table.csv"), text).unwrap();
    let table = "tables { lift [mm] over [deg] = cubic, held from \"rows_of_a_table.csv\"; } let P";
    let tokens: proc_macro2::TokenStream = SOUND.replacen("let P", table, 1).parse().unwrap();
    let read = codegen::dsl::read_files(tokens, folder).and_then(|(tokens, files)| {
        assert_eq!(files, ["rows_of_a_table.csv"]);
        let equations = codegen::equations(tokens)?;
        Ok(equations.graph.tables()[0].knots.len())
    });
    read.map_err(|mistake| format!("{}:{} {mistake}", mistake.span().start().line, mistake.span().start().column + 1))
}

#[test]
fn files() {
    for sound in [
        "angle [deg],lift [mm]\n0,0\n90,10.5\n180,20\n",
        "angle (left)\tlift (mm)\n0\t0\n90\t10.5\n180\t20\n",
        "angle [deg] lift\n0 0\n90 10.5\n180 20\n",
        "\"0\",\"0\"\n\"90\",\"10.5\"\n\"180\",\"20\"\n",
        "angle of the cam\n0 0\n90 10.5\n180 20\n",
        "angle,lift\n0,0\n90,10.5\n# the top\n180,20\n",
        "\u{feff}0;0\r\n90;10.5\r\n\r\n180;-2e1",
        "0 0\n90\t10.5 # here\n  180 20",
        "0,0,\n90,\t10.5,,\n,,\n180,20\n",
    ] {
        assert_eq!(in_file(sound), Ok(3), "{sound}");
    }
    let place = "4:50 rows_of_a_table.csv";
    let refused = |text: &str, message: &str| assert_eq!(in_file(text), Err(message.to_owned()), "{text}");
    refused("0,0\n90,top\n", &format!("{place}, line 2: `top` is not a number"));
    refused("0,0\n90,inf\n", &format!("{place}, line 2: `inf` is not a number"));
    refused("0,0\n90\n", &format!("{place}, line 2: a row has two numbers, an argument and a value; this one has 1"));
    refused("a,b\nc,d\n", &format!("{place}, line 2: `c` is not a number"));
    // With another minus, a currency, a unit.
    for [argument, value] in [["\u{2212}0.5", "\u{2212}3"], ["$0", "$7"], ["0s", "0N"], ["(0)", "(7)"], ["1D0", "1D0"]]
    {
        refused(&format!("{argument},{value}\n1,1\n2,4\n"), &format!("{place}, line 1: `{argument}` is not a number"));
    }
    refused("0,0,3\n", &format!("{place}, line 1: a row has two numbers, an argument and a value; this one has 3"));
    refused("0,,0\n", &format!("{place}, line 1: a row has two numbers, an argument and a value; this one has 3"));
    refused("0,0\n", "4:10 table `lift` has one row; a function is given by two or more");
    refused("0,0\n2,0\n1,0\n", "4:50 the arguments of a table must increase from row to row; 1.0 follows 2.0");
    let said = "the heading says that the arguments of table `lift` are in [rad]; they are declared in [deg]";
    for heading in ["angle [rad],lift [mm]", "angle [rad] lift", "\"angle [rad]\";\"lift\"", "angle (rad)\tlift (left)"]
    {
        refused(&format!("{heading}\n0,0\n1,1\n"), &format!("4:50 {said}"));
    }
    let two = "a heading names the arguments and the values, as in `t [s], F [N]`; a title stands behind `#`";
    for heading in ["lift [mm]", "angle,rad,lift,mm", "angle;rad;lift"] {
        refused(&format!("{heading}\n0,0\n1,1\n"), &format!("{place}, line 1: {two}"));
    }
    let many = |rows: usize| (0..rows).map(|row| format!("{row},2\n")).collect::<String>();
    assert_eq!(in_file(&format!("angle [deg], lift [mm]\n{}", many(100_000))), Ok(100_000));
    refused(&many(100_001), "4:50 the tables of a declaration have at most 100000 rows altogether; give fewer");
    let read = |written: &str| {
        let text = SOUND.replacen("let P", &format!("tables {{ lift = linear from {written}; }} let P"), 1);
        let folder = std::path::Path::new("/nowhere");
        let read = codegen::dsl::read_files(text.parse().unwrap(), folder).map(|(tokens, _)| tokens);
        read.and_then(|tokens| codegen::generate(tokens, &quote::quote!(sim_kernel))).unwrap_err().to_string()
    };
    assert!(read("\"lift.csv\"").starts_with("cannot read /nowhere/lift.csv: "));
    assert_eq!(
        read("\"/lift.csv\""),
        "the path of a table's file starts at the folder of the declaration's crate or `.mech` file: `from \"data/lift.csv\"`"
    );
    assert_eq!(read("lift"), "a file of rows is named in quotes: `from \"lift.csv\"`");
}
