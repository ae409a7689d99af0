//! A figure: drawings, what their lines are, and what they say.

use super::pen::Pen;
use super::plot::Drawing;
use crate::failure::Failure;

/// Pens and what they draw.
pub type Legend = Vec<(Pen, String)>;

/// Drawings and the words around them.
pub struct Figure {
    pub title: String,
    pub legend: Legend,
    /// As SVG elements.
    pub drawings: Vec<String>,
    /// Below the drawings: what it says in numbers.
    pub note: String,
}

impl Figure {
    /// With one drawing, which readers who do not see it know as `title``axes`, and by the note: `axes` says what is over what,
    /// " over time".
    pub fn new(
        title: impl Into<String>,
        axes: &str,
        legend: Legend,
        drawing: &Drawing,
        note: String,
    ) -> Result<Self, Failure> {
        let title = title.into();
        let svg = drawing.svg(&format!("{title}{axes}. {note}"))?;
        Ok(Self { title, legend, drawings: vec![svg], note })
    }
}
