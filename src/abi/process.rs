//! What the process must give before the first handle is made: on Unix, notice of a fork; on Windows, what is thread-local in
//! Rust.

use core::sync::atomic::{AtomicBool, Ordering};

/// Whether the process has given all of it, which is asked for again until it has.
#[inline]
pub(super) fn is_prepared() -> bool {
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
    use crate::abi::tables::lose_what_others_use;

    extern "C" fn in_child() {
        lose_what_others_use();
    }

    type Handler = Option<extern "C" fn()>;

    #[cfg(not(target_env = "gnu"))]
    pub fn prepare() -> bool {
        unsafe extern "C" {
            safe fn pthread_atfork(prepare: Handler, parent: Handler, child: Handler) -> i32;
        }
        pthread_atfork(None, None, Some(in_child)) == 0
    }

    #[cfg(target_env = "gnu")]
    pub use glibc::prepare;

    /// The handler goes with the library when that is unloaded. What pthread_atfork() does for this is code of glibc and gcc that
    /// other linkers leave out. Evidence: linked by Zig, a library that was unloaded ended the next child.
    #[cfg(target_env = "gnu")]
    mod glibc {
        use core::ffi::c_void;
        use core::ptr::from_ref;

        use super::{Handler, in_child};

        unsafe extern "C" {
            safe fn __register_atfork(
                prepare: Handler,
                parent: Handler,
                child: Handler,
                module: *const c_void,
            ) -> i32;
            safe fn __cxa_finalize(module: *const c_void);
        }

        /// Run when this module is unloaded. Its address stands for the module.
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

/// On windows-gnu each thread-local variable of Rust, those of its standard library among them, is a TLS index, taken at the
/// first use and never freed; where none is left, the process is aborted. One is used even when a thread ends or the library
/// is unloaded. So they are taken when the library is loaded, and it stays loaded from then on.
#[cfg(all(windows, target_env = "gnu"))]
mod system {
    use core::ffi::c_void;
    use core::ptr::from_ref;

    use crate::abi::thread_locals::touch_thread_locals;
    use crate::memory::room;

    /// Of Rust 1.95: one of the library's own, the current thread, its number in one or two, and the count of panics, which the
    /// first panic takes. The rest is for a later Rust.
    const INDEXES: usize = 8;
    const OUT_OF_INDEXES: u32 = u32::MAX;
    /// What the standard library allocates for them, generously.
    const MEMORY: usize = 4096;
    const PIN: u32 = 1;
    const FROM_ADDRESS: u32 = 4;

    #[link(name = "kernel32")]
    unsafe extern "system" {
        safe fn TlsAlloc() -> u32;
        safe fn TlsFree(index: u32) -> i32;
        fn GetModuleHandleExW(flags: u32, address: *const c_void, module: *mut *mut c_void) -> i32;
    }

    /// Run by the C library when this module is loaded.
    #[used]
    #[unsafe(link_section = ".CRT$XCU")]
    static AT_LOAD: extern "C" fn() = at_load;

    extern "C" fn at_load() {
        super::is_prepared();
    }

    pub fn prepare() -> bool {
        let mut module = core::ptr::null_mut();
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
        let indexes = [(); INDEXES].map(|()| TlsAlloc());
        for index in indexes.into_iter().filter(|&index| index != OUT_OF_INDEXES) {
            TlsFree(index);
        }
        !indexes.contains(&OUT_OF_INDEXES)
    }
}

/// Elsewhere what is thread-local in Rust comes and goes with the library.
#[cfg(all(windows, not(target_env = "gnu")))]
mod system {
    pub fn prepare() -> bool {
        true
    }
}
