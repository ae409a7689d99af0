//! The root of the covariance from the start of a stretch to its end, by the equations of the [module](super).

use nalgebra::{Matrix3, SMatrix, Vector3};

use super::alignment::field_e;
use super::factor::{ROWS, triangularize};
use super::line::{Line, Spread};
use super::root::Root;
use super::sources::{AXES, ErrorInput, LINES, RandomErrors, Source};
use super::stretch::Stretch;
use crate::base::math::VectorPair;
use crate::earth::state::StateErrors;
use crate::errors::are_linear;
use crate::errors::column::{At, Column, advance, keep_within};
use crate::mechanization::{VerticalLoop, VerticalMode};
use crate::signal::MotionNode;

/// Φ, the columns at the end for errors of 1 at the start.
type Transition = SMatrix<f64, ROWS, ROWS>;

const NONE: Vector3<f64> = Vector3::new(0.0, 0.0, 0.0);

/// Columns caused by an input: by a mean of 1, and by a change of 1 over the stretch.
#[derive(Clone, Copy)]
struct Response {
    of_mean: Column,
    of_change: Column,
}

impl Response {
    /// The column caused by a line.
    fn to(&self, line: &Line) -> Column {
        self.of_mean * line.mean + self.of_change * line.change
    }
}

/// The linear model over a stretch.
struct Model<'a> {
    at: &'a At<'a>,
    stretch: &'a Stretch,
    nodes: [MotionNode; 3],
    axes: [Matrix3<f64>; 3],
    mode: VerticalMode,
    /// The vertical loop of the stretch before.
    channel: VerticalLoop,
    /// Responses to the inputs that several processes share, as far as they are known.
    responses: [Option<Response>; LINES],
}

impl<'a> Model<'a> {
    fn new(at: &'a At<'a>, stretch: &'a Stretch, mode: VerticalMode, channel: VerticalLoop) -> Self {
        let (nodes, axes) = stretch.lines();
        Self { at, stretch, nodes, axes, mode, channel, responses: [None; LINES] }
    }

    /// The column at the end, with the sensor errors `errors_e`, and the vertical loop at the end.
    fn over(&self, column: &Column, errors_e: &[VectorPair; 3]) -> (Column, VerticalLoop) {
        let mut column = *column;
        advance(&mut column, self.at.earth, self.stretch.length_s, &self.nodes, errors_e);
        self.corrected(column, 0.0)
    }

    /// A column after the correction of the vertical channel by an altimeter that shows `altimeter_m` [m] too much, and the loop then.
    fn corrected(&self, mut column: Column, altimeter_m: f64) -> (Column, VerticalLoop) {
        let mut channel = self.channel;
        self.at.correct_vertical(&mut column, self.mode, &mut channel, altimeter_m, self.stretch.times());
        (column, channel)
    }

    /// Φ, and the vertical loop at the end.
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

    /// The response to an input. A constant has no change.
    fn response(&mut self, input: ErrorInput) -> Response {
        let line = input.line();
        if let Some(known) = line.and_then(|line| self.responses[line]) {
            return known;
        }
        let by = |line: Line| self.over(&Column::zeros(), &self.errors_by(input, line.at_nodes())).0;
        let response = Response {
            of_mean: by(Line { mean: 1.0, change: 0.0 }),
            of_change: match line {
                Some(_) => by(Line { mean: 0.0, change: 1.0 }),
                None => Column::zeros(),
            },
        };
        if let Some(line) = line {
            self.responses[line] = Some(response);
        }
        response
    }

    /// Errors of the sensors at the nodes, caused by an input that has these sizes there.
    fn errors_by(&self, input: ErrorInput, sizes: [f64; 3]) -> [VectorPair; 3] {
        let of_axis = |axis: usize, vectors_e: [Vector3<f64>; 3]| {
            let share = self.stretch.share(axis);
            core::array::from_fn(|node| {
                let error_e = vectors_e[node] * (sizes[node] * share);
                if axis < 3 { VectorPair::new(&error_e, &NONE) } else { VectorPair::new(&NONE, &error_e) }
            })
        };
        match input {
            ErrorInput::Axis(axis) => of_axis(axis, self.axes.map(|axes| axes.column(axis % 3).into_owned())),
            ErrorInput::Element(element) => {
                of_axis(element / 9 * 3 + element % 3, self.stretch.by_element(element))
            }
            // To an INS that computes with normal gravity the rest is an error of its accelerometers, as far as they sense it.
            ErrorInput::Field(field) => {
                let rest_e = -field_e(self.at.earth, self.at.truth, field);
                core::array::from_fn(|node| {
                    let lost = |i: usize| {
                        let axis_e = self.axes[node].column(i);
                        axis_e * ((1.0 - self.stretch.share(3 + i)) * axis_e.dot(&rest_e))
                    };
                    VectorPair::new(&NONE, &((rest_e - lost(0) - lost(1) - lost(2)) * sizes[node]))
                })
            }
            ErrorInput::Altimeter => [VectorPair::both(&NONE); 3],
        }
    }

    /// The column caused by an altimeter that shows 1 m too much at the end, where it is read.
    fn by_altimeter(&self) -> Column {
        self.corrected(Column::zeros(), 1.0).0
    }

