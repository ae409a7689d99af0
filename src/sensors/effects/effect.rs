//! What an effect does at its place along the path of the signal: one trait for each stage. A method without a default cannot be
//! forgotten.

use nalgebra::Vector3;

use super::super::parameters::TriadParameters;
use super::super::stream::EffectStreams;
use super::outputs::{BatchOutputs, Outputs};
use super::process::Processes;
use super::states::{States, Visitor};
use crate::base::snapshot::Stored;
use crate::signal::Turning;

/// The input of a triad over an increment. For constant signals it is the input over 1 s.
#[derive(Debug, Clone, Copy)]
pub(in crate::sensors) struct Input {
    /// Increment of the signal after size effect and bandwidth [u s].
    pub signal: Vector3<f64>,
    /// Increment of the true specific force at the block's own point [m/s].
    pub force: Vector3<f64>,
    /// Length of the increment [s].
    pub dt: f64,
}

/// Conditions of a sample interval, each `None` if it is not known.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::sensors) struct Conditions {
    /// Temperatures at the ends of the interval [°C].
    pub ends_c: Option<[f64; 2]>,
    /// The motion that the increments belong to.
    pub turning: Option<Turning>,
}

/// An effect of a triad, and its state.
pub(in crate::sensors) trait Effect: Stored + Clone {
    /// The effect without parameters. Random effects draw from `streams`.
    fn new(streams: &EffectStreams) -> Self;

    /// Sets the parameters. Returns whether they call for the effect. A process that was active continues from its current state.
    fn set(&mut self, parameters: &TriadParameters) -> bool;

    /// Takes the length of the increments to come [s].
    fn set_interval(&mut self, _dt: f64) {}

    /// Begins a sample interval. [`Self::undo`] can undo it.
    fn begin_interval(&mut self, _conditions: &Conditions) {}

    /// Undoes the last interval. An effect that keeps something from one interval to the next needs this method.
    fn undo(&mut self) {}

    /// Follows a jump of the signal: filters settle at once at the next signal. Noise continues.
    fn reposition(&mut self) {}

    /// Visits the state that differs from run to run, in the order in which the rows of a batch are taken.
    fn visit(&mut self, _visitor: &mut impl Visitor) {}
}

/// Changes the input of the sensors.
pub(in crate::sensors) trait OnInput: Effect {
    /// Begins the increments of an interval, which [`Effect::undo`] can undo.
    fn keep(&mut self) {}

    /// Acts on the input over an increment of `dt` [s] in which the block turns by `angle` [rad].
    fn apply(&mut self, angle: &Vector3<f64>, dt: f64, input: &mut Vector3<f64>);

    /// Change of the input [u] at the constant angular rate `rate` [rad/s].
    fn steady_change(&self, rate: &Vector3<f64>) -> Vector3<f64>;
}

/// An error that depends on the input.
pub(in crate::sensors) trait OfInput: Effect {
    /// Error [u s].
    fn error(&self, input: &Input) -> Vector3<f64>;

    /// Error [u s] at the temperature `temperature_c` [°C]; `None`: the reference temperature.
    fn steady_error(&self, input: &Input, _temperature_c: Option<f64>) -> Vector3<f64> {
        self.error(input)
    }
}

/// An [`OfInput`] that differs from run to run. The others are computed once for all runs.
pub(in crate::sensors) trait DrawnOfInput: OfInput {
    /// Adds [`OfInput::error`] of the inputs of the increments, for the runs of a batch.
    fn apply_each(states: &mut States<'_>, inputs: &[Input], outputs: &mut BatchOutputs<'_>);
}

/// An error that does not depend on the input.
pub(in crate::sensors) trait Added: Effect {
    /// Its processes, for the covariance of the errors. White noise has none: the covariance reads its density.
    const PROCESSES: Processes;

    /// Adds the integral over each increment of an interval, which [`Effect::undo`] can undo.
    fn apply(&mut self, dt: f64, outputs: Outputs<'_>);

    /// [`Self::apply`] for the runs of a batch.
    fn apply_each(&self, states: &mut States<'_>, outputs: &mut BatchOutputs<'_>);

    /// The present error [u] that an average does not remove.
    fn value(&self) -> Vector3<f64>;
}

/// Acts on the output.
pub(in crate::sensors) trait OnOutput: Effect {
    /// Acts on each increment of an interval, which [`Effect::undo`] can undo.
    fn apply(&mut self, dt: f64, outputs: Outputs<'_>);

    /// [`Self::apply`] for the runs of a batch.
    fn apply_each(&self, states: &mut States<'_>, outputs: &mut BatchOutputs<'_>);

    /// Acts on a constant signal [u].
    fn limit(&self, signal: &mut Vector3<f64>);
}
