//! The budgets as Markdown.

use super::survey::{Kind, Line, Survey};
use crate::units::{ANGLE, LENGTH, SPEED, brief, time_text};

/// A table for each scene.
pub fn tables(surveys: &[Survey]) -> String {
    surveys.iter().map(table).collect::<Vec<_>>().join("\n")
}

fn table(survey: &Survey) -> String {
    let mut text = format!(
        "{}: {}\n\n| effect | | position | velocity | attitude | ns a step |\n|---|---|---|---|---|---|\n",
        survey.name, survey.title
    );
    for line in survey.lines() {
        let (kind, cost) = (kind(&line), line.cost_ns.map_or_else(String::new, |cost| format!("{cost:.0}")));
        let [position, velocity, attitude] = cells(&line);
        text += &format!("| {} | {kind} | {position} | {velocity} | {attitude} | {cost} |\n", line.name);
    }
    text + "\n" + &remark(survey) + "\n"
}

/// Position, velocity and attitude.
pub fn cells(line: &Line) -> [String; 3] {
    let worst = &line.worst;
    [(worst.position_m, LENGTH), (worst.velocity_m_s, SPEED), (worst.attitude_rad, ANGLE)]
        .map(|(value, family)| brief(value, family))
}

/// What a line is.
pub fn kind(line: &Line) -> &'static str {
    match (line.kind, line.can_be_left_out) {
        (Kind::Random, false) => "1σ",
        (Kind::Random, true) => "1σ, can be left out",
        (Kind::Deterministic, true) => "can be left out",
        (Kind::Deterministic | Kind::Own | Kind::Together, _) => "",
    }
}

/// How it was found, in words.
pub fn remark(survey: &Survey) -> String {
    let budget = &survey.budget;
    let mut text = format!("The largest in {}; {} flights", time_text(budget.span_s), budget.flights);
    if budget.runs > 1 {
        text += &format!(
            ", {} runs of each random effect: the true 1σ is {:.2} to {:.2} times that (95 %)",
            budget.runs, budget.interval.low, budget.interval.high
        );
    }
    text += ".";
    if budget.rows.iter().any(|row| row.can_be_left_out) {
        let left_out = &budget.left_out;
        text += &format!(
            " Without what can be left out, flown, the errors change by {}, {}, {}.",
            brief(left_out.position_m, LENGTH),
            brief(left_out.velocity_m_s, SPEED),
            brief(left_out.attitude_rad, ANGLE)
        );
    }
    text
}
