//! What statistics consist of: the struct of the C interface itself, which hosts send and store as it is.

/// Statistics of the errors of many runs at one instant. All numbers are integers, so that the same runs give the same bits however
/// they were split and in whatever order the parts were merged. A plain struct of 14.6 KiB without pointers: send it, store it,
/// compare its bytes. Its numbers have the byte order of the machine. A struct that is zero except for struct_size holds no
/// runs. sins_statistics_figures() computes means, covariances and radii.
///
/// The nine states are the errors of position east, north, up, of velocity east, north, up, and the misalignment about east, north,
/// up, as in sins_errors. Each is rounded to the nearest multiple of its resolution: 2^-22 m (0.24 um), 2^-29 m/s (1.9 nm/s),
/// 2^-45 rad (2.8e-14 rad). A state is in range up to 2^25 m (33554 km), 2^18 m/s (262 km/s) and 4 rad, which are 2^47 resolutions;
/// the horizontal radial position error is in range below 2^25 m. There are at most 4294967295 runs, so the sums cannot
/// overflow. Integers of 128 bits are two words, the low one first, in two's complement.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct sins_statistics {
    /// sizeof(sins_statistics)
    pub struct_size: u32,
    /// Version of the layout of the fields below: 1; 0 while there is no run.
    pub layout: u32,
    /// Number of runs, including those that are left out of the sums.
    pub runs: u64,
    /// Number of runs that have diverged. They are left out of the sums.
    pub diverged: u64,
    /// Number of runs with a state or a horizontal radial position error outside its range. They are left out of the sums.
    pub out_of_range: u64,
    /// Number of runs whose error model is flagged SINS_ERRORS_OUTSIDE_VALIDITY. They are in the sums.
    pub outside_validity: u64,
    /// Largest horizontal radial position error, rounded down [2^-22 m].
    pub largest_radial: u64,
    /// Sum of each state, integers of 128 bits.
    pub sums: [u64; 18],
    /// Sums of the products of two states, integers of 128 bits: the upper triangle of the matrix, row by row.
    pub products: [u64; 90],
    /// Numbers of runs by their horizontal radial position error. Element 0 counts those below 2^-10 m (1 mm). Element 1 +
    /// 100 i + k, with i from 0 to 34 and k from 0 to 99, counts those from 2^(i-10) (1 + k/100) m up to 2^(i-10) (1 +
    /// (k+1)/100) m.
    pub histogram: [u32; 3501],
    /// 0
    pub reserved: u32,
}
