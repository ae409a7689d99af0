//! First-order Gauss-Markov bias.

use nalgebra::Vector3;

use super::super::kept::Kept;
use super::super::parameters::TriadParameters;
use super::super::stream::{EffectStreams, Stream};
use super::effect::{Added, Effect};
use super::outputs::{BatchOutputs, Outputs};
use super::process::{Kind, Processes};
use super::states::{States, Visitor};
use crate::base::math::{exp_m1, tanh};
use crate::base::snapshot::{WALKS, stored};
use crate::signal::RUNS;

/// Exact discretisation of x' = -x/τ + white noise, stationary variance 1, over a step of a = dt/τ:
/// ```text
/// x(dt)  = e^-a x + √(E (2 - E)) n1,   E = 1 - e^-a
/// ∫x dt  = τ (E x + E² / √(E (2 - E)) n1 + √(2 (a - 2 tanh(a/2))) n2)
/// ```
/// n1 and n2 are standard normal. The variance of the integral is 2a - 3 + 4e^-a - e^-2a. The part of this variance that n1 does
/// not explain is 2 (a - 2 tanh(a/2)) in closed form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MarkovStep {
    decay: f64,
    diffusion: f64,
    integral: f64,
    integral_shared: f64,
    integral_own: f64,
}

impl MarkovStep {
    pub const NONE: Self =
        Self { decay: 0.0, diffusion: 0.0, integral: 0.0, integral_shared: 0.0, integral_own: 0.0 };

    /// For a step `dt` [s] and a correlation time `time` [s].
    pub fn new(dt: f64, time: f64) -> Self {
        let a = dt / time;
        let e = -exp_m1(-a);
        let diffusion = (e * (2.0 - e)).sqrt();
        // Below 0.05 the closed form loses digits by cancellation. There the truncated series has an error of less than 1e-14 of
        // its value.
        let own_variance = if a < 0.05 {
            let a2 = a * a;
            a2 * a * (1.0 / 6.0 - a2 * (1.0 / 60.0 - a2 * (17.0 / 10_080.0 - a2 * (31.0 / 181_440.0))))
        } else {
            2.0 * (a - 2.0 * tanh(0.5 * a))
        };
        Self {
            decay: 1.0 - e,
            diffusion,
            integral: time * e,
            integral_shared: time * e * e / diffusion,
            integral_own: time * own_variance.sqrt(),
        }
    }

    /// Moves `x` on by one step with two draws. Returns the integral of `x` over the step.
    #[inline(always)]
    pub(in crate::sensors) fn advance_integral(&self, x: &mut f64, [n1, n2]: [f64; 2]) -> f64 {
        self.advance_shared(x, n1) + self.integral_own * n2
    }

    /// Moves `x` on by one step with the draw `n1`. Returns the part of the integral that follows from `x` and `n1`; the rest is
    /// [`Self::integral_own`] times another draw.
    #[inline(always)]
    pub fn advance_shared(&self, x: &mut f64, n1: f64) -> f64 {
        let integral = self.integral * *x + self.integral_shared * n1;
        *x = self.decay * *x + self.diffusion * n1;
        integral
    }

    /// Standard deviation of the part of the integral that does not follow from the ends of the step.
    pub fn integral_own(&self) -> f64 {
        self.integral_own
    }

    /// Moves `x` on by one step.
    #[inline]
    pub(in crate::sensors) fn advance(&self, x: &mut f64, stream: &mut Stream) {
        *x = self.decay * *x + self.diffusion * stream.normal();
    }
}

/// ε_r of the paper's equation (2), stationary from the first sample on.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::sensors) struct GaussMarkov {
    sigma: Vector3<f64>,
    time_s: Vector3<f64>,
    /// Processes of unit variance.
    x: Kept<Vector3<f64>>,
    steps: [MarkovStep; 3],
    streams: [Kept<Stream>; 3],
}

stored!(GaussMarkov { x: WALKS, streams } rebuilt { sigma, time_s, steps });

impl Effect for GaussMarkov {
    fn new(streams: &EffectStreams) -> Self {
        let mut streams = streams.triad(0);
        let x = Vector3::from_fn(|axis, _| streams[axis].normal());
        let (x, streams) = (Kept::new(x), streams.map(Kept::new));
        Self { sigma: Vector3::zeros(), time_s: Vector3::zeros(), x, steps: [MarkovStep::NONE; 3], streams }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.sigma = parameters.markov_sigma;
        self.time_s = parameters.markov_time_s;
        self.sigma != Vector3::zeros()
    }

