//! Trees of bodies in space, declared; their first parameter is a length, and the second a mass.

use sim::{DeclarationFile, Model};
use std::path::Path;
use std::sync::Arc;

/// Branches, a prismatic joint, a coordinate that turns two links, skew axes, fixed turns, and centres of mass beside their
/// frames; parameters for masses, so that regrouping is symbolic.
pub(crate) const BRANCHES: &str = "
    pub Branches;
    coordinates { a [rad]; b [rad]; c [m]; d [rad]; h [rad]; f [rad]; g [rad]; }
    parameters { L [m] = 1; m [kg] = 1; k [N/m] = 20; }
    let A = rotation(z, a);
    let B = A*axes([0, 0, -1], [0, 1, 0], [1, 0, 0])*rotation(y, b);
    let PB = A*[0.2*L, 0.1*L, 0.3*L];
    let PC = PB + B*[0, 0.1*L, 0.4*L + c];
    let D = B*rotation([0.6, 0, 0.8], d)*rotation(x, 0.3 - 2*b);
    let E = A*rotation(x, h);
    let PE = A*[-0.3*L, 0, 0.1*L];
    let F = E*euler(zxz, f, 0.4, g);
    let PF = PE + E*[0.1*L, -0.5*L, 0];
    bodies {
        first: mass 2*m at A*[0.1*L, 0.2*L, -0.1*L], inertia [0.3*m*L^2, 0.2*m*L^2, 0.25*m*L^2, 0.01*m*L^2, 0.02*m*L^2, 0.03*m*L^2], attitude A;
        second: mass m at PB + B*[0.05*L, 0.1*L, 0.2*L], inertia [0.1*m*L^2, 0.09*m*L^2, 0.05*m*L^2], attitude B;
        third: mass 0.5*m at PC + B*[0.02*L, 0, 0], inertia [0.01*m*L^2, 0.012*m*L^2, 0.008*m*L^2], attitude B;
        fourth: mass 0.3*m at PC + D*[0, 0.1*L, 0.05*L], inertia [0.011*m*L^2, 0.012*m*L^2, 0.013*m*L^2, 0.001*m*L^2, 0, 0.002*m*L^2], attitude D;
        fifth: mass m at PE + E*[0, -0.2*L, 0.1*L], inertia [0.1*m*L^2, 0.04*m*L^2, 0.09*m*L^2], attitude E;
        sixth: mass 0.4*m at PF + F*[0.03*L, 0.02*L, 0.2*L], inertia [0.02*m*L^2, 0.03*m*L^2, 0.015*m*L^2], attitude F;
        wheel: inertia [0.001*m*L^2, 0.001*m*L^2, 0.002*m*L^2], attitude F;
    }
    loads { gravity [1 [m/s^2], -2 [m/s^2], -9.81 [m/s^2]]; spring k, length 0.1*L from PC to PF; torque 0.1*m*L^2*t/(1 [s^3]) on h; }
    kernels { inverse_dynamics; }";

/// A base that moves freely, and one limb. The last load acts along its quaternion, which the multiplier of the norm
/// takes up.
pub(crate) const FREE: &str = "
    pub Floating;
    parameters { L [m] = 1; m [kg] = 1; k [N/m] = 20; }
    bodies { base: free, mass 3*m, inertia [0.3*m*L^2, 0.4*m*L^2, 0.35*m*L^2, 0.01*m*L^2, 0.02*m*L^2, 0.03*m*L^2]; }
    coordinates { a [rad]; b [rad]; }
    let A = attitude(base)*rotation(y, a);
    let PA = on(base, [0.1*L, 0.2*L, -0.3*L]);
    let B = A*rotation(y, b);
    let PB = PA + A*[0, 0.1*L, -0.4*L];
    bodies {
        upper: mass m at PA + A*[0.01*L, 0.03*L, -0.2*L], inertia [0.05*m*L^2, 0.06*m*L^2, 0.03*m*L^2], attitude A;
        lower: mass 0.7*m at PB + B*[0.02*L, 0, -0.15*L], inertia [0.02*m*L^2, 0.03*m*L^2, 0.015*m*L^2], attitude B;
    }
    loads {
        gravity [0, 0, -9.81 [m/s^2]];
        spring k, length 0.1*L from PA to PB;
        potential m*L^2*(base_q0^3 + 2*base_q2)/(1 [s^2]);
    }
    kernels { inverse_dynamics; }";

