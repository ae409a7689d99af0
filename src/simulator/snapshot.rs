//! The whole simulator as a snapshot, and back.

use nalgebra::{Quaternion, Vector3};

use super::chain::Chain;
use super::navigator::Navigator;
use super::{Imperfections, Mode, Options, Simulator, heap_simulator};
use crate::base::error::{Error, Rule};
use crate::base::snapshot::{Reader, SnapshotOf, Stored, Writer, fitting};
use crate::earth::Geodetic;
use crate::earth::state::Navigation;
use crate::truth::Intake;

/// Numbers of the modes in a snapshot.
const WAITING: usize = 0;
const FLYING: usize = 1;
const NAVIGATING: usize = 2;

/// Writes the words of a simulator that waits, or flies `chain`.
pub(super) fn save_flight(
    options: &Options,
    imperfections: &Imperfections,
    intake: &Intake,
    chain: Option<&Chain>,
    to: &mut Writer<'_>,
) {
    options.save(to);
    imperfections.save(to);
    intake.save(to);
    match chain {
        None => to.count(WAITING),
        Some(chain) => {
            to.count(FLYING);
            chain.save(to);
        }
    }
}

impl Simulator {
    /// Current size of a snapshot [bytes]. It changes with the settings and with the samples that wait.
    pub fn snapshot_size(&self) -> usize {
        self.write_snapshot(&mut [])
    }

    /// Writes a snapshot into `buffer` and returns its length. A snapshot can be saved at any moment. The call does not allocate.
    pub fn save_snapshot(&self, buffer: &mut [u8]) -> Result<usize, Error> {
        let capacity = buffer.len();
        fitting(self.write_snapshot(buffer), capacity)
    }

    /// Becomes the simulator of a snapshot, options included, whatever this simulator was before. The run continues to the same
    /// bits; only [`Self::ideal_increments`] are empty until the next interval. The call allocates.
    ///
    /// [`crate::ErrorKind::Snapshot`]: not a snapshot, not whole, altered, or of another release; then nothing has changed.
    pub fn load_snapshot(&mut self, snapshot: &[u8]) -> Result<(), Error> {
        let mut memory = Reader::read(snapshot, SnapshotOf::Simulator, Self::load_from)?;
        core::mem::swap(self, &mut memory[0]);
        Ok(())
    }

    /// The simulator that [`Self::save_to`] wrote.
    pub(crate) fn load_from(from: &mut Reader<'_>) -> Result<Box<[Self; 1]>, Error> {
        let mut options = Options::default();
        options.load(from).and_then(|()| options.validate())?;
        let mut memory = heap_simulator(&options)?;
        memory[0].read_snapshot(from)?;
        Ok(memory)
    }

    /// Writes the part of the snapshot for which `buffer` has room. Returns the length of the whole snapshot.
    fn write_snapshot(&self, buffer: &mut [u8]) -> usize {
        let mut to = Writer::new(buffer, SnapshotOf::Simulator);
        self.save_to(&mut to);
        to.finish()
    }

    /// Writes the words of the simulator.
    pub(crate) fn save_to(&self, to: &mut Writer<'_>) {
        let Self { options, earth: _, intake, imperfections, signals: _, covariance, summary, mode } = self;
        match mode {
            Mode::Waiting => {
                save_flight(options, imperfections, intake, None, to);
                summary.as_slice().save(to);
                covariance.iter().for_each(|covariance| covariance.save_waiting(to));
            }
            Mode::Flying(chain) => save_flight(options, imperfections, intake, Some(chain), to),
            Mode::Navigating(navigator) => {
                options.save(to);
                imperfections.save(to);
                intake.save(to);
                to.count(NAVIGATING);
                navigator.save(to);
            }
        }
    }

    /// Takes over the state that follows the options in a snapshot. This simulator was made with these options. Not inlined: its
    /// stack is not needed while memory for the simulator is allocated.
    #[inline(never)]
    fn read_snapshot(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        self.imperfections.load(from)?;
        self.intake.load(from)?;
        let behind = self.intake.behind();
        let flown = behind.iter().flatten().count();
        from.enter("snapshot: mode");
        let mode = from.count(NAVIGATING)?;
        let samples = if mode == NAVIGATING { flown + self.intake.waiting() } else { flown };
        match mode {
            FLYING => {
                let Some(current) = behind[0] else {
                    from.enter("snapshot: samples that were flown");
                    return Err(from.refused(0.0, Rule::Sentence("must be at least 1 in flight")));
                };
                // The chain is made in its final place, because chains take much stack.
                self.mode =
                    Mode::Flying(Chain::to_load(&self.options, self.earth, current, &self.imperfections));
                if let Mode::Flying(chain) = &mut self.mode {
                    chain.signals = core::mem::take(&mut self.signals);
                    chain.set_summary(self.summary);
                    chain.covariance = core::mem::take(&mut self.covariance);
                    chain.load(from)?;
                    chain.look_back(&behind);
                }
            }
            _ if samples > 0 => {
                from.enter("snapshot: samples that were flown");
                return Err(from.refused(samples as f64, Rule::Sentence("must be 0 without a flight")));
            }
            NAVIGATING => {
                let upright = Quaternion::identity();
                let anywhere =
                    Navigation::new(Geodetic::default(), Vector3::zeros(), upright, self.options.axes);
                let mut navigator = Navigator::new(&self.options, self.earth, 0.0, &anywhere);
                navigator.load(from)?;
                self.mode = Mode::Navigating(navigator);
            }
            _ => {
                self.summary.as_mut_slice().load(from)?;
                self.covariance.iter_mut().try_for_each(|covariance| covariance.load_waiting(from))?;
            }
        }
        if self.imperfections.depend_on_temperature() {
            self.check_temperatures()?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::error::ErrorKind;
    use crate::truth::FlightSample;

    /// States that the simulator refuses to enter.
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
            simulator.imperfections.change(|set| set.gyro.bias_temperature = warm);
            let length = simulator.save_snapshot(&mut buffer).unwrap();
            let refused = simulator.load_snapshot(&buffer[..length]).unwrap_err();
            assert!(refused.kind == ErrorKind::Snapshot && refused.to_string().contains("temperature"));
        }
    }
}
