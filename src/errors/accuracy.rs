//! Accuracy figures of one run, as in data sheets. One run is no ensemble.

use nalgebra::Vector3;

use super::NavigationErrors;
use crate::base::snapshot::{CLOCK_S, COUNT, NO_SQUARE, moved_clock, stored};

/// R50 = 0.8326 √(mean RER²): half of the radial errors, circular normal distribution (√ln 2).
const RADIAL_CEP: f64 = 0.832_554_611_157_697_8;

/// R95 = 1.7308 √(mean RER²): 95 % of the radial errors, circular normal distribution (√ln 20).
const RADIAL_95: f64 = 1.730_818_382_602_285;

/// Start of the window of the radial error rate, as time since the start [s]: as t → 0 the rate is the initial error divided by 0.
const WINDOW_START_S: f64 = 300.0;

/// Schuler period 2π √(R/g) [s]: 84.4 min. Within a period the errors swing back, so the rates depend on the moment.
pub const SCHULER_S: f64 = 5064.0;

/// Shortest interval between two samples of the errors [s].
const SAMPLE_INTERVAL_S: f64 = 1.0;

/// Least n Σt² - (Σt)² of a line [s²]: two samples are about one sampling interval apart, and more have a larger spread.
const LEAST_SPREAD_S2: f64 = 0.5 * SAMPLE_INTERVAL_S * SAMPLE_INTERVAL_S;

/// Sums over the run so far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accuracy {
    start_s: f64,
    next_s: f64,
    /// Samples that are not near a pole.
    samples: u64,
    velocity_squares: Vector3<f64>,
    windowed: u64,
    rate_squares: f64,
    /// Σ 1, t, t², r, t r over the window for the straight line through the radial error.
    line: [f64; 5],
}

stored!(Accuracy {
    start_s: CLOCK_S,
    next_s: CLOCK_S,
    samples: COUNT,
    velocity_squares: SUMS,
    windowed: COUNT,
    rate_squares: SUMS,
    line: SUMS,
} then |sums, from| {
    let [n, t, t2, r, tr] = sums.line;
    let squares = sums.velocity_squares.iter().chain([&sums.rate_squares, &t2]);
    for &square in squares.chain([&t, &r, &tr]) {
        from.require(square >= 0.0, square, NO_SQUARE)?;
    }
    from.require(n == sums.windowed as f64, n, "must be the number of samples in the window")
});

/// Bound of the sums over a run: no run has enough samples for it, with squares of 1e9 m/s or m, or times of 2e10 s.
const SUMS: f64 = 1e40;

/// Accuracy figures of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AccuracyFigures {
    /// Time since the navigation started [s].
    pub duration_s: f64,
    /// Start of the window of the radial error rate, as time since the start [s].
    pub window_start_s: f64,
    /// Number of samples in the window. While it is 0, the rates are 0.
    pub window_samples: u64,
    /// √(mean RER²), RER = radial position error / time since the start [m/s].
    pub radial_error_rate_rms_m_s: f64,
    /// Slope of the straight line of least squares through the radial position error [m/s].
    pub radial_error_slope_m_s: f64,
    /// Root mean square velocity error, east, north, up, of the samples not within 20 km of the Earth's axis [m/s].
    pub velocity_rms_n: Vector3<f64>,
}

impl Accuracy {
    /// Starts at the time `start_s` [s].
    pub fn new(start_s: f64) -> Self {
        Self {
            start_s,
            next_s: start_s + SAMPLE_INTERVAL_S,
            samples: 0,
            velocity_squares: Vector3::zeros(),
            windowed: 0,
            rate_squares: 0.0,
            line: [0.0; 5],
        }
    }

    /// Whether the errors at `time_s` [s] are to be added.
    #[inline]
    pub fn is_due(&self, time_s: f64) -> bool {
        time_s >= self.next_s
    }

    /// Adds the errors at `time_s` [s]. Near a pole the velocity errors are left out: at the pole itself the east and north axes of
    /// truth and solution differ by any angle, and a perfect run at 250 m/s would show 6 m/s.
    pub fn add(&mut self, time_s: f64, errors: &NavigationErrors, near_pole: bool) {
        self.next_s = time_s + SAMPLE_INTERVAL_S * (1.0 - 1e-6);
        if !near_pole {
            self.samples += 1;
            self.velocity_squares = (self.velocity_squares
                + errors.velocity_n.component_mul(&errors.velocity_n))
            .map(|sum| sum.min(SUMS));
        }
        let t = time_s - self.start_s;
        if t >= WINDOW_START_S {
            let r = errors.position_n.xy().norm_squared().sqrt();
            self.windowed += 1;
            self.rate_squares = (self.rate_squares + (r / t) * (r / t)).min(SUMS);
            for (sum, term) in self.line.iter_mut().zip([1.0, t, t * t, r, t * r]) {
                *sum = (*sum + term).min(SUMS);
            }
        }
    }

