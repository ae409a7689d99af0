//! Three sensors and the effects that are active in them.

use core::slice::{from_mut, from_ref};

use nalgebra::Vector3;

use super::effects::{
    BatchOutputs, Conditions, Count, EffectPlace, Effects, Outputs, PutLane, SharedInput, StateRows, TakeLane,
};
use super::failing::FailingTriad;
use super::failure::{Axis, Failure, SensorOutput};
use super::kept::Kept;
use super::parameters::{Sensor, TriadParameters};
use super::stream::StreamKey;
use crate::base::error::Error;
use crate::base::snapshot::{Reader, Stored, stored};
use crate::signal::{Increment, IncrementRows, MAX_INCREMENTS, RUNS, Turning};
use crate::truth::INTERVALS_S;

/// A triad of gyros or accelerometers. An ideal triad does not change a bit of the increments.
#[derive(Debug, Clone, PartialEq)]
pub struct Triad {
    sensor: Sensor,
    effects: Effects,
    failing: Kept<FailingTriad>,
    /// Whether a failure adds to an output, and whether one replaces an output.
    adds: bool,
    replaces: bool,
    /// Length of the increments for which the effects are prepared [s]; 0: not prepared yet.
    dt: Kept<f64>,
}

stored!(Triad { effects, dt: INTERVALS_S.1 } rebuilt { sensor, failing, adds, replaces } then |triad, from| {
    let shortest_s = INTERVALS_S.0 / MAX_INCREMENTS as f64;
    from.require(*triad.dt == 0.0 || *triad.dt >= shortest_s, *triad.dt, "is no length of an increment")?;
    triad.set_interval(*triad.dt);
    Ok(())
});

impl Triad {
    /// An ideal triad whose random effects, if ever switched on, draw from the streams of `key`.
    pub fn new(key: StreamKey, sensor: Sensor) -> Self {
        Self {
            sensor,
            effects: Effects::new(key, sensor),
            failing: Kept::new(FailingTriad::new(key, sensor.source())),
            adds: false,
            replaces: false,
            dt: Kept::new(0.0),
        }
    }

    /// Takes validated parameters, and decides which effects act on each increment from now on. Processes that were active continue
    /// from their current states.
    pub fn set(&mut self, parameters: &TriadParameters) {
        self.effects.set(parameters);
        self.adds = self.failing.any_adds();
        self.replaces = self.failing.any_replaces();
        self.set_interval(*self.dt);
    }

    /// Sets or clears the failure of one axis. `last` is the last output of the axis [u], if there was one. `parameters` are the
    /// parameters that are already set.
    pub fn set_failure(
        &mut self,
        axis: Axis,
        failure: Option<Failure>,
        last: Option<f64>,
        parameters: &TriadParameters,
    ) {
        self.failing.set(axis, failure, last);
        self.set(parameters);
    }

    /// The failure that is set for one axis.
    pub fn failure(&self, axis: Axis) -> Option<Failure> {
        self.failing.failure(axis)
    }

    /// The failures. A snapshot needs them before it sets the parameters, because `set` makes a plan of both.
    pub(crate) fn failures(&self) -> &FailingTriad {
        &self.failing
    }

    /// Reads the failures.
    pub(crate) fn load_failures(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        self.failing.load(from)?;
        self.failing.check(match self.sensor {
            Sensor::Gyro => SensorOutput::Gyro,
            Sensor::Accelerometer => SensorOutput::Accelerometer,
        })
    }

    /// Whether an axis has a failure.
    pub fn has_failed(&self) -> bool {
        self.adds || self.replaces
    }

    /// Whether an axis has no signal in this interval: dead, or dropped out.
    #[inline]
    pub fn is_silent(&self) -> bool {
        self.failing.are_silent()
    }

    /// Whether an accelerometer is away from the block's own point.
    pub fn has_size_effect(&self) -> bool {
        self.effects.size_effect.is_active()
    }

    /// Begins a sample interval of `t` [s]. `ends_c` are the temperatures at its ends [°C], and `turning` is the motion that its
    /// increments belong to; each is `None` if it is not known. The call is needed if an effect of temperature, the size effect or
    /// a failure is set.
    pub fn begin_interval(&mut self, t: f64, ends_c: Option<[f64; 2]>, turning: Option<Turning>) {
        self.failing.keep();
        self.failing.begin_interval(t);
        self.effects.begin_interval(&Conditions { ends_c, turning });
    }

    /// Where its active effects act, in order.
    pub fn effect_places(&self) -> impl Iterator<Item = EffectPlace> {
        self.effects.places()
    }

    /// Whether nothing changes the increments.
    pub fn is_ideal(&self) -> bool {
        self.effects.are_none() && !self.has_failed()
    }

    /// Follows a jump of the signals: filters settle at once at the next signals. Noise continues.
    pub fn reposition(&mut self) {
        self.effects.reposition();
    }

    /// The triad's output for one ideal increment over `dt` [s].
    pub fn sense(&mut self, ideal: &Increment, dt: f64) -> Vector3<f64> {
        let mut measured = *ideal;
        self.sense_each(from_ref(ideal), dt, from_mut(&mut measured));
        self.sensor.part_of(&measured)
    }

