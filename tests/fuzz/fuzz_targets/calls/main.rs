//! Sequences of calls of the C interface with arbitrary arguments. No call may touch what is not its own (the sanitizer sees
//! that), answer SINS_ERROR_INTERNAL, give a number that is none, or change anything when it fails.
#![no_main]

mod host;
mod input;
mod scenes;

use std::ffi::{CStr, c_char};
use std::ptr::{null, null_mut};

use host::{Host, checked, init};
use sins::abi::*;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let mut host = Host::new(bytes);
    for _ in 0..100 {
        if host.input.is_empty() {
            break;
        }
        host.call();
    }
    host.leave();
});

impl Host<'_> {
    fn call(&mut self) {
        // SAFETY: every pointer has as many bytes as its struct says; handles may be anything.
        unsafe {
            match self.input.byte() % 28 {
                0 => self.create(),
                1 => {
                    let sim = self.sim();
                    checked(sins_destroy(sim));
                }
                2 => self.giving(init(), |sim, gyro| sins_set_gyro(sim, gyro)),
                3 => self.giving(init(), |sim, accel| sins_set_accel(sim, accel)),
                4 => self.giving(init(), |sim, altimeter| sins_set_altimeter(sim, altimeter)),
                5 => self.giving(init(), |sim, errors| sins_set_initial_errors(sim, errors)),
                6 => {
                    let (sensor, axis) = (self.input.below(4) as i32, self.input.below(4) as i32);
                    let failure = some_failure(self.input.byte());
                    self.giving(failure, |sim, failure| sins_set_failure(sim, sensor, axis, failure));
                }
                7 => self
                    .giving(sins_mounting { lever_arm_m: [1.0, 2.0, 3.0], ..init() }, |sim, mounting| {
                        sins_set_mounting(sim, mounting)
                    }),
                8 => {
                    let gravity = sins_gravity_params {
                        anomaly_sigma_m_s2: 1e-4,
                        anomaly_distance_m: 1e4,
                        deflection_north_rad: 1e-5,
                        ..init()
                    };
                    self.giving(gravity, |sim, gravity| sins_set_gravity_disturbance(sim, gravity));
                }
                9..=13 => {
                    let sample = self.plausible_sample();
                    self.giving(sample, |sim, sample| sins_push_sample(sim, sample));
                    let sim = self.sim();
                    Self::changing(sim, |sim| sins_step(sim));
                }
                14 => {
                    let sim = self.sim();
                    Self::changing(sim, |sim| sins_step(sim));
                }
                15 => self.run(),
                16 => self.giving(
                    sins_navigation { quaternion_nb: [1.0, 0.0, 0.0, 0.0], ..init() },
                    |sim, start| sins_start_navigation(sim, start),
                ),
                17 => self
                    .giving(sins_imu_increment { interval_s: 0.01, count: 1, ..init() }, |sim, increment| {
                        sins_push_imu(sim, increment)
                    }),
                18 => {
                    let sample = self.plausible_sample();
                    self.giving(sample, |sim, sample| sins_reposition(sim, sample));
                }
                19 => {
                    let sim = self.sim();
                    Self::changing(sim, |sim| sins_reset(sim));
                }
                20 => self.create_flight(),
                21 => self.fly(),
                22 => self.hear(),
                23 => self.preset(),
                24 | 25 => self.thaw(),
                26 => names(i32::from(self.input.byte() as i8)),
                // As dear as all the rest of a sequence.
                _ => match self.input.byte() {
                    0..16 => self.recommend(),
                    16..20 => self.budget(),
                    _ => {}
                },
            }
        }
    }

    fn hear(&mut self) {
        let mut text = vec![0x55_u8; self.input.below(256)];
        let mut needed = 0;
        let buffer = if text.is_empty() { null_mut() } else { text.as_mut_ptr().cast::<c_char>() };
        let sim = self.sim().cast_const();
        let sim = if self.input.byte() == 0 { null() } else { sim };
        // SAFETY: as many bytes as it says.
        let status = checked(unsafe { sins_last_error(sim, buffer, text.len(), &mut needed) });
        if status == SINS_OK && !text.is_empty() {
            assert!(std::str::from_utf8(&text[..needed - 1]).is_ok() && text[needed - 1] == 0);
        }
    }

    fn preset(&mut self) {
        let sim = self.sim();
        let (mut gyro, mut accel) = (init::<sins_gyro_params>(), init::<sins_accel_params>());
        let grade = i32::from(self.input.byte() as i8) % 8;
        // SAFETY: structs of the interface.
        unsafe {
            if checked(sins_gyro_preset(grade, &mut gyro)) == SINS_OK {
                checked(sins_accel_preset(grade, &mut accel));
                Self::changing(sim, |sim| sins_set_gyro(sim, &gyro));
                Self::changing(sim, |sim| sins_set_accel(sim, &accel));
            }
        }
    }
}

/// A failure that is taken, of one of the kinds.
fn some_failure(kind: u8) -> sins_failure {
    let kind = i32::from(kind % 7);
    let mut failure = sins_failure { kind, ..init() };
    match kind {
        SINS_FAILURE_BIAS_STEP => failure.size = 0.1,
        SINS_FAILURE_SPIKES => (failure.size, failure.interval_s, failure.duration_s) = (0.1, 0.05, 0.01),
        SINS_FAILURE_NOISE => failure.density = 0.01,
        SINS_FAILURE_DROP_OUTS => failure.probability = 0.3,
        _ => {}
    }
    failure
}

/// The calls that need nothing.
fn names(status: sins_status) {
    let (mut text, mut numbers) = (null(), [0; 4]);
    let [abi, major, minor, patch] = &mut numbers;
    // SAFETY: room for each; the sentences are the library's.
    unsafe {
        assert_eq!(sins_abi_version(abi) | sins_version(major, minor, patch), SINS_OK);
        for answer in [sins_version_string(&mut text), sins_status_string(status, &mut text)] {
            assert!(checked(answer) < 0 || CStr::from_ptr(text).to_str().is_ok());
        }
    }
}
