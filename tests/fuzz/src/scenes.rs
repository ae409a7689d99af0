//! Calls that fly: samples, runs, increments, flights; recommendations and budgets of whole scenes.

use std::mem::offset_of;
use std::ptr::null_mut;

use sins::abi::*;

use crate::call;
use crate::host::{Host, init, look};
use crate::input::Argument;
use crate::settings::*;

/// Flights of months take seconds to create, as the header states. Their fields are replaced with
/// invalid numbers.
fn shorten(manoeuvre: &mut Argument) {
    let fields = [
        offset_of!(sins_manoeuvre, duration_s),
        offset_of!(sins_manoeuvre, heading_change_rad),
        offset_of!(sins_manoeuvre, turns),
        offset_of!(sins_manoeuvre, frequency_hz),
    ];
    for at in fields {
        if let Some(field) = manoeuvre.bytes.get_mut(at..at + 8)
            && f64::from_le_bytes(std::array::from_fn(|i| field[i])).abs() > 1e3
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
    fn push(&mut self, mut argument: Argument) {
        if self.bytes.is_empty() {
            self.stride = argument.bytes.len();
        }
        argument.bytes.resize(self.stride, 0);
        self.bytes.extend(argument.bytes);
    }

    fn pointer<T>(&self) -> *const T {
        self.bytes.as_ptr().cast()
    }
}

impl Host {
    /// The next sample of the simulator at a place, and the motion at it. The motion is stored when the
    /// sample is accepted.
    fn next_sample(&mut self, place: usize) -> (sins_flight_sample, crate::motion::Motion) {
        let sim = &mut self.sims[place];
        let motion = sim.motion.next(&mut self.input);
        let Some((flight, time_s)) = sim.aboard else { return (motion.sample(), motion) };
        let mut sample = init();
        let at_s = time_s + (motion.time_s - sim.motion.time_s);
        if call!(sins_flight_sample_at(self.flights[flight], at_s, &mut sample)) != SINS_OK {
            sim.aboard = None;
            return (motion.sample(), motion);
        }
        (sins_flight_sample { time_s: motion.time_s, ..motion.flagged(sample) }, motion)
    }

    /// Pushes the next sample.
    pub fn push(&mut self, place: usize) -> sins_status {
        let (sample, motion) = self.next_sample(place);
        let status = self.giving_to(place, sample, |sim, sample| call!(sins_push_sample(sim, sample)));
        match status {
            SINS_OK | SINS_GAP => self.advance(place, motion),
            // Some hosts continue with a reposition.
            SINS_ERROR_DISCONTINUITY | SINS_ERROR_TIME_ORDER | SINS_ERROR_INVALID_ARGUMENT
                if self.input.byte() < 128 =>
            {
                self.reposition(place);
            }
            _ => {}
        }
        status
    }

    fn advance(&mut self, place: usize, motion: crate::motion::Motion) {
        let sim = &mut self.sims[place];
        if let Some((_, time_s)) = &mut sim.aboard {
            *time_s += motion.time_s - sim.motion.time_s;
        }
        sim.motion = motion;
    }

    pub fn step(&mut self, place: usize) {
        let status = self.changing(place, false, |sim| call!(sins_step(sim)));
        match status {
            SINS_OK => self.hold_to_limits(place),
            SINS_ERROR_DIVERGED | SINS_ERROR_SINGULAR if self.input.byte() < 128 => {
                self.start_navigating_or_not(place, false);
                self.set_out(place);
            }
            _ => {}
        }
    }

    /// The next interval.
    pub fn fly(&mut self) {
        let place = self.place();
        if self.sims[place].is_navigating {
            return self.push_imu(place);
        }
        self.push(place);
        self.step(place);
    }

    /// Repositions the simulator, sometimes to another place.
    pub fn reposition(&mut self, place: usize) {
        if self.input.byte() < 64 {
            self.set_out(place);
        }
        let (sample, motion) = self.next_sample(place);
        let status = self.giving_to(place, sample, |sim, sample| call!(sins_reposition(sim, sample)));
        if status == SINS_OK {
            self.advance(place, motion);
        }
    }

    /// A slew, mostly to another place.
    pub fn move_truth(&mut self, place: usize) {
        if self.input.byte() < 192 {
            self.set_out(place);
        }
        let (sample, motion) = self.next_sample(place);
        let status = self.giving_to(place, sample, |sim, sample| call!(sins_move_truth(sim, sample)));
        if status == SINS_OK {
            self.advance(place, motion);
        }
    }

    /// A pause.
    pub fn move_time(&mut self, place: usize) {
        let number = self.input.number();
        let time_s = self.input.pick(&[0.0, 1.7e9, -9.9e9, 1e10, 1e3, number]);
        if self.changing(place, true, |sim| call!(sins_move_time(sim, time_s))) == SINS_OK {
            self.sims[place].motion.time_s = time_s;
        }
    }

    pub fn reset(&mut self, place: usize) {
        if self.changing(place, false, |sim| call!(sins_reset(sim))) == SINS_OK {
            self.sims[place].is_navigating = false;
        }
    }

    /// Mostly goes back before the first step, where settings of the start are allowed. Returns the place.
    pub fn start_again(&mut self) -> usize {
        let place = self.place();
        match self.input.byte() {
            0..96 => {}
            96..176 => self.reset(place),
            _ => self.reposition(place),
        }
        place
    }

    /// Mostly resets the simulator, and with `navigates` starts navigation from increments.
    pub fn start_navigating_or_not(&mut self, place: usize, navigates: bool) {
        if self.input.byte() < 192 {
            self.reset(place);
        }
        if !navigates {
            return;
        }
        let time_s = self.input.pick(&[0.0, 0.0, 1e10, -1e10]);
        let solution = sins_record_solution {
            latitude_rad: self.input.pick(&[0.7, 0.7, 0.0, 1.5, -std::f64::consts::FRAC_PI_2]),
            longitude_rad: self.input.pick(&[0.0, 100.0, 3.14]),
            height_m: self.input.pick(&[0.0, 0.0, 2000e3, -20e3]),
            velocity_enu_m_s: [
                self.input.pick(&[0.0, 100.0, 20e3, -20e3]),
                0.0,
                self.input.pick(&[0.0, 20e3]),
            ],
            quaternion_nb: self.input.pick(&[
                [1.0, 0.0, 0.0, 0.0],
                [0.6, 0.0, 0.0, 0.8],
                [0.5, -0.5, 0.5, 0.5005],
            ]),
            ..init::<sins_navigation>().solution
        };
        let start = sins_navigation { time_s, solution, ..init() };
        let status = self.giving_to(place, start, |sim, start| call!(sins_start_navigation(sim, start)));
        self.sims[place].is_navigating |= status == SINS_OK;
    }

    pub fn push_imu(&mut self, place: usize) {
        let count = 1 + self.input.below(5);
        let interval_s = self.input.pick(&[0.01, 0.01, 0.01, 5e-5, 10.0, 1.0]);
        let mut increment = sins_imu_increment { interval_s, count: count as i32, ..init() };
        let part_s = interval_s / count as f64;
        for part in 0..count {
            increment.velocity_m_s[3 * part + 2] = 9.8 * part_s;
        }
        if self.input.one_in(4) {
            for _ in 0..1 + self.input.below(4) {
                let at = self.input.below(3 * count);
                increment.angle_rad[at] = self.input.within((-3.1, 3.1));
                increment.velocity_m_s[at] += self.input.within((-1e4, 1e4));
            }
        }
        let status = self.giving_to(place, increment, |sim, increment| call!(sins_push_imu(sim, increment)));
        if status == SINS_OK {
            self.hold_to_limits(place);
        } else if status != SINS_ERROR_INVALID_ARGUMENT && self.input.byte() < 64 {
            self.start_navigating_or_not(place, true);
        }
    }

    /// The next samples of the simulator at a place, and the motion after them.
    fn samples(&mut self, place: usize, count: usize) -> (Array, crate::motion::Motion) {
        let start = (self.sims[place].motion, self.sims[place].aboard);
        let mut samples = Array::default();
        for _ in 0..count {
            let (sample, motion) = self.next_sample(place);
            self.advance(place, motion);
            samples.push(self.input.argument(sample));
        }
        let motion = self.sims[place].motion;
        (self.sims[place].motion, self.sims[place].aboard) = start;
        (samples, motion)
    }

    pub fn run(&mut self) {
        let place = self.place();
        let count = self.input.below(8);
        let (samples, motion) = self.samples(place, count);
        let records = Argument::of(&init::<sins_record>());
        let (every, capacity) = (self.input.below(4), self.input.below(16));
        let stride = records.bytes.len();
        // The intervals before an error stay flown, so the state before the call is not compared.
        let sim = self.sims[place].handle;
        let make = |sim| {
            let mut bytes = records.bytes.clone();
            bytes.resize(stride * capacity.max(1), 0);
            let mut written = 0;
            let status = call!(sins_run(
                sim,
                samples.pointer(),
                count,
                every,
                bytes.as_mut_ptr().cast(),
                capacity,
                &mut written
            ));
            assert!(written <= capacity);
            let (words, _) = bytes[..written * stride].as_chunks();
            assert!(
                words.iter().all(|&word| f64::from_le_bytes(word).is_finite()),
                "a record without numbers"
            );
            (status, bytes)
        };
        let (status, records) = make(sim);
        self.follower.follow(place, status, |sim| {
            let (status, same) = make(sim);
            assert!(same == records, "other records from the simulator that was loaded");
            status
        });
        if status >= 0 {
            self.advance(place, motion);
            if count > 1 {
                self.hold_to_limits(place);
            }
        }
        look(sim, self.input.below(16));
    }

    pub fn create_flight(&mut self) {
        let start = sins_flight_start {
            latitude_rad: self.input.pick(&[0.7, 0.7, 1.57, -1.2, 0.0]),
            speed_m_s: self.input.pick(&[200.0, 200.0, 0.0, 20.0, 8000.0]),
            height_m: self.input.pick(&[3000.0, 0.0, 100e3]),
            ..init()
        };
        let mut start = self.input.argument(start);
        let count = 1 + self.input.below(3);
        let mut manoeuvres = Array::default();
        for _ in 0..count {
            let manoeuvre = some_manoeuvre(&mut self.input);
            let mut argument = self.input.argument(manoeuvre);
            shorten(&mut argument);
            manoeuvres.push(argument);
        }
        let place = self.input.below(self.flights.len());
        let mut flight = null_mut();
        if call!(sins_flight_create(start.pointer(), manoeuvres.pointer(), count, &mut flight)) == SINS_OK {
            let mut duration_s = f64::NAN;
            assert_eq!(call!(sins_flight_duration(flight, &mut duration_s)), SINS_OK);
            assert!(duration_s > 0.0 && duration_s.is_finite(), "duration of a flight [{duration_s}]");
            let old = std::mem::replace(&mut self.flights[place], flight);
            if !old.is_null() {
                assert_eq!(call!(sins_flight_destroy(old)), SINS_OK);
            }
            self.board_flight(place);
        }
    }

    pub fn board(&mut self) {
        let flight = self.input.below(self.flights.len());
        self.board_flight(flight);
    }

    /// Gives a simulator the samples of a flight from now on.
    fn board_flight(&mut self, flight: usize) {
        let place = self.place();
        self.sims[place].aboard = Some((flight, 0.0));
        let (sample, motion) = self.next_sample(place);
        let status = self.giving_to(place, sample, |sim, sample| call!(sins_reposition(sim, sample)));
        if status == SINS_OK {
            self.advance(place, motion);
        }
    }

    /// A sample of a flight, at any time.
    pub fn sample_flight(&mut self) {
        let (flight, time_s) = (self.flight(), self.input.number());
        let mut sample = self.input.argument(init::<sins_flight_sample>());
        if call!(sins_flight_sample_at(flight, time_s, sample.pointer())) == SINS_OK {
            assert!(sample.is_finite());
        }
    }

    pub fn recommend(&mut self) {
        let place = self.place();
        let count = 2 + self.input.below(4);
        let (samples, _) = self.samples(place, count);
        let limits = [1.0, 1e-3, 1e-9, 5e-324, 1e300];
        let requirement = sins_requirement {
            duration_s: self.input.pick(&[0.0, 0.0, 1e6, 1.0]),
            position_m: self.input.pick(&limits),
            attitude_rad: if self.input.one_in(4) { self.input.pick(&limits) } else { 0.0 },
            ..init()
        };
        let mut requirement = self.input.argument(requirement);
        let (mut options, mut cost) =
            (Argument::of(&init::<sins_options>()), Argument::of(&init::<sins_cost>()));
        let status = call!(sins_recommend(
            self.sims[place].handle,
            samples.pointer(),
            count,
            requirement.pointer(),
            options.pointer(),
            cost.pointer()
        ));
        if status >= 0 {
            assert!(cost.is_finite(), "the cost of an algorithm");
        }
    }

    pub fn budget(&mut self) {
        let place = self.place();
        let count = 2 + self.input.below(4);
        let (samples, _) = self.samples(place, count);
        let input = &mut self.input;
        let request =
            sins_budget_request { runs: 8, position_m: input.pick(&[0.0, 1.0, 1e-9, 1e300]), ..init() };
        let mut request = input.argument(request);
        let mut budget = Argument::of(&init::<sins_budget>());
        let capacity = input.below(64);
        let mut rows = Argument::of(&init::<sins_budget_row>());
        let stride = rows.bytes.len();
        rows.bytes.resize(stride * capacity.max(1), 0);
        let mut written = 0;
        let status = call!(sins_error_budget(
            self.sims[place].handle,
            samples.pointer(),
            count,
            request.pointer(),
            rows.pointer(),
            capacity,
            &mut written,
            budget.pointer(),
        ));
        // If the buffer is too small, `written` is the number of rows that are needed.
        assert!(written <= capacity || status == SINS_ERROR_BUFFER_TOO_SMALL);
        if status >= 0 {
            assert!(budget.is_finite(), "a budget");
        }
    }
}
