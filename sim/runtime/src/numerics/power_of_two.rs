//! Scales that change no digit.

use std::f64::consts::SQRT_2;

const BIAS: i64 = 1023;
const FRACTION_BITS: u32 = f64::MANTISSA_DIGITS - 1;

/// The power of 2 whose logarithm is nearest to that of a size, from 2^-1000 to 2^1000; 1 for a size that is not positive
/// or not finite.
///
/// It is read from the bits of the size: scaling is a good part of solving a small system, and logarithms were most of it.
pub(crate) fn power_of_two(size: f64) -> f64 {
    if !(size > 0.0 && size.is_finite()) {
        return 1.0;
    }
    let fraction = |x: f64| x.to_bits() << (u64::BITS - FRACTION_BITS);
    let is_nearer_to_next = fraction(size) > fraction(SQRT_2);
    let exponent = (size.to_bits() >> FRACTION_BITS) as i64 - BIAS + i64::from(is_nearer_to_next);
    f64::from_bits(((exponent.clamp(-1000, 1000) + BIAS) as u64) << FRACTION_BITS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_logarithm_is_nearest() {
        let sizes = (-3070..3070).map(|k| 10f64.powf(0.1 * k as f64)).chain([f64::MIN_POSITIVE, f64::MAX, 5e-324, 1.0]);
        for size in sizes {
            assert_eq!(power_of_two(size), size.log2().round().clamp(-1000.0, 1000.0).exp2(), "{size:e}");
        }
        assert_eq!([0.0, -1.0, f64::NAN, f64::INFINITY].map(power_of_two), [1.0; 4]);
    }
}