    /// Turns the triad's part of `measured` into the triad's outputs. Before the call, this part equals the same part of the
    /// increments `ideal`, each over `dt` [s]. The active effects act one after the other, each on all increments. [`Self::undo`]
    /// can undo the interval.
    #[inline]
    pub fn sense_each(&mut self, ideal: &[Increment], dt: f64, measured: &mut [Increment]) {
        self.dt.keep();
        self.follow_length(dt);
        self.effects.act_on_signal(ideal, dt, self.sensor, measured);
        self.effects.add(dt, self.sensor, measured);
        if self.adds {
            Outputs::new(self.sensor, measured).iter_mut().for_each(|output| self.failing.add(dt, output));
        }
        self.effects.finish(dt, self.sensor, measured);
        if self.replaces {
            Outputs::new(self.sensor, measured)
                .iter_mut()
                .for_each(|output| self.failing.replace(dt, output));
        }
    }

    /// Takes the length `dt` [s] of the increments, if it differs. Time stamps differ in their last digits; the effect of this on a
    /// variance is far too small to be visible.
    #[inline]
    fn follow_length(&mut self, dt: f64) {
        if (dt - *self.dt).abs() > 1e-7 * dt {
            self.set_interval(dt);
        }
    }

    /// Takes the length of the increments to come [s]; 0: not known yet.
    #[cold]
    fn set_interval(&mut self, dt: f64) {
        *self.dt = dt;
        if dt != 0.0 {
            self.effects.set_interval(dt);
        }
    }

    /// Whether an output has been beyond the range since the last call.
    #[inline]
    pub fn take_saturated(&mut self) -> bool {
        self.effects.range.take_saturated()
    }

    /// Undoes the last interval: restores what [`Self::begin_interval`] and [`Self::sense_each`] changed.
    #[cold]
    pub fn undo(&mut self) {
        self.effects.undo();
        if self.has_failed() {
            self.failing.undo();
        }
        self.dt.undo();
        self.set_interval(*self.dt);
    }

    /// [`Self::steady_error`] of an alignment that takes the next `t` [s]; 0: an endless one. White noise and quantization are averaged
    /// over this time, and all processes move on to its end.
    pub fn alignment_error(
        &mut self,
        t: f64,
        rate: &Vector3<f64>,
        force: &Vector3<f64>,
        temperature_c: Option<f64>,
    ) -> Vector3<f64> {
        if t == 0.0 {
            return self.steady_error(rate, force, temperature_c);
        }
        let error = self.effects.mean_error(t, self.sensor, rate, force, temperature_c);
        self.take_saturated();
        self.set_interval(*self.dt);
        error
    }

    /// The error [u] that an alignment at this moment would have at the angular rate `rate` [rad/s], the specific force `force`
    /// [m/s²] and the temperature `temperature_c` [°C]; `None`: the reference temperature. It excludes white noise and
    /// quantization, because an alignment averages them out, and failures, because they come after it.
    pub fn steady_error(
        &self,
        rate: &Vector3<f64>,
        force: &Vector3<f64>,
        temperature_c: Option<f64>,
    ) -> Vector3<f64> {
        self.effects.steady_error(self.sensor, rate, force, temperature_c)
    }
}

/// The triads of many runs. One triad has the parameters and states that all runs share; rows have the states of each run.
impl Triad {
    /// Rows for the states of runs with these parameters.
    pub(crate) fn rows(&mut self) -> Result<StateRows, Error> {
        let mut count = Count::default();
        self.effects.visit(&mut count);
        count.rows()
    }

    /// Copies the states of this run into a lane.
    pub(crate) fn put_into(&mut self, rows: &mut StateRows, lane: usize) {
        self.effects.visit(&mut PutLane { rows, lane, next: Count::default() });
    }

    /// Copies the states of this run from a lane.
    pub(crate) fn take_from(&mut self, rows: &StateRows, lane: usize) {
        self.effects.visit(&mut TakeLane { rows, lane, next: Count::default() });
    }

    /// Takes over the states of the failures of another run, which has the same failures.
    pub(crate) fn take_failures(&mut self, failures: &FailingTriad) {
        (*self.failing).clone_from(failures);
    }

    /// Takes the states that depend on the signals from `other`, which had the same signals.
    pub(crate) fn follow_as(&mut self, other: &Self) {
        self.effects.follow(&other.effects);
        self.dt.clone_from(&other.dt);
        self.set_interval(*other.dt);
    }

    /// Computes in `shared` what is the same for all runs in an interval with the increments `ideal`, each over `dt`
    /// [s].
    pub(crate) fn share(&mut self, ideal: &[Increment], dt: f64, shared: &mut SharedInput) {
        self.follow_length(dt);
        self.effects.share(ideal, dt, self.sensor, shared);
    }

    /// Computes the outputs of the runs of a batch in the interval that was [shared](Self::share): the triad's part of
    /// `increments`. Each run has its own failures; copies of the last run have no failures. Runs beyond the range are
    /// marked in `saturated`. `before` gets the state of `rows` before the interval.
    #[inline(always)]
    pub(crate) fn sense_batch(
        &self,
        shared: &SharedInput,
        dt: f64,
        (rows, before): (&mut StateRows, &mut StateRows),
        failures: &mut [FailingTriad],
        increments: &mut [IncrementRows],
        saturated: &mut [u64; RUNS],
    ) {
        let mut states = rows.states(before);
        let mut outputs = BatchOutputs { sensor: self.sensor, dt, increments, saturated };
        self.effects.act_on_signal_each(shared, &mut states, &mut outputs);
        self.effects.add_each(&mut states, &mut outputs);
        let count = failures.len();
        if self.adds {
            outputs.each_run(count, |lane, output, _| failures[lane].add(dt, output));
        }
        self.effects.finish_each(&mut states, &mut outputs);
        if self.replaces {
            outputs.each_run(count, |lane, output, _| failures[lane].replace(dt, output));
        }
    }
}
