//! One flight of a scene, and its errors on the way.

use core::ops::ControlFlow;

use nalgebra::{SVector, Vector3};

use crate::analysis::recommend::{Refusal, fly_looking};
use crate::base::error::{Error, check_integer};
use crate::base::math::{relative_rotation, rotation_quaternion, rotation_vector};
use crate::base::memory::room;
use crate::errors::covariance::NavigationCovariance;
use crate::sensors::StreamKey;
use crate::simulator::{ErrorParameters, ErrorSource, Options, Simulator};
use crate::truth::FlightSample;

/// Least number of samples of a scene: one interval.
pub const MIN_SAMPLES: usize = 2;
/// Largest number of samples of a scene: an eleven-day flight at 1000 Hz.
pub const MAX_SAMPLES: usize = 1_000_000_000;
/// Largest number of instants at which a flight is evaluated.
const INSTANTS: usize = 1000;

/// Samples that are computed when they are flown, so that a long scene needs no memory for them.
#[derive(Clone, Copy)]
pub struct ComputedSamples<'a> {
    /// How many.
    pub count: usize,
    /// The sample of an index: the same in each call.
    pub sample: &'a dyn Fn(usize) -> Result<FlightSample, Error>,
}

impl ComputedSamples<'_> {
    pub(super) fn validate(&self) -> Result<(), Error> {
        check_integer("count", self.count, MIN_SAMPLES as u64, MAX_SAMPLES as u64)
    }

    pub(super) fn samples(&self) -> impl Iterator<Item = Result<FlightSample, Error>> {
        (0..self.count).map(self.sample)
    }

    /// Number of instants.
    pub(super) fn instants(&self) -> usize {
        INSTANTS.min(self.count - 1)
    }

    /// The sample at which instant `k` is: equally spaced from the end of the first interval to that of the last.
    fn instant(&self, k: usize) -> usize {
        match self.instants() {
            1 => 1,
            instants => 1 + (k as u64 * (self.count as u64 - 2) / (instants as u64 - 1)) as usize,
        }
    }
}

/// Position [m], velocity [m/s] and misalignment [rad], or differences of them.
pub(super) type Deviation = SVector<f64, 9>;

/// `errors` - `from`; for misalignments the rotation vector between the two attitudes, which does not jump at half a turn.
pub(super) fn difference(errors: &Deviation, from: &Deviation) -> Deviation {
    let attitude =
        |errors: &Deviation| rotation_quaternion(&errors.fixed_rows::<3>(MISALIGNMENT).into_owned());
    let mut difference = errors - from;
    let rotation = rotation_vector(&relative_rotation(&attitude(from), &attitude(errors)));
    difference.fixed_rows_mut::<3>(MISALIGNMENT).copy_from(&rotation);
    difference
}

/// Where the misalignment begins.
const MISALIGNMENT: usize = 6;

/// The errors of a flight, navigation minus truth, at the instants of its scene.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Track {
    /// Time from the first sample to the last instant [s].
    pub span_s: f64,
    pub errors: Vec<Deviation>,
}

/// The quantity that is read in a flight.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Look {
    /// Errors of the navigation.
    Navigation,
    /// Errors by the error equations.
    Model,
    /// Standard deviations, by the covariance.
    Sigma,
}

/// Flies `scene` with `parameters`, the draws those of run number `run` after that of `options`.
pub(super) fn fly(
    options: &Options,
    scene: &ComputedSamples<'_>,
    parameters: &ErrorParameters,
    run: u64,
    look: Look,
) -> Result<Track, Refusal> {
    let key = StreamKey { run: options.key.run.wrapping_add(run), ..options.key };
    let (error_model, covariance) = (look == Look::Model, look == Look::Sigma);
    let mut memory = parameters.simulator(&Options { key, error_model, covariance, ..*options })?;
    let instants = scene.instants();
    let mut track = Track { span_s: 0.0, errors: room(instants)? };
    let start_s = (scene.sample)(0).map_err(|error| Refusal { error, sample: Some(0), piece: 0 })?.time_s;
    fly_looking(&mut memory[0], scene.samples(), |index, simulator| {
        if track.errors.len() < instants
            && index == scene.instant(track.errors.len())
            && let Some((time_s, deviation)) = look.at(simulator)?
        {
            track.span_s = time_s - start_s;
            track.errors.push(deviation);
        }
        Ok(ControlFlow::Continue(()))
    })?;
    Ok(track)
}

impl Look {
    fn at(self, simulator: &mut Simulator) -> Result<Option<(f64, Deviation)>, Error> {
        let source = match self {
            Self::Sigma => {
                let covariance = simulator.covariance()?;
                let sigmas = |covariance: NavigationCovariance| Deviation::from(covariance.sigma());
                return Ok(covariance.map(|(time_s, covariance, _)| (time_s, sigmas(covariance))));
            }
            Self::Navigation => ErrorSource::Navigation,
            Self::Model => ErrorSource::Model,
        };
        Ok(simulator.errors(source)?.map(|(time_s, errors)| {
            let mut deviation = Deviation::zeros();
            let parts: [Vector3<f64>; 3] = [errors.position_n, errors.velocity_n, errors.misalignment_n];
            for (part, row) in parts.iter().zip([0, 3, MISALIGNMENT]) {
                deviation.fixed_rows_mut::<3>(row).copy_from(part);
            }
            (time_s, deviation)
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Turns of 3.1 and -3.1 rad about an axis are 0.083 rad apart, and small ones as far as their vectors.
    #[test]
    fn attitudes_differ_by_the_rotation_between_them() {
        let about = |angle: f64| {
            let mut deviation = Deviation::zeros();
            (deviation[0], deviation[7]) = (5.0 * angle, angle);
            deviation
        };
        let far = difference(&about(3.1), &about(-3.1));
        assert_eq!(far[0], 31.0);
        assert!((far[7] - (6.2 - core::f64::consts::TAU)).abs() < 1e-15, "{far}");
        let near = difference(&about(3e-9), &about(1e-9));
        assert!((near[7] - 2e-9).abs() < 1e-24, "{near}");
    }

    #[test]
    fn instants_are_every_sample_or_equally_spaced() {
        let sample = |_| Err(Error::bad_state("not flown"));
        for count in [2, 3, 17, 1000, 1001, 1002, 5000, 17_280_001] {
            let scene = ComputedSamples { count, sample: &sample };
            let all: Vec<usize> = (0..scene.instants()).map(|k| scene.instant(k)).collect();
            assert_eq!((all[0], all[all.len() - 1]), (1, count - 1), "{count}");
            assert!(all.windows(2).all(|pair| pair[0] < pair[1]), "{count}");
            let steps = all.windows(2).map(|pair| pair[1] - pair[0]);
            let (least, most) = (steps.clone().min().unwrap_or(1), steps.max().unwrap_or(1));
            assert!(most - least <= 1, "{count}");
        }
    }
}
