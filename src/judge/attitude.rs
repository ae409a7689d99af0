//! Attitude against the path: heading and track, roll and the bank of turns, pitch and climb.

use nalgebra::Vector3;

use super::blocks::{Block, Coarseness, End};
use super::crab::Crab;
use super::delay::{Banked, HeadingDelay, RollDelay, UPRIGHT};
use super::direction::Direction;
use super::finding::{Clue, Level, RADIANS};
use super::held::{Held, Stretches};
use super::regression::Regression;
use super::straight::Straight;
use crate::base::math::{atan, atan2, hypot, sin_cos, wrap_angle};
use crate::base::units::{DEG, STANDARD_GRAVITY as G};

/// Blocks that a judgement needs.
const LEAST: f64 = 9.0;

/// Length of the mean direction of the track below which a flight goes in all directions.
const ALL_ROUND: f64 = 0.3;

/// Slope of the roll on the bank above which a vehicle leans out of its turns: a car by a tenth to a fifth of the bank of an aeroplane.
const LEANS: f64 = -0.3;

/// Turn of the track above which an attitude that stays the same is not that of the vehicle, and a heading that does: one that is logged
/// at 1 Hz stays the same for less.
const TURN_WHILE_HELD: f64 = 10.0 * DEG;
const TURN_WHILE_HEADING_HELD: f64 = 20.0 * DEG;

/// The same of a roll alone, and how far it is from the bank of the turn \[rad\].
const TURN_WHILE_ROLL_HELD: f64 = 20.0 * DEG;
const OFF_WHILE_ROLL_HELD: f64 = 10.0 * DEG;

/// Blocks of turns that a judgement of the roll needs: in aerobatics half a minute is flown inverted.
const LEAST_OF_TURNS: f64 = 15.0;

/// Angle off the track of a vehicle that flies sideways, such as a drone whose camera looks to the middle of its circle.
const SIDEWAYS: f64 = 45.0 * DEG;

/// What a heading may be instead: sign and factor.
const HEADINGS: [(&str, f64); 5] = [
    ("", 1.0),
    ("anticlockwise, or the opposite sign", -1.0),
    ("degrees taken for radians", DEG),
    (RADIANS, 1.0 / DEG),
    ("radians taken for degrees, anticlockwise", -1.0 / DEG),
];

/// Turns of the track, all added, below which a heading of its own turns as the track by chance \[rad\]; and least share of them, less that
/// of the opposite turns, in which a heading that leads the track turns with it.
const TWO_CIRCLES: f64 = 720.0 * DEG;
const LEADS: f64 = 0.5;

/// Blocks of turns in which an aeroplane shows, and correlation of its roll with the bank of the turns. The roll of a drone is its bank
/// times the cosine of its heading off the track, which has that correlation by chance only where it turns little.
const LEAST_OF_AEROPLANE: f64 = 5.0;
const BANKS: f64 = 0.9;

/// Mean speeds at which the nose leads the track, as nothing flies sideways or is in orbit [m/s].
const FAST_M_S: core::ops::Range<f64> = 40.0..1000.0;

/// Slopes of a roll in radians that is read as degrees: 1/57.3, and what slips and attack make of it.
const IN_RADIANS: core::ops::Range<f64> = 0.012..0.024;

/// Error of a heading that is found in a flight in all directions, and in one that turns, where a wind that changes turns a nose by less
/// [rad].
const OFF_ALL_ROUND: f64 = 5.0 * DEG;
const OFF_IN_TURNS: f64 = 10.0 * DEG;

/// The same of a flight that turns a little: both the angle off the track and what is left of it without a constant wind \[rad\].
const OFF_IN_LITTLE_TURNS: f64 = 20.0 * DEG;

/// The same of any flight, where it needs a wind across the nose of this speed \[m/s\].
const OFF_IN_ANY_WIND: f64 = 25.0 * DEG;
const WIND_M_S: f64 = 30.0;

