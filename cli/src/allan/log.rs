//! An IMU log: columns of rates, forces or increments at equal intervals.

use std::io::Read;
use std::path::Path;

use sins::allan::FEWEST_SAMPLES;

use super::command::Order;
use super::quantity::{Quantity, Sensor, TIMES, choose};
use crate::drawing::series::mean;
use crate::failure::Failure;
use crate::given::open_table;
use crate::progress::Progress;
use crate::table::Table;

/// Limit of the difference between a step and the usual step, as a part of the usual step. A gap differs by a whole step or more.
const JITTER: f64 = 0.5;

/// A column.
pub struct Series {
    pub name: String,
    pub sensor: Sensor,
    /// Angles [rad] or velocities [m/s] over the intervals.
    pub increments: Vec<f64>,
}

/// All columns of one log.
pub struct Log {
    /// Name of the file.
    pub name: String,
    pub interval_s: f64,
    pub series: Vec<Series>,
    /// Whether the rate is that of --rate, and not that of the time stamps of the log.
    pub is_counted: bool,
    /// Whether the user says that the sensor is at rest.
    pub is_still: bool,
}

impl Log {
    /// Reads the log of `order`.
    pub fn read(order: &Order) -> Result<Self, Failure> {
        let path = &order.log;
        let (input, length) = open_table(path)?;
        let what = format!("reading {}", path.display());
        let progress = match length {
            0 => Progress::working(what),
            bytes => Progress::counting(what, bytes as usize),
        };
        Self::from_input(order, progress.reading(input))
    }

    fn from_input(order: &Order, input: impl Read) -> Result<Self, Failure> {
        let path = &order.log;
        let mut columns: Vec<(String, Quantity)> = Vec::new();
        let mut time = None;
        let mut table = Table::read_some(path, input, |names| {
            columns = choose(names, &order.columns).map_err(|failure| Failure::of_line(path, 1, &failure))?;
            time = TIMES.into_iter().find(|(name, _)| names.iter().any(|found| found == name));
            let times = time.iter().map(|(name, _)| (*name).to_owned());
            Ok(columns.iter().map(|(name, _)| name.clone()).chain(times).collect())
        })?;
        if table.rows() < FEWEST_SAMPLES {
            let what = format!("expected at least {FEWEST_SAMPLES} rows, found {}", table.rows());
            return Err(Failure::of_file(path, &what));
        }
        let interval_s = interval(path, &mut table, time, order.rate_hz)?;
        let series = columns.into_iter().map(|(name, quantity)| {
            let unit = quantity.si * if quantity.is_increment { 1.0 } else { interval_s };
            let mut increments = table.take(&name)?;
            increments.iter_mut().for_each(|value| *value *= unit);
            Ok(Series { name, sensor: quantity.sensor, increments })
        });
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let series = series.collect::<Result<_, Failure>>()?;
        let is_counted = order.rate_hz.is_some() && time.is_some();
        Ok(Self { name, interval_s, series, is_counted, is_still: order.still })
    }

    pub fn count(&self) -> usize {
        self.series.first().map_or(0, |series| series.increments.len())
    }

    pub fn duration_s(&self) -> f64 {
        self.count() as f64 * self.interval_s
    }
}

/// The interval of --rate, which counts rows, or the mean step of the stamps; rejects stamps that are not at equal steps.
fn interval(
    path: &Path,
    table: &mut Table,
    time: Option<(&str, f64)>,
    rate_hz: Option<f64>,
) -> Result<f64, Failure> {
    if let Some(rate_hz) = rate_hz {
        return Ok(1.0 / rate_hz);
    }
    let Some((name, unit)) = time else {
        let header = table.header();
        let what = format!("expected a column \"time_s\" in the header, or --rate; the header has {header}");
        return Err(Failure::of_line(path, 1, &what));
    };
    let stamps = table.take(name)?;
    let steps: Vec<f64> = stamps.windows(2).map(|pair| (pair[1] - pair[0]) * unit).collect();
    let usual = usual(&steps);
    if let Some(row) = steps.iter().position(|step| (step - usual).abs() >= JITTER * usual) {
        let what = format!(
            "column {name}: expected a step of about {usual:.6} s, found {:.6} s; an Allan deviation needs equal steps (--rate: counts rows)",
            steps[row]
        );
        return Err(Failure::of_line(path, table.line(row + 1), &what));
    }
    Ok((stamps[stamps.len() - 1] - stamps[0]) * unit / steps.len() as f64)
}

