//! The cheapest algorithm that meets a requirement.

use super::{Growth, Piece, Reference, Refusal, Requirement, Rung, Setup, SolutionError, ladder};
use crate::error::{Error, ErrorKind};
use crate::memory::room;
use crate::truth::FlightSample;

/// An algorithm and what it gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recommendation {
    /// The algorithm.
    pub rung: Rung,
    /// Whether it meets the requirement with the margin. If not, no algorithm does, and this one comes closest.
    pub met: bool,
    /// The share of the requirement that it takes up with the margin: [`Requirement::share`].
    pub share: f64,
    /// For how long the errors are predicted [s].
    pub duration_s: f64,
    /// Its predicted error: measured over the piece against the reference, the reference's uncertainty added, and grown.
    pub predicted: SolutionError,
    /// The part of it that is the reference's uncertainty.
    pub uncertainty: SolutionError,
    /// Algorithms that were tried.
    pub tried: usize,
}

/// The first algorithm of the [`ladder`] that meets `requirement` in `setup`, by a piece of the host's flight: all that are
/// cheaper do not. If none does: the one that takes up the smallest share of the requirement, of two that take up the same the cheaper.
///
/// The algorithms are judged by the error that they make on ideal signals, so neither sensor errors nor a host whose position,
/// velocity and attitude contradict each other come in; with a closed loop, which would hide that error, on the signals
/// without it. Same samples, same answer, on every machine.
///
/// 25 to 70 µs a sample, up to 0.4 ms where nothing meets the requirement (2.8 GHz Xeon).
pub fn recommend(
    setup: &Setup,
    samples: &[FlightSample],
    requirement: &Requirement,
) -> Result<Recommendation, Refusal> {
    requirement.validate()?;
    let piece = Piece::new(&setup.options, samples)?;
    let duration_s = if requirement.duration_s > 0.0 { requirement.duration_s } else { piece.duration_s };
    let growth = Growth::new(&piece, duration_s, setup.options.vertical);
    let mut instants = room(samples.len())?;
    instants.extend(1..samples.len());
    let reference = Reference::new(setup, samples, &instants)?;
    drop(instants);

    let predict = |error: &SolutionError| growth.of(&error.plus(&reference.uncertainty));
    let share = |error: &SolutionError| requirement.share(&predict(error));
    let mut best: Option<Recommendation> = None;
    let mut refused = Refusal::from(Error::bad_state("no algorithm flies this piece"));
    let mut tried = 0;
    for rung in ladder(setup.options.frame) {
        tried += 1;
        // Not better than the best so far: it is neither the answer nor the best.
        let bound = best.map_or(f64::INFINITY, |best| best.share);
        let error = reference.error_of(&setup.with(&rung), samples, |error| share(error) >= bound);
        let error = match error {
            Ok(error) => error,
            // A coarse algorithm may lose itself, or turn too far in an update near a pole, where a finer one does not.
            Err(refusal) if matches!(refusal.error.kind, ErrorKind::Diverged | ErrorKind::Singular) => {
                refused = refusal;
                continue;
            }
            Err(refusal) => return Err(refusal),
        };
        let share = share(&error);
        if share < bound {
            let (predicted, uncertainty) = (predict(&error), growth.of(&reference.uncertainty));
            let met = share <= 1.0;
            best = Some(Recommendation { rung, met, share, duration_s, predicted, uncertainty, tried: 0 });
        }
        if best.is_some_and(|best| best.met) {
            break;
        }
    }
    best.map(|best| Recommendation { tried, ..best }).ok_or(refused)
}
