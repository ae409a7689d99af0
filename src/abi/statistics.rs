//! `sins_statistics` and what they say. The struct itself is `src/ensemble/statistics/layout.rs`.

use super::boundary::enter_without_simulator;
use super::choice::{Choice, choices};
use super::ensemble::{sins_ensemble, with_ensemble};
use super::errors::sins_errors;
use super::failure::{SINS_NEED_SAMPLE, sins_status};
use super::memory::{Output, interface_struct, read, read_into};
use crate::ensemble::statistics::{Decision, Figures, Statistics, Verdict};
use crate::simulator::ErrorSource;

pub use crate::ensemble::statistics::Statistics as sins_statistics;

interface_struct!(sins_statistics, "statistics", 14920);

/// Figures that are computed from a sins_statistics. If there is no run, all figures are 0. If there is one run, its
/// covariance is 0.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_figures {
    /// sizeof(sins_figures)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Number of runs, including those that are left out of the other figures.
    pub runs: u64,
    /// Number of runs that have diverged. They are left out.
    pub diverged: u64,
    /// Number of runs with an error outside its range. They are left out.
    pub out_of_range: u64,
    /// Number of runs whose error model is flagged SINS_ERRORS_OUTSIDE_VALIDITY. They are not left out.
    pub outside_validity: u64,
    /// Mean position error [m].
    pub mean_position_enu_m: [f64; 3],
    /// Mean velocity error [m/s].
    pub mean_velocity_enu_m_s: [f64; 3],
    /// Mean misalignment [rad].
    pub mean_misalignment_enu_rad: [f64; 3],
    /// Standard deviation of the position error, with the divisor n - 1 [m].
    pub sigma_position_enu_m: [f64; 3],
    /// Standard deviation of the velocity error [m/s].
    pub sigma_velocity_enu_m_s: [f64; 3],
    /// Standard deviation of the misalignment [rad].
    pub sigma_misalignment_enu_rad: [f64; 3],
    /// Root mean square of the position error [m].
    pub rms_position_enu_m: [f64; 3],
    /// Root mean square of the velocity error [m/s].
    pub rms_velocity_enu_m_s: [f64; 3],
    /// Root mean square of the misalignment [rad].
    pub rms_misalignment_enu_rad: [f64; 3],
    /// Covariance of the nine states of sins_statistics, with the divisor n - 1, row by row: element 9 i + j is the
    /// covariance of the states i and j, in m, m/s and rad.
    pub covariance: [f64; 81],
    /// Root mean square of the horizontal radial position error [m].
    pub rms_radial_m: f64,
    /// Horizontal radius that contains the positions of half of the runs [m]. It is read from the histogram, to 0.5 % of its
    /// value, or to 0.5 mm if it is below 1 mm.
    pub cep50_m: f64,
    /// Horizontal radius that contains the positions of 95 % of the runs [m]. It is read from the histogram as cep50_m is.
    pub r95_m: f64,
    /// Largest horizontal radial position error [m].
    pub largest_radial_m: f64,
}

interface_struct!(sins_figures, "figures", 936);

impl From<&Figures> for sins_figures {
    fn from(figures: &Figures) -> Self {
        let three = |of: &dyn Fn(usize) -> f64, first: usize| core::array::from_fn(|k| of(first + k));
        let mean = |state: usize| figures.mean[state];
        let sigma = |state: usize| figures.covariance[(state, state)].sqrt();
        let rms = |state: usize| figures.rms[state];
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            runs: figures.runs,
            diverged: figures.diverged,
            out_of_range: figures.out_of_range,
            outside_validity: figures.outside_validity,
            mean_position_enu_m: three(&mean, 0),
            mean_velocity_enu_m_s: three(&mean, 3),
            mean_misalignment_enu_rad: three(&mean, 6),
            sigma_position_enu_m: three(&sigma, 0),
            sigma_velocity_enu_m_s: three(&sigma, 3),
            sigma_misalignment_enu_rad: three(&sigma, 6),
            rms_position_enu_m: three(&rms, 0),
            rms_velocity_enu_m_s: three(&rms, 3),
            rms_misalignment_enu_rad: three(&rms, 6),
            covariance: core::array::from_fn(|k| figures.covariance[(k / 9, k % 9)]),
            rms_radial_m: figures.radial_rms_m,
            cep50_m: figures.cep50_m,
            r95_m: figures.r95_m,
            largest_radial_m: figures.largest_radial_m,
        }
    }
}

/// Reads the statistics of the errors of all runs at this moment; source is of enum sins_errors_source. sins_statistics_merge() adds
/// those of other runs at the same moment. Within 20 km of the Earth's axis (SINS_NAVIGATION_NEAR_POLE of the truth) the up
/// misalignment and the east and north components of the velocity error have no meaning. No allocation, no system call.
///
/// SINS_NEED_SAMPLE: no sample yet. SINS_ERROR_INVALID_ARGUMENT: no such source. SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL while
/// the error model is off. SINS_ERROR_SINGULAR: before the first step, no run can start at the first sample.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_ensemble_get_statistics(
    ensemble: *mut sins_ensemble,
    source: i32,
    statistics: *mut sins_statistics,
) -> sins_status {
    with_ensemble(ensemble, |ensemble| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(statistics, "statistics")? };
        let source = ErrorSource::of("source", source)?;
        if ensemble.truth().is_none() {
            return Ok(SINS_NEED_SAMPLE);
        }
        let mut found = Statistics::EMPTY;
        ensemble.add_to(&mut found, source)?;
        Ok(output.write(&found))
    })
}

