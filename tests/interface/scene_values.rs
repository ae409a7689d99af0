//! Scenes key by key: the keys as data, values read and set by their paths, items of lists.

use std::collections::BTreeSet;
use std::ffi::{CStr, CString, c_char};
use std::ptr::null_mut;

use sins::abi::*;
use sins::scene::{BUILTIN_SCENES, Fault, FlightSource, KeyKind, KeyLine, Scene, builtin, keys};

use crate::support::{init, project_file, text};

const MANOEUVRES: &str = "\
[[manoeuvre]]
kind = \"accelerate\"
duration_s = 30
speed_change_m_s = 100

[[manoeuvre]]
kind = \"turn\"
heading_change_deg = 90
bank_deg = 30

[[manoeuvre]]
kind = \"sinusoids\"
duration_s = 100

[[manoeuvre.sinusoid]]
channel = \"course\"
amplitude_deg = 10
frequency_hz = 0.1

[[manoeuvre.sinusoid]]
channel = \"roll\"
amplitude_deg = 5
frequency_hz = 0.5

[[failure]]
sensor = \"gyro\"
axis = \"z\"
kind = \"bias_step\"
from_s = 20
size_deg_h = 3

[[update]]
kind = \"velocity\"
at_s = 20
sigma_m_s = [0.1, 0.1, 0]

[unit]
start = \"off\"

[[panel]]
kind = \"position\"
at_s = 20
latitude_deg = 40
longitude_deg = 7
";

fn scene() -> Scene {
    Scene::parse(MANOEUVRES.as_bytes()).unwrap()
}

fn path_of(key: &KeyLine) -> String {
    let section = match key.section {
        "manoeuvre" => "manoeuvre[1]",
        "manoeuvre.sinusoid" => "manoeuvre[2].sinusoid[1]",
        "failure" => "failure[0]",
        "update" => "update[0]",
        "panel" => "panel[0]",
        section => section,
    };
    format!("{section}.{}", key.name)
}

/// Paths and sentences of faults.
fn reported(faults: Vec<Fault>) -> Vec<(String, String)> {
    faults.into_iter().map(|fault| (fault.about.path, fault.sentence)).collect()
}

#[test]
fn values_are_read_by_their_paths() {
    let mut scene = scene();
    scene.set(&[("gyro.bias_deg_h", "[1, 0.1, 0]"), ("flight.title", "a \"b\" # c")]).unwrap();
    for (path, value) in [
        ("gyro.bias_deg_h", "[1, 0.1, 0]"),
        ("gyro.bias_deg_h[1]", "0.1"),
        ("accelerometer.misalignment_arcsec", "0"),
        ("options.scheme", "\"exact\""),
        ("options.subsamples", "2"),
        ("output.quiet", "false"),
        ("flight.rate_hz", "100"),
        ("flight.hours", ""),
        ("flight.file", ""),
        ("flight.title", "\"a \\\"b\\\" # c\""),
        ("manoeuvre[1].bank_deg", "30"),
        ("manoeuvre[1].ramp_s", "5"),
        ("manoeuvre[2].sinusoid[1].channel", "\"roll\""),
        ("failure[0].size_deg_h", "3"),
        ("failure[0].until_s", ""),
        ("update[0].sigma_m_s", "[0.1, 0.1, 0]"),
        ("update[0].sigma_m", ""),
        ("update[0].every_s", ""),
        ("panel[0].longitude_deg", "7"),
        ("panel[0].heading_deg", ""),
        ("unit.erection_s", "0"),
    ] {
        assert_eq!(scene.value(path).as_deref(), Some(value), "{path}");
    }
    let bias = scene.value("gyro.bias_rad_s[0]").unwrap().parse::<f64>().unwrap();
    assert_eq!(bias, scene.errors.gyro.bias.x);
    for path in [
        "",
        "gyro",
        "manoeuvre[3]",
        "manoeuvre[2].sinusoid[2].channel",
        "failure[1].kind",
        "gyro.bias_deg_h[3]",
    ] {
        assert_eq!(scene.value(path), None, "{path}");
    }
}

