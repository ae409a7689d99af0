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

/// A piece by which the algorithms are judged.
struct Judge<'a> {
    samples: &'a [FlightSample],
    reference: Reference,
    growth: Growth,
}

impl<'a> Judge<'a> {
    fn new(setup: &Setup, samples: &'a [FlightSample], duration_s: f64) -> Result<Self, Refusal> {
        let growth = Growth::new(&Piece::new(&setup.options, samples)?, duration_s, setup.options.vertical);
        let mut instants = room(samples.len())?;
        instants.extend(1..samples.len());
        Ok(Self { samples, reference: Reference::new(setup, samples, &instants)?, growth })
    }

    /// The error at the end of the duration of an algorithm with the error `error` in the piece.
    fn predict(&self, error: &SolutionError) -> SolutionError {
        self.growth.of(&error.plus(&self.reference.uncertainty))
    }
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
    recommend_by(setup, &[samples], requirement)
}

/// [`recommend`] by several pieces of one flight: an algorithm has the larger of the errors that the pieces predict. If the pieces
/// have the largest rates, forces and vibration of the flight, the prediction holds for all of it.
pub fn recommend_by(
    setup: &Setup,
    pieces: &[&[FlightSample]],
    requirement: &Requirement,
) -> Result<Recommendation, Refusal> {
    requirement.validate()?;
    let in_piece = |piece: usize| move |refusal: Refusal| Refusal { piece, ..refusal };
    let mut duration_s = requirement.duration_s;
    if duration_s == 0.0 {
        for (place, samples) in pieces.iter().enumerate() {
            let piece = Piece::new(&setup.options, samples).map_err(in_piece(place))?;
            duration_s = duration_s.max(piece.duration_s);
        }
    }
    let mut judges = room(pieces.len())?;
    for (place, samples) in pieces.iter().enumerate() {
        judges.push(Judge::new(setup, samples, duration_s).map_err(in_piece(place))?);
    }

    let none = SolutionError::default();
    let uncertainty =
        judges.iter().fold(none, |worst, judge| worst.larger(&judge.growth.of(&judge.reference.uncertainty)));
    let mut best: Option<Recommendation> = None;
    let mut refused = Refusal::from(Error::bad_state("no algorithm flies this piece"));
    let mut tried = 0;
    'ladder: for rung in ladder(setup.options.frame) {
        tried += 1;
        // Not better than the best so far: it is neither the answer nor the best.
        let bound = best.map_or(f64::INFINITY, |best| best.share);
        let mut predicted = none;
        for (place, judge) in judges.iter().enumerate() {
            let is_worse = |error: &SolutionError| requirement.share(&judge.predict(error)) >= bound;
            match judge.reference.error_of(&setup.with(&rung), judge.samples, is_worse) {
                Ok(error) => predicted = predicted.larger(&judge.predict(&error)),
                // A coarse algorithm may diverge, or turn too far in an update near a pole, where a finer one does not.
                Err(refusal) if matches!(refusal.error.kind, ErrorKind::Diverged | ErrorKind::Singular) => {
                    refused = in_piece(place)(refusal);
                    continue 'ladder;
                }
                Err(refusal) => return Err(in_piece(place)(refusal)),
            }
            if requirement.share(&predicted) >= bound {
                continue 'ladder;
            }
        }
        let share = requirement.share(&predicted);
        let met = share <= 1.0;
        best = Some(Recommendation { rung, met, share, duration_s, predicted, uncertainty, tried: 0 });
        if met {
            break;
        }
    }
    best.map(|best| Recommendation { tried, ..best }).ok_or(refused)
}
