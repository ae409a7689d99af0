//! Values of a scene by their paths.

use core::ffi::c_char;

use super::{change_scene, sins_scene, with_scene};
use crate::abi::failure::sins_status;
use crate::abi::text::{bad_text, put_text, text_of, utf8_of};
use crate::scene::{Fault, utf8};

/// Reads the value at a path, as it stands in the text of a scene: "gyro.bias_deg_h" (all three), "gyro.bias_deg_h[1]" (that of
/// the y axis), "gyro.bias_rad_s" (in SI), "options.scheme", "manoeuvre[3].bank_deg", "manoeuvre[3].sinusoid[0].channel",
/// "failure[0].kind". Places in lists begin at 0. Words and texts are in quotes. The text is empty if the scene has no such
/// value. For example, flight.hours is empty if the scene flies the whole flight. The scene stores numbers in SI, so a number
/// read in another unit may be rounded. The scene does not store the name of a preset, only the errors that the preset sets.
///
/// The paths "manoeuvre[3]" and "failure[0]" give all lines of an item, for sins_scene_set_items(). A built-in flight and a log
/// have no such manoeuvres. buffer, capacity and needed as in sins_scene_write().
///
/// SINS_ERROR_INVALID_ARGUMENT: the path names no value, or the scene has no such item.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_get_value(
    scene: *const sins_scene,
    path: *const c_char,
    buffer: *mut c_char,
    capacity: usize,
    needed: *mut usize,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: the host's promise.
        let path = unsafe { utf8_of(path, "path")? };
        let Some(value) = scene.value(path) else {
            return Err(bad_text(
                "path",
                "must name a value or an item of the scene; sins_scene_get_key() gives the keys",
            )
            .into());
        };
        // SAFETY: the host's promise.
        unsafe { put_text(value.as_bytes(), buffer, capacity, needed) }
    })
}

/// Sets up to 4096 values of the scene, all or none. values is a terminated text in UTF-8. Each line is path = value, with a path
/// as in sins_scene_get_value(). Blank lines and lines that begin with # are ignored. A value is written as in the text of a
/// scene, but words and texts need no quotes. An empty value (gyro.bias_deg_h =) sets the default of the key. If the path is
/// a single element (gyro.bias_deg_h[1] =), it sets 0. If a value is set twice, the last one counts. gyro.preset replaces all
/// errors of the gyros, accelerometer.preset those of the accelerometers, before the other lines are applied, wherever it
/// stands. flight.file and flight.builtin replace the flight.
///
/// The scene is then checked as sins_scene_parse() checks a text. Set values that depend on each other in one call, such as the
/// kind of a manoeuvre and its quantities.
///
/// SINS_ERROR_INVALID_ARGUMENT: the scene would not be valid, and stays as it was. sins_scene_get_fault() gives every fault
/// with the line in values and the path.
/// SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_set_values(
    scene: *mut sins_scene,
    values: *const c_char,
) -> sins_status {
    // SAFETY: the host's promise.
    let values = unsafe { text_of(values, "values") };
    let size = values.map_or(0, <[u8]>::len);
    change_scene(scene, "values", size, |scene| {
        let (mut settings, mut faults) = (Vec::new(), Vec::new());
        let mut lines = Vec::new();
        for (line, number) in utf8(values?)?.lines().zip(1..) {
            let line = line.trim();
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            match line.split_once('=') {
                Some((path, value)) => settings.push((path.trim(), value.trim())),
                None => faults.push(Fault {
                    line: number,
                    column: 1,
                    sentence: NO_SETTING.to_owned(),
                    ..Fault::default()
                }),
            }
            lines.push(number);
        }
        if !faults.is_empty() {
            return Err(faults.into());
        }
        scene.set(&settings).map_err(|mut faults| {
            faults.iter_mut().for_each(|fault| place_in_lines(fault, &lines));
            faults.into()
        })
    })
}

/// What is wrong with a line that sets nothing.
const NO_SETTING: &str = "expected path = value, or path = for the default";

/// A fault of setting `column` is one of its line.
fn place_in_lines(fault: &mut Fault, lines: &[usize]) {
    if let Some(line) = fault.column.checked_sub(1).and_then(|index| lines.get(index)) {
        (fault.line, fault.column) = (*line, 1);
    }
}

/// Replaces all items of a list, "manoeuvre", "failure", "update" or "panel". items is a terminated text with the items as in the
/// text of a scene: [[manoeuvre]] and its keys, and so on. sins_scene_get_value() gives the text of one item. To add, remove or move an
/// item, give the texts of all items that the list shall have, in order. An empty text removes all failures, updates or actions; for
/// "manoeuvre" an empty text is a fault. If the flight was a built-in flight, the manoeuvres begin at its start; if it was a log, at
/// latitude 0, longitude 0, height 0.
///
/// SINS_ERROR_INVALID_ARGUMENT: no such list, or the scene would not be valid; it stays as it was. sins_scene_get_fault() gives
/// every fault with the line in items and the path.
/// SINS_ERROR_OUT_OF_MEMORY: as sins_scene_create().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_set_items(
    scene: *mut sins_scene,
    list: *const c_char,
    items: *const c_char,
) -> sins_status {
    // SAFETY: the host's promise.
    let (list, items) = unsafe { (utf8_of(list, "list"), text_of(items, "items")) };
    let size = items.map_or(0, <[u8]>::len);
    change_scene(scene, "items", size, |scene| Ok(scene.set_items(list?, utf8(items?)?)?))
}
