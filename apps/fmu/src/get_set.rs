//! The functions of FMI that get and set values.
#![allow(non_snake_case, missing_docs, reason = "the names are the standard's, which has the documentation")]
#![allow(clippy::missing_safety_doc, reason = "the rules of pointers stand once, in `interface`")]

use std::ffi::{CString, c_char, c_int};

use crate::instance::Refused;
use crate::interface::{Component, elements, elements_mut, fmi2OK, fmi2Status, on, text};
use crate::values::{Base, Value};

/// Reads variables of one type.
///
/// # Safety
/// As [`on`]; both arrays have `count` elements.
unsafe fn get<T>(
    component: *mut Component,
    function: &str,
    base: Base,
    (references, count, values): (*const u32, usize, *mut T),
    convert: impl Fn(Value) -> Option<T>,
) -> fmi2Status {
    // SAFETY: as this function: the component is as the documentation of `interface` says; both arrays have `count` elements.
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
///
/// # Safety
/// As [`on`]; both arrays have `count` elements.
unsafe fn set<T: Copy>(
    component: *mut Component,
    function: &str,
    (references, count, values): (*const u32, usize, *const T),
    convert: impl Fn(T) -> Result<Value, Refused>,
) -> fmi2Status {
    // SAFETY: as this function: the component is as the documentation of `interface` says; both arrays have `count` elements.
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

macro_rules! getters {
    ($($name:ident: $base:ident as $type:ty;)*) => {$(
        #[unsafe(no_mangle)]
        pub unsafe extern "C-unwind" fn $name(
            component: *mut Component,
            references: *const u32,
            count: usize,
            values: *mut $type,
        ) -> fmi2Status {
            let own = |value| if let Value::$base(value) = value { Some(<$type>::from(value)) } else { None };
            // SAFETY: the promises of the master in `interface` are those of the function; a text is null or terminated.
            unsafe { get(component, stringify!($name), Base::$base, (references, count, values), own) }
        }
    )*};
}

getters! {
    fmi2GetReal: Real as f64;
    fmi2GetInteger: Integer as c_int;
    fmi2GetBoolean: Boolean as c_int;
}

macro_rules! setters {
    ($($name:ident: $type:ty, $value:expr;)*) => {$(
        #[unsafe(no_mangle)]
        pub unsafe extern "C-unwind" fn $name(
            component: *mut Component,
            references: *const u32,
            count: usize,
            values: *const $type,
        ) -> fmi2Status {
            // SAFETY: the promises of the master in `interface` are those of the function; a text is null or terminated.
            unsafe { set(component, stringify!($name), (references, count, values), $value) }
        }
    )*};
}

setters! {
    fmi2SetReal: f64, |value| Ok(Value::Real(value));
    fmi2SetInteger: c_int, |value| Ok(Value::Integer(value));
    fmi2SetBoolean: c_int, |value| Ok(Value::Boolean(value != 0));
    fmi2SetString: *const c_char, |value| Ok(Value::String(text(value)?.to_owned()));
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2GetString(
    component: *mut Component,
    references: *const u32,
    count: usize,
    values: *mut *const c_char,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of `interface` says; both arrays have `count` elements.
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
