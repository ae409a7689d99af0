//! A step that is smooth to the third derivative, and functions made of such steps.

/// S(u) = 35 u⁴ - 84 u⁵ + 70 u⁶ - 20 u⁷ from 0 to 1 on 0..1, three derivatives zero at both ends.
pub(super) fn step(u: f64) -> f64 {
    let u = u.clamp(0.0, 1.0);
    let u2 = u * u;
    u2 * u2 * (35.0 - u * (84.0 - u * (70.0 - 20.0 * u)))
}

/// dS/du = 140 u³ (1 - u)³.
pub(super) fn step_slope(u: f64) -> f64 {
    let u = u.clamp(0.0, 1.0);
    let x = u * (1.0 - u);
    140.0 * x * x * x
}

/// ∫ S from 0 to u; beyond 1 it grows with slope 1.
fn step_integral(u: f64) -> f64 {
    if u > 1.0 {
        return 0.5 + (u - 1.0);
    }
    let u = u.max(0.0);
    let u4 = u * u * u * u;
    u4 * u * (7.0 - u * (14.0 - u * (10.0 - 2.5 * u)))
}

/// A window: rises over `ramp`, holds 1, falls over `ramp`, on 0..`length`, all in one unit of time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Window {
    pub length: f64,
    pub ramp: f64,
}

impl Window {
    /// A ramp of `wanted`, or of half of the length if that is shorter.
    pub fn new(length: f64, wanted: f64) -> Self {
        Self { length, ramp: wanted.min(0.5 * length) }
    }

    pub fn at(&self, t: f64) -> f64 {
        step(t / self.ramp) * step((self.length - t) / self.ramp)
    }

    pub fn slope(&self, t: f64) -> f64 {
        (step_slope(t / self.ramp) - step_slope((self.length - t) / self.ramp)) / self.ramp
    }

    /// ∫ from 0 to t; over all of it, length - ramp.
    pub fn integral(&self, t: f64) -> f64 {
        self.ramp
            * (step_integral(t / self.ramp) - step_integral((t - (self.length - self.ramp)) / self.ramp))
    }

    pub fn whole(&self) -> f64 {
        self.length - self.ramp
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn window_slope_and_integral_belong_to_the_window() {
        for window in [Window::new(10.0, 2.0), Window::new(3.0, 7.0)] {
            let h = 1e-4;
            for i in 1..100 {
                let t = window.length * f64::from(i) / 100.0;
                // Central differences: h²/6 of the third derivative, which is below 2e3 / ramp³.
                let bound = h * h / 6.0 * 2e3 / window.ramp.powi(3) + 1e-11;
                let slope = (window.at(t + h) - window.at(t - h)) / (2.0 * h);
                let value = (window.integral(t + h) - window.integral(t - h)) / (2.0 * h);
                assert!((slope - window.slope(t)).abs() < bound, "{t} {slope} {}", window.slope(t));
                assert!((value - window.at(t)).abs() < bound);
            }
            assert!((window.integral(window.length) - window.whole()).abs() < 1e-14 * window.length);
            assert_eq!((window.at(0.0), window.at(window.length)), (0.0, 0.0));
        }
    }
}
