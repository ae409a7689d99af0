//! Attitude against the path: heading and track, roll and the bank of turns, pitch and climb.

use nalgebra::Vector3;

use super::blocks::{Block, Coarseness, End};
use super::finding::{At, Clue, Level};
use crate::base::math::{atan, atan2, hypot, sin_cos, wrap_angle};
use crate::base::units::{DEG, STANDARD_GRAVITY as G};

/// Blocks that a judgement needs.
const LEAST: f64 = 9.0;

/// Length of the mean direction of the track below which a flight goes in all directions.
const ALL_ROUND: f64 = 0.3;

/// Slope of the roll on the bank above which a vehicle leans out of its turns: a car by a tenth to a fifth of the bank of an aeroplane.
const LEANS: f64 = -0.3;

/// Turn of the track above which an attitude that stays the same is not that of the vehicle.
const TURN_WHILE_HELD: f64 = 10.0 * DEG;

/// Blocks of turns that a judgement of the roll needs: in aerobatics half a minute is flown inverted.
const LEAST_OF_TURNS: f64 = 15.0;

/// Blocks that a delay of the roll needs, delay that matters [s], and correlation that shows it: two thirds of the difference are
/// explained. Good flights have delays of 0.13 s at most.
const LEAST_OF_DELAY: f64 = 20.0;
const DELAY_S: f64 = 0.5;
const SHOWS_DELAY: f64 = 0.8;

/// Angle off the track of a vehicle that flies sideways, such as a drone whose camera looks to the middle of its circle.
const SIDEWAYS: f64 = 45.0 * DEG;

/// What a heading may be instead: sign and factor.
const HEADINGS: [(&str, f64); 4] = [
    ("", 1.0),
    ("anticlockwise, or the opposite sign", -1.0),
    ("degrees taken for radians", DEG),
    ("radians taken for degrees", 1.0 / DEG),
];

/// Share of the squared turns of the track that those of a heading leave unexplained at most, of a vehicle whose nose leads its track.
const FOLLOWS: f64 = 0.8;

/// A sum of unit vectors in the plane.
#[derive(Debug, Clone, Copy)]
struct Direction {
    cosine: f64,
    sine: f64,
}

impl Direction {
    const NONE: Self = Self { cosine: 0.0, sine: 0.0 };

    fn add(&mut self, angle: f64) {
        let (sine, cosine) = sin_cos(angle);
        self.cosine += cosine;
        self.sine += sine;
    }

    fn length(&self) -> f64 {
        hypot(self.cosine, self.sine)
    }
}

/// Sums of a regression of y on x.
#[derive(Debug, Clone, Copy)]
struct Regression {
    count: f64,
    x: f64,
    y: f64,
    xx: f64,
    xy: f64,
    yy: f64,
}

impl Regression {
    const NONE: Self = Self { count: 0.0, x: 0.0, y: 0.0, xx: 0.0, xy: 0.0, yy: 0.0 };

    fn add(&mut self, x: f64, y: f64) {
        self.count += 1.0;
        self.x += x;
        self.y += y;
        self.xx += x * x;
        self.xy += x * y;
        self.yy += y * y;
    }

    /// That of the points of both.
    fn with(&self, other: &Self) -> Self {
        Self {
            count: self.count + other.count,
            x: self.x + other.x,
            y: self.y + other.y,
            xx: self.xx + other.xx,
            xy: self.xy + other.xy,
            yy: self.yy + other.yy,
        }
    }

    /// Standard deviation of x, slope, correlation.
    fn figures(&self) -> (f64, f64, f64) {
        let n = self.count;
        let (xx, yy) = (self.xx / n - (self.x / n) * (self.x / n), self.yy / n - (self.y / n) * (self.y / n));
        let xy = self.xy / n - self.x / n * self.y / n;
        (xx.max(0.0).sqrt(), xy / xx, xy / (xx * yy).max(0.0).sqrt())
    }
}

/// A stretch in which the attitude stays the same, to the last bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Held {
    /// Its first row.
    pub begin: At,
    /// Its length [s].
    pub length_s: f64,
    /// What the track turns in it [rad].
    pub turn: f64,
}

impl Held {
    const NONE: Self = Self { begin: At { row: 0, time_s: 0.0 }, length_s: 0.0, turn: 0.0 };
}

/// Bank that the turn needs, and roll, between two blocks.
#[derive(Debug, Clone, Copy)]
struct Banked {
    bank: f64,
    roll: f64,
}

