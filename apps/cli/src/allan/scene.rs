//! A scene at rest, whose sensors have the noise of a record.

use sins::scene::{KeyLine, Scene, key_of_field, keys};
use sins_allan::Term;

use super::analysis::{Analysis, CERTAINTY, Coefficient};
use super::{sheet, table};
use crate::failure::Failure;
use crate::imu::Log;
use crate::imu::{Sensor, imu_text};
use crate::units::significant;

/// The begin of such a scene.
const MARK: &str = "# noise that sins allan found";

/// The longest scene [h]: the record of a week needs no longer one to be compared with.
const MOST_HOURS: f64 = 48.0;

/// The text of the scene. The columns of a sensor are its axes x, y and z in the order of the log; a single one is all three. A coefficient
/// that the record does not show is left out, one that it does not show with [`CERTAINTY`] is a comment, and a column whose coefficients
/// have no intervals is left out.
pub fn text(log: &Log, analyses: &[Analysis]) -> Result<String, Failure> {
    let keys = keys();
    let (mut sections, mut is_certain) = (String::new(), false);
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
        is_certain |=
            axes.iter().flat_map(|axis| &axis.coefficients).any(|coefficient| coefficient.written.is_some());
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
    if !is_certain {
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
        "{MARK} in {}, with intervals of 95 %. A term that it shows with less than {} % is a comment.\n\n[flight]\ntitle = \"At rest, with the noise of {}\"\nbuiltin = \"rest\"\nhours = {}\n{rate}{sections}\n[options]\nsubsamples = 1 # a row of --imu for each sample\n{}",
        printable(&table::source(log)),
        100.0 * CERTAINTY,
        printable(&log.name),
        digits(hours, 6),
        log.taken.as_deref().map_or(String::new(), |taken| format!(
            "\n# How the log was read; --imu-map with this file reads another one in the same way.\n{}",
            imu_text(taken)
        )),
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

/// The line of a term, with its interval on each axis: a comment if no axis is certain of it. `None`: no axis shows it.
fn line(axes: &[&Analysis], term: Term, keys: &[KeyLine]) -> Option<String> {
    let coefficients: Vec<&Coefficient> = axes.iter().map(|axis| &axis.coefficients[term as usize]).collect();
    if !coefficients.iter().any(|coefficient| coefficient.is_resolved()) {
        return None;
    }
    let is_comment = !coefficients.iter().any(|coefficient| coefficient.written.is_some());
    let (field, size) = sheet::parameter(axes[0].sensor, term);
    let path = key_of_field(field)?;
    let (section, name) = path.split_once('.')?;
    let unit_si = key(keys, section, name).unit_si / size;
    let number = |value: f64| digits(value / unit_si, 4);
    let value = |coefficient: &&Coefficient| {
        let shown = Some(coefficient.value).filter(|_| is_comment && coefficient.is_resolved());
        coefficient.written.or(shown).map_or("0".to_owned(), number)
    };
    let interval = |coefficient: &&Coefficient| {
        let ends = coefficient.interval.filter(|_| coefficient.is_resolved());
        let ends = ends.map(|ends| [ends.low, ends.high].map(|end| significant(end / unit_si)));
        match ends {
            None => "not shown".to_owned(),
            Some([low, high]) if coefficient.written.is_some() || is_comment => format!("{low} to {high}"),
            Some([low, high]) => format!("not certain, {} ({low} to {high})", number(coefficient.value)),
        }
    };
    let (_, columns) = axes[0].axis;
    let on_axis =
        |place: usize| axes.iter().position(|axis| axis.axis.0 == place).map(|at| &coefficients[at]);
    let intervals: Vec<String> =
        (0..columns).map(|place| on_axis(place).map_or("left out".to_owned(), interval)).collect();
    let value = |place| on_axis(place).map_or("0".to_owned(), value);
    let values = if columns == 1 { value(0) } else { format!("[{}]", [0, 1, 2].map(value).join(", ")) };
    let comment = if is_comment { "# not certain: " } else { "" };
    Some(format!("{comment}{name} = {values} # {}: {}\n", term.letter(), intervals.join(", ")))
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

#[cfg(test)]
mod tests {
    use super::super::analysis::tests::{logged, made_of};
    use super::*;
    use crate::draws::Draws;

    const RECORDS: u64 = 300;

    /// The keys of `[gyro]` that are written of a record, by the letters of their terms.
    fn written(log: &Log) -> Vec<String> {
        let text = text(log, &Analysis::of_log(log).unwrap()).unwrap();
        let of_keys = text.lines().filter(|line| !line.starts_with('#') && line.contains(" # "));
        of_keys.filter_map(|line| Some(line.split_once(" # ")?.1.split_once(':')?.0.to_owned())).collect()
    }

    /// In a record of white noise alone, chance shows each of the four other terms at 95 % in up to 1 of 20 records; it may write one in
    /// 0.3 % of them.
    #[test]
    fn of_white_noise_no_other_term_is_written() {
        let all: Vec<String> = (0..RECORDS).flat_map(|seed| written(&made_of(seed, 2000, 0.0))).collect();
        let count = |letter: &str| all.iter().filter(|one| *one == letter).count();
        assert_eq!(count("N") as u64, RECORDS);
        let expected = (1.0 - CERTAINTY) * RECORDS as f64;
        let limit = expected + 5.0 * expected.sqrt();
        let others = ["Q", "B", "K", "R"].map(|letter| count(letter) as f64);
        assert!(others.iter().all(|found| *found <= limit), "{others:?}");
        let sum: f64 = others.iter().sum();
        assert!(sum <= 4.0 * expected + 5.0 * (4.0 * expected).sqrt(), "{others:?}");
        let most = others.iter().copied().fold(0.0, f64::max);
        println!("figure: another term in {most} of {RECORDS} records (limit {limit:.1})");
    }

    /// A term that makes most of the deviation at one end of the curve is written always.
    #[test]
    fn terms_that_are_there_are_written() {
        const RECORDS_OF_THREE: u64 = 20;
        for seed in 0..RECORDS_OF_THREE {
            let mut draws = Draws::new(seed);
            let (mut walk, mut before) = (0.0, 0.0);
            let record = (0..20_000).map(|_| {
                walk += 0.02 * draws.nearly_normal();
                // Rounding of the angle, which is the difference of two errors.
                let after = 5.0 * draws.nearly_normal();
                let one = draws.nearly_normal() + walk + after - before;
                before = after;
                1e-6 * one
            });
            let found = written(&logged(record.collect()));
            for letter in ["Q", "N", "K"] {
                assert!(
                    found.iter().any(|one| one == letter),
                    "seed {seed}: {letter} is not among {found:?}"
                );
            }
        }
        println!("figure: all three in {RECORDS_OF_THREE}");
    }
}
