//! Which axis of the record is which of the path: the signed exchange nearest to the truth, and whether both are of one motion.

use nalgebra::{Matrix3, Vector3};

use super::Request;
use super::blocks::Block;
use super::path::{IdealPath, Six};
use super::unfit::check_number;
use crate::base::error::{Error, Rule};
use crate::base::math::hypot;
use crate::base::memory::room;
use crate::base::units::STANDARD_GRAVITY;

/// A correlation of the rates that only the same motion has.
pub(super) const SAME: f64 = 0.9;
/// The least part of the correlation that the noise of the record leaves.
const OF_POSSIBLE: f64 = 0.7;
/// Sizes of the signals of the record over those of the path that are possible.
pub(super) const SIZES: (f64, f64) = (0.7, 1.4);
/// An exchange is excluded by this chi-square, of a tenth of the blocks: neighbours depend on each other.
const EXCLUDED: f64 = 50.0;
const INDEPENDENT: f64 = 0.1;
/// Signals are left-handed if the best exchange leaves this many times as much as the best one with a reflection.
const MIRRORED: f64 = 2.0;
/// Least trace of a rotation to the nearest exchange, which turns by 63 degrees at most.
const NEAREST: f64 = 1.9;
/// Change of a signal that is rounding and no motion, as a part of its mean.
const ROUNDING: f64 = 1e-9;
/// Tilt of a block that stands square, for the comparison of the mean forces \[rad\].
const TILT: f64 = 0.05;

/// Mean force of a path that no bias reverses, in standard deviations of the bias.
const LARGE_MEAN: f64 = 4.0;

const LEFT_HANDED: &str = "correlation with the path in left-handed axes, which no rotation gives: a sign or the order of these columns is wrong";

/// The signed exchange of axes: signals of the record = `exchange` times those of the path, nearly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axes {
    /// Signed permutation without reflection.
    pub exchange: Matrix3<f64>,
    /// Whether the motion excludes all other exchanges, or tells a rotation that is far from each.
    pub is_seen: bool,
}

impl Axes {
    /// The 24 signed exchanges without reflection.
    pub fn exchanges() -> impl Iterator<Item = Matrix3<f64>> {
        let orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
        orders.into_iter().flat_map(|order| {
            (0..8_u8).filter_map(move |signs| {
                let mut matrix = Matrix3::zeros();
                for (row, column) in order.into_iter().enumerate() {
                    matrix[(row, column)] = if signs >> row & 1 == 0 { 1.0 } else { -1.0 };
                }
                (matrix.determinant() > 0.0).then_some(matrix)
            })
        })
    }
}

/// Sums over the blocks of one triad, each signal less its mean.
struct Sums {
    cross: Matrix3<f64>,
    recorded: f64,
    ideal: f64,
    means: (Vector3<f64>, Vector3<f64>),
    /// Sum of squares that the second differences of neighbouring blocks show.
    noise: f64,
    count: f64,
}

impl Sums {
    fn new(pairs: &[(Six, Six)], part: usize) -> Self {
        let of = |signal: &Six| signal.fixed_rows::<3>(3 * part).into_owned();
        let count = pairs.len() as f64;
        let means = pairs.iter().fold((Vector3::zeros(), Vector3::zeros()), |sum, pair| {
            (sum.0 + of(&pair.0) / count, sum.1 + of(&pair.1) / count)
        });
        let mut sums = Self { cross: Matrix3::zeros(), recorded: 0.0, ideal: 0.0, means, noise: 0.0, count };
        for (m, u) in pairs {
            let (m, u) = (of(m) - means.0, of(u) - means.1);
            sums.cross += m * u.transpose();
            sums.recorded += m.norm_squared();
            sums.ideal += u.norm_squared();
        }
        // White noise has second differences of six times its variance.
        sums.noise = pairs
            .windows(3)
            .map(|w| (of(&w[0].0) - 2.0 * of(&w[1].0) + of(&w[2].0)).norm_squared())
            .sum::<f64>()
            / 6.0;
        let rounding = ROUNDING * means.1.norm();
        sums.noise = sums.noise.max(count * rounding * rounding);
        sums
    }

