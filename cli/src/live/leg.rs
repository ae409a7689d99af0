//! One flight from its first sample to its last, with its files: records, figures, the states of the unit, and a log with a scene that
//! flies it again.

use std::path::{Path, PathBuf};
use std::time::Instant;

use sins::records;
use sins::scene::{FlightSource, Samples};
use sins::truth::FlightSample;
use sins::truth::judge::Judge;
use sins::unit::Unit;

use crate::failure::Failure;
use crate::fly::{
    Figures, Files, InFlight, MARK, Spacing, Stopped, UNIT_COLUMNS, UnitInFlight, finish, text,
};
use crate::given::{Given, judge_of, sentence};
use crate::output::{OutputFile, Outputs};
use crate::places::below;
use crate::record::COLUMNS;
use crate::terminal::say;

/// Time between records that a scene does not set [s].
const EVERY_S: f64 = 1.0;

/// The first line of a log.
const LOG_MARK: &str = "# live flight";

/// The columns of a log.
const LOG_COLUMNS: &str = "time_s,latitude_rad,longitude_rad,height_m,velocity_east_m_s,velocity_north_m_s,velocity_up_m_s,\
    roll_rad,pitch_rad,heading_rad";

/// The first line of a scene that flies a log again.
const SCENE_MARK: &str = "# flies the log of a live flight again, to the same bits";

/// Files of a flight that has not begun.
pub struct Blank {
    name: String,
    records: PathBuf,
    files: Files,
    summary: OutputFile,
    log: Option<Log>,
}

/// A log and the scene that flies it.
struct Log {
    file: OutputFile,
    scene: OutputFile,
    stem: String,
}

impl Blank {
    /// The files of flight `number`, from 1, in `folder`. `record` is the name of the log.
    pub fn open(
        given: &Given,
        outputs: &mut Outputs,
        folder: &Path,
        name: &str,
        record: Option<&str>,
        number: u64,
    ) -> Result<Self, Failure> {
        let numbered = |stem: &str| if number == 1 { stem.to_owned() } else { format!("{stem}_{number}") };
        let name = numbered(name);
        let file = |ending: &str| folder.join(format!("{name}{ending}"));
        let records = file(".csv");
        let unit = given.scene.unit()?.map(|unit: Unit| {
            let file = outputs.file(&file("_unit.csv"), &UNIT_COLUMNS.join(","))?;
            UnitInFlight::new(unit, Some(file), None)
        });
        let log = record.map(|record| {
            let path = below(folder, record, "--record", "--record")?;
            let begin = path.file_stem().unwrap_or_default().to_string_lossy();
            let beside = |stem: &str, ending: &str| path.with_file_name(format!("{stem}.{ending}"));
            if let Some(folder) = path.parent() {
                outputs.folder(folder)?;
            }
            // A live flight cannot be flown again: its log takes the place of no other.
            let numbered = |number| if number == 1 { begin.to_string() } else { format!("{begin}_{number}") };
            let is_free = |stem: &String| outputs.is_free(&beside(stem, "csv"));
            let stem = (number..).map(numbered).find(is_free).unwrap_or_default();
            if number == 1 && stem != begin {
                say(&format!("{}: exists; the log is {}", path.display(), beside(&stem, "csv").display()));
            }
            let beside = |ending: &str| beside(&stem, ending);
            let (file, scene) =
                (outputs.file(&beside("csv"), LOG_MARK)?, outputs.file(&beside("toml"), SCENE_MARK)?);
            Ok::<_, Failure>(Log { file, scene, stem })
        });
        Ok(Self {
            files: Files {
                records: outputs.file(&records, &COLUMNS.join(","))?,
                imu: None,
                unit: unit.transpose()?,
            },
            summary: outputs.file(&file("_summary.csv"), MARK)?,
            log: log.transpose()?,
            name,
            records,
        })
    }
}

/// A flight in progress.
pub struct Leg<'a> {
    given: &'a Given,
    name: String,
    records: PathBuf,
    summary: OutputFile,
    log: Option<Log>,
    spacing: Spacing,
    first: FlightSample,
    last: FlightSample,
    judge: Box<Judge>,
    state: State<'a>,
}

enum State<'a> {
    Begun(Option<Box<Files>>),
    Flying(Box<InFlight<'a>>),
}

