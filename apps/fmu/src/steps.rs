//! The function of FMI that flies a step, the functions that query its status, and the functions that this unit does not support.
#![allow(non_snake_case, missing_docs, reason = "the names are the standard's, which has the documentation")]
#![allow(clippy::missing_safety_doc, reason = "the rules of pointers stand once, in `interface`")]

use std::ffi::{c_char, c_int};

use crate::instance::{Flown, Refused};
use crate::interface::{Component, fmi2OK, fmi2Status, fmi2Warning, on};
use crate::logger::Category;

/// Kinds of `fmi2Get...Status`.
const LAST_SUCCESSFUL_TIME: c_int = 2;
const TERMINATED: c_int = 3;

/// Turn of the truth in one step that gives a warning [rad].
const LARGE_TURN_RAD: f64 = 0.1;

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2DoStep(
    component: *mut Component,
    current_communication_point: f64,
    communication_step_size: f64,
    _no_set_state_prior_to_current_point: c_int,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says.
    unsafe {
        on(component, "fmi2DoStep", |component| {
            let time_s = current_communication_point;
            let Flown { behind_gap, turn_rad, refused_entries, unconnected, sample } =
                component.instance.step(time_s, communication_step_size)?;
            if behind_gap {
                let text = format!("the sample at {time_s} s closes a gap in the truth");
                component.logger.say(Category::Warning, fmi2Warning, &text);
            }
            for text in refused_entries {
                component.logger.say(Category::Warning, fmi2Warning, &text);
            }
            if let (Some(sample), Some(flight)) = (&sample, &component.instance.flight) {
                for text in component.watch.push(flight.play.itinerary().scene(), sample) {
                    component.logger.say(Category::Warning, fmi2Warning, &text);
                }
            }
            if !unconnected.is_empty() && !component.has_said_unconnected {
                component.has_said_unconnected = true;
                for text in unconnected {
                    component.logger.say(Category::Warning, fmi2Warning, text);
                }
            }
            if turn_rad > LARGE_TURN_RAD && !component.has_said_turn {
                component.has_said_turn = true;
                let text = format!(
                    "the truth turned by {turn_rad:.2} rad in the step that ends at {time_s} s: above {LARGE_TURN_RAD} rad the \
                     sampled truth does not define the motion; connect an angle that is unwrapped before it is interpolated, or set a smaller step size (output_interval in FMPy)"
                );
                component.logger.say(Category::Warning, fmi2Warning, &text);
            }
            Ok(fmi2OK)
        })
    }
}

/// Refuses a call that this unit does not support.
///
/// # Safety
/// As [`on`].
unsafe fn without(component: *mut Component, function: &str, why: &str) -> fmi2Status {
    // SAFETY: as this function.
    unsafe { on(component, function, |_| Err(Refused::error(why))) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2CancelStep(component: *mut Component) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says.
    unsafe { without(component, "fmi2CancelStep", "steps are never asynchronous") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SetRealInputDerivatives(
    component: *mut Component,
    _references: *const u32,
    _count: usize,
    _orders: *const c_int,
    _values: *const f64,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says.
    unsafe { without(component, "fmi2SetRealInputDerivatives", "inputs are not interpolated") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetRealOutputDerivatives(
    component: *mut Component,
    _references: *const u32,
    _count: usize,
    _orders: *const c_int,
    _values: *mut f64,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says.
    unsafe { without(component, "fmi2GetRealOutputDerivatives", "outputs have no derivatives") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetDirectionalDerivative(
    component: *mut Component,
    _unknowns: *const u32,
    _unknown_count: usize,
    _knowns: *const u32,
    _known_count: usize,
    _seed: *const f64,
    _values: *mut f64,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says.
    unsafe { without(component, "fmi2GetDirectionalDerivative", "there are no directional derivatives") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetRealStatus(
    component: *mut Component,
    kind: c_int,
    value: *mut f64,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says; `value` is null or writable.
    unsafe {
        on(component, "fmi2GetRealStatus", |component| match (kind, value.as_mut()) {
            (LAST_SUCCESSFUL_TIME, Some(value)) => {
                *value = component.instance.end_s;
                Ok(fmi2OK)
            }
            _ => Err(Refused::discard(format!("there is no real status of kind {kind}"))),
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetBooleanStatus(
    component: *mut Component,
    kind: c_int,
    value: *mut c_int,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says; `value` is null or writable.
    unsafe {
        on(component, "fmi2GetBooleanStatus", |_| match (kind, value.as_mut()) {
            (TERMINATED, Some(value)) => {
                *value = 0;
                Ok(fmi2OK)
            }
            _ => Err(Refused::discard(format!("there is no boolean status of kind {kind}"))),
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetStatus(
    component: *mut Component,
    _kind: c_int,
    _value: *mut c_int,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says.
    unsafe { without(component, "fmi2GetStatus", "steps are never asynchronous") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetIntegerStatus(
    component: *mut Component,
    _kind: c_int,
    _value: *mut c_int,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says.
    unsafe { without(component, "fmi2GetIntegerStatus", "there is no integer status") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetStringStatus(
    component: *mut Component,
    _kind: c_int,
    _value: *mut *const c_char,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says.
    unsafe { without(component, "fmi2GetStringStatus", "steps are never asynchronous") }
}
