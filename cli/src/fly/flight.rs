//! The flight: sample by sample through the simulator, with its records.

use std::io::Write;
use std::time::{Duration, Instant};

use nalgebra::Vector3;
use sins::earth::state::Navigation;
use sins::errors::AccuracyFigures;
use sins::records;
use sins::scene::Scene;
use sins::truth::{FlightSample, TruthSummary};
use sins::unit::{State, Status, UnitNavigation, Validity};
use sins::{ClosureFigures, Error, ErrorSource, ImuInterval, Simulator, Solution, TrimFigures};

use super::imu;
use super::spacing::Spacing;
use super::unit::UnitInFlight;
use crate::failure::{Failure, Kind};
use crate::given::Given;
use crate::interrupt;
use crate::output::OutputFile;
use crate::progress::Progress;
use sins::record::{self, NEAR_POLE, NOT_COMPUTED, Record};

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
    /// Records so near a pole that velocity and misalignment have no east and north.
    pub near_pole: u64,
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

impl Flown {
    /// Whether velocity and misalignment have figures.
    pub fn has_axes(&self) -> bool {
        self.near_pole < self.records
    }
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

/// Flies all of `given`. After an error or a request to stop, the files and the results
/// are those up to then.
pub fn fly(
    given: &Given,
    spacing: Spacing,
    files: Files,
    quiet: bool,
) -> Result<(Files, Flown, Result<(), Failure>), Failure> {
    let mut flight = InFlight::new(&given.scene, spacing, given.start_s, files)?;
    let ended = flight.fly(given, quiet);
    let (files, flown) = flight.end()?;
    Ok((files, flown, ended))
}

/// What ends a flight.
pub enum Stopped {
    /// The sample is invalid, or the truth or the solution left its range.
    Sample(Error),
    /// A file cannot be written.
    Output(Failure),
}

impl From<Error> for Stopped {
    fn from(error: Error) -> Self {
        Self::Sample(error)
    }
}

impl From<Failure> for Stopped {
    fn from(failure: Failure) -> Self {
        Self::Output(failure)
    }
}

/// What an INS shows, and its error.
pub struct Shown {
    pub status: Status,
    pub navigation: UnitNavigation,
    /// Position error of the solution, east, north, up [m].
    pub position_error_n: Vector3<f64>,
}

/// A flight in progress: for each sample a push and a step.
pub struct InFlight<'a> {
    scene: &'a Scene,
    simulator: Box<[Simulator; 1]>,
    /// When records are due.
    spacing: Spacing,
    /// Time stamp of the first sample [s].
    start_s: f64,
    files: Files,
    flown: Flown,
    sensor_errors: SensorSum,
    /// Whether the last interval has its record, and its row of the unit.
    is_recorded: [bool; 2],
}

impl<'a> InFlight<'a> {
    /// A flight whose first sample is at `start_s` [s].
    pub fn new(scene: &'a Scene, spacing: Spacing, start_s: f64, mut files: Files) -> Result<Self, Failure> {
        write_line(&mut files.records, &record::head(scene.options.covariance))?;
        if let Some(file) = &mut files.imu {
            write_line(file, &imu::COLUMNS.join(","))?;
        }
        let (simulator, flown, sensor_errors) = (scene.simulator()?, Flown::default(), SensorSum::default());
        Ok(Self { scene, simulator, spacing, start_s, files, flown, sensor_errors, is_recorded: [true; 2] })
    }

    /// What the INS shows after the last interval. Without a unit, it navigates.
    pub fn shown(&self) -> Result<Shown, Error> {
        let [simulator] = &*self.simulator;
        let errors = simulator.errors(ErrorSource::Navigation)?;
        let position_error_n = errors.map(|(_, errors)| errors.position_n).unwrap_or_default();
        if let Some(unit) = &self.files.unit {
            let (status, navigation) = unit.shown(simulator)?;
            return Ok(Shown { status, navigation, position_error_n });
        }
        let Some(Solution { time_s, navigation, .. }) = simulator.navigation()? else {
            return Err(Error::bad_state("no interval was flown"));
        };
        let validity =
            Validity { rates: false, attitude: true, heading: true, position: true, velocity: true };
        let Navigation { place, v_n, euler, .. } = navigation;
        let navigation = UnitNavigation { time_s, validity, place, v_n, euler, ..UnitNavigation::default() };
        let status = Status { state: State::Navigation, validity, ..Status::default() };
        Ok(Shown { status, navigation, position_error_n })
    }

