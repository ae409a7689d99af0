//! The root of the covariance from the start of a stretch to its end.

use nalgebra::{Matrix3, SMatrix, Vector3};

use super::alignment::field_e;
use super::factor::{ROWS, triangularize};
use super::root::Root;
use super::sources::{AXES, COUNT, ELEMENTS, Input, Kind, Parameters, Source};
use super::stretch::Stretch;
use crate::earth::Earth;
use crate::errors::column::{At, Column, advance, keep_within};
use crate::math::VectorPair;
use crate::mechanization::{VerticalLoop, VerticalMode};
use crate::signal::MotionNode;
use crate::truth::TruthPoint;

/// The passage from the start of a stretch to its end.
pub(super) struct Passage<'a> {
    pub earth: &'a Earth,
    pub vertical: VerticalMode,
    pub stretch: &'a Stretch,
    pub at: &'a At<'a>,
    pub truth: &'a TruthPoint,
}

/// The linear model over the stretch, from the vertical loop of the one before.
struct Model<'a> {
    passage: &'a Passage<'a>,
    nodes: [MotionNode; 3],
    axes: [Matrix3<f64>; 3],
    mode: VerticalMode,
    channel: VerticalLoop,
}

/// The new columns, from which a root is computed.
struct Columns<'a> {
    all: &'a mut [Column],
    used: usize,
}

type Transition = SMatrix<f64, ROWS, ROWS>;

const NONE: Vector3<f64> = Vector3::new(0.0, 0.0, 0.0);

/// Errors of a gyro or of an accelerometer.
fn errors_of(is_gyro: bool, vector_e: Vector3<f64>) -> VectorPair {
    if is_gyro { VectorPair::new(&vector_e, &NONE) } else { VectorPair::new(&NONE, &vector_e) }
}

impl Columns<'_> {
    fn take(&mut self, column: Column) {
        self.all[self.used] = column;
        self.used += 1;
    }
}

impl Model<'_> {
    /// The column at the end, with the sensor errors `errors_e`, and the vertical loop at the end.
    fn over(&self, column: &Column, errors_e: &[VectorPair; 3]) -> (Column, VerticalLoop) {
        let (mut column, mut channel) = (*column, self.channel);
        let Passage { earth, stretch, at, .. } = self.passage;
        advance(&mut column, earth, stretch.length_s, &self.nodes, errors_e);
        at.correct_vertical(&mut column, self.mode, &mut channel, 0.0, stretch.times());
        (column, channel)
    }

    /// The columns at the end for errors of 1, and the vertical loop at the end.
    fn transition(&self) -> (Transition, VerticalLoop) {
        let mut transition = Transition::zeros();
        let mut channel = self.channel;
        for row in 0..ROWS {
            let mut unit = Column::zeros();
            unit[row] = 1.0;
            let (column, after) = self.over(&unit, &[VectorPair::both(&NONE); 3]);
            transition.set_column(row, &column);
            channel = after;
        }
        (transition, channel)
    }

    /// The column caused by errors of an axis that have these sizes at the nodes.
    fn by_axis(&self, axis: usize, sizes: [f64; 3]) -> Column {
        let at = |node: usize| errors_of(axis < 3, self.axes[node].column(axis % 3) * sizes[node]);
        self.over(&Column::zeros(), &[at(0), at(1), at(2)]).0
    }

    /// The column caused by a constant input of 1; for the altimeter, by an input of 1 at the end, where it is read.
    fn by(&self, input: Input) -> Column {
        let Passage { earth, stretch, at, truth, .. } = self.passage;
        let errors_e = match input {
            Input::Axis(axis) => return self.by_axis(axis, [1.0; 3]),
            Input::Element(element) => {
                stretch.by_element(element).map(|vector_e| errors_of(element < ELEMENTS / 2, vector_e))
            }
            // To an INS that computes with normal gravity the rest is an error of its accelerometers.
            Input::Field(field) => [errors_of(false, -field_e(earth, truth, field)); 3],
            Input::Altimeter => {
                let (mut column, mut channel) = (Column::zeros(), self.channel);
                at.correct_vertical(&mut column, self.mode, &mut channel, 1.0, stretch.times());
                return column;
            }
        };
        self.over(&Column::zeros(), &errors_e).0
    }
}

