//! Scenes and flight logs through their C functions: the checks of every text and of every change of a scene.

use std::ffi::{CStr, CString, c_char};
use std::ptr::{null, null_mut};

use sins::abi::*;
use sins::scene::{BUILTIN_SCENES, keys};

use crate::call;
use crate::host::init;
use crate::identify::check_identify;
use crate::input::{Argument, Input};

/// The text that a function writes. A smaller buffer must be rejected.
pub fn written(write: impl Fn(*mut c_char, usize, *mut usize) -> sins_status) -> Option<Vec<u8>> {
    let mut needed = 0;
    match write(null_mut(), 0, &mut needed) {
        SINS_OK => {}
        _ => return None,
    }
    let mut text = vec![0x55_u8; needed];
    assert_eq!(write(text.as_mut_ptr().cast(), needed, null_mut()), SINS_OK);
    assert_eq!(text.pop(), Some(0));
    assert!(std::str::from_utf8(&text).is_ok(), "a text that is not UTF-8");
    let mut short = vec![0x55_u8; needed / 2];
    if !short.is_empty() {
        assert_eq!(write(short.as_mut_ptr().cast(), short.len(), null_mut()), SINS_ERROR_BUFFER_TOO_SMALL);
        assert!(short.contains(&0), "a text that was cut has no end");
    }
    Some(text)
}

/// The text of a scene, with the checks of [`written`].
fn checked_text_of(scene: *const sins_scene) -> Option<Vec<u8>> {
    written(|buffer, capacity, needed| call!(sins_scene_write(scene, buffer, capacity, needed)))
}

/// The text of a scene. Most of an execution is the writing of texts, so it is written once.
pub fn text_of(scene: *const sins_scene) -> Option<Vec<u8>> {
    let (mut text, mut needed) = (vec![0x55_u8; 1 << 14], 0);
    match call!(sins_scene_write(scene, text.as_mut_ptr().cast(), text.len(), &mut needed)) {
        SINS_OK => {
            text.truncate(needed);
            assert_eq!(text.pop(), Some(0));
            Some(text)
        }
        SINS_ERROR_BUFFER_TOO_SMALL => checked_text_of(scene),
        _ => None,
    }
}

/// Checks the fields of a fault.
fn check_fault(fault: &sins_fault) {
    let sentence = fault.sentence.map(|letter| letter as u8);
    let end = sentence.iter().position(|&letter| letter == 0).expect("a sentence without an end");
    let sentence = std::str::from_utf8(&sentence[..end]).expect("a sentence that is not UTF-8");
    assert!(!sentence.is_empty() && !sentence.contains(char::is_control), "a sentence [{sentence:?}]");
    assert!(fault.count >= 1 && (fault.line >= 1) == (fault.column >= 1), "the place of a fault");
    let numbers = [fault.value, fault.minimum, fault.maximum];
    assert!(numbers.iter().all(|number| number.is_finite()), "numbers of a fault {numbers:?}");
}

/// The faults of a change, if it was rejected.
pub fn check_faults(scene: *const sins_scene) {
    let mut fault = init();
    let mut index = 0;
    while call!(sins_scene_get_fault(scene, index, &mut fault)) == SINS_OK {
        check_fault(&fault);
        index += 1;
    }
}

/// Largest number of values that are read back after a change.
const MOST_READ: usize = 4;

/// Sets values. They have faults, or every value that was set can be read, and setting it again gives the same scene.
pub fn set_values(scene: *mut sins_scene, values: &CStr) -> sins_status {
    let status = call!(sins_scene_set_values(scene, values.as_ptr()));
    check_faults(scene);
    if status != SINS_OK {
        return status;
    }
    let before = text_of(scene).expect("a scene with values that cannot be written");
    // Each value costs a change of the scene: the last ones stand for hundreds of lines.
    for line in values.to_str().expect("it was taken").lines().rev().take(MOST_READ) {
        let path = line.split('=').next().unwrap_or_default().trim();
        if path.is_empty() || path.starts_with('#') || path.ends_with(".preset") {
            continue;
        }
        let path = CString::new(path).expect("of a line");
        let value = written(|buffer, capacity, needed| {
            call!(sins_scene_get_value(scene, path.as_ptr(), buffer, capacity, needed))
        });
        let value = value.expect("a value that was set is not read");
        let again = [path.as_bytes(), b" = ", &value].concat();
        let again = CString::new(again).expect("no value has a zero byte");
        let status = call!(sins_scene_set_values(scene, again.as_ptr()));
        let is_same = text_of(scene).as_deref() == Some(&before[..]);
        assert!(is_same, "a value that was read is another [{}]", again.to_string_lossy());
        // With several values, a later one may restore a default, and not every item accepts the key of a default.
        let is_only = values.to_bytes().iter().filter(|&&byte| byte == b'=').count() == 1;
        let has_value = line.split_once('=').is_some_and(|(_, value)| !value.trim().is_empty());
        assert!(status == SINS_OK || !is_only || !has_value, "a value that was read is refused");
    }
    SINS_OK
}

