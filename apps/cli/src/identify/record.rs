//! The record as increments of three gyros and three accelerometers.

use nalgebra::Vector3;
use sins::analysis::identify::RecordedIncrement;
use sins::log::LogMapping;
use sins::scene::Scene;
use sins::signal::Increment;

use super::command::Order;
use super::limits::drop_limited;
use crate::failure::Failure;
use crate::imu::{Log, Sensor, Source, imu_of_file, imu_of_scene, reversed};

/// Fewest rows of the longest piece between gaps: in a record of fewer the gaps are none.
const FEWEST_ROWS: usize = 20;

/// A record of gyros and accelerometers.
pub struct SensorRecord {
    /// Name of its file.
    pub name: String,
    pub interval_s: f64,
    /// What is said of the rate.
    pub counted: &'static str,
    /// Names of the columns: gyros, then accelerometers.
    pub columns: Vec<String>,
    pub increments: Vec<RecordedIncrement>,
    /// Sentences about its stamps.
    pub remarks: Vec<String>,
    /// Whether it was read by an `[imu]` that was given.
    pub is_described: bool,
    /// The `[imu]` that reads it in the same way.
    pub mapping: Option<LogMapping>,
}

impl SensorRecord {
    /// Reads the record by the `[imu]` of the command line, or else that of `truth`.
    pub fn read(order: &Order, truth: &Scene) -> Result<Self, Failure> {
        let of_file =
            order.imu_map.as_deref().map(|path| imu_of_file(path, &order.settings.set)).transpose()?;
        let of_truth = imu_of_scene(truth).filter(|_| order.imu_columns.is_empty());
        let hint = match (&of_file, of_truth) {
            (None, Some(_)) => format!(
                "the [imu] of {} was used; --imu-map or --imu-columns reads the record in another way",
                order.truth.display()
            ),
            _ => String::new(),
        };
        let source = Source {
            path: &order.imu,
            columns: &order.imu_columns,
            flag: "--imu-columns",
            rate_hz: order.rate,
            mapping: of_file.as_ref().or(of_truth),
            hint: &hint,
            most_pieces: usize::MAX,
            fewest_rows: FEWEST_ROWS,
        };
        let log = Log::read(&source)?;
        let of = |sensor: Sensor| log.series.iter().filter(move |series| series.sensor == sensor);
        let columns: Vec<String> =
            of(Sensor::Gyro).chain(of(Sensor::Accelerometer)).map(|series| series.name.clone()).collect();
        let (gyros, accels): (Vec<_>, Vec<_>) =
            (of(Sensor::Gyro).collect(), of(Sensor::Accelerometer).collect());
        let ([gx, gy, gz], [ax, ay, az]) = (&gyros[..], &accels[..]) else {
            let what = format!(
                "expected three columns of gyros and three of accelerometers, found {} and {} ({}); choose them with {}",
                gyros.len(),
                accels.len(),
                columns.join(", "),
                if source.mapping.is_some() { "[imu]" } else { "--imu-columns or [imu]" }
            );
            return Err(source.of_table(Failure::of_line(&order.imu, 1, &what)));
        };
        let sign = if order.reversed { -1.0 } else { 1.0 };
        let row = |k: usize| RecordedIncrement {
            time_s: log.times_s[k],
            interval_s: log.lengths_s.get(k).copied().unwrap_or(log.interval_s),
            increment: Increment {
                angle: Vector3::new(gx.increments[k], gy.increments[k], gz.increments[k]),
                velocity: Vector3::new(ax.increments[k], ay.increments[k], az.increments[k]) * sign,
            },
        };
        let mut increments: Vec<RecordedIncrement> = (0..log.count()).map(row).collect();
        // A row of the same stamp has nothing to say of when it was.
        increments.dedup_by(|next, before| next.time_s <= before.time_s);
        // What drops out writes zeros, and no sensor of a vehicle reads them in all axes.
        let rows = increments.len();
        increments.retain(|row| row.increment != Increment::ZERO);
        let zeros = rows - increments.len();
        let limited = drop_limited(&mut increments);
        let counted = log.counted();
        let mapping = log.taken.map(|taken| if order.reversed { reversed(*taken) } else { *taken });
        let Log { name, interval_s, mut remarks, .. } = log;
        if zeros > 0 {
            remarks.push(format!("{zeros} of {rows} rows, in which all sensors are 0, are left out"));
        }
        remarks.extend(limited);
        let is_described = source.mapping.is_some();
        Ok(Self { name, interval_s, counted, columns, increments, remarks, is_described, mapping })
    }
}
