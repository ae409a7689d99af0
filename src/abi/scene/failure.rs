//! The failures that a scene plans.

use super::{sins_scene, with_scene};
use crate::abi::failure::sins_status;
use crate::abi::memory::{Output, element, interface_struct, put};
use crate::abi::sensor_failure::sins_failure_fields;
use crate::scene::{Failing, PlannedFailure};

/// A failure that a scene plans. Its fields from kind on are those of sins_failure; kind is not SINS_FAILURE_NONE.
/// sins_scene_set_items() sets the failures of a scene.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_planned_failure {
    /// sizeof(sins_planned_failure)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Sensor that fails, of enum sins_sensor.
    pub sensor: i32,
    /// Axis that fails: 0, 1, 2 for x, y, z of the sensor axes; 0 for the altimeter.
    pub axis: i32,
    /// Start of the failure, 0 to 1e9 since the start of the flight [s].
    pub from_s: f64,
    /// End of the failure, likewise; 0: the end of the flight [s].
    pub until_s: f64,
    /// Flat in C.
    pub fields: sins_failure_fields,
}

interface_struct!(sins_planned_failure, "failure", 80);

/// Reads the number of failures that the scene plans.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_get_failure_count(
    scene: *const sins_scene,
    count: *mut usize,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: the host's promise.
        unsafe { put(count, scene.failures.len(), "count") }
    })
}

/// Reads planned failure `index`, from 0.
///
/// SINS_ERROR_INVALID_ARGUMENT: no such failure.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_scene_get_failure(
    scene: *const sins_scene,
    index: usize,
    failure: *mut sins_planned_failure,
) -> sins_status {
    with_scene(scene, |scene| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(failure, "failure")? };
        let rule = "must be less than the number of failures of the scene:";
        let planned = element(&scene.failures, index, rule)?;
        Ok(output.write(&sins_planned_failure::new(planned)))
    })
}

impl sins_planned_failure {
    fn new(planned: &PlannedFailure) -> Self {
        let (sensor, axis) = planned.output.parts();
        let Failing { from_s, until_s } = planned.failing;
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            sensor: sensor as i32,
            axis: axis as i32,
            from_s,
            until_s: if until_s.is_infinite() { 0.0 } else { until_s },
            fields: sins_failure_fields::of(Some(planned.failure)),
        }
    }
}
