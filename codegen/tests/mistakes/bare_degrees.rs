//! Bare numbers for angles that are declared in degrees or revolutions: they would be in radians.

use super::{check, mistakes};

const ANGLES: &str = "pub Angles;
coordinates { phi [deg]; psi [deg]; theta [rad]; c [rev]; }
parameters { lim = 5; J [kg*m^2] = 1; k [N*m] = 1; }
tables { f over [deg] = linear { 0, 0; 90, 1; } g over [rad] = linear { 0, 0; 90, 1; } }
bodies { a: inertia J, angle phi; b: inertia J, angle psi; d: inertia J, angle theta; e_: inertia J, angle c; }
";

/// The mistake of such a number in line 6 of the declaration, which is added, or none.
fn check_line(line: &str, expected: &[String]) {
    assert_eq!(mistakes(&format!("{ANGLES}{line}")), expected, "\nin: {line}");
}

/// A mistake at the first `number` after the `before` of a line.
fn refuse(line: &str, [before, number]: [&str; 2], claim: &str) {
    let at = line.find(before).unwrap() + before.len() + 1;
    let unit = claim.rsplit(['[', ']']).nth(1).unwrap();
    let message = format!("{claim}, and `{number}` is in radians; write `{number} [{unit}]` or `{number} [rad]`");
    check_line(line, &[format!("6:{at} {message}")]);
}

const PHI: &str = "`phi` is declared in [deg]";
const PSI: &str = "`psi` is declared in [deg]";

#[test]
fn beside_lone_names() {
    refuse("outputs { o = cos(phi + 30); }", ["phi + ", "30"], PHI);
    refuse("outputs { o = cos(-1.5 - phi); }", ["(-", "1.5"], PHI);
    refuse("outputs { o = if phi > 30 then 1 else 2; }", ["> ", "30"], PHI);
    refuse("outputs { o = cos(c + 2); }", ["c + ", "2"], "`c` is declared in [rev]");
    refuse("events { up: phi = 30 rising; }", ["= ", "30"], PHI);
    check("height [m] = P.y", "o = cos(phi + 30)", &[]);
}

#[test]
fn beside_numbers_in_degrees() {
    refuse("outputs { o = cos(45 [deg] + 30); }", ["+ ", "30"], "`45 [deg]` is in [deg]");
    refuse("outputs { o = cos(theta - 45 [deg] + 0.1); }", ["+ ", "0.1"], "`45 [deg]` is in [deg]");
    refuse("outputs { o = cos(2 + 0.5 [rev]*2); }", ["cos(", "2"], "`0.5 [rev]` is in [rev]");
    refuse("outputs { o = cos(20 [mrad] + 30); }", ["+ ", "30"], "`20 [mrad]` is in [mrad]");
    check_line(
        "outputs { o = cos(45 [deg] + 30 [deg]); p = cos(theta + 0.1 [rad] + 2); q = phi/(30 [deg]) + 1; }",
        &[],
    );
    check_line("loads { torque (45 [deg] + pi/6)*k on phi; }", &[]);
}

#[test]
fn rests_of_springs() {
    refuse("loads { spring k, rest 30 on phi; }", ["rest ", "30"], PHI);
    refuse("loads { spring k, rest 30 between psi and phi; }", ["rest ", "30"], PSI);
    refuse("loads { spring k, rest -30 between theta and 2*phi; }", ["rest -", "30"], PHI);
    refuse("loads { spring k*stretch, rest 30 on phi; }", ["rest ", "30"], PHI);
    check_line(
        "loads { spring k, rest 30 [deg] on phi; spring k, rest 30 on theta; spring k, rest pi/6 on phi; }",
        &[],
    );
}

#[test]
fn equations() {
    refuse("constraints { s: [phi, psi] = [30, 10]; }", ["= [", "30"], PHI);
    refuse("constraints { s: [phi, psi] = [30 [deg], 10]; }", ["[deg], ", "10"], PSI);
    refuse("constraints { s: -[theta, psi] = -[30, 10]; }", ["-[30, ", "10"], PSI);
    refuse("constraints { s: phi - 2*psi = 30; }", ["= ", "30"], PHI);
    refuse("events { o: phi - psi = 30; }", ["= ", "30"], PHI);
    refuse("events { o: theta - psi/2 = 30; }", ["= ", "30"], PSI);
    refuse("events { o: abs(psi) = 30; }", ["= ", "30"], PSI);
    refuse("events { o: phi = 1.5*20; }", ["= ", "1.5"], PHI);
    refuse("events { o: phi = 30 + 15; }", ["= ", "30"], PHI);
    refuse("events { o: phi = 2*psi + 30; }", ["psi + ", "30"], PSI);
    refuse("events { o: phi = max(0, 30); }", ["(0, ", "30"], PHI);
    refuse("events { o: phi = 20*sin(3 [rad/s]*t)/2; }", ["= ", "20"], PHI);
    refuse("events { o: phi = sin(3 [rad/s]*t)*4*abs(20); }", ["*t)*", "4"], PHI);
    refuse("events { o: (if lim > 3 then phi else theta) = 30; }", ["= ", "30"], PHI);
    for sound in [
        "phi = 30 [deg]",
        "phi = 0.1 [rad]",
        "phi = 0",
        "phi = 0*sin(t/1 [s])",
        "phi = 2*pi",
        "phi = pi/2",
        "phi = 30*(pi/180)",
        "phi = lim",
        "phi = 2*lim",
        "phi = 2*theta",
        "phi = 2*atan2(1, lim)",
        "phi = 2*atan(1/2)",
        "phi = 2*0.1 [rad]",
        "theta = 30",
        "sin(phi) = 0.5",
        "phi^2 = 2",
        "phi/psi = 2",
        "phi*psi = 2",
        "dot(phi)/1 [1/s] = 2",
        "[theta, phi] = [1, 30 [deg]]",
        "[theta, phi] = [1, 0]",
    ] {
        check_line(&format!("constraints {{ s: {sound}; }}"), &[]);
    }
}

