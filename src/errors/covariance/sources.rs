//! The random quantities of a run, each as a process of unit variance.

use nalgebra::{Matrix3, Vector3};

use super::line::Advance;
use crate::sensors::{
    AltimeterParameters, GravityDisturbanceParameters, Kind, OF_SIGNAL, TriadParameters, element_sigmas,
};

/// The random errors that the host has set.
#[derive(Clone, Copy)]
pub(crate) struct RandomErrors<'a> {
    /// Of each axis, the share of the signal that is in its output, and the density of the noise of a failure [u √s].
    pub outputs: [(f64, f64); AXES],
    pub gyro: &'a TriadParameters,
    pub accel: &'a TriadParameters,
    pub altimeter: &'a AltimeterParameters,
    pub gravity: &'a GravityDisturbanceParameters,
}

impl RandomErrors<'_> {
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

/// Sensor axes: three gyros, three accelerometers.
pub const AXES: usize = 6;

/// Elements of scale factor and misalignment of both triads.
pub const ELEMENTS: usize = 18;

/// Gravity's deflections north and east, and its anomaly.
pub const FIELDS: usize = 3;

/// Number of possible processes.
pub const COUNT: usize = OF_AXES.len() + ELEMENTS + FIELDS + 1;

/// Number of possible random walks.
pub const WALKS: usize = number(true);

/// Number of the processes of effects, or of the walks among them.
const fn number(of_walks: bool) -> usize {
    let (mut of_axis, mut k) = (0, 0);
    while k < OF_SIGNAL.len() {
        if OF_SIGNAL[k].are_walks || !of_walks {
            of_axis += OF_SIGNAL[k].count;
        }
        k += 1;
    }
    of_axis * AXES
}

/// The processes of the effects: of each its effect, its axis, its number in the effect, and its place among [`WALKS`] if it is a walk.
const OF_AXES: [[usize; 4]; number(false)] = {
    let mut all = [[0; 4]; number(false)];
    let (mut k, mut walks, mut effect) = (0, 0, 0);
    while effect < OF_SIGNAL.len() {
        let processes = &OF_SIGNAL[effect];
        let mut place = 0;
        while place < AXES * processes.count {
            all[k] = [effect, place / processes.count, place % processes.count, walks];
            walks += processes.are_walks as usize;
            (k, place) = (k + 1, place + 1);
        }
        effect += 1;
    }
    all
};

/// The quantity to which a process adds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorInput {
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

impl ErrorInput {
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

/// A process: the quantity to which it adds, its evolution, and its standard deviation; of a walk its density [u/√s].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Source {
    pub input: ErrorInput,
    pub kind: Kind,
    pub sigma: f64,
    /// Place of a walk among [`WALKS`].
    walk: usize,
}

impl Source {
    /// The [`COUNT`] possible processes; unused ones have a sigma of 0.
    pub fn all(parameters: &RandomErrors<'_>) -> impl Iterator<Item = Self> {
        let RandomErrors { gyro, accel, altimeter, .. } = *parameters;
        let triad = move |axis| if axis < 3 { gyro } else { accel };
        let of_signal = OF_AXES.iter().map(move |&[effect, axis, process, walk]| {
            let (kind, sigma) = (OF_SIGNAL[effect].of)(triad(axis), axis % 3, process);
            Self { input: ErrorInput::Axis(axis), kind, sigma, walk }
        });
        let sigmas = [element_sigmas(gyro), element_sigmas(accel)];
        let elements = (0..ELEMENTS).map(move |element| Self {
            input: ErrorInput::Element(element),
            kind: Kind::Constant,
            sigma: sigmas[element / 9][element % 9],
            walk: 0,
        });
        let fields = parameters.gravity.fields().into_iter().enumerate().map(|(field, of)| Self {
            input: ErrorInput::Field(field),
            kind: Kind::MarkovOverGround(of.distance_m),
            sigma: of.sigma,
            walk: 0,
        });
        let altimeter = Self {
            input: ErrorInput::Altimeter,
            kind: Kind::Markov(altimeter.markov_time_s),
            sigma: altimeter.markov_sigma_m,
            walk: 0,
        };
        of_signal.chain(elements).chain(fields).chain([altimeter])
    }

    /// Its evolution over `t` [s] and `ground_m` [m] over ground. `walks` are the variances [u²] of the walks: those at the start,
    /// then those at the end.
    pub fn advance(&self, t: f64, ground_m: f64, walks: &mut [f64; WALKS]) -> Advance {
        match self.kind {
            Kind::Walk if self.sigma != 0.0 => {
                let (start, step) = (walks[self.walk].sqrt(), self.sigma * t.sqrt());
                walks[self.walk] += step * step;
                Advance::walk(start, step)
            }
            Kind::Walk => {
                walks[self.walk] = 0.0;
                Advance::still(0.0)
            }
            Kind::Markov(time_s) if self.sigma != 0.0 => Advance::markov(t / time_s, self.sigma),
            Kind::MarkovOverGround(distance_m) if self.sigma != 0.0 && ground_m != 0.0 => {
                Advance::markov(ground_m / distance_m, self.sigma)
            }
            _ => Advance::still(self.sigma),
        }
    }

    /// Present standard deviation; `walks` are the variances of the walks [u²].
    pub fn deviation(&self, walks: &[f64; WALKS]) -> f64 {
        match self.kind {
            Kind::Walk => walks[self.walk].sqrt(),
            _ => self.sigma,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An effect states of its processes whether they are walks, and each walk of an axis has a variance of its own.
    #[test]
    fn each_walk_has_a_place_of_its_own() {
        let triad = TriadParameters::default();
        let mut walks: Vec<usize> = Vec::new();
        for [effect, axis, process, walk] in OF_AXES {
            let processes = &OF_SIGNAL[effect];
            let (kind, _) = (processes.of)(&triad, axis % 3, process);
            assert_eq!(kind == Kind::Walk, processes.are_walks, "effect {effect}");
            walks.extend(processes.are_walks.then_some(walk));
        }
        assert!(walks.into_iter().eq(0..WALKS));
    }
}
