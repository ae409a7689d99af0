//! The sensors of a simulator and what the host set of them.

use super::{ImuFlags, Options};
use crate::covariance::Parameters;
use crate::error::{Error, ErrorKind, Rule};
use crate::memory::room;
use crate::mounting::{Block, MountingParameters};
use crate::sensors::{
    Altimeter, AltimeterParameters, FailingTriad, Failure, GravityDisturbance, GravityDisturbanceParameters,
    InitialErrorParameters, Sensor, SensorOutput, Triad, TriadParameters,
};
use crate::signal::{Increment, IntervalMotion, Turning};
use crate::snapshot::{Reader, Stored, Writer};
use crate::truth::Recent;

/// What an interval brings to the sensors beside their increments.
#[derive(Default)]
pub(super) struct IntervalConditions {
    /// Temperatures at its ends [°C]; without one at its start that at its end.
    pub temperatures_c: [Option<f64>; 2],
    /// How the block turns, along its axes; `None` of foreign increments.
    pub turning: Option<Turning>,
}

impl IntervalConditions {
    /// Of the interval of `motion`, which `recent` ends, for the sensors of `block`.
    #[cold]
    #[inline(never)]
    pub fn of(recent: &Recent<'_>, motion: &IntervalMotion<'_>, block: Option<&Block>) -> Self {
        let turning = motion.turning();
        let turning =
            block.map_or(turning, |block| turning.in_axes(|vector_b| block.in_block_axes(vector_b)));
        Self {
            temperatures_c: [recent.current.temperature_c(), recent.next.temperature_c()],
            turning: Some(turning),
        }
    }
}

/// Sensor models and what the host set of them.
#[derive(Debug, Clone)]
pub(super) struct SensorSuite {
    pub gyro: Triad,
    pub accel: Triad,
    pub altimeter: Altimeter,
    /// Gravity beyond the normal field, which acts on the accelerometers.
    pub gravity: GravityDisturbance,
    pub initial: InitialErrorParameters,
    /// Where gyros and accelerometers sit, if not at the reference point.
    mounting: Option<MountingParameters>,
    gyro_parameters: TriadParameters,
    accel_parameters: TriadParameters,
    /// What [`Self::update_summary`] has found.
    triads_are_ideal: bool,
    all_are_ideal: bool,
    depend_on_temperature: bool,
    /// Whether a triad is to be told when an interval begins.
    follow_intervals: bool,
    /// Whether an axis has no signal in the interval.
    gyro_is_silent: bool,
    accel_is_silent: bool,
    altimeter_parameters: AltimeterParameters,
}

/// The parameters first: they are set again, and the state of what they call for is laid over that.
impl Stored for SensorSuite {
    fn save(&self, to: &mut Writer<'_>) {
        let Self {
            gyro,
            accel,
            altimeter,
            gravity,
            initial,
            mounting,
            gyro_parameters,
            accel_parameters,
            triads_are_ideal: _,
            all_are_ideal: _,
            depend_on_temperature: _,
            follow_intervals: _,
            gyro_is_silent: _,
            accel_is_silent: _,
            altimeter_parameters,
        } = self;
        gyro.failures().save(to);
        gyro_parameters.save(to);
        accel.failures().save(to);
        accel_parameters.save(to);
        altimeter_parameters.save(to);
        initial.save(to);
        mounting.save(to);
        gravity.parameters().save(to);
        gyro.save(to);
        accel.save(to);
        altimeter.save(to);
        gravity.save(to);
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        let mut triad = TriadParameters::default();
        self.gyro.load_failures(from)?;
        triad.load(from)?;
        triad.validate(Sensor::Gyro)?;
        self.set_gyro(&triad);
        self.accel.load_failures(from)?;
        triad.load(from)?;
        triad.validate(Sensor::Accelerometer)?;
        self.set_accel(&triad);
        let mut altimeter = AltimeterParameters::default();
        altimeter.load(from)?;
        altimeter.validate()?;
        self.set_altimeter(&altimeter);
        self.initial.load(from)?;
        self.initial.validate()?;
        self.mounting.load(from)?;
        self.mounting.map_or(Ok(()), |mounting| mounting.validate())?;
        let mut gravity = GravityDisturbanceParameters::default();
        gravity.load(from)?;
        gravity.validate()?;
        self.gravity.set(&gravity);
        self.gyro.load(from)?;
        self.accel.load(from)?;
        self.altimeter.load(from)?;
        self.gravity.load(from)?;
        self.update_summary();
        Ok(())
    }
}

