//! The INS at its start: the truth with the errors of the run.

use nalgebra::{Matrix3, Vector3};

use super::{Imperfections, Options, singular};
use crate::base::error::Error;
use crate::base::math::{
    Euler, attitude_from_euler, relative_rotation, rotate, rotate_inverse, rotation_matrix,
    rotation_quaternion, rotation_vector, sin_cos,
};
use crate::earth::Earth;
use crate::earth::state::{EarthFixedState, Navigation, StateErrors};
use crate::errors::covariance::SteadyAlignment;
use crate::mechanization::VerticalMode;
use crate::sensors::{self, Aligned, Sensed, Triad, level, level_and_gyrocompass};
use crate::signal::mounting::{Block, MountingParameters};
use crate::truth::{Recent, TruthPoint};

/// Smallest cosine of latitude for gyrocompassing, which needs a horizontal Earth rate (0.6° from a pole).
const MIN_GYROCOMPASS_COS: f64 = 0.01;

/// Whether an error at the start of a run is caused by the place, where no run can align.
pub(crate) fn is_of_truth(error: &Error) -> bool {
    error.field == "cosine of sample.latitude_rad"
}

/// Initial errors of an INS, and the outcome of its alignment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Start {
    pub errors: StateErrors,
    /// Gyrocompassing could not find north.
    pub north_unknown: bool,
}

impl Start {
    /// Start without errors.
    pub const TRUE: Self = Self { errors: StateErrors::NONE, north_unknown: false };

