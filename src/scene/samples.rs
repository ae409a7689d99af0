//! The samples that a scene flies.

use super::{FlightSource, Scene};
use crate::base::error::{Error, Rule};
use crate::log::{FlightLog, LogError};

/// Largest rounding error of a time [intervals]: it must not remove a sample.
const ROUNDING: f64 = 1e-9;

/// Approximate number of records, if the scene does not state their spacing.
const RECORDS: f64 = 2000.0;

/// The samples that a scene flies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Samples {
    /// How many.
    pub count: usize,
    /// Time stamp of the first [s].
    pub start_s: f64,
    /// Time between two, of a log on average [s].
    pub period_s: f64,
    /// Time from the first to the last [s].
    pub duration_s: f64,
}

impl Scene {
    /// The log in a text, read and repaired as [`Scene::log`] says.
    pub fn read_log(&self, text: &[u8]) -> Result<FlightLog, LogError> {
        FlightLog::parse_with(text, &self.log)?.smoothed(&self.options.earth())
    }

    /// The samples of the flight at its rate, or those of its log up to the duration that the scene sets.
    pub fn samples(&self, log: Option<&FlightLog>) -> Result<Samples, Error> {
        match (log, &self.flight) {
            (Some(log), _) => self.samples_of_log(log),
            (None, FlightSource::Log(_)) => {
                Err(Error::bad_state("the flight of the scene is a log; give the log"))
            }
            (None, _) => {
                let period_s = 1.0 / self.rate_hz;
                let intervals = (self.flown_s()? / period_s + ROUNDING).floor();
                let count = intervals as usize + 1;
                Ok(Samples { count, start_s: 0.0, period_s, duration_s: intervals * period_s })
            }
        }
    }

    fn samples_of_log(&self, log: &FlightLog) -> Result<Samples, Error> {
        if !log.was_read_as(&self.log) {
            let what = "the log was not read by the [log] of the scene; read it with the scene";
            return Err(Error::bad_state(what));
        }
        if log.is_to_be_smoothed() {
            return Err(Error::bad_state(
                "the path of the log is still to be smoothed; read the log with the scene",
            ));
        }
        if let Some(temperature) = &self.temperature
            && log.samples()[0].temperature_c.is_some()
        {
            let rule = Rule::Sentence("must not be set for a log with the temperature of its own");
            return Err(Error::invalid("flight.temperature_c", temperature.at_start_c, rule));
        }
        let start_s = log.samples()[0].time_s;
        let wanted_s = self.duration_s.unwrap_or(f64::INFINITY) * (1.0 + ROUNDING);
        if let Some(duration_s) = self.duration_s
            && duration_s > log.duration_s() * (1.0 + ROUNDING)
        {
            let rule = Rule::AtMost("must be at most the duration of the log:", log.duration_s().into());
            return Err(Error::invalid("flight.duration_s", duration_s, rule));
        }
        let count = log.samples().iter().take_while(|sample| sample.time_s - start_s <= wanted_s).count();
        if count < 2 {
            let rule = Rule::Sentence("the log has no second sample within this time");
            return Err(Error::invalid("flight.duration_s", self.duration_s.unwrap_or_default(), rule));
        }
        let duration_s = log.samples()[count - 1].time_s - start_s;
        Ok(Samples { count, start_s, period_s: duration_s / (count - 1) as f64, duration_s })
    }

    /// Intervals from one record of a program to the next, of `count` samples `period_s` [s] apart: the spacing that the scene sets, else
    /// for about 2000 records.
    pub fn record_every(&self, count: usize, period_s: f64) -> Result<u64, Error> {
        let intervals = match self.output.every_s {
            None => (count.saturating_sub(1) as f64 / RECORDS).round().max(1.0),
            Some(every_s) => (every_s / period_s).round(),
        };
        if intervals < 1.0 {
            let rule = Rule::AtLeast("must be at least the sample interval,", period_s.into());
            return Err(Error::invalid("output.every_s", self.output.every_s.unwrap_or_default(), rule));
        }
        Ok(intervals as u64)
    }
}
