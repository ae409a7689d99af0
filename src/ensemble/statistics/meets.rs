//! Whether runs meet a requirement such as "95 % of the flights within 2 km", as far as their number allows the decision.

use super::radial::bucket_of;
use super::{FRACTION_BITS, STATE_BITS, Statistics, resolution};
use crate::base::error::{Error, Rule};

/// The standard normal quantile of 97.5 %: the intervals contain the true fraction with 95 % confidence.
const Z: f64 = 1.959_963_984_540_054;

/// Whether a requirement is met: "95 % of the flights are within 2 km".
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Decision {
    /// The interval of the fraction contains the required fraction. sins_verdict.more_runs runs more would decide.
    Undecided = 0,
    /// Met: the whole interval is above the required fraction.
    Met = 1,
    /// Not met: the whole interval is below the required fraction.
    NotMet = 2,
}

/// How many runs are within a limit, and what follows for a requirement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Verdict {
    /// Whether the requirement is met.
    pub decision: Decision,
    /// All runs, also those that diverged or are out of range: they are outside the limit.
    pub runs: u64,
    /// Runs that are certainly within the limit.
    pub inside: u64,
    /// Runs in the bucket of the histogram that the limit divides: inside or outside.
    pub near_limit: u64,
    /// Ends of the interval that contains the true fraction of runs within the limit with 95 % confidence (Wilson 1927) [1].
    pub low: f64,
    /// The upper end of this interval [1].
    pub high: f64,
    /// Number of further runs that decide if the fraction stays as it is: 0 if it is decided, `None` if no number does.
    pub more_runs: Option<u64>,
}

impl Verdict {
    /// The verdict of `inside` of `runs` runs, and `near_limit` more of which it is unknown, about the requirement that `percent`
    /// of all runs are inside.
    ///
    /// With p the required fraction and f the measured one, Wilson's interval of n runs contains p if
    ///
    /// |f - p| ≤ z √(p (1 - p)/n),
    ///
    /// so n = z² p (1 - p)/(f - p)² runs decide. Source: Wilson, J. Amer. Stat. Assoc. 22 (1927) 209.
    ///
    /// [`crate::ErrorKind::InvalidArgument`]: `percent` is not between 0 and 100.
    pub fn new(runs: u64, inside: u64, near_limit: u64, percent: f64) -> Result<Self, Error> {
        if !(percent > 0.0 && percent < 100.0) {
            let rule = Rule::Sentence("must be above 0 and below 100");
            return Err(Error::invalid("percent", percent, rule));
        }
        let (p, n) = (percent / 100.0, runs as f64);
        let fraction = |inside: u64| if runs > 0 { inside as f64 / n } else { p };
        let (least, most) = (fraction(inside), fraction(inside + near_limit));
        // Positive on the side that would decide; 0 if the limit's bucket contains the required fraction.
        let excess = (least - p).max(p - most).max(0.0);
        let needed = Z * Z * p * (1.0 - p) / (excess * excess);
        let decision = match (n > needed, least > p) {
            (false, _) => Decision::Undecided,
            (true, true) => Decision::Met,
            (true, false) => Decision::NotMet,
        };
        let more_runs = match decision {
            Decision::Undecided if excess == 0.0 => None,
            Decision::Undecided => Some((needed.floor() as u64).saturating_sub(runs).saturating_add(1)),
            _ => Some(0),
        };
        let (low, high) = (wilson(least, n, -1.0), wilson(most, n, 1.0));
        Ok(Self { decision, runs, inside, near_limit, low, high, more_runs })
    }
}

/// An end of the interval of the fraction `f` of `n` runs [1].
fn wilson(f: f64, n: f64, sign: f64) -> f64 {
    let end = 0.5 + 0.5 * sign;
    if n == 0.0 || f == end {
        return end;
    }
    let half = Z * (f * (1.0 - f) / n + Z * Z / (4.0 * n * n)).sqrt();
    ((f + Z * Z / (2.0 * n) + sign * half) / (1.0 + Z * Z / n)).clamp(0.0, 1.0)
}

impl Statistics {
    /// Whether `percent` of the runs are within the horizontal radius `radius_m` of the truth.
    ///
    /// [`crate::ErrorKind::InvalidArgument`]: a number is out of its range, or the statistics are damaged or of another release.
    pub fn meets(&self, radius_m: f64, percent: f64) -> Result<Verdict, Error> {
        self.check()?;
        let unit = resolution(FRACTION_BITS[0]);
        let most = (1_u64 << STATE_BITS) as f64 * unit;
        if !(radius_m > 0.0 && radius_m <= most) {
            let rule = Rule::Sentence("must be above 0 and at most 33554432");
            return Err(Error::invalid("radius_m", radius_m, rule));
        }
        let limit = ((radius_m / unit).floor() as u64).min((1 << STATE_BITS) - 1);
        let bucket = bucket_of(limit);
        let inside: u64 = self.histogram[..bucket].iter().copied().map(u64::from).sum();
        let near_limit = u64::from(self.histogram[bucket]);
        if self.largest_radial <= limit {
            return Verdict::new(self.runs, inside + near_limit, 0, percent);
        }
        Verdict::new(self.runs, inside, near_limit, percent)
    }
}
