//! Parameters and failures that a host sets, and reads back.

use super::Imperfections;
use crate::errors::covariance::RandomErrors;
use crate::sensors::{FailingTriad, Failure, SensorOutput};
use crate::signal::Increment;
use crate::signal::mounting::MountingParameters;
use crate::simulator::{ErrorParameters, Options};

impl Imperfections {
    /// The same parameters, with all processes and streams back at their start and without failures.
    pub fn restarted(&self, options: &Options) -> Self {
        let mut fresh = Self::new(options);
        fresh.change(|set| *set = self.set);
        fresh
    }

    /// Becomes the imperfections of another run than `other`, with the host's settings of `other`, failures included, and with all
    /// processes and streams at their start.
    #[inline(never)]
    pub fn become_run(&mut self, other: &Self, options: &Options) {
        *self = Self::new(options);
        self.change(|set| *set = other.set);
        for output in SensorOutput::ALL {
            if let Some(failure) = other.failure(output) {
                self.set_failure(output, Some(failure), None);
            }
        }
    }

    /// Whether `other` has the same settings of the host, failures included.
    pub fn is_set_as(&self, other: &Self) -> bool {
        self.set == other.set
            && SensorOutput::ALL.into_iter().all(|output| self.failure(output) == other.failure(output))
    }

    /// Settings of the host.
    pub fn set(&self) -> &ErrorParameters {
        &self.set
    }

    /// Changes settings of the host. Processes that were active continue from their states.
    #[inline(never)]
    pub fn change(&mut self, change: impl FnOnce(&mut ErrorParameters)) {
        let set = &mut self.set;
        change(set);
        if set.mounting == MountingParameters::default() {
            // A lever arm of -0 means no mounting, and a snapshot stores no mounting then.
            set.mounting = MountingParameters::default();
        }
        self.gravity.set(&set.gravity);
        self.gyro.set(&set.gyro);
        self.accel.set(&set.accel);
        self.altimeter.set(&set.altimeter);
        self.update_summary();
    }

    /// Where gyros and accelerometers sit, if not at the reference point.
    pub fn mounting(&self) -> Option<&MountingParameters> {
        Some(&self.set.mounting).filter(|mounting| **mounting != MountingParameters::default())
    }

    /// Sets or clears the failure of an output. `last` has the mean signals of the last interval, if there was one.
    pub fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>, last: Option<&Increment>) {
        let last = last.and_then(|mean| output.of(mean));
        match output {
            SensorOutput::Gyro(axis) => self.gyro.set_failure(axis, failure, last, &self.set.gyro),
            SensorOutput::Accelerometer(axis) => self.accel.set_failure(axis, failure, last, &self.set.accel),
            SensorOutput::Altimeter => self.altimeter.set_failure(failure),
        }
        self.update_summary();
    }

    /// Takes over the states of the failures of gyros and accelerometers of another run, which has the same failures.
    pub fn take_failures(&mut self, gyro: &FailingTriad, accel: &FailingTriad) {
        self.gyro.take_failures(gyro);
        self.accel.take_failures(accel);
        self.update_summary();
    }

    /// The host's settings of everything that can be random, and the failures that change it.
    pub fn parameters(&self) -> RandomErrors<'_> {
        let [gx, gy, gz] = self.gyro.failures().shares_and_noise();
        let [ax, ay, az] = self.accel.failures().shares_and_noise();
        RandomErrors {
            outputs: [gx, gy, gz, ax, ay, az],
            gyro: &self.set.gyro,
            accel: &self.set.accel,
            altimeter: &self.set.altimeter,
            gravity: &self.set.gravity,
        }
    }

    /// The failure that is set for an output.
    pub fn failure(&self, output: SensorOutput) -> Option<Failure> {
        match output {
            SensorOutput::Gyro(axis) => self.gyro.failure(axis),
            SensorOutput::Accelerometer(axis) => self.accel.failure(axis),
            SensorOutput::Altimeter => self.altimeter.failure(),
        }
    }
}
