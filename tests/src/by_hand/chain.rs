//! The articulated-body recursion for a plane chain of uniform rods (Featherstone: Rigid Body Dynamics Algorithms,
//! 2008, ch. 7; written with forces at the pins instead of spatial vectors).

/// Parameters of a chain of equal rods that hangs from the ground.
#[derive(Clone, Copy, Debug)]
pub struct Chain {
    /// Mass of a rod, in kg; the motion does not depend on it.
    pub m: f64,
    /// Length of a rod, in m.
    pub l: f64,
    /// Acceleration of free fall, along -y.
    pub g: f64,
}

/// What the way inwards leaves for the way outwards: alpha = -(s a + e), a the acceleration of the inner pin.
#[derive(Clone, Copy, Default)]
struct Link {
    s: [f64; 2],
    e: f64,
}

/// Angular accelerations from absolute angles and their rates, in O(N).
///
/// The rods outside a pin resist its acceleration with the force A a + b. A rod adds itself to that of its outer pin
/// and loses its own angle, from the outermost rod inwards; then the accelerations follow outwards. All accelerations
/// are less free fall, so that weight enters once, as that of the ground. Everything is divided by m and l: equal rods have
/// mass and length 1, and inertia 1/3 about a pin.
pub fn chain_absolute<const N: usize>(p: &Chain, angles: &[f64; N], rates: &[f64; N]) -> [f64; N] {
    // Sines first: the recursion waits for nothing but itself.
    let mut directions = [(0.0, 0.0); N];
    for i in 0..N {
        directions[i] = angles[i].sin_cos();
    }
    let mut links = [Link::default(); N];
    // A symmetric, b.
    let ([mut xx, mut xy, mut yy], mut b) = ([0.0; 3], [0.0; 2]);
    for i in (0..N).rev() {
        let (sin, cos) = directions[i];
        let square = rates[i] * rates[i];
        // A n with n = (-sin, cos), and A u with u = (cos, sin).
        let (nx, ny) = (xy * cos - xx * sin, yy * cos - xy * sin);
        let (ux, uy) = (xx * cos + xy * sin, xy * cos + yy * sin);
        let over = 1.0 / (1.0 / 3.0 + (ny * cos - nx * sin));
        let (hx, hy) = (b[0] - square * ux, b[1] - square * uy);
        let (sx, sy) = (nx - 0.5 * sin, ny + 0.5 * cos);
        let (tx, ty) = (sx * over, sy * over);
        let e = hy * cos - hx * sin;
        let centrifugal = 0.5 * square;
        b = [hx - centrifugal * cos - tx * e, hy - centrifugal * sin - ty * e];
        (xx, xy, yy) = (xx + 1.0 - sx * tx, xy - sx * ty, yy + 1.0 - sy * ty);
        links[i] = Link { s: [tx, ty], e: e * over };
    }
    let mut accelerations = [0.0; N];
    let (mut x, mut y) = (0.0, p.g / p.l);
    for i in 0..N {
        let (Link { s, e }, (sin, cos)) = (links[i], directions[i]);
        let alpha = -(s[0] * x + s[1] * y + e);
        let square = rates[i] * rates[i];
        x -= alpha * sin + square * cos;
        y += alpha * cos - square * sin;
        accelerations[i] = alpha;
    }
    accelerations
}

/// As [`chain_absolute`], each angle measured from the rod before.
pub fn chain_relative<const N: usize>(p: &Chain, angles: &[f64; N], rates: &[f64; N]) -> [f64; N] {
    let (mut absolute, mut absolute_rates) = (*angles, *rates);
    for i in 1..N {
        absolute[i] += absolute[i - 1];
        absolute_rates[i] += absolute_rates[i - 1];
    }
    let mut accelerations = chain_absolute(p, &absolute, &absolute_rates);
    for i in (1..N).rev() {
        accelerations[i] -= accelerations[i - 1];
    }
    accelerations
}
