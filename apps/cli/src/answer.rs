//! What a flight answers, in one sentence.

use sins::units::NMI_PER_HOUR;

use crate::units::{LENGTH, significant, time_text, with_unit};

/// Largest errors that are rounding: a thousand roundings of the Earth's radius [m], and of a tenth of the speed of a bullet [m/s].
const ROUNDING_M: f64 = 1e-6;
const ROUNDING_M_S: f64 = 1e-9;

/// Ratio of the largest error to that at the end from which both are reported.
const PASSED: f64 = 1.2;

/// Errors of a flight, as the flight itself has them or its files. The last record is that of the end, unless the flight was stopped.
#[derive(Debug, Clone, Copy)]
pub struct Answer {
    /// Time flown [s].
    pub duration_s: f64,
    /// Position error at the end: horizontal, and up [m].
    pub end_m: (f64, f64),
    /// Largest horizontal position error [m].
    pub largest_m: f64,
    /// Whether the height is taken from the truth.
    pub follows_height: bool,
    /// Whether it was stopped before its end.
    pub is_stopped: bool,
    /// Begin of NAV [s]; `None`: the unit did not navigate.
    pub nav_from_s: Option<f64>,
    /// R50 [m/s], if the flight has a rate.
    pub r50: Option<f64>,
    /// Largest difference between error data 1 and 2, if both are there [m].
    pub difference_m: Option<f64>,
}

/// Whether an error of position [m] and one of velocity [m/s] are those of rounding.
pub fn is_rounding(position_m: f64, velocity_m_s: f64) -> bool {
    position_m <= ROUNDING_M && velocity_m_s <= ROUNDING_M_S
}

/// The sentence of a flight whose largest position error is `position_m` [m], which is that of rounding.
pub fn of_rounding(duration_s: f64, position_m: f64) -> String {
    let after = time_text(duration_s);
    format!("In {after} there is no error beyond rounding: at most {}.", with_unit(position_m, LENGTH))
}

impl Answer {
    /// The errors at the end, their growth, and how well the error equations agree.
    pub fn sentence(&self) -> String {
        let (end, up) = self.end_m;
        let after = time_text(self.duration_s);
        let Some(nav_from_s) = self.nav_from_s else {
            return format!("In {after} the unit did not navigate.");
        };
        let begin = match self.is_stopped {
            true => format!("The flight was stopped after {after}, before its end:"),
            false => format!("After {after}"),
        };
        let mut sentence = format!("{begin} the INS is {} off", with_unit(end, LENGTH));
        if self.largest_m > PASSED * end {
            sentence += &format!(", at most {}", with_unit(self.largest_m, LENGTH));
        }
        if let Some(rate_m_s) = self.r50 {
            sentence += &format!(", R50 {} nmi/h", significant(rate_m_s / NMI_PER_HOUR));
        }
        if nav_from_s > 0.0 {
            let since = if self.r50.is_some() { " since NAV at" } else { ", in NAV since" };
            sentence += &format!("{since} {}", time_text(nav_from_s));
        }
        if !self.follows_height && up.abs() > end {
            let side = if up > 0.0 { "high" } else { "low" };
            sentence += &format!(", and {} too {side}", with_unit(up.abs(), LENGTH));
        }
        if let Some(difference_m) = self.difference_m {
            sentence += &format!("; the error equations agree to {}", with_unit(difference_m, LENGTH));
        }
        sentence + "."
    }
}
