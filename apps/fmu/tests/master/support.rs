//! A master for the tests: instances with a logger that keeps the messages, and the functions with types of Rust.

use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::ptr;
use std::sync::OnceLock;

use sins_fmu::get_set::*;
use sins_fmu::interface::*;
use sins_fmu::model_description;
use sins_fmu::states::*;

pub type Message = (c_int, String, String);

/// Messages of an instance.
pub type Messages = Vec<Message>;

unsafe extern "C-unwind" fn log(
    environment: *mut c_void,
    _name: *const c_char,
    status: c_int,
    category: *const c_char,
    message: *const c_char,
) {
    let text = |text| unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned();
    let messages = unsafe { &mut *environment.cast::<Messages>() };
    messages.push((status, text(category), text(message)));
}

/// An instance, freed with its messages at the end.
pub struct Unit {
    pub component: *mut Component,
    messages: *mut Messages,
}

impl Drop for Unit {
    fn drop(&mut self) {
        unsafe {
            fmi2FreeInstance(self.component);
            drop(Box::from_raw(self.messages));
        }
    }
}

impl Unit {
    /// A new instance, with a URI of the resources. Without debug logging, which changes nothing: no message is for debugging.
    pub fn new(uri: Option<&str>) -> Self {
        let messages: *mut Messages = Box::into_raw(Box::default());
        // SAFETY: on all processors that the unit is built for, a function of variable arguments is called like one without them.
        let logger = unsafe { std::mem::transmute::<*const (), LoggerFunction>(log as *const ()) };
        let functions = fmi2CallbackFunctions {
            logger: Some(logger),
            allocateMemory: None,
            freeMemory: None,
            stepFinished: None,
            componentEnvironment: messages.cast(),
        };
        let guid = CString::new(guid()).unwrap();
        let uri = uri.map(|uri| CString::new(uri).unwrap());
        let uri = uri.as_ref().map_or(ptr::null(), |uri| uri.as_ptr());
        let component = unsafe { fmi2Instantiate(c"unit".as_ptr(), 1, guid.as_ptr(), uri, &functions, 0, 0) };
        assert!(!component.is_null());
        Self { component, messages }
    }

    /// An instance in flight; `set` is called before the initialization.
    pub fn flying(set: impl FnOnce(&Self)) -> Self {
        let unit = Self::new(None);
        set(&unit);
        assert_eq!(unsafe { fmi2EnterInitializationMode(unit.component) }, fmi2OK);
        assert_eq!(unsafe { fmi2ExitInitializationMode(unit.component) }, fmi2OK, "{:?}", unit.messages());
        unit
    }

    /// Messages since the last call.
    pub fn messages(&self) -> Messages {
        std::mem::take(unsafe { &mut *self.messages })
    }

    pub fn set_reals(&self, references: &[u32], values: &[f64]) -> c_int {
        unsafe { fmi2SetReal(self.component, references.as_ptr(), references.len(), values.as_ptr()) }
    }

    pub fn reals(&self, references: &[u32]) -> Vec<f64> {
        let mut values = vec![0.0; references.len()];
        let status = unsafe {
            fmi2GetReal(self.component, references.as_ptr(), references.len(), values.as_mut_ptr())
        };
        assert_eq!(status, fmi2OK);
        values
    }

    /// The state as bytes.
    pub fn state(&self) -> Vec<u8> {
        let (mut state, mut size) = (ptr::null_mut(), 0);
        unsafe {
            assert_eq!(fmi2GetFMUstate(self.component, &mut state), fmi2OK);
            assert_eq!(fmi2SerializedFMUstateSize(self.component, state, &mut size), fmi2OK);
            let mut bytes = vec![0; size];
            assert_eq!(fmi2SerializeFMUstate(self.component, state, bytes.as_mut_ptr(), size), fmi2OK);
            assert_eq!(fmi2FreeFMUstate(self.component, &mut state), fmi2OK);
            bytes
        }
    }
}

/// Identity of the unit, from its description.
pub fn guid() -> String {
    let xml = model_description();
    let rest = xml.split_once("guid=\"").unwrap().1;
    rest[..rest.find('"').unwrap()].to_owned()
}

/// A variable of the description.
#[derive(Debug, Clone)]
pub struct Described {
    pub name: String,
    pub reference: u32,
    pub causality: String,
    /// Real, Integer, Enumeration, Boolean, String.
    pub element: String,
    pub limits: Option<(f64, f64)>,
}

/// All variables in the order of the description.
pub fn variables() -> &'static [Described] {
    static ALL: OnceLock<Vec<Described>> = OnceLock::new();
    ALL.get_or_init(described)
}

fn described() -> Vec<Described> {
    let xml = model_description();
    let attribute = |text: &str, name: &str| {
        let rest = text.split_once(&format!(" {name}=\""))?.1;
        Some(rest[..rest.find('"')?].to_owned())
    };
    let of = |text: &str| {
        let (outer, inner) = text.split_once('>')?;
        let number = |name| attribute(inner, name)?.parse().ok();
        Some(Described {
            name: attribute(outer, "name")?,
            reference: attribute(outer, "valueReference")?.parse().ok()?,
            causality: attribute(outer, "causality")?,
            element: inner.trim_start().strip_prefix('<')?.split([' ', '/']).next()?.to_owned(),
            limits: number("min").zip(number("max")),
        })
    };
    xml.split("<ScalarVariable").skip(1).map(|text| of(text).unwrap()).collect()
}

/// The reference of the variable `name`.
pub fn reference(name: &str) -> u32 {
    variables().iter().find(|variable| variable.name == name).unwrap_or_else(|| panic!("{name}")).reference
}

/// Inputs of position, attitude and velocity: at rest at 45 degrees.
pub const AT_REST: [f64; 9] = [0.785, 0.2, 500.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];

/// References of these inputs: the first reals.
pub fn inputs() -> Vec<u32> {
    (0..9).collect()
}
