//! Drawings as SVG files of their own, for pages that cannot hold the report; one with the velocity and the position errors
//! of a run.

use maud::{Markup, PreEscaped, html};

use crate::errors::{self, POSITION, Quantity, VELOCITY};
use crate::failure::Failure;
use crate::figures::Legend;
use crate::page::swatch;
use crate::plot::{FINE, WIDTH};
use crate::run::Run;

const STYLE: &str = include_str!("plot.css");

/// Height of the legend, of a title, and the margin around all [drawing units].
pub const LEGEND: f64 = 34.0;
pub const TITLE: f64 = 26.0;
pub const MARGIN: f64 = 10.0;

/// Width of an entry of the legend: its line and so much for each letter [drawing units].
const SWATCH: f64 = 34.0;
const LETTER: f64 = 7.8;

/// The file: velocity left, position right.
pub fn picture(run: &Run) -> Result<String, Failure> {
    let [velocity, position] = [&VELOCITY, &POSITION].map(|quantity| half(run, quantity));
    let ((velocity, left_height), (position, right_height)) = (velocity?, position?);
    let width = 2.0 * (WIDTH + MARGIN);
    let height = LEGEND + TITLE + left_height.max(right_height) + MARGIN;
    let content = html! {
        (legend_row(&errors::legend(run, &POSITION), 0.0))
        (placed(MARGIN, LEGEND, WIDTH, left_height + TITLE, &velocity))
        (placed(MARGIN + WIDTH, LEGEND, WIDTH, right_height + TITLE, &position))
    };
    Ok(file(width, height, &content))
}

/// `content` as a file that stands alone, `width` by `height` [drawing units].
pub fn file(width: f64, height: f64, content: &Markup) -> String {
    let view = format!("0 0 {} {}", width * FINE, height * FINE);
    let markup = html! {
        svg xmlns="http://www.w3.org/2000/svg" class="plot" viewBox=(view) width=(width) height=(height) {
            style { (PreEscaped(STYLE)) }
            rect class="paper" width="100%" height="100%" {}
            (content)
        }
    };
    markup.into_string() + "\n"
}

/// Title and drawing, and the height of the drawing.
fn half(run: &Run, quantity: &Quantity) -> Result<(Markup, f64), Failure> {
    let drawing = errors::drawing(run, quantity);
    let height = drawing.height();
    let svg = drawing.svg(quantity.title)?;
    let markup = html! {
        text class="title" x="0" y=(0.7 * TITLE * FINE) { (quantity.title) }
        (placed(0.0, TITLE, WIDTH, height, &PreEscaped(svg)))
    };
    Ok((markup, height))
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

/// `inside` in a box of its own.
pub fn placed(left: f64, top: f64, width: f64, height: f64, inside: &Markup) -> Markup {
    html! {
        svg x=(left * FINE) y=(top * FINE) width=(width * FINE) height=(height * FINE) { (inside) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::tests::made;

    #[test]
    fn the_picture_stands_alone() {
        let svg = picture(&made(3000, |_, t| (t / 806.0).sin())).unwrap();
        assert!(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\"") && svg.ends_with("</svg>\n"));
        assert!(svg.contains("figure 4 of the paper") && svg.contains("figure 5 of the paper"));
        assert_eq!(svg.matches("<svg").count(), svg.matches("</svg>").count());
        assert_eq!(svg.matches("http").count(), 1, "nothing from outside");
        assert!(!STYLE.contains(['<', '&']), "no letters that XML takes for its own");
    }
}
