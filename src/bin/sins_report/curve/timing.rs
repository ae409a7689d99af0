//! What the whole chain costs: intake, signal generator, mechanization with its damped vertical channel.
//!
//! All configurations take turns on the same samples, round after round: a slow phase of the machine hits them alike.

use std::hint::black_box;
use std::time::{Duration, Instant};

use sins::truth::FlightSample;
use sins::{Error, Simulator};

use super::configuration::Configuration;
use super::scene::{Rate, Scene};

/// Places of the scene that a round flies at, equally spaced: a step costs more where the aircraft turns.
const PLACES: usize = 8;

/// Samples at a place: until the chain runs as it does in the middle of a flight, and timed.
const WARM_UP: usize = 8;
const TIMED: usize = 64;

/// What is to be timed.
pub struct Candidate {
    pub rate: Rate,
    pub configuration: Configuration,
}

/// Time that each of `candidates` takes for a simulated second [ns], median over `rounds`.
pub fn costs(scene: &Scene, candidates: &[Candidate], rounds: usize) -> Result<Vec<f64>, Error> {
    let stretches: Vec<(Rate, Vec<Vec<FlightSample>>)> =
        scene.rates.iter().map(|rate| (*rate, stretches(&scene.samples_at(rate)))).collect();
    let mut times: Vec<Vec<f64>> = vec![Vec::with_capacity(rounds); candidates.len()];
    for _ in 0..rounds {
        for (candidate, times) in candidates.iter().zip(&mut times) {
            let own = stretches.iter().filter(|(rate, _)| *rate == candidate.rate);
            times.push(time(candidate, own.flat_map(|(_, stretches)| stretches))?);
        }
    }
    Ok(times.into_iter().map(median).collect())
}

fn stretches(samples: &[FlightSample]) -> Vec<Vec<FlightSample>> {
    let length = (WARM_UP + TIMED).min(samples.len());
    let last = samples.len() - length;
    (0..PLACES)
        .map(|place| last * place / (PLACES - 1))
        .map(|from| samples[from..from + length].to_vec())
        .collect()
}

/// For a simulated second on `stretches` [ns].
fn time<'a>(
    candidate: &Candidate,
    stretches: impl Iterator<Item = &'a Vec<FlightSample>>,
) -> Result<f64, Error> {
    let options = candidate.rate.applied_to(&candidate.configuration.options());
    let (mut elapsed, mut steps) = (Duration::ZERO, 0);
    for stretch in stretches {
        let mut simulator = Simulator::new(&options)?;
        let (warm_up, timed) = stretch.split_at(WARM_UP.min(stretch.len() / 2));
        fly(&mut simulator, warm_up)?;
        let start = Instant::now();
        fly(&mut simulator, timed)?;
        elapsed += start.elapsed();
        black_box(&simulator);
        steps += timed.len();
    }
    Ok(elapsed.as_secs_f64() * 1e9 / steps as f64 * candidate.rate.hz)
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
