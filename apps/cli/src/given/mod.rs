//! The scene that the command line names, and its flight sample by sample.

mod arguments;
mod beside;
mod file;
mod gaps;
mod judged;
mod kind;
mod left_out;
mod log;
mod settings;
mod text;
mod title;
mod whole;
mod words;

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use sins::log::RowOfPath;
use sins::scene::{FlightSource, Itinerary, Play, Samples, Scene, Source};
use sins::truth::FlightSample;
use sins::truth::flight::Flight;
use sins::{Error, ErrorKind};

pub use arguments::{Hours, SceneArguments};
pub use beside::beside;
pub use file::{open_table, read_text, read_whole};
pub use gaps::{Gaps, find as find_gaps, unit_of_interval};
pub use judged::{Json, Trust, Verdict, judge_of, sentence};
pub use kind::{FileKind, is_record};
pub use log::{ReadLog, of_log, parse_log, read_bytes, read_log};
pub use settings::Settings;
pub use text::is_log;
pub use whole::whole;
pub use words::of_sample;

use crate::failure::{Failure, Kind};
use crate::terminal::print;
use crate::units::rounded;
use text::{Text, name_of};

/// A scene with its flight.
#[derive(Debug, Clone)]
pub struct Given {
    pub scene: Scene,
    /// Name of the scene: its file name without the ending, or the name of the built-in scene.
    pub name: String,
    /// Origin of the scene: its file, or the built-in scene.
    pub origin: String,
    /// All files that were read.
    pub inputs: Vec<PathBuf>,
    /// Title of the scene.
    pub title: String,
    /// Number of samples.
    pub count: usize,
    /// Time stamp of the first sample [s].
    pub start_s: f64,
    /// Time between two samples; for a log, the mean [s].
    pub period_s: f64,
    /// Time from the first sample to the last [s].
    pub duration_s: f64,
    /// Gaps of the log, if the flight is one.
    pub gaps: Gaps,
    /// What the judge found in the log, in sentences.
    pub findings: Vec<String>,
    source: Source,
    /// The file of the log, if the flight is one.
    log: Option<PathBuf>,
}

impl Given {
    /// The scene called `name` (built in, a file, or a log); `log` replaces its flight. A log without a scene is flown by the
    /// simulator of the scene in the text `for_logs`.
    pub fn load(
        name: Option<&OsStr>,
        log: Option<&Path>,
        settings: &Settings,
        trust: &Trust,
        for_logs: &str,
    ) -> Result<Self, Failure> {
        // A table that --columns reads may have any name.
        let is_table = |name| {
            log.is_none() && settings.columns.is_some() && !text::is_scene(name) && Path::new(name).exists()
        };
        let (text, log) = match name {
            Some(name) if is_log(name) && log.is_some() => {
                let what =
                    format!("{}: is a flight log; so --log must not be given", Path::new(name).display());
                return Err(Failure::new(what));
            }
            Some(name) if is_log(name) || is_table(name) => {
                (Text::for_log(Path::new(name), for_logs), Some(Path::new(name)))
            }
            Some(name) => (Text::find(name)?, log),
            None => match log {
                Some(path) => (Text::for_log(path, for_logs), log),
                None => {
                    return Err(Failure::new(
                        "no scene was given; `sins scene list` lists the built-in scenes",
                    ));
                }
            },
        };
        let mut scene = text.parse(settings)?;
        let titled = text.titled(settings);
        let mut inputs: Vec<PathBuf> = text.path.iter().cloned().collect();
        let mut name = text.name.clone();
        if let Some(log) = log {
            scene.flight = FlightSource::Log(log.to_string_lossy().into_owned());
            if !settings.has("flight.hours") {
                scene.duration_s = None;
            }
            if !settings.has("flight.title") {
                scene.title.clear();
            }
            name = name_of(log);
        }
        let (source, log) = match &scene.flight {
            FlightSource::Log(file) => {
                let path = match log {
                    Some(path) => path.to_owned(),
                    None => text.folder().join(file),
                };
                let read = read_log(&path, &scene);
                let ReadLog { log, others } = read.map_err(|failure| text.at("flight", "file", failure))?;
                if scene.temperature.is_some() && log.samples()[0].temperature_c.is_some() {
                    let what = Failure::new("flight.temperature_c: the log has a column of that name");
                    return Err(text.at("flight", "temperature_c", what));
                }
                inputs.push(path.clone());
                inputs.extend(others);
                (Source::Log(Arc::new(log)), Some(path))
            }
            _ => (Source::flight_of(&scene)?, None),
        };
        let samples = match (&source, &log) {
            (Source::Log(samples), Some(path)) => {
                scene.samples(Some(samples)).map_err(|error| Failure::of_file(path, &error))?
            }
            _ => scene.samples(None)?,
        };
        let title = title::title(&scene, titled.as_ref(), &source, &samples);
        let Samples { count, start_s, period_s, duration_s } = samples;
        let mut given = Self {
            scene,
            name,
            origin: text.origin,
            inputs,
            title,
            count,
            start_s,
            period_s,
            duration_s,
            gaps: Gaps::default(),
            findings: Vec::new(),
            source,
            log,
        };
        if let (Source::Log(log), Some(path)) = (&given.source, &given.log) {
            let mut verdict = Verdict::new(&given.scene, path, log, count);
            let gaps = gaps::find(&given.scene, log, count);
            if let Err((index, error)) = &gaps {
                verdict.refuse(&given.scene, log, *index, error);
            }
            if trust.json {
                print(&verdict.json())?;
            }
            given.gaps = trust.take(&verdict, gaps.ok())?;
            given.findings = verdict.lines().collect();
        }
        Ok(given)
    }

