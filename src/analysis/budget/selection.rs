//! The effects that can be left out.

use super::{BudgetRequest, BudgetRow};
use crate::analysis::recommend::SolutionError;

/// The effects left out so far: the sizes of deterministic contributions are added, and the squares of random ones.
#[derive(Debug, Clone, Copy, Default)]
struct Together {
    sums: [f64; 3],
    squares: [f64; 3],
}

impl Together {
    fn with(&self, worst: &SolutionError, is_random: bool) -> Self {
        let mut together = *self;
        for (k, size) in worst.parts().into_iter().enumerate() {
            if is_random {
                together.squares[k] += size * size;
            } else {
                together.sums[k] += size;
            }
        }
        together
    }

    fn size(&self) -> SolutionError {
        [0, 1, 2].map(|k| (self.sums[k] * self.sums[k] + self.squares[k]).sqrt()).into()
    }
}

/// Marks the rows that can be left out, of rows sorted with the largest share of a limit first: from the last on, those that still fit.
pub(super) fn mark(rows: &mut [BudgetRow], request: &BudgetRequest) {
    let mut together = Together::default();
    for row in rows.iter_mut().rev() {
        let more = together.with(&row.worst, row.effect.is_random);
        row.can_be_left_out = request.has_limits() && request.share(&more.size()) <= 1.0;
        if row.can_be_left_out {
            together = more;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::budget::EFFECTS;

    fn marks(contributions: &[(f64, f64, bool)], limits: (f64, f64)) -> Vec<bool> {
        let error = |position_m, velocity_m_s| SolutionError { position_m, velocity_m_s, attitude_rad: 9e9 };
        let limits = SolutionError { attitude_rad: 0.0, ..error(limits.0, limits.1) };
        let request = BudgetRequest { limits, ..Default::default() };
        let row = |&(p, v, is_random): &(f64, f64, bool)| BudgetRow {
            effect: EFFECTS.iter().find(|effect| effect.is_random == is_random).unwrap(),
            worst: error(p, v),
            end: error(p, v),
            share: 0.0,
            can_be_left_out: true,
        };
        let mut rows: Vec<_> = contributions.iter().map(row).collect();
        mark(&mut rows, &request);
        rows.iter().map(|row| row.can_be_left_out).collect()
    }

    #[test]
    fn sizes_add_and_random_ones_add_their_squares() {
        let (steady, random) = (false, true);
        assert_eq!(marks(&[(5.0, 0.0, steady), (3.0, 0.0, steady)], (7.9, 0.0)), [false, true]);
        assert_eq!(marks(&[(5.0, 0.0, steady), (3.0, 0.0, steady)], (8.0, 0.0)), [true, true]);
        // √(4² + 3²)
        assert_eq!(marks(&[(4.0, 0.0, random), (3.0, 0.0, random)], (5.0, 0.0)), [true, true]);
        assert_eq!(marks(&[(4.0, 0.0, random), (3.0, 0.0, random)], (4.99, 0.0)), [false, true]);
        assert_eq!(marks(&[(4.0, 0.0, steady), (3.0, 0.0, random)], (5.0, 0.0)), [true, true]);
        assert_eq!(marks(&[(4.0, 0.0, steady), (3.0, 0.0, random)], (4.99, 0.0)), [false, true]);
    }

    #[test]
    fn each_limit_is_kept_and_none_leaves_all_in() {
        // The second does not fit, the first, which has another quantity, does.
        assert_eq!(
            marks(&[(0.0, 1.0, false), (6.0, 0.0, false), (5.0, 0.0, false)], (10.0, 1.0)),
            [true, false, true]
        );
        assert_eq!(marks(&[(0.0, 0.0, false)], (0.0, 0.0)), [false]);
    }
}
