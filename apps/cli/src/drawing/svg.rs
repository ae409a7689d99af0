//! A drawing as SVG.
//!
//! A drawing has no colours: a line has the class of its pen, and the style sheet has the rest. Lines, dots and notes of a panel stand
//! in an SVG element `moved`, lines in tenths of a pixel, dots and notes in percent, so that a script of the page enlarges a part by
//! the size of that element. The attributes `data-...` of a panel say where its axes are, and what they are.

use std::fmt::{self, Write};

use maud::html;

use super::axis::TimeAxis;
use super::plot::{Drawing, FINE, GAP, Label, Panel, RIGHT, Trace};
use crate::failure::Failure;

/// Parts of a pixel in which lines are written, and parts of its run in which the time of a track is written.
const PARTS: f64 = 10.0;
const TIMES: f64 = 1e5;

/// Distance of the labels from the left axis and from the lower one, of the x axis' name and of the marks' words [drawing units].
const BESIDE: f64 = 7.0;
const BELOW: f64 = 6.0;
const NAME_BELOW: f64 = 28.0;
const MARK_ABOVE: f64 = 5.0;

/// Base line of the caption below the upper edge of its panel [drawing units].
const CAPTION: f64 = 16.5;

impl Drawing {
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
        [drawing.left, top + panel.above(), drawing.width - drawing.left - RIGHT, panel.height]
    }

    /// Place of a point from the left and the upper edge of the axes, as shares of their width and height.
    fn share(&self, (x, y): (f64, f64)) -> (f64, f64) {
        (self.drawing.x.share(x), 1.0 - self.panel.y.share(y))
    }

    fn write(&self, text: &mut String) -> fmt::Result {
        let Self { drawing, panel, .. } = self;
        let sides = self.sides();
        let [left, top, width, height] = sides.map(pixel);
        let (x, y) = (drawing.x.data(unit(&drawing.x_label)), panel.y.data(unit(&panel.caption)));
        write!(text, "<g class=\"panel\" data-box=\"{left} {top} {width} {height}\" ")?;
        write!(text, "data-x=\"{}\" data-y=\"{}\"", escaped(&x), escaped(&y))?;
        if let Some(time) = &panel.time {
            write!(text, " data-t=\"{}\"", time.axis.data(time.unit))?;
        }
        let (caption, above) = (escaped(&panel.caption), pixel(self.top + CAPTION));
        writeln!(text, "><text class=\"caption\" x=\"{left}\" y=\"{above}\">{caption}</text>")?;
        self.write_axes(text)?;
        let (inner_width, inner_height) = (part(sides[2]), part(sides[3]));
        writeln!(
            text,
            "<svg class=\"inner\" x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\"><svg class=\"moved\">\
             <svg viewBox=\"0 0 {inner_width} {inner_height}\" preserveAspectRatio=\"none\">"
        )?;
        for mark in &panel.marks {
            let at = part(sides[2] * drawing.x.share(mark.at));
            writeln!(text, "<path class=\"{}\" d=\"m{at} 0v{inner_height}\"/>", mark.pen.class())?;
        }
        for trace in panel.traces.iter().filter(|trace| !trace.points.is_empty()) {
            self.write_trace(trace, text)?;
        }
        text.write_str("</svg>\n")?;
        self.write_dots_and_notes(text)?;
        text.write_str("</svg></svg>\n")?;
        for mark in panel.marks.iter().filter(|mark| !mark.text.is_empty()) {
            let (x, y) =
                (pixel(sides[0] + sides[2] * drawing.x.share(mark.at)), pixel(sides[1] - MARK_ABOVE));
            writeln!(text, "<text class=\"mark\" x=\"{x}\" y=\"{y}\">{}</text>", escaped(&mark.text))?;
        }
        if self.is_last {
            let name = escaped(&drawing.x_label);
            let (middle, below) = (pixel(sides[0] + 0.5 * sides[2]), pixel(sides[1] + sides[3] + NAME_BELOW));
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
            let x = left - pixel(BESIDE);
            write!(text, "<text x=\"{x}\" y=\"{y}\" dy=\".35em\">{}</text>", escaped(label))?;
        }
        text.write_str("</g>\n")?;
        if !is_last {
            return Ok(());
        }
        text.write_str("<g class=\"x-ticks\">")?;
        for (x, (_, label)) in across.iter().zip(x_ticks) {
            let y = top + height + pixel(BELOW);
            write!(text, "<text x=\"{x}\" y=\"{y}\" dy=\".8em\">{}</text>", escaped(label))?;
        }
        text.write_str("</g>\n")
    }

    /// A line: its first point, then the way from each point to the next.
    fn write_trace(&self, trace: &Trace, text: &mut String) -> fmt::Result {
        let [_, _, width, height] = self.sides();
        write!(text, "<path class=\"{}\" d=\"", trace.pen.class())?;
        let (mut x, mut y, mut begin) = (0, 0, "m");
        for point in &trace.points {
            let (next_x, next_y) = self.share(*point);
            let (next_x, next_y) = (part(width * next_x), part(height * next_y));
            let (right, down) = (next_x - x, next_y - y);
            let between = if down < 0 { "" } else { " " };
            write!(text, "{begin}{right}{between}{down}")?;
            (x, y, begin) = (next_x, next_y, if begin == "m" { "l" } else { " " });
        }
        // A single point is a dot.
        text.write_str(if trace.points.len() == 1 { "l0 0\"" } else { "\"" })?;
        if let Some(time) = &self.panel.time {
            write_times(&trace.time_s, time, text)?;
        }
        close("path", trace.label.as_ref(), text)
    }

    fn write_dots_and_notes(&self, text: &mut String) -> fmt::Result {
        let percent = |share: f64| (share * 1e4).round() / 100.0;
        for dot in &self.panel.dots {
            let (x, y) = self.share(dot.at);
            let (x, y, radius) = (percent(x), percent(y), pixel(dot.radius));
            write!(text, "<circle class=\"{}\" cx=\"{x}%\" cy=\"{y}%\" r=\"{radius}\"", dot.pen.class())?;
            close("circle", dot.label.as_ref(), text)?;
        }
        for note in &self.panel.notes {
            let (x, y) = self.share(note.at);
            let (x, y, class, words) = (percent(x), percent(y), note.pen.class(), escaped(&note.text));
            write!(text, "<text class=\"note {class}\" x=\"{x}%\" y=\"{y}%\" dy=\".35em\"")?;
            let (right, down) = (pixel(note.shift.0), pixel(note.shift.1));
            if (right, down) != (0, 0) {
                write!(text, " transform=\"translate({right} {down})\"")?;
            }
            writeln!(text, ">{words}</text>")?;
        }
        Ok(())
    }
}

