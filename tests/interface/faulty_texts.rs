//! Unusual and faulty texts, through the C functions. Each has an answer in bounded time.

use std::ffi::CStr;
use std::ptr::{null, null_mut};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use sins::abi::*;
use sins::scene::{MAX_FAULTS, MAX_TEXT};

use crate::support::init;

/// Limit of the time for any text, also on a slow machine. The longest case reads 100 MB once.
const LONGEST: Duration = Duration::from_secs(30);

/// Processor time of this thread, because other tests run in parallel. If the system does not report it, the time of day.
fn time_of_thread() -> Duration {
    let statistics = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    match statistics.split(' ').next().and_then(|ran_ns| ran_ns.parse().ok()) {
        Some(ran_ns) => Duration::from_nanos(ran_ns),
        None => SystemTime::now().duration_since(UNIX_EPOCH).unwrap(),
    }
}

fn sentence(fault: &sins_fault) -> String {
    // SAFETY: terminated, as the header says.
    unsafe { CStr::from_ptr(fault.sentence.as_ptr()) }.to_str().unwrap().to_owned()
}

/// The faults of a scene: line, column, sentence. A text without faults is a scene and can be written.
fn faults(name: &str, text: &[u8]) -> Vec<(u64, u64, String)> {
    let begin = time_of_thread();
    let (mut scene, mut fault, mut faults) = (null_mut(), init::<sins_fault>(), Vec::new());
    // SAFETY: a text with its size, living handles, structs of the interface.
    unsafe {
        let status = sins_scene_parse(text.as_ptr().cast(), text.len(), &mut scene);
        while sins_scene_get_fault(scene, faults.len(), &mut fault) == SINS_OK {
            faults.push((fault.line, fault.column, sentence(&fault)));
        }
        assert_eq!(status, if faults.is_empty() { SINS_OK } else { SINS_SCENE_HAS_FAULTS }, "{name}");
        assert!(faults.len() <= MAX_FAULTS, "{name}");
        let status = sins_scene_write(scene, null_mut(), 0, &mut 0);
        assert_eq!(status, if faults.is_empty() { SINS_OK } else { SINS_ERROR_BAD_STATE }, "{name}");
        assert_eq!(sins_scene_destroy(scene), SINS_OK);
    }
    let taken = time_of_thread() - begin;
    println!("{name}: {} bytes, {} faults, {taken:.2?}", text.len(), faults.len());
    assert!(taken < LONGEST, "{name}: {taken:?}");
    faults
}

/// The fault of a log: line, column, sentence. `None` if the text is a log.
fn log_fault(name: &str, text: &[u8]) -> Option<(u64, u64, String)> {
    let begin = time_of_thread();
    let (mut log, mut fault) = (null_mut(), init::<sins_fault>());
    // SAFETY: a text with its size, a place for the handle, a struct of the interface.
    let status = unsafe { sins_log_parse(text.as_ptr().cast(), text.len(), null(), &mut log, &mut fault) };
    let taken = time_of_thread() - begin;
    println!("{name}: {} bytes, status {status}, {taken:.2?}", text.len());
    assert!(taken < LONGEST, "{name}: {taken:?}");
    if status == SINS_OK {
        // SAFETY: a living handle.
        assert_eq!(unsafe { sins_log_destroy(log) }, SINS_OK);
        return None;
    }
    assert_eq!((status, log.is_null(), fault.count), (SINS_ERROR_INVALID_ARGUMENT, true, 1), "{name}");
    Some((fault.line, fault.column, sentence(&fault)))
}

/// `begin`, and then `unit` as often as a scene's text has room for.
fn full(begin: &str, unit: &str) -> Vec<u8> {
    let mut text = begin.to_owned();
    while text.len() + unit.len() <= MAX_TEXT {
        text.push_str(unit);
    }
    text.into_bytes()
}

const REST: &str = "[flight]\nbuiltin = \"rest\"\n";

#[test]
fn nesting_has_an_answer() {
    for (begin, unit) in
        [("a = ", "["), ("a = ", "{ a = "), ("", "a."), ("[", "a."), ("a = [", "[],"), ("", "[[a]]\n")]
    {
        assert!(!faults(&format!("{begin}{unit}..."), &full(begin, unit)).is_empty());
    }
}

