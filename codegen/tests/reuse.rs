//! Fragments and repetition: what is written with them means what is written out by hand.

#![allow(missing_docs, clippy::unwrap_used)]

use codegen::model::{self, Start, Unit};
use codegen::oracle::{Oracle, State};
use codegen::symbolic::evaluate;
use codegen::{dsl, equations};

const ROD: &str = "fragment Rod(base, phi) {
    parameters { l [m] = 0.6; m [kg] = 0.5; }
    let u = [sin(phi), -cos(phi)];
    let tip = base + l*u;
    bodies { rod: mass m at base + l/2*u, inertia m*l^2/12, angle phi; }
    outputs { speed \"Speed\" { /// of the tip
        v [m/s] = norm(dot(tip)); } }
    drawing { line base, tip; }
}";

/// The equations of motion as text: the same for the same expressions.
fn text(declaration: &str) -> String {
    codegen::equations_as(codegen::notation::Notation::Infix, declaration)
        .unwrap()
        .into_iter()
        .map(|part| part.text)
        .collect::<Vec<_>>()
        .join("\n")
}

/// Names of coordinates, parameters, outputs and figures.
fn names(declaration: &str) -> Vec<String> {
    let model = equations(declaration.parse().unwrap()).unwrap().model;
    let coordinates = model.coordinates.iter().map(|c| c.name.clone());
    let parameters = model.parameters.iter().map(|p| p.name.clone());
    let outputs = model.outputs.iter().map(|o| o.name.clone());
    let groups = model.groups.iter().map(|g| g.title.clone());
    coordinates.chain(parameters).chain(outputs).chain(groups).collect()
}

fn double_pendulum(middle: &str) -> String {
    format!(
        "pub P; coordinates {{ a [rad]; b [rad]; }} {middle} loads {{ gravity [0, -9.81 [m/s^2]]; }} initial {{ a = 1; }}"
    )
}

#[test]
fn two_instances_of_a_rod_are_a_double_pendulum() {
    let used = double_pendulum(&format!("{ROD} use Rod([0, 0], a) as upper; use Rod(upper_tip, b) as lower;"));
    let rod = |name: &str, base: &str, phi: &str| {
        format!(
            "parameters {{ {name}_l [m] = 0.6; {name}_m [kg] = 0.5; }}
            let {name}_u = [sin({phi}), -cos({phi})]; let {name}_tip = {base} + {name}_l*{name}_u;
            bodies {{ {name}_rod: mass {name}_m at {base} + {name}_l/2*{name}_u, inertia {name}_m*{name}_l^2/12, angle {phi}; }}
            outputs {{ {name}_speed \"Speed, {name}\" {{ {name}_v [m/s] = norm(dot({name}_tip)); }} }}
            drawing {{ line {base}, {name}_tip; }}"
        )
    };
    let by_hand = double_pendulum(&format!(
        "let upper_base = [0, 0]; {} {}",
        rod("upper", "upper_base", "a"),
        rod("lower", "upper_tip", "b")
    ));
    assert_eq!(text(&used), text(&by_hand));
    assert_eq!(names(&used), names(&by_hand));
}

#[test]
fn a_chain_by_repetition_is_the_chain_written_out() {
    let chain = "pub Chain; const n = 3; coordinates { repeat i in 1..=n { /// Angle of rod {i}.
        phi_[i] [rad]; } }
        parameters { l [m] = 1; m [kg] = 2; } let P_[0] = [0, 0];
        repeat i in 1..=n {
            let u_[i] = [sin(phi_[i]), -cos(phi_[i])];
            let P_[i] = P_[i-1] + l*u_[i];
            bodies { rod_[i]: mass m at (P_[i-1] + P_[i])/2, inertia i*m*l^2, angle phi_[i]; }
        }
        outputs { height [m] = P_[n].y; sum [rad] = sum(i in 1..=n, i*phi_[i]); }";
    let by_hand = "pub Chain; coordinates { phi_1 [rad]; phi_2 [rad]; phi_3 [rad]; }
        parameters { l [m] = 1; m [kg] = 2; } let P_0 = [0, 0];
        let u_1 = [sin(phi_1), -cos(phi_1)]; let P_1 = P_0 + l*u_1;
        let u_2 = [sin(phi_2), -cos(phi_2)]; let P_2 = P_1 + l*u_2;
        let u_3 = [sin(phi_3), -cos(phi_3)]; let P_3 = P_2 + l*u_3;
        bodies { rod_1: mass m at (P_0 + P_1)/2, inertia m*l^2, angle phi_1;
            rod_2: mass m at (P_1 + P_2)/2, inertia 2*m*l^2, angle phi_2;
            rod_3: mass m at (P_2 + P_3)/2, inertia 3*m*l^2, angle phi_3; }
        outputs { height [m] = P_3.y; sum [rad] = phi_1 + 2*phi_2 + 3*phi_3; }";
    assert_eq!(text(chain), text(by_hand));
    assert_eq!(names(chain), names(by_hand));
    let model = equations(chain.parse().unwrap()).unwrap().model;
    assert_eq!(model.coordinates[1].docs, "Angle of rod 2.");
}

