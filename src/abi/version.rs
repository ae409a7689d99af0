//! Versions and the names of the status codes.

use core::ffi::{CStr, c_char};

use super::failure::*;

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
pub extern "C" fn sins_abi_version() -> u32 {
    SINS_HEADER_ABI
}

/// Returns the release of the loaded library as text, such as "0.1.0". The text lives as long as the library is loaded.
#[unsafe(no_mangle)]
pub extern "C" fn sins_version_string() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

/// Returns the name of a status code, such as "SINS_OK", or "unknown status" for any other number. The text lives as long
/// as the library is loaded.
#[unsafe(no_mangle)]
pub extern "C" fn sins_status_string(status: sins_status) -> *const c_char {
    name(status).as_ptr()
}

fn name(status: sins_status) -> &'static CStr {
    match status {
        SINS_OK => c"SINS_OK",
        SINS_NEED_SAMPLE => c"SINS_NEED_SAMPLE",
        SINS_REQUIREMENT_NOT_MET => c"SINS_REQUIREMENT_NOT_MET",
        SINS_SCENE_HAS_FAULTS => c"SINS_SCENE_HAS_FAULTS",
        SINS_GAP => c"SINS_GAP",
        SINS_ERROR_NULL_POINTER => c"SINS_ERROR_NULL_POINTER",
        SINS_ERROR_BAD_HANDLE => c"SINS_ERROR_BAD_HANDLE",
        SINS_ERROR_STRUCT_SIZE => c"SINS_ERROR_STRUCT_SIZE",
        SINS_ERROR_INVALID_ARGUMENT => c"SINS_ERROR_INVALID_ARGUMENT",
        SINS_ERROR_BAD_STATE => c"SINS_ERROR_BAD_STATE",
        SINS_ERROR_TIME_ORDER => c"SINS_ERROR_TIME_ORDER",
        SINS_ERROR_DISCONTINUITY => c"SINS_ERROR_DISCONTINUITY",
        SINS_ERROR_QUEUE_FULL => c"SINS_ERROR_QUEUE_FULL",
        SINS_ERROR_DIVERGED => c"SINS_ERROR_DIVERGED",
        SINS_ERROR_SINGULAR => c"SINS_ERROR_SINGULAR",
        SINS_ERROR_BUFFER_TOO_SMALL => c"SINS_ERROR_BUFFER_TOO_SMALL",
        SINS_ERROR_OUT_OF_MEMORY => c"SINS_ERROR_OUT_OF_MEMORY",
        SINS_ERROR_SNAPSHOT => c"SINS_ERROR_SNAPSHOT",
        SINS_ERROR_INTERNAL => c"SINS_ERROR_INTERNAL",
        _ => c"unknown status",
    }
}
