//! Square roots by the processor's own instruction.
//!
//! libm's are inline assembly in SSE's old encoding. Within code for AVX each of them costs a hundred cycles, and several cannot
//! share an instruction.

/// The square root.
#[inline(always)]
pub(crate) fn sqrt(x: f64) -> f64 {
    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
    {
        use core::arch::x86_64::{_mm_cvtsd_f64, _mm_set_sd, _mm_sqrt_sd};
        // Safety: the target has these instructions.
        #[allow(unsafe_code)]
        unsafe {
            let x = _mm_set_sd(x);
            _mm_cvtsd_f64(_mm_sqrt_sd(x, x))
        }
    }
    #[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
    libm::sqrt(x)
}

/// The square root.
#[inline(always)]
pub(crate) fn sqrtf(x: f32) -> f32 {
    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
    {
        use core::arch::x86_64::{_mm_cvtss_f32, _mm_set_ss, _mm_sqrt_ss};
        // Safety: the target has these instructions.
        #[allow(unsafe_code)]
        unsafe {
            _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x)))
        }
    }
    #[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
    libm::sqrtf(x)
}

#[cfg(test)]
mod tests {
    /// Roots are rounded correctly everywhere (IEEE 754), so the bits are those of libm.
    #[test]
    fn the_bits_of_libm() {
        let mut random = 1u64;
        for _ in 0..100_000 {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let (x, short) = (f64::from_bits(random & (u64::MAX >> 1)), f32::from_bits(random as u32 >> 1));
            if !x.is_nan() {
                assert_eq!(super::sqrt(x).to_bits(), libm::sqrt(x).to_bits(), "{x:e}");
            }
            if !short.is_nan() {
                assert_eq!(super::sqrtf(short).to_bits(), libm::sqrtf(short).to_bits(), "{short:e}");
            }
        }
        for x in [0.0, f64::INFINITY, 5e-324] {
            assert_eq!(super::sqrt(x), libm::sqrt(x));
        }
        assert!(super::sqrt(-0.0).is_sign_negative() && super::sqrt(-1.0).is_nan() && super::sqrt(f64::NAN).is_nan());
    }
}
