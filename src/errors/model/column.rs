//! One column of the linear error model in Earth-fixed axes, with which a covariance is propagated.

use nalgebra::{SVector, Vector3};

use super::earth_fixed::EarthFixedForm;
use super::geometry::LocalGeometry;
use super::{ErrorModel, Form, LARGEST};
use crate::base::math::VectorPair;
use crate::earth::state::StateErrors;
use crate::earth::{Earth, Vertical};
use crate::mechanization::{VerticalCorrection, VerticalLoop, VerticalMode};
use crate::signal::MotionNode;
use crate::signal::mounting::{Block, MountingErrors};
use crate::truth::TruthPoint;

/// ψ [rad], δv [m/s], δr [m] in Earth-fixed axes, then the vertical loop's estimate [m/s²] and last residual [m].
pub(crate) type Column = SVector<f64, 11>;

/// Rows of the two states of the vertical loop in a column.
const LOOP: [usize; 2] = [9, 10];

fn form_of(column: &Column) -> EarthFixedForm {
    let rows = |first| column.fixed_rows::<3>(first).into_owned();
    EarthFixedForm { psi: rows(0), dv: rows(3), dr: rows(6) }
}

fn set_form(column: &mut Column, form: &EarthFixedForm) {
    for (first, rows) in [(0, &form.psi), (3, &form.dv), (6, &form.dr)] {
        column.fixed_rows_mut::<3>(first).copy_from(rows);
    }
}

/// Advances a column by `t` [s] as error data 1 does, without the vertical channel.
pub(crate) fn advance(
    column: &mut Column,
    earth: &Earth,
    t: f64,
    nodes: &[MotionNode; 3],
    errors_e: &[VectorPair; 3],
) {
    let mut form = form_of(column);
    form.advance(earth, t, nodes, errors_e);
    set_form(column, &form);
}

/// Keeps a column within the limits of error data 1, and finite.
pub(crate) fn keep_within(column: &mut Column) {
    column.apply(|error| *error = if error.is_nan() { LARGEST } else { error.clamp(-LARGEST, LARGEST) });
}

/// Moves a column to the truth after a jump: see [`ErrorModel::moved`].
pub(crate) fn moved(
    column: &mut Column,
    earth: &Earth,
    from: &(Vertical, Vector3<f64>, bool),
    to: &(Vertical, Vector3<f64>, bool),
) {
    let form = Form::EarthFixed(form_of(column));
    let model = ErrorModel { earth: *earth, form, vertical: VerticalLoop::new() };
    if let Form::EarthFixed(form) = model.moved(from, to).form {
        set_form(column, &form);
    }
}

/// The truth at which columns are read and corrected.
pub(crate) struct At<'a> {
    pub earth: &'a Earth,
    pub truth: &'a TruthPoint,
    local: LocalGeometry,
    /// Sensor block, and its mounting errors with only the arm kept: all errors of the mounting itself are zero.
    block: Option<(&'a Block, MountingErrors)>,
}

impl<'a> At<'a> {
    pub fn new(earth: &'a Earth, truth: &'a TruthPoint, block: Option<&'a Block>) -> Self {
        let arm_of = |block: &'a Block| {
            let zero = Vector3::zeros();
            let arm =
                MountingErrors { position_b: zero, velocity_b: zero, misalignment_b: zero, ..block.errors() };
            (block, arm)
        };
        let local = LocalGeometry::new(earth, &truth.vertical());
        Self { earth, truth, local, block: block.map(arm_of) }
    }

    /// Column with the errors `start` of the sensors' own state, at the true velocity `v_e` [m/s].
    pub fn column(&self, v_e: &Vector3<f64>, start: &StateErrors) -> Column {
        let mut column = Column::zeros();
        set_form(&mut column, &EarthFixedForm::new(&self.local, v_e, start));
        column
    }

    /// Errors of the reference point in local terms, for a column.
    pub fn errors(&self, column: &Column) -> StateErrors {
        let form = form_of(column);
        match &self.block {
            None => form.errors(&self.local, &self.truth.state.v_e),
            Some((block, arm)) => {
                let model = ErrorModel {
                    earth: *self.earth,
                    form: Form::EarthFixed(form),
                    vertical: VerticalLoop::new(),
                };
                model.of_reference_point_by(self.truth, block, arm)
            }
        }
    }

    /// Velocity error [m/s] of the reference point that the gyro errors `gyro_e` [rad/s] cause by the block's arm, Earth-fixed
    /// axes.
    pub fn velocity_by_arm(&self, gyro_e: &Vector3<f64>) -> Vector3<f64> {
        self.block
            .as_ref()
            .map_or(Vector3::zeros(), |(_, arm)| -gyro_e.cross(&(self.truth.to_earth * arm.arm_b)))
    }

    /// Corrects the vertical channel of a column over a stretch of `t` [s], with an altimeter that shows `altimeter_m` [m] too
    /// much. `channel` is the loop of the previous stretch, and becomes the loop of this stretch. The loop acts every `interval_s`
    /// [s], so that the correction of the velocity has grown over the rest of the stretch.
    ///
    /// Evidence: without this growth an accelerometer bias of 1e-5 g up costs 4 mm in the horizontal by stretches of a second.
    pub fn correct_vertical(
        &self,
        column: &mut Column,
        mode: VerticalMode,
        channel: &mut VerticalLoop,
        altimeter_m: f64,
        (t, interval_s): (f64, f64),
    ) {
        let form = form_of(column);
        let (height_m, up_m_s) = match &self.block {
            None => (form.height_error(self.truth), form.velocity_up_error(self.earth, self.truth)),
            Some(_) => {
                let errors = self.errors(column);
                (errors.position_n.z, errors.velocity_n.z)
            }
        };
        let correction = match mode {
            VerticalMode::Free => return,
            VerticalMode::FollowTruth => VerticalCorrection::to_truth(-height_m, -up_m_s, t),
            VerticalMode::Damped => {
                *channel = channel.with_states(LOOP.map(|row| column[row]));
                let correction = channel.correct(height_m - altimeter_m, t);
                for (row, state) in LOOP.into_iter().zip(channel.states()) {
                    column[row] = state;
                }
                let displacement_m = 0.5 * correction.velocity_up_m_s * (t - interval_s);
                VerticalCorrection { displacement_m, ..correction }
            }
        };
        let mut form = form;
        form.shift_vertical(self.earth, self.truth, &correction);
        set_form(column, &form);
    }

    /// Turns a vector from Earth-fixed axes to east-north-up.
    pub fn in_local_axes(&self, v_e: &Vector3<f64>) -> Vector3<f64> {
        self.local.in_local_axes(v_e)
    }
}
