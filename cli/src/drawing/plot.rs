//! Panels above one another on one x axis, drawn as SVG.
//!
//! A drawing has no colours: a line has the class of its pen, and the style sheet has the rest. The lines of a panel stand in an SVG
//! element of their own, in tenths of a pixel, so that a script of the page enlarges a part by that element's `viewBox`. The
//! attributes `data-...` of a panel say where its axes are and from where to where they go.

use std::fmt::{self, Write};

use maud::html;

use crate::drawing::axis::Axis;
use crate::drawing::pen::Pen;
use crate::drawing::series::Points;
use crate::failure::Failure;

/// Pixels in a drawing unit.
pub const FINE: f64 = 10.0;

/// Parts of a pixel in which lines are written.
const PARTS: f64 = 10.0;

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

/// Distance of the labels from the left axis and from the lower one, and of the x axis' name [drawing units].
const BESIDE: f64 = 7.0;
const BELOW: f64 = 6.0;
const NAME_BELOW: f64 = 28.0;

/// Width of the panels [drawing units].
pub const PANEL_WIDTH: f64 = WIDTH - LEFT - RIGHT;

/// A line.
pub struct Trace {
    pub points: Points,
    pub pen: Pen,
    /// Time of each point since the start of the run [s], where the x axis is not time; empty: not known.
    pub time_s: Vec<f64>,
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
        Self { points, pen, time_s: Vec::new() }
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

    /// The drawing with another height; the panels share the difference by their heights.
    pub fn of_height(mut self, height: f64) -> Self {
        let panels: f64 = self.panels.iter().map(|panel| panel.height).sum();
        let factor = (height - (self.height() - panels)) / panels;
        self.panels.iter_mut().for_each(|panel| panel.height *= factor);
        self
    }

    /// The drawing as an SVG element that fills the width it is given; `alt` describes it.
    pub fn svg(&self, alt: &str) -> Result<String, Failure> {
        let mut text = String::new();
        let written = self.write(alt, &mut text);
        written.map(|()| text).map_err(|error| Failure::new(format!("{alt}: cannot be drawn: {error}")))
    }

    fn write(&self, alt: &str, text: &mut String) -> fmt::Result {
        let (alt, width, height) = (escaped(alt), pixel(self.width), pixel(self.height()));
        writeln!(
            text,
            "<svg class=\"plot\" role=\"img\" aria-label=\"{alt}\" viewBox=\"0 0 {width} {height}\">"
        )?;
        let mut top = 0.0;
        for (place, panel) in self.panels.iter().enumerate() {
            let frame = Frame { drawing: self, panel, top, is_last: place + 1 == self.panels.len() };
            frame.write(text)?;
            top += panel.above() + panel.height + GAP;
        }
        text.write_str("</svg>\n")
    }
}

/// A panel at its place in a drawing.
struct Frame<'a> {
    drawing: &'a Drawing,
    panel: &'a Panel,
    /// Its upper edge [drawing units].
    top: f64,
    is_last: bool,
}

