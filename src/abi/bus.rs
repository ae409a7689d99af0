//! `sins_bus_...`: words of ARINC 429.

use super::boundary::enter_without_simulator;
use super::choice::{Choice, check_reserved, choices};
use super::failure::{CallError, SINS_OK, sins_status};
use super::memory::{Array, Output, interface_struct, put, read};
use super::text::chars;
use super::unit_status::{sins_unit_navigation, sins_unit_status};
use crate::base::error::{Error, Rule};
use crate::earth::state::BodyAxes;
use crate::unit::bus::{Inputs, LABELS, WordStatus, decode, decode_reversed, reversed};
use core::ffi::c_char;

/// Flags of a sins_bus_inputs.
pub type sins_bus_flags = u32;

/// The fields wind_... hold values.
pub const SINS_BUS_WIND: sins_bus_flags = 1;
/// The field magnetic_variation_rad holds a value.
pub const SINS_BUS_MAGNETIC_VARIATION: sins_bus_flags = 2;
/// The bits of the label are reversed: the lowest byte of 310 is hexadecimal 13. ARINC 429 sends the most significant bit of the label
/// first, and calls it bit 1. Without this flag that bit is the highest of the lowest byte, which is then the number of the label, c8;
/// with it, that bit is the lowest of the word. The manual of a card says which order it takes. 45 degrees of latitude are e40000c8,
/// reversed e4000013.
pub const SINS_BUS_REVERSED_LABEL: sins_bus_flags = 4;

/// What a host knows beside the unit. All zero, or NULL: nothing; the words that need it say "no computed data".
#[repr(C)]
#[derive(Debug, Clone, Copy, Default)]
pub struct sins_bus_inputs {
    /// sizeof(sins_bus_inputs)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Flags of enum sins_bus_flags, or'ed.
    pub flags: u32,
    /// Source/destination identifier of the words, 0 to 3. Words whose data need these bits have none.
    pub source: u32,
    /// Axes of the simulator, of enum sins_axes.
    pub axes: i32,
    /// Must be 0.
    pub reserved2: u32,
    /// Wind speed, 0 to 500 [m/s].
    pub wind_speed_m_s: f64,
    /// Direction from which the wind blows, clockwise from true north, -10 to 10 [rad].
    pub wind_direction_rad: f64,
    /// Magnetic variation, east positive, -3.2 to 3.2 [rad].
    pub magnetic_variation_rad: f64,
}

interface_struct!(sins_bus_inputs, "inputs", 48);

/// A word and its time.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_bus_word {
    /// sizeof(sins_bus_word)
    pub struct_size: u32,
    /// Number of the label: 200 is the octal 310.
    pub label: u32,
    /// The word: the label in the lowest byte, in the order of SINS_BUS_REVERSED_LABEL. From bit 9 of ARINC 429 on, bit n is bit n - 1 of
    /// the integer, from 0.
    pub word: u32,
    /// 0
    pub reserved: u32,
    /// Time of the word [s].
    pub time_s: f64,
}

interface_struct!(sins_bus_word, "word", 24);

include!(concat!(env!("OUT_DIR"), "/sins_bus_word_status.rs"));

/// A label of the table, with a decoded value where a function gives one.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_bus_label {
    /// sizeof(sins_bus_label)
    pub struct_size: u32,
    /// Number of the label: 200 is the octal 310.
    pub label: u32,
    /// Name, terminated: "ground speed".
    pub name: [c_char; 40],
    /// Unit of the value, terminated: "kt"; empty: a pure number, or single bits.
    pub unit: [c_char; 8],
    /// Value of the lowest bit or digit, in the unit.
    pub resolution: f64,
    /// Time from one word to the next [s]; 0: an input, which the unit does not send.
    pub interval_s: f64,
    /// Value of a decoded word, in the unit; 0 from sins_bus_get_label(); NaN if the data are no value of the label.
    pub value: f64,
    /// Status of a decoded word, of enum sins_bus_word_status. The value counts only with SINS_BUS_NORMAL.
    pub status: i32,
    /// 0
    pub reserved: u32,
    /// Least value that a word of the label may have, in the unit.
    pub minimum: f64,
    /// Greatest value that a word of the label may have, in the unit.
    pub maximum: f64,
}

interface_struct!(sins_bus_label, "label", 104);

fn label_of(label: &crate::unit::bus::Label) -> sins_bus_label {
    let (minimum, maximum) = label.least_and_greatest();
    sins_bus_label {
        struct_size: size_of::<sins_bus_label>() as u32,
        label: label.number.into(),
        name: chars(label.name),
        unit: chars(label.unit),
        resolution: label.resolution,
        interval_s: f64::from(label.interval_ms) / 1e3,
        value: 0.0,
        status: SINS_BUS_NORMAL,
        reserved: 0,
        minimum,
        maximum,
    }
}

impl sins_bus_inputs {
    fn to_inputs(self) -> Result<(Inputs, bool), CallError> {
        check_reserved("inputs.reserved", self.reserved)?;
        check_reserved("inputs.reserved2", self.reserved2)?;
        let known = SINS_BUS_WIND | SINS_BUS_MAGNETIC_VARIATION | SINS_BUS_REVERSED_LABEL;
        if self.flags & !known != 0 {
            return Err(
                Error::invalid("inputs.flags", self.flags, Rule::BetweenIntegers(0, known.into())).into()
            );
        }
        let has = |bit| self.flags & bit != 0;
        let inputs = Inputs {
            wind: has(SINS_BUS_WIND).then_some((self.wind_speed_m_s, self.wind_direction_rad)),
            variation_rad: has(SINS_BUS_MAGNETIC_VARIATION).then_some(self.magnetic_variation_rad),
            axes: BodyAxes::of("inputs.axes", self.axes)?,
            source: self.source,
        };
        Ok((inputs, has(SINS_BUS_REVERSED_LABEL)))
    }
}

