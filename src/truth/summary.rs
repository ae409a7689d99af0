//! The motion of a flight in figures, which reveal a wrong unit of the host or exchanged axes.

use nalgebra::Vector3;

use super::{Recent, TruthPoint};
use crate::base::math::{atan2, relative_rotation, rotation_vector};
use crate::base::snapshot::{ANY, CLOCK_S, COUNT, moved_clock, stored};
use crate::earth::Earth;
use crate::earth::state::BodyAxes;

/// A value and its time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Extreme {
    /// The value.
    pub value: f64,
    /// Time stamp of its sample, of the end of its interval [s].
    pub time_s: f64,
}

stored!(Extreme { value: ANY, time_s: CLOCK_S });

impl Extreme {
    /// Keeps `value` if its size is larger.
    pub(crate) fn take_larger(&mut self, value: f64, time_s: f64) {
        if value.abs() > self.value.abs() {
            *self = Self { value, time_s };
        }
    }
}

/// Figures of the true motion over the intervals that were added. Rates, accelerations and forces are means over an interval,
/// from one sample to the next.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TruthSummary {
    /// Number of intervals.
    pub intervals: u64,
    /// Number of intervals that are gaps: more than 2.5 times as long as each of the two before.
    pub gaps: u64,
    /// Sum of the lengths of the intervals [s].
    pub flown_s: f64,
    /// Time stamp of the first sample [s].
    pub first_s: f64,
    /// Time stamp of the last sample [s].
    pub last_s: f64,
    /// Longest interval [s].
    pub interval_max: Extreme,
    /// Largest rotation in an interval [rad].
    pub turn_max: Extreme,
    /// Largest angular rate: by the attitudes against the Earth, or the host's own against inertial space [rad/s].
    pub rate_max: Extreme,
    /// Largest acceleration against the Earth, by the velocities [m/s²].
    pub acceleration_max: Extreme,
    /// Largest specific force: by the velocities and gravity, or the host's own [m/s²].
    pub force_max: Extreme,
    /// Largest displacement in an interval that the velocities do not explain [m].
    pub inconsistency_max: Extreme,
    /// Largest speed against the Earth [m/s].
    pub speed_max: Extreme,
    /// Number of samples faster than [`Self::FAST_M_S`]; only they count for sideslip and angle of attack.
    pub fast_samples: u64,
    /// Sideslip of the largest size: from the plane of symmetry to the velocity against the Earth, to the right [rad].
    pub sideslip_max: Extreme,
    /// Angle of attack of the largest size: from the velocity against the Earth to the forward axis, in the plane of symmetry
    /// [rad].
    pub attack_max: Extreme,
    /// Lowest height [m].
    pub height_min: Extreme,
    /// Highest height [m].
    pub height_max: Extreme,
}

stored!(TruthSummary {
    intervals: COUNT,
    gaps: COUNT,
    flown_s: CLOCK_S,
    first_s: CLOCK_S,
    last_s: CLOCK_S,
    interval_max,
    turn_max,
    rate_max,
    acceleration_max,
    force_max,
    inconsistency_max,
    speed_max,
    fast_samples: COUNT,
    sideslip_max,
    attack_max,
    height_min,
    height_max,
});

impl TruthSummary {
    /// Speed above which sideslip and angle of attack count [m/s]. Slower helicopters fly sideways.
    pub const FAST_M_S: f64 = 30.0;

    /// Adds the interval that `recent` ends. `axes` are the sensor axes of the samples.
    pub fn add(&mut self, earth: &Earth, axes: BodyAxes, recent: &Recent<'_>) {
        let Recent { next, current, before } = *recent;
        if self.intervals == 0 {
            let height = Extreme { value: current.sample.place.height_m, time_s: current.time_s };
            (self.first_s, self.height_min, self.height_max) = (current.time_s, height, height);
        }
        // No interval has ended there.
        if before[0].is_none() {
            self.add_point(axes, current);
        }
        self.add_point(axes, next);
        let (t, time_s) = (next.interval_s, next.time_s);
        self.intervals += 1;
        self.gaps += u64::from(recent.gap_ratio().is_some());
        self.flown_s = moved_clock(self.flown_s, t);
        self.last_s = time_s;
        self.interval_max.take_larger(t, time_s);
        let length = |v: Vector3<f64>| v.norm_squared().sqrt();
        let turn = length(rotation_vector(&relative_rotation(&current.state.q_eb, &next.state.q_eb)));
        self.turn_max.take_larger(turn, time_s);
        self.rate_max.take_larger(turn / t, time_s);
        let a_e = (next.state.v_e - current.state.v_e) / t;
        self.acceleration_max.take_larger(length(a_e), time_s);
        let v_e = (current.state.v_e + next.state.v_e) * 0.5;
        // f = a + 2 W×v - g
        let coriolis = Vector3::new(-v_e.y, v_e.x, 0.0) * (2.0 * earth.rate_rad_s);
        let gravity_e = (current.gravity_e + next.gravity_e) * 0.5;
        self.force_max.take_larger(length(a_e + coriolis - gravity_e), time_s);
        let unexplained = next.state.r_e - current.state.r_e - v_e * t;
        self.inconsistency_max.take_larger(length(unexplained), time_s);
    }

    fn add_point(&mut self, axes: BodyAxes, point: &TruthPoint) {
        let (time_s, height_m) = (point.time_s, point.sample.place.height_m);
        let height = Extreme { value: height_m, time_s };
        if height_m < self.height_min.value {
            self.height_min = height;
        }
        if height_m > self.height_max.value {
            self.height_max = height;
        }
        let length = |v: &Vector3<f64>| v.norm_squared().sqrt();
        if let Some(rate) = &point.sample.omega_ib_b {
            self.rate_max.take_larger(length(rate), time_s);
        }
        if let Some(force) = &point.sample.f_b {
            self.force_max.take_larger(length(force), time_s);
        }
        let speed = length(&point.state.v_e);
        self.speed_max.take_larger(speed, time_s);
        if speed > Self::FAST_M_S {
            let v_b = point.to_earth.tr_mul(&point.state.v_e);
            let [right, forward, up] = match axes {
                BodyAxes::RightForwardUp => [v_b.x, v_b.y, v_b.z],
                BodyAxes::ForwardRightDown => [v_b.y, v_b.x, -v_b.z],
            };
            self.fast_samples += 1;
            self.sideslip_max.take_larger(atan2(right, (forward * forward + up * up).sqrt()), time_s);
            self.attack_max.take_larger(atan2(-up, forward), time_s);
        }
    }
}
