//! Steps of the positions: a quantum of which all values are multiples, or numbers of 32 bits.

use super::row::Row;
use crate::base::math::{Euler, wrap_angle};
use crate::base::units::DEG;
use crate::earth::Earth;

/// Steps of latitude and longitude [deg], the coarsest first. Records of gliders have thousandths of a minute of arc.
const ANGLES_DEG: [f64; 8] = [1e-2, 1e-3, 1e-4, 1.0 / 60e3, 1e-5, 1.0 / 600e3, 1e-6, 1e-7];

/// Steps of the height [m]: 100, 25 and 10 feet, and metres.
const HEIGHTS_M: [f64; 8] = [30.48, 10.0, 7.62, 3.048, 1.0, 0.3048, 0.1, 0.01];

/// Steps of an angle of the attitude [deg].
const ATTITUDE_DEG: [f64; 8] = [1.0, 0.5, 0.25, 0.2, 0.1, 0.05, 0.02, 0.01];

/// Bends by one step that rounding makes at least.
const LEAST_BENDS: u64 = 20;

/// A value is a multiple of a step if it is within this share of the step. A value agrees by chance with a probability of 0.04.
const WITHIN: f64 = 0.02;

/// Different values that must agree, and steps over which they must extend: by chance they do in 3 of a million logs.
const LEAST_VALUES: u32 = 4;
const LEAST_STEPS: f64 = 2.9;

/// The steps of which all values of a coordinate so far are multiples.
#[derive(Debug, Clone)]
struct Steps {
    /// A bit for each step.
    fits: u8,
    /// Whether all values are numbers of 32 bits, in the unit of the steps and in radians.
    is_float32: [bool; 2],
    /// Distance between two numbers of 32 bits at the last value, in the unit of the steps.
    float32_step: [f64; 2],
    /// Number of values beyond all values before them.
    extremes: u32,
    low: f64,
    high: f64,
}

impl Steps {
    const fn new() -> Self {
        Self {
            fits: u8::MAX,
            is_float32: [true; 2],
            float32_step: [0.0; 2],
            extremes: 0,
            low: f64::INFINITY,
            high: f64::NEG_INFINITY,
        }
    }

    /// Adds a `value`, which is `in_radians` if it is an angle.
    fn add(&mut self, steps: &[f64; 8], value: f64, in_radians: Option<f64>) {
        if value < self.low || value > self.high {
            (self.low, self.high) = (self.low.min(value), self.high.max(value));
            self.extremes = self.extremes.saturating_add(1);
        }
        for (bit, step) in steps.iter().enumerate() {
            if self.fits & (1 << bit) != 0 && !is_multiple(value, *step) {
                self.fits &= !(1 << bit);
            }
        }
        let numbers = [(value, 1.0), (in_radians.unwrap_or(f64::MAX), 1.0 / DEG)];
        for (index, (number, unit)) in numbers.into_iter().enumerate() {
            if !self.is_float32[index] {
                continue;
            }
            let near = number as f32;
            let spacing = f64::from(f32::from_bits(near.abs().to_bits() + 1)) - f64::from(near.abs());
            self.is_float32[index] = (number - f64::from(near)).abs() < WITHIN * spacing;
            self.float32_step[index] = spacing * unit;
        }
    }

    /// The step, and whether it is that of numbers of 32 bits.
    fn step(&self, steps: &[f64; 8]) -> Option<(f64, bool)> {
        if self.extremes < LEAST_VALUES {
            return None;
        }
        // Values that hardly differ are multiples of any step that one of them is.
        let is_crossed = |step: f64| self.high - self.low >= LEAST_STEPS * step;
        let fits = |bit: usize| self.fits & (1 << bit) != 0 && is_crossed(steps[bit]);
        if let Some(bit) = (0..steps.len()).find(|bit| fits(*bit)) {
            return Some((steps[bit], false));
        }
        let is = self.is_float32.iter().position(|is| *is)?;
        Some((self.float32_step[is], true)).filter(|(step, _)| self.fits == 0 && is_crossed(*step))
    }
}

fn is_multiple(value: f64, step: f64) -> bool {
    let multiple = value / step;
    (multiple - multiple.round()).abs() <= WITHIN
}

