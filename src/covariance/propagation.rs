//! The covariance along the truth.

use nalgebra::{Matrix3, SMatrix, Vector3};

use super::factor::{ROWS, triangularize};
use super::figures::{ErrorEllipse, Matrix9, NavigationCovariance};
use super::sources::{AXES, COUNT, ELEMENTS, FIELDS, Input, Kind, Parameters, Source};
use super::stretch::{Piece, Stretch};
use crate::earth::{Earth, Vertical};
use crate::error::Error;
use crate::errors::column::{At, Column, advance, keep_within, moved};
use crate::errors::{VALID_DISPLACEMENT_M, VALID_MISALIGNMENT_RAD};
use crate::math::VectorPair;
use crate::mechanization::{VerticalLoop, VerticalMode};
use crate::memory::room;
use crate::mounting::Block;
use crate::sensors::GravityDisturbance;
use crate::signal::{Increment, IntervalMotion};
use crate::state::StateErrors;
use crate::truth::TruthPoint;

/// Columns that a stretch makes at the most: the root, what the processes lose, mean and slope of the noise of the axes, their
/// quantization, what gravity's fields have of their own, the altimeter's noise.
const WORK: usize = ROWS + COUNT + 3 * AXES + FIELDS + 1;

/// The errors x = S β + L ξ: β the processes of unit variance as they are now, ξ normal numbers that have no name any more.
/// Of the covariance of x and β this is a square root, so that no rounding makes it negative.
#[derive(Debug, Clone)]
pub(super) struct Root {
    /// S, of each process.
    pub sensitivities: Box<[Column]>,
    /// L, lower triangular.
    pub factor: Box<[Column]>,
    /// Variance of the random walk of each axis [u²].
    pub walks: [f64; AXES],
    /// The vertical loop with the gains of the last stretch.
    pub channel: VerticalLoop,
}

/// The propagation.
#[derive(Debug, Clone)]
pub(crate) struct Propagation {
    earth: Earth,
    vertical: VerticalMode,
    pub(super) root: Root,
    /// Since the root was brought up to date.
    pub(super) stretch: Stretch,
    /// To look ahead in, and to work in.
    ahead: Root,
    work: Box<[Column]>,
}

/// An interval that was flown.
pub(crate) struct Flown<'a> {
    pub motion: &'a IntervalMotion<'a>,
    pub current: &'a TruthPoint,
    pub next: &'a TruthPoint,
    pub ideal: &'a [Increment],
    /// Whether the altimeter had a height.
    pub is_aided: bool,
    pub block: Option<&'a Block>,
}

/// The errors at the start: those of position, velocity and misalignment that are drawn, and what an alignment makes of steady
/// errors of rate [rad/s] and force [m/s²].
pub(crate) struct StartErrors<'a> {
    pub first: &'a TruthPoint,
    /// True velocity of the sensors [m/s].
    pub v_e: &'a Vector3<f64>,
    /// Standard deviations of the drawn errors.
    pub sigma: StateErrors,
    pub alignment: Option<Alignment>,
}

/// Misalignment that an alignment finds by steady errors, east-north-up, and what the sensors sense then, sensor axes.
pub(crate) struct Alignment {
    pub by_rate: Matrix3<f64>,
    pub by_force: Matrix3<f64>,
    /// Sensor axes in east-north-up.
    pub axes: Matrix3<f64>,
    /// Angular rate [rad/s] and specific force [m/s²].
    pub rate_s: Vector3<f64>,
    pub force_s: Vector3<f64>,
}

impl Root {
    fn new() -> Result<Self, Error> {
        Ok(Self {
            sensitivities: zeros(COUNT)?,
            factor: zeros(ROWS)?,
            walks: [0.0; AXES],
            channel: VerticalLoop::new(),
        })
    }

    fn copy_from(&mut self, other: &Self) {
        self.sensitivities.copy_from_slice(&other.sensitivities);
        self.factor.copy_from_slice(&other.factor);
        (self.walks, self.channel) = (other.walks, other.channel);
    }

    fn columns_mut(&mut self) -> impl Iterator<Item = &mut Column> {
        self.sensitivities.iter_mut().chain(&mut *self.factor)
    }
}

fn zeros(count: usize) -> Result<Box<[Column]>, Error> {
    let mut columns = room(count)?;
    columns.resize(count, Column::zeros());
    Ok(columns.into_boxed_slice())
}

