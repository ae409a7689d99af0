//! Data that the page and the terminal show.

use super::plan::{Data, Plan};
use super::results::{Results, State};
use super::table::Row;
use crate::given::Given;

/// One of the three errors of a [`State`].
pub struct Quantity {
    pub name: &'static str,
    pub family: &'static crate::units::Family,
    /// Place of its east component.
    pub first: usize,
    /// Whether its up axis is the vertical channel.
    pub is_motion: bool,
}

pub const QUANTITIES: [Quantity; 3] = [
    Quantity { name: "position", family: crate::units::LENGTH, first: 0, is_motion: true },
    Quantity { name: "velocity", family: crate::units::SPEED, first: 3, is_motion: true },
    Quantity { name: "misalignment", family: crate::units::ANGLE, first: 6, is_motion: false },
];

/// An ensemble that was flown.
pub struct Study<'a> {
    pub given: &'a Given,
    pub name: &'a str,
    pub plan: &'a Plan,
    pub results: &'a Results,
    pub rows: Vec<Row>,
}

impl<'a> Study<'a> {
    /// The rows of one of the error data, one for each instant; empty if these data are off.
    pub fn of(&self, source: Data) -> Vec<&Row> {
        self.rows.iter().filter(|row| row.source == source).collect()
    }

    /// The last row of one of the error data.
    pub fn end(&self, source: Data) -> Option<&Row> {
        self.rows.iter().rfind(|row| row.source == source)
    }

    /// The errors at the end of the runs that did not diverge.
    pub fn ends(&self) -> impl Iterator<Item = &'a State> + use<'a> {
        self.results.ends.iter().flatten()
    }

    /// Number of axes of a quantity that are shown, east first: without up if the height follows the truth.
    pub fn axes(&self, quantity: &Quantity) -> usize {
        let follows = self.given.scene.options.vertical == sins::mechanization::VerticalMode::FollowTruth;
        if quantity.is_motion && follows { 2 } else { 3 }
    }

    /// In how many runs gyros and accelerometers were beyond their range, in sentences.
    pub fn beyond_range(&self) -> impl Iterator<Item = String> {
        let runs = self.plan.runs;
        let counts = ["Gyros", "Accelerometers"].into_iter().zip(self.results.beyond_range);
        counts.filter(|(_, count)| *count > 0).map(move |(what, count)| {
            format!("{what} were beyond their range in {count} of {runs} runs: their range limited what they measured.")
        })
    }

    /// Number of runs, and the numbers of those that diverged.
    pub fn runs(&self) -> String {
        let Plan { first_run, runs, .. } = self.plan;
        let last = first_run + (runs - 1);
        let all = if *runs == 1 {
            format!("run {first_run}")
        } else {
            format!("{runs} runs, {first_run} to {last}")
        };
        let diverged = &self.results.diverged;
        if diverged.is_empty() {
            return all + "; none diverged";
        }
        let told: Vec<String> = diverged.iter().take(MOST_TOLD).map(u64::to_string).collect();
        let more = diverged.len().saturating_sub(MOST_TOLD);
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        format!("{all}; {} diverged: {}{more}", diverged.len(), told.join(", "))
    }
}

/// Largest number of diverged runs that are listed one by one. The file of the runs lists all.
const MOST_TOLD: usize = 20;