/// Steps of an angle, whose values go on beyond a turn.
#[derive(Debug, Clone)]
struct AngleSteps {
    of: Steps,
    /// The last value, and the one before less it [rad].
    last: [f64; 2],
    /// Second differences that are not 0, and those of one step.
    bends: [u64; 2],
}

impl AngleSteps {
    const fn new() -> Self {
        Self { of: Steps::new(), last: [0.0; 2], bends: [0; 2] }
    }

    fn add(&mut self, angle: f64) {
        let difference = wrap_angle(angle - self.last[0]);
        self.of.add(&ATTITUDE_DEG, (self.last[0] + difference) / DEG, None);
        if let Some((step, false)) = self.of.step(&ATTITUDE_DEG) {
            let bend = (difference - self.last[1]).abs() / (step * DEG);
            self.bends[0] += u64::from(bend > 0.5);
            self.bends[1] += u64::from((0.5..1.5).contains(&bend));
        }
        self.last = [self.last[0] + difference, difference];
    }

    /// The step [rad]; 0: none. Values that are rounded bend by one step; a turn by whole degrees a row does not.
    fn step_rad(&self) -> f64 {
        let is_rounded = self.bends[1] >= LEAST_BENDS && 2 * self.bends[1] > self.bends[0];
        let step = self.of.step(&ATTITUDE_DEG).filter(|(_, is_float32)| is_rounded && !is_float32);
        step.map_or(0.0, |(step, _)| step * DEG)
    }
}

/// Steps of roll, pitch and heading.
#[derive(Debug, Clone)]
pub(super) struct AttitudeSteps([AngleSteps; 3]);

impl AttitudeSteps {
    pub const fn new() -> Self {
        Self([const { AngleSteps::new() }; 3])
    }

    pub fn add(&mut self, euler: &Euler) {
        for (steps, angle) in self.0.iter_mut().zip([euler.roll, euler.pitch, euler.heading]) {
            steps.add(angle);
        }
    }

    /// Each [rad]; 0: none.
    pub fn steps_rad(&self) -> [f64; 3] {
        [0, 1, 2].map(|angle| self.0[angle].step_rad())
    }
}

/// Steps of the positions.
#[derive(Debug, Clone)]
pub(super) struct Resolution {
    latitude: Steps,
    longitude: Steps,
    height: Steps,
    /// Steps to the east, to the north and up [m]; 0: none.
    pub steps_m: [f64; 3],
    /// Whether the steps of latitude or longitude are those of numbers of 32 bits.
    pub is_float32: bool,
}

impl Resolution {
    pub const fn new() -> Self {
        Self {
            latitude: Steps::new(),
            longitude: Steps::new(),
            height: Steps::new(),
            steps_m: [0.0; 3],
            is_float32: false,
        }
    }

    pub fn add(&mut self, earth: &Earth, row: &Row) {
        let place = &row.place;
        let angles = [place.longitude_rad, place.latitude_rad];
        for (steps, angle) in [&mut self.longitude, &mut self.latitude].into_iter().zip(angles) {
            steps.add(&ANGLES_DEG, angle / DEG, Some(angle));
        }
        self.height.add(&HEIGHTS_M, place.height_m, None);
        let up = row.axes[2];
        let radii = earth.radii(up.z);
        let cosine = (1.0 - up.z * up.z).max(0.0).sqrt();
        let steps = [self.longitude.step(&ANGLES_DEG), self.latitude.step(&ANGLES_DEG)];
        let metres = [radii.transverse_m * cosine, radii.meridian_m];
        self.is_float32 = false;
        for ((step_m, step), metres) in self.steps_m.iter_mut().zip(steps).zip(metres) {
            let (degrees, is_float32) = step.unwrap_or_default();
            *step_m = degrees * DEG * metres;
            self.is_float32 |= is_float32;
        }
        self.steps_m[2] = self.height.step(&HEIGHTS_M).map_or(0.0, |(step, _)| step);
    }

    /// The larger of the horizontal steps [m].
    pub fn horizontal_m(&self) -> f64 {
        self.steps_m[0].max(self.steps_m[1])
    }
}