/// Each value of each scene is set to what was read, in its unit and in SI. The scene does not change. A value that the scene does
/// not have is read as an empty text.
#[test]
fn every_value_that_is_read_can_be_set() {
    let mut scenes: Vec<Scene> = BUILTIN_SCENES.iter().map(|(name, _)| builtin(name).unwrap()).collect();
    scenes.push(scene());
    for (kind, quantity) in [
        ("drop_outs", "probability = 0.1"),
        ("drop_outs", "interval_s = 2"),
        ("noise", "density_m_sqrt_hz = 1"),
    ] {
        let sensor = if kind == "noise" { "altimeter\"" } else { "gyro\"\naxis = \"x\"" };
        let failure = format!("[[failure]]\nsensor = \"{sensor}\nkind = \"{kind}\"\n{quantity}\n");
        let mut with = scene();
        with.set_items("failure", &failure).unwrap();
        scenes.push(with);
    }
    let mut log = Scene::default();
    log.set(&[("flight.file", "a.csv"), ("options.signal", "closed-loop")]).unwrap();
    scenes.push(log);
    let mut count = 0;
    for scene in scenes {
        for key in keys() {
            for name in [Some(key.name), key.si_name].into_iter().flatten() {
                let path = path_of(&key).replace(key.name, name);
                let Some(value) = scene.value(&path).filter(|_| key.name != "preset") else { continue };
                if value.is_empty() {
                    continue;
                }
                let mut again = scene.clone();
                let set = again.set(&[(&path, &value)]);
                assert_eq!(set, Ok(()), "{path} = {value}");
                assert_eq!(again, scene, "{path} = {value}");
                count += 1;
            }
        }
    }
    println!("figure: {count} values");
    assert!(count > 1500, "{count}");
}

#[test]
fn what_belongs_together_is_set_together() {
    let mut scene = scene();
    // A climb does not use the bank, and a turn does not use the height.
    let climb = [
        ("manoeuvre[1].kind", "climb"),
        ("manoeuvre[1].duration_s", "60"),
        ("manoeuvre[1].height_change_m", "500"),
    ];
    let faults = reported(scene.set(&climb).unwrap_err());
    assert_eq!(
        faults,
        [
            (
                "manoeuvre[1].heading_change_deg".into(),
                "manoeuvre.heading_change_deg: climb does not use it".into()
            ),
            ("manoeuvre[1].bank_deg".into(), "manoeuvre.bank_deg: climb does not use it".into()),
        ]
    );
    assert_eq!(scene, self::scene(), "a rejected change");
    let without = [("manoeuvre[1].bank_deg", ""), ("manoeuvre[1].heading_change_deg", "")];
    scene.set(&[&climb[..], &without].concat()).unwrap();
    assert_eq!(scene.value("manoeuvre[1].height_change_m").as_deref(), Some("500"));
    let both = [("gyro.markov_sigma_deg_h[2]", "1"), ("gyro.markov_time_s", "100")];
    let faults = reported(scene.set(&both[..1]).unwrap_err());
    assert_eq!(faults[0].0, "gyro.markov_time_s[2]", "{faults:?}");
    scene.set(&both).unwrap();
    assert_eq!(scene.value("gyro.markov_sigma_deg_h").as_deref(), Some("[0, 0, 1]"));
    // The fault of an element is reported with the number of its setting, although the scene already has the key.
    let faults = scene.set(&[("options.seed", "1"), ("gyro.markov_sigma_deg_h[1]", "-1")]).unwrap_err();
    assert_eq!(
        (faults[0].line, faults[0].column, faults[0].about.path.as_str()),
        (0, 2, "gyro.markov_sigma_deg_h[1]")
    );
    assert!(scene.set(&[("options.seed", "1"); 4097]).is_err());
    let faults = scene.set(&[("gyro.scale_factor", "1e305")]).unwrap_err();
    assert_eq!((faults[0].about.value, faults[0].about.maximum), (None, Some(1e6)), "{faults:?}");
    // Elements can be set one by one. An empty value sets 0.
    scene.set(&[("gyro.markov_sigma_deg_h[0]", "0.25"), ("gyro.markov_sigma_deg_h[2]", "")]).unwrap();
    assert_eq!(scene.value("gyro.markov_sigma_deg_h").as_deref(), Some("[0.25, 0, 0]"));
}

