//! Failures of all kinds in one flat form, which the C interface and scenes use.

use super::failure::Failure;

/// The kinds of failures, and the quantities that each of them uses. Drop-outs use one of the two.
pub(crate) const FAILURE_KINDS: [(&str, &[&str]); 7] = [
    ("none", &["size", "density", "interval_s", "duration_s", "probability"]),
    ("stuck", &[]),
    ("dead", &[]),
    ("bias_step", &["size"]),
    ("spikes", &["size", "interval_s", "duration_s"]),
    ("noise", &["density"]),
    ("drop_outs", &["interval_s", "probability"]),
];

/// A failure of any kind, or none. It has the quantities of all kinds; those that its kind does not use are 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct FailureFields {
    /// Index in [`FAILURE_KINDS`].
    pub kind: usize,
    pub size: f64,
    pub density: f64,
    pub interval_s: f64,
    pub duration_s: f64,
    pub probability: f64,
}

impl FailureFields {
    /// The failure; `None` for kind 0. Quantities that the kind does not use are ignored. Drop-outs with an interval are periodic.
    pub fn to_failure(self) -> Option<Failure> {
        let Self { kind, size, density, interval_s, duration_s, probability } = self;
        match kind {
            0 => None,
            1 => Some(Failure::Stuck),
            2 => Some(Failure::Dead),
            3 => Some(Failure::BiasStep { size }),
            4 => Some(Failure::Spikes { size, interval_s, duration_s }),
            5 => Some(Failure::Noise { density }),
            _ if interval_s != 0.0 => Some(Failure::PeriodicDropOuts { interval_s }),
            _ => Some(Failure::RandomDropOuts { probability }),
        }
    }
}

impl From<Option<Failure>> for FailureFields {
    fn from(failure: Option<Failure>) -> Self {
        let none = Self::default();
        let Some(failure) = failure else { return none };
        match failure {
            Failure::Stuck => Self { kind: 1, ..none },
            Failure::Dead => Self { kind: 2, ..none },
            Failure::BiasStep { size } => Self { kind: 3, size, ..none },
            Failure::Spikes { size, interval_s, duration_s } => {
                Self { kind: 4, size, interval_s, duration_s, ..none }
            }
            Failure::Noise { density } => Self { kind: 5, density, ..none },
            Failure::PeriodicDropOuts { interval_s } => Self { kind: 6, interval_s, ..none },
            Failure::RandomDropOuts { probability } => Self { kind: 6, probability, ..none },
        }
    }
}
