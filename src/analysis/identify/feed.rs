//! A path and a record that a host pushes row by row, and what was found in them.

use super::blocks::check_row;
use super::check::{Check, CheckRequest, Truth, check, identify_first_half};
use super::path::of_path;
use super::{Identified, RecordedIncrement, Request, identify};
use crate::base::error::{Error, check_integer};
use crate::base::memory::{only, room, room_for_one_more};
use crate::simulator::{Options, Simulator, Step, heap_simulator};
use crate::truth::{FlightSample, Pushed};

/// Most samples of a path and most increments of a record: 28 h at 1000 Hz.
pub const MOST_ROWS: usize = 100_000_000;

/// A path and a record.
pub struct Feed {
    options: Options,
    request: Request,
    /// Perfect sensors along the path.
    simulator: Box<[Simulator; 1]>,
    samples: usize,
    /// The path; its samples and states are those of a feed that checks.
    truth: Truth,
    keeps_states: bool,
    record: Vec<RecordedIncrement>,
    found: Option<Box<[Identified; 1]>>,
    checked: Option<Check>,
    /// A sample that was taken and could not be flown: the path has a hole from then on.
    broken: Option<Error>,
    most_rows: usize,
}

impl Feed {
    /// Without rows. Of `options`, Earth, gravity, body axes and the checks of samples count. With `keeps_states` the path is kept with
    /// all that [`Self::check`] needs.
    pub fn new(options: &Options, request: &Request, keeps_states: bool) -> Result<Self, Error> {
        Self::with_most(options, request, keeps_states, MOST_ROWS)
    }

    fn with_most(
        options: &Options,
        request: &Request,
        keeps_states: bool,
        most_rows: usize,
    ) -> Result<Self, Error> {
        options.validate()?;
        request.validate()?;
        let flown = of_path(options);
        Ok(Self {
            options: flown,
            request: *request,
            simulator: heap_simulator(&flown)?,
            samples: 0,
            truth: Truth::new(options),
            keeps_states,
            record: Vec::new(),
            found: None,
            checked: None,
            broken: None,
            most_rows,
        })
    }

    /// The options of the path.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// Number of increments of the record.
    pub fn increments(&self) -> usize {
        self.record.len()
    }

    /// Adds the next sample of the path.
    pub fn push_sample(&mut self, sample: &FlightSample) -> Result<Pushed, Error> {
        self.check_path()?;
        check_integer("samples", self.samples + 1, 1, self.most_rows as u64)?;
        self.truth.make_room(self.keeps_states)?;
        let [simulator] = &mut *self.simulator;
        let pushed = simulator.push_sample(sample)?;
        self.samples += 1;
        match self.fly(sample) {
            Ok(()) => Ok(pushed),
            Err(error) => {
                self.broken = Some(error);
                Err(error)
            }
        }
    }

    /// Flies the interval that waits, if it is complete.
    fn fly(&mut self, sample: &FlightSample) -> Result<(), Error> {
        self.truth.push_sample(sample, self.keeps_states)?;
        let [simulator] = &mut *self.simulator;
        while simulator.step()? == Step::Done {
            self.truth.push_interval(simulator, self.keeps_states)?;
        }
        Ok(())
    }

    /// Adds the next increment of the record.
    pub fn push_increment(&mut self, row: &RecordedIncrement) -> Result<(), Error> {
        check_integer("increments", self.record.len() + 1, 1, self.most_rows as u64)?;
        check_row(row, self.record.last().map(|last| last.time_s))?;
        room_for_one_more(&mut self.record)?;
        self.record.push(*row);
        Ok(())
    }

    /// Finds the errors of the sensors in all rows so far. After an error, what was found before stays.
    pub fn solve(&mut self) -> Result<&Identified, Error> {
        self.check_path()?;
        let mut found = room(1)?;
        found.push(identify(self.truth.path(), &self.record, &self.request)?);
        let [found] = &**self.found.insert(only(found)?);
        Ok(found)
    }

    /// What [`Self::solve`] found last.
    pub fn found(&self) -> Result<&Identified, Error> {
        match &self.found {
            Some(found) => Ok(&found[0]),
            None => Err(Error::bad_state("nothing was found yet: solve first")),
        }
    }

    /// Identifies the first half of the rows that the path has, and checks what was found in the other half. After an error, what was found
    /// before stays.
    pub fn check(&mut self, request: &CheckRequest) -> Result<&Check, Error> {
        self.check_path()?;
        request.validate()?;
        if !self.keeps_states {
            return Err(Error::bad_state(
                "the states of the path were not kept: ask for the check beforehand",
            ));
        }
        let mut place = room(1)?;
        let (found, other_half) = identify_first_half(&self.truth, &self.record, &self.request)?;
        let checked = check(&self.truth, &found, other_half, request)?;
        place.push(found);
        self.found = Some(only(place)?);
        Ok(self.checked.insert(checked))
    }

    /// What [`Self::check`] found last.
    pub fn checked(&self) -> Result<&Check, Error> {
        self.checked.as_ref().ok_or_else(|| Error::bad_state("nothing was checked yet"))
    }

    fn check_path(&self) -> Result<(), Error> {
        self.broken.map_or(Ok(()), Err)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math::Euler;
    use crate::earth::Geodetic;
    use crate::signal::Increment;

    /// No host makes the library take more rows than the bound, and a row that is rejected changes nothing.
    #[test]
    fn rows_are_bounded_and_checked() {
        let mut feed = Feed::with_most(&Options::default(), &Request::default(), true, 3).unwrap();
        let place = Geodetic { latitude_rad: 0.7, longitude_rad: 0.0, height_m: 0.0 };
        let sample = |time_s: f64| FlightSample::at_rest(time_s, place, Euler::default());
        let row = |time_s: f64| RecordedIncrement { time_s, interval_s: 0.1, increment: Increment::ZERO };
        assert!(feed.push_increment(&row(f64::NAN)).is_err());
        for k in 0..3 {
            feed.push_sample(&sample(f64::from(k))).unwrap();
            feed.push_increment(&row(f64::from(k))).unwrap();
            let error = feed.push_increment(&row(f64::from(k))).unwrap_err().to_string();
            assert!(k == 2 || error.starts_with("record.time_s = "), "{error}");
        }
        let sentences = [feed.push_sample(&sample(3.0)).err(), feed.push_increment(&row(3.0)).err()];
        let [samples, increments] = sentences.map(|error| error.unwrap().to_string());
        assert_eq!(samples, "samples = 4: must be from 1 to 3");
        assert_eq!(increments, "increments = 4: must be from 1 to 3");
        assert_eq!((feed.samples, feed.record.len()), (3, 3));
        assert!(feed.found().is_err() && feed.solve().is_err());
        assert!(feed.checked().is_err() && feed.check(&CheckRequest::default()).is_err());
    }
}
