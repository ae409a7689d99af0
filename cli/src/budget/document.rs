//! The charts as SVG files, and all of them as a page with their tables.

use maud::{Markup, html};

use super::chart::Layout;
use super::survey::{Line, Survey};
use super::{chart, table};
use crate::drawing::document as page;
use crate::drawing::figure::Figure;
use crate::drawing::file::{LEGEND, MARGIN, TITLE, file, legend_row, placed};
use crate::drawing::plot::FINE;

/// The chart of a scene as a file.
pub fn picture(survey: &Survey) -> String {
    let (top, (width, height)) = (TITLE + LEGEND, Layout::Row.size(survey));
    let content = html! {
        text class="title" x=(MARGIN * FINE) y=(0.8 * TITLE * FINE) { (title(survey)) }
        (legend_row(&chart::legend(survey), TITLE))
        (placed(MARGIN, top, width, height, &chart::chart(survey, Layout::Row)))
    };
    file(width + 2.0 * MARGIN, top + height + MARGIN, &content)
}

fn title(survey: &Survey) -> String {
    format!("{}: {}", survey.name, survey.title)
}

/// The page with the charts and tables of all scenes.
pub fn page(surveys: &[Survey]) -> String {
    let body = html! {
        header {
            h1 { "Error budget" }
            p {
                "What each effect contributes to the errors of a scene: the error with this effect alone, less the error with no effect; "
                "the largest in the flight."
                @if surveys.iter().any(|survey| survey.costs.is_some()) { " Times of a step are uncertain by 1 to 5 %." }
            }
        }
        main {
            @for survey in surveys {
                section {
                    h2 { (survey.name) }
                    p { (survey.title) "." }
                    @for finding in &survey.findings { p.remark { "Flight data: " (finding) "." } }
                    div.figures.wide { (page::figure(&figure(survey))) }
                    div.table { (figures(survey)) }
                }
            }
        }
    };
    page::document("Error budget", &body)
}

fn figure(survey: &Survey) -> Figure {
    let alt = format!("Error budget. {}", title(survey));
    // The style sheet shows one of them, by the width of the page.
    let drawings = [("plot broad", Layout::Row), ("plot narrow", Layout::Column)].map(|(class, layout)| {
        let (width, height) = layout.size(survey);
        let view = format!("0 0 {} {}", width * FINE, height * FINE);
        let chart = chart::chart(survey, layout);
        html! { svg class=(class) role="img" aria-label=(alt) viewBox=(view) { (chart) } }.into_string()
    });
    Figure {
        title: "Which effects matter".to_owned(),
        legend: chart::legend(survey),
        drawings: drawings.into(),
        note: table::remark(survey),
    }
}

fn figures(survey: &Survey) -> Markup {
    let columns = table::Columns::of(survey);
    let heads = columns.heads().into_iter().filter(|head| !head.is_empty()).collect();
    let row = |line: Line| {
        let kind = table::kind(&line);
        let name = html! {
            (line.name) @if !kind.is_empty() { " (" (kind) ")" }
            @if !line.key.is_empty() { br; code { (line.key) } }
        };
        (name, html! { @for cell in columns.cells(&line) { td { (cell) } } })
    };
    page::table(Some("effects"), heads, survey.lines().into_iter().map(row))
}

#[cfg(test)]
mod tests {
    use sins::analysis::budget::{Budget, BudgetRequest, BudgetRow, Costs, EFFECTS, SigmaInterval};
    use sins::analysis::recommend::SolutionError;

    use super::*;

    fn error(position_m: f64) -> SolutionError {
        SolutionError { position_m, velocity_m_s: 1e-3 * position_m, attitude_rad: 0.0 }
    }

