//! Blocks of rows, of 1 s and of each power of two above it: long enough that noise is a small share of their displacement.

use nalgebra::Vector3;

use super::attitude::Attitudes;
use super::finding::At;
use super::row::Row;
use super::velocity::Velocities;
use crate::base::error::Error;
use crate::base::math::{Euler, wrap_angle};
use crate::base::memory::filled;

/// Lengths of blocks: 1 s to 512 s.
const LEVELS: usize = 10;

/// Sums over the rows of a block.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block {
    pub length_s: f64,
    /// Displacement, Earth-fixed axes [m].
    pub d_e: Vector3<f64>,
    /// Climb [m].
    pub climb_m: f64,
    /// Integrals of e_i v_j, Earth-fixed axes [m]: unit vectors and velocities east east, north north, up up, east north, north east.
    pub moved: [Vector3<f64>; 5],
    /// Integral of the velocity up [m].
    pub moved_up_m: f64,
    /// Integral of the roll [rad s].
    pub rolled: f64,
    /// First row.
    pub begin: At,
    /// Whether each row has a velocity.
    pub has_velocity: bool,
    /// Whether each row has the attitude of the row before, to the last bit.
    pub is_held: bool,
    /// The same of its heading.
    pub is_heading_held: bool,
    /// The same of its roll.
    pub is_roll_held: bool,
}

impl Block {
    fn joined(&self, next: &Self) -> Self {
        let mut moved = self.moved;
        for (sum, term) in moved.iter_mut().zip(&next.moved) {
            *sum += term;
        }
        Self {
            length_s: self.length_s + next.length_s,
            d_e: self.d_e + next.d_e,
            climb_m: self.climb_m + next.climb_m,
            moved,
            moved_up_m: self.moved_up_m + next.moved_up_m,
            rolled: self.rolled + next.rolled,
            begin: self.begin,
            has_velocity: self.has_velocity && next.has_velocity,
            is_held: self.is_held && next.is_held,
            is_heading_held: self.is_heading_held && next.is_heading_held,
            is_roll_held: self.is_roll_held && next.is_roll_held,
        }
    }

    /// Displacement by the velocities as they are named [m].
    pub fn moved_e(&self) -> Vector3<f64> {
        self.moved[0] + self.moved[1] + self.moved[2]
    }
}

/// The end of a block.
#[derive(Debug, Clone, Copy)]
pub(super) struct End {
    pub at: At,
    pub euler: Euler,
    pub axes: [Vector3<f64>; 3],
}

/// Upper limits of the noise now, and steps of the positions [m].
#[derive(Debug, Clone, Copy)]
pub(super) struct Coarseness {
    pub horizontal_m: f64,
    pub up_m: f64,
    /// Usual interval [s].
    pub usual_s: f64,
    /// Whether noise and interval are known.
    pub is_known: bool,
}

/// Blocks of one length.
#[derive(Debug, Clone)]
pub(super) struct Level {
    /// The first half of a block of the next length.
    half: Option<Block>,
    /// The block before, and its end.
    before: Option<(Block, End)>,
    pub velocities: Velocities,
    pub attitudes: Attitudes,
}

const LEVEL: Level =
    Level { half: None, before: None, velocities: Velocities::new(), attitudes: Attitudes::new() };

#[derive(Debug, Clone)]
pub(super) struct Blocks {
    levels: Box<[Level]>,
    growing: Option<Block>,
    /// Unit vector times velocity at the last row.
    products: Option<[Vector3<f64>; 5]>,
    up_m_s: f64,
    last: Option<(At, Euler)>,
}

impl Blocks {
    /// Allocates the levels, which would be much of a small stack.
    pub fn new() -> Result<Self, Error> {
        let levels = filled(LEVELS, LEVEL)?;
        Ok(Self { levels, growing: None, products: None, up_m_s: 0.0, last: None })
    }

    /// Forgets all rows: they have no fix.
    pub fn clear(&mut self) {
        self.levels.fill(LEVEL);
        self.growing = None;
    }

    /// Adds a row.
    pub fn add(&mut self, row: &Row, coarse: &Coarseness) {
        let products = row.v_n.map(|v| {
            let [east, north, up] = row.axes;
            [east * v.x, north * v.y, up * v.z, east * v.y, north * v.x]
        });
        let up_m_s = row.v_n.map_or(0.0, |v| v.z);
        let t = row.interval_s;
        let mut moved = [Vector3::zeros(); 5];
        if let (Some(now), Some(before)) = (&products, &self.products) {
            moved = core::array::from_fn(|k| (now[k] + before[k]) * (0.5 * t));
        }
        let roll = wrap_angle(row.euler.roll);
        let roll_before = self.last.map_or(roll, |(_, euler)| wrap_angle(euler.roll));
        let own = Block {
            length_s: t,
            d_e: row.d_e,
            climb_m: row.d_n.z,
            moved,
            moved_up_m: 0.5 * (up_m_s + self.up_m_s) * t,
            rolled: 0.5 * (roll + roll_before) * t,
            begin: self.last.map_or(row.at, |(at, _)| at),
            has_velocity: products.is_some() && self.products.is_some(),
            is_held: self.last.is_some_and(|(_, euler)| euler == row.euler),
            is_heading_held: self.last.is_some_and(|(_, euler)| euler.heading == row.euler.heading),
            is_roll_held: self.last.is_some_and(|(_, euler)| euler.roll == row.euler.roll),
        };
        let had_row = self.last.is_some();
        (self.products, self.up_m_s, self.last) = (products, up_m_s, Some((row.at, row.euler)));
        // The first interval has no velocity at its start.
        if row.v_n.is_some() && !had_row {
            return;
        }
        let grown = self.growing.map_or(own, |growing| growing.joined(&own));
        // Half an interval of tolerance keeps blocks of rows at whole seconds that long.
        if grown.length_s < 1.0 - 0.5 * t.min(1.0) {
            self.growing = Some(grown);
            return;
        }
        self.growing = None;
        let end = End { at: row.at, euler: row.euler, axes: row.axes };
        self.complete(grown, &end, coarse);
    }

    fn complete(&mut self, mut block: Block, end: &End, coarse: &Coarseness) {
        for level in &mut self.levels {
            if coarse.is_known {
                if block.has_velocity {
                    level.velocities.add(&block, end, coarse);
                }
                if let Some((before, at)) = &level.before {
                    level.attitudes.add([before, &block], at, coarse);
                }
            }
            level.before = Some((block, *end));
            match level.half.take() {
                None => {
                    level.half = Some(block);
                    return;
                }
                Some(half) => block = half.joined(&block),
            }
        }
    }

    /// The shortest blocks from `least_s` [s] on that `fit`, or else those nearest below.
    pub fn level(&self, least_s: f64, fit: impl Fn(&Level) -> bool) -> Option<&Level> {
        let lengths = (0..LEVELS).map(|level| f64::from(1_u32 << level));
        let first = lengths.filter(|length_s| *length_s < least_s).count().min(LEVELS - 1);
        let up = self.levels[first..].iter();
        up.chain(self.levels[..first].last()).find(|level| fit(level))
    }
}