/// Reads a text: it is a scene, which is written and read back to the same text, or it has faults, each with a place
/// and a sentence.
pub fn parse_scene(text: &[u8]) -> *mut sins_scene {
    // The buffer has exactly the size of the text, so that the sanitizer detects an access beyond it.
    let text = text.to_vec().into_boxed_slice();
    let mut scene = null_mut();
    match call!(sins_scene_parse(text.as_ptr().cast(), text.len(), &mut scene)) {
        SINS_OK => {
            let first = checked_text_of(scene).expect("a scene that cannot be written");
            let mut again = null_mut();
            let status = call!(sins_scene_parse(first.as_ptr().cast(), first.len(), &mut again));
            assert_eq!(status, SINS_OK, "{}", String::from_utf8_lossy(&first));
            assert_eq!(text_of(again).as_deref(), Some(&first[..]), "another text the second time");
            assert_eq!(call!(sins_scene_destroy(again)), SINS_OK);
            let mut fault = init();
            assert_eq!(call!(sins_scene_get_fault(scene, 0, &mut fault)), SINS_ERROR_INVALID_ARGUMENT);
        }
        SINS_SCENE_HAS_FAULTS => {
            let mut fault = init::<sins_fault>();
            assert_eq!(call!(sins_scene_get_fault(scene, 0, &mut fault)), SINS_OK);
            let count = fault.count as usize;
            assert!((1..=200).contains(&count), "{count} faults");
            for index in 0..count {
                assert_eq!(call!(sins_scene_get_fault(scene, index, &mut fault)), SINS_OK);
                check_fault(&fault);
            }
            assert_eq!(call!(sins_scene_get_fault(scene, count, &mut fault)), SINS_ERROR_INVALID_ARGUMENT);
            assert_eq!(text_of(scene), None, "a text with faults was written");
        }
        status => panic!("sins_scene_parse answers {status}"),
    }
    scene
}

/// Reads a text: it is a log, and all its samples can be read, or it has a fault.
/// A judge finds the same in a log and in its samples.
fn check_judge(log: *const sins_log, samples: &[sins_flight_sample]) {
    let judges = [(); 2].map(|()| {
        let mut judge = null_mut();
        assert_eq!(call!(sins_judge_create(null(), &mut judge)), SINS_OK);
        judge
    });
    assert_eq!(call!(sins_judge_push_log(judges[0], log)), SINS_OK);
    for sample in samples {
        assert_eq!(call!(sins_judge_push(judges[1], sample)), SINS_OK);
    }
    let found = judges.map(|judge| {
        let (mut findings, mut count) = ([init::<sins_finding>(); SINS_FINDINGS_MAX], 0);
        let status =
            call!(sins_judge_get_findings(judge, findings.as_mut_ptr(), SINS_FINDINGS_MAX, &mut count));
        assert!(status == SINS_OK && count <= SINS_FINDINGS_MAX);
        assert_eq!(call!(sins_judge_destroy(judge)), SINS_OK);
        findings[..count].iter().for_each(|finding| check_finding(finding, samples.len() as u64));
        format!("{:?}", &findings[..count])
    });
    assert_eq!(found[0], found[1], "findings of a log and of its samples");
}

