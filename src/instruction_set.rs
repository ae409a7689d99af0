//! The instruction sets of a processor, chosen when an ensemble is made.
//!
//! A loop over many runs is compiled once for each set: [`InstructionSet::run`] calls the work in a function that may use its
//! instructions, and all that is inlined into that function may, too. No set fuses or reorders operations: the bits are the same.

/// Vector instructions that a loop may use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum InstructionSet {
    /// Those of the build: two numbers at a time with SSE2 and NEON.
    Baseline,
    /// Four numbers at a time.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// Eight numbers at a time.
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

/// Work that is compiled for each set. `run` and what it calls in its loops have to be inlined.
pub(crate) trait Work {
    fn run(self);
}

impl InstructionSet {
    /// All that this processor has, the widest last.
    pub fn of_processor() -> impl Iterator<Item = Self> {
        let sets = [
            Some(Self::Baseline),
            #[cfg(target_arch = "x86_64")]
            std::arch::is_x86_feature_detected!("avx2").then_some(Self::Avx2),
            #[cfg(target_arch = "x86_64")]
            (std::arch::is_x86_feature_detected!("avx512f")
                && std::arch::is_x86_feature_detected!("avx512dq")
                && std::arch::is_x86_feature_detected!("avx512vl"))
            .then_some(Self::Avx512),
        ];
        sets.into_iter().flatten()
    }

    /// The widest that this processor has.
    pub fn widest() -> Self {
        Self::of_processor().last().unwrap_or(Self::Baseline)
    }

    /// Does the work with the instructions of this set, which is of [`Self::of_processor`].
    #[inline]
    pub fn run(self, work: impl Work) {
        match self {
            Self::Baseline => baseline(work),
            // SAFETY: a value of these is made by `of_processor` alone, where the processor has the instructions.
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => unsafe { avx2(work) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => unsafe { avx512(work) },
        }
    }
}

#[inline(never)]
fn baseline(work: impl Work) {
    work.run();
}

#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx2")]
fn avx2(work: impl Work) {
    work.run();
}

#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx512f,avx512dq,avx512vl")]
fn avx512(work: impl Work) {
    work.run();
}
