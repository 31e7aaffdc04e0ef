//! Fragments, repetitions, sums and constants.

use super::{SOUND, mistakes};

/// The sound declaration with more items at its end; the first of these stands in line 10.
fn check(items: &str, expected: &[&str]) {
    assert_eq!(mistakes(&format!("{SOUND}{items}")), expected, "\nin: {items}");
}

const ROD: &str = "fragment Rod(base, angle_) {
    parameters { r [m] = 1; }
    let tip = base + r*[cos(angle_), sin(angle_)];
    bodies { rod: mass m at tip, angle angle_; }
}
";

/// The same with the fragment `Rod` in lines 10 to 14.
fn check_rod(items: &str, expected: &[&str]) {
    check(&format!("{ROD}{items}"), expected);
}

#[test]
fn the_fragment_is_sound() {
    check_rod("use Rod(P, phi) as left;", &[]);
}

#[test]
fn uses() {
    check_rod(
        "use Rodd(P, phi) as left;",
        &["15:5 no fragment is called `Rodd` (did you mean `Rod`?): `fragment Rodd(..) { .. }`"],
    );
    check_rod("use Rod(P) as left;", &["15:5 `Rod` takes 2 arguments, (base, angle_), not 1"]);
    check_rod("use Rod(P, ) as left;", &["15:5 `Rod` takes 2 arguments, (base, angle_), not 1"]);
    check_rod("use Rod(P, , phi) as left;", &["15:5 argument 2 of `Rod` is missing"]);
    check_rod("use Rod(P, phi);", &["15:16 a fragment is used by `use Leg(P, alpha) as left;`"]);
    check_rod(
        "use Rod(P, phi) as left; use Rod(P, phi) as left;",
        &["15:45 `left` is used twice; choose another name for one of them"],
    );
    check_rod("use Rod(P, phi) as left", &["15:1 a fragment is used by `use Leg(P, alpha) as left;`"]);
    check_rod("", &["10:10 fragment `Rod` is never used: `use Rod(..) as a_name;`"]);
    check_rod(
        "use Rod(P, phi) as left; bodies { use Rod(P, phi) as right; }",
        &["15:35 `use` stands beside blocks, not inside one"],
    );
    check_rod("use Rod(P, ph) as left;", &["15:12 nothing is called `ph`"]);
    check_rod(
        "use Rod(P + phi, 2*phi) as left;",
        &[
            "15:9 a vector and a scalar cannot be added or subtracted; take a component (`.x`, `.y`) or build a vector `[x, y]`",
        ],
    );
    check_rod(
        "let left_tip = 1; use Rod(P, phi) as left;",
        &[
            "12:9 `left_tip` is defined twice; choose another name for one of them (in `left`)",
            "15:5 the first definition of `left_tip` is here",
            "13:29 a scalar stands where a vector belongs; a vector is written `[x, y]` (in `left`)",
        ],
    );
    check_rod(
        "use Rod(phi, phi) as left; use Rod(P, phi) as right;",
        &[
            "12:15 a scalar and a vector cannot be added or subtracted; take a component (`.x`, `.y`) or build a vector `[x, y]` (in `left`)",
        ],
    );
    check_rod(
        "use Rod(1 + 2, phi) as left;",
        &[
            "12:15 a scalar and a vector cannot be added or subtracted; take a component (`.x`, `.y`) or build a vector `[x, y]` (in `left`)",
        ],
    );
    check_rod(
        "outputs { y = left_top.y; } use Rod(P, phi) as left;",
        &["15:15 no value is called `left_top` (did you mean `left_tip`?)"],
    );
}

