//! The functions of FMI that get, set and serialize states.
#![allow(non_snake_case, missing_docs, reason = "the names are the standard's, which has the documentation")]
#![allow(clippy::missing_safety_doc, reason = "the rules of pointers stand once, in `interface`")]

use std::ptr;

use crate::instance::Refused;
use crate::interface::{Component, Outcome, elements, elements_mut, fmi2OK, fmi2Status, on};
use crate::saved;

/// A state that the master holds: its bytes.
pub type State = Vec<u8>;

/// Replaces an earlier state by `bytes`, or returns a new state.
///
/// # Safety
/// `state` is null or a state that was not freed.
unsafe fn hand_out(state: &mut *mut State, bytes: State) -> Outcome {
    // SAFETY: the caller's promise.
    match unsafe { state.as_mut() } {
        Some(earlier) => *earlier = bytes,
        None => *state = Box::into_raw(Box::new(bytes)),
    }
    Ok(fmi2OK)
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetFMUstate(
    component: *mut Component,
    state: *mut *mut State,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says; `state` is null or holds null or a state that was not freed.
    unsafe {
        on(component, "fmi2GetFMUstate", |component| {
            let state = state.as_mut().ok_or_else(|| Refused::error("a null pointer"))?;
            let bytes = saved::save(&component.instance).map_err(Refused::error)?;
            hand_out(state, bytes)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SetFMUstate(component: *mut Component, state: *mut State) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says; `state` is null or was not freed.
    unsafe {
        on(component, "fmi2SetFMUstate", |component| {
            let state = state.as_ref().ok_or_else(|| Refused::error("a null pointer for a state"))?;
            component.instance = saved::load(state, &component.instance).map_err(Refused::error)?;
            Ok(fmi2OK)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2FreeFMUstate(
    component: *mut Component,
    state: *mut *mut State,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says; the state is freed once, and its place becomes null.
    unsafe {
        on(component, "fmi2FreeFMUstate", |_| {
            if let Some(state) = state.as_mut().filter(|state| !state.is_null()) {
                drop(Box::from_raw(*state));
                *state = ptr::null_mut();
            }
            Ok(fmi2OK)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SerializedFMUstateSize(
    component: *mut Component,
    state: *mut State,
    size: *mut usize,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says; `state` is null or was not freed, `size` is null or writable.
    unsafe {
        on(component, "fmi2SerializedFMUstateSize", |_| match (state.as_ref(), size.as_mut()) {
            (Some(state), Some(size)) => {
                *size = state.len();
                Ok(fmi2OK)
            }
            _ => Err(Refused::error("a null pointer")),
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SerializeFMUstate(
    component: *mut Component,
    state: *mut State,
    bytes: *mut u8,
    size: usize,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says; `state` is null or was not freed, `bytes` has room for `size`.
    unsafe {
        on(component, "fmi2SerializeFMUstate", |_| {
            let state = state.as_ref().ok_or_else(|| Refused::error("a null pointer for a state"))?;
            let needed = state.len();
            if size < needed {
                return Err(Refused::error(format!("size = {size}: must be at least {needed}")));
            }
            elements_mut(bytes, needed)?.copy_from_slice(state);
            Ok(fmi2OK)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2DeSerializeFMUstate(
    component: *mut Component,
    bytes: *const u8,
    size: usize,
    state: *mut *mut State,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says; there are `size` bytes; `state` is as in `fmi2GetFMUstate`.
    unsafe {
        on(component, "fmi2DeSerializeFMUstate", |component| {
            let state = state.as_mut().ok_or_else(|| Refused::error("a null pointer"))?;
            let bytes = elements(bytes, size)?;
            saved::load(bytes, &component.instance).map_err(Refused::error)?;
            hand_out(state, bytes.to_vec())
        })
    }
}
