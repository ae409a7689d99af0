//! Rate random walk of gyros, acceleration random walk of accelerometers.

use nalgebra::Vector3;

use super::super::kept::Kept;
use super::super::parameters::TriadParameters;
use super::super::stream::{EffectStreams, Stream};
use super::effect::{Added, Effect};
use super::outputs::{BatchOutputs, Outputs};
use super::process::{Kind, Processes};
use super::states::{States, Visitor};
use crate::base::snapshot::{WALKS, stored};
use crate::signal::RUNS;

/// b' = K w, where w is white noise of density 1 [1/√s] and b = 0 at the start of a run. Over dt, with n1 and n2 standard normal:
/// ```text
/// b(dt) = b + K √dt n1
/// ∫b dt = b dt + K dt^1.5 (n1/2 + n2/√12)
/// ```
/// b and its integral have the joint covariance [dt, dt²/2; dt²/2, dt³/3] K² of the continuous process at any dt (IEEE Std 952,
/// C.1.5).
#[derive(Debug, Clone, PartialEq)]
pub(in crate::sensors) struct RateRandomWalk {
    /// K [u/√s].
    density: Vector3<f64>,
    /// b [u].
    value: Kept<Vector3<f64>>,
    /// √dt [√s].
    root: f64,
    streams: Kept<[Stream; 3]>,
}

stored!(RateRandomWalk { value: WALKS, streams } rebuilt { density, root });

/// 1/√12
const INTEGRAL_OWN: f64 = 0.288_675_134_594_812_9;

impl Effect for RateRandomWalk {
    fn new(streams: &EffectStreams) -> Self {
        Self {
            density: Vector3::zeros(),
            value: Kept::new(Vector3::zeros()),
            root: 0.0,
            streams: Kept::new(streams.triad(0)),
        }
    }

    // With a new density the walk continues from its current value; a density of 0 ends the walk.
    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.density = parameters.rate_random_walk;
        *self.value =
            self.value.zip_map(&self.density, |value, density| if density == 0.0 { 0.0 } else { value });
        self.density != Vector3::zeros()
    }

    fn set_interval(&mut self, dt: f64) {
        self.root = dt.sqrt();
    }

    fn undo(&mut self) {
        self.value.undo();
        self.streams.undo();
    }

    fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.numbers(self.value.iter_mut());
        self.streams.iter_mut().for_each(|stream| visitor.stream(stream));
    }
}

impl Added for RateRandomWalk {
    const PROCESSES: Processes = Processes {
        count: 1,
        are_walks: true,
        of: |triad, axis, _| (Kind::Walk, triad.rate_random_walk[axis]),
    };

    #[inline(never)]
    fn apply(&mut self, dt: f64, mut outputs: Outputs<'_>) {
        self.value.keep();
        self.streams.keep();
        for axis in (0..3).filter(|&axis| self.density[axis] != 0.0) {
            let (step, stream) = (self.density[axis] * self.root, &mut self.streams[axis]);
            for output in outputs.iter_mut() {
                let draws = [stream.normal(), stream.normal()];
                output[axis] += Self::advance(&mut self.value[axis], step, dt, draws);
            }
        }
    }

    #[inline(always)]
    fn apply_each(&self, states: &mut States<'_>, outputs: &mut BatchOutputs<'_>) {
        let dt = outputs.dt;
        let (value, streams) = (states.numbers::<3>(), states.streams::<3>());
        for axis in 0..3 {
            if self.density[axis] != 0.0 {
                let step = self.density[axis] * self.root;
                for output in outputs.iter_mut() {
                    let (n1, n2) = (streams[axis].normal(), streams[axis].normal());
                    for lane in 0..RUNS {
                        let draws = [n1[lane], n2[lane]];
                        output[axis][lane] += Self::advance(&mut value[axis][lane], step, dt, draws);
                    }
                }
            }
        }
    }

    fn value(&self) -> Vector3<f64> {
        *self.value
    }
}

impl RateRandomWalk {
    /// Moves `value` on by one step with two draws. Returns the integral of `value` over the step.
    #[inline(always)]
    fn advance(value: &mut f64, step: f64, dt: f64, [n1, n2]: [f64; 2]) -> f64 {
        let integral = (*value + step * (0.5 * n1 + INTEGRAL_OWN * n2)) * dt;
        *value += step * n1;
        integral
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest steps, from the limit of a snapshot on, lead to no value that a snapshot cannot have.
    #[test]
    fn no_step_leads_beyond_the_limit_of_a_snapshot() {
        let (density, dt) = (1e4, crate::truth::INTERVALS_S.1);
        for sign in [1.0, -1.0] {
            let mut value = sign * WALKS;
            let integral = RateRandomWalk::advance(&mut value, density * dt.sqrt(), dt, [sign * 100.0; 2]);
            assert!(value == sign * WALKS && integral.abs() < crate::base::snapshot::SIGNALS);
        }
    }
}
