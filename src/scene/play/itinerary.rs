//! The plan of a scene in flight, and the place in it.

use core::fmt;
use std::sync::Arc;

use nalgebra::Vector3;

use super::super::schedule::LATEST_START_S;
use super::super::{FliesScene, Scene};
use super::{Source, Spacing};
use crate::base::error::Error;
use crate::base::snapshot::{CLOCK_S, COUNT, SIGNALS, stored};
use crate::sensors::SensorOutput;
use crate::simulator::{ImuInterval, Simulator, Step};
use crate::truth::{FlightSample, Pushed};
use crate::unit::Unit;

/// What a scene does over the time of its flight, and how far it has come: all of a scene in flight but its simulator and its unit.
#[derive(Debug, Clone)]
pub struct Itinerary {
    scene: Arc<Scene>,
    source: Source,
    /// Number of samples; `None`: the host's, without an end.
    count: Option<u64>,
    pub(super) place: Place,
}

/// How far a scene has come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    /// Number of samples that were accepted.
    pub taken: u64,
    /// Time stamp of the first of them [s].
    pub start_s: f64,
    /// The interval whose updates were made last [s], so that a sample that is rejected does not repeat them.
    pub updated_s: Option<[f64; 2]>,
    /// When records are due.
    pub spacing: Spacing,
    /// Whether one is due after the last interval.
    pub is_due: bool,
    pub sensors: SensorSum,
}

stored!(Place { taken: COUNT, start_s: LATEST_START_S, updated_s: CLOCK_S, spacing, is_due, sensors });

/// Errors of the sensors since the last record: integrals [rad], [m/s], and the time of integration [s].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct SensorSum {
    angle: Vector3<f64>,
    velocity: Vector3<f64>,
    time_s: f64,
}

stored!(SensorSum { angle: SIGNALS, velocity: SIGNALS, time_s: CLOCK_S });

impl SensorSum {
    fn add(&mut self, imu: &ImuInterval) {
        self.angle += imu.measured.angle - imu.ideal.angle;
        self.velocity += imu.measured.velocity - imu.ideal.velocity;
        self.time_s += imu.interval_s;
    }
}

/// Why a flight stopped, and where.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stopped {
    /// What is wrong with the sample, the truth, the solution, or an entry at the panel.
    pub error: Error,
    /// Time stamp of the sample [s].
    pub time_s: f64,
    /// Its line in the log, if the flight is one.
    pub line: Option<u64>,
}

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { error, time_s, line } = self;
        match line {
            Some(line) => write!(f, "at {time_s} s, line {line} of the log: {error}"),
            None => write!(f, "at {time_s} s: {error}"),
        }
    }
}

impl core::error::Error for Stopped {}

impl Itinerary {
    /// `scene` before its first sample, on the samples of `source`.
    pub fn new(scene: Arc<Scene>, source: Source) -> Result<Self, Error> {
        let samples = source.samples(&scene)?;
        let spacing = Spacing::of(&scene, &source, samples.as_ref())?;
        let count = samples.map(|samples| samples.count as u64);
        let place = Place {
            taken: 0,
            start_s: 0.0,
            updated_s: None,
            spacing,
            is_due: false,
            sensors: SensorSum::default(),
        };
        Ok(Self { scene, source, count, place })
    }

    /// The scene.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Takes over what another scene plans, from the next interval of `simulator` on: temperature, failures, updates, the panel. Failures
    /// that are no longer planned end. Flight, options and unit stay. After an error nothing has changed.
    pub fn set_plan(&mut self, simulator: &mut Simulator, scene: &Scene) -> Result<(), Error> {
        let Scene { flight, duration_s, rate_hz, options, unit, .. } = (*self.scene).clone();
        let planned = Scene { flight, duration_s, rate_hz, options, unit, ..scene.clone() };
        for output in SensorOutput::ALL {
            let plans = |scene: &Scene| scene.failures.iter().any(|planned| planned.output == output);
            if plans(&self.scene) && !plans(&planned) {
                simulator.set_failure(output, None)?;
            }
        }
        self.scene = Arc::new(planned);
        Ok(())
    }

    /// Where the samples come from.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// Number of samples; `None`: the host's, without an end.
    pub fn count(&self) -> Option<u64> {
        self.count
    }

    /// Number of samples that were flown, the first one included.
    pub fn taken(&self) -> u64 {
        self.place.taken
    }

    /// Whether all samples were flown.
    pub fn is_over(&self) -> bool {
        self.count.is_some_and(|count| self.place.taken >= count)
    }

    /// Time stamp of the first sample [s]; `None`: none was taken.
    pub fn start_s(&self) -> Option<f64> {
        (self.place.taken > 0).then_some(self.place.start_s)
    }

    /// Time between two records [s].
    pub fn every_s(&self) -> f64 {
        self.place.spacing.every_s
    }

