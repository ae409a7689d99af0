//! The velocity and the position errors of a run as an SVG file, for pages that cannot contain the report.

use maud::{Markup, PreEscaped, html};

use crate::drawing::file::{LEGEND, MARGIN, TITLE, file, legend_row, placed};
use crate::drawing::plot::{FINE, WIDTH};
use crate::failure::Failure;
use crate::report::errors::{self, POSITION, Quantity, VELOCITY};
use crate::report::run::Run;

/// The SVG file: velocity left, position right.
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

/// Title and drawing, and the height of the drawing.
fn half(run: &Run, quantity: &Quantity) -> Result<(Markup, f64), Failure> {
    let drawing = errors::drawing(run, quantity);
    let height = drawing.height();
    let title = errors::title(run, quantity);
    let svg = drawing.svg(&title)?;
    let markup = html! {
        text class="title" x="0" y=(0.7 * TITLE * FINE) { (title) }
        (placed(0.0, TITLE, WIDTH, height, &PreEscaped(svg)))
    };
    Ok((markup, height))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::run::tests::made;
    use crate::report::summary::Row;

    #[test]
    fn the_picture_stands_alone() {
        let mut run = made(3000, |_, t| (t / 806.0).sin());
        assert!(!picture(&run).unwrap().contains("of the paper"));
        run.summary.rows.push(Row::made("scene", "simulation2 (built in)", ""));
        run.summary.rows.push(Row::made("scene_text", "The paper's simulation 2", ""));
        let svg = picture(&run).unwrap();
        assert!(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\"") && svg.ends_with("</svg>\n"));
        assert!(svg.contains("figure 4 of the paper") && svg.contains("figure 5 of the paper"));
        assert_eq!(svg.matches("<svg").count(), svg.matches("</svg>").count());
        assert_eq!(svg.matches("http").count(), 1, "nothing from outside");
    }
}
