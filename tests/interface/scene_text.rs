//! Scenes as texts: reading, writing, and the faults of a text.

use std::collections::BTreeSet;
use std::fs;

use sins::scene::{BUILTIN_SCENES, Fault, FlightSource, MAX_FAULTS, MAX_TEXT, Scene, keys};

use crate::support::draws::Draws;
use crate::support::project_file;
use crate::support::runs::unusual_options;

/// The text of an example scene.
fn example(name: &str) -> String {
    let folder = project_file("c_examples/scenes");
    fs::read_to_string(folder.join(name).with_extension("toml")).unwrap()
}

fn examples() -> Vec<String> {
    ["day", "drone", "fighter", "patrol", "resets", "trainer"].map(example).to_vec()
}

fn read(text: &str) -> Scene {
    Scene::parse(text.as_bytes()).unwrap_or_else(|faults| panic!("{faults:?}\n{text}"))
}

fn faults(text: &str) -> Vec<Fault> {
    Scene::parse(text.as_bytes()).err().unwrap_or_default()
}

#[test]
fn every_built_in_scene_is_read_and_has_a_flight() {
    for (name, text) in BUILTIN_SCENES {
        let scene = read(text);
        assert!(!scene.title.is_empty(), "{name}");
        let flight = scene.flight().unwrap();
        assert!((60.0..=flight.duration_s()).contains(&scene.flown_s().unwrap()), "{name}");
        assert!(scene.simulator().is_ok(), "{name}");
        let named = read(&format!("[flight]\nbuiltin = \"{name}\"\n"));
        assert_eq!(named.flown_s(), scene.flown_s(), "{name} as the flight of another scene");
    }
}

/// The sentences with their lines.
fn reported(text: &str) -> Vec<(usize, String)> {
    faults(text).into_iter().map(|fault| (fault.line, fault.sentence)).collect()
}

#[test]
fn a_scene_that_is_written_reads_back_to_the_bit() {
    let built_in = BUILTIN_SCENES.iter().map(|(_, text)| (*text).to_owned());
    for text in examples().into_iter().chain(built_in) {
        let scene = read(&text);
        let written = scene.write();
        assert_eq!(read(&written), scene, "{written}");
        assert_eq!(read(&written).write(), written);
    }
}

/// An option without a key is lost when a scene is written. The compiler asks for each option in `unusual_options`.
#[test]
fn every_option_has_a_key() {
    let flight = FlightSource::Log("a.csv".to_owned()); // only the samples of a log have a stated period
    let scene = Scene { flight, options: unusual_options(), ..Scene::default() };
    assert_eq!(read(&scene.write()).options, scene.options);
}

/// Any size from 1e-12 to 1e3, with all digits.
fn any_size(draws: &mut Draws) -> f64 {
    draws.of(&[-1.0, 1.0]) * 10f64.powf(-12.0 + 15.0 * draws.unit())
}

