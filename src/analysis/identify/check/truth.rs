//! The true states along a path, at any time.

use super::super::path::{IdealPath, six_increment};
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
    /// Flies `samples` with perfect sensors.
    pub fn fly(
        options: &Options,
        samples: impl Iterator<Item = Result<FlightSample, Error>>,
    ) -> Result<Self, Refusal> {
        let options = Options { covariance: false, error_model: false, truth_summary: false, ..*options };
        let (mut flown, mut times_s, mut states) = (Vec::new(), Vec::new(), Vec::new());
        let kept = samples.map(|sample| {
            let sample = sample?;
            room_for_one_more(&mut flown)?;
            flown.push(sample);
            Ok(sample)
        });
        let path = IdealPath::fly_reading(&options, kept, |simulator| {
            if let Some(truth) = simulator.truth()? {
                room_for_one_more(&mut times_s)?;
                room_for_one_more(&mut states)?;
                times_s.push(truth.time_s);
                states.push(truth.navigation);
            }
            Ok(())
        })?;
        Ok(Self { options, earth: options.earth(), samples: flown, times_s, states, path })
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