/// The mean step without gaps. Not the median: stamps with few digits have steps of two lengths, and the median is one of the two.
fn usual(steps: &[f64]) -> f64 {
    let mut sorted = steps.to_vec();
    let middle = sorted.len() / 2;
    let median = *sorted.select_nth_unstable_by(middle, f64::total_cmp).1;
    let single: Vec<f64> = steps.iter().copied().filter(|step| *step < 1.75 * median).collect();
    mean(&single)
}

#[cfg(test)]
pub mod tests {
    use super::*;

    fn order(rate_hz: Option<f64>) -> Order {
        let (log, output) = ("log.csv".into(), Some("out.svg".into()));
        Order { log, output, points: None, rate_hz, still: false, columns: Vec::new(), force: false }
    }

    /// Reads a log with the rows `time(k)`, k.
    fn read(header: &str, rate_hz: Option<f64>, time: impl Fn(u32) -> String) -> Result<Log, String> {
        let rows: Vec<String> = (0..60).map(|k| format!("{},{k}\n", time(k))).collect();
        let text = format!("{header}\n{}", rows.concat());
        Log::from_input(&order(rate_hz), text.as_bytes()).map_err(|failure| failure.to_string())
    }

    #[test]
    fn rates_become_increments() {
        let log = read("time_ms,gyro_x_deg_s", None, |k| (1000 + 5 * k).to_string()).unwrap();
        assert!((log.interval_s - 0.005).abs() < 1e-15 && (log.duration_s() - 0.3).abs() < 1e-12);
        let expected = 2f64.to_radians() * 0.005;
        assert!((log.series[0].increments[2] - expected).abs() < 1e-15);
    }

    #[test]
    fn increments_stay_and_a_rate_needs_no_stamps() {
        let log = read("count,delta_v_m_s", Some(50.0), |k| format!("n{k}")).unwrap();
        assert_eq!((log.interval_s, log.series[0].increments[7]), (0.02, 7.0));
        let failure = read("count,delta_v_m_s", None, |k| k.to_string()).err().unwrap();
        assert!(failure.starts_with("log.csv:1: ") && failure.contains("--rate"), "{failure}");
    }

    #[test]
    fn jitter_is_taken_and_gaps_are_reported() {
        let stamps = |k: u32| format!("{:.3}", f64::from(k) * 0.0025);
        let log = read("time_s,a_g", None, stamps).unwrap();
        assert!((log.interval_s - 0.0025).abs() < 1e-5);
        for late in [1, -1] {
            let gap = |k: u32| format!("{:.2}", f64::from(k as i32 + if k < 30 { 0 } else { late }) * 0.01);
            let failure = read("time_s,a_g", None, gap).err().unwrap();
            assert!(
                failure.starts_with("log.csv:32: column time_s") && failure.contains("--rate"),
                "{failure}"
            );
            // --rate believes the count.
            let log = read("time_s,a_g", Some(100.0), gap).unwrap();
            assert!((log.interval_s, log.count(), log.is_counted) == (0.01, 60, true));
        }
    }

    #[test]
    fn short_logs_are_reported() {
        let failure = Log::from_input(&order(Some(1.0)), "a_g\n1\n".as_bytes()).err().unwrap().to_string();
        assert!(failure.contains("found 1"), "{failure}");
    }
}