    /// Sets when records are due, before the first interval.
    pub fn set_spacing(&mut self, spacing: Spacing) {
        self.place.spacing = spacing;
    }

    /// Whether there is a record now: of the first sample, at the spacing of the records, and of the last sample of the scene.
    pub fn is_due(&self) -> bool {
        self.place.is_due
    }

    /// Mean errors of gyros [rad/s] and accelerometers [m/s²], measured less ideal, since the last call; the next ones count from now on.
    pub fn take_sensor_errors(&mut self) -> [Vector3<f64>; 2] {
        let SensorSum { angle, velocity, time_s } = core::mem::take(&mut self.place.sensors);
        if time_s > 0.0 { [angle / time_s, velocity / time_s] } else { [Vector3::zeros(); 2] }
    }

    /// The next sample of the scene; `None`: the flight is over.
    pub fn next_sample(&self) -> Result<Option<FlightSample>, Stopped> {
        if self.is_over() {
            return Ok(None);
        }
        let sample = self.source.sample(self.place.taken as usize, &self.scene);
        sample.map(Some).map_err(|error| self.stopped(error, self.place.start_s))
    }

    /// Flies `simulator` with its unit to the next sample of the scene; `None`: the flight is over. No allocation.
    pub fn fly_next(
        &mut self,
        simulator: &mut Simulator,
        unit: Option<&mut Unit>,
    ) -> Result<Option<Pushed>, Stopped> {
        // An interval that could not be flown waits.
        if simulator.waiting_samples() > usize::from(!simulator.has_started()) {
            let last_s = simulator.last_sample_time_s().unwrap_or_default();
            let flown = self.fly_waiting(simulator, unit);
            return flown.map(|()| Some(Pushed::Regular)).map_err(|error| self.stopped(error, last_s));
        }
        match self.next_sample()? {
            Some(sample) => self.push(simulator, unit, &sample).map(Some),
            None => Ok(None),
        }
    }

    /// Flies `simulator` with its unit to a sample of the host. No allocation.
    pub fn push(
        &mut self,
        simulator: &mut Simulator,
        unit: Option<&mut Unit>,
        sample: &FlightSample,
    ) -> Result<Pushed, Stopped> {
        let pushed = self.take(simulator, sample).map_err(|error| self.stopped(error, sample.time_s))?;
        let flown = self.fly_waiting(simulator, unit);
        self.place.is_due |= self.place.taken == 1;
        flown.map(|()| pushed).map_err(|error| self.stopped(error, sample.time_s))
    }

    /// Gives `flown` a sample with all that the scene plans until then: temperature, failures, updates. A step has to follow.
    pub fn take(&mut self, flown: &mut dyn FliesScene, sample: &FlightSample) -> Result<Pushed, Error> {
        let mut sample = *sample;
        let start_s = self.start_s().unwrap_or(sample.time_s);
        // A sample that is not later ends no interval, and is rejected.
        let is_later = flown.last_sample_time_s().is_none_or(|last_s| sample.time_s > last_s);
        if let Some(begin_s) = self.scene.begin(flown, start_s, &mut sample)?
            && is_later
        {
            let last_s = flown.last_interval_s();
            if self.place.updated_s != last_s {
                self.scene.update(flown, start_s, begin_s)?;
                self.place.updated_s = last_s;
            }
            self.scene.fail(flown, begin_s)?;
        }
        let pushed = flown.push_sample(&sample)?;
        self.place.start_s = start_s;
        self.place.taken += 1;
        Ok(pushed)
    }

    /// Flies what waits in the queue, with the panel and the unit.
    fn fly_waiting(&mut self, simulator: &mut Simulator, mut unit: Option<&mut Unit>) -> Result<(), Error> {
        self.place.is_due = false;
        while simulator.step()? == Step::Done {
            let Some(interval) = simulator.imu() else { continue };
            let Place { start_s, taken, .. } = self.place;
            self.place.sensors.add(&interval);
            let is_due = self.place.spacing.take(interval.time_s - start_s, interval.interval_s);
            let is_last = self.count == Some(taken) && simulator.waiting_samples() == 0;
            self.place.is_due = is_due || is_last;
            if let Some(unit) = unit.as_deref_mut() {
                self.scene.update_unit(unit, simulator, start_s)?;
            }
            if simulator.waiting_samples() == 0 {
                break;
            }
        }
        Ok(())
    }

    /// `error` at the sample with the stamp `time_s` [s]: the one that was accepted last, or the next one.
    fn stopped(&self, error: Error, time_s: f64) -> Stopped {
        let at = |index: u64| {
            let sample = self.source.sample(index as usize, &self.scene).ok()?;
            (sample.time_s == time_s).then(|| self.source.line(index as usize)).flatten()
        };
        let taken = self.place.taken;
        let line = at(taken).or_else(|| at(taken.checked_sub(1)?));
        Stopped { error, time_s, line }
    }
}
