//! The flight: sample by sample through the simulator, with its records.

use std::io::Write;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use sins::earth::Earth;
use sins::errors::AccuracyFigures;
use sins::records;
use sins::scene::{self, Play};
use sins::truth::{FlightSample, TruthSummary};
use sins::unit::{Mode, State, Unit, UnitParameters};
use sins::{ClosureFigures, Error, ErrorSource, TrimFigures};

use super::imu;
use super::navigation::{Navigation, Navigations};
use super::shown::{self, Reason, Shown};
use super::unit::UnitFiles;
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
    pub unit: Option<UnitFiles>,
}

impl Files {
    /// Their paths, the records first.
    pub fn paths(&self) -> Vec<PathBuf> {
        let own = [Some(&self.records), self.imu.as_ref()].into_iter().flatten();
        let of_unit = self.unit.iter().flat_map(UnitFiles::files);
        own.chain(of_unit).map(|file| file.path().to_owned()).collect()
    }
}

/// Results of a flight, or of a part of it.
#[derive(Debug, Default)]
pub struct Flown {
    pub records: u64,
    /// Records so near a pole that velocity and misalignment have no east and north.
    pub near_pole: u64,
    pub steps: u64,
    /// Steps in which a gyro, and in which an accelerometer, was beyond its range.
    pub beyond_range: [u64; 2],
    /// Speed of the vehicle at its first sample [m/s].
    pub speed_at_start_m_s: f64,
    /// Whether it then is in motion and tilted: it was aligned level.
    pub is_levelled: bool,
    /// Time that the steps took [s].
    pub seconds: f64,
    /// Largest |error| of the records: position [m], velocity [m/s], misalignment [rad].
    pub largest: [f64; 3],
    /// Largest horizontal position error of the records [m].
    pub largest_radius_m: f64,
    /// Largest |error data 1 - error data 2| of the records: position [m], velocity [m/s].
    pub largest_difference: [f64; 2],
    pub accuracy: Option<(AccuracyFigures, ClosureFigures, TrimFigures)>,
    /// The longest navigation; without a unit, the whole flight; `None`: the unit did not navigate.
    pub navigation: Option<Navigation>,
    /// What the unit shows at the end, and how wrong it is; `None`: there is no unit.
    pub shown_at_end: Option<String>,
    /// Why outputs of the unit were not valid, in the order of their begins.
    pub reasons: Vec<Reason>,
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

/// Flies all of `given`. After an error or a request to stop, the files and the results
/// are those up to then.
pub fn fly(
    given: &Given,
    play: Play,
    files: Files,
    quiet: bool,
) -> Result<(Files, Flown, Result<(), Failure>), Failure> {
    let mut flight = InFlight::new(play, files)?;
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

impl From<scene::Stopped> for Stopped {
    fn from(stopped: scene::Stopped) -> Self {
        Self::Sample(stopped.error)
    }
}

impl From<Failure> for Stopped {
    fn from(failure: Failure) -> Self {
        Self::Output(failure)
    }
}

/// A flight in progress, with its files.
pub struct InFlight {
    play: Play,
    files: Files,
    flown: Flown,
    navigations: Navigations,
    /// The first sample, until the second comes.
    first: Option<FlightSample>,
    /// Whether the last interval has its record, and its row of the unit.
    is_recorded: [bool; 2],
}

impl InFlight {
    /// `play` before its first sample. A bus without a unit has one that navigates.
    pub fn new(mut play: Play, mut files: Files) -> Result<Self, Failure> {
        write_line(&mut files.records, &record::head(play.itinerary().scene().options.covariance))?;
        if let Some(file) = &mut files.imu {
            write_line(file, &imu::COLUMNS.join(","))?;
        }
        if files.unit.is_some() && play.unit().is_none() {
            play.set_unit(Unit::new(&UnitParameters::default(), Mode::Navigate)?);
        }
        Ok(Self {
            play,
            files,
            flown: Flown::default(),
            navigations: Navigations::default(),
            first: None,
            is_recorded: [true; 2],
        })
    }

    /// What the INS shows after the last interval. Without a unit, it navigates.
    pub fn shown(&self) -> Result<Shown, Error> {
        let errors = self.play.simulator().errors(ErrorSource::Navigation)?;
        let position_error_n = errors.map(|(_, errors)| errors.position_n).unwrap_or_default();
        let shown = self.play.shown()?.ok_or_else(|| Error::bad_state("no interval was flown"))?;
        let scene::Shown { status, navigation } = shown;
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
        self.play.push(&sample)?;
        self.first = Some(sample);
        if let Some(start) = Record::now(self.play.simulator_mut())? {
            self.keep(&start)?;
        }
        Ok(())
    }

    /// Takes the next sample, and flies the interval that it ends.
    pub fn go_on(&mut self, sample: FlightSample) -> Result<(), Stopped> {
        self.play.push(&sample)?;
        if let Some(first) = self.first.take() {
            let earth = self.play.itinerary().scene().simulator_options().earth();
            self.flown.speed_at_start_m_s = speed_m_s(&earth, &first, &sample);
            self.flown.is_levelled = first.is_tilted_in_motion();
        }
        self.flown.steps += 1;
        let simulator = self.play.simulator();
        let Some(interval) = simulator.imu() else { return Ok(()) };
        let flags = [interval.flags.gyro_saturated, interval.flags.accel_saturated];
        for (count, is_beyond) in self.flown.beyond_range.iter_mut().zip(flags) {
            *count += u64::from(is_beyond);
        }
        if let Some(file) = &mut self.files.imu {
            let written = imu::write_rows(file, simulator, interval.time_s);
            written.map_err(|error| Failure::of_output(file.path(), &error))?;
        }
        if let Some(unit) = self.play.unit() {
            let time_s = interval.time_s - self.play.itinerary().start_s().unwrap_or_default();
            let status = unit.status();
            self.navigations.take(status.state, simulator, time_s)?;
            shown::note(&mut self.flown.reasons, &status.reasons, time_s);
        }
        if let (Some(files), Some(unit)) = (&mut self.files.unit, self.play.unit()) {
            let words = files.send(unit, simulator, &interval)?;
            files.write(&words)?;
        }
        self.is_recorded = [false; 2];
        self.record(self.play.itinerary().is_due())
    }

    /// Records the last interval of the flight, if it has no record yet.
    pub fn record_last(&mut self) -> Result<(), Stopped> {
        self.record(true)
    }

    /// Writes what the last interval lacks: its record and the row of the unit if they are due, and a new state of the unit.
    fn record(&mut self, is_due: bool) -> Result<(), Stopped> {
        let [has_record, has_row] = &mut self.is_recorded;
        let start_s = self.play.itinerary().start_s().unwrap_or_default();
        if let (Some(files), Some(unit)) = (&mut self.files.unit, self.play.unit())
            && let Some(interval) = self.play.simulator().imu()
            && !*has_row
        {
            let new = files.record(unit, interval.time_s, is_due)?;
            *has_row = is_due || new.is_some();
            if let Some(state) = new {
                self.flown.states.push((interval.time_s - start_s, state));
            }
        }
        if is_due
            && !*has_record
            && let Some(mut record) = Record::now(self.play.simulator_mut())?
        {
            *has_record = true;
            [record.gyro_error, record.accel_error] = self.play.itinerary_mut().take_sensor_errors();
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
        self.files.unit.as_mut().map_or(Ok(()), UnitFiles::check)
    }

    /// The files and the results of the flight.
    pub fn end(mut self) -> Result<(Files, Flown), Failure> {
        let simulator = self.play.simulator();
        if let Ok(Some((_, accuracy, closure))) = simulator.accuracy() {
            self.flown.accuracy = Some((accuracy, closure, simulator.trim()?.unwrap_or_default()));
            self.flown.navigation = match self.play.unit() {
                Some(_) => std::mem::take(&mut self.navigations).longest(accuracy.duration_s),
                None => Some(Navigation::whole(accuracy)),
            };
        }
        if self.play.unit().is_some() && self.play.simulator().imu().is_some() {
            self.flown.shown_at_end = Some(self.shown()?.at_end(self.play.simulator())?);
        }
        if self.play.itinerary().scene().options.truth_summary {
            self.flown.truth = simulator.truth_summary()?;
        }
        self.flown.records = self.flown.records.saturating_sub(self.files.records.settle());
        Ok((self.files, self.flown))
    }

    fn keep(&mut self, record: &Record) -> Result<(), Failure> {
        keep(&mut self.flown, &mut self.files.records, record)
    }
}

/// Speed at the sample `first` [m/s]: its velocity, or without one the way to the sample `next`.
fn speed_m_s(earth: &Earth, first: &FlightSample, next: &FlightSample) -> f64 {
    let way_m = || earth.to_earth_fixed(&next.place) - earth.to_earth_fixed(&first.place);
    first.v_n.unwrap_or_else(|| way_m() / (next.time_s - first.time_s)).norm()
}

/// Writes a record and takes its largest errors.
fn keep(flown: &mut Flown, file: &mut OutputFile, record: &Record) -> Result<(), Failure> {
    let sigmas = record.sigma.iter().flatten().copied();
    write_line(file, &records::line(record.values().into_iter().chain(sigmas)))?;
    flown.records += 1;

    let (errors, model) = (&record.navigation_error, &record.model_error);
    let has_model = record.model_flags & NOT_COMPUTED == 0;
    let raise = |largest: &mut f64, size: f64| *largest = largest.max(size);
    raise(&mut flown.largest[0], errors.position_n.norm());
    raise(&mut flown.largest_radius_m, errors.position_n.xy().norm());
    if has_model {
        raise(&mut flown.largest_difference[0], (model.position_n - errors.position_n).norm());
    }
    if record.navigation_flags & NEAR_POLE != 0 {
        flown.near_pole += 1;
        return Ok(());
    }
    raise(&mut flown.largest[1], errors.velocity_n.norm());
    raise(&mut flown.largest[2], errors.misalignment_n.norm());
    if has_model {
        raise(&mut flown.largest_difference[1], (model.velocity_n - errors.velocity_n).norm());
    }
    Ok(())
}

fn write_line(file: &mut OutputFile, line: &str) -> Result<(), Failure> {
    writeln!(file, "{line}").map_err(|error| Failure::of_output(file.path(), &error))
}
