//! The functions of FMI 2.0 for co-simulation, as a master loads them.
//!
//! # Safety
//!
//! For every function of this module: pointers are as the standard requires; a component was returned by [`fmi2Instantiate`] and
//! not yet freed by [`fmi2FreeInstance`], and only one thread at a time uses it.
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
use crate::table::table;
use crate::uri::folder;
use crate::watch::Watch;

pub type fmi2Status = c_int;
pub const fmi2OK: fmi2Status = 0;
pub const fmi2Warning: fmi2Status = 1;
pub const fmi2Discard: fmi2Status = 2;
pub const fmi2Error: fmi2Status = 3;
pub const fmi2Fatal: fmi2Status = 4;

/// The kind of this unit: co-simulation.
const CO_SIMULATION: c_int = 1;

#[repr(C)]
pub struct fmi2CallbackFunctions {
    pub logger: Option<LoggerFunction>,
    pub allocateMemory: Option<unsafe extern "C" fn(usize, usize) -> *mut c_void>,
    pub freeMemory: Option<unsafe extern "C" fn(*mut c_void)>,
    pub stepFinished: Option<unsafe extern "C" fn(*mut c_void, fmi2Status)>,
    pub componentEnvironment: *mut c_void,
}

/// An instance with its logger, to which the master's handle points.
pub struct Component {
    pub(crate) instance: Instance,
    pub(crate) logger: Logger,
    /// Texts that were returned to the master; valid until the next call that returns texts.
    pub(crate) texts: Vec<CString>,
    /// Whether the warning about a large turn was sent, which is sent once.
    pub(crate) has_said_turn: bool,
    /// Whether the warnings about inputs that seem not to be connected were sent, which are sent once.
    pub(crate) has_said_unconnected: bool,
    pub(crate) watch: Watch,
}

pub(crate) type Outcome = Result<fmi2Status, Refused>;

/// Runs the body of a function on a component, and reports a refusal to the master.
///
/// # Safety
/// `component` is null or a component that was not freed.
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

/// The elements of an array; an empty array may be null.
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

/// The elements of an array, for writing; an empty array may be null.
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

/// A text that the master passes.
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
pub extern "C-unwind" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

#[unsafe(no_mangle)]
pub extern "C-unwind" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2Instantiate(
    instance_name: *const c_char,
    kind: c_int,
    guid: *const c_char,
    resource_location: *const c_char,
    functions: *const fmi2CallbackFunctions,
    _visible: c_int,
    _logging_on: c_int,
) -> *mut Component {
    // SAFETY: the pointers are as the standard requires.
    let Some(functions) = (unsafe { functions.as_ref() }) else { return ptr::null_mut() };
    let name = match instance_name.is_null() {
        true => c"sins".to_owned(),
        // SAFETY: as above.
        false => unsafe { CStr::from_ptr(instance_name) }.to_owned(),
    };
    // SAFETY: the master's logger accepts the master's environment.
    let logger = unsafe { Logger::new(functions.logger, functions.componentEnvironment, name) };
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
            let component = Component {
                instance,
                logger,
                texts: Vec::new(),
                has_said_turn: false,
                has_said_unconnected: false,
                watch: Watch::default(),
            };
            return Box::into_raw(Box::new(component));
        }
        Some(Err(refused)) => refused.text,
        None => "internal error".to_owned(),
    };
    logger.say(Category::Error, fmi2Error, &format!("fmi2Instantiate: {refused}"));
    ptr::null_mut()
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2FreeInstance(component: *mut Component) {
    if !component.is_null() {
        // SAFETY: the component came from `fmi2Instantiate` and is freed once.
        drop(unsafe { Box::from_raw(component) });
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2SetDebugLogging(
    component: *mut Component,
    logging_on: c_int,
    count: usize,
    categories: *const *const c_char,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of the module says; the array has `count` terminated texts.
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
pub unsafe extern "C-unwind" fn fmi2SetupExperiment(
    component: *mut Component,
    _tolerance_defined: c_int,
    _tolerance: f64,
    start_time: f64,
    _stop_time_defined: c_int,
    _stop_time: f64,
) -> fmi2Status {
    // SAFETY: the component is as the documentation of the module says.
    unsafe {
        on(component, "fmi2SetupExperiment", |component| {
            component.instance.require(&[Phase::Instantiated])?;
            component.instance.end_s = start_time;
            Ok(fmi2OK)
        })
    }
}

/// Changes the phase of a component.
///
/// # Safety
/// As [`on`].
unsafe fn go(component: *mut Component, function: &str, from: Phase, to: Phase) -> fmi2Status {
    // SAFETY: as this function.
    unsafe { on(component, function, |component| component.instance.go(from, to).map(|()| fmi2OK)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2EnterInitializationMode(component: *mut Component) -> fmi2Status {
    // SAFETY: the component is as the documentation of the module says.
    unsafe { go(component, "fmi2EnterInitializationMode", Phase::Instantiated, Phase::Initializing) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2ExitInitializationMode(component: *mut Component) -> fmi2Status {
    // SAFETY: the component is as the documentation of the module says.
    unsafe { go(component, "fmi2ExitInitializationMode", Phase::Initializing, Phase::Stepping) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2Terminate(component: *mut Component) -> fmi2Status {
    // SAFETY: the component is as the documentation of the module says.
    unsafe {
        on(component, "fmi2Terminate", |component| {
            component.instance.go(Phase::Stepping, Phase::Terminated)?;
            for text in component.watch.end() {
                component.logger.say(Category::Warning, fmi2Warning, &text);
            }
            Ok(fmi2OK)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn fmi2Reset(component: *mut Component) -> fmi2Status {
    // SAFETY: the component is as the documentation of the module says.
    unsafe {
        on(component, "fmi2Reset", |component| {
            component.instance.reset();
            component.watch = Watch::default();
            Ok(fmi2OK)
        })
    }
}
