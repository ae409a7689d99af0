//! Errors of sensors and of the start from published sources.

use nalgebra::{Matrix3, Vector3};

use super::initial::{Alignment, InitialErrorParameters};
use super::parameters::TriadParameters;
use crate::base::units::{DEG, DEG_PER_HOUR, DEG_PER_SQRT_HOUR, STANDARD_GRAVITY as G};

const FOOT_M: f64 = 0.3048;
/// The flat part of the Allan deviation of flicker noise of B = 1.
const FLAT: f64 = 0.664;

/// Grades of sensors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grade {
    /// Strategic: gyro bias 0.001 deg/h and accelerometer bias 1e-6 g, each 1 sigma (El-Sheimy and Youssef 2020, table 1, upper
    /// ends of the grade), angle random walk 0.0002 deg/sqrt(h), scale factor 20 ppm (Airbus Astrix 200). The table states 30 to 100 m/h
    /// for this grade, which holds in straight flight. In turns the scale factor dominates. From a perfect start, the CEP after an hour is
    /// 190 m on the built-in racetrack, and 35 m without the scale factor error. On the built-in patrol it is 1.6 km and 38 m.
    Strategic = 1, // submarines, ballistic missiles
    /// Navigation: Honeywell HG9900, brochure N61-1638. It states no accelerometer noise, so the preset has none: set your own.
    Navigation = 2, // airliners: a nautical mile an hour
    /// Tactical: Honeywell HG1700, brochure N61-1619. No scale factor or misalignment is stated.
    Tactical = 3, // guided weapons, aided navigation
    /// Industrial: Analog Devices ADIS16475-1, page 1 of its data sheet, rev. D. It states no accelerometer noise, so the preset
    /// has none: set your own. The range of the sensors is 125 deg/s and 8 g; the angle between two axes differs from 90 deg by
    /// 0.1 deg, 1 sigma.
    Industrial = 4, // calibrated micromechanics: drones, machines
    /// Consumer: InvenSense MPU-6050, uncalibrated, product specification rev. 3.4. Its tolerances are taken as 3 sigma.
    Consumer = 5, // uncalibrated micromechanics: telephones
    /// The paper's simulation 2: constant gyro bias 0.01 deg/h and angle random walk 0.005 deg/sqrt(h), constant accelerometer
    /// bias 1e-5 g and white noise 5e-6 g, taken as a density of 5e-6 g/sqrt(Hz) (for a bandwidth of 1 Hz, because the paper
    /// states none).
    PaperSimulation2 = 6,
}

impl Grade {
    /// Errors of gyros and of accelerometers, as a public source states them. What the source does not state is 0. What the source
    /// states becomes:
    ///
    /// | stated | here |
    /// |---|---|
    /// | 1 σ, a repeatability, or a size without a bound (±0.1°, 20 ppm) | standard deviation of what is drawn at turn-on |
    /// | a tolerance, from least to most (±3 %) | three standard deviations |
    /// | angle between two axes off square by σ | each of its two misalignments drawn with σ/√2: the angle is their sum |
    /// | lowest Allan deviation, "in-run bias stability" | 0.664 B of flicker noise |
    /// | g-sensitivity | each gyro along its own axis, positive sign |
    pub fn parameters(self) -> (TriadParameters, TriadParameters) {
        match self {
            Self::Strategic => strategic(),
            Self::Navigation => navigation(),
            Self::Tactical => tactical(),
            Self::Industrial => industrial(),
            Self::Consumer => consumer(),
            Self::PaperSimulation2 => paper_simulation2(),
        }
    }