/// Lengths of the mean direction of the track below which a flight turns enough, and a little, to tell the wind from an error of the
/// heading.
const TURNS: f64 = 0.95;
const TURNS_LITTLE: f64 = 0.98;

/// Bank and roll of a flight straight on, in which the nose of a glider does not follow the air \[rad\].
const STRAIGHT: f64 = 10.0 * DEG;

/// Turns of the track, all added, by which those of the heading are judged \[rad\]; squares of their difference, as a share of those of the
/// turns, which are none of the wind's, and which are.
const TURNED: f64 = 90.0 * DEG;
const DIFFER: f64 = 0.5;
const EQUAL: f64 = 0.1;

/// How many times the roll is the bank of turns, and least deviation of such a roll \[rad\].
const AS_FAR: core::ops::Range<f64> = 0.4..2.5;
const ROLLS: f64 = 5.0 * DEG;

/// What is wrong with a pitch that the angle of the path contradicts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum PitchFault {
    Opposite,
    Radians,
    HeightInFeet,
}

#[derive(Debug, Clone)]
pub(super) struct Attitudes {
    count: f64,
    track: Direction,
    headings: [Direction; 5],
    crab: Crab,
    /// Sum of the speeds [m/s].
    speeds: f64,
    /// The track and the heading before \[rad\], Σ |turn of the track|, and of it that in which the heading turns with it, less the rest.
    before: Option<[f64; 2]>,
    turned: f64,
    turned_with: f64,
    /// Σ turn² of the track, and of what turns of the heading by the factors of [`HEADINGS`] differ from those of the track \[rad²\].
    turned2: f64,
    differ2: [f64; 5],
    /// Blocks that turn, those of them with the sign of the turn, Σ roll bank, Σ bank², Σ pitch bank, Σ roll².
    turns: [f64; 6],
    pub straight: Straight,
    heading_delay: HeadingDelay,
    roll_delay: RollDelay,
    /// Roll on the bank that the turn needs, where it does not stay the same.
    rolls: Regression,
    /// Pitch on the angle of the path, and that of the flight straight on.
    climb: Regression,
    straight_climb: Regression,
    /// Held attitudes, headings, and rolls.
    held: [Stretches; 3],
}

impl Attitudes {
    pub const fn new() -> Self {
        Self {
            count: 0.0,
            track: Direction::NONE,
            headings: [Direction::NONE; 5],
            crab: Crab::NONE,
            speeds: 0.0,
            before: None,
            turned: 0.0,
            turned_with: 0.0,
            turned2: 0.0,
            differ2: [0.0; 5],
            turns: [0.0; 6],
            straight: Straight::NONE,
            heading_delay: HeadingDelay::NONE,
            roll_delay: RollDelay::NONE,
            rolls: Regression::NONE,
            climb: Regression::NONE,
            straight_climb: Regression::NONE,
            held: [Stretches::NONE; 3],
        }
    }