    /// Start with the initial errors of the run at the sample `first`. The errors belong to the solution of the sensors' own point,
    /// whose true state is `state`, or `truth` as a navigation. The errors of the vertical channel are 0 if it follows the truth.
    /// `disturbance_e` is true less normal gravity [m/s²]. An alignment that takes time moves the processes of the sensors on.
    pub fn new(
        options: &Options,
        earth: &Earth,
        (first, state): (&TruthPoint, &EarthFixedState),
        truth: &Navigation,
        disturbance_e: Option<&Vector3<f64>>,
        imperfections: &mut Imperfections,
    ) -> Result<Self, Error> {
        let mut start = Self { errors: imperfections.set().initial.draw(options.key), north_unknown: false };
        let alignment = imperfections.set().initial.alignment;
        if alignment != sensors::Alignment::Given {
            let disturbance_e = disturbance_e.copied().unwrap_or_default();
            let aligned = aligned(alignment, earth, (first, state), truth, &disturbance_e, imperfections)?;
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

/// The attitude in which a vehicle was aligned at rest that is in motion and tilted at `first`: level, with its heading. No vehicle rests
/// banked, and an alignment compensates errors of the sensors in its own attitude alone.
fn as_it_rested(
    first: &TruthPoint,
    state: &EarthFixedState,
    truth: &Navigation,
) -> (EarthFixedState, Navigation) {
    let Some(euler) = first.tilted_in_motion() else { return (*state, *truth) };
    let level = attitude_from_euler(&Euler { roll: 0.0, pitch: 0.0, ..euler });
    let turn_n = level * attitude_from_euler(&euler).conjugate();
    let turn_b = truth.q_nb.conjugate() * turn_n * truth.q_nb;
    (
        EarthFixedState { q_eb: state.q_eb * turn_b, ..*state },
        Navigation { q_nb: turn_n * truth.q_nb, ..*truth },
    )
}

/// Result of an alignment at rest at `state`.
fn aligned(
    alignment: sensors::Alignment,
    earth: &Earth,
    (first, state): (&TruthPoint, &EarthFixedState),
    truth: &Navigation,
    disturbance_e: &Vector3<f64>,
    imperfections: &mut Imperfections,
) -> Result<Aligned, Error> {
    let (state, truth) = &as_it_rested(first, state, truth);
    let at_rest = AtRest::new(alignment, earth, state, truth, disturbance_e)?;
    let t = imperfections.set().initial.alignment_s;
    let error_n = |triad: &mut Triad| {
        let error = triad.alignment_error(t, &at_rest.rate_b, &at_rest.force_b, first.temperature_c());
        rotate(&truth.q_nb, &error)
    };
    // For an INS that computes with normal gravity, the disturbance is an error of its accelerometers.
    let force_error_n = error_n(&mut imperfections.accel) - at_rest.disturbance_n;
    Ok(at_rest.aligned(force_error_n, error_n(&mut imperfections.gyro)))
}

/// What an INS senses at rest.
struct AtRest {
    alignment: sensors::Alignment,
    /// Reaction to the gravity that the INS computes [m/s²]; `earth_rate_n`: the Earth's rate [rad/s]; both east-north-up.
    reaction_n: Vector3<f64>,
    earth_rate_n: Vector3<f64>,
    /// True less normal gravity, east-north-up [m/s²].
    disturbance_n: Vector3<f64>,
    /// Outputs of perfect sensors along their axes: `rate_b` [rad/s], `force_b` [m/s²].
    rate_b: Vector3<f64>,
    force_b: Vector3<f64>,
}

impl AtRest {
    fn new(
        alignment: sensors::Alignment,
        earth: &Earth,
        state: &EarthFixedState,
        truth: &Navigation,
        disturbance_e: &Vector3<f64>,
    ) -> Result<Self, Error> {
        let (sin, cos) = sin_cos(truth.place.latitude_rad);
        if alignment == sensors::Alignment::LevelAndGyrocompass && cos < MIN_GYROCOMPASS_COS {
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
        Ok(Self {
            alignment,
            reaction_n: -in_local_axes(&computed_gravity_e),
            earth_rate_n,
            disturbance_n: in_local_axes(disturbance_e),
            rate_b,
            force_b,
        })
    }

    /// Result of the alignment with steady errors of force [m/s²] and rate [rad/s], east-north-up.
    fn aligned(&self, force_error_n: Vector3<f64>, rate_error_n: Vector3<f64>) -> Aligned {
        let force = Sensed { ideal_n: self.reaction_n, error_n: force_error_n };
        match self.alignment {
            sensors::Alignment::LevelAndGyrocompass => {
                level_and_gyrocompass(&force, &Sensed { ideal_n: self.earth_rate_n, error_n: rate_error_n })
            }
            sensors::Alignment::Level | sensors::Alignment::Given => level(&force),
        }
    }

    /// Misalignment per unit of error along each axis, for errors so small that they do not interact [rad]. It is computed by
    /// central differences, which are so small that their third-order term is 1e-10 of them.
    fn gains(&self, aligned: impl Fn(Vector3<f64>) -> Aligned, small: f64) -> Matrix3<f64> {
        Matrix3::from_columns(&[Vector3::x(), Vector3::y(), Vector3::z()].map(|unit| {
            let left = |size: f64| rotation_vector(&aligned(unit * size).rotation);
            (left(-small) - left(small)) / (2.0 * small)
        }))
    }
}

/// Effect of steady errors on an alignment at rest at `state`, the block's own state; `None` without one, and where it is impossible.
pub(super) fn alignment(
    alignment: sensors::Alignment,
    earth: &Earth,
    first: &TruthPoint,
    state: &EarthFixedState,
    truth: &Navigation,
) -> Option<SteadyAlignment> {
    if alignment == sensors::Alignment::Given {
        return None;
    }
    let (state, truth) = &as_it_rested(first, state, truth);
    let at_rest = AtRest::new(alignment, earth, state, truth, &Vector3::zeros()).ok()?;
    let none = Vector3::zeros();
    let share = |ideal_n: &Vector3<f64>, axis: usize| 1e-5 * ideal_n[axis].abs();
    let by_rate = || at_rest.gains(|error_n| at_rest.aligned(none, error_n), share(&at_rest.earth_rate_n, 1));
    Some(SteadyAlignment {
        // Levelling does without the gyros, also at a pole, where the share is 0.
        by_rate: if alignment == sensors::Alignment::Level { Matrix3::zeros() } else { by_rate() },
        by_force: at_rest.gains(|error_n| at_rest.aligned(error_n, none), share(&at_rest.reaction_n, 2)),
        axes: rotation_matrix(&truth.q_nb),
        rate_s: at_rest.rate_b,
        force_s: at_rest.force_b,
    })
}

/// The solution that has the errors `start` relative to `truth`: displaced along east and north at its height, C~ = exp(-φ) C.
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

/// The block at `first`. Its rate is the host's. Without one it is the mean of the first interval, if the interval is known, as in
/// the generator. Otherwise it is the Earth's rate.
pub(super) fn block_at_start(
    parameters: &MountingParameters,
    options: &Options,
    earth: &Earth,
    first: &TruthPoint,
    interval: Option<&Recent<'_>>,
) -> Block {
    Block::new(parameters, options.axes, earth.rate_rad_s, rate_at_start(earth, first, interval))
}

/// Angular rate of the vehicle at `first` relative to inertial space, body axes [rad/s].
pub(super) fn rate_at_start(
    earth: &Earth,
    first: &TruthPoint,
    interval: Option<&Recent<'_>>,
) -> Vector3<f64> {
    let against_earth = interval.map_or(Vector3::zeros(), |recent| {
        let turn = relative_rotation(&first.state.q_eb, &recent.next.state.q_eb);
        rotation_vector(&turn) / recent.next.interval_s
    });
    let earth_rate_b = rotate_inverse(&first.state.q_eb, &Vector3::new(0.0, 0.0, earth.rate_rad_s));
    first.omega_ib_b().unwrap_or(against_earth + earth_rate_b)
}
