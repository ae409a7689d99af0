//! The curves of all columns, as one SVG file or as a page.

use maud::{Markup, PreEscaped, html};

use super::analysis::Analysis;
use super::{diagram, sheet, table};
use crate::drawing::document as page;
use crate::drawing::figure::Figure;
use crate::drawing::file::{LEGEND, MARGIN, TITLE, file, legend_row, placed};
use crate::drawing::plot::{FINE, WIDTH};
use crate::failure::Failure;
use crate::imu::Log;

/// Largest number of curves side by side in a picture.
const ACROSS: usize = 3;

/// Height of a line of text [drawing units].
const LINE: f64 = 20.0;

/// The picture: curves of gyros above those of accelerometers where there are three of each, coefficients below them.
pub fn picture(log: &Log, analyses: &[Analysis]) -> Result<String, Failure> {
    let across = analyses.len().min(ACROSS);
    let cells = analyses.iter().map(cell).collect::<Result<Vec<_>, _>>()?;
    let height = cells.iter().fold(0.0, |most: f64, (_, height)| most.max(*height));
    let top = TITLE + LEGEND;
    let place = |k: usize| ((k % across) as f64 * (WIDTH + MARGIN), top + (k / across) as f64 * height);
    let content = html! {
        text x=(MARGIN * FINE) y=(0.8 * TITLE * FINE) { (table::source(log)) }
        (legend_row(&diagram::legend(), TITLE))
        @for (k, (cell, _)) in cells.iter().enumerate() {
            (placed(MARGIN + place(k).0, place(k).1, WIDTH, height, cell))
        }
    };
    let rows = analyses.len().div_ceil(across) as f64;
    Ok(file(across as f64 * (WIDTH + MARGIN) + MARGIN, top + rows * height + MARGIN, &content))
}

/// Title, drawing and coefficients, and their height.
fn cell(analysis: &Analysis) -> Result<(Markup, f64), Failure> {
    let drawing = diagram::drawing(analysis);
    let height = drawing.height();
    let svg = drawing.svg(&title(analysis))?;
    let lines: Vec<String> = analysis
        .coefficients
        .iter()
        .map(|coefficient| {
            format!("{}: {}", coefficient.term.letter(), table::on_sheet(analysis, coefficient))
        })
        .collect();
    let below = TITLE + height + 0.8 * LINE;
    let markup = html! {
        text class="title" x="0" y=(0.7 * TITLE * FINE) { (analysis.name) }
        (placed(0.0, TITLE, WIDTH, height, &PreEscaped(svg)))
        @for (k, line) in lines.iter().enumerate() {
            text x="0" y=((below + k as f64 * LINE) * FINE) { (line) }
        }
    };
    Ok((markup, below + lines.len() as f64 * LINE))
}

fn title(analysis: &Analysis) -> String {
    format!("Allan deviation of {}", analysis.name)
}

/// The page: the curves, and the coefficients as tables.
pub fn page(log: &Log, analyses: &[Analysis]) -> Result<String, Failure> {
    let figures = analyses.iter().map(figure).collect::<Result<Vec<_>, _>>()?;
    let body = html! {
        header {
            h1 { "Allan deviation" }
            p { (table::source(log)) }
        }
        main {
            div.figures { @for figure in &figures { (page::figure(figure)) } }
            div.tables { @for analysis in analyses { (coefficients(analysis)) } }
        }
    };
    Ok(page::document(&format!("Allan deviation: {}", log.name), &body))
}

/// The curves of all columns of a log.
pub fn deviations(log: &Log) -> Result<Vec<Figure>, Failure> {
    Analysis::of_log(log)?.iter().map(figure).collect()
}

fn figure(analysis: &Analysis) -> Result<Figure, Failure> {
    let svg = diagram::drawing(analysis).svg(&title(analysis))?;
    let note = table::remark(analysis).unwrap_or_default();
    Ok(Figure { title: analysis.name.clone(), legend: diagram::legend(), drawings: vec![svg], note })
}

fn coefficients(analysis: &Analysis) -> Markup {
    let rows = analysis.coefficients.iter().map(|coefficient| {
        let value = html! {
            td {
                (table::on_sheet(analysis, coefficient))
                @if let Some(density) = table::density(analysis, coefficient) { ", " (density) }
            }
        };
        (html! { (coefficient.term.letter()) ", " (sheet::name(analysis.sensor, coefficient.term)) }, value)
    });
    html! {
        div {
            h3 { (analysis.name) }
            (page::table(Some("list"), Vec::new(), rows))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::analysis::tests::made;
    use super::*;

    #[test]
    fn picture_and_page_stand_alone() {
        let log = made(5000, 0.0);
        let analyses = Analysis::of_log(&log).unwrap();
        let svg = picture(&log, &analyses).unwrap();
        assert!(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\"") && svg.ends_with("</svg>\n"));
        assert_eq!(svg.matches("<svg").count(), svg.matches("</svg>").count());
        let page = page(&log, &analyses).unwrap();
        assert!(page.starts_with("<!DOCTYPE html>") && page.contains("angle random walk"));
        for (text, addresses) in [(&svg, 1), (&page, 0)] {
            assert_eq!(text.matches("://").count(), addresses, "nothing from outside");
            assert!(text.contains("w&lt;x&gt;_rad") && !text.contains("w<x>"));
            for class in ["band", "asymptote", "fit", "computed"] {
                assert!(text.contains(&format!("class=\"{class}\"")), "{class}");
            }
        }
    }
}
