//! `sins_scene_key`: the keys of scenes as data.

use core::ffi::c_char;

use crate::abi::boundary::enter_without_simulator;
use crate::abi::failure::sins_status;
use crate::abi::memory::{Output, interface_struct};
use crate::abi::text::chars;
use crate::base::error::{Error, Rule};
use crate::base::memory::probe;
use crate::scene::{KeyKind, KeyLine, key_line};

/// What kind of value a key of a scene takes.
pub type sins_scene_key_kind = i32;

/// Numbers; elements says how many.
pub const SINS_SCENE_KEY_NUMBERS: sins_scene_key_kind = 0;
/// A whole number, not negative.
pub const SINS_SCENE_KEY_WHOLE: sins_scene_key_kind = 1;
/// One of several words.
pub const SINS_SCENE_KEY_WORD: sins_scene_key_kind = 2;
/// A text.
pub const SINS_SCENE_KEY_TEXT: sins_scene_key_kind = 3;
/// true or false.
pub const SINS_SCENE_KEY_FLAG: sins_scene_key_kind = 4;

/// Flags of a sins_scene_key.
pub type sins_scene_key_flags = u32;

/// The key belongs to the items of a list: its section stands in double brackets.
pub const SINS_SCENE_KEY_IN_LIST: sins_scene_key_flags = 1;
/// The fields minimum and maximum are the limits of each number. Without this flag there are no limits, or the limits depend
/// on other values.
pub const SINS_SCENE_KEY_LIMITS: sins_scene_key_flags = 2;
/// 0 is allowed in addition to the values within the limits. It switches the quantity off.
pub const SINS_SCENE_KEY_ZERO_IS_OFF: sins_scene_key_flags = 4;

/// A key of the scene format.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_scene_key {
    /// sizeof(sins_scene_key)
    pub struct_size: u32,
    /// Flags of enum sins_scene_key_flags, or'ed.
    pub flags: u32,
    /// Number of keys of the format.
    pub count: u64,
    /// Kind of the value, of enum sins_scene_key_kind.
    pub kind: i32,
    /// Number of numbers: 1; 3 for x, y, z; 9 for a matrix row by row; 0 for the other kinds.
    pub elements: i32,
    /// A single number may be given in the place of all elements if this is not 0. It sets element k if bit k is set, and the other
    /// elements are 0. 0: all elements must be given.
    pub spread: u32,
    /// 0
    pub reserved: u32,
    /// Factor from the unit of the key to SI. It is 1 if the value is not a number.
    pub si_per_unit: f64,
    /// Least allowed value of each number, in the unit of name. If the kinds of items have different limits, it is the widest.
    /// Other values of the scene may narrow the limits.
    pub minimum: f64,
    /// Greatest allowed value, likewise.
    pub maximum: f64,
    /// Section, such as "gyro" or "manoeuvre.sinusoid"; terminated, as all texts here.
    pub section: [c_char; 24],
    /// Name, such as "bias_deg_h": its value is in the unit of data sheets.
    pub name: [c_char; 40],
    /// Name of the key that takes the same quantity in SI, such as "bias_rad_s"; empty: name is that key.
    pub si_name: [c_char; 40],
    /// Unit of name, such as "deg/h"; empty: a pure number, or no number.
    pub unit: [c_char; 24],
    /// Unit of si_name, such as "rad/s".
    pub si_unit: [c_char; 24],
    /// Value in a scene that does not set the key, as sins_scene_get_value() gives it; empty: no value.
    pub default_value: [c_char; 32],
    /// Words that a key of SINS_SCENE_KEY_WORD takes, such as "exact|paper|polynomial".
    pub words: [c_char; 128],
    /// Items of the list that use the key. "kind=turn|s_turn" means the items in which the value of the key `kind` is one of
    /// these words. If there are several conditions, with a space between them, an item must meet all. Empty: all items.
    pub condition: [c_char; 96],
    /// Meaning, without unit.
    pub meaning: [c_char; 128],
}

interface_struct!(sins_scene_key, "key", 592);

/// What a list of keys takes at the most [bytes].
const ROOM: usize = 1 << 16;

/// Reads key `index` of the scene format, from 0 in the order in which a scene is written.
///
/// SINS_ERROR_INVALID_ARGUMENT: there are no more.
/// SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_get_key(index: usize, key: *mut sins_scene_key) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(key, "key")? };
        probe(ROOM)?;
        let (found, count) = key_line(index);
        let Some(line) = found else {
            let rule = Rule::SentenceWith("must be less than the number of keys:", count.into());
            return Err(Error::invalid("index", index, rule).into());
        };
        Ok(output.write(&sins_scene_key::new(&line, count)))
    })
}

impl sins_scene_key {
    fn new(line: &KeyLine, count: usize) -> Self {
        let flag = |is_set: bool, flag| if is_set { flag } else { 0 };
        let (kind, elements) = match line.kind {
            KeyKind::Numbers(count) => (SINS_SCENE_KEY_NUMBERS, count as i32),
            KeyKind::Whole => (SINS_SCENE_KEY_WHOLE, 0),
            KeyKind::Words(_) => (SINS_SCENE_KEY_WORD, 0),
            KeyKind::Text => (SINS_SCENE_KEY_TEXT, 0),
            KeyKind::Flag => (SINS_SCENE_KEY_FLAG, 0),
        };
        Self {
            struct_size: size_of::<Self>() as u32,
            flags: flag(line.is_list, SINS_SCENE_KEY_IN_LIST)
                | flag(line.limits.is_some(), SINS_SCENE_KEY_LIMITS)
                | flag(line.limits.is_some_and(|limits| limits.zero_is_off), SINS_SCENE_KEY_ZERO_IS_OFF),
            count: count as u64,
            kind,
            elements,
            spread: line.spread,
            reserved: 0,
            si_per_unit: line.unit_si,
            minimum: line.limits.map_or(0.0, |limits| limits.low),
            maximum: line.limits.map_or(0.0, |limits| limits.high),
            section: chars(line.section),
            name: chars(line.name),
            si_name: chars(line.si_name.unwrap_or("")),
            unit: chars(line.unit),
            si_unit: chars(line.si_unit),
            default_value: chars(&line.default),
            words: if let KeyKind::Words(words) = line.kind { chars(&words.join("|")) } else { [0; 128] },
            condition: chars(&line.condition),
            meaning: chars(line.doc),
        }
    }
}