impl<'a> Leg<'a> {
    pub fn new(given: &'a Given, blank: Blank, first: FlightSample) -> Result<Self, Failure> {
        let Blank { name, records, files, summary, mut log } = blank;
        if let Some(log) = &mut log {
            log.line(LOG_MARK)?;
            log.line(LOG_COLUMNS)?;
            log.sample(&first)?;
        }
        let state = State::Begun(Some(Box::new(files)));
        let spacing = Spacing::new(given.scene.output.every_s.unwrap_or(EVERY_S));
        let mut judge = Box::new(judge_of(&given.scene));
        judge.push(&first)?;
        Ok(Self { given, name, records, summary, log, spacing, first, last: first, judge, state })
    }

    /// Flies the interval that `sample` ends.
    pub fn go_on(&mut self, sample: FlightSample) -> Result<&InFlight<'a>, Stopped> {
        if let State::Begun(files) = &mut self.state
            && let Some(files) = files.take()
        {
            let scene = &self.given.scene;
            let mut flight = InFlight::new(scene, self.spacing, self.first.time_s, *files)?;
            flight.begin(self.first)?;
            self.state = State::Flying(Box::new(flight));
        }
        let State::Flying(flight) = &mut self.state else {
            return Err(sins::Error::bad_state("the flight has ended").into());
        };
        let began = Instant::now();
        flight.go_on(sample)?;
        flight.add_time(began.elapsed());
        self.last = sample;
        self.judge.push(&sample)?;
        if let Some(log) = &mut self.log {
            log.sample(&sample)?;
        }
        Ok(flight)
    }

    /// What is doubtful in the samples, in sentences, and was not reported yet.
    pub fn doubts(&mut self) -> Vec<String> {
        self.judge.new_doubts(false).map(|finding| sentence(&finding)).collect()
    }

    /// Time stamp of the last sample [s].
    pub fn last_s(&self) -> f64 {
        self.last.time_s
    }

    /// Time since the first sample [s].
    pub fn flown_s(&self) -> f64 {
        self.last.time_s - self.first.time_s
    }

    /// Writes what is in buffers, and reports an error of the disk.
    pub fn check(&mut self) -> Result<(), Failure> {
        if let State::Flying(flight) = &mut self.state {
            flight.check()?;
        }
        self.log.as_mut().map_or(Ok(()), |log| log.file.check())
    }

    /// Puts the files in place. Returns the path of the records and the summary in words; `None`: nothing was flown.
    pub fn end(self) -> Result<Option<(PathBuf, String)>, Failure> {
        let (given, every_s) = (self.given, self.spacing.every_s);
        let State::Flying(mut flight) = self.state else { return Ok(None) };
        match flight.record_last() {
            Err(Stopped::Output(failure)) => return Err(failure),
            // The solution of the last step cannot be read: the records end before it.
            Ok(()) | Err(Stopped::Sample(_)) => {}
        }
        let (files, flown) = flight.end()?;
        if flown.steps == 0 {
            return Ok(None);
        }
        let duration_s = self.last.time_s - self.first.time_s;
        let period_s = duration_s / flown.steps as f64;
        let samples =
            Samples { count: flown.steps as usize + 1, start_s: self.first.time_s, period_s, duration_s };
        let mut given = given.with_samples(&samples);
        given.findings = self.judge.findings().map(|finding| sentence(&finding)).collect();
        if let Some(log) = self.log {
            log.commit(&given, every_s)?;
        }
        let figures = Figures::gather(&given, &self.name, every_s, &flown, false)?;
        finish(&figures, files, self.summary)?;
        let words = text(&figures, &self.records);
        Ok(Some((self.records, words)))
    }
}

impl Log {
    fn line(&mut self, line: &str) -> Result<(), Failure> {
        use std::io::Write;
        writeln!(self.file, "{line}").map_err(|error| Failure::of_output(self.file.path(), &error))
    }

    fn sample(&mut self, sample: &FlightSample) -> Result<(), Failure> {
        let FlightSample { time_s, place, v_n, euler, .. } = sample;
        let v_n = v_n.unwrap_or_default();
        let place = [*time_s, place.latitude_rad, place.longitude_rad, place.height_m];
        let motion = [v_n.x, v_n.y, v_n.z, euler.roll, euler.pitch, euler.heading];
        self.line(&records::line(place.into_iter().chain(motion)))
    }

    /// Writes the scene: that of the flight, with its log and the spacing of its records.
    fn commit(self, given: &Given, every_s: f64) -> Result<(), Failure> {
        let mut scene = given.scene.clone();
        scene.flight = FlightSource::Log(format!("{}.csv", self.stem));
        scene.output.every_s = Some(every_s);
        scene.output.name = format!("{}_replay", self.stem);
        self.file.commit()?;
        self.scene.finish(format!("{SCENE_MARK}\n\n{}", scene.write()))
    }
}
