//! Bars: position, velocity and attitude side by side, a line for each effect.

use maud::{Markup, html};

use super::survey::{Kind, Line, Survey};
use super::table::Columns;
use crate::drawing::axis::Axis;
use crate::drawing::figure::Legend;
use crate::drawing::pen::Pen;
use crate::drawing::plot::FINE;
use crate::drawing::series::positive_range;
use crate::units::{Unit, short};

/// Widths of the names, of a panel and of the value after its longest bar; heights of a line, of its bar, of the panels' titles and
/// of the ticks below [drawing units].
const NAMES: f64 = 222.0;
const PANEL: f64 = 215.0;
const VALUE: f64 = 95.0;
const LINE: f64 = 22.0;
const BAR: f64 = 13.0;
const TITLE: f64 = 24.0;
const TICKS: f64 = 26.0;

/// How the three panels are arranged: side by side, or above one another on a narrow page.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    Row,
    Column,
}

impl Layout {
    /// Width and height of the chart of `survey` [drawing units].
    pub fn size(self, survey: &Survey) -> (f64, f64) {
        let (width, height) = (PANEL + VALUE, height(survey));
        match self {
            Self::Row => (NAMES + 3.0 * width, height),
            Self::Column => (NAMES + width, 3.0 * height),
        }
    }
}

/// Largest number of decades that a panel shows.
const DECADES: f64 = 9.0;

const QUANTITIES: [&str; 3] = ["position", "velocity", "attitude"];

/// Height of a panel with its title and ticks.
fn height(survey: &Survey) -> f64 {
    TITLE + survey.lines().len() as f64 * LINE + TICKS
}

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

/// The chart as the inside of an SVG element, in the units of the table.
pub fn chart(survey: &Survey, layout: Layout) -> Markup {
    let lines = survey.lines();
    let units = Columns::of(survey).units;
    let moved = |k: f64| match layout {
        Layout::Row => (k * (PANEL + VALUE), 0.0),
        Layout::Column => (0.0, k * height(survey)),
    };
    html! {
        @for (k, unit) in units.into_iter().enumerate() {
            @let (right, down) = moved(k as f64);
            g transform={ "translate(" (right * FINE) " " (down * FINE) ")" } {
                @if k == 0 || layout == Layout::Column {
                    @for (k, line) in lines.iter().enumerate() {
                        text class=(label_class(line)) x=((NAMES - 8.0) * FINE) y=(text_y(k)) { (line.name) }
                    }
                }
                (panel(&lines, survey.request.limits.parts()[k], k, unit))
            }
        }
    }
}

fn label_class(line: &Line) -> &'static str {
    if line.can_be_left_out { "label left-out" } else { "label" }
}

/// Base line of the text of line `k` [pixels].
fn text_y(k: usize) -> f64 {
    (TITLE + (k as f64 + 0.7) * LINE) * FINE
}

/// The panel of part `part` of the errors.
fn panel(lines: &[Line], limit: f64, part: usize, unit: Unit) -> Markup {
    let left = NAMES;
    let (title, limit) = (QUANTITIES[part], limit / unit.si);
    let value = |line: &Line| line.worst.parts()[part] / unit.si;
    let axis = axis(lines.iter().map(value).chain([limit]));
    let at = |value: f64| {
        let share = (value.log10() - axis.low) / (axis.high - axis.low);
        PANEL * share.clamp(0.0, 1.0)
    };
    let bottom = TITLE + lines.len() as f64 * LINE;
    html! {
        text class="title" x=(left * FINE) y=(0.65 * TITLE * FINE) { (title) " [" (unit.name) "]" }
        @for (place, tick) in &axis.ticks {
            (upright(Pen::Grid, left + at(10f64.powf(*place)), TITLE, bottom))
            text class="tick" x=((left + at(10f64.powf(*place))) * FINE) y=((bottom + 18.0) * FINE) { (tick) }
        }
        @if limit > 0.0 { (upright(Pen::Limit, left + at(limit), TITLE, bottom)) }
        @for (k, line) in lines.iter().enumerate() {
            (bar(line, at(value(line)), left, k))
            text class="value" x=((left + at(value(line)) + 6.0) * FINE) y=(text_y(k)) {
                (short(value(line)))
            }
        }
        (upright(Pen::Axis, left, TITLE, bottom))
    }
}

fn upright(pen: Pen, x: f64, top: f64, bottom: f64) -> Markup {
    html! { line class=(pen.class()) x1=(x * FINE) x2=(x * FINE) y1=(top * FINE) y2=(bottom * FINE) {} }
}

fn bar(line: &Line, width: f64, left: f64, k: usize) -> Markup {
    let pen = match line.kind {
        Kind::Random => Pen::Random,
        Kind::Deterministic => Pen::Deterministic,
        Kind::Own => Pen::Own,
        Kind::Together => Pen::Together,
    };
    let class =
        if line.can_be_left_out { format!("{} left-out", pen.class()) } else { pen.class().to_owned() };
    let top = TITLE + k as f64 * LINE + 0.5 * (LINE - BAR);
    html! {
        rect class=(class) x=(left * FINE) y=(top * FINE) width=(width * FINE) height=(BAR * FINE) {}
    }
}

/// Powers of ten that contain `values`, except values that are too small to be seen next to the largest.
fn axis(values: impl Iterator<Item = f64>) -> Axis {
    let (low, high) = positive_range(values);
    let (low, high) = (low.log10(), high.log10());
    // Half a decade is added so that the smallest value has a bar.
    Axis::decades((low - 0.5).max(high - DECADES), high.max(low + 1.0), 5)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axis_holds_what_can_be_seen() {
        let decades = axis([3.0, 0.0, 2e-4, f64::INFINITY].into_iter());
        assert!(decades.low < 2e-4f64.log10() && decades.high == 3f64.log10());
        assert_eq!(axis([1.0, 1e-30].into_iter()).low, -DECADES);
        let nothing = axis([0.0].into_iter());
        assert!(nothing.low < nothing.high);
    }
}