    /// Errors of the start. Strategic and navigation grade find north; the other grades level, and have the heading of a magnetic compass,
    /// because the bias of their gyros is a tenth of the Earth rate or more, or is not stated. The paper states no errors of the start.
    pub fn start(self) -> InitialErrorParameters {
        match self {
            Self::Strategic | Self::Navigation => InitialErrorParameters {
                alignment: Alignment::LevelAndGyrocompass,
                ..started(GYROCOMPASS_S, 0.0)
            },
            Self::Tactical => started(LEVEL_S, 1.0),
            Self::Industrial => started(LEVEL_S, 2.0),
            Self::Consumer => started(LEVEL_S, 4.0),
            Self::PaperSimulation2 => InitialErrorParameters::default(),
        }
    }
}

/// Gyrocompassing of airliners takes 5 to 17 minutes by latitude (Boeing 737 MAX flight crew operations manual, 11.20); 10 minutes
/// is that of 50°.
const GYROCOMPASS_S: f64 = 600.0;
/// Levelling of the attitude mode of the same units takes 30 s.
const LEVEL_S: f64 = 30.0;

/// A levelled start, with a heading that a compass shows with a standard deviation of `heading_deg` [°]: 1° Caruso, "Applications
/// of Magnetic Sensors for Low Cost Compass Systems" (Honeywell), 2° and 4° Tomasch and Winer, "Limits of Absolute Heading
/// Accuracy Using Inexpensive MEMS Sensors", 2018, with a good and with a simple calibration. The position is that of GPS: 8 m
/// horizontally and 13 m vertically, 95 % (Standard Positioning Service Performance Standard, 5th ed., 2020), which is
/// √(-2 ln 0.05) = 2.448 and 1.960 standard deviations of one axis.
fn started(alignment_s: f64, heading_deg: f64) -> InitialErrorParameters {
    InitialErrorParameters {
        position_sigma_n: Vector3::new(3.27, 3.27, 6.63),
        misalignment_sigma_n: Vector3::new(0.0, 0.0, heading_deg * DEG),
        alignment: Alignment::Level,
        alignment_s,
        ..Default::default()
    }
}

/// The same value on all axes.
fn each(value: f64) -> Vector3<f64> {
    Vector3::repeat(value)
}

/// The same value in all elements except for the diagonal, which is 0.
fn beside_diagonal(value: f64) -> Matrix3<f64> {
    Matrix3::repeat(value) - Matrix3::from_diagonal_element(value)
}

/// Misalignments of a triad whose axes are off square by `sigma` [rad], 1 σ of each pair.
fn off_square(sigma: f64) -> Matrix3<f64> {
    beside_diagonal(sigma * core::f64::consts::FRAC_1_SQRT_2)
}

/// El-Sheimy and Youssef, "Inertial sensors technologies for navigation applications", Satellite Navigation 1:2, 2020, table 1,
/// strategic grade, upper ends: gyro drift 0.001 °/h, accelerometer bias 1 µg. Airbus, product page of the Astrix 200: angle random
/// walk 0.0002 °/√h, scale factor 20 ppm.
fn strategic() -> (TriadParameters, TriadParameters) {
    let gyro = TriadParameters {
        bias_sigma: each(0.001 * DEG_PER_HOUR),
        random_walk: each(0.0002 * DEG_PER_SQRT_HOUR),
        scale_factor_sigma: each(20e-6),
        ..Default::default()
    };
    (gyro, TriadParameters { bias_sigma: each(1e-6 * G), ..Default::default() })
}

/// Honeywell, HG9900 brochure N61-1638-000-000, all 1 σ: gyro bias 0.0035 °/h, angle random walk at most 0.002 °/√h, scale factor
/// 5 ppm; accelerometer bias 25 µg, scale factor 100 ppm.
fn navigation() -> (TriadParameters, TriadParameters) {
    let gyro = TriadParameters {
        bias_sigma: each(0.0035 * DEG_PER_HOUR),
        random_walk: each(0.002 * DEG_PER_SQRT_HOUR),
        scale_factor_sigma: each(5e-6),
        ..Default::default()
    };
    let accel = TriadParameters {
        bias_sigma: each(25e-6 * G),
        scale_factor_sigma: each(100e-6),
        ..Default::default()
    };
    (gyro, accel)
}

