//! The root of the covariance from the start of a stretch to its end.

use nalgebra::{Matrix3, SMatrix, Vector3};

use super::alignment::field_e;
use super::factor::{ROWS, triangularize};
use super::propagation::Root;
use super::sources::{AXES, COUNT, ELEMENTS, Input, Kind, Parameters, Source};
use super::stretch::Stretch;
use crate::earth::Earth;
use crate::errors::column::{At, Column, advance, keep_within};
use crate::math::VectorPair;
use crate::mechanization::{VerticalLoop, VerticalMode};
use crate::truth::TruthPoint;

/// From the start of a stretch to its end.
pub(super) struct Passage<'a> {
    pub earth: &'a Earth,
    pub vertical: VerticalMode,
    pub stretch: &'a Stretch,
    pub at: &'a At<'a>,
    pub truth: &'a TruthPoint,
}

/// What errors of 1 over the stretch make of x.
struct Responses {
    /// By constant errors of the axes, and by such as go from -1/2 to 1/2.
    constant: [Column; AXES],
    sloping: [Column; AXES],
    altimeter: Column,
}

impl Passage<'_> {
    pub fn go(&self, root: &mut Root, work: &mut [Column], parameters: &Parameters<'_>) {
        let t = self.stretch.length_s;
        let times = (t, t / self.stretch.intervals as f64);
        let is_aided = self.vertical != VerticalMode::Damped || self.stretch.aided > 0;
        let mode = if is_aided { self.vertical } else { VerticalMode::Free };
        let mut channel = root.channel;
        let (nodes, axes) = self.stretch.lines();
        let zero = VectorPair::both(&Vector3::zeros());
        let over = |column: &Column, errors_e: &[VectorPair; 3], channel: &mut VerticalLoop| {
            let mut column = *column;
            advance(&mut column, self.earth, t, &nodes, errors_e);
            self.at.correct_vertical(&mut column, mode, channel, 0.0, times);
            column
        };

        // The transition, by unit columns.
        let before = root.channel;
        let mut transition = SMatrix::<f64, ROWS, ROWS>::zeros();
        for row in 0..ROWS {
            let mut unit = Column::zeros();
            unit[row] = 1.0;
            channel = before;
            transition.set_column(row, &over(&unit, &[zero; 3], &mut channel));
        }
        let alone = |errors_e: &[VectorPair; 3]| over(&Column::zeros(), errors_e, &mut { before });
        let steady = |gyro: Vector3<f64>, accel: Vector3<f64>| [VectorPair::new(&gyro, &accel); 3];

        let none = Vector3::zeros();
        let errors_of = |axis: usize, shares: [f64; 3]| -> [VectorPair; 3] {
            core::array::from_fn(|node| {
                let vector = axes[node].column(axis % 3) * shares[node];
                if axis < 3 { VectorPair::new(&vector, &none) } else { VectorPair::new(&none, &vector) }
            })
        };
        let mut altimeter = Column::zeros();
        self.at.correct_vertical(&mut altimeter, mode, &mut { before }, 1.0, times);
        let responses = Responses {
            constant: core::array::from_fn(|axis| alone(&errors_of(axis, [1.0; 3]))),
            sloping: core::array::from_fn(|axis| alone(&errors_of(axis, [-0.5, 0.0, 0.5]))),
            altimeter,
        };

        // The root.
        let mut used = 0;
        let mut take = |column: Column| {
            work[used] = column;
            used += 1;
        };
        root.factor.iter().for_each(|column| take(transition * column));

        // The processes.
        let mut own = [0.0f64; AXES];
        for place in 0..COUNT {
            let source = Source::at(place, parameters);
            let sensitivity = &mut root.sensitivities[place];
            if source.sigma == 0.0 && *sensitivity == Column::zeros() {
                if let (Input::Axis(axis), Kind::Walk(_)) = (source.input, source.kind) {
                    root.walks[axis] = 0.0;
                }
                continue;
            }
            let walk = match source.input {
                Input::Axis(axis) => &mut root.walks[axis],
                _ => &mut 0.0,
            };
            let step = source.advance(t, self.stretch.ground_m, walk);
            let led = transition * *sensitivity;
            if source.input == Input::Altimeter {
                // The altimeter is read at the end.
                let (decay, diffusion) = (step.decay, step.diffusion);
                *sensitivity = led * decay + responses.altimeter * source.sigma;
                take(led * diffusion);
                continue;
            }
            let by_one = match source.input {
                Input::Axis(axis) => responses.constant[axis],
                Input::Element(element) => {
                    let is_gyro = element < ELEMENTS / 2;
                    let pair = |vector: Vector3<f64>| {
                        if is_gyro {
                            VectorPair::new(&vector, &none)
                        } else {
                            VectorPair::new(&none, &vector)
                        }
                    };
                    alone(&self.stretch.by_element(element).map(pair))
                }
                // To an INS that computes with normal gravity the rest is an error of its accelerometers.
                Input::Field(field) => alone(&steady(none, -field_e(self.earth, self.truth, field))),
                Input::Altimeter => Column::zeros(),
            };
            let [of_start, of_draw, of_own] = step.mean;
            let (from_start, from_draw) = (led + by_one * of_start, by_one * of_draw);
            *sensitivity = from_start * step.decay + from_draw * step.diffusion;
            if step.diffusion != 0.0 {
                take(from_start * step.diffusion - from_draw * step.decay);
            }
            match source.input {
                Input::Axis(axis) => own[axis] += of_own * of_own,
                _ if of_own != 0.0 => take(by_one * of_own),
                _ => {}
            }
        }

        // What is new in every stretch: of white noise its mean, of variance N²/T, and its slope, of 12 N²/T.
        for axis in 0..AXES {
            let triad = if axis < 3 { parameters.gyro } else { parameters.accel };
            let density2 = triad.random_walk[axis % 3] * triad.random_walk[axis % 3] / t;
            let mean = (density2 + own[axis]).sqrt();
            if mean != 0.0 {
                take(responses.constant[axis] * mean);
            }
            if density2 != 0.0 {
                take(responses.sloping[axis] * (12.0 * density2).sqrt());
            }
            let pulse = triad.quantization[axis % 3];
            if pulse != 0.0 {
                take(self.quantization(axis, pulse, &nodes[1].f_e, &axes[1]));
            }
        }
        if mode == VerticalMode::Damped && parameters.altimeter.noise_m != 0.0 {
            take(responses.altimeter * (parameters.altimeter.noise_m / (self.stretch.aided as f64).sqrt()));
        }
        let work = &mut work[..used];
        triangularize(work);
        root.factor.copy_from_slice(&work[..ROWS]);
        root.channel = channel.with_states([0.0; 2]);
        if !is_aided {
            root.channel.skip();
        }
        root.columns_mut().for_each(keep_within);
    }

    /// What comes of the rest e that quantization carries, of variance q²/12 and new with each increment: ψ has -C e and δv C e
    /// while it lasts, of which f×ψ and the turn of the axes make a random walk.
    fn quantization(&self, axis: usize, pulse: f64, f_e: &Vector3<f64>, axes: &Matrix3<f64>) -> Column {
        let t = self.stretch.length_s;
        let size = pulse * t / (12.0 * self.stretch.increments as f64).sqrt();
        let direction_e = axes.column(axis % 3).into_owned();
        let turned_e = (axes * self.stretch.mean_rate()).cross(&direction_e);
        let mut column = Column::zeros();
        let (first, own, next) =
            if axis < 3 { (0, turned_e, -f_e.cross(&direction_e)) } else { (3, -turned_e, direction_e) };
        column.fixed_rows_mut::<3>(first).copy_from(&(own * size));
        column.fixed_rows_mut::<3>(first + 3).copy_from(&(next * size));
        column
    }
}