impl Propagation {
    /// None if it is not wanted: a slice of one or of none, which unlike a `Box` can be made without aborting. Its memory is
    /// allocated here.
    pub fn new(is_on: bool, earth: Earth, vertical: VerticalMode) -> Result<Box<[Self]>, Error> {
        let mut memory = room(usize::from(is_on))?;
        if is_on {
            memory.push(Self {
                earth,
                vertical,
                root: Root::new()?,
                stretch: Stretch::EMPTY,
                ahead: Root::new()?,
                work: zeros(WORK)?,
            });
        }
        Ok(memory.into_boxed_slice())
    }

    /// Before a run.
    pub fn reset(&mut self) {
        self.root.walks = [0.0; AXES];
        self.clear();
    }

    /// Before a flight: the processes go on, nothing has come of them.
    fn clear(&mut self) {
        self.root.columns_mut().for_each(|column| *column = Column::zeros());
        self.root.channel = VerticalLoop::new();
        self.stretch = Stretch::EMPTY;
    }

    /// A flight begins.
    pub fn start(&mut self, start: &StartErrors<'_>, parameters: &Parameters<'_>) {
        self.clear();
        let at = At::new(&self.earth, start.first, None);
        let StateErrors { position_n, velocity_n, misalignment_n } = start.sigma;
        let with_height = f64::from(u8::from(self.vertical != VerticalMode::FollowTruth));
        let unit = |sigma: &Vector3<f64>, axis: usize| {
            let mut one = Vector3::zeros();
            one[axis] = sigma[axis];
            one
        };
        for axis in 0..3 {
            let keep = if axis == 2 { with_height } else { 1.0 };
            for (group, errors) in [
                StateErrors { position_n: unit(&position_n, axis) * keep, ..StateErrors::NONE },
                StateErrors { velocity_n: unit(&velocity_n, axis) * keep, ..StateErrors::NONE },
                StateErrors { misalignment_n: unit(&misalignment_n, axis), ..StateErrors::NONE },
            ]
            .into_iter()
            .enumerate()
            {
                self.root.factor[3 * group + axis] = at.column(start.v_e, &errors);
            }
        }
        triangularize(&mut self.root.factor);
        let Some(alignment) = &start.alignment else { return };
        for place in 0..COUNT {
            let source = Source::at(place, parameters);
            let deviation = source.deviation(self.walk_of(&source));
            if deviation != 0.0 {
                let misalignment_n = alignment.by(&self.earth, start.first, source.input) * deviation;
                let errors = StateErrors { misalignment_n, ..StateErrors::NONE };
                self.root.sensitivities[place] = at.column(start.v_e, &errors);
            }
        }
    }

    fn walk_of(&self, source: &Source) -> f64 {
        match source.input {
            Input::Axis(axis) => self.root.walks[axis],
            _ => 0.0,
        }
    }

    /// Takes in an interval that was flown.
    pub fn advance(&mut self, flown: &Flown<'_>, parameters: &Parameters<'_>) {
        let piece = Piece {
            motion: flown.motion,
            ideal: flown.ideal,
            is_aided: flown.is_aided,
            ground_m: GravityDisturbance::over_ground(&self.earth, flown.current, flown.next),
            block: flown.block,
            with_elements: has_elements(parameters),
        };
        if self.stretch.has_no_room_for(flown.motion.interval_s) {
            self.bring_up_to_date(flown.current, flown.block, parameters);
        }
        if self.stretch.add(&piece) {
            self.bring_up_to_date(flown.next, flown.block, parameters);
        }
    }

    fn bring_up_to_date(&mut self, truth: &TruthPoint, block: Option<&Block>, parameters: &Parameters<'_>) {
        let at = At::new(&self.earth, truth, block);
        let passage =
            Passage { earth: &self.earth, vertical: self.vertical, stretch: &self.stretch, at: &at, truth };
        passage.go(&mut self.root, &mut self.work, parameters);
        self.stretch = Stretch::EMPTY;
    }

    /// The truth jumps, from and to a vertical, a velocity of the sensors and whether it is near a pole.
    pub fn move_truth(
        &mut self,
        (truth, block): (&TruthPoint, Option<&Block>),
        from: &(Vertical, Vector3<f64>, bool),
        to: &(Vertical, Vector3<f64>, bool),
        parameters: &Parameters<'_>,
    ) {
        if !self.stretch.is_empty() {
            self.bring_up_to_date(truth, block, parameters);
        }
        let earth = &self.earth;
        self.root.columns_mut().for_each(|column| moved(column, earth, from, to));
        triangularize(&mut self.root.factor);
    }