impl Frame<'_> {
    /// Left and upper edge of the axes, their width and their height [drawing units].
    fn sides(&self) -> [f64; 4] {
        let Self { drawing, panel, top, .. } = self;
        [LEFT, top + panel.above(), drawing.width - LEFT - RIGHT, panel.height]
    }

    /// Place of a point from the left and the upper edge of the axes [drawing units].
    fn at(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let [_, _, width, height] = self.sides();
        (width * self.drawing.x.share(x), height * (1.0 - self.panel.y.share(y)))
    }

    fn write(&self, text: &mut String) -> fmt::Result {
        let Self { drawing, panel, .. } = self;
        let sides = self.sides();
        let [left, top, width, height] = sides.map(pixel);
        let (x, y) = (drawing.x.data(), panel.y.data());
        writeln!(
            text,
            "<g class=\"panel\" data-box=\"{left} {top} {width} {height}\" data-x=\"{x}\" data-y=\"{y}\">"
        )?;
        let caption = escaped(&panel.caption);
        writeln!(
            text,
            "<text class=\"caption\" x=\"{left}\" y=\"{}\">{caption}</text>",
            pixel(self.top + 16.5)
        )?;
        self.write_axes(text)?;
        let (inner_width, inner_height) = (part(sides[2]), part(sides[3]));
        writeln!(
            text,
            "<svg class=\"inner\" x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {inner_width} {inner_height}\" preserveAspectRatio=\"none\">"
        )?;
        for mark in &panel.marks {
            let at = part(self.at((mark.at, 0.0)).0);
            writeln!(text, "<path class=\"{}\" d=\"m{at} 0v{inner_height}\"/>", mark.pen.class())?;
        }
        for trace in panel.traces.iter().filter(|trace| !trace.points.is_empty()) {
            self.write_trace(trace, text)?;
        }
        text.write_str("</svg>\n")?;
        self.write_dots_and_texts(text)?;
        if self.is_last {
            let name = escaped(&drawing.x_label);
            let (middle, below) = (pixel(LEFT + 0.5 * sides[2]), pixel(sides[1] + sides[3] + NAME_BELOW));
            writeln!(text, "<text class=\"x-name\" x=\"{middle}\" y=\"{below}\" dy=\".8em\">{name}</text>")?;
        }
        text.write_str("</g>\n")
    }

    /// Grid, axes and ticks.
    fn write_axes(&self, text: &mut String) -> fmt::Result {
        let Self { drawing, panel, is_last, .. } = self;
        let [left, top, width, height] = self.sides();
        let (x_ticks, y_ticks) = (&drawing.x.ticks, &panel.y.ticks);
        let across: Vec<i64> =
            x_ticks.iter().map(|(at, _)| pixel(left + width * drawing.x.share(*at))).collect();
        let up: Vec<i64> =
            y_ticks.iter().map(|(at, _)| pixel(top + height * (1.0 - panel.y.share(*at)))).collect();
        let [left, top, width, height] = [left, top, width, height].map(pixel);
        text.write_str("<path class=\"grid\" d=\"")?;
        across.iter().try_for_each(|x| write!(text, "M{x} {top}v{height}"))?;
        up.iter().try_for_each(|y| write!(text, "M{left} {y}h{width}"))?;
        writeln!(text, "\"/><path class=\"axis\" d=\"M{left} {top}v{height}h{width}\"/>")?;
        text.write_str("<g class=\"y-ticks\">")?;
        for (y, (_, label)) in up.iter().zip(y_ticks) {
            write!(
                text,
                "<text x=\"{}\" y=\"{y}\" dy=\".35em\">{}</text>",
                left - pixel(BESIDE),
                escaped(label)
            )?;
        }
        text.write_str("</g>\n")?;
        if !is_last {
            return Ok(());
        }
        text.write_str("<g class=\"x-ticks\">")?;
        for (x, (_, label)) in across.iter().zip(x_ticks) {
            write!(
                text,
                "<text x=\"{x}\" y=\"{}\" dy=\".8em\">{}</text>",
                top + height + pixel(BELOW),
                escaped(label)
            )?;
        }
        text.write_str("</g>\n")
    }

    /// A line: its first point, then the way from each point to the next.
    fn write_trace(&self, trace: &Trace, text: &mut String) -> fmt::Result {
        write!(text, "<path class=\"{}\" d=\"", trace.pen.class())?;
        let (mut x, mut y, mut begin) = (0, 0, "m");
        for point in &trace.points {
            let (next_x, next_y) = self.at(*point);
            let (next_x, next_y) = (part(next_x), part(next_y));
            let (right, down) = (next_x - x, next_y - y);
            let between = if down < 0 { "" } else { " " };
            write!(text, "{begin}{right}{between}{down}")?;
            (x, y, begin) = (next_x, next_y, if begin == "m" { "l" } else { " " });
        }
        // A single point is a dot.
        text.write_str(if trace.points.len() == 1 { "l0 0\"" } else { "\"" })?;
        if let Some(first) = trace.time_s.first() {
            write!(text, " data-t=\"{}", first.round())?;
            trace
                .time_s
                .windows(2)
                .try_for_each(|pair| write!(text, " {}", pair[1].round() - pair[0].round()))?;
            text.write_str("\"")?;
        }
        text.write_str("/>\n")
    }

    fn write_dots_and_texts(&self, text: &mut String) -> fmt::Result {
        let [left, top, ..] = self.sides();
        for mark in self.panel.marks.iter().filter(|mark| !mark.text.is_empty()) {
            let (x, y) = (pixel(left + self.at((mark.at, 0.0)).0), pixel(top - 5.0));
            writeln!(text, "<text class=\"mark\" x=\"{x}\" y=\"{y}\">{}</text>", escaped(&mark.text))?;
        }
        for dot in &self.panel.dots {
            let (x, y) = self.at(dot.at);
            let (x, y, radius) = (pixel(left + x), pixel(top + y), pixel(dot.radius));
            writeln!(text, "<circle class=\"{}\" cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"/>", dot.pen.class())?;
        }
        for note in &self.panel.notes {
            let (x, y) = self.at(note.at);
            let (x, y) = (pixel(left + x + note.shift.0), pixel(top + y + note.shift.1));
            let (class, words) = (note.pen.class(), escaped(&note.text));
            writeln!(text, "<text class=\"note {class}\" x=\"{x}\" y=\"{y}\" dy=\".35em\">{words}</text>")?;
        }
        Ok(())
    }
}

