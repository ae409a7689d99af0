//! What statistics consist of: the struct of the C interface itself, which hosts send and store as it is.

/// Statistics of the errors of many runs at one instant. All numbers are integers, so that the same runs give the same bits however
/// they were split and in whatever order the parts were merged. A plain struct of 14.6 KiB without pointers: send it, store it,
/// compare its bytes. Its numbers have the byte order of the machine. A struct that is all zero but for struct_size has no run.
/// sins_statistics_figures() computes means, covariances and radii.
///
/// The nine states are the errors of position east, north, up, of velocity east, north, up, and the misalignment about east, north,
/// up, as in sins_errors. Each is rounded to the nearest multiple of its resolution: 2^-22 m (0.24 um), 2^-29 m/s (1.9 nm/s),
/// 2^-45 rad (2.8e-14 rad). A state is in range up to 2^25 m (33554 km), 2^18 m/s (262 km/s) and 4 rad, which are 2^47 resolutions;
/// the horizontal radial position error is in range below 2^25 m. There are at most 4294967295 runs: their sums cannot overflow.
/// Integers of 128 bits are two words, the low one first, in two's complement.
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
