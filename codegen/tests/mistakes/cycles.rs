//! 1 Hz and 1 rad/s are of one dimension and are not the same. What is computed from a frequency is right.

use super::{check, mistakes};

const TURNING: &str = "pub Turning;
coordinates { c [rev]; d [deg]; }
parameters { J [kg*m^2] = 1; f [Hz] = 2; n [rpm] = 60; w [rad/s] = 3; r [1/s] = 3; }
bodies { a: inertia J, angle c; b: inertia J, angle d; }
";

/// The mistakes of a line that is added as line 5.
fn check_line(line: &str, expected: &[&str]) {
    assert_eq!(mistakes(&format!("{TURNING}{line}")), expected, "\nin: {line}");
}

#[test]
fn values_of_what_is_declared() {
    check(
        "phi = 0.5;",
        "phi = 0.5; dot(phi) = -3 [Hz];",
        &["7:34 `dot(phi)` is in [rad/s], and `3 [Hz]` is in [Hz]: angles and cycles; write `2*pi*3 [Hz]`"],
    );
    check(
        "l [m] = 1;",
        "f [Hz] = -60 [rpm]; l [m] = 1;",
        &["3:24 `f` is declared in [Hz], and `60 [rpm]` is in [rpm]: cycles and angles; write `60 [rpm]/(2*pi)`"],
    );
    check("phi = 0.5;", "phi = 0.5; dot(phi) = 2*pi*3 [Hz];", &[]);
    check("phi = 0.5;", "phi = 0.5; dot(phi) = 3 [rev/s];", &[]);
    for (line, message) in [
        (
            "inputs { u [rpm] = f; }",
            "5:20 `u` is declared in [rpm], and `f` is in [Hz]: angles and cycles; write `2*pi*f`",
        ),
        (
            "outputs { o [Hz] = dot(c); }",
            "5:20 output `o` is declared in [Hz], and `dot(c)` is in [rev/s]: cycles and angles; write `dot(c)/(2*pi)`",
        ),
        (
            "outputs { o [rpm] = f; }",
            "5:21 output `o` is declared in [rpm], and `f` is in [Hz]: angles and cycles; write `2*pi*f`",
        ),
        (
            "outputs { o [kHz] = -n; }",
            "5:22 output `o` is declared in [kHz], and `n` is in [rpm]: cycles and angles; write `n/(2*pi)`",
        ),
        (
            "initial { dot(d) = f; }",
            "5:20 `dot(d)` is in [deg/s], and `f` is in [Hz]: angles and cycles; write `2*pi*f`",
        ),
        (
            "tables { g over [Hz] = linear { 0, 0; 1, 1; } } outputs { o = g(dot(c)); }",
            "5:65 table `g` is over [Hz], and `dot(c)` is in [rev/s]: cycles and angles; write `dot(c)/(2*pi)`",
        ),
    ] {
        check_line(line, &[message]);
    }
    check_line("inputs { u [rpm] = 2*pi*f; v [rad/s] = n; x [Hz] = r; y [1/s] = f; z [kHz] = 3 [Hz]; }", &[]);
    check_line(
        "outputs { o [Hz] = dot(c)/(2*pi); p [rpm] = dot(c); q [rev/s] = w; s [1/s] = dot(d); v [Hz] = f; }",
        &[],
    );
}

#[test]
fn both_sides() {
    for (line, at, [cycles, unit, angle, of_angle]) in [
        ("constraints { s: dot(d) = f; }", 27, ["f", "Hz", "dot(d)", "deg/s"]),
        ("events { e_: f = dot(c); }", 14, ["f", "Hz", "dot(c)", "rev/s"]),
        ("events { e_: dot(d) = 3 [Hz]; }", 23, ["3 [Hz]", "Hz", "dot(d)", "deg/s"]),
        ("outputs { o [rad/s] = w + f; }", 27, ["f", "Hz", "w", "rad/s"]),
        ("outputs { o [rad/s] = -f - w; }", 24, ["f", "Hz", "w", "rad/s"]),
        ("outputs { o [rad/s] = max(n, f); }", 30, ["f", "Hz", "n", "rpm"]),
        ("outputs { o = if f > n then 1 else 2; }", 18, ["f", "Hz", "n", "rpm"]),
    ] {
        let message = format!(
            "`{cycles}` is in [{unit}] and `{angle}` in [{of_angle}]: cycles and angles; write `2*pi*{cycles}`"
        );
        check_line(line, &[&format!("5:{at} {message}")]);
    }
    check_line("constraints { s: dot(d) = 2*pi*f; }", &[]);
    check_line("events { p: dot(d) = n; q: dot(d) = r; s: dot(c) = dot(d); }", &[]);
    check_line(
        "outputs { o = if f > r then 1 else 2; p = if f > 3 [Hz] then 1 else 2; q = if f > 0 then 1 else 2; }",
        &[],
    );
    check_line("outputs { o [rad/s] = w + n - dot(d) + 1 [rev/s]; p [Hz] = f + r; }", &[]);
}
