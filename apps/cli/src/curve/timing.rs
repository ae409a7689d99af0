//! Cost of the whole chain: intake, signal generator, mechanization with its damped vertical channel.
//!
//! All configurations of all scenes are timed in turns, round after round, so that a slow phase of the machine affects all alike.

use std::hint::black_box;
use std::time::{Duration, Instant};

use sins::truth::FlightSample;
use sins::{Error, Options, Simulator};

use super::configuration::Configuration;
use super::scene::{CurveScene, Rate};
use crate::progress::Progress;

/// Number of places of the scene where a round flies, equally spaced. A step costs more where the aircraft turns.
const PLACES: usize = 8;

/// Numbers of samples at a place: before the timing, until the chain runs as in the middle of a flight, and during the timing.
const WARM_UP: usize = 8;
const TIMED: usize = 64;

/// Work that is to be timed on a scene: configurations and rates on stretches of its samples.
pub struct TimedWork {
    base: Options,
    stretches: Vec<(Rate, Vec<Vec<FlightSample>>)>,
    candidates: Vec<(Rate, Configuration)>,
}

impl TimedWork {
    pub fn new(scene: &CurveScene, candidates: Vec<(Rate, Configuration)>) -> Self {
        let at = |rate: &Rate| (*rate, stretches(&scene.samples_at(rate)));
        Self { base: scene.base, stretches: scene.rates.iter().map(at).collect(), candidates }
    }
}

/// Time that each candidate of each work takes for a simulated second [ns], median over `rounds`.
pub fn costs(works: &[TimedWork], rounds: usize) -> Result<Vec<Vec<f64>>, Error> {
    let mut times: Vec<Vec<Vec<f64>>> =
        works.iter().map(|work| vec![Vec::with_capacity(rounds); work.candidates.len()]).collect();
    let progress = Progress::counting("timing all of them in turns", rounds * works.len());
    for _ in 0..rounds {
        for (work, times) in works.iter().zip(&mut times) {
            for ((rate, configuration), times) in work.candidates.iter().zip(times) {
                let own = work.stretches.iter().filter(|(other, _)| other == rate);
                times.push(time(
                    &rate.applied_to(&configuration.options(&work.base)),
                    rate.hz,
                    own.flat_map(|(_, stretches)| stretches),
                )?);
            }
            progress.count();
        }
    }
    Ok(times.into_iter().map(|times| times.into_iter().map(median).collect()).collect())
}

fn stretches(samples: &[FlightSample]) -> Vec<Vec<FlightSample>> {
    let length = (WARM_UP + TIMED).min(samples.len());
    let last = samples.len() - length;
    (0..PLACES)
        .map(|place| last * place / (PLACES - 1))
        .map(|from| samples[from..from + length].to_vec())
        .collect()
}

/// Time for a simulated second on `stretches` [ns].
fn time<'a>(
    options: &Options,
    rate_hz: f64,
    stretches: impl Iterator<Item = &'a Vec<FlightSample>>,
) -> Result<f64, Error> {
    let (mut elapsed, mut steps) = (Duration::ZERO, 0);
    for stretch in stretches {
        let mut simulator = Simulator::new(options)?;
        let (warm_up, timed) = stretch.split_at(WARM_UP.min(stretch.len() / 2));
        fly(&mut simulator, warm_up)?;
        let start = Instant::now();
        fly(&mut simulator, timed)?;
        elapsed += start.elapsed();
        black_box(&simulator);
        steps += timed.len();
    }
    Ok(elapsed.as_secs_f64() * 1e9 / steps as f64 * rate_hz)
}

#[inline(never)]
fn fly(simulator: &mut Simulator, samples: &[FlightSample]) -> Result<(), Error> {
    for sample in samples {
        simulator.push_sample(black_box(sample))?;
        simulator.step()?;
    }
    Ok(())
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    match values.as_slice() {
        [] => f64::NAN,
        values if values.len() % 2 == 1 => values[middle],
        values => 0.5 * (values[middle - 1] + values[middle]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_in_the_middle() {
        assert_eq!((median(vec![5.0, 1.0, 2.0]), median(vec![4.0, 1.0, 3.0, 2.0])), (2.0, 2.5));
    }
}
