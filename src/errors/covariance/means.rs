//! Variances of the means of the sensor errors of an INS at rest, over a time and between two windows.

use nalgebra::Vector3;

use super::line::Advance;
use super::sources::{AXES, ErrorInput, RandomErrors, Source, WALKS};
use crate::sensors::Kind;

/// The signals of an INS at rest, sensor axes: angular rate \[rad/s\] and specific force \[m/s²\].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Signals {
    pub rate_s: Vector3<f64>,
    pub force_s: Vector3<f64>,
}

/// Variances of the mean errors of gyros \[(rad/s)²\] and of accelerometers \[(m/s²)²\].
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Variances {
    pub gyro: Vector3<f64>,
    pub accel: Vector3<f64>,
}

impl Variances {
    fn add(&mut self, axis: usize, variance: f64) {
        let triad = if axis < 3 { &mut self.gyro } else { &mut self.accel };
        triad[axis % 3] += variance;
    }

    /// The variances that `of` gives for each process, and those of white noise, whose mean over 1 s has the variance N².
    fn sum(
        parameters: &RandomErrors<'_>,
        signals: &Signals,
        of: impl Fn(&Source) -> f64,
        of_white_noise: f64,
    ) -> Self {
        let mut sum = Self::default();
        for source in Source::all(parameters).filter(|source| source.sigma != 0.0) {
            match source.input {
                ErrorInput::Axis(axis) => sum.add(axis, of(&source)),
                ErrorInput::Element(element) => {
                    let signal = if element < 9 { &signals.rate_s } else { &signals.force_s };
                    let size = signal[element / 3 % 3];
                    sum.add(element / 9 * 3 + element % 3, of(&source) * size * size);
                }
                // Gravity at rest is a constant vertical, and the altimeter does not level.
                ErrorInput::Field(_) | ErrorInput::Altimeter => {}
            }
        }
        for axis in 0..AXES {
            let density = parameters.of_axis(axis).random_walk[axis % 3];
            sum.add(axis, density * density * of_white_noise);
        }
        sum
    }

    /// Of the means over `t` \[s\] that begin `since_start_s` \[s\] after the random walks.
    pub fn of_means(parameters: &RandomErrors<'_>, signals: &Signals, t: f64, since_start_s: f64) -> Self {
        let of = |source: &Source| {
            let step = match source.kind {
                Kind::Walk => Advance::walk(source.sigma * since_start_s.sqrt(), source.sigma * t.sqrt()),
                _ => source.advance(t, 0.0, &mut [0.0; WALKS]),
            };
            let (of_start, of_draw) = (step.of_start.mean, step.of_draw.mean);
            of_start * of_start + of_draw * of_draw + step.rest.of_mean()
        };
        Self::sum(parameters, signals, of, 1.0 / t)
    }

    /// Of the differences of the means over two windows of length `window_s`, `apart_s` \[s\] apart, with the weight 1 - cos. Such a mean
    /// of white noise has the variance of a plain mean over two thirds of the window.
    pub fn of_differences(
        parameters: &RandomErrors<'_>,
        signals: &Signals,
        (window_s, apart_s): (f64, f64),
    ) -> Self {
        let averaged_s = window_s / 1.5;
        let of = |source: &Source| match source.kind {
            Kind::Constant | Kind::MarkovOverGround(_) => 0.0,
            Kind::Walk => source.sigma * source.sigma * apart_s,
            Kind::Markov(time_s) => {
                let step = source.advance(averaged_s, 0.0, &mut [0.0; WALKS]);
                let (of_start, of_draw) = (step.of_start.mean, step.of_draw.mean);
                let of_mean = of_start * of_start + of_draw * of_draw + step.rest.of_mean();
                -2.0 * of_mean * crate::base::math::exp_m1(-apart_s / time_s)
            }
        };
        Self::sum(parameters, signals, of, 2.0 / averaged_s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sensors::{AltimeterParameters, GravityDisturbanceParameters, TriadParameters};

    fn variances(
        of: impl Fn(&RandomErrors<'_>, &Signals) -> Variances,
        set: impl Fn(&mut TriadParameters),
    ) -> Variances {
        let mut gyro = TriadParameters::default();
        set(&mut gyro);
        let (altimeter, gravity) = (AltimeterParameters::default(), GravityDisturbanceParameters::default());
        let outputs = [(1.0, 0.0); AXES];
        let parameters =
            RandomErrors { outputs, gyro: &gyro, accel: &gyro, altimeter: &altimeter, gravity: &gravity };
        let signals = Signals { rate_s: Vector3::new(1.0, 2.0, 3.0), force_s: Vector3::new(0.0, 0.0, 10.0) };
        of(&parameters, &signals)
    }

    /// Against the closed forms of the mean of a process over T: a constant, N²/T, σ² 2(x - 1 + e⁻ˣ)/x² with x = T/τ, K² (t + T/3).
    #[test]
    fn the_mean_of_each_process_has_the_variance_of_its_closed_form() {
        let mean = |set: &dyn Fn(&mut TriadParameters)| {
            variances(|parameters, signals| Variances::of_means(parameters, signals, 100.0, 50.0), set)
        };
        let close = |is: f64, should: f64| assert!((is / should - 1.0).abs() < 1e-9, "{is} {should}");
        close(mean(&|triad| triad.bias_sigma.x = 3.0).gyro.x, 9.0);
        close(mean(&|triad| triad.random_walk.y = 3.0).accel.y, 0.09);
        close(mean(&|triad| triad.rate_random_walk.z = 3.0).gyro.z, 9.0 * (50.0 + 100.0 / 3.0));
        let markov = mean(&|triad| (triad.markov_sigma.x, triad.markov_time_s.x) = (3.0, 25.0));
        close(markov.gyro.x, 9.0 * 2.0 * (4.0 - 1.0 + (-4.0f64).exp()) / 16.0);
        let elements = mean(&|triad| {
            triad.scale_factor_sigma.y = 0.1;
            triad.misalignment_sigma[(1, 2)] = 0.1;
        });
        close(elements.gyro.y, 0.01 * (4.0 + 9.0));
        close(elements.accel.y, 0.01 * 100.0);
    }

    /// A process that is much slower than the windows differs by 2σ²(1 - e^(-D/τ)), a much faster one is averaged as white noise of the
    /// density σ √(2τ); the constants cancel.
    #[test]
    fn the_difference_of_two_windows_has_the_variance_of_its_closed_form() {
        let difference = |set: &dyn Fn(&mut TriadParameters)| {
            let windows = (30.0, 300.0);
            variances(|parameters, signals| Variances::of_differences(parameters, signals, windows), set)
        };
        let close = |is: f64, should: f64| assert!((is / should - 1.0).abs() < 2e-3, "{is} {should}");
        assert_eq!(difference(&|triad| triad.bias_sigma.x = 3.0).accel.x, 0.0);
        close(difference(&|triad| triad.random_walk.y = 3.0).accel.y, 9.0 * 2.0 * 1.5 / 30.0);
        close(difference(&|triad| triad.rate_random_walk.z = 3.0).accel.z, 9.0 * 300.0);
        let slow = difference(&|triad| (triad.markov_sigma.x, triad.markov_time_s.x) = (3.0, 1e4));
        close(slow.accel.x, 18.0 * (1.0 - (-0.03f64).exp()));
        let fast = difference(&|triad| (triad.markov_sigma.x, triad.markov_time_s.x) = (3.0, 0.01));
        close(fast.accel.x, 9.0 * 2.0 * 0.01 * 2.0 * 1.5 / 30.0);
    }
}