/// The text before and after the line of a key, such that the key is valid.
fn around(section: &str, name: &str) -> (String, String) {
    const REST: &str = "[[manoeuvre]]\nkind = \"rest\"\nduration_s = 10\n";
    let flying = |manoeuvre: &str| format!("[flight]\nspeed_m_s = 200\n[[manoeuvre]]\nkind = {manoeuvre}\n");
    let failing = |failure: &str| format!("[flight]\nbuiltin = \"rest\"\n[[failure]]\nsensor = {failure}\n");
    let before = match (section, name) {
        ("manoeuvre", "duration_s") => flying("\"straight\""),
        ("manoeuvre", "ramp_s") => flying("\"climb\"\nduration_s = 1e4\nheight_change_m = 10"),
        ("manoeuvre", "height_change_m") => flying("\"climb\"\nduration_s = 1e5"),
        ("manoeuvre", "speed_change_m_s") => flying("\"accelerate\"\nduration_s = 1e3"),
        ("manoeuvre", "heading_change_deg") => flying("\"turn\"\nbank_deg = 20"),
        ("manoeuvre", "bank_deg") => flying("\"turn\"\nheading_change_deg = 90"),
        ("manoeuvre", "turns") => flying("\"roll\"\nduration_s = 1e3"),
        ("manoeuvre.sinusoid", _) => {
            let terms = match name {
                "amplitude_m_s" => "channel = \"speed\"\nfrequency_hz = 0.1",
                "amplitude_deg" => "channel = \"roll\"\nfrequency_hz = 0.1",
                "frequency_hz" => "channel = \"roll\"\namplitude_deg = 1",
                _ => "channel = \"roll\"\namplitude_deg = 1\nfrequency_hz = 0.1",
            };
            flying(&format!("\"sinusoids\"\nduration_s = 1e3\n[[manoeuvre.sinusoid]]\n{terms}"))
        }
        ("failure", "size_deg_h") => failing("\"gyro\"\naxis = \"y\"\nkind = \"bias_step\""),
        ("failure", "size_micro_g") => failing("\"accelerometer\"\naxis = \"y\"\nkind = \"bias_step\""),
        ("failure", "size_m") => failing("\"altimeter\"\nkind = \"bias_step\""),
        ("failure", "density_deg_sqrt_h") => failing("\"gyro\"\naxis = \"z\"\nkind = \"noise\""),
        ("failure", "density_micro_g_sqrt_hz") => {
            failing("\"accelerometer\"\naxis = \"z\"\nkind = \"noise\"")
        }
        ("failure", "density_m_sqrt_hz") => failing("\"altimeter\"\nkind = \"noise\""),
        ("failure", "interval_s" | "probability") => failing("\"gyro\"\naxis = \"x\"\nkind = \"drop_outs\""),
        ("failure", "duration_s") => {
            failing("\"gyro\"\naxis = \"x\"\nkind = \"spikes\"\nsize_deg_h = 1\ninterval_s = 1e3")
        }
        ("failure", _) => failing("\"gyro\"\naxis = \"x\"\nkind = \"dead\""),
        ("update", name) => {
            let kind = if name == "sigma_m_s" { "velocity" } else { "position" };
            let at_s = if name == "at_s" { "" } else { "at_s = 1\n" };
            format!("[flight]\nbuiltin = \"rest\"\n[[update]]\nkind = \"{kind}\"\n{at_s}")
        }
        ("panel", name) => {
            let entered = match name {
                "latitude_deg" => "\"position\"\nat_s = 1\nlongitude_deg = 1\n",
                "longitude_deg" => "\"position\"\nat_s = 1\nlatitude_deg = 1\n",
                "heading_deg" => "\"heading\"\nat_s = 1\n",
                _ => "\"nav\"\n",
            };
            format!("[flight]\nbuiltin = \"rest\"\n[unit]\nstart = \"off\"\n[[panel]]\nkind = {entered}")
        }
        (_, "sample_period_s") => "[flight]\nfile = \"a.csv\"\n[options]\n".to_owned(),
        (_, name) => {
            let needed = match name {
                "temperature_change_c_h" => "temperature_c = 20\n",
                "markov_sigma_m" | "markov_sigma_deg_h" | "markov_sigma_micro_g" => "markov_time_s = 1\n",
                "closed_loop_time_s" => "signal = \"closed-loop\"\n",
                _ if name.starts_with("deflection_north_sigma") => "deflection_north_distance_km = 1\n",
                _ if name.starts_with("deflection_east_sigma") => "deflection_east_distance_km = 1\n",
                _ if name.starts_with("anomaly_sigma") => "anomaly_distance_km = 1\n",
                _ => "",
            };
            format!("[{section}]\n{needed}")
        }
    };
    let behind = match name {
        "sample_period_s" => "",
        _ if before.contains("[[") || before.contains("builtin") => "",
        "speed_m_s" => "[[manoeuvre]]\nkind = \"straight\"\nduration_s = 10\n",
        "hours" => "[[manoeuvre]]\nkind = \"rest\"\nduration_s = 1e8\n",
        _ => REST,
    };
    (before, behind.to_owned())
}

