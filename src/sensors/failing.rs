//! Sensor outputs with failures.

use nalgebra::Vector3;

use super::failure::{Acts, Axis, Failure, SensorOutput};
use super::stream::{Purpose, Source, Stream, StreamKey};
use crate::base::error::Error;
use crate::base::snapshot::{Numbers, Reader, SIGNALS, Stored, Writer, stored};

/// Share of a sample interval. A loss that is due this close before the end of an interval falls into the next
/// interval, because sums of intervals have rounding errors.
const SLACK: f64 = 1e-6;

/// One output, with or without a failure. Its random stream continues from one failure to the next.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FailingOutput {
    failure: Option<Failure>,
    /// Spikes: time since the last pulse began [s]. Periodic drop-outs: time to the next loss [s].
    phase_s: f64,
    /// Stuck: the value that is held [u].
    held: Option<f64>,
    /// Whether there is no signal.
    is_silent: bool,
    has_drawn: bool,
    stream: Stream,
}

/// Bits for what a snapshot stores of an output, in addition to an output without failure.
const FAILED: usize = 1;
const SILENT: usize = 2;
const DRAWN: usize = 4;

/// Phase and held value are stored only with a failure. The stream is stored only if it was drawn from; otherwise it
/// equals a new one.
impl Stored for FailingOutput {
    fn save(&self, to: &mut Writer<'_>) {
        let Self { failure, phase_s, held, is_silent, has_drawn, stream } = self;
        let bit = |is_set: bool, bit: usize| if is_set { bit } else { 0 };
        to.count(bit(failure.is_some(), FAILED) | bit(*is_silent, SILENT) | bit(*has_drawn, DRAWN));
        if let Some(failure) = failure {
            failure.save(to);
            Numbers::save(phase_s, to);
            Numbers::save(held, to);
        }
        if *has_drawn {
            stream.save(to);
        }
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        from.enter("snapshot: FailingOutput");
        let kind = from.count(FAILED | SILENT | DRAWN)?;
        let Self { failure, phase_s, held, is_silent, has_drawn, stream } = self;
        (*failure, *is_silent, *has_drawn) = (None, kind & SILENT != 0, kind & DRAWN != 0);
        if kind & FAILED != 0 {
            failure.insert(Failure::default()).load(from)?;
            Numbers::load(phase_s, from, 1e12)?;
            Numbers::load(held, from, SIGNALS)?;
        }
        if *has_drawn {
            stream.load(from)?;
        }
        Ok(())
    }
}

impl FailingOutput {
    pub fn new(key: StreamKey, source: Source, axis: usize) -> Self {
        Self {
            failure: None,
            phase_s: 0.0,
            held: None,
            is_silent: false,
            has_drawn: false,
            stream: Stream::new(key, source, axis, Purpose::Failure),
        }
    }

    /// Sets or clears the failure. `last` is the last output [u], if there was one.
    pub fn set(&mut self, failure: Option<Failure>, last: Option<f64>) {
        self.failure = failure;
        self.phase_s = 0.0;
        self.held = last;
        self.is_silent = failure == Some(Failure::Dead);
    }

    /// Checks the failure of the output `output`, if it has one.
    pub fn check(&self, output: SensorOutput) -> Result<(), Error> {
        self.failure.map_or(Ok(()), |failure| failure.validate(output))
    }

    /// The failure that is set.
    pub fn failure(&self) -> Option<Failure> {
        self.failure
    }

    /// Whether there is a failure.
    pub fn has_failed(&self) -> bool {
        self.failure.is_some()
    }

    /// Whether the output has no signal in this interval.
    pub fn is_silent(&self) -> bool {
        self.is_silent
    }

    /// Share of the signal, with its random errors, that is in the output of this interval; of random drop-outs, the mean share.
    fn share(&self) -> f64 {
        match self.failure {
            Some(Failure::Stuck | Failure::Dead) => 0.0,
            Some(Failure::DropOuts { interval_s: 0.0, probability }) => 1.0 - probability,
            _ if self.is_silent => 0.0,
            Some(Failure::DropOuts { .. }) | None => 1.0,
            Some(Failure::BiasStep { .. } | Failure::Spikes { .. } | Failure::Noise { .. }) => 1.0,
        }
    }

    /// Density of the noise that the failure adds [u √s].
    fn noise(&self) -> f64 {
        match self.failure {
            Some(Failure::Noise { density }) => density,
            Some(Failure::Stuck | Failure::Dead | Failure::DropOuts { .. }) => 0.0,
            Some(Failure::BiasStep { .. } | Failure::Spikes { .. }) | None => 0.0,
        }
    }

