//! Errors that the fit has only if it is asked for them, or never, and else takes for misalignments: a lever arm or a delay of the
//! accelerometers, and gyros that sense forces. The rows of the fit are solved again with columns of them, beside bias and signals of each
//! sensor.

use nalgebra::{SMatrix, SVector, Vector3};

use super::Also;
use super::parameter::Place;
use super::solve::Fitted;
use super::whiten::{Columns, Steps};
use crate::base::error::{Error, Rule};
use crate::base::math::hypot;
use crate::base::memory::room;
use crate::base::records::rounded;

/// Coefficients of one sensor that are solved for again, bias and the three signals; and more columns: three components, and the change
/// by a shift of the clock.
const OWN: usize = 4;
const MORE: usize = 4;
const CLOCK: usize = 3;

/// Size of what is beyond the model from which it is shown, in standard deviations: 48 records without it had at most 2.7 of one column.
const SHOWN: f64 = 10.0;

/// Least part of the residual of the forces that a lever arm and a delay explain if they are its cause.
const EXPLAINS: f64 = 0.8;
/// Least delay that is shown beside a lever arm [s]: a path has the force of the arm but for what it lacks of changes of the rates.
const LEAST_S: f64 = 1e-3;

type Row = [f64; 1 + OWN + MORE];

/// Rejects a record whose accelerometers are away from the point of the path, or on another clock than the gyros; of another error `cause`
/// says what it may come from, unless a lever arm or a delay explains what is left of the forces. Returns the mean g-sensitivity of the
/// gyros [rad/s per m/s²], if they show one.
pub(super) fn check_beyond(
    fitted: &Fitted,
    also: Also,
    cause: impl Fn(Error) -> Error,
) -> Result<Option<f64>, Error> {
    let steps = Steps::new(&fitted.rows.blocks)?;
    let rows = &fitted.rows.of_sensor;
    let mut accelerometers = Again::<{ 3 * OWN + MORE }>::new();
    for axis in 0..3 {
        let more = |row: usize| {
            let [.., x, y, z, _, _] = rows[3 + axis][row];
            [x, y, z, rows[3 + axis][row][5]]
        };
        accelerometers.add(&whitened(fitted, &steps, 3 + axis, more)?, axis * OWN, 3 * OWN);
    }
    let Some(([common, sigmas], explained)) = accelerometers.solved(3 * OWN) else { return Ok(None) };
    let shown = |error: Error| if explained > EXPLAINS { error } else { cause(error) };
    // The clock of the fit is between those of both.
    let (mut weights, mut gyros_s, mut sensed, mut square) = (0.0, 0.0, 0.0, 0.0);
    for (axis, of_gyro) in rows.iter().enumerate().take(3) {
        let more = |row: usize| {
            let [.., x, y, z, _, _] = of_gyro[row];
            [x, y, z, of_gyro[row][5]]
        };
        let mut gyro = Again::<{ OWN + MORE }>::new();
        gyro.add(&whitened(fitted, &steps, axis, more)?, 0, OWN);
        let Some(([found, sigmas], _)) = gyro.solved(OWN) else { continue };
        let weight = 1.0 / (sigmas[CLOCK] * sigmas[CLOCK]);
        weights += weight;
        gyros_s += weight * found[CLOCK];
        sensed += (0..3).map(|k| found[k] * found[k]).sum::<f64>();
        square += (0..3).map(|k| found[k] / sigmas[k]).map(|beside| beside * beside).sum::<f64>();
    }
    let late_s = if weights > 0.0 { gyros_s / weights } else { 0.0 } - common[CLOCK];
    let least_s = if also.lever_arm { LEAST_S } else { 0.0 };
    if late_s.abs() > (SHOWN * hypot(sigmas[CLOCK], weights.sqrt().recip())).max(least_s) {
        let rule = Rule::Sentence(
            "seconds by which the accelerometers are later than the gyros, which would be taken for misalignments: give both the same clock",
        );
        return Err(shown(Error::invalid("record.velocity_delay_s", rounded(late_s, 3), rule)));
    }
    let lever = Vector3::new(common[0], common[1], common[2]);
    let beside = Vector3::from_fn(|k, _| common[k] / sigmas[k]);
    if beside.norm() > SHOWN && !also.lever_arm {
        let rule = Rule::SentenceWith(
            "distance of the accelerometers from the point of the path [m], which would be taken for misalignments: give the path of their \
             place. It is shown by standard deviations:",
            rounded(beside.norm(), 2).into(),
        );
        return Err(shown(Error::invalid("record.lever_arm_m", rounded(lever.norm(), 2), rule)));
    }
    Ok((square.sqrt() > SHOWN && !also.g_sensitivity).then(|| (sensed / 3.0).sqrt()))
}