/// Each key of a number, in its unit and in SI, with up to 50 accepted values of all digits. An accepted value is written
/// and read again to the same scene. At least ten values of each key must be accepted, so that the test covers every key.
#[test]
fn every_key_is_read_written_and_read_again_to_the_same_value() {
    let mut draws = Draws::new(1);
    for key in keys().into_iter().filter(|key| key.takes.contains("number")) {
        let (before, behind) = around(key.section, key.name);
        for name in [Some(key.name), key.si_name].into_iter().flatten() {
            let mut accepted = 0;
            // 0 and the limits may be refused: with this context the value may not be 0, or the scene would be too long.
            let ends = key.limits.map_or([0.0; 2], |limits| {
                let unit = if Some(name) == key.si_name { key.unit_si } else { 1.0 };
                [limits.low * unit, limits.high * unit]
            });
            let special = [0.0, -0.0, ends[0], ends[1]];
            for round in 0..400 {
                let mut value = special.get(round).copied().unwrap_or_else(|| any_size(&mut draws).abs());
                // A roll needs whole turns: it ends with the roll angle of its begin.
                if round >= special.len() && (key.takes == "a whole number" || key.name == "turns") {
                    value = 1.0 + (round % 5) as f64;
                }
                let text = match key.takes.as_str() {
                    takes if takes.starts_with("three") => format!("[{value:?}, {:?}, 0]", -value),
                    takes if takes.starts_with("nine") => {
                        format!("[{value:?}, 0, 0, 0, {:?}, 0, 0, 0, {value:?}]", -value)
                    }
                    "a whole number" => value.to_string(),
                    _ => format!("{value:?}"),
                };
                let text = format!("{before}{name} = {text}\n{behind}");
                let Ok(scene) = Scene::parse(text.as_bytes()) else { continue };
                accepted += 1;
                let written = scene.write();
                assert_eq!(read(&written), scene, "{text}\n{written}");
                if accepted == 50 {
                    break;
                }
            }
            assert!(
                accepted >= 10,
                "{}.{name}: {accepted}; {:?}",
                key.section,
                reported(&format!("{before}{name} = 1\n{behind}"))
            );
        }
    }
}

#[test]
fn every_word_of_every_choice_is_read_and_written() {
    for key in keys().into_iter().filter(|key| key.takes.contains('|') && !key.is_list) {
        let words: BTreeSet<&str> = key.takes.split('|').collect();
        let mut scenes: Vec<Scene> = Vec::new();
        for word in &words {
            let text =
                format!("[flight]\nbuiltin = \"rest\"\n[{}]\n{} = \"{word}\"\n", key.section, key.name);
            let scene = read(&text);
            assert_eq!(read(&scene.write()), scene, "{text}");
            // The paper states no errors of the start; two grades start alike.
            let is_another =
                (key.section, key.name) == ("start", "preset") && ["paper2", "strategic"].contains(word);
            assert_eq!(scenes.contains(&scene), is_another, "{text}: a word without effect");
            scenes.push(scene);
        }
    }
}

/// A number is quoted as it was written, also where it is infinite in SI, and beside its limits.
#[test]
fn the_largest_numbers_are_rejected_as_written() {
    for (key, limits) in
        [("hours", "1e-5 to 100000"), ("rate_hz", "0.001 to 20000"), ("latitude_deg", "-90 to 90")]
    {
        for value in ["1e308", "-1e308"] {
            let text = format!(
                "[flight]\nlatitude_deg = 0\nlongitude_deg = 0\nheight_m = 0\n{key} = {value}\n[[manoeuvre]]\nkind = \"rest\"\nduration_s = 10\n"
            );
            let text = if key == "latitude_deg" { text.replacen("latitude_deg = 0\n", "", 1) } else { text };
            let faults = reported(&text);
            assert_eq!(faults[0].1, format!("flight.{key} = {value}: must be from {limits}"));
        }
    }
    for value in ["1e400", "-inf", "nan"] {
        let faults = reported(&format!("[flight]\nbuiltin = \"rest\"\nhours = {value}\n"));
        assert_eq!(faults, [(3, format!("flight.hours = {value}: expected a number [h]"))]);
    }
    let mut scene = Scene::parse(b"[flight]\nbuiltin = \"rest\"\n").unwrap();
    let faults = scene.set(&[("flight.hours", "1e308")]).unwrap_err();
    assert_eq!(faults[0].sentence, "flight.hours = 1e308: must be from 1e-5 to 100000");
}

/// Whole numbers keep every digit, in the value and in its limits.
#[test]
fn whole_numbers_are_rejected_with_every_digit() {
    let most = "expected a whole number from 0 to 18446744073709551615";
    for (setting, words) in [
        ("seed = 18446744073709551616", most),
        ("run = -9223372036854775809", most),
        ("seed = 1.5", most),
        ("subsamples = 2.5", "expected a whole number from 1 to 5"),
    ] {
        let faults = reported(&format!("[flight]\nbuiltin = \"rest\"\n[options]\n{setting}\n"));
        assert_eq!(faults, [(4, format!("options.{setting}: {words}"))]);
    }
}

