//! Navigation on a record from the truth, and the drift at the end of each flight.

use nalgebra::{Matrix3, Vector3};

use super::super::path::IdealPath;
use super::super::rows::above_k;
use super::super::{Identified, RecordedIncrement};
use super::starts::Starts;
use super::truth::Truth;
use super::twin::Twin;
use crate::base::error::{Error, ErrorKind, Rule};
use crate::base::memory::room;
use crate::errors::correction::Correction;
use crate::errors::navigation_minus_truth;
use crate::signal::Increment;
use crate::simulator::Simulator;
use crate::truth::MIN_INTERVAL_S;

/// Longest step, in lengths of an interval of the record, over which a signal is held: lost rows. A longer one is a gap.
const HELD: f64 = 5.0;

/// An increment on the clock and in the axes of the path.
#[derive(Debug, Clone, Copy)]
struct Step {
    begin_s: f64,
    end_s: f64,
    increment: Increment,
    /// The record has a gap before the end.
    is_behind_gap: bool,
}

/// A record on the clock and in the axes of the path.
pub(super) struct Steps(Vec<Step>);

impl Steps {
    /// The steps of `record`. With `is_corrected`, scale factors and misalignments that were found are removed, and the bias at the end of
    /// the record of the fit:
    /// ```text
    /// u = Rᵀ (I + E)⁻¹ (m - b - G f - a/2 |m - b|)            of gyros; of accelerometers without G f
    /// ```
    /// with the specific force f that was measured, and b that of the temperature that `path` has.
    pub fn new(
        path: &IdealPath,
        record: &[RecordedIncrement],
        found: &Identified,
        is_corrected: bool,
    ) -> Result<Self, Error> {
        let from_record = found.rotation.transpose();
        let undo = |part: usize| {
            let (error, bias) = match is_corrected {
                true => ([&found.gyro, &found.accel][part].error_matrix(), found.last_biases(part)),
                false => (Matrix3::zeros(), Vector3::zeros()),
            };
            let inverse = (Matrix3::identity() + error).try_inverse();
            inverse.map(|inverse| (from_record * inverse, bias)).ok_or_else(|| {
                Error::bad_state("scale factors and misalignments that were found have no inverse")
            })
        };
        let ((gyro, gyro_bias), (accel, accel_bias)) = (undo(0)?, undo(1)?);
        let is_removed = f64::from(u8::from(is_corrected));
        let asymmetries = [&found.gyro, &found.accel].map(|triad| triad.asymmetries() * is_removed);
        let sensed = found.g_sensitivities() * is_removed;
        let mut steps = room(record.len())?;
        let mut last_s = None;
        for row in record {
            let end_s = found.path_time_s(row.time_s);
            let begin_s = *last_s.get_or_insert(found.path_time_s(row.time_s - row.interval_s));
            let length_s = end_s - begin_s;
            // Rows that follow each other at once are one step: none is shorter than the shortest that can be navigated.
            if length_s < MIN_INTERVAL_S {
                continue;
            }
            // Stamps scatter and rows are lost: the mean signal holds for the time since the row before.
            let part = length_s / row.interval_s;
            let Increment { angle, velocity } = row.increment;
            let above_k = above_k(path, found.reference_c, [begin_s, end_s]) * is_removed;
            let (gyro_bias, accel_bias) =
                (gyro_bias + found.gyro.warming(above_k), accel_bias + found.accel.warming(above_k));
            let (angle, velocity) =
                (angle * part - gyro_bias * length_s, velocity * part - accel_bias * length_s);
            let asymmetric =
                |signal: Vector3<f64>, of: &Vector3<f64>| signal - 0.5 * of.component_mul(&signal.abs());
            let increment = Increment {
                angle: gyro * (asymmetric(angle, &asymmetries[0]) - sensed * velocity),
                velocity: accel * asymmetric(velocity, &asymmetries[1]),
            };
            steps.push(Step { begin_s, end_s, increment, is_behind_gap: part > HELD });
            last_s = Some(end_s);
        }
        Ok(Self(steps))
    }

    /// Part of the record that the path has [s].
    pub fn within(&self, truth: &Truth) -> Result<(f64, f64), Error> {
        let (from_s, to_s) = truth.ends_s()?;
        let (Some(first), Some(last)) = (self.0.first(), self.0.last()) else {
            return Err(Error::bad_state("the part of the record that is checked is empty"));
        };
        // A step more at each end: flights begin and end at steps of the record.
        let margin_s = 2.0 * (last.end_s - first.begin_s) / self.0.len() as f64;
        Ok((from_s.max(first.begin_s) + margin_s, to_s.min(last.end_s) - margin_s))
    }

