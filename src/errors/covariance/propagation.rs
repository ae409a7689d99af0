//! The covariance along the truth.

use nalgebra::Vector3;

use super::alignment::SteadyAlignment;
use super::factor::{ROWS, triangularize};
use super::figures::NavigationCovariance;
use super::line::Advance;
use super::read::covariance_of;
use super::root::Root;
use super::sources::{AXES, COUNT, ErrorInput, LINES, RandomErrors, Source, WALKS};
use super::stretch::{FlownInterval, Stretch};
use crate::base::error::Error;
use crate::base::memory::{filled, room};
use crate::earth::state::StateErrors;
use crate::earth::{Earth, Vertical};
use crate::errors::column::{At, Column, moved};
use crate::mechanization::{VerticalLoop, VerticalMode};
use crate::signal::mounting::Block;
use crate::truth::TruthPoint;

/// Largest number of columns of a stretch: the root, the lost correlation of the processes, mean and change of what is new in each
/// line, the quantization of each axis, the altimeter's noise.
const WORK: usize = ROWS + COUNT + 2 * LINES + AXES + 1;

/// The propagation.
#[derive(Debug, Clone)]
pub(crate) struct Propagation {
    earth: Earth,
    vertical: VerticalMode,
    pub(super) root: Root,
    /// Variances of the random walks before the flight, whose alignment continues them.
    walks_before: [f64; WALKS],
    /// The stretch since the last update of the root.
    pub(super) stretch: Stretch,
    /// Memory for a look ahead, and for the work.
    ahead: Root,
    work: Box<[Column]>,
}

/// The errors at the start: the drawn errors of position, velocity and misalignment, and the misalignment that an alignment derives
/// from steady errors of rate [rad/s] and force [m/s²].
pub(crate) struct StartErrors<'a> {
    pub first: &'a TruthPoint,
    /// True velocity of the sensors [m/s].
    pub v_e: &'a Vector3<f64>,
    /// Standard deviations of the drawn errors.
    pub sigma: StateErrors,
    pub alignment: Option<SteadyAlignment>,
    /// Length of the alignment [s]; 0: without end.
    pub alignment_s: f64,
}

impl Propagation {
    /// A slice of one propagation, or of none if the covariance is off. Its memory is allocated here; unlike that of a `Box` it can
    /// be missing without the end of the process.
    pub fn new(is_on: bool, earth: Earth, vertical: VerticalMode) -> Result<Box<[Self]>, Error> {
        let mut memory = room(usize::from(is_on))?;
        if is_on {
            memory.push(Self {
                earth,
                vertical,
                root: Root::new()?,
                walks_before: [0.0; WALKS],
                stretch: Stretch::EMPTY,
                ahead: Root::new()?,
                work: filled(WORK, Column::zeros())?,
            });
        }
        Ok(memory.into_boxed_slice())
    }

    /// Returns to the state before a run.
    pub fn reset(&mut self) {
        self.root.walks = [0.0; WALKS];
        self.clear();
    }

    /// Returns to the state before a flight: the processes continue, the errors are 0.
    fn clear(&mut self) {
        self.root.columns_mut().for_each(|column| *column = Column::zeros());
        self.root.mean_was_beyond = false;
        self.root.channel = VerticalLoop::new();
        self.stretch = Stretch::EMPTY;
    }

    /// Begins a flight.
    pub fn start(&mut self, start: &StartErrors<'_>, parameters: &RandomErrors<'_>) {
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
        self.root.bound();
        self.walks_before = self.root.walks;
        if let Some(alignment) = &start.alignment {
            self.align(alignment, start, parameters);
            self.root.bound();
        }
    }

