//! The noise of the blocks of one sensor: a Kalman filter that turns them into independent numbers.

use crate::sensors::{FLICKER_PROCESSES, MarkovStep};

use super::blocks::Block;
use crate::base::error::Error;
use crate::base::memory::room;

/// Data column and columns of the parameters of one axis.
pub(super) const COLUMNS: usize = 12;
pub(super) type Columns = [f64; COLUMNS];

const PROCESSES: usize = FLICKER_PROCESSES.len();
/// The random walk, then the processes of flicker noise.
const STATES: usize = 1 + PROCESSES;

/// Shape of the noise beside white noise of N = 1: B²/N² [1/s] and K²/N² [1/s²].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Shape {
    pub flicker: f64,
    pub walk: f64,
}

/// One process of flicker noise over a block: decay, diffusion, and what state, diffusion and own noise give to the mean of the block, for
/// B = 1.
#[derive(Debug, Clone, Copy, Default)]
struct Process {
    decay: f64,
    diffusion: f64,
    mean: f64,
    shared: f64,
    own_variance: f64,
}

/// The steps of the processes over each block and over the gap before it.
pub(super) struct Steps {
    of_block: Vec<[Process; PROCESSES]>,
    of_gap: Vec<[f64; PROCESSES]>,
    lengths_s: Vec<(f64, f64)>,
}

impl Steps {
    /// Of these blocks; their memory is that of the blocks some times.
    pub fn new(blocks: &[Block]) -> Result<Self, Error> {
        let count = blocks.len();
        let mut steps = Self { of_block: room(count)?, of_gap: room(count)?, lengths_s: room(count)? };
        for block in blocks {
            let length_s = block.length_s();
            steps.of_block.push(FLICKER_PROCESSES.map(|(time_s, deviation)| {
                let step = MarkovStep::new(length_s, time_s);
                let (mut decay, mut diffusion) = (1.0, 0.0);
                let mean = step.advance_shared(&mut decay, 0.0) * deviation / length_s;
                let shared = step.advance_shared(&mut diffusion, 1.0) * deviation / length_s;
                let own = step.integral_own() * deviation / length_s;
                Process { decay, diffusion, mean, shared, own_variance: own * own }
            }));
            steps.of_gap.push(FLICKER_PROCESSES.map(|(time_s, _)| {
                let mut decay = 1.0;
                if block.gap_s > 0.0 {
                    MarkovStep::new(block.gap_s, time_s).advance_shared(&mut decay, 0.0);
                }
                decay
            }));
            steps.lengths_s.push((length_s, block.gap_s));
        }
        Ok(steps)
    }

    /// The filter of a shape. It does not depend on the data, so all sensors share it.
    ///
    /// The mean of a block of length T is, with processes x' = -x/τ + white noise ([`MarkovStep`]) and the walk w,
    /// ```text
    /// N n/√T + B Σ σj (∫xj dt)/T + (∫w dt)/T,   w(T) = w + K √T n1,   (∫w dt)/T = w + K √T (n1/2 + n2/√12)
    /// ```
    pub fn filter(&self, shape: Shape) -> Result<Filter<'_>, Error> {
        let active = match (shape.flicker > 0.0, shape.walk > 0.0) {
            (true, _) => STATES,
            (false, true) => 1,
            (false, false) => 0,
        };
        let size = shape.flicker.sqrt();
        let mut covariance = [[0.0; STATES]; STATES];
        for (j, row) in covariance.iter_mut().enumerate().skip(1) {
            row[j] = 1.0;
        }
        let mut filter = Filter {
            steps: self,
            active,
            size,
            gains: room(self.lengths_s.len())?,
            logarithms: 0.0,
            walk_variance: 0.0,
        };
        for (place, &(length_s, gap_s)) in self.lengths_s.iter().enumerate() {
            if gap_s > 0.0 {
                pass(&self.of_gap[place], shape.walk * gap_s, &mut covariance);
            }
            let processes = &self.of_block[place];
            let walk = (shape.walk * length_s).sqrt();
            let mut variance = 1.0 / length_s + walk * walk / 3.0;
            // Of each state: decay, diffusion, its part of the mean, and the part of its diffusion.
            let mut step = [(1.0, walk, 1.0, 0.5 * walk); STATES];
            for (step, process) in step.iter_mut().skip(1).zip(processes) {
                *step = (process.decay, process.diffusion, size * process.mean, size * process.shared);
                variance += shape.flicker * (process.own_variance + process.shared * process.shared);
            }
            let mut along = [0.0; STATES];
            for j in 0..active {
                along[j] = (0..active).map(|l| covariance[j][l] * step[l].2).sum();
            }
            variance += (0..active).map(|j| step[j].2 * along[j]).sum::<f64>();
            filter.logarithms += crate::base::math::ln(variance);
            let mut gain = [0.0; STATES];
            for j in 0..active {
                let (decay, diffusion, _, shared) = step[j];
                gain[j] = (decay * along[j] + diffusion * shared) / variance;
            }
            for j in 0..active {
                for l in 0..=j {
                    let own = if j == l { step[j].1 * step[j].1 } else { 0.0 };
                    let value = step[j].0 * step[l].0 * covariance[j][l] + own - gain[j] * gain[l] * variance;
                    covariance[j][l] = value;
                    covariance[l][j] = value;
                }
            }
            filter.gains.push((1.0 / variance.sqrt(), gain));
        }
        filter.walk_variance = if shape.walk > 0.0 { covariance[0][0].max(0.0) } else { 0.0 };
        Ok(filter)
    }
}

