//! One flight from its first sample to its last, with its files: records, figures, the states of the unit, and a log with a scene that
//! flies it again.

use std::path::PathBuf;
use std::time::Instant;

use sins::judge::Judge;
use sins::scene::{Play, Samples};
use sins::truth::FlightSample;

use super::blank::Blank;
use super::log::Log;
use crate::failure::Failure;
use crate::fly::{Figures, Files, InFlight, Stopped, finish, text};
use crate::given::{Given, judge_of, sentence};
use crate::output::OutputFile;
use crate::written;

/// A flight in progress.
pub struct Leg<'a> {
    given: &'a Given,
    name: String,
    summary: OutputFile,
    log: Option<Log>,
    every_s: f64,
    first: FlightSample,
    last: FlightSample,
    judge: Box<Judge>,
    state: State,
}

enum State {
    Begun(Option<Box<(Play, Files)>>),
    Flying(Box<InFlight>),
}

/// A flight that has ended.
pub struct Ended {
    /// Its records.
    pub records: PathBuf,
    /// Its summary.
    pub words: String,
    /// What the disk has refused.
    pub written: Result<(), Failure>,
}

impl<'a> Leg<'a> {
    pub fn new(given: &'a Given, blank: Blank, first: FlightSample) -> Result<Self, Failure> {
        let Blank { name, files, summary, mut log, .. } = blank;
        if let Some(log) = &mut log {
            log.begin(&first)?;
        }
        let play = given.play()?;
        let every_s = play.itinerary().every_s();
        let state = State::Begun(Some(Box::new((play, files))));
        let mut judge = Box::new(judge_of(&given.scene));
        judge.push(&first)?;
        Ok(Self { given, name, summary, log, every_s, first, last: first, judge, state })
    }

    /// Flies the interval that `sample` ends.
    pub fn go_on(&mut self, sample: FlightSample) -> Result<&InFlight, Stopped> {
        if let State::Begun(ready) = &mut self.state
            && let Some(ready) = ready.take()
        {
            let (play, files) = *ready;
            let mut flight = InFlight::new(play, files)?;
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
            log.publish(self.given, self.every_s)?;
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
        self.log.as_mut().map_or(Ok(()), Log::check)
    }

    /// Puts the files in place, as far as the disk has taken them; `None`: nothing was flown. `is_stopped`: an error has ended the flight.
    pub fn end(self, is_stopped: bool) -> Result<Option<Ended>, Failure> {
        let (given, every_s) = (self.given, self.every_s);
        let State::Flying(mut flight) = self.state else { return Ok(None) };
        // If the solution of the last step cannot be read, the records end before it. The files remember what the disk has refused.
        let _ = flight.record_last();
        let (files, flown) = flight.end()?;
        if flown.steps == 0 {
            return Ok(None);
        }
        let log = self.log.map_or(Ok(()), Log::commit);
        let duration_s = self.last.time_s - self.first.time_s;
        let period_s = duration_s / flown.steps as f64;
        let samples =
            Samples { count: flown.steps as usize + 1, start_s: self.first.time_s, period_s, duration_s };
        let mut given = given.with_samples(&samples);
        given.findings = self.judge.findings().map(|finding| sentence(&finding)).collect();
        let records = files.records.path().to_owned();
        let figures = Figures::gather(&given, &self.name, every_s, &flown, is_stopped)?;
        let paths = [files.paths(), vec![self.summary.path().to_owned()]].concat();
        let written = Failure::each([log, finish(&figures, files, self.summary)]);
        Ok(Some(Ended {
            words: text(&figures, &records) + &written::text(&paths, written::report(&paths).as_deref()),
            records,
            written,
        }))
    }
}
