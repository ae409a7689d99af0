//! The true motion over several intervals: the integrals that the propagation of errors needs.

use nalgebra::{Matrix3, Vector3};

use super::sources::{AXES, ELEMENTS, RandomErrors};
use crate::base::math::VectorPair;
use crate::base::snapshot::{COUNT, SIGNALS, stored};
use crate::earth::Earth;
use crate::sensors::GravityDisturbance;
use crate::signal::mounting::Block;
use crate::signal::{Increment, IntervalMotion, MotionNode};
use crate::truth::TruthPoint;

/// Longest stretch [s], if the intervals are shorter, and largest rotation within a stretch [rad]. With a rotation of 0.3 rad,
/// (0.3)⁴/720 = 1e-5 of the integrated noise is lost.
const LONGEST_S: f64 = 1.0;
const LARGEST_TURN: f64 = 0.3;

/// Truth over a stretch, from the end of the last one on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    pub length_s: f64,
    turn_rad: f64,
    pub intervals: u64,
    /// Number of intervals with a height of the altimeter.
    pub aided: u64,
    /// Integral of the share of the signal of each axis that is in its output [s].
    shares: [f64; AXES],
    /// Variance of the integral of what failures add at random to each axis [u² s²].
    noise: [f64; AXES],
    /// Increments of the sensors.
    pub increments: u64,
    /// Distance over ground [m].
    pub ground_m: f64,
    /// Integral of the specific force [m/s], and of its product with the time since the start [m], Earth-fixed axes.
    force: Vector3<f64>,
    force_moment: Vector3<f64>,
    /// The same integrals of the sensor axes in Earth-fixed axes.
    axes: Matrix3<f64>,
    axes_moment: Matrix3<f64>,
    /// Position at the start [m].
    start_e: Vector3<f64>,
    end_e: Vector3<f64>,
    /// Integral of the angular rate, sensor axes [rad].
    angle: Vector3<f64>,
    /// Integrals of the mean errors of rate and force by random drop-outs, and of their products with the time, Earth-fixed axes.
    lost: [Vector3<f64>; 2],
    lost_moment: [Vector3<f64>; 2],
    /// ∫ C s_j dt for each component j of rate and force, Earth-fixed axes.
    elements: [Matrix3<f64>; ELEMENTS / 3],
    elements_moment: [Matrix3<f64>; ELEMENTS / 3],
}

stored!(Stretch {
    length_s: 1e6,
    turn_rad: SIGNALS,
    intervals: COUNT,
    aided: COUNT,
    shares: 1e6,
    noise: SIGNALS,
    increments: COUNT,
    ground_m: SIGNALS,
    force: SIGNALS,
    force_moment: SIGNALS,
    axes: SIGNALS,
    axes_moment: SIGNALS,
    start_e: SIGNALS,
    end_e: SIGNALS,
    angle: SIGNALS,
    lost: SIGNALS,
    lost_moment: SIGNALS,
    elements: SIGNALS,
    elements_moment: SIGNALS,
} then |stretch, from| {
    from.require(stretch.length_s >= 0.0 && stretch.turn_rad >= 0.0, stretch.length_s, "must not be negative")?;
    // Each share is at most 1; the sums round differently.
    let longest_s = stretch.length_s * (1.0 + 1e-6);
    for share_s in stretch.shares {
        from.require((0.0..=longest_s).contains(&share_s), share_s, "is not a share of the stretch")?;
    }
    let is_counted = stretch.intervals > 0 && stretch.increments > 0;
    from.require(stretch.is_empty() || is_counted, stretch.length_s, "has no intervals")
});

/// An interval that was flown.
pub(crate) struct FlownInterval<'a> {
    pub motion: &'a IntervalMotion<'a>,
    pub current: &'a TruthPoint,
    pub next: &'a TruthPoint,
    pub ideal: &'a [Increment],
    /// Whether the altimeter had a height.
    pub is_aided: bool,
    pub block: Option<&'a Block>,
}

