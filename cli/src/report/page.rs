//! The HTML page.

use maud::{Markup, html};

use crate::drawing::document::{document, figure};
use crate::failure::Failure;
use crate::report::comparison::{comparison, list};
use crate::report::figures;
use crate::report::overview;
use crate::report::run::Run;
use crate::units::time_text;

/// The whole page.
pub fn page(runs: &[Run]) -> Result<String, Failure> {
    let title = match runs {
        [run] => format!("Inertial navigation: {}", run.name),
        _ => format!("Inertial navigation: {} runs", runs.len()),
    };
    let sections =
        runs.iter().enumerate().map(|(place, run)| section(place, run)).collect::<Result<Vec<_>, _>>()?;
    let body = html! {
        header {
            h1 { (title) }
            p { "Errors of a simulated strapdown inertial navigation system, compared with its true flight." }
        }
        main {
            (overview::overview(runs))
            @for section in &sections { (section) }
            @if runs.len() > 1 { (comparison(runs)) }
        }
    };
    Ok(document(&title, &body))
}

fn section(place: usize, run: &Run) -> Result<Markup, Failure> {
    let figures = figures::figures(run)?;
    let rows: Vec<_> = run.summary.rows.iter().collect();
    let (flown, measured) = rows.split_at(rows.iter().position(|row| row.is_error()).unwrap_or(rows.len()));
    Ok(html! {
        section.run id={ "run-" (place + 1) } {
            div.intro {
                h2 { (run.name) }
                p { (scene(run)) }
                p.source {
                    "From " code { (run.file) } ", " (run.time_s.len()) " records over "
                    (time_text(run.duration_s())) ", one each " ((run.spacing_s() * 1e4).round() / 1e4) " s."
                }
                @for remark in remarks(run) { p.remark { (remark) } }
            }
            div.figures { @for drawn in &figures { (figure(drawn)) } }
            details {
                summary { "Settings and all figures of this run" }
                div.tables {
                    div { h3 { "Flight, sensors, settings" } (list(flown)) }
                    div { h3 { "Errors and accuracy" } (list(measured)) }
                }
            }
        }
    })
}

/// The flight, the sensors and their failures in one line.
fn scene(run: &Run) -> String {
    let flight = run.summary.value("scene_text").or(run.summary.value("motion")).map(str::to_owned);
    let sensors = overview::sensors(run).map(|text| format!("Sensor errors: {text}"));
    let failures = overview::failures(run).map(|text| format!("Failures: {text}"));
    let sentences = [flight, sensors, failures].into_iter().flatten();
    sentences.map(|text| text.trim_end_matches('.').to_owned() + ". ").collect()
}

/// Remarks that a reader of the figures needs.
fn remarks(run: &Run) -> Vec<String> {
    let mut remarks: Vec<String> =
        run.summary.findings().map(|finding| format!("Flight data: {finding}.")).collect();
    let span = |(from, to): (f64, f64)| format!("between {} and {}", time_text(from), time_text(to));
    if run.model.is_none() && run.is_of_paper() {
        remarks.push("The error differential equations (error data 1) were off.".to_owned());
    }
    if let Some(times) = run.model_invalid_s() {
        remarks.push(format!(
            "The error differential equations were outside their validity {}: misalignment above 2 degrees or displacement above 100 km.",
            span(times)
        ));
    }
    if let Some(times) = run.near_pole_s() {
        remarks.push(format!(
            "Near a pole {}: the up misalignment, and the east and north velocity errors, have no meaning there.",
            span(times)
        ));
    }
    remarks
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::run::tests::made;

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

    /// A row has at most two figures, and no row is half empty.
    #[test]
    fn the_last_of_an_odd_number_of_figures_has_its_row() {
        let html = page(&[made(3, |_, _| 0.0)]).unwrap();
        assert_eq!(html.matches("<figure>").count() % 2, 1);
        assert!(html.contains(".figures > figure:last-child:nth-child(odd) { grid-column: 1 / -1;"));
    }

    #[test]
    fn one_run_has_no_comparison() {
        let html = page(&[made(3, |_, _| 0.0)]).unwrap();
        assert!(
            !html.contains("#comparison") && !html.contains("id=\"comparison\"") && html.contains("1.234 km")
        );
    }

    #[test]
    fn the_runs_come_first_and_the_figures_before_the_settings() {
        let html = page(&[made(3, |_, _| 0.0), made(3, |_, _| 0.0)]).unwrap();
        let order = ["<h1>", "class=\"runs\"", "id=\"run-1\"", "<figure>", "<details>", "id=\"comparison\""];
        let places = order.map(|what| html.find(what).unwrap());
        assert!(places.is_sorted(), "{places:?}");
        assert_eq!(html.matches("<details>").count(), 3);
    }
}
