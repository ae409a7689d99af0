//! The random quantities of a run, each as a process of unit variance.

use nalgebra::{Matrix3, Vector3};

use super::line::Advance;
use crate::sensors::{AltimeterParameters, FLICKER_PROCESSES, GravityDisturbanceParameters, TriadParameters};

/// The random errors that the host has set.
#[derive(Clone, Copy)]
pub(crate) struct Parameters<'a> {
    /// Of each axis, the share of the signal that is in its output, and the density of the noise of a failure [u √s].
    pub outputs: [(f64, f64); AXES],
    pub gyro: &'a TriadParameters,
    pub accel: &'a TriadParameters,
    pub altimeter: &'a AltimeterParameters,
    pub gravity: &'a GravityDisturbanceParameters,
}

impl Parameters<'_> {
    /// The triad of an axis.
    pub fn of_axis(&self, axis: usize) -> &TriadParameters {
        if axis < 3 { self.gyro } else { self.accel }
    }

    /// Whether scale factors or misalignments are random.
    pub fn have_elements(&self) -> bool {
        [self.gyro, self.accel].iter().any(|triad| {
            triad.scale_factor_sigma != Vector3::zeros() || triad.misalignment_sigma != Matrix3::zeros()
        })
    }
}

const FLICKER: usize = FLICKER_PROCESSES.len();

/// Sensor axes: three gyros, three accelerometers.
pub const AXES: usize = 6;

/// Elements of scale factor and misalignment of both triads.
pub const ELEMENTS: usize = 18;

/// Gravity's deflections north and east, and its anomaly.
pub const FIELDS: usize = 3;

/// Number of possible processes.
pub const COUNT: usize = 3 * AXES + FLICKER * AXES + ELEMENTS + FIELDS + 1;

/// The quantity to which a process adds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Input {
    /// The signal of a sensor axis.
    Axis(usize),
    /// An element of the scale factor and misalignment matrices: 9 of the gyros, 9 of the accelerometers, by columns.
    Element(usize),
    /// A field of gravity.
    Field(usize),
    /// The height that the altimeter shows.
    Altimeter,
}

/// Inputs to which processes add that change within a stretch: axes and fields.
pub const LINES: usize = AXES + FIELDS;

impl Input {
    /// Its place among [`LINES`].
    pub fn line(self) -> Option<usize> {
        match self {
            Self::Axis(axis) => Some(axis),
            Self::Field(field) => Some(AXES + field),
            Self::Element(_) | Self::Altimeter => None,
        }
    }

    /// The input at a place among [`LINES`].
    pub fn of_line(line: usize) -> Self {
        if line < AXES { Self::Axis(line) } else { Self::Field(line - AXES) }
    }
}

/// The evolution of a process.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// Drawn once a run.
    Constant,
    /// Gauss-Markov of this correlation time [s].
    Markov(f64),
    /// Gauss-Markov of this correlation distance over ground [m].
    MarkovOverGround(f64),
    /// Random walk from 0 at the start of the run.
    Walk,
}

/// A process: the quantity to which it adds, its evolution, and its standard deviation, of a walk that after 1 s, which is its density
/// [u/√s].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Source {
    pub input: Input,
    pub kind: Kind,
    pub sigma: f64,
}

impl Source {
    /// The process at `place` of [`COUNT`]; unused processes have a sigma of 0.
    pub fn at(place: usize, parameters: &Parameters<'_>) -> Self {
        let triad = |axis: usize| parameters.of_axis(axis);
        let constant = |input, sigma| Self { input, kind: Kind::Constant, sigma };
        let mut place = place;
        if place < AXES {
            return constant(Input::Axis(place), triad(place).bias_sigma[place % 3]);
        }
        place -= AXES;
        if place < AXES {
            let (sigma, time_s) =
                (triad(place).markov_sigma[place % 3], triad(place).markov_time_s[place % 3]);
            return Self { input: Input::Axis(place), kind: Kind::Markov(time_s), sigma };
        }
        place -= AXES;
        if place < AXES {
            let sigma = triad(place).rate_random_walk[place % 3];
            return Self { input: Input::Axis(place), kind: Kind::Walk, sigma };
        }
        place -= AXES;
        if place < AXES * FLICKER {
            let (axis, (time_s, deviation)) = (place / FLICKER, FLICKER_PROCESSES[place % FLICKER]);
            let sigma = triad(axis).flicker[axis % 3] * deviation;
            return Self { input: Input::Axis(axis), kind: Kind::Markov(time_s), sigma };
        }
        place -= AXES * FLICKER;
        if place < ELEMENTS {
            let triad = triad(place / 9 * 3);
            let (row, column) = (place % 3, place / 3 % 3);
            let sigma = if row == column {
                triad.scale_factor_sigma[row]
            } else {
                triad.misalignment_sigma[(row, column)]
            };
            return constant(Input::Element(place), sigma);
        }
        place -= ELEMENTS;
        if place < FIELDS {
            let field = parameters.gravity.fields()[place];
            let kind = Kind::MarkovOverGround(field.distance_m);
            return Self { input: Input::Field(place), kind, sigma: field.sigma };
        }
        let AltimeterParameters { markov_sigma_m, markov_time_s, .. } = *parameters.altimeter;
        Self { input: Input::Altimeter, kind: Kind::Markov(markov_time_s), sigma: markov_sigma_m }
    }

    /// Its evolution over `t` [s] and `ground_m` [m] over ground. `walks` are the variances [u²] of the walk of each axis: those at the
    /// start, then those at the end.
    pub fn advance(&self, t: f64, ground_m: f64, walks: &mut [f64; AXES]) -> Advance {
        match (self.kind, self.input) {
            (Kind::Walk, Input::Axis(axis)) if self.sigma != 0.0 => {
                let (start, step) = (walks[axis].sqrt(), self.sigma * t.sqrt());
                walks[axis] += step * step;
                Advance::walk(start, step)
            }
            (Kind::Walk, Input::Axis(axis)) => {
                walks[axis] = 0.0;
                Advance::still(0.0)
            }
            (Kind::Markov(time_s), _) if self.sigma != 0.0 => Advance::markov(t / time_s, self.sigma),
            (Kind::MarkovOverGround(distance_m), _) if self.sigma != 0.0 && ground_m != 0.0 => {
                Advance::markov(ground_m / distance_m, self.sigma)
            }
            _ => Advance::still(self.sigma),
        }
    }

    /// Present standard deviation; `walks` are the variances of the walks [u²].
    pub fn deviation(&self, walks: &[f64; AXES]) -> f64 {
        match (self.kind, self.input) {
            (Kind::Walk, Input::Axis(axis)) => walks[axis].sqrt(),
            _ => self.sigma,
        }
    }
}
