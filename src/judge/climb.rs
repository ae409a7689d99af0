//! Heights and climbs that no vehicle has but a rocket: those of another unit.

use super::positions::Largest;
use super::row::Row;

/// Time over which a climb is taken [s]: noise and steps of a row are none.
const OVER_S: f64 = 1.0;

/// Largest height [m], and largest climb [m/s], of what is neither a rocket nor in an orbit.
const HIGHEST_M: f64 = 1e5;
const FASTEST_M_S: f64 = 1e3;

/// Speed over ground of an orbit [m/s]: that of the highest one with a period of a fifth of a day or less.
const ORBIT_M_S: f64 = 3e3;

/// The heights of a flight.
#[derive(Debug, Clone)]
pub(super) struct Climb {
    /// Time, way and climb since the last mark [s, m].
    since: [f64; 3],
    /// Largest speed over ground [m/s].
    along_m_s: f64,
    up_m_s: Largest,
    height_m: Largest,
}

/// What is unlikely about them.
pub(super) enum Unlikely {
    Height(Largest),
    Climb(Largest),
}

impl Climb {
    pub const fn new() -> Self {
        Self { since: [0.0; 3], along_m_s: 0.0, up_m_s: Largest::ZERO, height_m: Largest::ZERO }
    }

    pub fn add(&mut self, row: &Row) {
        self.height_m.take(row.place.height_m, row.at);
        let [time_s, way_m, up_m] = &mut self.since;
        *time_s += row.interval_s;
        *way_m += row.step_m();
        *up_m += row.d_n.z;
        if *time_s >= OVER_S {
            self.along_m_s = self.along_m_s.max(*way_m / *time_s);
            self.up_m_s.take(up_m.abs() / *time_s, row.at);
            self.since = [0.0; 3];
        }
    }

    pub fn unlikely(&self) -> Option<Unlikely> {
        let found = match (self.height_m, self.up_m_s) {
            (height_m, _) if height_m.value > HIGHEST_M => Unlikely::Height(height_m),
            (_, up_m_s) if up_m_s.value > FASTEST_M_S => Unlikely::Climb(up_m_s),
            _ => return None,
        };
        (self.along_m_s < ORBIT_M_S).then_some(found)
    }
}
