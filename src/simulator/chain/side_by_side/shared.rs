//! What all runs share in an interval.

use nalgebra::Vector3;

use crate::earth::Earth;
use crate::errors::ModelInterval;
use crate::mechanization::{VerticalAid, VerticalMode};
use crate::sensors::SharedInput;
use crate::signal::mounting::Block;
use crate::signal::{Increment, IntervalMotion};
use crate::simulator::aid::vertical_aid;
use crate::simulator::chain::Chain;
use crate::simulator::imperfections::IntervalConditions;
use crate::simulator::{Imperfections, Options};
use crate::truth::{Recent, TruthPoint};

/// What all runs share in an interval.
pub(super) struct Shared<'a> {
    pub earth: &'a Earth,
    pub options: &'a Options,
    pub imperfections: &'a Imperfections,
    /// Input of gyros and of accelerometers, unless gravity differs from run to run.
    pub inputs: &'a [SharedInput; 2],
    /// Solution at the start of the interval.
    pub last_good: LastGood,
    /// Length of the interval [s]; `dt` is the length of its increments [s].
    pub t: f64,
    pub dt: f64,
    /// Aid of the vertical channel. If the altimeters have errors, it holds the true height.
    pub aid: VerticalAid,
    /// Whether each run has an altimeter of its own.
    pub has_altimeters: bool,
    /// Interval of the error models, if they are on.
    pub model: Option<ModelInterval<'a>>,
    pub recent: &'a Recent<'a>,
    pub motion: &'a IntervalMotion<'a>,
    /// Error-free increments, without gravity beyond the normal field.
    pub ideal: &'a [Increment],
    /// The mounting, if there is one; `shift_e` is by how much it shifts the navigators [m/s], Earth-fixed axes.
    pub mounting: Option<&'a Block>,
    pub shift_e: Option<Vector3<f64>>,
    /// Whether mounting and closed loop are within their limits.
    pub is_good: bool,
}

impl<'a> Shared<'a> {
    /// The part of sensors, altimeter and error models that is the same in all runs, over the interval of `motion`, which `chain`
    /// has flown with the increments `ideal`, `shift_e` and `is_good`.
    pub fn new(
        chain: &'a Chain,
        (imperfections, inputs): (&'a mut Imperfections, &'a mut [SharedInput; 2]),
        (recent, motion, ideal): (&'a Recent<'a>, &'a IntervalMotion<'a>, &'a [Increment]),
        (shift_e, is_good): (Option<Vector3<f64>>, bool),
    ) -> Self {
        let Chain { options, earth, .. } = chain;
        let (next, t) = (recent.next, recent.next.interval_s);
        let (dt, mounting) = (t / ideal.len() as f64, chain.block.as_ref());
        let is_disturbed = imperfections.gravity.is_on();
        if !is_disturbed {
            imperfections.begin_interval(t, || IntervalConditions::of(recent, motion, mounting));
            imperfections.gyro.share(ideal, dt, &mut inputs[0]);
            imperfections.accel.share(ideal, dt, &mut inputs[1]);
        }
        let has_altimeters =
            options.vertical == VerticalMode::Damped && (is_disturbed || !imperfections.altimeter.is_ideal());
        let aid = vertical_aid(options.vertical, next, |height_m| {
            if has_altimeters { Some(height_m) } else { imperfections.altimeter.sense(height_m, t) }
        });
        Self {
            earth,
            options,
            imperfections,
            inputs,
            last_good: LastGood::of(chain, recent.current),
            t,
            dt,
            aid,
            has_altimeters,
            model: options.error_model.then(|| ModelInterval::new(earth, motion, next, ideal)),
            recent,
            motion,
            ideal,
            mounting,
            shift_e,
            is_good,
        }
    }

    /// Whether a gyro and whether an accelerometer has failed.
    pub fn have_failed(&self) -> [bool; 2] {
        [self.imperfections.gyro.has_failed(), self.imperfections.accel.has_failed()]
    }

    /// The mounting of a run whose sensors gave `measured` in the whole interval.
    pub fn mounting_of(&self, measured: &Increment) -> Option<Block> {
        self.mounting.map(|block| {
            let mut block = *block;
            block.observe(&Increment::sum(self.ideal), measured, self.t);
            block
        })
    }
}

/// The last good solution of a run that has diverged.
#[derive(Debug, Clone, Copy)]
pub(super) struct LastGood {
    /// Time [s].
    pub time_s: f64,
    /// Length of the interval that led to this solution [s]; 0: the solution is the start.
    pub interval_s: f64,
}

impl LastGood {
    /// The solution of the runs of `chain` while the truth is at `point`.
    pub fn of(chain: &Chain, point: &TruthPoint) -> Self {
        Self { time_s: point.time_s, interval_s: chain.imu().map_or(0.0, |imu| imu.interval_s) }
    }
}