    /// Adds the attitude between two blocks, the one that ends at `end` and the next.
    pub fn add(&mut self, blocks: [&Block; 2], end: &End, coarse: &Coarseness) {
        let local = |block: &Block| {
            let [east, north, up] = end.axes.map(|axis| axis.dot(&block.d_e));
            Vector3::new(east, north, up)
        };
        let [first, second] = blocks.map(local);
        let length_s = blocks[0].length_s + blocks[1].length_s;
        let v = (first + second) / length_s;
        let speed = hypot(v.x, v.y);
        let least = (40.0 * coarse.horizontal_m / length_s).max(5.0);
        if [first, second].iter().any(|d| hypot(d.x, d.y) < 0.5 * least * length_s) {
            self.before = None;
            self.roll_delay.pause();
            self.heading_delay.pause();
            return;
        }
        self.count += 1.0;
        self.speeds += speed;
        let track = atan2(v.x, v.y);
        self.track.add(track);
        let (roll, pitch) = (wrap_angle(end.euler.roll), wrap_angle(end.euler.pitch));
        for (sum, (_, factor)) in self.headings.iter_mut().zip(HEADINGS) {
            sum.add(wrap_angle(end.euler.heading * factor - track));
        }
        self.crab.add([v.x, v.y], end.euler.heading);
        self.add_turn(track, end.euler.heading, roll, speed / G, 0.5 * length_s);
        let turn = wrap_angle(atan2(second.x, second.y) - atan2(first.x, first.y));
        let bank = atan(speed * turn / (0.5 * length_s) / G);
        if (5.0 * DEG..75.0 * DEG).contains(&bank.abs()) && sin_cos(pitch).1.abs() > 0.5 {
            let has_sign = f64::from(u8::from((roll < 0.0) == (bank < 0.0) && roll != 0.0));
            for (sum, term) in self.turns.iter_mut().zip([
                1.0,
                has_sign,
                roll * bank,
                bank * bank,
                pitch * bank,
                roll * roll,
            ]) {
                *sum += term;
            }
        }
        let is_upright = roll.abs().max(bank.abs()) < UPRIGHT;
        let is_roll_held = blocks.iter().all(|block| block.is_roll_held);
        if is_upright && !is_roll_held {
            self.rolls.add(bank, roll);
        }
        let is_roll_off = is_upright && (roll - bank).abs() > OFF_WHILE_ROLL_HELD;
        for (stretches, is_held, limit) in [
            (0, blocks.iter().all(|block| block.is_held), TURN_WHILE_HELD),
            (1, blocks.iter().all(|block| block.is_heading_held), TURN_WHILE_HEADING_HELD),
            (2, is_roll_held && is_roll_off, TURN_WHILE_ROLL_HELD),
        ] {
            self.held[stretches].add(blocks[0], is_held, turn, limit);
        }
        let mean = (blocks[0].rolled + blocks[1].rolled) / length_s;
        self.roll_delay.add(Banked { bank, roll, mean }, 0.5 * length_s);
        let path = atan2(v.z, speed);
        self.straight.add(roll, [pitch, path], bank);
        if speed > 15.0 && roll.abs() < 1.0 && path.abs() < 1.2 && coarse.up_m < 0.02 * speed * length_s {
            self.climb.add(path, pitch);
            if roll.abs().max(bank.abs()) < STRAIGHT {
                self.straight_climb.add(path, pitch);
            }
        }
    }

    /// `tangent`: that of the bank that a turn needs, over its rate [s/rad]; `between_s`: time between two blocks [s].
    fn add_turn(&mut self, track: f64, heading: f64, roll: f64, tangent: f64, between_s: f64) {
        if let Some([track_before, heading_before]) = self.before {
            let turn = wrap_angle(track - track_before);
            let of_heading = wrap_angle(heading - heading_before);
            self.straight.add_turn(of_heading, turn, roll, atan(tangent * of_heading / between_s));
            self.heading_delay.add([turn, of_heading], between_s);
            let with = of_heading * turn;
            self.turned += turn.abs();
            self.turned_with += if with == 0.0 { 0.0 } else { turn.abs().copysign(with) };
            self.turned2 += turn * turn;
            for (sum, (_, factor)) in self.differ2.iter_mut().zip(HEADINGS) {
                let differs = wrap_angle((heading - heading_before) * factor) - turn;
                *sum += differs * differs;
            }
        }
        self.before = Some([track, heading]);
    }

    /// The stretch of held attitude in which the track turns farthest, if it turns, and how many such there are.
    pub fn held(&self) -> Option<(Held, u64)> {
        self.held[0].found()
    }

    /// The same of the heading alone, of what banks as an aeroplane or is fast.
    pub fn heading_held(&self) -> Option<(Held, u64)> {
        self.held[1].found().filter(|_| self.is_aeroplane() || self.is_fast())
    }

    /// The same of the roll alone, if it is the bank of the turns elsewhere.
    pub fn roll_held(&self) -> Option<(Held, u64)> {
        let (_, slope, correlation) = self.rolls.figures();
        let banks = self.rolls.count >= LEAST && correlation > BANKS && AS_FAR.contains(&slope);
        self.held[2].found().filter(|_| banks)
    }