#[test]
fn a_file_with_several_faults_gets_them_all_with_their_lines() {
    let text = "[flight]\nbuiltin = \"rest\"\n\n[gyro]\nbias_deg_hour = 3\nrange_deg_s = -1\nmarkov_sigma_deg_h = [1, 2]\n\
                bias_deg_h = [0, 1e9, 0]\n[options]\nscheme = \"fast\"\nsubsamples = 9\n[altimter]\nbias_m = 2\n";
    assert_eq!(
        reported(text),
        [
            (5, "no such key: bias_deg_hour; did you mean bias_deg_h?".to_owned()),
            (6, "gyro.range_deg_s[0] = -1: must be 0 for none, or from 5.72958e-8 to 5.72957e7".to_owned()),
            (
                7,
                "gyro.markov_sigma_deg_h = an array of 2: expected one number for all axes, or three [deg/h]"
                    .to_owned()
            ),
            (8, "gyro.bias_deg_h[1] = 1e9: must be from -2.06264e7 to 2.06264e7".to_owned()),
            (10, "options.scheme = \"fast\": expected exact, paper, polynomial".to_owned()),
            (11, "options.subsamples = 9: must be from 1 to 5".to_owned()),
            (12, "no such section: altimter; did you mean altimeter?".to_owned()),
        ]
    );
}

#[test]
fn what_does_not_go_together_is_told() {
    let one = |text: &str, line: usize, words: &str| {
        let faults = reported(text);
        assert!(
            faults.len() == 1 && faults[0].0 == line && faults[0].1.contains(words),
            "{text}: {faults:?}, expected {words}"
        );
    };
    let flight = "[flight]\nbuiltin = \"patrol\"\n";
    one("", 1, "expected a flight");
    one("[flight]\nbuiltin = \"patrol\"\nfile = \"log.csv\"\n", 1, "only one of");
    one("[flight]\nbuiltin = \"petrol\"\n", 2, "no such flight; did you mean patrol?");
    one("[flight]\nfile = \"a.csv\"\nrate_hz = 10\n", 3, "its own time stamps");
    one(&format!("{flight}latitude_deg = 3\n"), 3, "has its own start");
    one(&format!("{flight}temperature_change_c_h = 3\n"), 3, "only together with temperature_c");
    one(&format!("{flight}[options]\nvertical = \"free\"\n[altimeter]\nbias_m = 1\n"), 5, "damped");
    one(&format!("{flight}[options]\nclosed_loop_time_s = 40\n"), 4, "signal");
    one(&format!("{flight}[options]\nsample_period_s = 0.01\n"), 4, "only for a log");
    one(&format!("{flight}[gyro]\nbias_deg_h = 1\nbias_rad_s = 1e-6\n"), 5, "the same quantity");
    one(&format!("{flight}[gyro]\nmarkov_sigma_deg_h = 1\n"), 3, "markov_time_s");
    one(&format!("{flight}[output]\nname = \"a/b\"\n"), 4, "folder");
    one(&format!("{flight}hours = 49\n"), 3, "must be at most the duration of the flight: 48");
    one("loose = 1\n[flight]\nbuiltin = \"rest\"\n", 1, "a [section] before it");
    let manoeuvre = |keys: &str| format!("[[manoeuvre]]\n{keys}");
    one(&manoeuvre("duration_s = 3\n"), 1, "expected its kind");
    one(&manoeuvre("kind = \"rest\"\nduration_s = 3\nbank_deg = 3\n"), 4, "rest does not use it");
    one(&manoeuvre("kind = \"turn\"\nheading_change_deg = 90\nbank_deg = 20\n"), 1, "accelerate first");
    let failure = |keys: &str| format!("{flight}[[failure]]\n{keys}");
    one(&failure("sensor = \"gyro\"\naxis = \"x\"\n"), 3, "expected its kind");
    one(&failure("sensor = \"gyro\"\nkind = \"dead\"\n"), 3, "expected its axis");
    one(
        &failure("sensor = \"gyro\"\naxis = \"x\"\nkind = \"bias_step\"\nsize_m = 3\n"),
        7,
        "expected size_deg_h",
    );
    one(
        &failure("sensor = \"gyro\"\naxis = \"x\"\nkind = \"dead\"\nsize_deg_h = 3\n"),
        7,
        "dead does not use it",
    );
    let update = |keys: &str| format!("{flight}[[update]]\n{keys}");
    one(&update("at_s = 3\n"), 3, "expected its kind");
    one(&update("kind = \"velocity\"\n"), 3, "expected its at_s");
    one(&update("kind = \"velocity\"\nat_s = 3\nsigma_m = 3\n"), 6, "expected sigma_m_s");
    one(&update("kind = \"position\"\nat_s = 0\n"), 5, "update.at_s = 0: must be from 0.0001 to 1e9");
    one(&update("kind = \"position\"\nat_s = 3\nevery_s = -1\n"), 6, "update.every_s = -1: must be");
    one(
        &update("kind = \"position\"\nat_s = 3\nsigma_m = [0, -1, 0]\n"),
        6,
        "update.sigma_m[1] = -1: must be",
    );
    let panel = |keys: &str| format!("{flight}[unit]\nstart = \"off\"\n[[panel]]\n{keys}");
    one(&panel("at_s = 3\n"), 5, "expected its kind");
    one(&panel("kind = \"nav\"\n"), 5, "expected its at_s");
    one(&panel("kind = \"position\"\nat_s = 3\nlatitude_deg = 4\n"), 5, "expected its longitude_deg");
    one(&panel("kind = \"nav\"\nat_s = 3\nheading_deg = 4\n"), 8, "panel.heading_deg: not for this kind");
    one(
        &panel("kind = \"heading\"\nat_s = 3\nheading_deg = 400\n"),
        8,
        "panel.heading_deg = 400: must be from -360 to 360",
    );
    one(
        &format!("{flight}[[panel]]\nkind = \"nav\"\nat_s = 3\n"),
        3,
        "panel: needs a unit: unit.start must be off or nav",
    );
    one(
        &format!("{flight}[unit]\nerection_s = -3\n"),
        4,
        "unit.erection_s = -3: must be 0 for the default, or from",
    );
    let twice = "[[failure]]\nsensor = \"gyro\"\naxis = \"x\"\nkind = \"dead\"\nfrom_s = 3\n";
    one(&format!("{flight}{twice}{twice}"), 8, "overlaps");
    one(
        &failure("sensor = \"altimeter\"\nkind = \"dead\"\nfrom_s = 4\nuntil_s = 4\n"),
        7,
        "more than from_s = 4",
    );
}