    /// The effect of the remainder e that quantization carries; it has the variance q²/12 and is new with each increment. While it
    /// lasts ψ contains -C e and δv contains C e. Through f×ψ and the rotation of the axes they cause a random walk.
    fn by_quantization(&self, axis: usize, pulse: f64) -> Column {
        let (f_e, axes) = (&self.nodes[1].f_e, &self.axes[1]);
        let size = pulse * self.stretch.length_s / (12.0 * self.stretch.increments as f64).sqrt();
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

/// The columns of which L⁺ is made.
struct Columns<'a> {
    all: &'a mut [Column],
    used: usize,
}

impl Columns<'_> {
    fn take(&mut self, column: Column) {
        self.all[self.used] = column;
        self.used += 1;
    }
}

impl Root {
    /// Moves on over `stretch`, at whose end the truth is `at`. `work` is memory for the columns.
    pub fn advance(
        &mut self,
        stretch: &Stretch,
        at: &At<'_>,
        vertical: VerticalMode,
        work: &mut [Column],
        parameters: &RandomErrors<'_>,
    ) {
        let is_aided = vertical != VerticalMode::Damped || stretch.aided > 0;
        let mode = if is_aided { vertical } else { VerticalMode::Free };
        let mut model = Model::new(at, stretch, mode, self.channel);
        let (transition, channel) = model.transition();
        let mut columns = Columns { all: work, used: 0 };
        self.factor.iter().for_each(|column| columns.take(transition * column));
        self.advance_processes(&mut model, &transition, &mut columns, parameters);
        add_noise(&model, &mut columns, parameters);
        let mean_errors = stretch.mean_errors();
        if mean_errors.is_some() || self.mean != Column::zeros() {
            self.mean = model.over(&self.mean, &mean_errors.unwrap_or([VectorPair::both(&NONE); 3])).0;
        }
        triangularize(&mut columns.all[..columns.used]);
        self.factor.copy_from_slice(&columns.all[..ROWS]);
        self.channel = channel.with_states([0.0; 2]);
        if !is_aided {
            self.channel.skip();
        }
        self.columns_mut().for_each(keep_within);
        self.bound();
        if self.mean != Column::zeros() {
            let StateErrors { position_n, misalignment_n, .. } = at.errors(&self.mean);
            self.mean_was_beyond |= !are_linear(position_n.norm_squared(), misalignment_n.norm_squared());
        }
    }

    /// S⁺ = a (Φ S + γ) + s δ of each process, and the columns of the part of the errors that is not correlated with the processes any
    /// more, s (Φ S + γ) - a δ, or never was: the rests of their lines, and white noise.
    fn advance_processes(
        &mut self,
        model: &mut Model<'_>,
        transition: &Transition,
        columns: &mut Columns<'_>,
        parameters: &RandomErrors<'_>,
    ) {
        let stretch = model.stretch;
        let mut rests = [Spread::NONE; LINES];
        for (axis, rest) in rests.iter_mut().enumerate().take(AXES) {
            let density = stretch.noise(axis, parameters.of_axis(axis).random_walk[axis % 3]);
            *rest = Spread::of_white_noise(density, stretch.length_s);
        }
        for (source, sensitivity) in Source::all(parameters).zip(&mut self.sensitivities) {
            let step = source.advance(stretch.length_s, stretch.ground_m, &mut self.walks);
            if source.sigma == 0.0 && *sensitivity == Column::zeros() {
                continue;
            }
            let led = transition * *sensitivity;
            if source.input == ErrorInput::Altimeter {
                // It acts at the end alone, where the process is β⁺: γ and δ are a and s times its column.
                *sensitivity = led * step.decay + model.by_altimeter() * source.sigma;
                columns.take(led * step.diffusion);
                continue;
            }
            if let Some(line) = source.input.line() {
                rests[line].add(&step.rest);
            }
            let response = model.response(source.input);
            let (from_start, from_draw) = (led + response.to(&step.of_start), response.to(&step.of_draw));
            *sensitivity = from_start * step.decay + from_draw * step.diffusion;
            if step.diffusion != 0.0 {
                columns.take(from_start * step.diffusion - from_draw * step.decay);
            }
        }
        for (line, rest) in rests.iter().enumerate().filter(|(_, rest)| !rest.is_none()) {
            let response = model.response(ErrorInput::of_line(line));
            rest.lines().iter().for_each(|line| columns.take(response.to(line)));
        }
    }
}

/// The noise that is new in every stretch: quantization, and the altimeter's noise.
fn add_noise(model: &Model<'_>, columns: &mut Columns<'_>, parameters: &RandomErrors<'_>) {
    for axis in 0..AXES {
        let pulse = parameters.of_axis(axis).quantization[axis % 3] * model.stretch.share(axis);
        if pulse != 0.0 {
            columns.take(model.by_quantization(axis, pulse));
        }
    }
    let noise_m = parameters.altimeter.noise_m;
    if model.mode == VerticalMode::Damped && noise_m != 0.0 {
        columns.take(model.by_altimeter() * (noise_m / (model.stretch.aided as f64).sqrt()));
    }
}
