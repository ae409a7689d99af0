//! Alignment in flight, on positions and velocities of another sensor, such as a receiver of satellite navigation.
//!
//! Between two fixes the integral of the specific force f is known twice, in two sets of inertial axes: a from the gyros and
//! accelerometers, in those that the gyros keep, and b from the fixes, in those that the Earth-fixed axes were at the first fix,
//! ```text
//! b = Δ(v + Ω × r) - ∫γ dt          position r, velocity v against the Earth, Earth rate Ω, gravitation γ
//! ```
//! The rotation C between both makes Σ|b - C a|² over all windows as small as possible: it is the orthogonal factor of M = Σ b aᵀ.
//! Turns and changes of speed show the heading; without them the Earth's rotation alone shows it, slowly. What C leaves of the sum gives
//! the variance s² of a component of b, and with S = Σ b bᵀ and the vertical u the variance of the heading, s² uᵀ (tr S · I - S)⁻¹ u.

use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

use super::{AlignmentKind, State, Unit, UnitParameters};
use crate::earth::{Earth, Geodetic, navigation_axes};
use crate::error::{Error, check_range, check_ranges};
use crate::math::{rotate, rotation_quaternion};
use crate::simulator::Simulator;
use crate::snapshot::{CLOCK_S, SIGNALS, stored};

/// Iterations of the orthogonal factor, for matrices whose singular values differ by up to 1e12.
const ITERATIONS: usize = 60;

/// A fix in inertial axes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Point {
    /// Since the first fix \[s\].
    time_s: f64,
    /// Velocity \[m/s\] and gravitation \[m/s²\].
    velocity_i: Vector3<f64>,
    gravitation_i: Vector3<f64>,
}

stored!(Point { time_s: CLOCK_S, velocity_i: SIGNALS, gravitation_i: SIGNALS });

/// What the windows so far have shown.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Found {
    /// Rotates the axes that the gyros keep to those of the first fix.
    q_ei: Quaternion<f64>,
    /// Rotates east-north-up at the last fix to the axes that the gyros keep.
    q_in: Quaternion<f64>,
    heading_sigma_rad: f64,
}

stored!(Found { q_ei: 2.0, q_in: 2.0, heading_sigma_rad: SIGNALS } then |found, from| {
    let sizes = found.q_ei.norm_squared().min(found.q_in.norm_squared());
    from.require(sizes > 0.9, sizes, "is not of size 1")
});

impl Default for Found {
    fn default() -> Self {
        Self { q_ei: Quaternion::identity(), q_in: Quaternion::identity(), heading_sigma_rad: 0.0 }
    }
}

/// An alignment in flight: the present window, and sums over the complete ones.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct InFlight {
    last: Option<Point>,
    /// Since the first fix, and of it the present window \[s\].
    elapsed_s: f64,
    window_s: f64,
    /// a and b of the present window \[m/s\].
    felt_i: Vector3<f64>,
    expected_i: Vector3<f64>,
    /// Columns of Σ b aᵀ, and Σ(|a|² + |b|²).
    product: [Vector3<f64>; 3],
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
    squares: SIGNALS,
    windows: SIGNALS,
    found
});

impl InFlight {
    pub fn has_fix(&self) -> bool {
        self.last.is_some()
    }

    /// Rotates east-north-up at the last fix to the axes that the gyros keep.
    pub fn q_in(&self) -> Option<Quaternion<f64>> {
        self.found.map(|found| found.q_in)
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

    /// Takes a fix at the end of the last interval. A window ends with the first fix after `shortest_s` \[s\].
    fn take(&mut self, earth: &Earth, place: &Geodetic, v_n: &Vector3<f64>, shortest_s: f64) {
        let rate = Vector3::z() * earth.rate_rad_s;
        let r_e = earth.to_earth_fixed(place);
        let q_en = navigation_axes(place.latitude_rad, place.longitude_rad);
        let turned = rotation_quaternion(&(rate * self.elapsed_s));
        let gravitation_e = earth.gravity(&r_e) + rate.cross(&rate.cross(&r_e));
        let point = Point {
            time_s: self.elapsed_s,
            velocity_i: rotate(&turned, &(rotate(&q_en, v_n) + rate.cross(&r_e))),
            gravitation_i: rotate(&turned, &gravitation_e),
        };
        let q_en = turned * q_en;
        if let Some(last) = self.last.replace(point) {
            let mean = 0.5 * (point.gravitation_i + last.gravitation_i);
            self.expected_i += point.velocity_i - last.velocity_i - mean * (point.time_s - last.time_s);
        }
        if self.window_s > 0.0 && self.window_s >= shortest_s {
            self.close(&rotate(&q_en, &Vector3::z()));
        }
        if let Some(found) = &mut self.found {
            found.q_in = found.q_ei.conjugate() * q_en;
        }
    }

    /// Ends the present window, with `up` in the axes of the first fix.
    fn close(&mut self, up: &Vector3<f64>) {
        let (felt, expected) = (self.felt_i, self.expected_i);
        for (column, of_felt) in self.product.iter_mut().zip(felt.iter()) {
            *column += expected * *of_felt;
        }
        self.squares += felt.norm_squared() + expected.norm_squared();
        self.windows += 1.0;
        (self.felt_i, self.expected_i, self.window_s) = (Vector3::zeros(), Vector3::zeros(), 0.0);
        self.found = self.solve(up);
    }

    fn solve(&self, up: &Vector3<f64>) -> Option<Found> {
        let product = Matrix3::from_columns(&self.product);
        let rotation = orthogonal_factor(&product)?;
        let seen = product * rotation.transpose();
        let left = (self.squares - 2.0 * seen.trace()).max(0.0);
        let variance = left / (3.0 * self.windows - 3.0);
        let symmetric = 0.5 * (seen + seen.transpose());
        let shown = (Matrix3::identity() * seen.trace() - symmetric).try_inverse()?;
        let heading_variance = variance * up.dot(&(shown * up));
        let rotation = Rotation3::from_matrix_unchecked(rotation);
        let q_ei = *UnitQuaternion::from_rotation_matrix(&rotation);
        let is_good = self.windows > 1.0 && heading_variance >= 0.0 && q_ei.norm_squared() > 0.9;
        let heading_sigma_rad = heading_variance.sqrt();
        (is_good && heading_sigma_rad < 1.0).then_some(Found { q_ei, heading_sigma_rad, ..Found::default() })
    }
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
        let in_flight = &mut self.alignment.in_flight;
        in_flight.take(&earth, &place, &v_n, parameters.coarse_alignment_s);
        let Some(q_in) = in_flight.q_in() else { return Ok(()) };
        if self.state == State::CoarseAlignment {
            self.enter(State::FineAlignment);
        }
        let is_over = self.alignment.elapsed_s >= parameters.in_flight_alignment_s - 0.5 * self.interval_s;
        self.reasons.turns_needed = is_over && !self.alignment.in_flight.has_heading(&parameters);
        if !is_over || self.reasons.turns_needed {
            return Ok(());
        }
        let q_nb = q_in.conjugate() * self.inertial.q_is * self.q_bs.conjugate();
        self.settle(&earth, place, v_n, q_nb, simulator)?;
        self.become_ready();
        Ok(())
    }
}