impl Stretch {
    /// An empty stretch.
    pub const EMPTY: Self = Self {
        length_s: 0.0,
        turn_rad: 0.0,
        intervals: 0,
        aided: 0,
        shares: [0.0; AXES],
        noise: [0.0; AXES],
        increments: 0,
        ground_m: 0.0,
        force: Vector3::new(0.0, 0.0, 0.0),
        force_moment: Vector3::new(0.0, 0.0, 0.0),
        axes: ZERO,
        axes_moment: ZERO,
        start_e: Vector3::new(0.0, 0.0, 0.0),
        end_e: Vector3::new(0.0, 0.0, 0.0),
        angle: Vector3::new(0.0, 0.0, 0.0),
        lost: [Vector3::new(0.0, 0.0, 0.0); 2],
        lost_moment: [Vector3::new(0.0, 0.0, 0.0); 2],
        elements: [ZERO; ELEMENTS / 3],
        elements_moment: [ZERO; ELEMENTS / 3],
    };

    /// Whether it holds no interval.
    pub fn is_empty(&self) -> bool {
        self.length_s == 0.0
    }

    /// Whether an interval of `t` [s] would make it too long: a gap.
    pub fn has_no_room_for(&self, t: f64) -> bool {
        !self.is_empty() && self.length_s + t > LONGEST_S * (1.0 + 1e-6)
    }

    /// Adds an interval. Returns whether the stretch is long enough.
    pub fn add(&mut self, earth: &Earth, flown: &FlownInterval<'_>, parameters: &RandomErrors<'_>) -> bool {
        let &FlownInterval { motion, current, next, ideal, is_aided, block } = flown;
        let t = motion.interval_s;
        let nodes = block.map_or_else(|| motion.nodes(), |block| block.nodes(motion));
        let [c0, c1, c2] = axes_at_nodes(motion, block);
        if self.is_empty() {
            self.start_e = nodes[0].r_e;
        }
        self.end_e = nodes[2].r_e;

        // By Simpson's rule.
        let sixth = t / 6.0;
        let force = (nodes[0].f_e + nodes[1].f_e * 4.0 + nodes[2].f_e) * sixth;
        self.force += force;
        self.force_moment += force * self.length_s + (nodes[1].f_e * 2.0 + nodes[2].f_e) * (sixth * t);
        let axes = (c0 + c1 * 4.0 + c2) * sixth;
        self.axes += axes;
        self.axes_moment += axes * self.length_s + (c1 * 2.0 + c2) * (sixth * t);
        let Increment { angle, velocity } = Increment::sum(ideal);
        self.angle += angle;
        if parameters.have_elements() {
            let mean = axes / t;
            let middle_s = self.length_s + 0.5 * t;
            let signals = [angle.x, angle.y, angle.z, velocity.x, velocity.y, velocity.z];
            for ((sum, moment), signal) in
                self.elements.iter_mut().zip(&mut self.elements_moment).zip(signals)
            {
                let input = mean * signal;
                *sum += input;
                *moment += input * middle_s;
            }
        }
        for (axis, (share, density)) in parameters.outputs.into_iter().enumerate() {
            let signal = if axis < 3 { angle[axis] } else { velocity[axis - 3] };
            if share > 0.0 && share < 1.0 {
                let lost_e = axes.column(axis % 3) * ((share - 1.0) * signal / t);
                self.lost[axis / 3] += lost_e;
                self.lost_moment[axis / 3] += lost_e * (self.length_s + 0.5 * t);
            }
            self.shares[axis] += share * t;
            // Drop-outs lose the signal of an interval with the probability 1 - share.
            self.noise[axis] += density * density * t + share * (1.0 - share) * signal * signal;
        }
        let turn = angle.norm_squared().sqrt();
        self.turn_rad += turn;
        self.length_s += t;
        self.ground_m += GravityDisturbance::over_ground(earth, current, next);
        self.intervals += 1;
        self.aided += u64::from(is_aided);
        self.increments += ideal.len() as u64;
        // Its length with another interval like this one.
        self.has_no_room_for(t) || self.turn_rad + turn > LARGEST_TURN
    }

    /// The motion as straight lines that have the same integrals and first moments: its nodes, and the sensor axes there.
    pub fn lines(&self) -> ([MotionNode; 3], [Matrix3<f64>; 3]) {
        let t = self.length_s;
        let middle = (self.start_e + self.end_e) * 0.5;
        // The first moment of a line about the middle is a twelfth of its change.
        let force = self.force / t;
        let half_force = (self.force_moment / t - self.force * 0.5) * (6.0 / t);
        let (axes, half_axes) = line(&self.axes, &self.axes_moment, t);
        let node = |r_e, f_e| MotionNode { r_e, v_e: Vector3::zeros(), f_e };
        (
            [
                node(self.start_e, force - half_force),
                node(middle, force),
                node(self.end_e, force + half_force),
            ],
            [axes - half_axes, axes, axes + half_axes],
        )
    }