impl Passage<'_> {
    /// Propagates `root` from the start of the stretch to its end. `work` is memory for the columns.
    pub fn go(&self, root: &mut Root, work: &mut [Column], parameters: &Parameters<'_>) {
        let is_aided = self.vertical != VerticalMode::Damped || self.stretch.aided > 0;
        let mode = if is_aided { self.vertical } else { VerticalMode::Free };
        let (nodes, axes) = self.stretch.lines();
        let model = Model { passage: self, nodes, axes, mode, channel: root.channel };
        let (transition, channel) = model.transition();
        let mut columns = Columns { all: work, used: 0 };
        root.factor.iter().for_each(|column| columns.take(transition * column));
        self.add_processes(root, &mut columns, &model, &transition, parameters);
        self.add_noise(&mut columns, &model, parameters);
        triangularize(&mut columns.all[..columns.used]);
        root.factor.copy_from_slice(&columns.all[..ROWS]);
        root.channel = channel.with_states([0.0; 2]);
        if !is_aided {
            root.channel.skip();
        }
        root.columns_mut().for_each(keep_within);
    }

    /// The processes: S⁺ = a (Φ S + γ) + s δ, and the part of the errors that is no longer correlated with them.
    fn add_processes(
        &self,
        root: &mut Root,
        columns: &mut Columns<'_>,
        model: &Model<'_>,
        transition: &Transition,
        parameters: &Parameters<'_>,
    ) {
        let mut by_axes = [None; AXES];
        for place in 0..COUNT {
            let source = Source::at(place, parameters);
            let sensitivity = &mut root.sensitivities[place];
            let mut still = 0.0;
            let walk = match (source.input, source.kind) {
                (Input::Axis(axis), Kind::Walk(_)) => &mut root.walks[axis],
                _ => &mut still,
            };
            let step = source.advance(self.stretch.length_s, self.stretch.ground_m, walk);
            if source.sigma == 0.0 && *sensitivity == Column::zeros() {
                continue;
            }
            let led = transition * *sensitivity;
            let by_one = match source.input {
                Input::Axis(axis) => *by_axes[axis].get_or_insert_with(|| model.by(source.input)),
                input => model.by(input),
            };
            if source.input == Input::Altimeter {
                *sensitivity = led * step.decay + by_one * source.sigma;
                columns.take(led * step.diffusion);
                continue;
            }
            let [of_start, of_draw, of_own] = step.mean;
            let (from_start, from_draw) = (led + by_one * of_start, by_one * of_draw);
            *sensitivity = from_start * step.decay + from_draw * step.diffusion;
            if step.diffusion != 0.0 {
                columns.take(from_start * step.diffusion - from_draw * step.decay);
                columns.take(by_one * of_own);
            }
        }
    }

    /// The noise that is new in every stretch: the mean of the white noise, of variance N²/T, and its slope, of variance 12 N²/T;
    /// quantization; the altimeter's noise.
    fn add_noise(&self, columns: &mut Columns<'_>, model: &Model<'_>, parameters: &Parameters<'_>) {
        for axis in 0..AXES {
            let triad = parameters.of_axis(axis);
            let (density, pulse) = (triad.random_walk[axis % 3], triad.quantization[axis % 3]);
            if density != 0.0 {
                let root = density / self.stretch.length_s.sqrt();
                columns.take(model.by_axis(axis, [root; 3]));
                let slope = 12.0f64.sqrt() * root;
                columns.take(model.by_axis(axis, [-0.5 * slope, 0.0, 0.5 * slope]));
            }
            if pulse != 0.0 {
                columns.take(self.quantization(axis, pulse, &model.nodes[1].f_e, &model.axes[1]));
            }
        }
        let noise_m = parameters.altimeter.noise_m;
        if model.mode == VerticalMode::Damped && noise_m != 0.0 {
            columns.take(model.by(Input::Altimeter) * (noise_m / (self.stretch.aided as f64).sqrt()));
        }
    }

    /// The effect of the remainder e that quantization carries; it has the variance q²/12 and is new with each increment. While it
    /// lasts ψ contains -C e and δv contains C e. Through f×ψ and the rotation of the axes they cause a random walk.
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
