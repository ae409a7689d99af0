//! The whole simulator as a snapshot, and back.

use nalgebra::{Quaternion, Vector3};

use super::chain::Chain;
use super::heap::heap_simulator;
use super::navigator::Navigator;
use super::{Mode, Options, Simulator};
use crate::earth::Geodetic;
use crate::error::{Error, ErrorKind, Rule};
use crate::snapshot::{Reader, Stored, Writer};
use crate::state::Navigation;

/// Numbers of the modes in a snapshot.
const WAITING: usize = 0;
const FLYING: usize = 1;
const NAVIGATING: usize = 2;

impl Simulator {
    /// Bytes that a snapshot takes now; they change with what is set and with the samples that wait.
    pub fn snapshot_size(&self) -> usize {
        self.write_snapshot(&mut [])
    }

    /// Writes a snapshot into `buffer` and gives its length; it can be saved at any moment. No allocation.
    pub fn save_snapshot(&self, buffer: &mut [u8]) -> Result<usize, Error> {
        let capacity = buffer.len();
        let length = self.write_snapshot(buffer);
        if length <= capacity {
            return Ok(length);
        }
        let rule = Rule::AtLeast("is too small for the snapshot; needed:", length as f64);
        Err(Error::of(ErrorKind::BufferTooSmall, "capacity", capacity, rule))
    }

    /// Becomes the simulator of a snapshot, options included, whatever this one was: the run goes on to the same bits. Only
    /// [`Self::ideal_increments`] are empty until the next interval. Allocates.
    ///
    /// [`ErrorKind::Snapshot`]: not a snapshot, not whole, altered, or of a newer release; then nothing has changed.
    pub fn load_snapshot(&mut self, snapshot: &[u8]) -> Result<(), Error> {
        let damaged = |error| Error { kind: ErrorKind::Snapshot, ..error };
        let mut from = Reader::new(snapshot)?;
        let mut options = Options::default();
        options.load(&mut from).and_then(|()| options.validate()).map_err(damaged)?;
        let mut memory = heap_simulator(&options)?;
        let [loaded] = &mut *memory else { return Ok(()) };
        loaded.read_snapshot(from).map_err(damaged)?;
        core::mem::swap(self, loaded);
        Ok(())
    }

    /// The length of the snapshot, of which as much is written as `buffer` has room for.
    fn write_snapshot(&self, buffer: &mut [u8]) -> usize {
        let Self { options, earth: _, intake, sensors, signals: _, covariance, summary, mode } = self;
        let mut to = Writer::new(buffer);
        options.save(&mut to);
        sensors.save(&mut to);
        intake.save(&mut to);
        match mode {
            Mode::Waiting => {
                to.count(WAITING);
                summary.iter().for_each(|summary| summary.save(&mut to));
                covariance.iter().for_each(|covariance| covariance.save_waiting(&mut to));
            }
            Mode::Flying(chain) => {
                to.count(FLYING);
                chain.save(&mut to);
            }
            Mode::Navigating(navigator) => {
                to.count(NAVIGATING);
                navigator.save(&mut to);
            }
        }
        to.finish()
    }

    /// Takes the state over that stands behind the options, which this simulator was made with. Not inlined: its stack
    /// is not needed while memory for the simulator is made.
    #[inline(never)]
    fn read_snapshot(&mut self, mut from: Reader<'_>) -> Result<(), Error> {
        self.sensors.load(&mut from)?;
        self.intake.load(&mut from)?;
        let behind = self.intake.behind();
        let flown = behind.iter().flatten().count();
        from.enter("snapshot: mode");
        let mode = from.count(NAVIGATING)?;
        let samples = if mode == NAVIGATING { flown + self.intake.waiting() } else { flown };
        match mode {
            FLYING => {
                let current = Chain::flown_to(&behind, &mut from)?;
                // Made in its place: chains take much of a stack.
                self.mode = Mode::Flying(Chain::to_load(&self.options, self.earth, current, &self.sensors));
                if let Mode::Flying(chain) = &mut self.mode {
                    chain.signals = core::mem::take(&mut self.signals);
                    chain.set_summary(self.summary);
                    chain.covariance = core::mem::take(&mut self.covariance);
                    chain.load(&mut from)?;
                    chain.look_back(&behind);
                }
            }
            _ if samples > 0 => {
                from.enter("snapshot: samples that were flown");
                return Err(from.refused(samples as f64, Rule::Words("must be none without a flight")));
            }
            NAVIGATING => {
                let upright = Quaternion::identity();
                let anywhere =
                    Navigation::new(Geodetic::default(), Vector3::zeros(), upright, self.options.axes);
                let mut navigator = Navigator::new(&self.options, self.earth, 0.0, &anywhere);
                navigator.load(&mut from)?;
                self.mode = Mode::Navigating(navigator);
            }
            _ => {
                if let Some(summary) = &mut self.summary {
                    summary.load(&mut from)?;
                }
                self.covariance.iter_mut().try_for_each(|covariance| covariance.load_waiting(&mut from))?;
            }
        }
        if self.sensors.depend_on_temperature() {
            self.check_temperatures()?;
        }
        from.finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sensors::TriadParameters;
    use crate::truth::FlightSample;

    /// States that the simulator refuses to come to.
    #[test]
    fn a_forged_effect_without_its_temperature_is_refused() {
        let upright = Navigation::new(
            Geodetic::default(),
            Vector3::zeros(),
            Quaternion::identity(),
            Default::default(),
        );
        let mut waiting = Simulator::new(&Options::default()).unwrap();
        waiting.push_sample(&FlightSample::default()).unwrap();
        let mut navigating = Simulator::new(&Options::default()).unwrap();
        navigating.start_navigation(0.0, &upright).unwrap();
        for mut simulator in [waiting, navigating] {
            let mut buffer = [0; 8192];
            let length = simulator.save_snapshot(&mut buffer).unwrap();
            assert!(simulator.load_snapshot(&buffer[..length]).is_ok());

            let warm = Vector3::repeat(1e-6);
            simulator.sensors.set_gyro(&TriadParameters { bias_temperature: warm, ..Default::default() });
            let length = simulator.save_snapshot(&mut buffer).unwrap();
            let refused = simulator.load_snapshot(&buffer[..length]).unwrap_err();
            assert!(refused.kind == ErrorKind::Snapshot && refused.to_string().contains("temperature"));
        }
    }
}
