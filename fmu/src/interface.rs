//! The functions of FMI 2.0 for co-simulation, as a master loads them.
//!
//! # Safety
//!
//! Of every function here: pointers are what the standard says; a component is one that [`fmi2Instantiate`] gave and
//! [`fmi2FreeInstance`] has not taken back, and one thread at a time uses it.
#![allow(
    non_snake_case,
    non_camel_case_types,
    non_upper_case_globals,
    reason = "the names are the standard's"
)]
#![allow(clippy::missing_safety_doc, reason = "the rules of pointers stand once, above")]
#![allow(missing_docs, reason = "the standard has the documentation")]

use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::ptr;

use crate::instance::{Instance, Phase, Refusal, Refused};
pub use crate::logger::LoggerFunction;
use crate::logger::{Category, Logger};
use crate::uri::folder;
use crate::variables::table;

pub type fmi2Status = c_int;
pub const fmi2OK: fmi2Status = 0;
pub const fmi2Warning: fmi2Status = 1;
pub const fmi2Discard: fmi2Status = 2;
pub const fmi2Error: fmi2Status = 3;
pub const fmi2Fatal: fmi2Status = 4;

/// The kind of a unit that this one is.
const CO_SIMULATION: c_int = 1;

#[repr(C)]
pub struct fmi2CallbackFunctions {
    pub logger: Option<LoggerFunction>,
    pub allocateMemory: Option<unsafe extern "C" fn(usize, usize) -> *mut c_void>,
    pub freeMemory: Option<unsafe extern "C" fn(*mut c_void)>,
    pub stepFinished: Option<unsafe extern "C" fn(*mut c_void, fmi2Status)>,
    pub componentEnvironment: *mut c_void,
}

/// What a component is.
pub struct Component {
    pub(crate) instance: Instance,
    pub(crate) logger: Logger,
    /// Texts that were handed out; they live until the next call that hands some out.
    pub(crate) texts: Vec<CString>,
}

pub(crate) type Outcome = Result<fmi2Status, Refused>;

/// Runs the inside of a function on a component, and says to the master what was refused.
///
/// # Safety
/// `component` is null or one that is alive.
pub(crate) unsafe fn on(
    component: *mut Component,
    function: &str,
    body: impl FnOnce(&mut Component) -> Outcome,
) -> fmi2Status {
    // SAFETY: the caller's promise.
    let Some(component) = (unsafe { component.as_mut() }) else { return fmi2Error };
    let Some(outcome) = sins::abi::shielded(|| body(component)) else {
        component.logger.say(Category::Error, fmi2Fatal, &format!("{function}: internal error"));
        return fmi2Fatal;
    };
    outcome.unwrap_or_else(|Refused { refusal, text }| {
        let status = match refusal {
            Refusal::Discard => fmi2Discard,
            Refusal::Error => fmi2Error,
        };
        component.logger.say(Category::Error, status, &format!("{function}: {text}"));
        status
    })
}

/// The elements of an array; none where there are none.
///
/// # Safety
/// `array` has `count` elements.
pub(crate) unsafe fn elements<'a, T>(array: *const T, count: usize) -> Result<&'a [T], Refused> {
    match (array.is_null(), count) {
        (_, 0) => Ok(&[]),
        (true, _) => Err(Refused::error("a null pointer")),
        // SAFETY: the caller's promise.
        (false, _) => Ok(unsafe { std::slice::from_raw_parts(array, count) }),
    }
}

/// The same, to be written.
///
/// # Safety
/// `array` has `count` elements.
pub(crate) unsafe fn elements_mut<'a, T>(array: *mut T, count: usize) -> Result<&'a mut [T], Refused> {
    match (array.is_null(), count) {
        (_, 0) => Ok(&mut []),
        (true, _) => Err(Refused::error("a null pointer")),
        // SAFETY: the caller's promise.
        (false, _) => Ok(unsafe { std::slice::from_raw_parts_mut(array, count) }),
    }
}

