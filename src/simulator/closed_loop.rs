//! The closed loop: a small trim of the ideal signals that keeps an error-free navigator, the shadow, at the truth for any time.
//! The trim compensates the errors of the generator and the mechanization, so its size is the measure of these errors.

use nalgebra::Vector3;

use crate::base::error::Error;
use crate::base::math::rotate_inverse;
use crate::base::snapshot::{CLOCK_S, Numbers, Reader, Stored, Writer, moved_clock, stored};
use crate::earth::state::EarthFixedState;
use crate::mechanization::Mechanization;
use crate::signal::Increment;

/// Damping of the position loop.
const DAMPING: f64 = 0.8;

/// Stiffness in addition to 1/τ² [1/s²]. It must exceed 2 g/R = 3.1e-6 of the vertical channel.
const STIFFNESS: f64 = 4e-6;

/// The trim counts as settled after this many time constants.
const SETTLING: f64 = 10.0;

/// The largest trim since it has settled.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TrimFigures {
    /// Largest trim of the angular rate [rad/s].
    pub rate_rad_s: f64,
    /// Largest trim of the specific force [m/s²].
    pub force_m_s2: f64,
}

/// The loop.
#[derive(Debug, Clone)]
pub(super) struct ClosedLoop {
    time_constant_s: f64,
    /// The error-free navigator; `None` while the navigator itself is error-free.
    shadow: Option<Mechanization>,
    /// Trim of the interval to come, sensor axes: rate [rad/s], force [m/s²].
    rate_b: Vector3<f64>,
    force_b: Vector3<f64>,
    settles_at_s: f64,
    largest: TrimFigures,
}

stored!(TrimFigures { rate_rad_s: 1e12, force_m_s2: 1e12 } then |trim, from| {
    let least = trim.rate_rad_s.min(trim.force_m_s2);
    from.require(least >= 0.0, least, "must not be negative")
});

/// The values are read into a loop that was made with a shadow.
impl Stored for ClosedLoop {
    fn save(&self, to: &mut Writer<'_>) {
        let Self { time_constant_s: _, shadow, rate_b, force_b, settles_at_s, largest } = self;
        to.flag(shadow.is_some());
        if let Some(shadow) = shadow {
            shadow.save(to);
        }
        rate_b.save(to);
        force_b.save(to);
        settles_at_s.save(to);
        largest.save(to);
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        let Self { time_constant_s: _, shadow, rate_b, force_b, settles_at_s, largest } = self;
        from.enter("snapshot: ClosedLoop");
        match (from.flag()?, shadow.as_mut()) {
            (true, Some(shadow)) => shadow.load(from)?,
            _ => *shadow = None,
        }
        rate_b.load(from, 1e12)?;
        force_b.load(from, 1e12)?;
        settles_at_s.load(from, CLOCK_S)?;
        largest.load(from)
    }
}

impl ClosedLoop {
    /// Starts at `start_s` [s]. `shadow` is at the truth; `None` if the navigator itself is at the truth.
    pub fn new(time_constant_s: f64, start_s: f64, shadow: Option<Mechanization>) -> Self {
        Self {
            time_constant_s,
            shadow,
            rate_b: Vector3::zeros(),
            force_b: Vector3::zeros(),
            settles_at_s: start_s + SETTLING * time_constant_s,
            largest: TrimFigures::default(),
        }
    }

    /// Adds the trim to the increments of an interval of length `t` [s], in equal parts.
    pub fn trim(&self, increments: &mut [Increment], t: f64) {
        let part = t / increments.len() as f64;
        for increment in increments {
            increment.angle += self.rate_b * part;
            increment.velocity += self.force_b * part;
        }
    }

    /// The shadow, to be flown with the error-free increments. There is no shadow while the navigator itself is error-free. With
    /// `navigator_errs`, the shadow starts as a copy of `navigator`, which is free of errors until then.
    pub fn shadow(&mut self, navigator: &Mechanization, navigator_errs: bool) -> Option<&mut Mechanization> {
        if navigator_errs && self.shadow.is_none() {
            self.shadow = Some(*navigator);
        }
        self.shadow.as_mut()
    }

    /// Checks the shadow's solution.
    pub fn check(&self) -> Result<(), Error> {
        self.shadow.as_ref().map_or(Ok(()), Mechanization::check)
    }

    /// Adds `dv_e` [m/s] to the velocity of the shadow, if there is one, because the velocity of the truth was revised by `dv_e`.
    pub fn shift_velocity(&mut self, dv_e: &Vector3<f64>) {
        if let Some(shadow) = &mut self.shadow {
            shadow.shift_velocity(dv_e);
        }
    }

    /// Moves the clock of the run by `shift_s` [s].
    pub fn move_time(&mut self, shift_s: f64) {
        self.settles_at_s = moved_clock(self.settles_at_s, shift_s);
    }

    /// Follows a jump of the truth to `truth`, the true state of the sensors at `time_s` [s]. `navigator` and the shadow, which
    /// [`Self::shadow_mut`] gives, have already jumped. The trim settles anew.
    pub fn go_on(&mut self, navigator: &Mechanization, truth: &EarthFixedState, time_s: f64) {
        self.set_trim(navigator, truth);
        self.settles_at_s = time_s + SETTLING * self.time_constant_s;
    }

    /// The shadow, if it is not the navigator itself.
    pub fn shadow_mut(&mut self) -> Option<&mut Mechanization> {
        self.shadow.as_mut()
    }

    /// Computes the trim for the next interval: dw = -φ/τ, df = -Cᵀ (1.6/τ δv + (1/τ² + 4e-6) δr), where φ, δv, δr are the errors
    /// of the shadow relative to `truth`, the true state of the sensors at `time_s` [s].
    pub fn observe(&mut self, navigator: &Mechanization, truth: &EarthFixedState, time_s: f64) {
        self.set_trim(navigator, truth);
        if time_s >= self.settles_at_s {
            let TrimFigures { rate_rad_s, force_m_s2 } = &mut self.largest;
            *rate_rad_s = rate_rad_s.max(self.rate_b.norm_squared().sqrt());
            *force_m_s2 = force_m_s2.max(self.force_b.norm_squared().sqrt());
        }
    }

    fn set_trim(&mut self, navigator: &Mechanization, truth: &EarthFixedState) {
        let rate = 1.0 / self.time_constant_s;
        let error = self.shadow.as_ref().unwrap_or(navigator).minus(truth);
        let force_e = error.v_e * (-2.0 * DAMPING * rate) - error.r_e * (rate * rate + STIFFNESS);
        self.rate_b = error.rotation_b * -rate;
        self.force_b = rotate_inverse(&truth.q_eb, &force_e);
    }

    pub fn largest(&self) -> TrimFigures {
        self.largest
    }
}