/// Residual, own columns and more columns of the rows of a sensor, as independent numbers of deviation 1.
fn whitened(
    fitted: &Fitted,
    steps: &Steps,
    sensor: usize,
    more: impl Fn(usize) -> [f64; MORE],
) -> Result<Vec<Row>, Error> {
    let evidence = &fitted.evidences[sensor];
    let filter = steps.filter(evidence.shape)?;
    let solved = Place::coefficients(sensor, &fitted.solution[0].0);
    let size = 1.0 / evidence.square.sqrt();
    let rows = &fitted.rows.of_sensor[sensor];
    let mut columns: Vec<Columns> = room(rows.len())?;
    columns.extend(rows.iter().enumerate().map(|(place, row)| {
        let explained: f64 = solved.iter().zip(&row[1..]).map(|(c, column)| c * column).sum();
        let [a, b, c, d] = more(place);
        [row[0] - explained, row[1], row[2], row[3], row[4], a, b, c, d, 0.0, 0.0, 0.0]
    }));
    let mut white: Vec<Row> = room(rows.len())?;
    filter.whiten(&columns, |_, own| white.push(core::array::from_fn(|k| own[k] * size)));
    Ok(white)
}

/// Normal equations of rows that are solved again.
struct Again<const N: usize> {
    normal: SMatrix<f64, N, N>,
    side: SVector<f64, N>,
    squares: f64,
}

impl<const N: usize> Again<N> {
    fn new() -> Self {
        Self { normal: SMatrix::zeros(), side: SVector::zeros(), squares: 0.0 }
    }

    /// Adds rows whose own coefficients begin at place `own`, and the others at `more`.
    fn add(&mut self, rows: &[Row], own: usize, more: usize) {
        let place = |k: usize| if k < OWN { own + k } else { more + k - OWN };
        for row in rows {
            self.squares += row[0] * row[0];
            for i in 0..OWN + MORE {
                self.side[place(i)] += row[1 + i] * row[0];
                for j in 0..OWN + MORE {
                    self.normal[(place(i), place(j))] += row[1 + i] * row[1 + j];
                }
            }
        }
    }

    /// The coefficients from place `from` on and their standard deviations, and the part of the residual that all explain; `None`: the
    /// motion does not tell them from the others.
    fn solved(&self, from: usize) -> Option<([[f64; MORE]; 2], f64)> {
        let scale: SVector<f64, N> = self.normal.diagonal().map(|value| 1.0 / value.sqrt());
        let scaled = SMatrix::<f64, N, N>::from_fn(|i, j| self.normal[(i, j)] * scale[i] * scale[j]);
        let inverse = scaled.cholesky()?.inverse();
        let found = (inverse * self.side.component_mul(&scale)).component_mul(&scale);
        let sigma = |k: usize| inverse[(from + k, from + k)].sqrt() * scale[from + k];
        let sigmas: [f64; MORE] = core::array::from_fn(sigma);
        let explained = self.side.dot(&found) / self.squares;
        let both = [core::array::from_fn(|k| found[from + k]), sigmas];
        sigmas.iter().all(|sigma| sigma.is_finite()).then_some((both, explained))
    }
}
