//! Scale factor nonlinearity and vibration rectification: the second-order terms.

use nalgebra::Vector3;

use super::super::parameters::TriadParameters;
use super::super::stream::EffectStreams;
use super::effect::{Effect, Input, OfInput};
use crate::base::snapshot::stored;

/// δ = c s|s| + k s². The first term is odd: the nonlinearity c is a scale factor that grows with the size of the
/// signal s. The second term is even: the vibration rectification k turns vibration of RMS r into a bias of k r² (K_oq
/// and K2 of IEEE Std 1293) [1/u].
///
/// The error of an increment Δ over dt, with the signal assumed constant over it, is (c Δ|Δ| + k Δ²) / dt. By this
/// assumption a sine of frequency f loses the share 1 - (sin x / x)², x = π f dt, of its mean square: 3 % at ten
/// increments a period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sensors) struct Quadratic {
    odd: Vector3<f64>,
    even: Vector3<f64>,
}

stored!(Quadratic {} rebuilt { odd, even });

impl Effect for Quadratic {
    fn new(_: &EffectStreams) -> Self {
        Self { odd: Vector3::zeros(), even: Vector3::zeros() }
    }

    fn set(&mut self, parameters: &TriadParameters) -> bool {
        self.odd = parameters.scale_factor_nonlinearity;
        self.even = parameters.vibration_rectification_s2_m;
        self.odd != Vector3::zeros() || self.even != Vector3::zeros()
    }
}

impl OfInput for Quadratic {
    #[inline]
    fn error(&self, input: &Input) -> Vector3<f64> {
        let signal = &input.signal;
        let sizes = self.odd.component_mul(&signal.abs()) + self.even.component_mul(signal);
        sizes.component_mul(signal) / input.dt
    }
}
