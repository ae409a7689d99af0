//! What a snapshot keeps of the chain.

use super::Chain;
use crate::earth::Earth;
use crate::error::{Error, Rule};
use crate::errors::StartErrors;
use crate::mechanization::Mechanization;
use crate::simulator::Options;
use crate::simulator::interval::{ImuInterval, LastInterval};
use crate::snapshot::{COUNT, Numbers, Reader, Stored, Writer};
use crate::truth::TruthPoint;

/// Read over a chain that was made at the current point. Of the increments the sums are kept.
impl Stored for Chain {
    fn save(&self, to: &mut Writer<'_>) {
        let Self {
            options: _,
            earth: _,
            generator,
            ideal: _,
            measured: _,
            last: _,
            mechanization,
            error_model,
            accuracy,
            intervals,
            closure,
            closed_loop,
        } = self;
        generator.save(to);
        self.imu().save(to);
        mechanization.save(to);
        if let Some(model) = error_model {
            model.save(to);
        }
        accuracy.save(to);
        intervals.save(to);
        closure.save(to);
        if let Some(closed_loop) = closed_loop {
            closed_loop.save(to);
        }
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        self.generator.load(from)?;
        let mut imu: Option<ImuInterval> = None;
        imu.load(from)?;
        self.last = imu.map_or(LastInterval::None, LastInterval::Loaded);
        self.mechanization.load(from)?;
        if let Some(model) = &mut self.error_model {
            model.load(from)?;
        }
        self.accuracy.load(from)?;
        from.enter("snapshot: intervals");
        Numbers::load(&mut self.intervals, from, COUNT)?;
        self.closure.load(from)?;
        if let Some(closed_loop) = &mut self.closed_loop {
            closed_loop.load(from)?;
        }
        Ok(())
    }
}

impl Chain {
    /// The chain of a snapshot, which has come to the first of the points `behind`, newest first.
    pub fn load(
        options: &Options,
        earth: Earth,
        behind: &[Option<&TruthPoint>; 3],
        from: &mut Reader<'_>,
    ) -> Result<Self, Error> {
        let [Some(current), Some(_), _] = *behind else {
            from.enter("snapshot: samples that were flown");
            let count = behind.iter().flatten().count();
            return Err(from.refused(count as f64, Rule::Words("must be two at the least in flight")));
        };
        let navigator = Mechanization::new(earth, options.frame, options.scheme, &current.state);
        let mut chain = Self::new(options, earth, current, &StartErrors::NONE, navigator, true);
        Stored::load(&mut chain, from)?;
        chain.generator.look_back(behind);
        Ok(chain)
    }
}
