//! All that was found as one list, in SI units.

use super::Identified;
use super::sheet::{AXES, Line, Sheet, sheets};
use super::text::not_seen;
use super::{Estimate, NoiseEstimate};

/// Number of quantities: shift and drift of the clock, three angles of the mounting; bias, scale factor, two misalignments and three
/// coefficients of the noise of each of the six sensors; then those of [`super::Also`]: nine g-sensitivities, a lever arm, six
/// asymmetries and six changes of biases with temperature.
pub const LISTED: usize = 5 + 6 * (4 + 3) + 9 + 3 + 6 + 6;

/// A quantity that a record may show.
#[derive(Debug, Clone, PartialEq)]
pub struct Listed {
    /// "gyro bias x".
    pub name: String,
    /// SI unit of the figures.
    pub unit: &'static str,
    /// Mean.
    pub value: f64,
    /// 95 % interval; of noise that is not seen from 0 on.
    pub interval: (f64, f64),
    /// Standard deviation with the record and before it; 0 of noise, whose distribution is not normal.
    pub sigmas: (f64, f64),
    /// Why the record does not show it, and what would; `None`: it does.
    pub reason: Option<String>,
}

impl Listed {
    fn new(name: String, unit: &'static str, estimate: &Estimate, shown_by: &str) -> Self {
        let Estimate { value, sigma, prior } = *estimate;
        let reason = match estimate.prior > 0.0 {
            true => (!estimate.is_seen()).then(|| not_seen(shown_by)),
            false => Some("not asked for".to_owned()),
        };
        Self { name, unit, value, interval: estimate.interval(), sigmas: (sigma, prior), reason }
    }

    fn noise(name: String, unit: &'static str, noise: &NoiseEstimate) -> Self {
        let reason =
            (!noise.is_seen()).then(|| "not seen in this record; the interval is its bound".to_owned());
        let NoiseEstimate { value, low, high } = *noise;
        Self { name, unit, value, interval: (low, high), sigmas: (0.0, 0.0), reason }
    }
}

/// All quantities, the clock first, then mounting, gyros and accelerometers, and last what each fit does not have: [`LISTED`].
pub fn listed(found: &Identified) -> Vec<Listed> {
    let mut list = vec![
        Listed::new("clock shift".to_owned(), "s", &found.offset_s, "more turns"),
        Listed::new("clock drift".to_owned(), "1", &found.drift, "a longer record with more turns"),
    ];
    for (angle, axis) in found.mounting.iter().zip(AXES) {
        let shown_by = format!("more turns about other axes than {axis}");
        list.push(Listed::new(format!("mounting {axis}"), "rad", angle, &shown_by));
    }
    let sheets = sheets(found);
    let of_line = |sheet: &Sheet, line: &Line| {
        Listed::new(format!("{} {}", sheet.section, line.name), line.si, &line.estimate, &line.shown_by)
    };
    for sheet in &sheets {
        list.extend(sheet.lines.iter().map(|line| of_line(sheet, line)));
        list.extend(
            sheet.noises.iter().map(|line| {
                Listed::noise(format!("{} {}", sheet.section, line.name), line.si, &line.estimate)
            }),
        );
    }
    for sheet in &sheets {
        list.extend(sheet.also.iter().map(|line| of_line(sheet, line)));
    }
    list
}