    fn made() -> Survey {
        let row = |field: &str, position_m: f64, can_be_left_out| BudgetRow {
            effect: EFFECTS.iter().find(|effect| effect.field == field).unwrap(),
            worst: error(position_m),
            end: error(position_m),
            share: position_m,
            can_be_left_out,
        };
        Survey {
            name: "a<b".into(),
            title: "made & flown".into(),
            request: BudgetRequest { limits: error(1.0), ..Default::default() },
            budget: Budget {
                span_s: 600.0,
                own: (error(1e-7), error(1e-8)),
                rows: vec![row("gyro.bias_rad_s", 1234.0, false), row("gyro.bias_sigma_rad_s", 0.5, true)],
                total: error(1234.1),
                remainder: error(0.0),
                left_out: error(0.5),
                runs: 16,
                interval: SigmaInterval::of(16),
                flights: 51,
            },
            costs: Some(Costs { own_ns: 600.0, total_ns: 640.0, saved_ns: vec![30.0, 10.4] }),
            findings: Vec::new(),
        }
    }

    #[test]
    fn picture_and_page_stand_alone() {
        let surveys = [made()];
        let (svg, page) = (picture(&surveys[0]), page(&surveys));
        assert!(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\"") && svg.ends_with("</svg>\n"));
        assert!(page.starts_with("<!DOCTYPE html>") && page.contains("<code>gyro.bias_sigma_deg_h</code>"));
        assert!(!page.contains("rad_s"), "keys of a scene, not fields of the interface");
        for (text, addresses) in [(&svg, 1), (&page, 0)] {
            assert_eq!(text.matches("http").count(), addresses, "nothing from outside");
            assert!(text.contains("a&lt;b") && !text.contains("a<b") && text.contains("made &amp; flown"));
            for class in ["deterministic", "random left-out", "own", "together", "limit", "label left-out"] {
                assert!(text.contains(&format!("class=\"{class}\"")), "{class}");
            }
        }
    }

    /// Clocks are noisy: the measured cost of an effect may be negative.
    #[test]
    fn a_cost_that_the_clock_cannot_tell_is_below_noise() {
        let mut survey = made();
        survey.costs.as_mut().unwrap().saved_ns = vec![-12.0, 6.3];
        let tables = table::tables(&[survey]);
        assert_eq!(tables.matches("| below noise |").count(), 2, "{tables}");
        assert!(!tables.contains("-12"));
    }

    #[test]
    fn without_times_there_is_no_column_of_times() {
        let survey = Survey { costs: None, ..made() };
        let tables = table::tables(std::slice::from_ref(&survey));
        assert!(tables.contains("| attitude [rad] |\n|---|---|---|---|---|\n"), "{tables}");
        assert!(!page(&[survey]).contains("[ns]"));
    }

    /// Chart and table have the same units.
    #[test]
    fn a_budget_has_one_unit() {
        let page = page(&[made()]);
        assert_eq!(page.matches("position [km]").count(), 3, "two layouts and the table");
        assert_eq!(page.matches("position [m]").count(), 0);
        // The bias and all together are 1.2 km and 1.2 m/s, in both layouts and in the table.
        assert_eq!(page.matches(">1.2<").count(), 3 * 2 * 2);
    }

    /// The line of the limit is drawn first, and the labels over it have a halo.
    #[test]
    fn a_limit_does_not_strike_its_labels_through() {
        let svg = picture(&made());
        let (limit, label) = (svg.find("<line class=\"limit\""), svg.find("class=\"value\""));
        assert!(limit.is_some() && limit < label);
        let rule = svg.split(".plot text {").nth(1).and_then(|rest| rest.split('}').next()).unwrap();
        assert!(rule.contains("paint-order: stroke") && rule.contains("stroke: var(--halo)"), "{rule}");
    }

    #[test]
    fn the_table_has_a_line_for_each_effect_and_three_more() {
        let tables = table::tables(&[made()]);
        let lines: Vec<&str> = tables.lines().filter(|line| line.starts_with("| ")).collect();
        assert_eq!(lines.len(), 1 + 2 + 3);
        assert_eq!(lines[0], "| effect |  | position [km] | velocity [m/s] | attitude [rad] | a step [ns] |");
        assert_eq!(lines[1], "| gyro bias |  | 1.2 | 1.2 | 0 | 30 |");
        assert_eq!(lines[2], "| gyro turn-on bias | 1σ, can be left out | 5.0×10⁻⁴ | 5.0×10⁻⁴ | 0 | 10 |");
        assert!(tables.contains("is 0.74 to 1.52 times") && tables.contains("change by 500 mm"), "{tables}");
    }
}
