//! A recorded run.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use nalgebra::Vector3;
use sins::earth::state::Navigation;
use sins::errors::NavigationErrors;
use sins::record::{COLUMNS, NEAR_POLE, NOT_COMPUTED, OUTSIDE_VALIDITY, Record, SIGMA_COLUMNS};
use sins::unit::State;

use crate::drawing::events::Events;
use crate::failure::Failure;
use crate::given::{FileKind, open_table};
use crate::places::beside;
use crate::report::rows::Rows;
use crate::report::summary::Summary;
use crate::table::Table;

/// All recorded data of a run. All columns have one entry for each record.
pub struct Run {
    /// Name in the summary, otherwise the name of the file.
    pub name: String,
    /// Name of the file.
    pub file: String,
    /// Time since the first record [s].
    pub time_s: Vec<f64>,
    pub truth: Places,
    pub navigation: Places,
    /// Error data 2: navigation minus truth.
    pub errors: Errors,
    /// Error data 1: the error differential equations; `None` if they were off.
    pub model: Option<Errors>,
    /// Standard deviations of the errors; `None` if the covariance was off.
    pub sigma: Option<Errors>,
    /// Error of the gyros, measured less ideal, x, y, z [rad/s].
    pub gyro_error_rad_s: [Vec<f64>; 3],
    /// Error of the accelerometers, measured less ideal, x, y, z [m/s²].
    pub accel_error_m_s2: [Vec<f64>; 3],
    /// Failures of the sensors, and corrections of the solution.
    pub events: Events,
    /// States of the unit, each with its begin [s]; empty: there was no unit.
    pub states: Vec<(f64, State)>,
    pub summary: Summary,
    /// The rows of a smoothed log.
    pub rows: Option<Rows>,
}

/// A path over the ground.
pub struct Places {
    pub latitude_rad: Vec<f64>,
    pub longitude_rad: Vec<f64>,
    pub height_m: Vec<f64>,
    /// Velocity east, north, up [m/s].
    pub velocity_m_s: [Vec<f64>; 3],
}

/// Errors, each east, north, up.
pub struct Errors {
    pub position_m: [Vec<f64>; 3],
    pub velocity_m_s: [Vec<f64>; 3],
    pub misalignment_rad: [Vec<f64>; 3],
    flags: Vec<u32>,
}