/// A text of the master.
///
/// # Safety
/// `text` is null or a terminated string.
pub(crate) unsafe fn text<'a>(text: *const c_char) -> Result<&'a str, Refused> {
    if text.is_null() {
        return Err(Refused::error("a null pointer for a text"));
    }
    // SAFETY: the caller's promise.
    let text = unsafe { CStr::from_ptr(text) };
    text.to_str().map_err(|_| Refused::error("a text that is not UTF-8"))
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Instantiate(
    instance_name: *const c_char,
    kind: c_int,
    guid: *const c_char,
    resource_location: *const c_char,
    functions: *const fmi2CallbackFunctions,
    _visible: c_int,
    logging_on: c_int,
) -> *mut Component {
    // SAFETY: the pointers are what the standard says.
    let Some(functions) = (unsafe { functions.as_ref() }) else { return ptr::null_mut() };
    let name = match instance_name.is_null() {
        true => c"sins".to_owned(),
        // SAFETY: as above.
        false => unsafe { CStr::from_ptr(instance_name) }.to_owned(),
    };
    // SAFETY: the master's logger takes the master's environment.
    let logger = unsafe { Logger::new(functions.logger, functions.componentEnvironment, name, true) };
    let made = sins::abi::shielded(|| {
        if kind != CO_SIMULATION {
            return Err(Refused::error("this unit is for co-simulation only"));
        }
        // SAFETY: as above.
        let guid = unsafe { text(guid) }?;
        let table = table();
        if guid != table.guid {
            let own = &table.guid;
            return Err(Refused::error(format!("guid {guid} is that of another unit; this one's is {own}")));
        }
        let resources = match resource_location.is_null() {
            true => None,
            // SAFETY: as above.
            false => folder(unsafe { text(resource_location) }?),
        };
        Ok(Instance::new(resources))
    });
    let refused = match made {
        Some(Ok(instance)) => {
            let mut component = Component { instance, logger, texts: Vec::new() };
            if logging_on == 0 {
                let _ = component.logger.switch(&[Category::Warning.name()], false);
            }
            return Box::into_raw(Box::new(component));
        }
        Some(Err(refused)) => refused.text,
        None => "internal error".to_owned(),
    };
    logger.say(Category::Error, fmi2Error, &format!("fmi2Instantiate: {refused}"));
    ptr::null_mut()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeInstance(component: *mut Component) {
    if !component.is_null() {
        // SAFETY: it came from `fmi2Instantiate` and is given back once.
        drop(unsafe { Box::from_raw(component) });
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetDebugLogging(
    component: *mut Component,
    logging_on: c_int,
    count: usize,
    categories: *const *const c_char,
) -> fmi2Status {
    // SAFETY: as the module says; so everywhere below.
    unsafe {
        on(component, "fmi2SetDebugLogging", |component| {
            let names = elements(categories, count)?;
            let names = names.iter().map(|&name| text(name)).collect::<Result<Vec<_>, _>>()?;
            component.logger.switch(&names, logging_on != 0).map_err(Refused::error)?;
            Ok(fmi2OK)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetupExperiment(
    component: *mut Component,
    _tolerance_defined: c_int,
    _tolerance: f64,
    start_time: f64,
    _stop_time_defined: c_int,
    _stop_time: f64,
) -> fmi2Status {
    unsafe {
        on(component, "fmi2SetupExperiment", |component| {
            component.instance.require(&[Phase::Instantiated])?;
            component.instance.end_s = start_time;
            Ok(fmi2OK)
        })
    }
}

/// A change of the phase.
unsafe fn go(component: *mut Component, function: &str, from: Phase, to: Phase) -> fmi2Status {
    unsafe { on(component, function, |component| component.instance.go(from, to).map(|()| fmi2OK)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2EnterInitializationMode(component: *mut Component) -> fmi2Status {
    unsafe { go(component, "fmi2EnterInitializationMode", Phase::Instantiated, Phase::Initializing) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2ExitInitializationMode(component: *mut Component) -> fmi2Status {
    unsafe { go(component, "fmi2ExitInitializationMode", Phase::Initializing, Phase::Stepping) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Terminate(component: *mut Component) -> fmi2Status {
    unsafe { go(component, "fmi2Terminate", Phase::Stepping, Phase::Terminated) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Reset(component: *mut Component) -> fmi2Status {
    unsafe {
        on(component, "fmi2Reset", |component| {
            component.instance.reset();
            Ok(fmi2OK)
        })
    }
}
