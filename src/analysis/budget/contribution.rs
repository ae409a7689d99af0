//! The size of a contribution over the runs.

use super::flight::Deviation;
use crate::analysis::recommend::SolutionError;
use crate::base::error::Error;
use crate::base::memory::filled;

/// Sums of squares of the lengths of position, velocity and misalignment at each instant.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Contribution {
    squares: Box<[[f64; 3]]>,
    runs: u64,
}

impl Contribution {
    /// The sums without runs.
    pub fn new(instants: usize) -> Result<Self, Error> {
        Ok(Self { squares: filled(instants, [0.0; 3])?, runs: 0 })
    }

    /// Adds a run with `deviations` at the instants.
    pub fn add(&mut self, deviations: impl Iterator<Item = Deviation>) {
        self.runs += 1;
        for (squares, deviation) in self.squares.iter_mut().zip(deviations) {
            for (square, row) in squares.iter_mut().zip([0, 3, 6]) {
                *square += deviation.fixed_rows::<3>(row).norm_squared();
            }
        }
    }

    /// Root mean square over the runs, the largest of all instants.
    pub fn worst(&self) -> SolutionError {
        let larger = |most: [f64; 3], squares: &[f64; 3]| [0, 1, 2].map(|k| most[k].max(squares[k]));
        self.root(self.squares.iter().fold([0.0; 3], larger))
    }

    /// Root mean square over the runs, at the last instant.
    pub fn end(&self) -> SolutionError {
        self.root(self.squares.last().copied().unwrap_or_default())
    }

    fn root(&self, squares: [f64; 3]) -> SolutionError {
        let runs = self.runs.max(1) as f64;
        squares.map(|square| (square / runs).sqrt()).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn worst_and_end_are_over_the_runs() {
        let mut contribution = Contribution::new(2).unwrap();
        let along = |position: f64, velocity: f64| {
            let mut deviation = Deviation::zeros();
            (deviation[1], deviation[3]) = (position, velocity);
            deviation
        };
        contribution.add([along(3.0, 1.0), along(1.0, 2.0)].into_iter());
        contribution.add([along(-4.0, 0.0), along(1.0, 2.0)].into_iter());
        let worst = SolutionError { position_m: 12.5f64.sqrt(), velocity_m_s: 2.0, attitude_rad: 0.0 };
        assert_eq!(contribution.worst(), worst);
        assert_eq!(contribution.end(), SolutionError { position_m: 1.0, ..worst });
    }
}
