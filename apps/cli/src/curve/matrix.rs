//! The errors of the matrix: every configuration at every rate.

use sins::Simulator;
use sins::analysis::recommend::{Refusal, track};

use super::configuration::Configuration;
use super::reference::Judgement;
use super::scene::{CurveScene, Rate};
use crate::parallel::in_parallel;
use crate::progress::Progress;

/// Result of a flight: its errors, or the reason for its refusal.
pub type Outcome = Result<Judgement, Refusal>;

/// The outcome of each of `configurations` at each rate of `scene`, rate by rate.
pub fn outcomes(scene: &CurveScene, configurations: &[Configuration]) -> Vec<(Rate, Configuration, Outcome)> {
    let samples: usize = scene.rates.iter().map(|rate| scene.samples.len().div_ceil(rate.stride)).sum();
    let what = format!("{}: flying every configuration", scene.name);
    let progress = Progress::flying(what, samples * configurations.len(), false);
    let mut outcomes = Vec::new();
    for rate in &scene.rates {
        let (samples, instants) = (scene.samples_at(rate), scene.instants_at(rate));
        let flown = in_parallel(configurations, |configuration| {
            let options = rate.applied_to(&configuration.options(&scene.base));
            let mut simulator = Simulator::new(&options)?;
            let track = track(&mut simulator, &samples, &instants);
            progress.fly(samples.len(), 1.0 / rate.hz);
            track.map(|track| scene.judge.judge(&track))
        });
        outcomes.extend(configurations.iter().zip(flown).map(|(which, outcome)| (*rate, *which, outcome)));
    }
    outcomes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::embedded;
    use sins::ErrorKind;

    #[test]
    fn geographic_axes_are_singular_at_the_pole() {
        let mut scene = embedded::ALL[4].scene(120.0).unwrap();
        scene.rates.retain(|rate| rate.hz == 10.0);
        let all = [Configuration::of(&Default::default()), Configuration::PAPER];
        let outcomes = outcomes(&scene, &all);
        assert!(outcomes[0].2.is_ok());
        assert_eq!(outcomes[1].2.as_ref().unwrap_err().error.kind, ErrorKind::Singular);
    }
}
