//! Drawings and pages: `series` → `axis`, `plot` → `svg` → `figure` → `document` (HTML, with `script`), `file` (SVG).

pub mod axis;
pub mod document;
pub mod events;
pub mod figure;
pub mod file;
mod foot;
pub mod pen;
pub mod plot;
mod policy;
pub mod scales;
mod script;
pub mod series;
mod svg;
