//! A scene at rest, whose sensors have the noise of a record.

use sins::allan::Term;
use sins::scene::{KeyLine, Scene, key_of_field, keys};

use super::analysis::{Analysis, Coefficient};
use super::log::Log;
use super::quantity::Sensor;
use super::{sheet, table};
use crate::failure::Failure;
use crate::units::significant;

/// The first line of such a scene.
pub const MARK: &str = "# noise that sins allan found";

/// The longest scene [h]: the record of a week needs no longer one to be compared with.
const MOST_HOURS: f64 = 48.0;

/// The text of the scene. The columns of a sensor are its axes x, y and z in the order of the log; a single one is all three. A coefficient
/// that the record does not show is left out, and so is a column whose coefficients have no intervals.
pub fn text(log: &Log, analyses: &[Analysis]) -> Result<String, Failure> {
    let keys = keys();
    let mut sections = String::new();
    for (sensor, section) in [(Sensor::Gyro, "gyro"), (Sensor::Accelerometer, "accelerometer")] {
        let axes: Vec<&Analysis> = analyses.iter().filter(|analysis| analysis.sensor == sensor).collect();
        if axes.len() > 3 {
            let what = format!(
                "--write: {} columns of {section}s: a scene has three axes; choose them with --columns",
                axes.len()
            );
            return Err(Failure::new(what));
        }
        let lines: String = Term::ALL.iter().filter_map(|term| line(&axes, *term, &keys)).collect();
        if lines.is_empty() {
            continue;
        }
        sections += &format!("\n[{section}]\n{lines}");
        for (axis, place) in axes.iter().zip(["x", "y", "z"]) {
            let axis_name = if axes.len() == 1 { "all axes" } else { place };
            let remark = table::remark(axis).map(|remark| format!(": {remark}")).unwrap_or_default();
            sections += &format!("# {axis_name}: {}{remark}\n", axis.name);
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
        "{MARK} in {}, with intervals of 95 %.\n\n[flight]\ntitle = {:?}\nbuiltin = \"rest\"\nhours = {}\n{rate}{sections}\n[options]\nsubsamples = 1 # a row of --imu for each sample\n",
        table::source(log),
        format!("At rest, with the noise of {}", log.name),
        digits(hours, 6),
    );
    match Scene::parse(text.as_bytes()) {
        Ok(_) => Ok(text),
        Err(faults) => {
            let sentences: Vec<String> = faults.iter().map(|fault| fault.sentence.clone()).collect();
            Err(Failure::new(format!("--write: the library has no such sensor: {}", sentences.join("; "))))
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
    let mut values: Vec<String> = coefficients.iter().map(value).collect();
    let intervals: Vec<String> = coefficients.iter().map(interval).collect();
    let values = if values.len() == 1 {
        values.remove(0)
    } else {
        values.resize(3, "0".to_owned());
        format!("[{}]", values.join(", "))
    };
    Some(format!("{name} = {values} # {}: {}\n", term.letter(), intervals.join(", ")))
}

fn key<'k>(keys: &'k [KeyLine], section: &str, name: &str) -> &'k KeyLine {
    keys.iter().find(|key| key.section == section && key.name == name).expect("a key of the table")
}

/// A number with so many digits, in TOML.
fn digits(value: f64, count: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", count - 1).parse().unwrap_or(value);
    format!("{rounded}")
}