/// A base with loads on it, and a limb of so many joints that each is eliminated at its link: about axes of a frame and askew,
/// one that slides, one with a rotor that turns with it, two on one link. And a second base, of which the first knows nothing.
pub(crate) const LIMB: &str = "
    pub Limb;
    parameters { L [m] = 1; m [kg] = 1; k [N/m] = 20; }
    bodies {
        base: free, mass 3*m, inertia [0.3*m*L^2, 0.4*m*L^2, 0.35*m*L^2, 0.01*m*L^2, 0.02*m*L^2, 0.03*m*L^2];
        other: free, mass 2*m, inertia [0.2*m*L^2, 0.1*m*L^2, 0.25*m*L^2];
    }
    coordinates { a [rad]; b [rad]; c [rad]; d [m]; s [rad]; f [rad]; g [rad]; h [rad]; i [rad]; o [rad]; u [rad]; }
    let A = attitude(base)*rotation(y, a);
    let PA = on(base, [0.1*L, 0.2*L, -0.3*L]);
    let B = A*rotation(x, b);
    let PB = PA + A*[0, 0.1*L, -0.4*L];
    let C = B*rotation([0.6, 0, 0.8], c);
    let PC = PB + B*[0.1*L, 0.1*L, -0.3*L];
    let PD = PC + C*[0, 0.1*L, d];
    let E = C*rotation(z, s);
    let PE = PD + C*[0.1*L, 0, 0.2*L];
    let F = E*axes([0, 1, 0], [0, 0, 1], [1, 0, 0])*rotation(y, f);
    let PF = PE + E*[0, -0.3*L, 0.1*L];
    let G = F*rotation(y, g);
    let PG = PF + F*[0.2*L, 0.1*L, 0];
    let H = G*rotation(x, h);
    let PH = PG + G*[0.2*L, 0, 0.3*L];
    let I = H*rotation(z, i + 2*u);
    let PI = PH + H*[0, 0.3*L, 0.1*L];
    let O = attitude(other)*rotation(z, o);
    bodies {
        one: mass m at PA + A*[0.01*L, 0.03*L, -0.2*L], inertia [0.05*m*L^2, 0.06*m*L^2, 0.03*m*L^2], attitude A;
        two: mass 0.7*m at PB + B*[0.02*L, 0, -0.15*L], inertia [0.02*m*L^2, 0.03*m*L^2, 0.015*m*L^2], attitude B;
        three: mass 0.6*m at PC + C*[0.02*L, 0, -0.1*L], inertia [0.02*m*L^2, 0.03*m*L^2, 0.025*m*L^2, 0.001*m*L^2, 0.002*m*L^2, 0], attitude C;
        four: mass 0.5*m at PD + C*[0.1*L, 0.02*L, 0], inertia [0.01*m*L^2, 0.012*m*L^2, 0.008*m*L^2], attitude C;
        five: mass 0.5*m at PE + E*[0.1*L, 0.02*L, 0], inertia [0.01*m*L^2, 0.012*m*L^2, 0.009*m*L^2], attitude E;
        six: mass 0.4*m at PF + F*[0.05*L, 0.1*L, 0.1*L], inertia [0.01*m*L^2, 0.011*m*L^2, 0.008*m*L^2], attitude F;
        seven: mass 0.4*m at PG + G*[0.05*L, 0, 0.1*L], inertia [0.01*m*L^2, 0.012*m*L^2, 0.007*m*L^2], attitude G;
        eight: mass 0.3*m at PH + H*[0, 0.1*L, 0.1*L], inertia [0.01*m*L^2, 0.012*m*L^2, 0.008*m*L^2], attitude H;
        nine: mass 0.3*m at PI + I*[0.05*L, 0.1*L, 0.1*L], inertia [0.009*m*L^2, 0.012*m*L^2, 0.008*m*L^2], attitude I;
        ten: mass m at on(other, [0.1*L, 0, 0.2*L]) + O*[0.1*L, 0.1*L, 0], inertia [0.1*m*L^2, 0.12*m*L^2, 0.08*m*L^2], attitude O;
        rotor: inertia 0.02*m*L^2, angle b;
        gear: inertia 0.03*m*L^2, angle u + 0.2*sin(u);
    }
    loads {
        gravity [1 [m/s^2], 0, -9.81 [m/s^2]];
        spring k, length 0.1*L from PA to PF;
        spring k, length 0.2*L from [0, 0, L] to on(base, [0, 0.1*L, 0.2*L]);
        torque [0.1*m*L^2/(1 [s^2]), 0, 0.2*m*L^2/(1 [s^2])] on base;
        torque 0.1*m*L^2/(1 [s^2]) on g;
    }
    kernels { inverse_dynamics; speed_mass_matrix; }";