#[test]
fn any_bytes_have_an_answer() {
    let reported = |bytes: &[u8]| Scene::parse(bytes).unwrap_err();
    assert_eq!(reported(b"[flight]\n\xff\n")[0].line, 2);
    assert!(reported(&vec![b'#'; MAX_TEXT + 1])[0].sentence.contains("at most"));
    let deep = format!("[gyro]\nbias_deg_h = {}1{}\n", "[".repeat(100_000), "]".repeat(100_000));
    assert!(!reported(deep.as_bytes()).is_empty());
    let tables = format!("[{}a]\n", "a.".repeat(50_000));
    assert!(!reported(tables.as_bytes()).is_empty());
    let many = "x = 1\n".repeat(1000).replace('x', "[[failure]]\nx");
    assert!(reported(many.as_bytes()).len() <= MAX_FAULTS);
    for number in ["1e999", "-1e999", "inf", "nan", "99999999999999999999999999", "0x7fffffffffffffffffff"] {
        let text = format!("[flight]\nbuiltin = \"rest\"\n[gyro]\nbias_rad_s = {number}\n");
        assert!(!reported(text.as_bytes()).is_empty(), "{number}");
    }
    assert!(!reported(b"[flight]\nbuiltin = \"rest\x00\"\n").is_empty());
    let marked = "\u{feff}[flight]\r\nbuiltin = \"rest\"\r\n";
    assert_eq!(read(marked).flight, FlightSource::Builtin("rest".to_owned()));
}

/// Each example text with one byte altered, removed or doubled, 8000 texts in all. Each text has an answer, and an
/// accepted scene is written and read again.
#[test]
fn altered_texts_have_an_answer() {
    let mut draws = Draws::new(2);
    for text in examples() {
        for _ in 0..2_000 {
            let mut bytes = text.clone().into_bytes();
            let at = draws.next() as usize % bytes.len();
            match draws.next() % 3 {
                0 => bytes[at] = draws.next() as u8,
                1 => drop(bytes.remove(at)),
                _ => bytes.insert(at, bytes[at]),
            }
            if let Ok(scene) = Scene::parse(&bytes) {
                assert_eq!(read(&scene.write()), scene);
            }
        }
    }
}
