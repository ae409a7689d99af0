//! The true path as perfect sensors measure it: running integrals of angular rate and specific force.

use nalgebra::{SVector, Vector3};

use super::blocks::LARGEST;
use crate::analysis::recommend::{Refusal, fly_looking};
use crate::base::error::{Error, ErrorKind, Rule, check_range};
use crate::base::memory::{room, room_for_more, room_for_one_more};
use crate::mechanization::Frame;
use crate::signal::Increment;
use crate::signal::mounting::lever_arm_velocity;
use crate::simulator::{Options, Simulator};
use crate::truth::FlightSample;
use core::ops::ControlFlow;

/// Signals of the three gyros, then of the three accelerometers.
pub(super) type Six = SVector<f64, 6>;

pub(super) fn six(increment: &Increment) -> Six {
    let Increment { angle, velocity } = increment;
    Six::from_column_slice(&[angle.x, angle.y, angle.z, velocity.x, velocity.y, velocity.z])
}

pub(super) fn six_increment(six: &Six) -> Increment {
    Increment { angle: six.fixed_rows::<3>(0).into_owned(), velocity: six.fixed_rows::<3>(3).into_owned() }
}

fn rates(six: &Six) -> Vector3<f64> {
    six.fixed_rows::<3>(0).into_owned()
}

/// What perfect sensors measure along a path, body axes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct IdealPath {
    times_s: Vec<f64>,
    /// Integrals from the first time on.
    integrals: Vec<Six>,
    /// Times [s] and temperatures [°C] of the samples that have one.
    temperatures: Vec<(f64, f64)>,
}

/// Options with which perfect sensors fly a path: of `options`, Earth, gravity, body axes and the checks of samples count.
pub(super) fn of_path(options: &Options) -> Options {
    let Options { ellipsoid, gravity, axes, intake, .. } = *options;
    // Earth-fixed axes have no pole, and the damped vertical channel keeps the path for any time.
    Options { ellipsoid, gravity, axes, intake, frame: Frame::EarthFixed, ..Options::default() }
}

impl IdealPath {
    /// Flies `samples` with perfect sensors. Of `options`, Earth, gravity, body axes and the checks of samples count.
    pub fn fly(
        options: &Options,
        samples: impl Iterator<Item = Result<FlightSample, Error>>,
    ) -> Result<Self, Refusal> {
        Self::fly_reading(options, samples, |_| Ok(()))
    }

    /// As [`Self::fly`]; calls `read` after each step.
    pub(super) fn fly_reading(
        options: &Options,
        samples: impl Iterator<Item = Result<FlightSample, Error>>,
        mut read: impl FnMut(&Simulator) -> Result<(), Error>,
    ) -> Result<Self, Refusal> {
        let mut simulator = Simulator::new(&of_path(options))?;
        let (mut path, mut temperatures) = (Self::default(), Vec::new());
        let samples = samples.map(|sample| {
            let sample = sample?;
            add_temperature(&mut temperatures, &sample)?;
            Ok(sample)
        });
        fly_looking(&mut simulator, samples, |_, simulator| {
            if let Some(imu) = simulator.imu() {
                path.push(imu.time_s, imu.interval_s, &imu.ideal)?;
                read(simulator)?;
            }
            Ok(ControlFlow::Continue(()))
        })?;
        Ok(Self { temperatures, ..path })
    }

    /// Adds the ideal increment of the interval of length `interval_s` [s] that ends at `time_s` [s]. The first interval begins the path;
    /// each other follows the one before.
    pub fn push(&mut self, time_s: f64, interval_s: f64, ideal: &Increment) -> Result<(), Error> {
        check_range("path.time_s", time_s, -1e12, 1e12)?;
        check_range("path.interval_s", interval_s, f64::MIN_POSITIVE, 1e12)?;
        for (part, value) in six(ideal).iter().enumerate() {
            let name = if part < 3 { "path.angle" } else { "path.velocity" };
            check_range(name, value / interval_s, -LARGEST, LARGEST)?;
        }
        let before = match (self.times_s.last(), self.integrals.last()) {
            (Some(&last_s), Some(sum)) if time_s > last_s => *sum,
            (Some(_), _) => {
                let last_s = self.times_s.last().copied().unwrap_or(time_s);
                let rule = Rule::SentenceWith("must be later than the interval before, at", last_s.into());
                return Err(Error::of(ErrorKind::TimeOrder, "path.time_s", time_s, rule));
            }
            (None, _) => {
                self.make_room()?;
                self.times_s.push(time_s - interval_s);
                self.integrals.push(Six::zeros());
                Six::zeros()
            }
        };
        self.make_room()?;
        self.times_s.push(time_s);
        self.integrals.push(before + six(ideal));
        Ok(())
    }

    /// Makes room for an interval, and for the begin of the path.
    pub(super) fn make_room(&mut self) -> Result<(), Error> {
        room_for_more(&mut self.times_s, 2)?;
        room_for_more(&mut self.integrals, 2)
    }

    /// Adds the temperature of a sample, if it has one; its time is later than that of the sample before.
    pub(super) fn push_temperature(&mut self, sample: &FlightSample) -> Result<(), Error> {
        add_temperature(&mut self.temperatures, sample)
    }

    /// Temperature at `time_s` [°C], linear between the samples that have one, and beyond them that of the nearest; `None`: none has.
    pub(super) fn temperature_c(&self, time_s: f64) -> Option<f64> {
        let behind = self.temperatures.partition_point(|(time, _)| *time < time_s);
        let before = behind.checked_sub(1).and_then(|place| self.temperatures.get(place));
        match (before, self.temperatures.get(behind)) {
            (Some((from_s, from)), Some((to_s, to))) => {
                Some(from + (to - from) * (time_s - from_s) / (to_s - from_s))
            }
            (one, other) => one.or(other).map(|(_, temperature_c)| *temperature_c),
        }
    }

