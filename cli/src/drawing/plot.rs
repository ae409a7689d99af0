//! Panels above one another on one x axis, drawn as SVG.
//!
//! `plotters` has colours only, and writes integer coordinates. A pen is passed in as the colour of its number and is written as a
//! CSS class. A drawing unit is [`FINE`] pixels of `plotters`.

use std::ops::Range;

use plotters::coord::Shift;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::drawing::axis::Axis;
use crate::drawing::pen::Pen;
use crate::drawing::series::Points;
use crate::failure::Failure;

/// Pixels of `plotters` in a drawing unit.
pub const FINE: f64 = 10.0;

/// Width of a drawing, unless it states another [drawing units]; a phone shows it at two thirds.
pub const WIDTH: f64 = 520.0;

/// Room for the labels left of the panels, the margin right, the caption above, the marks' texts under it, the x axis
/// [drawing units].
const LEFT: f64 = 72.0;
const RIGHT: f64 = 22.0;
const CAPTION: f64 = 25.0;
const MARK_TEXT: f64 = 20.0;
const X_AXIS: f64 = 48.0;
const GAP: f64 = 6.0;

/// Width of the panels [drawing units].
pub const PANEL_WIDTH: f64 = WIDTH - LEFT - RIGHT;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn<'a> = Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

/// A line.
pub struct Trace {
    pub points: Points,
    pub pen: Pen,
}

/// A vertical line over the whole panel, with a word above it, or none.
pub struct Mark {
    pub at: f64,
    pub pen: Pen,
    pub text: String,
}

/// A circle, filled or hollow as its pen defines.
pub struct Dot {
    pub at: (f64, f64),
    pub pen: Pen,
    /// Radius [drawing units].
    pub radius: f64,
}

/// Text with its middle at a point, shifted right and down by `shift` [drawing units].
pub struct Note {
    pub at: (f64, f64),
    pub shift: (f64, f64),
    pub pen: Pen,
    pub text: String,
}

/// One pair of axes.
pub struct Panel {
    /// Quantity of the y axis, with its unit.
    pub caption: String,
    pub y: Axis,
    pub traces: Vec<Trace>,
    pub marks: Vec<Mark>,
    pub dots: Vec<Dot>,
    pub notes: Vec<Note>,
    /// Height of the axes alone [drawing units].
    pub height: f64,
}

/// Panels from top to bottom.
pub struct Drawing {
    /// Width [drawing units].
    pub width: f64,
    pub x: Axis,
    pub x_label: String,
    pub panels: Vec<Panel>,
}

impl Trace {
    pub fn new(pen: Pen, points: Points) -> Self {
        Self { points, pen }
    }
}

impl Panel {
    /// Panel with lines only.
    pub fn new(caption: impl Into<String>, y: Axis, height: f64, traces: Vec<Trace>) -> Self {
        Self {
            caption: caption.into(),
            y,
            traces,
            marks: Vec::new(),
            dots: Vec::new(),
            notes: Vec::new(),
            height,
        }
    }

    fn above(&self) -> f64 {
        if self.marks.iter().all(|mark| mark.text.is_empty()) { CAPTION } else { CAPTION + MARK_TEXT }
    }
}

impl Drawing {
    /// Height of all panels with the x axis [drawing units].
    pub fn height(&self) -> f64 {
        self.panels.iter().map(|panel| panel.above() + panel.height + GAP).sum::<f64>() + X_AXIS
    }

    /// The drawing as an SVG element that fills the width it is given; `alt` describes it.
    pub fn svg(&self, alt: &str) -> Result<String, Failure> {
        let height = self.height();
        let mut text = String::new();
        let root = SVGBackend::with_string(&mut text, (size(self.width), size(height))).into_drawing_area();
        let mut top = 0.0;
        for (place, panel) in self.panels.iter().enumerate() {
            let below = if place + 1 == self.panels.len() { X_AXIS } else { 0.0 };
            let whole = panel.above() + panel.height + below;
            let area = root.clone().shrink((0, pixel(top)), (size(self.width), size(whole)));
            self.draw(&area, panel, below)?;
            top += whole + GAP;
        }
        root.present()?;
        drop(root);
        let body = text.split_once('\n').map_or("", |(_, body)| body);
        let alt = maud::html! { (alt) }.into_string();
        Ok(format!(
            "<svg class=\"plot\" role=\"img\" aria-label=\"{alt}\" viewBox=\"0 0 {} {}\">\n{}",
            size(self.width),
            size(height),
            with_classes(body)
        ))
    }

