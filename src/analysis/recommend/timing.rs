//! Time of a step on this machine.

use std::time::{Duration, Instant};

use super::Setup;
use crate::base::error::Error;
use crate::simulator::Simulator;
use crate::truth::FlightSample;

/// Number of rounds; the result is their median.
const ROUNDS: usize = 9;
/// Least number of steps of a round.
const STEPS: usize = 1000;

/// Time of a step of the whole chain with ideal sensors, push and step, over the first samples [ns].
///
/// This is the only figure of a recommendation that differs from call to call. WebAssembly has no clock: it is 0 there.
#[inline(never)]
pub fn step_time_ns(setup: &Setup, samples: &[FlightSample]) -> Result<f64, Error> {
    if cfg!(target_family = "wasm") {
        return Ok(0.0);
    }
    let stretch = &samples[..samples.len().min(STEPS + 1)];
    let repeats = STEPS.div_ceil(stretch.len().saturating_sub(1).max(1));
    let mut memory = setup.simulator()?;
    let mut rounds = [0.0; ROUNDS];
    for round in &mut rounds {
        *round = round_ns(&mut memory[0], stretch, repeats)?;
    }
    rounds.sort_unstable_by(f64::total_cmp);
    Ok(rounds[ROUNDS / 2])
}

/// Mean time of a push and step over `stretch`, flown `repeats` times from its start [ns].
pub(crate) fn round_ns(
    simulator: &mut Simulator,
    stretch: &[FlightSample],
    repeats: usize,
) -> Result<f64, Error> {
    let (mut steps, mut elapsed) = (0, Duration::ZERO);
    for _ in 0..repeats {
        simulator.reset();
        let start = Instant::now();
        for sample in stretch {
            simulator.push_sample(sample)?;
            simulator.step()?;
        }
        elapsed += start.elapsed();
        steps += simulator.intervals();
    }
    Ok(elapsed.as_secs_f64() * 1e9 / steps.max(1) as f64)
}
