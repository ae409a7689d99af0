//! A recorded run.

use std::fs::File;
use std::path::Path;

use crate::failure::Failure;
use crate::summary::Summary;
use crate::table::Table;

/// Axes of all errors but those of the sensors, in the order of the columns.
pub const EAST_NORTH_UP: [&str; 3] = ["east", "north", "up"];

/// Axes of the sensor errors.
pub const SENSOR_AXES: [&str; 3] = ["x", "y", "z"];

/// Flags of errors, as in the C header: near a pole; outside validity; not computed.
const NEAR_POLE: u32 = 1;
const OUTSIDE_VALIDITY: u32 = 2;
const NOT_COMPUTED: u32 = 4;

/// Everything that was recorded. All columns have one entry a record.
pub struct Run {
    /// Name in the summary, or else of the file.
    pub name: String,
    /// Name of the file.
    pub file: String,
    /// Time since the first record [s].
    pub time_s: Vec<f64>,
    pub truth: Places,
    pub navigation: Places,
    /// Error data 2: navigation minus truth.
    pub errors: Errors,
    /// Error data 1: the error differential equations; none if they were off.
    pub model: Option<Errors>,
    /// Measured less ideal, x, y, z [rad/s].
    pub gyro_error_rad_s: [Vec<f64>; 3],
    /// Measured less ideal, x, y, z [m/s²].
    pub accel_error_m_s2: [Vec<f64>; 3],
    pub summary: Summary,
}

/// A path over the ground.
pub struct Places {
    pub latitude_rad: Vec<f64>,
    pub longitude_rad: Vec<f64>,
    pub height_m: Vec<f64>,
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
        let input =
            File::open(path).map_err(|error| Failure::of_file(path, &format!("cannot be read: {error}")))?;
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let summary_path = path.with_file_name(format!("{stem}_summary.csv"));
        let summary = File::open(&summary_path).map_err(|error| {
            let what =
                format!("the summary that has to lie beside {} cannot be read: {error}", path.display());
            Failure::of_file(&summary_path, &what)
        })?;
        let summary = Summary::read(&summary_path, summary)?;
        Self::from_table(path, &stem, Table::read(path, input)?, summary)
    }

    fn from_table(path: &Path, stem: &str, mut table: Table, summary: Summary) -> Result<Self, Failure> {
        let time_s = since_start(path, table.take("time_s")?)?;
        let truth = Places::take(&mut table, "truth")?;
        let navigation = Places::take(&mut table, "nav")?;
        let errors = Errors::take(&mut table, "error2")?;
        let model = Errors::take(&mut table, "error1")?;
        let model_was_on = model.flags.iter().any(|flags| flags & NOT_COMPUTED == 0);
        Ok(Self {
            name: summary.value("name").filter(|name| !name.is_empty()).unwrap_or(stem).to_owned(),
            file: path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            time_s,
            truth,
            navigation,
            errors,
            model: model_was_on.then_some(model),
            gyro_error_rad_s: table.take_three("gyro_error_{}_rad_s", SENSOR_AXES)?,
            accel_error_m_s2: table.take_three("accel_error_{}_m_s2", SENSOR_AXES)?,
            summary,
        })
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

impl Places {
    fn take(table: &mut Table, prefix: &str) -> Result<Self, Failure> {
        Ok(Self {
            latitude_rad: table.take(&format!("{prefix}_latitude_rad"))?,
            longitude_rad: table.take(&format!("{prefix}_longitude_rad"))?,
            height_m: table.take(&format!("{prefix}_height_m"))?,
        })
    }
}

impl Errors {
    fn take(table: &mut Table, prefix: &str) -> Result<Self, Failure> {
        let mut three = |what: &str| table.take_three(&format!("{prefix}_{what}"), EAST_NORTH_UP);
        Ok(Self {
            position_m: three("position_{}_m")?,
            velocity_m_s: three("velocity_{}_m_s")?,
            misalignment_rad: three("misalignment_{}_rad")?,
            flags: table.take(&format!("{prefix}_flags"))?.into_iter().map(|flags| flags as u32).collect(),
        })
    }
}

/// Times less the first; refuses fewer than two, and such as do not increase.
fn since_start(path: &Path, time_s: Vec<f64>) -> Result<Vec<f64>, Failure> {
    if let Some(row) = time_s.windows(2).position(|pair| pair[1] <= pair[0]) {
        let what =
            format!("column time_s: expected a time later than {}, found {}", time_s[row], time_s[row + 1]);
        return Err(Failure::of_line(path, row as u64 + 3, &what));
    }
    match time_s.first() {
        Some(start) if time_s.len() > 1 => Ok(time_s.iter().map(|t| t - start).collect()),
        _ => Err(Failure::of_file(path, &format!("expected at least two rows, found {}", time_s.len()))),
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// A run of `records` records, 10 s apart, in which the column `name` has the value `value(name, time)`.
    pub fn made(records: u32, value: impl Fn(&str, f64) -> f64) -> Run {
        let three = |pattern: &str, axes: [&str; 3]| axes.map(|axis| pattern.replace("{}", axis));
        let mut names = vec!["time_s".to_owned()];
        for prefix in ["truth", "nav"] {
            names.extend(three(&format!("{prefix}_{{}}"), ["latitude_rad", "longitude_rad", "height_m"]));
        }
        for prefix in ["error2", "error1"] {
            for what in ["position_{}_m", "velocity_{}_m_s", "misalignment_{}_rad"] {
                names.extend(three(&format!("{prefix}_{what}"), EAST_NORTH_UP));
            }
            names.push(format!("{prefix}_flags"));
        }
        names.extend(three("gyro_error_{}_rad_s", SENSOR_AXES));
        names.extend(three("accel_error_{}_m_s2", SENSOR_AXES));
        let mut text = names.join(",");
        for record in 0..records {
            let t = f64::from(record) * 10.0;
            let row: Vec<String> =
                names.iter().map(|n| if n == "time_s" { t } else { value(n, t) }.to_string()).collect();
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
            "error2_position_north_m" => 2.0 * t,
            "error1_flags" if t >= 20.0 => 2.0,
            _ => 0.0,
        });
        assert_eq!(run.errors.position_m[1], [0.0, 20.0, 40.0, 60.0]);
        assert_eq!(run.duration_s(), 30.0);
        assert_eq!(run.model_invalid_s(), Some((20.0, 30.0)));
        assert_eq!(run.near_pole_s(), None);
    }

    #[test]
    fn a_model_that_was_off_is_left_out() {
        let off = made(3, |name, _| if name == "error1_flags" { 4.0 } else { 0.0 });
        assert!(off.model.is_none());
    }

    #[test]
    fn times_have_to_increase() {
        let path = Path::new("run.csv");
        assert_eq!(since_start(path, vec![5.0, 6.0]).unwrap(), [0.0, 1.0]);
        let failure = since_start(path, vec![5.0, 6.0, 6.0]).unwrap_err().to_string();
        assert!(failure.starts_with("run.csv, line 4: column time_s"), "{failure}");
        assert!(since_start(path, vec![5.0]).is_err());
    }

    #[test]
    fn a_missing_summary_is_told() {
        let run = std::env::temp_dir().join("sins_report_lone.csv");
        std::fs::write(&run, "time_s\n").unwrap();
        let failure = Run::read(&run).err().unwrap().to_string();
        std::fs::remove_file(&run).unwrap();
        assert!(failure.contains("sins_report_lone_summary.csv: the summary that has to lie beside"));
    }
}
