//! Quaternions, whose axes and sense no name states.

use csv::StringRecord;

use super::attitude::{BETTER, FITS, QUARTER};
use super::{ATTITUDE, Draft, QUATERNION, Question};
use crate::base::math::atan2;

impl Draft<'_> {
    /// A quaternion is read if its heading follows the track as that of forward-right-down axes against north-east-down, or of the opposite
    /// rotation, and asked about otherwise: many are of other axes.
    pub(super) fn quaternion(&mut self) {
        let found: Vec<&str> = QUATERNION.into_iter().filter(|key| self.value(key).is_some()).collect();
        if found.is_empty() {
            return;
        }
        if !self.has_all(&QUATERNION) || self.has_all(&ATTITUDE) || self.is_attitude_asked {
            let why =
                if self.has_all(&QUATERNION) { "angles are the attitude" } else { "there are not four" };
            let sentence = format!("left out: {}; {why}", found.join(", "));
            self.doubt(sentence);
            return QUATERNION.into_iter().for_each(|key| self.remove(key));
        }
        let reading = self.reading();
        let turn = |is_reversed: bool, is_from_east: bool| {
            let motion = self.motion_with(|cells| self.heading_of(cells, is_reversed))?;
            motion.first_place(reading, false)?;
            let heading = |yaw: f64| if is_from_east { QUARTER - yaw } else { yaw };
            motion.turn(reading, heading)
        };
        let readings = [(false, false), (true, false), (false, true), (true, true)];
        let mut turns: Vec<((bool, bool), f64)> = readings
            .into_iter()
            .filter_map(|reading @ (is_reversed, is_from_east)| {
                Some((reading, turn(is_reversed, is_from_east)?))
            })
            .collect();
        turns.sort_by(|(_, one), (_, other)| one.total_cmp(other));
        let best = match turns[..] {
            [(best, least), (_, next), ..] if least < FITS && BETTER * least < next => Some(best),
            _ => None,
        };
        match best {
            Some((is_reversed, false)) => {
                for key in QUATERNION.into_iter().skip(1).filter(|_| is_reversed) {
                    let Some(place) = self.place(key) else { continue };
                    self.replace(key, self.column(place, ", sign = -1"));
                }
                let sense = if is_reversed {
                    "from north-east-down to the body"
                } else {
                    "from the body to north-east-down"
                };
                self.doubt(format!("the quaternion is taken as one {sense}, forward-right-down: its heading follows the track"));
            }
            _ => {
                let answers: Vec<String> = QUATERNION
                    .iter()
                    .filter_map(|key| Some(format!("{key} = {}", self.column(self.place(key)?, ""))))
                    .collect();
                let own = answers.join("\n") + "  # forward-right-down to north-east-down";
                let none = "attitude = \"coordinated\"  # it is not read".to_owned();
                QUATERNION.into_iter().for_each(|key| self.remove(key));
                self.is_attitude_asked = true;
                let sentence = "the heading of the quaternion does not follow the track as one from north: of which axes is it?";
                self.ask(Question { sentence: sentence.to_owned(), answers: vec![own, none] });
            }
        }
    }

    /// The heading of the quaternion in a row \[rad\].
    fn heading_of(&self, cells: &StringRecord, is_reversed: bool) -> Option<f64> {
        let [w, x, y, z] = QUATERNION.map(|key| self.number_of(cells, key));
        let (w, x, y, z) = (w?, x?, y?, z?);
        let w = if is_reversed { -w } else { w };
        Some(atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z))
    }
}
