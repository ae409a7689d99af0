//! A path and a record that a host pushes row by row, and what was found in them.

use super::blocks::check_row;
use super::{IdealPath, Identified, RecordedIncrement, Request, identify};
use crate::base::error::{Error, check_integer};
use crate::base::memory::{only, room, room_for_one_more};
use crate::mechanization::Frame;
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
    path: IdealPath,
    record: Vec<RecordedIncrement>,
    found: Option<Box<[Identified; 1]>>,
    /// A sample that was taken and could not be flown: the path has a hole from then on.
    broken: Option<Error>,
    most_rows: usize,
}

impl Feed {
    /// Without rows. Of `options`, Earth, gravity, body axes and the checks of samples count.
    pub fn new(options: &Options, request: &Request) -> Result<Self, Error> {
        Self::with_most(options, request, MOST_ROWS)
    }

    fn with_most(options: &Options, request: &Request, most_rows: usize) -> Result<Self, Error> {
        options.validate()?;
        request.validate()?;
        let Options { ellipsoid, gravity, axes, intake, .. } = *options;
        // Earth-fixed axes have no pole, and the damped vertical channel keeps the path for any time.
        let flown =
            Options { ellipsoid, gravity, axes, intake, frame: Frame::EarthFixed, ..Options::default() };
        Ok(Self {
            options: flown,
            request: *request,
            simulator: heap_simulator(&flown)?,
            samples: 0,
            path: IdealPath::default(),
            record: Vec::new(),
            found: None,
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
        self.path.make_room()?;
        let [simulator] = &mut *self.simulator;
        let pushed = simulator.push_sample(sample)?;
        self.samples += 1;
        match fly(simulator, &mut self.path) {
            Ok(()) => Ok(pushed),
            Err(error) => {
                self.broken = Some(error);
                Err(error)
            }
        }
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
        found.push(identify(&self.path, &self.record, &self.request)?);
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

    fn check_path(&self) -> Result<(), Error> {
        self.broken.map_or(Ok(()), Err)
    }
}

/// Flies the interval that waits, if it is complete.
fn fly(simulator: &mut Simulator, path: &mut IdealPath) -> Result<(), Error> {
    while simulator.step()? == Step::Done {
        if let Some(imu) = simulator.imu() {
            path.push(imu.time_s, imu.interval_s, &imu.ideal)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::earth::Geodetic;
    use crate::math::Euler;
    use crate::signal::Increment;

    /// No host makes the library take more rows than the bound, and a row that is rejected changes nothing.
    #[test]
    fn rows_are_bounded_and_checked() {
        let mut feed = Feed::with_most(&Options::default(), &Request::default(), 3).unwrap();
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
    }
}