#[test]
fn a_preset_and_another_flight_replace_what_was() {
    let mut scene = scene();
    scene.set(&[("gyro.bias_deg_h", "7"), ("gyro.dead_zone_deg_h", "1")]).unwrap();
    scene.set(&[("gyro.preset", "consumer")]).unwrap();
    assert_eq!(scene.errors.gyro, sins::sensors::Grade::Consumer.parameters().0);
    scene.set(&[("gyro.preset", "tactical"), ("gyro.bias_deg_h", "2")]).unwrap();
    assert_eq!(scene.value("gyro.bias_deg_h").as_deref(), Some("2"));
    // The default of a preset is none: no errors.
    scene.set(&[("gyro.preset", "")]).unwrap();
    assert_eq!(scene.errors.gyro, sins::sensors::TriadParameters::default());
    // An empty value sets the default of the key, not the value of the preset.
    scene.set(&[("gyro.preset", "tactical"), ("gyro.bias_sigma_deg_h", "")]).unwrap();
    assert_eq!(scene.value("gyro.bias_sigma_deg_h").as_deref(), Some("0"));
    assert_eq!(scene.value("gyro.random_walk_deg_sqrt_h").as_deref(), Some("0.125"));
    scene.set(&[("start.position_m", "[1, 2, 3]")]).unwrap();
    scene.set(&[("start.preset", "navigation"), ("start.alignment_s", "900")]).unwrap();
    let initial = sins::sensors::Grade::Navigation.start();
    assert_eq!(scene.errors.initial, sins::sensors::InitialErrorParameters { alignment_s: 900.0, ..initial });
    scene.set(&[("flight.builtin", "patrol"), ("flight.rate_hz", "50")]).unwrap();
    assert_eq!(scene.flight, FlightSource::Builtin("patrol".into()));
    scene.set(&[("flight.file", "a.csv")]).unwrap();
    assert_eq!((scene.flight.clone(), scene.rate_hz), (FlightSource::Log("a.csv".into()), 100.0));
    assert_eq!(scene.value("flight.rate_hz").as_deref(), Some(""), "a log has its own time stamps");
    assert!(scene.set(&[("flight.file", "")]).is_err() && scene.is_log());
    scene.set_items("manoeuvre", "[[manoeuvre]]\nkind = \"rest\"\nduration_s = 60\n").unwrap();
    assert_eq!(scene.flown_s(), Ok(60.0));
}

#[test]
fn items_are_added_moved_and_removed_by_their_texts() {
    let mut scene = scene();
    let items: Vec<String> = (0..3).map(|k| scene.value(&format!("manoeuvre[{k}]")).unwrap()).collect();
    let moved = [&items[0], &items[2], &items[1], "[[manoeuvre]]\nkind = \"straight\"\nduration_s = 9\n"]
        .map(str::to_owned);
    scene.set_items("manoeuvre", &moved.join("\n")).unwrap();
    assert_eq!(scene.value("manoeuvre[1].sinusoid[0].channel").as_deref(), Some("\"course\""));
    assert_eq!(scene.value("manoeuvre[3].duration_s").as_deref(), Some("9"));
    scene.set_items("manoeuvre", &items.join("\n")).unwrap();
    assert_eq!(scene, self::scene());
    let failure = scene.value("failure[0]").unwrap();
    let faults = scene.set_items("failure", &format!("{failure}\n{failure}")).unwrap_err();
    assert_eq!((faults[0].line, faults[0].about.path.as_str()), (8, "failure[1]"), "{faults:?}");
    scene.set_items("failure", "").unwrap();
    let update = scene.value("update[0]").unwrap();
    scene.set_items("update", &format!("{update}\n{update}")).unwrap();
    assert_eq!(scene.value("update[1].at_s").as_deref(), Some("20"));
    scene.set_items("update", "").unwrap();
    let action = scene.value("panel[0]").unwrap();
    scene.set_items("panel", &format!("{action}\n{action}")).unwrap();
    assert_eq!(scene.value("panel[1].latitude_deg").as_deref(), Some("40"));
    scene.set_items("panel", "").unwrap();
    assert!(scene.panel.is_empty());
    scene.set(&[("unit.start", "")]).unwrap();
    assert!(scene.failures.is_empty() && scene.updates.is_empty());
    for (list, text, line, sentence) in [
        ("manoeuvre", "", 1, "[flight]: expected a flight: file, builtin or [[manoeuvre]]s"),
        ("failure", "# first\n[output]\nquiet = true\n", 2, "expected only [[failure]]"),
        ("failure", "[[manoeuvre]]\nkind = \"rest\"\nduration_s = 1\n", 1, "expected only [[failure]]"),
        ("failure", "kind = 1", 1, "expected only [[failure]]"),
        ("failure", "[[failure]", 1, "unclosed array table"),
        (
            "manoeuvre",
            "[[manoeuvre]]\nkind = \"rest\"\nduration_s = -1",
            3,
            "manoeuvre.duration_s = -1: must be from 0.001 to 1e8",
        ),
        ("gyro", "", 0, "expected manoeuvre, failure, update or panel"),
    ] {
        let before = scene.clone();
        let faults = scene.set_items(list, text).unwrap_err();
        let found = (faults[0].line, faults[0].sentence.as_str());
        assert!(found.0 == line && found.1.starts_with(sentence), "{text}: {faults:?}");
        assert_eq!(scene, before);
    }
}