#[test]
fn fragments() {
    check("fragment Rod(base, base) { } use Rod(P, P) as a;", &["10:20 there are two arguments called `base`"]);
    check(
        "fragment Rod(base + 1) { } use Rod(P) as a;",
        &["10:14 the arguments of a fragment are names, separated by commas"],
    );
    check("fragment { }", &["10:10 a fragment is written `fragment Leg(hip, phi) { .. }`"]);
    check("fragment Rod(base); use Rod(P) as a;", &["10:19 a fragment is written `fragment Leg(hip, phi) { .. }`"]);
    check(
        "fragment Rod(mass) { } use Rod(P) as a;",
        &["10:14 `mass` is a word of the language and cannot name an index or anything in a fragment"],
    );
    check(
        "fragment Rod { parameters { angle = 1; } } use Rod as a;",
        &["10:29 `angle` is a word of the language and cannot name an index or anything in a fragment (in `a`)"],
    );
    check(
        "fragment Rod(base) { let base = 1; } use Rod(P) as a;",
        &[
            "10:14 `base` is an argument of `Rod` and defined in it as well; choose another name for one of them (in `a`)",
        ],
    );
    check(
        "fragment Rod { } fragment Rod { } use Rod as a;",
        &[
            "10:27 `Rod` is defined twice; choose another name for one of them",
            "10:10 the first definition of `Rod` is here",
        ],
    );
    check(
        "fragment A { use B as b; } fragment B { use A as a; } use A as a;",
        &["10:45 fragments cannot use themselves: A -> B -> A (in `a_b`)"],
    );
    check(
        "fragment A { fragment B { } } use A as a;",
        &["10:14 `fragment` stands beside the blocks of the mechanism, not inside one (in `a`)"],
    );
    check(
        "fragment A { const n = 2; } use A as a;",
        &["10:14 `const` stands beside the blocks of the mechanism, not inside one (in `a`)"],
    );
    check(
        "fragment A {\n  let y = z;\n} use A as a; use A as b;",
        &[
            "11:11 no value is called `z`; declared: `phi`, `l`, `m`, `g`, `P` (in `a`)",
            "11:11 no value is called `z`; declared: `phi`, `l`, `m`, `g`, `P`, `a_y` (in `b`)",
        ],
    );
    check(
        "fragment A(v) {\n  let y = v.x;\n} use A(P) as a; use A(phi) as b;",
        &["11:13 a scalar has no component `.x` (in `b`)"],
    );
    check(
        "fragment A {\n  bodies { b: mass 2*m + at P; }\n} use A as a; use A as b; use A as c;",
        &["11:29 an operator or `;` is missing before `P` (in `a` and 2 more)"],
    );
    check(
        "fragment A(v) {\n  let y = v.x;\n} fragment B(w) { use A(w) as a; } use B(phi) as b;",
        &["11:13 a scalar has no component `.x` (in `b_a`)"],
    );
}

#[test]
fn repetitions() {
    check("repeat i in 1..=0 { }", &["10:8 nothing is repeated: 1..=0 is empty"]);
    check("repeat i in 3..3 { }", &["10:8 nothing is repeated: 3..3 is empty"]);
    check("repeat i 1..=3 { }", &["10:10 a repetition is written `repeat i in 1..=3 { .. }`"]);
    check("repeat i in 3 { }", &["10:15 a repetition needs a range: `1..=3` includes its end, `0..3` does not"]);
    check("repeat 3 { }", &["10:8 a repetition is written `repeat i in 1..=3 { .. }`"]);
    check("repeat i in 1..=3;", &["10:1 a repetition is written `repeat i in 1..=3 { .. }`"]);
    check(
        "repeat i in 1..=m { }",
        &["10:17 no index is called `m`; an index is made of whole numbers, `const`s and the counters of `repeat`"],
    );
    check("repeat i in 1..=2.5 { }", &["10:17 an index is made of whole numbers and names: `i`, `i - 1`, `2*n`"]);
    check(
        "repeat i in 1..=1000000 { let a_[i] = i; }",
        &["10:40 written out, this declaration has more than 50000 words; repeat less often (for i = 9983)"],
    );
    check(
        "repeat t in 1..=2 { }",
        &["10:8 `t` is a word of the language and cannot name an index or anything in a fragment"],
    );
    check("repeat m in 1..=2 { let a_[m] = m; }", &["10:8 `m` is declared as well; choose another name for the index"]);
    check(
        "repeat i in 1..=2 { coordinates { i [m]; } }",
        &["10:35 `i` is a whole number here, an index or a `const`; choose another name (for i = 1)"],
    );
    check(
        "let a_[1] = 1;\nrepeat i in 1..=3 {\n  let b_[i] = a_[i];\n}",
        &[
            "12:15 no value is called `a_2` (did you mean `a_1`?) (for i = 2)",
            "12:15 no value is called `a_3` (did you mean `a_1`?) (for i = 3)",
        ],
    );
    check(
        "let a_[1] = 1; repeat i in 1..=2 { let b_[i] = a_[i-2]; }",
        &["10:51 this index is -1; indices count from 0 (for i = 1)"],
    );
    check(
        "repeat i in 1..=2 { let b_[j] = 1; }",
        &[
            "10:28 no index is called `j`; an index is made of whole numbers, `const`s and the counters of `repeat` (for i = 1)",
        ],
    );
    check("repeat i in 1..=3 { let b_[i/2] = 1; }", &["10:29 1/2 is not a whole number (for i = 1)"]);
    check("repeat i in 1..=2 { let b_[i%0] = 1; }", &["10:29 division by zero in an index (for i = 1)"]);
    check(
        "repeat i in 1..=2 { let b_[i +] = 1; }",
        &["10:31 an index is made of whole numbers and names: `i`, `i - 1`, `2*n` (for i = 1)"],
    );
    check(
        "repeat i in 1..=2 { let b = 1; }",
        &[
            "10:25 `b` is defined twice; choose another name for one of them (for i = 2)",
            "10:25 the first definition of `b` is here (for i = 1)",
        ],
    );
    check(
        "repeat i in 1..=2 { repeat j in 1..=2 {\n  let b_[i, j] = c_[i, j];\n} }",
        &[
            "11:18 no value is called `c_1_1`; declared: `phi`, `l`, `m`, `g`, `P` (for i = 1, for j = 1)",
            "11:18 no value is called `c_1_2`; declared: `phi`, `l`, `m`, `g`, `P`, `b_1_1` (for i = 1, for j = 2)",
        ],
    );
    check(
        "repeat i in 1..=40 {\n  let b_[i] = c_[i];\n}",
        &[
            "11:15 no value is called `c_1`; declared: `phi`, `l`, `m`, `g`, `P` (for i = 1)",
            "11:15 no value is called `c_2`; declared: `phi`, `l`, `m`, `g`, `P`, `b_1` (for i = 2)",
        ],
    );
}

