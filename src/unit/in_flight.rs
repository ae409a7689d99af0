//! Alignment in flight, on positions and velocities of another sensor, such as a receiver of satellite navigation.
//!
//! Between two fixes the integral of the specific force f is known twice, in two sets of inertial axes: a from the gyros and
//! accelerometers, in those that the gyros keep, and b from the fixes, in those that the Earth-fixed axes were at the first fix,
//! ```text
//! b = Δ(v + Ω × r) - ∫γ dt          position r, velocity v against the Earth, Earth rate Ω, gravitation γ
//! a = ∫C f dt - Δ C (ω × l)         attitude C of the block, its rate ω, lever arm l from the reference point to the block
//! ```
//! The rotation R between both makes Σ|b - R a|² over all windows as small as possible: it is the orthogonal factor of M = Σ b aᵀ.
//! Turns and changes of speed show the heading; without them the Earth's rotation alone shows it, slowly. With Wₖ = |bₖ|² I - bₖ bₖᵀ of
//! the window around the time tₖ and A = Σ Wₖ, the heading about the vertical u at the time t has the variance
//! ```text
//! s² uᵀ A⁻¹ u + d² |(A⁻¹ Σ tₖ Wₖ - t I)ᵀ u|²
//! ```
//! Roll and pitch have what is left of the traces. s² is that of a component of b, from what R leaves of the sum; d is the drift of the
//! gyros, which turns the axes that they keep. A window counts less the older it is: its weight falls by e in the time in which the drift
//! reaches the limit of the heading. What R leaves of n windows has ν = 3n - 3 degrees of freedom, so the error follows Student's
//! distribution, not the normal one: s is multiplied by the ratio of their quantiles at 3 standard deviations, 2.8 for two windows, 1.6 for
//! three, 1.2 for six.

use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

use super::{AlignmentKind, State, Unit, UnitParameters};
use crate::base::error::{Error, check_range, check_ranges};
use crate::base::math::{exp, rotate, rotate_inverse, rotation_quaternion};
use crate::base::snapshot::{CLOCK_S, SIGNALS, stored};
use crate::base::units::DEG;
use crate::earth::{Earth, Geodetic, navigation_axes};
use crate::errors::covariance::Signals;
use crate::simulator::Simulator;
use crate::truth::TruthPoint;

/// Iterations of the orthogonal factor, for matrices whose singular values differ by up to 1e12.
const ITERATIONS: usize = 60;

/// Longest time behind a fix for which the unit flies on with its velocity; then it lacks a position \[s\].
pub(super) const WITHOUT_FIX_S: f64 = 60.0;

/// Standard deviation of roll and pitch up to which they are shown \[rad\].
const TILT_LIMIT_RAD: f64 = 0.5 * DEG;

/// A fix.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Fix {
    /// Since the first fix \[s\].
    time_s: f64,
    /// Position \[m\] and velocity \[m/s\], Earth-fixed axes.
    r_e: Vector3<f64>,
    v_e: Vector3<f64>,
    /// Velocity \[m/s\] and gravitation \[m/s²\], in inertial axes: the Earth-fixed ones at the first fix.
    velocity_i: Vector3<f64>,
    gravitation_i: Vector3<f64>,
    /// Velocity of the block against the reference point, in the axes that the gyros keep \[m/s\].
    arm_i: Vector3<f64>,
}

stored!(Fix { time_s: CLOCK_S, r_e: SIGNALS, v_e: SIGNALS, velocity_i: SIGNALS, gravitation_i: SIGNALS, arm_i: SIGNALS } then |fix, from| {
    let height = fix.r_e.norm_squared().sqrt();
    from.require(height > 6e6, height, "is below the ground")
});

/// What the windows so far have shown.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Found {
    /// Rotates the axes that the gyros keep to those of the first fix.
    q_ei: Quaternion<f64>,
    heading_sigma_rad: f64,
    /// Of roll and pitch together.
    tilt_sigma_rad: f64,
}

stored!(Found { q_ei: 2.0, heading_sigma_rad: SIGNALS, tilt_sigma_rad: SIGNALS } then |found, from| {
    let size = found.q_ei.norm_squared();
    from.require(size > 0.9, size, "is not of size 1")
});

