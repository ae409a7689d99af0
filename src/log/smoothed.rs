//! The smoothed path of a log, as a log.

use nalgebra::Vector3;

use super::{FlightLog, LogError, LogMapping, fault};
use crate::base::math::hypot;
use crate::base::memory::room;
use crate::base::text::Fault;
use crate::base::units::DEG;
use crate::earth::{Earth, Geodetic};
use crate::judge::{Finding, Judge, Level};
use crate::log::smooth::{ASSUMED_ATTITUDE_COSTS, SmoothOptions, Smoothed, SmoothedPart};
use crate::truth::FlightSample;

/// Most samples of a smoothed log: of any, and of one with few rows, 1e6 and so many a row, whatever their time stamps are.
const MOST_SAMPLES: f64 = 2e7;
const FEW_ROWS: f64 = 1e6;
const OF_A_ROW: f64 = 4000.0;

/// Share of the largest residual and the noise beyond which that of the rows without weight is another.
const FARTHER: f64 = 2.0;

/// A row that a path was fitted to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RowOfPath {
    /// Its time stamp [s].
    pub time_s: f64,
    /// Its position.
    pub place: Geodetic,
    /// Its position less that of the path at its time stamp, east, north, up [m].
    pub residual_n: Vector3<f64>,
}

/// How a log becomes a smooth path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Smoothing {
    /// Rate of the samples of the path [Hz].
    rate_hz: f64,
    options: SmoothOptions,
}

impl LogMapping {
    /// How the path is smoothed; `None`: it is not.
    pub(super) fn smoothing(&self) -> Option<Smoothing> {
        let options = SmoothOptions {
            position_sigma_m: self.position_sigma_m,
            attitude_sigma_rad: self.attitude_sigma_rad,
            coordinated_attack_rad: self.is_coordinated.then_some(self.attack_rad),
        };
        self.smooths().then_some(Smoothing { rate_hz: self.smooth_rate_hz, options })
    }
}

impl FlightLog {
    /// The path of [`Smoothed`] through its samples, sampled at [`LogMapping::smooth_rate_hz`]. Its notes say what was done. A log that is
    /// not to be smoothed is its own path. What flies is compared with the columns that are not read.
    pub fn smoothed(self, earth: &Earth) -> Result<Self, LogError> {
        let flown = match self.smoothing {
            Some(smoothing) => self.through_rows(earth, &smoothing)?,
            None => self,
        };
        Ok(flown.compared())
    }

    fn through_rows(&self, earth: &Earth, smoothing: &Smoothing) -> Result<Self, LogError> {
        let Smoothing { rate_hz, options } = *smoothing;
        let smoothed = Smoothed::new(earth, &self.samples, &options).map_err(|error| {
            let line = error.index.and_then(|index| self.line(index)).unwrap_or_default();
            fault(line, 1, format!("{error}{}", self.what_may_be_the_cause(earth)))
        })?;
        let [start_s, end_s] = smoothed.span_s();
        let intervals = (end_s - start_s) * rate_hz;
        let most = MOST_SAMPLES.min(FEW_ROWS + OF_A_ROW * self.samples.len() as f64);
        if !(1.0..=most).contains(&intervals) {
            let sentence =
                format!("log.smooth_rate_hz = {rate_hz}: {intervals} samples; must be from 1 to {most}");
            return Err(fault(0, 1, sentence));
        }
        let count = intervals.floor() as usize + 1;
        let mut samples = room(count).map_err(LogError::Memory)?;
        let mut lines = room(count).map_err(LogError::Memory)?;
        let mut row = 0;
        for k in 0..count {
            let time_s = (start_s + k as f64 / rate_hz).min(end_s);
            while self.samples.get(row + 1).is_some_and(|next| next.time_s <= time_s) {
                row += 1;
            }
            let sample = smoothed.sample_at(time_s).and_then(|sample| sample.validate().map(|()| sample));
            samples.push(sample.map_err(|error| {
                let (line, cause) = (self.line(row).unwrap_or_default(), self.what_may_be_the_cause(earth));
                fault(line, 1, format!("the path through the rows: {error}{cause}"))
            })?);
            lines.extend(self.line(row));
        }
        let rows = self.rows_of_path(earth, &smoothed)?;
        let had_velocities = self.samples[0].v_n.is_some();
        let said = said(&smoothed, had_velocities, &rows).into_iter();
        let said = said.map(|sentence| Fault { sentence, ..Fault::default() });
        let notes = self.notes.iter().cloned().chain(said).collect();
        let mut of_rows = self.of_rows.clone();
        of_rows.extend(smoothed.findings.iter().map(|finding| {
            let line = self.line(finding.at.row as usize).unwrap_or_default();
            let after_s = (finding.at.time_s - start_s).max(0.0);
            let row = ((after_s * rate_hz) as u64).min(count as u64 - 1);
            (finding.of_rows(row), line)
        }));
        of_rows.extend(Finding::of_scatter(smoothed.position().noise).map(|finding| (finding, 0)));
        Ok(Self {
            title: self.title.clone(),
            samples,
            lines,
            notes,
            of_rows,
            rows,
            has_attitude: self.has_attitude,
            mapping: self.mapping.clone(),
            smoothing: None,
            unread: self.unread.clone(),
        })
    }
}

impl FlightLog {
    /// The rows, and how far each is from the path.
    fn rows_of_path(&self, earth: &Earth, smoothed: &Smoothed) -> Result<Vec<RowOfPath>, LogError> {
        let mut rows = room(self.samples.len()).map_err(LogError::Memory)?;
        for FlightSample { time_s, place, .. } in &self.samples {
            // Rows from before the first fix are before the path.
            let Ok(path) = smoothed.sample_at(*time_s) else { continue };
            let (d_e, axes) = earth.displacement(place, &path.place);
            let [east, north, _] = axes.map(|axis| axis.dot(&d_e));
            let residual_n = Vector3::new(east, north, place.height_m - path.place.height_m);
            rows.push(RowOfPath { time_s: *time_s, place: *place, residual_n });
        }
        Ok(rows)
    }

