//! Drawings and pages: `series` → `axis`, `plot` → `figure` → `document` (HTML), `file` (SVG).

pub mod axis;
pub mod document;
pub mod failures;
pub mod figure;
pub mod file;
mod foot;
pub mod pen;
pub mod plot;
pub mod scales;
pub mod series;
