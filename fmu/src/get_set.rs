//! The functions of FMI that get and set values.
#![allow(non_snake_case, missing_docs, reason = "the names are the standard's, which has the documentation")]
#![allow(clippy::missing_safety_doc, reason = "the rules of pointers stand once, in `interface`")]

use std::ffi::{CString, c_char, c_int};

use crate::instance::Refused;
use crate::interface::{Component, elements, elements_mut, fmi2OK, fmi2Status, on, text};
use crate::values::{Base, Value};

/// Reads variables of one type.
unsafe fn get<T>(
    component: *mut Component,
    function: &str,
    base: Base,
    (references, count, values): (*const u32, usize, *mut T),
    convert: impl Fn(Value) -> Option<T>,
) -> fmi2Status {
    unsafe {
        on(component, function, |component| {
            let references = elements(references, count)?;
            let values = elements_mut(values, count)?;
            let read = references.iter().map(|&reference| component.instance.get(base, reference as usize));
            let read = read.collect::<Result<Vec<_>, _>>()?;
            values.iter_mut().zip(read.into_iter().filter_map(convert)).for_each(|(to, value)| *to = value);
            Ok(fmi2OK)
        })
    }
}

/// Sets variables of one type.
unsafe fn set<T: Copy>(
    component: *mut Component,
    function: &str,
    (references, count, values): (*const u32, usize, *const T),
    convert: impl Fn(T) -> Result<Value, Refused>,
) -> fmi2Status {
    unsafe {
        on(component, function, |component| {
            let references = elements(references, count)?;
            let values = elements(values, count)?;
            let values = values.iter().map(|&value| convert(value)).collect::<Result<Vec<_>, _>>()?;
            let pairs = references.iter().map(|&reference| reference as usize).zip(values);
            component.instance.set(pairs).map(|()| fmi2OK)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetReal(
    component: *mut Component,
    references: *const u32,
    count: usize,
    values: *mut f64,
) -> fmi2Status {
    let real = |value| if let Value::Real(value) = value { Some(value) } else { None };
    unsafe { get(component, "fmi2GetReal", Base::Real, (references, count, values), real) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetInteger(
    component: *mut Component,
    references: *const u32,
    count: usize,
    values: *mut c_int,
) -> fmi2Status {
    let integer = |value| if let Value::Integer(value) = value { Some(value) } else { None };
    unsafe { get(component, "fmi2GetInteger", Base::Integer, (references, count, values), integer) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBoolean(
    component: *mut Component,
    references: *const u32,
    count: usize,
    values: *mut c_int,
) -> fmi2Status {
    let boolean = |value| if let Value::Boolean(value) = value { Some(c_int::from(value)) } else { None };
    unsafe { get(component, "fmi2GetBoolean", Base::Boolean, (references, count, values), boolean) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetString(
    component: *mut Component,
    references: *const u32,
    count: usize,
    values: *mut *const c_char,
) -> fmi2Status {
    unsafe {
        on(component, "fmi2GetString", |component| {
            let references = elements(references, count)?;
            let values = elements_mut(values, count)?;
            let mut texts = Vec::with_capacity(count);
            for &reference in references {
                let Value::String(text) = component.instance.get(Base::String, reference as usize)? else {
                    continue;
                };
                texts.push(CString::new(text).unwrap_or_default());
            }
            texts.iter().zip(values).for_each(|(text, to)| *to = text.as_ptr());
            component.texts = texts;
            Ok(fmi2OK)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetReal(
    component: *mut Component,
    references: *const u32,
    count: usize,
    values: *const f64,
) -> fmi2Status {
    unsafe { set(component, "fmi2SetReal", (references, count, values), |value| Ok(Value::Real(value))) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetInteger(
    component: *mut Component,
    references: *const u32,
    count: usize,
    values: *const c_int,
) -> fmi2Status {
    unsafe {
        set(component, "fmi2SetInteger", (references, count, values), |value| Ok(Value::Integer(value)))
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetBoolean(
    component: *mut Component,
    references: *const u32,
    count: usize,
    values: *const c_int,
) -> fmi2Status {
    let boolean = |value| Ok(Value::Boolean(value != 0));
    unsafe { set(component, "fmi2SetBoolean", (references, count, values), boolean) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetString(
    component: *mut Component,
    references: *const u32,
    count: usize,
    values: *const *const c_char,
) -> fmi2Status {
    let string = |value| Ok(Value::String(unsafe { text(value) }?.to_owned()));
    unsafe { set(component, "fmi2SetString", (references, count, values), string) }
}
