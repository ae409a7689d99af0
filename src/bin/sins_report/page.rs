//! The HTML page.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::failure::Failure;
use crate::figures::{self, Figure};
use crate::pen::Pen;
use crate::run::Run;
use crate::summary::Row;
use crate::units::{significant, time_text};

const STYLE: &str = include_str!("page.css");

/// The whole page.
pub fn page(runs: &[Run]) -> Result<String, Failure> {
    let names = runs.iter().map(|run| run.name.as_str()).collect::<Vec<_>>().join(", ");
    let title = match runs {
        [run] => format!("Inertial navigation: {}", run.name),
        _ => format!("Inertial navigation: {} runs", runs.len()),
    };
    let sections =
        runs.iter().enumerate().map(|(place, run)| section(place, run)).collect::<Result<Vec<_>, _>>()?;
    let markup = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                header { h1 { "Inertial navigation runs" } p { (names) } }
                main {
                    @if runs.len() > 1 { (contents(runs)) (comparison(runs)) }
                    @for section in &sections { (section) }
                }
                footer { p { "Written by sins_report " (env!("CARGO_PKG_VERSION")) "." } }
            }
        }
    };
    Ok(markup.into_string())
}

fn contents(runs: &[Run]) -> Markup {
    html! {
        nav aria-label="Contents" {
            h2 { "Contents" }
            ol {
                li { a href="#comparison" { "The runs compared" } }
                @for (place, run) in runs.iter().enumerate() {
                    li { a href={ "#run-" (place + 1) } { (run.name) } }
                }
            }
        }
    }
}

/// Every row in which the runs differ, a column for each run; then those that are the same in all.
fn comparison(runs: &[Run]) -> Markup {
    let mut rows: Vec<&Row> = Vec::new();
    for row in runs.iter().flat_map(|run| &run.summary.rows) {
        if row.key != "name" && !rows.iter().any(|known| known.key == row.key) {
            rows.push(row);
        }
    }
    let (same, different): (Vec<_>, Vec<_>) = rows
        .into_iter()
        .partition(|row| runs.iter().all(|run| run.summary.value(&row.key) == Some(row.value.as_str())));
    html! {
        section id="comparison" {
            h2 { "The runs compared" }
            div.table tabindex="0" {
                table.comparison {
                    thead {
                        tr { th scope="col" { "Quantity" } @for run in runs { th scope="col" { (run.name) } } }
                    }
                    tbody {
                        @for row in different {
                            tr {
                                th scope="row" { (row.title()) }
                                @for run in runs { (cell(run.summary.row(&row.key))) }
                            }
                        }
                    }
                }
            }
            @if !same.is_empty() {
                h3 { "The same in all runs" }
                (list(&same))
            }
        }
    }
}

fn cell(row: Option<&Row>) -> Markup {
    match row {
        Some(row) if row.value.parse::<f64>().is_ok() => {
            html! { td.number title=(row.value) { (row.text()) } }
        }
        Some(row) => html! { td { (row.text()) } },
        None => html! { td { "–" } },
    }
}

/// Label and value of each row.
fn list(rows: &[&Row]) -> Markup {
    html! {
        table.list {
            tbody {
                @for row in rows {
                    tr { th scope="row" { (row.title()) } (cell(Some(row))) }
                }
            }
        }
    }
}

fn section(place: usize, run: &Run) -> Result<Markup, Failure> {
    let figures = figures::figures(run)?;
    let rows: Vec<_> = run.summary.rows.iter().collect();
    let (flown, measured) = rows.split_at(rows.iter().position(|row| row.is_error()).unwrap_or(rows.len()));
    Ok(html! {
        section.run id={ "run-" (place + 1) } {
            h2 { (run.name) }
            p.source {
                "From " code { (run.file) } ", " (run.time_s.len()) " records over " (time_text(run.duration_s()))
                ", one each " (significant(run.spacing_s())) " s."
            }
            div.tables {
                div { h3 { "Flight, sensors, settings" } (list(flown)) }
                div { h3 { "Errors and accuracy" } (list(measured)) }
            }
            @for remark in remarks(run, &figures) { p.remark { (remark) } }
            div.figures { @for figure in &figures { (self::figure(figure)) } }
        }
    })
}

/// What a reader of the figures has to know.
fn remarks(run: &Run, figures: &[Figure]) -> Vec<String> {
    let mut remarks = Vec::new();
    let span = |(from, to): (f64, f64)| format!("between {} and {}", time_text(from), time_text(to));
    if run.model.is_none() {
        remarks.push("The error differential equations (error data 1) were off.".to_owned());
    }
    if let Some(times) = run.model_invalid_s() {
        remarks.push(format!(
            "Error data 1 was outside its validity {}: misalignment above 2 degrees or displacement above 100 km.",
            span(times)
        ));
    }
    if let Some(times) = run.near_pole_s() {
        remarks.push(format!(
            "Near a pole {}: up misalignment, and east and north of the velocity, have lost their meaning there.",
            span(times)
        ));
    }
    for (sensor, errors) in [("gyros", "Gyro errors"), ("accelerometers", "Accelerometer errors")] {
        if !figures.iter().any(|figure| figure.title == errors) {
            remarks.push(format!("The {sensor} had no errors: all records are zero."));
        }
    }
    remarks
}

fn figure(figure: &Figure) -> Markup {
    html! {
        figure {
            h3 { (figure.title) }
            ul.legend {
                @for (pen, text) in &figure.legend { li { (swatch(*pen)) span { (text) } } }
            }
            @for drawing in &figure.drawings { (PreEscaped(drawing)) }
            figcaption { (figure.note) }
        }
    }
}

fn swatch(pen: Pen) -> Markup {
    html! {
        svg.swatch aria-hidden="true" viewBox="0 0 340 140" {
            @if pen == Pen::Start {
                circle class=(pen.class()) cx="170" cy="70" r="60" {}
            } @else {
                line class=(pen.class()) x1="0" y1="70" x2="340" y2="70" {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::tests::made;

    #[test]
    fn text_from_files_is_escaped() {
        let html = page(&[made(3, |_, _| 0.0), made(3, |_, _| 0.0)]).unwrap();
        assert!(html.contains("&lt;made&gt; &amp; &quot;quoted&quot;") && !html.contains("<made>"));
    }

    #[test]
    fn the_page_needs_nothing_from_outside() {
        let html = page(&[made(3000, |_, t| (t / 806.0).sin() * 1e-5)]).unwrap();
        assert!(html.starts_with("<!DOCTYPE html><html lang=\"en\">"));
        for outside in ["http", "<script", "<link", "url(", "@import"] {
            assert!(!html.contains(outside), "{outside}");
        }
        let drawings = html.matches("class=\"plot\"").count();
        assert_eq!(html.matches("role=\"img\" aria-label=\"").count(), drawings);
        assert_eq!(html.matches("<figure>").count() + 1, drawings, "two in the trajectory's figure");
    }

    #[test]
    fn one_run_has_no_contents() {
        let html = page(&[made(3, |_, _| 0.0)]).unwrap();
        assert!(!html.contains("<nav") && !html.contains("id=\"comparison\"") && html.contains("1.234 km"));
    }
}