    fn fly(&mut self, given: &Given, quiet: bool) -> Result<(), Failure> {
        let stopped = |index: usize| {
            move |stopped| match stopped {
                Stopped::Sample(error) => given.stopped_at(index, &error),
                Stopped::Output(failure) => failure,
            }
        };
        self.begin(given.sample(0)?).map_err(stopped(0))?;
        let progress = Progress::flying("flying", given.count - 1, quiet);
        for first in (1..given.count).step_by(CHUNK) {
            let last = (first + CHUNK).min(given.count);
            // The flight is computed outside of the measured time: a host has its own flight.
            let samples =
                (first..last).map(|index| given.sample(index)).collect::<Result<Vec<_>, Error>>()?;
            let began = Instant::now();
            for (index, sample) in (first..last).zip(samples) {
                self.go_on(sample).map_err(stopped(index))?;
                if index + 1 == given.count {
                    self.record_last().map_err(stopped(index))?;
                }
            }
            self.add_time(began.elapsed());
            self.check()?;
            if interrupt::is_asked() {
                return Err(Failure::of_kind(Kind::Interrupted, "interrupted; the files are complete"));
            }
            progress.fly(last - first, given.period_s);
        }
        Ok(())
    }

    /// Takes the first sample.
    pub fn begin(&mut self, sample: FlightSample) -> Result<(), Stopped> {
        self.push(sample)?;
        let [simulator] = &mut *self.simulator;
        if let Some(start) = Record::now(simulator)? {
            self.keep(&start)?;
        }
        Ok(())
    }

    /// Takes the next sample, and flies the interval that it ends.
    pub fn go_on(&mut self, sample: FlightSample) -> Result<(), Stopped> {
        self.push(sample)?;
        self.step()
    }

    /// Pushes a sample, with the failures and the temperature that are due.
    fn push(&mut self, mut sample: FlightSample) -> Result<(), Error> {
        let [simulator] = &mut *self.simulator;
        self.scene.prepare(simulator, self.start_s, &mut sample)?;
        simulator.push_sample(&sample).map(|_| ())
    }

    fn step(&mut self) -> Result<(), Stopped> {
        let [simulator] = &mut *self.simulator;
        simulator.step()?;
        self.flown.steps += 1;
        let Some(interval) = simulator.imu() else { return Ok(()) };
        self.sensor_errors.add(&interval);
        if let Some(file) = &mut self.files.imu {
            let written = imu::write_rows(file, simulator, interval.time_s);
            written.map_err(|error| Failure::of_output(file.path(), &error))?;
        }
        let is_due = self.spacing.take(interval.time_s - self.start_s, interval.interval_s);
        if let Some(unit) = &mut self.files.unit {
            unit.update(self.scene, simulator, self.start_s)?;
            let words = unit.send(simulator, &interval)?;
            unit.write(&words)?;
        }
        self.is_recorded = [false; 2];
        self.record(is_due)
    }

    /// Records the last interval of the flight, if it has no record yet.
    pub fn record_last(&mut self) -> Result<(), Stopped> {
        self.record(true)
    }

    /// Writes what the last interval lacks: its record and the row of the unit if they are due, and a new state of the unit.
    fn record(&mut self, is_due: bool) -> Result<(), Stopped> {
        let [simulator] = &mut *self.simulator;
        let [has_record, has_row] = &mut self.is_recorded;
        if let Some(unit) = &mut self.files.unit
            && let Some(interval) = simulator.imu()
            && !*has_row
        {
            let new = unit.record(interval.time_s, is_due)?;
            *has_row = is_due || new.is_some();
            if let Some(state) = new {
                self.flown.states.push((interval.time_s - self.start_s, state));
            }
        }
        if is_due
            && !*has_record
            && let Some(mut record) = Record::now(simulator)?
        {
            *has_record = true;
            [record.gyro_error, record.accel_error] = self.sensor_errors.take();
            self.keep(&record)?;
        }
        Ok(())
    }

    /// Adds the time that steps took.
    pub fn add_time(&mut self, time: Duration) {
        self.flown.seconds += time.as_secs_f64();
    }

    /// Reports an error of the disk.
    pub fn check(&mut self) -> Result<(), Failure> {
        self.files.records.check()?;
        self.files.imu.as_mut().map_or(Ok(()), OutputFile::check)?;
        self.files.unit.as_mut().map_or(Ok(()), UnitInFlight::check)
    }

    /// The files and the results of the flight.
    pub fn end(mut self) -> Result<(Files, Flown), Failure> {
        let [simulator] = &mut *self.simulator;
        if let Ok(Some((_, accuracy, closure))) = simulator.accuracy() {
            self.flown.accuracy = Some((accuracy, closure, simulator.trim()?.unwrap_or_default()));
        }
        if self.scene.options.truth_summary {
            self.flown.truth = simulator.truth_summary()?;
        }
        self.flown.records = self.flown.records.saturating_sub(self.files.records.settle());
        Ok((self.files, self.flown))
    }

    fn keep(&mut self, record: &Record) -> Result<(), Failure> {
        keep(&mut self.flown, &mut self.files.records, record)
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
        flown.near_pole += 1;
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
