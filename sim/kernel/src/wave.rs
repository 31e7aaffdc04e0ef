//! Sine and cosine together, without branches, so that several angles are evaluated side by side.
//!
//! The angle is reduced by multiples of pi/2 in parts of 33 bits (Cody and Waite), each product exact for up to 2^20
//! quadrants; then the polynomials of fdlibm (Sun Microsystems, `k_sin.c`, `k_cos.c`) give both values. No fused
//! operations, so that every build gives the same bits. Angles next to a multiple of pi/2 are reduced with more parts;
//! larger angles, infinities and NaN go to libm.

/// Largest angle reduced here: 2^20 quadrants, rounded down.
const LARGEST: f64 = 1e6;

/// Adding and subtracting it rounds to an integer, which then stands in the lowest bits.
const ROUNDER: f64 = 1.5 * (1u64 << 52) as f64;

/// pi/2 in parts of 33 bits, and the rest.
const PI_HALVES: [f64; 4] =
    [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_711_166_5e-21, 8.478_427_660_368_9e-32];

/// pi/2 less its first part.
const PI_HALF_TAIL: f64 = 6.077_100_506_506_192e-11;

const SIN: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];

const COS: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Sine and cosine of each angle: the same bits as one by one.
#[inline(always)]
pub(crate) fn sin_cos_each<const N: usize>(angles: [f64; N]) -> ([f64; N], [f64; N]) {
    let (sines, cosines, all_plain) = side_by_side(angles);
    if all_plain { (sines, cosines) } else { each_by_itself(angles) }
}

/// Gives sine and cosine of each angle to a function, with the same bits as one by one. It is compiled once for the usual case and
/// once for the rare one: where the two met, what vector registers hold would go through memory.
#[inline(always)]
pub fn give_sin_cos<const N: usize>(angles: [f64; N], mut found: impl FnMut([f64; N], [f64; N])) {
    let (sines, cosines, all_plain) = side_by_side(angles);
    if all_plain {
        found(sines, cosines);
    } else {
        let (sines, cosines) = each_by_itself(angles);
        found(sines, cosines);
    }
}

/// Sines and cosines of a block of angles, with the same bits as one by one. One loop over arrays that do not overlap, which the
/// compiler turns into vector instructions.
#[inline(always)]
pub fn sin_cos_of_block<const N: usize>(angles: &[f64; N], sines: &mut [f64; N], cosines: &mut [f64; N]) {
    // As wide as the numbers, so that vectors hold both.
    let mut others = 0u64;
    for i in 0..N {
        let reduced = reduce(angles[i]);
        others |= u64::from(!reduced.is_plain);
        (sines[i], cosines[i]) = evaluate(angles[i], &reduced);
    }
    if others != 0 {
        (*sines, *cosines) = each_by_itself(*angles);
    }
}

/// Sines and cosines, and whether all of them are right: if no angle is large, or next to a multiple of pi/2.
#[inline(always)]
fn side_by_side<const N: usize>(angles: [f64; N]) -> ([f64; N], [f64; N], bool) {
    let (mut sines, mut cosines) = ([0.0; N], [0.0; N]);
    let mut all_plain = true;
    for i in 0..N {
        let reduced = reduce(angles[i]);
        all_plain &= reduced.is_plain;
        (sines[i], cosines[i]) = evaluate(angles[i], &reduced);
    }
    (sines, cosines, all_plain)
}

#[cold]
fn each_by_itself<const N: usize>(angles: [f64; N]) -> ([f64; N], [f64; N]) {
    let (mut sines, mut cosines) = ([0.0; N], [0.0; N]);
    for i in 0..N {
        let reduced = reduce(angles[i]);
        (sines[i], cosines[i]) = match () {
            _ if reduced.is_plain => evaluate(angles[i], &reduced),
            _ if angles[i].abs() <= LARGEST => evaluate(angles[i], &reduce_near_multiple(angles[i])),
            _ => libm::sincos(angles[i]),
        };
    }
    (sines, cosines)
}

/// |angle| = quadrants pi/2 + x + y, |x| at most about pi/4 and y a tail of x.
struct Reduced {
    x: f64,
    y: f64,
    /// The quadrants in the lowest bits.
    shifted: f64,
    /// Whether x keeps enough digits, and the angle is not too large.
    is_plain: bool,
}