/// An arm on the ground: turns about axes of a frame and askew, one that slides askew, and two motors of one turn.
pub(crate) const ARM: &str = "
    pub Arm;
    parameters { L [m] = 1; m [kg] = 1; k [N/m] = 20; }
    coordinates { a [rad]; b [rad]; s [m]; c [rad]; d [rad]; h [rad]; f [rad]; }
    let A = rotation(x, 0.3)*rotation(z, a);
    let B = A*rotation([0.6, 0, 0.8], b);
    let PB = A*[0.1*L, 0.2*L, 0.3*L];
    let PS = PB + B*[0.3*L, 0.6*s, 0.8*s];
    let C = B*rotation(y, c + 3*d);
    let PC = PS + B*[0, 0.1*L, 0.2*L];
    let E = C*rotation(x, h);
    let PE = PC + C*[0.2*L, 0, 0.1*L];
    let F = E*rotation(y, f);
    let PF = PE + E*[0, 0.3*L, 0];
    bodies {
        one: mass m at A*[0.01*L, 0.03*L, 0.2*L], inertia [0.05*m*L^2, 0.06*m*L^2, 0.03*m*L^2, 0.001*m*L^2, 0, 0.002*m*L^2], attitude A;
        two: mass 0.7*m at PB + B*[0.02*L, 0, 0.15*L], inertia [0.02*m*L^2, 0.03*m*L^2, 0.015*m*L^2], attitude B;
        three: mass 0.6*m at PS + B*[0.02*L, 0.1*L, 0], inertia [0.02*m*L^2, 0.03*m*L^2, 0.025*m*L^2], attitude B;
        four: mass 0.5*m at PC + C*[0.1*L, 0.02*L, 0], inertia [0.01*m*L^2, 0.012*m*L^2, 0.008*m*L^2, 0, 0.001*m*L^2, 0], attitude C;
        five: mass 0.4*m at PE + E*[0, 0.1*L, 0.03*L], inertia [0.01*m*L^2, 0.008*m*L^2, 0.009*m*L^2], attitude E;
        six: mass 0.3*m at PF + F*[0.1*L, 0, 0.1*L], inertia [0.004*m*L^2, 0.006*m*L^2, 0.005*m*L^2], attitude F;
        motor: inertia 0.02*m*L^2, angle d;
    }
    loads {
        gravity [1 [m/s^2], 0, -9.81 [m/s^2]];
        spring k, length 0.1*L from PB to PF;
        torque -0.1*m*L^2*dot(h)/(1 [s]) on h;
    }
    kernels { inverse_dynamics; }";

/// Limbs that stand in one place, in pairs, with a joint that slides among them: what follows a place is moved from there as one.
pub(crate) const TWINS: &str = "
    pub Twins;
    parameters { L [m] = 1; m [kg] = 1; k [N/m] = 20; }
    coordinates { a [rad]; b [rad]; c [m]; d [rad]; f [rad]; g [rad]; h [rad]; i [rad]; j [rad]; o [rad]; u [rad]; v [rad]; }
    let A = rotation(z, a);
    let PA = A*[0.1*L, 0.2*L, L];
    let B = A*rotation(x, b);
    let PC = PA + B*[0.1*L, 0, 0.2*L + c];
    let D = A*rotation(y, d);
    let PD = PA + D*[0.2*L, -0.3*L, 0.9*L];
    let F = B*rotation(y, f);
    let PF = PC + F*[0, 0, L];
    let G = B*rotation(z, g);
    let PG = PC + G*[0.3*L, 0, L];
    let H = D*rotation(x, h);
    let PH = PD + H*[0, 0.1*L, L];
    let I = D*rotation(z, i);
    let PI = PD + I*[0, 0.5*L, 0.5*L];
    let J = F*rotation(x, j);
    let O = F*rotation([0.6, 0, 0.8], o);
    let U = H*rotation(y, u);
    let V = H*rotation(x, v);
    fragment Body(P, R) {
        bodies { own: mass m at P + R*[0.1*L, 0.05*L, 0.5*L], inertia [0.1*m*L^2, 0.11*m*L^2, 0.05*m*L^2, 0.01*m*L^2, 0, 0.02*m*L^2], attitude R; }
    }
    use Body([0, 0, 0], A) as of_a; use Body(PA, B) as of_b; use Body(PC, B) as of_c; use Body(PA, D) as of_d;
    use Body(PC, F) as of_f; use Body(PC, G) as of_g; use Body(PD, H) as of_h; use Body(PD, I) as of_i;
    use Body(PF, J) as of_j; use Body(PF, O) as of_o; use Body(PH, U) as of_u; use Body(PH, V) as of_v;
    loads { gravity [1 [m/s^2], 0, -9.81 [m/s^2]]; spring k, length 0.1*L from PG to PI; torque 0.1*m*L^2/(1 [s^2]) on h; }
    kernels { inverse_dynamics; }";