    fn correlation(&self, axes: &Matrix3<f64>) -> f64 {
        let size = (self.recorded * self.ideal).sqrt();
        if size > 0.0 { self.along(axes) / size } else { 0.0 }
    }

    /// The rotation that fits best.
    fn rotation(&self) -> Matrix3<f64> {
        let svd = self.cross.svd(true, true);
        let (Some(u), Some(v_t)) = (svd.u, svd.v_t) else { return Matrix3::identity() };
        let last = (u.determinant() * v_t.determinant()).signum();
        u * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, last)) * v_t
    }

    /// Size of the record over that of the path.
    fn size(&self, axes: &Matrix3<f64>) -> f64 {
        self.along(axes) / self.ideal
    }

    /// Size of the record over that of the path, the means with them.
    fn size_with_mean(&self) -> f64 {
        let of = |squares: f64, mean: Vector3<f64>| (squares / self.count).sqrt().max(mean.norm());
        of(self.recorded, self.means.0) / of(self.ideal, self.means.1)
    }

    fn along(&self, axes: &Matrix3<f64>) -> f64 {
        axes.component_mul(&self.cross).sum()
    }

    /// Sum of squares of the differences from the record, the mean aside.
    fn rest(&self, axes: &Matrix3<f64>) -> f64 {
        (self.recorded + self.ideal - 2.0 * self.along(axes)).max(0.0)
    }

    /// The exchange that fits best.
    fn best(&self) -> Matrix3<f64> {
        nearest(&self.cross)
    }

    /// Chi-square of an exchange: the rest over the least one, `least`.
    fn chi_square(&self, axes: &Matrix3<f64>, least: f64) -> f64 {
        let least = least.max(self.noise).max(1e-12 * self.ideal);
        if least > 0.0 { self.rest(axes) / least * (INDEPENDENT * 3.0 * self.count) } else { 0.0 }
    }

    /// The left-handed exchange of signals that are those of the path in left-handed axes, and not in right-handed ones. The negative of an
    /// exchange without reflection is one with a reflection.
    fn left_handed(&self) -> Option<Matrix3<f64>> {
        let mirrored = -Axes::exchanges()
            .min_by(|a, b| self.along(a).total_cmp(&self.along(b)))
            .unwrap_or_else(Matrix3::identity);
        let (correlation, least) = (self.correlation(&mirrored), self.rest(&mirrored));
        let of = |axes: &Matrix3<f64>| self.chi_square(axes, least);
        let (right, left) = (of(&self.best()), of(&mirrored));
        let is_left = correlation > SAME && right > left + EXCLUDED && right > MIRRORED * left;
        is_left.then_some(mirrored)
    }

    /// Rejects left-handed signals.
    fn check_hand(&self, field: &'static str) -> Result<(), Error> {
        let Some(mirrored) = self.left_handed() else { return Ok(()) };
        Err(Error::invalid(field, self.correlation(&mirrored), Rule::Sentence(LEFT_HANDED)))
    }

    /// The correlation that the noise leaves to the signals of the path.
    fn possible(&self) -> f64 {
        let size = self.ideal + self.noise;
        if size > 0.0 { (self.ideal / size).sqrt() } else { 0.0 }
    }
}

/// What axes and rates say of the record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Match {
    pub axes: Axes,
    /// Whether the motion of the path stands out of the noise of the record.
    pub is_moving: bool,
}

