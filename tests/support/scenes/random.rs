//! Random scenes, each with a part of what a scene can say. The same seed gives the same scene.

use std::collections::BTreeSet;

use sins::scene::{KeyKind, KeyLine, Scene, keys};

use super::FlownScene;
use super::draws::Draws;
use super::logs::{Log, log_of};

/// A time after which nothing is planned [s].
const SECONDS: usize = 120;
const RATE_HZ: usize = 10;

impl Draws {
    /// A time of the flight in quarters of a second, which are not all at samples.
    fn time_s(&mut self) -> f64 {
        self.below(4 * SECONDS) as f64 / 4.0
    }

    /// From -`size` to `size`.
    fn around(&mut self, size: f64) -> f64 {
        size * (self.below(2001) as f64 / 1000.0 - 1.0)
    }
}

/// Keys that are not set key by key: those that choose the flight and its length, and those that end it early.
const BY_HAND: [&str; 6] = [
    "options.sample_period_s",
    "options.max_gap_s",
    "options.max_acceleration_m_s2",
    "output.folder",
    "output.name",
    "unit.start",
];

/// The scene of `seed`. `with_log`: its flight may be a log.
pub fn random_scene(seed: u64, with_log: bool) -> FlownScene {
    let mut draws = Draws::new(seed);
    let name = format!("random_{seed}");
    let flight = flight(&mut draws);
    let log = (with_log && draws.one_in(3)).then(|| log_of(&cleaned(&flight), &mut draws));
    let is_builtin = log.is_none() && draws.one_in(8);
    let mut text = match &log {
        Some(_) => format!("[flight]\nfile = \"{name}.csv\"\n"),
        None if is_builtin => {
            let builtin = draws.of(&["commuter", "racetrack", "aerobatics", "patrol"]);
            format!("[flight]\nbuiltin = \"{builtin}\"\nhours = 0.04\nrate_hz = {RATE_HZ}\n")
        }
        None => flight.split_once("[[").unwrap().0.to_owned(),
    };
    // A scene has one source of the temperature.
    let is_logged = log.as_ref().is_some_and(|log| log.has_temperature);
    let has_temperature = !is_logged && draws.one_in(2);
    if has_temperature {
        text += &format!("temperature_c = {}\n", draws.below(60) as f64 - 20.0);
        if draws.one_in(2) {
            text += &format!("temperature_change_c_h = {}\n", draws.around(900.0));
        }
    }
    if draws.one_in(4) {
        text += "title = \"at random\"\n";
    }
    if let Some(Log { keys, .. }) = &log {
        text += keys;
    }
    if log.is_none() && !is_builtin {
        text += &flight[flight.find("[[").unwrap()..];
    }
    text += &format!("[options]\nseed = {seed}\nrun = {}\n", draws.below(1000));
    if draws.one_in(8) {
        text += "max_acceleration_m_s2 = 400\nmax_gap_s = 50\n";
    }
    if log.as_ref().is_some_and(|log| log.is_regular) && draws.one_in(2) {
        text += &format!("sample_period_s = {}\n", 1.0 / RATE_HZ as f64);
    }
    let density = [2, 6, 30][draws.below(3)];
    text += &random_keys("options", &mut draws, density.max(4));
    let grade =
        draws.of(&["ideal", "navigation", "tactical", "industrial", "strategic", "consumer", "paper2"]);
    for section in ["gyro", "accelerometer", "altimeter", "start", "mounting", "gravity", "output"] {
        text += &format!("[{section}]\n");
        if ["gyro", "accelerometer", "start"].contains(&section) && !draws.one_in(4) {
            text += &format!("preset = \"{grade}\"\n");
        }
        text += &random_keys(section, &mut draws, density);
    }
    if draws.one_in(6) {
        text += "folder = \"of_scene\"\nname = \"of_scene\"\n";
    }
    text += &failures(&mut draws);
    text += &updates(&mut draws);
    match draws.below(12) {
        0..6 => text += &unit(&mut draws, density),
        6 => text += "[unit]\nstart = \"none\"\n",
        _ => {}
    }
    if !is_logged && !has_temperature && text.contains("_per_k") {
        text = text.replacen("[flight]\n", "[flight]\ntemperature_c = 25\n", 1);
    }
    if draws.one_in(3) {
        text += &imu(&mut draws);
    }
    FlownScene { name, text: cleaned(&text), log: log.map(|log| log.text) }
}

