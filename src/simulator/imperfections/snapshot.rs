//! What a snapshot keeps of all that makes an INS err.

use super::Imperfections;
use crate::base::error::Error;
use crate::base::snapshot::{Reader, Stored, Writer};
use crate::sensors::Sensor;
use crate::signal::mounting::MountingParameters;
use crate::simulator::ErrorParameters;

/// The parameters come first: they are set again, and then the states of the effects that they call for are read.
impl Stored for Imperfections {
    fn save(&self, to: &mut Writer<'_>) {
        let Self {
            gyro,
            accel,
            altimeter,
            gravity,
            set,
            triads_are_ideal: _,
            are_none: _,
            depend_on_temperature: _,
            follow_intervals: _,
            gyro_is_silent: _,
            accel_is_silent: _,
        } = self;
        gyro.failures().save(to);
        set.gyro.save(to);
        accel.failures().save(to);
        set.accel.save(to);
        set.altimeter.save(to);
        set.initial.save(to);
        self.mounting().copied().save(to);
        set.gravity.save(to);
        gyro.save(to);
        accel.save(to);
        altimeter.save(to);
        gravity.save(to);
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        let mut set = ErrorParameters::default();
        self.gyro.load_failures(from)?;
        set.gyro.load(from)?;
        set.gyro.validate(Sensor::Gyro)?;
        self.accel.load_failures(from)?;
        set.accel.load(from)?;
        set.accel.validate(Sensor::Accelerometer)?;
        set.altimeter.load(from)?;
        set.altimeter.validate()?;
        set.initial.load(from)?;
        set.initial.validate()?;
        let mut mounting: Option<MountingParameters> = None;
        mounting.load(from)?;
        set.mounting = mounting.unwrap_or_default();
        set.mounting.validate()?;
        set.gravity.load(from)?;
        set.gravity.validate()?;
        self.change(|own| *own = set);
        self.gyro.load(from)?;
        self.accel.load(from)?;
        self.altimeter.load(from)?;
        self.gravity.load(from)?;
        self.update_summary();
        Ok(())
    }
}
