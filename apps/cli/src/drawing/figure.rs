//! A figure: drawings, the meaning of their lines, and the main numbers.

use super::pen::Pen;
use super::plot::Drawing;
use crate::failure::Failure;

/// Pens and what they draw.
pub type Legend = Vec<(Pen, String)>;

/// Drawings and the text around them.
pub struct Figure {
    pub title: String,
    pub legend: Legend,
    /// Drawings as SVG elements.
    pub drawings: Vec<String>,
    /// Text below the drawings: the main numbers.
    pub note: String,
}

impl Figure {
    /// A figure of one drawing. Its description for readers who cannot see it is title, `axes` (such as " over time") and note.
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
