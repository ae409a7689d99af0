//! Does reality keep the prediction? A part of a record that was not identified is navigated from many starts, beside twins: virtual
//! records of the identified sensors along the same path.
//!
//! ```text
//!  true path ---> twin        sensors drawn from what was identified    -> record of the twin
//!                                                                              |
//!  record of the real sensors ---------------------------------------------> steps     on the clock and in the axes of the path
//!                                                                              |
//!  starts        flights of each duration within the part                  -> drift     navigation less truth at the end
//!                                                                              |
//!                                                                          verdict     the real record among the twins
//! ```
//!
//! - **The same treatment.** The real record and each twin pass through the same code: the clock, the axes and the errors that were
//!   identified are removed, the biases as they are at the end of the fit. Then the mechanization of the library navigates from the truth,
//!   and the truth is subtracted.
//! - **Twins.** A twin draws its parameters from the joint distribution that the fit found, also those that the motion does not show. So
//!   its drift contains what the fit does not know. All flights of a twin have the same parameters, and its noise goes on from flight to
//!   flight, as those of the real record do.
//! - **Figures.** The figure of a record and a duration is the median of the drifts of its flights. Flights of one record depend on each
//!   other, because they share biases and overlap. So the verdict does not count flights: it compares the figure of the real record with
//!   those of the twins, whose flights depend on each other in the same way.
//! - **Verdict.** z is the logarithm of the figure, less the mean of the twins, over their standard deviation. The limit of |z| is that
//!   which 95 % of the twins keep at all durations together. A right model agrees in 90 % of the cases: the flicker noise of a twin begins
//!   anew, while the slow part of the real one is in the bias that was removed.
//!
//! The number of flights, twins and durations is bounded. Memory is that of the path and the record, and of the record of one twin.

mod drift;
mod starts;
mod truth;
mod twin;
mod verdict;

pub use truth::Truth;
pub use verdict::{Agreement, Span};

use super::{Identified, RecordedIncrement, Request, identify};
use crate::base::error::{Error, Rule, check_integer, check_range};
use crate::base::memory::room;
use drift::{Steps, medians};
use starts::Starts;

/// Durations of the flights \[s\], as long as two of them have room in the part that is checked.
pub const DURATIONS_S: [f64; 6] = [10.0, 30.0, 60.0, 120.0, 300.0, 600.0];

/// Largest standard deviation of an angle of the truth \[rad\]: no error that is drawn turns by more than half a turn, which is ten of it.
const MOST_ANGLE: f64 = 0.3;

/// What a check is made with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CheckRequest {
    /// Number of twins, 40 to 1000.
    pub twins: usize,
    /// Seed of their random numbers.
    pub seed: u64,
    /// Standard deviations of the errors of the truth, with which a flight begins.
    pub truth: TruthSigma,
}

impl Default for CheckRequest {
    fn default() -> Self {
        Self { twins: 100, seed: 1, truth: TruthSigma::default() }
    }
}

impl CheckRequest {
    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        check_integer("check.twins", self.twins, 40, 1000)?;
        self.truth.validate()
    }
}

/// Standard deviations of the errors of the truth.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TruthSigma {
    /// Position, each axis \[m\], 0 to 1e4.
    pub position_m: f64,
    /// Velocity, each axis \[m/s\], 0 to 1e3.
    pub velocity_m_s: f64,
    /// Tilt about east and about north \[rad\], 0 to 0.3.
    pub tilt_rad: f64,
    /// Heading \[rad\], 0 to 0.3.
    pub heading_rad: f64,
}

impl TruthSigma {
    fn validate(&self) -> Result<(), Error> {
        check_range("truth.position_m", self.position_m, 0.0, 1e4)?;
        check_range("truth.velocity_m_s", self.velocity_m_s, 0.0, 1e3)?;
        check_range("truth.tilt_rad", self.tilt_rad, 0.0, MOST_ANGLE)?;
        check_range("truth.heading_rad", self.heading_rad, 0.0, MOST_ANGLE)
    }
}

