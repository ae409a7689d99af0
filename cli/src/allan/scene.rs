//! A scene at rest, whose sensors have the noise of a record.

use sins::scene::{KeyLine, Scene, key_of_field, keys};
use sins_allan::Term;

use super::analysis::{Analysis, Coefficient};
use super::log::Log;
use super::quantity::Sensor;
use super::{sheet, table};
use crate::failure::Failure;
use crate::units::significant;

/// The begin of such a scene.
const MARK: &str = "# noise that sins allan found";

/// The longest scene [h]: the record of a week needs no longer one to be compared with.
const MOST_HOURS: f64 = 48.0;

/// The text of the scene. The columns of a sensor are its axes x, y and z in the order of the log; a single one is all three. A coefficient
/// that the record does not show is left out, and so is a column whose coefficients have no intervals.
pub fn text(log: &Log, analyses: &[Analysis]) -> Result<String, Failure> {
    let keys = keys();
    let mut sections = String::new();
    for (sensor, section) in [(Sensor::Gyro, "gyro"), (Sensor::Accelerometer, "accelerometer")] {
        let axes: Vec<&Analysis> = analyses.iter().filter(|analysis| analysis.sensor == sensor).collect();
        let columns = axes.first().map_or(0, |axis| axis.axis.1);
        if columns > 3 {
            let what = format!(
                "--write: {columns} columns of {section}s: a scene has three axes; choose them with --columns"
            );
            return Err(Failure::new(what));
        }
        let lines: String = Term::ALL.iter().filter_map(|term| line(&axes, *term, &keys)).collect();
        if lines.is_empty() {
            continue;
        }
        sections += &format!("\n[{section}]\n{lines}");
        for place in 0..columns {
            let name = if columns == 1 { "all axes" } else { ["x", "y", "z"][place] };
            let about = axes.iter().find(|axis| axis.axis.0 == place).map_or(
                "left out: no noise".to_owned(),
                |axis| {
                    let remark = table::remark(axis).map(|remark| format!(": {remark}")).unwrap_or_default();
                    format!("{}{remark}", printable(&axis.name))
                },
            );
            sections += &format!("# {name}: {about}\n");
        }
    }
    if sections.is_empty() {
        return Err(Failure::new(
            "--write: the record shows no coefficient with an interval, so there is nothing to write",
        ));
    }
    let rate = key(&keys, "flight", "rate_hz");
    let rate_hz = Some(1.0 / log.interval_s)
        .filter(|hz| rate.limits.is_none_or(|limits| (limits.low..=limits.high).contains(hz)));
    let rate = rate_hz.map(|hz| format!("rate_hz = {}\n", digits(hz, 6))).unwrap_or_default();
    let hours = (log.duration_s() / 3600.0).min(MOST_HOURS);
    let text = format!(
        "{MARK} in {}, with intervals of 95 %.\n\n[flight]\ntitle = \"At rest, with the noise of {}\"\nbuiltin = \"rest\"\nhours = {}\n{rate}{sections}\n[options]\nsubsamples = 1 # a row of --imu for each sample\n",
        printable(&table::source(log)),
        printable(&log.name),
        digits(hours, 6),
    );
    match Scene::parse(text.as_bytes()) {
        Ok(_) => Ok(text),
        Err(faults) => {
            let sentences: Vec<String> = faults.iter().map(|fault| fault.sentence.clone()).collect();
            Err(Failure::new(format!(
                "--write: a scene cannot have what was found: {}",
                sentences.join("; ")
            )))
        }
    }
}

/// The line of a term, with its interval on each axis; `None`: no axis shows it.
fn line(axes: &[&Analysis], term: Term, keys: &[KeyLine]) -> Option<String> {
    let coefficients: Vec<&Coefficient> = axes.iter().map(|axis| &axis.coefficients[term as usize]).collect();
    if !coefficients.iter().any(|coefficient| coefficient.is_resolved()) {
        return None;
    }
    let (field, size) = sheet::parameter(axes[0].sensor, term);
    let path = key_of_field(field)?;
    let (section, name) = path.split_once('.')?;
    let unit_si = key(keys, section, name).unit_si / size;
    let value = |coefficient: &&Coefficient| {
        if coefficient.is_resolved() { digits(coefficient.value / unit_si, 4) } else { "0".to_owned() }
    };
    let interval = |coefficient: &&Coefficient| {
        let ends = coefficient.interval.filter(|_| coefficient.is_resolved());
        ends.map_or("not shown".to_owned(), |ends| {
            format!("{} to {}", significant(ends.low / unit_si), significant(ends.high / unit_si))
        })
    };
    let (_, columns) = axes[0].axis;
    let on_axis =
        |place: usize| axes.iter().position(|axis| axis.axis.0 == place).map(|at| &coefficients[at]);
    let intervals: Vec<String> =
        (0..columns).map(|place| on_axis(place).map_or("left out".to_owned(), interval)).collect();
    let value = |place| on_axis(place).map_or("0".to_owned(), value);
    let values = if columns == 1 { value(0) } else { format!("[{}]", [0, 1, 2].map(value).join(", ")) };
    Some(format!("{name} = {values} # {}: {}\n", term.letter(), intervals.join(", ")))
}

/// A text in a comment or in quotes of TOML: marks that it cannot have become question marks.
fn printable(text: &str) -> String {
    let is_plain =
        |letter: char| letter.is_alphanumeric() || letter.is_ascii_graphic() || "° √µ·²³⁻".contains(letter);
    text.chars()
        .map(|letter| if is_plain(letter) && !matches!(letter, '"' | '\\') { letter } else { '?' })
        .collect()
}

fn key<'k>(keys: &'k [KeyLine], section: &str, name: &str) -> &'k KeyLine {
    keys.iter().find(|key| key.section == section && key.name == name).expect("a key of the table")
}

/// A number with so many digits, in TOML.
fn digits(value: f64, count: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", count - 1).parse().unwrap_or(value);
    format!("{rounded}")
}