    /// The scene called `name` (built in or a file) for samples that come from outside, or without a name that of the text `for_logs`.
    /// Its own flight is left out. There are no samples yet.
    pub fn live(name: Option<&OsStr>, settings: &Settings, for_logs: &str) -> Result<Self, Failure> {
        let text = match name {
            Some(name) if is_log(name) => {
                return Err(Failure::of_file(Path::new(name), &"is a flight log: expected a scene"));
            }
            Some(name) => Text::find(name)?,
            None => Text::for_log(Path::new("live"), for_logs),
        };
        let mut scene = text.parse(settings)?;
        (scene.flight, scene.duration_s) = (FlightSource::Log(String::new()), None);
        if !settings.has("flight.title") {
            scene.title = "live flight".to_owned();
        }
        let name = if name.is_some() { format!("{}_live", text.name) } else { text.name };
        Ok(Self {
            title: scene.title.clone(),
            scene,
            name,
            origin: text.origin,
            inputs: text.path.into_iter().collect(),
            count: 0,
            start_s: 0.0,
            period_s: 0.0,
            duration_s: 0.0,
            gaps: Gaps::default(),
            findings: Vec::new(),
            source: Source::Host,
            log: None,
        })
    }

    /// The same with the samples that came.
    pub fn with_samples(&self, samples: &Samples) -> Self {
        let Samples { count, start_s, period_s, duration_s } = *samples;
        Self { count, start_s, period_s, duration_s, ..self.clone() }
    }

    /// The scene before its first sample.
    pub fn play(&self) -> Result<Play, Error> {
        Play::new(Arc::new(self.scene.clone()), self.source.clone())
    }

    /// The same of another run, without what concerns the truth alone.
    pub fn play_of_run(&self, run: u64) -> Result<Play, Error> {
        let mut scene = self.scene.clone();
        scene.options.key.run = run;
        (scene.options.covariance, scene.options.truth_summary) = (false, false);
        Play::new(Arc::new(scene), self.source.clone())
    }

    /// The same without a simulator.
    pub fn itinerary(&self) -> Result<Itinerary, Error> {
        Itinerary::new(Arc::new(self.scene.clone()), self.source.clone())
    }

    /// The sample `index`.
    pub fn sample(&self, index: usize) -> Result<FlightSample, Error> {
        self.source.sample(index, &self.scene)
    }