/// The exchange of axes at a shift of the clock. Rejects a record of another motion, in other units, or with reversed forces.
pub(super) fn find(
    path: &IdealPath,
    blocks: &[Block],
    offset_s: f64,
    request: &Request,
) -> Result<Match, Error> {
    let (given, prior) = (request.axes.as_ref(), &request.prior);
    let mut pairs: Vec<(Six, Six)> = room(blocks.len())?;
    let mean = |block: &Block| path.mean(block.start_s + offset_s, block.end_s + offset_s);
    pairs.extend(blocks.iter().filter_map(|block| Some((block.mean, mean(block)?.0))));
    check_number(pairs.len(), blocks)?;
    let (gyro, accel) = (Sums::new(&pairs, 0), Sums::new(&pairs, 1));
    // Units first: the rates correlate in any unit.
    let best = given.copied().unwrap_or_else(|| gyro.best());
    let rotation = gyro.rotation();
    let nearest = given.copied().unwrap_or_else(|| nearest(&rotation));
    // A block that is mounted far from each exchange: only rates that are certain tell its rotation.
    let is_turned = gyro.correlation(&best) <= SAME
        && gyro.correlation(&rotation) > SAME
        && rotation.component_mul(&nearest).sum() > NEAREST;
    let turned = if is_turned { rotation } else { best };
    let correlation = gyro.correlation(&turned);
    gyro.check_hand("record.angle")?;
    if correlation > SAME {
        check_size(
            "record.angle",
            gyro.size(&turned),
            "size of the rates of the record over that of the path; 0.7 to 1.4 in the same unit and within the range of the sensors",
        )?;
    }
    let is_moving = gyro.possible() > 0.5 || accel.possible() > 0.5;
    let quality = |sums: &Sums, axes: &Matrix3<f64>| sums.correlation(axes) / sums.possible().max(0.5);
    let forced = given.copied().unwrap_or_else(|| accel.best());
    // Rates decide where they show the motion: forces of two flights may resemble each other.
    let quality = if gyro.possible() > 0.5 { quality(&gyro, &turned) } else { quality(&accel, &forced) };
    let is_same = quality > OF_POSSIBLE;
    let warmed = if request.also.temperature { warmed(path, blocks, offset_s) } else { 0.0 };
    let is_at_rest = gyro.recorded - warmed < 4.0 * gyro.noise.max(1e-3 * gyro.ideal);
    if is_moving && !is_same {
        return Err(other_motion(correlation));
    }
    if !is_moving && !is_at_rest {
        let rule = Rule::Sentence(
            "scatter of its rates [rad/s], where the path hardly turns: of another motion, or of gyros that drift by much, as with temperature",
        );
        return Err(Error::invalid("record.motion", (gyro.recorded / gyro.count).sqrt(), rule));
    }
    // Forces of another motion have other sizes: a unit is blamed only if the rates are certain.
    check_size(
        "record.velocity",
        accel.size_with_mean(),
        "size of the forces of the record over that of the path; 0.7 to 1.4 in the same unit and within the range of the sensors",
    )
    .map_err(|error| if is_moving && correlation <= SAME { other_motion(correlation) } else { error })?;

    let bias = hypot(TILT * STANDARD_GRAVITY, prior.accel_bias);
    // Chi-square of an exchange: the rest over its least value, and the means by the biases that sensors may have.
    let of = |sums: &Sums, axes: &Matrix3<f64>| sums.chi_square(axes, sums.rest(&sums.best()));
    let mean = |axes: &Matrix3<f64>| (accel.means.0 - axes * accel.means.1).norm_squared() / (bias * bias);
    let chi_square = |axes: &Matrix3<f64>| of(&gyro, axes) + of(&accel, axes) + mean(axes);
    // The rates alone say which exchanges are possible; forces that oppose the path in all of them are reversed.
    let turns_as_well = |axes: &Matrix3<f64>| of(&gyro, axes) < of(&gyro, &turned) + EXCLUDED;
    let could_be = || Axes::exchanges().filter(turns_as_well).chain(is_turned.then_some(rotation));
    if correlation > SAME {
        check_direction(&accel, bias, could_be)?;
    }
    accel.check_hand("record.velocity")?;
    if let Some(exchange) = given {
        return Ok(Match { axes: Axes { exchange: *exchange, is_seen: true }, is_moving });
    }
    if is_turned {
        return Ok(Match { axes: Axes { exchange: nearest, is_seen: true }, is_moving });
    }
    let order = |a: &Matrix3<f64>, b: &Matrix3<f64>| chi_square(a).total_cmp(&chi_square(b));
    let exchange = Axes::exchanges().min_by(order).unwrap_or_else(Matrix3::identity);
    let excluded = chi_square(&exchange) + EXCLUDED;
    let possible = |axes: &Matrix3<f64>| chi_square(axes) < excluded;
    let is_seen = Axes::exchanges().filter(possible).count() == 1;
    let identity = Matrix3::identity();
    let exchange = if possible(&identity) { identity } else { exchange };
    Ok(Match { axes: Axes { exchange, is_seen }, is_moving })
}