/// A value at the stated limits of a key is accepted, unless another key is at fault. A value beyond the limits is rejected.
#[test]
fn the_limits_of_the_keys_are_those_of_the_scene() {
    let mut scene = scene();
    scene.set(&[("gyro.markov_time_s", "1"), ("options.signal", "closed-loop")]).unwrap();
    let mut counts = [0; 3];
    for key in keys() {
        let Some(limits) = key.limits else {
            counts[2] += usize::from(matches!(key.kind, KeyKind::Numbers(_)));
            continue;
        };
        let path = path_of(&key);
        // The first element of a matrix with a zero diagonal must be 0; the second element is free.
        let element = if key.spread == 0b011_101_110 {
            "[1]"
        } else if key.kind == KeyKind::Numbers(1) || key.kind == KeyKind::Whole {
            ""
        } else {
            "[0]"
        };
        for (value, is_within) in [
            (limits.low, true),
            (limits.high, true),
            (limits.low - limits.low.abs().max(1e-3) * 1e-3, false),
            (limits.high + limits.high.abs().max(1e-3) * 1e-3, false),
        ] {
            let value = if key.kind == KeyKind::Whole && !is_within {
                value.round() + (value - limits.low).signum()
            } else {
                value
            };
            let mut changed = scene.clone();
            let faults =
                changed.set(&[(&format!("{path}{element}"), &value.to_string())]).err().unwrap_or_default();
            let is_beyond = |fault: &Fault| {
                let about = &fault.about;
                about.path == format!("{path}{element}") && about.minimum.is_some() && about.maximum.is_some()
            };
            if is_within {
                // The limit of `repeat` depends on the number of manoeuvres.
                assert!(
                    key.name == "repeat" || !faults.iter().any(is_beyond),
                    "{path}{element} = {value}: {faults:?}"
                );
                counts[0] += usize::from(faults.is_empty());
            } else {
                assert!(!faults.is_empty() || limits.zero_is_off, "{path}{element} = {value} is taken");
                counts[1] += usize::from(faults.iter().any(is_beyond));
            }
        }
    }
    println!("figure: {} limits accepted, {} values beyond rejected with that limit", counts[0], counts[1]);
    assert!(counts[0] > 150 && counts[1] > 150 && counts[2] < 6, "{counts:?}");
}

/// Items of a section, one for each choice of the words that the conditions of its keys name: their settings.
fn kinds_of(section: &str) -> Vec<Vec<(String, String)>> {
    let mut items = vec![Vec::new()];
    for key in keys().into_iter().filter(|key| key.section == section) {
        let KeyKind::Words(words) = key.kind else { continue };
        let words: Vec<_> = words.iter().filter(|word| **word != "none").collect();
        let with = |item: Vec<(String, String)>| {
            let is_used = is_used(&key, &item);
            let count = if is_used { words.len() } else { 1 };
            let one = |k: usize| {
                let mut item = item.clone();
                item.extend(is_used.then(|| (key.name.to_owned(), words[k].to_string())));
                item
            };
            (0..count).map(one).collect::<Vec<_>>()
        };
        items = items.into_iter().flat_map(with).collect();
    }
    items
}

