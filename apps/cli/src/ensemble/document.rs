//! The HTML page of an ensemble.

use maud::{Markup, html};
use sins::ensemble::statistics::Figures;
use sins::scene::ChangedKey;

use super::plan::Data;
use super::study::{QUANTITIES, Quantity, Study};
use super::table::Row;
use super::verdict::{self, Judged};
use super::{bands, ends, radii};
use crate::drawing::document::{document, figure, table};
use crate::failure::Failure;
use crate::planned;
use crate::rows::EAST_NORTH_UP;
use crate::units::{LENGTH, time_text, with_unit};

/// The whole page.
pub fn page(study: &Study, judged: &[Judged]) -> Result<String, Failure> {
    // The picture of the first sentence comes first.
    let mut figures = vec![bands::radial(study)?];
    figures.extend(
        QUANTITIES.iter().map(|quantity| bands::figure(study, quantity)).collect::<Result<Vec<_>, _>>()?,
    );
    figures.insert(2, bands::track(study)?);
    figures.extend(ends::scatter(study)?);
    figures.extend(ends::histogram(study)?);
    let title = format!("Ensemble: {}", study.name);
    let notes = study.given.warnings([]);
    let body = html! {
        header {
            h1 { (title) }
            p.lead { (radii::sentence(study)) }
        }
        main {
            section.run {
                div.intro {
                    p {
                        (study.given.title) ". The same flight many times, each run with its own random errors: " (study.runs()) "."
                        @if !notes.is_empty() { " " a href="#notes" { "Notes on the flight data" } "." }
                    }
                    @for warning in warnings(study) { p.remark { (warning) } }
                    @if !study.results.diverged.is_empty() {
                        p.remark { "Runs that diverged are left out of the statistics from that moment on." }
                    }
                }
                @if !judged.is_empty() { div.table { (verdict::markup(judged)) } }
                div.figures { @for drawn in &figures { (figure(drawn)) } }
                @if !notes.is_empty() {
                    h2 id="notes" { "Notes on the flight data" }
                    @for note in &notes { p.remark { (note) } }
                }
                h2 { "At the end" }
                div.table { (numbers(study)) }
                div.table { (radii(study)) }
                p.source {
                    "Navigation: navigation minus truth. "
                    @if study.end(Data::Model).is_some() { "Model: error differential equations. " }
                    "CEP50 and R95: the radii about the truth within which 50 % and 95 % of the runs are. "
                    "A row of statistics each " (time_text(study.plan.every_s)) "."
                }
                details {
                    summary { "What the scene sets" }
                    (settings(study))
                }
            }
        }
    };
    Ok(document(&title, &body))
}

/// What a reader must know before the curves, beside the notes on the flight data, in sentences.
fn warnings(study: &Study) -> Vec<String> {
    let scene = &study.given.scene;
    let planned = [("Failures", planned::failures(scene)), ("Updates by fixes", planned::updates(scene))];
    let planned = planned.into_iter().filter(|(_, what)| what != "none");
    let planned = planned.map(|(name, what)| format!("{name}: {what}."));
    planned.chain(not_valid(study)).chain(study.beyond_range()).collect()
}

/// When outputs of the unit are invalid in some of the runs that have not diverged, by the rows of the statistics.
fn not_valid(study: &Study) -> Option<String> {
    let rows = study.of(Data::Shown).into_iter().zip(study.of(Data::Navigation));
    // Begin and end [s], and the largest number of such runs.
    let mut stretches: Vec<(f64, f64, u64)> = Vec::new();
    let mut goes_on = false;
    for (shown, solution) in rows {
        let time_s = shown.time_s - study.given.start_s;
        let invalid = solution.good().saturating_sub(shown.good());
        if invalid > 0 {
            match stretches.last_mut().filter(|_| goes_on) {
                Some((_, end_s, most)) => (*end_s, *most) = (time_s, invalid.max(*most)),
                None => stretches.push((time_s, time_s, invalid)),
            }
        }
        goes_on = invalid > 0;
    }
    let told = stretches.iter().map(|(from_s, to_s, most)| {
        let [from, to] = [from_s, to_s].map(|time_s| time_text(*time_s));
        let when = if from == to { format!("at {to}") } else { format!("from {from} to {to}") };
        format!("{when} in up to {most} of {} runs", study.plan.runs)
    });
    let told: Vec<String> = told.collect();
    (!told.is_empty()).then(|| format!("The unit shows invalid outputs {}.", told.join(", ")))
}

/// The last row of each of the error data that is on.
fn ends_by_data<'a>(study: &'a Study) -> Vec<(&'static str, &'a Row)> {
    let sources =
        [(Data::Navigation, "navigation"), (Data::Model, "model"), (Data::Shown, "shown by the unit")];
    let ends = sources.into_iter().filter_map(|(source, name)| Some((name, study.end(source)?)));
    ends.filter(|(_, row)| row.source != Data::Shown || row.good() > 0).collect()
}

/// Mean, sigma and root mean square of each error at the end, by each of the error data that is on.
fn numbers(study: &Study) -> Markup {
    let ends = ends_by_data(study);
    let values = |place: usize, family| {
        let of = move |values: [f64; 9]| with_unit(values[place], family);
        ends.iter().map(move |(_, row)| [row.mean(), row.sigma(), row.rms()].map(of))
    };
    let mut heads = vec!["error".to_owned()];
    heads.extend(
        ends.iter().flat_map(|(name, _)| ["mean", "1σ", "RMS"].map(|what| format!("{what}, {name}"))),
    );
    let axes = QUANTITIES.iter().flat_map(|of| (0..study.axes(of)).map(move |axis| (of, axis)));
    let row = |(of, axis): (&Quantity, usize)| {
        let values = values(of.first + axis, of.family).flatten();
        (
            html! { (of.name) " " (EAST_NORTH_UP[axis]) },
            html! { @for value in values { td.number { (value) } } },
        )
    };
    table(None, heads, axes.map(row))
}

/// Radii at the end.
fn radii(study: &Study) -> Markup {
    let heads = ["horizontal position error", "CEP50", "R95", "largest", "runs"].map(str::to_owned);
    let cells = |figures: &Figures| {
        html! {
            @for size in [figures.cep50_m, figures.r95_m, figures.largest_radial_m] {
                td.number { (with_unit(size, LENGTH)) }
            }
            td.number { (figures.runs) }
        }
    };
    let rows = ends_by_data(study).into_iter().map(|(name, row)| (html! { (name) }, cells(&row.figures)));
    table(None, heads.into(), rows)
}

/// The keys of the scene that are not at their defaults.
fn settings(study: &Study) -> Markup {
    let keys = study.given.scene.changed_keys().into_iter();
    let row = |key: ChangedKey| {
        (html! { code { (key.section) "." (key.name) } }, html! { td { (key.value) " " (key.unit) } })
    };
    table(Some("list"), Vec::new(), keys.map(row))
}
