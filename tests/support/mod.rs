//! Reference signals, flights and samples that several tests share. Each test program includes the whole module.
#![allow(dead_code)] // each program uses a part of it

use std::borrow::Borrow;
use std::path::{Path, PathBuf};

use nalgebra::Vector3;
use sins::earth::state::{BodyAxes, EarthFixedState};
use sins::earth::{Earth, Geodetic};
use sins::errors::NavigationErrors;
use sins::math::Euler;
use sins::sensors::{PARAMETERS, Parameter, ParameterShape, Sensor, TriadParameters};
use sins::signal::Increment;
use sins::truth::{FlightSample, Intake, IntakeLimits};

pub mod any_use;
pub mod budget;
pub mod c_programs;
pub mod closed_form;
pub mod draws;
pub mod fnv;
pub mod forged;
pub mod moments;
pub mod orbits;
pub mod patrol;
pub mod runs;
#[cfg(feature = "scenes")]
pub mod scenes;

pub const DEG: f64 = std::f64::consts::PI / 180.0;
pub const DEG_PER_HOUR: f64 = DEG / 3600.0;
pub const G: f64 = 9.80665;
pub const ARCSEC: f64 = DEG / 3600.0;
/// One milligal [m/s²].
pub const MILLIGAL: f64 = 1e-5;
/// Earth rate [rad/s].
pub const EARTH_RATE: f64 = 7.292_115e-5;

/// Each sensor parameter except for those of temperature, as by [`one_unit_of`]. Tests use them for the parameters that they do not
/// name.
pub fn one_unit_of_each(sensor: Sensor, scale: f64) -> TriadParameters {
    one_unit_of(sensor, scale, |parameter| !parameter.name.contains("temperature"))
}

/// The chosen sensor parameters: one data-sheet unit times `scale`, times 1, -0.7 and 0.4 along x, y and z.
pub fn one_unit_of(sensor: Sensor, scale: f64, chosen: impl Fn(&Parameter) -> bool) -> TriadParameters {
    let mut triad = TriadParameters::default();
    for (parameter, numbers) in PARAMETERS.iter().zip(triad.numbers_mut()).filter(|(row, _)| chosen(row)) {
        let Some(field) = parameter.of(sensor) else { continue };
        let has_diagonal = !matches!(parameter.shape, ParameterShape::OffDiagonal(_));
        for index in (0..numbers.len()).filter(|index| has_diagonal || index % 4 != 0) {
            let size = field.key_si * scale * [1.0, -0.7, 0.4][index % 3];
            numbers[index] = if field.range.ends().0 < 0.0 { size } else { size.abs() };
        }
    }
    triad
}

/// The text in an array of a struct.
pub fn text(chars: &[std::ffi::c_char]) -> String {
    let bytes: Vec<u8> = chars.iter().map(|letter| *letter as u8).collect();
    std::ffi::CStr::from_bytes_until_nul(&bytes).unwrap().to_str().unwrap().to_owned()
}

