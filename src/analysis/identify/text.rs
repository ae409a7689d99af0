//! What was found, in words and as the sections of a scene.

use nalgebra::Matrix3;

use super::sheet::{AXES, Line, NoiseLine, Sheet, sheets};
use super::{Estimate, Identified, TriadEstimate};
use crate::base::figures::{significant, two_digits};
use crate::base::records::rounded;
use crate::base::units::DEG;
use crate::earth::state::BodyAxes;

/// The begin of a scene of what was found.
pub const MARK: &str = "# sensors that sins identify found";
/// What the begin of a scene says of its figures.
pub const FIGURES: &str = "with intervals of 95 %. Noise is that of the record and of the path together.";
/// Boresight below which none is written \[rad\].
const NO_TURN: f64 = 1e-9;

/// A parameter with its interval, or how it could be seen.
pub fn seen(line: &Line) -> String {
    match line.estimate.is_seen() {
        true => with_interval(&line.estimate, line.unit.si, line.unit.name),
        false => not_seen(&line.shown_by),
    }
}

/// That a parameter is not seen, and what would show it.
pub(super) fn not_seen(shown_by: &str) -> String {
    format!("not seen in this motion and noise; {shown_by} would show it")
}

/// A coefficient of noise with its interval.
pub fn of_noise(line: &NoiseLine) -> String {
    let [value, low, high] = [line.estimate.value, line.estimate.low, line.estimate.high]
        .map(|value| significant(value / line.unit.si));
    match line.estimate.is_seen() {
        true => format!("{value} ({low} to {high}) {}", line.unit.name),
        false => format!("below {high} {}", line.unit.name),
    }
}

/// A value and half the width of its interval, with the digits that the width has.
pub fn with_interval(estimate: &Estimate, si: f64, unit: &str) -> String {
    let half = two_digits(1.96 * estimate.sigma / si);
    let decimals = half.split_once('.').map_or(0, |(_, behind)| behind.len());
    format!("{:.decimals$} ± {half} {unit}", estimate.value / si)
}

/// The exchange of axes in words.
pub fn axes(exchange: &Matrix3<f64>, is_seen: bool) -> String {
    if *exchange == Matrix3::identity() {
        let taken = "taken for those of the path; the motion does not exclude others";
        return if is_seen { "those of the path" } else { taken }.to_owned();
    }
    let words: Vec<String> = (0..3)
        .map(|row| {
            let column = (0..3).find(|column| exchange[(row, *column)] != 0.0).unwrap_or(row);
            let reversed = if exchange[(row, column)] < 0.0 { ", reversed" } else { "" };
            format!("{} of the record is {} of the path{reversed}", AXES[row], AXES[column])
        })
        .collect();
    words.join("; ")
}

/// The scene of what was found, at rest: a host sets another flight. `axes` are those of the vehicle.
pub fn scene(found: &Identified, axes: BodyAxes) -> String {
    format!(
        "{MARK}, {FIGURES}\n\n[flight]\nbuiltin = \"rest\"\n{}{}",
        temperature(found),
        sections(found, axes)
    )
}

/// The temperature of a flight without one of its own, if what was seen needs one.
pub fn temperature(found: &Identified) -> String {
    let is_seen = |triad: &TriadEstimate| triad.bias_temperature.iter().any(Estimate::is_seen);
    match found.reference_c.filter(|_| is_seen(&found.gyro) || is_seen(&found.accel)) {
        Some(reference_c) => format!("temperature_c = {}\n", rounded(reference_c, 6)),
        None => String::new(),
    }
}

/// The sections of a scene that has what was found; its vehicle has `axes`. What was not seen is a comment.
pub fn sections(found: &Identified, axes: BodyAxes) -> String {
    let mut text = match axes {
        BodyAxes::ForwardRightDown => "\n[options]\naxes = \"frd\"\n".to_owned(),
        BodyAxes::RightForwardUp => String::new(),
    };
    text += &mounting(found, axes);
    for sheet in sheets(found) {
        text += &section(&sheet);
    }
    text
}

