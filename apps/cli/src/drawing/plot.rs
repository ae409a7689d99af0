//! Panels above one another on one x axis.

use crate::drawing::axis::{Axis, TimeAxis};
use crate::drawing::pen::Pen;
use crate::drawing::series::Points;

/// Pixels in a drawing unit.
pub const FINE: f64 = 10.0;

/// Width of a drawing, unless it states another [drawing units]; a phone shows it at two thirds.
pub const WIDTH: f64 = 520.0;

/// Usual room for the labels left of the panels, the margin right, the caption above, the marks' texts under it, the x axis
/// [drawing units].
pub const LEFT: f64 = 72.0;
pub const RIGHT: f64 = 22.0;
const CAPTION: f64 = 25.0;
const MARK_TEXT: f64 = 20.0;
const X_AXIS: f64 = 48.0;
pub const GAP: f64 = 6.0;

/// Width of the panels [drawing units].
pub const PANEL_WIDTH: f64 = WIDTH - LEFT - RIGHT;

/// What a reader is told of a dot or of the end of a bar.
#[derive(Clone)]
pub struct Label {
    pub text: String,
    /// Its values in the units of the axes, right and up; empty: that of the axis.
    pub values: [String; 2],
}

/// A line.
pub struct Trace {
    pub points: Points,
    pub pen: Pen,
    /// Of a bar, which goes from its first point to its second.
    pub label: Option<Label>,
    /// Time of each point of a track since the start of the run [s].
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
    pub label: Option<Label>,
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
    /// Of a track: the time axis of its run.
    pub time: Option<TimeAxis>,
    /// Height of the axes alone [drawing units].
    pub height: f64,
}

/// Panels from top to bottom.
pub struct Drawing {
    /// Width, and room for the labels left of the panels [drawing units].
    pub width: f64,
    pub left: f64,
    pub x: Axis,
    pub x_label: String,
    pub panels: Vec<Panel>,
}

impl Trace {
    pub fn new(pen: Pen, points: Points) -> Self {
        Self { points, pen, label: None, time_s: Vec::new() }
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
            time: None,
            height,
        }
    }

    /// Room above the axes [drawing units].
    pub fn above(&self) -> f64 {
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
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawing_of_another_height_is_that_high() {
        let panel = |height| Panel::new("", Axis::linear(0.0, 1.0, 4), height, Vec::new());
        let panels = vec![panel(100.0), panel(50.0)];
        let x = Axis::linear(0.0, 1.0, 4);
        let drawing = Drawing { width: WIDTH, left: LEFT, x, x_label: String::new(), panels };
        let drawing = drawing.of_height(500.0);
        assert_eq!(drawing.height(), 500.0);
        assert!((drawing.panels[0].height - 2.0 * drawing.panels[1].height).abs() < 1e-9);
    }
}
