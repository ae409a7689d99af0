//! The budgets as CSV.

use sins::analysis::recommend::SolutionError;

use super::survey::{BudgetLine, Kind, Survey};
use crate::failure::Failure;
use crate::rows::text;

pub const COLUMNS: [&str; 12] = [
    "scene",
    "effect",
    "key",
    "kind",
    "position_m",
    "velocity_m_s",
    "attitude_rad",
    "end_position_m",
    "end_velocity_m_s",
    "end_attitude_rad",
    "can_be_left_out",
    "cost_ns",
];

/// A row for each line.
pub fn records(surveys: &[Survey]) -> Result<String, Failure> {
    let rows =
        surveys.iter().flat_map(|survey| survey.lines().into_iter().map(move |line| row(survey, &line)));
    text(&COLUMNS, rows)
}

fn row(survey: &Survey, line: &BudgetLine) -> Vec<String> {
    let kind = match line.kind {
        Kind::Random => "random",
        Kind::Deterministic => "deterministic",
        Kind::Own => "own",
        Kind::Together => "together",
    };
    let mut row = [&survey.name, line.name, &line.key, kind].map(str::to_owned).to_vec();
    let parts = |error: SolutionError| error.parts().map(|part| format!("{part:.6e}"));
    for error in [Some(line.worst), line.end] {
        row.extend(error.map_or_else(Default::default, parts));
    }
    row.push(u8::from(line.can_be_left_out).to_string());
    row.push(line.cost_ns.map_or_else(String::new, |cost| format!("{cost:.1}")));
    row
}