fn check_finding(finding: &sins_finding, samples: u64) {
    let sentence: Vec<u8> =
        finding.sentence.iter().map(|&byte| byte as u8).take_while(|&byte| byte != 0).collect();
    let is_sentence = std::str::from_utf8(&sentence).is_ok_and(|text| text.contains(". Remedy: "));
    let numbers = [finding.figure, finding.acceleration_m_s2, finding.ins_error_m];
    assert!(is_sentence && sentence.len() < finding.sentence.len(), "{finding:?}");
    assert!((SINS_LEVEL_NOTE..=SINS_LEVEL_UNUSABLE).contains(&finding.level), "{finding:?}");
    assert!(finding.sample < samples && numbers.iter().all(|number| number.is_finite()), "{finding:?}");
}

pub fn check_log(text: &[u8]) {
    let text = text.to_vec().into_boxed_slice();
    let (mut log, mut fault) = (null_mut(), init::<sins_fault>());
    let status = call!(sins_log_parse(text.as_ptr().cast(), text.len(), null(), &mut log, &mut fault));
    if status != SINS_OK {
        assert!(status == SINS_ERROR_INVALID_ARGUMENT && log.is_null());
        return check_fault(&fault);
    }
    let (mut info, mut line, mut last_s) = (init::<sins_log_info>(), 0, f64::NEG_INFINITY);
    assert_eq!(call!(sins_log_get_info(log, &mut info)), SINS_OK);
    assert!(info.samples >= 2 && info.duration_s > 0.0);
    let mut samples = Vec::new();
    for index in 0..info.samples as usize {
        let mut sample = Argument::of(&init::<sins_flight_sample>());
        let before = line;
        assert_eq!(call!(sins_log_get_sample(log, index, sample.pointer(), &mut line)), SINS_OK);
        assert!(sample.is_finite() && line >= before.max(1), "sample {index} of a log");
        let sample: sins_flight_sample = sample.value().expect("of this release");
        assert!(sample.time_s > last_s, "samples of a log in disorder");
        last_s = sample.time_s;
        samples.push(sample);
    }
    let mut copy = null_mut();
    let status = call!(sins_log_create(samples.as_ptr(), samples.len(), &mut copy));
    assert_eq!(status, SINS_OK, "a log of the samples of a log");
    check_judge(copy, &samples);
    check_identify(&samples);
    assert_eq!(call!(sins_log_destroy(copy)), SINS_OK);
    let status = call!(sins_log_get_sample(log, info.samples as usize, &mut init(), null_mut()));
    assert_eq!(status, SINS_ERROR_INVALID_ARGUMENT);
    assert_eq!(call!(sins_log_destroy(log)), SINS_OK);
    assert_eq!(call!(sins_log_destroy(log)), SINS_ERROR_BAD_HANDLE);
}

/// A value for a key, mostly of the kind that it takes.
fn some_value(input: &mut Input, takes: &str) -> String {
    let number = |input: &mut Input| match input.below(5) {
        0 => format!("{}", input.number()),
        2 => "0".to_owned(),
        1 => input.pick(&["1e308", "-0", "1e999", "0x10", "1_000", "nan", "+inf"]).to_owned(),
        _ => format!("{}", f64::from(input.byte() as i8) * 1e-2),
    };
    match input.below(16) {
        0 => input.pick(&["[", "\"\\uD800\"", "{ a = 1 }", "1979-05-27", "'x'", "[[1], [2]]", ""]).to_owned(),
        1 => format!("[{}, {}, {}]", number(input), number(input), number(input)),
        _ if takes.contains('|') => {
            let words: Vec<&str> = takes.split('|').collect();
            format!("\"{}\"", input.pick(&words))
        }
        _ if takes.starts_with("a text") => {
            input.pick(&["\"patrol\"", "\"a.csv\"", "'\u{fc}'", "\"\"", "\"rest\""]).to_owned()
        }
        _ if takes.starts_with("true") => input.pick(&["true", "false", "1"]).to_owned(),
        _ if takes.starts_with("a whole") => input.pick(&["1", "2", "7", "-1", "4096"]).to_owned(),
        _ if takes.contains("nine numbers row") || takes.starts_with("nine") => {
            let numbers: [String; 9] = std::array::from_fn(|_| number(input));
            format!("[{}]", numbers.join(", "))
        }
        _ if takes.starts_with("three") => {
            format!("[{}, {}, {}]", number(input), number(input), number(input))
        }
        _ => number(input),
    }
}