impl Default for Found {
    fn default() -> Self {
        Self { q_ei: Quaternion::identity(), heading_sigma_rad: 0.0, tilt_sigma_rad: 0.0 }
    }
}

/// An alignment in flight: the present window, and sums over the complete ones.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct InFlight {
    last: Option<Fix>,
    /// Since the first fix, and of it the present window \[s\].
    elapsed_s: f64,
    window_s: f64,
    /// a and b of the present window \[m/s\].
    felt_i: Vector3<f64>,
    expected_i: Vector3<f64>,
    /// Columns of Σ b aᵀ, of A and of Σ t W; Σ(|a|² + |b|²).
    product: [Vector3<f64>; 3],
    shown: [Vector3<f64>; 3],
    moment: [Vector3<f64>; 3],
    squares: f64,
    windows: f64,
    found: Option<Found>,
}

stored!(InFlight {
    last,
    elapsed_s: CLOCK_S,
    window_s: CLOCK_S,
    felt_i: SIGNALS,
    expected_i: SIGNALS,
    product: SIGNALS,
    shown: SIGNALS,
    moment: SIGNALS,
    squares: SIGNALS,
    windows: SIGNALS,
    found
});

impl InFlight {
    /// Times since the first fix and in the present window.
    pub fn clocks(&self) -> [f64; 2] {
        [self.elapsed_s, self.window_s]
    }

    /// Time since the last fix \[s\].
    fn since_fix_s(&self) -> Option<f64> {
        self.last.map(|last| self.elapsed_s - last.time_s)
    }

    pub fn has_fix(&self) -> bool {
        self.since_fix_s().is_some_and(|since_s| since_s <= WITHOUT_FIX_S)
    }

    /// Rotates east-north-up, where the unit should be by now, to the axes that the gyros keep.
    pub fn q_in(&self, earth: &Earth) -> Option<Quaternion<f64>> {
        let (found, last) = (self.found?, self.last?);
        let since_s = self.since_fix_s()?.min(WITHOUT_FIX_S);
        let place = earth.to_geodetic(&(last.r_e + last.v_e * since_s));
        let turned = rotation_quaternion(&(Vector3::z() * (earth.rate_rad_s * self.elapsed_s)));
        Some(found.q_ei.conjugate() * turned * navigation_axes(place.latitude_rad, place.longitude_rad))
    }

    /// Whether the windows show roll and pitch. Where the force has one direction all the time, which is not the vertical, an unknown
    /// heading tilts them.
    pub fn has_attitude(&self) -> bool {
        self.found.is_some_and(|found| found.tilt_sigma_rad <= TILT_LIMIT_RAD)
    }

    /// Whether the heading is as accurate as `parameters` ask.
    pub fn has_heading(&self, parameters: &UnitParameters) -> bool {
        self.found.is_some_and(|found| found.heading_sigma_rad <= parameters.in_flight_heading_rad)
    }

    /// Takes the integral of the specific force over `dt` \[s\].
    pub fn feel(&mut self, velocity_i: &Vector3<f64>, dt: f64) {
        if self.last.is_some() {
            self.felt_i += velocity_i;
            self.elapsed_s += dt;
            self.window_s += dt;
        }
    }

    /// Takes a fix at the end of the last interval, at which the arm moves the block by `arm_i` \[m/s\] and the gyros drift by up to
    /// `drift` \[rad/s\]. Returns whether it ends a window: it does if the window is long enough.
    fn take(
        &mut self,
        earth: &Earth,
        (place, v_n): (&Geodetic, &Vector3<f64>),
        arm_i: Vector3<f64>,
        drift: f64,
        parameters: &UnitParameters,
    ) -> bool {
        let rate = Vector3::z() * earth.rate_rad_s;
        let r_e = earth.to_earth_fixed(place);
        let q_en = navigation_axes(place.latitude_rad, place.longitude_rad);
        let turned = rotation_quaternion(&(rate * self.elapsed_s));
        let v_e = rotate(&q_en, v_n);
        let gravitation_e = earth.gravity(&r_e) + rate.cross(&rate.cross(&r_e));
        let fix = Fix {
            time_s: self.elapsed_s,
            r_e,
            v_e,
            velocity_i: rotate(&turned, &(v_e + rate.cross(&r_e))),
            gravitation_i: rotate(&turned, &gravitation_e),
            arm_i,
        };
        if let Some(last) = self.last.replace(fix) {
            let mean = 0.5 * (fix.gravitation_i + last.gravitation_i);
            self.expected_i += fix.velocity_i - last.velocity_i - mean * (fix.time_s - last.time_s);
            self.felt_i -= fix.arm_i - last.arm_i;
        }
        // The length of a window is a sum of intervals, with their rounding.
        let is_complete =
            self.window_s > 0.0 && self.window_s >= parameters.coarse_alignment_s * (1.0 - 1e-9);
        if is_complete {
            let kept = exp(-self.window_s * drift / parameters.in_flight_heading_rad);
            self.close(&rotate(&(turned * q_en), &Vector3::z()), kept, drift);
        }
        is_complete
    }

