//! The flight: sample by sample through the simulator, with its records.

use std::io::Write;
use std::time::Instant;

use nalgebra::Vector3;
use sins::errors::AccuracyFigures;
use sins::records;
use sins::truth::{FlightSample, TruthSummary};
use sins::unit::State;
use sins::{ClosureFigures, Error, ImuInterval, Simulator, TrimFigures};

use super::imu;
use super::unit::UnitInFlight;
use crate::failure::{Failure, Kind};
use crate::given::Given;
use crate::interrupt;
use crate::output::OutputFile;
use crate::progress::Progress;
use crate::record::{NEAR_POLE, NOT_COMPUTED, Record};

/// Number of samples between two checks of the clock, the signals and the disk.
const CHUNK: usize = 4096;

/// The files that grow with the flight.
pub struct Files {
    pub records: OutputFile,
    pub imu: Option<OutputFile>,
    pub unit: Option<UnitInFlight>,
}

/// Results of a flight, or of a part of it.
#[derive(Debug, Default)]
pub struct Flown {
    pub records: u64,
    pub steps: u64,
    /// Time that the steps took [s].
    pub seconds: f64,
    /// Largest |error| of the records: position [m], velocity [m/s], misalignment [rad].
    pub largest: [f64; 3],
    /// Largest |error data 1 - error data 2| of the records: position [m], velocity [m/s].
    pub largest_difference: [f64; 2],
    pub accuracy: Option<(AccuracyFigures, ClosureFigures, TrimFigures)>,
    /// States of the unit, each with the time of its begin [s].
    pub states: Vec<(f64, State)>,
    /// Summary of the true motion, if the scene requests it.
    pub truth: Option<TruthSummary>,
}

/// Errors of the sensors since the last record: integrals [rad], [m/s], and the time of integration [s].
#[derive(Default)]
struct SensorSum {
    angle: Vector3<f64>,
    velocity: Vector3<f64>,
    time_s: f64,
}

impl SensorSum {
    fn add(&mut self, imu: &ImuInterval) {
        self.angle += imu.measured.angle - imu.ideal.angle;
        self.velocity += imu.measured.velocity - imu.ideal.velocity;
        self.time_s += imu.interval_s;
    }

    /// Returns the mean errors and resets the sum.
    fn take(&mut self) -> [Vector3<f64>; 2] {
        let Self { angle, velocity, time_s } = std::mem::take(self);
        [angle / time_s, velocity / time_s]
    }
}

/// Flies all of `given`, with a record after every `every` intervals. After an error or a request to stop, `flown` has the results
/// up to then.
pub fn fly(
    given: &Given,
    every: u64,
    files: &mut Files,
    flown: &mut Flown,
    quiet: bool,
) -> Result<(), Failure> {
    let [simulator] = &mut *given.scene.simulator()?;
    let sensor_errors = SensorSum::default();
    let result = InFlight { simulator, given, every, files, flown, sensor_errors }.fly(quiet);
    if let Ok(Some((_, accuracy, closure))) = simulator.accuracy() {
        flown.accuracy = Some((accuracy, closure, simulator.trim()?.unwrap_or_default()));
    }
    if given.scene.options.truth_summary {
        flown.truth = simulator.truth_summary()?;
    }
    result
}

/// A flight in progress.
struct InFlight<'a> {
    simulator: &'a mut Simulator,
    given: &'a Given,
    /// Intervals from one record to the next.
    every: u64,
    files: &'a mut Files,
    flown: &'a mut Flown,
    sensor_errors: SensorSum,
}

