//! What statistics consist of: the struct of the C interface itself, which hosts send and store as it is.

/// Statistics of the errors of many runs at one instant, as integers: sums of equal runs are the same bits however the runs were split
/// and in whatever order the parts were merged. A plain struct without pointers, 14.6 KiB: send it, store it, compare its bytes. Its
/// numbers have the byte order of the machine. All zero but struct_size is that of no run. Read it with sins_statistics_figures().
///
/// The states are x = position east, north, up; velocity east, north, up; misalignment about east, north, up, as in sins_errors. Each
/// is a multiple of its resolution, rounded to the nearest: 2^-22 m (0.24 um), 2^-29 m/s (1.9 nm/s), 2^-45 rad (2.8e-14 rad). The
/// ranges are 2^25 m, 2^18 m/s and 4 rad, so that 2^47 resolutions are never exceeded, and the sums of 4294967295 runs, which is the
/// most, cannot overflow. Integers of 128 bits are two words, the low one first, in two's complement.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct sins_statistics {
    /// sizeof(sins_statistics)
    pub struct_size: u32,
    /// Version of what follows: 1; 0 while there is no run.
    pub layout: u32,
    /// Runs, those that were left out of the sums too.
    pub runs: u64,
    /// Runs that have diverged, left out of the sums.
    pub diverged: u64,
    /// Runs with a state or a horizontal radial position error outside its range, left out of the sums.
    pub out_of_range: u64,
    /// Runs within the sums whose error model is flagged SINS_ERRORS_OUTSIDE_VALIDITY.
    pub outside_validity: u64,
    /// Largest horizontal radial position error, rounded down [2^-22 m].
    pub largest_radial: u64,
    /// Sum of each state, integers of 128 bits.
    pub sums: [u64; 18],
    /// Sums of the products of two states, integers of 128 bits: the upper triangle of the matrix, row by row.
    pub products: [u64; 90],
    /// Runs by horizontal radial position error: element 0 those below 2^-10 m (1 mm), and 1 + 100 i + k, for i from 0 to 34 and k
    /// from 0 to 99, those from 2^(i-10) (1 + k/100) up to 2^(i-10) (1 + (k+1)/100) m.
    pub histogram: [u32; 3501],
    /// 0
    pub reserved: u32,
}
