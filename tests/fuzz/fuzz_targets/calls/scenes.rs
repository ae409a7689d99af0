//! Calls on whole scenes: runs, flights, recommendations, budgets.

use std::mem::offset_of;
use std::ptr::null_mut;

use sins::abi::*;

use crate::host::{Host, checked, init, look};
use crate::input::Block;

/// Flights of months take seconds to lay out, as the header says: their fields are made refused ones.
fn shorten(manoeuvre: &mut Block) {
    let fields = [
        offset_of!(sins_manoeuvre, duration_s),
        offset_of!(sins_manoeuvre, heading_change_rad),
        offset_of!(sins_manoeuvre, turns),
        offset_of!(sins_manoeuvre, frequency_hz),
    ];
    for at in fields {
        if let Some(field) = manoeuvre.bytes.get_mut(at..at + 8)
            && f64::from_le_bytes(std::array::from_fn(|i| field[i])).abs() > 1e4
        {
            field.copy_from_slice(&f64::NAN.to_le_bytes());
        }
    }
}

/// Structs as an array with the stride of the first.
#[derive(Default)]
struct Array {
    bytes: Vec<u8>,
    stride: usize,
}

impl Array {
    fn push(&mut self, mut block: Block) {
        if self.bytes.is_empty() {
            self.stride = block.bytes.len();
        }
        block.bytes.resize(self.stride, 0);
        self.bytes.extend(block.bytes);
    }

    fn pointer<T>(&self) -> *const T {
        self.bytes.as_ptr().cast()
    }
}

impl Host<'_> {
    fn samples(&mut self, count: usize) -> Array {
        let mut samples = Array::default();
        for _ in 0..count {
            let sample = self.plausible_sample();
            samples.push(self.input.changed(sample));
        }
        samples
    }

    pub fn run(&mut self) {
        let sim = self.sim();
        let count = self.input.below(8);
        let samples = self.samples(count);
        let mut records = Block::of(&init::<sins_record>());
        let (every, capacity) = (self.input.below(4), self.input.below(8));
        let stride = records.bytes.len();
        records.bytes.resize(stride * capacity.max(1), 0);
        let mut written = 0;
        // SAFETY: both arrays are as long as they say.
        let status = unsafe {
            sins_run(sim, samples.pointer(), count, every, records.pointer(), capacity, &mut written)
        };
        assert!(written <= capacity);
        if checked(status) != SINS_ERROR_BAD_HANDLE {
            look(sim);
        }
    }

    pub fn create_flight(&mut self) {
        let start = sins_flight_start { latitude_rad: 0.7, speed_m_s: 200.0, height_m: 3000.0, ..init() };
        let mut start = self.input.changed(start);
        let count = 1 + self.input.below(3);
        let mut manoeuvres = Array::default();
        for _ in 0..count {
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
            manoeuvres.push(block);
        }
        let mut flight = null_mut();
        // SAFETY: as many bytes as they say.
        let status = unsafe { sins_flight_create(start.pointer(), manoeuvres.pointer(), count, &mut flight) };
        if checked(status) == SINS_OK {
            let mut duration_s = f64::NAN;
            // SAFETY: a key, and room for a number.
            checked(unsafe { sins_flight_duration(flight, &mut duration_s) });
            assert!(duration_s > 0.0 && duration_s.is_finite(), "{duration_s} s");
            self.keep(flight);
        }
    }

    /// Samples of a flight, at any time, into a simulator.
    pub fn fly(&mut self) {
        let (flight, sim) = (self.flight(), self.sim());
        let time_s = self.input.number();
        for step in 0..self.input.below(4) {
            let mut sample = self.input.changed(init::<sins_flight_sample>());
            // SAFETY: as many bytes as it says.
            let status =
                unsafe { sins_flight_sample_at(flight, time_s + 0.01 * step as f64, sample.pointer()) };
            if checked(status) == SINS_OK {
                assert!(sample.is_finite());
                // SAFETY: as above.
                Self::changing(sim, |sim| unsafe { sins_push_sample(sim, sample.pointer()) });
            }
        }
    }

    pub fn recommend(&mut self) {
        let mut samples: Vec<sins_flight_sample> = (0..2).map(|_| self.plausible_sample()).collect();
        samples[1].heading_rad += self.input.number();
        let mut requirement = self.input.changed(sins_requirement { position_m: 1.0, ..init() });
        let (mut options, mut cost) = (Block::of(&init::<sins_options>()), Block::of(&init::<sins_cost>()));
        let (options, cost_out) = (options.pointer(), cost.pointer());
        let configured = self.sim();
        let mut status = SINS_OK;
        Self::changing(configured, |configured| {
            let (samples, requirement) = (samples.as_ptr(), requirement.pointer());
            // SAFETY: as many bytes as they say.
            status = unsafe { sins_recommend(configured, samples, 2, requirement, options, cost_out) };
            status
        });
        if status >= 0 {
            assert!(cost.is_finite());
        }
    }

    pub fn budget(&mut self) {
        let count = 2 + self.input.below(2);
        let samples = self.samples(count);
        let mut options = self.input.changed(init::<sins_options>());
        let mut gyro = self.input.changed(sins_gyro_params { bias_rad_s: [1e-6; 3], ..init() });
        let mut accel = self.input.changed(init::<sins_accel_params>());
        let mut altimeter = self.input.changed(init::<sins_altimeter_params>());
        let mut initial = self.input.changed(init::<sins_initial_errors>());
        let mut mounting = self.input.changed(init::<sins_mounting>());
        let mut gravity = self.input.changed(init::<sins_gravity_params>());
        let mut request = self.input.changed(sins_budget_request { runs: 8, position_m: 1.0, ..init() });
        let mut budget = Block::of(&init::<sins_budget>());
        let capacity = self.input.below(64);
        let mut rows = Block::of(&init::<sins_budget_row>());
        let stride = rows.bytes.len();
        rows.bytes.resize(stride * capacity.max(1), 0);
        let mut written = 0;
        // SAFETY: as many bytes as they say.
        let status = unsafe {
            sins_error_budget(
                samples.pointer(),
                count,
                options.pointer(),
                gyro.pointer(),
                accel.pointer(),
                altimeter.pointer(),
                initial.pointer(),
                mounting.pointer(),
                gravity.pointer(),
                request.pointer(),
                rows.pointer(),
                capacity,
                &mut written,
                budget.pointer(),
            )
        };
        // How many there are, where they have no room.
        assert!(written <= capacity || status == SINS_ERROR_BUFFER_TOO_SMALL);
        if checked(status) >= 0 {
            assert!(budget.is_finite());
        }
    }
}
