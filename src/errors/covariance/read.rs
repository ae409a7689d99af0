//! The covariance of the errors in local terms, from its root.

use nalgebra::{Matrix3, SMatrix, Vector3};

use super::figures::{ErrorEllipse, Matrix9, NavigationCovariance};
use super::root::Root;
use super::sources::{AXES, ErrorInput, RandomErrors, Source};
use crate::earth::state::StateErrors;
use crate::errors::are_linear;
use crate::errors::column::At;
use crate::signal::mounting::Block;
use crate::truth::TruthPoint;

/// The covariance of the reference point at `truth`, where the sensors are those of `block`.
pub(super) fn covariance_of(
    root: &Root,
    at: &At<'_>,
    truth: &TruthPoint,
    block: Option<&Block>,
    parameters: &RandomErrors<'_>,
) -> NavigationCovariance {
    let mut matrix = Matrix9::zeros();
    let mut add = |errors: &StateErrors| {
        let mut column = SMatrix::<f64, 9, 1>::zeros();
        let StateErrors { position_n, velocity_n, misalignment_n } = errors;
        for (first, errors) in [(0, position_n), (3, velocity_n), (6, misalignment_n)] {
            column.fixed_rows_mut::<3>(first).copy_from(errors);
        }
        matrix += column * column.transpose();
    };
    let axes_e = block.map_or(truth.to_earth, |block| {
        truth.to_earth
            * Matrix3::from_columns(
                &[Vector3::x(), Vector3::y(), Vector3::z()].map(|unit| block.in_body_axes(&unit)),
            )
    });
    let t = truth.interval_s;
    // Before the first step the INS has no rate.
    let has_rate = block.is_some() && t > 0.0;
    for (source, sensitivity) in Source::all(parameters).zip(&root.sensitivities) {
        let mut errors = at.errors(sensitivity);
        if let (ErrorInput::Axis(axis @ 0..3), true) = (source.input, has_rate) {
            let (share, _) = parameters.outputs[axis];
            let gyro_e = axes_e.column(axis) * (source.deviation(&root.walks) * share);
            errors.velocity_n += at.in_local_axes(&at.velocity_by_arm(&gyro_e));
        }
        add(&errors);
    }
    root.factor.iter().for_each(|column| add(&at.errors(column)));
    // The noise of the rate of the last interval, times the lever arm.
    for axis in (0..3).filter(|_| has_rate) {
        let (share, of_failure) = parameters.outputs[axis];
        let (density, pulse) = (parameters.gyro.random_walk[axis], parameters.gyro.quantization[axis]);
        let of_sensor = density * density / t + pulse * pulse / (6.0 * t * t);
        let rate = (share * of_sensor + of_failure * of_failure / t).sqrt();
        let velocity_n = at.in_local_axes(&at.velocity_by_arm(&(axes_e.column(axis) * rate)));
        add(&StateErrors { velocity_n, ..StateErrors::NONE });
    }
    // The remainder that quantization carries now.
    for axis in 0..AXES {
        let triad = parameters.of_axis(axis);
        let (share, _) = parameters.outputs[axis];
        let pulse = triad.quantization[axis % 3] * share;
        if pulse != 0.0 {
            let rest_n = at.in_local_axes(&axes_e.column(axis % 3).into_owned()) * (pulse / 12.0f64.sqrt());
            add(&if axis < 3 {
                StateErrors { misalignment_n: rest_n, ..StateErrors::NONE }
            } else {
                StateErrors { velocity_n: rest_n, ..StateErrors::NONE }
            });
        }
    }
    let sum = |rows: [usize; 3]| rows.iter().map(|&row| matrix[(row, row)]).sum::<f64>();
    NavigationCovariance {
        matrix,
        ellipse: ErrorEllipse::new(matrix[(0, 0)], matrix[(1, 1)], matrix[(0, 1)]),
        outside_validity: root.mean_was_beyond || !are_linear(sum([0, 1, 2]), sum([6, 7, 8])),
        without_corrections: false,
    }
}
