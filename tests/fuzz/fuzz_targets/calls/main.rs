//! Sequences of calls of the C interface with arbitrary arguments. No call may touch what is not its own (the sanitizer sees
//! that), answer SINS_ERROR_INTERNAL, give a number that is none, or change anything when it fails.
#![no_main]

mod input;

use std::ffi::c_char;
use std::ptr::{null, null_mut, without_provenance_mut};

use input::{Block, Input};
use sins::abi::*;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let mut host = Host::new(bytes);
    for _ in 0..200 {
        if host.input.is_empty() {
            break;
        }
        host.call();
    }
    host.leave();
});

const HANDLES: usize = 3;

struct Host<'a> {
    input: Input<'a>,
    sims: [*mut sins_sim; HANDLES],
    flights: [*mut sins_flight; HANDLES],
    /// Where the next plausible sample is.
    time_s: f64,
}

/// A struct of zeros that states its size, as SINS_INIT makes it.
fn init<T: Copy>() -> T {
    // SAFETY: the structs of the interface are numbers.
    let mut value: T = unsafe { std::mem::zeroed() };
    // SAFETY: struct_size comes first.
    unsafe { std::ptr::from_mut(&mut value).cast::<u32>().write(size_of::<T>() as u32) };
    value
}

/// A status that the interface knows and that no defect is behind.
fn checked(status: sins_status) -> sins_status {
    assert!((-13..=2).contains(&status), "status {status}");
    status
}

/// Flights of months are laid out for seconds, which is known: their fields are made refused ones.
fn shorten(manoeuvre: &mut Block) {
    let fields = [
        std::mem::offset_of!(sins_manoeuvre, duration_s),
        std::mem::offset_of!(sins_manoeuvre, heading_change_rad),
        std::mem::offset_of!(sins_manoeuvre, turns),
        std::mem::offset_of!(sins_manoeuvre, frequency_hz),
    ];
    for at in fields {
        if let Some(field) = manoeuvre.bytes.get_mut(at..at + 8)
            && f64::from_le_bytes(std::array::from_fn(|i| field[i])).abs() > 1e4
        {
            field.copy_from_slice(&f64::NAN.to_le_bytes());
        }
    }
}

