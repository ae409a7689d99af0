//! The results of a scene: cost and error of each configuration.

use sins::analysis::recommend::SolutionError;

use super::command::Effort;
use super::configuration::Configuration;
use super::matrix::Outcome;
use super::reference::Judgement;
use super::scene::{CurveScene, Pieces, Rate};
use super::timing::TimedWork;
use super::{grades, matrix};
use crate::failure::Failure;

/// A configuration at a sample rate, with its cost and its errors.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    pub configuration: Configuration,
    pub rate_hz: f64,
    /// Whether the scene vibrates too fast for the sample rate.
    pub is_undersampled: bool,
    /// Cost and errors, or the reason why there are none.
    pub measured: Result<Measured, String>,
    /// Whether the point is on the Pareto front.
    pub is_on_front: bool,
}

/// Cost and errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// Time for a simulated second [ns]; NaN until it is timed.
    pub cost_ns: f64,
    pub judgement: Judgement,
}

/// Results of a scene.
pub struct Survey {
    pub name: String,
    pub title: String,
    pub duration_s: f64,
    pub uncertainty: SolutionError,
    pub floor: SolutionError,
    /// The kind of reference.
    pub reference: &'static str,
    pub points: Vec<Point>,
    /// Position errors that sensors of navigation and of tactical grade cause [m].
    pub sensors_m: [f64; 2],
    /// What is doubtful in the flight data, and what is not flown, in sentences.
    pub warnings: Vec<String>,
}

#[cfg(test)]
impl Survey {
    /// A survey of `points` for tests, of a scene of `duration_s` [s].
    pub fn made(name: &str, duration_s: f64, points: Vec<Point>, sensors_m: [f64; 2]) -> Self {
        let floor = SolutionError { position_m: 1e-7, ..Default::default() };
        let (name, title) = (name.into(), "made".into());
        Self {
            name,
            title,
            duration_s,
            uncertainty: floor,
            floor,
            reference: "",
            points,
            sensors_m,
            warnings: Vec::new(),
        }
    }
}

impl Measured {
    pub fn position_m(&self) -> f64 {
        self.judgement.error.position_m
    }
}

impl Point {
    /// Cost and errors, if the sample rate is high enough for the errors to be true.
    pub fn eligible(&self) -> Option<&Measured> {
        self.measured.as_ref().ok().filter(|_| !self.is_undersampled)
    }
}

impl Survey {
    /// Flies all configurations on `pieces`. Returns their errors, the largest that a piece predicts for the whole scene, and the work
    /// that is still to be timed.
    pub fn flown(pieces: &Pieces, effort: &Effort) -> Result<(Self, TimedWork), Failure> {
        let scene = pieces.scenes.first().ok_or_else(|| Failure::new("a scene without a piece"))?;
        // A scene that is flown whole has its own errors.
        let growths = if pieces.scenes.len() > 1 { pieces.growths()? } else { Vec::new() };
        let grown = |piece: usize, error: &SolutionError| match growths.get(piece) {
            Some(growth) => growth.of(error),
            None => *error,
        };
        let largest = |of: &dyn Fn(&CurveScene) -> SolutionError| {
            let errors = pieces.scenes.iter().enumerate().map(|(piece, scene)| grown(piece, &of(scene)));
            errors.fold(SolutionError::default(), |most, error| most.max(&error))
        };
        let mut outcomes: Vec<(Rate, Configuration, Outcome)> = Vec::new();
        for (piece, scene) in pieces.scenes.iter().enumerate() {
            let mut flown = matrix::outcomes(scene, &Configuration::all());
            for (_, _, outcome) in &mut flown {
                if let Ok(judgement) = outcome {
                    judgement.error = grown(piece, &judgement.error);
                }
            }
            if piece == 0 {
                outcomes = flown;
                continue;
            }
            for ((_, _, outcome), (_, _, other)) in outcomes.iter_mut().zip(flown) {
                match (outcome.as_mut(), other) {
                    (Ok(one), Ok(other)) => *one = one.worse(&other),
                    (Ok(_), Err(refusal)) => *outcome = Err(refusal),
                    (Err(_), _) => {}
                }
            }
        }
        let candidates = outcomes.iter().filter(|(_, _, outcome)| outcome.is_ok());
        let work = TimedWork::new(scene, candidates.map(|(rate, which, _)| (*rate, *which)).collect());
        let point = |(rate, configuration, outcome): (Rate, Configuration, Outcome)| Point {
            configuration,
            rate_hz: rate.hz,
            is_undersampled: scene.is_undersampled(&rate),
            measured: outcome
                .map(|judgement| Measured { cost_ns: f64::NAN, judgement })
                .map_err(|error| error.to_string()),
            is_on_front: false,
        };
        let survey = Self {
            name: scene.name.clone(),
            title: scene.title.clone() + pieces.note(),
            duration_s: pieces.whole_s,
            uncertainty: largest(&|scene| scene.judge.uncertainty),
            floor: largest(&|scene| scene.judge.floor()),
            reference: scene.judge.description,
            points: outcomes.into_iter().map(point).collect(),
            sensors_m: grades::effects(pieces, effort.sensor_runs)?,
            warnings: scene.warnings.clone(),
        };
        Ok((survey, work))
    }

    /// Sets the costs, which are in the order of the work.
    pub fn set_costs(&mut self, costs: &[f64]) {
        let measured = self.points.iter_mut().filter_map(|point| point.measured.as_mut().ok());
        for (measured, cost_ns) in measured.zip(costs) {
            measured.cost_ns = *cost_ns;
        }
    }
}
