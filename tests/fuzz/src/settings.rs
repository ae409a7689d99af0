//! Calls that set errors of any size within the ranges of the header, including their ends.

use std::mem::offset_of;
use std::sync::LazyLock;

use sins::abi::*;
use sins::scene::{KeyKind, keys};
use sins::sensors::{self, PARAMETERS, ParameterRange, ParameterShape, Row, Sensor};
use sins::signal::mounting;

use crate::call;
use crate::host::{Host, init};
use crate::input::Input;

/// Numbers of a struct: offset [bytes], count, and limits.
type Range = (usize, usize, (f64, f64));

macro_rules! ranges {
    ($name:ident, $type:ty, $($field:ident: $count:literal, $low:expr, $high:expr;)*) => {
        const $name: &[Range] = &[$((offset_of!($type, $field), $count, ($low, $high))),*];
    };
}

/// The numbers of the struct of sensor parameters, in their order. Correlation times are not included
/// ([`markov_times`] chooses them), and neither are diagonals that must be 0.
fn triad_ranges(sensor: Sensor) -> Vec<Range> {
    let mut offset = 8;
    let mut ranges = Vec::new();
    for (parameter, field) in PARAMETERS.iter().filter_map(|row| Some((row, row.of(sensor)?))) {
        let (count, ends) = (parameter.shape.count(), field.range.ends());
        match (field.range, parameter.shape) {
            (ParameterRange::TimeOf(..), _) => {}
            (_, ParameterShape::OffDiagonal(_)) => {
                ranges.extend([(offset + 8, 3, ends), (offset + 40, 3, ends)])
            }
            _ => ranges.push((offset, count, ends)),
        }
        offset += 8 * count;
    }
    ranges
}

static GYRO: LazyLock<Vec<Range>> = LazyLock::new(|| triad_ranges(Sensor::Gyro));
static ACCEL: LazyLock<Vec<Range>> = LazyLock::new(|| triad_ranges(Sensor::Accelerometer));

ranges!(INITIAL, sins_initial_errors,
    position_enu_m: 3, -1e6, 1e6;
    velocity_enu_m_s: 3, -1e4, 1e4;
    misalignment_enu_rad: 3, -3.14, 3.14;
    position_sigma_enu_m: 3, 0.0, 1e5;
    velocity_sigma_enu_m_s: 3, 0.0, 1e3;
    misalignment_sigma_enu_rad: 3, 0.0, 1.0;
);

/// The numbers of a struct of another table, without the correlation times.
fn ranges_of(rows: &[Row]) -> Vec<Range> {
    let mut offset = 8;
    let range = |row: &Row| {
        let count = row.shape.count();
        offset += 8 * count;
        let is_time = matches!(row.field.range, ParameterRange::TimeOf(..));
        (!is_time).then_some((offset - 8 * count, count, row.field.range.ends()))
    };
    rows.iter().filter_map(range).collect()
}

static ALTIMETER: LazyLock<Vec<Range>> = LazyLock::new(|| ranges_of(&sensors::ALTIMETER));
static MOUNTING: LazyLock<Vec<Range>> = LazyLock::new(|| ranges_of(&mounting::MOUNTING));
static GRAVITY: LazyLock<Vec<Range>> = LazyLock::new(|| ranges_of(&sensors::GRAVITY));

ranges!(CORRECTION, sins_correction,
    position_enu_m: 3, -1e6, 1e6;
    velocity_enu_m_s: 3, -1e4, 1e4;
    misalignment_enu_rad: 3, -3.14, 3.14;
    gyro_bias_rad_s: 3, -100.0, 100.0;
    gyro_scale_factor: 3, -0.5, 0.5;
    accel_bias_m_s2: 3, -1e4, 1e4;
    accel_scale_factor: 3, -0.5, 0.5;
);

const SINUSOIDS: usize = 6;

/// A struct with some of its numbers set and all others 0. Most structs use a thousandth of their ranges.
fn filled<T: Copy>(input: &mut Input, ranges: &[Range]) -> T {
    let mut value = init::<T>();
    let place = std::ptr::from_mut(&mut value);
    let is_wild = input.one_in(3);
    let mask = match input.byte() {
        0..128 => 1 << input.below(ranges.len()),
        128..192 => input.word() & input.word() & input.word(),
        _ => input.word(),
    };
    for (index, &(offset, count, range)) in ranges.iter().enumerate() {
        if mask >> index & 1 == 0 {
            continue;
        }
        let axes = input.byte();
        for axis in (0..count).filter(|axis| axes >> (axis % 8) & 1 == 0) {
            let number = input.within(range);
            let number = if is_wild { number } else { (number * 1e-3).max(range.0) };
            // SAFETY: a number of the struct, 8 bytes after 8 bytes.
            unsafe { place.cast::<u8>().add(offset + 8 * axis).cast::<f64>().write(number) };
        }
    }
    value
}

