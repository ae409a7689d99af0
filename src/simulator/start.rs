//! The INS at its start: the truth with the errors of the run.

use nalgebra::Vector3;

use super::{Options, SensorSuite, singular};
use crate::earth::Earth;
use crate::error::Error;
use crate::math::{rotate, rotate_inverse, rotation_quaternion, rotation_vector, sin_cos};
use crate::mechanization::VerticalMode;
use crate::sensors::{Aligned, Alignment, Sensed, Triad, level_and_gyrocompass};
use crate::state::{EarthFixedState, Navigation, StateErrors};
use crate::truth::TruthPoint;

/// Gyrocompassing needs a horizontal Earth rate: cosine of latitude at the least (0.6° from a pole).
const MIN_GYROCOMPASS_COS: f64 = 0.01;

/// Whether an error of a run's start is one of the place, where no run can align.
pub(crate) fn is_of_truth(error: &Error) -> bool {
    error.field == "cosine of sample.latitude_rad"
}

/// How an INS starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Start {
    pub errors: StateErrors,
    /// Gyrocompassing could not find north.
    pub north_unknown: bool,
}

impl Start {
    /// Without errors.
    pub const TRUE: Self = Self { errors: StateErrors::NONE, north_unknown: false };

    /// With the initial errors of the run, of the sensors' own solution, whose true one is `state` or `truth`, at the sample
    /// `first`; those of the vertical channel vanish where it follows the truth. `disturbance_e` is true less normal gravity
    /// [m/s²].
    pub fn new(
        options: &Options,
        earth: &Earth,
        (first, state): (&TruthPoint, &EarthFixedState),
        truth: &Navigation,
        disturbance_e: Option<&Vector3<f64>>,
        sensors: &SensorSuite,
    ) -> Result<Self, Error> {
        let mut start = Self { errors: sensors.initial.draw(options.key), north_unknown: false };
        if sensors.initial.alignment == Alignment::LevelAndGyrocompass {
            let disturbance_e = disturbance_e.copied().unwrap_or_default();
            let aligned = aligned(earth, (first, state), truth, &disturbance_e, sensors)?;
            let given = rotation_quaternion(&-start.errors.misalignment_n);
            start.errors.misalignment_n = -rotation_vector(&(given * aligned.rotation));
            start.north_unknown = aligned.north_unknown;
        }
        if options.vertical == VerticalMode::FollowTruth {
            start.errors.position_n.z = 0.0;
            start.errors.velocity_n.z = 0.0;
        }
        Ok(start)
    }
}

/// What levelling and gyrocompassing find at rest at `state`.
fn aligned(
    earth: &Earth,
    (first, state): (&TruthPoint, &EarthFixedState),
    truth: &Navigation,
    disturbance_e: &Vector3<f64>,
    sensors: &SensorSuite,
) -> Result<Aligned, Error> {
    let (sin, cos) = sin_cos(truth.place.latitude_rad);
    if cos < MIN_GYROCOMPASS_COS {
        return Err(singular(
            "cosine of sample.latitude_rad",
            cos,
            "gyrocompassing needs at least",
            MIN_GYROCOMPASS_COS,
        ));
    }
    let (east, north, up) = earth.east_north_up(&truth.place);
    let in_local_axes =
        |vector_e: &Vector3<f64>| Vector3::new(east.dot(vector_e), north.dot(vector_e), up.dot(vector_e));
    let computed_gravity_e = earth.gravity(&state.r_e);
    let earth_rate_n = Vector3::new(0.0, earth.rate_rad_s * cos, earth.rate_rad_s * sin);
    let rate_b = rotate_inverse(&truth.q_nb, &earth_rate_n);
    let force_b = -rotate_inverse(&state.q_eb, &(computed_gravity_e + disturbance_e));
    let error_n = |triad: &Triad| {
        rotate(&truth.q_nb, &triad.steady_error(&rate_b, &force_b, first.sample.temperature_c))
    };
    // To an INS that computes with normal gravity the rest is an error of its accelerometers.
    let force_error_n = error_n(&sensors.accel) - in_local_axes(disturbance_e);
    Ok(level_and_gyrocompass(
        &Sensed { ideal_n: -in_local_axes(&computed_gravity_e), error_n: force_error_n },
        &Sensed { ideal_n: earth_rate_n, error_n: error_n(&sensors.gyro) },
    ))
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
