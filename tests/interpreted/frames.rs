//! Points and attitudes of frames are those that are written out by hand, to the last bit.

use sim::{At, DeclarationFile, Kernel, Model};
use std::path::Path;
use std::sync::Arc;
use tests::Random;
use tests::called::called;

fn declared(text: &str) -> Arc<dyn Model> {
    DeclarationFile::of(Path::new("frames.mech"), text.to_owned()).model(None).map_err(|why| why.to_string()).unwrap()
}

/// At random states.
fn are_the_same(by_frames: &str, by_hand: &str) {
    let (framed, written) = (declared(by_frames), declared(by_hand));
    let random = &mut Random(2);
    let n = framed.description().coordinates.len();
    let multipliers = vec![0.0; framed.description().constraints.len()];
    for _ in 0..20 {
        let [q, qd, a] = [(); 3].map(|()| (0..n).map(|_| random.between(-1.0, 1.0)).collect::<Vec<f64>>());
        let at = At { time: 0.3, positions: &q, speeds: &qd, accelerations: &a, multipliers: &multipliers };
        for kernel in [Kernel::Dynamics, Kernel::MassMatrix, Kernel::KineticEnergy, Kernel::Outputs, Kernel::Drawing] {
            let [found, expected] = [&framed, &written].map(|model| called(&**model, kernel, at));
            let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            assert!(!found.is_empty());
            assert_eq!(bits(&found), bits(&expected), "{kernel:?}");
        }
    }
}

#[test]
fn in_space() {
    let rest = "loads { gravity [0, 0, -9.81 [m/s^2]]; force [1 [N], 0, 2 [N]] at TIP; }
        outputs { height [m] = (TIP).z; turning [rad/s] = norm(SPIN); }
        drawing { line [0, 0, 0], TIP; }";
    let rest = |tip: &str, spin: &str| rest.replace("TIP", tip).replace("SPIN", spin);
    let head = "pub Arm; parameters { l [m] = 0.4; m [kg] = 3; J [kg*m^2] = 0.05; } coordinates { a [rad]; b [rad]; }
        bodies { base: free, mass 5*m, inertia [3*J, 4*J, 5*J]; }";
    let framed = format!(
        "{head} frames {{
            shoulder: at on(base, [0.1*l, 0, l]), attitude attitude(base)*rotation(y, a);
            elbow: at on(shoulder, [l, 0, 0]), attitude attitude(shoulder)*rotation([0, 0.6, 0.8], b);
            tip: at on(elbow, [l, 0.1*l, 0]), attitude attitude(elbow)*rotation(x, 0.3);
        }}
        bodies {{ upper: mass m at on(shoulder, [l/2, 0, 0]), inertia [J, 2*J, 2*J], attitude attitude(shoulder);
            lower: mass m at on(elbow, [l/2, 0, 0]), inertia [J, 2*J, 2*J], attitude attitude(elbow); }} {}",
        rest("on(tip, [0, 0, 0.1*l])", "omega(tip)")
    );
    let written = format!(
        "{head} let R = attitude(base)*rotation(y, a); let S = R*rotation([0, 0.6, 0.8], b); let T = S*rotation(x, 0.3);
        let P = on(base, [0.1*l, 0, l]); let Q = P + R*[l, 0, 0]; let U = Q + S*[l, 0.1*l, 0];
        bodies {{ upper: mass m at P + R*[l/2, 0, 0], inertia [J, 2*J, 2*J], attitude R;
            lower: mass m at Q + S*[l/2, 0, 0], inertia [J, 2*J, 2*J], attitude S; }} {}",
        rest("(U + T*[0, 0, 0.1*l])", "angular_velocity(T)")
    );
    are_the_same(&framed, &written);
}

#[test]
fn in_the_plane() {
    let rest = "loads { gravity [0, -9.81 [m/s^2]]; force [1 [N], 2 [N]] at TIP; }
        outputs { height [m] = (TIP).y; } drawing { line [0, 0], TIP; }";
    let head = "pub Arm; parameters { l [m] = 0.4; m [kg] = 3; J [kg*m^2] = 0.05; } coordinates { a [rad]; }
        bodies { base: free, mass 5*m, inertia 3*J; }";
    let framed = format!(
        "{head} frames {{ elbow: at on(base, [l, 0.1*l]), angle base_phi + a; }}
        bodies {{ lower: mass m at on(elbow, [l/2, 0]), inertia J, angle base_phi + a; }} {}",
        rest.replace("TIP", "on(elbow, [l, 0.2*l])")
    );
    let written = format!(
        "{head} let P = on(base, [l, 0.1*l]); let phi = base_phi + a; let u = [cos(phi), sin(phi)]; let v = [-sin(phi), cos(phi)];
        bodies {{ lower: mass m at P + l/2*u, inertia J, angle phi; }} {}",
        rest.replace("TIP", "(P + l*u + 0.2*l*v)")
    );
    are_the_same(&framed, &written);
}
