//! Drawings as separate SVG files, for pages that cannot contain a report.

use maud::{Markup, PreEscaped, html};

use super::document::swatch;
use super::figure::Legend;
use super::plot::FINE;

/// Mark near the beginning of every picture, by which the program recognizes its own pictures.
pub const PICTURE_MARK: &str = "data-generator=\"sins\"";

const STYLE: &str = include_str!("plot.css");

/// Height of the legend, of a title, and the margin around all [drawing units].
pub const LEGEND: f64 = 34.0;
pub const TITLE: f64 = 26.0;
pub const MARGIN: f64 = 10.0;

/// Widths in an entry of the legend: of its line, and of each letter [drawing units].
const SWATCH: f64 = 34.0;
const LETTER: f64 = 7.8;

/// `content` as a complete file, `width` by `height` [drawing units].
pub fn file(width: f64, height: f64, content: &Markup) -> String {
    let view = format!("0 0 {} {}", width * FINE, height * FINE);
    let markup = html! {
        svg xmlns="http://www.w3.org/2000/svg" class="plot" data-generator="sins" viewBox=(view) width=(width) height=(height) {
            style { (PreEscaped(STYLE)) }
            rect class="paper" width="100%" height="100%" {}
            (content)
        }
    };
    markup.into_string() + "\n"
}

/// The entries of `legend` side by side, `top` below the edge [drawing units].
pub fn legend_row(legend: &Legend, top: f64) -> Markup {
    let entries = legend.iter().scan(MARGIN, |next, (pen, text)| {
        let left = *next;
        *next += SWATCH + 22.0 + LETTER * text.chars().count() as f64;
        Some((left, *pen, text))
    });
    html! {
        @for (left, pen, text) in entries {
            (placed(left, top + 10.0, SWATCH, 14.0, &swatch(pen)))
            text x=((left + SWATCH + 6.0) * FINE) y=((top + 22.0) * FINE) { (text) }
        }
    }
}

/// `inside` in a separate box.
pub fn placed(left: f64, top: f64, width: f64, height: f64, inside: &Markup) -> Markup {
    html! {
        svg x=(left * FINE) y=(top * FINE) width=(width * FINE) height=(height * FINE) { (inside) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_style_is_plain_text_of_xml() {
        assert!(!STYLE.contains(['<', '&']), "no letters that XML takes for its own");
    }
}