/// Sum of squares of the rates of the record that changes with temperature explain.
fn warmed(path: &IdealPath, blocks: &[Block], offset_s: f64) -> f64 {
    let both = || {
        let of_path = blocks
            .iter()
            .filter(|block| path.mean(block.start_s + offset_s, block.end_s + offset_s).is_some());
        of_path.filter_map(|block| Some((path.temperature_c(block.middle_s() + offset_s)?, block.mean)))
    };
    let count = both().count() as f64;
    let mean = both().fold((0.0, Six::zeros()), |sum, one| (sum.0 + one.0 / count, sum.1 + one.1 / count));
    let (squares, products) = both().fold((0.0, Six::zeros()), |sum, (temperature_c, signals)| {
        let above_k = temperature_c - mean.0;
        (sum.0 + above_k * above_k, sum.1 + (signals - mean.1) * above_k)
    });
    if squares > 0.0 { products.fixed_rows::<3>(0).norm_squared() / squares } else { 0.0 }
}

fn other_motion(correlation: f64) -> Error {
    let rule = Rule::Sentence(
        "correlation of its rates with those of the path at the best shift of the clock: of another motion, or of sensors that are held or beyond their range",
    );
    Error::invalid("record.motion", correlation, rule)
}

/// Rejects forces that are reversed with each exchange that could be, for biases of this size.
fn check_direction<I: Iterator<Item = Matrix3<f64>>>(
    accel: &Sums,
    bias: f64,
    could_be: impl Fn() -> I,
) -> Result<(), Error> {
    let (recorded, ideal) = (accel.means.0.norm(), accel.means.1.norm());
    let opposes = |axes: Matrix3<f64>| accel.means.0.dot(&(axes * accel.means.1)) < -0.5 * recorded * ideal;
    if ideal > LARGE_MEAN * bias && could_be().all(opposes) {
        let rule = Rule::Sentence("along the forces of the path: the specific forces have the opposite sign");
        return Err(Error::invalid("record.velocity", -recorded, rule));
    }
    // Where the mean force is small, the changes of the forces tell that all three are reversed.
    let is_reversed = |mirrored: &Matrix3<f64>| could_be().all(|axes| axes == -mirrored);
    let Some(mirrored) = accel.left_handed().filter(is_reversed) else { return Ok(()) };
    let rule =
        Rule::Sentence("correlation with the forces of the path: the specific forces have the opposite sign");
    Err(Error::invalid("record.velocity", -accel.correlation(&mirrored), rule))
}

/// The exchange nearest to a rotation, or along sums of products best.
fn nearest(turned: &Matrix3<f64>) -> Matrix3<f64> {
    let trace = |axes: &Matrix3<f64>| axes.component_mul(turned).sum();
    Axes::exchanges().max_by(|a, b| trace(a).total_cmp(&trace(b))).unwrap_or_else(Matrix3::identity)
}

fn check_size(field: &'static str, size: f64, why: &'static str) -> Result<(), Error> {
    if (SIZES.0..=SIZES.1).contains(&size) {
        return Ok(());
    }
    Err(Error::invalid(field, size, Rule::Sentence(why)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_24_exchanges_that_are_rotations() {
        let all: Vec<_> = Axes::exchanges().collect();
        assert_eq!(all.len(), 24);
        for (k, a) in all.iter().enumerate() {
            assert!((a * a.transpose() - Matrix3::identity()).norm() == 0.0 && a.determinant() == 1.0);
            assert!(all[..k].iter().all(|b| a != b));
        }
    }
}
