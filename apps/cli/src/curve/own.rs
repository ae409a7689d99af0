//! Scenes of the user: flights in closed form, and flight logs.

use sins::Options;
use sins::analysis::recommend::Refusal;
use sins::scene::{FlightSource, builtin};
use sins::truth::FlightSample;
use sins::truth::flight::Manoeuvre;

use super::command::{Effort, FULL};
use super::embedded;
use super::reference::Judge;
use super::scene::{CurveScene, Pieces, Rate};
use crate::failure::Failure;
use crate::given::Given;
use crate::recommend::{PIECE_S, hardest_parts};

/// Lowest rate [Hz] and number of samples that must remain when the samples of a log are thinned.
const LOWEST_HZ: f64 = 10.0;
const FEWEST_SAMPLES: usize = 120;

/// The scene of `given` in one piece: a whole log, or at most `effort.duration_s` of a flight in closed form; or in the hardest pieces of
/// the time for which the full effort flies, if that is longer.
pub fn scene(given: &Given, effort: &Effort) -> Result<Pieces, Failure> {
    let mut made = without_warnings(given, effort)?;
    for scene in &mut made.scenes {
        scene.warnings = given.warnings(given.without_updates());
    }
    Ok(made)
}

fn without_warnings(given: &Given, effort: &Effort) -> Result<Pieces, Failure> {
    let scene = &given.scene;
    let base =
        Options { ellipsoid: scene.options.ellipsoid, gravity: scene.options.gravity, ..Options::default() };
    match given.flight() {
        Some(flight) => {
            let what = embedded::Sampled {
                name: &given.name,
                title: &given.title,
                highest_hz: highest_hz(&scene.flight),
                base,
            };
            let whole_s = given.duration_s.min(FULL.duration_s);
            if whole_s <= effort.duration_s {
                return Ok(Pieces::whole(what.scene(flight, 0.0, whole_s)?));
            }
            let begin_s = |(first, _): (usize, usize)| {
                let longest_s = 1.0 / f64::from(embedded::RATES_HZ[embedded::RATES_HZ.len() - 1]);
                (given.time_s(first) / longest_s + 1e-6).floor() * longest_s
            };
            let parts = hardest_parts(given, 0, given.index_at(whole_s))?.into_iter();
            let scenes = parts.map(|part| what.scene(flight, begin_s(part), PIECE_S));
            let scenes = scenes.collect::<Result<_, _>>()?;
            Ok(Pieces { scenes, whole_s, coarse: Some(embedded::coarse(flight, whole_s)?) })
        }
        None => of_log(given, base).map(Pieces::whole),
    }
}

/// The scene of a log at its own rate, with every second sample, every fourth sample and so on.
fn of_log(given: &Given, base: Options) -> Result<CurveScene, Failure> {
    let samples: Vec<FlightSample> =
        (0..given.count).map(|index| given.sample(index)).collect::<Result<_, _>>()?;
    let own_hz = 1.0 / given.period_s;
    let thinned = |stride: &usize| {
        // The epsilon keeps a rate that rounding puts just below the lowest rate.
        *stride == 1
            || (own_hz / *stride as f64 > LOWEST_HZ * (1.0 - 1e-6) && samples.len() / stride > FEWEST_SAMPLES)
    };
    let rates: Vec<Rate> = (0..6)
        .map(|power| 1 << power)
        .filter(thinned)
        .map(|stride| Rate::of_stamps(stride, own_hz / stride as f64))
        .collect();
    let instants = CurveScene::instants(samples.len(), &rates, 1);
    let judge =
        Judge::of_log(&base, &samples, &instants).map_err(|Refusal { error, sample, .. }| match sample {
            Some(index) => given.failure_at(index, &error),
            None => Failure::new(format!("{}: {error}", given.origin)),
        })?;
    let title = format!("{} s at {} Hz", round(given.duration_s), round(own_hz));
    let (name, warnings) = (given.name.clone(), Vec::new());
    Ok(CurveScene { name, title, highest_hz: 0.0, samples, rates, judge, base, warnings })
}

/// Highest frequency of the sinusoids of a flight [Hz]; 0 without sinusoids.
fn highest_hz(source: &FlightSource) -> f64 {
    let manoeuvres = match source {
        FlightSource::Path(path) => path.manoeuvres.clone(),
        FlightSource::Builtin(name) => match builtin(name).map(|scene| scene.flight) {
            Some(FlightSource::Path(path)) => path.manoeuvres,
            _ => Vec::new(),
        },
        FlightSource::Log(_) => Vec::new(),
    };
    let of = |manoeuvre: &Manoeuvre| match manoeuvre {
        Manoeuvre::Sinusoids { sinusoids, .. } => {
            let moving = sinusoids.terms().iter().filter(|term| term.amplitude != 0.0);
            moving.fold(0.0, |most: f64, term| most.max(term.frequency_hz))
        }
        _ => 0.0,
    };
    manoeuvres.iter().map(of).fold(0.0, f64::max)
}

fn round(value: f64) -> f64 {
    (value * 10.0).round() / 10.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fastest_sinusoid_counts() {
        let of = |name: &str| highest_hz(&FlightSource::Builtin(name.to_owned()));
        assert_eq!((of("coning"), of("rest")), (0.5, 0.0));
        assert!((of("patrol") - 1.0 / 5.3).abs() < 1e-12);
    }
}