/// Whether an item of these words takes a key.
fn is_used(key: &KeyLine, item: &[(String, String)]) -> bool {
    key.condition.split_whitespace().all(|condition| {
        let (name, words) = condition.split_once('=').unwrap();
        item.iter().any(|(own, word)| own == name && words.split('|').any(|one| one == word))
    })
}

/// The limits of the keys of items hold for every kind of item that takes the key: a number beyond them is refused by each, and
/// at its limits each key is taken by a kind.
#[test]
fn the_limits_of_the_keys_are_those_of_every_kind_of_item() {
    let mut count = 0;
    for section in ["manoeuvre", "manoeuvre.sinusoid", "failure", "update", "panel"] {
        let own: Vec<KeyLine> = keys().into_iter().filter(|key| key.section == section).collect();
        for key in own.iter().filter(|key| key.limits.is_some()) {
            let (limits, mut is_taken) = (key.limits.unwrap(), [false; 2]);
            for words in kinds_of(section).into_iter().filter(|words| is_used(key, words)) {
                for (end, value, is_within) in [
                    (0, limits.low, true),
                    (1, limits.high, true),
                    (0, limits.low - limits.low.abs().max(1e-3) * 1e-3, false),
                    (1, limits.high + limits.high.abs().max(1e-3) * 1e-3, false),
                ] {
                    let (path, faults) = faults_of(&own, key, &words, value);
                    let mut own = faults.iter().filter(|fault| fault.about.path == path);
                    if is_within {
                        // An end before the begin is refused, and not by the limits.
                        is_taken[end] |= !own.any(|fault| fault.about.minimum.is_some());
                    } else {
                        assert!(own.next().is_some(), "{words:?} {path} = {value}: {faults:?}");
                        count += 1;
                    }
                }
            }
            assert_eq!(is_taken, [true; 2], "{section}.{}", key.name);
        }
    }
    println!("{count} numbers beyond the limits");
    assert!(count > 200, "{count}");
}

/// The path of a key in an item of these words, and the faults of the item if the key is a number and the other keys are usual.
fn faults_of(own: &[KeyLine], key: &KeyLine, words: &[(String, String)], value: f64) -> (String, Vec<Fault>) {
    let mut item: String = words.iter().map(|(name, word)| format!("{name} = \"{word}\"\n")).collect();
    let mut path = key.name.to_owned();
    for other in own.iter().filter(|other| is_used(other, words)) {
        let usual = match other.name {
            "repeat" | "duration_s" => "2",
            "interval_s" | "from_s" | "at_s" => "4",
            "probability" | "until_s" if key.name != other.name => continue,
            _ => "1",
        };
        let text = if other.name == key.name { value.to_string() } else { usual.to_owned() };
        // Drop-outs are random without an interval.
        if key.name == "probability" && ["interval_s", "duration_s"].contains(&other.name) {
            continue;
        }
        match other.kind {
            KeyKind::Numbers(3) => {
                path = if other.name == key.name { format!("{path}[0]") } else { path };
                item += &format!("{} = [{text}, 1, 1]\n", other.name);
            }
            KeyKind::Numbers(_) | KeyKind::Whole => item += &format!("{} = {text}\n", other.name),
            _ => {}
        }
    }
    let mut scene = scene();
    let is = |kind: &str| words.iter().any(|(_, word)| word == kind);
    let (list, text, at) = match key.section {
        "manoeuvre" if is("rest") => ("manoeuvre", format!("[[manoeuvre]]\n{item}"), "manoeuvre[0]"),
        "manoeuvre" if is("sinusoids") => {
            let one = "[[manoeuvre.sinusoid]]\nchannel = \"roll\"\namplitude_deg = 5\nfrequency_hz = 0.5\n";
            ("manoeuvre", format!("{FASTER}[[manoeuvre]]\n{item}{one}"), "manoeuvre[1]")
        }
        "manoeuvre" => ("manoeuvre", format!("{FASTER}[[manoeuvre]]\n{item}"), "manoeuvre[1]"),
        "manoeuvre.sinusoid" => {
            let one = "[[manoeuvre]]\nkind = \"sinusoids\"\nduration_s = 100\n[[manoeuvre.sinusoid]]\n";
            ("manoeuvre", format!("{FASTER}{one}{item}"), "manoeuvre[1].sinusoid[0]")
        }
        list => (list, format!("[[{list}]]\n{item}"), "[0]"),
    };
    let at = if at == "[0]" { format!("{list}{at}") } else { at.to_owned() };
    (format!("{at}.{path}"), scene.set_items(list, &text).err().unwrap_or_default())
}