fn markov_times(input: &mut Input) -> [f64; 3] {
    let times = [300.0, 1e-9, 1e15, 1.0];
    [input.pick(&times), input.pick(&times), input.pick(&times)]
}

pub fn some_gyro(input: &mut Input) -> sins_gyro_params {
    sins_gyro_params { markov_time_s: markov_times(input), ..filled(input, &GYRO) }
}

pub fn some_accel(input: &mut Input) -> sins_accel_params {
    sins_accel_params { markov_time_s: markov_times(input), ..filled(input, &ACCEL) }
}

pub fn some_altimeter(input: &mut Input) -> sins_altimeter_params {
    sins_altimeter_params { markov_time_s: markov_times(input)[0], ..filled(input, &ALTIMETER) }
}

pub fn some_initial_errors(input: &mut Input) -> sins_initial_errors {
    let alignment = input.pick(&[0, 0, 1, 2]);
    let alignment_s = input.pick(&[0.0, 1.0, 600.0, 86_400.0]);
    sins_initial_errors { alignment, alignment_s, ..filled(input, INITIAL) }
}

pub fn some_mounting(input: &mut Input) -> sins_mounting {
    filled(input, &MOUNTING)
}

pub fn some_correction(input: &mut Input) -> sins_correction {
    filled(input, CORRECTION)
}

pub fn some_gravity(input: &mut Input) -> sins_gravity_params {
    let mut gravity: sins_gravity_params = filled(input, &GRAVITY);
    for distance in [
        &mut gravity.deflection_north_distance_m,
        &mut gravity.deflection_east_distance_m,
        &mut gravity.anomaly_distance_m,
    ] {
        *distance = distance.max(1.0);
    }
    gravity
}

pub fn some_options(input: &mut Input) -> sins_options {
    let max_gap_s = input.pick(&[0.0, 0.0, 0.0, 1000.0, 10.0, 1.0, 5e-5]);
    let longest_s: f64 = if max_gap_s == 0.0 { 2.5 } else { max_gap_s };
    let is_closed = input.one_in(4);
    let shortest_loop_s = (4.0 * longest_s).max(1.0);
    sins_options {
        frame: i32::from(input.one_in(3)),
        scheme: input.below(3) as i32,
        subsamples: input.below(6) as i32,
        updates_per_sample: input.pick(&[0, 0, 1, 2, 16, 7]),
        vertical: input.below(3) as i32,
        error_model: i32::from(input.byte() % 2),
        earth: input.below(4) as i32,
        gravity: i32::from(input.one_in(3)),
        axes: i32::from(input.one_in(3)),
        signal: i32::from(is_closed),
        seed: u64::from(input.byte()),
        closed_loop_time_s: if is_closed { input.pick(&[shortest_loop_s, 1e4]) } else { 0.0 },
        sample_period_s: input.pick::<f64>(&[0.0, 0.0, 0.0, 0.01, 5e-5, longest_s]).min(longest_s),
        max_gap_s,
        max_acceleration_m_s2: input.pick(&[0.0, 0.0, 1e6, 1e-3, 1e4]),
        truth_summary: i32::from(input.one_in(4)),
        covariance: i32::from(input.one_in(4)),
        ..init()
    }
}

/// How many kinds of failure and of manoeuvre there are: their words in a scene, where no failure is one of the kinds.
static FAILURE_KINDS: LazyLock<usize> = LazyLock::new(|| kinds("failure"));
static MANOEUVRE_KINDS: LazyLock<usize> = LazyLock::new(|| kinds("manoeuvre"));

fn kinds(section: &str) -> usize {
    let key = keys().into_iter().find(|key| key.section == section && key.name == "kind");
    match key.map(|key| key.kind) {
        Some(KeyKind::Words(words)) => words.len(),
        _ => panic!("{section}: no words of its kinds"),
    }
}

/// A plausible failure of a random kind.
pub fn some_failure(input: &mut Input, sensor: i32) -> sins_failure {
    let largest = match sensor {
        SINS_SENSOR_GYRO => 100.0,
        SINS_SENSOR_ACCEL => 1e4,
        _ => 1e5,
    };
    let kind = input.below(*FAILURE_KINDS) as i32;
    let mut failure: sins_failure = init();
    failure.fields.kind = kind;
    let size = input.within((-largest, largest));
    let interval_s = input.pick(&[0.05, 1e-4, 1.0, 1e9]);
    match kind {
        SINS_FAILURE_BIAS_STEP => failure.fields.size = size,
        SINS_FAILURE_SPIKES => {
            let duration_s = input.pick(&[0.2 * interval_s, interval_s, 1e-9]);
            (failure.fields.size, failure.fields.interval_s, failure.fields.duration_s) =
                (size, interval_s, duration_s);
        }
        SINS_FAILURE_NOISE => failure.fields.density = size.abs(),
        SINS_FAILURE_DROP_OUTS if input.byte() < 128 => failure.fields.probability = input.within((0.0, 1.0)),
        SINS_FAILURE_DROP_OUTS => failure.fields.interval_s = interval_s,
        _ => {}
    }
    failure
}