impl Run {
    /// Reads `path` and the summary beside it.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let summary_path = summary_path(path);
        if path.is_file() {
            // A file of another kind has no summary.
            let (mut input, mut begin) = (open_table(path)?.0, [0; 64]);
            let length = input.read(&mut begin).map_err(|error| Failure::of_input(path, &error))?;
            if let Some(what) = FileKind::of(&begin[..length]).filter(|what| *what != FileKind::Records) {
                return Err(Failure::of_file(path, &format!("is {what}: expected records of sins fly")));
            }
        }
        // The summary is opened before the records: a pipe in the place of the records has no summary, and opening the pipe would wait.
        let summary = File::open(&summary_path).map_err(|error| {
            let what = format!(
                "the summary of {}, which must be in the same folder, cannot be read: {error}",
                path.display()
            );
            Failure::of_file(&summary_path, &what)
        })?;
        let summary = Summary::read(&summary_path, summary)?;
        let (input, _) = open_table(path)?;
        Self::from_table(path, &stem, Table::read(path, input)?, summary)
    }

    fn from_table(path: &Path, stem: &str, mut table: Table, summary: Summary) -> Result<Self, Failure> {
        let lines: Vec<u64> = (0..table.rows()).map(|row| table.line(row)).collect();
        let columns = COLUMNS.iter().map(|name| table.take(name)).collect::<Result<Vec<_>, _>>()?;
        let row = |k: usize| Record::of_values(&std::array::from_fn(|column| columns[column][k]));
        let records: Vec<Record> = (0..lines.len()).map(row).collect();
        let time_s = since_start(path, &lines, &records)?;
        let start_s = records.first().map_or(0.0, |record| record.time_s);
        let has_rows = summary.number("log_rows").is_some_and(|count| count > 0.0);
        let rows = if has_rows { Rows::read(path, start_s)? } else { None };
        let model_was_on = records.iter().any(|record| record.model_flags & NOT_COMPUTED == 0);
        let sigma = table.has(SIGMA_COLUMNS[0]).then(|| Errors::of_sigmas(&mut table)).transpose()?;
        let axes = |of: fn(&Record) -> &Vector3<f64>| axes(&records, of);
        Ok(Self {
            name: summary.value("name").filter(|name| !name.is_empty()).unwrap_or(stem).to_owned(),
            file: path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            time_s,
            truth: Places::of(&records, |record| &record.truth),
            navigation: Places::of(&records, |record| &record.navigation),
            errors: Errors::of(&records, |record| (&record.navigation_error, record.navigation_flags)),
            model: model_was_on
                .then(|| Errors::of(&records, |record| (&record.model_error, record.model_flags))),
            sigma,
            gyro_error_rad_s: axes(|record| &record.gyro_error),
            accel_error_m_s2: axes(|record| &record.accel_error),
            events: summary.events(),
            states: summary.states(),
            rows,
            summary,
        })
    }

    /// What was flown, in words; the name, if the words say nothing.
    pub fn title(&self) -> &str {
        let words = self.summary.value("scene_text").filter(|words| !["", "recorded flight"].contains(words));
        words.unwrap_or(&self.name)
    }

    /// Time from the first record to the last [s].
    pub fn duration_s(&self) -> f64 {
        self.time_s.last().copied().unwrap_or(0.0)
    }

    /// Mean distance of the records [s].
    pub fn spacing_s(&self) -> f64 {
        self.duration_s() / (self.time_s.len() - 1) as f64
    }

    /// Whether the height is taken from the truth, so that up position and velocity have no errors of their own.
    pub fn follows_height(&self) -> bool {
        self.summary.value("vertical") == Some("follow")
    }

    /// Whether it is one of the paper's two simulations, whose figures the paper has.
    pub fn is_of_paper(&self) -> bool {
        let scene = self.summary.value("scene").unwrap_or_default();
        let is_built_in = |name: &&str| scene.strip_suffix(" (built in)") == Some(name);
        // Its title is that of another flight if the settings have replaced what it says.
        ["simulation1", "simulation2"].iter().any(is_built_in) && self.title().contains("paper's simulation")
    }

    /// First and last time at which navigation or truth was near a pole [s].
    pub fn near_pole_s(&self) -> Option<(f64, f64)> {
        self.flagged_s(&self.errors, NEAR_POLE)
    }

    /// First and last time at which the error model was outside its validity [s].
    pub fn model_invalid_s(&self) -> Option<(f64, f64)> {
        self.flagged_s(self.model.as_ref()?, OUTSIDE_VALIDITY)
    }

    fn flagged_s(&self, errors: &Errors, flag: u32) -> Option<(f64, f64)> {
        let mut times =
            self.time_s.iter().zip(&errors.flags).filter(|(_, f)| *f & flag != 0).map(|(t, _)| *t);
        let first = times.next()?;
        Some((first, times.next_back().unwrap_or(first)))
    }
}

/// Path of the summary of the records at `path`.
pub fn summary_path(path: &Path) -> PathBuf {
    beside(path, "_summary.csv")
}

impl Places {
    fn of(records: &[Record], of: fn(&Record) -> &Navigation) -> Self {
        let column = |part: fn(&Navigation) -> f64| records.iter().map(|r| part(of(r))).collect();
        Self {
            latitude_rad: column(|navigation| navigation.place.latitude_rad),
            longitude_rad: column(|navigation| navigation.place.longitude_rad),
            height_m: column(|navigation| navigation.place.height_m),
            velocity_m_s: std::array::from_fn(|axis| records.iter().map(|r| of(r).v_n[axis]).collect()),
        }
    }
}

impl Errors {
    fn of(records: &[Record], of: fn(&Record) -> (&NavigationErrors, u32)) -> Self {
        let three = |part: fn(&NavigationErrors) -> &Vector3<f64>| {
            std::array::from_fn(|axis| records.iter().map(|r| part(of(r).0)[axis]).collect())
        };
        Self {
            position_m: three(|errors| &errors.position_n),
            velocity_m_s: three(|errors| &errors.velocity_n),
            misalignment_rad: three(|errors| &errors.misalignment_n),
            flags: records.iter().map(|r| of(r).1).collect(),
        }
    }

    /// Standard deviations from their own columns.
    fn of_sigmas(table: &mut Table) -> Result<Self, Failure> {
        let mut columns = SIGMA_COLUMNS.iter().map(|name| table.take(name));
        let mut three = || -> Result<[Vec<f64>; 3], Failure> {
            let mut axis = || columns.next().unwrap_or_else(|| Ok(Vec::new()));
            Ok([axis()?, axis()?, axis()?])
        };
        let (position_m, velocity_m_s, misalignment_rad) = (three()?, three()?, three()?);
        Ok(Self { position_m, velocity_m_s, misalignment_rad, flags: Vec::new() })
    }
}

