//! Mechanisms that reach every part of the language and of the derivation; with the shipped ones they are what the
//! checks of this folder run over.

use sim::Description;
use sim::mechanism;

mechanism! {
    /// A bead on a rod that turns: mixed second derivatives.
    pub(crate) Bead;
    coordinates { r [m]; phi [rad]; }
    parameters { m [kg] = 2; J [kg*m^2] = 0.3; g [m/s^2] = 9.81; c [N*s/m] = 0.4; }
    let P = r*[cos(phi), sin(phi)];
    bodies { rod: inertia J, angle phi; bead: mass m at P; }
    loads { gravity [0, -g]; force -c*dot(P) at P; torque 0.1*sin(t) on rod; }
    initial { r = 0.5; phi = 0.1; dot(phi) = 3; }
    outputs { speed [m/s] = norm(dot(P)); radial [m/s^2] = ddot(r) - r*dot(phi)^2; }
}

mechanism! {
    /// A double pendulum on a cart whose rail and support move as declared, closed by a rod that time drives.
    pub(crate) Cart;
    coordinates { x [m]; a [rad]; b [rad]; }
    parameters { M [kg] = 3; m [kg] = 1; n [kg] = 0.5; l [m] = 0.8; k [m] = 0.6; J [kg*m^2] = 0.05; g [m/s^2] = 9.81; w [1/s] = 2; }
    let O = [x, 0.1*sin(w*t)];
    let A = O + l*[sin(a), -cos(a)];
    let B = A + k*[sin(b), -cos(b)];
    bodies { cart: mass M at O; first: mass m at A, inertia J, angle a; second: mass n at B, inertia J*k/l, angle b - a/3; }
    loads { gravity [0.1*t, -g]; force [-2*x - dot(x)*abs(dot(x)), 0] at O; torque -0.1*dot(b - a) on second; }
    constraints { leash: norm(B - [0.2, 0.3*cos(w*t)]) = 1.1 + 0.05*sin(3*t); }
    initial { x = 0.1; guess a = 0.2; b = 0.3; dot(x) = 0.4; dot(a) = 0.2; }
    events { low: B.y = -1; }
    outputs { tip [m] = B.x; tip_speed [m/s] = dot(B.x); tip_acceleration [m/s^2] = ddot(B.x); leash_force [N] = reaction(leash); }
    drawing { line O, A, B; ground [0, 0]; slider O along 0; circle B radius 0.05; point A; }
}

mechanism! {
    /// Every function of the language, and powers of every kind, in one potential-like load and one position.
    pub(crate) Functions;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; p = 1.7; type [m] = 2; }
    let u = sin(x)*cos(y) + tan(x/4) + asin(x/9) + acos(y/9) + atan(x*y) + atan2(y, x + 5);
    let v = sqrt(x^2 + y^2 + 1) + exp(-x^2) + ln(x^2 + 3) + abs(x - 2*y) + sinh(x/3) + cosh(y/3) + tanh(x);
    let w = (x^2 + 1)^p + (y^2 + 2)^(1/3) + (x^2 + y^2 + 1)^(-3/2) + (y^2 + 1)^-2 + p^(x/5) + pi*e*x^5/type;
    bodies { point: mass m at [x + u/20, y + v/30]; }
    loads { force [w, u*v] at [x, y]; force [y, x]/(1 + x^2) at [v, x]; }
    initial { x = 0.5; y = 0.7; }
    events { even: u = v; }
    outputs { u = u; v = v; w = w; rate = dot(u*v); second = ddot(w); }
}

mechanism! {
    /// A rod in absolute coordinates with its pin as a constraint between vectors, and names that are Rust's.
    pub(crate) Rod;
    coordinates { x [mm]; q [mm]; phi [deg]; }
    parameters { l [mm] = 600; m [g] = 500; J = 0.015; r#fn [N] = 3; t0 = 2; }
    let G = [x, q];
    bodies { rod: mass m at G, inertia J, angle phi; }
    loads { gravity [0, -9.81]; force [r#fn, 0] at G + l/2*[cos(phi), sin(phi)]; }
    constraints { pin: G - l/2*[cos(phi), sin(phi)] = [0, 0]; }
    initial { phi = 30; guess x = 300; guess q = 100; dot(phi) = 60 [rpm]; }
    outputs { pin_x [kN] = reaction(pin).x; pin_y [N] = reaction(pin).y; }
}

/// Calls a macro with the types of all mechanisms, the shipped ones first.
macro_rules! all_mechanisms {
    ($callback:ident) => {
        $callback!(
            models::QuickReturn,
            models::QuickReturnRatio,
            models::Andrews,
            models::Pendulum,
            models::DoublePendulum,
            models::FourBar,
            models::SliderCrank,
            crate::mechanisms::Bead,
            crate::mechanisms::Cart,
            crate::mechanisms::Functions,
            crate::mechanisms::Rod
        )
    };
}
pub(crate) use all_mechanisms;

/// The shipped mechanisms and those of this file.
pub(crate) fn all() -> Vec<&'static Description> {
    macro_rules! descriptions {
        ($($model:ty),*) => { [$(const { &<$model as sim::Mechanism>::DESCRIPTION }),*] };
    }
    [tests::shipped(), descriptions!(Bead, Cart, Functions, Rod).to_vec()].concat()
}