/// The end of an element, with what its label says and its values.
fn close(name: &str, label: Option<&Label>, text: &mut String) -> fmt::Result {
    let Some(Label { text: words, values }) = label else { return text.write_str("/>\n") };
    for (axis, value) in ["x", "y"].iter().zip(values).filter(|(_, value)| !value.is_empty()) {
        write!(text, " data-{axis}=\"{}\"", escaped(value))?;
    }
    writeln!(text, "><title>{}</title></{name}>", escaped(words))
}

/// Times of the points of a track: the first, then from each to the next, in parts of the time axis.
fn write_times(time_s: &[f64], time: &TimeAxis, text: &mut String) -> fmt::Result {
    let at = |time_s: &f64| (TIMES * time.axis.share(time_s / time.seconds)).round() as i64;
    let (mut before, mut begin) = (0, "data-t=\"");
    for now in time_s.iter().map(at) {
        write!(text, " {begin}{}", now - before)?;
        (before, begin) = (now, "");
    }
    text.write_str(if time_s.is_empty() { "" } else { "\"" })
}

/// The unit in a label: what stands in brackets.
fn unit(label: &str) -> &str {
    label.split_once('[').and_then(|(_, rest)| rest.split_once(']')).map_or("", |(unit, _)| unit)
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
    use crate::drawing::axis::{Axis, Scale};
    use crate::drawing::pen::Pen;
    use crate::drawing::plot::{Dot, LEFT, Mark, Note, WIDTH};

    fn drawing(panel: Panel) -> Drawing {
        Drawing {
            width: WIDTH,
            left: LEFT,
            x: Axis::linear(0.0, 10.0, 5),
            x_label: "time [s]".into(),
            panels: vec![panel],
        }
    }

    #[test]
    fn a_drawing_has_classes_and_no_colours() {
        let y = Axis::linear(-1.0, 1.0, 4);
        let traces = vec![Trace::new(Pen::East, vec![(0.0, -1.0), (5.0, 0.5), (10.0, 1.0)])];
        let mut panel = Panel::new("east <m>", y, 100.0, traces);
        panel.marks.push(Mark { at: 5.0, pen: Pen::Schuler, text: "Schuler".into() });
        panel.dots.push(Dot { at: (2.5, 0.0), pen: Pen::Start, radius: 6.0, label: None });
        panel.notes.push(Note { at: (0.0, 0.5), shift: (0.0, 2.0), pen: Pen::Digit, text: "begin".into() });
        let svg = drawing(panel).svg("a \"line\"").unwrap();
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
        assert!(
            svg.contains("data-box=\"720 450 4260 1000\" data-x=\"0 10 0 s\" data-y=\"-1 2 0 \""),
            "{svg}"
        );
        assert!(svg.contains("<circle class=\"start\" cx=\"25%\" cy=\"50%\" r=\"60\"/>"), "{svg}");
        assert!(svg.contains("x=\"0%\" y=\"25%\" dy=\".35em\" transform=\"translate(0 20)\">begin"), "{svg}");
    }

    #[test]
    fn a_point_far_outside_is_still_a_number_that_can_be_read() {
        let trace = Trace::new(Pen::East, vec![(0.0, 0.0), (10.0, 1e300)]);
        let panel = Panel::new("", Axis::linear(0.0, 1.0, 4), 100.0, vec![trace]);
        assert!(drawing(panel).svg("").unwrap().contains("m0 10000l42600-10010000\"/>"));
    }

    /// The script finds the panels of one time axis, and the track beside them, by the same text.
    #[test]
    fn a_track_has_the_time_axis_of_its_run() {
        let time = Axis::time(7200.0, 8);
        let x = time.axis.data("min");
        let time_s = vec![0.0, 1800.0, 7200.0];
        let trace = Trace { time_s, ..Trace::new(Pen::Computed, vec![(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)]) };
        let mut panel = Panel::new("", Axis::linear(0.0, 1.0, 4), 100.0, vec![trace]);
        panel.time = Some(time);
        let svg = drawing(panel).svg("").unwrap();
        assert!(svg.contains(&format!("data-t=\"{x}\"")) && x == "0 120 0 min", "{svg}");
        assert!(svg.contains(" data-t=\"0 25000 75000\"/>"), "{svg}");
    }

    #[test]
    fn axes_say_what_their_positions_are() {
        let decades = |scale| Axis { scale, ..Axis::decades(-2.0, 1.0, 4) };
        assert_eq!(decades(Scale::Logarithm).data("m"), "-2 3 1 m");
        assert_eq!(decades(Scale::NegativeLogarithm).data("m"), "-2 3 -1 m");
        assert_eq!(Axis::periods(2.0, 5.0, 0.5).data(""), "2 3 1 s");
        let ticks = ["OFF", "NAV"].map(|word| (0.0, word.to_owned())).into();
        let names = Axis { low: -0.5, high: 1.5, ticks, scale: Scale::Names };
        assert_eq!(names.data(""), "-0.5 2 names OFF NAV");
        assert_eq!((unit("north [10⁻⁹ m]"), unit("runs")), ("10⁻⁹ m", ""));
    }
}
