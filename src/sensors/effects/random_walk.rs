//! White noise of rate or force: angle or velocity random walk.

use nalgebra::Vector3;

use super::super::kept::Kept;
use super::super::parameters::TriadParameters;
use super::super::stream::{EffectStreams, Stream};
use super::effect::{Added, Effect};
use super::outputs::{BatchOutputs, Outputs};
use super::process::Processes;
use super::states::{States, Visitor};
use crate::base::snapshot::stored;
use crate::signal::RUNS;

/// White noise w. Its integral over dt is N √dt n, where n is standard normal and independent from one increment to the
/// next. The density N [u √s] does not depend on the sampling rate.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::sensors) struct RandomWalk {
    density: Vector3<f64>,
    /// N √dt [u s]
    step: Vector3<f64>,
    streams: [Kept<Stream>; 3],
}

stored!(RandomWalk { streams } rebuilt { density, step });

impl Effect for RandomWalk {
    fn new(streams: &EffectStreams) -> Self {
        Self { density: Vector3::zeros(), step: Vector3::zeros(), streams: streams.triad(0).map(Kept::new) }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.density = parameters.random_walk;
        self.density != Vector3::zeros()
    }

    fn set_interval(&mut self, dt: f64) {
        self.step = self.density * dt.sqrt();
    }

    fn undo(&mut self) {
        self.streams.iter_mut().for_each(Kept::undo);
    }

    fn visit(&mut self, visitor: &mut impl Visitor) {
        self.streams.iter_mut().for_each(|stream| visitor.stream(stream));
    }
}

impl Added for RandomWalk {
    const PROCESSES: Processes = Processes::NONE;

    #[inline(never)]
    fn apply(&mut self, _dt: f64, mut outputs: Outputs<'_>) {
        for axis in 0..3 {
            let step = self.step[axis];
            let mut stream = self.streams[axis].kept();
            if step != 0.0 {
                outputs.iter_mut().for_each(|output| output[axis] += step * stream.normal());
                *self.streams[axis] = stream;
            }
        }
    }

    #[inline(always)]
    fn apply_each(&self, states: &mut States<'_>, outputs: &mut BatchOutputs<'_>) {
        let streams = states.streams::<3>();
        for axis in 0..3 {
            let step = self.step[axis];
            if step != 0.0 {
                for output in outputs.iter_mut() {
                    let draws = streams[axis].normal();
                    for lane in 0..RUNS {
                        output[axis][lane] += step * draws[lane];
                    }
                }
            }
        }
    }

    fn value(&self) -> Vector3<f64> {
        Vector3::zeros()
    }
}
