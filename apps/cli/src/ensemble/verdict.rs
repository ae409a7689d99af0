//! The verdicts on the requirements: for the terminal, the page and a file.

use maud::{Markup, html};
use sins::ensemble::statistics::{Decision, Verdict};

use super::plan::Due;
use super::study::Study;
use crate::drawing::document::table;
use crate::failure::{Failure, Kind};
use crate::rows::{self, number};
use crate::units::{time_text, with_unit};

/// Columns of the file of verdicts.
pub const COLUMNS: [&str; 11] = [
    "quantity",
    "percent",
    "time_s",
    "limit_si",
    "runs",
    "inside",
    "fraction_low",
    "fraction_high",
    "verdict",
    "more_runs",
    "source",
];

/// A requirement with its verdict.
pub struct Judged<'a> {
    pub due: &'a Due,
    pub verdict: Verdict,
}

/// The verdicts on the requirements of a study, in their order.
pub fn verdicts<'a>(study: &Study<'a>) -> Result<Vec<Judged<'a>>, Failure> {
    let judged = study.plan.requirements.iter().zip(&study.results.inside).map(|(due, inside)| {
        let verdict = Verdict::new(study.plan.runs, *inside, 0, due.requirement.percent)?;
        Ok(Judged { due, verdict })
    });
    judged.collect()
}

impl Judged<'_> {
    fn decision(&self) -> &'static str {
        match self.verdict.decision {
            Decision::Met => "met",
            Decision::NotMet => "not met",
            Decision::Undecided => "undecided",
        }
    }

    /// What is required: "position_horizontal: 95 % within 22.22 km at 6 h".
    fn required(&self) -> String {
        let Due { requirement, time_s, limit, grows_from_s, .. } = self.due;
        let limit = with_unit(*limit, requirement.family);
        let (quantity, percent) = (requirement.quantity, requirement.percent);
        let nav_s = grows_from_s.filter(|from_s| *from_s > 0.0);
        let since =
            nav_s.map_or(String::new(), |nav_s| format!(", which grows from NAV at {} on", time_text(nav_s)));
        format!("{quantity}: {percent} % of the flights within {limit} after {}{since}", time_text(*time_s))
    }

    /// What was found: the fraction of the runs with its interval.
    fn found(&self) -> String {
        let Verdict { runs, inside, low, high, .. } = self.verdict;
        let [fraction, low, high] =
            [inside as f64 / runs as f64, low, high].map(|one| format!("{:.1}", 100.0 * one));
        format!("{inside} of {runs} runs, {fraction} % ({low} to {high} %)")
    }

    /// The decision, and how many runs would decide.
    fn answer(&self) -> String {
        let more = match self.verdict.more_runs {
            Some(0) => return self.decision().to_owned(),
            Some(more) => format!("{more} more runs would decide at this fraction"),
            None => "the fraction is the required one".to_owned(),
        };
        format!("{}: {more}", self.decision())
    }
}

/// Lines for the terminal.
pub fn text(judged: &[Judged]) -> String {
    let line = |one: &Judged| format!("  {}\n    {}: {}\n", one.required(), one.found(), one.answer());
    judged.iter().map(line).collect()
}

/// A table for the page.
pub fn markup(judged: &[Judged]) -> Markup {
    let heads = ["requirement", "runs within the limit", "verdict", "source"].map(str::to_owned);
    let cells = |one: &Judged| {
        let source = &one.due.requirement.source;
        html! { td { (one.found()) } td { (one.answer()) } td { (source) } }
    };
    table(Some("list"), heads.into(), judged.iter().map(|one| (html! { (one.required()) }, cells(one))))
}

/// The file of verdicts.
pub fn file(judged: &[Judged]) -> Result<String, Failure> {
    rows::text(
        &COLUMNS,
        judged.iter().map(|Judged { due, verdict }| {
            let more = verdict.more_runs.map_or_else(String::new, |more| more.to_string());
            let decision = Judged { due, verdict: *verdict }.decision();
            [
                due.requirement.quantity.to_owned(),
                number(due.requirement.percent),
                number(due.time_s),
                number(due.limit),
                verdict.runs.to_string(),
                verdict.inside.to_string(),
                number(verdict.low),
                number(verdict.high),
                decision.to_owned(),
                more,
                due.requirement.source.clone(),
            ]
        }),
    )
}

/// The failure that gives the exit code, unless all requirements are met. Those that are not met come before those that are undecided.
pub fn failure(judged: &[Judged]) -> Option<Failure> {
    let with = |decision, kind| {
        let those = judged.iter().filter(move |one| one.verdict.decision == decision);
        let sentence =
            |one: &Judged| format!("--meets: {}: {}: {}", one.required(), one.found(), one.answer());
        those.map(move |one| Failure::of_kind(kind, sentence(one)))
    };
    let not_met = with(Decision::NotMet, Kind::NotMet);
    let failures: Vec<Failure> = not_met.chain(with(Decision::Undecided, Kind::Undecided)).collect();
    if failures.is_empty() { None } else { Some(Failure::all(failures)) }
}