#[test]
fn sums() {
    check("let s = sum(i in 1..=3);", &["10:12 a sum is written `sum(i in 1..=3, term)`"]);
    check("let s = sum(1, 2);", &["10:12 a sum is written `sum(i in 1..=3, term)`"]);
    check("let s = sum(i in 1..=0, i);", &["10:13 a sum has at least one term, and 1..=0 is empty"]);
    check("let s = sum(i in 1..=3, i, 2);", &["10:26 a vector is written in square brackets: `[x, y]` (for i = 1)"]);
    check(
        "let s = sum(i in 1..=3, Q_[i]);",
        &[
            "10:25 no value is called `Q_1`; declared: `phi`, `l`, `m`, `g`, `P` (for i = 1)",
            "10:25 no value is called `Q_2`; declared: `phi`, `l`, `m`, `g`, `P` (for i = 2)",
        ],
    );
}

#[test]
fn constants() {
    check("const n = 2.5;", &["10:11 an index is made of whole numbers and names: `i`, `i - 1`, `2*n`"]);
    check(
        "const n = k;",
        &["10:11 no index is called `k`; an index is made of whole numbers, `const`s and the counters of `repeat`"],
    );
    check("const n = 99999999999999999999;", &["10:11 this number is too large for an index"]);
    check("const n = 1; const n = 2;", &["10:20 `n` is defined twice; choose another name for one of them"]);
    check("const n [m] = 1;", &["10:9 a constant is a whole number with a name: `const n = 5;`"]);
    check("const pi = 3;", &["10:7 `pi` is a word of the language and cannot name an index or anything in a fragment"]);
    check("const m = 3; let a = m;", &["3:25 `m` is a whole number here, an index or a `const`; choose another name"]);
    check("const n = 9223372036854775807 + 1;", &["10:31 this number is too large for an index"]);
}

/// A free body may have a raw name, beside fragments too.
#[test]
fn free_bodies_with_raw_names() {
    let text = SOUND
        .replacen("let P", "fragment Part(a) { let b = a; } use Part(l) as left; let P", 1)
        .replacen("bodies {", "bodies { r#type: free, mass m, inertia 1 [kg*m^2];", 1)
        .replacen("phi = 0.5;", "phi = 0.5; type_x = 1; type_y = 0; type_phi = 0;", 1);
    assert_eq!(mistakes(&text), [""; 0]);
}
