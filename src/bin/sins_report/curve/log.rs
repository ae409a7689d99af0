//! The scene of a flight log.

use std::path::Path;

use sins::Options;

use super::reference::Judge;
use super::scene::{Rate, Scene};
use crate::failure::Failure;
use crate::flight_log;

/// The samples are thinned down to no fewer than these.
const LOWEST_HZ: f64 = 10.0;
const FEWEST_SAMPLES: usize = 120;

/// The scene of the log at `path`: at its own rate, with every second sample, every fourth and so on.
pub fn scene(path: &Path) -> Result<Scene, Failure> {
    let samples = flight_log::read(path)?;
    let span_s = samples[samples.len() - 1].time_s - samples[0].time_s;
    let own_hz = (samples.len() - 1) as f64 / span_s;
    let thinned = |stride: &usize| {
        // The epsilon keeps a rate that rounding puts just below.
        *stride == 1
            || (own_hz / *stride as f64 > LOWEST_HZ * (1.0 - 1e-6) && samples.len() / stride > FEWEST_SAMPLES)
    };
    let rates: Vec<Rate> = (0..6)
        .map(|power| 1 << power)
        .filter(thinned)
        .map(|stride| Rate::of_stamps(stride, own_hz / stride as f64))
        .collect();
    let judge = Judge::of_log(&Options::default(), &samples, &Scene::instants(samples.len(), &rates, 1))
        .map_err(|failure| Failure::of_file(path, &failure))?;
    let title = format!("{} s at {} Hz", round(span_s), round(own_hz));
    Ok(Scene { name: flight_log::name(path), title, highest_hz: 0.0, samples, rates, judge })
}

fn round(value: f64) -> f64 {
    (value * 10.0).round() / 10.0
}
