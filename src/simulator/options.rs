//! Options with which a simulator is made.

use super::{ErrorSource, singular};
use crate::base::error::{Error, Rule, check_within};
use crate::base::math::sin_cos;
use crate::base::snapshot::{ANY, stored};
use crate::earth::state::BodyAxes;
use crate::earth::{Earth, Ellipsoid, GravityModel};
use crate::mechanization::{Frame, MAX_SUBSAMPLES, Mechanization, Scheme, VerticalMode};
use crate::sensors::StreamKey;
use crate::signal::MAX_INCREMENTS;
use crate::truth::{IntakeLimits, MAX_GAP_S, MIN_INTERVAL_S, TruthPoint};

/// Largest number of mechanization updates in a sample interval.
pub const MAX_UPDATES: usize = MAX_INCREMENTS / MAX_SUBSAMPLES;

/// Makes the options: of each its type and its default, and of a number its limit in a snapshot, in the order of the snapshot.
macro_rules! options {
    ($($(#[$doc:meta])* $option:ident: $type:ty = $default:expr $(, within $limit:expr)?;)*) => {
        /// Options of a simulator; the default is the recommended one.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct Options {
            $($(#[$doc])* pub $option: $type,)*
        }

        stored!(Options { $($option $(: $limit)?),* });

        impl Default for Options {
            fn default() -> Self {
                Self { $($option: $default),* }
            }
        }
    };
}

options! {
    /// Axes in which the mechanization navigates.
    frame: Frame = Frame::default();
    /// Algorithm of the mechanization.
    scheme: Scheme = Scheme::default();
    /// Number of sub-increments of an update, 1 to 5.
    subsamples: usize = 2, within 1e3;
    /// Number of mechanization updates in a sample interval, 1 to 16; more in a gap.
    updates_per_sample: usize = 1, within 1e3;
    /// Mode of the vertical channel.
    vertical: VerticalMode = VerticalMode::default();
    /// Whether the error differential equations are solved too.
    error_model: bool = false;
    /// The ellipsoid.
    ellipsoid: Ellipsoid = Ellipsoid::default();
    /// The gravity field.
    gravity: GravityModel = GravityModel::default();
    /// Directions of the sensor axes.
    axes: BodyAxes = BodyAxes::default();
    /// Time constant of the closed loop [s], 1 to 1e4, at least four times the longest gap; `None`: physical signals.
    closed_loop_time_s: Option<f64> = None, within ANY;
    /// Seed and run number of all random streams.
    key: StreamKey = StreamKey::default();
    /// Limits and time base of the samples.
    intake: IntakeLimits = IntakeLimits::default();
    /// Whether the motion of the truth is summed up.
    truth_summary: bool = false;
    /// Whether the covariance of the navigation errors is propagated along the truth.
    covariance: bool = false;
}

impl Options {
    /// Time constant of the closed loop where none is given [s].
    pub const DEFAULT_CLOSED_LOOP_TIME_S: f64 = 30.0;

    // Ranges of the fields.
    pub(crate) const SUBSAMPLES: (f64, f64) = (1.0, MAX_SUBSAMPLES as f64);
    pub(crate) const UPDATES: (f64, f64) = (1.0, MAX_UPDATES as f64);
    pub(crate) const CLOSED_LOOP_TIMES_S: (f64, f64) = (1.0, 1e4);
    pub(crate) const INTERVALS_S: (f64, f64) = (MIN_INTERVAL_S, MAX_GAP_S);
    pub(crate) const ACCELERATIONS_M_S2: (f64, f64) = (1e-3, 1e6);

    /// Options of a run of an ensemble, without the options that concern only the truth.
    pub(crate) fn of_run(&self) -> Self {
        Self { truth_summary: false, covariance: false, ..*self }
    }

    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        check_within("options.subsamples", self.subsamples as f64, Self::SUBSAMPLES)?;
        check_within("options.updates_per_sample", self.updates_per_sample as f64, Self::UPDATES)?;
        if let Some(period) = self.intake.period_s {
            check_within("options.sample_period_s", period, Self::INTERVALS_S)?;
            if period > self.intake.max_gap_s {
                let rule = Rule::AtMost("must be at most options.max_gap_s =", self.intake.max_gap_s.into());
                return Err(Error::invalid("options.sample_period_s", period, rule));
            }
        }
        check_within("options.max_gap_s", self.intake.max_gap_s, Self::INTERVALS_S)?;
        if let Some(time_constant) = self.closed_loop_time_s {
            check_within("options.closed_loop_time_s", time_constant, Self::CLOSED_LOOP_TIMES_S)?;
            if time_constant < 4.0 * self.intake.max_gap_s {
                let rule = Rule::AtLeast(
                    "must be at least four times options.max_gap_s:",
                    (4.0 * self.intake.max_gap_s).into(),
                );
                return Err(Error::invalid("options.closed_loop_time_s", time_constant, rule));
            }
        }
        let acceleration_m_s2 = self.intake.max_acceleration_m_s2;
        check_within("options.max_acceleration_m_s2", acceleration_m_s2, Self::ACCELERATIONS_M_S2)
    }

    /// Rejects a source of errors that is off.
    pub(super) fn check_source(&self, source: ErrorSource) -> Result<(), Error> {
        if source == ErrorSource::Model && !self.error_model {
            return Err(Error::bad_state(
                "the error model is off, as it is by default: create the simulator with options.error_model",
            ));
        }
        Ok(())
    }

    /// Whether the mechanization can follow the truth to `next`.
    pub(crate) fn check_truth(&self, next: &TruthPoint) -> Result<(), Error> {
        if self.frame == Frame::Geographic {
            let cos = sin_cos(next.place().latitude_rad).1;
            if cos < Mechanization::MIN_COS_LATITUDE {
                return Err(singular(
                    "cosine of sample.latitude_rad",
                    cos,
                    "the geographic frame needs at least",
                    Mechanization::MIN_COS_LATITUDE,
                ));
            }
        }
        Ok(())
    }

    /// The Earth of the run.
    pub fn earth(&self) -> Earth {
        Earth::new(self.ellipsoid, self.gravity)
    }
}
