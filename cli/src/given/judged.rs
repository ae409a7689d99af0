//! What the judge finds in a log, and what is done about it.

use std::path::Path;

use sins::judge::{Finding, Judge, Level};
use sins::log::FlightLog;
use sins::scene::Scene;

use super::gaps;
use crate::failure::Failure;
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

/// The findings in the first `count` samples of a log, and the notes of its reader, each with its line.
pub fn judge(scene: &Scene, path: &Path, log: &FlightLog, count: usize) -> Vec<(Level, String)> {
    let mut judge = judge_of(scene);
    log.judge(&mut judge, count).expect("each value of a log is in its range");
    let place = |finding: &Finding| match log.line_of(finding) {
        Some(line) => format!("{}:{line}", path.display()),
        None => path.display().to_string(),
    };
    let words = |finding: Finding| (finding.level, format!("{}: {}", place(&finding), sentence(&finding)));
    let noted = |line: usize, sentence: &str| {
        let line = if line > 0 { format!(":{line}") } else { String::new() };
        let word = Level::Note.word();
        (Level::Note, format!("{}{line}: {word}: {sentence}", path.display()))
    };
    let noted = log.notes().iter().map(|note| noted(note.line, &note.sentence));
    judge.findings().map(words).chain(noted).collect()
}

/// The first sample of a log that a simulator refuses, as a finding of it, if the judge has found nothing that is
/// unusable: that is the reason then.
pub fn refused(
    scene: &Scene,
    path: &Path,
    log: &FlightLog,
    findings: &[(Level, String)],
) -> Option<(Level, String)> {
    let (index, error) = gaps::find(scene, log, log.samples().len()).err()?;
    let line = log.line(index).map_or_else(String::new, |line| format!(":{line}"));
    let (word, why) = (Level::Unusable.word(), gaps::refusal(scene, log, &error));
    let is_new = findings.iter().all(|(level, _)| *level < Level::Unusable);
    is_new.then(|| (Level::Unusable, format!("{}{line}: {word}: {why}", path.display())))
}

impl Trust {
    /// Refuses a log with these findings, or reports them on standard error.
    pub fn take(&self, findings: &[(Level, String)]) -> Result<(), Failure> {
        let worst = findings.iter().map(|(level, _)| *level).max();
        let refusal = match worst {
            Some(Level::Unusable) if !self.believe => "the log is refused; --believe flies it all the same",
            Some(Level::Doubtful | Level::Unusable) if self.strict => "the log is refused (--strict)",
            _ => {
                findings.iter().for_each(|(_, words)| say(words));
                return Ok(());
            }
        };
        let lines: Vec<&str> = findings.iter().map(|(_, words)| words.as_str()).chain([refusal]).collect();
        Err(Failure::new(lines.join("\n")))
    }
}
