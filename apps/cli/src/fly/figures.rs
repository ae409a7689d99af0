//! Figures of a flight: what was flown, and its accuracy.

use sins::errors::{AccuracyFigures, SCHULER_S};
use sins::mechanization::VerticalMode;
use sins::scene::{PlannedUpdate, Scene};
use sins::unit::{Mode, State};
use sins::{ClosureFigures, TrimFigures};

use super::flight::Flown;
use super::navigation::Navigation;
use crate::answer::{self, Answer};
use crate::failure::{Failure, Kind};
use crate::given::Given;
use crate::planned;
use crate::units::six_digits;

/// Smallest number of samples for a rate of growth: one sample defines no slope.
const LEAST_SAMPLES: u64 = 2;

/// Largest speed of the first sample of a vehicle at rest, which positions of a receiver show too [m/s].
const AT_REST_M_S: f64 = 0.5;

/// All figures of the summary file and of the terminal.
pub struct Figures<'a> {
    pub given: &'a Given,
    pub name: &'a str,
    pub flown: &'a Flown,
    pub accuracy: AccuracyFigures,
    pub closure: ClosureFigures,
    pub trim: TrimFigures,
    /// Time between two records [s].
    pub every_s: f64,
    pub is_interrupted: bool,
}

impl<'a> Figures<'a> {
    pub fn gather(
        given: &'a Given,
        name: &'a str,
        every_s: f64,
        flown: &'a Flown,
        is_interrupted: bool,
    ) -> Result<Self, Failure> {
        let none = || Failure::of_kind(Kind::Failed, "no interval was flown");
        let (accuracy, closure, trim) = flown.accuracy.ok_or_else(none)?;
        Ok(Self { given, name, flown, accuracy, closure, trim, every_s, is_interrupted })
    }

    pub fn scene(&self) -> &Scene {
        &self.given.scene
    }

    pub fn rate_hz(&self) -> f64 {
        1.0 / self.given.period_s
    }

    /// Computing time of a step [ns].
    pub fn ns_per_step(&self) -> f64 {
        1e9 * self.flown.seconds / self.flown.steps.max(1) as f64
    }

    /// The navigation from whose begin the rates count.
    pub fn navigation(&self) -> Option<&Navigation> {
        self.flown.navigation.as_ref()
    }

    /// The rates: RER, R50, R95; or why there are none. They are errors over the time since NAV, so an update after it, which leaves other
    /// errors than those that have grown since, leaves no rate; and before the end of a Schuler period they depend on the moment.
    pub fn rates(&self) -> Result<&AccuracyFigures, String> {
        let navigation = self.grown()?;
        if !navigation.figures.has_rates() {
            let flown_s = navigation.duration_s();
            let (least, flown) = (six_digits(SCHULER_S / 60.0), six_digits((flown_s / 6.0).round() / 10.0));
            return Err(format!(
                "none: they need {least} min of navigation, a Schuler period, and it navigated {flown} min"
            ));
        }
        Ok(&navigation.figures)
    }

    /// The slope of the line through the horizontal error [m/s]; or why there is none. The line begins at a fixed time after NAV.
    pub fn slope(&self) -> Result<f64, String> {
        let figures = &self.grown()?.figures;
        match figures.window_samples {
            0..LEAST_SAMPLES => Err(format!("none before {} s of navigation", figures.window_start_s)),
            _ => Ok(figures.radial_error_slope_m_s),
        }
    }

    /// The navigation, if its errors have grown by themselves.
    fn grown(&self) -> Result<&Navigation, String> {
        let navigation = self.navigation().ok_or("none: the unit did not navigate")?;
        let is_corrected = |update: &PlannedUpdate| {
            update.at_s < navigation.until_s
                && (update.every_s.is_finite() || update.at_s > navigation.from_s)
        };
        match self.scene().updates.iter().any(is_corrected) {
            true => Err("none: an update after NAV starts the errors anew".to_owned()),
            false => Ok(navigation),
        }
    }

    /// What the flight answers, in one sentence.
    pub fn sentence(&self) -> String {
        let (flown, end) = (self.flown, &self.closure.position_n);
        // Without axes the velocity has no figure.
        let nav_from_s = self.navigation().map(|navigation| navigation.from_s);
        if nav_from_s.is_some() && flown.has_axes() && answer::is_rounding(flown.largest[0], flown.largest[1])
        {
            return answer::of_rounding(self.accuracy.duration_s, flown.largest[0]);
        }
        let answer = Answer {
            duration_s: self.accuracy.duration_s,
            end_m: (end.xy().norm(), end.z),
            largest_m: flown.largest_radius_m,
            follows_height: self.scene().options.vertical == VerticalMode::FollowTruth,
            is_stopped: self.is_interrupted,
            nav_from_s,
            r50: self.rates().ok().map(AccuracyFigures::cep_rate_m_s),
            difference_m: self.scene().options.error_model.then_some(flown.largest_difference[0]),
        };
        answer.sentence()
    }