const FASTER: &str = "[[manoeuvre]]\nkind = \"accelerate\"\nduration_s = 30\nspeed_change_m_s = 100\n";

/// The words of each condition are those of the key that it names; the kinds of one quantity are among them, and those of none are not.
#[test]
fn conditions_name_the_items_that_use_a_key() {
    let all = keys();
    let of = |section: &str, name: &str| {
        all.iter().find(|key| (key.section, key.name) == (section, name)).unwrap().condition.clone()
    };
    let mut count = 0;
    for key in all.iter().filter(|key| !key.condition.is_empty()) {
        for condition in key.condition.split(' ') {
            let (name, words) = condition.split_once('=').unwrap();
            let named = all.iter().find(|other| (other.section, other.name) == (key.section, name)).unwrap();
            let KeyKind::Words(known) = named.kind else { panic!("{}: {condition}", key.name) };
            assert!(words.split('|').all(|word| known.contains(&word)), "{}: {condition}", key.name);
            count += 1;
        }
    }
    assert!(count > 15, "{count}");
    // Further kinds may use a quantity too.
    for (section, name, by, uses, not) in [
        ("manoeuvre", "bank_deg", "kind", "turn", "loop"),
        ("manoeuvre", "turns", "kind", "roll", "climb"),
        ("manoeuvre", "turns", "kind", "s_turn", "straight"),
        ("manoeuvre.sinusoid", "amplitude_m_s", "channel", "speed", "roll"),
        ("failure", "axis", "sensor", "gyro", "altimeter"),
        ("failure", "size_m", "kind", "bias_step", "stuck"),
        ("failure", "size_m", "kind", "spikes", "noise"),
        ("failure", "size_m", "sensor", "altimeter", "gyro"),
        ("failure", "interval_s", "kind", "drop_outs", "dead"),
        ("update", "sigma_m", "kind", "horizontal_position", "velocity"),
        ("update", "sigma_m_s", "kind", "velocity", "position"),
        ("panel", "heading_deg", "kind", "heading", "position"),
    ] {
        let condition = of(section, name);
        let has = |word: &str| {
            let words = condition.split(' ').find_map(|one| one.strip_prefix(by)?.strip_prefix('='));
            words.unwrap_or_else(|| panic!("{section}.{name}: {condition}")).split('|').any(|one| one == word)
        };
        assert!(has(uses) && !has(not), "{section}.{name}: {condition}");
    }
    for (section, name) in [
        ("manoeuvre", "kind"),
        ("manoeuvre.sinusoid", "phase_deg"),
        ("update", "every_s"),
        ("panel", "at_s"),
        ("gyro", "bias_deg_h"),
    ] {
        assert_eq!(of(section, name), "", "{section}.{name}");
    }
}

/// The Chinese table of `SINS_Emulator` and of the page has a row for each key and for each of its words.
#[test]
fn each_key_and_each_word_is_translated() {
    let table = std::fs::read_to_string(project_file("apps/emulator/zh.txt")).unwrap();
    let names: BTreeSet<&str> =
        table.lines().filter_map(|line| line.split_once(" = ")).map(|(own, _)| own).collect();
    let mut missing = Vec::new();
    for key in keys() {
        let path = format!("{}.{}", key.section, key.name);
        // The presets of all sections have the same words.
        let of_words = if key.name == "preset" { key.name } else { &*path };
        if let KeyKind::Words(words) = key.kind {
            missing.extend(words.iter().map(|word| format!("{of_words}.{word}")));
        }
        missing.push(path);
    }
    let count = missing.len();
    missing.retain(|name| !names.contains(name.as_str()));
    assert!(count > 300, "{count}");
    assert_eq!(missing, [""; 0], "rows that apps/emulator/zh.txt lacks");
}