/// A unit cannot stand at one number of these.
#[test]
fn whole_terms() {
    let whole = |line: &str, at: usize, term: &str| {
        let message = format!("{PHI}, and `{term}` is in radians; write `({term})*1 [deg]` or `({term})*1 [rad]`");
        check_line(line, &[format!("6:{at} {message}")]);
    };
    whole("events { o: phi = 2^3; }", 19, "2^3");
    whole("events { o: phi = sin(3 [rad/s]*t)/2; }", 19, "sin(3 [rad/s]*t)/2");
    whole("events { o: phi = (1 + 2)*cos(theta); }", 19, "1 + 2");
    whole("events { o: phi = exp(theta)/(1 + exp(theta)); }", 19, "exp(theta)/(1 + exp(theta))");
}

#[test]
fn expressions() {
    refuse("outputs { o = if 2*phi > 30 then 1 else 2; }", ["> ", "30"], PHI);
    refuse("outputs { o = if abs(phi) > 30 then 1 else 2; }", ["> ", "30"], PHI);
    refuse("outputs { o = max(phi - psi, 3); }", ["psi, ", "3"], PHI);
    refuse("outputs { o = max(0, phi, 3); }", ["phi, ", "3"], PHI);
    refuse("outputs { o = sin(-(phi) + 30); }", [" + ", "30"], PHI);
    refuse("outputs { o = if lim > 3 then phi else 3; }", ["else ", "3"], PHI);
    refuse("outputs { o = 2*phi + 1; }", ["phi + ", "1"], PHI);
    check_line(
        "outputs { o = phi - pi/2; p = phi - 0; q = max(phi, 0); r = max(theta, 3); s = 2*phi + 30 [deg]; }",
        &[],
    );
}

#[test]
fn arguments_and_rows_of_tables() {
    let claim = "table `f` is over [deg]";
    refuse("outputs { o = f(30); }", ["f(", "30"], claim);
    refuse("outputs { o = f(10*sin(phi)); }", ["f(", "10"], claim);
    refuse("outputs { o = f(theta - 1.5); }", ["- ", "1.5"], claim);
    check_line("outputs { o = f(30 [deg]); p = f(2*pi); q = f(phi); r = f(0); s = f(theta); u = g(30); }", &[]);
    let claim = "the values of table `h` are in [deg]";
    refuse("tables { h [deg] over [s] = linear { 0, 0; 1, 5 + 1 [rad]; } }", ["1, ", "5"], claim);
    check_line("tables { h [deg] over [rev] = linear { 0, 0; 1, 2*5; 9 [rad], 2*pi; } }", &[]);
}

#[test]
fn values_of_what_is_declared() {
    for value in ["20 + lim", "lim - 20", "max(lim, 20)", "if lim > 3 then 20 else 10", "20*sin(lim)", "20 + 1 [rad]"] {
        for line in [format!("initial {{ psi = {value}; }}"), format!("initial {{ guess psi = {value}; }}")] {
            let before = &value[..value.find("20").unwrap()];
            refuse(&line, [&format!("= {before}"), "20"], PSI);
        }
    }
    refuse("initial { c = 20 + lim; }", ["= ", "20"], "`c` is declared in [rev]");
    refuse("parameters { p [deg] = 20 + 1 [rad]; }", ["[deg] = ", "20"], "`p` is declared in [deg]");
    refuse("inputs { u [deg] = 30*sin(2 [rad/s]*t); }", ["[deg] = ", "30"], "`u` is declared in [deg]");
    refuse("inputs { u [deg] = 30 + 10*t/(1 [s]); }", ["[deg] = ", "30"], "`u` is declared in [deg]");
    refuse("inputs { u [deg] = if t < 1 [s] then 10 else 20; }", ["then ", "10"], "`u` is declared in [deg]");
    refuse("outputs { a [deg] = 30*sin(2 [rad/s]*t); }", ["[deg] = ", "30"], "output `a` is declared in [deg]");
    refuse("outputs { a [deg] = 5; }", ["[deg] = ", "5"], "output `a` is declared in [deg]");
    refuse("events { o: theta = 1 { set psi = 20 + lim; } }", ["psi = ", "20"], PSI);
    for sound in
        ["30", "30 + 15", "2*(3 + 1)", "-pi", "lim", "2*lim", "pi + lim", "30 [deg] + lim", "0", "acos(0.1*lim)"]
    {
        check_line(&format!("initial {{ psi = {sound}; dot(psi) = 30; }}"), &[]);
        check_line(&format!("inputs {{ u [deg] = {sound}; v [rad] = 2 + lim; w [deg/s] = 30; }}"), &[]);
    }
    check_line(
        "outputs { a [deg] = phi; b_ [deg] = 2*pi; h [deg] = 0; i [deg] = 30 [deg]; j [deg] = asin(1/2); }",
        &[],
    );
}
