//! The N-four-bar mechanism by its null space, in one sweep forth and one back.
//!
//! The mechanism is problem A02 of the library of computational benchmarks of the IFToMM technical committee for multibody
//! dynamics (Gonzalez, Dopico, Lugris, Cuadrado: A benchmarking system for MBS simulation software, 2006): N + 1
//! cranks side by side, joined by N couplers, all of one length and mass.

/// Parameters: all rods are equal, and so are the distances of the pivots.
#[derive(Clone, Copy, Debug)]
pub struct FourBars {
    /// Mass of a rod, in kg.
    pub m: f64,
    /// Length of a rod, in m.
    pub l: f64,
    /// Acceleration of free fall, along -y.
    pub g: f64,
}

/// Accelerations and reactions of N loops with K = N + 1 cranks.
#[derive(Clone, Copy, Debug)]
pub struct FourBarsSolution<const N: usize, const K: usize> {
    /// Of the cranks.
    pub cranks: [f64; K],
    /// Of the couplers.
    pub couplers: [f64; N],
    /// Of each loop, closed at the tip of its second crank.
    pub reactions: [[f64; 2]; N],
}

/// What a loop's crank and coupler turn into: their second derivatives are `forced + free * (that of the first crank)`.
#[derive(Clone, Copy, Default)]
struct Affine {
    free: f64,
    forced: f64,
}

#[derive(Clone, Copy, Default)]
struct Loop {
    coupler: Affine,
    crank: Affine,
    u_coupler: [f64; 2],
    u_crank: [f64; 2],
    /// 1 / sin(crank - coupler).
    over: f64,
    /// Half the cosine of (crank before - coupler).
    half_cos: f64,
    /// Terms without accelerations: of the coupler, and of the crank before.
    coupler_term: f64,
    before_term: f64,
}

/// Accelerations and reactions at a state, from absolute angles of the cranks and couplers.
///
/// Everything is divided by m l^2, and reactions by m l.
pub fn four_bars<const N: usize, const K: usize>(
    p: &FourBars,
    cranks: &[f64; K],
    couplers: &[f64; N],
    crank_rates: &[f64; K],
    coupler_rates: &[f64; N],
) -> FourBarsSolution<N, K> {
    // A crank's inertia about its pivot with a coupler's mass at its tip; the last has none.
    const WITH_TIP: f64 = 4.0 / 3.0;
    const ROD: f64 = 1.0 / 3.0;
    let weight = p.g / p.l;
    // Sines first: the sweep waits for nothing but itself.
    let (mut of_cranks, mut of_couplers) = ([(0.0, 0.0); K], [(0.0, 0.0); N]);
    for i in 0..K {
        of_cranks[i] = cranks[i].sin_cos();
    }
    for i in 0..N {
        of_couplers[i] = couplers[i].sin_cos();
    }
    let mut loops = [Loop::default(); N];
    let (sin, cos) = of_cranks[0];
    let (mut u_before, mut before) = ([cos, sin], Affine { free: 1.0, forced: 0.0 });
    let mut before_square = crank_rates[0] * crank_rates[0];
    let (mut inertia, mut force) = (0.0, 0.0);
    for k in 0..N {
        let ((s, c), (sp, cp)) = (of_cranks[k + 1], of_couplers[k]);
        let [cb, sb] = u_before;
        let (square, coupler_square) = (crank_rates[k + 1] * crank_rates[k + 1], coupler_rates[k] * coupler_rates[k]);
        // Angles between the crank, the coupler and the crank before.
        let (sin_pair, cos_pair) = (s * cp - c * sp, c * cp + s * sp);
        let (sin_before, cos_before) = (sb * cp - cb * sp, cb * cp + sb * sp);
        let (sin_cranks, cos_cranks) = (s * cb - c * sb, c * cb + s * sb);
        let over = 1.0 / sin_pair;
        let coupler_by = -sin_cranks * over;
        let crank_by = sin_before * over;
        let coupler = Affine {
            free: coupler_by * before.free,
            forced: coupler_by * before.forced
                + (before_square * cos_cranks + coupler_square * cos_pair - square) * over,
        };
        let crank = Affine {
            free: crank_by * before.free,
            forced: crank_by * before.forced + (before_square * cos_before + coupler_square - square * cos_pair) * over,
        };
        let half_cos = 0.5 * cos_before;
        let coupler_term = 0.5 * (weight * cp - before_square * sin_before);
        let before_term = 1.5 * weight * cb + 0.5 * coupler_square * sin_before;
        inertia += before.free * (WITH_TIP * before.free + half_cos * coupler.free)
            + coupler.free * (ROD * coupler.free + half_cos * before.free);
        force += before.free * (WITH_TIP * before.forced + half_cos * coupler.forced + before_term)
            + coupler.free * (ROD * coupler.forced + half_cos * before.forced + coupler_term);
        let (u_coupler, u_crank) = ([cp, sp], [c, s]);
        loops[k] = Loop { coupler, crank, u_coupler, u_crank, over, half_cos, coupler_term, before_term };
        (u_before, before, before_square) = (u_crank, crank, square);
    }
    let last_term = 0.5 * weight * u_before[0];
    inertia += ROD * before.free * before.free;
    force += before.free * (ROD * before.forced + last_term);
    let first = -force / inertia;
    let mut found = FourBarsSolution { cranks: [first; K], couplers: [0.0; N], reactions: [[0.0; 2]; N] };
    for k in 0..N {
        found.cranks[k + 1] = loops[k].crank.forced + loops[k].crank.free * first;
        found.couplers[k] = loops[k].coupler.forced + loops[k].coupler.free * first;
    }
    // The equations of a loop's coupler and crank give its reaction, from the last loop to the first.
    let mut crank_residual = ROD * found.cranks[N] + last_term;
    let mut next = [0.0; 2];
    for k in (0..N).rev() {
        let Loop { u_coupler, u_crank, over, half_cos, coupler_term, before_term, .. } = loops[k];
        let (coupler, before) = (found.couplers[k], found.cranks[k]);
        let along_coupler = -(ROD * coupler + half_cos * before + coupler_term) * over;
        let along_crank = (crank_residual + next[1] * u_crank[0] - next[0] * u_crank[1]) * over;
        next = [
            along_coupler * u_crank[0] - along_crank * u_coupler[0],
            along_coupler * u_crank[1] - along_crank * u_coupler[1],
        ];
        found.reactions[k] = [p.m * p.l * next[0], p.m * p.l * next[1]];
        crank_residual = WITH_TIP * before + half_cos * coupler + before_term;
    }
    found
}
