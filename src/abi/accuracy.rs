//! `sins_accuracy`.

use super::answer::write_or_need;
use super::failure::sins_status;
use super::memory::{Output, interface_struct};
use super::simulator::{sins_sim, with_simulator};
use crate::errors::AccuracyFigures;
use crate::simulator::{ClosureFigures, TrimFigures};

/// Running figures of the flight since its start or last reposition; sins_move_time() and sins_move_truth() do not restart
/// them. The figures use the errors once a second. They describe one run, not an ensemble. To get nautical miles per hour,
/// divide a rate by SINS_NMI_PER_HOUR.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_accuracy {
    /// sizeof(sins_accuracy)
    pub struct_size: u32,
    /// 1: duration_s is at least a Schuler period, 5064 s (84.4 min), and the window has errors. 0: the errors still swing back, so the
    /// rates RER, R50 and R95 depend on the moment, and a display leaves them out. The time in which a unit aligns counts, and so do
    /// errors that sins_correct() removed: then the rates are not figures of the INS alone.
    pub has_rates: u32,
    /// Time [s].
    pub time_s: f64,
    /// Time since the start [s].
    pub duration_s: f64,
    /// Start of the window of the radial error rates, as time since the start: 300 [s]. Earlier rates would be initial errors
    /// divided by a very short time.
    pub window_start_s: f64,
    /// Number of errors (one a second) in the window of the radial error rates. While it is 0, the rates are 0.
    pub window_samples: u64,
    /// Root mean square of the radial error rate, sqrt(mean RER^2), with RER = horizontal position error / time since the
    /// start [m/s].
    pub radial_error_rate_rms_m_s: f64,
    /// R50 = 0.8326 sqrt(mean RER^2): CEP rate for a circular normal distribution [m/s].
    pub cep_rate_m_s: f64,
    /// R95 = 1.7308 sqrt(mean RER^2): 95 % for a circular normal distribution [m/s].
    pub radial_95_rate_m_s: f64,
    /// Slope of the least-squares line (with an intercept) through the horizontal position errors of the window [m/s].
    pub radial_error_slope_m_s: f64,
    /// Root mean square velocity error since the start, east-north-up; samples within 20 km of the Earth's axis, where east
    /// and north turn fast, are left out [m/s].
    pub velocity_rms_enu_m_s: [f64; 3],
    /// Position closure: the position error now, navigation minus truth [m].
    pub closure_position_enu_m: [f64; 3],
    /// Velocity closure: the velocity error now, navigation minus truth [m/s].
    pub closure_velocity_enu_m_s: [f64; 3],
    /// Part of the horizontal position error that the host causes, because its velocities contradict its positions [m]. Let d
    /// be the displacement from the velocities less the displacement from the positions. The field is the response of a
    /// Schuler oscillator to d; up is 0. The rest of the position error is caused by the simulator and the sensors.
    pub host_position_enu_m: [f64; 3],
    /// Part of the horizontal velocity error that the host causes in this way; up is 0 [m/s].
    pub host_velocity_enu_m_s: [f64; 3],
    /// Displacement from the host's velocities less displacement from its positions, summed over the flight [m].
    pub inconsistency_enu_m: [f64; 3],
    /// Largest difference, in one interval, between the displacement from the host's velocities and the displacement from its
    /// positions [m].
    pub inconsistency_max_m: f64,
    /// Number of samples flagged SINS_NAVIGATION_INCONSISTENT.
    pub inconsistent_samples: u64,
    /// Number of intervals flown since the start or the last reposition.
    pub intervals: u64,
    /// Largest trim that SINS_SIGNAL_CLOSED_LOOP added to the angular rate, later than ten times closed_loop_time_s after the
    /// start [rad/s]. It shows the error of the signal generator and the mechanization themselves. 0 with physical signals.
    pub trim_rate_max_rad_s: f64,
    /// Largest trim that SINS_SIGNAL_CLOSED_LOOP added to the specific force, likewise [m/s2].
    pub trim_force_max_m_s2: f64,
}

interface_struct!(sins_accuracy, "accuracy", 256);

impl sins_accuracy {
    fn new(
        time_s: f64,
        figures: &AccuracyFigures,
        closure: &ClosureFigures,
        intervals: u64,
        trim: &TrimFigures,
    ) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            has_rates: figures.has_rates().into(),
            time_s,
            duration_s: figures.duration_s,
            window_start_s: figures.window_start_s,
            window_samples: figures.window_samples,
            radial_error_rate_rms_m_s: figures.radial_error_rate_rms_m_s,
            cep_rate_m_s: figures.cep_rate_m_s(),
            radial_95_rate_m_s: figures.radial_95_rate_m_s(),
            radial_error_slope_m_s: figures.radial_error_slope_m_s,
            velocity_rms_enu_m_s: figures.velocity_rms_n.into(),
            closure_position_enu_m: closure.position_n.into(),
            closure_velocity_enu_m_s: closure.velocity_n.into(),
            host_position_enu_m: closure.host_position_n.into(),
            host_velocity_enu_m_s: closure.host_velocity_n.into(),
            inconsistency_enu_m: closure.inconsistency_n.into(),
            inconsistency_max_m: closure.inconsistency_max_m,
            inconsistent_samples: closure.inconsistent_samples,
            intervals,
            trim_rate_max_rad_s: trim.rate_rad_s,
            trim_force_max_m_s2: trim.force_m_s2,
        }
    }
}

/// Reads the running accuracy figures.
///
/// SINS_NEED_SAMPLE: no sample yet.
/// SINS_ERROR_BAD_STATE: navigating on increments, without a truth.
/// SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_accuracy(
    sim: *mut sins_sim,
    accuracy: *mut sins_accuracy,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(accuracy, "accuracy")? };
        let figures = simulator.accuracy()?;
        let intervals = simulator.intervals();
        let trim = simulator.trim()?.unwrap_or_default();
        let figures = figures.map(|(time_s, figures, closure)| {
            sins_accuracy::new(time_s, &figures, &closure, intervals, &trim)
        });
        Ok(write_or_need(&output, figures))
    })
}