/// Gives the words that are due after from_s and not after to_s, in the order of their times, into words[0] to words[*count - 1].
/// from_s is from -1e10 to 1e10 s, to_s from from_s to 10 s later. A time that is before a multiple of a millisecond by no more than
/// four roundings, 4 * DBL_EPSILON times itself, counts as the multiple. status and navigation are those of sins_unit_get_status()
/// and sins_unit_get_navigation(). Each label is sent at the multiples of its interval. A unit that is off sends nothing. A value
/// beyond the range of its label is the end of the range; angles of any direction wrap.
///
/// The words show what navigation holds. A real unit is some 80 ms late: a host that wants that keeps status and navigation for this
/// time. A simulator without a panel sends words too, with a unit that was created with SINS_UNIT_NAV.
///
/// inputs may be NULL. count gets the number of words that are due. With capacity 0, words may be NULL. No allocation, no system call.
///
/// SINS_ERROR_BUFFER_TOO_SMALL: more words are due than capacity; *count has their number, and words the first ones.
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
///
/// ```c
/// sins_unit_status bus_status;
/// sins_unit_navigation bus_navigation;
/// sins_bus_word word;
/// sins_bus_label label;
/// size_t word_count = 0;
/// SINS_INIT(bus_status);
/// SINS_INIT(bus_navigation);
/// SINS_INIT(word);
/// SINS_INIT(label);
/// bus_status.state = SINS_UNIT_STATE_NAVIGATION;
/// bus_navigation.validity = SINS_UNIT_VALID_POSITION;
/// bus_navigation.latitude_rad = 45.0 * SINS_DEG;
/// sins_bus_words(&bus_status, &bus_navigation, NULL, 0.09, 0.1, &word, 1, &word_count);
/// sins_bus_decode(word.word, 0, &label);
/// printf("label %o: %08lx, %g %s\n", (unsigned)label.label, (unsigned long)word.word, label.value, label.unit);  // label 310: e40000c8, 45 deg
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_bus_words(
    status: *const sins_unit_status,
    navigation: *const sins_unit_navigation,
    inputs: *const sins_bus_inputs,
    from_s: f64,
    to_s: f64,
    words: *mut sins_bus_word,
    capacity: usize,
    count: *mut usize,
) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        let (status, navigation) = unsafe { (read(status, "status")?, read(navigation, "navigation")?) };
        let inputs = if inputs.is_null() {
            (Inputs::default(), false)
        } else {
            // SAFETY: the host's promise.
            unsafe { read(inputs, "inputs")? }.to_inputs()?
        };
        // SAFETY: the host's promise.
        let place = unsafe { Array::new(words, capacity, "words")? };
        let ((inputs, is_reversed), mut due, mut written) = (inputs, 0, Ok(()));
        let (status, navigation) = (status.to_status()?, navigation.to_shown()?);
        crate::unit::bus::words(&status, &navigation, &inputs, (from_s, to_s), |word| {
            if due < capacity && written.is_ok() {
                let bits = if is_reversed { reversed(word.word) } else { word.word };
                written = place.write(
                    due,
                    &sins_bus_word {
                        struct_size: size_of::<sins_bus_word>() as u32,
                        label: word.label.into(),
                        word: bits,
                        reserved: 0,
                        time_s: word.time_s,
                    },
                );
            }
            due += 1;
        })?;
        written?;
        // SAFETY: the host's promise.
        unsafe { put(count, due, "count")? };
        if due > capacity { Err(CallError::buffer("capacity", capacity, due)) } else { Ok(SINS_OK) }
    })
}

/// Reads row `index` of the table of labels, from 0: what a unit sends, and the three inputs behind it.
///
/// SINS_ERROR_INVALID_ARGUMENT: no such row.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_bus_get_label(index: usize, label: *mut sins_bus_label) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(label, "label")? };
        let Some(row) = LABELS.get(index) else {
            return Err(Error::invalid("index", index, Rule::Below(LABELS.len() as f64)).into());
        };
        Ok(output.write(&label_of(row)))
    })
}

/// Decodes a word of the table: its label, its value and its status. The status is SINS_BUS_ILLEGAL_VALUE and the value NaN if the status
/// bits say normal, but the data are no value of the label: a decimal digit above 9, 75 minutes, 99 degrees of latitude, a minus sign
/// where the range begins at 0. If the status is SINS_BUS_NORMAL, the host may give the value of an input, set latitude (041), set
/// longitude (042) or set heading (043), to sins_unit_enter_position() or sins_unit_enter_heading(); these do not accept NaN. flags is 0,
/// or SINS_BUS_REVERSED_LABEL.
///
/// SINS_ERROR_INVALID_ARGUMENT: the parity of the word is even, or the table does not have its label. sins_last_error() says which, and
/// whether there is a label with the bits in the other order.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_bus_decode(
    word: u32,
    flags: u32,
    label: *mut sins_bus_label,
) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(label, "label")? };
        if flags & !SINS_BUS_REVERSED_LABEL != 0 {
            let rule = Rule::Sentence("must be 0 or SINS_BUS_REVERSED_LABEL");
            return Err(Error::invalid("flags", flags, rule).into());
        }
        let decoded = if flags == 0 { decode(word)? } else { decode_reversed(word)? };
        Ok(output.write(&sins_bus_label {
            value: decoded.value,
            status: decoded.status.code(),
            ..label_of(decoded.label)
        }))
    })
}