    /// Ends the present window, with `up` in the axes of the first fix. Earlier windows count `kept` times as much as before.
    fn close(&mut self, up: &Vector3<f64>, kept: f64, drift: f64) {
        let (felt, expected) = (self.felt_i, self.expected_i);
        let shown = Matrix3::identity() * expected.norm_squared() - expected * expected.transpose();
        let middle_s = self.elapsed_s - 0.5 * self.window_s;
        let add = |sum: &mut [Vector3<f64>; 3], matrix: Matrix3<f64>| {
            sum.iter_mut().zip(matrix.column_iter()).for_each(|(sum, column)| *sum = *sum * kept + column);
        };
        add(&mut self.product, expected * felt.transpose());
        add(&mut self.shown, shown);
        add(&mut self.moment, shown * middle_s);
        self.squares = self.squares * kept + felt.norm_squared() + expected.norm_squared();
        self.windows = self.windows * kept + 1.0;
        (self.felt_i, self.expected_i, self.window_s) = (Vector3::zeros(), Vector3::zeros(), 0.0);
        self.found = self.solve(up, drift);
    }

    fn solve(&self, up: &Vector3<f64>, drift: f64) -> Option<Found> {
        let product = Matrix3::from_columns(&self.product);
        let rotation = orthogonal_factor(&product)?;
        let left = (self.squares - 2.0 * (product * rotation.transpose()).trace()).max(0.0);
        let freedom = 3.0 * self.windows - 3.0;
        let variance = left / freedom * student(freedom) * student(freedom);
        let inverse = Matrix3::from_columns(&self.shown).try_inverse()?;
        let lever = Matrix3::from_columns(&self.moment) * inverse - Matrix3::identity() * self.elapsed_s;
        let drift2 = drift * drift;
        let heading_variance = variance * up.dot(&(inverse * up)) + drift2 * (lever * up).norm_squared();
        let tilt_variance = variance * inverse.trace() + drift2 * lever.norm_squared() - heading_variance;
        let q_ei = *UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(rotation));
        let is_good = self.windows > 1.0 && heading_variance >= 0.0 && q_ei.norm_squared() > 0.9;
        let (heading_sigma_rad, tilt_sigma_rad) = (heading_variance.sqrt(), tilt_variance.max(0.0).sqrt());
        let is_known = heading_sigma_rad < 1e9 && tilt_sigma_rad < 1e9;
        (is_good && is_known).then_some(Found { q_ei, heading_sigma_rad, tilt_sigma_rad })
    }
}

/// The quantile of Student's distribution with `freedom` degrees of freedom that belongs to 3 standard deviations, divided by 3: the
/// expansion of Fisher and Cornish. An estimate of few degrees of freedom is multiplied by it.
fn student(freedom: f64) -> f64 {
    1.0 + (2.5 + (5.75 + 10.0625 / freedom) / freedom) / freedom
}

/// The rotation nearest to `matrix`, which need not be of full rank: its cofactors, added, make up for a direction that was not seen.
/// `None`: the matrix shows one direction at most, or a reflection.
fn orthogonal_factor(matrix: &Matrix3<f64>) -> Option<Matrix3<f64>> {
    let size = matrix.norm_squared().sqrt();
    let unit = matrix / size;
    let mut factor = unit + cofactors(&unit) * 2.0;
    for _ in 0..ITERATIONS {
        let cofactors = cofactors(&factor);
        factor = (factor + cofactors / factor.column(0).dot(&cofactors.column(0))) * 0.5;
    }
    let miss = (factor.transpose() * factor - Matrix3::identity()).norm_squared();
    (miss < 1e-20 && factor.determinant() > 0.0).then_some(factor)
}

