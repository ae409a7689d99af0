//! Error data 1: the error differential equations (the paper's (4)-(6), misprints corrected), integrated by classical fourth-order
//! Runge-Kutta. The sensor errors that the mechanization receives drive them, and the same vertical channel corrects them.
//!
//! The equations have two forms: Earth-fixed, which no pole disturbs, and geographic, as in the paper.

pub(crate) mod column;
mod earth_fixed;
mod geographic;
mod geometry;
mod lanes;
mod reference_point;
mod sensor_errors;

use nalgebra::Vector3;

use super::NavigationErrors;
use crate::base::math::{euler_from_attitude, rotation_quaternion, wrap_angle};
use crate::base::snapshot::{stored, variants};
use crate::earth::state::{BodyAxes, Navigation, StateErrors};
use crate::earth::{Earth, Vertical};
use crate::mechanization::{Frame, VerticalAid, VerticalCorrection, VerticalLoop};
use crate::signal::mounting::Block;
use crate::signal::{IntervalMotion, MotionNode};
use crate::truth::TruthPoint;
use earth_fixed::EarthFixedForm;
use geographic::GeographicForm;
use geometry::LocalGeometry;
pub(crate) use lanes::{ModelBatch, ModelInterval};
pub use sensor_errors::SensorErrors;

/// Misalignment [rad] and displacement [m] above which the terms that the linear model drops are no longer small:
/// more than 1e-3 of the solution.
pub(crate) const VALID_MISALIGNMENT_RAD: f64 = 0.035;
pub(crate) const VALID_DISPLACEMENT_M: f64 = 100e3;

/// Errors at which the linear model stops [rad, m/s, m]. It grows without limit where a solution turns or diverges.
const LARGEST: f64 = 1e20;

/// Bound of the errors in a snapshot: larger than an interval makes of [`LARGEST`], and its square is finite.
const ERRORS: f64 = 1e140;

/// Whether the model continues with this displacement; false for NaN.
#[inline(always)]
fn is_within(displacement: &Vector3<f64>) -> bool {
    displacement.norm_squared() < LARGEST * LARGEST
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Form {
    EarthFixed(EarthFixedForm),
    Geographic(GeographicForm),
}

variants!(Form { EarthFixed, Geographic });

/// The same of either form.
macro_rules! of_form {
    ($form:expr, $part:ident => $value:expr) => {
        match $form {
            Form::EarthFixed($part) => $value,
            Form::Geographic($part) => $value,
        }
    };
}

/// Errors of attitude, velocity and position, in the terms of the form.
#[inline(always)]
fn states_of(form: &mut Form) -> [&mut Vector3<f64>; 3] {
    of_form!(form, form => form.state())
}

/// The linear error model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorModel {
    earth: Earth,
    form: Form,
    vertical: VerticalLoop,
}

stored!(ErrorModel { form, vertical } rebuilt { earth });

impl ErrorModel {
    /// Starts at the true vertical and velocity `v_e` [m/s] with the errors `start`, in the form that belongs to `frame`.
    pub fn new(
        earth: Earth,
        frame: Frame,
        vertical: &Vertical,
        v_e: &Vector3<f64>,
        start: &StateErrors,
    ) -> Self {
        let local = LocalGeometry::new(&earth, vertical);
        let form = match frame {
            Frame::EarthFixed => Form::EarthFixed(EarthFixedForm::new(&local, v_e, start)),
            Frame::Geographic => Form::Geographic(GeographicForm::new(&local, start)),
        };
        Self { earth, form, vertical: VerticalLoop::new() }
    }

    /// Model with the same errors in local terms at another truth. Each truth is given by its vertical, its velocity `v_e` [m/s]
    /// and whether it is near a pole. Near a pole the errors are expressed in the truth's own axes. Elsewhere they are expressed in
    /// the solution's axes, which the displacement turns about the vertical.
    pub(crate) fn moved(
        &self,
        from: &(Vertical, Vector3<f64>, bool),
        to: &(Vertical, Vector3<f64>, bool),
    ) -> Self {
        let turned =
            |errors: StateErrors, (vertical, v_e, near_pole): &(Vertical, Vector3<f64>, bool), sign: f64| {
                if !near_pole {
                    return errors;
                }
                let local = LocalGeometry::new(&self.earth, vertical);
                let turn = Vector3::z() * (sign * local.rotation_of_axes(&errors.position_n).z);
                StateErrors {
                    velocity_n: errors.velocity_n - turn.cross(&local.in_local_axes(v_e)),
                    misalignment_n: errors.misalignment_n + turn,
                    ..errors
                }
            };
        let local = LocalGeometry::new(&self.earth, &from.0);
        let errors = turned(turned(self.in_local_terms(&local, &from.1), from, -1.0), to, 1.0);
        let frame = match self.form {
            Form::EarthFixed(_) => Frame::EarthFixed,
            Form::Geographic(_) => Frame::Geographic,
        };
        let mut moved =
            Self { vertical: self.vertical, ..Self::new(self.earth, frame, &to.0, &to.1, &errors) };
        moved.keep_within();
        moved
    }

    /// Advances the model over the interval of `motion`, which ends at `truth`, with the sensor errors `errors`. Then corrects the
    /// vertical channel with its aid, as the mechanization does. With a mounting the sensors belong to `block`.
    pub fn advance(
        &mut self,
        motion: &IntervalMotion<'_>,
        truth: &TruthPoint,
        errors: &SensorErrors,
        aid: &VerticalAid,
        block: Option<&Block>,
    ) {
        match block {
            None => self.advance_forms(motion, &motion.nodes(), errors),
            Some(block) => {
                self.advance_forms(motion, &block.nodes(motion), &errors.in_body_axes(block));
            }
        }
        self.correct_vertical(motion.interval_s, truth, aid, block);
        self.keep_within();
    }

