//! Flicker noise: bias instability.

use nalgebra::Vector3;

use super::super::kept::Kept;
use super::super::parameters::TriadParameters;
use super::super::stream::{EffectStreams, Stream};
use super::effect::{Added, Effect};
use super::gauss_markov::MarkovStep;
use super::outputs::{BatchOutputs, Outputs};
use super::process::{Kind, Processes};
use super::states::{States, Visitor};
use crate::base::snapshot::{WALKS, stored};
use crate::signal::RUNS;

/// Correlation times of the processes [s], one process per decade.
const TIMES_S: [f64; 6] = [1.0, 10.0, 100.0, 1e3, 1e4, 1e5];

/// Standard deviations of the processes at B = 1: √(ln 10 / π). The two end processes have 1.25 times this variance, because they
/// also represent the decades beyond.
const DEVIATIONS: [f64; 6] = [END, MIDDLE, MIDDLE, MIDDLE, MIDDLE, END];
const MIDDLE: f64 = 0.856_116_580_191_873_1;
const END: f64 = 0.957_167_434_986_839_1;

/// Correlation time [s] and standard deviation at B = 1 of each Gauss-Markov process of flicker noise.
pub const PROCESSES: [(f64, f64); TIMES_S.len()] = {
    let mut processes = [(0.0, 0.0); TIMES_S.len()];
    let mut k = 0;
    while k < TIMES_S.len() {
        processes[k] = (TIMES_S[k], DEVIATIONS[k]);
        k += 1;
    }
    processes
};

/// Noise of the two-sided power spectral density B²/(2π f), whose Allan deviation is flat, √(2 ln 2 / π) B = 0.664 B (IEEE
/// Std 952), as a sum of stationary first-order Gauss-Markov processes, each exact at any step:
/// ```text
/// Σ 2 σ² τ / (1 + (2π f τ)²) -> σ²/(2 f ln r) for correlation times τ a factor of r apart: σ² = B² ln r / π
/// ```
/// The band has one process per decade, from 1 s to 1e5 s. The Allan deviation stays within -1 % and +2.3 % of 0.664 B for
/// averaging times of 2 s to 1.8e5 s (50 hours), as the test below computes; the ripple of one process per decade is 1 %.
/// Outside the band the Allan deviation falls by a factor of √10 per decade: as with white noise for shorter averages, and as with
/// rate random walk for longer ones.
///
/// Each process has its own draw for its step. The parts of the integrals that do not follow from the ends of the steps have one
/// draw for all processes.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::sensors) struct Flicker {
    /// B [u].
    instability: Vector3<f64>,
    /// Processes of unit variance, by axis.
    x: Kept<[[f64; TIMES_S.len()]; 3]>,
    steps: [MarkovStep; TIMES_S.len()],
    /// Standard deviation, at B = 1, of the part of the integral over a step that does not follow from the ends of the step [s].
    own: f64,
    streams: Kept<[Stream; 3]>,
}

stored!(Flicker { x: WALKS, streams } rebuilt { instability, steps, own });

impl Effect for Flicker {
    fn new(streams: &EffectStreams) -> Self {
        let mut streams = streams.triad(0);
        let x = core::array::from_fn(|axis| core::array::from_fn(|_| streams[axis].normal()));
        let (x, streams) = (Kept::new(x), Kept::new(streams));
        Self { instability: Vector3::zeros(), x, steps: [MarkovStep::NONE; TIMES_S.len()], own: 0.0, streams }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.instability = parameters.flicker;
        self.instability != Vector3::zeros()
    }

    fn set_interval(&mut self, dt: f64) {
        if self.instability == Vector3::zeros() {
            return;
        }
        self.steps = TIMES_S.map(|time| MarkovStep::new(dt, time));
        let own = DEVIATIONS.iter().zip(&self.steps).map(|(deviation, step)| deviation * step.integral_own());
        self.own = own.map(|own| own * own).sum::<f64>().sqrt();
    }

    fn undo(&mut self) {
        self.x.undo();
        self.streams.undo();
    }

    fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.numbers(self.x.as_flattened_mut());
        self.streams.iter_mut().for_each(|stream| visitor.stream(stream));
    }
}

impl Added for Flicker {
    const PROCESSES: Processes = Processes {
        count: PROCESSES.len(),
        are_walks: false,
        of: |triad, axis, process| {
            let (time_s, deviation) = PROCESSES[process];
            (Kind::Markov(time_s), triad.flicker[axis] * deviation)
        },
    };

    #[inline(never)]
    fn apply(&mut self, _dt: f64, mut outputs: Outputs<'_>) {
        self.x.keep();
        self.streams.keep();
        for axis in (0..3).filter(|&axis| self.instability[axis] != 0.0) {
            let stream = &mut self.streams[axis];
            for output in outputs.iter_mut() {
                let own = self.own * stream.normal();
                let processes = DEVIATIONS.iter().zip(&self.steps).zip(&mut self.x[axis]);
                let integral = processes.fold(own, |integral, ((deviation, step), x)| {
                    integral + deviation * step.advance_shared(x, stream.normal())
                });
                output[axis] += self.instability[axis] * integral;
            }
        }
    }

    #[inline(always)]
    fn apply_each(&self, states: &mut States<'_>, outputs: &mut BatchOutputs<'_>) {
        let streams = states.streams::<3>();
        for axis in 0..3 {
            let x = states.numbers::<{ TIMES_S.len() }>();
            if self.instability[axis] != 0.0 {
                for output in outputs.iter_mut() {
                    let mut integrals = streams[axis].normal().map(|draw| self.own * draw);
                    for ((deviation, step), x) in DEVIATIONS.iter().zip(&self.steps).zip(x.iter_mut()) {
                        let draws = streams[axis].normal();
                        for lane in 0..RUNS {
                            integrals[lane] += deviation * step.advance_shared(&mut x[lane], draws[lane]);
                        }
                    }
                    for lane in 0..RUNS {
                        output[axis][lane] += self.instability[axis] * integrals[lane];
                    }
                }
            }
        }
    }

    fn value(&self) -> Vector3<f64> {
        let sum = |axis: usize| DEVIATIONS.iter().zip(&self.x[axis]).map(|(d, x)| d * x).sum::<f64>();
        Vector3::from_fn(|axis, _| self.instability[axis] * sum(axis))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math::exp;

    /// Allan variance of a Gauss-Markov process of unit variance over an average of `a` correlation times (IEEE Std 952,
    /// C.13).
    fn allan_variance(a: f64) -> f64 {
        2.0 / a * (1.0 - (3.0 - 4.0 * exp(-a) + exp(-2.0 * a)) / (2.0 * a))
    }

    #[test]
    fn the_allan_deviation_is_flat_over_the_band_stated() {
        let flat = (2.0 * core::f64::consts::LN_2 / core::f64::consts::PI).sqrt();
        let ratio = |average_s: f64| {
            let sum: f64 = (0..TIMES_S.len())
                .map(|k| DEVIATIONS[k].powi(2) * allan_variance(average_s / TIMES_S[k]))
                .sum();
            sum.sqrt() / flat
        };
        let mut average_s = 2.0;
        while average_s < 1.8e5 {
            let found = ratio(average_s);
            assert!((0.99..1.023).contains(&found), "{average_s} s: {found}");
            average_s *= 1.02;
        }
        // Between the ends there is only the ripple.
        for average_s in [100.0, 180.0, 316.0, 562.0, 1000.0] {
            assert!((ratio(average_s) - 1.0).abs() < 0.012, "{average_s} s: {}", ratio(average_s));
        }
    }
}