    /// The worst that is found in rows that no path can be fitted to, as the end of a sentence.
    fn what_may_be_the_cause(&self, earth: &Earth) -> String {
        let judged = Judge::new(*earth, f64::INFINITY).ok().and_then(|mut judge| {
            self.judge(&mut judge, self.samples.len()).ok()?;
            judge.findings().find(|finding| finding.level >= Level::Doubtful)
        });
        judged.map_or(String::new(), |finding| format!("; is it this? {}", finding.of_rows(finding.at.row)))
    }
}

/// What was done, in lines.
fn said(smoothed: &Smoothed, had_velocities: bool, rows: &[RowOfPath]) -> Vec<String> {
    // The rows that are left out are far from a path that is wrong.
    let all = |part: &SmoothedPart, of: fn(&RowOfPath) -> f64| {
        let farthest = rows.iter().max_by(|a, b| of(a).total_cmp(&of(b)));
        let beyond = farthest.filter(|row| of(row) > FARTHER * (part.largest + part.noise));
        beyond.map_or(String::new(), |row| {
            let (largest, at_s) = (digits(of(row)), thousandths(row.time_s));
            format!("; {largest} m at {at_s} s with the rows that are left out")
        })
    };
    let (position, height) = (smoothed.position(), smoothed.height());
    let horizontal = |row: &RowOfPath| hypot(row.residual_n.x, row.residual_n.y);
    let mut lines = vec![
        of_part("position", &position, "m", 1.0) + &all(&position, horizontal),
        of_part("height", &height, "m", 1.0) + &all(&height, |row| row.residual_n.z.abs()),
    ];
    if let Some((count, interval_s)) = smoothed.corrections {
        let interval_s = thousandths(interval_s);
        lines.push(format!(
            "{count} jumps are taken out, one every {interval_s} s: those of a filter that is corrected at fixes"
        ));
    }
    if smoothed.is_coordinated {
        let [aeroplanes, gliders, hovering] = ASSUMED_ATTITUDE_COSTS;
        lines.push(format!(
            "attitude: assumed, that of a coordinated flight without wind; CEP50 and R95 of an INS differ in nine of ten cases by up to {} % from those of the flight for aeroplanes, up to {} % for gliders that circle and ships, and up to a factor of {hovering} for what stops or hovers",
            100.0 * aeroplanes,
            100.0 * gliders
        ));
    } else {
        lines.push(of_part("attitude", &smoothed.attitude(), "deg", DEG));
    }
    if smoothed.left_out > 0 {
        lines.push(format!(
            "the positions of {} rows are left out: from before the first fix, repeats, or too near to the row before",
            smoothed.left_out
        ));
    }
    if smoothed.cut_s > 0.0 {
        let cut_s = thousandths(smoothed.cut_s);
        lines.push(format!("the path begins {cut_s} s behind the first row: it needs rows on both sides"));
    }
    if smoothed.is_steady_clock {
        lines.push("the time stamps are replaced by those of a steady clock".to_owned());
    }
    if had_velocities {
        lines
            .push("the velocities of the log are not used: those of the path are its derivatives".to_owned());
    }
    lines
}

/// What was done to a part.
fn of_part(name: &str, part: &SmoothedPart, unit: &str, si: f64) -> String {
    format!(
        "{name}: motion above {} Hz is lost; noise {} {unit}; {} outlier{}; largest residual {} {unit} at {} s",
        thousandths(part.cutoff_hz),
        digits(part.noise / si),
        part.outliers,
        if part.outliers == 1 { "" } else { "s" },
        digits(part.largest / si),
        thousandths(part.largest_at_s)
    )
}

fn thousandths(value: f64) -> f64 {
    (value * 1e3).round() / 1e3
}

/// A number with two significant digits.
fn digits(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if size >= 100.0 => format!("{value:.0}"),
        size if size >= 1.0 => format!("{value:.1}"),
        size if size >= 1e-3 => format!("{value:.4}"),
        _ => format!("{value:.1e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{FlightLog, LogError};
    use crate::earth::Earth;
    use crate::scene::Scene;

    /// Stamps that are too near for their rows make a path that nothing flies: it is refused at a row, with the cause.
    #[test]
    fn a_path_beyond_the_limits_of_samples_is_refused_at_its_row() {
        let scene = Scene::parse(b"[flight]\nfile = \"a.csv\"\n[log]\nsmooth = \"auto\"\n").unwrap();
        let smoothed = |step_s: f64| {
            let row = |k: u32| {
                let (time_s, latitude) = (step_s * f64::from(k), 47.0 + 3.6e-4 * f64::from(k));
                format!("{time_s},{latitude:.8},8,500,0,0,0\n")
            };
            let names = "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n";
            let table = names.to_owned() + &(0..300).map(row).collect::<String>();
            FlightLog::parse_with(table.as_bytes(), &scene.log).unwrap().smoothed(&Earth::default())
        };
        assert!(smoothed(1.0).is_ok());
        let Err(LogError::Fault(fault)) = smoothed(0.001) else { panic!("40 km/s is flown") };
        assert!(fault.line >= 2 && fault.sentence.contains("velocity_enu_m_s[1]"), "{fault:?}");
        assert!(fault.sentence.starts_with("the path through the rows: "), "{fault:?}");
    }
}