    fn is_fast(&self) -> bool {
        FAST_M_S.contains(&(self.speeds / self.count))
    }

    /// Whether it banks as an aeroplane, by a roll of any sign.
    fn is_aeroplane(&self) -> bool {
        let [count, _, mixed, bank2, _, roll2] = self.turns;
        count >= LEAST_OF_AEROPLANE
            && (0.5..1.6).contains(&(mixed / bank2).abs())
            && mixed * mixed > BANKS * BANKS * bank2 * roll2
    }

    /// Whether a heading can be judged by the track: that of an aeroplane, or one that turns with the track, or `against` it, for long.
    fn leads(&self, against: bool) -> bool {
        let with = if against { -self.turned_with } else { self.turned_with };
        self.is_aeroplane() || self.turned > TWO_CIRCLES && with > LEADS * self.turned
    }

    /// How late the roll is [s], negative if it is early, of a vehicle that banks as an aeroplane.
    pub fn roll_delay_s(&self) -> Option<f64> {
        let [_, _, mixed, bank2, ..] = self.turns;
        self.roll_delay.delay_s().filter(|_| (0.5..1.6).contains(&(mixed / bank2)))
    }

    /// How late its heading is [s].
    pub fn heading_delay_s(&self) -> Option<f64> {
        self.heading_delay.delay_s().filter(|_| self.is_aeroplane())
    }

    /// Whether there are enough blocks for a judgement.
    pub fn is_enough(&self) -> bool {
        self.count >= LEAST
    }

    /// How well the heading follows the track, 0 to 1, if it does not, and as what it would.
    pub fn heading_unit(&self) -> Option<(f64, Clue)> {
        let [as_it_is, ..] = self.headings.map(|sum| sum.length() / self.count);
        let turned = self.track.length() / self.count < 0.9;
        if self.is_enough() && !turned {
            return self.heading_unit_by_turns();
        }
        if !self.is_enough() || as_it_is >= 0.8 {
            return None;
        }
        let lengths = self.headings.map(|sum| sum.length() / self.count);
        let best = (0..HEADINGS.len()).max_by(|&a, &b| lengths[a].total_cmp(&lengths[b]))?;
        // By chance the mean direction of a drone that turns as it likes agrees.
        let leads = self.is_fast() || self.leads(HEADINGS[best].1 < 0.0);
        (lengths[best] > 0.9 && leads).then_some((as_it_is, Clue::Known(HEADINGS[best].0)))
    }

    /// The same of an aeroplane that turns, but never far: by the turns alone.
    fn heading_unit_by_turns(&self) -> Option<(f64, Clue)> {
        let shares = self.differ2.map(|sum| sum / self.turned2);
        let is_judged = self.turned > TURNED && self.is_aeroplane() && shares[0] > DIFFER;
        let best = shares.iter().position(|&share| share < EQUAL).filter(|_| is_judged)?;
        Some(((1.0 - shares[0]).max(0.0), Clue::Known(HEADINGS[best].0)))
    }

    /// Angle of the heading off the track [rad], if it is constant and large, and what that means: wind makes no constant angle in a flight
    /// that turns, and vehicles that fly sideways do not bank as aeroplanes do.
    pub fn heading_offset(&self) -> Option<(f64, Level)> {
        if !self.is_enough() {
            return None;
        }
        let (angle, share) = self.off_track();
        let length = self.track.length() / self.count;
        let leads = self.leads(false);
        let is_all_round = length < ALL_ROUND && (leads || self.is_fast());
        let all_round = Some(angle).filter(|angle| is_all_round && angle.abs() > OFF_ALL_ROUND);
        let of_wind = self.crab.offset().filter(|_| leads).and_then(|offset| match length {
            ..TURNS => (offset.abs() > OFF_IN_TURNS).then_some(offset),
            // A wind that changes moves the offset by some 10°, so the angle off the track has to be as large.
            ..TURNS_LITTLE => {
                let is_large = |off: f64| off * angle.signum() > OFF_IN_LITTLE_TURNS;
                (is_large(offset) && is_large(angle)).then_some(angle)
            }
            _ => None,
        });
        let is_beyond_wind = leads
            && angle.abs() > OFF_IN_ANY_WIND
            && self.speeds / self.count * sin_cos(angle).0.abs() > WIND_M_S;
        let beyond_wind = Some(angle).filter(|_| is_beyond_wind);
        let off = all_round.or(of_wind).or(beyond_wind).filter(|_| share > 0.9);
        if let Some(off) = off.filter(|off| off.abs() < SIDEWAYS || self.roll().is_none()) {
            return Some((off, Level::Doubtful));
        }
        (share > 0.9 && angle.abs() > SIDEWAYS).then_some((angle, Level::Note))
    }