    /// How the start came about. An alignment of a simulator is one at rest, wherever the flight begins.
    pub fn start(&self) -> String {
        let speed_m_s = self.flown.speed_at_start_m_s;
        let aligned = match speed_m_s > AT_REST_M_S {
            true => format!(
                "aligned as at rest (the flight begins in motion, at {} m/s{})",
                six_digits((10.0 * speed_m_s).round() / 10.0),
                if self.flown.is_levelled { ", tilted; aligned level" } else { "" }
            ),
            false => "aligned at rest".to_owned(),
        };
        match self.scene().unit.start {
            Some(Mode::Off) => "those that the alignment of the unit leaves".to_owned(),
            _ => {
                let set = self.scene().changed_keys();
                let is_set =
                    |is: fn(&str) -> bool| set.iter().any(|key| key.section == "start" && is(key.name));
                let ways = [
                    (aligned.as_str(), is_set(|name| name == "alignment")),
                    ("drawn", is_set(|name| name.contains("_sigma_"))),
                    ("given", is_set(|name| !name.contains("_sigma_") && !name.starts_with("alignment"))),
                ];
                let ways: Vec<&str> = ways.iter().filter(|(_, is)| *is).map(|(way, _)| *way).collect();
                let words = self.set_in("start");
                if ways.is_empty() { words } else { format!("{}: {words}", ways.join(" and ")) }
            }
        }
    }

    /// The states of the unit with their times, and how long it aligned; `None`: the scene has no unit.
    pub fn unit(&self) -> Option<String> {
        self.scene().unit.start?;
        let (states, end_s) = (&self.flown.states, self.accuracy.duration_s);
        let ends = states.iter().skip(1).map(|(from_s, _)| *from_s).chain([end_s]);
        let aligns = |state: &State| {
            matches!(state, State::CoarseAlignment | State::FineAlignment | State::Realignment)
        };
        let aligned_s: f64 = states
            .iter()
            .zip(ends)
            .filter(|((_, state), _)| aligns(state))
            .map(|((from_s, _), end_s)| end_s - from_s)
            .sum();
        let words: Vec<String> = states
            .iter()
            .map(|(from_s, state)| format!("{} {} s", state.word(), six_digits(*from_s)))
            .collect();
        Some(format!("{}; {:.1} min of alignment", words.join(", "), aligned_s / 60.0))
    }

    /// Extremes of the true motion: key, value, unit, label and time stamp of each. Empty unless the scene requests them.
    pub fn truth(&self) -> Vec<(&'static str, f64, &'static str, &'static str, f64)> {
        let Some(truth) = &self.flown.truth else { return Vec::new() };
        [
            ("truth_interval_max_s", &truth.interval_max, "s", "longest interval"),
            ("truth_turn_max_rad", &truth.turn_max, "rad", "largest rotation in an interval"),
            ("truth_rate_max_rad_s", &truth.rate_max, "rad/s", "largest angular rate"),
            ("truth_acceleration_max_m_s2", &truth.acceleration_max, "m/s2", "largest acceleration"),
            ("truth_force_max_m_s2", &truth.force_max, "m/s2", "largest specific force"),
            ("truth_speed_max_m_s", &truth.speed_max, "m/s", "largest speed"),
            ("truth_sideslip_max_rad", &truth.sideslip_max, "rad", "largest sideslip"),
            ("truth_attack_max_rad", &truth.attack_max, "rad", "largest angle of attack"),
            ("truth_height_min_m", &truth.height_min, "m", "lowest height"),
            ("truth_height_max_m", &truth.height_max, "m", "highest height"),
        ]
        .map(|(key, extreme, unit, label)| (key, extreme.value, unit, label, extreme.time_s))
        .to_vec()
    }

    /// Keys that a section of the scene sets, in words; "none" if it sets none.
    pub fn set_in(&self, section: &str) -> String {
        let set = self.scene().changed_keys();
        let words: Vec<String> = set
            .iter()
            .filter(|key| key.section == section)
            .map(|key| {
                format!("{} {} {}", name(key.doc), rounded(&key.value), key.unit).trim_end().to_owned()
            })
            .collect();
        match section {
            _ if !words.is_empty() => words.join(", "),
            "start" => "none: true position, velocity and attitude".to_owned(),
            _ => "none".to_owned(),
        }
    }

    /// Each update with its time, and what leaves them out; "none" if there are no updates.
    pub fn updates(&self) -> String {
        let Scene { updates, options, .. } = self.scene();
        let is_left_out = options.covariance && !updates.is_empty();
        planned::updates(self.scene()) + if is_left_out { "; not in the covariance" } else { "" }
    }
}

/// Name of what a key sets, without the explanation after the name.
fn name(doc: &str) -> &str {
    doc.split([',', ':', ';', '(']).next().unwrap_or(doc).trim_end()
}

/// `value` with its numbers rounded to six digits: the numbers that a person set, without rounding errors of their units.
fn rounded(value: &str) -> String {
    let number = |word: &str| match word.parse::<f64>() {
        Ok(number) if word.parse::<u64>().is_err() => crate::rows::number(six_digits(number)),
        _ => word.to_owned(),
    };
    let is_between = |letter: char| matches!(letter, '[' | ']' | ',' | ' ' | '"');
    let words = value.split_inclusive(is_between).map(|part| match part.strip_suffix(is_between) {
        Some(word) => number(word) + &part[word.len()..],
        None => number(part),
    });
    words.collect::<String>().replace('"', "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_what_stands_before_its_explanation() {
        for (doc, expected) in [
            ("constant bias, measured less true", "constant bias"),
            ("white noise N: angle random walk", "white noise N"),
            ("deflection in the meridian (xi)", "deflection in the meridian"),
            ("mechanization", "mechanization"),
        ] {
            assert_eq!(name(doc), expected);
        }
    }

    #[test]
    fn values_in_words() {
        for (value, words) in [
            ("10.000000000000002", "10"),
            ("[0.5, -0.2, 1e-7]", "[0.5, -0.2, 1e-7]"),
            ("\"rk4\"", "rk4"),
            ("true", "true"),
            ("18446744073709551615", "18446744073709551615"),
        ] {
            assert_eq!(rounded(value), words);
        }
    }
}
