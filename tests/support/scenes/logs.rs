//! Random logs: the flight of a scene as a table, in the library's own columns or in those of a recorder.

use std::f64::consts::PI;

use sins::math::Euler;
use sins::records::Number;
use sins::scene::Scene;
use sins::truth::FlightSample;

use super::draws::Draws;

const DEG: f64 = PI / 180.0;
const FT: f64 = 0.3048;
const KT: f64 = 1852.0 / 3600.0;

/// A log, and the section of its scene that says how it is read.
pub struct Log {
    pub text: String,
    pub keys: String,
    /// Whether its time stamps have the period of the scene.
    pub is_regular: bool,
    pub has_temperature: bool,
}

/// A row of the truth.
struct Truth {
    /// Time since the start [s].
    time_s: f64,
    sample: FlightSample,
    /// Mean angular rate and specific force of the interval before, sensor axes.
    rate: [f64; 3],
    force: [f64; 3],
}

/// What a column has in a row.
type Cell = Box<dyn Fn(&Truth) -> String>;

/// The flight of a scene as a log.
pub fn log_of(scene: &str, draws: &mut Draws) -> Log {
    let scene = Scene::parse(scene.as_bytes()).unwrap_or_else(|faults| panic!("{faults:?}"));
    let is_own = draws.one_in(3);
    let is_regular = !is_own || draws.one_in(2);
    let truths = truths(&scene, |k| {
        (k as f64 + if is_regular { 0.0 } else { 0.1 * draws.below(3) as f64 }) / scene.rate_hz
    });
    // The attitude of a coordinated flight follows from its path, but for one on its back.
    let is_upright =
        truths.iter().all(|truth| truth.sample.euler.roll.abs().max(truth.sample.euler.pitch.abs()) < 1.0);
    if is_own { own(&truths, draws, is_regular) } else { recorded(&truths, draws, scene.rate_hz, is_upright) }
}

fn truths(scene: &Scene, mut time_of: impl FnMut(usize) -> f64) -> Vec<Truth> {
    let flight = scene.flight().unwrap();
    let [mut simulator] = *scene.simulator().unwrap();
    let mut truths = Vec::new();
    for k in 0.. {
        let time_s = time_of(k);
        if time_s > flight.duration_s() {
            break;
        }
        let sample = flight.sample_at(time_s).unwrap();
        let regular = FlightSample { time_s: k as f64 / scene.rate_hz, ..sample };
        simulator.push_sample(&regular).unwrap();
        simulator.step().unwrap();
        let means = simulator
            .imu()
            .map(|imu| [imu.ideal.angle / imu.interval_s, imu.ideal.velocity / imu.interval_s]);
        let [rate, force] = means.unwrap_or_default().map(<[f64; 3]>::from);
        truths.push(Truth { time_s, sample, rate, force });
    }
    [truths[0].rate, truths[0].force] = [truths[1].rate, truths[1].force];
    truths
}

fn table(separator: &str, names: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let mut text = names.join(separator) + "\n";
    rows.for_each(|row| text += &(row.join(separator) + "\n"));
    text
}

fn number(value: f64) -> String {
    Number(value).to_string()
}

/// In the columns of the library.
fn own(truths: &[Truth], draws: &mut Draws, is_regular: bool) -> Log {
    let start_s = draws.below(100_000) as f64;
    let [has_signals, has_velocity, has_temperature] = [6, 2, 4].map(|count| draws.one_in(count));
    let mut names =
        vec!["time_s", "latitude_rad", "longitude_rad", "height_m", "roll_rad", "pitch_rad", "heading_rad"];
    for (has, more) in [
        (has_velocity, &["velocity_east_m_s", "velocity_north_m_s", "velocity_up_m_s"][..]),
        (
            has_signals,
            &["rate_x_rad_s", "rate_y_rad_s", "rate_z_rad_s", "force_x_m_s2", "force_y_m_s2", "force_z_m_s2"],
        ),
        (has_temperature, &["temperature_c"]),
    ] {
        names.extend(if has { more } else { &[] });
    }
    let rows = truths.iter().map(|Truth { time_s, sample, rate, force }| {
        let (place, euler) = (sample.place, sample.euler);
        let mut row = vec![start_s + time_s, place.latitude_rad, place.longitude_rad, place.height_m];
        row.extend([euler.roll, euler.pitch, euler.heading]);
        if has_velocity {
            row.extend(sample.v_n.unwrap().iter());
        }
        if has_signals {
            row.extend(rate.iter().chain(force));
        }
        if has_temperature {
            row.push(20.0 + 0.1 * time_s);
        }
        row.into_iter().map(number).collect()
    });
    Log { text: table(",", &names, rows), keys: String::new(), is_regular, has_temperature }
}

