//! Error data 1: the error differential equations (the paper's (4)-(6), misprints mended), by classical fourth-order
//! Runge-Kutta, driven by the sensor errors that the mechanization receives and kept by the same vertical channel.
//!
//! Two forms of the same equations: Earth-fixed, which no pole disturbs, and the paper's geographic one.

pub(crate) mod column;
mod earth_fixed;
mod geographic;
mod geometry;
mod lanes;
mod reference_point;
mod sensor_errors;

use nalgebra::Vector3;

use super::NavigationErrors;
use crate::earth::{Earth, Vertical};
use crate::math::{euler_from_attitude, rotation_quaternion, wrap_angle};
use crate::mechanization::{Frame, VerticalAid, VerticalCorrection, VerticalLoop};
use crate::mounting::Block;
use crate::signal::{IntervalMotion, MotionNode};
use crate::snapshot::{stored, variants};
use crate::state::{BodyAxes, Navigation, StateErrors};
use crate::truth::TruthPoint;
use earth_fixed::EarthFixedForm;
use geographic::GeographicForm;
use geometry::LocalGeometry;
pub(crate) use lanes::{ModelBlock, ModelInterval};
pub use sensor_errors::SensorErrors;

/// Misalignment [rad] and displacement [m] beyond which the terms that the linear model drops are no longer small:
/// 1e-3 of the solution.
pub(crate) const VALID_MISALIGNMENT_RAD: f64 = 0.035;
pub(crate) const VALID_DISPLACEMENT_M: f64 = 100e3;

/// Errors at which the linear model stops [rad, m/s, m]: it goes on to grow where a solution turns or diverges.
const LARGEST: f64 = 1e20;

/// For errors that a snapshot has: more than an interval makes of [`LARGEST`], with squares that are finite.
const ERRORS: f64 = 1e140;

/// Whether a displacement is one that the model goes on with; of no number it is not.
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

    /// The same errors in local terms at another truth; each is given by its vertical, its velocity `v_e` [m/s] and whether it
    /// is near a pole. There they are told in the truth's own axes, those elsewhere in the solution's, which are turned about the
    /// vertical by the displacement.
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

    /// Over the interval of `motion`, which ends at `truth`, with the sensor errors `errors`; then the vertical channel as
    /// the mechanization has it, with its aid. The sensors are those of `block` where there is a mounting.
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

    /// Stops where the errors are beyond [`LARGEST`].
    #[inline(always)]
    fn keep_within(&mut self) {
        let [.., displacement] = self.state();
        if !is_within(displacement) {
            self.stop();
        }
    }

    /// Keeps the errors within [`LARGEST`].
    #[cold]
    #[inline(never)]
    fn stop(&mut self) {
        for errors in self.state() {
            // Out of an overflow it can be no number.
            errors.apply(|error| {
                *error = if error.is_nan() { LARGEST } else { error.clamp(-LARGEST, LARGEST) };
            });
        }
        self.vertical = VerticalLoop::new();
    }

    /// Errors of attitude, velocity and position, in the terms of the form.
    #[inline(always)]
    fn state(&mut self) -> [&mut Vector3<f64>; 3] {
        match &mut self.form {
            Form::EarthFixed(form) => form.state(),
            Form::Geographic(form) => form.state(),
        }
    }

    /// Keeps the vertical channel over an interval of `t` [s].
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
        match &mut self.form {
            Form::EarthFixed(form) => form.shift_vertical(&self.earth, truth, &correction),
            Form::Geographic(form) => form.shift_vertical(&self.earth, truth, &correction),
        }
    }

    #[inline(always)]
    fn advance_forms(&mut self, motion: &IntervalMotion<'_>, nodes: &[MotionNode; 3], errors: &SensorErrors) {
        let errors_e = motion.to_earth_axes(&errors.nodes());
        match &mut self.form {
            Form::EarthFixed(form) => form.advance(&self.earth, motion.interval_s, nodes, &errors_e),
            Form::Geographic(form) => form.advance(&self.earth, motion.interval_s, nodes, &errors_e),
        }
    }

    fn height_error(&self, truth: &TruthPoint, block: Option<&Block>) -> f64 {
        match (&self.form, block) {
            (_, Some(block)) => self.of_reference_point(truth, block).position_n.z,
            (Form::EarthFixed(form), None) => form.height_error(truth),
            (Form::Geographic(form), None) => form.height_error(),
        }
    }

    fn velocity_up_error(&self, truth: &TruthPoint, block: Option<&Block>) -> f64 {
        match (&self.form, block) {
            (_, Some(block)) => self.of_reference_point(truth, block).velocity_n.z,
            (Form::EarthFixed(form), None) => form.velocity_up_error(&self.earth, truth),
            (Form::Geographic(form), None) => form.velocity_up_error(),
        }
    }

    /// In local terms, at the true velocity `v_e` [m/s].
    fn in_local_terms(&self, local: &LocalGeometry, v_e: &Vector3<f64>) -> StateErrors {
        match &self.form {
            Form::EarthFixed(form) => form.errors(local, v_e),
            Form::Geographic(form) => form.errors(local),
        }
    }

    /// In local terms, of the reference point. It has its own geometry: that of the caller stays in registers.
    #[inline(never)]
    fn state_errors(&self, point: &TruthPoint, block: Option<&Block>) -> StateErrors {
        match block {
            None => {
                self.in_local_terms(&LocalGeometry::new(&self.earth, &point.vertical()), &point.state.v_e)
            }
            Some(block) => self.of_reference_point(point, block),
        }
    }

    /// The errors at the truth `point`, which is `truth` in geographic terms; of the reference point, where the sensors are
    /// those of `block`.
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
        // Near a pole the local axes turn by the displacement over the distance to it, whatever its direction.
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
