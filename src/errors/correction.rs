//! Corrections by the host: errors that the host estimated, and that the INS removes from its solution and from its sensors.

use nalgebra::{Quaternion, Vector3};

use crate::base::error::{Error, Rule, check_ranges};
use crate::base::math::{atan2, hypot, rotate, rotate_inverse, rotation_quaternion, sin_cos};
use crate::base::snapshot::{ANY, stored};
use crate::earth::state::{EarthFixedState, StateErrors};
use crate::earth::{Earth, Geodetic, navigation_axes};
use crate::signal::Increment;

/// Compensation of the measured increments: s = (s~ - b dt) / (1 + k), axis by axis, with the measured increment s~, the bias b and
/// the scale factor error k. All zero: the INS navigates on the measured increments.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Compensation {
    /// Gyro bias [rad/s].
    pub gyro_bias: Vector3<f64>,
    /// Scale factor error of the gyros \[1\].
    pub gyro_scale_factor: Vector3<f64>,
    /// Accelerometer bias [m/s²].
    pub accel_bias: Vector3<f64>,
    /// Scale factor error of the accelerometers \[1\].
    pub accel_scale_factor: Vector3<f64>,
}

stored!(Compensation { gyro_bias: ANY, gyro_scale_factor: ANY, accel_bias: ANY, accel_scale_factor: ANY }
    then |compensation, _| compensation.validate());

impl Compensation {
    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        let Self { gyro_bias, gyro_scale_factor, accel_bias, accel_scale_factor } = self;
        check_ranges("compensation.gyro_bias_rad_s", gyro_bias.as_slice(), -100.0, 100.0)?;
        check_ranges("compensation.gyro_scale_factor", gyro_scale_factor.as_slice(), -0.5, 0.5)?;
        check_ranges("compensation.accel_bias_m_s2", accel_bias.as_slice(), -1e4, 1e4)?;
        check_ranges("compensation.accel_scale_factor", accel_scale_factor.as_slice(), -0.5, 0.5)
    }

    /// Sum of both compensations; `None`: all zero.
    pub(crate) fn sum(of: Option<&Self>, added: &Self) -> Result<Option<Self>, Error> {
        let of = of.copied().unwrap_or_default();
        let sum = Self {
            gyro_bias: of.gyro_bias + added.gyro_bias,
            gyro_scale_factor: of.gyro_scale_factor + added.gyro_scale_factor,
            accel_bias: of.accel_bias + added.accel_bias,
            accel_scale_factor: of.accel_scale_factor + added.accel_scale_factor,
        };
        sum.validate()?;
        Ok((sum != Self::default()).then_some(sum))
    }

    /// Compensates `increments`, each over `dt` [s]. Returns their sum before.
    #[cold]
    #[inline(never)]
    pub(crate) fn apply(&self, increments: &mut [Increment], dt: f64) -> Increment {
        let measured = Increment::sum(increments);
        for Increment { angle, velocity } in increments {
            for axis in 0..3 {
                angle[axis] =
                    (angle[axis] - self.gyro_bias[axis] * dt) / (1.0 + self.gyro_scale_factor[axis]);
                velocity[axis] =
                    (velocity[axis] - self.accel_bias[axis] * dt) / (1.0 + self.accel_scale_factor[axis]);
            }
        }
        measured
    }
}

/// Errors that the host wants removed. All zero changes nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Correction {
    /// Errors of the solution, in the definitions of [`NavigationErrors`](crate::errors::NavigationErrors), of any size.
    pub errors: StateErrors,
    /// Errors of the sensors. They are added to the compensation in force.
    pub sensors: Compensation,
}

impl Default for Correction {
    fn default() -> Self {
        Self { errors: StateErrors::NONE, sensors: Compensation::default() }
    }
}

impl Correction {
    /// Checks the errors of the solution. The sum of the compensations is checked when it is known.
    pub fn validate(&self) -> Result<(), Error> {
        let StateErrors { position_n, velocity_n, misalignment_n } = &self.errors;
        let pi = core::f64::consts::PI;
        check_ranges("correction.position_enu_m", position_n.as_slice(), -1e6, 1e6)?;
        check_ranges("correction.velocity_enu_m_s", velocity_n.as_slice(), -1e4, 1e4)?;
        check_ranges("correction.misalignment_enu_rad", misalignment_n.as_slice(), -pi, pi)
    }

