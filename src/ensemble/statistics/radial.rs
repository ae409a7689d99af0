//! The histogram of the horizontal radial position error: a hundred equal buckets in each octave, so that no bucket is wider than
//! 1 % of the values in it.

use super::{FRACTION_BITS, STATE_BITS, Statistics, resolution};

/// Largest relative error of a radius from the histogram, from 2^-10 m on: half a bucket over the values in it.
pub const RADIAL_ERROR: f64 = 0.5 / PARTS as f64;

/// Bits of the first radius beyond bucket 0: 2^-10 m.
const FIRST_BITS: u32 = FRACTION_BITS[0] - 10;

/// Buckets in an octave.
const PARTS: u64 = 100;

/// Buckets in all.
pub(super) const BUCKETS: usize = 1 + (STATE_BITS - FIRST_BITS) as usize * PARTS as usize;

/// The bucket of a radius that is less than 2^47 resolutions.
pub(super) fn bucket_of(radial: u64) -> usize {
    if radial < 1 << FIRST_BITS {
        return 0;
    }
    let octave = radial.ilog2();
    let part = ((radial - (1 << octave)) * PARTS) >> octave;
    1 + ((octave - FIRST_BITS) as usize) * PARTS as usize + part as usize
}

/// The middle of a bucket [resolutions].
fn middle_of(bucket: usize) -> f64 {
    let Some(beyond) = bucket.checked_sub(1) else { return 0.5 * (1_u64 << FIRST_BITS) as f64 };
    let (octave, part) = (beyond / PARTS as usize, beyond % PARTS as usize);
    (1_u64 << (FIRST_BITS as usize + octave)) as f64 * (1.0 + (part as f64 + 0.5) / PARTS as f64)
}

impl Statistics {
    /// The horizontal radius [m] within which `percent` of the runs are: that of the run of this rank, to [`RADIAL_ERROR`] of
    /// itself, or to 0.5 mm. 0 without a run.
    pub(super) fn radius(&self, percent: u64) -> f64 {
        let rank = (percent * self.good()).div_ceil(100);
        let mut within = 0;
        let bucket = self.histogram.iter().position(|&count| {
            within += u64::from(count);
            within >= rank
        });
        if rank == 0 {
            return 0.0;
        }
        bucket.map_or(0.0, middle_of).min(self.largest_radial as f64) * resolution(FRACTION_BITS[0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each bucket's ends, one resolution around them, and the whole range.
    #[test]
    fn buckets_lie_side_by_side_and_none_is_wider_than_a_hundredth() {
        let (mut last, mut bucket) = (0, 0);
        let mut lowest = vec![0];
        for octave in FIRST_BITS..STATE_BITS {
            for part in 0..PARTS {
                let low = (1 << octave) + ((part << octave).div_ceil(PARTS));
                assert_eq!((bucket_of(low - 1), bucket_of(low)), (bucket, bucket + 1));
                bucket += 1;
                lowest.push(low);
                assert!(low > last);
                last = low;
            }
        }
        assert_eq!((bucket, bucket_of((1 << STATE_BITS) - 1)), (BUCKETS - 1, BUCKETS - 1));
        for (bucket, &low) in lowest.iter().enumerate().skip(1) {
            let high = lowest.get(bucket + 1).map_or((1 << STATE_BITS) - 1, |next| next - 1);
            for radius in [low, high] {
                let error = (middle_of(bucket) - radius as f64).abs() / radius as f64;
                assert!(error <= RADIAL_ERROR, "bucket {bucket}: {error}");
            }
        }
    }
}