/// Honeywell, HG1700 brochure N61-1619-000-001, the better models, all 1 σ: gyro bias 1 °/h, angle random walk at most
/// 0.125 °/√h; accelerometer bias 1 mg, velocity random walk at most 0.065 ft/s/√h.
fn tactical() -> (TriadParameters, TriadParameters) {
    let gyro = TriadParameters {
        bias_sigma: each(DEG_PER_HOUR),
        random_walk: each(0.125 * DEG_PER_SQRT_HOUR),
        ..Default::default()
    };
    let accel = TriadParameters {
        bias_sigma: each(1e-3 * G),
        random_walk: each(0.065 * FOOT_M / 60.0),
        ..Default::default()
    };
    (gyro, accel)
}

/// Analog Devices, ADIS16475 data sheet, rev. D, page 1, model ADIS16475-1: gyros 2 °/h in run, 0.15 °/√h, ±125 °/s;
/// accelerometers 3.6 µg in run, ±8 g; ±0.1° axis to axis.
fn industrial() -> (TriadParameters, TriadParameters) {
    let gyro = TriadParameters {
        flicker: each(2.0 * DEG_PER_HOUR / FLAT),
        random_walk: each(0.15 * DEG_PER_SQRT_HOUR),
        misalignment_sigma: off_square(0.1 * DEG),
        range: each(125.0 * DEG),
        ..Default::default()
    };
    let accel = TriadParameters {
        flicker: each(3.6e-6 * G / FLAT),
        misalignment_sigma: off_square(0.1 * DEG),
        range: each(8.0 * G),
        ..Default::default()
    };
    (gyro, accel)
}

/// InvenSense, MPU-6000 and MPU-6050 product specification PS-MPU-6000A-00, rev. 3.4, sections 6.1 and 6.2: gyros ±20 °/s of
/// zero-rate output, ±3 % of scale factor, ±2 % across, 0.1 °/s/g, 0.005 °/s/√Hz, ±2000 °/s, 256 Hz; accelerometers ±50 mg
/// (±80 mg along z), ±3 %, ±2 % across, 400 µg/√Hz, ±16 g, 260 Hz. All ± are tolerances.
fn consumer() -> (TriadParameters, TriadParameters) {
    let gyro = TriadParameters {
        bias_sigma: each(20.0 * DEG / 3.0),
        random_walk: each(0.005 * DEG),
        scale_factor_sigma: each(0.03 / 3.0),
        misalignment_sigma: beside_diagonal(0.02 / 3.0),
        g_sensitivity: Matrix3::from_diagonal_element(0.1 * DEG / G),
        range: each(2000.0 * DEG),
        bandwidth_hz: each(256.0),
        ..Default::default()
    };
    let accel = TriadParameters {
        bias_sigma: Vector3::new(50e-3, 50e-3, 80e-3) * (G / 3.0),
        random_walk: each(400e-6 * G),
        scale_factor_sigma: each(0.03 / 3.0),
        misalignment_sigma: beside_diagonal(0.02 / 3.0),
        range: each(16.0 * G),
        bandwidth_hz: each(260.0),
        ..Default::default()
    };
    (gyro, accel)
}

/// The errors of the paper's simulation 2, gyros and accelerometers: constant drift 0.01 °/h and bias 1e-5 g, angle
/// random walk 0.005 °/√h, accelerometer white noise of 5e-6 g.
///
/// Departure: the paper gives the accelerometer noise without a bandwidth. It is read here as the standard deviation in a
/// band of 1 Hz, 5 µg/√Hz.
pub fn paper_simulation2() -> (TriadParameters, TriadParameters) {
    let gyro = TriadParameters {
        bias: each(0.01 * DEG_PER_HOUR),
        random_walk: each(0.005 * DEG_PER_SQRT_HOUR),
        ..Default::default()
    };
    let accel = TriadParameters { bias: each(1e-5 * G), random_walk: each(5e-6 * G), ..Default::default() };
    (gyro, accel)
}
