//! `sins_options`.

use super::choice::{Choice, check_reserved, choices, switch};
use super::failure::CallError;
use super::memory::interface_struct;
use super::parameters::Parameters;
use crate::base::error::{Error, Rule, check_integer};
use crate::earth::state::BodyAxes;
use crate::earth::{Ellipsoid, GravityModel};
use crate::mechanization::{Frame, Scheme, VerticalMode};
use crate::sensors::StreamKey;
use crate::simulator::Options;
use crate::truth::IntakeLimits;

include!(concat!(env!("OUT_DIR"), "/sins_frame.rs"));
include!(concat!(env!("OUT_DIR"), "/sins_scheme.rs"));
include!(concat!(env!("OUT_DIR"), "/sins_vertical.rs"));

/// Whether the error differential equations are integrated.
pub type sins_error_model = i32;

/// No error differential equations: SINS_ERRORS_MODEL is not available.
pub const SINS_ERROR_MODEL_OFF: sins_error_model = 0;
/// The error differential equations (error data 1) by fourth-order Runge-Kutta.
pub const SINS_ERROR_MODEL_RK4: sins_error_model = 1;

/// Whether the library summarizes the true motion.
pub type sins_summary = i32;

/// sins_get_truth_summary() is not available.
pub const SINS_SUMMARY_OFF: sins_summary = 0;
/// sins_get_truth_summary() is available. The other outputs have the same bits as without.
pub const SINS_SUMMARY_ON: sins_summary = 1;

/// Whether the covariance of the navigation errors is propagated.
pub type sins_covariance_mode = i32;

/// sins_get_covariance() is not available.
pub const SINS_COVARIANCE_OFF: sins_covariance_mode = 0;
/// The covariance is propagated along the truth; the other outputs have the same bits.
pub const SINS_COVARIANCE_ON: sins_covariance_mode = 1;

include!(concat!(env!("OUT_DIR"), "/sins_earth.rs"));
include!(concat!(env!("OUT_DIR"), "/sins_gravity.rs"));
include!(concat!(env!("OUT_DIR"), "/sins_axes.rs"));

/// Ideal signals.
pub type sins_signal = i32;

/// Ideal signals are the integrals of the true angular rate and specific force, so the navigation shows the mechanization's
/// own error.
pub const SINS_SIGNAL_PHYSICAL: sins_signal = 0;
/// As SINS_SIGNAL_PHYSICAL, plus a small trim that keeps an error-free navigator at the truth for any time, even with a
/// free vertical channel. It is for hosts that want the errors of the sensors only. sins_accuracy reports the size of the
/// trim. If the initial state, a sensor or gravity has errors, the library also runs a second navigator without errors to
/// compute the trim. A step then takes longer.
pub const SINS_SIGNAL_CLOSED_LOOP: sins_signal = 1;

/// Options of a simulator. All zero (except struct_size) is the recommended simulator.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_options {
    /// sizeof(sins_options)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Axes of the mechanization, of enum sins_frame.
    pub frame: i32,
    /// Algorithm of the mechanization, of enum sins_scheme.
    pub scheme: i32,
    /// Number of subsamples of a mechanization update, 1 to 5; 0: 2. A subsample is one of the equal parts of the update; the
    /// sensors give one increment for each.
    pub subsamples: i32,
    /// Mechanization updates in a sample interval, 1 to 16; 0: 1. In a gap there are more (docs/host_time.md).
    pub updates_per_sample: i32,
    /// Vertical channel, of enum sins_vertical.
    pub vertical: i32,
    /// Error differential equations, of enum sins_error_model.
    pub error_model: i32,
    /// Ellipsoid, of enum sins_earth.
    pub earth: i32,
    /// Normal gravity, of enum sins_gravity.
    pub gravity: i32,
    /// Directions of the body axes and of the sensor axes, of enum sins_axes.
    pub axes: i32,
    /// Ideal signals, of enum sins_signal.
    pub signal: i32,
    /// Seed of all random streams.
    pub seed: u64,
    /// Run number. The same seed with another run number gives other random numbers. Run k of an ensemble has the number k.
    pub run: u64,
    /// Time constant of SINS_SIGNAL_CLOSED_LOOP, 1 to 1e4, at least four times max_gap_s [s]; 0: 30 s, for which max_gap_s
    /// must be at most 7.5 s. Must be 0 with another signal.
    pub closed_loop_time_s: f64,
    /// Stated sample period, 5e-5 to max_gap_s [s]; 0: the samples' own time stamps count. With a stated period, each
    /// sample is at an exact multiple of the period from the first. The time stamps then serve only to order and to check the
    /// samples: each must be within 0.4 of a period of its multiple.
    pub sample_period_s: f64,
    /// Longest interval between samples, 5e-5 to 1000 [s]; 0: 2.5 s. Use intervals of minutes only for a vehicle at rest.
    /// Even at rest the position error grows with the third power of the interval: within 12 h it reaches 0.09 m with
    /// intervals of 10 s, and 91 m with intervals of 100 s.
    pub max_gap_s: f64,
    /// Largest mean acceleration between two samples, 1e-3 to 1e6 [m/s2]; 0: 2000 m/s2. Velocities that need a larger one are
    /// rejected as a jump of the truth; without velocities, displacements that need a larger one and 10 m more.
    pub max_acceleration_m_s2: f64,
    /// Summary of the true motion, of enum sins_summary.
    pub truth_summary: i32,
    /// Covariance of the navigation errors, of enum sins_covariance_mode.
    pub covariance: i32,
}