    fn set_interval(&mut self, dt: f64) {
        for axis in (0..3).filter(|&axis| self.sigma[axis] != 0.0) {
            self.steps[axis] = MarkovStep::new(dt, self.time_s[axis]);
        }
    }

    fn undo(&mut self) {
        self.x.undo();
        self.streams.iter_mut().for_each(Kept::undo);
    }

    fn visit(&mut self, visitor: &mut impl Visitor) {
        visitor.numbers(self.x.iter_mut());
        self.streams.iter_mut().for_each(|stream| visitor.stream(stream));
    }
}

impl Added for GaussMarkov {
    const PROCESSES: Processes = Processes {
        count: 1,
        are_walks: false,
        of: |triad, axis, _| (Kind::Markov(triad.markov_time_s[axis]), triad.markov_sigma[axis]),
    };

    #[inline(never)]
    fn apply(&mut self, _dt: f64, mut outputs: Outputs<'_>) {
        self.x.keep();
        for axis in 0..3 {
            let (sigma, step, mut stream) = (self.sigma[axis], self.steps[axis], self.streams[axis].kept());
            if sigma != 0.0 {
                for output in outputs.iter_mut() {
                    let draws = [stream.normal(), stream.normal()];
                    output[axis] += sigma * step.advance_integral(&mut self.x[axis], draws);
                }
                *self.streams[axis] = stream;
            }
        }
    }

    #[inline(always)]
    fn apply_each(&self, states: &mut States<'_>, outputs: &mut BatchOutputs<'_>) {
        let (x, streams) = (states.numbers::<3>(), states.streams::<3>());
        for axis in 0..3 {
            let (sigma, step) = (self.sigma[axis], self.steps[axis]);
            if sigma != 0.0 {
                for output in outputs.iter_mut() {
                    let (n1, n2) = (streams[axis].normal(), streams[axis].normal());
                    for lane in 0..RUNS {
                        let integral = step.advance_integral(&mut x[axis][lane], [n1[lane], n2[lane]]);
                        output[axis][lane] += sigma * integral;
                    }
                }
            }
        }
    }

    fn value(&self) -> Vector3<f64> {
        self.sigma.component_mul(&self.x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math::exp;

    /// Variances and covariance of the step, compared with their textbook forms.
    #[test]
    fn the_step_has_the_moments_of_the_process() {
        for a in [0.03, 0.049_999, 0.050_001, 0.7, 5.0, 60.0] {
            let time = 3.0;
            let s = MarkovStep::new(a * time, time);
            let (e1, e2) = (exp(-a), exp(-2.0 * a));
            let near = |value: f64, expected: f64, scale: f64| {
                // The textbook forms cancel: their rounding error is a few ulp of their largest term.
                assert!((value - expected).abs() <= 32.0 * f64::EPSILON * scale, "{a}: {value} {expected}");
            };
            near(s.decay, e1, 1.0);
            near(s.diffusion * s.diffusion, 1.0 - e2, 1.0);
            let variance = s.integral_shared * s.integral_shared + s.integral_own * s.integral_own;
            near(variance, time * time * (2.0 * a - 3.0 + 4.0 * e1 - e2), time * time * (3.0 + 2.0 * a));
            near(s.integral_shared * s.diffusion, time * (1.0 - e1) * (1.0 - e1), time);
        }
    }

    /// Two half steps give the variance of one whole step, for correlation times from a millionth of the step to 1e12 s.
    #[test]
    fn halving_the_step_changes_nothing_at_any_correlation_time() {
        for time in [1e-8, 1e-4, 1e-2, 1.0, 1e4, 1e9, 1e12] {
            let dt = 0.01;
            let whole = MarkovStep::new(dt, time);
            let half = MarkovStep::new(0.5 * dt, time);
            let diffusion2 = half.diffusion.powi(2) * (1.0 + half.decay.powi(2));
            assert!((half.decay * half.decay - whole.decay).abs() < 4.0 * f64::EPSILON);
            assert!((diffusion2 / whole.diffusion.powi(2) - 1.0).abs() < 1e-12, "{time}");
            // Integral over both halves: (I + I' ) with I' = τE x(half) + ...
            let from_n1 = half.integral_shared + half.integral * half.diffusion;
            let variance = from_n1.powi(2) + half.integral_own.powi(2) * 2.0 + half.integral_shared.powi(2);
            let expected = whole.integral_shared.powi(2) + whole.integral_own.powi(2);
            assert!((variance / expected - 1.0).abs() < 1e-12, "{time}: {variance} {expected}");
        }
    }
}
