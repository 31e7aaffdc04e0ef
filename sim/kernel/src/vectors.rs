//! Vector instructions: code compiled for each width that a processor may have, chosen at run time.

use core::fmt;

#[cfg(target_arch = "x86_64")]
cpufeatures::new!(has_avx2, "avx2");
#[cfg(target_arch = "x86_64")]
cpufeatures::new!(has_avx512, "avx512f", "avx512dq");

/// Work that is compiled for every width of vector instructions, with the functions that are inlined into it.
pub trait Work {
    /// Its result.
    type Output;
    /// Does it, with vectors of so many numbers of double precision. Implementations are `#[inline(always)]`.
    fn run<const AT_ONCE: usize>(self) -> Self::Output;
}

/// Vector instructions that this processor has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vectors(Width);

impl fmt::Display for Vectors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.0 {
            Width::Baseline => "the target's vectors",
            #[cfg(target_arch = "x86_64")]
            Width::Avx2 => "AVX2",
            #[cfg(target_arch = "x86_64")]
            Width::Avx512 => "AVX-512",
        })
    }
}

/// Only [`Vectors`] that the processor has are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Width {
    Baseline,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Vectors {
    /// The instructions that every processor of this build's target has.
    pub const BASELINE: Vectors = Vectors(Width::Baseline);

    /// The widest.
    #[inline]
    pub fn widest() -> Vectors {
        Vectors::avx512().or_else(Vectors::avx2).unwrap_or(Vectors::BASELINE)
    }

    /// AVX2: 4 numbers of double precision at once.
    #[inline]
    pub fn avx2() -> Option<Vectors> {
        #[cfg(target_arch = "x86_64")]
        if has_avx2::get() {
            return Some(Vectors(Width::Avx2));
        }
        None
    }

    /// AVX-512: 8 numbers of double precision at once.
    #[inline]
    pub fn avx512() -> Option<Vectors> {
        #[cfg(target_arch = "x86_64")]
        if has_avx512::get() {
            return Some(Vectors(Width::Avx512));
        }
        None
    }

    /// Runs the work with these instructions.
    ///
    /// The same bits with all of them: operations are never fused, however many are done at once.
    #[inline]
    pub fn run<W: Work>(self, work: W) -> W::Output {
        match self.0 {
            Width::Baseline => work.run::<4>(),
            // Safety: these widths are made only where the processor was found to have the instructions.
            #[cfg(target_arch = "x86_64")]
            #[allow(unsafe_code)]
            Width::Avx2 => unsafe { with_avx2(work) },
            #[cfg(target_arch = "x86_64")]
            #[allow(unsafe_code)]
            Width::Avx512 => unsafe { with_avx512(work) },
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn with_avx2<W: Work>(work: W) -> W::Output {
    work.run::<4>()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq")]
fn with_avx512<W: Work>(work: W) -> W::Output {
    work.run::<8>()
}

/// Work on single numbers, which long kernels are: AVX2, where the processor has it, saves copies between registers. It is compiled
/// apart from where it is done, twice, and once in a build that is not for speed.
#[inline]
pub(crate) fn apart<W: Work>(work: W) -> W::Output {
    // Called by itself: by `Vectors::run` a third copy would be compiled, to be thrown away.
    #[cfg(all(target_arch = "x86_64", not(debug_assertions)))]
    if has_avx2::get() {
        // Safety: the processor was found to have the instructions.
        #[allow(unsafe_code)]
        return unsafe { with_avx2(work) };
    }
    with_baseline(work)
}

#[inline(never)]
fn with_baseline<W: Work>(work: W) -> W::Output {
    work.run::<1>()
}