/// Values for a scene: existing keys, mostly with values of the kind that they take.
pub fn some_values(input: &mut Input) -> CString {
    let keys = keys();
    let mut text = String::new();
    for _ in 0..1 + input.below(4) {
        let key = &keys[input.word() as usize % keys.len()];
        let name = key.si_name.filter(|_| input.one_in(3)).unwrap_or(key.name);
        let item = input.below(3);
        let section = match key.section {
            "manoeuvre.sinusoid" => format!("manoeuvre[{item}].sinusoid[{}]", input.below(2)),
            section if key.is_list => format!("{section}[{item}]"),
            section => section.to_owned(),
        };
        let element = if input.one_in(4) { input.pick(&["[0]", "[2]", "[8]", "[99]"]) } else { "" };
        let value = if input.one_in(8) { String::new() } else { some_value(input, &key.takes) };
        text.push_str(&format!("{section}.{name}{element} = {value}\n"));
    }
    CString::new(altered(input, text.into_bytes()).into_iter().filter(|&byte| byte != 0).collect::<Vec<u8>>())
        .unwrap_or_default()
}

/// An item of a list with most of the keys that its kind has.
fn some_item(input: &mut Input) -> String {
    let section = input.pick(&["panel", "panel", "update", "failure", "manoeuvre"]);
    let keys = keys();
    let of_section: Vec<_> = keys.iter().filter(|key| key.section == section).collect();
    let mut text = format!("[[{section}]]\n");
    if section == "panel" {
        text = format!("[unit]\nstart = \"off\"\n{text}");
    }
    let mut kind = String::new();
    for key in of_section {
        if key.name == "kind" {
            kind = input.pick(&key.takes.split('|').collect::<Vec<_>>()).to_owned();
            text.push_str(&format!("kind = \"{kind}\"\n"));
        } else if (key.condition.is_empty() || key.condition.contains(&kind)) && !input.one_in(8) {
            text.push_str(&format!("{} = {}\n", key.name, some_value(input, &key.takes)));
        }
    }
    text
}

/// The text of a scene with some random keys, which are added to a built-in scene or to a short one. Sometimes some
/// bytes are altered.
pub fn some_scene(input: &mut Input) -> Vec<u8> {
    let keys = keys();
    let mut text = String::new();
    if input.byte() < 128 {
        text.push_str(input.pick(BUILTIN_SCENES).1);
    } else {
        text.push_str("[flight]\nbuiltin = \"patrol\"\n");
    }
    if input.one_in(3) {
        text.push_str(&some_item(input));
    }
    for _ in 0..input.below(6) {
        let key = &keys[input.word() as usize % keys.len()];
        let (open, close) = if key.is_list { ("[[", "]]") } else { ("[", "]") };
        text.push_str(&format!("{open}{}{close}\n", key.section));
        let name = key.si_name.filter(|_| input.one_in(3)).unwrap_or(key.name);
        text.push_str(&format!("{name} = {}\n", some_value(input, &key.takes)));
    }
    altered(input, text.into_bytes())
}

/// A log, mostly with as many values as columns.
pub fn some_log(input: &mut Input) -> Vec<u8> {
    let mut text =
        String::from("# title\ntime_s,latitude_deg,longitude_rad,height_m,roll_deg,pitch_deg,heading_deg");
    let more =
        input.pick(&["", ",temperature_c", ",velocity_east_m_s,velocity_north_m_s,velocity_up_m_s", ",x"]);
    text.push_str(more);
    for row in 0..input.below(16) {
        text.push_str(input.pick(&["\n", "\r\n", "\n#\n", "\n\n"]));
        text.push_str(&format!("{}", row as f64 * 0.01));
        for _ in 0..6 + more.matches(',').count() {
            let number = if input.one_in(32) { input.number() } else { f64::from(input.byte()) * 0.1 };
            text.push_str(&format!(",{number}"));
        }
    }
    altered(input, text.into_bytes())
}

fn altered(input: &mut Input, mut text: Vec<u8>) -> Vec<u8> {
    if input.one_in(4) {
        for _ in 0..1 + input.below(4) {
            if text.is_empty() {
                break;
            }
            let at = input.word() as usize % text.len();
            match input.below(4) {
                0 => text[at] = input.byte(),
                1 => text.insert(at, input.pick(b"\"'[]{}=,#\n\r\0\\.\xff\xc3")),
                2 => drop(text.remove(at)),
                _ => text.truncate(at.max(1)),
            }
        }
    }
    text
}