/// The C interface gives every key, and no text is truncated.
#[test]
fn the_keys_of_the_c_interface_are_all_of_them() {
    let mut key = init::<sins_scene_key>();
    for (index, line) in keys().iter().enumerate() {
        // SAFETY: a struct of the interface.
        assert_eq!(unsafe { sins_scene_get_key(index, &mut key) }, SINS_OK);
        assert_eq!(key.count as usize, keys().len());
        let texts = [&key.section[..], &key.name, &key.si_name, &key.unit, &key.si_unit, &key.default_value];
        let expected =
            [line.section, line.name, line.si_name.unwrap_or(""), line.unit, line.si_unit, &line.default];
        assert_eq!(texts.map(text), expected);
        assert_eq!((text(&key.condition), text(&key.meaning)), (line.condition.clone(), line.doc.to_owned()));
        let words = if let KeyKind::Words(words) = line.kind { words.join("|") } else { String::new() };
        assert_eq!(text(&key.words), words);
        let limits = (key.flags & SINS_SCENE_KEY_LIMITS != 0).then_some((key.minimum, key.maximum));
        assert_eq!(limits, line.limits.map(|limits| (limits.low, limits.high)));
        assert_eq!((key.elements == 9, key.si_per_unit), (line.kind == KeyKind::Numbers(9), line.unit_si));
    }
    // SAFETY: a struct of the interface.
    assert_eq!(unsafe { sins_scene_get_key(keys().len(), &mut key) }, SINS_ERROR_INVALID_ARGUMENT);
}

#[test]
fn a_host_is_told_the_line_the_path_and_the_limits_of_a_fault() {
    let mut scene = null_mut();
    let (mut fault, mut needed) = (init::<sins_fault>(), 0);
    let values =
        c"# from a form\n\ngyro.range_deg_s[2] = -3\noptions.vertical = free\naltimeter.bias_m = 4\n";
    // SAFETY: living handles, structs of the interface, terminated texts.
    unsafe {
        assert_eq!(sins_scene_create(&mut scene), SINS_OK);
        assert_eq!(sins_scene_set_values(scene, values.as_ptr()), SINS_ERROR_INVALID_ARGUMENT);
        assert_eq!(sins_scene_get_fault(scene, 0, &mut fault), SINS_OK);
        assert_eq!((fault.count, fault.line, text(&fault.path)), (2, 3, "gyro.range_deg_s[2]".into()));
        let limits = SINS_ERROR_INFO_VALUE | SINS_ERROR_INFO_MINIMUM | SINS_ERROR_INFO_MAXIMUM;
        assert_eq!((fault.flags, fault.value), (limits, -3.0));
        assert_eq!(fault.maximum, 5.72957e7);
        assert_eq!(sins_scene_get_fault(scene, 1, &mut fault), SINS_OK);
        assert_eq!((fault.line, text(&fault.path), fault.flags), (5, "altimeter".into(), 0));
        let mut buffer = [0; 64];
        let read = |path: &CStr, buffer: &mut [c_char; 64], needed: &mut usize| {
            sins_scene_get_value(scene, path.as_ptr(), buffer.as_mut_ptr(), 64, needed)
        };
        assert_eq!(read(c"options.vertical", &mut buffer, &mut needed), SINS_OK);
        assert_eq!((text(&buffer), needed), ("\"damped\"".into(), 9));
        let without = c"options.vertical = free\noptions.vertical\n";
        assert_eq!(sins_scene_set_values(scene, without.as_ptr()), SINS_ERROR_INVALID_ARGUMENT);
        assert_eq!(sins_scene_get_fault(scene, 0, &mut fault), SINS_OK);
        let sentence = "expected path = value, or path = for the default".to_owned();
        assert_eq!((fault.count, fault.line, text(&fault.sentence)), (1, 2, sentence));
        assert_eq!(read(c"options.vertical", &mut buffer, &mut needed), SINS_OK);
        assert_eq!(text(&buffer), "\"damped\"");
        assert_eq!(sins_scene_set_values(scene, c"options.vertical = free".as_ptr()), SINS_OK);
        assert_eq!(sins_scene_get_fault(scene, 0, &mut fault), SINS_ERROR_INVALID_ARGUMENT);
        assert_eq!(read(c"options.vertcal", &mut buffer, &mut needed), SINS_ERROR_INVALID_ARGUMENT);
        let failure =
            CString::new("[[failure]]\nsensor = \"gyro\"\naxis = \"x\"\nkind = \"dead\"\n").unwrap();
        assert_eq!(sins_scene_set_items(scene, c"failure".as_ptr(), failure.as_ptr()), SINS_OK);
        assert_eq!(read(c"failure[0].kind", &mut buffer, &mut needed), SINS_OK);
        let twice = CString::new([failure.to_bytes(), failure.to_bytes()].concat()).unwrap();
        let status = sins_scene_set_items(scene, c"failure".as_ptr(), twice.as_ptr());
        let mut info = init::<sins_error_info>();
        assert_eq!(sins_last_error_info(null_mut(), &mut info), SINS_OK);
        assert_eq!((status, text(&info.field)), (SINS_ERROR_INVALID_ARGUMENT, "items".into()));
        assert_eq!(
            sins_scene_set_values(scene, c"gyro.bias_deg_h = \xff".as_ptr()),
            SINS_ERROR_INVALID_ARGUMENT
        );
        assert_eq!(sins_scene_destroy(scene), SINS_OK);
        assert_eq!(sins_scene_set_values(scene, values.as_ptr()), SINS_ERROR_BAD_HANDLE);
    }
}

