//! The rows of the fit: record less path, and what each parameter changes.

use nalgebra::{Matrix3, SMatrix, Vector3};

use super::Also;
use super::blocks::Block;
use super::noise::COEFFICIENTS;
use super::parameter::{PARAMETERS, Place, turning_sign};
use super::path::{IdealPath, Six};
use super::whiten::Columns;
use crate::base::error::Error;
use crate::base::memory::room;

/// Parts of a block whose sizes are taken one by one.
const SIZE_PARTS: usize = 5;

/// About what the fit is linear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct About {
    /// Axes of the record = `axes` times those of the path.
    pub axes: Matrix3<f64>,
    /// Path time less record time at `middle_s` of the record [s], and its change [s/s].
    pub offset_s: f64,
    pub drift: f64,
    pub middle_s: f64,
    /// End of the last block on the clock of the record [s].
    pub last_s: f64,
    /// Angles of the mounting that `axes` has beside the exchange [rad], and those that the misalignments of both triads have in common.
    pub turned: Vector3<f64>,
    pub common: Vector3<f64>,
    /// The rotation of both [rad].
    pub mounting: Vector3<f64>,
    /// Lever arm that the path has [m], axes of the path.
    pub lever_b: Vector3<f64>,
    /// Temperature at which the biases hold [°C], if their changes with it are asked for.
    pub reference_c: Option<f64>,
    /// What the fit has beside.
    pub also: Also,
}

impl About {
    fn path_time_s(&self, time_s: f64) -> f64 {
        time_s + self.offset_s + self.drift * (time_s - self.middle_s)
    }
}

/// The rows of the six sensors: record less path, and the columns of the coefficients.
pub(super) struct Rows {
    pub blocks: Vec<Block>,
    /// Number of each block among those of the record.
    pub places: Vec<usize>,
    pub of_sensor: [Vec<Columns>; 6],
}

impl Rows {
    pub fn new(path: &IdealPath, blocks: &[Block], about: &About) -> Result<Self, Error> {
        let count = blocks.len();
        let mut rows = Self { blocks: room(count)?, places: room(count)?, of_sensor: Default::default() };
        for sensor in &mut rows.of_sensor {
            *sensor = room(count)?;
        }
        let mut last: Option<f64> = None;
        for (place, block) in blocks.iter().enumerate() {
            let ends = [block.start_s, block.end_s].map(|time| about.path_time_s(time));
            let Some((mean, change)) = path.mean(ends[0], ends[1]) else { continue };
            let turned = |signal: &Six, part: usize| about.axes * signal.fixed_rows::<3>(3 * part);
            // A block that the path does not have makes a gap too.
            let gap_s = last.map_or(0.0, |end_s| block.start_s - end_s);
            rows.blocks
                .push(Block { gap_s: if gap_s > 1e-3 * block.length_s() { gap_s } else { 0.0 }, ..*block });
            rows.places.push(place);
            last = Some(block.end_s);
            let since_s = block.middle_s() - about.middle_s;
            let ideal = [0, 1].map(|part| turned(&mean, part));
            let change = [0, 1].map(|part| turned(&change, part));
            let sizes = match about.also.asymmetry {
                true => mean_sizes(path, about, ends),
                false => Six::zeros(),
            };
            let above_k = above_k(path, about.reference_c, ends);
            // Gyros sense forces; accelerometers away from the point of the path sense (α× + ω×ω×) r.
            let lever = change[0].cross_matrix() + ideal[0].cross_matrix() * ideal[0].cross_matrix();
            for (part, axis) in (0..6).map(|sensor| (sensor / 3, sensor % 3)) {
                let beside = if part == 0 { ideal[1].transpose() } else { lever.row(axis).into_owned() };
                rows.of_sensor[3 * part + axis].push([
                    block.mean[3 * part + axis] - ideal[part][axis],
                    1.0,
                    ideal[part].x,
                    ideal[part].y,
                    ideal[part].z,
                    change[part][axis],
                    since_s * change[part][axis],
                    beside[0],
                    beside[1],
                    beside[2],
                    0.5 * sizes[3 * part + axis],
                    above_k,
                ]);
            }
        }
        Ok(rows)
    }
}

/// Temperature above that of the biases \[K\], in the middle between two times of the path.
pub(super) fn above_k(path: &IdealPath, reference_c: Option<f64>, [from_s, to_s]: [f64; 2]) -> f64 {
    let temperature_c = reference_c.and_then(|_| path.temperature_c(0.5 * (from_s + to_s)));
    temperature_c.zip(reference_c).map_or(0.0, |(temperature_c, reference_c)| temperature_c - reference_c)
}

/// Means of |u| between two times of the path: a signal may change its sign within a block.
fn mean_sizes(path: &IdealPath, about: &About, [from_s, to_s]: [f64; 2]) -> Six {
    let at = |part: usize| from_s + (to_s - from_s) * part as f64 / SIZE_PARTS as f64;
    let means = (0..SIZE_PARTS).filter_map(|part| path.mean(at(part), at(part + 1)));
    let sum = means.fold(Six::zeros(), |sum, (mean, _)| {
        let turned = [0, 3].map(|first| about.axes * mean.fixed_rows::<3>(first));
        sum + Six::from_fn(|k, _| turned[k / 3][k % 3].abs())
    });
    sum / SIZE_PARTS as f64
}

/// Coefficients of a sensor by the parameters: bias, error matrix and mounting rotation φ, of which the record has φ×u more, and what was
/// asked for beside.
pub(super) fn coefficients(part: usize, axis: usize) -> SMatrix<f64, COEFFICIENTS, PARAMETERS> {
    let mut matrix = SMatrix::zeros();
    matrix[(0, Place::bias(part, axis))] = 1.0;
    for column in 0..3 {
        matrix[(1 + column, Place::element(part, axis, column))] = 1.0;
        // (φ×u) of this axis holds φ of the third axis, with the sign of the order.
        if column != axis {
            let third = 3 - axis - column;
            matrix[(1 + column, Place::mounting(third))] = turning_sign(axis, column);
        }
    }
    matrix[(4, Place::CLOCK)] = 1.0;
    matrix[(5, Place::DRIFT)] = 1.0;
    for column in 0..3 {
        let place = if part == 0 { Place::g_sensitivity(axis, column) } else { Place::lever_arm(column) };
        matrix[(6 + column, place)] = 1.0;
    }
    matrix[(9, Place::asymmetry(part, axis))] = 1.0;
    matrix[(10, Place::bias_temperature(part, axis))] = 1.0;
    matrix
}