    fn draw<'a>(&self, area: &Area<'a>, panel: &Panel, below: f64) -> Drawn<'a> {
        let style = |pen: Pen| ShapeStyle { color: pen.colour().to_rgba(), filled: false, stroke_width: 1 };
        area.draw(&Text::new(panel.caption.clone(), (pixel(LEFT), pixel(4.0)), text_style(HPos::Left)))?;
        let mut chart = ChartBuilder::on(area)
            .margin_top(size(panel.above()))
            .margin_right(size(RIGHT))
            .set_label_area_size(LabelAreaPosition::Left, size(LEFT))
            .set_label_area_size(LabelAreaPosition::Bottom, size(below))
            .build_cartesian_2d(self.x.clone(), panel.y.clone())?;
        chart
            .configure_mesh()
            .bold_line_style(style(Pen::Grid))
            .light_line_style(TRANSPARENT)
            .axis_style(style(Pen::Axis))
            .set_all_tick_mark_size(size(4.0))
            .label_style(text_style(HPos::Center))
            .axis_desc_style(text_style(HPos::Center))
            .x_desc(self.x_label.clone())
            .draw()?;
        for mark in &panel.marks {
            chart.draw_series(LineSeries::new(
                [(mark.at, panel.y.low), (mark.at, panel.y.high)],
                style(mark.pen),
            ))?;
            let (x, y) = chart.backend_coord(&(mark.at, panel.y.high));
            let (left, top) = area.get_base_pixel();
            area.draw(&Text::new(
                mark.text.clone(),
                (x - left, y - top - pixel(MARK_TEXT)),
                text_style(HPos::Center),
            ))?;
        }
        for trace in &panel.traces {
            chart.draw_series(LineSeries::new(trace.points.iter().copied(), style(trace.pen)))?;
        }
        let filled = |pen: Pen| ShapeStyle { filled: true, ..style(pen) };
        chart.draw_series(
            panel.dots.iter().map(|dot| Circle::new(dot.at, size(dot.radius), filled(dot.pen))),
        )?;
        let (left, top) = area.get_base_pixel();
        for note in &panel.notes {
            let (x, y) = chart.backend_coord(&note.at);
            let place = (x - left + pixel(note.shift.0), y - top + pixel(note.shift.1));
            let centred = text_style(HPos::Center).pos(Pos::new(HPos::Center, VPos::Center));
            let style = TextStyle { color: note.pen.colour().to_backend_color(), ..centred };
            area.draw(&Text::new(note.text.clone(), place, style))?;
        }
        Ok(())
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        let share = (value - self.low) / (self.high - self.low);
        (f64::from(from) + share * f64::from(to - from)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.iter().map(|(at, _)| *at).collect()
    }

    fn range(&self) -> Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, place: &f64) -> String {
        self.text(*place)
    }
}

fn pixel(units: f64) -> i32 {
    (units * FINE).round() as i32
}

fn size(units: f64) -> u32 {
    (units * FINE).round() as u32
}

/// Style of texts. Its size is only for the layout; the style sheet has the visible size.
fn text_style(horizontal: HPos) -> TextStyle<'static> {
    let mut style =
        TextStyle::from(("sans-serif", size(16.0)).into_font()).pos(Pos::new(horizontal, VPos::Top));
    style.color = Pen::Text.colour().to_backend_color();
    style
}

/// Replaces colours by classes, and leaves the rest of the look to the style sheet.
fn with_classes(body: &str) -> String {
    let mut text = body.to_owned();
    for pen in Pen::ALL {
        for attribute in ["stroke", "fill"] {
            let colour = format!("{attribute}=\"#0000{:02X}\"", pen.colour().2);
            text = text.replace(&colour, &format!("class=\"{}\"", pen.class()));
        }
    }
    let font_size = format!(" font-size=\"{}\"", f64::from(size(16.0)) / 1.24);
    for attribute in [
        " opacity=\"1\"",
        " fill=\"none\"",
        " stroke=\"none\"",
        " stroke-width=\"1\"",
        " font-family=\"sans-serif\"",
        &font_size,
    ] {
        text = text.replace(attribute, "");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawing_has_classes_and_no_colours() {
        let y = Axis::linear(-1.0, 1.0, 4);
        let traces = vec![Trace::new(Pen::East, vec![(0.0, -1.0), (10.0, 1.0)])];
        let mut panel = Panel::new("east <m>", y, 100.0, traces);
        panel.marks.push(Mark { at: 5.0, pen: Pen::Schuler, text: "Schuler".into() });
        panel.dots.push(Dot { at: (0.0, 0.0), pen: Pen::Start, radius: 6.0 });
        panel.notes.push(Note { at: (0.0, 0.0), shift: (0.0, 0.0), pen: Pen::Digit, text: "begin".into() });
        let x = Axis::linear(0.0, 10.0, 5);
        let drawing = Drawing { width: WIDTH, x, x_label: "time [s]".into(), panels: vec![panel] };
        let svg = drawing.svg("a \"line\"").unwrap();
        assert!(
            svg.starts_with("<svg class=\"plot\" role=\"img\" aria-label=\"a &quot;line&quot;\" viewBox=")
        );
        assert!(svg.ends_with("</svg>\n"));
        for class in ["text", "grid", "axis", "east", "schuler", "start", "digit"] {
            assert!(svg.contains(&format!("class=\"{class}\"")), "{class}");
        }
        for look in ["#", "opacity", "stroke", "fill", "font"] {
            assert!(!svg.contains(look), "{look} is the style sheet's");
        }
        assert!(svg.contains("east &lt;m&gt;"));
    }
}
