//! The HTML page.

use maud::{Markup, html};

use crate::drawing::document::{document, figure};
use crate::drawing::figure::Figure;
use crate::failure::Failure;
use crate::report::comparison::{comparison, list};
use crate::report::figures;
use crate::report::overview;
use crate::report::rows;
use crate::report::run::Run;
use crate::report::sentence::{is_rounding, sentence};
use crate::report::unit;
use crate::report::warnings::warnings;
use crate::units::time_text;

/// The whole page: the run that the user named first in a sentence and two figures, all runs as a table, then run by run.
pub fn page(runs: &[Run]) -> Result<String, Failure> {
    let first = &runs[0];
    let title = match runs {
        [run] => run.title().to_owned(),
        _ => format!("Inertial navigation: {} runs", runs.len()),
    };
    let pictures = pictures(first)?;
    let sections = (0..runs.len()).map(|place| section(runs, place)).collect::<Result<Vec<_>, _>>()?;
    let body = html! {
        header {
            h1 { (title) }
            p.lead {
                @if runs.len() > 1 { a href="#run-1" { (first.title()) } ". " }
                (sentence(first))
            }
            @if runs.len() == 1 { p { (sensors(first)) } }
            (remarks(first))
        }
        main {
            div.figures data-run="1" { @for drawn in &pictures { (figure(drawn)) } }
            @if runs.len() > 1 { (overview::overview(runs)) }
            @for section in &sections { (section) }
            @if let [run] = runs { (overview::overview(std::slice::from_ref(run))) }
            @if runs.len() > 1 { (comparison(runs)) }
        }
    };
    Ok(document(&title, &body))
}

/// Trajectory and position errors; of a run without errors the trajectory, and the states of its unit, which otherwise stand below the
/// errors.
fn pictures(run: &Run) -> Result<Vec<Figure>, Failure> {
    let [trajectory, position] = figures::first(run)?;
    let beside = if is_rounding(run) { unit::figure(run)? } else { Some(position) };
    Ok([trajectory].into_iter().chain(beside).collect())
}

fn remarks(run: &Run) -> Markup {
    html! { @for remark in warnings(run) { p.remark { (remark) } } }
}

/// The run at `place`. The pictures of the first one stand at the top of the page.
fn section(runs: &[Run], place: usize) -> Result<Markup, Failure> {
    let run = &runs[place];
    let mut drawn = if place == 0 { Vec::new() } else { pictures(run)? };
    if is_rounding(run) {
        drawn.clear();
    } else {
        drawn.extend(figures::others(run)?);
    }
    drawn.extend(rows::figure(run)?);
    let rows: Vec<_> = run.summary.rows.iter().collect();
    let (flown, measured) = rows.split_at(rows.iter().position(|row| row.is_error()).unwrap_or(rows.len()));
    Ok(html! {
        section.run id={ "run-" (place + 1) } data-run=(place + 1) {
            div.intro {
                @if runs.len() > 1 {
                    h2 { (run.title()) }
                    p {
                        (sentence(run)) " " (sensors(run))
                        @if place == 0 { "Its first figures stand at the top of the page." }
                    }
                    (remarks(run))
                } @else {
                    h2 { "Velocity, attitude, sensors" }
                }
                p.source {
                    (run.name) ", from " code { (run.file) } ": " (run.time_s.len()) " records over "
                    (time_text(run.duration_s())) ", one each " ((run.spacing_s() * 1e4).round() / 1e4) " s."
                }
            }
            div.figures { @for drawn in &drawn { (figure(drawn)) } }
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

fn sensors(run: &Run) -> String {
    let text = overview::sensors(run).map(|text| text.trim_end_matches('.').to_owned());
    text.map_or(String::new(), |text| format!("Sensor errors: {text}. "))
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
        for outside in ["://", "<script src", "<link", "url(", "@import"] {
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
    fn the_run_that_was_named_first_opens_the_page() {
        let runs = [made(3, |_, t| t), made(3, |_, _| 0.0), made(3, |_, t| 5.0 * t)];
        let html = page(&runs).unwrap();
        let order = [
            "<h1>",
            "<a href=\"#run-1\">",
            "After 20 s the INS is 28.28 m off",
            "<div class=\"figures\" data-run=\"1\"><figure><h3>Trajectory",
            "<h3>Position errors",
            "class=\"runs\"",
            "id=\"run-1\"",
            "<h3>Velocity errors",
            "<details>",
            "id=\"run-2\"",
            "no error beyond rounding",
            "id=\"run-3\"",
            "<h3>Trajectory",
            "id=\"comparison\"",
        ];
        let mut rest = html.as_str();
        for what in order {
            let (_, behind) = rest.split_once(what).unwrap_or_else(|| panic!("{what}"));
            rest = behind;
        }
        let (_, ideal) = html.split_once("id=\"run-2\"").unwrap();
        let (ideal, _) = ideal.split_once("id=\"run-3\"").unwrap();
        assert!(!ideal.contains("<figure>"), "no figure of a run without errors");
        assert_eq!(html.matches("<details>").count(), 4);
    }

    #[test]
    fn remarks_stand_above_the_curves() {
        let mut run = made(3, |_, t| t);
        run.summary.rows.push(crate::report::summary::Row::made("inconsistent_samples", "8", ""));
        let html = page(std::slice::from_ref(&run)).unwrap();
        let (above, _) = html.split_once("<figure>").unwrap();
        assert!(above.contains("<p class=\"remark\">In 8 samples of the truth"));
        let html = page(&[made(3, |_, t| 2.0 * t), run]).unwrap();
        let (_, section) = html.split_once("id=\"run-2\"").unwrap();
        let (above, _) = section.split_once("<figure>").unwrap();
        assert!(above.contains("<p class=\"remark\">In 8 samples of the truth"));
    }

    #[test]
    fn the_order_of_runs_is_that_of_the_user() {
        let html = page(&[made(3, |_, t| t), made(3, |_, t| 2.0 * t)]).unwrap();
        let order = ["class=\"runs\"", "href=\"#run-1\"", "href=\"#run-2\"", "id=\"run-1\""];
        let (_, mut rest) = html.split_once("</header>").unwrap();
        for what in order {
            (_, rest) = rest.split_once(what).unwrap_or_else(|| panic!("{what}"));
        }
    }
}
