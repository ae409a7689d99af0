//! `sins_scene_samples`: which samples a scene flies.

use super::log::sins_log;
use super::{sins_scene, with_scene};
use crate::abi::boundary::tables::LOGS;
use crate::abi::failure::{CallError, SINS_OK, sins_status};
use crate::abi::memory::{Output, interface_struct};
use crate::base::error::Error;
use crate::log::FlightLog;
use crate::scene::{Samples, Scene};

/// The samples that a scene flies.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_scene_samples {
    /// sizeof(sins_scene_samples)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Number of samples.
    pub count: u64,
    /// Number of sample intervals between two records of the program sins, at least 1. It follows from sins_scene_setup.every_s;
    /// if every_s is 0, there are about 2000 records. The last sample has a record too.
    pub record_every: u64,
    /// Time stamp of the first sample [s].
    pub start_s: f64,
    /// Time between two samples [s]; of a log, the mean.
    pub period_s: f64,
    /// Time from the first to the last sample [s].
    pub duration_s: f64,
}

interface_struct!(sins_scene_samples, "samples", 48);

/// Reads which samples the scene flies. If the flight is composed of manoeuvres or is built-in, give NULL for `log`; sample k
/// is then sins_flight_sample_at(flight, k / rate_hz) of sins_scene_create_flight(). For a log, sample k is
/// sins_log_get_sample(log, k); the samples end at the duration that the scene sets.
///
/// SINS_ERROR_INVALID_ARGUMENT: the flight is not valid, the log has no second sample within the duration, or
/// sins_scene_setup.every_s is less than the time between two samples.
/// SINS_ERROR_BAD_HANDLE: scene or log is not a valid handle.
/// SINS_ERROR_BAD_STATE: the flight is a log, and log is NULL; or as sins_scene_parse().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_get_samples(
    scene: *const sins_scene,
    log: *const sins_log,
    samples: *mut sins_scene_samples,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(samples, "samples")? };
        if log.is_null() {
            return Ok(output.write(&sins_scene_samples::of(scene, None)?));
        }
        let mut found = None;
        let status = LOGS.with(log.addr(), |log| {
            found = Some(sins_scene_samples::of(scene, Some(log)));
            Ok(SINS_OK)
        });
        Ok(output.write(&found.ok_or(CallError::of_handle(status, "log"))??))
    })
}

impl sins_scene_samples {
    fn of(scene: &Scene, log: Option<&FlightLog>) -> Result<Self, Error> {
        let Samples { count, start_s, period_s, duration_s } = scene.samples(log)?;
        Ok(Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            count: count as u64,
            record_every: scene.record_every(count, period_s)?,
            start_s,
            period_s,
            duration_s,
        })
    }
}
