//! White noise of rate or force: angle or velocity random walk.

use nalgebra::Vector3;

use super::kept::Kept;
use super::outputs::Outputs;
use super::parameters::{Sensor, TriadParameters};
use super::states::{States, Visitor};
use super::stream::{Purpose, Stream, StreamKey};
use crate::signal::{IncrementRows, RUNS};
use crate::snapshot::stored;

/// White noise w. Its integral over dt is N √dt n, where n is standard normal and independent from one increment to the
/// next. The density N [u √s] does not depend on the sampling rate.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct RandomWalk {
    density: Vector3<f64>,
    /// N √dt [u s]
    step: Vector3<f64>,
    streams: [Kept<Stream>; 3],
}

stored!(RandomWalk { streams } rebuilt { density, step });

impl RandomWalk {
    pub fn new(key: StreamKey, sensor: Sensor) -> Self {
        Self {
            density: Vector3::zeros(),
            step: Vector3::zeros(),
            streams: Stream::triad(key, sensor.source(), Purpose::RandomWalk).map(Kept::new),
        }
    }

    /// Sets the parameters. Returns whether they call for the effect.
    pub fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.density = parameters.random_walk;
        self.density != Vector3::zeros()
    }

    /// Takes the length of the increments to come [s].
    pub fn set_interval(&mut self, dt: f64) {
        self.step = self.density * dt.sqrt();
    }

    /// Adds the noise of each increment of an interval, which [`Self::undo`] can undo.
    #[inline(never)]
    pub fn apply(&mut self, mut outputs: Outputs<'_>) {
        for axis in 0..3 {
            let step = self.step[axis];
            let mut stream = self.streams[axis].kept();
            if step != 0.0 {
                outputs.iter_mut().for_each(|output| output[axis] += step * stream.normal());
                *self.streams[axis] = stream;
            }
        }
    }

    /// Visits the state of a run.
    pub fn visit(&mut self, visitor: &mut impl Visitor) {
        self.streams.iter_mut().for_each(|stream| visitor.stream(stream));
    }

    /// [`Self::apply`] for the runs of a block.
    #[inline(always)]
    pub fn apply_each(&self, states: &mut States<'_>, outputs: &mut [IncrementRows], first: usize) {
        let streams = states.streams::<3>();
        for axis in 0..3 {
            let step = self.step[axis];
            if step != 0.0 {
                for output in outputs.iter_mut() {
                    let draws = streams[axis].normal();
                    for lane in 0..RUNS {
                        output[first + axis][lane] += step * draws[lane];
                    }
                }
            }
        }
    }

    /// Undoes the last interval.
    pub fn undo(&mut self) {
        self.streams.iter_mut().for_each(Kept::undo);
    }
}