fn escaped(text: &str) -> String {
    html! { (text) }.into_string()
}

fn pixel(units: f64) -> i64 {
    (units * FINE).round() as i64
}

/// Parts of a pixel; a point far outside stays a number that drawing programs can read.
fn part(units: f64) -> i64 {
    const FAR: f64 = 1e7;
    (units * FINE * PARTS).round().clamp(-FAR, FAR) as i64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawing_has_classes_and_no_colours() {
        let y = Axis::linear(-1.0, 1.0, 4);
        let traces = vec![Trace::new(Pen::East, vec![(0.0, -1.0), (5.0, 0.5), (10.0, 1.0)])];
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
        for class in ["grid", "axis", "east", "schuler", "start", "note digit"] {
            assert!(svg.contains(&format!("class=\"{class}\"")), "{class}");
        }
        for look in ["#", "opacity", "stroke", "fill", "font"] {
            assert!(!svg.contains(look), "{look} is the style sheet's");
        }
        assert!(svg.contains("east &lt;m&gt;"));
        // 426 by 100 units, in hundredths.
        assert!(svg.contains("<path class=\"east\" d=\"m0 10000l21300-7500 21300-2500\"/>"), "{svg}");
        assert!(svg.contains("data-box=\"720 450 4260 1000\" data-x=\"0 10 1\" data-y=\"-1 1 1\""), "{svg}");
    }

    #[test]
    fn a_drawing_of_another_height_is_that_high() {
        let panel = |height| Panel::new("", Axis::linear(0.0, 1.0, 4), height, Vec::new());
        let panels = vec![panel(100.0), panel(50.0)];
        let drawing = Drawing { width: WIDTH, x: Axis::linear(0.0, 1.0, 4), x_label: String::new(), panels };
        let drawing = drawing.of_height(500.0);
        assert_eq!(drawing.height(), 500.0);
        assert!((drawing.panels[0].height - 2.0 * drawing.panels[1].height).abs() < 1e-9);
    }

    #[test]
    fn a_point_far_outside_is_still_a_number_that_can_be_read() {
        let trace = Trace::new(Pen::East, vec![(0.0, 0.0), (1.0, 1e300)]);
        let panel = Panel::new("", Axis::linear(0.0, 1.0, 4), 100.0, vec![trace]);
        let drawing = Drawing {
            width: WIDTH,
            x: Axis::linear(0.0, 1.0, 4),
            x_label: String::new(),
            panels: vec![panel],
        };
        assert!(drawing.svg("").unwrap().contains("m0 10000l42600-10010000\"/>"));
    }
}
