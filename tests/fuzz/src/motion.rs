//! The motion of a simulator's vehicle: along a parallel, rolling and turning.

use std::f64::consts::{FRAC_PI_2, PI};

use sins::abi::*;

use crate::input::Input;

/// A motion, which gives the next plausible sample.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    pub time_s: f64,
    /// Time since the motion began [s].
    elapsed_s: f64,
    interval_s: f64,
    longest_s: f64,
    /// Whether samples are at whole intervals from the first.
    is_periodic: bool,
    latitude_rad: f64,
    longitude_rad: f64,
    height_m: f64,
    east_m_s: f64,
    up_m_s: f64,
    amplitude_rad: f64,
    rate_rad_s: f64,
    heading_rad_s: f64,
    is_forward_right_down: bool,
    /// Flags of each sample.
    pub flags: u32,
}

impl Motion {
    /// A motion that a simulator with `options` can usually follow.
    pub fn new(input: &mut Input, options: &sins_options) -> Self {
        let is_periodic = options.sample_period_s > 0.0;
        let interval_s = match is_periodic {
            true => options.sample_period_s,
            false => input.pick(&[0.01, 0.01, 0.0078125, 0.1, 1.0, 5e-5, 2.5, options.max_gap_s]),
        };
        let latitude_rad = match input.byte() {
            0..128 => 0.7,
            kind => {
                input.pick(&[0.0, FRAC_PI_2, -FRAC_PI_2, FRAC_PI_2 - 1e-6, 1.5698, -1.5, 1e-9])
                    * if kind == 255 { 0.5 } else { 1.0 }
            }
        };
        let height_m = input.pick(&[1000.0, 1000.0, 0.0, -20e3, 2000e3, 100e3]);
        let speed_m_s: f64 = input.pick(&[100.0, 100.0, 0.0, 250.0, -8e3, 20e3, 1e-3]);
        // Limits the rate of the longitude to one radian per second.
        let radius_m = 6.4e6 * latitude_rad.cos();
        Self {
            time_s: input.pick(&[0.0, 0.0, 0.0, 1.7e9, -1e10, 1e10 - 1000.0, 1e3, 0.3]),
            elapsed_s: 0.0,
            interval_s: interval_s.min(options.max_gap_s),
            longest_s: options.max_gap_s,
            is_periodic,
            latitude_rad,
            longitude_rad: input.pick(&[0.0, 0.5, -100.0, 100.0, PI]),
            height_m,
            east_m_s: speed_m_s.clamp(-radius_m, radius_m),
            up_m_s: input.pick(&[0.0, 0.0, 0.0, 10.0, -3000.0]),
            amplitude_rad: input.pick(&[0.0, 0.1, 0.6, 1.5, 3.0]),
            rate_rad_s: 2.0 * PI * input.pick(&[0.1, 1.0, 0.01, 5.0]),
            heading_rad_s: input.pick(&[0.0, 0.01, 1.0, -20.0]),
            is_forward_right_down: options.axes == SINS_AXES_FORWARD_RIGHT_DOWN,
            flags: match input.byte() {
                kind @ 0..128 => u32::from(kind % 2) * SINS_SAMPLE_NO_VELOCITY,
                kind => u32::from(kind) % 16,
            },
        }
    }

    /// The motion at the next sample: mostly one interval later, sometimes after a gap.
    pub fn next(mut self, input: &mut Input) -> Self {
        let intervals: f64 = match input.byte() {
            0..216 => 1.0,
            216..224 => 2.0,
            224..230 => 3.0,
            230..236 => 10.0,
            236..242 => 100.0,
            242..246 => self.longest_s / self.interval_s,
            246 => 1.5 * self.longest_s / self.interval_s,
            // Not a whole number of intervals, if the motion is not periodic.
            247..254 => 0.5 + f64::from(input.byte()) / 128.0,
            _ => 4.0,
        };
        let step_s = self.interval_s * if self.is_periodic { intervals.floor().max(1.0) } else { intervals };
        self.advance(step_s);
        self
    }

    fn advance(&mut self, step_s: f64) {
        self.time_s += step_s;
        self.elapsed_s += step_s;
        let (sin, cos) = self.latitude_rad.sin_cos();
        let prime_vertical_m = 6_378_137.0 / (1.0 - 0.006_694_38 * sin * sin).sqrt();
        let radius_m = (prime_vertical_m + self.height_m) * cos;
        if radius_m > 1.0 {
            self.longitude_rad += self.east_m_s / radius_m * step_s;
        }
        if self.longitude_rad.abs() > 100.0 {
            self.longitude_rad %= 2.0 * PI;
        }
        let height_m = self.height_m + self.up_m_s * step_s;
        if (-20e3..=2000e3).contains(&height_m) {
            self.height_m = height_m;
        } else {
            self.up_m_s = 0.0;
        }
    }

    pub fn sample(&self) -> sins_flight_sample {
        let phase = self.rate_rad_s * self.elapsed_s;
        let (roll, roll_rate) =
            (self.amplitude_rad * phase.sin(), self.amplitude_rad * self.rate_rad_s * phase.cos());
        let (pitch, heading) = (0.02, (self.heading_rad_s * self.elapsed_s) % 1e3);
        let (sin, cos) = roll.sin_cos();
        let turn = self.heading_rad_s;
        let rate = self.axes([roll_rate - 0.02 * turn, turn * sin, turn * cos]);
        let force = self.axes([0.2, -9.8 * sin, -9.8 * cos]);
        self.flagged(sins_flight_sample {
            struct_size: size_of::<sins_flight_sample>() as u32,
            flags: 0,
            time_s: self.time_s,
            latitude_rad: self.latitude_rad,
            longitude_rad: self.longitude_rad,
            height_m: self.height_m,
            velocity_enu_m_s: [self.east_m_s, 0.0, self.up_m_s],
            roll_rad: roll,
            pitch_rad: pitch,
            heading_rad: heading,
            angular_rate_rad_s: rate,
            specific_force_m_s2: force,
            temperature_c: 20.0 + 10.0 * phase.sin(),
        })
    }

    /// The sample with the flags of this motion.
    pub fn flagged(&self, sample: sins_flight_sample) -> sins_flight_sample {
        sins_flight_sample { flags: self.flags, ..sample }
    }

    /// A vector along forward, right, down in sensor axes.
    fn axes(&self, [forward, right, down]: [f64; 3]) -> [f64; 3] {
        if self.is_forward_right_down { [forward, right, down] } else { [right, forward, -down] }
    }
}
