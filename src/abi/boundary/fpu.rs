//! The host's floating-point control state: saved on entry, set to the default that Rust code may rely on, put back on
//! exit. Hosts unmask exceptions (Delphi before 12), set x87 to 24 bits (Direct3D 9), flush denormals (-ffast-math), leave x87
//! registers in use (MMX without EMMS). On x86-64 no code of the library uses x87.

#[cfg(not(target_family = "wasm"))]
use core::arch::asm;
#[cfg(target_arch = "x86")]
use core::mem::MaybeUninit;

#[cfg(target_family = "wasm")]
pub(in crate::abi) use super::wasm::FloatState;

/// The host's state. It is filled in place: on i686 it is too large to be moved in every call.
#[cfg(not(target_family = "wasm"))]
pub(in crate::abi) struct FloatState {
    #[cfg(any(target_arch = "x86_64", target_arch = "x86"))]
    mxcsr: u32,
    #[cfg(target_arch = "x86")]
    x87: [u16; 14],
    /// Environment and registers, if the host left registers in use.
    #[cfg(target_arch = "x86")]
    x87_registers: MaybeUninit<[u8; 108]>,
    #[cfg(target_arch = "aarch64")]
    fpcr: u64,
}

/// All exceptions masked, round to nearest, denormals kept, no exception noted.
#[cfg(any(target_arch = "x86_64", target_arch = "x86"))]
static DEFAULT_MXCSR: u32 = 0x1f80;

/// The control bits of MXCSR; the other bits are flags of exceptions.
#[cfg(target_arch = "x86_64")]
const MXCSR_CONTROL: u32 = 0xffc0;

#[cfg(target_arch = "x86_64")]
impl FloatState {
    #[inline(always)]
    fn read() -> u32 {
        let mut mxcsr = 0_u32;
        // SAFETY: stores MXCSR to the named four bytes.
        unsafe { asm!("stmxcsr [{0}]", in(reg) &raw mut mxcsr, options(nostack, preserves_flags)) }
        mxcsr
    }

    /// # Safety
    /// No floating-point code may run between this and the load that puts the host's state back, but code that relies on
    /// the default.
    #[inline(always)]
    unsafe fn load(mxcsr: &u32) {
        // SAFETY: the caller's promise.
        unsafe {
            asm!("ldmxcsr [{0}]", in(reg) core::ptr::from_ref(mxcsr), options(nostack, preserves_flags))
        }
    }

    pub const UNKNOWN: Self = Self { mxcsr: 0 };

    /// Saves the host's state and sets the default. A load of MXCSR costs 10 ns, so there is none if nothing would change.
    #[inline(always)]
    pub fn enter(&mut self) {
        self.mxcsr = Self::read();
        if self.mxcsr & MXCSR_CONTROL != DEFAULT_MXCSR {
            // SAFETY: no floating-point code has run yet.
            unsafe { Self::load(&DEFAULT_MXCSR) }
        }
    }

    /// Puts the host's state back, noted exceptions included.
    #[inline(always)]
    pub fn leave(&self) {
        if Self::read() != self.mxcsr {
            // SAFETY: what `enter` stored; no floating-point code of ours follows.
            unsafe { Self::load(&self.mxcsr) }
        }
    }
}

#[cfg(target_arch = "x86")]
impl FloatState {
    pub const UNKNOWN: Self = Self { mxcsr: 0, x87: [0; 14], x87_registers: MaybeUninit::uninit() };

    /// Whether the host left x87 registers in use, as MMX code without EMMS does: a full stack takes no number more.
    #[inline(always)]
    fn has_registers(&self) -> bool {
        const TAGS: usize = 4;
        const ALL_EMPTY: u16 = 0xffff;
        self.x87[TAGS] != ALL_EMPTY
    }

    /// Saves the host's state and sets the default.
    #[inline(always)]
    pub fn enter(&mut self) {
        static DEFAULT_X87: u16 = 0x037f;
        // SAFETY: the instructions touch the floating-point state and the named bytes alone; no floating-point code has run
        // yet. fnstenv masks all exceptions, so that none that is pending strikes in here.
        unsafe {
            asm!(
                "stmxcsr [{mxcsr}]", "ldmxcsr [{default_mxcsr}]", "fnstenv [{x87}]",
                mxcsr = in(reg) &raw mut self.mxcsr,
                default_mxcsr = in(reg) &raw const DEFAULT_MXCSR,
                x87 = in(reg) &raw mut self.x87,
                options(nostack, preserves_flags)
            );
            if self.has_registers() {
                // Empties them, and sets the default.
                asm!("fnsave [{0}]", in(reg) self.x87_registers.as_mut_ptr(), options(nostack, preserves_flags));
            } else {
                asm!("fnclex", "fldcw [{0}]", in(reg) &raw const DEFAULT_X87, options(nostack, preserves_flags));
            }
        }
    }

    /// Puts the host's state back, noted exceptions included.
    #[inline(always)]
    pub fn leave(&self) {
        // SAFETY: loads what `enter` stored; no floating-point code of ours follows. The registers' environment has all
        // exceptions masked: the host's own comes last.
        unsafe {
            if self.has_registers() {
                asm!("frstor [{0}]", in(reg) self.x87_registers.as_ptr(), options(nostack, preserves_flags));
            }
            asm!(
                "ldmxcsr [{mxcsr}]", "fldenv [{x87}]",
                mxcsr = in(reg) &raw const self.mxcsr,
                x87 = in(reg) &raw const self.x87,
                options(nostack, preserves_flags)
            );
        }
    }
}

#[cfg(target_arch = "aarch64")]
impl FloatState {
    pub const UNKNOWN: Self = Self { fpcr: 0 };

    /// Saves the host's state and sets the default.
    #[inline(always)]
    pub fn enter(&mut self) {
        let fpcr: u64;
        // SAFETY: reads and writes the control register alone; no floating-point code has run yet.
        unsafe {
            asm!("mrs {0}, fpcr", out(reg) fpcr, options(nostack, preserves_flags));
            if fpcr != 0 {
                asm!("msr fpcr, {0}", in(reg) 0_u64, options(nostack, preserves_flags));
            }
        }
        self.fpcr = fpcr;
    }

    /// Puts the host's state back.
    #[inline(always)]
    pub fn leave(&self) {
        if self.fpcr != 0 {
            // SAFETY: writes what `enter` read; no floating-point code of ours follows.
            unsafe { asm!("msr fpcr, {0}", in(reg) self.fpcr, options(nostack, preserves_flags)) }
        }
    }
}

#[cfg(not(any(
    target_arch = "x86_64",
    target_arch = "x86",
    target_arch = "aarch64",
    target_family = "wasm"
)))]
compile_error!("how this processor keeps its floating-point control state is not known here");