interface_struct!(sins_options, "options", 104);

impl Parameters for sins_options {
    type Own = Options;

    /// The options as they are in effect, no default left 0.
    fn from_parameters(options: &Options) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            frame: options.frame.code(),
            scheme: options.scheme.code(),
            subsamples: options.subsamples as i32,
            updates_per_sample: options.updates_per_sample as i32,
            vertical: options.vertical.code(),
            error_model: options.error_model.into(),
            earth: options.ellipsoid.code(),
            gravity: options.gravity.code(),
            axes: options.axes.code(),
            signal: options.closed_loop_time_s.is_some().into(),
            seed: options.key.seed,
            run: options.key.run,
            closed_loop_time_s: options.closed_loop_time_s.unwrap_or(0.0),
            sample_period_s: options.intake.period_s.unwrap_or(0.0),
            max_gap_s: options.intake.max_gap_s,
            max_acceleration_m_s2: options.intake.max_acceleration_m_s2,
            truth_summary: options.truth_summary.into(),
            covariance: options.covariance.into(),
        }
    }

    fn to_parameters(self) -> Result<Options, CallError> {
        check_reserved("options.reserved", self.reserved)?;
        let defaults = Options::default();
        let or = |value: f64, default: f64| if value == 0.0 { default } else { value };
        let count = |value: i32, default: usize| if value == 0 { default } else { value as usize };
        // The fields are checked in this order.
        Ok(Options {
            covariance: switch("options.covariance", self.covariance, "sins_covariance_mode")?,
            truth_summary: switch("options.truth_summary", self.truth_summary, "sins_summary")?,
            frame: Frame::of("options.frame", self.frame)?,
            scheme: Scheme::of("options.scheme", self.scheme)?,
            vertical: VerticalMode::of("options.vertical", self.vertical)?,
            error_model: switch("options.error_model", self.error_model, "sins_error_model")?,
            gravity: GravityModel::of("options.gravity", self.gravity)?,
            axes: BodyAxes::of("options.axes", self.axes)?,
            closed_loop_time_s: match switch("options.signal", self.signal, "sins_signal")? {
                true => Some(or(self.closed_loop_time_s, Options::DEFAULT_CLOSED_LOOP_TIME_S)),
                false if self.closed_loop_time_s == 0.0 => None,
                false => {
                    let rule = Rule::Zero(" without SINS_SIGNAL_CLOSED_LOOP");
                    let time_s = self.closed_loop_time_s;
                    return Err(Error::invalid("options.closed_loop_time_s", time_s, rule).into());
                }
            },
            subsamples: {
                check_integer("options.subsamples", self.subsamples, 0, 5)?;
                count(self.subsamples, defaults.subsamples)
            },
            updates_per_sample: {
                check_integer("options.updates_per_sample", self.updates_per_sample, 0, 16)?;
                count(self.updates_per_sample, defaults.updates_per_sample)
            },
            ellipsoid: Ellipsoid::of("options.earth", self.earth)?,
            key: StreamKey { seed: self.seed, run: self.run },
            intake: IntakeLimits {
                max_gap_s: or(self.max_gap_s, defaults.intake.max_gap_s),
                max_acceleration_m_s2: or(self.max_acceleration_m_s2, defaults.intake.max_acceleration_m_s2),
                period_s: (self.sample_period_s != 0.0).then_some(self.sample_period_s),
            },
        })
    }
}
