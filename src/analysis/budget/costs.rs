//! Computing time of the effects on this machine.

use super::{BudgetEffect, ComputedSamples};
use crate::analysis::recommend::round_ns;
use crate::base::error::Error;
use crate::base::memory::{filled, room};
use crate::simulator::{ErrorParameters, Options};

/// Number of rounds; the result is the fastest.
const ROUNDS: usize = 61;
/// Number of steps of a round. A shorter scene is flown again, up to a limit.
const STEPS: usize = 250;
const REPEATS: usize = 5;

/// Times of a step, push and step over the first samples [ns].
#[derive(Debug, Clone, PartialEq)]
pub struct Costs {
    /// With no effect set.
    pub own_ns: f64,
    /// With all effects.
    pub total_ns: f64,
    /// Time saved without each of the effects.
    pub saved_ns: Vec<f64>,
}

/// Times a step with all that `parameters` set, with no effect, and without each of `effects`. The rounds alternate, so a busy
/// moment of the machine affects all alike.
///
/// The fastest of 61 rounds of 250 steps each, which are shorter than a turn of the scheduler. Uncertain by 1 to 5 % of a
/// step, more on a busy machine, so that a small effect may come out negative.
pub fn step_costs_ns<'a>(
    options: &Options,
    scene: &ComputedSamples<'_>,
    parameters: &ErrorParameters,
    effects: impl ExactSizeIterator<Item = &'a BudgetEffect>,
) -> Result<Costs, Error> {
    let mut stretch = room(scene.count.min(STEPS + 1))?;
    for sample in scene.samples().take(STEPS + 1) {
        stretch.push(sample?);
    }
    let mut simulators = room(2 + effects.len())?;
    simulators.push(parameters.ideal().simulator(options)?);
    simulators.push(parameters.simulator(options)?);
    for effect in effects {
        let mut without = *parameters;
        effect.leave_out(&mut without);
        simulators.push(without.simulator(options)?);
    }
    let mut fastest = filled(simulators.len(), f64::INFINITY)?;
    let repeats = (STEPS / stretch.len().max(2)).clamp(1, REPEATS);
    let count = simulators.len();
    for round in 0..ROUNDS {
        // Each is the first of a round in turn, so no one is always hit by what the scheduler does at the same point of a round.
        for place in (0..count).map(|place| (round + place) % count) {
            fastest[place] = fastest[place].min(round_ns(&mut simulators[place][0], &stretch, repeats)?);
        }
    }
    let (own_ns, total_ns) = (fastest[0], fastest[1]);
    let mut saved_ns = room(fastest.len() - 2)?;
    saved_ns.extend(fastest[2..].iter().map(|without_ns| total_ns - without_ns));
    Ok(Costs { own_ns, total_ns, saved_ns })
}