    /// Time of the sample `index` since the first one [s].
    pub fn time_s(&self, index: usize) -> f64 {
        match &self.source {
            Source::Log(log) => log.samples()[index].time_s - self.start_s,
            Source::Flight(_) | Source::Host => index as f64 * self.period_s,
        }
    }

    /// Index of the sample nearest to a time since the first one [s], one of the `count`.
    pub fn index_at(&self, time_s: f64) -> usize {
        let last = self.count.saturating_sub(1);
        match &self.source {
            Source::Log(log) => {
                let samples = &log.samples()[..self.count];
                let behind =
                    samples.partition_point(|sample| sample.time_s - self.start_s < time_s).min(last);
                let before = behind.saturating_sub(1);
                let is_nearer = time_s - self.time_s(before) < self.time_s(behind) - time_s;
                if is_nearer { before } else { behind }
            }
            Source::Flight(_) | Source::Host => ((time_s / self.period_s).round() as usize).min(last),
        }
    }

    /// The rows that the path of a smoothed log was fitted to.
    pub fn rows_of_path(&self) -> &[RowOfPath] {
        match &self.source {
            Source::Log(log) => log.rows(),
            Source::Flight(_) | Source::Host => &[],
        }
    }

    /// Flight in closed form; `None` for a log.
    pub fn flight(&self) -> Option<&Flight> {
        match &self.source {
            Source::Flight(flight) => Some(flight),
            Source::Log(_) | Source::Host => None,
        }
    }

    /// Place of the sample `index`: the line of a log, or the time.
    pub fn place(&self, index: usize) -> String {
        match (&self.log, self.source.line(index)) {
            (Some(path), line) => format!("{}:{}", path.display(), line.unwrap_or_default()),
            (None, _) => format!("{}: at {} s", self.origin, rounded(index as f64 * self.period_s, 10)),
        }
    }

    /// What a reader must know before the figures, in sentences: what is doubtful in the flight data, gaps, and what is `left_out`.
    pub fn warnings(&self, left_out: impl IntoIterator<Item = String>) -> Vec<String> {
        let findings = self.findings.iter().map(|finding| format!("Flight data: {finding}."));
        let gaps = self.gaps_text().map(|gaps| format!("Gaps in the flight data: {gaps}."));
        let left_out = left_out.into_iter().map(|what| format!("Flown {what}."));
        findings.chain(gaps).chain(left_out).collect()
    }

    /// The gaps of the log in words; `None`: it has none.
    pub fn gaps_text(&self) -> Option<String> {
        let Gaps { count, longest_s, index } = self.gaps;
        let (longest_s, place) = (rounded(longest_s, 6), self.place(index));
        match count {
            0 => None,
            1 => Some(format!("1, of {longest_s} s, before {place}, bridged")),
            _ => Some(format!("{count}, the longest of {longest_s} s, before {place}, bridged")),
        }
    }

    /// Failure that ends a flight at the sample `index`: the sample is invalid, or the truth or the solution left its range.
    pub fn stopped_at(&self, index: usize, error: &Error) -> Failure {
        let refusal = self.failure_at(index, error);
        match error.kind {
            ErrorKind::InvalidArgument | ErrorKind::TimeOrder | ErrorKind::Discontinuity => refusal,
            _ => Failure::of_kind(Kind::Failed, refusal.to_string()),
        }
    }

    /// Failure about the sample `index`, with its place.
    pub fn failure_at(&self, index: usize, error: &Error) -> Failure {
        Failure::new(format!("{}: {}", self.place(index), of_sample(error)))
    }
}

/// Reads the scene called `name` (built in or a file), without its flight. Its title is left out if the settings replace what it says.
pub fn read_scene(name: &OsStr, settings: &Settings) -> Result<Scene, Failure> {
    let text = Text::find(name)?;
    let mut scene = text.parse(settings)?;
    let has_title = |own: &Scene| title::holds(&scene, own) && own.duration_s == scene.duration_s;
    if !text.titled(settings).as_ref().is_none_or(has_title) {
        scene.title.clear();
    }
    Ok(scene)
}