/// The scene without the lines that are at fault: settings that do not go together, and keys that are set twice.
fn cleaned(text: &str) -> String {
    let mut lines: Vec<&str> = text.lines().collect();
    loop {
        let text = lines.join("\n") + "\n";
        let Err(faults) = Scene::parse(text.as_bytes()) else { return text };
        let at_fault: BTreeSet<usize> = faults.iter().map(|fault| fault.line).collect();
        assert!(!at_fault.contains(&0), "{faults:?}\n{text}");
        let mut number = 0;
        lines.retain(|_| {
            number += 1;
            !at_fault.contains(&number)
        });
    }
}

/// The start of a flight and its manoeuvres: at rest, in motion for about two minutes.
fn flight(draws: &mut Draws) -> String {
    let mut text = format!(
        "[flight]\nlatitude_deg = {}\nlongitude_deg = {}\nheight_m = {}\nheading_deg = {}\nrate_hz = {RATE_HZ}\n",
        draws.below(120) as f64 - 60.0,
        draws.below(360) as f64 - 180.0,
        1000 + draws.below(3000),
        draws.below(360)
    );
    let rest_s = 10 + draws.below(60);
    // A flight that begins in motion, tilted, and that is flown twice.
    let moves = draws.one_in(6);
    if moves {
        text += &format!(
            "speed_m_s = {}\nroll_deg = {}\npitch_deg = 2\nrepeat = 2\n",
            60 + draws.below(50),
            draws.around(5.0)
        );
    } else {
        text += &format!(
            "[[manoeuvre]]\nkind = \"rest\"\nduration_s = {rest_s}\n[[manoeuvre]]\nkind = \"accelerate\"\nduration_s = 20\n\
             speed_change_m_s = {}\nramp_s = 4\n",
            60 + draws.below(50)
        );
    }
    for _ in 0..draws.below(4) {
        text += "[[manoeuvre]]\n";
        text += &match draws.below(7) {
            0 => format!(
                "kind = \"climb\"\nduration_s = 20\nheight_change_m = {}\nramp_s = 5\n",
                draws.around(50.0)
            ),
            1 => format!("kind = \"turn\"\nheading_change_deg = {}\nbank_deg = 20\n", draws.around(90.0)),
            2 => "kind = \"roll\"\nduration_s = 20\nturns = 1\n".to_owned(),
            3 => "kind = \"loop\"\nduration_s = 30\nturns = 1\n".to_owned(),
            4 => "kind = \"s_turn\"\nduration_s = 40\nheading_change_deg = 15\nturns = 2\n".to_owned(),
            5 => format!(
                "kind = \"sinusoids\"\nduration_s = 20\nramp_s = 3\n[[manoeuvre.sinusoid]]\nchannel = \"{}\"\namplitude_deg = 1\n\
                 frequency_hz = 0.4\nphase_deg = 40\n[[manoeuvre.sinusoid]]\nchannel = \"speed\"\namplitude_m_s = 1\n\
                 frequency_hz = 0.2\n",
                draws.of(&["course", "climb", "roll", "pitch", "heading"])
            ),
            _ => "kind = \"straight\"\nduration_s = 15\n".to_owned(),
        };
    }
    text + &format!(
        "[[manoeuvre]]\nkind = \"straight\"\nduration_s = {}\n",
        SECONDS / if moves { 2 } else { 1 } - rest_s.min(50)
    )
}

