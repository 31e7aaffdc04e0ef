//! The system as a whole, and mistakes.

use codegen::notation::Notation;

const PENDULUM: &str = "Pendulum; coordinates { phi [rad]; } parameters { m [kg] = 1; l [m] = 1; }
    bodies { bob: mass m at l*[sin(phi), -cos(phi)]; } loads { gravity [0, -9.81 [m/s^2]]; }";

#[test]
fn without_constraints_there_is_no_block_for_them() {
    assert_eq!(
        super::part(PENDULUM, Notation::Infix, "system"),
        "mass_matrix * accelerations = generalized_forces - convective_forces\n\
         coordinates = [phi]\n\
         [m*l^2] * [phi_ddot] = [-9.81*m*l*sin(phi)]\n"
    );
    let names: Vec<_> =
        codegen::equations_as(Notation::Latex, PENDULUM).unwrap().iter().map(|part| part.name).collect();
    assert_eq!(names, ["system", "mass_matrix", "convective_forces", "generalized_forces"]);
}

#[test]
fn letters_have_dots_and_indices() {
    let text = super::part(super::CART, Notation::Latex, "convective_forces");
    assert!(text.contains(r"\dot{\theta}_{2}^{2}"), "{text}");
    let text = super::part(super::CART, Notation::MathMl, "system");
    assert!(
        text.contains("<msub><mover accent=\"true\"><mi>θ</mi><mo>¨</mo></mover><mrow><mn>2</mn></mrow></msub>"),
        "{text}"
    );
}

#[test]
fn mistakes_are_those_of_the_declaration() {
    let error = codegen::equations_as(Notation::Infix, "M; coordinates { x [m]; } bodies { b: mass q at [x, 0]; }")
        .unwrap_err();
    assert!(error.to_string().contains("`q`"), "{error}");
    assert!(codegen::equations_as(Notation::Infix, "M; coordinates { x [m]; ").is_err());
}