/// Determinant times the transposed inverse.
fn cofactors(matrix: &Matrix3<f64>) -> Matrix3<f64> {
    let [a, b, c] = [0, 1, 2].map(|column| matrix.column(column).into_owned());
    Matrix3::from_columns(&[b.cross(&c), c.cross(&a), a.cross(&b)])
}

impl Unit {
    /// Whether an alignment in flight is in progress, or goes on.
    pub(super) fn aligns_in_flight(&self) -> bool {
        self.kind == AlignmentKind::InFlight
            && !self.realigned
            && matches!(self.state, State::CoarseAlignment | State::FineAlignment | State::Ready)
    }

    /// Takes a fix of another sensor: position, and velocity east-north-up \[m/s\], of the reference point of the simulator at the time
    /// of the last update. Other than in an alignment in flight it changes nothing. If it ends the alignment, it corrects the solution of
    /// `simulator`.
    pub fn push_fix(
        &mut self,
        simulator: &mut Simulator,
        place: Geodetic,
        v_n: Vector3<f64>,
    ) -> Result<(), Error> {
        let quarter = core::f64::consts::FRAC_PI_2;
        check_range("fix.latitude_rad", place.latitude_rad, -quarter, quarter)?;
        check_range("fix.longitude_rad", place.longitude_rad, -4.0 * quarter, 4.0 * quarter)?;
        check_range("fix.height_m", place.height_m, -1e5, 1e6)?;
        check_ranges("fix.velocity_enu_m_s", v_n.as_slice(), -1e4, 1e4)?;
        if !self.aligns_in_flight() {
            return Ok(());
        }
        let before = *self;
        let done = self.take_fix(simulator, place, v_n);
        if done.is_err() {
            *self = before;
        }
        done
    }

    fn take_fix(
        &mut self,
        simulator: &mut Simulator,
        place: Geodetic,
        v_n: Vector3<f64>,
    ) -> Result<(), Error> {
        let parameters = self.limits;
        let earth = simulator.options().earth();
        let arm_s = rotate_inverse(&self.q_bs, &simulator.mounting().believed_placement(self.axes).arm_b);
        let rate_s = self.measured.angle / self.interval_s;
        let arm_i = rotate(&self.inertial.q_is, &rate_s.cross(&arm_s));
        let signals = Signals { rate_s: Vector3::zeros(), force_s: self.measured.velocity / self.interval_s };
        let aligned_s = self.alignment.elapsed_s.max(self.interval_s);
        let now_c = simulator.true_point().and_then(TruthPoint::temperature_c);
        let before_s = (self.age_s - aligned_s).max(0.0) + simulator.initial_errors().alignment_s;
        let drift = simulator.mean_rate_error(&signals, aligned_s, [now_c; 2], before_s).at(1.0);
        let in_flight = &mut self.alignment.in_flight;
        if !in_flight.take(&earth, (&place, &v_n), arm_i, drift, &parameters) {
            return Ok(());
        }
        let Some(q_in) = in_flight.q_in(&earth) else { return Ok(()) };
        if self.state == State::CoarseAlignment {
            self.enter(State::FineAlignment);
        }
        if self.is_over_in_flight() && self.alignment.in_flight.has_heading(&parameters) {
            let q_nb = self.attitude_in(&q_in);
            self.settle(&earth, place, v_n, q_nb, simulator)?;
            self.become_ready(simulator);
        }
        Ok(())
    }

    /// Whether an alignment in flight has its least length.
    fn is_over_in_flight(&self) -> bool {
        self.alignment.elapsed_s >= self.limits.in_flight_alignment_s - 0.5 * self.interval_s
    }

    /// Whether an alignment in flight goes on because its heading is not accurate enough.
    pub(super) fn needs_turns(&self) -> bool {
        self.aligns_in_flight()
            && self.state != State::Ready
            && self.is_over_in_flight()
            && !self.alignment.in_flight.has_heading(&self.limits)
    }
}
