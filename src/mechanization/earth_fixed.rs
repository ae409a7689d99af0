//! The navigation-frame part in Earth-fixed axes: regular everywhere, and the navigation axes turn at the constant
//! Earth rate W alone.

use nalgebra::{Quaternion, Vector3};

use super::branches::{gravity, renormalized, series};
use super::limits::MAX_SPEED_M_S;
use super::norm::{MAX_NORM_ERROR, renormalize};
use super::scratch::{AxesRows, Sums};
use super::{BodyMotion, StateDifference, VerticalCorrection};
use crate::base::math::{
    AxisTurn, Compensated, axis_cross, rotate, rotated_z, rotation_increment, rotation_increment_by,
    rotation_matrix,
};
use crate::base::snapshot::stored;
use crate::earth::state::EarthFixedState;
use crate::earth::{Earth, VerticalTrack};

/// Position, velocity and attitude in Earth-fixed axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EarthFixed {
    r_e: Compensated<3>,
    v_e: Compensated<3>,
    /// Components i, j, k, w.
    q_eb: Compensated<4>,
    /// Gravity of the last update [m/s²].
    gravity_e: Vector3<f64>,
    track: VerticalTrack,
}

stored!(EarthFixed { r_e: 1e9, v_e: 1e9, q_eb: 2.0, gravity_e: 1e18, track });

impl EarthFixed {
    /// Whether the distance from the centre is between `low` and `high` [m], and speed and attitude are within their limits.
    #[inline(always)]
    pub fn is_far_within(&self, (low, high): (f64, f64)) -> bool {
        let r2 = self.r_e.value.norm_squared();
        r2 > low * low
            && r2 < high * high
            && self.v_e.value.norm_squared() < MAX_SPEED_M_S * MAX_SPEED_M_S
            && (self.q_eb.value.norm_squared() - 1.0).abs() <= MAX_NORM_ERROR
    }

    /// Starts from `state`.
    pub fn new(earth: &Earth, state: &EarthFixedState) -> Self {
        Self {
            r_e: Compensated::new(state.r_e),
            v_e: Compensated::new(state.v_e),
            q_eb: Compensated::new(state.q_eb.coords),
            gravity_e: earth.gravity(&state.r_e),
            track: earth.track(&state.r_e),
        }
    }

    /// One update of length `t` [s]. W× is the cross product with the Earth rate:
    /// ```text
    /// Δv = C S1 - T W×C(S1 - S2) + T²/6 W×(W×C S1) + T g - 2 W×Δr
    /// Δr = T v + T C S2 - T² W×C S3 + T²/2 g - T²/12 Δg - 2 T W×(r̄ - r)
    /// q  ← q(-W T) q q(Φ)
    /// ```
    /// g is gravity at the mean position r̄ of the update, Δg its change since the update before. The Coriolis integral
    /// is exact: ∫ v dt is Δr.
    pub fn update(&mut self, earth: &Earth, body: &BodyMotion, t: f64) {
        self.update_by::<false>(earth, body, t, &Self::earth_turn(earth, t));
    }

    /// The rotation by which the axes turn back in an update of length `t` [s].
    #[inline]
    pub(super) fn earth_turn(earth: &Earth, t: f64) -> AxisTurn {
        AxisTurn::new(-earth.rate_rad_s * t)
    }

    /// One update with `turn` of [`Self::earth_turn`]. Returns true if the norm of the attitude is left to the caller.
    #[inline(always)]
    pub(super) fn update_by<const BRANCHLESS: bool>(
        &mut self,
        earth: &Earth,
        body: &BodyMotion,
        t: f64,
        turn: &AxisTurn,
    ) -> bool {
        let w = earth.rate_rad_s;
        let (q, v) = (self.q(), self.v_e.value);
        let to_earth = rotation_matrix(&q);
        let (s1, s2, s3) = (to_earth * body.s1, to_earth * body.s2, to_earth * body.s3);

        let dv_gravity_free =
            s1 - axis_cross(w * t, &(s1 - s2)) + earth_cross_twice(w * t, &s1) * (1.0 / 6.0);
        let acceleration_t = s1 + (self.gravity_e - axis_cross(2.0 * w, &v)) * t;
        let to_mean_position = (v * 0.5 + acceleration_t * (1.0 / 6.0)) * t;
        let gravity_e = gravity::<BRANCHLESS>(earth, &(self.r_e.value + to_mean_position));
        let gravity_change = gravity_e - self.gravity_e;

        let dr = (v + s2 - axis_cross(w * t, &s3) + (gravity_e * 0.5 - gravity_change * (1.0 / 12.0)) * t
            - axis_cross(2.0 * w, &to_mean_position))
            * t;
        let dv = dv_gravity_free + gravity_e * t - axis_cross(2.0 * w, &dr);
        let turned = q * rotation_increment_by(&body.rotation, series::<BRANCHLESS>);
        let dq = turned + turn.increment(&(q + turned));
        self.sum_up(&dr, &dv, &dq);
        self.gravity_e = gravity_e;
        renormalized::<BRANCHLESS>(&mut self.q_eb)
    }

