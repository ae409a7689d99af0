//! The whole simulator as a snapshot, and back.

use nalgebra::{Quaternion, Vector3};

use super::chain::Chain;
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
        let rule = Rule::WordsAnd("is too small for the snapshot; needed:", length as f64);
        Err(Error::of(ErrorKind::BufferTooSmall, "capacity", capacity as f64, rule))
    }

    /// Becomes the simulator of a snapshot, options included, whatever this one was: the run goes on to the same bits. Only
    /// [`Self::ideal_increments`] are empty until the next interval.
    ///
    /// [`ErrorKind::Snapshot`]: not a snapshot, not whole, altered, or of a newer release; then nothing has changed.
    pub fn load_snapshot(&mut self, snapshot: &[u8]) -> Result<(), Error> {
        *self = Self::of_snapshot(snapshot).map_err(|error| Error { kind: ErrorKind::Snapshot, ..error })?;
        Ok(())
    }

    /// The length of the snapshot, of which as much is written as `buffer` has room for.
    fn write_snapshot(&self, buffer: &mut [u8]) -> usize {
        let Self { options, earth: _, intake, sensors, mode } = self;
        let mut to = Writer::new(buffer);
        options.save(&mut to);
        sensors.save(&mut to);
        intake.save(&mut to);
        match mode {
            Mode::Waiting => to.count(WAITING),
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

    fn of_snapshot(snapshot: &[u8]) -> Result<Self, Error> {
        let mut from = Reader::new(snapshot)?;
        let mut options = Options::default();
        options.load(&mut from)?;
        let mut simulator = Self::new(&options)?;
        simulator.sensors.load(&mut from)?;
        simulator.intake.load(&mut from)?;
        from.enter("snapshot: mode");
        match from.count(NAVIGATING)? {
            FLYING => {
                let behind = simulator.intake.behind();
                simulator.mode = Mode::Flying(Chain::load(&options, simulator.earth, &behind, &mut from)?);
            }
            mode => {
                let behind = simulator.intake.behind().iter().flatten().count();
                let kept = if mode == WAITING { behind } else { behind + simulator.intake.waiting() };
                if kept > 0 {
                    from.enter("snapshot: samples that were flown");
                    return Err(from.refused(kept as f64, Rule::Words("must be none before the first step")));
                }
                if mode == NAVIGATING {
                    let place = Geodetic::default();
                    let upright = Quaternion::identity();
                    let anywhere = Navigation::new(place, Vector3::zeros(), upright, options.axes);
                    let mut navigator = Navigator::new(&options, simulator.earth, 0.0, &anywhere);
                    navigator.load(&mut from)?;
                    simulator.mode = Mode::Navigating(navigator);
                }
            }
        }
        from.finish()?;
        Ok(simulator)
    }
}
