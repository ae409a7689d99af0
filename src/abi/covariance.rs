//! `sins_covariance`.

use super::answer::write_or_need;
use super::choice::flag;
use super::errors::{SINS_ERRORS_NEAR_POLE, SINS_ERRORS_OUTSIDE_VALIDITY, SINS_ERRORS_WITHOUT_CORRECTIONS};
use super::failure::sins_status;
use super::memory::{Output, interface_struct};
use super::simulator::{sins_sim, with_simulator};
use crate::errors::covariance::NavigationCovariance;

/// Covariance of the navigation errors over all runs of the flight, with its standard deviations and its error ellipse. The errors
/// are those of sins_errors: east, north, up of position [m], velocity [m/s] and misalignment [rad], in this order.
///
/// The covariance is propagated along the truth with the linear error equations (error data 1). Both values of
/// sins_options.frame use the equations in Earth-fixed axes; the result is the same. The covariance is taken about the mean
/// error of all runs. It does not depend on the random numbers of this run, except for random drop-outs of the altimeter: it takes
/// those of this run. It contains: random initial errors; the misalignment that the alignment at the start derives from sensor
/// errors; turn-on biases, scale factors and misalignments; Gauss-Markov, flicker, rate random walk and white noise; the random
/// fields of gravity; the altimeter's Gauss-Markov error and noise; quantization, as white noise of the same variance; failures of
/// gyros and accelerometers: a dead or stuck sensor has no random errors, the noise of a failure is added, random drop-outs count
/// with their mean effect and the scatter of what they lose. It does not contain: constant errors, bias steps and spikes, which
/// change only the mean; the value that a stuck sensor holds; failures of the altimeter other than lost heights; dead zones and
/// ranges, which are not linear. One step of the propagation is one second of flight. A parameter that is set in flight takes effect
/// from the start of the current second, a failure by its share of this second. A second with at least one height of the altimeter
/// counts as aided throughout, so drop-outs shorter than a second have no effect on the covariance. The
/// standard deviations of the propagation are limited to 1e30 in SI units, so all outputs are finite.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_covariance {
    /// sizeof(sins_covariance)
    pub struct_size: u32,
    /// Flags of enum sins_errors_flags, or'ed: SINS_ERRORS_NEAR_POLE, SINS_ERRORS_WITHOUT_CORRECTIONS, and
    /// SINS_ERRORS_OUTSIDE_VALIDITY if a standard deviation, or an error of this run, exceeds the limits of that flag, or if the mean
    /// error by random drop-outs, over all runs, has exceeded them since the start.
    pub flags: i32,
    /// Time [s].
    pub time_s: f64,
    /// Covariance, 9 by 9, row by row. It is symmetric, and rounding cannot make a variance negative.
    pub covariance: [f64; 81],
    /// Standard deviation of the position error [m].
    pub position_sigma_enu_m: [f64; 3],
    /// Standard deviation of the velocity error [m/s].
    pub velocity_sigma_enu_m_s: [f64; 3],
    /// Standard deviation of the misalignment [rad].
    pub misalignment_sigma_enu_rad: [f64; 3],
    /// Semi-major axis of the error ellipse (one standard deviation) of the horizontal position [m].
    pub ellipse_major_m: f64,
    /// Semi-minor axis of that ellipse [m].
    pub ellipse_minor_m: f64,
    /// Azimuth of the major axis, from north to the east, 0 up to pi [rad].
    pub ellipse_azimuth_rad: f64,
    /// Radius of the circle that contains the horizontal error with a probability of 50 % [m]. The error has the normal
    /// distribution of this ellipse, with the mean 0.
    pub cep50_m: f64,
    /// Radius of the circle that contains the horizontal error with a probability of 95 % [m].
    pub radial_95_m: f64,
}

interface_struct!(sins_covariance, "covariance", 776);

impl sins_covariance {
    fn new(&(time_s, covariance, near_pole): &(f64, NavigationCovariance, bool)) -> Self {
        let NavigationCovariance { matrix, ellipse, outside_validity, without_corrections } = covariance;
        let sigma = covariance.sigma();
        let [pe, pn, pu, ve, vn, vu, me, mn, mu] = sigma;
        Self {
            struct_size: size_of::<Self>() as u32,
            flags: flag(near_pole, SINS_ERRORS_NEAR_POLE)
                | flag(outside_validity, SINS_ERRORS_OUTSIDE_VALIDITY)
                | flag(without_corrections, SINS_ERRORS_WITHOUT_CORRECTIONS),
            time_s,
            covariance: core::array::from_fn(|place| matrix[(place / 9, place % 9)]),
            position_sigma_enu_m: [pe, pn, pu],
            velocity_sigma_enu_m_s: [ve, vn, vu],
            misalignment_sigma_enu_rad: [me, mn, mu],
            ellipse_major_m: ellipse.major_m,
            ellipse_minor_m: ellipse.minor_m,
            ellipse_azimuth_rad: ellipse.azimuth_rad,
            cep50_m: ellipse.cep50_m(),
            radial_95_m: ellipse.radial_95_m(),
        }
    }
}

/// Reads the covariance of the navigation errors at the end of the last interval; before the first step, that of the start.
///
/// SINS_NEED_SAMPLE: no sample yet.
/// SINS_ERROR_BAD_STATE: sins_options.covariance is off, or navigating on increments.
/// SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: no INS can start at the first sample.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_covariance(
    sim: *mut sins_sim,
    covariance: *mut sins_covariance,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(covariance, "covariance")? };
        let covariance = simulator.covariance()?;
        Ok(write_or_need(&output, covariance.as_ref().map(sins_covariance::new)))
    })
}
