//! Each getter returns the bits that its setter took: before a flight, in flight, and from a loaded snapshot.

use core::ptr::{null, null_mut};
use std::mem::MaybeUninit;

use sins::abi::*;

/// A struct of the interface with different numbers in `fields` (indexes of 8-byte words).
fn filled<T: Copy>(fields: impl Iterator<Item = usize>) -> T {
    let mut bytes = MaybeUninit::<T>::zeroed();
    let words = bytes.as_mut_ptr().cast::<f64>();
    // SAFETY: the structs of the interface are numbers without padding; places are within them.
    unsafe {
        bytes.as_mut_ptr().cast::<u32>().write(size_of::<T>() as u32);
        for (k, place) in fields.enumerate() {
            assert!((place + 1) * 8 <= size_of::<T>());
            words.add(place).write(1e-3 * (1.0 + k as f64 / 128.0));
        }
        bytes.assume_init()
    }
}

/// Every word of a struct, as bits.
fn words<T: Copy>(value: &T) -> Vec<u64> {
    // SAFETY: as in `filled`.
    (0..size_of::<T>() / 8)
        .map(|k| unsafe { core::ptr::from_ref(value).cast::<u64>().add(k).read() })
        .collect()
}

type Get<T> = unsafe extern "C-unwind" fn(*mut sins_sim, *mut T) -> sins_status;

/// Asserts that the getter returns `set`.
fn gives_back<T: Copy>(sim: *mut sins_sim, get: Get<T>, set: &T) {
    let mut got: T = filled(core::iter::empty());
    // SAFETY: a handle and a struct of the interface.
    assert_eq!(unsafe { get(sim, &mut got) }, SINS_OK);
    assert_eq!(words(&got), words(set), "{}", core::any::type_name::<T>());
}

struct Settings {
    gyro: sins_gyro_params,
    accel: sins_accel_params,
    altimeter: sins_altimeter_params,
    initial: sins_initial_errors,
    mounting: sins_mounting,
    gravity: sins_gravity_params,
    failures: Vec<(i32, i32, sins_failure)>,
}

impl Settings {
    fn new() -> Self {
        let all = |size: usize| 1..size / 8;
        // The diagonals of the misalignment and of its scatter must be 0. Matrices are stored by rows.
        let mut gyro: sins_gyro_params = filled(all(size_of::<sins_gyro_params>()));
        let mut accel: sins_accel_params = filled(all(size_of::<sins_accel_params>()));
        for place in [0, 4, 8] {
            (gyro.misalignment_rad[place], accel.misalignment_rad[place]) = (0.0, 0.0);
            (gyro.misalignment_sigma_rad[place], accel.misalignment_sigma_rad[place]) = (0.0, 0.0);
        }
        let mut initial: sins_initial_errors = filled(1..size_of::<sins_initial_errors>() / 8 - 2);
        (initial.alignment, initial.alignment_s) = (SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS, 600.0);
        let mut gravity: sins_gravity_params = filled(all(size_of::<sins_gravity_params>()));
        (gravity.deflection_north_distance_m, gravity.deflection_east_distance_m) = (1e3, 2e3);
        gravity.anomaly_distance_m = 3e3;
        let failure = |kind: i32, fields: &[usize]| {
            let mut failure: sins_failure = filled(fields.iter().copied());
            failure.fields.kind = kind;
            failure
        };
        // Words 2 to 6 are size, density, interval, duration and probability. The pulse must be shorter than the interval.
        let mut spikes = failure(SINS_FAILURE_SPIKES, &[2, 4, 5]);
        spikes.fields.interval_s = 0.5;
        let failures = vec![
            (SINS_SENSOR_GYRO, 0, failure(SINS_FAILURE_STUCK, &[])),
            (SINS_SENSOR_GYRO, 1, failure(SINS_FAILURE_BIAS_STEP, &[2])),
            (SINS_SENSOR_GYRO, 2, failure(SINS_FAILURE_NONE, &[])),
            (SINS_SENSOR_ACCEL, 0, spikes),
            (SINS_SENSOR_ACCEL, 1, failure(SINS_FAILURE_NOISE, &[3])),
            (SINS_SENSOR_ACCEL, 2, failure(SINS_FAILURE_DROP_OUTS, &[4])),
            (SINS_SENSOR_ALTIMETER, 0, failure(SINS_FAILURE_DROP_OUTS, &[6])),
        ];
        let altimeter = filled(all(size_of::<sins_altimeter_params>()));
        let mounting = filled(all(size_of::<sins_mounting>()));
        Self { gyro, accel, altimeter, initial, mounting, gravity, failures }
    }