#[test]
fn fragments_stand_in_fragments_and_in_repetitions() {
    let text_of = |body: &str| {
        text(&format!("pub Legs; coordinates {{ x; }} parameters {{ g = 2; }} {body} loads {{ gravity [g, 0]; }}"))
    };
    let nested = text_of(
        "fragment Foot(at_, size) { parameters { m = 1; } let P = at_ + [size, 0];
            repeat k in 1..=size { bodies { toe_[k]: mass k*m*g at P; } } }
        fragment Leg(hip, g) { coordinates { phi; } let knee = hip + g*[cos(phi), sin(phi)];
            use Foot(knee, 2) as foot; outputs { height = foot_P.y; } }
        repeat i in 1..=2 { use Leg([x, i], 3) as leg_[i]; outputs { h_[i] = leg_[i]_foot_P.x; } }",
    );
    let leg = |i: usize| {
        format!(
            "coordinates {{ leg_{i}_phi; }} parameters {{ leg_{i}_foot_m = 1; }}
            let leg_{i}_hip = [x, {i}]; let leg_{i}_knee = leg_{i}_hip + 3*[cos(leg_{i}_phi), sin(leg_{i}_phi)];
            let leg_{i}_foot_P = leg_{i}_knee + [2, 0];
            bodies {{ leg_{i}_foot_toe_1: mass leg_{i}_foot_m*g at leg_{i}_foot_P;
                leg_{i}_foot_toe_2: mass 2*leg_{i}_foot_m*g at leg_{i}_foot_P; }}
            outputs {{ leg_{i}_height = leg_{i}_foot_P.y; h_{i} = leg_{i}_foot_P.x; }}"
        )
    };
    assert_eq!(nested, text_of(&(leg(1) + &leg(2))));
}

/// Numbers with operators are in the unit of the place, as one number is, and one factor.
#[test]
fn arguments_of_numbers_are_in_the_unit_of_the_place() {
    let start = |argument: &str| {
        let text = format!(
            "pub P; fragment Inner(k) {{ coordinates {{ th [deg]; }} bodies {{ b: inertia 1 [kg*m^2], angle th; }}
                initial {{ th = 15*k; }} }}
            const n = 3; fragment Outer(j) {{ use Inner(j) as inner; }} use Outer({argument}) as outer;"
        );
        let equations = equations(text.parse().unwrap()).unwrap();
        let Start::Given(start) = equations.model.coordinates[0].start else { panic!("no start: {argument}") };
        evaluate(&equations.graph, &[start], |_| f64::NAN)[0]
    };
    for argument in ["1 + 1", "(1 + 1)", "2*1", "-(-2)", "1/2*2^2", "n - 1"] {
        assert_eq!(start(argument), start("2"), "{argument}");
    }
    assert_eq!(start("-2"), -start("2"));
    assert_eq!(start("30 [deg]/15/(1 [deg])"), 30.0, "with units it is in SI units");
}

/// What a fragment does not name itself is the mechanism's, wherever it is used.
#[test]
fn names_are_not_captured() {
    let text_of = |middle: &str| {
        text(&format!(
            "pub P; coordinates {{ x; }} parameters {{ k = 5; }} {middle}
            bodies {{ b: mass 1 at [x, 0]; }} loads {{ force [o_f, 0] at [x, 0]; }}"
        ))
    };
    let captured = text_of(
        "fragment Inner(p) { let f = k*p; }
        fragment Outer(q) { parameters { k = 7; } use Inner(k*q) as inner; let f = k + inner_f; }
        use Outer(x) as o;",
    );
    assert_eq!(captured, text_of("parameters { o_k = 7; } let o_inner_f = k*(o_k*x); let o_f = o_k + o_inner_f;"));
}

/// A unit may follow a name that ends in `_`, and units are no names of a fragment.
#[test]
fn units_stay_units() {
    let declaration = "pub P; coordinates { x_ [m]; } fragment F { parameters { m [kg] = 2 [kg]; s [m/s] = 1; } }
        use F as f; bodies { b: mass f_m at [x_*f_s/1 [m/s], 0]; }";
    assert_eq!(names(declaration), ["x_", "f_m", "f_s"]);
}

#[test]
fn an_empty_range_by_name_repeats_nothing() {
    let declaration = "pub P; const n = 1; coordinates { x [m]; repeat i in 2..=n { y_[i] [m]; } } bodies { b: mass 1 [kg] at [x, 0]; }";
    assert_eq!(names(declaration), ["x"]);
}

#[test]
fn indices_are_computed() {
    let declaration =
        "pub P; const n = 2*(3 - 1); const k = -n/2; coordinates { repeat i in 0..n { x_[i, (i + 3) % n] [m]; } }
        bodies { b: mass 1 [kg] at [x_0_3 + x_1_0, x_2_1*k + x_3_2]; }";
    assert_eq!(names(declaration), ["x_0_3", "x_1_0", "x_2_1", "x_3_2"]);
}

/// The text that a mechanism carries is derived again.
#[test]
fn the_text_of_a_declaration_means_the_same() {
    let used = double_pendulum(&format!("{ROD} use Rod([0, 0], a) as upper; use Rod(upper_tip, b) as lower;"));
    assert_eq!(text(&dsl::source_text(used.parse().unwrap())), text(&used));
}

#[test]
fn the_oracle_reads_what_is_written_out() {
    let used = double_pendulum(&format!("{ROD} use Rod([0, 0], a) as upper; use Rod(upper_tip, b) as lower;"));
    let declaration = codegen::parse(used.parse().unwrap()).unwrap();
    let si_factor = |unit: &dsl::Unit| Unit::resolve(unit).unwrap().factor();
    let oracle = Oracle::new(&declaration, &si_factor);
    let parameters = oracle.default_parameters().unwrap();
    let at = State { time: 0.0, parameters: &parameters, inputs: &[], coordinates: &[0.3, 0.4], speeds: &[1.0, 2.0] };
    // The double pendulum of slender rods: M_12 = m l^2/2 cos(a - b).
    let expected = 0.5 * 0.36 / 2.0 * 0.1f64.cos();
    assert!((oracle.terms(&at).unwrap().mass_matrix[0][1].value - expected).abs() < 1e-15);
    assert!(model::resolve(&declaration).is_ok());
}
