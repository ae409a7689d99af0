//! The cheapest algorithm that meets a requirement.

use super::{Growth, Motion, Piece, Reference, Refusal, Requirement, Rung, Setup, SolutionError, ladder};
use crate::base::error::{Error, ErrorKind};
use crate::base::memory::room;
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
    /// For how long the errors are predicted: the required duration, or that of the longest piece if it is longer [s].
    pub duration_s: f64,
    /// Its predicted error: measured over the piece against the reference, the reference's uncertainty added, and grown.
    pub predicted: SolutionError,
    /// The part of it that is the reference's uncertainty.
    pub uncertainty: SolutionError,
    /// The hardest motion of the pieces.
    pub motion: Motion,
    /// Algorithms that were tried.
    pub tried: usize,
}

/// A piece of the flight by which the algorithms are judged.
struct Judge<'a> {
    /// Which piece.
    index: usize,
    samples: &'a [FlightSample],
    reference: Reference,
    growth: Growth,
}

impl Judge<'_> {
    /// The error over the duration of an algorithm with the error `error` in the piece.
    fn grown(&self, error: &SolutionError) -> SolutionError {
        self.growth.of(&error.plus(&self.reference.uncertainty))
    }

    /// The error over the duration of the algorithm of `setup`, which flies the piece until `give_up` finds this error bad enough.
    fn predict(
        &self,
        setup: &Setup,
        give_up: impl Fn(&SolutionError) -> bool,
    ) -> Result<SolutionError, Refusal> {
        let error = self.reference.error_of(setup, self.samples, |error| give_up(&self.grown(error)));
        error.map(|error| self.grown(&error)).map_err(in_piece(self.index))
    }
}

/// The first algorithm of the [`ladder`] that meets `requirement` in `setup`, by a piece of the host's flight. If none does: the
/// algorithm that takes up the smallest share of the requirement, and the cheapest of several with the same share.
///
/// The algorithms fly ideal signals, so errors of sensors, and contradictions between position, velocity and attitude of the host,
/// do not matter. A closed loop would hide the error, and is left out. The same samples have the same answer on every machine.
///
/// 18 to 70 µs a sample, 0.1 to 0.4 ms where nothing meets the requirement (2.8 GHz Xeon).
pub fn recommend(
    setup: &Setup,
    samples: &[FlightSample],
    requirement: &Requirement,
) -> Result<Recommendation, Refusal> {
    recommend_by(setup, &[samples], requirement)
}

/// [`recommend`] by several pieces of one flight: an algorithm has the largest of the errors that the pieces predict. The
/// prediction holds for the flight if the pieces have its hardest [`Motion`].
pub fn recommend_by(
    setup: &Setup,
    pieces: &[&[FlightSample]],
    requirement: &Requirement,
) -> Result<Recommendation, Refusal> {
    requirement.validate()?;
    let (mut figures, mut motion) = (room(pieces.len())?, Motion::default());
    let mut duration_s = requirement.duration_s;
    for (index, samples) in pieces.iter().enumerate() {
        let piece = Piece::new(&setup.options, samples).map_err(in_piece(index))?;
        duration_s = duration_s.max(piece.duration_s);
        motion.include(&piece.motion);
        figures.push(piece);
    }
    let (mut judges, mut uncertainty) = (room(pieces.len())?, SolutionError::default());
    for (index, (&samples, piece)) in pieces.iter().zip(&figures).enumerate() {
        let reference = Reference::everywhere(setup, samples).map_err(in_piece(index))?;
        let growth = Growth::new(piece, duration_s, setup.options.vertical);
        let judge = Judge { index, samples, reference, growth };
        uncertainty = uncertainty.max(&judge.grown(&SolutionError::default()));
        judges.push(judge);
    }

    let mut best: Option<Recommendation> = None;
    let mut refused = Refusal::from(Error::bad_state("no algorithm flies this piece"));
    let mut tried = 0;
    for rung in ladder(setup.options.frame) {
        tried += 1;
        let bound = best.map_or(f64::INFINITY, |best| best.share);
        match predict(&judges, &setup.with(&rung), requirement, bound) {
            Ok(None) => {}
            Ok(Some(predicted)) => {
                let share = requirement.share(&predicted);
                let met = share <= 1.0;
                best = Some(Recommendation {
                    rung,
                    met,
                    share,
                    duration_s,
                    predicted,
                    uncertainty,
                    motion,
                    tried,
                });
                if met {
                    break;
                }
            }
            // A coarse algorithm may diverge, or turn too far in an update near a pole, where a finer one does not.
            Err(refusal) if matches!(refusal.error.kind, ErrorKind::Diverged | ErrorKind::Singular) => {
                refused = refusal;
            }
            Err(refusal) => return Err(refusal),
        }
    }
    best.map(|best| Recommendation { tried, ..best }).ok_or(refused)
}

/// The largest error that the judges predict for the algorithm of `setup`; `None` if its share of the requirement reaches `bound`,
/// which ends its flight.
fn predict(
    judges: &[Judge<'_>],
    setup: &Setup,
    requirement: &Requirement,
    bound: f64,
) -> Result<Option<SolutionError>, Refusal> {
    let reaches_bound = |predicted: &SolutionError| requirement.share(predicted) >= bound;
    let mut worst = SolutionError::default();
    for judge in judges {
        worst = worst.max(&judge.predict(setup, reaches_bound)?);
        if reaches_bound(&worst) {
            return Ok(None);
        }
    }
    Ok(Some(worst))
}

fn in_piece(piece: usize) -> impl Fn(Refusal) -> Refusal {
    move |refusal| Refusal { piece, ..refusal }
}