/// The texts that the scene format takes are those that sins_scene_set_text() takes.
#[test]
fn texts_have_no_control_characters_and_at_most_4096_bytes() {
    for control in ["\\u0000", "\\n", "\\u007F", "\\u0085"] {
        let faults = Scene::parse(format!("[flight]\nfile = \"a.csv{control}\"\n").as_bytes()).unwrap_err();
        assert_eq!(faults[0].sentence, "flight.file: must not have control characters");
    }
    let titled = |length| scene().set(&[("flight.title", &"x".repeat(length))]);
    assert_eq!(titled(4096), Ok(()));
    assert_eq!(titled(4097).unwrap_err()[0].sentence, "flight.title: 4097 bytes: a text has at most 4096");
}

/// The stated limits of a key in its unit and in SI are accepted.
#[test]
fn the_limits_of_the_duration_are_accepted() {
    for (path, value) in [("flight.duration_s", "0.036"), ("flight.hours", "1e-5")] {
        assert_eq!(scene().set(&[(path, value)]), Ok(()), "{path}");
    }
    let hours = keys().into_iter().find(|key| key.name == "hours").unwrap();
    let limits = hours.limits.unwrap();
    assert_eq!((limits.low, limits.high), (1e-5, 1e5));
    let faults = scene().set(&[("flight.duration_s", "0.03")]).unwrap_err();
    assert_eq!(faults[0].about.minimum, Some(1e-5), "{faults:?}");
}

/// A text of values or items that is too long or not UTF-8 has a fault with its line.
#[test]
fn every_rejected_change_has_a_fault() {
    let long = vec![b'#'; (1 << 20) + 1];
    for (text, line, words) in [
        (&long[..], 1, "1048577 bytes: a text has at most 1048576"),
        (b"gyro.preset = tactical\n\xff", 2, "not UTF-8"),
    ] {
        let text = CString::new(text).unwrap();
        let mut handle = null_mut();
        // SAFETY: living handles and terminated texts.
        unsafe {
            assert_eq!(sins_scene_create(&mut handle), SINS_OK);
            for status in [
                sins_scene_set_values(handle, text.as_ptr()),
                sins_scene_set_items(handle, c"failure".as_ptr(), text.as_ptr()),
            ] {
                let mut fault: sins_fault = init();
                assert_eq!(status, SINS_ERROR_INVALID_ARGUMENT);
                assert_eq!(sins_scene_get_fault(handle, 0, &mut fault), SINS_OK);
                let sentence = CStr::from_ptr(fault.sentence.as_ptr()).to_str().unwrap();
                assert_eq!((fault.line, sentence), (line, words));
            }
            sins_scene_destroy(handle);
        }
    }
}