    /// The state from which `state` has the errors of this correction.
    ///
    /// Each state has its velocity and its attitude in its own axes east-north-up: v = v~ - δv, C = exp([φ×]) C~.
    pub(crate) fn corrected(&self, earth: &Earth, state: &EarthFixedState) -> Result<EarthFixedState, Error> {
        let StateErrors { position_n, velocity_n, misalignment_n } = &self.errors;
        let place = earth.to_geodetic(&state.r_e);
        let axes = navigation_axes(place.latitude_rad, place.longitude_rad);
        let v_n = rotate_inverse(&axes, &state.v_e) - velocity_n;
        let q_nb = rotation_quaternion(misalignment_n) * (axes.conjugate() * state.q_eb);
        let at = |place: &Geodetic, r_e: Vector3<f64>| {
            let axes = navigation_axes(place.latitude_rad, place.longitude_rad);
            let q_eb = axes * q_nb;
            EarthFixedState { r_e, v_e: rotate(&axes, &v_n), q_eb: q_eb / q_eb.norm_squared().sqrt() }
        };
        if *position_n == Vector3::zeros() {
            return Ok(at(&place, state.r_e));
        }
        // Near a pole two places can have these errors. The place that turns the attitude less is meant.
        let turn = |state_before: &EarthFixedState| -dot(&state_before.q_eb, &state.q_eb).abs();
        places(earth, &place, &state.r_e, position_n)
            .into_iter()
            .flatten()
            .map(|place| at(&place, earth.to_earth_fixed(&place)))
            .min_by(|one, other| turn(one).total_cmp(&turn(other)))
            .ok_or_else(|| {
                let size = position_n.norm_squared().sqrt();
                let rule =
                    Rule::Sentence("cannot be removed: so near a pole, no place has this displacement");
                Error::invalid("correction.position_enu_m", size, rule)
            })
    }
}

fn dot(p: &Quaternion<f64>, q: &Quaternion<f64>) -> f64 {
    p.w * q.w + p.i * q.i + p.j * q.j + p.k * q.k
}

/// Places from which `place`, at `r_e` [m], is displaced by `position_n` [m] along their east and north, at a height difference.
///
/// East of a place is normal to its meridian plane, so r·east = δE gives the longitude. In that plane r = (m, z), m² + δE² = x² + y²,
/// and r·north = δN is an equation of the latitude L alone, N the radius of the prime vertical:
/// ```text
/// z cos L - m sin L + N e² sin L cos L = δN
/// ```
fn places(
    earth: &Earth,
    place: &Geodetic,
    r_e: &Vector3<f64>,
    position_n: &Vector3<f64>,
) -> [Option<Geodetic>; 2] {
    // A place beyond the axis or the pole by rounding is on it.
    const ROUNDING_M: f64 = 1e-8;
    const ROUNDING_RAD: f64 = ROUNDING_M / 6e6;
    let (east_m, north_m) = (position_n.x, position_n.y);
    let p = hypot(r_e.x, r_e.y);
    let m2 = (p - east_m) * (p + east_m);
    if east_m.abs() > p + ROUNDING_M {
        return [None; 2];
    }
    let quarter = core::f64::consts::FRAC_PI_2;
    [1.0, -1.0].map(|side| {
        let m = side * m2.max(0.0).sqrt();
        let mut latitude = atan2(r_e.z, m);
        for _ in 0..8 {
            let (sin, cos) = sin_cos(latitude);
            let bulge = earth.radii(sin).transverse_m * earth.eccentricity2;
            let miss = r_e.z * cos - m * sin + bulge * sin * cos - north_m;
            latitude += miss / (r_e.z * sin + m * cos - bulge * (cos * cos - sin * sin));
        }
        (latitude.abs() <= quarter + ROUNDING_RAD).then(|| Geodetic {
            latitude_rad: latitude.clamp(-quarter, quarter),
            longitude_rad: place.longitude_rad - atan2(east_m, m),
            height_m: place.height_m - position_n.z,
        })
    })
}
