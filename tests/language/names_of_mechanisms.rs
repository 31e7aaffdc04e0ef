//! Names that what is generated uses too: as mechanisms, coordinates, parameters, inputs, outputs and intermediate results.

// In a crate of its own this would be seen from outside.
#![allow(dead_code, unreachable_pub)]

use mechanism_macros::mechanism;

/// A mechanism of this name, in a module of its own, with these names for what it has.
macro_rules! named {
    ($($module:ident $name:ident [$q:ident $p:ident $i:ident $l:ident $o:ident];)*) => { $(
        mod $module {
            mechanism_macros::mechanism! {
                pub $name;
                coordinates { $q [rad]; phi [rad]; }
                parameters { $p [m] = 1; m [kg] = 2; }
                inputs { $i [N*m] = 0; }
                let $l = sin($q)*cos(phi) + $p/1 [m];
                bodies { bob: mass m at $p*[cos($q), sin($q)], angle phi; }
                loads { torque $i*$l on bob; }
                constraints { held: phi = 1 initially released; }
                events { hit: phi = 1 { activate held; } }
                outputs { $o = $l*$l; }
            }
        }
    )* };
}

named! {
    a T [q qd qdd lambda u];
    b U [prepared found convert record values];
    o Compiled [DESCRIPTION description as_declared mechanism compiled];
    c Mechanism [scalar parameters inputs activities defaults];
    d Option [dynamics prepare initial outputs drawing];
    e Default [core std alloc sim sim_kernel];
    f f64 [usize bool str f32 u8];
    g Scalar [S T Q L Z];
    h Clone [Some None Ok Err Vec];
    i Copy [main drop union auto raw];
    j Debug [mask one zero event kinetic_energy];
}

mechanism! {
    /// What is private may be called as keywords are.
    r#type;
    coordinates { r#fn [rad]; r#match [m]; }
    parameters { r#loop [kg] = 1; }
    bodies { r#struct: mass r#loop at [r#match, 0], inertia 1 [kg*m^2], angle r#fn; }
    outputs { r#if [m] = r#match; }
}

#[test]
fn names_of_what_is_generated_are_names_like_others() {
    use sim_kernel::Compiled as _;
    let _ = (a::T::<f64>::defaults(), b::U::<f64>::defaults(), r#type::<f64>::defaults());
}