    /// The covariance at `truth`, the last point that was flown to; nothing changes but scratch.
    pub fn read(
        &mut self,
        truth: &TruthPoint,
        block: Option<&Block>,
        parameters: &Parameters<'_>,
    ) -> NavigationCovariance {
        let at = At::new(&self.earth, truth, block);
        self.ahead.copy_from(&self.root);
        if !self.stretch.is_empty() {
            let passage = Passage {
                earth: &self.earth,
                vertical: self.vertical,
                stretch: &self.stretch,
                at: &at,
                truth,
            };
            passage.go(&mut self.ahead, &mut self.work, parameters);
        }
        covariance_of(&self.ahead, &at, truth, block, parameters)
    }
}

fn has_elements(parameters: &Parameters<'_>) -> bool {
    [parameters.gyro, parameters.accel].iter().any(|triad| {
        triad.scale_factor_sigma != Vector3::zeros() || triad.misalignment_sigma != Matrix3::zeros()
    })
}

impl Alignment {
    /// Misalignment by a source of 1, east-north-up [rad].
    fn by(&self, earth: &Earth, first: &TruthPoint, input: Input) -> Vector3<f64> {
        match input {
            Input::Axis(axis) => self.of(axis < 3) * self.axes.column(axis % 3),
            Input::Element(element) => {
                let signal = if element < 9 { &self.rate_s } else { &self.force_s };
                self.of(element < 9) * self.axes.column(element % 3) * signal[element / 3 % 3]
            }
            Input::Field(field) => {
                let local = At::new(earth, first, None);
                self.by_force * -local.in_local_axes(&field_e(earth, first, field))
            }
            Input::Altimeter => Vector3::zeros(),
        }
    }

    fn of(&self, is_gyro: bool) -> &Matrix3<f64> {
        if is_gyro { &self.by_rate } else { &self.by_force }
    }
}

/// True less normal gravity for a field of 1, Earth-fixed axes [m/s²].
fn field_e(earth: &Earth, truth: &TruthPoint, field: usize) -> Vector3<f64> {
    let mut fields = [0.0; FIELDS];
    fields[field] = 1.0;
    GravityDisturbance::of_fields(earth, truth, fields)
}

/// From the start of a stretch to its end.
struct Passage<'a> {
    earth: &'a Earth,
    vertical: VerticalMode,
    stretch: &'a Stretch,
    at: &'a At<'a>,
    truth: &'a TruthPoint,
}

/// What errors of 1 over the stretch make of x.
struct Responses {
    /// By constant errors of the axes, and by such as go from -1/2 to 1/2.
    constant: [Column; AXES],
    sloping: [Column; AXES],
    altimeter: Column,
}

impl Passage<'_> {
    fn go(&self, root: &mut Root, work: &mut [Column], parameters: &Parameters<'_>) {
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

fn covariance_of(
    root: &Root,
    at: &At<'_>,
    truth: &TruthPoint,
    block: Option<&Block>,
    parameters: &Parameters<'_>,
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
    for (place, sensitivity) in root.sensitivities.iter().enumerate() {
        let source = Source::at(place, parameters);
        let mut errors = at.errors(sensitivity);
        if let (Input::Axis(axis @ 0..3), Some(_)) = (source.input, block) {
            let gyro_e = axes_e.column(axis) * source.deviation(root.walks[axis]);
            errors.velocity_n += at.in_local_axes(&at.velocity_by_arm(&gyro_e));
        }
        add(&errors);
    }
    root.factor.iter().for_each(|column| add(&at.errors(column)));
    // The noise of the rate of the last interval, by the arm.
    if block.is_some() {
        let t = truth.interval_s;
        for axis in (0..3).filter(|_| t > 0.0) {
            let (density, pulse) = (parameters.gyro.random_walk[axis], parameters.gyro.quantization[axis]);
            let rate = (density * density / t + pulse * pulse / (6.0 * t * t)).sqrt();
            let velocity_n = at.in_local_axes(&at.velocity_by_arm(&(axes_e.column(axis) * rate)));
            add(&StateErrors { velocity_n, ..StateErrors::NONE });
        }
    }
    // What quantization carries now: while it lasts.
    for axis in 0..AXES {
        let triad = if axis < 3 { parameters.gyro } else { parameters.accel };
        let pulse = triad.quantization[axis % 3];
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
    let outside_validity = !(sum([0, 1, 2]) < VALID_DISPLACEMENT_M * VALID_DISPLACEMENT_M
        && sum([6, 7, 8]) < VALID_MISALIGNMENT_RAD * VALID_MISALIGNMENT_RAD);
    NavigationCovariance {
        matrix,
        ellipse: ErrorEllipse::new(matrix[(0, 0)], matrix[(1, 1)], matrix[(0, 1)]),
        outside_validity,
    }
}