/// In the columns of a recorder, which the scene names.
fn recorded(truths: &[Truth], draws: &mut Draws, rate_hz: f64, is_upright: bool) -> Log {
    let mut keys = "[log]\n".to_owned();
    let mut names = Vec::new();
    let mut columns: Vec<Cell> = Vec::new();
    let mut column = |key: &str, name: &'static str, parts: &str, value: Cell| {
        let from =
            if parts.is_empty() { format!("\"{name}\"") } else { format!("{{ col = \"{name}\"{parts} }}") };
        names.push(name);
        columns.push(value);
        format!("{key} = {from}\n")
    };
    let of = |value: fn(&Truth) -> f64| -> Cell { Box::new(move |truth| number(value(truth))) };
    // Times of the clock are to a tenth of a second, as the rows are.
    let clock = |date: &'static str| -> Cell {
        Box::new(move |truth| {
            let tenths = (truth.time_s * 10.0).round() as u64;
            format!("{date}23:{:02}:{:02}.{}", 50 + tenths / 600, tenths / 10 % 60, tenths % 10)
        })
    };
    let format = draws.of(&["s", "hms", "iso", "row", "dmy", "mdy", "mmss"]);
    keys += &match format {
        "s" => column("time", "T", ", unit = \"ms\"", of(|truth| 1e3 * truth.time_s)),
        "hms" => column("time", "T", "", clock("")),
        "mmss" => column(
            "time",
            "T",
            "",
            Box::new(|truth| {
                let tenths = (truth.time_s * 10.0).round() as u64;
                format!("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10)
            }),
        ),
        "iso" => column("time", "T", "", clock("2024-02-03T")),
        "dmy" => column("time", "T", "", clock("3/2/2024 ")),
        "mdy" => column("time", "T", "", clock("2/3/2024 ")),
        _ => format!("rate_hz = {rate_hz}\n"),
    };
    keys += &format!("time_format = \"{format}\"\n");
    keys += &column("latitude", "Lat", "", of(|truth| truth.sample.place.latitude_rad / DEG));
    keys += &column("longitude", "Lon", "", of(|truth| truth.sample.place.longitude_rad / DEG));
    keys += &column("height", "Alt", ", unit = \"ft\"", of(|truth| truth.sample.place.height_m / FT));
    let is_smoothed = draws.one_in(4);
    if !is_smoothed && draws.one_in(4) {
        keys += "smooth = \"off\"\nattitude = \"log\"\n";
    }
    match draws.below(if is_smoothed && is_upright { 3 } else { 2 }) {
        0 => {
            keys += &column("roll", "Roll", "", of(|truth| truth.sample.euler.roll / DEG));
            keys += &column("pitch", "Pitch", ", sign = -1", of(|truth| -truth.sample.euler.pitch / DEG));
            keys += &column("heading", "Hdg", "", of(|truth| truth.sample.euler.heading / DEG));
        }
        1 => {
            for (key, name, value) in [
                ("q0", "A", of(|truth| quaternion(&truth.sample.euler)[0])),
                ("q1", "B", of(|truth| quaternion(&truth.sample.euler)[1])),
                ("q2", "C", of(|truth| quaternion(&truth.sample.euler)[2])),
                ("q3", "D", of(|truth| quaternion(&truth.sample.euler)[3])),
            ] {
                keys += &column(key, name, "", value);
            }
        }
        _ => keys += "attitude = \"coordinated\"\nattack_deg = 2\n",
    }
    let velocity: fn(&Truth) -> [f64; 3] = |truth| truth.sample.v_n.unwrap().into();
    match draws.below(4) {
        0 => {
            keys += &column(
                "east",
                "VE",
                ", unit = \"kt\"",
                Box::new(move |truth| number(velocity(truth)[0] / KT)),
            );
            keys += &column(
                "north",
                "VN",
                ", unit = \"km/h\"",
                Box::new(move |truth| number(velocity(truth)[1] * 3.6)),
            );
            keys += &column("up", "VD", ", sign = -1", Box::new(move |truth| number(-velocity(truth)[2])));
        }
        1 => {
            keys += &format!("track_is = \"{}\"\n", draws.of(&["true", "magnetic"]));
            keys += &column(
                "speed",
                "GS",
                "",
                Box::new(move |truth| number(velocity(truth)[0].hypot(velocity(truth)[1]))),
            );
            keys += &column(
                "track",
                "TRK",
                "",
                Box::new(move |truth| number(velocity(truth)[0].atan2(velocity(truth)[1]) / DEG)),
            );
            keys += &column(
                "climb",
                "VS",
                ", unit = \"ft/min\"",
                Box::new(move |truth| number(velocity(truth)[2] / FT * 60.0)),
            );
        }
        2 => {
            for (key, name, index) in [("forward", "U", 0), ("right", "V", 1), ("down", "W", 2)] {
                keys += &column(
                    key,
                    name,
                    "",
                    Box::new(move |truth| number(body_velocity(&truth.sample)[index])),
                );
            }
        }
        _ => {}
    }
    if draws.one_in(6) {
        for (key, name, index) in [("rate_x", "P", 0), ("rate_y", "Q", 1), ("rate_z", "R", 2)] {
            keys += &column(key, name, "", Box::new(move |truth| number(truth.rate[index])));
        }
        for (key, name, index) in [("force_x", "AX", 0), ("force_y", "AY", 1), ("force_z", "AZ", 2)] {
            keys += &column(key, name, "", Box::new(move |truth| number(truth.force[index])));
        }
    }
    let has_temperature = draws.one_in(3);
    if has_temperature {
        keys += &column("temperature", "OAT", ", add = 5", of(|truth| 10.0 + 0.2 * truth.time_s));
    }
    for line in ["variation = 0\n", "geoid = 38\n"] {
        keys += if draws.one_in(3) { line } else { "" };
    }
    if is_smoothed {
        keys += &format!("smooth = \"auto\"\nsmooth_rate_hz = {rate_hz}\n");
        keys += if draws.one_in(2) { "position_sigma_m = 0.5\n" } else { "" };
        keys += if draws.one_in(2) { "attitude_sigma_deg = 0.1\n" } else { "" };
    }
    let words: &[&str] = match format {
        "dmy" | "mdy" => &["comma", "semicolon", "tab", "bar"],
        _ => &["comma", "semicolon", "tab", "bar", "blanks"],
    };
    let at = draws.below(words.len());
    let separator = [",", ";", "\t", "|", " "][at];
    keys += &format!("separator = \"{}\"\n", words[at]);
    let mut rows: Vec<Vec<String>> =
        truths.iter().map(|truth| columns.iter().map(|column| column(truth)).collect()).collect();
    if draws.one_in(3) {
        keys += "missing = -9999\n";
        let (row, column) = (5 + draws.below(100), names.iter().position(|name| *name == "Lat").unwrap());
        rows[row][column] = "-9999".to_owned();
    }
    let [is_commented, is_behind, has_units] = [3, 3, 3].map(|count| draws.one_in(count));
    if has_units {
        keys += "skip = 1\n";
        rows.insert(0, vec!["unit".to_owned(); names.len()]);
    }
    if draws.one_in(4) {
        keys += "only_column = \"Id\"\nonly = \"a\"\n";
        names.push("Id");
        let of_both = |row: Vec<String>| {
            ["a", "b"].map(|id| row.iter().cloned().chain([id.to_owned()]).collect::<Vec<String>>())
        };
        rows = rows.into_iter().flat_map(of_both).collect();
    }
    let mut text = table(separator, &names, rows.into_iter());
    if is_behind {
        keys += "header = 3\n";
        text = format!("a recorder\nof somebody\n{text}");
    }
    if is_commented {
        keys += "comment = \"%\"\n";
        text += "% the end\n";
    }
    Log { text, keys, is_regular: true, has_temperature }
}

/// From body axes forward-right-down to north-east-down.
fn quaternion(euler: &Euler) -> [f64; 4] {
    let [(sr, cr), (sp, cp), (sh, ch)] =
        [euler.roll, euler.pitch, euler.heading].map(|angle| (angle / 2.0).sin_cos());
    [
        cr * cp * ch + sr * sp * sh,
        sr * cp * ch - cr * sp * sh,
        cr * sp * ch + sr * cp * sh,
        cr * cp * sh - sr * sp * ch,
    ]
}

/// Velocity along body axes forward-right-down.
fn body_velocity(sample: &FlightSample) -> [f64; 3] {
    let [east, north, up]: [f64; 3] = sample.v_n.unwrap().into();
    let [(sr, cr), (sp, cp), (sh, ch)] =
        [sample.euler.roll, sample.euler.pitch, sample.euler.heading].map(f64::sin_cos);
    let (ahead, aside) = (north * ch + east * sh, east * ch - north * sh);
    let below = ahead * sp - up * cp;
    [ahead * cp + up * sp, aside * cr + below * sr, below * cr - aside * sr]
}
