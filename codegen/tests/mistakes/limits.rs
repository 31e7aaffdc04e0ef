//! What is too deep, too long or too often: refused at its place, within the stack and without a wait.

use super::{SOUND, check, mistakes};

#[test]
fn brackets_nest_so_deep_and_no_deeper() {
    let nested = |levels: usize| format!("let a = {}1{}; let P = l*", "(".repeat(levels), ")".repeat(levels));
    check("let P = l*", &nested(60), &[]);
    for levels in [70, 100_000] {
        let expected = "4:73 brackets are nested too deeply; name inner parts with `let`";
        check("let P = l*", &nested(levels), &[expected]);
    }
    // Within a fragment, and beside one.
    let brackets = format!("{}1{}", "[".repeat(100_000), "]".repeat(100_000));
    let in_fragment = format!("fragment Part(a) {{ let b = {brackets}; }} use Part(l) as left; let P = l*");
    check("let P = l*", &in_fragment, &["4:91 brackets are nested too deeply; name inner parts with `let`"]);
    check(
        "initial {",
        &format!("{brackets} initial {{"),
        &["7:65 brackets are nested too deeply; name inner parts with `let`"],
    );
}

#[test]
fn files_and_expansions_have_the_same_limits() {
    let deep = |text: &str| codegen::generate_text(text, "sim_kernel").unwrap_err().to_string();
    let modules = format!("{}mechanism! {{ {SOUND} }}{}", "mod a { ".repeat(100), "}".repeat(100));
    assert!(codegen::generate_text(&modules, "sim_kernel").is_ok());
    let modules = format!("{}mechanism! {{ {SOUND} }}{}", "mod a { ".repeat(100_000), "}".repeat(100_000));
    assert_eq!(deep(&modules), "brackets are nested too deeply; name inner parts with `let`");
    // The stand-in needs no more than the head.
    let text = format!("path; pub Deep; let a = {}1{};", "(".repeat(100_000), ")".repeat(100_000));
    let expanded = codegen::expand(text.parse().unwrap()).to_string();
    assert!(expanded.contains("compile_error") && expanded.contains("struct Deep"));
}

#[test]
fn sums_may_have_as_many_terms_as_words_allow() {
    check("let P = l*", "let a = sum(i in 1..=200, l/i^2); let P = l*", &[]);
    check("let P = l*", "let a = sum(i in 1..=2000, 1/i); let P = l*", &[]);
    let long = vec!["l"; 800].join("+");
    check(
        "let P = l*",
        &format!("let a = {long}; let P = l*"),
        &["4:1506 this line is too long; name parts of it with `let`"],
    );
}

#[test]
fn numbers_have_so_many_digits_and_no_more() {
    check("l [m] = 1;", &format!("l [m] = 0.{};", "1".repeat(300)), &[]);
    for number in ["1".repeat(100_000), format!("0.{}", "1".repeat(100_000)), format!("1e{}", "1".repeat(100_000))] {
        check("l [m] = 1;", &format!("l [m] = {number};"), &["3:22 a number has at most 1000 characters"]);
        check("l [m] = 1;", &format!("l [m^{number}] = 1;"), &["3:19 a number has at most 1000 characters"]);
    }
}

#[test]
fn every_name_of_many_equal_ones_is_shown_with_the_first() {
    let twice = mistakes(&SOUND.replace("phi [rad];", &"phi [rad]; ".repeat(3)));
    assert_eq!(twice.len(), 4, "{twice:?}");
    // A comparison of each mistake with each before it would not come to an end here.
    let many = mistakes(&SOUND.replace("phi [rad];", &"phi [rad]; ".repeat(2001)));
    assert_eq!(many.len(), 4_000);
    assert_eq!(many[3_998].split_once(' ').unwrap().1, "`phi` is defined twice; choose another name for one of them");
}

/// They count beside the words: a table of 15 s at a thousand rows a second is no long declaration.
#[test]
fn tables_have_so_many_rows_and_no_more() {
    let tables = |rows: usize| {
        let rows: String = (0..rows).map(|row| format!("{row}, -1.5; ")).collect();
        let tables = format!(
            "fragment Part(a) {{ let b = a; }} use Part(l) as left; tables {{ lift = linear {{ {rows} }} }} let P"
        );
        mistakes(&SOUND.replacen("let P", &tables, 1))
    };
    assert_eq!(tables(15_000), [""; 0]);
    assert_eq!(tables(100_001), ["1:1 the tables of a declaration have at most 100000 rows altogether; give fewer"]);
}