/// One in `density` of the keys of a section, with a random value each.
fn random_keys(section: &str, draws: &mut Draws, density: usize) -> String {
    let mut text = String::new();
    for key in keys().iter().filter(|key| key.section == section && key.name != "preset") {
        let path = format!("{section}.{}", key.name);
        if !BY_HAND.contains(&path.as_str()) && draws.one_in(density) {
            text += &format!("{} = {}\n", key.name, value(key, draws));
        }
    }
    text
}

/// A value as large as those of a data sheet.
fn value(key: &KeyLine, draws: &mut Draws) -> String {
    let mut number = || {
        let size = match key.unit {
            "arcsec" | "micro-g" | "mm" | "m" | "s" => 50.0,
            "ppm" | "deg/s" | "g" => 100.0,
            "deg" | "km" | "mGal" | "deg C" | "Hz" => 10.0,
            _ => 1.0,
        };
        let number = draws.around(size);
        match key.limits {
            Some(limits) if limits.low >= 0.0 => number.abs().clamp(limits.low, limits.high),
            Some(limits) => number.clamp(limits.low, limits.high),
            None => number,
        }
    };
    match key.kind {
        KeyKind::Numbers(1) => number().to_string(),
        KeyKind::Numbers(_) if key.spread != 0 && number() > 0.0 => number().to_string(),
        KeyKind::Numbers(count) => {
            let numbers: Vec<String> = (0..count).map(|_| number().to_string()).collect();
            format!("[{}]", numbers.join(", "))
        }
        KeyKind::Words(words) => format!("\"{}\"", draws.of(words)),
        KeyKind::Whole => (1 + draws.below(4)).to_string(),
        KeyKind::Text => "\"at_random.csv\"".to_owned(),
        KeyKind::Flag => "true".to_owned(),
    }
}

/// The description of a record, which no flight reads.
fn imu(draws: &mut Draws) -> String {
    let mut text = format!(
        "[imu]\nheader = {}\nskip = {}\ncomment = \"%\"\nmissing = -9999\nonly_column = \"I\"\nonly = \"0\"\nrate_hz = 200\nseparator = \"{}\"\ntime_format = \"{}\"\n",
        draws.below(9),
        draws.below(9),
        draws.of(&["comma", "semicolon", "tab", "bar", "blanks"]),
        draws.of(&["s", "hms", "iso", "row", "dmy", "mdy", "mmss"]),
    );
    text += "time = { col = 1, unit = \"us\", add = -5 }\n";
    for (sensor, units) in [("gyro", ["mdeg/s", "arcsec"]), ("accelerometer", ["ug", "mm/s"])] {
        for axis in ["x", "y", "z"] {
            text += &format!(
                "{sensor}_{axis} = {{ col = \"{axis}\", unit = \"{}\", sign = -1 }}\n",
                draws.of(&units)
            );
        }
    }
    text
}

/// Failures of some outputs, of every kind.
fn failures(draws: &mut Draws) -> String {
    let mut text = String::new();
    for (sensor, axis, units) in [
        ("gyro", "x", ["deg_h", "deg_sqrt_h"]),
        ("gyro", "z", ["deg_h", "deg_sqrt_h"]),
        ("accelerometer", "y", ["micro_g", "micro_g_sqrt_hz"]),
        ("accelerometer", "z", ["micro_g", "micro_g_sqrt_hz"]),
        ("altimeter", "", ["m", "m_sqrt_hz"]),
    ] {
        if !draws.one_in(4) {
            continue;
        }
        text += &format!("[[failure]]\nsensor = \"{sensor}\"\n");
        if !axis.is_empty() {
            text += &format!("axis = \"{axis}\"\n");
        }
        let (from_s, size) = (draws.time_s(), 1 + draws.below(20));
        let [of_size, of_density] = units;
        text += &match draws.below(8) {
            7 => "kind = \"none\"\n".to_owned(),
            0 => "kind = \"stuck\"\n".to_owned(),
            1 => "kind = \"dead\"\n".to_owned(),
            2 => format!("kind = \"bias_step\"\nsize_{of_size} = {size}\n"),
            3 => format!("kind = \"spikes\"\nsize_{of_size} = {size}\ninterval_s = 3\nduration_s = 0.4\n"),
            4 => format!("kind = \"noise\"\ndensity_{of_density} = {size}\n"),
            5 => "kind = \"drop_outs\"\ninterval_s = 2\n".to_owned(),
            _ => "kind = \"drop_outs\"\nprobability = 0.3\n".to_owned(),
        };
        text += &format!("from_s = {from_s}\n");
        if !draws.one_in(6) || text.contains("stuck") || text.contains("dead") {
            text += &format!("until_s = {}\n", from_s + 0.3 + draws.below(8) as f64);
        }
    }
    text
}