    /// Adds the misalignment that an alignment derives from the errors of the sensors: from the present ones, or from their mean over
    /// the length of the alignment, to whose end the processes move on. The part that their present values do not explain is added
    /// to the factor.
    fn align(&mut self, alignment: &SteadyAlignment, start: &StartErrors<'_>, parameters: &RandomErrors<'_>) {
        let Self { earth, root, work, .. } = self;
        let at = At::new(earth, start.first, None);
        let t = start.alignment_s;
        let column = |input: ErrorInput, size: f64| {
            let misalignment_n = alignment.by(earth, start.first, input) * size;
            at.column(start.v_e, &StateErrors { misalignment_n, ..StateErrors::NONE })
        };
        let mut used = ROWS;
        let mut add = |input: ErrorInput, size: f64| {
            if size != 0.0 {
                work[used] = column(input, size);
                used += 1;
            }
        };
        let mut own = [0.0; AXES];
        for (source, sensitivity) in Source::all(parameters).zip(&mut root.sensitivities) {
            let step = match t {
                0.0 => Advance::still(source.deviation(&root.walks)),
                _ => source.advance(t, 0.0, &mut root.walks),
            };
            let (of_start, of_draw) = (step.of_start.mean, step.of_draw.mean);
            let of_end = of_start * step.decay + of_draw * step.diffusion;
            if of_end != 0.0 {
                *sensitivity = column(source.input, of_end);
            }
            add(source.input, of_start * step.diffusion - of_draw * step.decay);
            if let ErrorInput::Axis(axis) = source.input {
                own[axis] += step.rest.of_mean();
            }
        }
        if t == 0.0 {
            return;
        }
        // What is independent of the ends of the processes, white noise, and the remainder that quantization carries.
        for (axis, own) in own.into_iter().enumerate() {
            let triad = parameters.of_axis(axis);
            let (density, pulse) = (triad.random_walk[axis % 3], triad.quantization[axis % 3]);
            add(
                ErrorInput::Axis(axis),
                (own + density * density / t + pulse * pulse / (12.0 * t * t)).sqrt(),
            );
        }
        work[..ROWS].copy_from_slice(&root.factor);
        triangularize(&mut work[..used]);
        root.factor.copy_from_slice(&work[..ROWS]);
    }

    /// Undoes what a start continued beyond the flight: the random walks of its alignment.
    pub fn undo_start(&mut self) {
        self.root.walks = self.walks_before;
    }

    /// Adds an interval that was flown.
    pub fn advance(&mut self, flown: &FlownInterval<'_>, parameters: &RandomErrors<'_>) {
        if self.stretch.has_no_room_for(flown.motion.interval_s) {
            self.bring_up_to_date(flown.current, flown.block, parameters);
        }
        if self.stretch.add(&self.earth, flown, parameters) {
            self.bring_up_to_date(flown.next, flown.block, parameters);
        }
    }

    fn bring_up_to_date(&mut self, truth: &TruthPoint, block: Option<&Block>, parameters: &RandomErrors<'_>) {
        let at = At::new(&self.earth, truth, block);
        self.root.advance(&self.stretch, &at, self.vertical, &mut self.work, parameters);
        self.stretch = Stretch::EMPTY;
    }

    /// Follows a jump of the truth. Each of its ends has a vertical, a velocity of the sensors, and whether it is near a pole.
    pub fn move_truth(
        &mut self,
        (truth, block): (&TruthPoint, Option<&Block>),
        from: &(Vertical, Vector3<f64>, bool),
        to: &(Vertical, Vector3<f64>, bool),
        parameters: &RandomErrors<'_>,
    ) {
        if !self.stretch.is_empty() {
            self.bring_up_to_date(truth, block, parameters);
        }
        let earth = &self.earth;
        self.root.columns_mut().for_each(|column| moved(column, earth, from, to));
        triangularize(&mut self.root.factor);
        self.root.bound();
    }

    /// The covariance at `truth`, the last point that was flown to. Only working memory changes.
    pub fn read(
        &mut self,
        truth: &TruthPoint,
        block: Option<&Block>,
        parameters: &RandomErrors<'_>,
    ) -> NavigationCovariance {
        let at = At::new(&self.earth, truth, block);
        self.ahead.copy_from(&self.root);
        if !self.stretch.is_empty() {
            self.ahead.advance(&self.stretch, &at, self.vertical, &mut self.work, parameters);
        }
        covariance_of(&self.ahead, &at, truth, block, parameters)
    }
}
