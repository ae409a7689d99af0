//! A scene: the samples of a flight, the rates at which the simulator gets them, and the reference for its solutions.

use sins::Options;
use sins::analysis::recommend::{Growth, Piece, Refusal};
use sins::truth::{FlightSample, IntakeLimits};

use super::reference::Judge;
use crate::units::stamp_text;

/// Largest number of instants at which a solution is judged; the last instant is at the end of the scene.
const INSTANTS: usize = 60;

/// Smallest number of samples in a period of a vibration from which the signal generator can recover the vibration.
const SAMPLES_OF_A_PERIOD: f64 = 10.0;

/// A sample rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rate {
    /// Distance of two samples, in samples of the scene.
    pub stride: usize,
    pub hz: f64,
    /// Whether the period is stated to the simulator.
    is_stated: bool,
}

impl Rate {
    /// Rate with the exact period 1/`hz`.
    pub fn stated(stride: usize, hz: f64) -> Self {
        Self { stride, hz, is_stated: true }
    }

    /// Rate from the samples' own time stamps; `hz` is the mean.
    pub fn of_stamps(stride: usize, hz: f64) -> Self {
        Self { stride, hz, is_stated: false }
    }

    /// `options` at this rate.
    pub fn applied_to(&self, options: &Options) -> Options {
        let period_s = self.is_stated.then_some(1.0 / self.hz);
        Options { intake: IntakeLimits { period_s, ..options.intake }, ..*options }
    }
}

/// A scene.
pub struct CurveScene {
    pub name: String,
    pub title: String,
    /// Highest frequency of a vibration in the scene [Hz]; 0 without vibration.
    pub highest_hz: f64,
    /// Samples at the highest rate.
    pub samples: Vec<FlightSample>,
    /// Rates, the highest first. The stride of the last rate is a multiple of the other strides.
    pub rates: Vec<Rate>,
    pub judge: Judge,
    /// Recommended options, with ellipsoid and gravity of the scene.
    pub base: Options,
    /// What is doubtful in the flight data, and what is not flown, in sentences.
    pub warnings: Vec<String>,
}

/// A scene in pieces, by which its configurations are judged: the whole scene, or its hardest parts.
pub struct Pieces {
    pub scenes: Vec<CurveScene>,
    /// Of a scene that is not flown whole: all of it at the lowest rate, for what needs no more.
    pub coarse: Option<(Rate, Vec<FlightSample>)>,
    /// Length of the whole scene [s].
    pub whole_s: f64,
}

impl Pieces {
    pub fn whole(scene: CurveScene) -> Self {
        Self { whole_s: scene.duration_s(), scenes: vec![scene], coarse: None }
    }

    /// The pieces in words; empty: it is flown whole.
    pub fn text(&self) -> String {
        if let [_] = self.scenes[..] {
            return String::new();
        }
        let begins: Vec<String> =
            self.scenes.iter().map(|scene| stamp_text(scene.samples[0].time_s)).collect();
        let (count, piece_s) = (begins.len(), self.scenes[0].duration_s());
        format!(
            "; judged by its {count} hardest pieces of {piece_s} s, at {}, predicted for the whole",
            begins.join(", ")
        )
    }

    /// The same in few words, behind the title.
    pub fn note(&self) -> &'static str {
        if let [_] = self.scenes[..] { "" } else { " (predicted from its hardest minutes)" }
    }

    /// How the errors of each piece grow over the whole scene.
    pub fn growths(&self) -> Result<Vec<Growth>, Refusal> {
        let of = |scene: &CurveScene| {
            let options = match scene.rates.first() {
                Some(rate) => rate.applied_to(&scene.base),
                None => scene.base,
            };
            Ok(Growth::new(&Piece::new(&options, &scene.samples)?, self.whole_s, options.vertical))
        };
        self.scenes.iter().map(of).collect()
    }
}

impl CurveScene {
    /// Indices of samples that all `rates` have, counted at `stride`: equally spaced, without the first sample.
    pub fn instants(samples: usize, rates: &[Rate], stride: usize) -> Vec<usize> {
        let coarsest = rates.last().map_or(1, |rate| rate.stride);
        let intervals = samples.saturating_sub(1) / coarsest;
        let count = INSTANTS.min(intervals);
        (1..=count).map(|k| k * intervals / count * (coarsest / stride)).collect()
    }

    /// The instants of the judge, as indices of the samples at `rate`.
    pub fn instants_at(&self, rate: &Rate) -> Vec<usize> {
        Self::instants(self.samples.len(), &self.rates, rate.stride)
    }

    /// The samples at `rate`.
    pub fn samples_at(&self, rate: &Rate) -> Vec<FlightSample> {
        self.samples.iter().step_by(rate.stride).copied().collect()
    }

    /// Whether the scene vibrates too fast for samples at `rate`: a solution that agrees with the samples may then differ from the
    /// flight between them.
    pub fn is_undersampled(&self, rate: &Rate) -> bool {
        rate.hz < SAMPLES_OF_A_PERIOD * self.highest_hz
    }

    /// Time from the first sample to the last instant [s].
    pub fn duration_s(&self) -> f64 {
        let instants = Self::instants(self.samples.len(), &self.rates, 1);
        let last = instants.last().map_or(0, |&index| index);
        self.samples[last].time_s - self.samples[0].time_s
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_instants_are_common_to_all_rates() {
        let rates = [1, 2, 4].map(|stride| Rate::of_stamps(stride, 100.0 / stride as f64));
        let [fine, middle, coarse] = [1, 2, 4].map(|stride| CurveScene::instants(1003, &rates, stride));
        assert_eq!((coarse.len(), coarse[0], coarse[59]), (60, 4, 250));
        assert!(coarse.windows(2).all(|pair| pair[1] - pair[0] >= 4));
        assert!(coarse.iter().zip(&middle).zip(&fine).all(|((c, m), f)| 2 * c == *m && 4 * c == *f));
        assert_eq!(CurveScene::instants(9, &rates, 1), [4, 8], "no more than there are");
    }

    #[test]
    fn a_stated_period_is_exact() {
        let options = Rate::stated(4, 50.0).applied_to(&Options::default());
        assert_eq!(options.intake.period_s, Some(0.02));
        assert_eq!(Rate::of_stamps(1, 50.0).applied_to(&options).intake.period_s, None);
    }
}