/// Adds one run, whose errors are `errors`, to `statistics`: for runs that simulators fly one by one. sins_statistics without runs is zero
/// except for struct_size. With the flag SINS_ERRORS_NOT_COMPUTED the run counts as diverged. The errors may be any numbers: a run whose
/// errors are out of the range of the sums is counted in out_of_range. No allocation, no system call.
///
/// SINS_ERROR_INVALID_ARGUMENT: the statistics are damaged or of another release, or have 4294967295 runs. They are then unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_statistics_add(
    statistics: *mut sins_statistics,
    errors: *const sins_errors,
) -> sins_status {
    enter_without_simulator(|| {
        let mut sum = Statistics::EMPTY;
        // SAFETY: the host's promise.
        let (output, errors) = unsafe { (Output::new(statistics, "statistics")?, read(errors, "errors")?) };
        // SAFETY: the host's promise.
        unsafe { read_into(statistics.cast_const(), "statistics", &mut sum)? };
        sum.check()?;
        match errors.of_run() {
            Some(errors) => sum.add(&errors)?,
            None => sum.add_diverged()?,
        }
        Ok(output.write(&sum))
    })
}

/// Adds the runs of `other` to those of `into`. The caller makes sure that no run is in both. The sums are exact: any order
/// and any grouping of merges gives the same bits, so the work can be split over threads, processes, machines and restarts in
/// any way. If `into` is zero except for struct_size, it holds no runs.
///
/// SINS_ERROR_INVALID_ARGUMENT: one of the two is damaged or of another release, or the sum would have more than 4294967295
/// runs. into is then unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_statistics_merge(
    into: *mut sins_statistics,
    other: *const sins_statistics,
) -> sins_status {
    enter_without_simulator(|| {
        let (mut sum, mut more) = (Statistics::EMPTY, Statistics::EMPTY);
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(into, "into")? };
        // SAFETY: the host's promise.
        unsafe {
            read_into(into.cast_const(), "into", &mut sum)?;
            read_into(other, "other", &mut more)?;
        }
        sum.merge(&more)?;
        Ok(output.write(&sum))
    })
}

/// Computes means, covariances, root mean squares and radii from statistics.
///
/// SINS_ERROR_INVALID_ARGUMENT: they are damaged or of another release.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_statistics_figures(
    statistics: *const sins_statistics,
    figures: *mut sins_figures,
) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(figures, "figures")? };
        let mut read = Statistics::EMPTY;
        // SAFETY: the host's promise.
        unsafe { read_into(statistics, "statistics", &mut read)? };
        Ok(output.write(&sins_figures::from(&read.figures()?)))
    })
}

include!(concat!(env!("OUT_DIR"), "/sins_decision.rs"));

/// Whether the runs of a sins_statistics meet a requirement. The numbers of runs are exact, so they and the decision do not depend
/// on how the runs were split.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_verdict {
    /// sizeof(sins_verdict)
    pub struct_size: u32,
    /// One of enum sins_decision.
    pub decision: i32,
    /// Number of all runs. Runs that diverged or are out of range are outside the limit.
    pub runs: u64,
    /// Number of runs that are within the limit.
    pub inside: u64,
    /// Number of further runs of which the histogram does not show whether they are within the limit: those in the bucket that
    /// contains the limit, less than 1 % from it. The decision holds wherever they are.
    pub near_limit: u64,
    /// Number of further runs that would decide if the fraction of runs within the limit stayed as it is. 0: it is decided.
    /// UINT64_MAX: without a run, or if the fraction is the required one.
    pub more_runs: u64,
    /// Lower end of the interval that contains the true fraction of runs within the limit with 95 % confidence (Wilson's score
    /// interval) [1].
    pub fraction_low: f64,
    /// Upper end of this interval [1].
    pub fraction_high: f64,
}

interface_struct!(sins_verdict, "verdict", 56);

impl From<&Verdict> for sins_verdict {
    fn from(verdict: &Verdict) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            decision: verdict.decision.code(),
            runs: verdict.runs,
            inside: verdict.inside,
            near_limit: verdict.near_limit,
            more_runs: verdict.more_runs.unwrap_or(u64::MAX),
            fraction_low: verdict.low,
            fraction_high: verdict.high,
        }
    }
}

/// Decides whether `percent` of the runs have a horizontal radial position error of at most `radius_m`. The requirement 0.8 nmi/h
/// CEP after 2 hours is: 50 %, 2 * 0.8 * SINS_NMI. 0 < percent < 100; 0 < radius_m <= 33554432.
///
/// SINS_ERROR_INVALID_ARGUMENT: a number is out of its range, or the statistics are damaged or of another release.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_meets(
    statistics: *const sins_statistics,
    radius_m: f64,
    percent: f64,
    verdict: *mut sins_verdict,
) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(verdict, "verdict")? };
        let mut read = Statistics::EMPTY;
        // SAFETY: the host's promise.
        unsafe { read_into(statistics, "statistics", &mut read)? };
        Ok(output.write(&sins_verdict::from(&read.meets(radius_m, percent)?)))
    })
}
