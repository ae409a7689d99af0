//! Bandwidth: a second-order Butterworth filter.

use nalgebra::Vector3;

use super::super::kept::Kept;
use super::super::parameters::TriadParameters;
use super::super::stream::EffectStreams;
use super::effect::{Effect, OnInput};
use crate::base::error::Error;
use crate::base::math::{exp, sin_cos};
use crate::base::snapshot::{Reader, SIGNALS, Stored, Writer, stored};

/// y'' + 2 s y' + 2 s² y = 2 s² u, s = √2 π f: -3 dB at f, flat below, a delay of 1/s. The signal u is assumed constant over each
/// increment, at its mean. For such a signal the step is exact at any length. With e = y - u, w = y'/s, E = exp(-s dt), and
/// c, n = cos, sin (s dt):
/// ```text
/// e(dt)  = E ((c + n) e + n w)
/// w(dt)  = E ((c - n) w - 2 n e)
/// ∫y dt  = ∫u dt - (y(dt) - y + (w(dt) - w)/2) / s
/// ```
/// The last line is the integrated differential equation: the filter outputs later what it holds back, so no angle is lost. The
/// filter starts in the steady state of its first increment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sensors) struct Bandwidth {
    axes: [Option<Filter>; 3],
}

/// One axis.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Filter {
    /// s [1/s].
    rate: f64,
    /// E c, E n.
    cos: f64,
    sin: f64,
    /// y, w [u]; none before the first increment.
    state: Kept<Option<(f64, f64)>>,
}

stored!(Filter { state: SIGNALS } rebuilt { rate, cos, sin });

/// The parameters determine which axes have a filter.
impl Stored for Bandwidth {
    fn save(&self, to: &mut Writer<'_>) {
        let Self { axes } = self;
        axes.iter().flatten().for_each(|filter| filter.save(to));
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        let Self { axes } = self;
        axes.iter_mut().flatten().try_for_each(|filter| filter.load(from))
    }
}

/// Size below which a state becomes 0, so that there is no arithmetic on denormal numbers.
const NOTHING: f64 = 1e-300;

impl Filter {
    fn new(bandwidth_hz: f64) -> Self {
        let rate = core::f64::consts::SQRT_2 * core::f64::consts::PI * bandwidth_hz;
        Self { rate, cos: 1.0, sin: 0.0, state: Kept::new(None) }
    }

    fn set_interval(&mut self, dt: f64) {
        let decay = exp(-self.rate * dt);
        let (sin, cos) = sin_cos(self.rate * dt);
        (self.cos, self.sin) = (decay * cos, decay * sin);
    }

    /// Filtered increment for the increment `input` over `dt` [s].
    #[inline]
    fn filtered(&mut self, dt: f64, input: f64) -> f64 {
        let u = input / dt;
        let (y, w) = self.state.unwrap_or((u, 0.0));
        let e = y - u;
        let flush = |x: f64| if x.abs() < NOTHING { 0.0 } else { x };
        let y1 = flush(u + ((self.cos + self.sin) * e + self.sin * w));
        let w1 = flush((self.cos - self.sin) * w - 2.0 * self.sin * e);
        *self.state = Some((y1, w1));
        input - ((y1 - y) + 0.5 * (w1 - w)) / self.rate
    }
}

impl Effect for Bandwidth {
    fn new(_: &EffectStreams) -> Self {
        Self { axes: [None; 3] }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        for (filter, &bandwidth_hz) in self.axes.iter_mut().zip(parameters.bandwidth_hz.iter()) {
            let state = filter.map_or(Kept::new(None), |filter| filter.state);
            *filter = (bandwidth_hz != 0.0).then(|| Filter { state, ..Filter::new(bandwidth_hz) });
        }
        self.axes.iter().any(Option::is_some)
    }

    fn set_interval(&mut self, dt: f64) {
        self.axes.iter_mut().flatten().for_each(|filter| filter.set_interval(dt));
    }

    fn undo(&mut self) {
        self.axes.iter_mut().flatten().for_each(|filter| filter.state.undo());
    }

    fn reposition(&mut self) {
        self.axes.iter_mut().flatten().for_each(|filter| *filter.state = None);
    }
}

impl OnInput for Bandwidth {
    fn keep(&mut self) {
        self.axes.iter_mut().flatten().for_each(|filter| filter.state.keep());
    }

    #[inline]
    fn apply(&mut self, _: &Vector3<f64>, dt: f64, input: &mut Vector3<f64>) {
        for (filter, input) in self.axes.iter_mut().zip(input.iter_mut()) {
            if let Some(filter) = filter {
                *input = filter.filtered(dt, *input);
            }
        }
    }

    fn steady_change(&self, _: &Vector3<f64>) -> Vector3<f64> {
        Vector3::zeros()
    }
}
