//! Tables and their derivatives in every notation.

use codegen::notation::Notation;

const CAM: &str = "Cam; coordinates { a [rad]; y [m]; } parameters { r [m] = 1; }
    tables { lift_2 [mm] over [deg] = cubic { 0, 0; 90, 10; 180, 20; 270, 0; } }
    bodies { cam: inertia 1 [kg*m^2], angle a; follower: mass 1 [kg] at [0, y]; }
    constraints { touch: y = r + lift_2(a - 2 [rad])^2/r; }";

#[test]
fn primes_stand_for_derivatives() {
    let part = |notation, name| super::part(CAM, notation, name);
    let infix = part(Notation::Infix, "constraint_jacobian");
    assert!(infix.contains(" = -2*lift_2(a - 2)*lift_2'(a - 2)/r\n"), "{infix}");
    let latex = part(Notation::Latex, "constraint_convective");
    assert!(latex.contains("\\mathrm{lift}_{2}^{\\prime \\prime } \\left(a - 2\\right)"), "{latex}");
    assert!(
        part(Notation::Latex, "constraints").contains("\\left(\\mathrm{lift}_{2} \\left(a - 2\\right)\\right)^{2}")
    );
    let mathml = part(Notation::MathMl, "constraint_jacobian");
    assert!(
        mathml.contains("<msup><msub><mi>lift</mi><mrow><mn>2</mn></mrow></msub><mrow><mo>′</mo></mrow></msup>"),
        "{mathml}"
    );
}
