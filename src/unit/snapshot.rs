//! A unit as a snapshot, and back.

use super::{Mode, Unit, UnitParameters};
use crate::base::error::Error;
use crate::base::snapshot::{CLOCK_S, Reader, SIGNALS, SnapshotOf, Stored as _, Writer, fitting, stored};
use crate::truth::INTERVALS_S;

stored!(Unit {
    parameters, kind, selector, power, state, state_s: CLOCK_S, time_s: CLOCK_S, entered, refused, place_e: SIGNALS, stored, switched_on_e: SIGNALS, q_bs: 2.0, axes,
    inertial, motion, alignment, q_il: 2.0, heading_entered, realigned, reasons, found_latitude_rad: 1.6, latitude_failures: 2.0,
    has_signal, age_s: CLOCK_S, invalid_s: CLOCK_S, on_battery_s: CLOCK_S, kept_s: CLOCK_S, test_s: CLOCK_S, in_navigation_s: CLOCK_S, measured,
    interval_s: INTERVALS_S.1
} rebuilt { limits } then |unit, from| {
    unit.parameters.validate()?;
    unit.limits = unit.parameters.with_defaults();
    let sizes = unit.q_bs.norm_squared().min(unit.q_il.norm_squared());
    from.require(sizes > 0.9, sizes, "is not of size 1")?;
    from.require(unit.interval_s >= INTERVALS_S.0, unit.interval_s, "is no length of an interval")?;
    let clocks = [unit.age_s, unit.state_s, unit.invalid_s, unit.on_battery_s, unit.kept_s, unit.test_s, unit.in_navigation_s];
    let least = clocks.into_iter().chain(unit.alignment.clocks()).fold(0.0, f64::min);
    from.require(least >= 0.0, least, "is a time before the start")
});

// A field takes at most as many bytes as in memory, and two bits for its size. The limits, which are not stored, are more than the bits of
// all flags and the header.
const _: () = assert!(size_of::<Unit>() + size_of::<Unit>() / 32 <= Unit::SNAPSHOT_MAX_SIZE);

impl Unit {
    /// A buffer of this size holds every snapshot of a unit.
    pub const SNAPSHOT_MAX_SIZE: usize = 2048;

    /// Writes a snapshot into `buffer` and returns its length. The call does not allocate.
    pub fn save_snapshot(&self, buffer: &mut [u8]) -> Result<usize, Error> {
        let capacity = buffer.len();
        let mut to = Writer::new(buffer, SnapshotOf::Unit);
        self.save(&mut to);
        fitting(to.finish(), capacity)
    }

    /// Becomes the unit of a snapshot. On an error nothing has changed.
    pub fn load_snapshot(&mut self, snapshot: &[u8]) -> Result<(), Error> {
        *self = Reader::read(snapshot, SnapshotOf::Unit, |from| {
            let mut unit = Self::new(&UnitParameters::default(), Mode::Off)?;
            unit.load(from)?;
            Ok(unit)
        })?;
        Ok(())
    }
}
