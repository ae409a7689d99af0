//! Versions of the interface and of the library.

use core::ffi::c_char;

/// Version of the interface that this header declares: a host compares it with what sins_abi_version() gives. The number
/// changes if a part of the interface is removed or changes its meaning. Additions at the end do not change it.
pub const SINS_HEADER_ABI: u32 = 1;
/// Major number of this release of the library, by semantic versioning.
pub const SINS_VERSION_MAJOR: u32 = 0;
/// Minor number of this release.
pub const SINS_VERSION_MINOR: u32 = 1;
/// Patch number of this release.
pub const SINS_VERSION_PATCH: u32 = 0;

/// Returns the version of the interface of the loaded library: compare it with SINS_HEADER_ABI.
#[unsafe(no_mangle)]
pub extern "C-unwind" fn sins_abi_version() -> u32 {
    SINS_HEADER_ABI
}

/// Returns the release of the loaded library as text, such as "0.1.0". The text lives as long as the library is loaded.
#[unsafe(no_mangle)]
pub extern "C-unwind" fn sins_version_string() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}