#[test]
fn numbers_of_any_size_are_read_or_refused() {
    let digits = "9".repeat(100_000);
    for number in [
        "1e999",
        "-1e999",
        "1e99999999999999999999",
        "inf",
        "nan",
        &digits,
        &format!("0x{digits}"),
        &format!("1e{digits}"),
        &format!("{digits}.0"),
        "1_0_",
        "1.",
        ".5",
        "00",
        "1e",
    ] {
        let text = format!("{REST}[gyro]\nbias_deg_h = {number}\n");
        let found = faults(&number[..number.len().min(20)], text.as_bytes());
        assert_eq!(found[0].0, 4, "{found:?}");
    }
    for number in ["1e-999", &format!("0.{}1", "0".repeat(100_000)), "-0", "0x10", "1_0", "1e-30"] {
        let text = format!("{REST}[gyro]\nbias_deg_h = {number}\n");
        assert_eq!(faults(&number[..number.len().min(20)], text.as_bytes()), [], "{number}");
    }
}

#[test]
fn bytes_that_are_no_text_are_told_with_their_line() {
    for (name, bytes, line) in [
        ("a zero byte", &b"\0"[..], 3),
        ("invalid UTF-8", b"a = \"\xff\"", 3),
        ("an overlong slash", b"# \xc0\xaf", 3),
        ("a surrogate in UTF-8", b"# \xed\xa0\x80", 3),
        ("an escaped surrogate", b"[output]\nname = \"\\uD800\"", 4),
        ("an escape beyond Unicode", b"[output]\nname = \"\\U00110000\"", 4),
        ("a carriage return alone", b"a = 1\rb = 2", 3),
        ("a second mark", b"\xef\xbb\xbf", 3),
        ("a text without an end", b"[output]\nname = \"a", 4),
    ] {
        let text = [REST.as_bytes(), bytes, b"\n"].concat();
        let found = faults(name, &text);
        assert_eq!(found[0].0, line, "{name}: {found:?}");
    }
    let marked = [b"\xef\xbb\xbf", REST.replace('\n', "\r\n").as_bytes()].concat();
    assert_eq!(faults("a mark and CRLF", &marked), []);
    assert!(!faults("nothing", b"").is_empty());
    assert!(!faults("a mark alone", b"\xef\xbb\xbf").is_empty());
}

#[test]
fn three_faults_are_told_each_at_its_place() {
    let text = format!("{REST}[gyro]\nbias_deg_hour = 1\n  range_deg_s = -1\n[options]\nscheme = \"fast\"\n");
    let expected = [
        (4, 1, "no such key: bias_deg_hour; did you mean bias_deg_h?"),
        (5, 3, "gyro.range_deg_s[0] = -1: must be 0 for none, or from 5.72958e-8 to 5.72957e7"),
        (7, 10, "options.scheme = \"fast\": expected exact, paper, polynomial"),
    ];
    assert_eq!(
        faults("three faults", text.as_bytes()),
        expected.map(|(line, column, words)| (line, column, words.to_owned()))
    );
}

