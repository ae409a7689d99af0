//! Checks of statistics that come from elsewhere.

use super::{LAYOUT, STATE_BITS, STATES, Statistics, check_runs, place_of};
use crate::base::error::{Error, Rule, Value};

impl Statistics {
    /// Rejects statistics that no runs can give: another layout, counts that contradict each other, sums out of their range.
    pub fn check(&self) -> Result<(), Error> {
        let size = size_of::<Self>();
        if self.struct_size as usize != size {
            let rule = Rule::Exactly("must be", size.into());
            return Err(Error::invalid("statistics.struct_size", self.struct_size, rule));
        }
        if self.layout != LAYOUT && (self.layout, self.runs) != (0, 0) {
            let rule = Rule::Exactly("is of another release or damaged; this one reads", LAYOUT.into());
            return Err(Error::invalid("statistics.layout", self.layout, rule));
        }
        if self.reserved != 0 {
            return Err(Error::invalid("statistics.reserved", self.reserved, Rule::Zero("")));
        }
        check_runs(self.runs)?;
        self.check_counts()?;
        self.check_sums()
    }

    fn check_counts(&self) -> Result<(), Error> {
        for (field, count) in [
            ("statistics.diverged", self.diverged),
            ("statistics.out_of_range", self.out_of_range),
            ("statistics.outside_validity", self.outside_validity),
        ] {
            require(count <= self.runs, field, count, Rule::AtMost(TOO_MANY, self.runs.into()))?;
        }
        let left_out = self.diverged + self.out_of_range;
        let rule = Rule::AtMost(TOO_MANY, self.runs.into());
        require(left_out <= self.runs, "statistics.diverged + out_of_range", left_out, rule)?;
        let good = self.good();
        let rule = Rule::AtMost("is damaged: more than the runs in the sums,", good.into());
        require(self.outside_validity <= good, "statistics.outside_validity", self.outside_validity, rule)?;

        let counted: u64 = self.histogram.iter().copied().map(u64::from).sum();
        let rule = Rule::Exactly("is damaged: the runs in the sums are", good.into());
        require(counted == good, "sum of statistics.histogram", counted, rule)?;
        let last = self.histogram.iter().rposition(|&count| count > 0);
        let of_largest = super::bucket_of(self.largest_radial.min((1 << STATE_BITS) - 1));
        let fits = self.largest_radial < 1 << STATE_BITS
            && last.map_or(self.largest_radial == 0, |last| of_largest == last);
        let rule = Rule::Sentence("is damaged: it is not in the last bucket of the histogram");
        require(fits, "statistics.largest_radial", self.largest_radial, rule)
    }

    fn check_sums(&self) -> Result<(), Error> {
        let good = i128::from(self.good());
        let damaged = |field, index| {
            Err(Error {
                value: None,
                ..Error::invalid(field, 0_u64, Rule::Sentence("is damaged: no runs have such sums")).at(index)
            })
        };
        for state in 0..STATES {
            let (sum, squares) = (self.sum(state), self.product(state, state));
            let in_range = (-(good << STATE_BITS)..=good << STATE_BITS).contains(&sum)
                && (0..=good << (2 * STATE_BITS)).contains(&squares);
            if !in_range || self.scatter(state, state) < 0.0 {
                return damaged("statistics.sums", state);
            }
        }
        for row in 0..STATES {
            for column in row + 1..STATES {
                let [x2, y2] = [row, column].map(|state| self.product(state, state) as u128);
                // (x - y)² and (x + y)² are squares.
                if self.product(row, column).unsigned_abs() > (x2 + y2) / 2 {
                    return damaged("statistics.products", place_of(row, column));
                }
            }
        }
        Ok(())
    }
}

const TOO_MANY: &str = "is damaged: more than runs, which are";

fn require(good: bool, field: &'static str, value: impl Into<Value>, rule: Rule) -> Result<(), Error> {
    if good { Ok(()) } else { Err(Error::invalid(field, value, rule)) }
}