/// Reduction with 86 bits of pi/2: enough unless the angle is so near a multiple that 16 bits cancel.
#[inline(always)]
fn reduce(signed: f64) -> Reduced {
    let angle = signed.abs();
    let shifted = angle * core::f64::consts::FRAC_2_PI + ROUNDER;
    let quadrants = shifted - ROUNDER;
    let first = angle - quadrants * PI_HALVES[0];
    let tail = quadrants * PI_HALF_TAIL;
    let x = first - tail;
    let y = (first - x) - tail;
    let is_plain = (angle <= LARGEST) & (x.abs() * 65_536.0 >= angle);
    Reduced { x, y, shifted, is_plain }
}

/// Reduction with 151 bits of pi/2, all remainders kept.
fn reduce_near_multiple(signed: f64) -> Reduced {
    let angle = signed.abs();
    let shifted = angle * core::f64::consts::FRAC_2_PI + ROUNDER;
    let quadrants = shifted - ROUNDER;
    let first = angle - quadrants * PI_HALVES[0];
    let (second, lost) = subtract(first, quadrants * PI_HALVES[1]);
    let (third, lost_too) = subtract(second, quadrants * PI_HALVES[2]);
    let tail = (lost + lost_too) - quadrants * PI_HALVES[3];
    let x = third + tail;
    Reduced { x, y: (third - x) + tail, shifted, is_plain: true }
}

/// Sine and cosine of an angle from its reduction.
#[inline(always)]
fn evaluate(angle: f64, reduced: &Reduced) -> (f64, f64) {
    let (sine, cosine) = (sine(reduced.x, reduced.y), cosine(reduced.x, reduced.y));
    // Odd quadrants swap the two; two bits of the quadrant give the signs; the sine is odd, also in the sign of 0.
    let quadrant = reduced.shifted.to_bits();
    let swap = (quadrant & 1).wrapping_neg();
    let (sine, cosine) = (sine.to_bits(), cosine.to_bits());
    let both = (sine ^ cosine) & swap;
    let sign = |quadrant: u64| (quadrant & 2) << 62;
    let sign_of_angle = angle.to_bits() & (1 << 63);
    (
        f64::from_bits(sine ^ both ^ sign(quadrant) ^ sign_of_angle),
        f64::from_bits(cosine ^ both ^ sign(quadrant.wrapping_add(1))),
    )
}

/// a - b and its rounding error (Knuth's two-sum).
#[inline(always)]
fn subtract(a: f64, b: f64) -> (f64, f64) {
    let difference = a - b;
    let b_part = a - difference;
    let a_part = difference + b_part;
    (difference, (a - a_part) + (b_part - b))
}

/// The sine of x + y for |x| <= pi/4, y a tail of x.
#[inline(always)]
fn sine(x: f64, y: f64) -> f64 {
    let z = x * x;
    let w = z * z;
    let r = SIN[1] + z * (SIN[2] + z * SIN[3]) + z * w * (SIN[4] + z * SIN[5]);
    let v = z * x;
    x - ((z * (0.5 * y - v * r) - y) - v * SIN[0])
}

