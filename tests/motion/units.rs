//! The same mechanism declared in different units moves the same, and reports in the units it declares.

use sim::{Table, mechanism};
use tests::any_model::run;

mechanism! {
    /// In SI units throughout.
    Si;
    coordinates { x [m]; phi [rad]; }
    parameters { l [m] = 0.3; m [kg] = 0.5; k [N/m] = 200; w [rad/s] = 3; start [rad] = 0.5; }
    let P = [x + l*sin(phi), -l*cos(phi)];
    bodies { block: mass 2*m at [x, 0]; bob: mass m at P; }
    loads { gravity [0, -9.81 [m/s^2]]; force [-k*x, 0] at [x, 0]; }
    initial { x = 0.01; dot(x) = 0.2; phi = start; dot(phi) = w; }
    outputs { height [m] = P.y; rate [rad/s] = dot(phi); acceleration [m/s^2] = ddot(P.x); weight [N] = 9.81 [m/s^2]*m; }
}

mechanism! {
    /// In other units.
    Mixed;
    coordinates { x [mm]; phi [deg]; }
    parameters { l [cm] = 30; m [g] = 500; k [N/mm] = 0.2; w [rpm] = 90/pi; start [deg] = 90/pi; }
    let P = [x + l*sin(phi), -l*cos(phi)];
    bodies { block: mass 2*m at [x, 0]; bob: mass m at P; }
    loads { gravity [0, -9.81 [m/s^2]]; force [-k*x, 0] at [x, 0]; }
    initial { x = 10; dot(x) = 720 [m/h]; phi = start; dot(phi) = w; }
    outputs { height [cm] = P.y; rate [rpm] = dot(phi); acceleration [km/h/s] = ddot(P.x); weight [kN] = 9.81 [m/s^2]*m; }
}

#[test]
fn units_change_what_is_reported_and_not_the_motion() {
    let si = run(Si::default(), 0.7, 200).unwrap();
    let mixed = run(Mixed::default(), 0.7, 200).unwrap();
    let (si, mixed) = (Table::of(&si.mechanism, &si.trajectory), Table::of(&mixed.mechanism, &mixed.trajectory));
    let pi = std::f64::consts::PI;
    let rows = [
        ("t", "s", 1.0),
        ("x", "mm", 1e3),
        ("phi", "deg", 180.0 / pi),
        ("x_dot", "mm/s", 1e3),
        ("phi_dot", "deg/s", 180.0 / pi),
        ("x_ddot", "mm/s^2", 1e3),
        ("phi_ddot", "deg/s^2", 180.0 / pi),
        ("height", "cm", 1e2),
        ("rate", "rpm", 30.0 / pi),
        ("acceleration", "km/h/s", 3.6),
        ("weight", "kN", 1e-3),
        ("work", "J", 1.0),
    ];
    assert_eq!(rows.len(), mixed.columns.len());
    for (name, unit, factor) in rows {
        let (a, b) = (si.column(name).unwrap(), mixed.column(name).unwrap());
        assert_eq!(b.unit, unit);
        let largest = a.values.iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
        for (a, b) in a.values.iter().zip(&b.values) {
            // The roundings of the defaults, carried along for 0.7 s.
            assert!((a * factor - b).abs() <= 1e-12 * factor * largest, "{name}: {a} {b}");
        }
    }
}
