//! Axes: a range, and the places of its ticks.

use crate::units;

/// Range below which the decade of a step underflows to 0.
const LEAST_RANGE: f64 = 1e-300;

/// A range in the plotted unit with its ticks.
#[derive(Debug, Clone)]
pub struct Axis {
    pub low: f64,
    pub high: f64,
    pub ticks: Vec<(f64, String)>,
    pub scale: Scale,
}

/// What the positions of an axis are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scale {
    /// The quantity itself.
    Linear,
    /// Its decimal logarithm.
    Logarithm,
    /// The negative of that.
    NegativeLogarithm,
    /// The decimal logarithm of a period in seconds; the ticks have units of their own.
    Period,
    /// Names: the first tick's at 0, the second's at 1.
    Names,
}

/// Axis of time, and its unit.
#[derive(Debug, Clone)]
pub struct TimeAxis {
    pub axis: Axis,
    pub unit: &'static str,
    /// Length of the unit [s].
    pub seconds: f64,
}

impl Axis {
    /// Axis from `low` to `high` with at most `most` ticks, in steps of 1, 2, 2.5 or 5 times a power of ten.
    pub fn linear(low: f64, high: f64, most: usize) -> Self {
        // A range that is only rounding is widened: ticks that are closer than neighbouring numbers have no end.
        let size = low.abs().max(high.abs());
        let margin = f64::max(1.0, 1e-6 * size);
        let is_rounding = high - low <= (1e-9 * size).max(LEAST_RANGE);
        let (low, high) = if is_rounding { (low - margin, high + margin) } else { (low, high) };
        let rough = (high - low) / most.max(1) as f64;
        let decade = 10f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 2.5, 5.0]
            .map(|m| m * decade)
            .into_iter()
            .find(|s| *s >= rough)
            .unwrap_or(10.0 * decade);
        Self::with_step(low, high, step)
    }

    /// Linear axis with a margin beyond the data from `low` to `high`, for a range of at least `least`.
    pub fn around(low: f64, high: f64, least: f64, most: usize) -> Self {
        let (middle, half) = ((low + high) / 2.0, ((high - low).max(least)) / 2.0);
        Self::linear(middle - 1.08 * half, middle + 1.08 * half, most)
    }

    /// Axis of powers of ten; positions are logarithms.
    pub fn decades(low: f64, high: f64, most: usize) -> Self {
        let every = ((high - low) / most.max(1) as f64).ceil().max(1.0) as i32;
        let ticks = (low.ceil() as i32..=high.floor() as i32)
            .filter(|exponent| exponent.rem_euclid(every) == 0)
            .map(|exponent| (f64::from(exponent), units::power_of_ten(exponent)))
            .collect();
        Self { low, high, ticks, scale: Scale::Logarithm }
    }

    /// Axis of periods in minutes and hours; positions are logarithms of seconds. `room` is the smallest distance of two ticks.
    pub fn periods(low: f64, high: f64, room: f64) -> Self {
        const MINUTES: [f64; 15] = [
            1.0, 3.0, 10.0, 30.0, 60.0, 180.0, 360.0, 720.0, 1440.0, 2880.0, 5760.0, 11_520.0, 23_040.0,
            46_080.0, 92_160.0,
        ];
        let mut ticks: Vec<(f64, String)> = Vec::new();
        for seconds in MINUTES.map(|minutes| minutes * 60.0) {
            let at = seconds.log10();
            let free = ticks.last().is_none_or(|(last, _)| at - last >= room);
            if (low..=high).contains(&at) && free {
                let text = if seconds < 3600.0 {
                    format!("{} min", seconds / 60.0)
                } else {
                    format!("{} h", seconds / 3600.0)
                };
                ticks.push((at, text));
            }
        }
        Self { low, high, ticks, scale: Scale::Period }
    }

    /// Axis of time from 0 to `duration_s`, in seconds, minutes or hours, with at most `most` ticks.
    pub fn time(duration_s: f64, most: usize) -> TimeAxis {
        const HOURS: &[f64] =
            &[0.25, 0.5, 1.0, 2.0, 3.0, 4.0, 6.0, 12.0, 24.0, 48.0, 96.0, 168.0, 336.0, 720.0];
        const MINUTES: &[f64] = &[1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0];
        let (unit, seconds, steps): (_, _, &[f64]) = match duration_s {
            s if s <= 900.0 => ("s", 1.0, &[]),
            s if s <= 3.0 * 3600.0 => ("min", 60.0, MINUTES),
            _ => ("h", 3600.0, HOURS),
        };
        let high = duration_s / seconds;
        let axis = match steps.iter().find(|step| high / **step <= most as f64) {
            Some(step) => Self::with_step(0.0, high, *step),
            None => Self::linear(0.0, high, most),
        };
        TimeAxis { axis, unit, seconds }
    }

    /// Where `value` is between low, 0, and high, 1.
    pub fn share(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }

    /// The axis for the script of a page: its first position, its length, 0 or the sign of the logarithms, its unit; or its names.
    pub fn data(&self, unit: &str) -> String {
        // A space within a name does not end it.
        let names =
            || self.ticks.iter().map(|(_, name)| name.replace(' ', "\u{a0}")).collect::<Vec<_>>().join(" ");
        let scale = match self.scale {
            Scale::Linear => format!("0 {unit}"),
            Scale::Logarithm => format!("1 {unit}"),
            Scale::NegativeLogarithm => format!("-1 {unit}"),
            Scale::Period => "1 s".to_owned(),
            Scale::Names => format!("names {}", names()),
        };
        format!("{} {} {scale}", self.low, self.high - self.low)
    }

    fn with_step(low: f64, high: f64, step: f64) -> Self {
        // The epsilon keeps a tick that rounding puts just outside.
        let (first, last) = ((low / step - 1e-9).ceil() as i64, (high / step + 1e-9).floor() as i64);
        let ticks = (first..=last).map(|k| (k as f64 * step, tick_text(k, step))).collect();
        Self { low, high, ticks, scale: Scale::Linear }
    }
}