/// The cosine of x + y for |x| <= pi/4, y a tail of x.
#[inline(always)]
fn cosine(x: f64, y: f64) -> f64 {
    let z = x * x;
    let w = z * z;
    let r = z * (COS[0] + z * (COS[1] + z * COS[2])) + w * w * (COS[3] + z * (COS[4] + z * COS[5]));
    let half = 0.5 * z;
    let w = 1.0 - half;
    w + (((1.0 - w) - half) + (z * r - x * y))
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::{LARGEST, sin_cos_each, sin_cos_of_block};
    use core::f64::consts::FRAC_PI_2;
    use num_bigint::BigInt;
    use std::vec::Vec;

    /// Fractional bits of the reference.
    const BITS: i64 = 400;

    /// A double as a fixed-point number, exact down to 2^-400.
    fn fixed(x: f64) -> BigInt {
        let (mantissa, exponent) = match (x.to_bits() >> 52) & 0x7ff {
            0 => (x.to_bits() & ((1 << 52) - 1), -1074),
            biased => (x.to_bits() & ((1 << 52) - 1) | 1 << 52, biased as i64 - 1075),
        };
        let size = BigInt::from(mantissa);
        let size = if BITS + exponent >= 0 { size << (BITS + exponent) } else { size >> -(BITS + exponent) };
        if x.is_sign_negative() { -size } else { size }
    }

    /// atan(1/n).
    fn arc_tangent_of_inverse(n: i64) -> BigInt {
        let mut term: BigInt = (BigInt::from(1) << BITS) / n;
        let (mut sum, mut k) = (BigInt::from(0), 1);
        while term != BigInt::from(0) {
            let part: BigInt = &term / k;
            sum += if k % 4 == 1 { part } else { -part };
            term /= n * n;
            k += 2;
        }
        sum
    }

    /// pi by Machin's formula.
    fn pi() -> BigInt {
        16 * arc_tangent_of_inverse(5) - 4 * arc_tangent_of_inverse(239)
    }

    /// Sine and cosine by their series.
    fn reference(x: &BigInt, pi: &BigInt) -> (BigInt, BigInt) {
        let x = x % (2 * pi);
        let (mut sine, mut cosine) = (BigInt::from(0), BigInt::from(0));
        let (mut term, mut k) = (BigInt::from(1) << BITS, 0);
        while term != BigInt::from(0) {
            match k % 4 {
                0 => cosine += &term,
                1 => sine += &term,
                2 => cosine -= &term,
                _ => sine -= &term,
            }
            k += 1;
            term = ((&term * &x) >> BITS) / k;
        }
        (sine, cosine)
    }

    /// |found - exact| in units of the last place of the exact value.
    fn ulps(found: f64, exact: &BigInt) -> f64 {
        let unit = exact.magnitude().bits() as i64 - 53;
        let difference = fixed(found) - exact;
        // Thousandths are enough to read.
        let scaled: BigInt = ((difference.magnitude().clone() * 1000u32) >> unit.max(0)).into();
        i64::try_from(scaled).unwrap() as f64 / 1000.0
    }

    fn angles() -> Vec<f64> {
        let mut random = 1u64;
        let mut unit = move || {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut angles = Vec::new();
        for _ in 0..4000 {
            angles.push(2.0 * unit() - 1.0);
            angles.push(20.0 * unit() - 10.0);
            angles.push(LARGEST * (2.0 * unit() - 1.0));
            angles.push(2f64.powf(-200.0 * unit()));
            // Beyond the reduction, where libm takes over; up to 2^150, which 400 bits of pi reduce accurately enough.
            angles.push(2f64.powf(20.0 + 130.0 * unit()));
            // Nearest doubles to multiples of pi/2, where almost all digits cancel.
            let multiple = (unit() * (LARGEST / FRAC_PI_2)).floor() * FRAC_PI_2;
            angles.extend([multiple, multiple.next_up(), -multiple.next_down()]);
        }
        angles
    }

    /// fdlibm's polynomials are within 0.8 ulp on a reduced argument that is exact to its last bit and more.
    #[test]
    fn within_one_unit_in_the_last_place() {
        let pi = pi();
        let mut worst = 0.0f64;
        for angle in angles() {
            let ([sine], [cosine]) = sin_cos_each([angle]);
            let (exact_sine, exact_cosine) = reference(&fixed(angle), &pi);
            let error = ulps(sine, &exact_sine).max(ulps(cosine, &exact_cosine));
            assert!(error < 1.0, "{angle:e}: {error} ulp");
            worst = worst.max(error);
        }
        std::println!("worst of {} angles: {worst} ulp", angles().len());
    }

    #[test]
    fn the_same_bits_alone_and_together() {
        for chunk in angles().chunks_exact(8) {
            let together: [f64; 8] = core::array::from_fn(|i| chunk[i]);
            let (sines, cosines) = sin_cos_each(together);
            let (mut of_block, mut cosines_of_block) = ([0.0; 8], [0.0; 8]);
            sin_cos_of_block(&together, &mut of_block, &mut cosines_of_block);
            let bits = |numbers: [f64; 8]| numbers.map(f64::to_bits);
            assert_eq!((bits(of_block), bits(cosines_of_block)), (bits(sines), bits(cosines)));
            let (large, _) = sin_cos_each([together[0], 1e300, together[1], f64::NAN]);
            for i in 0..8 {
                let ([sine], [cosine]) = sin_cos_each([together[i]]);
                assert_eq!((sine.to_bits(), cosine.to_bits()), (sines[i].to_bits(), cosines[i].to_bits()));
            }
            assert_eq!((large[0].to_bits(), large[2].to_bits()), (sines[0].to_bits(), sines[1].to_bits()));
        }
    }

    #[test]
    fn special_values_are_those_of_ieee() {
        let ([a, b, c, d, e], cosines) = sin_cos_each([0.0, -0.0, f64::INFINITY, f64::NAN, 5e-324]);
        assert!(a.to_bits() == 0 && b.to_bits() == (-0.0f64).to_bits() && c.is_nan() && d.is_nan() && e == 5e-324);
        assert!(cosines[..2] == [1.0, 1.0] && cosines[2].is_nan() && cosines[3].is_nan() && cosines[4] == 1.0);
        // Beyond the reduction libm takes over.
        assert_eq!(sin_cos_each([1e22]), ([libm::sin(1e22)], [libm::cos(1e22)]));
    }
}