impl SensorSuite {
    /// Not inlined, for the stack: made in its place.
    #[inline(never)]
    pub fn new(options: &Options) -> Self {
        Self {
            gyro: Triad::new(options.key, Sensor::Gyro),
            accel: Triad::new(options.key, Sensor::Accelerometer),
            altimeter: Altimeter::new(options.key, 0.0),
            gravity: GravityDisturbance::new(options.key),
            initial: InitialErrorParameters::default(),
            mounting: None,
            gyro_parameters: TriadParameters::default(),
            accel_parameters: TriadParameters::default(),
            triads_are_ideal: true,
            all_are_ideal: true,
            depend_on_temperature: false,
            follow_intervals: false,
            gyro_is_silent: false,
            accel_is_silent: false,
            altimeter_parameters: AltimeterParameters::default(),
        }
    }

    /// The same parameters, all processes and streams back at their start, no failures.
    pub fn restarted(&self, options: &Options) -> Self {
        let mut fresh = Self::new(options);
        fresh.set_as(self);
        fresh
    }

    /// Sensors on the heap: they are much of a stack.
    #[inline(never)]
    pub fn on_heap(options: &Options) -> Result<Box<[Self]>, Error> {
        let mut memory = room(1)?;
        memory.push(Self::new(options));
        Ok(memory.into_boxed_slice())
    }

    /// Becomes the sensors of another run than `other`: what the host set of those, failures too, and all processes and streams at
    /// their start.
    #[inline(never)]
    pub fn become_run(&mut self, other: &Self, options: &Options) {
        *self = Self::new(options);
        self.set_as(other);
        for output in SensorOutput::ALL {
            if let Some(failure) = other.failure(output) {
                self.set_failure(output, Some(failure), None);
            }
        }
    }

    /// Takes what the host set of `other`, but for failures.
    fn set_as(&mut self, other: &Self) {
        self.initial = other.initial;
        self.set_mounting(other.mounting);
        self.gravity.set(other.gravity.parameters());
        self.set_gyro(&other.gyro_parameters);
        self.set_accel(&other.accel_parameters);
        self.set_altimeter(&other.altimeter_parameters);
    }

    /// Whether the host set the same of `other`, failures too.
    pub fn is_set_as(&self, other: &Self) -> bool {
        self.initial == other.initial
            && self.mounting == other.mounting
            && self.gravity.parameters() == other.gravity.parameters()
            && self.gyro_parameters == other.gyro_parameters
            && self.accel_parameters == other.accel_parameters
            && self.altimeter_parameters == other.altimeter_parameters
            && SensorOutput::ALL.into_iter().all(|output| self.failure(output) == other.failure(output))
    }

    /// What follows the signals is as in `other`, whose sensors got the same.
    pub fn follow_as(&mut self, other: &Self) {
        self.gyro.follow_as(&other.gyro);
        self.accel.follow_as(&other.accel);
        self.altimeter.follow_as(&other.altimeter);
    }

    pub fn set_gyro(&mut self, parameters: &TriadParameters) {
        self.gyro_parameters = *parameters;
        self.gyro.set(parameters);
        self.update_summary();
    }

    pub fn set_accel(&mut self, parameters: &TriadParameters) {
        self.accel_parameters = *parameters;
        self.accel.set(parameters);
        self.update_summary();
    }

