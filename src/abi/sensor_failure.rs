//! `sins_failure`.

use super::choice::{check_reserved, of_kinds};
use super::failure::{CallError, SINS_OK, sins_status};
use super::memory::{Output, interface_struct, read};
use super::simulator::{sins_sim, with_simulator};
use crate::base::error::{Error, Rule};
use crate::sensors::{self, FailureFields, SensorOutput};

/// Sensors that can fail.
pub type sins_sensor = i32;

/// The gyros.
pub const SINS_SENSOR_GYRO: sins_sensor = 0;
/// The accelerometers.
pub const SINS_SENSOR_ACCEL: sins_sensor = 1;
/// The altimeter. Give 0 for the argument axis.
pub const SINS_SENSOR_ALTIMETER: sins_sensor = 2;

include!(concat!(env!("OUT_DIR"), "/sins_failure_kind.rs"));

/// What a sins_failure and a sins_planned_failure say of a failure.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_failure_fields {
    /// Kind of the failure, of enum sins_failure_kind.
    pub kind: i32,
    /// Must be 0.
    pub reserved2: u32,
    /// Bias step, spikes: size, up to 100 rad/s for a gyro, 1e4 m/s2 for an accelerometer, 1e5 m for the altimeter [u].
    pub size: f64,
    /// Noise: root of the spectral density, up to 100 for a gyro, 1e4 for an accelerometer, 1e5 for the altimeter
    /// [u sqrt(s)].
    pub density: f64,
    /// Spikes, drop-outs: time from the start of one to the start of the next, 1e-4 to 1e9 [s]; 0 for drop-outs with a
    /// probability.
    pub interval_s: f64,
    /// Spikes: length of one spike, 1e-9 s to interval_s [s].
    pub duration_s: f64,
    /// Drop-outs, if interval_s is 0: probability that an interval is lost, 0 to 1.
    pub probability: f64,
}

/// A failure of one output of a sensor. All zero is no failure. Fields that the kind does not use must be 0. The unit u is
/// rad/s for a gyro, m/s2 for an accelerometer, m for the altimeter.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_failure {
    /// sizeof(sins_failure)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Flat in C.
    pub fields: sins_failure_fields,
}

interface_struct!(sins_failure, "failure", 56);

impl sins_failure_fields {
    /// The fields of `failure`; without one SINS_FAILURE_NONE.
    pub(super) fn of(failure: Option<sensors::Failure>) -> Self {
        let fields = failure.as_ref().map_or(FailureFields::default(), FailureFields::from);
        let FailureFields { kind, size, density, interval_s, duration_s, probability } = fields;
        Self { kind: kind as i32, reserved2: 0, size, density, interval_s, duration_s, probability }
    }

    pub(super) fn to_failure(self) -> Result<Option<sensors::Failure>, CallError> {
        check_reserved("failure.reserved2", self.reserved2)?;
        let Self { size, density, interval_s, duration_s, probability, .. } = self;
        let kind = of_kinds("failure.kind", self.kind, FailureFields::KINDS.len(), "sins_failure_kind")?;
        let mut fields = FailureFields { kind, size, density, interval_s, duration_s, probability };
        let numbers = fields.numbers_mut().map(|number| *number);
        fields.check_unused(&numbers)?;
        Ok(fields.kind())
    }
}

impl sins_failure {
    fn of(failure: Option<sensors::Failure>) -> Self {
        let fields = sins_failure_fields::of(failure);
        Self { struct_size: size_of::<Self>() as u32, reserved: 0, fields }
    }

    pub(super) fn to_failure(self) -> Result<Option<sensors::Failure>, CallError> {
        check_reserved("failure.reserved", self.reserved)?;
        self.fields.to_failure()
    }
}

/// The arguments that select an output.
pub(super) const ARGUMENTS: [&str; 2] = ["sensor", "axis"];

/// The output that `sensor` and `axis` select; `fields` are their names in messages.
pub(super) fn output(fields: [&'static str; 2], sensor: i32, axis: i32) -> Result<SensorOutput, CallError> {
    let [sensor_field, axis_field] = fields;
    let (last, rule) = match sensor {
        SINS_SENSOR_GYRO | SINS_SENSOR_ACCEL => (2, Rule::BetweenIntegers(0, 2)),
        SINS_SENSOR_ALTIMETER => (0, Rule::Zero(": the altimeter has one output")),
        _ => return Err(Error::invalid(sensor_field, sensor, Rule::OneOf("sins_sensor", 0, 2)).into()),
    };
    if !(0..=last).contains(&axis) {
        return Err(Error::invalid(axis_field, axis, rule).into());
    }
    Ok(SensorOutput::of_sensor(sensor as usize, axis as usize))
}

/// Sets a failure of one output, as an instructor's station does: before the first sample or in flight, from the next
/// interval on. It lasts until SINS_FAILURE_NONE clears it, or another failure of the same output replaces it. Several
/// outputs may fail at the same time.
///
/// sensor is of enum sins_sensor; axis 0, 1, 2 is x, y, z of the sensor axes. Bias steps, spikes and noise act before dead
/// zone, range and quantization. SINS_FAILURE_STUCK, SINS_FAILURE_DEAD and SINS_FAILURE_DROP_OUTS replace the output. The
/// random numbers of other effects do not change. Sensor processes continue during a failure, and act on the output again
/// when it is cleared. A failure acts on error data 1 and on error data 2. It does not act on the alignment at the start.
/// sins_reposition() keeps failures. sins_reset() clears all failures, so an exercise starts again with working sensors;
/// failures that are set again at the same intervals give the same bits.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or not 0 where the kind does not use it. If a failure makes the
/// solution diverge, sins_step() returns SINS_ERROR_DIVERGED.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_set_failure(
    sim: *mut sins_sim,
    sensor: i32,
    axis: i32,
    failure: *const sins_failure,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let failure = unsafe { read(failure, "failure")? };
        simulator.set_failure(output(ARGUMENTS, sensor, axis)?, failure.to_failure()?)?;
        Ok(SINS_OK)
    })
}

/// Reads the failure of one output. May be called at any moment. After sins_snapshot_load() it is that of the snapshot.
/// SINS_FAILURE_NONE: the output has no failure. sensor and axis as in sins_set_failure().
///
/// SINS_ERROR_INVALID_ARGUMENT: no such output.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_failure(
    sim: *mut sins_sim,
    sensor: i32,
    axis: i32,
    failure: *mut sins_failure,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let place = unsafe { Output::new(failure, "failure")? };
        Ok(place.write(&sins_failure::of(simulator.failure(output(ARGUMENTS, sensor, axis)?))))
    })
}