/// A file of the project.
pub fn project_file(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

/// A source in C, C++ or Rust without its comments, which name functions that it does not call.
pub fn without_comments(source: &str) -> String {
    let blocks = source.split("/*").map(|part| part.split_once("*/").map_or(part, |(_, code)| code));
    let code: String = blocks.collect();
    code.lines().flat_map(|line| [line.split("//").next().unwrap_or_default(), "\n"]).collect()
}

/// The C headers, one after the other.
pub fn headers() -> String {
    let names =
        ["sins.h", "sins_flight.h", "sins_analysis.h", "sins_unit.h", "sins_ensemble.h", "sins_scene.h"];
    names.map(|name| std::fs::read_to_string(project_file("include").join(name)).unwrap()).concat()
}

/// A table of named columns of numbers.
pub struct Table {
    names: Vec<String>,
    columns: Vec<Vec<f64>>,
}

impl Table {
    /// A file written by `tests/data/reference.py`, which describes the format.
    pub fn packed(name: &str) -> Self {
        let bytes = std::fs::read(project_file("tests/data").join(name)).unwrap();
        let mut input = bytes.strip_prefix(b"SINSPACK").unwrap();
        let mut table = Self { names: Vec::new(), columns: Vec::new() };
        for _ in 0..take(&mut input, 1)[0] {
            let length = usize::from(take(&mut input, 1)[0]);
            table.names.push(String::from_utf8(take(&mut input, length).to_vec()).unwrap());
            let &[decimals, order] = take(&mut input, 2) else { unreachable!() };
            let count = u32::from_le_bytes(take(&mut input, 4).try_into().unwrap());
            let mut values: Vec<i128> = (0..count).map(|_| varint(&mut input)).collect();
            for k in (0..usize::from(order)).rev() {
                for i in k + 1..values.len() {
                    values[i] += values[i - 1];
                }
            }
            // Two roundings at most: 1e-16 rad of latitude is 0.6 nm.
            let scale = 10f64.powi(i32::from(decimals));
            table.columns.push(values.into_iter().map(|value| value as f64 / scale).collect());
        }
        table
    }

    /// A CSV file; lines that begin with # are comments.
    pub fn csv(path: &str) -> Self {
        let text = std::fs::read_to_string(project_file(path)).unwrap();
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let names: Vec<String> = lines.next().unwrap().split(',').map(str::to_owned).collect();
        let mut columns = vec![Vec::new(); names.len()];
        for line in lines {
            for (column, field) in columns.iter_mut().zip(line.split(',')) {
                column.push(field.parse().unwrap());
            }
        }
        Self { names, columns }
    }

    pub fn column(&self, name: &str) -> &[f64] {
        let index = self.names.iter().position(|n| n == name);
        &self.columns[index.unwrap_or_else(|| panic!("no column {name}"))]
    }

    pub fn len(&self) -> usize {
        self.columns[0].len()
    }

    /// Three columns as vectors.
    pub fn vectors(&self, names: [&str; 3]) -> Vec<Vector3<f64>> {
        let [x, y, z] = names.map(|name| self.column(name));
        (0..self.len()).map(|i| Vector3::new(x[i], y[i], z[i])).collect()
    }

    /// The rows as flight samples; with `host_signals` they carry angular rate and specific force.
    pub fn samples(&self, host_signals: bool) -> Vec<FlightSample> {
        let velocity = self.vectors(["velocity_east_m_s", "velocity_north_m_s", "velocity_up_m_s"]);
        let angles = self.vectors(["roll_rad", "pitch_rad", "heading_rad"]);
        let signals = host_signals.then(|| {
            let rate = self.vectors(["rate_x_rad_s", "rate_y_rad_s", "rate_z_rad_s"]);
            (rate, self.vectors(["force_x_m_s2", "force_y_m_s2", "force_z_m_s2"]))
        });
        (0..self.len())
            .map(|i| FlightSample {
                time_s: self.column("time_s")[i],
                place: Geodetic {
                    latitude_rad: self.column("latitude_rad")[i],
                    longitude_rad: self.column("longitude_rad")[i],
                    height_m: self.column("height_m")[i],
                },
                v_n: Some(velocity[i]),
                euler: Euler { roll: angles[i].x, pitch: angles[i].y, heading: angles[i].z },
                omega_ib_b: signals.as_ref().map(|(rate, _)| rate[i]),
                f_b: signals.as_ref().map(|(_, force)| force[i]),
                temperature_c: None,
            })
            .collect()
    }
}

fn take<'a>(input: &mut &'a [u8], count: usize) -> &'a [u8] {
    let (head, tail) = input.split_at(count);
    *input = tail;
    head
}

fn varint(input: &mut &[u8]) -> i128 {
    let mut z = 0_u128;
    for shift in (0..).step_by(7) {
        let byte = take(input, 1)[0];
        z |= u128::from(byte & 127) << shift;
        if byte < 128 {
            break;
        }
    }
    (z >> 1) as i128 ^ -((z & 1) as i128)
}

/// An exact reference flight: truth samples, and exact integrals over each half interval.
pub struct Reference {
    pub truth: Table,
    pub increments: Vec<Increment>,
    pub period_s: f64,
}

impl Reference {
    pub fn load(name: &str) -> Self {
        let truth = Table::packed(&format!("{name}_truth.packed"));
        let table = Table::packed(&format!("{name}_increments.packed"));
        let angle = table.vectors(["angle_x_rad", "angle_y_rad", "angle_z_rad"]);
        let velocity = table.vectors(["velocity_x_m_s", "velocity_y_m_s", "velocity_z_m_s"]);
        let increments =
            angle.into_iter().zip(velocity).map(|(angle, velocity)| Increment { angle, velocity }).collect();
        let period_s = truth.column("time_s")[1];
        Self { truth, increments, period_s }
    }
}

/// A sample at rest, level, heading north, at Beijing's latitude 39.9° N as in the closed form's fixture.
pub fn resting_sample(time_s: f64) -> FlightSample {
    let place = Geodetic { latitude_rad: 39.9 * DEG, longitude_rad: 116.4 * DEG, height_m: 0.0 };
    FlightSample::at_rest(time_s, place, Euler::default())
}

/// The patrol of the tests: from Beijing's meridian, heading a little east of north.
pub fn patrol(duration_s: f64) -> sins::truth::flight::Flight {
    let start = sins::truth::flight::FlightStart {
        latitude_rad: 40.0 * DEG,
        longitude_rad: 116.4 * DEG,
        height_m: 8000.0,
        speed_m_s: 200.0,
        heading_rad: 0.3,
        ..Default::default()
    };
    patrol::patrol_from(&start, duration_s).unwrap()
}

/// Options with a stated sample rate and the vertical channel following the truth.
pub fn options_at(rate_hz: f64) -> sins::Options {
    sins::Options {
        vertical: sins::mechanization::VerticalMode::FollowTruth,
        intake: sins::truth::IntakeLimits { period_s: Some(1.0 / rate_hz), ..Default::default() },
        ..Default::default()
    }
}

