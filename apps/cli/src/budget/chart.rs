//! Bars: a drawing for each of position, velocity and attitude, with a bar for each effect. The axis is linear, so that bars of twice the
//! length are errors of twice the size.

use super::survey::{BudgetLine, Kind, Survey};
use super::table::{self, Columns};
use crate::drawing::axis::{Axis, Scale};
use crate::drawing::figure::Legend;
use crate::drawing::pen::Pen;
use crate::drawing::plot::{Drawing, Label, Mark, Note, Panel, RIGHT, Trace};
use crate::units::{Unit, short, six_digits};

/// Widths of the names, of the room left of bars without names, and of a panel; height of a line [drawing units].
const NAMES: f64 = 222.0;
const NO_NAMES: f64 = 16.0;
const PANEL: f64 = 290.0;
const LINE: f64 = 22.0;

/// Length of the axis as a multiple of its longest bar: room for its value.
const ROOM: f64 = 1.35;

/// Distance of a value from the end of its bar [drawing units].
const BESIDE: f64 = 6.0;

/// Largest ratio of the limit to the longest bar at which the limit is drawn.
const FAR: f64 = 3.0;

pub const QUANTITIES: [&str; 3] = ["position", "velocity", "attitude"];

pub fn legend(survey: &Survey) -> Legend {
    let entry = |pen, text: &str| (pen, text.to_owned());
    let mut legend = vec![
        entry(Pen::Random, "random, 1σ"),
        entry(Pen::Deterministic, "deterministic"),
        entry(Pen::Own, "mechanization"),
        entry(Pen::Together, "together"),
    ];
    if survey.request.has_limits() {
        legend.push(entry(Pen::Limit, "limit; pale: can be left out"));
    }
    legend
}

/// The bars of part `part` of the errors, in the unit of the table; the names stand left of the bars, if they are wanted.
pub fn drawing(survey: &Survey, part: usize, has_names: bool) -> Drawing {
    let lines = survey.lines();
    let unit = Columns::of(survey).units[part];
    let (count, limit) = (lines.len(), survey.request.limits.parts()[part] / unit.si);
    let value = |line: &BudgetLine| line.worst.parts()[part] / unit.si;
    let longest = lines.iter().map(value).fold(0.0, f64::max);
    let is_near = limit > 0.0 && limit <= FAR * longest;
    let most = if is_near { limit.max(longest) } else { longest };
    let x = Axis::linear(0.0, if most > 0.0 { ROOM * most } else { 1.0 }, 4);
    // The first line is the highest.
    let row = |k: usize| (count - 1 - k) as f64;
    let name = |line: &BudgetLine| if has_names { line.name.to_owned() } else { String::new() };
    let ticks = lines.iter().enumerate().rev().map(|(k, line)| (row(k), name(line))).collect();
    let y = Axis { low: -0.5, high: count as f64 - 0.5, ticks, scale: Scale::Names };
    let bars = lines.iter().enumerate().map(|(k, line)| Trace {
        label: Some(label(line, value(line), unit)),
        ..Trace::new(pen(line), vec![(0.0, row(k)), (value(line), row(k))])
    });
    let caption = format!("{} [{}]", QUANTITIES[part], unit.name);
    let mut panel = Panel::new(caption, y, count as f64 * LINE, bars.collect());
    panel.marks.extend(is_near.then(|| Mark { at: limit, pen: Pen::Limit, text: String::new() }));
    panel.notes.extend(lines.iter().enumerate().map(|(k, line)| Note {
        at: (value(line), row(k)),
        shift: (BESIDE, 0.0),
        pen: Pen::Value,
        text: short(value(line)),
    }));
    let left = if has_names { NAMES } else { NO_NAMES };
    let x_label = format!("largest error in the flight [{}]", unit.name);
    Drawing { width: left + PANEL + RIGHT, left, x, x_label, panels: vec![panel] }
}

fn label(line: &BudgetLine, value: f64, unit: Unit) -> Label {
    let kind = match table::kind(line) {
        "" => String::new(),
        kind => format!(" ({kind})"),
    };
    let text = format!("{}{kind}: {} {}", line.name, short(value), unit.name);
    Label { text, values: [six_digits(value).to_string(), String::new()] }
}

fn pen(line: &BudgetLine) -> Pen {
    match (line.kind, line.can_be_left_out) {
        (Kind::Random, false) => Pen::Random,
        (Kind::Random, true) => Pen::PaleRandom,
        (Kind::Deterministic, false) => Pen::Deterministic,
        (Kind::Deterministic, true) => Pen::PaleDeterministic,
        (Kind::Own, _) => Pen::Own,
        (Kind::Together, _) => Pen::Together,
    }
}

#[cfg(test)]
mod tests {
    use super::super::survey::tests::made;
    use super::*;

    /// The lengths of two bars are to each other as their errors are, and no bar is longer than the root sum of squares.
    #[test]
    fn bars_can_be_compared() {
        let survey = made();
        let drawing = drawing(&survey, 0, true);
        let ends: Vec<f64> =
            drawing.panels[0].traces.iter().map(|bar| drawing.x.share(bar.points[1].0)).collect();
        let errors: Vec<f64> = survey.lines().iter().map(|line| line.worst.position_m).collect();
        assert!(
            ends.iter().zip(&errors).all(|(end, error)| (end / ends[0] - error / errors[0]).abs() < 1e-12)
        );
        assert!(drawing.panels[0].traces.iter().all(|bar| drawing.x.share(bar.points[0].0) == 0.0));
        let place = survey.lines().iter().position(|line| line.name == "root sum of squares").unwrap();
        assert!(
            errors[..place].iter().all(|error| *error <= errors[place])
                && errors[place] < errors[0] + errors[1]
        );
    }

    #[test]
    fn a_limit_that_is_far_away_does_not_shorten_the_bars() {
        let mut survey = made();
        let marks = |survey: &Survey| drawing(survey, 0, true).panels[0].marks.len();
        assert_eq!(marks(&survey), 1);
        survey.request.limits.position_m = 1e6;
        assert_eq!(marks(&survey), 0);
        assert!(drawing(&survey, 0, true).x.high < 2.0);
    }

    #[test]
    fn without_errors_there_is_an_axis() {
        let drawing = drawing(&made(), 2, true);
        assert!(drawing.x.low == 0.0 && drawing.x.high == 1.0);
    }
}
