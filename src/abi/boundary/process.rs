//! Preparation of the process before the first handle is made: on Unix a handler of forks, on Windows the storage of Rust's
//! thread-local variables.

use core::sync::atomic::{AtomicBool, Ordering};

#[cfg(target_family = "wasm")]
use super::wasm as system;

/// Whether the process is prepared. If it is not, it is prepared now; if that fails, the next call tries again.
#[inline]
pub(in crate::abi) fn prepare_process() -> bool {
    static PREPARED: AtomicBool = AtomicBool::new(false);
    // Two threads may prepare at once: once more does no harm.
    PREPARED.load(Ordering::Acquire)
        || system::prepare() && {
            PREPARED.store(true, Ordering::Release);
            true
        }
}

#[cfg(unix)]
mod system {
    use crate::abi::boundary::tables::lose_what_others_use;

    extern "C" fn in_child() {
        lose_what_others_use();
    }

    #[cfg(not(target_env = "gnu"))]
    pub fn prepare() -> bool {
        // SAFETY: the handler lives as long as this library, which systems without glibc do not unload.
        unsafe { libc::pthread_atfork(None, None, Some(in_child)) == 0 }
    }

    #[cfg(target_env = "gnu")]
    pub use glibc::prepare;

    /// Registers the handler so that it is removed when the library is unloaded. pthread_atfork() needs code of glibc and gcc for this,
    /// which other linkers leave out. Evidence: after a library that was linked by Zig was unloaded, the next child process crashed.
    #[cfg(target_env = "gnu")]
    mod glibc {
        use core::ffi::c_void;
        use core::ptr::from_ref;

        use super::in_child;

        type Handler = Option<extern "C" fn()>;

        // glibc has these functions for compilers; the crate libc does not declare them.
        unsafe extern "C" {
            safe fn __register_atfork(
                prepare: Handler,
                parent: Handler,
                child: Handler,
                module: *const c_void,
            ) -> i32;
            safe fn __cxa_finalize(module: *const c_void);
        }

        /// Runs when this module is unloaded. The address of this variable identifies the module.
        #[used]
        #[unsafe(link_section = ".fini_array")]
        static AT_UNLOAD: extern "C" fn() = at_unload;

        fn module() -> *const c_void {
            from_ref(&AT_UNLOAD).cast()
        }

        extern "C" fn at_unload() {
            __cxa_finalize(module());
        }

        pub fn prepare() -> bool {
            __register_atfork(None, None, Some(in_child), module()) == 0
        }
    }
}

/// On windows-gnu each thread-local variable of Rust and of its standard library takes a TLS index at its first use, and never frees
/// it. If no index is left, the process is aborted. One variable is used even when a thread ends or the library is unloaded. So the
/// library takes its indexes when it is loaded, and stays loaded from then on.
#[cfg(all(windows, target_env = "gnu"))]
mod system {
    use core::ptr::{from_ref, null_mut};

    use windows_sys::Win32::System::LibraryLoader::{
        GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS as FROM_ADDRESS, GET_MODULE_HANDLE_EX_FLAG_PIN as PIN,
        GetModuleHandleExW,
    };
    use windows_sys::Win32::System::Threading::{TLS_OUT_OF_INDEXES, TlsAlloc, TlsFree};

    use crate::abi::boundary::thread_locals::touch_thread_locals;
    use crate::base::memory::room;

    /// Rust 1.95 needs one for the library's own variable, one for the current thread, one or two for its number, and one for the count
    /// of panics, which the first panic takes. The rest is for a later Rust.
    const INDEXES: usize = 8;
    /// Upper bound of the memory that the standard library allocates for them.
    const MEMORY: usize = 4096;

    /// Run by the C library when this module is loaded.
    #[used]
    #[unsafe(link_section = ".CRT$XCU")]
    static AT_LOAD: extern "C" fn() = at_load;

    extern "C" fn at_load() {
        super::prepare_process();
    }

    pub fn prepare() -> bool {
        let mut module = null_mut();
        // SAFETY: an address within this module, and a place for the answer.
        let pinned = unsafe {
            GetModuleHandleExW(PIN | FROM_ADDRESS, from_ref(&AT_LOAD).cast(), &raw mut module) != 0
        };
        if !pinned || room::<u8>(MEMORY).is_err() || !indexes_are_left() {
            return false;
        }
        drop(std::thread::current());
        touch_thread_locals();
        true
    }

    fn indexes_are_left() -> bool {
        // SAFETY: each index that is taken is freed once.
        unsafe {
            let indexes = [(); INDEXES].map(|()| TlsAlloc());
            for index in indexes.into_iter().filter(|&index| index != TLS_OUT_OF_INDEXES) {
                TlsFree(index);
            }
            !indexes.contains(&TLS_OUT_OF_INDEXES)
        }
    }
}

/// On other systems Rust's thread-local variables come and go with the library.
#[cfg(all(windows, not(target_env = "gnu")))]
mod system {
    pub fn prepare() -> bool {
        true
    }
}