/// Largest norms of the errors during a flight.
#[derive(Debug, Default)]
pub struct Worst {
    pub position_m: f64,
    pub velocity_m_s: f64,
    pub misalignment_rad: f64,
}

/// Bound of the rounding errors with perfect sensors at rest within `duration_s`. The rounded attitude tilts gravity. At worst the
/// tilt has one direction during half a Schuler swing, which gives a velocity of 2 g eps/ω, and a random direction in the next
/// half. The sensed rate equals Earth rate to two ulps, 2.7e-20 rad/s, and this error turns the vertical. Earth-fixed coordinates
/// are rounded three times, a quaternion four times.
pub fn rounding_at_rest(duration_s: f64) -> Worst {
    let (radius_m, schuler, rate) = (6.4e6, 1.24e-3, 2.7e-20);
    let half_swings = 1.0 + duration_s * schuler / std::f64::consts::PI;
    let swing_m_s = 2.0 * G * f64::EPSILON / schuler * half_swings.sqrt();
    let position_m = swing_m_s / schuler + radius_m * rate * duration_s + 3.0 * radius_m * f64::EPSILON;
    Worst {
        position_m,
        velocity_m_s: swing_m_s + 2.0 * radius_m * rate,
        misalignment_rad: rate * duration_s + position_m / radius_m + 4.0 * f64::EPSILON,
    }
}

/// Flies one sample.
pub fn step(simulator: &mut sins::Simulator, sample: &FlightSample) {
    simulator.push_sample(sample).unwrap();
    simulator.step().unwrap();
}

/// Flies all of `samples`.
pub fn fly_through(
    simulator: &mut sins::Simulator,
    samples: impl IntoIterator<Item = impl Borrow<FlightSample>>,
) {
    samples.into_iter().for_each(|sample| step(simulator, sample.borrow()));
}

/// The errors of a simulator that has flown.
pub fn errors(simulator: &sins::Simulator, source: sins::ErrorSource) -> NavigationErrors {
    simulator.errors(source).unwrap().unwrap().1
}

/// The exact state that a sample states.
pub fn state_of(earth: &Earth, sample: &FlightSample) -> EarthFixedState {
    let mut intake = Intake::new(*earth, BodyAxes::default(), IntakeLimits::default()).unwrap();
    intake.push(sample).unwrap();
    intake.front().unwrap().navigation(earth, BodyAxes::default()).earth_fixed(earth)
}

/// A struct of the C interface with its size set and all other fields 0.
pub fn init<T: Copy>() -> T {
    // SAFETY: the structs of the interface are numbers, and the size comes first.
    unsafe {
        let mut value: T = core::mem::zeroed();
        core::ptr::from_mut(&mut value).cast::<u32>().write(size_of::<T>() as u32);
        value
    }
}

/// Flies `samples` and returns the largest errors, read at every `every`-th sample.
pub fn fly(
    simulator: &mut sins::Simulator,
    samples: impl Iterator<Item = FlightSample>,
    every: usize,
) -> Worst {
    let mut worst = Worst::default();
    for (k, sample) in samples.enumerate() {
        step(simulator, &sample);
        if k % every == 0 {
            let (_, errors) = simulator.errors(sins::ErrorSource::Navigation).unwrap().unwrap();
            worst.position_m = worst.position_m.max(errors.position_n.norm());
            worst.velocity_m_s = worst.velocity_m_s.max(errors.velocity_n.norm());
            worst.misalignment_rad = worst.misalignment_rad.max(errors.misalignment_n.norm());
        }
    }
    worst
}

/// Flies `samples` and returns the signals of each interval.
pub fn sensed(
    simulator: &mut sins::Simulator,
    samples: impl IntoIterator<Item = FlightSample>,
) -> Vec<sins::ImuInterval> {
    let mut intervals = Vec::new();
    for sample in samples {
        simulator.push_sample(&sample).unwrap();
        if simulator.step().unwrap() == sins::Step::Done {
            intervals.push(simulator.imu().unwrap());
        }
    }
    intervals
}

/// The bits of the solution and of the errors of each available source.
pub fn bits(simulator: &sins::Simulator) -> Vec<u64> {
    let navigation = simulator.navigation().unwrap().unwrap().navigation;
    let place = &navigation.place;
    let mut values = vec![place.latitude_rad, place.longitude_rad, place.height_m];
    values.extend_from_slice(navigation.v_n.as_slice());
    values.extend_from_slice(navigation.q_nb.coords.as_slice());
    for source in [sins::ErrorSource::Navigation, sins::ErrorSource::Model] {
        if let Ok(Some((_, errors))) = simulator.errors(source) {
            values.extend_from_slice(errors.position_n.as_slice());
            values.extend_from_slice(errors.misalignment_n.as_slice());
        }
    }
    values.into_iter().map(f64::to_bits).collect()
}
