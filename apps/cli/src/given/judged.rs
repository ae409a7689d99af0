//! What is found in a log, and what is done about it.

use std::path::{Path, PathBuf};

use sins::Error;
use sins::judge::{Finding, Judge, Level};
use sins::log::FlightLog;
use sins::records::number;
use sins::scene::{Scene, text_in_quotes};

use super::gaps::{self, Gaps};
use crate::failure::{Failure, Kind};
use crate::terminal::say;

/// What is done about findings in a log.
#[derive(Debug, Clone, Copy, Default, clap::Args)]
pub struct Trust {
    /// Also refuses a log with a doubtful finding
    #[arg(long)]
    pub strict: bool,
    /// Flies a log with an unusable finding
    #[arg(long, conflicts_with = "strict")]
    pub believe: bool,
    /// Whether they are printed in JSON.
    #[arg(skip)]
    pub json: bool,
}

/// Whether what is found in a log is printed in JSON.
#[derive(Debug, Clone, Copy, clap::Args)]
pub struct Json {
    /// Prints what is found in a log in JSON, a line each, and no other text on standard output
    ///
    /// Keys: file; level of the worst finding ("note", "doubtful", "unusable"; null: nothing is found); findings, the worst first. Each has
    /// its level, its line (null: the whole log) and a sentence. Those of the judge also have kind, sample, time_s, count, figure,
    /// acceleration_m_s2 (false acceleration), ins_error_m (of an INS with ideal sensors; both null: none, or unknown) and remedy; enum
    /// sins_finding_kind in sins_flight.h says what the kinds and figures are. A log that cannot be read prints no line.
    #[arg(long = "json")]
    pub is_wanted: bool,
}

/// One that was found.
#[derive(Debug, Clone)]
struct Found {
    level: Level,
    line: Option<usize>,
    /// That of the judge; `None`: a note of the reader, or why a simulator refuses the log.
    finding: Option<Finding>,
    sentence: String,
}

/// What was found in the log at a path, the worst first.
#[derive(Debug, Clone)]
pub struct Verdict {
    path: PathBuf,
    list: Vec<Found>,
}

/// A judge with the Earth and the limits of `scene`.
pub fn judge_of(scene: &Scene) -> Judge {
    let options = scene.simulator_options();
    Judge::new(options.earth(), options.intake.max_acceleration_m_s2).expect("memory for a judge")
}

/// A finding in a sentence, with what to do about it.
pub fn sentence(finding: &Finding) -> String {
    format!("{}: {}", finding.level.word(), finding.with_remedy())
}

impl Verdict {
    /// What the judge finds in the first `count` samples of a log, and the notes of its reader.
    pub fn new(scene: &Scene, path: &Path, log: &FlightLog, count: usize) -> Self {
        let mut judge = judge_of(scene);
        log.judge(&mut judge, count).expect("each value of a log is in its range");
        let findings = judge.findings().map(|finding| Found {
            level: finding.level,
            line: log.line_of(&finding).map(|line| line as usize),
            finding: Some(finding),
            sentence: finding.with_remedy().to_string(),
        });
        let notes = log.notes().iter().map(|note| Found {
            level: Level::Note,
            line: Some(note.line).filter(|line| *line > 0),
            finding: None,
            sentence: note.sentence.clone(),
        });
        Self { path: path.to_owned(), list: findings.chain(notes).collect() }
    }

    /// Adds why a simulator refuses the sample `index`, behind what is unusable: that may be the reason.
    pub fn refuse(&mut self, scene: &Scene, log: &FlightLog, index: usize, error: &Error) {
        let place = self.list.partition_point(|found| found.level == Level::Unusable);
        let line = log.line(index).map(|line| line as usize);
        let sentence = gaps::refusal(scene, log, error);
        self.list.insert(place, Found { level: Level::Unusable, line, finding: None, sentence });
    }

    /// The level of the worst that was found.
    pub fn worst(&self) -> Option<Level> {
        self.list.iter().map(|found| found.level).max()
    }