/// Each axis of a vector of the records.
fn axes(records: &[Record], of: fn(&Record) -> &Vector3<f64>) -> [Vec<f64>; 3] {
    std::array::from_fn(|axis| records.iter().map(|record| of(record)[axis]).collect())
}

/// Times less the first time; rejects fewer than two records, and times that do not increase.
fn since_start(path: &Path, lines: &[u64], records: &[Record]) -> Result<Vec<f64>, Failure> {
    if let Some(row) = records.windows(2).position(|pair| pair[1].time_s <= pair[0].time_s) {
        let (before, found) = (records[row].time_s, records[row + 1].time_s);
        let what = format!("column time_s: expected a time later than {before}, found {found}");
        return Err(Failure::of_line(path, lines[row + 1], &what));
    }
    match records {
        [start, _, ..] => Ok(records.iter().map(|record| record.time_s - start.time_s).collect()),
        _ => Err(Failure::of_file(path, &format!("expected at least two rows, found {}", records.len()))),
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// A run of `records` records, 10 s apart, in which the column `name` has the value `value(name, time)`.
    pub fn made(records: u32, value: impl Fn(&str, f64) -> f64) -> Run {
        of_columns(&COLUMNS, records, value)
    }

    /// A run as from `made`, with standard deviations.
    pub fn with_sigmas(records: u32, value: impl Fn(&str, f64) -> f64) -> Run {
        of_columns(&[&COLUMNS[..], &SIGMA_COLUMNS].concat(), records, value)
    }

    fn of_columns(columns: &[&str], records: u32, value: impl Fn(&str, f64) -> f64) -> Run {
        let mut text = columns.join(",");
        for record in 0..records {
            let t = f64::from(record) * 10.0;
            let row: Vec<String> =
                columns.iter().map(|n| if *n == "time_s" { t } else { value(n, t) }.to_string()).collect();
            text += &format!("\n{}", row.join(","));
        }
        let path = Path::new("made.csv");
        let summary = "key,value,unit,label\n\
            name,<made> & \"quoted\",,name of the run\n\
            max_position_m,1234.5,m,largest\n";
        let summary = Summary::read(Path::new("made_summary.csv"), summary.as_bytes()).unwrap();
        Run::from_table(path, "made", Table::read(path, text.as_bytes()).unwrap(), summary).unwrap()
    }

    #[test]
    fn a_good_run_is_read() {
        let run = made(4, |name, t| match name {
            "navigation_error_position_north_m" => 2.0 * t,
            "model_error_flags" if t >= 20.0 => 2.0,
            _ => 0.0,
        });
        assert_eq!(run.errors.position_m[1], [0.0, 20.0, 40.0, 60.0]);
        assert_eq!(run.duration_s(), 30.0);
        assert_eq!(run.model_invalid_s(), Some((20.0, 30.0)));
        assert_eq!(run.near_pole_s(), None);
    }

    #[test]
    fn a_model_that_was_off_is_left_out() {
        let off = made(3, |name, _| if name == "model_error_flags" { 4.0 } else { 0.0 });
        assert!(off.model.is_none());
    }

    #[test]
    fn times_have_to_increase() {
        let path = Path::new("run.csv");
        let at = |times: &[f64]| {
            let record = |time_s: &f64| Record { time_s: *time_s, ..Record::default() };
            let records: Vec<Record> = times.iter().map(record).collect();
            since_start(path, &[2, 4, 7], &records).map_err(|failure| failure.to_string())
        };
        assert_eq!(at(&[5.0, 6.0]).unwrap(), [0.0, 1.0]);
        let failure = at(&[5.0, 6.0, 6.0]).unwrap_err();
        assert!(failure.starts_with("run.csv:7: column time_s"), "{failure}");
        assert!(at(&[5.0]).is_err());
    }

    #[test]
    fn a_missing_summary_is_reported() {
        let folder = tempfile::tempdir().unwrap();
        let run = folder.path().join("lone.csv");
        std::fs::write(&run, "time_s\n").unwrap();
        let failure = Run::read(&run).err().unwrap().to_string();
        assert!(failure.contains("lone_summary.csv: the summary of"));
        std::fs::write(&run, "time_s,error_data,runs,diverged\n").unwrap();
        let failure = Run::read(&run).err().unwrap().to_string();
        let what = "lone.csv: is a table of sins ensemble, which has a page of its own: expected records of sins fly";
        assert!(failure.ends_with(what), "{failure}");
    }
}
