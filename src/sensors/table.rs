//! The table of the parameters of gyros and accelerometers: each is listed here once.
//!
//! `build.rs` makes from the table the structs [`TriadParameters`](super::TriadParameters), `sins_gyro_params` and
//! `sins_accel_params` with the header. The checks of parameters, the keys of scene files, the rows of an error budget and lists of
//! tests read the table.
//!
//! A new parameter needs a row here, the formula of its effect and a test. Rows of a group are next to each other. From the first
//! release on, structs of the interface grow only at their ends: a new row is then the last one, and each struct keeps its first
//! size.

use crate::base::parameter::Range::{OffOr, TimeOf, Within};
use crate::base::parameter::Shape::{Axes, Diagonal, Matrix, Number, OffDiagonal};
use crate::base::parameter::{CORRELATION_TIMES_S, Parameter, Range, defined, field};
use crate::base::units::{
    ARCSEC, DEG, DEG_PER_HOUR, DEG_PER_SQRT_HOUR, MICRO_G, PPM, STANDARD_GRAVITY, TEMPERATURE_RANGE_C,
};

// The limits have one purpose: wild values of a host must not overflow the navigator.
const RATE: Range = Within(-100.0, 100.0);
const RATE_SIZE: Range = Within(0.0, 100.0);
const FORCE: Range = Within(-1e4, 1e4);
const FORCE_SIZE: Range = Within(0.0, 1e4);
const SHARE: Range = Within(-1.0, 1.0);
const SHARE_SIZE: Range = Within(0.0, 1.0);
const PULSE: Range = OffOr(1e-15, 1.0);
const SATURATION: Range = OffOr(1e-9, 1e6);
const FREQUENCY: Range = OffOr(1e-3, 1e6);
const TEMPERATURE: Range = Within(TEMPERATURE_RANGE_C.0, TEMPERATURE_RANGE_C.1);
const MARKOV_TIME: Range = TimeOf("markov_sigma", CORRELATION_TIMES_S.0, CORRELATION_TIMES_S.1);

/// One degree per hour per g [(rad/s)/(m/s²)].
const DEG_PER_HOUR_PER_G: f64 = DEG_PER_HOUR / STANDARD_GRAVITY;

const GIVEN: bool = false;
const RANDOM: bool = true;

