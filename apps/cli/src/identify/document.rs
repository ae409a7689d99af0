//! The page: the drift of the record beside that of its twins, the parameters on their priors, what the record has beside them, its Allan
//! deviation, and all figures.

use maud::{Markup, PreEscaped, html};
use sins::analysis::identify::Identified;
use sins::analysis::identify::check::{Check, CheckRequest};
use sins::analysis::identify::sheet::{Line, Sheet, sheets};
use sins::analysis::identify::text::{of_noise, seen};

use super::record::SensorRecord;
use super::residual::Residual;
use super::{check, diagram, table};
use crate::allan::deviations;
use crate::drawing::document as page;
use crate::drawing::figure::Figure;
use crate::drawing::file::{LEGEND, MARGIN, file, legend_row, placed};
use crate::failure::Failure;
use crate::given::Given;
use crate::units::{significant, time_text};

/// What a page shows.
pub struct Shown<'a> {
    pub given: &'a Given,
    pub record: &'a SensorRecord,
    pub found: &'a Identified,
    pub checked: Option<(&'a Check, &'a CheckRequest)>,
    pub residual: Residual,
}

/// The page.
pub fn page(shown: Shown<'_>) -> Result<String, Failure> {
    let Shown { given, record, found, checked, residual } = shown;
    let sheets = sheets(found);
    let drift = checked.map(|(check, request)| drift(check, request)).transpose()?;
    let mut parameters = Vec::new();
    for sheet in &sheets {
        let title = format!("Parameters of the {}s", sheet.section);
        let (drawing, legend) = (diagram::priors(sheet), diagram::legend_of_priors());
        parameters.push(Figure::new(title, "", legend, &drawing, not_seen(sheet))?);
    }
    let fitted_s = checked.map(|_| found.last_s);
    let mut beside = Vec::new();
    for (part, name) in ["gyros", "accelerometers"].into_iter().enumerate() {
        let drawing = diagram::residuals(&residual, part, fitted_s);
        let title = format!("Residual of the {name}");
        let note = "The record less the path and the errors that were found.".to_owned();
        beside.push(Figure::new(title, " over time", diagram::legend_of_residuals(), &drawing, note)?);
    }
    // A record may be too short, or a sensor without noise.
    let (noise, no_noise) = match deviations(&residual.into_log()) {
        Ok(figures) => (figures, None),
        Err(failure) => (Vec::new(), Some(format!("No Allan deviation of the residual: {failure}."))),
    };
    let title = format!("Sensors of {}", record.name);
    let body = html! {
        header {
            h1 { (title) }
            p { (answer(checked, &sheets)) }
            @for line in table::head(given, record, found) { p.source { (line) } }
        }
        main {
            @if let Some(drift) = &drift { div.figures { (page::figure(drift)) } }
            div.figures.bars { @for figure in &parameters { (page::figure(figure)) } }
            div.figures { @for figure in &beside { (page::figure(figure)) } }
            h2 { "Allan deviation of the residual" }
            p {
                "The identification has taken a part of the slow noise, so these curves have less of it than the tables. Errors of the path "
                "are in both."
            }
            @if let Some(reason) = &no_noise { p.remark { (reason) } }
            div.figures { @for figure in &noise { (page::figure(figure)) } }
            div.tables { @for sheet in &sheets { (figures(sheet)) } }
        }
    };
    Ok(page::document(&title, &body))
}

/// The first sentence: whether the prediction holds, or how much the motion shows.
fn answer(checked: Option<(&Check, &CheckRequest)>, sheets: &[Sheet]) -> String {
    match checked {
        Some((check, request)) => {
            let last = check.spans.last().map_or(String::new(), |span| {
                format!(
                    "After {} half of the flights on this record are within {} m, where {} m were predicted: ",
                    time_text(span.duration_s),
                    significant(span.real_m),
                    significant(span.predicted_m)
                )
            });
            format!("{last}{}.", check::verdict(check, &request.truth))
        }
        None => {
            let lines = || sheets.iter().flat_map(Sheet::fitted);
            let count = lines().filter(|line| line.estimate.is_seen()).count();
            format!("The motion shows {count} of the {} errors of these sensors.", lines().count())
        }
    }
}

fn drift(check: &Check, request: &CheckRequest) -> Result<Figure, Failure> {
    let note = format!(
        "Half of the flights are within these distances. {} twins, sensors drawn from what was found, flew the same starts: {}.",
        check.twins,
        check::verdict(check, &request.truth)
    );
    let legend = diagram::legend_of_drifts();
    Figure::new("Does the record keep the prediction?", " by duration", legend, &diagram::drifts(check), note)
}

/// The drifts of a check as an SVG file.
pub fn picture(check: &Check) -> Result<String, Failure> {
    let drawing = diagram::drifts(check);
    let svg = drawing.svg("Distances that half of the flights keep, recorded and predicted, by duration")?;
    let mut first = diagram::legend_of_drifts();
    let second = first.split_off(2);
    let content = html! {
        (legend_row(&first, 0.0))
        (legend_row(&second, LEGEND))
        (placed(MARGIN, 2.0 * LEGEND, drawing.width, drawing.height(), &PreEscaped(svg)))
    };
    Ok(file(drawing.width + 2.0 * MARGIN, 2.0 * LEGEND + drawing.height() + MARGIN, &content))
}

/// What the motion does not show of a triad.
fn not_seen(sheet: &Sheet) -> String {
    let unseen: Vec<&Line> = sheet.fitted().filter(|line| !line.estimate.is_seen()).collect();
    let reasons = unseen.chunk_by(|a, b| a.shown_by == b.shown_by).map(|lines| {
        let names: Vec<&str> = lines.iter().map(|line| line.name.as_str()).collect();
        format!("{} ({} would show it)", names.join(", "), lines[0].shown_by)
    });
    match unseen.is_empty() {
        true => "All are seen.".to_owned(),
        false => format!("Not seen: {}.", reasons.collect::<Vec<_>>().join("; ")),
    }
}

fn figures(sheet: &Sheet) -> Markup {
    let lines = sheet.fitted().map(|line| (&line.name, seen(line)));
    let noises = sheet.noises.iter().map(|line| (&line.name, of_noise(line)));
    let rows = lines.chain(noises).map(|(name, text)| (html! { (name) }, html! { td { (text) } }));
    html! {
        div {
            h3 { (sheet.section) }
            (page::table(Some("list"), Vec::new(), rows))
        }
    }
}