impl InFlight<'_> {
    fn fly(&mut self, quiet: bool) -> Result<(), Failure> {
        let given = self.given;
        write_line(&mut self.files.records, &records::head(given.scene.options.covariance))?;
        if let Some(file) = &mut self.files.imu {
            write_line(file, &imu::COLUMNS.join(","))?;
        }
        self.push(0, given.sample(0)?)?;
        if let Some(start) = self.record(0)? {
            keep(self.flown, &mut self.files.records, &start)?;
        }
        let progress = Progress::flying("flying", given.count - 1, quiet);
        for first in (1..given.count).step_by(CHUNK) {
            let last = (first + CHUNK).min(given.count);
            // The flight is computed outside of the measured time: a host has its own flight.
            let samples =
                (first..last).map(|index| given.sample(index)).collect::<Result<Vec<_>, Error>>()?;
            let began = Instant::now();
            for (index, sample) in (first..last).zip(samples) {
                self.push(index, sample)?;
                self.step(index)?;
            }
            self.flown.seconds += began.elapsed().as_secs_f64();
            self.files.records.check()?;
            if let Some(file) = &mut self.files.imu {
                file.check()?;
            }
            if interrupt::is_asked() {
                return Err(Failure::of_kind(Kind::Interrupted, "interrupted; the files are complete"));
            }
            progress.fly(last - first, given.period_s);
        }
        Ok(())
    }

    /// Pushes the sample `index`, with the failures and the temperature that are due.
    fn push(&mut self, index: usize, mut sample: FlightSample) -> Result<(), Failure> {
        let prepared = self.given.scene.prepare(self.simulator, self.given.start_s, &mut sample);
        let pushed = prepared.and_then(|()| self.simulator.push_sample(&sample));
        pushed.map(|_| ()).map_err(|error| self.given.stopped_at(index, &error))
    }

    /// Flies the interval that the sample `index` ends.
    fn step(&mut self, index: usize) -> Result<(), Failure> {
        self.simulator.step().map_err(|error| self.given.stopped_at(index, &error))?;
        self.flown.steps += 1;
        if let Some(interval) = self.simulator.imu() {
            self.sensor_errors.add(&interval);
            if let Some(file) = &mut self.files.imu {
                let written = imu::write_rows(file, self.simulator, interval.time_s);
                written.map_err(|error| Failure::of_output(file.path(), &error))?;
            }
        }
        let is_last = index + 1 == self.given.count;
        let is_due = self.simulator.intervals().is_multiple_of(self.every) || is_last;
        if let Some(unit) = &mut self.files.unit
            && let Some(interval) = self.simulator.imu()
        {
            let updated = unit.update(&self.given.scene, self.simulator, self.given.start_s);
            updated.map_err(|error| self.given.stopped_at(index, &error))?;
            let words = unit.send(self.simulator, &interval);
            unit.write(&words.map_err(|error| self.given.stopped_at(index, &error))?)?;
            if let Some(state) = unit.record(interval.time_s, is_due)? {
                self.flown.states.push((interval.time_s - self.given.start_s, state));
            }
        }
        if is_due && let Some(mut record) = self.record(index)? {
            [record.gyro_error, record.accel_error] = self.sensor_errors.take();
            keep(self.flown, &mut self.files.records, &record)?;
        }
        Ok(())
    }

    /// Current record, after the sample `index`.
    fn record(&mut self, index: usize) -> Result<Option<Record>, Failure> {
        Record::now(self.simulator).map_err(|error| self.given.stopped_at(index, &error))
    }
}

/// Writes a record and takes its largest errors.
fn keep(flown: &mut Flown, file: &mut OutputFile, record: &Record) -> Result<(), Failure> {
    let sigmas = record.sigma.iter().flatten().copied();
    write_line(file, &records::line(record.values().into_iter().chain(sigmas)))?;
    flown.records += 1;

    let (errors, model) = (&record.navigation_error, &record.model_error);
    let has_model = model.flags & NOT_COMPUTED == 0;
    let raise = |largest: &mut f64, size: f64| *largest = largest.max(size);
    raise(&mut flown.largest[0], errors.position.norm());
    if has_model {
        raise(&mut flown.largest_difference[0], (model.position - errors.position).norm());
    }
    if errors.flags & NEAR_POLE != 0 {
        // East, north and up misalignment have no meaning near a pole.
        return Ok(());
    }
    raise(&mut flown.largest[1], errors.velocity.norm());
    raise(&mut flown.largest[2], errors.misalignment.norm());
    if has_model {
        raise(&mut flown.largest_difference[1], (model.velocity - errors.velocity).norm());
    }
    Ok(())
}

fn write_line(file: &mut OutputFile, line: &str) -> Result<(), Failure> {
    writeln!(file, "{line}").map_err(|error| Failure::of_output(file.path(), &error))
}