/// The filter of one shape over all blocks.
pub(super) struct Filter<'a> {
    steps: &'a Steps,
    /// States that the shape has, and the size of those of flicker noise.
    active: usize,
    size: f64,
    /// Of each block: 1 over the standard deviation of the innovation, and the gains of the states.
    gains: Vec<(f64, [f64; STATES])>,
    /// Σ ln of the variances of the innovations.
    pub logarithms: f64,
    /// Variance of the walk behind the last block, for N = 1.
    pub walk_variance: f64,
}

impl Filter<'_> {
    /// Gives `take` the rows in order, each over the standard deviation of its innovation for N = 1, so that they are independent with
    /// the variance N². The columns of the parameters run through the same filter as the data, because it is linear. Returns the walk
    /// behind the last block: its mean is the part of the data, less those of the columns times their coefficients.
    pub fn whiten(&self, rows: &[Columns], mut take: impl FnMut(usize, &Columns)) -> Columns {
        let mut state = [[0.0; COLUMNS]; STATES];
        for (place, (row, (scale, gain))) in rows.iter().zip(&self.gains).enumerate() {
            let processes = &self.steps.of_block[place];
            if self.steps.lengths_s[place].1 > 0.0 {
                for (state, decay) in state[1..].iter_mut().zip(&self.steps.of_gap[place]) {
                    state.iter_mut().for_each(|value| *value *= decay);
                }
            }
            // The walk does not decay, and its part of the mean is 1.
            let step = |j: usize| match j {
                0 => (1.0, 1.0),
                _ => (processes[j - 1].decay, self.size * processes[j - 1].mean),
            };
            let mut innovation = *row;
            for (j, state) in state.iter().enumerate().take(self.active) {
                let part = step(j).1;
                innovation.iter_mut().zip(state).for_each(|(value, state)| *value -= part * state);
            }
            for (j, state) in state.iter_mut().enumerate().take(self.active) {
                let (decay, gain) = (step(j).0, gain[j]);
                state
                    .iter_mut()
                    .zip(&innovation)
                    .for_each(|(value, new)| *value = decay * *value + gain * new);
            }
            take(place, &innovation.map(|value| value * scale));
        }
        state[0]
    }
}

/// Passes over a gap: the processes decay towards their stationary variance, and the walk goes on.
fn pass(decays: &[f64; PROCESSES], walk: f64, covariance: &mut [[f64; STATES]; STATES]) {
    let decay = |j: usize| if j == 0 { 1.0 } else { decays[j - 1] };
    for (j, row) in covariance.iter_mut().enumerate() {
        for (l, value) in row.iter_mut().enumerate() {
            *value *= decay(j) * decay(l);
        }
        row[j] += if j == 0 { walk } else { 1.0 - decay(j) * decay(j) };
    }
}

