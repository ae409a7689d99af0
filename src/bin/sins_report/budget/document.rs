//! The charts as SVG files, and all of them as a page with their tables.

use maud::{Markup, html};

use super::survey::Survey;
use super::{chart, table};
use crate::figures::Figure;
use crate::page;
use crate::picture::{LEGEND, MARGIN, TITLE, file, legend_row, placed};
use crate::plot::FINE;

/// The chart of a scene as a file.
pub fn picture(survey: &Survey) -> String {
    let (top, height) = (TITLE + LEGEND, chart::height(survey));
    let content = html! {
        text class="title" x=(MARGIN * FINE) y=(0.8 * TITLE * FINE) { (title(survey)) }
        (legend_row(&chart::legend(survey), TITLE))
        (placed(MARGIN, top, chart::WIDTH, height, &chart::chart(survey)))
    };
    file(chart::WIDTH + 2.0 * MARGIN, top + height + MARGIN, &content)
}

fn title(survey: &Survey) -> String {
    format!("{}: {}", survey.name, survey.title)
}

/// The page.
pub fn page(surveys: &[Survey]) -> String {
    let body = html! {
        header {
            h1 { "Error budget" }
            p { "What each effect contributes to the errors of a scene, all others off: the largest on the way." }
        }
        main {
            @for survey in surveys {
                section {
                    h2 { (survey.name) }
                    p { (survey.title) "." }
                    div.figures.wide { (page::figure(&figure(survey))) }
                    div.table { (figures(survey)) }
                }
            }
        }
    };
    page::document("Error budget", &body)
}

fn figure(survey: &Survey) -> Figure {
    let view = format!("0 0 {} {}", chart::WIDTH * FINE, chart::height(survey) * FINE);
    let alt = format!("Error budget. {}", title(survey));
    let drawing = html! {
        svg class="plot" role="img" aria-label=(alt) viewBox=(view) { (chart::chart(survey)) }
    };
    Figure {
        title: "Which effects matter".to_owned(),
        legend: chart::legend(survey),
        drawings: vec![drawing.into_string()],
        note: table::remark(survey),
    }
}

fn figures(survey: &Survey) -> Markup {
    html! {
        table {
            thead {
                tr {
                    @for name in ["effect", "", "position", "velocity", "attitude", "ns a step", "field"] {
                        th scope="col" { (name) }
                    }
                }
            }
            tbody {
                @for line in survey.lines() {
                    tr {
                        th scope="row" { (line.name) }
                        td { (table::kind(&line)) }
                        @for cell in table::cells(&line) { td.number { (cell) } }
                        td.number { @if let Some(cost) = line.cost_ns { (format!("{cost:.0}")) } }
                        td { code { (line.field) } }
                    }
                }
            }
        }
    }
}
