//! A scene in flight as a snapshot, and back: the place in the plan, then the simulator, then the unit.

use super::{Itinerary, Play};
use crate::base::error::Error;
use crate::base::snapshot::{Reader, SnapshotOf, Stored as _, Writer, fitting};
use crate::simulator::Simulator;
use crate::unit::{Mode, Unit, UnitParameters};

impl Play {
    /// Bytes that a snapshot takes now.
    pub fn snapshot_size(&self) -> usize {
        self.itinerary.write_snapshot(self.simulator(), self.unit(), &mut [])
    }

    /// Writes a snapshot of simulator, unit and place in the plan into `buffer`, and returns its length. No allocation.
    pub fn save_snapshot(&self, buffer: &mut [u8]) -> Result<usize, Error> {
        self.itinerary.save_snapshot(self.simulator(), self.unit(), buffer)
    }

    /// Continues from a snapshot of the same scene on the same samples, to the same bits. On an error nothing has changed. Allocates.
    pub fn load_snapshot(&mut self, snapshot: &[u8]) -> Result<(), Error> {
        let (simulator, unit) = self.itinerary.load_snapshot(self.unit.is_some(), snapshot)?;
        (self.simulator, self.unit) = (simulator, unit);
        Ok(())
    }
}

impl Itinerary {
    pub(crate) fn save_snapshot(
        &self,
        simulator: &Simulator,
        unit: Option<&Unit>,
        buffer: &mut [u8],
    ) -> Result<usize, Error> {
        let capacity = buffer.len();
        fitting(self.write_snapshot(simulator, unit, buffer), capacity)
    }

    fn write_snapshot(&self, simulator: &Simulator, unit: Option<&Unit>, buffer: &mut [u8]) -> usize {
        let mut to = Writer::new(buffer, SnapshotOf::Play);
        self.place.save(&mut to);
        simulator.save_to(&mut to);
        to.flag(unit.is_some());
        if let Some(unit) = unit {
            unit.save(&mut to);
        }
        to.finish()
    }

    /// Becomes the itinerary of a snapshot, whose simulator and unit it returns. `has_unit`: whether the scene has one.
    pub(crate) fn load_snapshot(
        &mut self,
        has_unit: bool,
        snapshot: &[u8],
    ) -> Result<(Box<[Simulator; 1]>, Option<Unit>), Error> {
        let mut place = self.place;
        // A unit is large: it is read in its place, not handed from one frame of the stack to the next.
        let mut unit = match has_unit {
            true => Some(Unit::new(&UnitParameters::default(), Mode::Off)?),
            false => None,
        };
        let simulator = Reader::read(snapshot, SnapshotOf::Play, |from| {
            place.load(from)?;
            let all = self.count().unwrap_or(u64::MAX);
            from.enter("snapshot: samples that were flown");
            from.require(place.taken <= all, place.taken as f64, "is more than the scene has")?;
            let simulator = Simulator::load_from(from)?;
            from.enter("snapshot: options");
            let same = *simulator[0].options() == self.scene().simulator_options();
            from.require(
                same,
                place.taken as f64,
                "samples: it is of a scene with other options, or of another run",
            )?;
            from.enter("snapshot: unit");
            let saved_unit = from.flag()?;
            from.require(
                saved_unit == has_unit,
                f64::from(saved_unit),
                "is there or not, unlike that of the scene",
            )?;
            if let Some(unit) = &mut unit {
                unit.load(from)?;
            }
            Ok(simulator)
        })?;
        self.place = place;
        Ok((simulator, unit))
    }
}