/// Three turns of massless links, of which the outer ones have one axis where `b` is zero, and an arm on them.
pub(crate) const GIMBALS: &str = "
    pub Gimbals;
    parameters { L [m] = 1; m [kg] = 1; }
    coordinates { a [rad]; b [rad]; c [rad]; d [rad]; f [rad]; g [rad]; h [rad]; i [rad]; roll [rad]; }
    let C = rotation(z, a)*rotation(x, b)*rotation(z, c);
    let D = C*rotation(x, d); let PD = C*[0.1*L, 0, L];
    let F = D*rotation(y, f); let PF = PD + D*[0, 0.1*L, L];
    let G = F*rotation(x, g); let PG = PF + F*[0, 0, L];
    let H = G*rotation(y, h); let PH = PG + G*[0.1*L, 0, L];
    let I = H*rotation(x, i); let PI = PH + H*[0, 0, L];
    let R = I*rotation(z, roll);
    bodies {
        c: mass m at C*[0.1*L, 0, 0.5*L], inertia [0.1*m*L^2, 0.1*m*L^2, 0.05*m*L^2], attitude C;
        d: mass m at PD + D*[0.1*L, 0, 0.5*L], inertia [0.1*m*L^2, 0.1*m*L^2, 0.05*m*L^2], attitude D;
        f: mass m at PF + F*[0.1*L, 0, 0.5*L], inertia [0.1*m*L^2, 0.1*m*L^2, 0.05*m*L^2], attitude F;
        g: mass m at PG + G*[0.1*L, 0, 0.5*L], inertia [0.1*m*L^2, 0.1*m*L^2, 0.05*m*L^2], attitude G;
        h: mass m at PH + H*[0.1*L, 0, 0.5*L], inertia [0.1*m*L^2, 0.1*m*L^2, 0.05*m*L^2], attitude H;
        wire: mass m at PI + R*[0, 0, 0.5*L], inertia [0.1*m*L^2, 0.1*m*L^2, 1e-12*m*L^2], attitude R;
    }
    loads { gravity [0, 0, -9.81 [m/s^2]]; }";

/// A table that time turns and lifts carries an arm: the power is that of loads and drives.
pub(crate) const DRIVEN: &str = "
    pub Driven;
    coordinates { a [rad]; b [rad]; }
    parameters { L [m] = 1; m [kg] = 1; w [1/s] = 2; }
    let R = rotation(z, 0.3*sin(w*t));
    let A = R*rotation(x, a);
    let PA = [0, 0, 0.2*L*sin(w*t)] + R*[0.3*L, 0, 0.1*L];
    let B = A*rotation(y, b);
    let PB = PA + A*[0, 0.5*L, 0];
    bodies {
        arm: mass m at PA + A*[0.05*L, 0.25*L, 0], inertia [0.075*m*L^2, 0.01*m*L^2, 0.07*m*L^2, 0.002*m*L^2, 0, 0], attitude A;
        hand: mass 0.5*m at PB + B*[0.1*L, 0.05*L, 0.02*L], inertia [0.01*m*L^2, 0.02*m*L^2, 0.015*m*L^2], attitude B;
    }
    loads { gravity [0, 0, -9.81 [m/s^2]]; }
    kernels { inverse_dynamics; }";

/// Lengths are multiples of L and masses of m: of a mechanism of a millimetre as of one of 100 m.
pub(crate) fn scaled(text: &str, length: f64, mass: f64) -> Arc<dyn Model> {
    let model = DeclarationFile::of(Path::new("links.mech"), text.to_owned()).model(None).unwrap();
    let mut values = model.values();
    values.parameters[0] = length;
    values.parameters[1] = mass;
    model.with_values(&values)
}