impl<'a> Host<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        let mut host = Self {
            input: Input::new(bytes),
            sims: [null_mut(); HANDLES],
            flights: [null_mut(); HANDLES],
            time_s: 0.0,
        };
        host.create();
        host
    }

    /// One of the host's handles, living or not, or a made-up one.
    fn sim(&mut self) -> *mut sins_sim {
        match self.input.byte() {
            0..200 => self.sims[0],
            200..250 => self.sims[self.input.below(HANDLES)],
            _ => without_provenance_mut(self.input.word() as usize),
        }
    }

    fn flight(&mut self) -> *mut sins_flight {
        match self.input.byte() {
            0..250 => self.flights[self.input.below(HANDLES)],
            _ => without_provenance_mut(self.input.word() as usize),
        }
    }

    /// The sample after the last one: east along a parallel, turning slowly.
    fn plausible_sample(&mut self) -> sins_flight_sample {
        self.time_s += 1.0 / 128.0;
        sins_flight_sample {
            time_s: self.time_s,
            latitude_rad: 0.7,
            longitude_rad: self.time_s * (100.0 / 6378e3),
            height_m: 1000.0,
            heading_rad: 0.1 * self.time_s,
            flags: SINS_SAMPLE_NO_VELOCITY,
            ..init()
        }
    }

    /// All that a host can read of a simulator, checked.
    fn look(sim: *const sins_sim) -> Vec<u8> {
        let mut seen = Vec::new();
        let sim = sim.cast_mut();
        let mut read = |status: sins_status, block: Block, last: usize| {
            if checked(status) == SINS_OK {
                assert!(block.numbers(1, last).all(f64::is_finite), "a number that is none");
            }
            seen.extend(status.to_le_bytes());
            seen.extend(block.bytes);
        };
        let (mut truth, mut navigation) =
            (Block::of(&init::<sins_navigation>()), Block::of(&init::<sins_navigation>()));
        let (mut errors, mut model) = (Block::of(&init::<sins_errors>()), Block::of(&init::<sins_errors>()));
        let mut imu = Block::of(&init::<sins_imu>());
        let mut accuracy = Block::of(&init::<sins_accuracy>());
        // SAFETY: each output has as many bytes as it says.
        unsafe {
            read(sins_get_truth(sim, truth.pointer()), truth, 15);
            read(sins_get_navigation(sim, navigation.pointer()), navigation, 15);
            read(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, errors.pointer()), errors, 17);
            read(sins_get_errors(sim, SINS_ERRORS_MODEL, model.pointer()), model, 17);
            read(sins_get_imu(sim, imu.pointer()), imu, 27);
            read(sins_get_accuracy(sim, accuracy.pointer()), accuracy, 4);
        }
        seen
    }

    /// A call that may change `sim`: it does not when it fails.
    fn changing(&mut self, sim: *mut sins_sim, call: impl FnOnce(*mut sins_sim) -> sins_status) {
        let before = Self::look(sim);
        if checked(call(sim)) < 0 {
            assert_eq!(before, Self::look(sim), "a failed call changed something");
        } else {
            Self::look(sim);
        }
    }

    fn create(&mut self) {
        let mut options = self.input.changed(sins_options { error_model: SINS_ERROR_MODEL_RK4, ..init() });
        let place = self.input.below(HANDLES);
        let mut sim = null_mut();
        // SAFETY: as many bytes as it says.
        if checked(unsafe { sins_create(options.pointer(), &mut sim) }) == SINS_OK {
            let old = std::mem::replace(&mut self.sims[place], sim);
            if !old.is_null() {
                // SAFETY: a key.
                checked(unsafe { sins_destroy(old) });
            }
        }
    }

    fn run(&mut self) {
        let sim = self.sim();
        let count = self.input.below(8);
        let mut samples = Vec::new();
        let mut stride = 0;
        for index in 0..count {
            let sample = self.plausible_sample();
            let mut block = self.input.changed(sample);
            if index == 0 {
                stride = block.bytes.len();
            }
            block.bytes.resize(stride, 0);
            samples.extend(block.bytes);
        }
        let mut records = Block::of(&init::<sins_record>());
        let (every, capacity) = (self.input.below(4), self.input.below(8));
        let stride = records.bytes.len();
        records.bytes.resize(stride * capacity.max(1), 0);
        let mut written = 0;
        // SAFETY: both arrays are as long as they say.
        let status = unsafe {
            sins_run(sim, samples.as_ptr().cast(), count, every, records.pointer(), capacity, &mut written)
        };
        assert!(written <= capacity);
        if checked(status) != SINS_ERROR_BAD_HANDLE {
            Self::look(sim);
        }
    }

    fn create_flight(&mut self) {
        let start = sins_flight_start { latitude_rad: 0.7, speed_m_s: 200.0, height_m: 3000.0, ..init() };
        let mut start = self.input.changed(start);
        let count = 1 + self.input.below(3);
        let mut manoeuvres = Vec::new();
        let mut stride = 0;
        for index in 0..count {
            let kind = self.input.below(9) as i32;
            let mut manoeuvre: sins_manoeuvre = init();
            manoeuvre.kind = kind;
            manoeuvre.duration_s = if kind == SINS_MANOEUVRE_TURN { 0.0 } else { 20.0 };
            match kind {
                SINS_MANOEUVRE_TURN => (manoeuvre.heading_change_rad, manoeuvre.bank_rad) = (1.0, 0.5),
                SINS_MANOEUVRE_CLIMB => manoeuvre.height_change_m = 100.0,
                SINS_MANOEUVRE_ACCELERATE => manoeuvre.speed_change_m_s = 10.0,
                SINS_MANOEUVRE_ROLL | SINS_MANOEUVRE_LOOP => manoeuvre.turns = 1.0,
                SINS_MANOEUVRE_S_TURN => (manoeuvre.heading_change_rad, manoeuvre.turns) = (0.5, 2.0),
                SINS_MANOEUVRE_SINUSOIDS => {
                    (manoeuvre.sinusoid_count, manoeuvre.amplitude[0], manoeuvre.frequency_hz[0]) =
                        (1, 0.1, 0.2);
                }
                _ => {}
            }
            let mut block = self.input.changed(manoeuvre);
            shorten(&mut block);
            if index == 0 {
                stride = block.bytes.len();
            }
            block.bytes.resize(stride, 0);
            manoeuvres.extend(block.bytes);
        }
        let place = self.input.below(HANDLES);
        let mut flight = null_mut();
        // SAFETY: as many bytes as they say.
        let status =
            unsafe { sins_flight_create(start.pointer(), manoeuvres.as_ptr().cast(), count, &mut flight) };
        if checked(status) == SINS_OK {
            let old = std::mem::replace(&mut self.flights[place], flight);
            if !old.is_null() {
                // SAFETY: a key.
                checked(unsafe { sins_flight_destroy(old) });
            }
        }
    }

    /// Samples of a flight, at any time, into a simulator.
    fn fly(&mut self) {
        let (flight, sim) = (self.flight(), self.sim());
        let time_s = self.input.number();
        for step in 0..self.input.below(4) {
            let mut sample = self.input.changed(init::<sins_flight_sample>());
            // SAFETY: as many bytes as it says.
            let status =
                unsafe { sins_flight_sample_at(flight, time_s + 0.01 * step as f64, sample.pointer()) };
            if checked(status) == SINS_OK {
                assert!(sample.numbers(1, 11).all(f64::is_finite));
                // SAFETY: as above.
                self.changing(sim, |sim| unsafe { sins_push_sample(sim, sample.pointer()) });
            }
        }
    }

    fn recommend(&mut self) {
        let mut samples: Vec<sins_flight_sample> = (0..2).map(|_| self.plausible_sample()).collect();
        samples[1].heading_rad += self.input.number();
        let mut requirement = self.input.changed(sins_requirement { position_m: 1.0, ..init() });
        let mut options = self.input.changed(init::<sins_options>());
        let mut cost = Block::of(&init::<sins_cost>());
        // SAFETY: as many bytes as they say.
        let status = unsafe {
            sins_recommend(samples.as_ptr(), 2, requirement.pointer(), options.pointer(), cost.pointer())
        };
        if checked(status) >= 0 {
            assert!(cost.numbers(1, 11).all(f64::is_finite));
        }
    }

    fn call(&mut self) {
        let call = self.input.byte();
        let sim = self.sim();
        // SAFETY: every pointer has as many bytes as its struct says; handles may be anything.
        unsafe {
            match call % 20 {
                0 => self.create(),
                1 => {
                    checked(sins_destroy(sim));
                }
                2 => {
                    let mut gyro = self.input.changed(init::<sins_gyro_params>());
                    self.changing(sim, |sim| sins_set_gyro(sim, gyro.pointer()));
                }
                3 => {
                    let mut accel = self.input.changed(init::<sins_accel_params>());
                    self.changing(sim, |sim| sins_set_accel(sim, accel.pointer()));
                }
                4 => {
                    let mut altimeter = self.input.changed(init::<sins_altimeter_params>());
                    self.changing(sim, |sim| sins_set_altimeter(sim, altimeter.pointer()));
                }
                5 => {
                    let mut initial = self.input.changed(init::<sins_initial_errors>());
                    self.changing(sim, |sim| sins_set_initial_errors(sim, initial.pointer()));
                }
                6..=8 => {
                    let sample = self.plausible_sample();
                    let mut sample = self.input.changed(sample);
                    self.changing(sim, |sim| sins_push_sample(sim, sample.pointer()));
                    self.changing(sim, |sim| sins_step(sim));
                }
                9 => self.changing(sim, |sim| sins_step(sim)),
                10 => self.run(),
                11 => {
                    let start = sins_navigation { quaternion_nb: [1.0, 0.0, 0.0, 0.0], ..init() };
                    let mut start = self.input.changed(start);
                    self.changing(sim, |sim| sins_start_navigation(sim, start.pointer()));
                }
                12 => {
                    let increment = sins_imu_increment { interval_s: 0.01, count: 1, ..init() };
                    let mut increment = self.input.changed(increment);
                    self.changing(sim, |sim| sins_push_imu(sim, increment.pointer()));
                }
                13 => {
                    let sample = self.plausible_sample();
                    let mut sample = self.input.changed(sample);
                    self.changing(sim, |sim| sins_reposition(sim, sample.pointer()));
                }
                14 => self.changing(sim, |sim| sins_reset(sim)),
                15 => self.create_flight(),
                16 => self.fly(),
                17 => {
                    let mut text = vec![0x55_u8; self.input.below(256)];
                    let mut needed = 0;
                    let buffer =
                        if text.is_empty() { null_mut() } else { text.as_mut_ptr().cast::<c_char>() };
                    let sim = if self.input.byte() == 0 { null() } else { sim.cast_const() };
                    let status = checked(sins_last_error(sim, buffer, text.len(), &mut needed));
                    if status == SINS_OK && !text.is_empty() {
                        assert!(std::str::from_utf8(&text[..needed - 1]).is_ok() && text[needed - 1] == 0);
                    }
                }
                18 => {
                    let (mut gyro, mut accel) = (init::<sins_gyro_params>(), init::<sins_accel_params>());
                    let grade = i32::from(self.input.byte() as i8) % 8;
                    if checked(sins_gyro_preset(grade, &mut gyro)) == SINS_OK {
                        checked(sins_accel_preset(grade, &mut accel));
                        self.changing(sim, |sim| sins_set_gyro(sim, &gyro));
                        self.changing(sim, |sim| sins_set_accel(sim, &accel));
                    }
                }
                // As dear as all the rest of a sequence.
                _ if self.input.byte() < 16 => self.recommend(),
                _ => {}
            }
        }
    }

    /// Every handle is destroyed, so that a leak is the library's.
    fn leave(self) {
        // SAFETY: keys.
        unsafe {
            for sim in self.sims {
                checked(sins_destroy(sim));
            }
            for flight in self.flights {
                checked(sins_flight_destroy(flight));
            }
        }
    }
}