    pub fn set_mounting(&mut self, mounting: Option<MountingParameters>) {
        self.mounting = mounting;
        self.update_summary();
    }

    pub fn mounting(&self) -> Option<&MountingParameters> {
        self.mounting.as_ref()
    }

    pub fn set_gravity_disturbance(&mut self, parameters: &GravityDisturbanceParameters) {
        self.gravity.set(parameters);
        self.update_summary();
    }

    pub fn set_altimeter(&mut self, parameters: &AltimeterParameters) {
        self.altimeter_parameters = *parameters;
        self.altimeter.set(parameters);
        self.update_summary();
    }

    /// Takes a failure of an output, or clears it; `last` are the mean signals of the interval before, if there was one.
    pub fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>, last: Option<&Increment>) {
        match output {
            SensorOutput::Gyro(axis) => {
                let last = last.map(|mean| mean.angle[axis as usize]);
                self.gyro.set_failure(axis, failure, last, &self.gyro_parameters);
            }
            SensorOutput::Accelerometer(axis) => {
                let last = last.map(|mean| mean.velocity[axis as usize]);
                self.accel.set_failure(axis, failure, last, &self.accel_parameters);
            }
            SensorOutput::Altimeter => self.altimeter.set_failure(failure),
        }
        self.update_summary();
    }

    /// The failures of gyros and accelerometers are those of another run, which has the same.
    pub fn take_failures(&mut self, gyro: &FailingTriad, accel: &FailingTriad) {
        self.gyro.take_failures(gyro);
        self.accel.take_failures(accel);
        self.update_summary();
    }

    /// What the host set of all that can be random.
    pub fn parameters(&self) -> Parameters<'_> {
        Parameters {
            gyro: &self.gyro_parameters,
            accel: &self.accel_parameters,
            altimeter: &self.altimeter_parameters,
            gravity: self.gravity.parameters(),
        }
    }

    /// What the host set of the gyros.
    pub fn gyro_parameters(&self) -> &TriadParameters {
        &self.gyro_parameters
    }

    /// What the host set of the accelerometers.
    pub fn accel_parameters(&self) -> &TriadParameters {
        &self.accel_parameters
    }

    /// What the host set of the altimeter.
    pub fn altimeter_parameters(&self) -> &AltimeterParameters {
        &self.altimeter_parameters
    }

    /// The failure that is set of an output.
    pub fn failure(&self, output: SensorOutput) -> Option<Failure> {
        match output {
            SensorOutput::Gyro(axis) => self.gyro.failure(axis),
            SensorOutput::Accelerometer(axis) => self.accel.failure(axis),
            SensorOutput::Altimeter => self.altimeter.failure(),
        }
    }

    /// Brings up to date what each interval asks, after a change.
    fn update_summary(&mut self) {
        self.triads_are_ideal = self.gyro.is_ideal() && self.accel.is_ideal();
        self.all_are_ideal = self.triads_are_ideal
            && self.altimeter.is_ideal()
            && !self.gravity.is_on()
            && self.mounting.as_ref().is_none_or(MountingParameters::is_believed);
        self.depend_on_temperature =
            self.gyro_parameters.depend_on_temperature() || self.accel_parameters.depend_on_temperature();
        self.follow_intervals = self.depend_on_temperature
            || self.gyro.has_failed()
            || self.accel.has_failed()
            || self.accel.has_size_effect();
        (self.gyro_is_silent, self.accel_is_silent) = (self.gyro.is_silent(), self.accel.is_silent());
    }

    /// Whether an effect needs the temperature.
    pub fn depend_on_temperature(&self) -> bool {
        self.depend_on_temperature
    }

    /// Refuses a sample of the temperature `temperature_c` if an effect needs one and it has none.
    pub fn check_temperature(&self, temperature_c: Option<f64>) -> Result<(), Error> {
        if self.depend_on_temperature && temperature_c.is_none() {
            return Err(no_temperature());
        }
        Ok(())
    }

    /// An interval of `t` [s] begins; `conditions` gives what is known of it.
    #[inline]
    pub fn begin_interval(&mut self, t: f64, conditions: impl FnOnce() -> IntervalConditions) {
        if self.follow_intervals {
            self.follow_interval(t, conditions());
        }
    }

    #[cold]
    #[inline(never)]
    fn follow_interval(&mut self, t: f64, conditions: IntervalConditions) {
        let [start, end] = conditions.temperatures_c;
        let ends_c = end.map(|end| [start.unwrap_or(end), end]);
        self.gyro.begin_interval(t, ends_c, None);
        self.accel.begin_interval(t, ends_c, conditions.turning);
        self.gyro_is_silent = self.gyro.is_silent();
        self.accel_is_silent = self.accel.is_silent();
    }

    /// The truth jumped to `height_m`: what follows the signals settles there at once, noise goes on.
    pub fn reposition(&mut self, height_m: f64) {
        self.gyro.reposition();
        self.accel.reposition();
        self.altimeter.reposition(height_m);
    }

    /// The truth jumped by `change_m` up, and the INS goes on: what follows the signals settles there at once, errors stay.
    pub fn go_on(&mut self, change_m: f64) {
        self.gyro.reposition();
        self.accel.reposition();
        self.altimeter.shift(change_m);
    }

    /// What the two triads make of the ideal increments of an interval, each over `dt` [s]; [`Self::undo`] takes it back.
    #[inline]
    pub fn sense(&mut self, ideal: &[Increment], dt: f64, measured: &mut [Increment]) -> ImuFlags {
        measured.copy_from_slice(ideal);
        self.gyro.sense_each(ideal, dt, measured);
        self.accel.sense_each(ideal, dt, measured);
        ImuFlags {
            gyro_saturated: self.gyro.take_saturated(),
            accel_saturated: self.accel.take_saturated(),
            gyro_invalid: self.gyro_is_silent,
            accel_invalid: self.accel_is_silent,
        }
    }

    /// Takes the last [`Self::begin_interval`] and [`Self::sense`] back.
    pub fn undo(&mut self) {
        self.gyro.undo();
        self.accel.undo();
        (self.gyro_is_silent, self.accel_is_silent) = (self.gyro.is_silent(), self.accel.is_silent());
    }

    /// Whether gyros and accelerometers are ideal.
    pub fn are_ideal(&self) -> bool {
        self.triads_are_ideal
    }

    /// Whether nothing makes the INS err: the altimeter is ideal too, gravity is normal and the mounting known.
    pub fn all_are_ideal(&self) -> bool {
        self.all_are_ideal
    }
}

#[cold]
fn no_temperature() -> Error {
    Error {
        kind: ErrorKind::InvalidArgument,
        field: "sample.temperature_c",
        index: None,
        value: None,
        rule: Rule::Sentence(
            "is needed, with SINS_SAMPLE_TEMPERATURE in sample.flags, while temperature coefficients are set",
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sensors::Axis;

    #[test]
    fn a_suite_with_a_failure_is_not_ideal_until_it_is_cleared() {
        let mut suite = SensorSuite::new(&Options::default());
        let ideal_of = |suite: &SensorSuite| (suite.are_ideal(), suite.all_are_ideal());
        for output in
            [SensorOutput::Gyro(Axis::X), SensorOutput::Accelerometer(Axis::Z), SensorOutput::Altimeter]
        {
            assert_eq!(ideal_of(&suite), (true, true));
            for failure in [Failure::Stuck, Failure::Dead, Failure::BiasStep { size: -1.0 }] {
                suite.set_failure(output, Some(failure), None);
                assert_eq!(ideal_of(&suite), (output == SensorOutput::Altimeter, false));
            }
            suite.set_failure(output, None, None);
        }
        assert_eq!(ideal_of(&suite), (true, true));
    }
}