/// A manoeuvre of a random kind, with the fields that this kind uses.
pub fn some_manoeuvre(input: &mut Input) -> sins_manoeuvre {
    let kind = input.below(*MANOEUVRE_KINDS) as i32;
    let mut manoeuvre: sins_manoeuvre = init();
    manoeuvre.kind = kind;
    manoeuvre.duration_s =
        if kind == SINS_MANOEUVRE_TURN { 0.0 } else { input.pick(&[20.0, 20.0, 100.0, 0.5, 1e-3, 5.0]) };
    match kind {
        SINS_MANOEUVRE_TURN => {
            (manoeuvre.heading_change_rad, manoeuvre.bank_rad) = (1.0, input.pick(&[0.5, 1e-3, 1.5]));
        }
        SINS_MANOEUVRE_CLIMB => manoeuvre.height_change_m = input.within((-1e3, 1e3)),
        SINS_MANOEUVRE_ACCELERATE => manoeuvre.speed_change_m_s = input.within((-100.0, 1e3)),
        SINS_MANOEUVRE_ROLL | SINS_MANOEUVRE_LOOP => manoeuvre.turns = input.pick(&[1.0, -1.0, 20.0]),
        SINS_MANOEUVRE_S_TURN => (manoeuvre.heading_change_rad, manoeuvre.turns) = (0.5, 2.0),
        SINS_MANOEUVRE_SINUSOIDS => {
            let count = 1 + input.below(SINUSOIDS);
            manoeuvre.sinusoid_count = count as i32;
            for term in 0..count {
                manoeuvre.channel[term] = input.below(6) as i32;
                manoeuvre.amplitude[term] = input.within((-1.5, 1.5));
                manoeuvre.frequency_hz[term] = input.pick(&[0.2, 0.2, 0.0, 1.0]);
            }
        }
        _ => {}
    }
    manoeuvre
}

impl Host {
    pub fn set_gyro(&mut self) {
        let gyro = some_gyro(&mut self.input);
        self.giving(gyro, |sim, gyro| call!(sins_set_gyro(sim, gyro)));
    }

    pub fn set_accel(&mut self) {
        let accel = some_accel(&mut self.input);
        self.giving(accel, |sim, accel| call!(sins_set_accel(sim, accel)));
    }

    pub fn set_altimeter(&mut self) {
        let altimeter = some_altimeter(&mut self.input);
        self.giving(altimeter, |sim, altimeter| call!(sins_set_altimeter(sim, altimeter)));
    }

    pub fn set_failure(&mut self) {
        let (sensor, axis) = (self.input.below(4) as i32, self.input.below(4) as i32);
        let failure = some_failure(&mut self.input, sensor);
        self.giving(failure, |sim, failure| call!(sins_set_failure(sim, sensor, axis, failure)));
    }

    pub fn set_initial_errors(&mut self) {
        let errors = some_initial_errors(&mut self.input);
        let place = self.start_again();
        self.giving_to(place, errors, |sim, errors| call!(sins_set_initial_errors(sim, errors)));
    }

    pub fn correct(&mut self) {
        let correction = some_correction(&mut self.input);
        self.giving(correction, |sim, correction| call!(sins_correct(sim, correction)));
    }

    pub fn set_mounting(&mut self) {
        let mounting = some_mounting(&mut self.input);
        let place = self.start_again();
        self.sims[place].is_mounted = true;
        self.giving_to(place, mounting, |sim, mounting| call!(sins_set_mounting(sim, mounting)));
    }

    pub fn set_gravity(&mut self) {
        let gravity = some_gravity(&mut self.input);
        let place = self.start_again();
        self.giving_to(place, gravity, |sim, gravity| call!(sins_set_gravity_disturbance(sim, gravity)));
    }

    pub fn set_preset(&mut self) {
        let (mut gyro, mut accel) = (init::<sins_gyro_params>(), init::<sins_accel_params>());
        let grade = self.input.below(8) as i32;
        if call!(sins_gyro_preset(grade, &mut gyro)) == SINS_OK {
            assert_eq!(call!(sins_accel_preset(grade, &mut accel)), SINS_OK);
            assert_eq!(call!(sins_initial_preset(grade, &mut init::<sins_initial_errors>())), SINS_OK);
            let place = self.place();
            self.changing(place, false, |sim| call!(sins_set_gyro(sim, &gyro)));
            self.changing(place, false, |sim| call!(sins_set_accel(sim, &accel)));
        }
    }
}
