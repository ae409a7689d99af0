//! What was found out about a scene.

use sins::recommend::SolutionError;

use super::command::Effort;
use super::configuration::Configuration;
use super::reference::Judgement;
use super::scene::Scene;
use super::timing::Candidate;
use super::{front, grades, matrix, timing};
use crate::failure::Failure;

/// A configuration at a rate, with what it costs and what it leaves.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    pub configuration: Configuration,
    pub rate_hz: f64,
    /// Whether the scene vibrates faster than the samples can tell.
    pub is_undersampled: bool,
    /// Time for a simulated second [ns] and errors, or why there are none.
    pub measured: Result<Measured, String>,
    /// Whether it is on the Pareto front.
    pub is_on_front: bool,
}

/// Cost and errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// Time for a simulated second [ns].
    pub cost_ns: f64,
    pub judgement: Judgement,
}

/// A scene surveyed.
pub struct Survey {
    pub name: String,
    pub title: String,
    pub duration_s: f64,
    pub uncertainty: SolutionError,
    pub floor: SolutionError,
    /// What the reference is.
    pub reference: &'static str,
    pub points: Vec<Point>,
    /// Position errors that the grades of sensors make [m].
    pub sensors_m: [f64; 2],
}

impl Measured {
    pub fn position_m(&self) -> f64 {
        self.judgement.error.position_m
    }
}

impl Point {
    /// Cost and errors where they can be believed.
    pub fn eligible(&self) -> Option<&Measured> {
        self.measured.as_ref().ok().filter(|_| !self.is_undersampled)
    }
}

impl Survey {
    /// Flies and times all of `scene`.
    pub fn new(scene: &Scene, effort: &Effort) -> Result<Self, Failure> {
        let outcomes = matrix::outcomes(scene, &Configuration::all());
        let sensors_m = grades::effects(scene, effort.sensor_runs)?;
        let flown = outcomes.iter().filter(|(_, _, outcome)| outcome.is_ok());
        let candidates: Vec<Candidate> =
            flown.map(|&(rate, configuration, _)| Candidate { rate, configuration }).collect();
        let mut costs = timing::costs(scene, &candidates, effort.rounds)?.into_iter();
        let mut points: Vec<Point> = outcomes
            .into_iter()
            .map(|(rate, configuration, outcome)| Point {
                configuration,
                rate_hz: rate.hz,
                is_undersampled: scene.is_undersampled(&rate),
                measured: match outcome {
                    Ok(judgement) => Ok(Measured { cost_ns: costs.next().unwrap_or(f64::NAN), judgement }),
                    Err(error) => Err(error.to_string()),
                },
                is_on_front: false,
            })
            .collect();
        front::mark(&mut points);
        Ok(Self {
            name: scene.name.clone(),
            title: scene.title.clone(),
            duration_s: scene.duration_s(),
            uncertainty: scene.judge.uncertainty,
            floor: scene.judge.floor(),
            reference: scene.judge.words,
            points,
            sensors_m,
        })
    }
}
