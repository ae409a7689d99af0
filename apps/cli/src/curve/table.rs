//! The table of the README: the cheapest configuration for each accuracy on each scene.

use super::front::cheapest;
use super::survey::Survey;
use crate::units::{self, brief, time_text, two_digits};

/// Heads of the columns.
pub const HEADS: [&str; 7] = ["scene", "flown for", "100 m", "1 m", "1 cm", "1 mm", "sensors' own error"];

/// Accuracies of the columns in the middle [m].
const ACCURACIES_M: [f64; 4] = [100.0, 1.0, 0.01, 0.001];

/// Table as Markdown: a row for each scene. Accuracies are the largest errors in the time for which a scene is flown: errors of a
/// longer time cannot be derived from them.
pub fn table(surveys: &[Survey]) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let head = line(&HEADS.map(str::to_owned)) + "|---|---|---|---|---|---|---|\n";
    surveys.iter().fold(head, |text, survey| text + &line(&cells(survey)))
}

/// The row of a scene.
pub fn cells(survey: &Survey) -> [String; 7] {
    let [hundred, one, centimetre, millimetre] = ACCURACIES_M.map(|position_m| cell(survey, position_m));
    let [navigation, tactical] = survey.sensors_m.map(rounded);
    let scene = format!("{}: {}", survey.name, survey.title);
    let (time, sensors) = (time_text(survey.duration_s), format!("{navigation}; {tactical}"));
    [scene, time, hundred, one, centimetre, millimetre, sensors]
}

/// The cheapest configuration with an error of at most `position_m` [m] in the scene.
fn cell(survey: &Survey, position_m: f64) -> String {
    match cheapest(&survey.points, position_m) {
        Some((point, measured)) => format!(
            "{} @ {} Hz, {} µs",
            point.configuration.name(),
            short(point.rate_hz),
            two_digits(measured.cost_ns * 1e-3)
        ),
        None => "none".to_owned(),
    }
}

/// `value` with at most one digit after the point.
pub fn short(value: f64) -> String {
    ((10.0 * value).round() / 10.0).to_string()
}

/// A length with two digits.
pub fn rounded(length_m: f64) -> String {
    brief(length_m, units::LENGTH)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::front::{self, tests::made};

    #[test]
    fn the_cheapest_for_each_accuracy() {
        let mut points = vec![made(0, 5e3, 20.0), made(3, 8.14e3, 0.6), made(4, 9e3, 2e-4)];
        front::mark(&mut points);
        let table = table(&[Survey::made("loop", 1800.0, points, [1234.0, 45_600.0])]);
        assert!(table.starts_with("| scene | flown for | 100 m |"));
        let row = table.lines().nth(2).unwrap();
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        assert_eq!((cells[1], cells[2]), ("loop: made", "30 min"));
        assert_eq!(cells[3], "paper 1 @ 50 Hz, 5.0 µs");
        // 0.6 m in the half hour: the limit is not scaled to an hour, where it would be 0.5 m.
        assert_eq!(cells[4], "exact 2 @ 50 Hz, 8.1 µs");
        assert_eq!((cells[5], cells[6]), ("exact 3 @ 50 Hz, 9.0 µs", "exact 3 @ 50 Hz, 9.0 µs"));
        assert_eq!(cells[7], "1.2 km; 46 km");
    }

    #[test]
    fn digits() {
        for (value, text) in [(9.96, "10"), (0.0123, "0.012"), (31.4, "31"), (1234.0, "1200"), (1.0, "1.0")] {
            assert_eq!(two_digits(value), text);
        }
        assert_eq!((rounded(3.2e-9).as_str(), rounded(0.0)), ("3.2×10⁻⁹ m", "0 m".into()));
    }
}