    fn set(&self, sim: *mut sins_sim) {
        // SAFETY: a handle and structs of the interface.
        unsafe {
            assert_eq!(sins_set_gyro(sim, &self.gyro), SINS_OK);
            assert_eq!(sins_set_accel(sim, &self.accel), SINS_OK);
            assert_eq!(sins_set_altimeter(sim, &self.altimeter), SINS_OK);
            assert_eq!(sins_set_initial_errors(sim, &self.initial), SINS_OK);
            assert_eq!(sins_set_mounting(sim, &self.mounting), SINS_OK);
            assert_eq!(sins_set_gravity_disturbance(sim, &self.gravity), SINS_OK);
            for (sensor, axis, failure) in &self.failures {
                assert_eq!(sins_set_failure(sim, *sensor, *axis, failure), SINS_OK, "{sensor} {axis}");
            }
        }
    }

    fn are_given_back(&self, sim: *mut sins_sim) {
        gives_back(sim, sins_get_gyro, &self.gyro);
        gives_back(sim, sins_get_accel, &self.accel);
        gives_back(sim, sins_get_altimeter, &self.altimeter);
        gives_back(sim, sins_get_initial_errors, &self.initial);
        gives_back(sim, sins_get_mounting, &self.mounting);
        gives_back(sim, sins_get_gravity_disturbance, &self.gravity);
        for (sensor, axis, failure) in &self.failures {
            let mut got: sins_failure = filled(core::iter::empty());
            // SAFETY: a handle and a struct of the interface.
            assert_eq!(unsafe { sins_get_failure(sim, *sensor, *axis, &mut got) }, SINS_OK);
            assert_eq!(words(&got), words(failure), "{sensor} {axis}");
        }
    }
}

fn created() -> *mut sins_sim {
    let mut sim = null_mut();
    // SAFETY: a place for a handle.
    assert_eq!(unsafe { sins_create(null(), &mut sim) }, SINS_OK);
    sim
}

#[test]
fn before_a_flight_in_flight_and_from_a_loaded_snapshot() {
    let (sim, settings) = (created(), Settings::new());
    let nothing: sins_gyro_params = filled(core::iter::empty());
    gives_back(sim, sins_get_gyro, &nothing);
    settings.set(sim);
    settings.are_given_back(sim);
    for k in 0..20 {
        let mut sample: sins_flight_sample = filled(core::iter::empty());
        (sample.time_s, sample.latitude_rad, sample.flags) =
            (0.1 * f64::from(k), 0.7, SINS_SAMPLE_TEMPERATURE);
        sample.temperature_c = 20.0;
        // SAFETY: a handle and a struct of the interface.
        unsafe {
            assert_eq!(sins_push_sample(sim, &sample), SINS_OK);
            assert!(sins_step(sim) >= SINS_OK);
        }
    }
    settings.are_given_back(sim);
    let (mut snapshot, mut size) = (vec![0_u8; SINS_SNAPSHOT_MAX_SIZE], 0);
    let other = created();
    // SAFETY: handles, and a buffer of the size that is stated.
    unsafe {
        assert_eq!(sins_snapshot_save(sim, snapshot.as_mut_ptr().cast(), snapshot.len(), &mut size), SINS_OK);
        assert_eq!(sins_snapshot_load(other, snapshot.as_ptr().cast(), size), SINS_OK);
    }
    settings.are_given_back(other);
    // A host can read the parameters, change one field and set them again.
    let mut params: sins_gyro_params = filled(core::iter::empty());
    // SAFETY: handles and structs of the interface.
    unsafe {
        assert_eq!(sins_get_gyro(other, &mut params), SINS_OK);
        params.bias_rad_s[1] = 0.25;
        assert_eq!(sins_set_gyro(other, &params), SINS_OK);
        gives_back(other, sins_get_gyro, &params);
        assert_eq!(
            sins_get_failure(sim, SINS_SENSOR_ALTIMETER, 1, &mut settings.failures[0].2.clone()),
            SINS_ERROR_INVALID_ARGUMENT
        );
        assert_eq!(sins_destroy(sim), SINS_OK);
        assert_eq!(sins_destroy(other), SINS_OK);
    }
}