    /// Mean angle of the heading off the track [rad], and how constant it is, 0 to 1.
    fn off_track(&self) -> (f64, f64) {
        let sum = &self.headings[0];
        (sum.angle().unwrap_or(0.0), sum.length() / self.count)
    }

    /// Slope of the roll on the bank that the turns need, if it is wrong, and what explains it.
    pub fn roll(&self) -> Option<(f64, Clue)> {
        let [count, with_sign, mixed, bank2, of_pitch, roll2] = self.turns;
        if count < LEAST_OF_TURNS {
            return None;
        }
        let slope = mixed / bank2;
        let is_opposite = slope < LEANS && with_sign < 0.2 * count;
        // A vehicle with a heading of its own banks to any side of it.
        let (off_track, share) = self.off_track();
        let is_sideways = off_track.abs() > SIDEWAYS || share < 0.8;
        let clue = match (of_pitch / bank2).abs() {
            0.6..1.6 if slope.abs() < 0.4 && !is_sideways => Clue::Known("roll and pitch are exchanged"),
            _ if IN_RADIANS.contains(&slope) && mixed * mixed > BANKS * BANKS * bank2 * roll2 => {
                Clue::Known(RADIANS)
            }
            _ if is_opposite && !is_sideways => Clue::Known("opposite sign"),
            _ => Clue::None,
        };
        (clue != Clue::None || !(0.1..=5.0).contains(&slope)).then_some((slope, clue))
    }

    /// How many times the roll is the bank of the turns, if they follow each other and it is another one: roll, time or way are others.
    pub fn rolls_otherwise(&self) -> Option<f64> {
        let (deviation, slope, correlation) = self.rolls.figures();
        let rolls = self.rolls.count >= LEAST && slope * deviation > ROLLS;
        (rolls && correlation > BANKS && !AS_FAR.contains(&slope)).then_some(slope)
    }

    /// Slope of the pitch on the angle of the path, if the path varies, and what is wrong.
    pub fn pitch(&self) -> Option<(f64, PitchFault)> {
        let (deviation, slope, correlation) = self.climb.figures();
        let varies = self.climb.count >= LEAST && deviation > 2.0 * DEG;
        if varies && slope < -0.3 && correlation < -0.5 {
            return Some((slope, PitchFault::Opposite));
        }
        if varies && IN_RADIANS.contains(&slope) && correlation > 0.8 {
            return Some((slope, PitchFault::Radians));
        }
        // In thermals the nose of a glider follows a third of the climb.
        let (deviation, slope, correlation) = self.straight_climb.figures();
        let in_feet = self.straight_climb.count >= LEAST
            && deviation > 2.0 * DEG
            && correlation > 0.8
            && (0.2..0.4).contains(&slope);
        in_feet.then_some((slope, PitchFault::HeightInFeet))
    }

    /// Mean of pitch less angle of the path [rad], if it is below -1° and the path does not vary.
    pub fn negative_attack(&self) -> Option<f64> {
        let (deviation, ..) = self.climb.figures();
        let mean = (self.climb.y - self.climb.x) / self.climb.count;
        let is_negative = self.climb.count >= LEAST && deviation < 2.0 * DEG && mean < -DEG;
        is_negative.then_some(mean)
    }
}