    /// One update of the paper's approximations: Φ - Cᵀ W T as the rotation vector, factor I - ½ T W×, Coriolis and
    /// gravity of the start, position by the velocity of the start.
    pub fn update_paper(&mut self, earth: &Earth, body: &BodyMotion, t: f64) {
        let w = earth.rate_rad_s;
        let (q, v) = (self.q(), self.v_e.value);
        let s1 = rotate(&q, &body.s1);
        let gravity_e = earth.gravity(&self.r_e.value);
        let dv = s1 - axis_cross(0.5 * w * t, &s1) + (gravity_e - axis_cross(2.0 * w, &v)) * t;
        let rotation = body.rotation - rotated_z(&q.conjugate()) * (w * t);
        let dq = q * rotation_increment(&rotation);
        self.sum_up(&(v * t), &dv, &dq);
        self.gravity_e = gravity_e;
        self.renormalize();
    }

    #[inline(always)]
    fn sum_up(&mut self, dr: &Vector3<f64>, dv: &Vector3<f64>, dq: &Quaternion<f64>) {
        self.r_e.add(dr);
        self.v_e.add(dv);
        self.q_eb.add(&dq.coords);
    }

    /// Brings the norm of the attitude to 1.
    #[inline]
    pub(super) fn renormalize(&mut self) {
        renormalize(&mut self.q_eb);
    }

    /// The state at `lane` of `rows`.
    #[inline(always)]
    pub(super) fn of_rows(rows: &AxesRows, lane: usize) -> Self {
        let Sums { place, velocity, attitude, acceleration } = Sums::of_rows(rows, lane);
        let track = VerticalTrack::from_numbers([rows[23][lane], rows[24][lane]]);
        Self { r_e: place, v_e: velocity, q_eb: attitude, gravity_e: acceleration, track }
    }

    /// Stores the state at `lane` of `rows`.
    #[inline(always)]
    pub(super) fn put_into(&self, rows: &mut AxesRows, lane: usize) {
        let Self { r_e: place, v_e: velocity, q_eb: attitude, gravity_e: acceleration, track } = *self;
        Sums { place, velocity, attitude, acceleration }.put_into(rows, lane);
        [rows[23][lane], rows[24][lane]] = track.numbers();
    }

    #[inline(always)]
    fn q(&self) -> Quaternion<f64> {
        Quaternion::from(self.q_eb.value)
    }

    /// Up, height above the ellipsoid [m] and velocity up [m/s].
    #[inline(always)]
    pub fn observe_vertical(&mut self, earth: &Earth) -> (Vector3<f64>, f64, f64) {
        let vertical = earth.follow(&mut self.track, &self.r_e.value);
        (vertical.up_e, vertical.height_m, vertical.up_e.dot(&self.v_e.value))
    }

    /// Shifts height [m] and velocity up [m/s] along `up`; the place on the ellipsoid stays. The velocity correction corresponds to
    /// a displacement, whose Coriolis integral and whose part in the turn of the vertical are corrected too.
    #[inline(always)]
    pub fn shift_vertical(&mut self, earth: &Earth, up: &Vector3<f64>, correction: &VerticalCorrection) {
        let mut dv = up * correction.velocity_up_m_s;
        if correction.displacement_m != 0.0 {
            dv -= displaced_vertical(earth, up, &self.v_e.value, correction.displacement_m);
        }
        self.r_e.add(&(up * correction.height_m));
        self.v_e.add(&dv);
    }

    /// Adds `dv_e` [m/s] to the velocity.
    pub fn shift_velocity(&mut self, dv_e: &Vector3<f64>) {
        self.v_e.add(dv_e);
    }

    /// The state less `truth`, rounding carries of the sums included.
    pub fn minus(&self, truth: &EarthFixedState) -> StateDifference {
        StateDifference::new(self.r_e.minus(&truth.r_e), self.v_e.minus(&truth.v_e), &self.q(), truth)
    }

    /// The state.
    pub fn state(&self) -> EarthFixedState {
        EarthFixedState { r_e: self.r_e.value, v_e: self.v_e.value, q_eb: self.q() }
    }
}

/// (2 W + w_en)×up times a `displacement` [m] along `up`: the effect of a wrong velocity up on the horizontal velocity [m/s] at the
/// true velocity `v_e`. The vertical turns at the rate v/a, to 0.3 %.
#[inline]
pub(crate) fn displaced_vertical(
    earth: &Earth,
    up: &Vector3<f64>,
    v_e: &Vector3<f64>,
    displacement: f64,
) -> Vector3<f64> {
    let up_rate = (v_e - up * up.dot(v_e)) / earth.equatorial_radius_m;
    (axis_cross(2.0 * earth.rate_rad_s, up) + up_rate) * displacement
}

/// (0, 0, `w`) × ((0, 0, `w`) × `v`)
#[inline]
fn earth_cross_twice(w: f64, v: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(-w * w * v.x, -w * w * v.y, 0.0)
}
