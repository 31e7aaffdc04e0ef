//! Names that are keywords, prelude names or names inside the generated code.

// What the user's module has under the same names.
#[allow(dead_code)]
const N: f64 = 1.0;
#[allow(dead_code)]
struct P;

mechanism_macros::mechanism! {
    /// A spring pendulum, in numbers without units.
    pub Names;
    coordinates { r#type; q; N; r#gen; }
    parameters { S = 1; r#fn = 2; value = 3; self_mass = 1; lambda = 50; f64 = 1; }
    let Some = (S + r#type)*[sin(q), -cos(q)];
    let P = N + q;
    bodies { r#loop: mass r#fn + self_mass at Some, inertia value, angle P*sin(P); other: mass value at [r#gen, P^2]; }
    loads { gravity [0, -9.81]; force -lambda*r#type*[sin(q), -cos(q)]*f64 at Some; }
    initial { q = 0.3; }
    outputs { refused = Some.x*value; Ok = dot(q); }
}

#[test]
fn names_of_rust_are_names_like_others() {
    use sim_kernel::Compiled;
    let mechanism: Names = Names { S: 2.0, ..Names::default() };
    let coordinates = NamesCoordinates { r#type: 0.1, q: 0.2, N: 0.3, r#gen: 0.4 };
    let solved = mechanism.dynamics(0.0, &coordinates.into(), &[0.0; 4]);
    assert!(!solved.refused && Names::<f32>::defaults().S == 1.0);
}