#[cfg(test)]
mod tests {
    use super::super::path::Six;
    use super::*;
    use nalgebra::SMatrix;

    /// Compared with the covariance of the block means in closed form: Σ ln of the variances is the logarithm of its determinant, and the
    /// sum of squares of white numbers is the quadratic form of its inverse, also across a gap.
    #[test]
    fn the_filter_is_the_inverse_of_the_covariance() {
        let shape = Shape { flicker: 0.3, walk: 0.02 };
        let starts = [0.0, 1.0, 2.5, 3.0, 9.0, 10.0];
        let lengths = [1.0, 1.5, 0.5, 1.0, 1.0, 2.0];
        let gap = |k: usize| if k == 0 { 0.0 } else { starts[k] - starts[k - 1] - lengths[k - 1] };
        let blocks: Vec<Block> = (0..6)
            .map(|k| Block {
                start_s: starts[k],
                end_s: starts[k] + lengths[k],
                gap_s: gap(k),
                mean: Six::zeros(),
            })
            .collect();
        // Double integrals over two blocks by the midpoint rule, fine enough for 1e-5.
        let parts = 400;
        let mean_of = |k: usize, l: usize, c: &dyn Fn(f64, f64) -> f64| {
            let at = |k: usize, i: usize| starts[k] + lengths[k] * (i as f64 + 0.5) / parts as f64;
            let sum: f64 = (0..parts)
                .flat_map(|i| (0..parts).map(move |j| (i, j)))
                .map(|(i, j)| c(at(k, i), at(l, j)))
                .sum();
            sum / (parts * parts) as f64
        };
        let covariance = |s: f64, t: f64| {
            let flicker: f64 = FLICKER_PROCESSES
                .iter()
                .map(|(time, sigma)| sigma * sigma * (-(s - t).abs() / time).exp())
                .sum();
            shape.flicker * flicker + shape.walk * s.min(t)
        };
        let matrix = SMatrix::<f64, 6, 6>::from_fn(|k, l| {
            mean_of(k, l, &covariance) + if k == l { 1.0 / lengths[k] } else { 0.0 }
        });
        let data = [0.3, -1.0, 0.7, 2.0, -0.4, 0.1];
        let with_bias = |y: f64| core::array::from_fn(|k| [y, 1.0].get(k).copied().unwrap_or(0.0));
        let rows: Vec<Columns> = data.iter().map(|y| with_bias(*y)).collect();
        let (mut squares, mut mixed) = (0.0, 0.0);
        let steps = Steps::new(&blocks).unwrap();
        let filter = steps.filter(shape).unwrap();
        let logarithms = filter.logarithms;
        let last = filter.whiten(&rows, |_, white| {
            squares += white[0] * white[0];
            mixed += white[0] * white[1];
        });
        // The walk behind the last block given all blocks: its covariance with a mean is K² times the middle of the block.
        let with_walk =
            nalgebra::SVector::<f64, 6>::from_fn(|k, _| shape.walk * (starts[k] + 0.5 * lengths[k]));
        let expected =
            (with_walk.transpose() * matrix.try_inverse().unwrap() * nalgebra::SVector::from(data))[0];
        let left = shape.walk * 12.0 - (with_walk.transpose() * matrix.try_inverse().unwrap() * with_walk)[0];
        assert!((last[0] / expected - 1.0).abs() < 1e-3, "{} {expected}", last[0]);
        assert!((filter.walk_variance / left - 1.0).abs() < 1e-3, "{} {left}", filter.walk_variance);
        let factor = matrix.cholesky().unwrap();
        let (determinant, inverse) = (factor.determinant(), factor.inverse());
        let form = |a: &[f64; 6], b: &[f64; 6]| -> f64 {
            (0..6).map(|k| (0..6).map(|l| a[k] * inverse[(k, l)] * b[l]).sum::<f64>()).sum()
        };
        assert!((logarithms - determinant.ln()).abs() < 1e-4, "{logarithms} {}", determinant.ln());
        assert!((squares / form(&data, &data) - 1.0).abs() < 1e-4, "{squares} {}", form(&data, &data));
        assert!((mixed / form(&data, &[1.0; 6]) - 1.0).abs() < 1e-3, "{mixed}");
    }
}
