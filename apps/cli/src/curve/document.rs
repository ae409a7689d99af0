//! The page: the diagrams of all scenes, and the cheapest configurations as a table.

use maud::{Markup, html};

use super::survey::Survey;
use super::{diagram, table};
use crate::drawing::document as page;
use crate::drawing::figure::Figure;
use crate::failure::Failure;
use crate::units::time_text;

/// Width of a drawing on the page [drawing units]; a phone shows it at six tenths.
const WIDTH: f64 = 640.0;

pub fn page(surveys: &[Survey]) -> Result<String, Failure> {
    let figures = surveys.iter().map(figure).collect::<Result<Vec<_>, _>>()?;
    let body = html! {
        header {
            h1 { "What accuracy costs" }
            p {
                "Computing time and error of each scheme, number of subsamples, sample rate and choice of axes, without sensor errors."
            }
            @for survey in surveys {
                @for warning in &survey.warnings { p.remark { (survey.name) ": " (warning) } }
            }
        }
        main {
            div.figures { @for drawn in &figures { (page::figure(drawn)) } }
            h2 { "The cheapest configuration for each accuracy" }
            div.table tabindex="0" { (cheapest(surveys)) }
        }
    };
    Ok(page::document("What accuracy costs", &body))
}

fn figure(survey: &Survey) -> Result<Figure, Failure> {
    let title = format!("{}: {}, {}", survey.name, survey.title, time_text(survey.duration_s));
    let note = diagram::HOW_TO_READ.join(" ");
    let legend = diagram::legends(survey).into_iter().flatten().collect();
    Figure::new(title, "", legend, &diagram::drawing(survey, WIDTH), note)
}

fn cheapest(surveys: &[Survey]) -> Markup {
    let row = |survey: &Survey| {
        let [name, cells @ ..] = table::cells(survey);
        (html! { (name) }, html! { @for cell in cells { td { (cell) } } })
    };
    page::table(None, table::HEADS.map(str::to_owned).into(), surveys.iter().map(row))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::front::{self, tests::made};

    #[test]
    fn the_page_stands_alone_and_every_point_has_its_words() {
        let mut points = vec![made(0, 5e3, 20.0), made(3, 8e3, 0.4), made(13, 9e3, 2e-4)];
        front::mark(&mut points);
        let mut survey = Survey::made("a<b", 3600.0, points, [1e3, 1e5]);
        survey.warnings.push("Flight data: <odd>.".to_owned());
        let page = page(&[survey]).unwrap();
        assert!(page.starts_with("<!DOCTYPE html>") && !page.contains("://"));
        assert!(page.contains("a&lt;b: Flight data: &lt;odd&gt;.") && !page.contains("a<b"));
        assert_eq!(page.matches("<title>").count(), 1 + 3);
        for words in
            ["<title>exact 2 @ 50 Hz: 400 mm, 8.0 µs a second</title>", "data-x=\"0.4\" data-y=\"8\""]
        {
            assert!(page.contains(words), "{words}");
        }
    }
}