    /// Stops the model if the displacement is beyond [`LARGEST`].
    #[inline(always)]
    fn keep_within(&mut self) {
        let [.., displacement] = self.state();
        if !is_within(displacement) {
            self.stop();
        }
    }

    /// Limits the errors to [`LARGEST`] and resets the vertical loop.
    #[cold]
    #[inline(never)]
    fn stop(&mut self) {
        for errors in self.state() {
            // After an overflow an error can be NaN.
            errors.apply(|error| {
                *error = if error.is_nan() { LARGEST } else { error.clamp(-LARGEST, LARGEST) };
            });
        }
        self.vertical = VerticalLoop::new();
    }

    /// Errors of attitude, velocity and position, in the terms of the form.
    #[inline(always)]
    fn state(&mut self) -> [&mut Vector3<f64>; 3] {
        states_of(&mut self.form)
    }

    /// Begins the loop of the vertical channel anew if its estimate is beyond `limit_m_s2`.
    pub(crate) fn limit_vertical_bias(&mut self, limit_m_s2: f64) {
        self.vertical.limit_bias(limit_m_s2);
    }

    /// Corrects the vertical channel over an interval of `t` [s].
    #[inline(always)]
    fn correct_vertical(&mut self, t: f64, truth: &TruthPoint, aid: &VerticalAid, block: Option<&Block>) {
        let correction = match *aid {
            VerticalAid::None => return self.vertical.skip(),
            VerticalAid::Truth { .. } => VerticalCorrection::to_truth(
                -self.height_error(truth, block),
                -self.velocity_up_error(truth, block),
                t,
            ),
            VerticalAid::Barometer { height_m } => {
                let altimeter_error = height_m - truth.height_m();
                self.vertical.correct(self.height_error(truth, block) - altimeter_error, t)
            }
        };
        of_form!(&mut self.form, form => form.shift_vertical(&self.earth, truth, &correction));
    }

    #[inline(always)]
    fn advance_forms(&mut self, motion: &IntervalMotion<'_>, nodes: &[MotionNode; 3], errors: &SensorErrors) {
        let errors_e = motion.to_earth_axes(&errors.nodes());
        of_form!(&mut self.form, form => form.advance(&self.earth, motion.interval_s, nodes, &errors_e));
    }

    fn height_error(&self, truth: &TruthPoint, block: Option<&Block>) -> f64 {
        match block {
            Some(block) => self.of_reference_point(truth, block).position_n.z,
            None => of_form!(&self.form, form => form.height_error(truth)),
        }
    }

    fn velocity_up_error(&self, truth: &TruthPoint, block: Option<&Block>) -> f64 {
        match block {
            Some(block) => self.of_reference_point(truth, block).velocity_n.z,
            None => of_form!(&self.form, form => form.velocity_up_error(&self.earth, truth)),
        }
    }

    /// Errors in local terms, at the true velocity `v_e` [m/s].
    fn in_local_terms(&self, local: &LocalGeometry, v_e: &Vector3<f64>) -> StateErrors {
        of_form!(&self.form, form => form.errors(local, v_e))
    }

    /// Errors of the reference point in local terms. Computes its own geometry, so that the caller's geometry stays in registers.
    #[inline(never)]
    fn state_errors(&self, point: &TruthPoint, block: Option<&Block>) -> StateErrors {
        match block {
            None => {
                self.in_local_terms(&LocalGeometry::new(&self.earth, &point.vertical()), &point.state.v_e)
            }
            Some(block) => self.of_reference_point(point, block),
        }
    }

    /// Errors at the truth `point`, which is `truth` in geographic terms. With the sensors of `block` they are the errors of the
    /// reference point.
    #[inline(always)]
    pub fn errors(
        &self,
        point: &TruthPoint,
        truth: &Navigation,
        axes: BodyAxes,
        block: Option<&Block>,
    ) -> NavigationErrors {
        let local = LocalGeometry::new(&self.earth, &point.vertical());
        let StateErrors { position_n, velocity_n, misalignment_n } = match (&self.form, block) {
            (Form::EarthFixed(form), None) => form.errors(&local, &point.state.v_e),
            _ => self.state_errors(point, block),
        };
        // C~ = (I - [φ×]) C, to first order a rotation by -φ.
        let q_nb = rotation_quaternion(&-misalignment_n) * truth.q_nb;
        let euler = euler_from_attitude(&axes.exchange(&q_nb));
        let change = local.change_of_place(&position_n);
        let displacement = position_n.norm_squared().sqrt();
        let misalignment = misalignment_n.norm_squared().sqrt();
        // Near a pole the local axes turn by the displacement over the distance to the pole, in whatever direction.
        let turn = displacement * local.sin.abs() / (local.n * local.cos);
        NavigationErrors {
            position_n,
            latitude_rad: change.x,
            longitude_rad: change.y,
            velocity_n,
            misalignment_n,
            roll_rad: wrap_angle(euler.roll - truth.euler.roll),
            pitch_rad: euler.pitch - truth.euler.pitch,
            heading_rad: wrap_angle(euler.heading - truth.euler.heading),
            outside_validity: !(displacement < VALID_DISPLACEMENT_M
                && misalignment.max(turn) < VALID_MISALIGNMENT_RAD),
        }
    }
}