    /// The path of sensors that are away from its point by a lever arm `lever_b` [m], body axes.
    pub fn with_lever_arm(mut self, lever_b: &Vector3<f64>) -> Result<Self, Error> {
        self.ends_s()?;
        let rate_at = |time_s: f64| self.at(time_s).map_or(Vector3::zeros(), |(_, rate)| rates(&rate));
        let mut integrals = room(self.integrals.len())?;
        let mut moved = Vector3::zeros();
        let mut last: Option<(f64, Six, Vector3<f64>)> = None;
        for (&time_s, integral) in self.times_s.iter().zip(&self.integrals) {
            let rate = rate_at(time_s);
            if let Some((last_s, before, last_rate)) = last.replace((time_s, *integral, rate)) {
                let dt = time_s - last_s;
                let mean = rates(&(integral - before)) / dt;
                moved += lever_arm_velocity(&(rate - last_rate), &mean, dt, lever_b);
            }
            let Increment { angle, velocity } = six_increment(integral);
            integrals.push(six(&Increment { angle, velocity: velocity + moved }));
        }
        self.integrals = integrals;
        Ok(self)
    }

    /// First and last time [s]; the path has two intervals or more.
    pub(super) fn ends_s(&self) -> Result<(f64, f64), Error> {
        match (self.times_s.first(), self.times_s.last()) {
            (Some(&first), Some(&last)) if self.times_s.len() > 4 => Ok((first, last)),
            _ => Err(Error::bad_state("the path must have at least four intervals")),
        }
    }

    /// Integral and signal at `time_s`, by the cubic through the four nearest points; `None` outside the path.
    pub(super) fn at(&self, time_s: f64) -> Option<(Six, Six)> {
        let next = self.times_s.partition_point(|&time| time < time_s);
        let count = self.times_s.len();
        if next == count || (next == 0 && self.times_s[0] > time_s) || count < 4 {
            return None;
        }
        let first = next.saturating_sub(2).min(count - 4);
        let x: [f64; 4] = core::array::from_fn(|i| self.times_s[first + i] - time_s);
        let base = self.integrals[first];
        let (mut integral, mut rate) = (base, Six::zeros());
        for i in 1..4 {
            // Lagrange's weight of a point, and its derivative by time.
            let others = |skip: usize| (0..4).filter(move |j| *j != i && *j != skip);
            let below: f64 = others(4).map(|j| x[i] - x[j]).product();
            let weight: f64 = others(4).map(|j| -x[j]).product::<f64>() / below;
            let slope: f64 =
                others(4).map(|k| others(k).map(|j| -x[j]).product::<f64>()).sum::<f64>() / below;
            let value = self.integrals[first + i] - base;
            integral += value * weight;
            rate += value * slope;
        }
        Some((integral, rate))
    }

    /// Mean signal from `start_s` to `end_s` [s], and its derivative by a shift of both; `None` outside the path.
    pub(super) fn mean(&self, start_s: f64, end_s: f64) -> Option<(Six, Six)> {
        let ((from, rate_from), (to, rate_to)) = (self.at(start_s)?, self.at(end_s)?);
        let length_s = end_s - start_s;
        Some(((to - from) / length_s, (rate_to - rate_from) / length_s))
    }
}

fn add_temperature(to: &mut Vec<(f64, f64)>, sample: &FlightSample) -> Result<(), Error> {
    if let Some(temperature_c) = sample.temperature_c {
        room_for_one_more(to)?;
        to.push((sample.time_s, temperature_c));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    /// A signal that is a parabola has a cubic integral, which is interpolated exactly between uneven points.
    #[test]
    fn a_parabola_is_exact_between_the_points() {
        let integral = |t: f64| 0.3 * t * t * t - t * t + 2.0 * t;
        let mut path = IdealPath::default();
        let mut last = 0.0;
        for k in 1..40 {
            let time = f64::from(k) * 0.1 + 0.02 * f64::from(k % 3);
            let angle = Vector3::new(integral(time) - integral(last), 0.0, 0.0);
            path.push(time, time - last, &Increment { angle, ..Increment::ZERO }).unwrap();
            last = time;
        }
        let (mean, change) = path.mean(0.913, 1.777).unwrap();
        let signal = |t: f64| 0.9 * t * t - 2.0 * t + 2.0;
        assert!((mean[0] - (integral(1.777) - integral(0.913)) / 0.864).abs() < 1e-13);
        assert!((change[0] - (signal(1.777) - signal(0.913)) / 0.864).abs() < 1e-12);
        assert!(path.mean(-0.1, 1.0).is_none() && path.mean(3.0, 4.2).is_none());
        // What is rejected changes nothing.
        let before = path.clone();
        let wild = Increment { angle: Vector3::new(f64::NAN, 0.0, 0.0), ..Increment::ZERO };
        for (time_s, interval_s, ideal, named) in [
            (1.0, 0.1, Increment::ZERO, "path.time_s = 1: must be later than the interval before, at 3.9"),
            (f64::NAN, 0.1, Increment::ZERO, "path.time_s = NaN: must be a finite number"),
            (5.0, 0.0, Increment::ZERO, "path.interval_s = 0: must be from"),
            (5.0, 0.1, wild, "path.angle = NaN: must be a finite number"),
        ] {
            let error = path.push(time_s, interval_s, &ideal).unwrap_err().to_string();
            assert!(error.starts_with(named), "{error}");
        }
        assert_eq!(path, before);
    }
}