    /// A sample interval of `t` [s] begins: drop-outs are decided.
    pub fn begin_interval(&mut self, t: f64) {
        match self.failure {
            Some(Failure::DropOuts { interval_s: 0.0, probability }) => {
                self.has_drawn = true;
                self.is_silent = self.stream.uniform() < probability;
            }
            Some(Failure::DropOuts { interval_s, .. }) => {
                let left = t * (1.0 - SLACK) - self.phase_s;
                self.is_silent = left > 0.0;
                if self.is_silent {
                    self.phase_s += interval_s * (left / interval_s).ceil();
                }
                self.phase_s -= t;
            }
            Some(Failure::Stuck | Failure::Dead | Failure::BiasStep { .. }) => {}
            Some(Failure::Spikes { .. } | Failure::Noise { .. }) | None => {}
        }
    }

    /// Integral over `dt` [s] of what the failure adds [u s].
    pub fn added(&mut self, dt: f64) -> f64 {
        match self.failure {
            Some(Failure::BiasStep { size }) => size * dt,
            Some(Failure::Noise { density }) => {
                self.has_drawn = true;
                density * dt.sqrt() * self.stream.normal()
            }
            Some(Failure::Spikes { size, interval_s, duration_s }) => {
                let end = self.phase_s + dt;
                let whole = (end / interval_s).floor();
                let phase = (end - whole * interval_s).max(0.0);
                let under = whole * duration_s + phase.min(duration_s) - self.phase_s.min(duration_s);
                self.phase_s = phase;
                size * under
            }
            Some(Failure::Stuck | Failure::Dead | Failure::DropOuts { .. }) | None => 0.0,
        }
    }

    /// The output over `dt` [s] in place of `measured` [u s].
    pub fn replaced(&mut self, dt: f64, measured: f64) -> f64 {
        match self.failure {
            _ if self.is_silent => 0.0,
            Some(Failure::Stuck) => *self.held.get_or_insert(measured / dt) * dt,
            Some(Failure::Dead | Failure::DropOuts { .. }) | None => measured,
            Some(Failure::BiasStep { .. } | Failure::Spikes { .. } | Failure::Noise { .. }) => measured,
        }
    }
}

/// The outputs of a triad.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FailingTriad {
    outputs: [FailingOutput; 3],
}

stored!(FailingTriad { outputs });

impl FailingTriad {
    pub(super) fn new(key: StreamKey, source: Source) -> Self {
        Self { outputs: [0, 1, 2].map(|axis| FailingOutput::new(key, source, axis)) }
    }

    /// Sets or clears the failure of one axis, as [`FailingOutput::set`].
    pub fn set(&mut self, axis: Axis, failure: Option<Failure>, last: Option<f64>) {
        self.outputs[axis as usize].set(failure, last);
    }

    /// The failure that is set for one axis.
    pub fn failure(&self, axis: Axis) -> Option<Failure> {
        self.outputs[axis as usize].failure()
    }

    /// Checks each failure. `output` gives the output of an axis.
    pub fn check(&self, output: fn(Axis) -> SensorOutput) -> Result<(), Error> {
        let [x, y, z] = &self.outputs;
        x.check(output(Axis::X))?;
        y.check(output(Axis::Y))?;
        z.check(output(Axis::Z))
    }

    /// Whether a failure adds to an output.
    pub fn any_adds(&self) -> bool {
        self.failures().any(|failure| failure.acts() == Acts::Added)
    }

    /// Whether a failure replaces an output.
    pub fn any_replaces(&self) -> bool {
        self.failures().any(|failure| failure.acts() == Acts::Replaces)
    }

    /// Whether an output has no signal in this interval.
    pub fn are_silent(&self) -> bool {
        self.outputs.iter().any(FailingOutput::is_silent)
    }

    /// For each axis the share of the signal that is in the output, and the density of added noise [u √s].
    pub fn shares_and_noise(&self) -> [(f64, f64); 3] {
        self.outputs.each_ref().map(|output| (output.share(), output.noise()))
    }

    /// A sample interval of `t` [s] begins.
    pub fn begin_interval(&mut self, t: f64) {
        self.outputs.iter_mut().for_each(|output| output.begin_interval(t));
    }

    /// Adds what failures add over `dt` [s].
    pub fn add(&mut self, dt: f64, measured: &mut Vector3<f64>) {
        for (output, measured) in self.outputs.iter_mut().zip(measured.iter_mut()) {
            *measured += output.added(dt);
        }
    }

    /// Replaces what failures replace over `dt` [s].
    pub fn replace(&mut self, dt: f64, measured: &mut Vector3<f64>) {
        for (output, measured) in self.outputs.iter_mut().zip(measured.iter_mut()) {
            *measured = output.replaced(dt, *measured);
        }
    }

    fn failures(&self) -> impl Iterator<Item = &Failure> {
        self.outputs.iter().filter_map(|output| output.failure.as_ref())
    }
}
