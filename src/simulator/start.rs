//! The INS at its start: the truth with the errors of the run.

use nalgebra::Vector3;

use super::{Options, SensorSuite, singular};
use crate::earth::Earth;
use crate::error::Error;
use crate::math::{rotate, rotate_inverse, rotation_quaternion, sin_cos};
use crate::mechanization::VerticalMode;
use crate::sensors::{Alignment, Triad, alignment_error};
use crate::state::{EarthFixedState, Navigation, StateErrors};
use crate::truth::TruthPoint;

/// Gyrocompassing needs a horizontal Earth rate: cosine of latitude at the least (0.6° from a pole).
const MIN_GYROCOMPASS_COS: f64 = 0.01;

/// The initial errors of the run, of the sensors' own solution, whose true one is `state` or `truth`, at the sample `first`;
/// those of the vertical channel vanish where it follows the truth. `disturbance_e` is true less normal gravity [m/s²].
pub(super) fn start_errors(
    options: &Options,
    earth: &Earth,
    (first, state): (&TruthPoint, &EarthFixedState),
    truth: &Navigation,
    disturbance_e: Option<&Vector3<f64>>,
    sensors: &SensorSuite,
) -> Result<StateErrors, Error> {
    let mut start = sensors.initial.draw(options.key);
    if sensors.initial.alignment == Alignment::LevelAndGyrocompass {
        let (sin, cos) = sin_cos(truth.place.latitude_rad);
        if cos < MIN_GYROCOMPASS_COS {
            return Err(singular(
                "cosine of sample.latitude_rad",
                cos,
                "gyrocompassing needs at least",
                MIN_GYROCOMPASS_COS,
            ));
        }
        let earth_rate_n = Vector3::new(0.0, earth.rate_rad_s * cos, earth.rate_rad_s * sin);
        let force_b = -rotate_inverse(&state.q_eb, &first.gravity_e);
        let rate_b = rotate_inverse(&truth.q_nb, &earth_rate_n);
        let steady_error_n = |triad: &Triad| {
            rotate(&truth.q_nb, &triad.steady_error(&rate_b, &force_b, first.sample.temperature_c))
        };
        let (gyro_n, mut accel_n) = (steady_error_n(&sensors.gyro), steady_error_n(&sensors.accel));
        if let Some(disturbance_e) = disturbance_e {
            // To an INS that computes with normal gravity the rest is an error of its accelerometers.
            let (east, north, up) = earth.east_north_up(&truth.place);
            accel_n -= Vector3::new(east.dot(disturbance_e), north.dot(disturbance_e), up.dot(disturbance_e));
        }
        let g = first.gravity_e.norm_squared().sqrt();
        start.misalignment_n += alignment_error(&gyro_n, &accel_n, g, earth_rate_n.y, earth_rate_n.z);
    }
    if options.vertical == VerticalMode::FollowTruth {
        start.position_n.z = 0.0;
        start.velocity_n.z = 0.0;
    }
    Ok(start)
}

/// The solution that has the errors `start` against `truth`: displaced along east and north at its height, C~ = exp(-φ) C.
pub(super) fn with_errors(
    earth: &Earth,
    options: &Options,
    truth: &Navigation,
    start: &StateErrors,
) -> Navigation {
    let (r_e, [east, north, _]) = earth.to_earth_fixed_with_axes(&truth.place);
    let mut place = truth.place;
    if start.position_n.x != 0.0 || start.position_n.y != 0.0 {
        place = earth.to_geodetic(&(r_e + east * start.position_n.x + north * start.position_n.y));
    }
    place.height_m = truth.place.height_m + start.position_n.z;
    let q_nb = rotation_quaternion(&-start.misalignment_n) * truth.q_nb;
    Navigation::new(place, truth.v_n + start.velocity_n, q_nb, options.axes)
}
