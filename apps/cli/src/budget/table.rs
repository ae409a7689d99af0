//! The budgets as Markdown.

use super::survey::{BudgetLine, Kind, Survey};
use crate::units::{ANGLE, Family, LENGTH, SPEED, Unit, brief_parts, short, time_text, usual};

/// Uncertainty of a cost, as a part of the time of a step.
const NOISE: f64 = 0.01;

/// A table for each scene.
pub fn tables(surveys: &[Survey]) -> String {
    surveys.iter().map(table).collect::<Vec<_>>().join("\n")
}

fn table(survey: &Survey) -> String {
    let columns = Columns::of(survey);
    let mut text = format!("{}: {}\n\n|", survey.name, survey.title);
    for head in columns.heads() {
        text += &format!(" {head} |");
    }
    text += &format!("\n{}|\n", "|---".repeat(columns.heads().len()));
    for line in survey.lines() {
        text += &format!("| {} | {} | {} |\n", line.name, kind(&line), columns.cells(&line).join(" | "));
    }
    text + "\n" + &remark(survey) + "\n"
}

/// One unit for each column, chosen for its largest value, so that rows can be compared.
pub struct Columns {
    /// Of position, velocity and attitude.
    pub units: [Unit; 3],
    /// Time of a step with all effects [ns]; without it, there is no column of times.
    step_ns: Option<f64>,
}

impl Columns {
    pub fn of(survey: &Survey) -> Self {
        let lines = survey.lines();
        let unit = |part: usize, family: &Family| {
            let largest = lines.iter().map(|line| line.worst.parts()[part]).fold(0.0, f64::max);
            usual(largest, family)
        };
        let step_ns = survey.costs.as_ref().map(|costs| costs.total_ns);
        Self { units: [unit(0, LENGTH), unit(1, SPEED), unit(2, ANGLE)], step_ns }
    }

    pub fn heads(&self) -> Vec<String> {
        let [position, velocity, attitude] = self.units.map(|unit| unit.name);
        let mut heads = vec![
            "effect".to_owned(),
            String::new(),
            format!("position [{position}]"),
            format!("velocity [{velocity}]"),
            format!("attitude [{attitude}]"),
        ];
        heads.extend(self.step_ns.map(|_| "a step [ns]".to_owned()));
        heads
    }

    /// Position, velocity and attitude, and the cost of a step.
    pub fn cells(&self, line: &BudgetLine) -> Vec<String> {
        let parts = line.worst.parts().into_iter().zip(self.units);
        let mut cells: Vec<String> = parts.map(|(part, unit)| short(part / unit.si)).collect();
        // A cost below the noise of the clock may be negative.
        cells.extend(self.step_ns.map(|step_ns| match line.cost_ns {
            None => String::new(),
            Some(cost) if cost < NOISE * step_ns => "below noise".to_owned(),
            Some(cost) => format!("{cost:.0}"),
        }));
        cells
    }
}

/// Kind of a line in words.
pub fn kind(line: &BudgetLine) -> &'static str {
    match (line.kind, line.can_be_left_out) {
        (Kind::Random, false) => "1σ",
        (Kind::Random, true) => "1σ, can be left out",
        (Kind::Deterministic, true) => "can be left out",
        (Kind::Deterministic | Kind::Own | Kind::Together, _) => "",
    }
}

/// How the figures were found.
pub fn remark(survey: &Survey) -> String {
    let budget = &survey.budget;
    let mut text = format!("The largest in {}; {} flights", time_text(budget.span_s), budget.flights);
    if budget.runs > 1 {
        text += &format!(
            "; \"all together\" is from {} runs: the true root mean square of the random part is {:.2} to {:.2} times its figure (95 %)",
            budget.runs, budget.interval.low, budget.interval.high
        );
    }
    text += ".";
    if budget.rows.iter().any(|row| row.can_be_left_out) {
        let left_out = brief_parts(budget.left_out.parts());
        text += &format!(
            " In flights without the effects that can be left out, the errors change by {left_out} (root mean square over the runs)."
        );
    }
    text
}