#[derive(Debug, Clone)]
pub(super) struct Attitudes {
    count: f64,
    track: Direction,
    headings: [Direction; 4],
    /// The track and the heading before \[rad\], Σ (turn of the track)², and Σ (turn of a heading less turn of the track)².
    before: Option<[f64; 2]>,
    turned2: f64,
    unexplained2: [f64; 4],
    /// Blocks that turn, those of them with the sign of the turn, Σ roll bank, Σ bank², Σ pitch bank.
    turns: [f64; 5],
    climb: Regression,
    /// The stretch of held attitude now, that of the largest turn, and how many turn.
    held: Held,
    longest_held: Held,
    held_count: u64,
    /// The two ends of blocks before, if they follow each other.
    banked: [Option<Banked>; 2],
    /// Roll less bank, on the rate of the bank, where that falls and where it grows: the slope is how late the roll is. A heading shows no
    /// delay: wind turns it in every turn.
    delays: [Regression; 2],
}

impl Attitudes {
    pub const fn new() -> Self {
        Self {
            count: 0.0,
            track: Direction::NONE,
            headings: [Direction::NONE; 4],
            before: None,
            turned2: 0.0,
            unexplained2: [0.0; 4],
            turns: [0.0; 5],
            climb: Regression::NONE,
            held: Held::NONE,
            longest_held: Held::NONE,
            held_count: 0,
            banked: [None; 2],
            delays: [Regression::NONE; 2],
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
            (self.banked, self.before) = ([None; 2], None);
            return;
        }
        self.count += 1.0;
        let track = atan2(v.x, v.y);
        self.track.add(track);
        let (roll, pitch) = (wrap_angle(end.euler.roll), wrap_angle(end.euler.pitch));
        for (sum, (_, factor)) in self.headings.iter_mut().zip(HEADINGS) {
            sum.add(wrap_angle(end.euler.heading * factor - track));
        }
        self.add_turn(track, end.euler.heading);
        let turn = wrap_angle(atan2(second.x, second.y) - atan2(first.x, first.y));
        let bank = atan(speed * turn / (0.5 * length_s) / G);
        if (5.0 * DEG..75.0 * DEG).contains(&bank.abs()) && sin_cos(pitch).1.abs() > 0.5 {
            let has_sign = f64::from(u8::from((roll < 0.0) == (bank < 0.0) && roll != 0.0));
            for (sum, term) in
                self.turns.iter_mut().zip([1.0, has_sign, roll * bank, bank * bank, pitch * bank])
            {
                *sum += term;
            }
        }
        self.add_held(blocks, turn);
        self.add_banked(Banked { bank, roll }, 0.5 * length_s);
        let path = atan2(v.z, speed);
        if speed > 15.0 && roll.abs() < 1.0 && path.abs() < 1.2 && coarse.up_m < 0.02 * speed * length_s {
            self.climb.add(path, pitch);
        }
    }

    fn add_turn(&mut self, track: f64, heading: f64) {
        if let Some([track_before, heading_before]) = self.before {
            let turn = wrap_angle(track - track_before);
            self.turned2 += turn * turn;
            for (sum, (_, factor)) in self.unexplained2.iter_mut().zip(HEADINGS) {
                let rest = wrap_angle((heading - heading_before) * factor - turn);
                *sum += rest * rest;
            }
        }
        self.before = Some([track, heading]);
    }

    fn add_held(&mut self, blocks: [&Block; 2], turn: f64) {
        if !blocks.iter().all(|block| block.is_held) {
            self.held = Held::NONE;
            return;
        }
        if self.held == Held::NONE {
            self.held = Held { begin: blocks[0].begin, length_s: blocks[0].length_s, turn: 0.0 };
        }
        let had_turned = self.held.turn.abs() > TURN_WHILE_HELD;
        self.held.length_s += blocks[1].length_s;
        self.held.turn += turn;
        self.held_count += u64::from(!had_turned && self.held.turn.abs() > TURN_WHILE_HELD);
        if self.held.turn.abs() > self.longest_held.turn.abs() {
            self.longest_held = self.held;
        }
    }

    /// `between_s`: time from the middle of a block to that of the next [s].
    fn add_banked(&mut self, now: Banked, between_s: f64) {
        let is_upright = |at: &Banked| at.bank.abs().max(at.roll.abs()) < 75.0 * DEG;
        if let [Some(first), Some(middle)] = self.banked
            && [first, middle, now].iter().all(is_upright)
        {
            let rate = (now.bank - first.bank) / (2.0 * between_s);
            self.delays[usize::from(rate > 0.0)].add(-rate, middle.roll - middle.bank);
        }
        self.banked = [self.banked[1], Some(now)];
    }