fn updates(draws: &mut Draws) -> String {
    let mut text = String::new();
    for kind in ["position", "horizontal_position", "velocity"] {
        if !draws.one_in(2) {
            continue;
        }
        let sigma = if kind == "velocity" { "sigma_m_s = 0.2" } else { "sigma_m = [30, 20, 10]" };
        let every =
            if draws.one_in(4) { String::new() } else { format!("every_s = {}\n", 1 + draws.below(40)) };
        let at_s = 0.25 + draws.time_s();
        text += &format!("[[update]]\nkind = \"{kind}\"\nat_s = {at_s}\n{every}{sigma}\n");
    }
    text
}

/// A unit and its panel. Some of the entries come at a moment at which the unit does not take them.
fn unit(draws: &mut Draws, density: usize) -> String {
    let kind = draws.of(&["gyrocompass", "stored_heading", "fast", "instant", "in_flight"]);
    let start = draws.of(&["off", "off", "nav"]);
    let mut text = format!("[unit]\nstart = \"{start}\"\nalignment = \"{kind}\"\npower_up_test_s = 2\n");
    text += &random_keys("unit", draws, density);
    let mut action = |kind: &str, at_s: f64, more: &str| {
        text += &format!("[[panel]]\nkind = \"{kind}\"\nat_s = {at_s}\n{more}");
    };
    action("align", 1.0, "");
    if draws.one_in(8) {
        action("position", 4.5, &format!("latitude_deg = {}\nlongitude_deg = 3\n", draws.around(60.0)));
    }
    action("true_position", 5.0 + 0.25 * draws.below(8) as f64, "");
    let att_s = 7.0 + draws.time_s();
    match draws.of(&["nav", "att"]) {
        "att" => {
            action("att", att_s, "");
            action("heading", att_s + 33.0, "heading_deg = 77\n");
        }
        _ => action("nav", att_s, ""),
    }
    for _ in 0..draws.below(3) {
        let kinds = ["off", "align", "nav", "true_position", "battery", "no_power", "aircraft_power", "test"];
        action(draws.of(&kinds), draws.time_s(), "");
    }
    text
}

/// The keys and words that scenes have not set yet.
pub struct Coverage(BTreeSet<String>);

impl Default for Coverage {
    fn default() -> Self {
        let mut all = BTreeSet::new();
        for key in keys() {
            let path = format!("{}.{}", key.section, key.name);
            if let KeyKind::Words(words) = key.kind {
                all.extend(words.iter().map(|word| format!("{path} = \"{word}\"")));
            }
            all.insert(path);
        }
        Self(all)
    }
}

impl Coverage {
    pub fn add(&mut self, text: &str) {
        let mut section = "";
        for line in text.lines() {
            if line.starts_with('[') {
                section = line.trim_matches(['[', ']']);
            } else if let Some((name, _)) = line.split_once(" = ") {
                self.0.remove(&format!("{section}.{name}"));
                self.0.remove(&format!("{section}.{line}"));
            }
        }
    }

    /// What was never set.
    pub fn missing(&self) -> Vec<&str> {
        self.0.iter().map(String::as_str).collect()
    }
}