    /// Whether a remedy is to smooth the log, and no finding that makes it unusable has another one.
    pub fn advises_smoothing(&self) -> bool {
        let smooths = |finding: &Finding| finding.remedy().contains("smooth the log");
        let mut findings = self.list.iter().filter_map(|found| Some((found.level, found.finding.as_ref()?)));
        findings.clone().any(|(_, finding)| smooths(finding))
            && findings.all(|(level, finding)| level != Level::Unusable || smooths(finding))
    }

    /// Each in a line, with its place.
    pub fn lines(&self) -> impl Iterator<Item = String> {
        self.list.iter().map(|Found { level, line, sentence, .. }| {
            let line = line.map_or_else(String::new, |line| format!(":{line}"));
            format!("{}{line}: {}: {sentence}", self.path.display(), level.word())
        })
    }

    /// It as an object in JSON, on one line.
    pub fn json(&self) -> String {
        let level = self.worst().map_or("null".to_owned(), |level| text_in_quotes(level.word()));
        let findings: Vec<String> = self.list.iter().map(Found::json).collect();
        let file = text_in_quotes(&self.path.to_string_lossy());
        format!("{{\"file\":{file},\"level\":{level},\"findings\":[{}]}}\n", findings.join(","))
    }
}

impl Found {
    fn json(&self) -> String {
        let or_null = |value: Option<String>| value.unwrap_or_else(|| "null".to_owned());
        let finite = |value: f64| value.is_finite().then(|| number(value));
        let of = |value: fn(&Finding) -> String| or_null(self.finding.as_ref().map(value));
        let known = |value: fn(&Finding) -> f64| or_null(self.finding.as_ref().map(value).and_then(finite));
        let effect = |value: fn(&Finding) -> f64| {
            or_null(self.finding.as_ref().map(value).filter(|value| *value != 0.0).and_then(finite))
        };
        let values = [
            ("kind", of(|finding| text_in_quotes(&snake_case(&format!("{:?}", finding.kind))))),
            ("level", text_in_quotes(self.level.word())),
            ("line", or_null(self.line.map(|line| line.to_string()))),
            ("sample", of(|finding| finding.at.row.to_string())),
            ("time_s", known(|finding| finding.at.time_s)),
            ("count", of(|finding| finding.count.to_string())),
            ("figure", known(|finding| finding.figure)),
            ("acceleration_m_s2", effect(|finding| finding.acceleration_m_s2)),
            ("ins_error_m", effect(|finding| finding.ins_error_m)),
            ("sentence", text_in_quotes(&self.finding.map_or(self.sentence.clone(), |it| it.to_string()))),
            ("remedy", of(|finding| text_in_quotes(finding.remedy()))),
        ];
        let members = values.map(|(key, value)| format!("\"{key}\":{value}"));
        format!("{{{}}}", members.join(","))
    }
}

/// The name of a constant in small letters, with a line between its words.
fn snake_case(name: &str) -> String {
    let mut words = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !words.is_empty() {
            words.push('_');
        }
        words.extend(letter.to_lowercase());
    }
    words
}

impl Trust {
    /// The gaps of a log with this verdict, which is reported on standard error, or the log refused. `gaps` is `None` if a simulator
    /// refuses it.
    pub fn take(&self, verdict: &Verdict, gaps: Option<Gaps>) -> Result<Gaps, Failure> {
        let (kind, refusal) = match (verdict.worst(), gaps) {
            (_, None) => (Kind::Input, "the log is refused"),
            (Some(Level::Unusable), _) if !self.believe => {
                (Kind::Input, "the log is refused; --believe flies it all the same")
            }
            (Some(Level::Doubtful), _) if self.strict => (Kind::Doubtful, "the log is refused (--strict)"),
            (_, Some(gaps)) => {
                verdict.lines().filter(|_| !self.json).for_each(|line| say(&line));
                return Ok(gaps);
            }
        };
        let lines = verdict.lines().filter(|_| !self.json);
        let lines: Vec<String> = lines.chain([refusal.to_owned()]).collect();
        Err(Failure::of_kind(kind, lines.join("\n")))
    }
}
