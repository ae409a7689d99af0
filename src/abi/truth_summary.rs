//! `sins_truth_summary`.

use super::answer::write_or_need;
use super::failure::sins_status;
use super::memory::{Output, interface_struct};
use super::simulator::{sins_sim, with_simulator};
use crate::truth::TruthSummary;

/// Extreme values of the true motion over all intervals since the create or the last sins_reset(). Wrong units and exchanged
/// axes give values that no vehicle has, so these figures reveal them. Attitudes in degrees turn 57 times too fast, and give
/// arbitrary sideslips. Exchanged east and north give a sideslip, and velocities that contradict the positions. Knots instead
/// of m/s contradict the positions too. Feet instead of metres give heights and climbs 3.3 times too large. Accelerations are
/// means from one sample to the next. So are rates and forces, unless the samples carry them; then they are the values at the
/// samples. Each ..._at_s is the time stamp of the sample at which the value was found. A judge (sins_judge_create() in sins_flight.h)
/// draws the conclusions.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_truth_summary {
    /// sizeof(sins_truth_summary)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Number of intervals flown.
    pub intervals: u64,
    /// Number of intervals that are gaps (see SINS_GAP).
    pub gaps: u64,
    /// Number of samples with a speed of more than 30 m/s. Sideslip and angle of attack are taken from these only.
    pub fast_samples: u64,
    /// Sum of the lengths of the intervals [s].
    pub flown_s: f64,
    /// Time stamp of the first sample [s].
    pub first_s: f64,
    /// Time stamp of the last sample [s].
    pub last_s: f64,
    /// Longest interval [s].
    pub interval_max_s: f64,
    /// Time stamp of interval_max_s [s].
    pub interval_max_at_s: f64,
    /// Largest rotation in an interval [rad].
    pub turn_max_rad: f64,
    /// Time stamp of turn_max_rad [s].
    pub turn_max_at_s: f64,
    /// Largest angular rate: from the attitudes against the Earth, or the samples' own rate [rad/s].
    pub rate_max_rad_s: f64,
    /// Time stamp of rate_max_rad_s [s].
    pub rate_max_at_s: f64,
    /// Largest acceleration against the Earth, from the velocities [m/s2].
    pub acceleration_max_m_s2: f64,
    /// Time stamp of acceleration_max_m_s2 [s].
    pub acceleration_max_at_s: f64,
    /// Largest specific force: from the velocities and gravity, or the samples' own force [m/s2].
    pub force_max_m_s2: f64,
    /// Time stamp of force_max_m_s2 [s].
    pub force_max_at_s: f64,
    /// Largest difference, in one interval, between the displacement from the positions and the displacement from the
    /// velocities (the mean of the velocities at the two ends, times the length of the interval) [m].
    pub inconsistency_max_m: f64,
    /// Time stamp of inconsistency_max_m [s].
    pub inconsistency_max_at_s: f64,
    /// Largest speed against the Earth [m/s].
    pub speed_max_m_s: f64,
    /// Time stamp of speed_max_m_s [s].
    pub speed_max_at_s: f64,
    /// Sideslip of the largest size, from the plane of symmetry to the velocity against the Earth, positive to the right;
    /// includes wind [rad].
    pub sideslip_max_rad: f64,
    /// Time stamp of sideslip_max_rad [s].
    pub sideslip_max_at_s: f64,
    /// Angle of attack of the largest size, from the velocity against the Earth up to the forward axis, in the plane of
    /// symmetry [rad].
    pub attack_max_rad: f64,
    /// Time stamp of attack_max_rad [s].
    pub attack_max_at_s: f64,
    /// Lowest height [m].
    pub height_min_m: f64,
    /// Time stamp of height_min_m [s].
    pub height_min_at_s: f64,
    /// Highest height [m].
    pub height_max_m: f64,
    /// Time stamp of height_max_m [s].
    pub height_max_at_s: f64,
}

interface_struct!(sins_truth_summary, "summary", 232);

impl sins_truth_summary {
    fn new(summary: &TruthSummary) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            intervals: summary.intervals,
            gaps: summary.gaps,
            fast_samples: summary.fast_samples,
            flown_s: summary.flown_s,
            first_s: summary.first_s,
            last_s: summary.last_s,
            interval_max_s: summary.interval_max.value,
            interval_max_at_s: summary.interval_max.time_s,
            turn_max_rad: summary.turn_max.value,
            turn_max_at_s: summary.turn_max.time_s,
            rate_max_rad_s: summary.rate_max.value,
            rate_max_at_s: summary.rate_max.time_s,
            acceleration_max_m_s2: summary.acceleration_max.value,
            acceleration_max_at_s: summary.acceleration_max.time_s,
            force_max_m_s2: summary.force_max.value,
            force_max_at_s: summary.force_max.time_s,
            inconsistency_max_m: summary.inconsistency_max.value,
            inconsistency_max_at_s: summary.inconsistency_max.time_s,
            speed_max_m_s: summary.speed_max.value,
            speed_max_at_s: summary.speed_max.time_s,
            sideslip_max_rad: summary.sideslip_max.value,
            sideslip_max_at_s: summary.sideslip_max.time_s,
            attack_max_rad: summary.attack_max.value,
            attack_max_at_s: summary.attack_max.time_s,
            height_min_m: summary.height_min.value,
            height_min_at_s: summary.height_min.time_s,
            height_max_m: summary.height_max.value,
            height_max_at_s: summary.height_max.time_s,
        }
    }
}

/// Reads the extreme values of the true motion. sins_reposition() and sins_move_truth() do not restart them.
///
/// SINS_NEED_SAMPLE: no interval yet.
/// SINS_ERROR_BAD_STATE: sins_options.truth_summary is off, or navigating on increments, without a truth.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_truth_summary(
    sim: *mut sins_sim,
    summary: *mut sins_truth_summary,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(summary, "summary")? };
        let summary = simulator.truth_summary()?;
        Ok(write_or_need(&output, summary.as_ref().map(sins_truth_summary::new)))
    })
}
