//! The instruction sets of a processor. One is chosen when an ensemble is made and at each read of a simulator.
//!
//! A loop over many runs, and the long formulas of a read, are compiled once for each set. [`InstructionSet::run`] calls the work
//! in a function that may use the instructions of the set. All code that is inlined into that function may use them, too. No set
//! fuses or reorders operations: the bits are the same.

/// Vector instructions of this processor that a piece of work may use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct InstructionSet(Kind);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// The instructions of the build: two numbers at a time with SSE2 and NEON.
    Baseline,
    /// Four numbers at a time.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// Eight numbers at a time.
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

/// Work that is compiled for each set. `run` and the functions that it calls have to be inlined.
pub(crate) trait Work {
    /// Whether the work is faster with eight numbers at a time.
    #[cfg_attr(not(target_arch = "x86_64"), expect(dead_code, reason = "one instruction set"))]
    const IN_EIGHTS: bool = false;

    fn run(self);
}

impl InstructionSet {
    /// The widest set of this processor for up to `width` numbers at a time.
    pub fn up_to(width: usize) -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            use std::arch::is_x86_feature_detected as has;
            if width >= 8 && has!("avx2") && has!("avx512f") && has!("avx512dq") && has!("avx512vl") {
                return Self(Kind::Avx512);
            }
            if width >= 4 && has!("avx2") {
                return Self(Kind::Avx2);
            }
        }
        let _ = width;
        Self(Kind::Baseline)
    }

    /// Largest number of runs that are flown faster one by one than in a batch, most of whose lanes would be empty. Evidence: with the
    /// errors of simulation 2 a run alone adds 4200 instructions to a step, a batch 36 700 with two numbers at a time and 16 600 with four.
    pub fn few_runs(self) -> usize {
        match self.0 {
            Kind::Baseline => 8,
            #[cfg(target_arch = "x86_64")]
            Kind::Avx2 | Kind::Avx512 => 3,
        }
    }

    /// Does the work with the instructions of this set.
    #[inline]
    pub fn run<W: Work>(self, work: W) {
        match self.0 {
            Kind::Baseline => baseline(work),
            // SAFETY: only `up_to` makes this set, and only where the processor has these instructions.
            #[cfg(target_arch = "x86_64")]
            Kind::Avx512 if W::IN_EIGHTS => unsafe { avx512(work) },
            // SAFETY: as above; for AVX-512 `up_to` requires AVX2 as well.
            #[cfg(target_arch = "x86_64")]
            Kind::Avx2 | Kind::Avx512 => unsafe { avx2(work) },
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