#[test]
fn a_full_text_has_an_answer() {
    let numbered = |begin: &str, line: &dyn Fn(usize) -> String| {
        let mut text = begin.to_owned();
        (0..)
            .map(line)
            .take_while(|line| {
                text.len() + line.len() <= MAX_TEXT && {
                    text.push_str(line);
                    true
                }
            })
            .for_each(drop);
        text.into_bytes()
    };
    let texts = [
        ("one key twice and again", full("[gyro]\n", "bias_deg_h = 1\n")),
        ("unknown keys", numbered("[gyro]\n", &|k| format!("bias_deg_{k} = 1\n"))),
        ("unknown sections", numbered("", &|k| format!("[gyro{k}]\n"))),
        ("loose keys", numbered("", &|k| format!("k{k} = 1\n"))),
        ("a section twice and again", full("", "[gyro]\n")),
        ("failures", full(REST, "[[failure]]\n")),
        (
            "failures that overlap",
            full(REST, "[[failure]]\nsensor = \"gyro\"\naxis = \"x\"\nkind = \"dead\"\n"),
        ),
        (
            "failures without an end of them",
            numbered(REST, &|k| {
                format!(
                    "[[failure]]\nsensor=\"gyro\"\naxis=\"x\"\nkind=\"dead\"\nfrom_s={k}\nuntil_s={}\n",
                    k + 1
                )
            }),
        ),
        ("manoeuvres", full("", "[[manoeuvre]]\nkind = \"rest\"\nduration_s = 1\n")),
        ("sinusoids", full("[[manoeuvre]]\nkind = \"sinusoids\"\n", "[[manoeuvre.sinusoid]]\n")),
        ("a long key", full(REST, "a")),
        ("a long array", full("[gyro]\nbias_deg_h = [", "1,")),
        ("a long word", full("[options]\nscheme = \"", "x")),
        ("quotes", full("", "\"")),
        ("brackets", full("", "]")),
    ];
    for (name, text) in texts {
        assert!(!faults(name, &text).is_empty(), "{name}");
    }
    let begin = "[flight]\ntitle = \"";
    let title = [&full(begin, "x")[..MAX_TEXT - 40], b"\"\nbuiltin = \"rest\"\n"].concat();
    assert!(faults("a long title", &title).iter().any(|fault| fault.2.contains("a text has at most 4096")));
    let rests = "[[manoeuvre]]\nkind = \"rest\"\nduration_s = 1\n".repeat(4096);
    let repeated = format!("[flight]\nrepeat = 4096\n{rests}");
    assert!(faults("4096 times 4096 manoeuvres", repeated.as_bytes())[0].2.contains("repeat"));
    assert_eq!(faults("4096 manoeuvres", rests.as_bytes()), []);
    let keys = (0..1_000_000).map(|k| format!("k{k} = 1\n")).collect::<String>();
    assert!(faults("a million keys", keys.as_bytes())[0].2.contains("at most"));
    assert!(faults("100 MB", &vec![b'#'; 100 << 20])[0].2.contains("at most"));
    // SAFETY: the function does not read through a null pointer.
    assert_eq!(unsafe { sins_scene_parse(null(), usize::MAX, &mut null_mut()) }, SINS_ERROR_NULL_POINTER);
}

const HEADER: &str = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n";

#[test]
fn a_log_of_any_bytes_has_an_answer() {
    let reported = |name: &str, text: &[u8]| log_fault(name, text).unwrap_or_else(|| panic!("{name}: a log"));
    let long = 100 << 20;
    assert!(reported("one line of 100 MB", &vec![b'1'; long]).2.contains("at most"));
    assert!(reported("one line of 100 MB of commas", &vec![b','; long]).2.contains("at most"));
    assert!(reported("100 MB of ends of lines", &vec![b'\n'; long]).2.contains("no header"));
    assert!(reported("100 MB of comments", &b"# x\n".repeat(long / 4)).2.contains("no header"));
    assert!(reported("100 MB of quotes", &b"\"\n".repeat(long / 2)).0 >= 1);
    assert!(reported("100 MB of zero bytes", &vec![0; long]).2.contains("is a binary file"));
    assert!(reported("many columns", &[b"x,".repeat(30_000), b"\n".to_vec()].concat()).2.contains("columns"));
    let row = |time: &str| format!("{HEADER}0,1,2,3,4,5,6\n{time},1,2,3,4,5,6\n").into_bytes();
    for time in ["1e999", "nan", "inf", "", "0", "-1", "0x1", "1,5", "\u{661}"] {
        assert!(reported(time, &row(time)).0 == 3, "{time}");
    }
    assert_eq!(log_fault("a long number", &row(&format!("0.{}", "9".repeat(300)))), None);
    assert_eq!(reported("invalid UTF-8", &[HEADER.as_bytes(), b"0,1,2,\xff,4,5,6\n"].concat()).0, 2);
    assert_eq!(reported("a zero byte", &[HEADER.as_bytes(), b"0,1,2,\0,4,5,6\n"].concat()).0, 2);
    let crlf =
        [b"\xef\xbb\xbf", String::from_utf8(row("1")).unwrap().replace('\n', "\r\n").as_bytes()].concat();
    assert_eq!(log_fault("a mark and CRLF", &crlf), None);
    let rows = (0..1_000_000).map(|k| format!("{k},1,2,3,4,5,6\n")).collect::<String>();
    assert_eq!(log_fault("a million rows", [HEADER, &rows].concat().as_bytes()), None);
    assert!(time_of_thread() > Duration::ZERO, "the time of a thread stands still: nothing was limited");
}
