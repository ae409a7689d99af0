//! Random streams: one for each (seed, run, sensor, axis, effect), so that no effect changes the draws of another one.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};

use super::draw::normal;
use super::xoshiro::Xoshiro256PlusPlus;
use crate::base::math::mix;
use crate::base::snapshot::{ANY, stored};

/// Source of draws: the sensor or model that draws. The numbers are part of the bit-for-bit guarantee: never reuse one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Source {
    Gyro = 0,
    Accelerometer = 1,
    Altimeter = 2,
    InitialErrors = 3,
    Fix = 4,
    Gravity = 16,
    Host = 64,
}

/// The numbers of the streams of effects are below this one; they stand in the table of effects.
pub(super) const STREAM_NUMBERS: usize = 16;

/// Rejects a number that stands twice, or is not one for effects.
pub(super) const fn check_numbers(numbers: &[u64]) {
    let (mut seen, mut k) = ([false; STREAM_NUMBERS], 0);
    while k < numbers.len() {
        let is_seen = &mut seen[numbers[k] as usize];
        assert!(!*is_seen, "two streams of effects have one number");
        *is_seen = true;
        k += 1;
    }
}

/// Other purposes of draws. The numbers are part of the bit-for-bit guarantee: never reuse one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Purpose {
    /// Of the altimeter and of gravity, which have no effects.
    GaussMarkov = 1,
    InitialPosition = 16,
    InitialVelocity = 17,
    InitialMisalignment = 18,
    SampleNoise = 19,
    Alignment = 20,
    Failure = 32,
}

/// Key of a run: the streams of two different keys are independent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct StreamKey {
    /// Seed, chosen by the user.
    pub seed: u64,
    /// Number of the run in an ensemble.
    pub run: u64,
}

stored!(StreamKey { seed: ANY, run: ANY });

impl StreamKey {
    /// A stream for the host's own random numbers in this run, independent of the library's streams and of those with another
    /// `number`.
    ///
    /// ```
    /// use rand::RngExt;
    /// use rand_distr::Distribution;
    /// use sins::sensors::{StandardNormal, StreamKey};
    ///
    /// let mut stream = StreamKey { seed: 1, run: 0 }.host_stream(0);
    /// let uniform: f64 = stream.random();
    /// let normal = StandardNormal.sample(&mut stream);
    /// assert!((0.0..1.0).contains(&uniform) && normal.abs() < 10.0);
    /// ```
    pub fn host_stream(self, number: u64) -> Xoshiro256PlusPlus {
        self.generator([Source::Host as u64, 0, number])
    }

    /// Normal numbers for the three errors of the fix of a `quantity` at `time_s` [s], which depend on nothing else.
    pub fn fix(self, quantity: u64, time_s: f64) -> Vector3<f64> {
        let mut generator = self.generator([Source::Fix as u64, quantity, time_s.to_bits()]);
        Vector3::from_fn(|_, _| normal(&mut generator))
    }

    fn generator(self, words: [u64; 3]) -> Xoshiro256PlusPlus {
        let seed = [self.seed, self.run].into_iter().chain(words).fold(0, |hash, word| mix(hash ^ word));
        Xoshiro256PlusPlus::seed_from_u64(seed)
    }
}

/// A stream of random numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Stream {
    generator: Xoshiro256PlusPlus,
}

stored!(Stream { generator });

impl Stream {
    pub fn new(key: StreamKey, source: Source, axis: usize, purpose: Purpose) -> Self {
        Self::of_number(key, source, axis, purpose as u64)
    }

    fn of_number(key: StreamKey, source: Source, axis: usize, number: u64) -> Self {
        Self { generator: key.generator([source as u64, axis as u64, number]) }
    }

    /// Streams of the three axes.
    pub fn triad(key: StreamKey, source: Source, purpose: Purpose) -> [Self; 3] {
        [0, 1, 2].map(|axis| Self::new(key, source, axis, purpose))
    }

    /// A stream with the state `words`, which [`Self::words`] gave.
    #[inline(always)]
    pub fn of_words(words: [u64; 4]) -> Self {
        Self { generator: Xoshiro256PlusPlus::of_words(words) }
    }

    /// A stream that follows from the state of this one, and is independent of it.
    pub fn other(&self) -> Self {
        let seed = self.words().into_iter().fold(Purpose::Alignment as u64, |hash, word| mix(hash ^ word));
        Self { generator: Xoshiro256PlusPlus::seed_from_u64(seed) }
    }

    /// State of the stream.
    #[inline(always)]
    pub fn words(&self) -> [u64; 4] {
        self.generator.words()
    }

    /// The next uniform number from 0 up to but excluding 1, in steps of 2^-53.
    pub fn uniform(&mut self) -> f64 {
        self.generator.random()
    }

    /// The next normal number with mean 0 and variance 1.
    #[inline]
    pub fn normal(&mut self) -> f64 {
        normal(&mut self.generator)
    }
}

/// The streams of an effect, which the table of effects numbers.
pub(super) struct EffectStreams {
    pub key: StreamKey,
    pub source: Source,
    pub numbers: &'static [u64],
}

impl EffectStreams {
    /// Those of the three axes under the effect's number at `place`.
    pub fn triad(&self, place: usize) -> [Stream; 3] {
        [0, 1, 2].map(|axis| Stream::of_number(self.key, self.source, axis, self.numbers[place]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_part_of_the_key_gives_another_stream() {
        let key = StreamKey { seed: 1, run: 0 };
        let mut first = [
            Stream::new(key, Source::Gyro, 0, Purpose::GaussMarkov),
            Stream::new(key, Source::Gyro, 1, Purpose::GaussMarkov),
            Stream::new(key, Source::Accelerometer, 0, Purpose::GaussMarkov),
            Stream::new(key, Source::Gyro, 0, Purpose::Failure),
            Stream::new(StreamKey { seed: 2, ..key }, Source::Gyro, 0, Purpose::GaussMarkov),
            Stream::new(StreamKey { run: 1, ..key }, Source::Gyro, 0, Purpose::GaussMarkov),
            Stream::new(StreamKey { seed: 0, run: 1 }, Source::Gyro, 0, Purpose::GaussMarkov),
            Stream::new(key, Source::Gyro, 0, Purpose::GaussMarkov).other(),
            Stream::new(key, Source::Gyro, 1, Purpose::GaussMarkov).other(),
        ]
        .iter_mut()
        .map(|stream| stream.normal().to_bits())
        .collect::<Vec<_>>();
        first.sort_unstable();
        first.dedup();
        assert_eq!(first.len(), 9);
        let mut again = Stream::new(key, Source::Gyro, 0, Purpose::GaussMarkov);
        assert!(first.contains(&again.normal().to_bits()));
    }
}
