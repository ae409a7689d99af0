//! All that makes an INS err: the errors of its sensors, gravity beyond the normal field, the mounting and the errors at the start.

mod set;
mod snapshot;

use super::{ErrorParameters, ImuFlags, Options};
use crate::base::error::{Error, ErrorKind, Rule};
use crate::base::memory::room;
use crate::sensors::{Altimeter, GravityDisturbance, Sensor, Triad};
use crate::signal::mounting::Block;
use crate::signal::{Increment, IntervalMotion, Turning};
use crate::truth::Recent;

/// Conditions of an interval for the sensors, in addition to their increments.
#[derive(Default)]
pub(super) struct IntervalConditions {
    /// Temperatures at the ends of the interval [°C]. Without one at its start, the temperature at its end is used.
    pub temperatures_c: [Option<f64>; 2],
    /// Turning of the block, along its axes; `None` for foreign increments.
    pub turning: Option<Turning>,
}

impl IntervalConditions {
    /// Conditions of the interval of `motion`, which `recent` ends, for the sensors of `block`.
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

/// All that makes an INS err: models of the sensors and of gravity, and the parameters that the host set.
#[derive(Debug, Clone)]
pub(super) struct Imperfections {
    pub gyro: Triad,
    pub accel: Triad,
    pub altimeter: Altimeter,
    /// Gravity beyond the normal field, which acts on the accelerometers.
    pub gravity: GravityDisturbance,
    /// Parameters that the host set, also of the mounting and of the errors at the start.
    set: ErrorParameters,
    /// Results of [`Self::update_summary`].
    triads_are_ideal: bool,
    are_none: bool,
    depend_on_temperature: bool,
    /// Whether a triad needs to know when an interval begins.
    follow_intervals: bool,
    /// Whether an axis has no signal in the interval.
    gyro_is_silent: bool,
    accel_is_silent: bool,
}

impl Imperfections {
    /// Not inlined, to save stack: the value is made in its final place.
    #[inline(never)]
    pub fn new(options: &Options) -> Self {
        Self {
            gyro: Triad::new(options.key, Sensor::Gyro),
            accel: Triad::new(options.key, Sensor::Accelerometer),
            altimeter: Altimeter::new(options.key, 0.0),
            gravity: GravityDisturbance::new(options.key),
            set: ErrorParameters::default(),
            triads_are_ideal: true,
            are_none: true,
            depend_on_temperature: false,
            follow_intervals: false,
            gyro_is_silent: false,
            accel_is_silent: false,
        }
    }

    /// On the heap, because the models are large for a stack.
    #[inline(never)]
    pub fn on_heap(options: &Options) -> Result<Box<[Self]>, Error> {
        let mut memory = room(1)?;
        memory.push(Self::new(options));
        Ok(memory.into_boxed_slice())
    }

    /// Becomes a copy of `other`: the models one after the other, to save stack.
    pub fn copy_from(&mut self, other: &Self) {
        let Self { gyro, accel, altimeter, gravity, .. } = other;
        self.gyro.clone_from(gyro);
        self.accel.clone_from(accel);
        self.altimeter.clone_from(altimeter);
        self.gravity.clone_from(gravity);
        self.set = other.set;
        self.update_summary();
    }

    /// Takes the states that depend on the signals from `other`, whose sensors had the same signals.
    pub fn follow_as(&mut self, other: &Self) {
        self.gyro.follow_as(&other.gyro);
        self.accel.follow_as(&other.accel);
        self.altimeter.follow_as(&other.altimeter);
    }

    /// Updates, after a change, the flags that each interval reads.
    fn update_summary(&mut self) {
        self.triads_are_ideal = self.gyro.is_ideal() && self.accel.is_ideal();
        self.are_none = self.triads_are_ideal
            && self.altimeter.is_ideal()
            && !self.gravity.is_on()
            && self.set.mounting.is_believed();
        self.depend_on_temperature =
            self.set.gyro.depend_on_temperature() || self.set.accel.depend_on_temperature();
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

    /// Rejects a sample without a temperature if an effect needs one. `temperature_c` is the sample's temperature.
    pub fn check_temperature(&self, temperature_c: Option<f64>) -> Result<(), Error> {
        if self.depend_on_temperature && temperature_c.is_none() {
            return Err(no_temperature());
        }
        Ok(())
    }

    /// Begins an interval of `t` [s]. `conditions` gives the known conditions of the interval.
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

    /// Follows a jump of the truth to `height_m`: states that depend on the signals settle there at once, noise continues.
    pub fn reposition(&mut self, height_m: f64) {
        self.gyro.reposition();
        self.accel.reposition();
        self.altimeter.reposition(height_m);
    }

    /// Follows a jump of the truth by `change_m` up, after which the INS continues: states that depend on the signals settle there
    /// at once, errors stay.
    pub fn go_on(&mut self, change_m: f64) {
        self.gyro.reposition();
        self.accel.reposition();
        self.altimeter.shift(change_m);
    }

    /// Senses the ideal increments of an interval, each over `dt` [s], with the two triads. [`Self::undo`] can undo the interval.
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

    /// Undoes the last [`Self::begin_interval`] and [`Self::sense`].
    pub fn undo(&mut self) {
        self.gyro.undo();
        self.accel.undo();
        (self.gyro_is_silent, self.accel_is_silent) = (self.gyro.is_silent(), self.accel.is_silent());
    }

    /// Whether gyros and accelerometers are ideal.
    pub fn triads_are_ideal(&self) -> bool {
        self.triads_are_ideal
    }

    /// Whether nothing makes the INS err: the altimeter is ideal too, gravity is normal and the mounting known.
    pub fn are_none(&self) -> bool {
        self.are_none
    }
}

#[cold]
fn no_temperature() -> Error {
    Error {
        kind: ErrorKind::InvalidArgument,
        field: "sample.temperature_c",
        index: None,
        value: None,
        rule: Rule::Sentence("is needed while temperature coefficients are set"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sensors::{Axis, Failure, SensorOutput};

    #[test]
    fn a_failure_is_an_imperfection_until_it_is_cleared() {
        let mut imperfections = Imperfections::new(&Options::default());
        let ideal_of =
            |imperfections: &Imperfections| (imperfections.triads_are_ideal(), imperfections.are_none());
        for output in
            [SensorOutput::Gyro(Axis::X), SensorOutput::Accelerometer(Axis::Z), SensorOutput::Altimeter]
        {
            assert_eq!(ideal_of(&imperfections), (true, true));
            for failure in [Failure::Stuck, Failure::Dead, Failure::BiasStep { size: -1.0 }] {
                imperfections.set_failure(output, Some(failure), None);
                assert_eq!(ideal_of(&imperfections), (output == SensorOutput::Altimeter, false));
            }
            imperfections.set_failure(output, None, None);
        }
        assert_eq!(ideal_of(&imperfections), (true, true));
    }
}