    /// The stretch of held attitude in which the track turns farthest, if it turns, and how many such there are.
    pub fn held(&self) -> Option<(Held, u64)> {
        (self.held_count > 0).then_some((self.longest_held, self.held_count))
    }

    /// How late the roll is [s], negative if it is early, of a vehicle that banks as an aeroplane.
    pub fn delay_s(&self) -> Option<f64> {
        let [into, out_of] = &self.delays;
        let both = into.with(out_of);
        let (_, delay_s, correlation) = both.figures();
        let [_, _, mixed, bank2, _] = self.turns;
        let banks = (0.5..1.6).contains(&(mixed / bank2));
        // A slip in a single bend is a delay where the bank grows, and the opposite where it falls.
        let is_of = |part: &Regression| part.xx > 0.1 * both.xx && part.xy / part.xx / delay_s > 0.5;
        let is_shown = banks
            && both.count >= LEAST_OF_DELAY
            && correlation.abs() > SHOWS_DELAY
            && self.delays.iter().all(is_of);
        (is_shown && delay_s.abs() > DELAY_S).then_some(delay_s)
    }

    /// Whether there are enough blocks for a judgement.
    pub fn is_enough(&self) -> bool {
        self.count >= LEAST
    }

    /// How well the heading follows the track, 0 to 1, if it does not, and as what it would.
    pub fn heading_unit(&self) -> Option<(f64, Clue)> {
        let [as_it_is, ..] = self.headings.map(|sum| sum.length() / self.count);
        let turned = self.track.length() / self.count < 0.9;
        if !self.is_enough() || !turned || as_it_is >= 0.8 {
            return None;
        }
        let lengths = self.headings.map(|sum| sum.length() / self.count);
        let best = (0..HEADINGS.len()).max_by(|&a, &b| lengths[a].total_cmp(&lengths[b]))?;
        // By chance the mean direction of a drone that turns as it likes agrees; its turns do not.
        let leads = self.unexplained2[best] < FOLLOWS * self.turned2;
        (lengths[best] > 0.9 && leads).then_some((as_it_is, Clue::Known(HEADINGS[best].0)))
    }

    /// Angle of the heading off the track [rad], if it is constant and large, and what that means: wind makes no constant angle in a flight
    /// in all directions, and vehicles that fly sideways do not bank as aeroplanes do.
    pub fn heading_offset(&self) -> Option<(f64, Level)> {
        let (angle, share) = self.off_track();
        let is_all_round = self.track.length() / self.count < ALL_ROUND;
        let (least, level) = match is_all_round {
            true if angle.abs() < SIDEWAYS || self.roll().is_none() => (5.0, Level::Doubtful),
            _ => (45.0, Level::Note),
        };
        (self.is_enough() && share > 0.9 && angle.abs() > least * DEG).then_some((angle, level))
    }

    /// Mean angle of the heading off the track [rad], and how constant it is, 0 to 1.
    fn off_track(&self) -> (f64, f64) {
        let sum = &self.headings[0];
        (atan2(sum.sine, sum.cosine), sum.length() / self.count)
    }

    /// Slope of the roll on the bank that the turns need, if it is wrong, and what explains it.
    pub fn roll(&self) -> Option<(f64, Clue)> {
        let [count, with_sign, mixed, bank2, of_pitch] = self.turns;
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
            _ if is_opposite && !is_sideways => Clue::Known("opposite sign"),
            _ => Clue::None,
        };
        (clue != Clue::None || !(0.1..=5.0).contains(&slope)).then_some((slope, clue))
    }

    /// Slope of the pitch on the angle of the path, if the path varies: if the sign of pitch is wrong, or the height is in feet (true).
    pub fn pitch(&self) -> Option<(f64, bool)> {
        let (deviation, slope, correlation) = self.climb.figures();
        if self.climb.count < LEAST || deviation < 2.0 * DEG {
            return None;
        }
        let in_feet = correlation > 0.8 && (0.2..0.4).contains(&slope);
        (in_feet || slope < -0.3 && correlation < -0.5).then_some((slope, in_feet))
    }

    /// Mean of pitch less angle of the path [rad], if it is below -1° and the path does not vary.
    pub fn negative_attack(&self) -> Option<f64> {
        let (deviation, ..) = self.climb.figures();
        let mean = (self.climb.y - self.climb.x) / self.climb.count;
        let is_negative = self.climb.count >= LEAST && deviation < 2.0 * DEG && mean < -DEG;
        is_negative.then_some(mean)
    }
}
