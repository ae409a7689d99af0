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
use std::path::PathBuf;
use std::ptr;

use crate::instance::{Instance, Phase, Refusal, Refused};
use crate::logger::{Category, Logger, LoggerFunction};
use crate::saved;
use crate::values::{Base, Value};
use crate::variables::table;

pub type fmi2Status = c_int;
pub const fmi2OK: fmi2Status = 0;
pub const fmi2Warning: fmi2Status = 1;
pub const fmi2Discard: fmi2Status = 2;
pub const fmi2Error: fmi2Status = 3;
pub const fmi2Fatal: fmi2Status = 4;

/// The kind of a unit that this one is.
const CO_SIMULATION: c_int = 1;
/// Kinds of `fmi2Get...Status`.
const LAST_SUCCESSFUL_TIME: c_int = 2;
const TERMINATED: c_int = 3;

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
    instance: Instance,
    logger: Logger,
    /// Texts that were handed out; they live until the next call that hands some out.
    texts: Vec<CString>,
}

type Outcome = Result<fmi2Status, Refused>;

/// Runs the inside of a function on a component, and says to the master what was refused.
///
/// # Safety
/// `component` is null or one that is alive.
unsafe fn on(
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
unsafe fn elements<'a, T>(array: *const T, count: usize) -> Result<&'a [T], Refused> {
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
unsafe fn elements_mut<'a, T>(array: *mut T, count: usize) -> Result<&'a mut [T], Refused> {
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
unsafe fn text<'a>(text: *const c_char) -> Result<&'a str, Refused> {
    if text.is_null() {
        return Err(Refused::error("a null pointer for a text"));
    }
    // SAFETY: the caller's promise.
    let text = unsafe { CStr::from_ptr(text) };
    text.to_str().map_err(|_| Refused::error("a text that is not UTF-8"))
}

/// The folder of a URI: "file:///home/a%20b", "file:/C:/resources". Other schemes: none.
fn folder(uri: &str) -> Option<PathBuf> {
    let rest = uri.strip_prefix("file:")?;
    let path = match rest.strip_prefix("//") {
        Some(rest) => &rest[rest.find('/')?..],
        None => rest,
    };
    let path = percent_encoding::percent_decode_str(path).decode_utf8().ok()?;
    let has_drive = path.as_bytes().get(2) == Some(&b':');
    Some(PathBuf::from(if has_drive { &path[1..] } else { &path }))
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
            for (&reference, to) in references.iter().zip(values) {
                if let Some(value) = convert(component.instance.get(base, reference as usize)?) {
                    *to = value;
                }
            }
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

/// A state that was got: its bytes.
pub type State = Vec<u8>;

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetFMUstate(component: *mut Component, state: *mut *mut State) -> fmi2Status {
    unsafe {
        on(component, "fmi2GetFMUstate", |component| {
            let state = state.as_mut().ok_or_else(|| Refused::error("a null pointer"))?;
            let bytes = saved::save(&component.instance).map_err(Refused::error)?;
            match state.as_mut() {
                Some(earlier) => *earlier = bytes,
                None => *state = Box::into_raw(Box::new(bytes)),
            }
            Ok(fmi2OK)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetFMUstate(component: *mut Component, state: *mut State) -> fmi2Status {
    unsafe {
        on(component, "fmi2SetFMUstate", |component| {
            let state = state.as_ref().ok_or_else(|| Refused::error("a null pointer for a state"))?;
            component.instance = saved::load(state, &component.instance).map_err(Refused::error)?;
            Ok(fmi2OK)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeFMUstate(component: *mut Component, state: *mut *mut State) -> fmi2Status {
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
pub unsafe extern "C" fn fmi2SerializedFMUstateSize(
    component: *mut Component,
    state: *mut State,
    size: *mut usize,
) -> fmi2Status {
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
pub unsafe extern "C" fn fmi2SerializeFMUstate(
    component: *mut Component,
    state: *mut State,
    bytes: *mut u8,
    size: usize,
) -> fmi2Status {
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
pub unsafe extern "C" fn fmi2DeSerializeFMUstate(
    component: *mut Component,
    bytes: *const u8,
    size: usize,
    state: *mut *mut State,
) -> fmi2Status {
    unsafe {
        on(component, "fmi2DeSerializeFMUstate", |component| {
            let state = state.as_mut().ok_or_else(|| Refused::error("a null pointer"))?;
            let bytes = elements(bytes, size)?;
            saved::load(bytes, &component.instance).map_err(Refused::error)?;
            match state.as_mut() {
                Some(earlier) => *earlier = bytes.to_vec(),
                None => *state = Box::into_raw(Box::new(bytes.to_vec())),
            }
            Ok(fmi2OK)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DoStep(
    component: *mut Component,
    current_communication_point: f64,
    communication_step_size: f64,
    _no_set_state_prior_to_current_point: c_int,
) -> fmi2Status {
    unsafe {
        on(component, "fmi2DoStep", |component| {
            if component.instance.step(current_communication_point, communication_step_size)? {
                let text = format!("the sample at {current_communication_point} s closes a gap in the truth");
                component.logger.say(Category::Warning, fmi2OK, &text);
            }
            Ok(fmi2OK)
        })
    }
}

/// A call that this unit has no use for.
unsafe fn without(component: *mut Component, function: &str, why: &str) -> fmi2Status {
    unsafe { on(component, function, |_| Err(Refused::error(why))) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2CancelStep(component: *mut Component) -> fmi2Status {
    unsafe { without(component, "fmi2CancelStep", "steps are never asynchronous") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetRealInputDerivatives(
    component: *mut Component,
    _references: *const u32,
    _count: usize,
    _orders: *const c_int,
    _values: *const f64,
) -> fmi2Status {
    unsafe { without(component, "fmi2SetRealInputDerivatives", "inputs are not interpolated") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealOutputDerivatives(
    component: *mut Component,
    _references: *const u32,
    _count: usize,
    _orders: *const c_int,
    _values: *mut f64,
) -> fmi2Status {
    unsafe { without(component, "fmi2GetRealOutputDerivatives", "outputs have no derivatives") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDirectionalDerivative(
    component: *mut Component,
    _unknowns: *const u32,
    _unknown_count: usize,
    _knowns: *const u32,
    _known_count: usize,
    _seed: *const f64,
    _values: *mut f64,
) -> fmi2Status {
    unsafe { without(component, "fmi2GetDirectionalDerivative", "there are no directional derivatives") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealStatus(
    component: *mut Component,
    kind: c_int,
    value: *mut f64,
) -> fmi2Status {
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
pub unsafe extern "C" fn fmi2GetBooleanStatus(
    component: *mut Component,
    kind: c_int,
    value: *mut c_int,
) -> fmi2Status {
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
pub unsafe extern "C" fn fmi2GetStatus(
    component: *mut Component,
    _kind: c_int,
    _value: *mut c_int,
) -> fmi2Status {
    unsafe { without(component, "fmi2GetStatus", "steps are never asynchronous") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetIntegerStatus(
    component: *mut Component,
    _kind: c_int,
    _value: *mut c_int,
) -> fmi2Status {
    unsafe { without(component, "fmi2GetIntegerStatus", "there is no integer status") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetStringStatus(
    component: *mut Component,
    _kind: c_int,
    _value: *mut *const c_char,
) -> fmi2Status {
    unsafe { without(component, "fmi2GetStringStatus", "steps are never asynchronous") }
}