/// Every parameter, in the order of the structs of the interface.
#[rustfmt::skip]
pub const PARAMETERS: &[Parameter] = &[
    // Bias and noise.
    Parameter {
        name: "bias", shape: Axes, is_random: GIVEN,
        doc: "constant bias, measured less true", note: "",
        gyro: field(("gyro.bias_rad_s", "rad/s"), RATE, ("bias_deg_h", "deg/h", DEG_PER_HOUR), "gyro bias"),
        accel: field(("accel.bias_m_s2", "m/s2"), FORCE, ("bias_micro_g", "micro-g", MICRO_G), "accel bias"),
    },
    Parameter {
        name: "bias_sigma", shape: Axes, is_random: RANDOM,
        doc: "standard deviation of the turn-on bias, drawn once a run", note: "",
        gyro: field(("gyro.bias_sigma_rad_s", "rad/s"), RATE_SIZE,
            ("bias_sigma_deg_h", "deg/h", DEG_PER_HOUR), "gyro turn-on bias"),
        accel: field(("accel.bias_sigma_m_s2", "m/s2"), FORCE_SIZE,
            ("bias_sigma_micro_g", "micro-g", MICRO_G), "accel turn-on bias"),
    },
    Parameter {
        name: "markov_sigma", shape: Axes, is_random: RANDOM,
        doc: "standard deviation of the first-order Gauss-Markov bias",
        note: "The process is stationary from the first sample on.",
        gyro: field(("gyro.markov_sigma_rad_s", "rad/s"), RATE_SIZE,
            ("markov_sigma_deg_h", "deg/h", DEG_PER_HOUR), "gyro Gauss-Markov bias"),
        accel: field(("accel.markov_sigma_m_s2", "m/s2"), FORCE_SIZE,
            ("markov_sigma_micro_g", "micro-g", MICRO_G), "accel Gauss-Markov bias"),
    },
    Parameter {
        name: "markov_time_s", shape: Axes, is_random: RANDOM,
        doc: "correlation time of the Gauss-Markov bias", note: "",
        gyro: field(("gyro.markov_time_s", "s"), MARKOV_TIME, ("markov_time_s", "s", 1.0), ""),
        accel: field(("accel.markov_time_s", "s"), MARKOV_TIME, ("markov_time_s", "s", 1.0), ""),
    },
    Parameter {
        name: "random_walk", shape: Axes, is_random: RANDOM,
        doc: "white noise N: angle or velocity random walk",
        note: "It is the square root of the spectral density of the noise, in the unit of the signal per sqrt(Hz).",
        gyro: defined("white noise N: angle random walk", field(("gyro.random_walk_rad_sqrt_s", "rad/sqrt(s)"), RATE_SIZE,
            ("random_walk_deg_sqrt_h", "deg/sqrt(h)", DEG_PER_SQRT_HOUR), "gyro angle random walk")),
        accel: defined("white noise N: velocity random walk", field(("accel.velocity_random_walk_m_s_sqrt_s", "(m/s)/sqrt(s)"), FORCE_SIZE,
            ("random_walk_micro_g_sqrt_hz", "micro-g/sqrt(Hz)", MICRO_G), "accel velocity random walk")),
    },
    Parameter {
        name: "rate_random_walk", shape: Axes, is_random: RANDOM,
        doc: "random walk K of rate or acceleration",
        note: "It starts at 0 at the start of a run.",
        gyro: defined("rate random walk K", field(("gyro.rate_random_walk_rad_s_sqrt_s", "(rad/s)/sqrt(s)"), RATE_SIZE,
            ("rate_random_walk_deg_h_sqrt_h", "deg/h/sqrt(h)", DEG_PER_HOUR / 60.0), "gyro rate random walk")),
        accel: defined("acceleration random walk K", field(("accel.acceleration_random_walk_m_s2_sqrt_s", "(m/s2)/sqrt(s)"), FORCE_SIZE,
            ("acceleration_random_walk_micro_g_sqrt_h", "micro-g/sqrt(h)", MICRO_G / 60.0), "acceleration random walk")),
    },
    Parameter {
        name: "ramp", shape: Axes, is_random: GIVEN,
        doc: "ramp R: bias that grows with time",
        note: "The bias starts at 0 when the ramp is switched on, and at sins_reset(). If R is changed in flight, the bias continues from \
            its present value.",
        gyro: field(("gyro.rate_ramp_rad_s2", "rad/s2"), RATE,
            ("rate_ramp_deg_h2", "deg/h/h", DEG_PER_HOUR / 3600.0), "gyro ramp"),
        accel: field(("accel.ramp_m_s3", "m/s3"), FORCE,
            ("ramp_micro_g_h", "micro-g/h", MICRO_G / 3600.0), "accel ramp"),
    },
    Parameter {
        name: "flicker", shape: Axes, is_random: RANDOM,
        doc: "flicker noise, bias instability B",
        note: "The process is stationary from the first sample on: the Allan deviation is flat at 0.664 B from 2 s to 50 h.",
        gyro: field(("gyro.flicker_rad_s", "rad/s"), RATE_SIZE,
            ("flicker_deg_h", "deg/h", DEG_PER_HOUR), "gyro flicker"),
        accel: field(("accel.flicker_m_s2", "m/s2"), FORCE_SIZE,
            ("flicker_micro_g", "micro-g", MICRO_G), "accel flicker"),
    },

    // Scale factor and misalignment.
    Parameter {
        name: "scale_factor", shape: Axes, is_random: GIVEN,
        doc: "scale factor error", note: "",
        gyro: field(("gyro.scale_factor", ""), SHARE, ("scale_factor_ppm", "ppm", PPM), "gyro scale factor"),
        accel: field(("accel.scale_factor", ""), SHARE, ("scale_factor_ppm", "ppm", PPM), "accel scale factor"),
    },
    Parameter {
        name: "scale_factor_sigma", shape: Axes, is_random: RANDOM,
        doc: "standard deviation of the turn-on scale factor error, drawn once a run",
        note: "It is added to scale_factor.",
        gyro: field(("gyro.scale_factor_sigma", ""), SHARE_SIZE,
            ("scale_factor_sigma_ppm", "ppm", PPM), "gyro turn-on scale factor"),
        accel: field(("accel.scale_factor_sigma", ""), SHARE_SIZE,
            ("scale_factor_sigma_ppm", "ppm", PPM), "accel turn-on scale factor"),
    },
    Parameter {
        name: "scale_factor_asymmetry", shape: Axes, is_random: GIVEN,
        doc: "scale factor error for positive signals less that for negative signals", note: "The error of a signal s is half of this times |s|.",
        gyro: field(("gyro.scale_factor_asymmetry", ""), SHARE,
            ("scale_factor_asymmetry_ppm", "ppm", PPM), "gyro asymmetry"),
        accel: field(("accel.scale_factor_asymmetry", ""), SHARE,
            ("scale_factor_asymmetry_ppm", "ppm", PPM), "accel asymmetry"),
    },
    Parameter {
        name: "scale_factor_nonlinearity", shape: Axes, is_random: GIVEN,
        doc: "scale factor error that grows with the size of the signal", note: "The error of a signal s is this times s |s|.",
        gyro: field(("gyro.scale_factor_nonlinearity_s_rad", "s/rad"), SHARE,
            ("scale_factor_nonlinearity_ppm_per_deg_s", "ppm/(deg/s)", PPM / DEG), "gyro nonlinearity"),
        accel: field(("accel.scale_factor_nonlinearity_s2_m", "s2/m"), SHARE,
            ("scale_factor_nonlinearity_ppm_per_g", "ppm/g", PPM / STANDARD_GRAVITY), "accel nonlinearity"),
    },
    Parameter {
        name: "misalignment", shape: OffDiagonal("must be 0 on the diagonal; use scale_factor"), is_random: GIVEN,
        doc: "misalignment: row = sensor, column = axis it should not sense",
        note: "The error of sensor i is the sum over j of element (i, j) times the true signal along axis j. The diagonal must be 0.",
        gyro: field(("gyro.misalignment_rad", "rad"), SHARE,
            ("misalignment_arcsec", "arcsec", ARCSEC), "gyro misalignment"),
        accel: field(("accel.misalignment_rad", "rad"), SHARE,
            ("misalignment_arcsec", "arcsec", ARCSEC), "accel misalignment"),
    },
    Parameter {
        name: "misalignment_sigma", shape: OffDiagonal("must be 0 on the diagonal; use scale_factor_sigma"), is_random: RANDOM,
        doc: "standard deviation of each turn-on misalignment, drawn once a run",
        note: "It is added to misalignment_rad. The diagonal must be 0.",
        gyro: field(("gyro.misalignment_sigma_rad", "rad"), SHARE_SIZE,
            ("misalignment_sigma_arcsec", "arcsec", ARCSEC), "gyro turn-on misalignment"),
        accel: field(("accel.misalignment_sigma_rad", "rad"), SHARE_SIZE,
            ("misalignment_sigma_arcsec", "arcsec", ARCSEC), "accel turn-on misalignment"),
    },

    // Acceleration and vibration.
    Parameter {
        name: "g_sensitivity", shape: Diagonal, is_random: GIVEN,
        doc: "drift caused by specific force, g-sensitivity: row = gyro, column = axis of the force",
        note: "The error of a gyro is the sum over the three axes of its row times the true specific force along them.",
        gyro: field(("gyro.g_sensitivity_rad_s_per_m_s2", "(rad/s)/(m/s2)"), SHARE,
            ("g_sensitivity_deg_h_per_g", "deg/h/g", DEG_PER_HOUR_PER_G), "gyro g-sensitivity"),
        accel: None,
    },
    Parameter {
        name: "g2_sensitivity", shape: Axes, is_random: GIVEN,
        doc: "drift caused by the square of the specific force along the gyro's own axis, g2-sensitivity",
        note: "The rate error of gyro i is element i times the square of the true specific force along sensor axis i, at the point of \
            the sensor block (see sins_mounting). So a positive element makes a drift in the positive sense about the axis, whatever the sign \
            of the force. The mean force of a subsample is squared, as with nonlinearity.",
        gyro: field(("gyro.g2_sensitivity_rad_s_per_m2_s4", "(rad/s)/(m/s2)^2"), SHARE,
            ("g2_sensitivity_deg_h_per_g2", "deg/h/g2", DEG_PER_HOUR_PER_G / STANDARD_GRAVITY), "gyro g2-sensitivity"),
        accel: None,
    },
    Parameter {
        name: "vibration_rectification_s2_m", shape: Axes, is_random: GIVEN,
        doc: "vibration rectification, the g2 term",
        note: "The error is this times the square of the mean force of a subsample. So a vibration with the root mean square r causes a bias of this times r squared.",
        gyro: None,
        accel: field(("accel.vibration_rectification_s2_m", "s2/m"), SHARE,
            ("vibration_rectification_micro_g_per_g2", "micro-g/g2", 1e-6 / STANDARD_GRAVITY), "accel vibration rectification"),
    },
    Parameter {
        name: "lever_arm_m", shape: Matrix, is_random: GIVEN,
        doc: "lever arm of each accelerometer from the point of the sensor block, sensor axes, row = sensor (size effect)",
        note: "The point of the sensor block is where the lever arm of sins_mounting ends. If a flight starts in motion, samples without an \
            angular rate do not show the angular acceleration of the first interval (see sins_mounting). The measured velocity is then wrong for \
            the rest of the flight: it lacks the lever arm times the change of the angular rate in the first interval. \
            With sins_push_imu() the angular acceleration follows from the previous increments.",
        gyro: None,
        accel: field(("accel.lever_arm_m", "m"), Within(-100.0, 100.0),
            ("lever_arm_mm", "mm", 1e-3), "accel size effect"),
    },

    // Temperature.
    Parameter {
        name: "reference_temperature_c", shape: Number, is_random: GIVEN,
        doc: "temperature at which the four temperature coefficients have no effect",
        note: "T is sins_flight_sample.temperature_c less this temperature. If one of the coefficients is not 0, every sample needs a \
            temperature, and sins_push_imu() is not available.",
        gyro: field(("gyro.reference_temperature_c", "deg C"), TEMPERATURE,
            ("reference_temperature_c", "deg C", 1.0), ""),
        accel: field(("accel.reference_temperature_c", "deg C"), TEMPERATURE,
            ("reference_temperature_c", "deg C", 1.0), ""),
    },
    Parameter {
        name: "bias_temperature", shape: Axes, is_random: GIVEN,
        doc: "bias per kelvin", note: "The bias is this coefficient times T.",
        gyro: field(("gyro.bias_temperature_rad_s_per_k", "(rad/s)/K"), RATE,
            ("bias_temperature_deg_h_per_k", "deg/h/K", DEG_PER_HOUR), "gyro bias/temperature"),
        accel: field(("accel.bias_temperature_m_s2_per_k", "(m/s2)/K"), FORCE,
            ("bias_temperature_micro_g_per_k", "micro-g/K", MICRO_G), "accel bias/temperature"),
    },
    Parameter {
        name: "bias_temperature2", shape: Axes, is_random: GIVEN,
        doc: "bias per kelvin squared", note: "The bias is this coefficient times T squared.",
        gyro: field(("gyro.bias_temperature2_rad_s_per_k2", "(rad/s)/K2"), RATE,
            ("bias_temperature2_deg_h_per_k2", "deg/h/K2", DEG_PER_HOUR), "gyro bias/temperature squared"),
        accel: field(("accel.bias_temperature2_m_s2_per_k2", "(m/s2)/K2"), FORCE,
            ("bias_temperature2_micro_g_per_k2", "micro-g/K2", MICRO_G), "accel bias/temperature squared"),
    },
    Parameter {
        name: "scale_factor_temperature", shape: Axes, is_random: GIVEN,
        doc: "scale factor error per kelvin", note: "The scale factor error is this coefficient times T.",
        gyro: field(("gyro.scale_factor_temperature_per_k", "1/K"), SHARE,
            ("scale_factor_temperature_ppm_per_k", "ppm/K", PPM), "gyro scale/temperature"),
        accel: field(("accel.scale_factor_temperature_per_k", "1/K"), SHARE,
            ("scale_factor_temperature_ppm_per_k", "ppm/K", PPM), "accel scale/temperature"),
    },
    Parameter {
        name: "scale_factor_temperature2", shape: Axes, is_random: GIVEN,
        doc: "scale factor error per kelvin squared", note: "The scale factor error is this coefficient times T squared.",
        gyro: field(("gyro.scale_factor_temperature2_per_k2", "1/K2"), SHARE,
            ("scale_factor_temperature2_ppm_per_k2", "ppm/K2", PPM), "gyro scale/temperature squared"),
        accel: field(("accel.scale_factor_temperature2_per_k2", "1/K2"), SHARE,
            ("scale_factor_temperature2_ppm_per_k2", "ppm/K2", PPM), "accel scale/temperature squared"),
    },

    // Bandwidth and output.
    Parameter {
        name: "bandwidth_hz", shape: Axes, is_random: GIVEN,
        doc: "bandwidth, -3 dB of a second-order Butterworth filter",
        note: "The filter starts in its steady state, so there is no transient in the first interval.",
        gyro: field(("gyro.bandwidth_hz", "Hz"), FREQUENCY, ("bandwidth_hz", "Hz", 1.0), "gyro bandwidth"),
        accel: field(("accel.bandwidth_hz", "Hz"), FREQUENCY, ("bandwidth_hz", "Hz", 1.0), "accel bandwidth"),
    },
    Parameter {
        name: "dead_zone", shape: Axes, is_random: GIVEN,
        doc: "half the dead zone: signals up to this size give 0", note: "",
        gyro: field(("gyro.dead_zone_rad_s", "rad/s"), RATE_SIZE,
            ("dead_zone_deg_h", "deg/h", DEG_PER_HOUR), "gyro dead zone"),
        accel: field(("accel.dead_zone_m_s2", "m/s2"), FORCE_SIZE,
            ("dead_zone_micro_g", "micro-g", MICRO_G), "accel dead zone"),
    },
    Parameter {
        name: "range", shape: Axes, is_random: GIVEN,
        doc: "range, where the output saturates", note: "Saturation is flagged in sins_imu.",
        gyro: field(("gyro.range_rad_s", "rad/s"), SATURATION, ("range_deg_s", "deg/s", DEG), "gyro range"),
        accel: field(("accel.range_m_s2", "m/s2"), SATURATION, ("range_g", "g", STANDARD_GRAVITY), "accel range"),
    },
    Parameter {
        name: "quantization", shape: Axes, is_random: GIVEN,
        doc: "quantum (pulse weight) of the output increments", note: "The remainder goes into the next increment. The quantization noise Q is quantum/sqrt(12).",
        gyro: field(("gyro.quantization_rad", "rad"), PULSE,
            ("quantization_arcsec", "arcsec", ARCSEC), "gyro quantization"),
        accel: field(("accel.quantization_m_s", "m/s"), PULSE,
            ("quantization_mm_s", "mm/s", 1e-3), "accel quantization"),
    },
];
