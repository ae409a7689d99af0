//! What the record has beside the path and the errors that were found.

use sins::analysis::identify::{IdealPath, Identified};

use super::record::SensorRecord;
use crate::imu::{Log, Sensor, Series};

/// Longest time between two rows of a piece, in intervals.
const GAP: f64 = 1.5;

/// The residual, of the rows that the path has.
pub struct Residual {
    /// Ends of the intervals, on the clock of the record [s].
    pub times_s: Vec<f64>,
    pub interval_s: f64,
    /// Increments of three gyros, then of three accelerometers.
    pub increments: [Vec<f64>; 6],
}

impl Residual {
    pub fn new(path: &IdealPath, record: &SensorRecord, found: &Identified) -> Self {
        let mut residual =
            Self { times_s: Vec::new(), interval_s: record.interval_s, increments: Default::default() };
        for row in &record.increments {
            let Some(increment) = found.residual(path, row) else { continue };
            residual.times_s.push(row.time_s);
            let six = increment.angle.iter().chain(&increment.velocity);
            residual.increments.iter_mut().zip(six).for_each(|(of, value)| of.push(*value));
        }
        residual
    }

    /// The residual as a record at rest.
    pub fn into_log(self) -> Log {
        let names = ["gyro x", "gyro y", "gyro z", "accelerometer x", "accelerometer y", "accelerometer z"];
        let series =
            self.increments.into_iter().zip(names).enumerate().map(|(k, (increments, name))| Series {
                name: name.to_owned(),
                sensor: if k < 3 { Sensor::Gyro } else { Sensor::Accelerometer },
                increments,
            });
        let gap_s = GAP * self.interval_s;
        Log {
            name: "residual".to_owned(),
            interval_s: self.interval_s,
            series: series.collect(),
            pieces: self.times_s.chunk_by(|a, b| b - a <= gap_s).map(<[f64]>::len).collect(),
            remarks: Vec::new(),
            is_counted: false,
            is_still: true,
            times_s: self.times_s,
            lengths_s: Vec::new(),
            taken: None,
        }
    }
}