/// What a check has found.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Length of the part of the record that was flown \[s\].
    pub length_s: f64,
    /// Number of twins.
    pub twins: usize,
    /// Each duration.
    pub spans: Vec<Span>,
    /// Shortest duration that is left out because half of the flights of the record or of a twin diverge \[s\]; longer ones are too.
    pub diverged_s: Option<f64>,
    /// Verdict on the model: that of the duration that is farthest off.
    pub agreement: Agreement,
}

/// Identifies the first half of the rows of `record` that the path has. Returns what was found, and the other half.
pub fn identify_first_half<'a>(
    truth: &Truth,
    record: &'a [RecordedIncrement],
    request: &Request,
) -> Result<(Identified, &'a [RecordedIncrement]), Error> {
    refuse_lever_arm(request.also.lever_arm)?;
    let whole = identify(truth.path(), record, request)?;
    let (first, other) = halves(truth, &whole, record)?;
    Ok((identify(truth.path(), first, request)?, other))
}

/// Flights begin at the point of the path, where sensors away from it are not.
fn refuse_lever_arm(is_asked: bool) -> Result<(), Error> {
    if !is_asked {
        return Ok(());
    }
    let rule = Rule::Sentence(
        "is no parameter of a check, whose flights begin at the point of the path: move the path",
    );
    Err(Error { value: None, ..Error::invalid("request.also.lever_arm", 1.0, rule) })
}

/// Rows of the record that the path has, in two halves. `found` was identified from the whole record: it has the clock.
fn halves<'a>(
    truth: &Truth,
    found: &Identified,
    record: &'a [RecordedIncrement],
) -> Result<(&'a [RecordedIncrement], &'a [RecordedIncrement]), Error> {
    let (from_s, to_s) = truth.ends_s()?;
    let before = |time_s: f64| record.partition_point(|row| found.path_time_s(row.time_s) < time_s);
    let first = before(from_s);
    let common = &record[first..before(to_s).max(first)];
    Ok(common.split_at(common.len() / 2))
}

/// Flies `record`, a part of the record that `found` was not identified from, and its twins.
pub fn check(
    truth: &Truth,
    found: &Identified,
    record: &[RecordedIncrement],
    request: &CheckRequest,
) -> Result<Check, Error> {
    request.validate()?;
    super::blocks::check(record)?;
    let removed = Steps::new(truth.path(), record, found, true)?;
    let within = removed.within(truth)?;
    let length_s = within.1 - within.0;
    let mut starts = Starts::new(&removed, within)?;
    if starts.spans.is_empty() && length_s >= 2.0 * DURATIONS_S[0] {
        return Err(Error::bad_state(
            "the part of the record that is checked has no two times of 10 s without a gap",
        ));
    }
    if starts.spans.is_empty() {
        let rule = Rule::AtLeast(
            "seconds of the part of the record that is checked and that the path has; must be at least",
            (2.0 * DURATIONS_S[0]).into(),
        );
        return Err(Error::invalid("check.length_s", length_s, rule));
    }
    let real = medians(truth, &removed, &starts, None)?;
    let free = medians(truth, &Steps::new(truth.path(), record, found, false)?, &starts, None)?;
    let mut twins = room(request.twins)?;
    for run in 0..request.twins as u64 {
        let twin = twin::Twin::draw(found, request, run, within.0);
        let steps = Steps::new(truth.path(), &twin.record(truth, found, within)?, found, true)?;
        twins.push(medians(truth, &steps, &starts, Some(&twin))?);
    }
    let keeps =
        |place: &usize| twins.iter().chain([&real]).all(|drifts| drifts[*place].quantile_m(0.5).is_finite());
    let kept = (0..starts.spans.len()).take_while(keeps).count();
    let diverged_s = starts.spans.get(kept).map(|flights| flights.duration_s);
    if kept == 0 {
        return Err(Error::bad_state(
            "half of the flights of 10 s diverge: the errors that are left are too large to navigate with",
        ));
    }
    starts.spans.truncate(kept);
    let check = verdict::check(length_s, &starts, (&free, &real), &twins)?;
    Ok(Check { diverged_s, ..check })
}