    /// Follows a clock of the run that was moved by `shift_s` [s].
    pub(crate) fn move_time(&mut self, shift_s: f64) {
        self.start_s = moved_clock(self.start_s, shift_s);
        self.next_s = moved_clock(self.next_s, shift_s);
    }

    /// The figures at `time_s` [s].
    pub fn figures(&self, time_s: f64) -> AccuracyFigures {
        let mean = |sum: f64, count: u64| if count > 0 { sum / count as f64 } else { 0.0 };
        let [n, t, t2, r, tr] = self.line;
        let spread = n * t2 - t * t;
        AccuracyFigures {
            duration_s: time_s - self.start_s,
            window_start_s: WINDOW_START_S,
            window_samples: self.windowed,
            radial_error_rate_rms_m_s: mean(self.rate_squares, self.windowed).sqrt(),
            radial_error_slope_m_s: if spread > LEAST_SPREAD_S2 { (n * tr - t * r) / spread } else { 0.0 },
            velocity_rms_n: self.velocity_squares.map(|sum| mean(sum, self.samples).sqrt()),
        }
    }
}

impl AccuracyFigures {
    /// Whether the rates are figures of the INS, which every display needs: it has navigated for a Schuler period.
    pub fn has_rates(&self) -> bool {
        self.window_samples > 0 && self.duration_s >= SCHULER_S
    }

    /// R50 = 0.8326 √(mean RER²) [m/s], circular normal distribution.
    pub fn cep_rate_m_s(&self) -> f64 {
        RADIAL_CEP * self.radial_error_rate_rms_m_s
    }

    /// R95 = 1.7308 √(mean RER²) [m/s], circular normal distribution.
    pub fn radial_95_rate_m_s(&self) -> f64 {
        RADIAL_95 * self.radial_error_rate_rms_m_s
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::units::NMI_PER_HOUR;

    /// An error that grows by 1 nmi/h: every figure has its closed form.
    #[test]
    fn a_steady_drift_gives_its_own_rate() {
        let mut accuracy = Accuracy::new(100.0);
        let velocity_n = Vector3::new(0.3 * NMI_PER_HOUR, 0.4 * NMI_PER_HOUR, 0.0);
        let mut errors = NavigationErrors { velocity_n, ..Default::default() };
        for second in 1..=3600 {
            let t = f64::from(second);
            errors.position_n = Vector3::new(0.6, 0.8, 9.0) * NMI_PER_HOUR * t;
            assert!(accuracy.is_due(100.0 + t));
            accuracy.add(100.0 + t, &errors, false);
            assert!(!accuracy.is_due(100.5 + t));
        }
        let figures = accuracy.figures(3700.0);
        // The rates are those of a Schuler period from its end on.
        assert!(!figures.has_rates() && !accuracy.figures(100.0 + 5063.9).has_rates());
        assert!(accuracy.figures(100.0 + 5064.0).has_rates());
        assert!(!Accuracy::new(0.0).figures(6000.0).has_rates(), "no errors were added");
        assert_eq!(figures.window_samples, 3301);
        assert!((figures.cep_rate_m_s() / NMI_PER_HOUR - 0.832_554_611).abs() < 1e-9);
        assert!((figures.radial_95_rate_m_s() / NMI_PER_HOUR - 1.730_818_383).abs() < 1e-9);
        assert!((figures.radial_error_slope_m_s - NMI_PER_HOUR).abs() < 1e-9);
        assert!((figures.velocity_rms_n.y - 0.4 * NMI_PER_HOUR).abs() < 1e-12);
    }

    /// Sums that are too large for the spread of their times, or at their limit: finite figures, and sums within the limit.
    #[test]
    fn sums_at_their_limit_stay_there_and_give_finite_figures() {
        let mut errors = NavigationErrors {
            position_n: Vector3::repeat(1e9),
            velocity_n: Vector3::repeat(1e25),
            ..Default::default()
        };
        let mut accuracy =
            Accuracy { line: [2.0, 1e20, 0.5e40, SUMS, SUMS], windowed: 2, ..Accuracy::new(0.0) };
        (accuracy.velocity_squares, accuracy.rate_squares) = (Vector3::repeat(SUMS), SUMS);
        for second in 1..=10 {
            errors.position_n *= 1e3;
            accuracy.add(300.0 + f64::from(second), &errors, false);
        }
        assert!(accuracy.figures(400.0).radial_error_slope_m_s.is_finite());
        let sums = accuracy.line.iter().chain(&accuracy.velocity_squares).chain([&accuracy.rate_squares]);
        assert!(sums.into_iter().all(|sum| *sum <= SUMS));
    }
}