/// Text of `k` steps, with the digits that the step needs.
fn tick_text(k: i64, step: f64) -> String {
    let value = k as f64 * step;
    let digits = (0..5).find(|digits| {
        let scaled = step * 10f64.powi(*digits);
        scaled >= 0.999 && (scaled - scaled.round()).abs() < 1e-6 * scaled
    });
    match digits {
        _ if k == 0 => "0".to_owned(),
        Some(digits) if value.abs() < 1e6 => format!("{value:.*}", digits.unsigned_abs() as usize),
        _ => format!("{value:.1e}").replace(".0e", "e"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(axis: &Axis) -> Vec<&str> {
        axis.ticks.iter().map(|(_, text)| text.as_str()).collect()
    }

    #[test]
    fn linear_ticks_are_round() {
        assert_eq!(texts(&Axis::linear(-0.31, 0.72, 5)), ["-0.25", "0", "0.25", "0.50"]);
        assert_eq!(texts(&Axis::linear(-3.0, 8.0, 6)), ["-2", "0", "2", "4", "6", "8"]);
        assert_eq!(texts(&Axis::linear(0.0, 2.4e-7, 3)), ["0", "1e-7", "2e-7"]);
        assert_eq!(texts(&Axis::linear(0.0, 0.0, 4)), ["-1.0", "-0.5", "0", "0.5", "1.0"]);
        for size in [1e30, -1e30, 1e-59] {
            let axis = Axis::around(size, size * (1.0 + 1e-15), 0.0, 5);
            assert!(axis.ticks.len() < 12 && axis.low < axis.high, "{size}: {}", axis.ticks.len());
        }
    }

    /// Ranges of every size that a number has, of both signs and about 0: the number of ticks does not depend on the data.
    #[test]
    fn no_range_has_more_ticks_than_asked_for() {
        let sizes = (-324..=308).map(|decade| 10f64.powi(decade)).chain([5e-324, 1.5e-323, f64::MAX]);
        for size in sizes {
            for (low, high) in [(0.0, size), (-size, 0.0), (-size, size), (size, 1.1 * size), (size, size)] {
                for most in [1, 4, 8] {
                    let axis = Axis::linear(low, high, most);
                    assert!(axis.ticks.len() <= most + 1, "{low} {high}: {} of {most}", axis.ticks.len());
                }
            }
        }
    }

    #[test]
    fn time_is_in_hours_minutes_or_seconds() {
        let day = Axis::time(48.0 * 3600.0, 8);
        assert_eq!((day.unit, texts(&day.axis).join(" ")), ("h", "0 6 12 18 24 30 36 42 48".into()));
        assert_eq!(Axis::time(3600.0, 8).unit, "min");
        let short = Axis::time(600.0, 8);
        assert_eq!((short.unit, texts(&short.axis).join(" ")), ("s", "0 100 200 300 400 500 600".into()));
    }

    #[test]
    fn logarithmic_ticks() {
        assert_eq!(texts(&Axis::decades(-3.5, 1.2, 8)), ["0.001", "0.01", "0.1", "1", "10"]);
        let periods = Axis::periods(600f64.log10(), 172_800f64.log10(), 0.25);
        assert_eq!(texts(&periods), ["10 min", "30 min", "1 h", "3 h", "6 h", "12 h", "24 h", "48 h"]);
    }
}
