//! The true states along a path, at any time.

use super::super::path::{IdealPath, of_path, six_increment};
use crate::analysis::recommend::Refusal;
use crate::base::error::Error;
use crate::base::memory::room_for_one_more;
use crate::earth::Earth;
use crate::earth::state::Navigation;
use crate::simulator::{Options, Simulator};
use crate::truth::{FlightSample, MIN_INTERVAL_S};

/// A path with its states.
#[derive(Debug, Clone)]
pub struct Truth {
    pub(super) options: Options,
    pub(super) earth: Earth,
    pub(super) samples: Vec<FlightSample>,
    times_s: Vec<f64>,
    states: Vec<Navigation>,
    path: IdealPath,
}

impl Truth {
    /// Without samples. Of `options`, Earth, gravity, body axes and the checks of samples count.
    pub(in super::super) fn new(options: &Options) -> Self {
        let options = of_path(options);
        Self {
            options,
            earth: options.earth(),
            samples: Vec::new(),
            times_s: Vec::new(),
            states: Vec::new(),
            path: IdealPath::default(),
        }
    }

    /// Flies `samples` with perfect sensors. Of `options`, Earth, gravity, body axes and the checks of samples count.
    pub fn fly(
        options: &Options,
        samples: impl Iterator<Item = Result<FlightSample, Error>>,
    ) -> Result<Self, Refusal> {
        let mut truth = Self::new(options);
        let mut flown = Vec::new();
        let kept = samples.map(|sample| {
            let sample = sample?;
            room_for_one_more(&mut flown)?;
            flown.push(sample);
            Ok(sample)
        });
        let path = IdealPath::fly_reading(options, kept, |simulator| truth.push_state(simulator))?;
        Ok(Self { samples: flown, path, ..truth })
    }

    /// Makes room for the interval of a sample; with `keeps_states` for the sample and its state too.
    pub(in super::super) fn make_room(&mut self, keeps_states: bool) -> Result<(), Error> {
        self.path.make_room()?;
        if keeps_states {
            room_for_one_more(&mut self.samples)?;
            room_for_one_more(&mut self.times_s)?;
            room_for_one_more(&mut self.states)?;
        }
        Ok(())
    }

    /// Adds a sample of the path: its temperature, and with `keeps_states` all of it.
    pub(in super::super) fn push_sample(
        &mut self,
        sample: &FlightSample,
        keeps_states: bool,
    ) -> Result<(), Error> {
        self.path.push_temperature(sample)?;
        if keeps_states {
            room_for_one_more(&mut self.samples)?;
            self.samples.push(*sample);
        }
        Ok(())
    }

    /// Adds the interval that `simulator` has flown; with `keeps_states` its state too.
    pub(in super::super) fn push_interval(
        &mut self,
        simulator: &Simulator,
        keeps_states: bool,
    ) -> Result<(), Error> {
        let Some(imu) = simulator.imu() else { return Ok(()) };
        self.path.push(imu.time_s, imu.interval_s, &imu.ideal)?;
        if keeps_states { self.push_state(simulator) } else { Ok(()) }
    }

    /// Adds the state at the end of an interval.
    fn push_state(&mut self, simulator: &Simulator) -> Result<(), Error> {
        if let Some(truth) = simulator.truth()? {
            room_for_one_more(&mut self.times_s)?;
            room_for_one_more(&mut self.states)?;
            self.times_s.push(truth.time_s);
            self.states.push(truth.navigation);
        }
        Ok(())
    }

    /// The path that sensors are identified along.
    pub fn path(&self) -> &IdealPath {
        &self.path
    }

    /// First and last time of the states [s].
    pub(super) fn ends_s(&self) -> Result<(f64, f64), Error> {
        let ends = (self.times_s.first().copied(), self.times_s.last().copied());
        let (Some(first), Some(last)) = ends else {
            return Err(Error::bad_state("the path must have at least four intervals"));
        };
        Ok((first, last))
    }

    /// The state at `time_s` [s]: that of the sample before, which perfect sensors navigate to this time. `None` outside the path.
    pub(super) fn at(&self, time_s: f64) -> Result<Option<Navigation>, Error> {
        let behind = self.times_s.partition_point(|&time| time <= time_s);
        let Some(mut place) = behind.checked_sub(1) else { return Ok(None) };
        if self.times_s[place] == time_s {
            return Ok(Some(self.states[place]));
        }
        // No interval is shorter than the shortest that can be navigated.
        if time_s - self.times_s[place] < MIN_INTERVAL_S {
            let Some(before) = place.checked_sub(1) else { return Ok(None) };
            place = before;
        }
        let (from_s, length_s) = (self.times_s[place], time_s - self.times_s[place]);
        let Some((mean, _)) = self.path.mean(from_s, time_s) else { return Ok(None) };
        let mut simulator = Simulator::new(&self.options)?;
        simulator.start_navigation(from_s, &self.states[place])?;
        simulator.push_imu(&[six_increment(&(mean * length_s))], length_s)?;
        Ok(simulator.navigation()?.map(|solution| solution.navigation))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::identify::path::Six;

    /// What the interface says of the memory of a path: 56 bytes a sample, with states 336.
    #[test]
    fn the_memory_of_a_sample_is_that_of_the_interface() {
        let path = size_of::<f64>() + size_of::<Six>();
        let states = size_of::<FlightSample>() + size_of::<f64>() + size_of::<Navigation>();
        assert_eq!((path, path + states), (56, 336));
    }
}
