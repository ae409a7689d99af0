//! `sins_budget_row` and `sins_budget`: what a budget answers.

use core::ffi::c_char;

use super::choice::flag;
use super::memory::interface_struct;
use super::text::chars;
use crate::analysis::budget::{Budget, BudgetRequest, BudgetRow, Costs};
use crate::analysis::recommend::SolutionError;

/// Flags of a sins_budget_row.
pub type sins_budget_flags = u32;

/// The figures of the row are standard deviations (1 sigma), from linear error equations.
pub const SINS_BUDGET_RANDOM: sins_budget_flags = 1;
/// The effect can be left out, together with all others that have this flag.
pub const SINS_BUDGET_CAN_BE_LEFT_OUT: sins_budget_flags = 2;

/// An effect and its contribution to the errors. The first row of a budget has the errors of the mechanization and of the
/// samples, with no effect set.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_budget_row {
    /// sizeof(sins_budget_row)
    pub struct_size: u32,
    /// Flags of enum sins_budget_flags, or'ed.
    pub flags: u32,
    /// Name of the effect, such as "gyro turn-on bias", terminated; in the first row "mechanization".
    pub effect: [c_char; 32],
    /// The field that sets the effect, such as "gyro.bias_sigma_rad_s", terminated; a value of 0 there leaves the effect
    /// out. Empty in the first row.
    pub field: [c_char; 48],
    /// Length of the contribution to the position error, the largest at up to 1000 instants of the flight [m].
    pub position_m: f64,
    /// Length of the contribution to the velocity error, the largest at these instants [m/s].
    pub velocity_m_s: f64,
    /// Length of the contribution to the misalignment, the largest at these instants [rad].
    pub attitude_rad: f64,
    /// Length of the contribution to the position error at the end of the flight [m].
    pub end_position_m: f64,
    /// Length of the contribution to the velocity error at the end of the flight [m/s].
    pub end_velocity_m_s: f64,
    /// Length of the contribution to the misalignment at the end of the flight [rad].
    pub end_attitude_rad: f64,
    /// The contribution divided by its limit, the largest of the three; 0 without limits.
    pub share: f64,
    /// Time of a step with all effects, less that of a step without this one; in the first row, time of a step with no effect
    /// set. Measured in this call on this machine if time_steps is 1, else 0 [ns]. Uncertain by 1 to 5 % of a step, more on a busy machine,
    /// so it may be negative.
    pub ns_per_step: f64,
}

interface_struct!(sins_budget_row, "rows", 152);

/// Figures of a budget as a whole.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_budget {
    /// sizeof(sins_budget)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Time from the first sample to the end of the last interval [s].
    pub duration_s: f64,
    /// Number of runs with all effects together; 1 if nothing is random.
    pub runs: u64,
    /// Number of flights that the call made.
    pub flights: u64,
    /// Lower end of the 95 % confidence interval of the root mean square of the random errors, divided by the root mean
    /// square over the flown runs. The fewer the runs, the wider the interval. 1 if nothing is random.
    pub sigma_low: f64,
    /// Upper end of that interval, divided likewise; 1 if nothing is random.
    pub sigma_high: f64,
    /// Position error with all effects together, root mean square over the runs, the largest in the flight [m].
    pub position_m: f64,
    /// Velocity error with all effects together, likewise [m/s].
    pub velocity_m_s: f64,
    /// Misalignment with all effects together, likewise [rad].
    pub attitude_rad: f64,
    /// Part of the position error that the sum of all rows does not explain [m].
    pub remainder_position_m: f64,
    /// Part of the velocity error that the sum of all rows does not explain [m/s].
    pub remainder_velocity_m_s: f64,
    /// Part of the misalignment that the sum of all rows does not explain [rad].
    pub remainder_attitude_rad: f64,
    /// Change of the position error if the marked effects (SINS_BUDGET_CAN_BE_LEFT_OUT) are left out, from flights of all runs
    /// without them [m].
    pub left_out_position_m: f64,
    /// Change of the velocity error if the marked effects are left out, likewise [m/s].
    pub left_out_velocity_m_s: f64,
    /// Change of the misalignment if the marked effects are left out, likewise [rad].
    pub left_out_attitude_rad: f64,
    /// Time of a step with all effects, measured in this call on this machine if time_steps is 1, else 0 [ns].
    pub ns_per_step: f64,
}

interface_struct!(sins_budget, "budget", 128);

impl sins_budget_row {
    pub(super) fn new(row: &BudgetRow, ns_per_step: f64) -> Self {
        Self {
            flags: flag(row.effect.is_random, SINS_BUDGET_RANDOM)
                | flag(row.can_be_left_out, SINS_BUDGET_CAN_BE_LEFT_OUT),
            effect: chars(row.effect.name),
            field: chars(row.effect.field),
            share: row.share,
            ns_per_step,
            ..Self::of(&row.worst, &row.end)
        }
    }

    /// The first row.
    pub(super) fn own(budget: &Budget, request: &BudgetRequest, costs: &Costs) -> Self {
        let (worst, end) = &budget.own;
        Self {
            effect: chars("mechanization"),
            share: request.share(worst),
            ns_per_step: costs.own_ns,
            ..Self::of(worst, end)
        }
    }

    /// The errors alone.
    fn of(worst: &SolutionError, end: &SolutionError) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            flags: 0,
            effect: chars(""),
            field: chars(""),
            position_m: worst.position_m,
            velocity_m_s: worst.velocity_m_s,
            attitude_rad: worst.attitude_rad,
            end_position_m: end.position_m,
            end_velocity_m_s: end.velocity_m_s,
            end_attitude_rad: end.attitude_rad,
            share: 0.0,
            ns_per_step: 0.0,
        }
    }
}

impl sins_budget {
    pub(super) fn new(budget: &Budget, costs: &Costs) -> Self {
        let Budget { total, remainder, left_out, .. } = budget;
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            duration_s: budget.span_s,
            runs: budget.runs,
            flights: budget.flights,
            sigma_low: budget.interval.low,
            sigma_high: budget.interval.high,
            position_m: total.position_m,
            velocity_m_s: total.velocity_m_s,
            attitude_rad: total.attitude_rad,
            remainder_position_m: remainder.position_m,
            remainder_velocity_m_s: remainder.velocity_m_s,
            remainder_attitude_rad: remainder.attitude_rad,
            left_out_position_m: left_out.position_m,
            left_out_velocity_m_s: left_out.velocity_m_s,
            left_out_attitude_rad: left_out.attitude_rad,
            ns_per_step: costs.total_ns,
        }
    }
}