    /// Whether the record has all of a time.
    pub fn is_whole(&self, from_s: f64, to_s: f64) -> bool {
        let (first, end) = (self.first(from_s), self.0.partition_point(|step| step.begin_s < to_s));
        !self.0[first.min(end)..end].iter().any(|step| step.is_behind_gap)
    }

    /// The first step that begins at `time_s` [s] or later.
    fn first(&self, time_s: f64) -> usize {
        self.0.partition_point(|step| step.begin_s < time_s)
    }
}

/// Median and root mean square of the drifts of the flights of a duration [m].
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Drifts {
    /// In ascending order. A flight that diverged is infinitely far off.
    pub sorted_m: Vec<f64>,
}

impl Drifts {
    /// The drift that `fraction` of the flights do not exceed [m], interpolated.
    pub fn quantile_m(&self, fraction: f64) -> f64 {
        let count = self.sorted_m.len();
        let place = (fraction * count as f64 - 0.5).clamp(0.0, (count - 1) as f64);
        let below = place as usize;
        let above = (below + 1).min(count - 1);
        if self.sorted_m[above].is_infinite() {
            return if place > below as f64 { f64::INFINITY } else { self.sorted_m[below] };
        }
        self.sorted_m[below] + (self.sorted_m[above] - self.sorted_m[below]) * (place - below as f64)
    }

    pub fn rms_m(&self) -> f64 {
        (self.sorted_m.iter().map(|drift| drift * drift).sum::<f64>() / self.sorted_m.len() as f64).sqrt()
    }
}

/// Drifts of all flights, by duration. The starts of a twin have the errors of the truth.
pub(super) fn medians(
    truth: &Truth,
    steps: &Steps,
    starts: &Starts,
    twin: Option<&Twin>,
) -> Result<Vec<Drifts>, Error> {
    let mut simulator = Simulator::new(&truth.options)?;
    let mut all = room(starts.spans.len())?;
    let mut flight = 0;
    for flights in &starts.spans {
        let mut sorted_m: Vec<f64> = room(flights.starts_s.len())?;
        for &start_s in &flights.starts_s {
            simulator.reset();
            let error = twin.map(|twin| twin.start(flight));
            sorted_m.push(
                match drift_m(truth, steps, (start_s, flights.duration_s), error, &mut simulator) {
                    Err(error) if error.kind == ErrorKind::Diverged => f64::INFINITY,
                    drift_m => drift_m?,
                },
            );
            flight += 1;
        }
        sorted_m.sort_unstable_by(f64::total_cmp);
        all.push(Drifts { sorted_m });
    }
    Ok(all)
}

/// Horizontal distance from the truth at the end of a flight [m].
fn drift_m(
    truth: &Truth,
    steps: &Steps,
    (start_s, duration_s): (f64, f64),
    error: Option<Correction>,
    simulator: &mut Simulator,
) -> Result<f64, Error> {
    let first = steps.first(start_s);
    let begin_s = steps.0.get(first).map_or(start_s, |step| step.begin_s);
    let at = |time_s: f64| {
        truth.at(time_s)?.ok_or_else(|| {
            Error::invalid("path.time_s", time_s, Rule::Sentence("is outside the path at an end of a flight"))
        })
    };
    simulator.start_navigation(begin_s, &at(begin_s)?)?;
    if let Some(error) = error {
        simulator.correct(&error)?;
    }
    let mut end_s = begin_s;
    // Steps of a twin are those of the path, and may be longer than those of the record: none ends behind the path.
    let (_, to_s) = truth.ends_s()?;
    let is_flown = |step: &&Step| step.begin_s < start_s + duration_s && step.end_s <= to_s;
    for step in steps.0[first..].iter().take_while(is_flown) {
        simulator.push_imu(&[step.increment], step.end_s - step.begin_s)?;
        end_s = step.end_s;
    }
    let Some(solution) = simulator.navigation()? else {
        return Err(Error::bad_state("a flight has no navigation"));
    };
    let errors = navigation_minus_truth(&truth.earth, &solution.navigation, &at(end_s)?);
    Ok(errors.position_n.xy().norm())
}
