//! A figure: drawings, what their lines are, and what they say.

use crate::drawing::pen::Pen;

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