    /// The mean errors of rate and force by random drop-outs, at the nodes, in Earth-fixed axes; `None`: there are none.
    pub fn mean_errors(&self) -> Option<[VectorPair; 3]> {
        if self.lost == [Vector3::zeros(); 2] {
            return None;
        }
        let t = self.length_s;
        let [(rate, half_rate), (force, half_force)] = core::array::from_fn(|triad| {
            let (sum, moment) = (self.lost[triad], self.lost_moment[triad]);
            (sum / t, (moment / t - sum * 0.5) * (6.0 / t))
        });
        Some(
            [-1.0, 0.0, 1.0]
                .map(|side| VectorPair::new(&(rate + half_rate * side), &(force + half_force * side))),
        )
    }

    /// Its length and the mean length of its intervals [s].
    pub fn times(&self) -> (f64, f64) {
        (self.length_s, self.length_s / self.intervals as f64)
    }

    /// Mean share of the signal of an axis that is in its output.
    pub fn share(&self, axis: usize) -> f64 {
        self.shares[axis] / self.length_s
    }

    /// Density of noise [u √s] of which [`Self::share`] is the noise in the output of an axis: that of the sensor, of density `density`,
    /// while there is a signal, and that of failures.
    pub fn noise(&self, axis: usize, density: f64) -> f64 {
        let share = self.share(axis);
        if share == 0.0 {
            return 0.0;
        }
        let of_failures = self.noise[axis] / self.length_s;
        ((density * density + of_failures / share) / share).sqrt()
    }

    /// Mean angular rate, sensor axes [rad/s].
    pub fn mean_rate(&self) -> Vector3<f64> {
        self.angle / self.length_s
    }

    /// Signals that an element of scale factor and misalignment of 1 adds, at the nodes, in Earth-fixed axes [u].
    pub fn by_element(&self, element: usize) -> [Vector3<f64>; 3] {
        let (signal, row) = (element / 3, element % 3);
        let (mean, half) = line(&self.elements[signal], &self.elements_moment[signal], self.length_s);
        [mean - half, mean, mean + half].map(|matrix| matrix.column(row).into_owned())
    }
}

/// The mean and half the change of the straight line of an integral and a first moment over `t` [s].
fn line(sum: &Matrix3<f64>, moment: &Matrix3<f64>, t: f64) -> (Matrix3<f64>, Matrix3<f64>) {
    (sum / t, (moment / t - sum * 0.5) * (6.0 / t))
}

const ZERO: Matrix3<f64> = Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);

/// The sensors' axes, as columns in Earth-fixed axes, at the start, in the middle and at the end.
fn axes_at_nodes(motion: &IntervalMotion<'_>, block: Option<&Block>) -> [Matrix3<f64>; 3] {
    let axis = |unit: Vector3<f64>| block.map_or(unit, |block| block.in_body_axes(&unit));
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()].map(axis);
    let (xy, zz) = (VectorPair::new(&x, &y), VectorPair::both(&z));
    let (xy, zz) = (motion.to_earth_axes(&[xy; 3]), motion.to_earth_axes(&[zz; 3]));
    core::array::from_fn(|k| Matrix3::from_columns(&[xy[k].first(), xy[k].second(), zz[k].first()]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::error::Error;
    use crate::base::snapshot::{Reader, SnapshotOf, Stored as _, Writer};

    /// A stretch of 0.1 s, an interval long, whose axes have each `share_s` [s] of the signal, written and read.
    fn read_back(share_s: f64) -> Result<Stretch, Error> {
        let stretch =
            Stretch { length_s: 0.1, intervals: 1, increments: 1, shares: [share_s; AXES], ..Stretch::EMPTY };
        let mut bytes = [0; 4096];
        let mut to = Writer::new(&mut bytes, SnapshotOf::Simulator);
        stretch.save(&mut to);
        let size = to.finish();
        Reader::read(&bytes[..size], SnapshotOf::Simulator, |from| {
            let mut read = Stretch::EMPTY;
            read.load(from)?;
            Ok(read)
        })
    }

    #[test]
    fn a_share_is_at_most_the_length_of_the_stretch() {
        for share_s in [0.0, 0.07, 0.1] {
            assert_eq!(read_back(share_s).unwrap().shares, [share_s; AXES]);
        }
        for share_s in [-0.01, 0.11, 1e6] {
            assert!(read_back(share_s).is_err(), "{share_s}");
        }
    }
}
