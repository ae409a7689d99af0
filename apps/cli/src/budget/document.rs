//! The charts as SVG files, and all of them as a page with their tables.

use maud::{Markup, PreEscaped, html};
use sins::analysis::recommend::SolutionError;

use super::chart::QUANTITIES;
use super::survey::{BudgetLine, Survey};
use super::{chart, table};
use crate::drawing::document as page;
use crate::drawing::figure::Figure;
use crate::drawing::file::{LEGEND, MARGIN, TITLE, file, legend_row, placed};
use crate::drawing::plot::FINE;
use crate::failure::Failure;
use crate::units::short;

/// The chart of a scene as a file: position, velocity and attitude side by side.
pub fn picture(survey: &Survey) -> Result<String, Failure> {
    let top = TITLE + LEGEND;
    let (mut right, mut bottom, mut panels) = (MARGIN, top, String::new());
    for (part, quantity) in QUANTITIES.iter().enumerate() {
        let drawing = chart::drawing(survey, part, part == 0);
        let svg = PreEscaped(drawing.svg(quantity)?);
        panels += &placed(right, top, drawing.width, drawing.height(), &svg).into_string();
        right += drawing.width;
        bottom = top + drawing.height();
    }
    let content = html! {
        text class="title" x=(MARGIN * FINE) y=(0.8 * TITLE * FINE) { (title(survey)) }
        (legend_row(&chart::legend(survey), TITLE))
        (PreEscaped(panels))
    };
    Ok(file(right + MARGIN, bottom + MARGIN, &content))
}

fn title(survey: &Survey) -> String {
    format!("{}: {}", survey.name, survey.title)
}

/// The page with the charts and tables of all scenes.
pub fn page(surveys: &[Survey]) -> Result<String, Failure> {
    let sections = surveys.iter().map(section).collect::<Result<Vec<_>, _>>()?;
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
            @for section in &sections { (section) }
        }
    };
    Ok(page::document("Error budget", &body))
}

fn section(survey: &Survey) -> Result<Markup, Failure> {
    let drawn = (0..QUANTITIES.len()).map(|part| figure(survey, part)).collect::<Result<Vec<_>, _>>()?;
    Ok(html! {
        section data-run=(survey.name) {
            h2 { (survey.name) }
            p { (survey.title) "." }
            @for warning in &survey.warnings { p.remark { (warning) } }
            div.figures.bars { @for drawn in &drawn { (page::figure(drawn)) } }
            p.source { (table::remark(survey)) }
            div.table { (figures(survey)) }
        }
    })
}

/// The bars of part `part` of the errors.
fn figure(survey: &Survey, part: usize) -> Result<Figure, Failure> {
    let unit = table::Columns::of(survey).units[part];
    let value = |error: &SolutionError| format!("{} {}", short(error.parts()[part] / unit.si), unit.name);
    let note = format!(
        "All together {}; the root sum of squares of the effects is {}.",
        value(&survey.budget.total),
        value(&survey.root_sum_of_squares())
    );
    let title = format!("Effects on the {}", QUANTITIES[part]);
    Figure::new(title, "", chart::legend(survey), &chart::drawing(survey, part, true), note)
}

fn figures(survey: &Survey) -> Markup {
    let columns = table::Columns::of(survey);
    let heads = columns.heads().into_iter().filter(|head| !head.is_empty()).collect();
    let row = |line: BudgetLine| {
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
    use super::super::survey::tests::made;
    use super::*;

    #[test]
    fn picture_and_page_stand_alone() {
        let surveys = [made()];
        let (svg, page) = (picture(&surveys[0]).unwrap(), page(&surveys).unwrap());
        assert!(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\"") && svg.ends_with("</svg>\n"));
        assert!(page.starts_with("<!DOCTYPE html>") && page.contains("<code>gyro.bias_sigma_deg_h</code>"));
        assert!(!page.contains("rad_s"), "keys of a scene, not fields of the interface");
        for (text, addresses) in [(&svg, 1), (&page, 0)] {
            assert_eq!(text.matches("://").count(), addresses, "nothing from outside");
            assert!(text.contains("a&lt;b") && !text.contains("a<b") && text.contains("made &amp; flown"));
            for class in ["deterministic", "pale-random", "own", "together", "limit", "note value"] {
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
        assert!(!page(&[survey]).unwrap().contains("[ns]"));
    }

    /// Chart and table have the same units.
    #[test]
    fn a_budget_has_one_unit() {
        let page = page(&[made()]).unwrap();
        assert_eq!(page.matches("position [km]").count(), 2, "bars and table");
        assert_eq!(page.matches("position [m]").count(), 0);
        // The bias, the root sum of squares and all together are 1.2 km and 1.2 m/s, at the bars and in the table.
        assert_eq!(page.matches(">1.2<").count(), 3 * 2 * 2);
    }

    /// The line of the limit is drawn first, and the labels over it have a halo.
    #[test]
    fn a_limit_does_not_strike_its_labels_through() {
        let svg = picture(&made()).unwrap();
        let (limit, label) = (svg.find("<path class=\"limit\""), svg.find("class=\"note value\""));
        assert!(limit.is_some() && limit < label);
        let rule = svg.split(".plot text {").nth(1).and_then(|rest| rest.split('}').next()).unwrap();
        assert!(rule.contains("paint-order: stroke") && rule.contains("stroke: var(--halo)"), "{rule}");
    }

    #[test]
    fn the_table_has_a_line_for_each_effect_and_four_more() {
        let tables = table::tables(&[made()]);
        let lines: Vec<&str> = tables.lines().filter(|line| line.starts_with("| ")).collect();
        assert_eq!(lines.len(), 1 + 2 + 4);
        assert_eq!(lines[0], "| effect |  | position [km] | velocity [m/s] | attitude [rad] | a step [ns] |");
        assert_eq!(lines[1], "| gyro bias |  | 1.2 | 1.2 | 0 | 30 |");
        assert_eq!(lines[2], "| gyro turn-on bias | 1σ, can be left out | 5.0×10⁻⁴ | 5.0×10⁻⁴ | 0 | 10 |");
        assert!(tables.contains("is 0.74 to 1.52 times") && tables.contains("change by 500 mm"), "{tables}");
    }
}