/// The attitude of the block in the vehicle.
fn mounting(found: &Identified, of_vehicle: BodyAxes) -> String {
    let words = axes(&found.axes.exchange, found.axes.is_seen);
    let euler = found.boresight(of_vehicle);
    let mut text = format!("\n# axes: {words}\n");
    let angles = [euler.roll, euler.pitch, euler.heading];
    let is_turned = angles.iter().any(|angle| angle.abs() >= NO_TURN);
    let is_seen = found.lever_arm.iter().any(Estimate::is_seen);
    if is_turned || is_seen {
        text += "[mounting]\n";
    }
    if is_turned {
        let [roll, pitch, heading] = angles.map(|angle| rounded(angle / DEG, 9));
        text += &format!("boresight_deg = [{roll}, {pitch}, {heading}]\n");
    }
    if is_seen {
        let [x, y, z] = <[f64; 3]>::from(found.lever_arm_b()).map(|part| rounded(part, 4));
        text += &format!("lever_arm_m = [{x}, {y}, {z}]\n");
    }
    text
}

/// Values of the parameters that were seen on at least one axis, the standard deviations that are left, and comments about the others.
fn section(sheet: &Sheet) -> String {
    let Sheet { section, noises, reference_c, .. } = sheet;
    let mut text = format!("\n[{section}]\n");
    let lines: Vec<&Line> = sheet.fitted().collect();
    for of_key in lines.chunk_by(|a, b| a.key == b.key) {
        let key = of_key[0].key;
        let is_matrix = of_key.len() == 6;
        let value =
            |line: &Line, of: f64| if line.estimate.is_seen() { rounded(of / line.unit.si, 6) } else { 0.0 };
        if !key.is_empty() && of_key.iter().any(|line| line.estimate.is_seen()) {
            let values = |of: &dyn Fn(&Line) -> f64| {
                let numbers: Vec<f64> = of_key.iter().map(|line| value(line, of(line))).collect();
                let numbers = if is_matrix { beside_diagonal(&numbers) } else { numbers };
                numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(", ")
            };
            let unit = unit(key);
            let stem = key.strip_suffix(unit).unwrap_or(key);
            text += &format!("{key} = [{}]\n", values(&|line| line.estimate.value));
            if let Some(reference_c) = reference_c
                && key.starts_with("bias_temperature")
            {
                text += &format!("reference_temperature_c = {}\n", rounded(*reference_c, 6));
            }
            if WITH_SIGMA.contains(&stem) {
                text += &format!("{stem}_sigma{unit} = [{}]\n", values(&|line| line.estimate.sigma));
            }
        }
        for line in of_key {
            text += &format!("# {}: {}\n", line.name, seen(line));
        }
    }
    for of_key in noises.chunk_by(|a, b| a.key == b.key) {
        let value = |line: &NoiseLine| match line.estimate.is_seen() {
            true => rounded(line.estimate.value / line.unit.si, 6),
            false => 0.0,
        };
        if of_key.iter().any(|line| line.estimate.is_seen()) {
            let values: Vec<String> = of_key.iter().map(|line| value(line).to_string()).collect();
            text += &format!("{} = [{}]\n", of_key[0].key, values.join(", "));
        }
        for line in of_key {
            text += &format!("# {}: {}\n", line.name, of_noise(line));
        }
    }
    text
}

/// Stems of the keys that have a key for their standard deviation beside them.
const WITH_SIGMA: [&str; 3] = ["bias", "scale_factor", "misalignment"];

/// The unit at the end of a key.
fn unit(key: &str) -> &'static str {
    ["_deg_h", "_micro_g", "_ppm", "_arcsec"].into_iter().find(|unit| key.ends_with(unit)).unwrap_or("")
}

/// Nine elements of six beside the diagonal, row by row.
fn beside_diagonal(six: &[f64]) -> Vec<f64> {
    let mut rest = six.iter().copied();
    (0..9).map(|k| if k % 4 == 0 { 0.0 } else { rest.next().unwrap_or(0.0) }).collect()
}
