//! The root of the covariance from the start of a stretch to its end.

use nalgebra::{Matrix3, SMatrix, Vector3};

use super::alignment::field_e;
use super::factor::{ROWS, triangularize};
use super::line::{Line, Spread};
use super::root::Root;
use super::sources::{AXES, COUNT, Input, Kind, LINES, Parameters, Source};
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

/// Columns caused by an input: by a mean of 1, and by a change of 1 over the stretch.
#[derive(Clone, Copy)]
struct Response {
    of_mean: Column,
    of_change: Column,
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

    /// The columns caused by an input with a mean of 1, and by one with a change of 1 from start to end. A constant has no change.
    fn response(&self, input: Input) -> Response {
        let [mean, change] = [Line { mean: 1.0, change: 0.0 }, Line { mean: 0.0, change: 1.0 }];
        let by = |line: Line| self.over(&Column::zeros(), &self.errors_by(input, line.at_nodes())).0;
        let is_constant = matches!(input, Input::Element(_));
        Response { of_mean: by(mean), of_change: if is_constant { Column::zeros() } else { by(change) } }
    }

    /// Errors of the sensors at the nodes, caused by an input that has these sizes there.
    fn errors_by(&self, input: Input, sizes: [f64; 3]) -> [VectorPair; 3] {
        let Passage { earth, stretch, truth, .. } = self.passage;
        let of_axis = |axis: usize, vectors_e: [Vector3<f64>; 3]| {
            let share = stretch.share(axis);
            core::array::from_fn(|node| errors_of(axis < 3, vectors_e[node] * (sizes[node] * share)))
        };
        match input {
            Input::Axis(axis) => of_axis(axis, self.axes.map(|axes| axes.column(axis % 3).into_owned())),
            Input::Element(element) => of_axis(element / 9 * 3 + element % 3, stretch.by_element(element)),
            // To an INS that computes with normal gravity the rest is an error of its accelerometers, as far as they sense it.
            Input::Field(field) => {
                let rest_e = -field_e(earth, truth, field);
                core::array::from_fn(|node| {
                    let lost = |i: usize| {
                        let axis_e = self.axes[node].column(i);
                        axis_e * ((1.0 - stretch.share(3 + i)) * axis_e.dot(&rest_e))
                    };
                    errors_of(false, (rest_e - lost(0) - lost(1) - lost(2)) * sizes[node])
                })
            }
            Input::Altimeter => [VectorPair::both(&NONE); 3],
        }
    }

    /// The column caused by an altimeter that shows 1 m too much at the end, where it is read.
    fn by_altimeter(&self) -> Column {
        let (mut column, mut channel) = (Column::zeros(), self.channel);
        let Passage { stretch, at, .. } = self.passage;
        at.correct_vertical(&mut column, self.mode, &mut channel, 1.0, stretch.times());
        column
    }
}

impl Response {
    /// The column caused by a line.
    fn to(&self, line: &Line) -> Column {
        self.of_mean * line.mean + self.of_change * line.change
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

    /// The processes: S⁺ = a (Φ S + γ) + s δ, and the part of the errors that is not correlated with them any more or never was; with
    /// this part, white noise.
    fn add_processes(
        &self,
        root: &mut Root,
        columns: &mut Columns<'_>,
        model: &Model<'_>,
        transition: &Transition,
        parameters: &Parameters<'_>,
    ) {
        let mut responses = [None; LINES];
        let mut rests = [Spread::NONE; LINES];
        for (axis, rest) in rests.iter_mut().enumerate().take(AXES) {
            let density = self.stretch.noise(axis, parameters.of_axis(axis).random_walk[axis % 3]);
            *rest = Spread::of_white_noise(density, self.stretch.length_s);
        }
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
            let response = match source.input.line() {
                Some(line) => {
                    rests[line].add(&step.rest);
                    *responses[line].get_or_insert_with(|| model.response(source.input))
                }
                None if source.input == Input::Altimeter => {
                    *sensitivity = led * step.decay + model.by_altimeter() * source.sigma;
                    columns.take(led * step.diffusion);
                    continue;
                }
                None => model.response(source.input),
            };
            let (from_start, from_draw) = (led + response.to(&step.of_start), response.to(&step.of_draw));
            *sensitivity = from_start * step.decay + from_draw * step.diffusion;
            if step.diffusion != 0.0 {
                columns.take(from_start * step.diffusion - from_draw * step.decay);
            }
        }
        for (line, rest) in rests.iter().enumerate().filter(|(_, rest)| !rest.is_none()) {
            let response = responses[line].get_or_insert_with(|| model.response(Input::of_line(line)));
            rest.lines().iter().for_each(|line| columns.take(response.to(line)));
        }
    }

    /// The noise that is new in every stretch: quantization, and the altimeter's noise.
    fn add_noise(&self, columns: &mut Columns<'_>, model: &Model<'_>, parameters: &Parameters<'_>) {
        for axis in 0..AXES {
            let pulse = parameters.of_axis(axis).quantization[axis % 3] * self.stretch.share(axis);
            if pulse != 0.0 {
                columns.take(self.quantization(axis, pulse, &model.nodes[1].f_e, &model.axes[1]));
            }
        }
        let noise_m = parameters.altimeter.noise_m;
        if model.mode == VerticalMode::Damped && noise_m != 0.0 {
            columns.take(model.by_altimeter() * (noise_m / (self.stretch.aided as f64).sqrt()));
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
